"""From an optimisation file to what is varied, what is wanted and under which conditions."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from flexbearing import inputs
from flexbearing.case.as_written import rated_apart
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source as CaseSource, next_to, value_at
from flexbearing.case.problems import BadCase, validated
from flexbearing.case.read import LONGEST_NAME, with_settings
from flexbearing.case.text import tables
from flexbearing.optimise.goals import Bound, Goal, Measure
from flexbearing.optimise.schema import DUTY_LIFE, OptimisationFile, Search
from flexbearing.optimise.variables import Variable, variables
from flexbearing.outputs import UnknownOutput, WrongUnit, requested
from flexbearing.printable import excerpt
from flexbearing.studies.file import Study
from flexbearing.studies.file.read import Source, declared, flat_tables, study_of
from flexbearing.studies.file.schema import StudyFile
from flexbearing.studies.file.values import BadValues
from flexbearing.studies.table.duty import Cycles

Settings = Mapping[str, Any]  # keys of the case to values in its words
_TABLES = "set", "vary", "constrain", "over", "duty", "surrogate"
BOUND = '"<= 2500 MPa", ">= 20000 h" or "100 kN/mm .. 120 kN/mm"'
_NUMBER = r"([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([^\s.][^<>]*?)?\s*"
_ONE = re.compile(rf"\s*(<=|>=)\s*{_NUMBER}")
_TWO = re.compile(rf"\s*{_NUMBER}\.\.\s*{_NUMBER}")


@dataclass(frozen=True)
class Problem:
    """An optimisation file that was read."""

    study: Study  # conditions under which every design is computed
    fixed: Settings  # of every design
    variables: tuple[Variable, ...]
    lists: Mapping[str, list[Any]]  # of keys whose entries are varied, what the case has there
    goal: Callable[[Cycles | None], Goal]  # given the duty cycle with its speeds
    bounds: Callable[[Cycles | None], tuple[Bound, ...]]
    search: Search
    verify: tuple[Settings, ...]
    surrogate: Settings  # of the cheaper model that is searched; none: the case itself is


def read(source: Source, families: Families, case: Head | None = None) -> Problem:
    """Read an optimisation, from its file or as a dictionary; of its case unless that is given.

    Raises `BadCase`, one line for each problem: file, key, value found, what is allowed, nearest valid name.
    """
    raw, file = flat_tables(source, "optimisation", _TABLES)
    raw = raw if case is None else {**raw, "case": case.source.path}
    given = _validated(raw, file)
    conditions = {name: raw[name] for name in ("case", "name", "over", "duty") if name in raw}
    study = study_of(StudyFile.model_validate(conditions), file, families, case)
    find = partial(declared, model=families[study.kind].case(), families=families)
    layout, files = families[study.kind].layout(), families[study.kind].case().file_keys
    name = excerpt(file.name, LONGEST_NAME)
    where = "vary"
    try:
        fixed, text = given.set.model_extra or {}, _with_settings(study, families)
        found = variables(given.vary.model_extra or {}, find, lambda key: fixed.get(key, value_at(text, key)))
        _require_apart(found, study, fixed, "[set]")
        entries = [each.key for each in found if each.entry is not None]
        lists = {key: fixed.get(key, value_at(text, key)) for key in entries}
        surrogate, verify = (
            given.surrogate.model_extra or {},
            [each.model_extra or {} for each in given.verify],
        )
        _require_apart(found, study, surrogate, "[surrogate]")
        tables_of_keys = [("set", fixed), ("surrogate", surrogate), *(("verify", each) for each in verify)]
        for where, key in ((table, key) for table, settings in tables_of_keys for key in settings):  # noqa: B007
            find(key)
        where = "maximise" if given.maximise else "minimise"
        goal = _goal(given, study, layout)
        where = "constrain"
        bounds = _bounds(given.constrain, study, layout)
    except (BadValues, UnknownOutput, WrongUnit) as problem:
        raise BadCase(f"{name}: [{where}] {problem}") from None
    named = [value for each in (fixed, surrogate, *verify) for key, value in each.items() if key in files]
    study = study.reading(*next_to(study.case, named))
    return Problem(
        study, fixed, found, lists, goal, bounds, given.search, tuple(verify), surrogate
    )  # fmt: skip


def _with_settings(study: Study, families: Families) -> dict[str, Any]:
    """Tables of the case with the settings that every variant has."""
    raw = tables(study.text)
    if study.settings:
        with_settings(raw, CaseSource(str(study.case), study.text, study.settings), families)
    return raw


def _validated(raw: dict[str, Any], file: Path) -> OptimisationFile:
    name = excerpt(file.name, LONGEST_NAME)
    given = validated(raw, name, OptimisationFile, {})
    if (given.maximise is None) == (given.minimise is None):
        raise BadCase(f"{name}: [maximise] or [minimise] is needed, one of them.")
    if given.search.verified and not given.verify:
        raise BadCase(
            f"{name}: search.verified needs [[verify]], whose first settings constraints are met with."
        )
    return given


def _require_apart(found: tuple[Variable, ...], study: Study, fixed: Settings, table: str) -> None:
    """Refuse a key in two tables, speeds, which weigh rows of a duty cycle, and ratings beside sizes."""
    others = dict.fromkeys(study.keys, "[over] or [duty]") | dict.fromkeys(fixed, table)
    varied = [each.key for each in found]
    if why := rated_apart((*fixed, *varied, *study.keys), varied):
        raise BadValues(why)
    for each in found:
        if each.entry is None and each.key in others:
            raise BadValues(f"{each.name} is given in {others[each.key]}, too")
        if study.spectrum and each.key.startswith("operation.") and each.key.endswith("speed"):
            raise BadValues(f"{each.name} cannot be varied: speeds weigh the rows of [duty]")


def _goal(given: OptimisationFile, study: Study, layout: Any) -> Callable[[Cycles | None], Goal]:
    objective = given.maximise or given.minimise
    assert objective is not None
    name, _, unit = objective.output.partition("[")
    measure = _measure(name.strip(), unit.rstrip(" ]"), study, layout)
    sign = 1.0 if given.maximise else -1.0
    return lambda cycles: Goal(
        measure(cycles), sign, objective.over == "worst", objective.scale == "logarithmic"
    )


def _measure(name: str, unit: str, study: Study, layout: Any) -> Callable[[Cycles | None], Measure]:
    """An output by its name and unit, or the life of the duty cycle."""
    if name != DUTY_LIFE:
        found = requested(layout, f"{name} [{unit}]" if unit else name)
        return lambda cycles: Measure(found.name, f"{found.name} [{found.unit}]", found.unit)
    if study.spectrum is None:
        raise BadValues(f"{DUTY_LIFE} needs [duty], whose rows it cumulates")
    life = study.spectrum.life
    unit = requested(layout, f"{life} [{unit or 'h'}]").unit
    return lambda cycles: Measure(DUTY_LIFE, f"{life} [Mrev]", unit, cycles)


def _bounds(
    given: Mapping[str, Any], study: Study, layout: Any
) -> Callable[[Cycles | None], tuple[Bound, ...]]:
    sides: list[tuple[Callable[[Cycles | None], Measure], float, bool]] = []
    for name, text in given.items():
        for number, unit, upper in _sides(name, text):
            sides.append((_measure(name, unit, study, layout), number, upper))
    return lambda cycles: tuple(Bound(measure(cycles), number, upper) for measure, number, upper in sides)


def _sides(name: str, text: Any) -> list[tuple[float, str, bool]]:
    """Numbers of a bound with their units, and whether each is an upper one."""
    short = isinstance(text, str) and len(text) <= 300
    one, two = (_ONE.fullmatch(text), _TWO.fullmatch(text)) if short else (None, None)
    try:
        if one:
            return [(inputs.number(one[2]), one[3] or "", one[1] == "<=")]
        if two:
            low, high = inputs.number(two[1]), inputs.number(two[3])
            return [(low, two[2] or "", False), (high, two[4] or "", True)]
    except inputs.BadNumber:
        pass
    raise BadValues(f"{name} = {excerpt(str(text))} is no bound; it must be {BOUND}")
