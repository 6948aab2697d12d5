"""Frozen dataclasses of arrays as bytes, with a digest that tells damage, without pickle.

The bytes are a SHA-256 digest and an npz archive: the arrays as they are, and one text, `tree`, that says
in JSON where they belong.
"""

import json
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from hashlib import sha256
from importlib import import_module
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

HOME = "fem"  # package of the classes that may be kept; nothing else is ever imported
_DIGEST = 32  # bytes


class Damaged(ValueError):
    """Bytes that are not what was written."""


def packed(value: Any) -> bytes:
    """Bytes from which `unpacked` makes the value again.

    Parameters
    ----------
    value : object
        a dataclass of the package `HOME`, with arrays, numbers, strings, None, tuples, mappings from
        strings and such dataclasses in its fields

    Returns
    -------
    bytes

    Raises
    ------
    TypeError
        for anything else
    """
    arrays: dict[str, NDArray] = {}
    tree = json.dumps(_tree(value, arrays)).encode()
    file = BytesIO()
    np.savez(file, tree=np.frombuffer(tree, dtype=np.uint8), **arrays)  # pyright: ignore[reportArgumentType]
    content = file.getbuffer()
    return sha256(content).digest() + content


def unpacked(data: bytes) -> Any:
    """The value that `packed` was given.

    Parameters
    ----------
    data : bytes
        from `packed`

    Returns
    -------
    object

    Raises
    ------
    Damaged
        if the bytes are others than written
    """
    content = memoryview(data)[_DIGEST:]
    if sha256(content).digest() != data[:_DIGEST]:
        raise Damaged("the digest does not fit")
    with np.load(BytesIO(content), allow_pickle=False) as archive:
        return _value(json.loads(archive["tree"].tobytes()), archive.__getitem__)


def _tree(value: Any, arrays: dict[str, NDArray]) -> Any:
    """The value as JSON, its arrays moved out."""
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, np.ndarray) and value.dtype.kind in "biufc":
        name = f"array{len(arrays)}"
        arrays[name] = value
        return {"array": name}
    if isinstance(value, dict) and all(isinstance(name, str) for name in value):
        return {"mapping": {name: _tree(item, arrays) for name, item in value.items()}}
    if isinstance(value, tuple):
        return {"tuple": [_tree(item, arrays) for item in value]}
    module, name = type(value).__module__, type(value).__qualname__
    if not is_dataclass(value) or module.partition(".")[0] != HOME:
        raise TypeError(f"{module}.{name} cannot be kept on disk")
    content = {field.name: _tree(getattr(value, field.name), arrays) for field in fields(value) if field.init}
    return {"class": [module, name], "fields": content}


def _value(tree: Any, array: Callable[[str], NDArray]) -> Any:
    """The inverse of `_tree`."""
    if not isinstance(tree, dict):
        return tree
    if "array" in tree:
        return array(tree["array"])
    if "mapping" in tree:
        return {name: _value(item, array) for name, item in tree["mapping"].items()}
    if "tuple" in tree:
        return tuple(_value(item, array) for item in tree["tuple"])
    module, name = tree["class"]
    return getattr(import_module(module), name)(
        **{name: _value(item, array) for name, item in tree["fields"].items()}
    )
