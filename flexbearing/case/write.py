"""From a case to the text of a file that reads as the same case."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from flexbearing.case.declarations import toml
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source
from flexbearing.case.read import with_settings
from flexbearing.case.text import tables

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def text(case: Head, families: Families) -> str:
    """Its file, letter by letter where no setting changed it, else its keys."""
    source = case.source
    if not source.overrides:
        return source.text
    raw = tables(source.text)
    with_settings(raw, Source(source.path, source.text, source.overrides), families)
    return "\n".join(lines(raw)) + "\n"


def lines(table: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    """Values of a table, then the tables in it."""
    for name, value in table.items():
        if not isinstance(value, Mapping):
            yield f"{_key(name)} = {toml(value)}"
    for name, value in table.items():
        if isinstance(value, Mapping):
            yield f"\n[{prefix}{_key(name)}]"
            yield from lines(value, f"{prefix}{_key(name)}.")


def _key(name: str) -> str:
    return name if _BARE.fullmatch(name) else toml(name)
