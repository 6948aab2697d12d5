"""Effects of assumed inputs as data next to the case, with a digest of the case they were computed for."""

import json
from functools import lru_cache
from hashlib import sha256
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexbearing import inputs
from flexbearing.case import BadCase, Head
from flexbearing.case.head import digests
from flexbearing.quantities.attributes import EFFECTS
from flexbearing.quantities.forms import TEXT, Record

if TYPE_CHECKING:
    from flexbearing.results.attributes import Checked

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
    """Root attributes of a result by the file next to its case.

    Raises `BadCase` for a file that cannot be read, or holds no effects.
    """
    path = case.source.path
    if not (path and exists(place := name(Path(path)))):  # noqa: PTH110
        return {}
    try:
        of_case, effects = _understood(inputs.content(place, LARGEST))
    except (inputs.Unreadable, ValueError) as problem:
        raise BadCase(f"{place}: {problem}; delete it.") from problem
    return {"assumed_effects": effects} if of_case == digest(case) else {"effects_left_out": LEFT_OUT}


@lru_cache(maxsize=4)
def _understood(content: bytes) -> tuple[str, "Checked"]:
    """Digest and effects of a file; many runs have the same."""
    from flexbearing.results.attributes import Checked, plain  # loads h5py, which a new case does without

    try:
        found = json.loads(content)
    except (ValueError, RecursionError) as problem:
        raise ValueError("is no JSON") from problem
    if problem := _FORM.problem(found):
        raise ValueError(f"is no file of effects: it{problem}")
    return found["case"], Checked(plain(found["effects"]))


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _rounded(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_rounded(each) for each in value]
    return float(f"{value:.{_DIGITS}g}") if isinstance(value, float) else value
