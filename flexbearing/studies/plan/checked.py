"""Variants that were checked, in little memory: what they share once, their numbers side by side."""

from array import array
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from types import NoneType
from typing import Any, overload

from flexbearing.studies.file.columns import Row
from flexbearing.studies.plan.task import LENGTH, Idle, Variant

Shared = tuple[tuple[str, ...], str, Idle | None, str]  # rings, name of the levels, whether idle or thin


class CheckedVariants(Sequence[Variant]):
    """Variants row by row; one that cannot be computed has no identity.

    Each takes 20 bytes, and 8 for each number of its case that is not the one of its row, as of another unit.
    """

    def __init__(self, rows: Sequence[Row]):
        self._rows = rows
        self._identities = bytearray()
        self._numbers: dict[Shared, int] = {}  # of what is shared
        self._shared: list[Shared] = []
        self._which = array("I")  # of these numbers
        self._in_si: list[_Column | None] = []  # None of a key whose values are those of the rows
        self._impossible = array("Q")  # numbers of those without an identity, which are not stored
        self._count = 0

    def append(self, found: Variant | None) -> None:
        """Add the next variant; None where it cannot be computed."""
        if found is None:
            self._impossible.append(self._count)
        else:
            self._in_si = self._in_si or [None] * len(found.in_si)
            for key, value in enumerate(found.in_si):
                self._add(key, value, found.values[key])
            self._identities += bytes.fromhex(found.identity)
            self._which.append(self._number_of((found.rings, found.levels, found.idle, found.thin)))
        self._count += 1

    def _add(self, key: int, value: Any, written: Any) -> None:
        column = self._in_si[key]
        if column is None and not _same(value, _plain(written)):
            column = self._in_si[key] = _Column()
            for number, row in zip(range(self._count), self._rows, strict=False):
                if self._is_possible(number):
                    column.append(_plain(row[key]))
        if column is not None:
            column.append(value)

    def rename(self, number: int, identity: str, levels: str) -> None:
        """Give a variant another identity and other levels."""
        place, size = self._place(number), LENGTH // 2
        rings, _, idle, thin = self._shared[self._which[place]]
        self._identities[place * size : (place + 1) * size] = bytes.fromhex(identity)
        self._which[place] = self._number_of((rings, levels, idle, thin))

    def _number_of(self, shared: Shared) -> int:
        if shared not in self._numbers:
            self._numbers[shared] = len(self._shared)
            self._shared.append(shared)
        return self._numbers[shared]

    @property
    def have_levels(self) -> bool:
        """Whether any of them share levels."""
        return any(levels for _, levels, *_ in self._shared)

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, place: int) -> Variant: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Variant, ...]: ...
    def __getitem__(self, place: int | slice) -> Any:
        numbers = range(self._count)[place]
        if isinstance(numbers, int):
            return self._variant(numbers, self._rows[numbers])
        return tuple(self._variant(number, self._rows[number]) for number in numbers)

    def identity(self, number: int) -> str:
        """The identity of a variant that can be computed, whose row is not made."""
        place, size = self._place(number), LENGTH // 2
        return self._identities[place * size : (place + 1) * size].hex()

    def __iter__(self) -> Iterator[Variant]:
        for number, row in zip(range(self._count), self._rows, strict=False):
            yield self._variant(number, row)

    def _variant(self, number: int, row: Row) -> Variant:
        if self._impossible and not self._is_possible(number):
            return Variant(row, "")
        rings, levels, idle, thin = self._shared[self._which[self._place(number)]]
        in_si = [
            _plain(row[key]) if column is None else column[self._place(number)]
            for key, column in enumerate(self._in_si)
        ]
        return Variant(row, self.identity(number), rings, levels, tuple(in_si), idle, thin)

    def _is_possible(self, number: int) -> bool:
        before = bisect_left(self._impossible, number)
        return before == len(self._impossible) or self._impossible[before] != number

    def _place(self, number: int) -> int:
        """Of a variant among those that can be computed."""
        return number - bisect_left(self._impossible, number) if self._impossible else number


class _Column:
    """Values of a key: floats and tuples of as many floats side by side, of other kinds one by one."""

    def __init__(self) -> None:
        self._form: tuple[type, int] | None = None  # float, or tuple and its length; None of other values
        self._numbers, self._others = array("d"), list[Any]()
        self._same: dict[tuple[type, Any], Any] = {}

    def append(self, value: Any) -> None:
        form = _form(value)
        if not (self._numbers or self._others):
            self._form = form
        elif form != self._form and self._form is not None:
            self._others = [self[place] for place in range(len(self._numbers) // self._form[1])]
            self._form, self._numbers = None, array("d")
        if self._form is None:
            plain = isinstance(value, str | int | NoneType)
            self._others.append(self._same.setdefault((type(value), value), value) if plain else value)
        elif self._form[0] is float:
            self._numbers.append(value)
        else:
            self._numbers.extend(value)

    def __getitem__(self, place: int) -> Any:
        if self._form is None:
            return self._others[place]
        kind, width = self._form
        return (
            self._numbers[place]
            if kind is float
            else tuple(self._numbers[place * width : (place + 1) * width])
        )


def _plain(written: Any) -> Any:
    """The number of a value in the words of a case file, in any unit; the value itself without one."""
    if isinstance(written, list):
        return tuple(map(_plain, written))
    if not isinstance(written, str):
        return written
    try:
        return float(written.partition(" ")[0])
    except ValueError:
        return written


def _same(one: Any, other: Any) -> bool:
    if type(one) is not type(other):
        return False
    return len(one) == len(other) and all(map(_same, one, other)) if type(one) is tuple else one == other


def _form(value: Any) -> tuple[type, int] | None:
    if type(value) is float:
        return float, 1
    if type(value) is tuple and value and all(type(number) is float for number in value):
        return tuple, len(value)
    return None
