"""Derivatives of a ball bearing key by key: which differences, and both sides where a contact switches."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.derivatives.keys import Key
from flexbearing.derivatives.sides import CENTRAL, STENCILS, Stencil, with_sides
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange

REACH = 1e-4  # of a value: contacts that open or close within make a derivative one-sided
BEYOND = 2.0  # of the reach: where the derivatives of both sides are taken


class State(Protocol):
    """An equilibrium with the outputs that are differentiated there."""

    def differences(self, key: Key, stencil: Stencil) -> "Differences":
        """Outputs of variants of a key, linearly near the state.

        Raises `ImpossiblePart`, `OutOfRange`, `BadCase` or `NotSolved` where there are none.
        """
        ...


@dataclass(frozen=True)
class Differences:
    """Outputs of a state, and of variants of it at the places of a stencil, linearly near the state."""

    stencil: Stencil
    values: NDArray  # (O) in the state itself
    numbers: NDArray  # (V, O) at the places of the stencil
    steps_to_switch: float  # steps after which a contact opens or closes, linearly
    moved: Callable[[float], State]  # the equilibrium so many steps away; raises `NotSolved`

    @property
    def slope(self) -> NDArray:
        """Derivatives (O) by a step."""
        return np.tensordot(self.stencil.weights, self.numbers, 1)

    def side(self, change: float) -> NDArray:
        """Difference (O) of first order to one side; NaN where the stencil has no place there."""
        if change not in self.stencil.places:
            return np.full(len(self.values), np.nan)
        return change * (self.numbers[self.stencil.places.index(change)] - self.values)


def columns(state: State, keys: Iterable[Key]) -> tuple[dict[Key, NDArray], list[tuple[str, str]]]:
    """Derivatives of outputs by keys."""
    found: dict[Key, NDArray] = {}
    left_out: list[tuple[str, str]] = []
    for key in keys:
        differences = _differences(state, key)
        if isinstance(differences, str):
            left_out.append((key.path, differences))
        else:
            found[key] = _column(differences, key) * key.size / key.step
    return found, left_out


def _differences(state: State, key: Key) -> Differences | str:
    """Differences by a key, or why there are none."""
    why = "it has no room to change"
    for stencil in STENCILS:
        if all(map(key.allows, stencil.places)):
            try:
                return state.differences(key, stencil)
            except (ImpossiblePart, OutOfRange, BadCase, NotSolved) as problem:
                why = str(problem)
    return why


def _column(differences: Differences, key: Key) -> NDArray:
    """Slope and both sides (3, O) by a step."""
    sides = (differences.side(change) for change in (-1.0, 1.0))
    column = with_sides(key, differences.values, differences.slope, *sides)
    reach = REACH / key.relative_step  # in steps
    if differences.stencil is CENTRAL and differences.steps_to_switch <= reach:
        beyond = [_beyond(differences, key, side * BEYOND * reach) for side in (-1, 1)]
        column = np.where(np.isnan(column[0]), np.nan, [column[0], *beyond])
    return column


def _beyond(differences: Differences, key: Key, change: float) -> NDArray:
    """Derivatives (O) by a step at the equilibrium some steps away; NaN where there is none."""
    there = replace(key, value=key.value + change * key.step)
    try:
        beyond = _differences(differences.moved(change), there)
    except (NotSolved, ImpossiblePart, OutOfRange, BadCase):
        beyond = ""
    if isinstance(beyond, str):
        return np.full(len(differences.values), np.nan)
    return beyond.slope * key.step / there.step
