"""One case, given its family, from what was read to its result."""

import re
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from functools import partial
from hashlib import sha256
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.case.outputs import ContactOutputs, LifeOutputs
from flexbearing.files import BadOutput
from flexbearing.findings import stored
from flexbearing.outputs import requested
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged, Report, Silent
from flexbearing.results import Others, Record, Result, ResultFile, case_file
from flexbearing.runs import effects_file
from flexbearing.runs.answer import BAD_INPUT, CONVERGED, Answer, row_findings
from flexbearing.runs.validate import require_possible

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels

LONGEST = 80  # characters of the settings in the name of a result
AT_ONCE = 64  # cases


def run_case(  # noqa: PLR0913  # what a run may be given besides its case
    case: Head,
    family: Family,
    output: str | Path | None = None,
    report: Report | None = None,
    start: Result | None = None,
    levels: "Levels | None" = None,
    others: Others = "searched",
) -> Result:
    """Compute a case, and store it where a file is requested; other equilibria are searched, or reported."""
    began = perf_counter()
    require_possible(case, family)
    stored = {} if _weighing(case) else effects_file.attributes(case)
    inputs = (*case.input_files, *(start.files if start else ()))
    with family.ahead()(case) if family.ahead else nullcontext() as ahead:  # of all that is loaded to solve
        solve = _solver(case, family, start, levels=levels, ahead=ahead)
        head = _head(case) | family.opening()(case)
        kept = (
            ResultFile(output, head, family, inputs, others)
            if output
            else nullcontext(Record(head, family, others=others))
        )
        with linear_algebra_alone(), kept as record:
            ending = solve(case, record, report or Logged())
            if _comparing_lives(case) and ending["status"] == "converged":
                ending |= _lives_compared(case, family, report or Logged(), ending["notes"])
            if _weighing(case) and ending["status"] == "converged":
                ending |= _inputs_weighed(case, family, report or Logged(), ending["notes"])
            elif ending["status"] == "converged":
                ending |= stored
            return record.finish(**ending, wall_time_s=perf_counter() - began)


def compared(case: Head, family: Family, beside: Result | None = None) -> Result:
    """Compute a case whose numbers are compared with those of another: other equilibria are not searched.

    It starts from the state of a case that differs little, `beside`, where its unknowns are the same.
    """
    began = perf_counter()
    require_possible(case, family)
    with family.ahead()(case) if family.ahead else nullcontext() as ahead, linear_algebra_alone():
        record = Record(_head(case) | family.opening()(case), family, others="left out")
        near = family.neighbouring_state()(beside, case) if beside and family.neighbouring_state else None
        ending = _solver(case, family, None, ahead=ahead, near=near)(case, record, Silent())
        return record.finish(**ending, wall_time_s=perf_counter() - began)


def effects(case: Head, family: Family, report: Report) -> dict[str, Any]:
    """What other values of assumed inputs make of a case, as `flexbearing.runs.assumed_effects` finds it."""
    from flexbearing.runs.assumed_effects import assumed_effects

    read = reader(case, family, _ratings(case, family))
    return assumed_effects(case, read, lambda each, beside: compared(each, family, beside), report)


def _ratings(case: Head, family: Family) -> list[str]:
    """Settings that keep the ratings of a case: other values of what is assumed are no other bearing."""
    from quasidynamic import OutOfRange

    if family.catalogue is None:
        return []
    try:
        given = family.catalogue().rated(case).given
        return [f"life.{name}={rating.value!r} N" for name, rating in given.items()]
    except OutOfRange as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem


def _solver(
    case: Head, family: Family, start: Result | None, **further: Any
) -> Callable[..., dict[str, Any]]:
    """The solve of a family, with its further arguments where they are not None."""
    given = {name: value for name, value in further.items() if value is not None}
    if start is not None:
        if family.initial_state is None:
            raise BadCase(f'start {start.place}: a case of kind = "{case.kind}" starts from no other result')
        given["near"] = family.initial_state()(start, case)
    return partial(family.solve(), **given)


def _comparing_lives(case: Head) -> bool:
    outputs = getattr(case, "outputs", None)
    return isinstance(outputs, LifeOutputs) and outputs.catalogue_life


def _lives_compared(case: Head, family: Family, report: Report, notes: list[Any]) -> dict[str, Any]:
    """The attribute `catalogue_life`, or a further note that says why there is none."""
    from flexbearing.life.against_catalogue import against_catalogue
    from quasidynamic.note import information

    assert family.catalogue is not None  # of a case that has this output
    report.stage("lives against those of a catalogue", None)
    try:
        lives = against_catalogue(
            case, family.catalogue(), reader(case, family), lambda each: compared(each, family)
        )
    except BadCase as problem:
        why = information("no-catalogue-life", f"no life of a catalogue to compare with: {problem}")
        return {"notes": [*notes, why.record()]}
    return {"catalogue_life": lives}


