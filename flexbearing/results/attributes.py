"""How each kind of root attribute is stored in a result file."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from platform import python_version
from typing import Any

import numpy as np

from flexbearing.quantities.attributes import FORMAT, STATUSES, Attribute, Kind
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


def encoded(entry: Attribute, value: Any) -> Any:
    """Store form of a value: what HDF5 is given.

    Parameters
    ----------
    entry : Attribute
        what the layout says of it
    value : text, number, list of texts or mapping
        what its kind asks for

    Returns
    -------
    text, number or list of texts

    Raises
    ------
    NotInLayout
        for a value of another kind, or a status that does not exist
    """
    name, kind = entry.name, entry.kind
    if name == "status" and value not in STATUSES:
        raise NotInLayout(f"status {value!r} does not exist; it is one of: {', '.join(STATUSES)}.")
    try:
        return _ENCODE[kind](value)
    except (TypeError, ValueError) as reason:
        raise NotInLayout(f"attribute {name} = {value!r} cannot be stored as {kind}: {reason}.") from reason


def decoded(entry: Attribute, stored: Any) -> Any:
    """Value as the program uses it, from what HDF5 stored.

    Parameters
    ----------
    entry : Attribute
        what the layout says of it
    stored : any
        text, number or list of texts, as it stands in the file

    Returns
    -------
    text, number, tuple of texts, or mapping

    Raises
    ------
    NotInLayout
        for another kind of value, JSON that is none, or a status that does not exist
    """
    if not isinstance(stored, _STORED[entry.kind]):
        raise NotInLayout(f"attribute {entry.name} is not stored as {entry.kind}.")
    if entry.name == "status" and stored not in STATUSES:
        raise NotInLayout(f"status {stored!r} does not exist; it is one of: {', '.join(STATUSES)}.")
    try:
        return _DECODE[entry.kind](stored)
    except (ValueError, RecursionError) as reason:
        raise NotInLayout(f"attribute {entry.name} holds no JSON ({reason}).") from reason


def empty(kind: Kind) -> Any:
    """Value of an attribute that is not known yet.

    Parameters
    ----------
    kind : "text", "texts", "integer", "number" or "json"
        how it is stored

    Returns
    -------
    empty text, list or mapping, or zero
    """
    return {"text": "", "texts": [], "integer": 0, "number": 0.0, "json": {}}[kind]


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError("a text is wanted")
    return value


def _texts(value: Sequence[str]) -> list[str]:
    if isinstance(value, str):
        raise TypeError("a list of texts is wanted, not a single one")
    return [_text(item) for item in value]


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


def _mapping(stored: str) -> Mapping[str, Any]:
    value = json.loads(stored)
    if not isinstance(value, Mapping):
        raise ValueError("a mapping is wanted")
    return value


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
    "texts": tuple,
    "integer": int,
    "number": float,
    "json": _mapping,
}
_STORED: dict[Kind, type] = {"text": str, "texts": list, "integer": int, "number": float, "json": str}
