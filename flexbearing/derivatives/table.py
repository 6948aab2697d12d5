"""Derivatives of outputs by keys as one frozen table, and what can be reported of it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.derivatives.keys import Key

# Elasticity, or share per step over the relative size of a step, below which a key does not reach an output:
# outputs are rounded to some 1e-12, and steps are 1e-6 of a value.
NEGLIGIBLE = 1e-5

COLUMNS: tuple[str, ...] = (
    "output", "output_unit", "key", "key_unit", "value", "key_value", "step", "percent_by_step", "derivative",
    "elasticity", "percent_per_unit", "derivative_below", "derivative_above", "one_sided",
)  # fmt: skip


@dataclass(frozen=True)
class OutputValue:
    """An output in the state where it is differentiated."""

    name: str
    unit: str
    value: float


@dataclass(frozen=True)
class Slope:
    """The derivative of one output by one key; sides are NaN where both sides have it alike."""

    output: OutputValue
    key: Key
    slope: float  # of the output in its unit, by the key in its unit
    below: float  # the same where the key is smaller
    above: float  # the same where it is larger

    @property
    def one_sided(self) -> bool:
        """Whether the derivative differs from one side to the other."""
        return not (np.isnan(self.below) and np.isnan(self.above))

    @property
    def jumps(self) -> bool:
        """Whether the output jumps at this value of the key, so that it has no derivative."""
        return bool(np.isnan(self.slope))

    @property
    def share(self) -> float:
        """Change of the output in percent of it, by one unit of the key."""
        return 100.0 * self.slope / self.output.value if self.output.value else nan

    @property
    def effect(self) -> float:
        """Change of the output in percent of it by one realistic step of the key, by the derivative."""
        return self.by_step(self.slope)

    def by_step(self, slope: float) -> float:
        """The same of another slope, such as that on one side."""
        return 100.0 * slope * self.key.realistic_step / self.output.value if self.output.value else nan

    @property
    def elasticity(self) -> float:
        """Percent of the output by a percent of the key; NaN where either means nothing."""
        if not (self.key.is_ratio and self.output.value):
            return nan
        return self.slope * self.key.value / self.key.size / self.output.value

    @property
    def reaches(self) -> bool:
        """Whether the key changes the output beyond rounding."""
        sides = [abs(each) for each in (self.slope, self.below, self.above) if not np.isnan(each)]
        size = max(abs(self.key.value), self.key.step / self.key.relative_step) / self.key.size
        return max(sides, default=0.0) * size > NEGLIGIBLE * abs(self.output.value)


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """Derivatives of O outputs by K keys, in the units of both."""

    title: str
    raceways: str  # "rigid raceways" or "flexible rings"
    outputs: tuple[OutputValue, ...]
    keys: tuple[Key, ...]
    slopes: NDArray  # (O, K)
    below: NDArray  # (O, K) on the side of smaller keys; NaN where both sides have the same
    above: NDArray  # (O, K)
    left_out: tuple[tuple[str, str], ...] = ()  # keys without derivatives, and why

    def __getitem__(self, place: tuple[str, str]) -> Slope:
        """The derivative of an output by a key, by their names."""
        output, key = place
        names = [each.name for each in self.outputs], [each.path for each in self.keys]
        if output not in names[0] or key not in names[1]:
            raise KeyError(f"{output}, {key}: outputs are {', '.join(names[0])}; keys {', '.join(names[1])}")
        return self._slope(names[0].index(output), names[1].index(key))

    @cached_property
    def by_output(self) -> dict[str, tuple[Slope, ...]]:
        """Derivatives by the keys that reach an output, by the change that a realistic step of each makes."""
        return {
            output.name: tuple(sorted(self._reaching(number), key=_strength))
            for number, output in enumerate(self.outputs)
        }

    def records(self) -> list[dict[str, Any]]:
        """Every derivative as plain values; what means nothing is None."""
        return [_record(slope) for slopes in self.by_output.values() for slope in slopes]

    def _reaching(self, output: int) -> Iterator[Slope]:
        for key in range(len(self.keys)):
            slope = self._slope(output, key)
            if slope.reaches:
                yield slope

    def _slope(self, output: int, key: int) -> Slope:
        numbers = (float(each[output, key]) for each in (self.slopes, self.below, self.above))
        return Slope(self.outputs[output], self.keys[key], *numbers)


def _strength(slope: Slope) -> tuple[bool, float]:
    without = bool(np.isnan(slope.effect))  # of an output that is zero, or jumps
    return without, -abs(slope.slope * slope.key.realistic_step if without else slope.effect)


def _record(slope: Slope) -> dict[str, Any]:
    output, key = slope.output, slope.key
    numbers = (
        output.value,
        key.stated,
        key.realistic_step,
        slope.effect,
        slope.slope,
        slope.elasticity,
        slope.share,
        slope.below,
        slope.above,
    )
    finite = [float(number) if np.isfinite(number) else None for number in numbers]
    values = output.name, output.unit, key.path, key.unit or "1", *finite, slope.one_sided
    return dict(zip(COLUMNS, values, strict=True))
