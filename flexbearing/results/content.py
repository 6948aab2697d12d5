"""What is in a result file, apart from how HDF5 stores it."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from json import dumps
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.quantities import Quantity
from flexbearing.quantities.layout import ITERATION, Axis, Layout

ITERATIONS = "iterations"  # group whose arrays have a row for each iteration
Groups = Mapping[str, Mapping[str, NDArray]]  # blocks and iterations, by name
DIGEST, MEANINGS = "digest", "meanings"  # root attributes that are no part of a result


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


@dataclass(frozen=True)
class Content:
    """Root attributes and arrays of a file."""

    attributes: Mapping[str, Any]  # texts, lists of texts, whole numbers and numbers; without the digest
    arrays: Mapping[str, NDArray]  # of float64, "rigid/inner_load" in a group and "roller", a scale
    units: Mapping[str, str]  # of each array; empty for a scale that is a length and has no numbers
    axes: Mapping[str, tuple[str, ...]]  # scales along each array; none of a scale


def digest(content: Content) -> str:
    """SHA-256 over everything in a file.

    Of the bytes of a JSON text without spaces, keys sorted, ASCII alone, followed by the arrays in the order
    of their sorted names, each as little-endian float64, row by row. The text holds `attributes` (floats as
    hexadecimal texts), `shapes`, `units` and `axes`.
    """
    head = {
        "attributes": {name: _exact(value) for name, value in content.attributes.items()},
        "shapes": {name: array.shape for name, array in content.arrays.items()},
        "units": dict(content.units),
        "axes": dict(content.axes),
    }
    hashed = sha256(json.dumps(head, sort_keys=True, separators=(",", ":")).encode())
    for name in sorted(content.arrays):
        hashed.update(np.ascontiguousarray(content.arrays[name], dtype="<f8").tobytes())
    return hashed.hexdigest()


def _exact(value: Any) -> Any:
    return float(value).hex() if isinstance(value, float) else value
