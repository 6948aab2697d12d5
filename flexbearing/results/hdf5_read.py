"""Content from the bytes of an HDF5 file.

The library works in memory only: it follows no link and opens no other file. A file from elsewhere may claim
anything, so every claim is checked before memory is taken for it.
"""

import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from h5py import h5a, h5d, h5ds, h5f, h5g, h5l, h5o, h5p, h5r, h5s, h5t, h5z  # pyright: ignore[reportAttributeAccessIssue]
from numpy.typing import NDArray

from flexbearing import inputs
from flexbearing.inputs.file import RESULT
from flexbearing.quantities.attributes import FORMAT
from flexbearing.results.content import DIGEST, Content
from flexbearing.results.hdf5_write import (
    ALONG_AXIS,
    ATTACHED,
    LENGTH_ALONE,
    LIST_OF_SCALES,
    SCALES,
    STRING,
    UNITS,
    name_in_memory,
)

MOST = 256  # groups of a file, arrays of a group, attributes of an array
MOST_TEXTS = 10_000  # of a list
_TEXT_MEMORY = 500_000_000  # bytes that a list of texts may come to
_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_SUPERBLOCKS = (
    b"\2",
    b"\3",
)  # versions that say the end of the file at this place; older ones are of older formats
_END_OF_FILE = slice(28, 36)
_HEAP = re.compile(rb"GCOL\x01\x00\x00\x00(.{8})", re.DOTALL)  # with its size
_OBJECT_HEADER = 16  # bytes
_OF_SCALES = b"CLASS", b"NAME", ATTACHED  # attributes that make an array a scale
_LAYOUTS = (h5d.COMPACT, h5d.CONTIGUOUS, h5d.CHUNKED)


class BadContent(ValueError):
    """A file that holds something else than such a content; the message says what."""


def stored(path: Path) -> bytes:
    """Bytes of a file, once its first ones say that it is HDF5 and how long it is.

    Raises `BadContent` for another kind of file, one that is longer or shorter than it says, or longer than
    any result; `Unreadable` if it cannot be read.
    """
    with inputs.opened(path) as file:
        start, length = file.read(_END_OF_FILE.stop), os.fstat(file.fileno()).st_size
        if not start.startswith(_SIGNATURE):
            raise BadContent("not an HDF5 file, or damaged")
        if start[len(_SIGNATURE) : len(_SIGNATURE) + 1] in _SUPERBLOCKS:
            said = int.from_bytes(start[_END_OF_FILE], "little")
            if said != length:
                raise BadContent(f"damaged: it has {length} bytes and says that it ends after {said}")
        if length > RESULT:
            raise BadContent(f"it is larger than {inputs.size(RESULT)}, the most of a result")
        return start + file.read()


def content(data: bytes) -> tuple[Content, str]:
    """Read the content of a file's bytes.

    Raises `BadContent` for anything that `image` would not have written.
    """
    with _opened(data) as root:
        return _content(root, len(data))


def attribute(data: bytes, name: str) -> Any:
    """Read one root attribute, also of a file of another format.

    Raises `BadContent` for a file that is not HDF5.
    """
    with _opened(data) as root:
        return _stated(root, name, len(data))


def require_held(data: bytes, content: Content) -> None:
    """Raise unless the arrays in a file's bytes are those of a content.

    What a writer asks of its own bytes: names, units, axes and forms of storage are not examined again.

    Raises `BadContent` where the library made something else of it.
    """
    with _opened(data) as root:
        for path, array in content.arrays.items():
            dataset = h5d.open(root, path.encode())
            if dataset.shape != array.shape or _numbers(dataset).tobytes() != array.tobytes():
                raise BadContent(f"{path} is not what was to be written")


@contextmanager
def _opened(data: bytes) -> Iterator[Any]:
    """Root of a file in memory."""
    _require_heaps(data)
    access = h5p.create(h5p.FILE_ACCESS)
    access.set_fapl_core(backing_store=False)
    access.set_file_image(data)
    try:
        file = h5f.open(name_in_memory().encode(), h5f.ACC_RDONLY, fapl=access)
        try:
            yield h5g.open(file, b"/")
        finally:
            file.close()
    # The library reports damage in all these ways; which one, only the damage knows.
    except (OSError, RuntimeError, ValueError, TypeError, KeyError, MemoryError, OverflowError) as problem:
        if isinstance(problem, BadContent):
            raise
        raise BadContent(f"not an HDF5 file, or damaged ({_first_line(problem)})") from problem


