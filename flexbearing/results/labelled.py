"""A result as xarray has it: named dimensions, places along them, units."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.layout import ITERATION, Layout
from flexbearing.results.content import Groups, named_axes, scales

if TYPE_CHECKING:
    from xarray import Dataset, DataTree


def labelled(layout: Layout, groups: Groups, attributes: Mapping[str, Any]) -> DataTree:
    """Blocks and iterations as a tree of data sets."""
    from xarray import Dataset, DataTree

    root = Dataset(coords=_coordinates(layout, groups), attrs=dict(attributes))
    blocks = {name: _data_set(layout, name, arrays) for name, arrays in groups.items() if arrays}
    return DataTree.from_dict({"/": root, **blocks})


def _coordinates(layout: Layout, groups: Groups) -> dict[str, Any]:
    """Places along every axis that has some."""
    entries = {axis.name: np.array(axis.entries) for axis in layout.axis.values() if axis.entries}
    coordinates: dict[str, Any] = {}
    for name, scale in scales(layout, groups).items():
        if name in entries:
            coordinates[name] = (name, entries[name])
        elif name == ITERATION.name:
            coordinates[name] = (name, scale.values.astype(int))
        elif scale.unit:
            coordinates[name] = (name, scale.values, {"units": scale.unit})
    return coordinates


def _data_set(layout: Layout, group: str, arrays: Mapping[str, Any]) -> Dataset:
    from xarray import Dataset

    return Dataset(
        {
            name: (
                named_axes(layout, group, layout[name]),
                array,
                {"units": layout[name].unit, "long_name": layout[name].meaning},
            )
            for name, array in arrays.items()
        }
    )
