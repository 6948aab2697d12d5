"""Frozen data of several cases as one: numbers that differ are columns (C, 1), all others stay numbers.

Columns broadcast against arrays (..., C, Z) as numbers do: physics written for one case holds for many.
"""

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import fields, is_dataclass
from functools import cache, partial
from types import FunctionType, NoneType
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Part = TypeVar("Part")
Number = float | NDArray
OTHERS = frozenset({int, bool, str, NoneType, FunctionType})  # types that hold no number, most of all values


def kind_and_numbers(part: Any) -> tuple[Hashable, list[float]]:
    """What must be equal in parts that stand side by side, and the numbers that may differ.

    Numbers are those of fields that are declared as such, at any depth. What is None, whole numbers, names,
    yes and no, arrays and functions belong to the kind. Fields that do not count in comparisons are left out.
    """
    kind: list[Hashable] = []
    numbers: list[float] = []
    _collect(part, kind, numbers)
    return tuple(kind), numbers


def kinds_and_numbers(parts: Sequence[Any]) -> tuple[set[Hashable], NDArray]:
    """The kinds of parts, one where they may stand side by side, and the numbers (C, n) of all; as above.

    Fields that several parts share as one object are looked into once.
    """
    known: dict[int, tuple[Any, tuple[Hashable, list[float]]]] = {}  # with the value, which keeps its id

    def inside(value: Any) -> tuple[Hashable, list[float]]:
        if id(value) not in known:
            known[id(value)] = value, kind_and_numbers((value,))
        return known[id(value)][1]

    kinds, rows = set(), []
    for part in parts:
        each = [inside(value) for value in _inside(part) or ()]
        kinds.add((type(part), *(kind for kind, _ in each)))
        rows.append([number for _, numbers in each for number in numbers])
    return kinds, np.array(rows)


def side_by_side(parts: Sequence[Part]) -> Part:
    """One part that stands for parts of one kind."""
    return with_columns(parts[0], np.array([kind_and_numbers(part)[1] for part in parts]))


def with_columns(part: Part, numbers: NDArray, own: NDArray | None = None) -> Part:
    """The same part with the numbers (C, n) of C parts of its kind, all of which have been checked.

    Its `own` numbers (n) are those of the first of them where nothing else is said.
    """
    differs = (numbers != (numbers[0] if own is None else own)).any(0)
    columns = iter([numbers[:, i, None] if differs[i] else None for i in range(len(differs))])

    def of_all(number: Number) -> Number:
        if isinstance(number, np.ndarray):
            return number
        column = next(columns)
        return number if column is None else column

    return _changed(part, of_all)


def stacked(*numbers: Number) -> NDArray:
    """Numbers or columns one above the other (n, 1, 1) or (n, C, 1)."""
    if any(isinstance(number, np.ndarray) for number in numbers):
        return np.stack(np.broadcast_arrays(*np.atleast_2d(*numbers)))
    return np.array(numbers)[:, None, None]  # the same, ten times faster


def joined(parts: Iterable[NDArray]) -> NDArray:
    """Arrays (..., n) one after the other along their last axis, some of them perhaps of many cases."""
    return np.concatenate(np.broadcast_arrays(*parts), axis=-1)


def columns_of(part: Any, cases: int) -> NDArray:
    """Numbers (C, n) that differ between the C cases of a part `with_columns`."""
    columns: list[NDArray] = []

    def found(number: Number) -> Number:
        if isinstance(number, np.ndarray) and number.shape == (cases, 1):
            columns.append(number[:, 0])
        return number

    _changed(part, found)
    return np.array(columns).T if columns else np.zeros((cases, 0))


def taken(part: Part, cases: NDArray) -> Part:
    """The same part for some of its cases; for a single one its columns become numbers.

    Columns may have further axes (..., C, 1). What has none stays the same object.
    """

    def of_some(number: Number) -> Number:
        if not isinstance(number, np.ndarray) or number.ndim < 2 or number.shape[-2] == 1:
            return number
        some = number[..., cases, :]
        return some.item() if some.size == 1 else some

    return _changed(part, of_some, OTHERS | {float})


def _collect(value: Any, kind: list[Hashable], numbers: list[float]) -> None:
    """Add what a value that is no number consists of."""
    if names := _names(type(value)):  # nearly always, and looked into without a list
        kind.append(type(value))
        stored = value.__dict__
        for name, declared in names.items():
            each = stored[name]
            _add(float(each) if declared and type(each) is int else each, kind, numbers)
        return
    inside = _inside(value)
    if inside is None:
        array = isinstance(value, np.ndarray)
        named = value is None or isinstance(value, str | int)
        kind.append((value.shape, value.tobytes()) if array else value if named else id(value))
        return
    kind.append((value.func, *value.keywords) if isinstance(value, partial) else type(value))
    kind.append(len(inside))
    for each in inside:
        _add(each, kind, numbers)


def _add(value: Any, kind: list[Hashable], numbers: list[float]) -> None:
    """Add a value."""
    if isinstance(value, float):
        kind.append(float)
        numbers.append(value)
    elif value is None:
        kind.append(value)
    else:
        _collect(value, kind, numbers)


def _changed(value: Any, change: Callable[[Number], Number], others: frozenset[type] = OTHERS) -> Any:
    """The same data with every number and array changed, but those of other types; the same where none is."""
    if isinstance(value, float | np.ndarray):
        return change(value)
    inside = _inside(value)
    if inside is None:
        return value
    changed = [each if type(each) in others else _changed(each, change, others) for each in inside]
    if all(new is old for new, old in zip(changed, inside, strict=True)):
        return value
    if isinstance(value, tuple):
        return tuple(changed)
    if isinstance(value, partial):
        return partial(value.func, *changed[0], **dict(zip(value.keywords, changed[1:], strict=True)))
    whole = object.__new__(type(value))
    whole.__dict__.update(zip(_names(type(value)) or (), changed, strict=True))
    return whole


def _inside(value: Any) -> list | None:
    """What tuples, functions with arguments and dataclasses consist of; None for anything else."""
    if isinstance(value, tuple):
        return list(value)
    if isinstance(value, partial):
        return [value.args, *value.keywords.values()]
    names = _names(type(value))
    if not names:
        return None if names is None else []
    stored = value.__dict__
    inside = [stored[name] for name in names]
    if int in map(type, inside):  # where a whole number stands for a number
        declared = names.values()
        inside = [
            float(each) if d and type(each) is int else each for each, d in zip(inside, declared, strict=True)
        ]
    return inside


@cache
def _names(kind: type) -> dict[str, bool] | None:
    """Names of the fields of a dataclass that count, and whether they are declared as numbers."""
    if not is_dataclass(kind):
        return None
    return {field.name: field.type not in (int, bool) for field in fields(kind) if field.compare}
