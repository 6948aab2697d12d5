"""The table as arrays over named dimensions, which netCDF4 and HDF5 hold."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray

from flexbearing.outputs.names import ROLLER
from flexbearing.studies.file import Axis
from flexbearing.studies.table.table import Column


def dataset(
    name: str, columns: Sequence[Column], axes: Sequence[Axis], of_rollers: Sequence[Column] = ()
) -> xarray.Dataset:
    """Arrays over the axes of a study."""
    shape = [len(axis.rows) for axis in axes]
    dimensions = [axis.name for axis in axes]
    varied = {column.name: column for column in columns if column.varied}
    variables = {
        column.name: (dimensions, _array(column).reshape(shape), _attributes(column))
        for column in columns
        if not column.varied
    } | {
        column.name: (
            [*dimensions, ROLLER],
            np.array(column.values, dtype=float).reshape([*shape, -1]),
            _attributes(column),
        )
        for column in of_rollers
    }
    coordinates = {
        key: ([axis.name], _along(varied[key], number, shape), _attributes(varied[key]))
        for number, axis in enumerate(axes)
        for key in axis.keys
    } | {axis.name: _numbers(axis) for axis in axes if axis.name not in axis.keys}
    return xarray.Dataset(variables, coordinates, {"title": name})


def _array(column: Column) -> np.ndarray:
    values = np.asarray(column.values)
    return values.astype(np.int8) if values.dtype == bool else values  # netCDF4 has no other flags


def _along(column: Column, number: int, shape: list[int]) -> np.ndarray:
    """Values of a key along its axis."""
    values = np.moveaxis(_array(column).reshape(shape), number, 0)
    return values.reshape(shape[number], -1)[:, 0]


def _attributes(column: Column) -> dict[str, Any]:
    return {"units": column.unit} if column.unit else {}


def _numbers(axis: Axis) -> tuple[list[str], np.ndarray]:
    """Rows of an axis of several keys, counted from 1 as messages do."""
    return [axis.name], np.arange(1, len(axis.rows) + 1)
