"""What a worker does with a task: variants side by side, with the answers of single runs."""

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from math import isnan
from pathlib import Path
from time import perf_counter
from typing import Any

from flexbearing.accuracy.shared import Levels, UsualLevels, shared_levels
from flexbearing.api import compute
from flexbearing.build.ring_parts import Race, part_of
from flexbearing.cache import complaints
from flexbearing.cache.store import VARIABLE
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput, NotStored
from flexbearing.findings.row import information
from flexbearing.printable import one_line
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.program.worker_processes import keep_freed
from flexbearing.progress import Logged
from flexbearing.results import store
from flexbearing.runs.answer import Answer
from flexbearing.runs.run_case import answered
from flexbearing.studies.idle import bounded, without_factor
from flexbearing.studies.plan import Condensed, Corners, Ring, Row, Task, Variant
from flexbearing.studies.plan.task import BAD_INPUT, CONVERGED, ERROR, NOT_STORED, RATED, file_name
from flexbearing.studies.prepared_study import variants_of
from flexbearing.studies.table.collected import errors
from flexbearing.studies.table.duty import MODIFIED, MREV
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange


@dataclass(frozen=True)
class RowRequest:
    """What is wanted of every variant."""

    texts: tuple[str, ...]  # outputs, with units
    search: bool = False  # whether other equilibria are searched where they are likely, of every row
    files: Path | None = None  # folder of a result file for each variant; None where the rows suffice
    final: bool = False  # whether these files hold end states alone
    cycle: bool = False  # whether they are rows of a duty cycle
    levels: Levels | None = None  # that variants with accuracy.target share


def rows(task: Task, request: RowRequest, cache: str | None = None) -> tuple[Row, ...]:
    """Compute the variants of a task."""
    keep_freed()
    read = variants_of(task.base)
    known = (read.known(variant.values, variant.in_si) for variant in task.variants)
    both = zip(task.variants, known, strict=True)
    cases = [without_factor(case) if variant.thin else case for variant, case in both]
    levels = UsualLevels(task.levels) if isinstance(task.levels, str) else task.levels
    request = replace(request, levels=levels)
    with rings_in(cache), complaints() as heard:
        ended = tuple(_rows(list(zip(task.variants, cases, strict=True)), request))
    once = tuple(dict.fromkeys(heard))
    return tuple(replace(row, complaints=once) for row in ended) if once else ended


def condense(ring: Ring | Corners, cache: str | None = None, *, here: bool = False) -> Condensed:
    """Condense a ring into the cache; errors are reported by the variants that have it."""
    with complaints() as heard:
        levels = None
        if isinstance(ring, Corners):
            with rings_in(cache), linear_algebra_alone():
                cases = _cases(ring)
                of_family = FAMILIES[cases[0].kind].levels
                assert of_family  # of cases that share levels
                levels = shared_levels(cases, of_family(), Logged())
        else:
            _keep(ring, cache, here=here)
    return Condensed(levels, tuple(dict.fromkeys(heard)))


def _cases(corners: Corners) -> list[Head]:
    read = variants_of(corners.base)
    return [read.known(variant.values, variant.in_si) for variant in corners.variants]


def _keep(ring: Ring, cache: str | None, *, here: bool) -> None:
    """Put a ring into the cache."""
    case = variants_of(ring.base).known(ring.variant.values, ring.variant.in_si)
    race: Race = "inner" if ring.race == "inner" else "outer"
    with rings_in(cache), suppress(BadCase, NotSolved, PartnerFailed), linear_algebra_alone():
        if isinstance(case, FastCase | FourPointCase):
            from flexbearing.rings.grooves import compliance, shape_of

            in_fit = isinstance(case, FastCase) and case.in_fit and race == "outer"
            if (shape := shape_of(case, race)) and not in_fit:
                compliance(case, shape, Logged())
        elif isinstance(case, Case):
            _keep_raceway(case, race, here=here)


