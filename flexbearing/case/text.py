"""From a file or a setting to TOML tables and values, within bounds: refusing takes no longer than checking.

tomllib takes time with the square of the parts of a key, and as many stack frames as arrays are in each
other; both are counted before.
"""

import re
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from datetime import date, datetime, time
from functools import lru_cache
from typing import Any

from flexbearing.inputs import Unreadable
from flexbearing.inputs.file import CASE as LARGEST
from flexbearing.printable import excerpt

DEEPEST = 8  # arrays and tables in each other, and parts of a key; the keys of a case have up to 4
LARGEST_INTEGER = 2**63  # as TOML says
_READ_BY = {"case": "run", "study": "study", "optimisation": "optimise"}  # kind of file to command

Plain = dict[str, Any] | list[Any] | str | int | float | bool | date | datetime | time

# Texts and comments, each to its end or to that of its line or of the file: no character is looked at twice.
_TEXT_OR_COMMENT = re.compile(
    r'"""(?:\\.|[^\\])*?(?:"{3,5}|\Z)'
    r"|'''.*?(?:'{3,5}|\Z)"
    r'|"(?:[^"\\\n]|\\[^\n])*"?'
    r"|'[^'\n]*'?"
    r"|\#[^\n]*",
    re.DOTALL,
)
_BETWEEN_KEYS = re.compile(r"[^\w.\- \t]")
_BRACKET = re.compile(r"[\[{\]}]")


def tables(text: str, of: str = "case") -> dict[str, Any]:
    """Tables of the text of a case file."""
    return deepcopy(_parsed(text, of))  # callers put settings into them


@lru_cache(maxsize=8)
def _parsed(text: str, of: str) -> dict[str, Any]:
    """The tables of a text that was read before, or reads now."""
    if len(text) > LARGEST:
        raise Unreadable(f"is longer than {LARGEST // 1024} KiB, which no {of} file is")
    if _deep(text):
        raise Unreadable(
            f"has arrays or tables more than {DEEPEST} deep, or a key of more than {DEEPEST} parts; "
            f"nothing in a {of} is so deep"
        )
    try:
        parsed = tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        what, _, place = str(problem).rpartition(" (")
        raise Unreadable(f"is not valid TOML: {excerpt(what)} ({place}") from None
    except ValueError as problem:  # Python reads no integers of more than 4300 digits
        raise Unreadable("is not valid TOML: an integer of thousands of digits") from problem
    if wrong := next(_not_plain(parsed, ""), None):
        raise Unreadable(wrong)
    if (found := _kind_of_file(parsed)) and of in _READ_BY and found != of:
        article = "an" if found == "optimisation" else "a"
        raise Unreadable(f"is {article} {found} file; flexbearing {_READ_BY[found]} computes it")
    return parsed


def command(text: str) -> str:
    """Name of the command that computes a file; that of cases where its text does not tell."""
    try:
        return _READ_BY[_kind_of_file(_parsed(text, "")) or "case"]
    except Unreadable:
        return _READ_BY["case"]


def _kind_of_file(parsed: dict[str, Any]) -> str | None:
    """What a file holds, from tables that no other kind of file has; none where this cannot be known."""
    if "bearing" in parsed:
        return "case"
    if "case" not in parsed:
        return None
    if "vary" in parsed:
        return "optimisation"
    return "study" if parsed.keys() & {"over", "sample", "duty"} else None


def setting_value(text: str) -> Any:
    """Value of a setting: that of TOML where it is one (20, true, "5 mm"), else the text itself.

    Raises `Unreadable` where it holds what no case can have.
    """
    try:
        parsed = None if _deep(text) else tomllib.loads(f"value = {text}")
    except ValueError:  # also integers of thousands of digits
        parsed = None
    given = parsed["value"] if parsed and set(parsed) == {"value"} else text
    if wrong := next(_not_plain(given, ""), None):
        raise Unreadable(wrong)
    return given


def _deep(text: str) -> bool:
    """Whether more than `DEEPEST` arrays or tables are in each other, or a key has more parts."""
    bare = _TEXT_OR_COMMENT.sub("x", text)
    if any(between.count(".") >= DEEPEST for between in _BETWEEN_KEYS.split(bare)):
        return True
    depth = 0
    for bracket in _BRACKET.finditer(bare):
        depth += 1 if bracket[0] in "[{" else -1
        if depth > DEEPEST:
            return True
    return False


def _not_plain(found: Plain, path: str) -> Iterator[str]:
    """What in a value cannot be stored or shown: characters that are no text, integers without end."""
    if isinstance(found, dict):
        for name, item in found.items():
            yield from _not_plain(name, path)
            yield from _not_plain(item, f"{path}.{name}" if path else name)
    elif isinstance(found, list):
        for item in found:
            yield from _not_plain(item, path)
    elif isinstance(found, str) and ("\0" in found or not _encodable(found)):
        yield f"{_at(path)}holds a character that is no text, in {excerpt(found)}"
    elif isinstance(found, int) and abs(found) >= LARGEST_INTEGER:
        yield f"{_at(path)}holds an integer of more than 64 bits; take a number with a point or fewer digits"


def _at(path: str) -> str:
    return f"{excerpt(path)} " if path else ""


def _encodable(text: str) -> bool:
    try:
        text.encode()
    except UnicodeEncodeError:  # surrogates, as of a command line that is not in UTF-8
        return False
    return True
