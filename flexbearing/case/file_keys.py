"""Keys of a case that name a file next to it."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any


def value_at(tables: Any, key: str) -> Any:
    """What nested tables have at a dotted key; None where it is not given."""
    for name in key.split("."):
        tables = tables.get(name) if isinstance(tables, Mapping) else None
    return tables


def next_to(case: Path, names: Iterable[Any]) -> tuple[Path, ...]:
    """Files with some names next to a case; what is no name is left out."""
    return tuple(case.parent / name for name in names if isinstance(name, str))
