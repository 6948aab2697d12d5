"""Sensitivities of a roller bearing: which outputs, which keys, and both sides where a contact switches."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.derivatives.keys import Key, announced, given_keys, keys_of
from flexbearing.derivatives.roller_slopes import Difference, OutputSlopes, RollerSlopes, numbers
from flexbearing.derivatives.roller_state import SolvedState, solved
from flexbearing.derivatives.sides import STENCILS, Differentiable, tabled, with_sides
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged, Report
from flexbearing.quantities.roller import CAGE_SLIP, LAYOUT
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange

OUTPUTS = Differentiable(
    LAYOUT,
    ("life", "max_roller_load", CAGE_SLIP.name, "stiffness_zz"),
    ("life_error", "peak_pressure_error", "nominal_bar_stress_error"),
    "inner.kind and outer.kind",
)
REACH = 100.0  # steps, 0.01 % of a value: contacts that open or close within make a derivative one-sided
BEYOND = 2 * REACH  # where the derivatives of both sides are taken


def sensitivities(
    case: Case, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Raises `BadCase` for keys that are none, and cases that have no derivatives; `UnknownOutput`, `WrongUnit`
    for texts that name no output; `NotSolved` where there is no equilibrium.
    """
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked = requested_of(case, of)
    with linear_algebra_alone():  # its threads would only wait for each other
        report = report or Logged()
        return differentiated(solved(case, report), asked, keys, report)


def differentiated(
    state: SolvedState, of: Sequence[RequestedOutput], by: Iterable[Key], report: Report | None = None
) -> Sensitivities:
    """Derivatives at a state that is known."""
    return _Differentiated(state, of).table(announced(list(by), report or Logged()))


def requested_of(case: Case, of: Sequence[str]) -> list[RequestedOutput]:
    """Outputs of a case that are requested, as `sensitivities` takes them."""
    elastic = case.inner.kind != "rigid" or case.outer.kind != "rigid"
    return OUTPUTS.requested(of, basic=case.life.is_basic, elastic=elastic)


@dataclass(frozen=True)
class _Differentiated:
    """A state and the outputs that are differentiated there."""

    state: SolvedState
    outputs: Sequence[RequestedOutput]

    def table(self, keys: Iterable[Key]) -> Sensitivities:
        differences, left_out = _differences(self.state, keys)
        columns: dict[str, NDArray] = {}  # (3, O) slope, below, above by key
        values = numbers(self.state, self.outputs, aligned=self.state.base.aligned)
        for aligned in (True, False):
            some = [each for each in differences if each.aligned is aligned]
            if some:
                slopes = RollerSlopes(self.state, some)
                found = slopes.outputs(self.outputs)
                columns |= dict(self._columns(slopes, found))
        raceways = "rigid raceways" if self.state.rings.rigid else "flexible rings"
        title, by = self.state.base.case.title, [each.key for each in differences]
        return tabled(
            (title, raceways), self.outputs, values, {key: columns[key.path] for key in by}, left_out
        )

    def _columns(self, slopes: RollerSlopes, found: OutputSlopes) -> Iterator[tuple[str, NDArray]]:
        """Yield a key with its derivatives (3, O): slope, and both sides where they differ."""
        for number, each in enumerate(slopes.differences):
            slope, below, above = (of[:, number] for of in (found.slopes, found.below, found.above))
            column, at_limit = (
                with_sides(each.key, found.values, slope, below, above),
                np.isnan(above) != np.isnan(below),
            )
            if found.nearest_switch[number] <= REACH and not at_limit.any():
                moved = slopes.by_step[:, number]
                sides = [self._beyond(each.key, change, moved) for change in (-BEYOND, BEYOND)]
                column = np.where(np.isnan(column[0]), np.nan, [column[0], *sides])
            yield each.key.path, column * each.key.size / each.key.step

    def _beyond(self, key: Key, change: float, by_step: NDArray) -> NDArray:
        """Derivatives (O) by a step on one side of a contact switch; NaN where no equilibrium is there."""
        try:
            moved = self.state.moved(key, change, by_step)
        except (NotSolved, ImpossiblePart, OutOfRange, BadCase, PartnerFailed):
            return np.full(len(self.outputs), np.nan)
        there = replace(key, value=key.value + change * key.step)
        differences, _ = _differences(moved, [there])
        if not differences:
            return np.full(len(self.outputs), np.nan)
        return RollerSlopes(moved, differences).outputs(self.outputs).slopes[:, 0] * key.step / there.step


def _differences(state: SolvedState, keys: Iterable[Key]) -> tuple[list[Difference], list[tuple[str, str]]]:
    """Keys with what their differences are taken of, and keys without, with the reason."""
    found, left_out = [], []
    for key in keys:
        each = difference(state, key)
        if isinstance(each, str):
            left_out.append((key.path, each))
        else:
            found.append(each)
    return found, left_out


def difference(state: SolvedState, key: Key) -> Difference | str:
    """What the differences by a key of a state are taken of, or why there are none."""
    why = "it has no room to change"
    for stencil in STENCILS:
        if all(map(key.allows, stencil.places)):
            try:
                return Difference(key, stencil, tuple(state.variant(key, place) for place in stencil.places))
            except (ImpossiblePart, OutOfRange, BadCase, PartnerFailed) as problem:
                why = str(problem)
    return why
