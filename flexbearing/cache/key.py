"""The name of a condensed ring: a digest of all that it was made from."""

import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

import fem

LAYOUT = 2  # of the file of an entry; those of another one are never looked for


def digest(parts: Any) -> str:
    """Name of what is computed from some data by the present code.

    Raises `TypeError` for data of any other kind: it could change without the name.
    """
    return sha256(json.dumps([LAYOUT, code(), _plain(parts)], sort_keys=True).encode()).hexdigest()


@cache
def code() -> str:
    """Digest of the finite element package and the version of its solver."""
    package = Path(fem.__path__[0])
    sources = sha256(version("ngsolve").encode())
    for source in sorted(package.rglob("*.py")):
        name = source.relative_to(package).as_posix()
        sources.update(name.encode() + b"\0" + source.read_bytes() + b"\0")
    return sources.hexdigest()


def _plain(value: Any) -> Any:
    """The value as JSON, such that different values stay different."""
    if value is None or isinstance(value, bool | str | int):
        return value
    if isinstance(value, float):
        return {"float": float(value).hex()}
    if isinstance(value, bytes):
        return {"bytes": sha256(value).hexdigest()}
    if isinstance(value, np.ndarray | np.generic):
        return _plain_array(np.asarray(value))
    return _plain_group(value)


def _plain_array(value: np.ndarray) -> Any:
    if value.dtype.kind not in "biufc":
        raise TypeError(f"an array of {value.dtype} cannot name a condensed ring")
    content = sha256(np.ascontiguousarray(value).tobytes()).hexdigest()
    return {"array": [value.dtype.str, value.shape, content]}


def _plain_group(value: Any) -> Any:
    if is_dataclass(value) and not isinstance(value, type):
        content = {field.name: _plain(getattr(value, field.name)) for field in fields(value) if field.compare}
        return {f"{type(value).__module__}.{type(value).__qualname__}": content}
    if isinstance(value, Mapping):
        return {"mapping": sorted([json.dumps(_plain(name)), _plain(item)] for name, item in value.items())}
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    raise TypeError(f"{type(value).__name__} cannot name a condensed ring")
