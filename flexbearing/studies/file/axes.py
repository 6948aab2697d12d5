"""Along what a study varies: each axis holds keys whose values belong together; axes are crossed."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

from flexbearing.case.as_written import rated_apart
from flexbearing.case.declarations import Declaration
from flexbearing.studies.file.columns import Row, Zipped
from flexbearing.studies.file.rows import rows
from flexbearing.studies.file.values import MOST, BadValues, count, values

TOGETHER, OF_FILE = "variant", "row"  # names of axes of several keys


@dataclass(frozen=True)
class Axis:
    """Keys whose values change together, and what they are one after the other."""

    name: str  # the key, where there is one
    keys: tuple[str, ...]
    rows: Sequence[Row]  # a value for each key, in the words of a case file


def axes(
    over: Mapping[str, Any], *, zipped: bool, table: Path | None, find: Callable[[str], Declaration]
) -> tuple[Axis, ...]:
    """Axes of the table [over]; raises `BadValues` naming the key."""
    found = [Axis(OF_FILE, *rows(table, lambda key: find(key).kind is not None))] if table else []
    if not zipped:
        _require_few(prod(map(count, over.values())))
    columns = columns_of(over, find)
    if zipped and columns:
        constant = [key for key, column in columns.items() if len(column) == 1]
        _require_rated_together(constant, [key for key in columns if key not in constant])
        found.append(together(columns, TOGETHER))
    elif columns:
        found += [Axis(key, (key,), Zipped((column,), len(column))) for key, column in columns.items()]
    return tuple(found)


def columns_of(given: Mapping[str, Any], find: Callable[[str], Declaration]) -> dict[str, Sequence[Any]]:
    """Values of varied keys, one after the other.

    Raises `BadValues` naming the key.
    """
    columns: dict[str, Sequence[Any]] = {}
    for key, text in given.items():
        declaration = find(key)
        try:
            columns[key] = values(text, declaration)
        except BadValues as problem:
            raise BadValues(f"{key} {problem}") from None
    return columns


def together(columns: Mapping[str, Sequence[Any]], name: str) -> Axis:
    """One axis of all keys.

    Raises `BadValues` where the numbers of values differ.
    """
    lengths = {key: len(column) for key, column in columns.items() if len(column) > 1}
    if len({*lengths.values()}) > 1:
        lengths_of_keys = ", ".join(f"{key} has {length}" for key, length in lengths.items())
        raise BadValues(f"needs as many values of every key: {lengths_of_keys}")
    count = max(lengths.values(), default=1)
    return Axis(name, tuple(columns), Zipped(tuple(columns.values()), count))


def require_crossable(found: Sequence[Axis]) -> None:
    """Refuse axes that vary a key twice, have too many variants together, or rate what others vary.

    Raises `BadValues` naming the key or the number.
    """
    keys = [key for axis in found for key in axis.keys]
    for key in keys:
        if keys.count(key) > 1:
            raise BadValues(f"{key} is varied twice")
    _require_few(prod(len(axis.rows) for axis in found))
    for axis in found:
        others = (key for other in found if other is not axis and len(other.rows) > 1 for key in other.keys)
        _require_rated_together(axis.keys, others)


def _require_rated_together(rated: Iterable[str], varied: Iterable[str]) -> None:
    if why := rated_apart(rated, varied):
        raise BadValues(why)


def _require_few(variants: int) -> None:
    if variants > MOST:
        raise BadValues(f"gives {variants} variants; a study has at most {MOST}")
