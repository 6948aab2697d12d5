"""Values of keys row by row: numbers side by side in memory, words made of them where a row is read."""

from abc import abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import repeat
from math import prod
from typing import Any, overload

from numpy.typing import NDArray

FEW = 1000  # rows of an axis whose words are made once for all rows of the others
Row = tuple[Any, ...]  # a value for each key, in the words of a case file


@dataclass(frozen=True, eq=False)
class Written(Sequence[Any]):
    """Numbers (N), or lists of them (N, W), each written in the words of a case file."""

    numbers: NDArray
    written: Callable[[Any], Any]

    def __len__(self) -> int:
        return len(self.numbers)

    @overload
    def __getitem__(self, place: int) -> Any: ...
    @overload
    def __getitem__(self, place: slice) -> Sequence[Any]: ...
    def __getitem__(self, place: int | slice) -> Any:
        if isinstance(place, slice):
            return Written(self.numbers[place], self.written)
        return self.written(self.numbers[place].tolist())


class MadeRows(Sequence[Row]):
    """Rows that are made where they are read."""

    @abstractmethod
    def _row(self, number: int) -> Row: ...

    @overload
    def __getitem__(self, place: int) -> Row: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Row, ...]: ...
    def __getitem__(self, place: int | slice) -> Any:
        numbers = range(len(self))[place]
        return self._row(numbers) if isinstance(numbers, int) else tuple(map(self._row, numbers))


@dataclass(frozen=True, eq=False)
class Zipped(MadeRows):
    """Columns side by side; one of a single value has it in every row."""

    columns: tuple[Sequence[Any], ...]
    count: int  # rows

    def __len__(self) -> int:
        return self.count

    def _row(self, number: int) -> Row:
        return tuple(column[number if len(column) > 1 else 0] for column in self.columns)

    def __iter__(self) -> Iterator[Row]:
        full = (column if len(column) > 1 else repeat(column[0], self.count) for column in self.columns)
        return zip(*full, strict=True)


@dataclass(frozen=True, eq=False)
class Crossed(MadeRows):
    """Every combination of rows of several axes, those of the last one change fastest."""

    axes: tuple[Sequence[Row], ...]

    def __len__(self) -> int:
        return prod(map(len, self.axes))

    def _row(self, number: int) -> Row:
        found: Row = ()
        for rows in reversed(self.axes):
            number, place = divmod(number, len(rows))
            found = (*rows[place], *found)
        return found

    def __iter__(self) -> Iterator[Row]:
        return _crossed([rows if len(rows) > FEW else tuple(rows) for rows in self.axes])


def _crossed(axes: Sequence[Sequence[Row]]) -> Iterator[Row]:
    if not axes:
        yield ()
        return
    *before, last = axes
    for first in _crossed(before):
        for row in last:
            yield (*first, *row)
