"""How each kind of root attribute is stored in a result file."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, version
from platform import python_version
from typing import Any

import numpy as np

from flexbearing.quantities.attributes import FORMAT, STATUSES, Attribute, Kind
from flexbearing.results.checks import NotInLayout

DEEPEST = 20  # levels of a record
LARGEST = 1e300  # number in a record


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


@lru_cache
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
    value : text, number, list of texts, mapping or list of mappings
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
    try:
        stored = _ENCODE[kind](value)
        _require_stored(entry, stored)
        if kind in ("json", "records"):
            _record(entry, stored)
    except NotInLayout:
        raise
    except (TypeError, ValueError) as reason:
        raise NotInLayout(f"attribute {name} = {value!r} cannot be stored as {kind}: {reason}.") from reason
    return stored


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
    text, number, tuple of texts, mapping, or list of mappings

    Raises
    ------
    NotInLayout
        for another kind of value, JSON that is none or of another form, or a status that does not exist
    """
    _require_stored(entry, stored)
    if entry.kind not in ("json", "records"):
        return tuple(stored) if entry.kind == "texts" else stored
    try:
        return _record(entry, stored)
    except (ValueError, RecursionError) as reason:
        raise NotInLayout(f"attribute {entry.name} is not of its form: {reason}.") from reason


def empty(kind: Kind) -> Any:
    """Value of an attribute that is not known yet.

    Parameters
    ----------
    kind : "text", "texts", "integer", "number", "json" or "records"
        how it is stored

    Returns
    -------
    empty text, list or mapping, or zero
    """
    return {"text": "", "texts": [], "integer": 0, "number": 0.0, "json": {}, "records": []}[kind]


def _require_stored(entry: Attribute, stored: Any) -> None:
    """Raise for another kind, a status that does not exist, NaN, infinities, texts beyond reading."""
    if not isinstance(stored, _STORED[entry.kind]):
        raise NotInLayout(f"attribute {entry.name} is not stored as {entry.kind}.")
    if entry.name == "status" and stored not in STATUSES:
        raise NotInLayout(f"status {stored!r:.40} does not exist; it is one of: {', '.join(STATUSES)}.")
    if isinstance(stored, float) and not math.isfinite(stored):
        raise NotInLayout(f"attribute {entry.name} = {stored} is not finite.")
    length = (
        sum(map(len, stored)) if isinstance(stored, list) else len(stored) if isinstance(stored, str) else 0
    )
    if length > entry.longest:
        raise NotInLayout(
            f"attribute {entry.name} has {length} characters; {entry.longest} is the most that it may have."
        )


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


def _records(value: Sequence[Mapping[str, Any]]) -> str:
    if isinstance(value, str | Mapping):
        raise TypeError("a list of records is wanted")
    return json.dumps([dict(record) for record in value], allow_nan=False, default=_python_number)


def _record(entry: Attribute, stored: str) -> Any:
    """The record, or list of records, that a text holds, of the form that the layout asks for."""
    value = json.loads(stored, parse_constant=_no_number)
    _require_plain(value, DEEPEST)
    if problem := next(entry.form.problems(value, entry.name), None):
        raise ValueError(problem)
    return value


def _no_number(text: str) -> Any:
    raise ValueError(f"{text} is no number of JSON")


def _require_plain(value: Any, depth: int) -> None:
    """Raise for what every reader of a record would stumble over, whatever its form."""
    if isinstance(value, str):
        value.encode()  # half a pair of UTF-16 is no text
    elif isinstance(value, int | float):
        if not -LARGEST <= value <= LARGEST:
            raise ValueError(f"a number is larger than {LARGEST:g}")
    elif value is not None:
        if depth == 0:
            raise ValueError(f"it is nested deeper than {DEEPEST} levels")
        for item in (*value, *value.values()) if isinstance(value, dict) else value:
            _require_plain(item, depth - 1)


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
    "records": _records,
}
_STORED: dict[Kind, Any] = {
    "text": str,
    "texts": list,
    "integer": int,
    "number": float,
    "json": str,
    "records": str,
}
