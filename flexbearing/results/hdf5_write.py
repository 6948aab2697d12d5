"""Content as the bytes of an HDF5 file.

The library works in memory only: a full disk cannot break it. Its calls are what a file costs, so an array
takes few of them: made, written, its unit, its scales.
"""

import os
from functools import lru_cache
from typing import Any

import h5py
import numpy as np
from h5py import h5a, h5d, h5ds, h5p, h5r, h5s, h5t  # pyright: ignore[reportAttributeAccessIssue]
from numpy.typing import NDArray

from flexbearing.results.content import DIGEST, Content, digest

LENGTH_ALONE = "This is a netCDF dimension but not a netCDF variable.%10d"  # name of a scale without numbers
UNITS, SCALES, ATTACHED = b"units", b"DIMENSION_LIST", b"REFERENCE_LIST"  # attributes of arrays and scales
STRING = h5py.string_dtype()
_TEXT = h5t.py_create(STRING, logical=True)
_SCALAR = h5s.create(h5s.SCALAR)
ALONG_AXIS = h5py.vlen_dtype(h5py.ref_dtype)  # references to the scales along one axis
LIST_OF_SCALES = h5t.py_create(ALONG_AXIS, logical=True)
_PLACE = np.dtype([("dataset", h5py.ref_dtype), ("dimension", "<i4")])  # where a scale is attached
_PLACES = h5t.py_create(_PLACE, logical=True)


def image(content: Content) -> bytes:
    """Bytes of the file, which carries checksums of its arrays and a digest of everything."""
    memory: dict[str, Any] = {"driver": "core", "backing_store": False, "libver": ("v110", "v110")}
    with h5py.File(name_in_memory(), "w", **memory) as file:
        for name, value in {**content.attributes, DIGEST: digest(content)}.items():
            _write_attribute(file.id, name.encode(), value)
        for group in dict.fromkeys(name.partition("/")[0] for name in content.arrays if "/" in name):
            file.create_group(group)
        _write_arrays(file.id, content)
        file.flush()
        return file.id.get_file_image()


def name_in_memory() -> str:
    """A name that no other file in memory has: the library takes files of one name for one file."""
    return f"image-{os.urandom(8).hex()}"


def _write_arrays(file: Any, content: Content) -> None:
    """Scales first, then the arrays that they are attached to."""
    scales: dict[str, Any] = {}
    for name in (name for name in content.arrays if "/" not in name):
        scales[name] = _written(file, name, content.arrays[name], content.units[name])
        known_as = name if content.units[name] else LENGTH_ALONE % content.arrays[name].size
        h5ds.set_scale(scales[name], known_as.encode())
    lists = {axes: _list_of_scales(file, axes) for axes in set(content.axes.values()) if axes}
    attached: dict[str, list[tuple[Any, int]]] = {name: [] for name in scales}
    for name, axes in content.axes.items():
        dataset = _written(file, name, content.arrays[name], content.units[name])
        if axes:
            h5a.create(dataset, SCALES, LIST_OF_SCALES, h5s.create_simple((len(axes),))).write(lists[axes])
            reference = h5r.create(file, name.encode(), h5r.OBJECT)
            for dimension, axis in enumerate(axes):
                attached[axis].append((reference, dimension))
    for name, places in attached.items():
        stored = np.array(places, dtype=_PLACE)
        h5a.create(scales[name], ATTACHED, _PLACES, h5s.create_simple(stored.shape)).write(stored)


def _list_of_scales(file: Any, axes: tuple[str, ...]) -> NDArray:
    """One scale along each axis."""
    listed = np.empty(len(axes), dtype=ALONG_AXIS)
    for place, axis in enumerate(axes):
        listed[place] = np.array([h5r.create(file, axis.encode(), h5r.OBJECT)], dtype=h5py.ref_dtype)
    return listed


def _written(file: Any, path: str, array: NDArray, unit: str) -> Any:
    dataset = h5d.create(file, path.encode(), h5t.IEEE_F64LE, *_form(array.shape))
    dataset.write(h5s.ALL, h5s.ALL, np.ascontiguousarray(array, dtype="<f8"))
    if unit:
        _write_attribute(dataset, UNITS, unit)
    return dataset


@lru_cache(maxsize=64)  # most arrays have the shape of others
def _form(shape: tuple[int, ...]) -> tuple[Any, Any]:
    """Space and plan of the arrays of a shape."""
    plan = h5p.create(h5p.DATASET_CREATE)
    if 0 not in shape and shape:  # a checksum needs a chunk; the digest is enough for the others
        plan.set_chunk(shape)
        plan.set_fletcher32()
    return h5s.create_simple(shape) if shape else _SCALAR, plan


def _write_attribute(owner: Any, name: bytes, value: Any) -> None:
    if isinstance(value, str | list):
        space = h5s.create_simple((len(value),)) if isinstance(value, list) else _SCALAR
        stored, kind = np.array(value, dtype=STRING), _TEXT
    else:
        stored, space = np.array(value), _SCALAR
        kind = h5t.NATIVE_DOUBLE if isinstance(value, float) else h5t.NATIVE_INT64
    attribute = h5a.create(owner, name, kind, space)
    if stored.size:
        attribute.write(stored)
