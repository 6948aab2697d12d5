"""The root attributes of a result file: which there are, and how each is stored."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from platform import python_version
from typing import Any, Literal

import h5py
import numpy as np

from flexbearing.results.checks import NotInLayout
from flexbearing.results.layout import FORMAT

STATUSES = ("converged", "iteration limit", "diverging", "stagnating", "not finite", "not solved")

Kind = Literal["text", "texts", "integer", "number", "json"]


@dataclass(frozen=True)
class Attribute:
    """One root attribute of the file."""

    name: str
    kind: Kind
    meaning: str
    rollers: bool = False  # only of roller bearings
    optional: bool = False  # absent where the case does not ask for it


ATTRIBUTES = (
    Attribute("format", "integer", f"number of this layout, {FORMAT}"),
    Attribute("kind", "text", "family of the bearing, as in the case"),
    Attribute("title", "text", "title of the case"),
    Attribute("status", "text", f"how the run ended: {', '.join(STATUSES)}"),
    Attribute("ending", "text", "how the last solve of the bearing itself ended; empty while it still ran"),
    Attribute("message", "text", "the ending in a sentence"),
    Attribute("method", "text", "method of the coupling", rollers=True),
    Attribute("iterations", "integer", "iterations of the coupling, 0 when no ring is flexible"),
    Attribute(
        "attempts",
        "json",
        "methods of the coupling in the order they were tried, with their ends",
        rollers=True,
    ),
    Attribute(
        "started_from",
        "text",
        "result of a neighbouring case whose flexible end state the coupling started from, or rigid raceways "
        "where that failed; absent where none was asked for",
        rollers=True,
        optional=True,
    ),
    Attribute("wall_time_s", "number", "time from case to result [s]"),
    Attribute("case_text", "text", "the case file, letter by letter"),
    Attribute("case_file", "text", "where the case file was; drawings lie beside it", optional=True),
    Attribute("case_overrides", "texts", "keys set on the command line, key=value"),
    Attribute("case_si", "json", "the whole case with its defaults, in SI units"),
    Attribute("versions", "json", "versions of the program and of what it stands on"),
    Attribute("assumed", "texts", "keys whose values are assumed, not known"),
    Attribute("calibrated", "json", "keys whose values were fitted, each to what"),
    Attribute("notes", "texts", "warnings: what left its range of validity"),
    Attribute(
        "clearance",
        "json",
        "operating clearance, with the steps that led to it when it was computed",
        rollers=True,
    ),
    Attribute(
        "life", "json", "factors of [life] with value and note, and the modified life; by block", rollers=True
    ),
    Attribute("regimes", "json", "lubrication regime of inner and outer raceway; by block", rollers=True),
    Attribute(
        "structure", "json", "figures of the finite elements: unknowns, seconds per stage", rollers=True
    ),
    Attribute(
        "stresses",
        "json",
        "largest stresses of the flexible parts at the end state, and the stiffness of their supports; "
        "absent without outputs.stresses",
        rollers=True,
        optional=True,
    ),
    Attribute(
        "choices",
        "json",
        "levels that accuracy.target led to, by choice: the level, whether the case fixes it, the level it "
        "was compared with, the changes found, the error over a change, and the error allowed; absent "
        "without a target",
        rollers=True,
        optional=True,
    ),
    Attribute(
        "error_estimate",
        "json",
        "estimated numerical errors of the flexible block, over the values but for the cage slip; the "
        "target, and whether it is met; absent without a target, empty where nothing could be estimated",
        rollers=True,
        optional=True,
    ),
    Attribute("created", "text", "time the run began, ISO 8601"),
)

BY_NAME = {entry.name: entry for entry in ATTRIBUTES}


ROLLER = "cylindrical_roller"


def attributes_of(kind: str) -> dict[str, Attribute]:
    """Root attributes of the file of one kind of bearing, by name."""
    return {entry.name: entry for entry in ATTRIBUTES if kind == ROLLER or not entry.rollers}


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


def encoded(name: str, value: Any) -> Any:
    """Store form of a value: what HDF5 is given.

    Parameters
    ----------
    name : str
        name of the attribute
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
    kind = BY_NAME[name].kind
    try:
        return _ENCODE[kind](value)
    except (TypeError, ValueError) as reason:
        raise NotInLayout(f"attribute {name} = {value!r} cannot be stored as {kind}: {reason}.") from reason


def decoded(name: str, stored: Any) -> Any:
    """Value as the program uses it, from what HDF5 stored.

    Parameters
    ----------
    name : str
        name of the attribute
    stored : any
        as h5py returns it

    Returns
    -------
    text, number, tuple of texts, or mapping
    """
    return _DECODE[BY_NAME[name].kind](stored)


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
