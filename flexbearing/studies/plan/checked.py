"""Variants that were checked, in little memory: what they share once, their numbers side by side."""

from array import array
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from types import NoneType
from typing import Any, overload

from flexbearing.studies.file.columns import Row
from flexbearing.studies.plan.identity import LENGTH
from flexbearing.studies.plan.task import Variant

Shared = tuple[tuple[str, ...], str]  # rings and name of the levels


class CheckedVariants(Sequence[Variant]):
    """Variants row by row; one that cannot be computed has no identity.

    Each takes 20 bytes and 8 for each number that its case has at a varied key.
    """

    def __init__(self, rows: Sequence[Row]):
        self._rows = rows
        self._identities = bytearray()
        self._shared: dict[Shared, int] = {}
        self._which = array("I")  # of what is shared
        self._in_si: tuple[_Column, ...] = ()
        self._impossible = array("Q")  # numbers of those without an identity, which are not stored
        self._count = 0

    def append(self, found: Variant | None) -> None:
        """Add the next variant; None where it cannot be computed."""
        if found is None:
            self._impossible.append(self._count)
        else:
            self._in_si = self._in_si or tuple(_Column() for _ in found.in_si)
            for column, value in zip(self._in_si, found.in_si, strict=True):
                column.append(value)
            self._identities += bytes.fromhex(found.identity)
            self._which.append(self._shared.setdefault((found.rings, found.levels), len(self._shared)))
        self._count += 1

    def rename(self, number: int, identity: str, levels: str) -> None:
        """Give a variant another identity and other levels."""
        place, size = self._place(number), LENGTH // 2
        rings = [*self._shared][self._which[place]][0]
        self._identities[place * size : (place + 1) * size] = bytes.fromhex(identity)
        self._which[place] = self._shared.setdefault((rings, levels), len(self._shared))

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, place: int) -> Variant: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Variant, ...]: ...
    def __getitem__(self, place: int | slice) -> Any:
        numbers, shared = range(self._count)[place], [*self._shared]
        if isinstance(numbers, int):
            return self._variant(numbers, self._rows[numbers], shared)
        return tuple(self._variant(number, self._rows[number], shared) for number in numbers)

    def __iter__(self) -> Iterator[Variant]:
        shared = [*self._shared]
        for number, row in enumerate(self._rows):
            yield self._variant(number, row, shared)

    def _variant(self, number: int, row: Row, shared: list[Shared]) -> Variant:
        place = self._place(number)
        if place is None:
            return Variant(row, "")
        first, size = place * LENGTH // 2, LENGTH // 2
        identity = self._identities[first : first + size].hex()
        rings, levels = shared[self._which[place]]
        return Variant(row, identity, rings, levels, tuple([column[place] for column in self._in_si]))

    def _place(self, number: int) -> int | None:
        """Among those that can be computed; None of one that cannot."""
        if not self._impossible:
            return number
        before = bisect_left(self._impossible, number)
        if before < len(self._impossible) and self._impossible[before] == number:
            return None
        return number - before


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


def _form(value: Any) -> tuple[type, int] | None:
    if type(value) is float:
        return float, 1
    if type(value) is tuple and value and all(type(number) is float for number in value):
        return tuple, len(value)
    return None
