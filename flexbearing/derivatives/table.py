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
    "output", "output_unit", "key", "key_unit", "value", "key_value", "step", "choice", "change_by_step",
    "percent_by_step", "derivative",
    "elasticity", "percent_per_unit", "derivative_below", "derivative_above", "one_sided",
)  # fmt: skip


@dataclass(frozen=True)
class OutputValue:
    """An output in the state where it is differentiated."""

    name: str
    unit: str
    value: float
    ratio: bool = (
        True  # whether a share of it says something: not of a percentage, nor of what rounds to zero
    )

    def percent(self, change: float) -> float:
        """A change in its unit as percent of it; NaN where that says nothing."""
        return 100.0 * change / self.value if self.ratio and self.value else nan


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
    def change(self) -> float:
        """Of the output in its unit by one realistic step of the key, by the derivative."""
        return self.by_step(self.slope)

    def by_step(self, slope: float) -> float:
        """The same of another slope, such as that on one side."""
        return slope * self.key.realistic_step

    @property
    def percent(self) -> float:
        """The same change in percent of the output."""
        return self.output.percent(self.change)

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


@dataclass(frozen=True)
class Chosen:
    """An output with another choice of a key, solved."""

    output: OutputValue
    key: str
    words: str  # of the choice
    value: float  # of the output

    @property
    def change(self) -> float:
        """Of the output in its unit."""
        return self.value - self.output.value

    @property
    def percent(self) -> float:
        """The same in percent of the output."""
        return self.output.percent(self.change)


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
    chosen: tuple[Chosen, ...] = ()  # outputs with other choices of graded keys

    def __getitem__(self, place: tuple[str, str]) -> Slope:
        """The derivative of an output by a key, by their names."""
        output, key = place
        names = [each.name for each in self.outputs], [each.path for each in self.keys]
        if output not in names[0] or key not in names[1]:
            raise KeyError(f"{output}, {key}: outputs are {', '.join(names[0])}; keys {', '.join(names[1])}")
        return self._slope(names[0].index(output), names[1].index(key))

    @cached_property
    def by_output(self) -> dict[str, tuple[Slope | Chosen, ...]]:
        """What changes an output, the key whose realistic step changes it most first."""
        return {
            output.name: tuple(
                sorted([*self._reaching(number), *self._chosen(output)], key=lambda each: -abs(each.change))
            )
            for number, output in enumerate(self.outputs)
        }

    def records(self) -> list[dict[str, Any]]:
        """Every derivative as plain values; what means nothing is None."""
        return [
            _record(each) if isinstance(each, Slope) else _record_of_choice(each)
            for changes in self.by_output.values()
            for each in changes
        ]

    def _reaching(self, output: int) -> Iterator[Slope]:
        without = {key for key, _ in self.left_out}  # among them keys at which some outputs jump
        for key in range(len(self.keys)):
            slope = self._slope(output, key)
            if slope.reaches and slope.key.path not in without:
                yield slope

    def _chosen(self, output: OutputValue) -> Iterator[Chosen]:
        for each in self.chosen:
            if each.output is output and abs(each.value - output.value) > NEGLIGIBLE * abs(output.value):
                yield each

    def _slope(self, output: int, key: int) -> Slope:
        numbers = (float(each[output, key]) for each in (self.slopes, self.below, self.above))
        return Slope(self.outputs[output], self.keys[key], *numbers)


def _record_of_choice(chosen: Chosen) -> dict[str, Any]:
    output, percent = chosen.output, chosen.percent
    known = {
        "output": output.name,
        "output_unit": output.unit,
        "key": chosen.key,
        "value": output.value,
        "choice": chosen.words,
        "change_by_step": chosen.change,
        "percent_by_step": percent if np.isfinite(percent) else None,
    }
    return dict.fromkeys(COLUMNS) | known


def _record(slope: Slope) -> dict[str, Any]:
    output, key = slope.output, slope.key
    numbers = (
        output.value,
        key.stated,
        key.realistic_step,
        slope.change,
        slope.percent,
        slope.slope,
        slope.elasticity,
        slope.share,
        slope.below,
        slope.above,
    )
    finite = [float(number) if np.isfinite(number) else None for number in numbers]
    values = output.name, output.unit, key.path, key.unit or "1", *finite, slope.one_sided
    return dict.fromkeys(COLUMNS) | dict(
        zip((each for each in COLUMNS if each != "choice"), values, strict=True)
    )
