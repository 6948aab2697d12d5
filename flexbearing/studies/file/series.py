"""Many rows of loads and speeds as a duty cycle: a time series or rows with shares, each bin a row."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing import inputs
from flexbearing.case.declarations import Declaration
from flexbearing.case.quantity import Kind
from flexbearing.studies.file.rows import rows
from flexbearing.studies.file.values import BadValues, in_si_units
from flexbearing.units import BadUnit, UnknownUnit, unit

TIME = "time"
SPEED = "operation.inner_speed"
Weighing = Mapping[str, Callable[[Sequence[Any]], NDArray]]  # columns of weights, and how these are read
EXPONENTS = {"operation.radial_load": 10 / 3, "operation.load.": 3.0}  # of loads in the life, ISO 281


@dataclass(frozen=True)
class Binned:
    """Rows of a table in bins; those of other signs are never in one bin, zero has its own."""

    columns: Mapping[str, Sequence[str]]  # by key what stands for each bin, in the words of a case file
    measure: str  # what the weights are of
    weights: NDArray  # (B) time or revolutions in each bin, or any measure of them
    errors: NDArray  # (B) of the damage of each bin over it, for lives that go with any power up to P^(-2 p)
    rows: int  # of the table


def series(file: Path, bins: int, find: Callable[[str], Declaration]) -> Binned:
    """Read a time series (CSV), whose column `time` says when a row begins, and sort it, see `binned`."""
    return binned(file, bins, find, {TIME: _seconds}, alike=True)


def binned(
    file: Path, bins: int, find: Callable[[str], Declaration], weighing: Weighing, *, alike: bool = False
) -> Binned:
    """Read a table (CSV) and sort its rows into bins of equal width, a third as many where keys are no loads.

    With the loads of the bins they have the damage of their rows where the life goes with P^-p; other keys
    have their mean over the weights. `alike`: rows may lack weights, and then are equal times.

    Raises `BadValues` naming file, row or key.
    """
    measure, weights, values, units = _read(file, find, weighing)
    if measure is None and not alike:
        raise BadValues(f"{file.name} needs the shares of its rows, {' or '.join(weighing)}")
    measure = measure or TIME
    rows_read, counted = len(weights), weights > 0
    weights, values = weights[counted], {key: numbers[counted] for key, numbers in values.items()}
    each = [_places(of, bins if _exponent(key) else max(1, bins // 3)) for key, of in values.items()]
    _, bin_of = np.unique(np.array(each), axis=1, return_inverse=True)
    weighed = _Sums(bin_of.ravel(), weights)
    turned = weighed.weighted(values[SPEED]) if measure == TIME and SPEED in values else weighed
    columns, errors = dict[str, Sequence[str]](), np.zeros(len(weighed.total))
    for key, numbers in values.items():
        exponent = _exponent(key)
        mean = weighed.mean(numbers) if exponent is None else turned.mean(numbers, exponent)
        columns[key] = [f"{number!r} {units[key]}" for number in mean.tolist()]
        errors += 0.0 if exponent is None else turned.error(numbers, mean, exponent)
    return Binned(columns, measure, weighed.total, errors, rows_read)


def _read(
    file: Path, find: Callable[[str], Declaration], weighing: Weighing
) -> tuple[str | None, NDArray, dict[str, NDArray], dict[str, str]]:
    """Measure, None without one, and weights of the rows (N), their numbers by key, and their SI units."""
    keys, table = rows(file, lambda key: key in weighing or find(key).kind is not None)
    texts = dict(zip(keys, zip(*table, strict=True), strict=True))
    found = {name: weigh(texts.pop(name)) for name, weigh in weighing.items() if name in texts}
    if len(found) > 1:
        raise BadValues(f"{file.name} has {' and '.join(found)}; the shares of rows are of one of them")
    measure, weights = next(iter(found.items()), (None, np.ones(len(table))))
    if not texts:
        raise BadValues(f"{file.name} has no key of the case, such as operation.radial_load [N]")
    kinds = {key: _kind(key, find(key)) for key in texts}
    values = {key: _numbers(key, column, kinds[key]) for key, column in texts.items()}
    return measure, weights, values, {key: kind.unit for key, kind in kinds.items()}


def _exponent(key: str) -> float | None:
    """Of a load in the life; None of other keys."""
    return next((p for name, p in EXPONENTS.items() if key.startswith(name)), None)


@dataclass(frozen=True)
class _Sums:
    """Weighted sums over the rows (N) of each bin (B)."""

    bin_of: NDArray  # (N)
    weights: NDArray  # (N)

    @property
    def total(self) -> NDArray:
        """Weights of the bins (B)."""
        return np.bincount(self.bin_of, self.weights)

    def weighted(self, by: NDArray) -> "_Sums":
        """With other weights; those of a bin that would have none stay."""
        weights = self.weights * np.abs(by)
        none = np.bincount(self.bin_of, weights) == 0
        return _Sums(self.bin_of, np.where(none[self.bin_of], self.weights, weights))

    def mean(self, values: NDArray, exponent: float = 1.0) -> NDArray:
        """Mean (B) of values of one sign in each bin, by a power of them."""
        powers = np.bincount(self.bin_of, self.weights * np.abs(values) ** exponent) / self.total
        sign = np.zeros(len(powers))
        sign[self.bin_of] = np.sign(values)
        return sign * powers ** (1 / exponent)

    def error(self, values: NDArray, mean: NDArray, exponent: float) -> NDArray:
        """By how much the damage (B) differs where it goes with twice the exponent, over that at the mean."""
        relative = np.abs(values) / np.where(mean == 0, 1.0, np.abs(mean))[self.bin_of]
        powers = np.bincount(self.bin_of, self.weights * relative ** (2 * exponent)) / self.total
        return np.where(mean == 0, 0.0, powers - 1)


def _places(values: NDArray, bins: int) -> NDArray:
    """Numbers of the bins of values: 0 of zero, positive and negative ones counted from 1 and -1."""
    found = np.zeros(len(values), dtype=int)
    for sign in (1, -1):
        some = np.sign(values) == sign
        if some.any():
            sizes = np.abs(values[some])
            width = np.ptp(sizes) or 1.0
            found[some] = sign * (1 + np.minimum((sizes - sizes.min()) / width * bins, bins - 1).astype(int))
    return found


def _seconds(begins: Sequence[Any]) -> NDArray:
    """How long each row lasts; the last one as long as the one before."""
    times = np.array([_time(text, row) for row, text in enumerate(begins, 1)])
    lasting = np.diff(times)
    if len(times) == 1:
        raise BadValues("a time series with a column time has two rows or more; time is when a row begins")
    if not np.all(lasting > 0):
        row = int(np.argmin(lasting > 0)) + 2
        raise BadValues(f"time of row {row} is not above that of the row before; it is when a row begins")
    return np.append(lasting, lasting[-1])


def _time(text: Any, row: int) -> float:
    number, _, name = str(text).partition(" ")
    try:
        of = unit(name or "1")
        if of.powers in (unit("s").powers, unit("1").powers):
            return of.to_si(inputs.number(number))
    except (BadUnit, UnknownUnit, inputs.BadNumber):
        pass
    raise BadValues(f"row {row}, time: {text!r:.40} is no time; it is when a row begins, such as 12.5 s")


def _kind(key: str, declaration: Declaration) -> Kind:
    if declaration.kind is None or declaration.listed:
        raise BadValues(f"{key} is no quantity with a unit; only such ones are sorted into bins")
    return declaration.kind


def _numbers(key: str, column: Sequence[Any], kind: Kind) -> NDArray:
    """Numbers of a key in SI units."""
    found = np.empty(len(column))
    for row, text in enumerate(column):
        if not isinstance(text, str):
            what = "is empty" if text is None else f"is {text}, without a unit, which the header may have"
            raise BadValues(f"row {row + 1}, {key} {what}")
        try:
            found[row] = in_si_units(text, kind)
        except BadValues as problem:
            raise BadValues(f"row {row + 1}, {key} {problem}") from None
    return found
