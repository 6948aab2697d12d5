"""Sensitivities of a bearing with fast balls."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.derivatives.by_keys import Differences, columns
from flexbearing.derivatives.keys import Key, announced, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import Differentiable, Stencil, tabled
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput
from flexbearing.outputs.names import PROBE
from flexbearing.progress import Logged, Report
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.runs import angular_contact
from quasidynamic import AngularContactBallBearing, NotSolved, RingOperation
from quasidynamic.solve.balls.implicit_derivative import Equations, moved_places, newton_step
from quasidynamic.solve.balls.ring_in_elastic_grooves import (
    ElasticGrooves,
    Places,
    as_solution,
    solve_elastic,
    unmoved,
)
from quasidynamic.solve.step_length import SolverOutcome

if TYPE_CHECKING:
    from flexbearing.derivatives.near_grooves import NearGrooves, NearReadings

OUTPUTS = Differentiable(
    LAYOUT,
    ("life", "contact_load_range.inner.largest", "peak_pressure.inner", "stiffness_zz"),
    ("torque_grid_error",),
    "inner.kind and outer.kind",
)
RIGID = ElasticGrooves(None, None)
RELATIVE_STEP = 1e-7  # of a value: balls are a thousand times larger than their approaches to the races


def sensitivities(
    case: FastCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Raises `BadCase` for keys that are none, outputs of rigid rings where rings are elastic, and cases whose
    friction has no derivatives; `UnknownOutput`, `WrongUnit` for texts that name no output; `NotSolved` where
    there is no equilibrium.
    """
    if case.accuracy.target is not None:
        raise BadCase(
            f"{case.source.path}: accuracy.target chooses levels anew for every value of a key; take the key "
            "out for derivatives."
        )
    refused = {"operation.control": case.operation.by_friction}
    refused |= {"outer.bilateral": case.outer.lifts_off, "outer.housing_clearance": case.in_fit}
    refused |= {"friction.model": case.friction.model != "full_sliding"}
    for key, given in refused.items():
        if given:
            raise BadCase(
                f"{case.source.path}: {key} is found by separate iterations without known derivatives; "
                f"derivatives need another one, see flexbearing explain {key}"
            )
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked = OUTPUTS.requested(of, basic=case.life.is_basic, elastic=not case.rigid)
    if not any(output.name.partition("_")[0] == PROBE for output in asked):
        case = case.model_copy(update={"outputs": case.outputs.model_copy(update={"probes": None})})
    report = report or Logged()
    state = _Differentiated(_State.of(case, report), asked)
    shorter = [replace(key, relative_step=RELATIVE_STEP) for key in keys]
    found, left_out = columns(state, announced(shorter, report))
    raceways = "rigid raceways" if case.rigid else "flexible rings"
    return tabled((case.title, raceways), asked, state.values, found, left_out)


@dataclass(frozen=True)
class _Variant:
    """A case with its bearing at an operating point, and its grooves."""

    case: FastCase
    grooves: ElasticGrooves
    model: AngularContactBallBearing
    operation: RingOperation

    @classmethod
    def of(cls, case: FastCase, grooves: ElasticGrooves) -> "_Variant":
        model = angular_contact.on_cam(case, angular_contact.bearing(case))
        return cls(case, grooves, model, angular_contact.operation(case))

    @property
    def at_rest(self) -> "_Variant | None":
        """Under the preload force that decides where elastic rings are held; None without."""
        rest = angular_contact.preload_at_rest(self.case)
        return rest and replace(self, operation=rest)

    def held_where(self, places: Places) -> "_Variant":
        """The ring held where it is at other places."""
        return replace(self, operation=angular_contact.held_at(self.operation, float(places.ring[0, 0])))

    @cached_property
    def equations(self) -> Equations:
        return self.model.equations([self.operation]), self.grooves

    def solution(self, places: Places) -> angular_contact.Solution:
        """Solution at places of ring, grooves and balls; raises `NotSolved` where friction is not known."""
        balance, grooves = self.equations
        solution = as_solution(balance, unmoved(balance, grooves, places), [SolverOutcome.CONVERGED])
        moved = None if self.case.rigid else solution.moved
        (state,) = self.model.states([self.operation], balance, solution.rings, moved)
        if isinstance(state, NotSolved):
            raise state
        return angular_contact.followed(self.case, state)


