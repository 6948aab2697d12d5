"""How each kind of root attribute is stored in a result file."""

import json
import math
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from platform import machine, node, platform, python_version
from typing import Any

import numpy as np

from flexbearing.printable import printable
from flexbearing.program.threads import cores
from flexbearing.quantities.attributes import FORMAT, STATUSES, Attribute, Kind
from flexbearing.results.checks import NotInLayout

DEEPEST = 20  # levels of a record
LARGEST = 1e300  # number in a record


def stamp() -> dict[str, Any]:
    """Attributes that every file carries without being asked: format, time, machine, versions."""
    packages = ("numpy", "scipy", "ngsolve", "h5py", "flexbearing")
    return {
        "format": FORMAT,
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
        "machine": {"host": printable(node()), "processor": machine(), "cores": cores(), **_origin()},
        "versions": {"python": python_version(), **{name: _version(name) for name in packages}},
    }


@lru_cache
def _version(package: str) -> str:
    try:
        found = distribution(package)
    except PackageNotFoundError:
        return "not installed"
    about = found.read_text("METADATA") or ""  # to read all of it as a message takes longer
    return about.partition("\nVersion: ")[2].partition("\n")[0] or found.version


@lru_cache
def _origin() -> dict[str, str]:
    """Operating system, and the revision of the program's source where one is known."""
    revision = _revision()
    return {"system": printable(platform(terse=True)), **({"revision": revision} if revision else {})}


def _revision() -> str:
    """Commit that the program was installed from, or that its repository has checked out; else empty."""
    try:
        installed = json.loads(distribution("flexbearing").read_text("direct_url.json") or "{}")
    except PackageNotFoundError:
        installed = {}
    if commit := installed.get("vcs_info", {}).get("commit_id"):
        return str(commit)
    source = Path(__file__).parents[2]
    if not (source / ".git").exists():
        return ""
    command = ["git", "-C", str(source), "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"]
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=5, check=True).stdout.strip()
    except (OSError, subprocess.SubprocessError):  # no git, or a repository of somebody else
        return ""


def checked(entry: Attribute, value: Any) -> Any:
    """Value as the program uses it, from what a run says.

    Raises `NotInLayout` for a value of another kind or form, or a status that does not exist.
    """
    if isinstance(value, Checked):
        return value.value
    try:
        return _of_form(entry, _CHECKED[entry.kind](value))
    except (TypeError, ValueError) as reason:
        raise NotInLayout(
            f"attribute {entry.name} = {value!r} cannot be stored as {entry.kind}: {reason}."
        ) from reason


def encoded(entry: Attribute, value: Any) -> Any:
    """Store form of a checked value: what HDF5 is given.

    Raises `NotInLayout` for texts that are too long to be read again.
    """
    if entry.kind in ("json", "records"):
        value = json.dumps(value, allow_nan=False)
    stored = list(value) if entry.kind == "texts" else value
    _require_readable(entry, stored)
    return stored


def decoded(entry: Attribute, stored: Any) -> Any:
    """Value as the program uses it, from what HDF5 stored.

    Raises `NotInLayout` for another kind of value, JSON that is none or of another form, or a status that
    does not exist.
    """
    if not isinstance(stored, _STORED[entry.kind]):
        raise NotInLayout(f"attribute {entry.name} is not stored as {entry.kind}.")
    _require_readable(entry, stored)
    try:
        if entry.kind in ("json", "records"):
            return _of_form(entry, plain(json.loads(stored, parse_constant=_no_number)))
        return _of_form(entry, tuple(stored) if entry.kind == "texts" else stored)
    except (ValueError, RecursionError) as reason:
        raise NotInLayout(f"attribute {entry.name} is not of its form: {reason}.") from reason


def empty(kind: Kind) -> Any:
    """Value of an attribute that is not known yet."""
    return {"text": "", "texts": [], "integer": 0, "number": 0.0, "json": {}, "records": []}[kind]


def _require_readable(entry: Attribute, stored: Any) -> None:
    """Raise for texts that are longer than a reader accepts."""
    texts = stored if isinstance(stored, list) else [stored] if isinstance(stored, str) else []
    length = sum(map(len, texts))
    if length > entry.longest:
        raise NotInLayout(
            f"attribute {entry.name} has {length} characters; {entry.longest} is the most that it may have."
        )


def _of_form(entry: Attribute, value: Any) -> Any:
    """The value; raises for a status that does not exist, NaN, infinities, records of another form."""
    if entry.name == "status" and value not in STATUSES:
        raise NotInLayout(f"status {value!r:.40} does not exist; it is one of: {', '.join(STATUSES)}.")
    if isinstance(value, float) and not math.isfinite(value):
        raise NotInLayout(f"attribute {entry.name} = {value} is not finite.")
    if entry.kind in ("json", "records") and (problem := entry.form.problem(value)):
        raise ValueError(f"{entry.name}{problem}")
    return value


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError("a text is wanted")
    return value


def _texts(value: Sequence[str]) -> tuple[str, ...]:
    if isinstance(value, str):
        raise TypeError("a list of texts is wanted, not a single one")
    return tuple(_text(item) for item in value)


def _integer(value: Any) -> int:
    if isinstance(value, bool) or int(value) != value:
        raise TypeError("a whole number is wanted")
    return int(value)


def _number(value: Any) -> float:
    if not math.isfinite(value):
        raise ValueError("a finite number is wanted")
    return float(value)


def _json(value: Mapping[str, Any]) -> Any:
    if not isinstance(value, Mapping):
        raise TypeError("a mapping is wanted; it becomes JSON when it is stored")
    return plain(value)


def _records(value: Sequence[Mapping[str, Any]]) -> Any:
    if isinstance(value, str | Mapping):
        raise TypeError("a list of records is wanted")
    return [plain(dict(record)) for record in value]


@dataclass(frozen=True)
class Checked:
    """A value of an attribute that was checked before, and that nobody changes."""

    value: Any


def plain(value: Any, depth: int = DEEPEST) -> Any:
    """Python's own numbers, lists and dicts; raises for what readers of JSON would stumble over."""
    kind = type(value)
    if kind is float or kind is int:
        return _finite(value)
    if kind is dict or kind is list:  # most of all: nothing else is asked of them
        return _nested(value, depth)
    if isinstance(value, str):
        value.encode()  # half a pair of UTF-16 is no text
        return str.__str__(value)
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist(), depth)
    if value is None or isinstance(value, bool):
        return value
    return _finite(value) if isinstance(value, int | float) else _nested(value, depth)


def _nested(value: Any, depth: int) -> Any:
    if depth == 0:
        raise ValueError(f"it is nested deeper than {DEEPEST} levels")
    if isinstance(value, Mapping):
        return {plain(_text(name)): plain(item, depth - 1) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item, depth - 1) for item in value]
    raise TypeError(f"{type(value).__name__} has no JSON form")


def _finite(number: float) -> float:
    if not -LARGEST <= number <= LARGEST:
        raise ValueError(f"a number is not finite, or larger than {LARGEST:g}")
    return number


def _no_number(text: str) -> Any:
    raise ValueError(f"{text} is no number of JSON")


_CHECKED: dict[Kind, Callable[[Any], Any]] = {
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
