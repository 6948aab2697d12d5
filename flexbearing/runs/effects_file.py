"""Effects of assumed inputs as data next to the case, with a digest of the case they were computed for."""

import json
from hashlib import sha256
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from typing import Any

from flexbearing import inputs
from flexbearing.case import BadCase, Head
from flexbearing.case.head import digests
from flexbearing.quantities.attributes import EFFECTS
from flexbearing.quantities.forms import TEXT, Record

ENDING = ".effects.json"
LARGEST = 10_000_000  # bytes
LEFT_OUT = "effects of assumed inputs were computed for other inputs and are left out"
_FORM = Record({"case": TEXT, "effects": EFFECTS})
_DIGITS = 6  # of stored numbers
_NO_INPUTS = {"title", "outputs", "report"}  # of a case: no effect depends on them


def name(case_file: Path) -> Path:
    """The file next to a case."""
    return case_file.with_suffix(ENDING)


def digest(case: Head) -> str:
    """Digest of all inputs, which of them are assumed, and the content of named files."""
    values = {key: value for key, value in case.to_json().items() if key not in _NO_INPUTS}
    values.get("life", {}).pop("required", None)  # with which results are only compared
    return sha256(f"{json.dumps(values)} {digests(case)}".encode()).hexdigest()[:32]


def content(case: Head, effects: dict[str, Any]) -> bytes:
    """Content of the file."""
    text = json.dumps({"case": digest(case), "effects": _rounded(effects)})
    return (text.replace('{"key"', '\n{"key"') + "\n").encode()  # a line for each key


def attributes(case: Head) -> dict[str, Any]:
    """Root attributes of a result by the file next to its case."""
    path = case.source.path
    if not (path and exists(place := name(Path(path)))):  # noqa: PTH110
        return {}
    found = _read(place)
    if found["case"] != digest(case):
        return {"effects_left_out": LEFT_OUT}
    return {"assumed_effects": found["effects"]}


def _read(place: Path) -> dict[str, Any]:
    try:
        found = json.loads(inputs.content(place, LARGEST))
    except (inputs.Unreadable, ValueError, RecursionError) as problem:
        raise BadCase(f"{place}: {_why(problem)}; delete it.") from problem
    if problem := next(_FORM.problems(found, "it"), ""):
        raise BadCase(f"{place}: is no file of effects: {problem}; delete it.")
    return found


def _why(problem: Exception) -> str:
    return str(problem) if isinstance(problem, inputs.Unreadable) else "is no JSON"


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _rounded(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_rounded(each) for each in value]
    return float(f"{value:.{_DIGITS}g}") if isinstance(value, float) else value
