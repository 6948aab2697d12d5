"""Sensitivities of a bearing with fast balls between rigid rings."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.derivatives.by_keys import Differences, columns
from flexbearing.derivatives.key_messages import announced
from flexbearing.derivatives.keys import Key, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import tabled
from flexbearing.derivatives.stencil import Stencil
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput, outputs, requested
from flexbearing.progress import Logged, Report
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.runs import angular_contact
from quasidynamic import AngularContactBallBearing, NotSolved, RingOperation
from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.solve.balls.implicit_derivative import Places, moved_places
from quasidynamic.solve.balls.ring_on_balls import RingSolution, newton, solve
from quasidynamic.solve.step_length import SolverOutcome

DEFAULT = ("life", "contact_load_range.inner.largest", "peak_pressure.inner", "stiffness_zz")
ALL, LIFE = "all", "life"
ESTIMATES = ("torque_grid_error",)
RELATIVE_STEP = 1e-7  # of a value: balls are a thousand times larger than their approaches to the races


def sensitivities(
    case: FastCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

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
    if not case.rigid:
        raise BadCase(
            f"{case.source.path}: derivatives of ball bearings are those between rigid rings; allowed are "
            'outer.kind = "rigid" and inner.kind = "rigid"'
        )
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked = _asked(case, of)
    state = _Differentiated(_State.solved(case), asked)
    shorter = [replace(key, relative_step=RELATIVE_STEP) for key in keys]
    found, left_out = columns(state, announced(shorter, report or Logged()))
    return tabled((case.title, "rigid raceways"), asked, state.values, found, left_out)


def _asked(case: FastCase, of: Sequence[str]) -> list[RequestedOutput]:
    texts = list(of) or list(DEFAULT)
    if ALL in texts:
        texts = [each.name for each in outputs(LAYOUT) if each.name not in ESTIMATES]
    life = "life_L10" if case.life.is_basic else "modified_life"
    return [requested(LAYOUT, life if text == LIFE else text) for text in dict.fromkeys(texts)]


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
        return angular_contact.block(angular_contact.followed(self.case, state))


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
class _Differentiated:
    """A state and the outputs that are differentiated there."""

    state: _State
    outputs: Sequence[RequestedOutput]

    @cached_property
    def values(self) -> NDArray:
        """Of the outputs (O)."""
        return self._numbers(self.state.block)

    def differences(self, key: Key, stencil: Stencil) -> Differences:
        """Outputs of variants and unknowns together, at the places of a stencil."""
        state = self.state
        variants = [state.variant(key, change) for change in stencil.places]
        balances = [variant.balance for variant in variants]
        by_step = moved_places(state.base.balance, state.places, balances, stencil.weights)
        blocks = [
            variant.block(state.places.shifted(variant.balance, by_step, change))
            for variant, change in zip(variants, stencil.places, strict=True)
        ]
        return Differences(
            stencil,
            self.values,
            np.array([self._numbers(block) for block in blocks]),
            self._steps_to_lift(stencil, blocks),
            lambda change: _Differentiated(state.moved(key, change, by_step), self.outputs),
        )

    def _numbers(self, block: dict[str, NDArray]) -> NDArray:
        return np.array([output.number({"rigid": block}) for output in self.outputs])

    def _steps_to_lift(self, stencil: Stencil, blocks: Sequence[dict[str, NDArray]]) -> float:
        """Steps after which a ball lifts off the inner race, linearly: loads go with the 3/2 power."""
        loads = np.array([block["contact_load"][0] for block in blocks])
        change = np.abs(np.tensordot(stencil.weights, loads, 1))
        load = self.state.block["contact_load"][0]
        pressed = (load > 0) & (change > 0)
        return float((1.5 * load[pressed] / change[pressed]).min(initial=np.inf))
