"""How much every input that no source gives matters: outputs of the same case with other values."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import isfinite
from typing import Any

from flexbearing.case import BadCase, Head
from flexbearing.outputs import AbsentOutput, outputs
from flexbearing.progress import Report
from flexbearing.quantities.effects import COMPARISON, LIVES, Effects, KeyEffects, OtherCase, about
from flexbearing.results import Result
from flexbearing.runs.plausible import Other, plausible

STAGE = "effects of assumed inputs"
UNCHANGED = 5e-3  # relative change of the life that is left out where changes are combined


def assumed_effects(
    case: Any,
    read: Callable[[Sequence[str]], Any],
    solved: Callable[[Any, Result | None], Result],  # a case, from the state of another one
    report: Report,
) -> dict[str, Any]:
    """Solve a case with other values of each assumed or calibrated key, one at a time, from its own state."""
    report.stage(STAGE, None)
    itself = solved(_alone(read(())), None)
    of = measured(itself)

    def solved_beside(changed: Any) -> Result:
        return solved(changed, itself)

    keys = list(plausible(case))
    count, done = sum(len(each.others) for each in keys) + 2, 0
    rows = []
    for each in keys:
        found = []
        for other in each.others:
            if row := _compared(other, case, read, solved_beside, of):
                found.append(row)
            done += 1
            report.stage(STAGE, done / count)
        rows.append(KeyEffects(each.key, each.source, found, each.role))
    together = []
    for other in _at_once(rows, of):
        if row := _compared(other, case, read, solved_beside, of):
            together.append(row)
        done += 1
        report.stage(STAGE, done / count)
    return Effects(of, rows, together).stored()


def _at_once(rows: Sequence[KeyEffects], of: dict[str, float]) -> Iterator[Other]:
    """All changes that shorten the life at once, then all that lengthen it; none without a life.

    Of keys that describe one thing, such as the drop and the profile of rollers, the one that changes the
    life most; changes within `UNCHANGED` are left out.
    """
    name = next((name for name in LIVES if name in of), "")
    if not name:
        return
    for words, better in (("shortest life", min), ("longest life", max)):
        chosen: dict[str, tuple[float, tuple[str, ...]]] = {}
        for row in (row for row in rows if row.role != COMPARISON):
            factors = [(other.values[name] / of[name], tuple(other.settings))
                    for other in row.others if name in other.values]  # fmt: skip
            known = [*factors, *filter(None, [chosen.get(about(row.key))])]
            ratio, settings = better(known, default=(1.0, ()))
            if better(ratio, 1.0) == ratio and abs(ratio - 1) > UNCHANGED:
                chosen[about(row.key)] = ratio, settings
        if chosen:
            yield Other(words, tuple(setting for _, settings in chosen.values() for setting in settings))


def _compared(
    other: Other,
    case: Any,
    read: Callable[[Sequence[str]], Any],
    solved: Callable[[Any], Result],
    of: dict[str, float],
) -> OtherCase | None:
    """Lives and weighed outputs with another value; None where it is that of the case."""
    row = OtherCase(other.words, list(other.settings), {}, "")
    try:
        changed = read(other.settings)
        if _values(changed) == _values(case):
            return None
        return replace(row, values=_of_same_rule(measured(solved(_alone(changed))), of))
    except BadCase as problem:
        return replace(row, problem=str(problem).splitlines()[0])


def _of_same_rule(values: dict[str, float], of: dict[str, float]) -> dict[str, float]:
    """A life after factors in place of a basic one, where the case itself has no factors."""
    modified, basic = LIVES
    if modified in values and modified not in of and basic in of:
        values[basic] = values.pop(modified)
    return values


def _values(case: Any) -> dict[str, Any]:
    """Values of all keys, without where they come from."""
    return {name: value for name, value in case.to_json().items() if name not in Head.model_fields}


def _alone(case: Any) -> Any:
    """The case without outputs that a comparison does not need, such as a comparison of its own."""
    return case.model_copy(update={"outputs": type(case.outputs)()})


def measured(result: Result) -> dict[str, float]:
    """Lives and the outputs that inputs are weighed by, in the units of the summary, those that are finite.

    Raises `BadCase` where it has no solution.
    """
    if result.attributes["status"] != "converged":
        raise BadCase(f"not converged: {result.attributes['message']}")
    layout = result.family.layout()
    block = "flexible" if result.flexible else "rigid"
    known = {each.name for each in outputs(layout)}
    found: dict[str, float] = {}
    for name in (
        name for name in (*LIVES, *dict((*layout.weighed, *layout.weighed_in_results))) if name in known
    ):
        try:
            number = float(result[f"{block}.{name}"].number)
        except AbsentOutput:
            continue
        again = name not in LIVES and number and number in found.values()
        if isfinite(number) and not again:
            found[name] = number
    return found
