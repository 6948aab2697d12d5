"""Sections of a page of text: tables with a title, and lists of lines."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from flexbearing.findings.words import of_note
from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import document
from flexbearing.report.html.document import Cell, Number

_ASCII = str.maketrans(
    {"µ": "u", "°": "deg", "–": "-", "±": "+-", "·": " ", "²": "^2", "³": "^3", "⁶": "^6", "∞": "inf"}
)  # signs of the HTML page, for a terminal of any encoding


_BEGIN = {"", *"+-0123456789"}  # what numbers begin with


def titled(title: str, table: document.Table | None) -> Iterator[RenderableType]:
    """A table of a report below its title; nothing without rows."""
    if table is None or not table.rows:
        return
    if title:
        yield Text(title, style="bold")
    shown = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1, 0, 0))
    for place, (head, *cells) in enumerate(zip(table.head, *table.rows, strict=True)):
        heading, texts = head.translate(_ASCII), [plain(cell) for cell in cells]
        numbers = place > 0 and all(text[:1] in _BEGIN for text in texts)
        shown.add_column(
            Text(heading),
            justify="right" if numbers else "left",
            overflow="fold",
            width=max(map(len, (*texts, *heading.split()))) if numbers else None,
        )  # headings are wrapped, numbers are not
    for row in table.rows:  # as Text: rich would take a unit in brackets for a markup tag
        shown.add_row(*(Text(plain(cell)) for cell in row))
    yield shown


def plain(cell: Cell) -> str:
    """A cell in signs that every terminal has."""
    return (cell.text if isinstance(cell, Number) else cell).translate(_ASCII)


def listed(title: str, lines: Iterable[str]) -> Iterator[RenderableType]:
    """A title with indented lines; nothing without lines."""
    rows = [Padding(Text(line), (0, 0, 0, 2), expand=False) for line in lines]
    if rows:
        yield from (Text(title, style="bold"), *rows, Text(""))


def noted(notes: Iterable[Mapping[str, Any]]) -> Iterator[RenderableType]:
    """Notes by grade, the gravest first."""
    texts: dict[str, list[str]] = {grade: [] for grade in GRADES}
    for note in notes:
        texts[note["grade"]].append(of_note(note))
    for grade, lines in texts.items():
        yield from listed(grade, lines)