def _require_heaps(data: bytes) -> None:
    """Refuse damaged heaps of texts, in some of which the library looks for an object without end.

    Source
    ------
    HDF5 File Format Specification 3.0, section III.E, Global Heap.
    """
    for found in _HEAP.finditer(data):
        place, end = found.end(), found.start() + int.from_bytes(found[1], "little")
        while end - place >= _OBJECT_HEADER:
            number = int.from_bytes(data[place : place + 2], "little")
            size = int.from_bytes(data[place + 8 : place + _OBJECT_HEADER], "little")
            step = (
                _OBJECT_HEADER + -(-size // 8) * 8 if number else size
            )  # that of what is free counts its header
            if step < _OBJECT_HEADER or place + step > end or end > len(data):
                raise BadContent("damaged: an object in a heap of texts has an impossible size")
            place += step


def _content(root: Any, size: int) -> tuple[Content, str]:
    """The content below the root, unchecked, and the digest that it claims."""
    number = _stated(root, "format", size)
    if number != FORMAT or not h5a.exists(root, DIGEST.encode()):
        raise Foreign(number, _stated(root, "versions", size))
    found, groups = _Found(size), []
    for name in _names(root, "file"):
        if h5g.get_objinfo(root, name.encode()).type == h5g.DATASET:
            found.add_scale(root, name)
        else:
            groups.append(name)
    for name in groups:
        group = h5g.open(root, name.encode())
        for inside in _names(group, name):
            found.add_array(group, f"{name}/{inside}")
    attributes = _attributes(root, found.room)  # last: the room that numbers leave is no room for texts
    claimed = str(attributes.pop(DIGEST))
    return Content(attributes, found.arrays, found.units, found.axes), claimed


class _Found:
    """Arrays of a file so far, and the bytes that are left for others."""

    def __init__(self, room: int):
        self.room = room
        self.arrays: dict[str, NDArray] = {}
        self.units: dict[str, str] = {}
        self.axes: dict[str, tuple[str, ...]] = {}
        self._scales: dict[int, str] = {}  # by their places in the file

    def add_scale(self, root: Any, name: str) -> None:
        """Add the numbers along a named axis; those of a length alone have no unit."""
        dataset = h5d.open(root, name.encode())
        array = self._add(dataset, name, _OF_SCALES)
        known_as = name if self.units[name] else LENGTH_ALONE % array.size
        if not h5ds.is_scale(dataset) or h5ds.get_scale_name(dataset) != known_as.encode():
            raise BadContent(f"{_shown(name.encode())} is no scale of an axis")
        self._scales[h5o.get_info(dataset).addr] = name

    def add_array(self, group: Any, path: str) -> None:
        """Add an array of a group with the names of its axes."""
        dataset = h5d.open(group, path.partition("/")[2].encode())
        array = self._add(dataset, path, (SCALES,))
        self.axes[path] = _axes(dataset, path, self._scales) if array.ndim else ()

    def _add(self, dataset: Any, path: str, others: tuple[bytes, ...]) -> NDArray:
        array = self.arrays[path] = _array(dataset, path, self.room)
        self.room -= array.nbytes
        unit = self.units[path] = _unit(dataset, path, self.room, others)
        self.room -= len(unit)
        return array


def _unit(dataset: Any, path: str, room: int, others: tuple[bytes, ...]) -> str:
    """The unit of an array, empty where it has none; beside it there are some attributes and no more."""
    unit = ""
    for place in range(h5a.get_num_attrs(dataset)):
        attribute = h5a.open(dataset, index=place)
        name = attribute.name
        if name == UNITS:
            unit = _attribute(attribute, room)
        elif name not in others:
            raise BadContent(f"{path} has an attribute {_shown(name)}, which is none of a result")
    if not isinstance(unit, str) or len(unit) > room:
        raise BadContent(f"{path} has a unit that is no text, or more of it than the file holds")
    return unit


def _axes(dataset: Any, path: str, scales: Mapping[int, str]) -> tuple[str, ...]:
    """Names of the scales along an array, one along each axis; the library would search the file for them."""
    attribute = h5a.open(dataset, SCALES) if h5a.exists(dataset, SCALES) else None
    if attribute and attribute.get_type() == LIST_OF_SCALES and attribute.shape == (dataset.rank,):
        references: Any = np.empty(attribute.shape, dtype=ALONG_AXIS)
        attribute.read(references)
        single = [one[0] for one in references if one is not None and len(one) == 1]
        places = [h5o.get_info(h5r.dereference(reference, dataset)).addr for reference in single]
        names = tuple(scales[place] for place in places if place in scales)
        if len(names) == dataset.rank:
            return names
    raise BadContent(f"{path} has no scale along each of its axes")


class Foreign(BadContent):
    """An HDF5 file of another program, or of another format."""

    def __init__(self, number: Any, versions: Any):
        super().__init__("an HDF5 file of another format")
        self.number = number  # of its format, None for another program
        self.versions = versions


def _stated(root: Any, name: str, size: int) -> Any:
    """What a file of another kind says in an attribute, None where it says nothing that could be read."""
    if not h5a.exists(root, name.encode()):
        return None
    try:
        return _attribute(h5a.open(root, name.encode()), size)
    except BadContent:
        return None


def _names(group: Any, where: str) -> Iterator[str]:
    """Names of what lies in a group; all of it in the file itself, linked nowhere else."""
    if group.get_num_objs() > MOST:
        raise BadContent(f"{where} holds {group.get_num_objs()} names; {MOST} is the most")
    for name in group:
        if group.links.get_info(name).type != h5l.TYPE_HARD:
            raise BadContent(f"{_shown(name)} in {where} is a link to elsewhere; none is followed")
        yield name.decode()


def _array(dataset: Any, path: str, room: int) -> NDArray:
    """Numbers of a dataset, once they are known to be in the file."""
    plan, space = dataset.get_create_plist(), dataset.get_space()
    if dataset.get_type() != h5t.IEEE_F64LE:
        raise BadContent(f"{path} holds no 64-bit floats, little-endian")
    if plan.get_external_count() or plan.get_layout() not in _LAYOUTS:
        raise BadContent(f"{path} keeps its numbers in another file; none is followed")
    if any(plan.get_filter(place)[0] != h5z.FILTER_FLETCHER32 for place in range(plan.get_nfilters())):
        raise BadContent(f"{path} is compressed; such files are not")
    if space.get_simple_extent_type() == h5s.NULL:
        raise BadContent(f"{path} is empty")
    shape = space.get_simple_extent_dims()
    if plan.get_layout() == h5d.CHUNKED and plan.get_chunk() != shape:
        raise BadContent(f"{path} is stored in pieces; such files are not")
    needed = 8 * int(np.prod([int(length) for length in shape], dtype=object))
    if needed > min(room, dataset.get_storage_size()):
        raise BadContent(f"{path} claims {needed} bytes; the file does not hold them")
    array = _numbers(dataset)
    array.flags.writeable = False
    return array


def _numbers(dataset: Any) -> NDArray:
    array = np.empty(dataset.shape)
    if array.size:
        dataset.read(h5s.ALL, h5s.ALL, array)
    return array


def _attributes(owner: Any, room: int) -> dict[str, Any]:
    """Attributes of the root or of an array, texts and numbers alone."""
    count = h5a.get_num_attrs(owner)
    if count > MOST:
        raise BadContent(f"{count} attributes; {MOST} is the most")
    values: dict[str, Any] = {}
    left = room
    for place in range(count):
        attribute = h5a.open(owner, index=place)
        name = attribute.name
        value = values[name.decode()] = _attribute(attribute, room)
        left -= _length(value)
        if left < 0:
            raise BadContent(f"attribute {_shown(name)} claims more text than the file holds")
    return values


def _length(value: Any) -> int:
    """Characters of the texts of an attribute."""
    texts = value if isinstance(value, list) else [value]
    return sum(len(text) for text in texts if isinstance(text, str))


def _attribute(attribute: Any, room: int) -> Any:
    """One attribute: a text, a list of texts, a whole number or a number."""
    kind, space = attribute.get_type(), attribute.get_space()
    if space.get_simple_extent_type() == h5s.NULL:
        raise BadContent(f"attribute {_shown(attribute.name)} is empty")
    shape = space.get_simple_extent_dims()
    if isinstance(kind, h5t.TypeStringID) and kind.is_variable_str():
        count = shape[0] if shape else 1
        if len(shape) > 1 or count > MOST_TEXTS or count * room > max(_TEXT_MEMORY, room):
            name = _shown(attribute.name)
            raise BadContent(f"attribute {name} is no list of texts that the file could hold")
        texts = np.empty(shape, dtype=STRING)
        if count:
            attribute.read(texts)
        decoded = [text.decode() if isinstance(text, bytes) else str(text) for text in texts.reshape(-1)]
        return decoded if shape else decoded[0]
    if shape == () and kind in (h5t.NATIVE_INT64, h5t.NATIVE_DOUBLE):
        number = np.empty((), dtype=kind.dtype)
        attribute.read(number)
        return number.item()
    raise BadContent(f"attribute {_shown(attribute.name)} is neither text nor number")


def _shown(name: bytes) -> str:
    return repr(name.decode(errors="replace"))


def _first_line(problem: Exception) -> str:
    return (str(problem).strip().splitlines() or [type(problem).__name__])[0]