@dataclass(frozen=True)
class _State:
    """A case in equilibrium, and at rest under the force that decides where its elastic rings are held."""

    base: _Variant
    places: Places
    near: "NearGrooves | None"  # None between rigid rings
    rest: "_State | None"

    @classmethod
    def of(cls, case: FastCase, report: Report) -> "_State":
        if case.rigid:
            return cls.solved(_Variant.of(case, RIGID), None)
        from flexbearing.derivatives.near_grooves import NearGrooves  # rigid rings need no finite elements
        from flexbearing.rings.grooves import elastic_grooves

        azimuths = angular_contact.bearing(case).bearing.azimuths
        grooves = elastic_grooves(case, azimuths, report)
        assert grooves  # as one is elastic
        return cls.solved(_Variant.of(case, grooves), NearGrooves(case, grooves, azimuths))

    @classmethod
    def solved(cls, variant: _Variant, near: "NearGrooves | None") -> "_State":
        """Raises `NotSolved`."""
        rest = variant.at_rest and cls._balanced(variant.at_rest, near)
        return cls._balanced(variant.held_where(rest.places) if rest else variant, near, rest)

    @classmethod
    def _balanced(cls, base: _Variant, near: "NearGrooves | None", rest: "_State | None" = None) -> "_State":
        base.model.solve(base.operation, base.grooves)  # which says why there is none
        return cls(base, solve_elastic(*base.equations).places, near, rest)

    @cached_property
    def block(self) -> dict[str, NDArray]:
        return self.block_of(self.base, self.places)

    def block_of(self, variant: _Variant, places: Places) -> dict[str, NDArray]:
        """Quantities of a variant at places of ring, grooves and balls."""
        solution = variant.solution(places)
        if self._readings is not None:
            solution = replace(solution, probes=self._readings.of(variant.case, solution.state))
        return angular_contact.block(solution)

    @cached_property
    def _readings(self) -> "NearReadings | None":
        """What probes read; None without any."""
        if self.base.case.outputs.probes is None:
            return None
        from flexbearing.derivatives.near_grooves import NearReadings

        return NearReadings(self.base.case, self.base.solution(self.places).state)

    def variant(self, key: Key, change: float) -> _Variant:
        """The case with a key changed by so many steps, held to first order where it is at rest."""
        if change == 0.0:
            return self.base
        case = with_value(self.base.case, key.path, key.value + change * key.step)
        variant = _Variant.of(case, self.near.of(case) if self.near else RIGID)
        if self.rest is None or variant.at_rest is None:
            return variant
        step = newton_step(variant.at_rest.equations, self.rest.places)
        return variant.held_where(self.rest.places.further(1.0, step))


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
        equations = [variant.equations for variant in variants]
        by_step = moved_places(state.places, equations, stencil.weights)
        blocks = [
            state.block_of(variant, state.places.further(change, by_step).held(variant.equations[0]))
            for variant, change in zip(variants, stencil.places, strict=True)
        ]
        return Differences(
            stencil,
            self.values,
            np.array([self._numbers(block) for block in blocks]),
            self._steps_to_lift(stencil, blocks),
            lambda change: _Differentiated(
                _State.solved(state.variant(key, change), state.near), self.outputs
            ),
        )

    def _numbers(self, block: dict[str, NDArray]) -> NDArray:
        name = "rigid" if self.state.base.case.rigid else "flexible"
        return np.array([output.number({name: block}) for output in self.outputs])

    def _steps_to_lift(self, stencil: Stencil, blocks: Sequence[dict[str, NDArray]]) -> float:
        """Steps after which a ball lifts off the inner race, linearly: loads go with the 3/2 power."""
        loads = np.array([block["contact_load"][0] for block in blocks])
        change = np.abs(np.tensordot(stencil.weights, loads, 1))
        load = self.state.block["contact_load"][0]
        pressed = (load > 0) & (change > 0)
        return float((1.5 * load[pressed] / change[pressed]).min(initial=np.inf))
