"""Sensitivities of a bearing with slow balls of two or four contact points."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.derivatives.by_keys import Differences, columns
from flexbearing.derivatives.keys import Key, announced, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import Differentiable, Stencil, tabled
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput
from flexbearing.progress import Logged, Report
from flexbearing.quantities.four_point import LAYOUT
from flexbearing.rings import grooves
from flexbearing.runs import four_point
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves

OUTPUTS = Differentiable(
    LAYOUT,
    ("torque.inner", "max_contact_load", "peak_pressure.inner", "stiffness_zz"),
    ("torque_grid_error", "max_ball_imbalance"),
    "rings.inner.kind and rings.outer.kind",
)


def sensitivities(
    case: FourPointCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Raises `BadCase` for keys that are none, outputs of rigid rings where rings are elastic, contacts that
    stick and slip; `UnknownOutput`, `WrongUnit` for texts that name no output; `NotSolved` where there is no
    equilibrium.
    """
    if case.friction.model != "full_sliding":
        raise BadCase(
            f"{case.source.path}: friction.model is found by separate iterations without known derivatives; "
            'derivatives need "full_sliding"'
        )
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked = OUTPUTS.requested(of, basic=case.life.is_basic, elastic=not case.rigid)
    report = report or Logged()
    state = _State(case, four_point.elastic_rings(case, report), asked)
    found, left_out = columns(state, announced(keys, report))
    raceways = "rigid raceways" if case.rigid else "flexible rings"
    return tabled((case.title, raceways), asked, state.values, found, left_out)


@dataclass(frozen=True)
class _State:
    """A case in equilibrium, with the outputs that are differentiated there."""

    case: FourPointCase
    rings: ElasticGrooves | None  # which no variant changes
    outputs: Sequence[RequestedOutput]

    @cached_property
    def solution(self) -> four_point.Solution:
        """Loads and motion of the balls, to rounding."""
        found = four_point.solved(self.case, self.rings)
        return four_point.solved(self.case, self.rings, near=found)

    @cached_property
    def values(self) -> NDArray:
        """Of the outputs (O)."""
        return self._numbers(self.solution)

    def differences(self, key: Key, stencil: Stencil) -> Differences:
        """Outputs of variants, each one step of Newton's method from this state: to first order."""
        ends = [
            four_point.solved(self._variant(key, change), self.rings, near=self.solution)
            for change in stencil.places
        ]
        return Differences(
            stencil,
            self.values,
            np.array([self._numbers(end) for end in ends]),
            self._steps_to_switch(stencil, ends),
            lambda change: _State(self._variant(key, change), self.rings, self.outputs),
        )

    def _variant(self, key: Key, change: float) -> FourPointCase:
        """The case with a key changed by so many steps; raises `BadCase` where it changes an elastic ring."""
        variant = with_value(self.case, key.path, key.value + change * key.step)
        if grooves.parts(variant) != grooves.parts(self.case):
            raise BadCase("it changes an elastic ring, which is meshed anew; vary it in a study")
        return variant

    def _numbers(self, solution: four_point.Solution) -> NDArray:
        block = {"rigid" if self.case.rigid else "flexible": four_point.block(solution)}
        return np.array([output.number(block) for output in self.outputs])

    def _steps_to_switch(self, stencil: Stencil, ends: Sequence[four_point.Solution]) -> float:
        """Steps after which a diagonal opens or closes, linearly."""
        if self.solution.distribution is None:
            return np.inf  # contact loads are given
        approaches = [end.distribution.approach for end in ends if end.distribution]
        change = np.abs(np.tensordot(stencil.weights, np.array(approaches), 1))
        approach = np.abs(self.solution.distribution.approach)
        return float((approach[change > 0] / change[change > 0]).min(initial=np.inf))
