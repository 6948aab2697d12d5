"""Content as the bytes of an HDF5 file, and back.

The library works in memory only: a full disk cannot break it, and it follows no link and opens no other file.
A file from elsewhere may claim anything, so every claim is checked before memory is taken for it.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from h5py import h5a, h5d, h5f, h5g, h5l, h5p, h5s, h5t, h5z  # pyright: ignore[reportAttributeAccessIssue]
from numpy.typing import NDArray

from flexbearing.results.content import DIGEST, Content, digest

MOST = 256  # groups of a file, arrays of a group, attributes of an array
MOST_TEXTS = 10_000  # of a list
_TEXT_MEMORY = 500_000_000  # bytes that a list of texts may come to
LONGEST = 4_000_000_000  # bytes of a file
_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_SUPERBLOCKS = (
    b"\2",
    b"\3",
)  # versions that say the end of the file at this place; older ones are of older formats
_END_OF_FILE = slice(28, 36)
_STRING = h5py.string_dtype()
_TEXT = h5t.py_create(_STRING, logical=True)
_SCALAR = h5s.create(h5s.SCALAR)
_LAYOUTS = (h5d.COMPACT, h5d.CONTIGUOUS, h5d.CHUNKED)


class BadContent(ValueError):
    """A file that holds something else than such a content; the message says what."""


def image(content: Content) -> bytes:
    """Bytes of the file, which carries checksums of its arrays and a digest of everything.

    Parameters
    ----------
    content : Content
        without the attribute of the digest

    Returns
    -------
    bytes
        readable from HDF5 1.10 on
    """
    with h5py.File(_name(), "w", driver="core", backing_store=False, libver=("v110", "v110")) as file:
        for name, value in {**content.attributes, DIGEST: digest(content)}.items():
            _write_attribute(file.id, name, value)
        for group in dict.fromkeys(name.partition("/")[0] for name in content.arrays):
            file.create_group(group)
        for name, array in content.arrays.items():
            dataset = _written(file.id, name, array)
            for key, text in content.texts[name].items():
                _write_attribute(dataset, key, text)
        file.flush()
        return file.id.get_file_image()


def stored(path: Path) -> bytes:
    """Bytes of a file, once its first ones say that it is HDF5 and how long it is.

    Parameters
    ----------
    path : Path
        a regular file

    Returns
    -------
    bytes

    Raises
    ------
    BadContent
        for another kind of file, one that is longer or shorter than it says, or longer than any result
    OSError
        if it cannot be read
    """
    with path.open("rb") as file:
        start, length = file.read(_END_OF_FILE.stop), os.fstat(file.fileno()).st_size
        if not start.startswith(_SIGNATURE):
            raise BadContent("not an HDF5 file, or damaged")
        if start[len(_SIGNATURE) : len(_SIGNATURE) + 1] in _SUPERBLOCKS:
            said = int.from_bytes(start[_END_OF_FILE], "little")
            if said != length:
                raise BadContent(f"damaged: it has {length} bytes and says that it ends after {said}")
        if length > LONGEST:
            raise BadContent(f"it has {length} bytes; {LONGEST} is the most of a result")
        return start + file.read()


def content(data: bytes) -> tuple[Content, str]:
    """Read the content of a file's bytes.

    Parameters
    ----------
    data : bytes
        of a file

    Returns
    -------
    Content
        its arrays cannot be written to
    str
        the digest that the file claims

    Raises
    ------
    BadContent
        for anything that `image` would not have written
    """
    with _opened(data) as root:
        return _content(root, len(data))


def attribute(data: bytes, name: str) -> Any:
    """Read one root attribute, also of a file of another format.

    Parameters
    ----------
    data : bytes
        of a file
    name : str
        of the attribute

    Returns
    -------
    text, list of texts, whole number, number or None
        None where the file says nothing that could be read

    Raises
    ------
    BadContent
        for a file that is not HDF5
    """
    with _opened(data) as root:
        return _stated(root, name, len(data))


@contextmanager
def _opened(data: bytes) -> Iterator[Any]:
    """Root of a file in memory."""
    access = h5p.create(h5p.FILE_ACCESS)
    access.set_fapl_core(backing_store=False)
    access.set_file_image(data)
    try:
        file = h5f.open(_name().encode(), h5f.ACC_RDONLY, fapl=access)
        try:
            yield h5g.open(file, b"/")
        finally:
            file.close()
    # The library tells damage in all these ways; which one, only the damage knows.
    except (OSError, RuntimeError, ValueError, TypeError, KeyError, MemoryError, OverflowError) as problem:
        if isinstance(problem, BadContent):
            raise
        raise BadContent(f"not an HDF5 file, or damaged ({_first_line(problem)})") from problem


def _name() -> str:
    """A name that no other file in memory has: the library takes files of one name for one file."""
    return f"image-{os.urandom(8).hex()}"


def _content(root: Any, size: int) -> tuple[Content, str]:
    """The content below the root, unchecked, and the digest that it claims."""
    if not h5a.exists(root, DIGEST.encode()):
        raise Foreign(*(_stated(root, name, size) for name in ("format", "versions")))
    arrays: dict[str, NDArray] = {}
    texts: dict[str, dict[str, str]] = {}
    room = size
    for group_name in _names(root, "file"):
        group = h5g.open(root, group_name.encode())
        for name in _names(group, group_name):
            path = f"{group_name}/{name}"
            dataset = h5d.open(group, name.encode())
            arrays[path] = _array(dataset, path, room)
            room -= arrays[path].nbytes
            texts[path] = _attributes(dataset, room)
            room -= sum(map(_length, texts[path].values()))
    attributes = _attributes(root, room)  # last: the room that numbers leave is no room for texts
    claimed = str(attributes.pop(DIGEST))
    return Content(attributes, arrays, texts), claimed


class Foreign(BadContent):
    """An HDF5 file without digest: of another program, or of an older format."""

    def __init__(self, number: Any, versions: Any):
        super().__init__("an HDF5 file without a digest")
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
    array = np.empty(shape)
    if array.size:
        dataset.read(h5s.ALL, h5s.ALL, array)
    array.flags.writeable = False
    return array


def _written(file: Any, path: str, array: NDArray) -> Any:
    plan = h5p.create(h5p.DATASET_CREATE)
    if array.ndim and array.size:  # a checksum needs a chunk; the digest is enough for the others
        plan.set_chunk(array.shape)
        plan.set_fletcher32()
    space = h5s.create_simple(array.shape) if array.ndim else _SCALAR
    dataset = h5d.create(file, path.encode(), h5t.IEEE_F64LE, space, plan)
    dataset.write(h5s.ALL, h5s.ALL, np.ascontiguousarray(array, dtype="<f8"))
    return dataset


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
        texts = np.empty(shape, dtype=_STRING)
        if count:
            attribute.read(texts)
        decoded = [_decoded(text) for text in texts.reshape(-1)]
        return decoded if shape else decoded[0]
    if shape == () and kind in (h5t.NATIVE_INT64, h5t.NATIVE_DOUBLE):
        number = np.empty((), dtype=kind.dtype)
        attribute.read(number)
        return number.item()
    raise BadContent(f"attribute {_shown(attribute.name)} is neither text nor number")


def _write_attribute(owner: Any, name: str, value: Any) -> None:
    if isinstance(value, str | list):
        space = h5s.create_simple((len(value),)) if isinstance(value, list) else _SCALAR
        stored, kind = np.array(value, dtype=_STRING), _TEXT
    else:
        stored, space = np.array(value), _SCALAR
        kind = h5t.NATIVE_DOUBLE if isinstance(value, float) else h5t.NATIVE_INT64
    attribute = h5a.create(owner, name.encode(), kind, space)
    if stored.size:
        attribute.write(stored)


def _decoded(text: Any) -> str:
    return text.decode() if isinstance(text, bytes) else str(text)


def _shown(name: bytes) -> str:
    return repr(name.decode(errors="replace"))


def _first_line(problem: Exception) -> str:
    return (str(problem).strip().splitlines() or [type(problem).__name__])[0]
