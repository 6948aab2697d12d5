"""Sensitivities of a bearing with fast balls between rigid rings."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.derivatives.keys import Key, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import tabled, with_sides
from flexbearing.derivatives.stencil import CENTRAL, STENCILS, Stencil
from flexbearing.derivatives.table import Sensitivities
from flexbearing.derivatives.told import told
from flexbearing.outputs import Wanted, outputs, wanted
from flexbearing.progress import Logged, Report
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.runs import angular_contact, ball_life
from quasidynamic import AngularContactBallBearing, ImpossiblePart, NotSolved, OutOfRange, RingOperation
from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.solve.balls.implicit_derivative import Places, moved_places
from quasidynamic.solve.balls.ring_on_balls import RingSolution, newton, solve
from quasidynamic.solve.outcome import SolverOutcome

DEFAULT = ("life", "contact_load_range.inner.largest", "peak_pressure.inner", "stiffness_zz")
ALL, LIFE = "all", "life"
ESTIMATES = ("torque_grid_error",)
RELATIVE_STEP = 1e-7  # of a value: balls are a thousand times larger than their approaches to the races
REACH = 1e-4 / RELATIVE_STEP  # steps: balls that lift off within 0.01 % make a derivative one-sided
BEYOND = 2 * REACH  # where the derivatives of both sides are taken


def sensitivities(
    case: FastCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Parameters
    ----------
    case : FastCase
        as it was read
    of : sequence of str
        outputs, with units if others than those of the summary are wanted; "life" is the modified life where
        the case has one, "all" every output; by default life, largest load, pressure, stiffness
    by : sequence of str
        keys; by default all continuous ones that the case states
    report : Report, optional
        hears of every key; the log, unless given

    Returns
    -------
    Sensitivities

    Raises
    ------
    BadCase
        for keys that are none, and cases whose friction has no derivatives
    UnknownOutput, WrongUnit
        for texts that name no output
    NotSolved
        where there is no equilibrium
    """
    refused = {"operation.control": case.operation.control == "coulomb"}
    refused |= {"friction.model": case.friction.model != "full_sliding"}
    for key, given in refused.items():
        if given:
            raise BadCase(
                f"{case.source.path}: {key} is found by separate iterations without known derivatives; "
                f"derivatives need another one, see flexbearing explain {key}"
            )
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked, shorter = _asked(case, of), [replace(key, relative_step=RELATIVE_STEP) for key in keys]
    return _table(_State.solved(case), asked, told(shorter, report or Logged()))


def _asked(case: FastCase, of: Sequence[str]) -> list[Wanted]:
    texts = list(of) or list(DEFAULT)
    if ALL in texts:
        texts = [each.name for each in outputs(LAYOUT) if each.name not in ESTIMATES]
    life = "life_L10" if case.life.is_basic else "modified_life"
    return [wanted(LAYOUT, life if text == LIFE else text) for text in dict.fromkeys(texts)]


@dataclass(frozen=True)
class _Variant:
    """A case with its bearing at its operating point."""

    case: FastCase
    model: AngularContactBallBearing
    operation: RingOperation

    @classmethod
    def of(cls, case: FastCase) -> "_Variant":
        return cls(case, *angular_contact.build(case))

    @cached_property
    def balance(self) -> AngularBalance:
        return self.model.equations([self.operation])

    def block(self, places: Places) -> dict[str, NDArray]:
        """Quantities with ring and balls at places; raises `NotSolved` where friction is not known."""
        solution = RingSolution(*places, [SolverOutcome.CONVERGED], np.zeros(1), np.zeros(1, int))
        (state,) = self.model.states([self.operation], self.balance, solution)
        if isinstance(state, NotSolved):
            raise state
        lines = self.case.rolling_lines
        contact = state.rolling_contact(spin=lines.spin, friction=lines.net_force)
        lives, safety = ball_life.lives(self.case, state), ball_life.safety(self.case, state)
        return angular_contact.block(self.case, angular_contact.Solution(state, contact, None, lives, safety))


@dataclass(frozen=True)
class _State:
    """A case in equilibrium."""

    base: _Variant
    places: Places

    @classmethod
    def solved(cls, case: FastCase) -> "_State":
        base = _Variant.of(case)
        base.model.solve(base.operation)  # which says why there is none
        solution = solve(base.balance)
        return cls(base, Places(solution.ring, solution.centres))

    @cached_property
    def block(self) -> dict[str, NDArray]:
        return self.base.block(self.places)

    def variant(self, key: Key, change: float) -> _Variant:
        """The case with a key changed by so many steps."""
        if change == 0.0:
            return self.base
        return _Variant.of(with_value(self.base.case, key.path, key.value + change * key.step))

    def moved(self, key: Key, change: float, by_step: Places) -> "_State":
        """The equilibrium with a key changed by so many steps; raises `NotSolved`."""
        variant = self.variant(key, change)
        solution = newton(variant.balance, *self.places.shifted(variant.balance, by_step, change))
        if solution.outcomes[0] is not SolverOutcome.CONVERGED:
            raise NotSolved(f"no equilibrium near {key.path}", solution.outcomes[0])
        return _State(variant, Places(solution.ring, solution.centres))


