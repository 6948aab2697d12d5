"""Sensitivities of a tapered roller bearing."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.tapered import TaperedCase
from flexbearing.derivatives.by_keys import Differences, columns
from flexbearing.derivatives.keys import Key, announced, given_keys, keys_of, with_value
from flexbearing.derivatives.sides import LIFE, Differentiable, Stencil, tabled
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import RequestedOutput
from flexbearing.progress import Logged, Report
from flexbearing.quantities.tapered import LAYOUT
from flexbearing.runs import tapered

OUTPUTS = Differentiable(
    LAYOUT, ("life_L10", "peak_pressure.inner", "max_rib_load", "stiffness_zz"), ("imbalance",), ""
)


def sensitivities(
    case: TaperedCase, of: Sequence[str] = (), by: Sequence[str] = (), report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs by continuous keys at the equilibrium of a case.

    Raises `BadCase` for keys that are none; `UnknownOutput`, `WrongUnit` for texts that name no output;
    `NotSolved` where there is no equilibrium.
    """
    keys = [key for path in by for key in keys_of(case, path)] or given_keys(case)
    asked = OUTPUTS.requested(of, LIFE, elastic=False)
    state = _State(case, asked)
    found, left_out = columns(state, announced(keys, report or Logged()))
    return tabled((case.title, "rigid raceways"), asked, state.values, found, left_out)


@dataclass(frozen=True)
class _State:
    """A case in equilibrium, with the outputs that are differentiated there."""

    case: TaperedCase
    outputs: Sequence[RequestedOutput]

    @cached_property
    def values(self) -> NDArray:
        """Of the outputs (O)."""
        block = {"rigid": tapered.block(tapered.solved(self.case))}
        return np.array([output.number(block) for output in self.outputs])

    def differences(self, key: Key, stencil: Stencil) -> Differences:
        """Outputs of variants, each solved to rounding: slices that open change no slope at once."""
        ends = [self._moved(key, change).values for change in stencil.places]
        return Differences(
            stencil, self.values, np.array(ends), np.inf, lambda change: self._moved(key, change)
        )

    def _moved(self, key: Key, change: float) -> "_State":
        """The state with a key changed by so many steps."""
        return _State(with_value(self.case, key.path, key.value + change * key.step), self.outputs)
