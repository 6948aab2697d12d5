"""The text that an optimisation prints."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from flexbearing.findings.row import by_sentence
from flexbearing.findings.running import PRESSED_ENDS
from flexbearing.optimise.answer import Measured, Optimum
from flexbearing.optimise.gradients import EXACT
from flexbearing.optimise.run import CASE, TABLE
from flexbearing.optimise.search import FEASIBLE, End, SearchResult

MOST = 20  # lines of reasons that are printed


def start(found: SearchResult, optimum: str = "") -> str:
    """A line of the search from one start."""
    return f"start: {found.end} after {found.iterations} iterations{optimum}"


def page(optimum: Optimum, folder: Path) -> str:
    """The answer as text."""
    search, verification = optimum.seconds
    of_surrogate = f" and {optimum.cheap} of the surrogate" if optimum.cheap else ""
    lines = [
        f"{optimum.name}: {optimum.ending}",
        *_design(optimum),
        "",
        *_numbers(optimum),
        "",
        *(_limits(optimum) if optimum.usable else ()),
        *_starts(optimum),
        *_derivatives(optimum),
        f"{optimum.designs} designs{of_surrogate}, {optimum.rows} rows computed now: "
        f"searched in {search:.1f} s, "
        f"verified in {verification:.1f} s",
        f"all designs: {folder / (optimum.name + TABLE)}",
        f"case of the best: {folder / (optimum.name + CASE)}"
        if optimum.usable
        else "no case of the best is written",
    ]
    return "\n".join(lines)


def _design(optimum: Optimum) -> Iterator[str]:
    """The best value of each key."""
    for each, value in zip(optimum.variables, optimum.best.point, strict=True):
        unit = f" {each.unit}" if each.unit else ""
        bounds = f"{each.low:g} .. {each.high:g}{unit}"
        yield f"  {each.name} = {value:.6g}{unit}   (of {bounds})"
    if optimum.best.end is End.INFEASIBLE:
        yield f"  it misses a constraint by {optimum.best.missed:.2%}; no start came closer"
    for words in optimum.violated[:MOST]:
        yield f"  missed: {words}"
    for words, _ in islice(by_sentence(enumerate(optimum.findings)), MOST):
        yield f"  {words}"
    yield from _peaks(optimum)


def _peaks(optimum: Optimum) -> Iterator[str]:
    """What half-spaces say of the peak pressure of the best point."""
    peaks = optimum.peaks
    if peaks is None:
        return
    if peaks.message:
        yield f"  peak pressure not checked by half-spaces: {peaks.message}"
        return
    yield f"  peak pressure: {peaks.sliced:.5g} MPa of slices, {peaks.whole:.5g} MPa by half-spaces"
    if not peaks.hold:
        yield f"  {PRESSED_ENDS.meaning}; {PRESSED_ENDS.action}"


def _numbers(optimum: Optimum) -> Iterator[str]:
    """Objective and constraints of the case and of the best point, also with other settings."""
    goal, rows = optimum.goal, [(optimum.case, optimum.measured), *optimum.verified]
    unit = "" if goal.measure.unit == "1" else f" {goal.measure.unit}"
    which, of = "largest" if goal.sign > 0 else "least", "worst row" if goal.worst else "mean of all rows"
    yield f"{which} {goal.measure.name}, {of}: case -> best"
    for number, (case, best) in enumerate(rows):
        change = _objective(case, best, unit, gain=optimum.usable)
        yield f"  {'as searched' if number == 0 else best.what}: {change}"
        for place, bound in enumerate(optimum.bounds):
            if best.bounds:
                before = f"{case.bounds[place]:.6g} -> " if case.bounds else ""
                yield f"    {bound.words}: {before}{best.bounds[place]:.6g}"
        if number > 0 and best.missed > FEASIBLE:
            yield f"    a constraint is missed by {best.missed:.2%} here"


def _objective(case: Measured, best: Measured, unit: str, *, gain: bool) -> str:
    if best.objective is None:
        return f"not solved: {best.message}"
    if case.objective is None:
        return f"{best.objective:.6g}{unit} (the case was not solved: {case.message})"
    change = f" ({best.objective / case.objective - 1:+.1%})" if gain and case.objective else ""
    return f"{case.objective:.6g} -> {best.objective:.6g}{unit}{change}"


def _limits(optimum: Optimum) -> Iterator[str]:
    """What is active, and what one unit more of it would give."""
    if not optimum.active:
        yield "no constraint and no bound of a key is active: the optimum lies inside all limits"
        return
    yield "active limits:"
    for each in optimum.active:
        one = "1" if each.unit == "1" else f"1 {each.unit}"
        change = f"{optimum.goal.measure.name} by {100 * each.gain:+.3g} %"
        yield f"  {each.words}: {one} more room would change {change}"


def _starts(optimum: Optimum) -> Iterator[str]:
    """How each start ended, and whether they agree."""
    agreeing, count = len(optimum.agreeing), len(optimum.starts)
    yield f"{agreeing} of {count} starts end within 0.1 % of the best:"
    for found in optimum.starts:
        values = ", ".join(f"{value:.5g}" for value in found.point)
        left = "" if found.optimality is None else f", gain still possible {found.optimality.gain:.1e}"
        reason = "" if found.end is End.CONVERGED else f" ({found.message})"
        yield f"  {found.end} after {found.iterations} iterations{left}{reason}: {values}"


def _derivatives(optimum: Optimum) -> Iterator[str]:
    """How the derivatives by each key were found, and why not otherwise."""
    kinds: dict[str, list[str]] = {}
    for name, how in optimum.how.items():
        kinds.setdefault(how, []).append(name)
    for how, names in kinds.items():
        yield f"{how}: {', '.join(names)}"
    reasons = dict.fromkeys(why for key, why in optimum.refused.items() if optimum.how.get(key) != EXACT)
    for why in list(reasons)[:MOST]:
        yield f"  no derivatives at the equilibrium: {why}"