@dataclass(frozen=True)
class _Slopes:
    """Derivatives of a state by a step of a key."""

    state: _State
    outputs: Sequence[Wanted]
    stencil: Stencil
    variants: tuple[_Variant, ...]

    @cached_property
    def by_step(self) -> Places:
        balances = [variant.balance for variant in self.variants]
        return moved_places(self.state.base.balance, self.state.places, balances, self.stencil.weights)

    @cached_property
    def _blocks(self) -> list[dict[str, NDArray]]:
        """Quantities at the places of the stencil, of variants and unknowns together."""
        both = zip(self.variants, self.stencil.places, strict=True)
        return [
            variant.block(self.state.places.shifted(variant.balance, self.by_step, change))
            for variant, change in both
        ]

    @cached_property
    def values(self) -> NDArray:
        """Of the outputs (O), in the state itself."""
        return _numbers(self.outputs, self.state.block)

    @cached_property
    def _numbers(self) -> NDArray:
        return np.array([_numbers(self.outputs, block) for block in self._blocks])

    @cached_property
    def slope(self) -> NDArray:
        """Derivatives (O)."""
        return np.tensordot(self.stencil.weights, self._numbers, 1)

    def side(self, change: float) -> NDArray:
        """Difference (O) of first order to one side; NaN where the stencil has no place there."""
        if change not in self.stencil.places:
            return np.full(len(self.outputs), np.nan)
        return change * (self._numbers[self.stencil.places.index(change)] - self.values)

    @property
    def steps_to_lift(self) -> float:
        """Steps after which a ball lifts off the inner race, linearly: loads go with the 3/2 power."""
        loads = np.array([block["contact_load"][0] for block in self._blocks])
        change = np.abs(np.tensordot(self.stencil.weights, loads, 1))
        load = self.state.block["contact_load"][0]
        pressed = (load > 0) & (change > 0)
        return float((1.5 * load[pressed] / change[pressed]).min(initial=np.inf))


def _numbers(outputs: Sequence[Wanted], block: dict[str, NDArray]) -> NDArray:
    return np.array([output.number({"rigid": block}) for output in outputs])


def _table(state: _State, asked: Sequence[Wanted], keys: Iterable[Key]) -> Sensitivities:
    columns: dict[Key, NDArray] = {}
    left_out: list[tuple[str, str]] = []
    for key in keys:
        slopes = _slopes(state, asked, key)
        if isinstance(slopes, str):
            left_out.append((key.path, slopes))
        else:
            columns[key] = _column(slopes, key) * key.size / key.step
    heading = state.base.case.title, "rigid raceways"
    return tabled(heading, asked, _numbers(asked, state.block), columns, left_out)


def _slopes(state: _State, asked: Sequence[Wanted], key: Key) -> _Slopes | str:
    """Derivatives of a state by a key, or why there are none."""
    why = "it has no room to change"
    for stencil in STENCILS:
        if all(map(key.allows, stencil.places)):
            try:
                variants = tuple(state.variant(key, change) for change in stencil.places)
                slopes = _Slopes(state, asked, stencil, variants)
                slopes.slope  # noqa: B018  where friction of a variant is not known
            except (ImpossiblePart, OutOfRange, BadCase, NotSolved) as problem:
                why = str(problem)
            else:
                return slopes
    return why


def _column(slopes: _Slopes, key: Key) -> NDArray:
    """Slope and both sides (3, O) by a step."""
    column = with_sides(key, slopes.values, slopes.slope, slopes.side(-1.0), slopes.side(1.0))
    if slopes.stencil is CENTRAL and slopes.steps_to_lift <= REACH:
        sides = [_beyond(slopes, key, change) for change in (-BEYOND, BEYOND)]
        column = np.where(np.isnan(column[0]), np.nan, [column[0], *sides])
    return column


def _beyond(slopes: _Slopes, key: Key, change: float) -> NDArray:
    """Derivatives (O) by a step at the equilibrium some steps away; NaN where there is none."""
    there = replace(key, value=key.value + change * key.step)
    try:
        beyond = _slopes(slopes.state.moved(key, change, slopes.by_step), slopes.outputs, there)
    except (NotSolved, ImpossiblePart, OutOfRange, BadCase):
        beyond = ""
    if isinstance(beyond, str):
        return np.full(len(slopes.outputs), np.nan)
    return beyond.slope * key.step / there.step
