"""The rows of a duty cycle with their shares of time or of revolutions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import fsum
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing import inputs
from flexbearing.case.declarations import Declaration, toml
from flexbearing.printable import excerpt
from flexbearing.studies.file.axes import Axis, columns_of, together
from flexbearing.studies.file.rows import rows
from flexbearing.studies.file.schema import Duty
from flexbearing.studies.file.series import Binned, binned, series
from flexbearing.studies.file.values import BadValues
from flexbearing.units import BadUnit, UnknownUnit, unit

AXIS = "duty"
MEASURES = {"time": "s", "revolutions": "rev"}  # with the units that shares may have
BINS = 30  # of a time series
COMPLETE = 0.005  # by how much percentages may miss 100 %, as rounded ones do


@dataclass(frozen=True)
class Spectrum:
    """The weights of a duty cycle."""

    measure: str  # what the shares are of, "time" or "revolutions"
    shares: tuple[float, ...]  # row by row; the sum is 1
    life: str  # output that is cumulated
    required: float | None = None  # life [s]
    application_factor: float = 1.0
    bin_errors: tuple[float, ...] = ()  # of the damage of each row, over it, where rows are bins of a series
    measured: int = 0  # rows of the series


def spectrum(duty: Duty, folder: Path, find: Callable[[str], Declaration]) -> tuple[Axis, Spectrum]:
    """The axis of the table [duty], and its weights.

    Raises `BadValues` naming key or row.
    """
    columns, bins = _columns(duty, folder, find)
    measures = [name for name in MEASURES if name in columns]
    if len(measures) != 1 or len(columns) < 2:
        raise BadValues(
            "needs the shares of its rows, either time or revolutions, and keys such as operation.radial_load"
        )
    joined = together({measures[0]: columns.pop(measures[0]), **columns}, AXIS)
    axis = Axis(AXIS, joined.keys[1:], tuple(row[1:] for row in joined.rows))  # a few rows
    shares = _shares(measures[0], [row[0] for row in joined.rows])
    found = Spectrum(measures[0], shares, duty.life, _required(duty), duty.application_factor)
    if bins is None:
        return axis, found
    return axis, replace(found, bin_errors=tuple(bins.errors.tolist()), measured=bins.rows)


def _columns(
    duty: Duty, folder: Path, find: Callable[[str], Declaration]
) -> tuple[dict[str, Sequence[Any]], Binned | None]:
    """Shares and keys of the rows, given here and in a file; the bins where rows of a file are in such."""
    weights = {name: tuple(given) for name in MEASURES if (given := getattr(duty, name)) is not None}
    for name in weights:
        if not weights[name]:
            raise BadValues(f"{name} is an empty list; every row has a share")
    columns: dict[str, Sequence[Any]] = weights | columns_of(duty.model_extra or {}, find)
    if duty.file is not None and duty.series is not None:
        raise BadValues("file and series are both there; the rows are in one of them")
    name = duty.file or duty.series
    if name is None:
        if duty.bins is not None:
            raise BadValues("bins is given without file or series, whose rows are sorted into them")
        return columns, None
    if duty.file and duty.bins is None:
        keys, table = rows(folder / name, lambda key: key in MEASURES or find(key).kind is not None)
        return _joined(columns, dict(zip(keys, zip(*table, strict=True), strict=True)), name), None
    if weights:
        raise BadValues(f"{min(weights)} is given beside {excerpt(name)}, whose rows have their own")
    bins = duty.bins or BINS
    found = series(folder / name, bins, find) if duty.series else binned(folder / name, bins, find, WEIGHING)
    return _joined(columns, {found.measure: found.weights.tolist(), **found.columns}, name), found


def _joined(
    columns: dict[str, Sequence[Any]], of_file: Mapping[str, Sequence[Any]], file: str
) -> dict[str, Sequence[Any]]:
    """Columns of the study file and of another one, none of which is in both."""
    if twice := columns.keys() & of_file.keys():
        raise BadValues(f"{min(twice)} is given here and in {file}")
    return {**columns, **of_file}


def _required(duty: Duty) -> float | None:
    """The life that is required [s]."""
    if duty.required_life is None:
        return None
    number, _, name = duty.required_life.strip().partition(" ")
    words = f'required_life has {excerpt(toml(duty.required_life))}; it is a time, such as "20000 h"'
    try:
        of = unit(name.strip() or "1")
        seconds = of.to_si(inputs.number(number))
    except (BadUnit, UnknownUnit, inputs.BadNumber):
        raise BadValues(words) from None
    if of.powers != unit("s").powers or seconds <= 0:
        raise BadValues(words)
    return seconds


def _shares(measure: str, given: Sequence[Any]) -> tuple[float, ...]:
    weights, units = zip(*(_weight(measure, value) for value in given), strict=True)
    if len({*units}) > 1:
        raise BadValues(
            f"{measure} has shares in {' and '.join(map(repr, units))}; write all in the same unit"
        )
    total = fsum(weights)
    if total <= 0:
        raise BadValues(f"{measure} has no share above zero")
    if units[0] == "%" and abs(total - 1) > COMPLETE:
        raise BadValues(f"{measure} adds up to {100 * total:g} %; percentages must add up to 100 %")
    return tuple(weight / total for weight in weights)


def _weights(measure: str, given: Sequence[Any]) -> NDArray:
    return np.array(_shares(measure, given))


WEIGHING = {measure: partial(_weights, measure) for measure in MEASURES}


def _weight(measure: str, value: Any) -> tuple[float, str]:
    """A weight in SI units, and the unit that it is written in."""
    if value is None:
        raise BadValues(f"{measure} has an empty cell; every row has a share")
    number, _, name = str(value).strip().partition(" ")
    words = f"{measure} has {excerpt(toml(value))}"
    try:
        of = unit(name.strip() or "1")
        weight = of.to_si(inputs.number(number))
    except (BadUnit, UnknownUnit, inputs.BadNumber):
        raise BadValues(
            f'{words}; a share is a number, a percentage such as "30 %", or a {measure}'
        ) from None
    if of.powers not in (unit("1").powers, unit(MEASURES[measure]).powers):
        raise BadValues(f"{words}, which is no share of {measure}")
    if weight < 0:
        raise BadValues(f"{words}; a share is at least 0")
    return weight, name.strip()
