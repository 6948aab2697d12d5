"""What a report hands over to its template: numbers, tables, figures, drawings."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from flexbearing.report.figure import Figure


@dataclass(frozen=True)
class Number:
    """A number as it is printed, with the place in the file that it comes from."""

    text: str
    unit: str  # that it is printed in; empty for plain numbers
    of: str  # "summary/flexible/life_L10_Mrev", "rigid/inner_load/3", "attributes/clearance/operating_m"
    stored: str  # its unit at that place

    @property
    def size(self) -> float:
        """The number that is printed, for comparisons with others."""
        return float(self.text.replace(",", "").replace("∞", "inf"))


Cell = str | Number


@dataclass(frozen=True)
class Table:
    """A table; the first cell of every row names it. Its caption is in the template."""

    kind: ClassVar = "table"
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    sortable: bool = False


@dataclass(frozen=True)
class Drawing:
    """A drawing as SVG of the program itself, put into the page as it is."""

    kind: ClassVar = "drawing"
    title: str
    svg: str


@dataclass(frozen=True)
class Document:
    """A whole report: a template of the folder `page`, and the parts that it arranges."""

    template: str
    title: str
    parts: Mapping[str, Any]  # tables, figures, numbers and texts by name, or lists of them; empty: left out
    download: tuple[str, str] | None = None  # name and text of a table to be saved

    @property
    def figures(self) -> list[Figure]:
        """Every figure."""
        return _figures(self.parts)


def _figures(part: Any) -> list[Figure]:
    if isinstance(part, Figure):
        return [part]
    each = part.values() if isinstance(part, Mapping) else part if isinstance(part, list | tuple) else ()
    return [figure for item in each for figure in _figures(item)]
