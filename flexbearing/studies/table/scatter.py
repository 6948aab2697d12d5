"""What the rows of a sampled study tell of its outputs: how they scatter, and which keys make them."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.sampling.distribution import quantile, weighted_quantile
from flexbearing.sampling.indices import Indices, sobol_indices
from flexbearing.sampling.linear import Linear, explained, is_skewed
from flexbearing.studies.file import Axis
from flexbearing.studies.file.sampled import Drawn
from flexbearing.studies.table.files import SCATTER
from flexbearing.studies.table.table import Column, Table

PERCENTILES_TABLE, SHARES, HISTOGRAM = SCATTER
PERCENTILES = 10, 50, 90
FEWEST = 100  # rows, by their weights, from which a narrower input is estimated
MOST_BINS = 60
SAME = 1e-9  # relative difference of one number in two ways of solving a variant
QUARTER = 0.25  # of the variance is left of an input whose spread is halved


@dataclass(frozen=True, eq=False)
class Scatter:
    """Outputs of drawn rows."""

    name: str  # of the study
    drawn: Drawn
    numbers: NDArray  # (rows, D) drawn values of all keys in SI units, those of a list side by side
    outputs: Sequence[Column]
    linear: Mapping[str, Linear] = field(default_factory=dict)  # by names of outputs, of D numbers

    def tables(self) -> tuple[Table, ...]:
        """How outputs scatter, the share of every key in it, and histograms."""
        outputs, keys = self._axis("output", self._names), self._axis("key", self._keys)
        bins = self._axis("bin", [str(number + 1) for number in range(self._bins)])
        return (
            Table(f"{self.name}{PERCENTILES_TABLE}", _columns(self._of_outputs()), (outputs,)),
            Table(f"{self.name}{SHARES}", _columns(self._of_keys()), (outputs, keys)),
            Table(f"{self.name}{HISTOGRAM}", _columns(self._of_bins()), (outputs, bins)),
        )

    @property
    def _names(self) -> list[str]:
        return [output.name for output in self._scattering]

    @property
    def _keys(self) -> list[str]:
        return [factor.key for factor in self.drawn.factors]

    @staticmethod
    def _axis(name: str, values: Sequence[str]) -> Axis:
        return Axis(name, (name,), tuple((value,) for value in values))

    @cached_property
    def _scattering(self) -> list["_Output"]:
        """Outputs that vary beyond rounding."""
        rows = self.drawn.design.independent(len(self.numbers))
        found = [
            _Output(
                output.name, output.unit, np.array(output.values, float), rows, self.linear.get(output.name)
            )
            for output in self.outputs
        ]
        return [each.with_scale() for each in found if each.varies]

    @cached_property
    def _bins(self) -> int:
        """Bins of a histogram, by the rule of Rice."""
        rows = len(self.drawn.design.independent(len(self.numbers)))
        return min(MOST_BINS, int(np.ceil(2 * rows ** (1 / 3))))

    @cached_property
    def _halving(self) -> dict[str, NDArray]:
        """Weights of the rows with which one key scatters half as much; a list of numbers has none."""
        return {
            factor.key: factor.distribution.halving_weights(self.numbers[:, place.start])
            for factor, place in zip(self.drawn.factors, self._places, strict=True)
            if factor.width == 1
        }

    @cached_property
    def _places(self) -> list[slice]:
        """Where the numbers of each key stand."""
        ends = np.cumsum([factor.width for factor in self.drawn.factors])
        return [
            slice(int(end) - each.width, int(end)) for each, end in zip(self.drawn.factors, ends, strict=True)
        ]

    def _of_outputs(self) -> Iterator[dict[str, Any]]:
        for output in self._scattering:
            yield output.scatter(self.numbers)

    def _of_keys(self) -> Iterator[dict[str, Any]]:
        for output in self._scattering:
            indices = self._indices(output)
            for number, (key, place) in enumerate(zip(self._keys, self._places, strict=True)):
                share = output.linear_share(place)
                yield {
                    "output": output.name,
                    "key": key,
                    **_told(indices, number),
                    "linear_share": share,
                    **output.narrowed(self._halving.get(key), share),
                }

    def _indices(self, output: "_Output") -> Indices | None:
        if self.drawn.design.method != "sobol_indices":
            return None
        values = output.values.reshape(-1, len(self.drawn.factors) + 2)
        return sobol_indices(values, self.drawn.design.seed)

    def _of_bins(self) -> Iterator[dict[str, Any]]:
        for output in self._scattering:
            counts, edges = np.histogram(output.known, self._bins)
            linear = np.histogram(output.predicted(self.numbers), edges)[0] if output.linear else None
            for number, count in enumerate(counts.tolist()):
                yield {
                    "output": output.name,
                    "bin": str(number + 1),
                    "unit": output.unit,
                    "from": float(edges[number]),
                    "to": float(edges[number + 1]),
                    "rows": count,
                    "linear_rows": np.nan if linear is None else float(linear[number]),
                }


@dataclass(frozen=True, eq=False)
class _Output:
    """One output of all rows."""

    name: str
    unit: str
    values: NDArray  # (rows) NaN where there is none
    independent: NDArray  # rows that are drawn independently
    linear: Linear | None

    @cached_property
    def places(self) -> NDArray:
        """Independent rows with a finite number."""
        return self.independent[np.isfinite(self.values[self.independent])]

    @cached_property
    def known(self) -> NDArray:
        """Their numbers."""
        return self.values[self.places]

    @property
    def varies(self) -> bool:
        """Whether its numbers differ by more than rounding."""
        return len(self.known) > 0 and np.ptp(self.known) > SAME * np.abs(self.known).max()

    def with_scale(self) -> "_Output":
        """The same, predicted by its logarithm where its numbers are above zero and skewed."""
        if self.linear is None or self.linear.value <= 0 or not is_skewed(self.known):
            return self
        return replace(self, linear=replace(self.linear, logarithmic=True))

    def explained(self, predicted: NDArray) -> float:
        """Share of the variance that a prediction explains, of logarithms where it is made for them [%]."""
        if self.linear and self.linear.logarithmic:
            return 100 * explained(np.log(self.known), np.log(predicted))
        return 100 * explained(self.known, predicted)

    def predicted(self, numbers: NDArray) -> NDArray:
        """The same to first order; of all of them."""
        return self.linear.at(numbers[self.places]) if self.linear else np.full(len(self.places), np.nan)

    def scatter(self, numbers: NDArray) -> dict[str, Any]:
        """Mean, standard deviation and percentiles, sampled and to first order."""
        unsolved = len(self.independent) - len(self.places)
        row: dict[str, Any] = {"output": self.name, "unit": self.unit}
        row |= {"mean": float(self.known.mean()), "deviation": float(self.known.std(ddof=1))}
        for percent in PERCENTILES:
            found = quantile(self.known, unsolved, percent / 100)
            low, high = (side if np.isfinite(side) else np.nan for side in (found.low, found.high))
            row |= {f"P{percent}": found.value, f"P{percent}_low": low, f"P{percent}_high": high}
        predicted = self.predicted(numbers)
        linear = self.linear
        first_order = self._first_order(predicted)
        beyond = linear is not None and np.isnan([*first_order.values()]).any()
        row |= first_order
        scale = "" if linear is None else "logarithm" if linear.logarithmic else "output"
        return row | {
            "linear_explains": np.nan if beyond else self.explained(predicted),
            "linear_of": f"{scale}: beyond the range of numbers" if beyond else scale,
            "rows": len(self.places),
            "unsolved": unsolved,
        }

    def _first_order(self, predicted: NDArray) -> dict[str, float]:
        """Mean, deviation and percentiles to first order; no numbers where no float holds them."""
        names = ["mean", "deviation", *(f"P{percent}" for percent in PERCENTILES)]
        numbers = [np.nan] * len(names)
        if self.linear and np.isfinite([self.linear.mean, self.linear.deviation, *predicted]).all():
            percentiles = np.quantile(predicted, np.array(PERCENTILES) / 100).tolist()
            numbers = [self.linear.mean, self.linear.deviation, *percentiles]
        return {f"linear_{name}": float(number) for name, number in zip(names, numbers, strict=True)}

    def linear_share(self, place: slice) -> float:
        """Share of some numbers in the variance to first order."""
        if self.linear is None or not self.linear.deviation:
            return np.nan
        return float(self.linear.variances[place].sum() / self.linear.variances.sum())

    def narrowed(self, weights: NDArray | None, linear_share: float) -> dict[str, Any]:
        """Percentiles with a key that scatters half as much, and by how much closer they come."""
        low, high = (self._percentile(np.ones(len(self.places)), percent) for percent in (10, 90))
        if weights is None or _effective(weights[self.places]) < FEWEST:
            narrower = 1 - np.sqrt(1 - (1 - QUARTER) * linear_share)
            return {"halved_P10": np.nan, "halved_P90": np.nan, "narrower": 100 * narrower, "by": "linear"}
        ends = [self._percentile(weights[self.places], percent) for percent in (10, 90)]
        narrower = 1 - (ends[1] - ends[0]) / (high - low) if high > low else np.nan
        return {"halved_P10": ends[0], "halved_P90": ends[1], "narrower": 100 * narrower, "by": "rows"}

    def _percentile(self, weights: NDArray, percent: float) -> float:
        return weighted_quantile(self.known, weights, percent / 100)


def _effective(weights: NDArray) -> float:
    """Number of rows of one weight that tell as much (Kish)."""
    return float(weights.sum() ** 2 / (weights**2).sum()) if weights.any() else 0.0


def _told(indices: Indices | None, number: int) -> dict[str, Any]:
    """Indices of one key; NaN in a study whose rows do not tell them."""
    found = {}
    for name in ("first", "total"):
        share = np.nan if indices is None else getattr(indices, name)[number]
        low, high = (np.nan, np.nan) if indices is None else getattr(indices, f"{name}_interval")[:, number]
        found |= {name: float(share), f"{name}_low": float(low), f"{name}_high": float(high)}
    return found | {"points": 0 if indices is None else indices.points}


UNITS = {"linear_explains": "%", "narrower": "%"}
AXES = ("output", "key", "bin")


def _columns(rows: Iterator[dict[str, Any]]) -> tuple[Column, ...]:
    """Columns of rows with the same names."""
    found = list(rows)
    names = list(found[0]) if found else ["output"]
    return tuple(
        Column(name, UNITS.get(name, ""), tuple(row[name] for row in found), varied=name in AXES)
        for name in names
    )