def _weighing(case: Head) -> bool:
    outputs = getattr(case, "outputs", None)
    return isinstance(outputs, ContactOutputs) and outputs.assumed_effects


def _inputs_weighed(case: Head, family: Family, report: Report, notes: list[Any]) -> dict[str, Any]:
    """The attribute `assumed_effects`, or a further note that says why there is none."""
    from quasidynamic.note import information

    try:
        found = effects(case, family, report)
    except BadCase as problem:
        why = information("no-assumed-effects", f"how much assumed inputs matter is not known: {problem}")
        return {"notes": [*notes, why.record()]}
    return {"assumed_effects": found}


def reader(case: Head, family: Family, same: Sequence[str] = ()) -> Callable[[Sequence[str]], Head]:
    """Read the same case with further settings, before which some stand that are the same in all."""
    from flexbearing.case import understood

    def read(further: Sequence[str]) -> Head:
        settings = [*case.source.overrides, *same, *further]
        return understood(case.source.text, Path(case.source.path), settings, {family.kind: family})

    return read


def default_output(case: Head) -> Path:
    """Name of the result of a case that is given none: another one for other settings.

    Raises `BadOutput` where the result of a case of this name in another folder is.
    """
    path = usual_output(case.source.path, case.source.overrides)
    other = case_file(path)
    if other and exists(other) and not Path(other).samefile(case.source.path):  # noqa: PTH110
        raise BadOutput(f"{path}: is the result of {other}; choose another name with -o.")
    return path


def usual_output(case: str | Path, settings: Sequence[str] = ()) -> Path:
    """Name of the result of a case file that is given none, existing or not."""
    return Path("results") / f"{stem_of_outputs(case, settings)}.h5"


def stem_of_outputs(case: str | Path, settings: Sequence[str]) -> str:
    """Stem of the default names of outputs, which carry the settings."""
    if not settings:
        return Path(case).stem
    digest = sha256(repr(tuple(settings)).encode()).hexdigest()[:8]
    words = re.sub(r"[^A-Za-z0-9_.+=-]", "", "_".join(settings))[:LONGEST]
    return f"{Path(case).stem}_{words}_{digest}"


def _head(case: Head) -> dict[str, object]:
    """Root attributes that every kind of case has."""
    return {
        "title": case.title,
        "case_text": case.source.text,
        "case_file": str(Path(case.source.path).resolve())
        .encode(errors="surrogateescape")
        .decode(errors="backslashreplace"),
        "case_overrides": list(case.source.overrides),
        "case_si": case.to_json(),
        "assumed": list(case.assumed),
        "calibrated": dict(case.calibrated),
    }


def answers(cases: Sequence[Any], texts: Sequence[str], family: Family) -> list[Answer]:
    """An answer for each case; one that cannot be computed says why."""
    found = [_refused(case, family) for case in cases]
    possible = [place for place, answer in enumerate(found) if answer is None]
    for first in range(0, len(possible), AT_ONCE):
        places = possible[first : first + AT_ONCE]
        some = [cases[place] for place in places]
        alone = partial(_alone, some, texts, family)
        solved = family.rows()(some, texts, alone) if family.rows else map(alone, range(len(some)))
        for place, answer in zip(places, solved, strict=True):
            found[place] = answer
    return [answer for answer in found if answer is not None]


def _refused(case: Any, family: Family) -> Answer | None:
    """Why a case cannot be computed; None where it can."""
    try:
        require_possible(case, family)
    except BadCase as problem:
        return Answer(BAD_INPUT, _first_line(problem, case), {})
    return None


def _alone(cases: Sequence[Any], texts: Sequence[str], family: Family, place: int) -> Answer:
    """The answer of a run."""
    try:
        result = compared(cases[place], family)
    except BadCase as problem:
        return Answer(BAD_INPUT, _first_line(problem, cases[place]), {})
    return answered(result, texts, family)


def answered(result: Result, texts: Sequence[str], family: Family) -> Answer:
    """The answer that a result holds; of a run that did not converge numbers between rigid raceways alone."""
    about, blocks = result.attributes, {"rigid": result.rigid, "flexible": result.flexible}
    solved = about["status"] == CONVERGED
    numbers = {
        text: requested(family.layout(), text).number(blocks)
        for text in texts
        if solved or text.startswith("rigid.")
    }
    if not solved:
        return Answer(about["status"], about["message"], numbers)
    from quasidynamic.note import of_record

    notes = map(of_record, about["notes"])
    return Answer(CONVERGED, "", numbers, row_findings(stored(about), notes))


def _first_line(problem: BadCase, case: Any) -> str:
    """What is wrong, without the name of the file."""
    return str(problem).splitlines()[0].removeprefix(f"{case.source.path}: ")