def _keep_raceway(case: Case, race: Race, *, here: bool) -> None:
    from fem.condense import condense_in_process
    from flexbearing.build.roller_bearing import bearing
    from flexbearing.rings.condensed import raceway
    from flexbearing.rings.fits import is_in_fit
    from flexbearing.rings.resolution import resolved

    part = part_of(case, race)
    if part is None or is_in_fit(case, race):
        return

    def meshed_here() -> Any:
        return condense_in_process(*resolved(part, case))

    raceway(case, race, bearing(case).bearing.azimuths, Logged(), meshed_here if here else None)


@contextmanager
def rings_in(folder: str | None) -> Iterator[None]:
    """Let condensed rings be kept in a folder of the study, where the user keeps none."""
    before = os.environ.get(VARIABLE)
    if folder is not None:
        os.environ[VARIABLE] = folder
    try:
        yield
    finally:
        if folder is not None:
            os.environ.pop(VARIABLE)
            os.environ |= {} if before is None else {VARIABLE: before}


def _rows(found: Sequence[tuple[Variant, Head]], request: RowRequest) -> Iterator[Row]:
    """Rows of variants as their family answers many; from runs where each stores its result.

    A result file that cannot be written is the last row.
    """
    began, cases = perf_counter(), [case for _, case in found]
    family = FAMILIES[cases[0].kind]
    if request.files is not None or family.rows is None:
        for variant, case in found:
            row = _alone(variant, case, request)
            yield row
            if row.status == NOT_STORED:
                return
        return
    answered = family.rows()(
        cases,
        request.texts,
        lambda place: _answer(cases[place], request),
        search=request.search,
        levels=request.levels,
    )
    seconds = (perf_counter() - began) / len(found)
    for (variant, case), answer in zip(found, answered, strict=True):
        yield _row(variant, case, answer, seconds, request)


def _alone(variant: Variant, case: Head, request: RowRequest) -> Row:
    """Row from a run of its own."""
    began = perf_counter()
    file = None if request.files is None else request.files / file_name(variant, final=request.final)
    answer = _answer(case, request, file)
    return _row(variant, case, answer, perf_counter() - began, request)


def _row(variant: Variant, case: Head, answer: Answer, seconds: float, request: RowRequest) -> Row:
    values = {text: number for text, number in answer.numbers.items() if not isnan(number)}
    if request.levels is not None and answer.status == CONVERGED:
        values |= errors(request.levels.estimate, request.texts, case.kind, FAMILIES)
    row = Row(
        variant.identity,
        answer.status,
        one_line(answer.message),
        round(seconds, 6),
        values,
        answer.findings,
        answer.own_run,
    )
    if request.cycle and MODIFIED in request.texts and MODIFIED not in values:
        row = _by_ratings(row, case)
    if variant.thin:
        least = information("least-factor", variant.thin)
        row = replace(row, values=bounded(row.values), findings=(least, *row.findings))
    return row


def _by_ratings(row: Row, case: Any) -> Row:
    """A row with the life by ratings, where its case has that: it needs no equilibrium."""
    catalogue = FAMILIES[case.kind].catalogue
    try:
        life = catalogue().rated(case).lived if catalogue else None
    except (ImpossiblePart, OutOfRange):
        life = None
    if life is None:
        return row
    rated = replace(row, values={**row.values, MODIFIED: life / MREV})
    if row.converged:
        return rated
    why = information("life-by-ratings", f"life by ratings alone; {row.status}: {row.message}")
    return replace(rated, status=RATED, message="", findings=(why,))


def _answer(case: Head, request: RowRequest, file: Path | None = None) -> Answer:
    """The answer of a run; that between rigid raceways where it does not converge."""
    try:
        output = None if request.final else file
        others = "searched" if request.search else "reported"
        result = compute(case, output=output, levels=request.levels, others=others)
        if file is not None and request.final:
            store(result.end_states, file, case.input_files)
    except BadCase as problem:
        return Answer(BAD_INPUT, str(problem), {})
    except (BadOutput, NotStored) as problem:
        return Answer(NOT_STORED, str(problem), {})
    except MemoryError:
        return Answer(ERROR, "out of memory", {})
    except Exception as problem:  # of one variant, which must not end the others
        return Answer(ERROR, f"{type(problem).__name__}: {problem}", {})
    return answered(result, request.texts, FAMILIES[case.kind])
