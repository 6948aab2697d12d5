"""Objects of the table in `forms` as bytes, with a digest that shows damage, without pickle.

The bytes are

- 32 bytes: SHA-256 over the name of the entry, a zero byte, and all that follows
- 8 bytes: length of the header, little-endian
- the header: JSON with the class and its fields, of an array its dtype, shape and order, C or F
- the numbers of the arrays one after the other, each beginning at the next multiple of 64 after the digest

Nothing is compressed: no file makes more than its own length of arrays.
"""

import json
from hashlib import sha256
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.cache.forms import RECORDS, Array, Kept, WrongForm, plain, require_fields, require_form

DTYPES = ("<f8", "<c16", "<i8")
LONGEST_HEADER = 2**16  # bytes
_DIGEST, _LENGTH, _STEP = 32, 8, 64  # bytes


class Damaged(ValueError):
    """Bytes that are not what was written."""


def packed(entry: str, name: str, value: Any) -> bytes:
    """Bytes from which `unpacked` makes the value again.

    Raises `WrongForm` for anything else, or fields of another form than the table has.
    """
    require_form(name, value)
    arrays: list[NDArray] = []
    header = json.dumps(_tree(name, value, arrays)).encode()
    if len(header) > LONGEST_HEADER:
        raise WrongForm(f"the header of this {name} has {len(header)} bytes; allowed are {LONGEST_HEADER}")
    content = bytearray(len(header).to_bytes(_LENGTH, "little") + header)
    for array in arrays:
        content += bytes(-len(content) % _STEP)
        content += array.tobytes("A")
    return _digest(entry, content) + content


def unpacked(entry: str, name: str, data: bytes) -> Any:
    """The value that `packed` was given; its arrays cannot be written to.

    Raises `Damaged` if the bytes are others than written, or were written for another entry or from another
    class.
    """
    content = memoryview(data)[_DIGEST:]
    if _digest(entry, content) != data[:_DIGEST]:
        raise Damaged("the digest does not fit")
    try:
        return _Reading(content).value(name)
    except (ValueError, TypeError, KeyError, ArithmeticError, RecursionError, MemoryError) as problem:
        # what JSON, NumPy and the class itself say to fields that somebody made up
        raise Damaged(f"{type(problem).__name__}: {problem}") from problem


def _digest(entry: str, content: bytes | bytearray | memoryview) -> bytes:
    digest = sha256(entry.encode() + b"\0")
    digest.update(content)
    return digest.digest()


def _tree(name: str, value: Any, arrays: list[NDArray]) -> dict[str, Any]:
    """An object as JSON, its arrays moved out in the order of the table."""
    fields = {}
    for field, form in RECORDS[name].fields.items():
        item = getattr(value, field)
        if isinstance(form, Kept):
            fields[field] = None if item is None else _tree(form.name, item, arrays)
        elif isinstance(form, Array):
            fields[field] = None if item is None else _described(item, arrays)
        else:
            fields[field] = plain(item)
    return {"class": name, "fields": fields}


def _described(array: NDArray, arrays: list[NDArray]) -> dict[str, Any]:
    order = "F" if array.flags.f_contiguous and not array.flags.c_contiguous else "C"
    arrays.append(np.asarray(array, dtype=array.dtype.newbyteorder("<"), order=order))
    dtype = arrays[-1].dtype.str
    if dtype not in DTYPES:
        raise WrongForm(f"an array of {array.dtype}; kept are {', '.join(DTYPES)}")
    return {"dtype": dtype, "shape": array.shape, "order": order}


class _Reading:
    """Objects from the header, arrays from what follows it."""

    def __init__(self, content: memoryview):
        length = int.from_bytes(content[:_LENGTH], "little")
        if length > min(LONGEST_HEADER, len(content) - _LENGTH):
            raise Damaged("the header is longer than the file, or than any")
        self.content, self.place = content, _LENGTH + length
        self.tree = json.loads(bytes(content[_LENGTH : self.place]))

    def value(self, name: str) -> Any:
        """The one object of the file."""
        made = self._object(name, self.tree)
        if self.place != len(self.content):
            raise Damaged("more bytes than arrays")
        return made

    def _object(self, name: str, tree: Any) -> Any:
        if tree["class"] != name:
            raise Damaged(f"a {tree['class']!r:.40} where a {name} belongs")
        values, fields = {}, RECORDS[name].fields
        for field, form in fields.items():
            item = tree["fields"][field]
            if isinstance(form, Kept):
                item = None if item is None and form.optional else self._object(form.name, item)
            elif isinstance(form, Array):
                item = None if item is None and form.optional else self._array(**item)
            values[field] = item
        require_fields(name, values)
        return RECORDS[name].made(name, values)

    def _array(self, dtype: str, shape: list[int], order: str) -> NDArray:
        if dtype not in DTYPES or order not in ("C", "F"):
            raise Damaged(f"an array of {dtype!r:.40} in the order {order!r:.40}")
        if not all(type(size) is int and 0 < size <= len(self.content) for size in shape):
            raise Damaged("an array longer than the file")
        first, count = self.place + -self.place % _STEP, prod(shape)
        self.place = first + count * np.dtype(dtype).itemsize
        if self.place > len(self.content):
            raise Damaged("an array longer than the file")
        return np.frombuffer(self.content, dtype, count, first).reshape(shape, order=order)  # pyright: ignore
