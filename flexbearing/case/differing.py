"""The keys by which two cases differ."""

from collections.abc import Iterator, Mapping
from typing import Any


def differing(one: Mapping[str, Any], other: Mapping[str, Any]) -> dict[str, tuple[Any, Any]]:
    """Compare two cases key by key."""
    first, second = (dict(_keys(case)) for case in (one, other))
    both = {key: (first.get(key), second.get(key)) for key in {**first, **second}}
    return {key: (a, b) for key, (a, b) in both.items() if a != b}


def _keys(case: Mapping[str, Any], section: str = "") -> Iterator[tuple[str, Any]]:
    """Every key of a case with its sections, and its value."""
    for name, value in case.items():
        if isinstance(value, Mapping):
            yield from _keys(value, f"{section}{name}.")
        else:
            yield f"{section}{name}", value
