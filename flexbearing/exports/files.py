"""A result as files: CSV tables of every block and set of axes, netCDF4, effects of assumed inputs."""

from collections.abc import Iterator, Mapping, Sequence
from importlib.util import find_spec
from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase, understood
from flexbearing.files import BadOutput, as_csv, require_folder, require_output, require_outputs, write
from flexbearing.quantities.layout import Axis, Layout
from flexbearing.quantities.quantity import Quantity
from flexbearing.results import BadResult, Result
from flexbearing.runs import effects_file

ALONE = "scalars"  # name of the table of numbers without places


def csv(result: Result, directory: Path) -> Iterator[Path]:
    """Write the end states of a result.

    Raises `BadResult` if nothing was solved; `BadOutput`, `NotStored` if a file cannot be written.
    """
    folder, layout = require_folder(directory), result.family.layout()
    tables = {
        folder / f"{result.stem}_{block}_{name}.csv": _table(layout, arrays, names)
        for block, arrays in (("rigid", result.rigid), ("flexible", result.flexible))
        for name, names in _groups(layout, arrays).items()
    }
    if not tables:
        raise BadResult(f"{result.place}: nothing was solved, so there is nothing to export.")
    places = require_outputs(tables, result.files)
    for place, (path, rows) in zip(places, tables.items(), strict=True):
        write(place, as_csv(rows).encode())
        yield path


def _groups(layout: Layout, arrays: Mapping[str, NDArray]) -> dict[str, list[str]]:
    """Names of arrays by those of the axes along which a table has its rows."""
    found: dict[str, list[str]] = {}
    for name in arrays:
        axes = [axis.name for axis in _along(layout, layout[name])]
        found.setdefault("_".join(axes) or ALONE, []).append(name)
    return found


def _along(layout: Layout, entry: Quantity) -> list[Axis]:
    """Axes of rows; those with fixed entries, such as inner and outer, are columns."""
    return [layout.axis[symbol] for symbol in entry.shape if not layout.axis[symbol].entries]


def _table(layout: Layout, arrays: Mapping[str, NDArray], names: Sequence[str]) -> list[list[object]]:
    """Heading and rows; rows are counted from 1 along every axis."""
    axes = _along(layout, layout[names[0]])
    lengths = _lengths(layout, arrays, names[0])
    columns: dict[str, NDArray] = {}
    for number, axis in enumerate(axes):
        shape = [-1 if place == number else 1 for place in range(len(axes))]
        columns[axis.name] = np.broadcast_to(np.arange(1, lengths[number] + 1).reshape(shape), lengths)
        places = layout.datasets("block").get(axis.coordinate)
        if places and places.name in arrays and places.name not in names:
            along = places.for_people(arrays[places.name]).reshape(shape)
            columns[_heading(places)] = np.broadcast_to(along, lengths)
    for name in names:
        columns |= dict(_columns(layout, layout[name], arrays[name]))
    rows = zip(*(column.ravel().tolist() for column in columns.values()), strict=True)
    return [list(columns), *map(list, rows)]


def _lengths(layout: Layout, arrays: Mapping[str, NDArray], name: str) -> tuple[int, ...]:
    symbols = layout[name].shape
    both = zip(symbols, arrays[name].shape, strict=True)
    return tuple(length for symbol, length in both if not layout.axis[symbol].entries)


def _columns(layout: Layout, entry: Quantity, array: NDArray) -> Iterator[tuple[str, NDArray]]:
    """Columns of a quantity, one for each set of entries of its fixed axes."""
    values = entry.for_people(array)
    fixed = [number for number, symbol in enumerate(entry.shape) if layout.axis[symbol].entries]
    values = np.moveaxis(values, fixed, range(len(fixed)))
    entries = [layout.axis[entry.shape[number]].entries for number in fixed]
    for place, words in zip(np.ndindex(*map(len, entries)), product(*entries), strict=True):
        yield _heading(entry, *words), values[place]


def _heading(entry: Quantity, *words: str) -> str:
    """Name and unit, "peak_pressure.inner [MPa]"."""
    unit = entry.unit_for_people.name
    several, turning = unit.split(", "), [word.startswith("about") for word in words]
    if len(several) == 2 ** len(turning) > 1:  # lengths first, then angles, row by row
        unit = several[int("".join("01"[each] for each in turning), 2)]
    return ".".join([entry.name, *words]) + (f" [{unit}]" if unit else "")


EXTRA = 'pip install "flexbearing[studies]"'


def netcdf(result: Result, directory: Path) -> Iterator[Path]:
    """Write a result as `Result.to_xarray` has it.

    Raises `BadOutput` if the file cannot be written, or xarray and h5netcdf are not installed; `NotStored` if
    there is no room for it.
    """
    if missing := [name for name in ("xarray", "h5netcdf") if find_spec(name) is None]:
        raise BadOutput(f"--to netcdf needs {' and '.join(missing)}: {EXTRA}.")
    path = require_output(require_folder(directory) / f"{result.stem}.nc", result.files)
    write(path, bytes(result.to_xarray().to_netcdf(engine="h5netcdf")))  # type: ignore[arg-type]
    yield path


def effects(result: Result, directory: Path) -> Iterator[Path]:
    """Write the effects of a result.

    Raises `BadCase` without that attribute; `BadOutput`, `NotStored` if the file cannot be written.
    """
    about = result.attributes
    if not about.get("assumed_effects"):
        raise BadCase(
            f"{result.place}: --to effects needs a result of a run with outputs.assumed_effects = true"
        )
    file = Path(about["case_file"])
    case = understood(about["case_text"], file, about["case_overrides"], {result.kind: result.family})
    path = require_output(require_folder(directory) / effects_file.name(file).name, result.files)
    write(path.resolve(), effects_file.content(case, about["assumed_effects"]))
    yield path
