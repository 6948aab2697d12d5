"""Effects of assumed inputs as data next to the case, with the inputs they were computed for."""

import json
from functools import lru_cache
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flexbearing import inputs
from flexbearing.case import BadCase, Head
from flexbearing.case.head import digests
from flexbearing.quantities.attributes import EFFECTS, OBJECT
from flexbearing.quantities.forms import TEXT, Record

if TYPE_CHECKING:
    from flexbearing.results.attributes import Checked

ENDING = ".effects.json"
LARGEST = 10_000_000  # bytes
LEFT_OUT = "effects of assumed inputs were computed for other inputs and are left out"
_FORM = Record({"case": OBJECT, "files": TEXT, "effects": EFFECTS})
_DIGITS = 6  # of stored numbers
_NO_INPUTS: dict[str, Any] = {  # of a case: no effect depends on them
    "title": True, "outputs": True, "report": True, "life": {"required"},
}  # fmt: skip


def name(case_file: Path) -> Path:
    """The file next to a case."""
    return case_file.with_suffix(ENDING)


def content(case: Head, effects: dict[str, Any]) -> bytes:
    """Content of the file."""
    text = json.dumps({"case": _inputs(case), "files": digests(case), "effects": _rounded(effects)})
    return (text.replace('{"key"', '\n{"key"') + "\n").encode()  # a line for each key


def attributes(case: Head) -> dict[str, Any]:
    """Root attributes of a result by the file next to its case.

    Raises `BadCase` for a file that cannot be read, or holds no effects.
    """
    path = case.source.path
    if not (path and exists(place := name(Path(path)))):  # noqa: PTH110
        return {}
    try:
        of_case, of_files, effects = _understood(inputs.content(place, LARGEST))
    except (inputs.Unreadable, ValueError) as problem:
        raise BadCase(f"{place}: {problem}; delete it.") from problem
    if of_files == digests(case) and unchanged(of_case, _inputs(case), _inputs(case, exclude_unset=True)):
        return {"assumed_effects": effects}
    return {"effects_left_out": LEFT_OUT}


def _inputs(case: Head, *, exclude_unset: bool = False) -> dict[str, Any]:
    """Values of the keys that effects depend on, of all or of those that are given."""
    return case.model_dump(mode="json", exclude=_NO_INPUTS, exclude_unset=exclude_unset)


def unchanged(stored: Any, now: Any, given: Any) -> bool:
    """Whether inputs are as stored; keys that are not, as they were declared later, must not be given."""
    if isinstance(stored, dict) and isinstance(now, dict):
        given = given or {}
        return given.keys() <= stored.keys() <= now.keys() and all(
            unchanged(value, now[key], given.get(key)) for key, value in stored.items()
        )
    if isinstance(stored, list) and isinstance(now, list):
        return len(stored) == len(now) and all(map(unchanged, stored, now, given or [None] * len(now)))
    return stored == now


@lru_cache(maxsize=4)
def _understood(content: bytes) -> tuple[dict[str, Any], str, "Checked"]:
    """Inputs, digests of files, and effects of a file; many runs have the same."""
    from flexbearing.results.attributes import Checked, plain  # loads h5py, which a new case does without

    try:
        found = json.loads(content)
    except (ValueError, RecursionError) as problem:
        raise ValueError("is no JSON") from problem
    if problem := _FORM.problem(found):
        raise ValueError(f"is no file of effects: it{problem}")
    return found["case"], found["files"], Checked(plain(found["effects"]))


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _rounded(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_rounded(each) for each in value]
    return float(f"{value:.{_DIGITS}g}") if isinstance(value, float) else value
