"""Sensitivities of a tapered roller bearing."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.tapered import TaperedCase
from flexbearing.derivatives.by_keys import Differences, columns
from flexbearing.derivatives.keys import Key, announced, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import Differentiable, Stencil, tabled
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput
from flexbearing.progress import Logged, Report
from flexbearing.runs import tapered


def sensitivities(
    case: TaperedCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Raises `BadCase` for keys that are none, outputs of rigid rings where rings are elastic; `UnknownOutput`,
    `WrongUnit` for texts that name no output; `NotSolved` where there is no equilibrium.
    """
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    thrust = case.kind == "thrust_roller"
    ribs, along = ("max_rib_load",) * bool(case.bearing.rib), "stiffness_xx" if thrust else "stiffness_zz"
    main = "life_L10", "peak_pressure.inner", *ribs, along
    known = Differentiable(tapered.LAYOUTS[case.kind], main, ("imbalance",), "outer.kind and inner.kind")
    asked = known.requested(of, basic=case.life.is_basic, elastic=not case.rigid)
    report = report or Logged()
    state = _State(case, tapered.raceways(case, report), asked)
    found, left_out = columns(state, announced(keys, report))
    raceways = "rigid raceways" if case.rigid else "flexible rings"
    return tabled((case.title, raceways), asked, state.values, found, left_out)


@dataclass(frozen=True)
class _State:
    """A case in equilibrium, with the outputs that are differentiated there."""

    case: TaperedCase
    raceways: Any  # which no variant changes
    outputs: Sequence[RequestedOutput]

    @cached_property
    def values(self) -> NDArray:
        """Of the outputs (O)."""
        name = "rigid" if self.case.rigid else "flexible"
        block = {name: tapered.block(tapered.solved(self.case, self.raceways))}
        return np.array([output.number(block) for output in self.outputs])

    def differences(self, key: Key, stencil: Stencil) -> Differences:
        """Outputs of variants, each solved to rounding: slices that open change no slope at once."""
        ends = [self._moved(key, change).values for change in stencil.places]
        return Differences(
            stencil, self.values, np.array(ends), np.inf, lambda change: self._moved(key, change)
        )

    def _moved(self, key: Key, change: float) -> "_State":
        """The state with a key changed by so many steps; raises `BadCase` where that changes a ring."""
        variant = with_value(self.case, key.path, key.value + change * key.step)
        if variant.bearing.on_circle != self.case.bearing.on_circle:
            raise BadCase("rollers that part are crossed no more")
        if not self.case.rigid and _rings(variant) != _rings(self.case):
            raise BadCase("it changes an elastic ring, which is meshed anew; vary it in a study")
        return _State(variant, self.raceways, self.outputs)


def _rings(case: TaperedCase) -> tuple[Any, ...]:
    """What decides the compliance of the raceways under the rollers of a case."""
    from flexbearing.rings.cones import parts  # with what describes finite elements

    return parts(case), case.bearing.first_roller_azimuth
