"""The table of a study, as its CSV file has it."""

import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from io import StringIO
from itertools import islice
from math import nan
from pathlib import Path

from flexbearing import inputs
from flexbearing.case.declarations import find
from flexbearing.case.family import Families
from flexbearing.findings import RowFinding
from flexbearing.findings.row import read as read_findings
from flexbearing.inputs.file import TABLE
from flexbearing.printable import one_line
from flexbearing.results import BadResult

PARQUET = ".parquet"
ENDS = ("status", "message", "findings", "seconds")
NOT_COMPUTED = (
    "not computed"  # status of a variant that is still to come, in the table of an interrupted study
)
SHARES = ("time_share", "revolution_share")  # of a duty cycle, no outputs
AT_ONCE = 10_000  # rows
MOST_ROWS = 2000  # that a browser still shows at once
HANDED_OUT = 20_000  # rows of the largest table that a page has inside; of others the first are read
_HEADING = re.compile(r"(?P<name>.*?)(?: \[(?P<unit>[^]]*)\])?")


def words(name: str) -> str:
    """Name of an output in words.

    >>> words("flexible.max_roller_load"), words("raceway_life.inner")
    ('max roller load, flexible', 'raceway life, inner')
    """
    block, point, rest = name.partition(".")
    behind = f"{rest}.{block}" if point and block in ("rigid", "flexible") else name
    return ", ".join(behind.replace("_", " ").split("."))


@dataclass(frozen=True)
class StudyColumn:
    """A column of a table."""

    heading: str
    name: str
    unit: str  # empty for texts and plain numbers
    texts: tuple[str, ...]  # as the file has them
    varied: bool  # whether it is a key of a case

    @cached_property
    def numbers(self) -> tuple[float, ...] | None:
        """Its numbers, NaN for an empty cell; None where a cell is no number, or all are empty."""
        try:
            found = tuple(float(text) if text else nan for text in self.texts)
        except ValueError:
            return None
        return found if any(self.texts) else None

    @cached_property
    def listed(self) -> bool:
        """Whether its cells are lists, such as the diameters of all rollers."""
        return any(text.startswith("[") for text in self.texts)

    @cached_property
    def distinct(self) -> list[str]:
        """Different cells, in their order."""
        return list(dict.fromkeys(self.texts))


@dataclass(frozen=True)
class StudyTable:
    """A table of a study."""

    place: Path
    text: str  # of the file; empty where it is too large for a page
    columns: tuple[StudyColumn, ...]  # of all rows, or of the first of a large table
    statuses: Sequence[str]  # of all rows
    messages: Sequence[str]
    findings: Sequence[tuple[RowFinding, ...]]

    @property
    def name(self) -> str:
        """Name of the study."""
        return self.place.stem

    def __len__(self) -> int:
        return len(self.columns[0].texts)

    @cached_property
    def to_come(self) -> int:
        """Variants that are not computed yet."""
        return self.statuses.count(NOT_COMPUTED)

    def first(self, rows: int) -> "StudyTable":
        """The first rows of it, or all."""
        if len(self) <= rows:
            return self
        return replace(self, columns=tuple(replace(c, texts=c.texts[:rows]) for c in self.columns))

    def column(self, name: str) -> StudyColumn | None:
        """Column by its name; None where there is none."""
        return next((column for column in self.columns if column.name == name), None)

    @property
    def axes(self) -> Sequence[StudyColumn]:
        """Varied keys with several values; lists have no place along an axis."""
        return [
            column
            for column in self.columns
            if column.varied and not column.listed and len(column.distinct) > 1
        ]

    @property
    def outputs(self) -> Sequence[StudyColumn]:
        """Columns of numbers that are neither keys nor how a row ended."""
        apart = (*ENDS, *SHARES)
        return [column for column in self.columns
                if not column.varied and column.name not in apart and column.numbers]  # fmt: skip


def read_table(place: Path, families: Families, most: int | None = None) -> StudyTable:
    """Read the table of a study, or its first rows.

    Raises `BadResult` where there is no such file, or it is no table of a study.
    """
    try:
        packed = place.suffix == PARQUET and most is None and _row_count(place) > HANDED_OUT
        text = table_text(place, MOST_ROWS if packed else most)
        lines = csv.reader(StringIO(text, newline=""), strict=True)
        head = next(lines)
        inputs.require_different(head)
        cells = _cells(islice(lines, most), len(head))
        _require_rows(head, cells)
        ends = _packed_ends(place) if packed else [cells[head.index(name)] for name in ENDS[:3]]
        statuses, messages, findings = ends
        known = {cell: read_findings(cell) for cell in {*findings}}
    except inputs.Unreadable as problem:
        raise BadResult(f"{place}: {problem}.") from problem
    except (ValueError, StopIteration, csv.Error) as problem:
        raise BadResult(f"{place}: is no table of a study: {one_line(problem)}.") from problem
    if len(statuses) > HANDED_OUT:
        text, cells = "", [column[:MOST_ROWS] for column in cells]
    columns = tuple(_columns(head, cells, families))
    return StudyTable(place, text, columns, statuses, messages, [known[cell] for cell in findings])


def _require_rows(head: list[str], cells: list[list[str]]) -> None:
    """Raises ValueError for a table without rows, or without the columns that every study has."""
    if not any(cells) or not set(ENDS) <= set(head):
        raise ValueError(f"it has no rows with {', '.join(ENDS)}")


def _row_count(place: Path) -> int:
    from flexbearing.report.html.parquet import row_count

    return row_count(place)


def _packed_ends(place: Path) -> list[list[str]]:
    from flexbearing.report.html.parquet import texts

    return texts(place, ENDS[:3])


def table_text(place: Path, most: int | None = None) -> str:
    """Text of a CSV file, or of one with the same table as a Parquet file, of its first rows at least.

    Raises `Unreadable` where the file cannot be read, also without the package that reads Parquet.
    """
    if place.suffix != PARQUET:
        return inputs.text(place, TABLE)
    from flexbearing.report.html.parquet import csv_text

    return csv_text(place, most)


def _cells(lines: Iterator[list[str]], count: int) -> list[list[str]]:
    """Cells column by column; some rows at once, whose equal cells are one text in memory."""
    columns: list[list[str]] = [[] for _ in range(count)]
    while some := [*islice(lines, AT_ONCE)]:
        texts: dict[str, str] = {}
        for column, cells in zip(columns, zip(*some, strict=True), strict=True):
            column += (texts.setdefault(cell, cell) for cell in cells)
    return columns


def _columns(head: list[str], cells: list[list[str]], families: Families) -> Iterator[StudyColumn]:
    """Columns with their units; varied keys come first."""
    varied = True
    for heading, texts in zip(head, cells, strict=True):
        parts = _HEADING.fullmatch(heading)
        name, unit = (parts["name"], parts["unit"] or "") if parts else (heading, "")
        varied = varied and _is_key(name, families)
        yield StudyColumn(heading, name, unit, tuple(texts), varied)


def _is_key(name: str, families: Families) -> bool:
    declared = (find(name, family.case()) for family in families.values())
    return any(found is not None and not (found.section and not found.choices) for found in declared)
