"""Dimension scales: the named axes of a result, by which other programs know what an array goes along."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from json import dumps

import numpy as np
from numpy.typing import NDArray

from flexbearing.quantities import Quantity
from flexbearing.quantities.axes import ITERATION, Axis
from flexbearing.quantities.layout import Layout

ITERATIONS = "iterations"  # group whose arrays have a row for each iteration
Groups = Mapping[str, Mapping[str, NDArray]]  # blocks and iterations, by name


@dataclass(frozen=True)
class Scale:
    """A named axis with the places along it."""

    values: NDArray  # (n), zeros where only the length is known
    unit: str = ""  # empty where only the length is known


def meanings(layout: Layout) -> str:
    """What every dataset means, by its name, as JSON: the root attribute of that name."""
    return dumps({entry.name: entry.meaning for entry in layout.quantities})


def named_axes(layout: Layout, group: str, entry: Quantity) -> tuple[str, ...]:
    """Names of the scales along a dataset of a group."""
    leading = (ITERATION.symbol,) if group == ITERATIONS else ()
    return tuple(layout.axis[symbol].name for symbol in (*leading, *entry.shape))


def scales(layout: Layout, groups: Groups) -> dict[str, Scale]:
    """The scales of all arrays of a result."""
    found: dict[str, Scale] = {}
    for axis, length in _along(layout, groups):
        if axis.name not in found:
            found[axis.name] = _scale(layout, axis, length, groups)
    return found


def _along(layout: Layout, groups: Groups) -> Iterator[tuple[Axis, int]]:
    """Every axis of every array with its length."""
    for group, arrays in groups.items():
        leading = (ITERATION.symbol,) if group == ITERATIONS else ()
        for name, array in arrays.items():
            axes = [layout.axis[symbol] for symbol in (*leading, *layout[name].shape)]
            yield from zip(axes, array.shape, strict=True)


def _scale(layout: Layout, axis: Axis, length: int, groups: Groups) -> Scale:
    if axis is ITERATION:
        return Scale(np.arange(1.0, length + 1), "1")
    for group, arrays in groups.items():
        if group != ITERATIONS and axis.coordinate in arrays:
            return Scale(arrays[axis.coordinate], layout[axis.coordinate].unit)
    return Scale(np.zeros(length))
