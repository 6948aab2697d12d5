"""How each kind of root attribute is stored in a result file."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from platform import python_version
from typing import Any

import h5py
import numpy as np

from flexbearing.quantities.attributes import FORMAT, STATUSES, Kind
from flexbearing.results.checks import NotInLayout


def stamp() -> dict[str, Any]:
    """Attributes that every file carries without being asked: format, time, versions.

    Returns
    -------
    dict
        name to value
    """
    packages = ("numpy", "scipy", "ngsolve", "h5py", "flexbearing")
    return {
        "format": FORMAT,
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
        "versions": {"python": python_version(), **{name: _version(name) for name in packages}},
    }


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


def encoded(name: str, kind: Kind, value: Any) -> Any:
    """Store form of a value: what HDF5 is given.

    Parameters
    ----------
    name : str
        name of the attribute
    kind : "text", "texts", "integer", "number" or "json"
        how it is stored
    value : text, number, list of texts or mapping
        what its kind asks for

    Returns
    -------
    text, number or array of texts

    Raises
    ------
    NotInLayout
        for a value of another kind, or a status that does not exist
    """
    if name == "status" and value not in STATUSES:
        raise NotInLayout(f"status {value!r} does not exist; it is one of: {', '.join(STATUSES)}.")
    try:
        return _ENCODE[kind](value)
    except (TypeError, ValueError) as reason:
        raise NotInLayout(f"attribute {name} = {value!r} cannot be stored as {kind}: {reason}.") from reason


def decoded(kind: Kind, stored: Any) -> Any:
    """Value as the program uses it, from what HDF5 stored.

    Parameters
    ----------
    kind : "text", "texts", "integer", "number" or "json"
        how it is stored
    stored : any
        as h5py returns it

    Returns
    -------
    text, number, tuple of texts, or mapping
    """
    return _DECODE[kind](stored)


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError("a text is wanted")
    return value


def _texts(value: Sequence[str]) -> np.ndarray:
    if isinstance(value, str):
        raise TypeError("a list of texts is wanted, not a single one")
    return np.array([_text(item) for item in value], dtype=h5py.string_dtype())


def _integer(value: Any) -> int:
    if isinstance(value, bool) or int(value) != value:
        raise TypeError("a whole number is wanted")
    return int(value)


def _number(value: Any) -> float:
    if not math.isfinite(value):
        raise ValueError("a finite number is wanted")
    return float(value)


def _json(value: Mapping[str, Any]) -> str:
    if not isinstance(value, Mapping):
        raise TypeError("a mapping is wanted; it becomes JSON when it is stored")
    return json.dumps(dict(value), allow_nan=False, default=_python_number)


def _python_number(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} has no JSON form")


_ENCODE: dict[Kind, Callable[[Any], Any]] = {
    "text": _text,
    "texts": _texts,
    "integer": _integer,
    "number": _number,
    "json": _json,
}
_DECODE: dict[Kind, Callable[[Any], Any]] = {
    "text": str,
    "texts": lambda stored: tuple(str(item) for item in stored),
    "integer": int,
    "number": float,
    "json": json.loads,
}
