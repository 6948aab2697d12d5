"""What a report holds, apart from how a page shows it."""

from dataclasses import dataclass, field
from typing import Any, ClassVar


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
    """A table; the first cell of every row names it."""

    kind: ClassVar = "table"
    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    note: str = ""
    sortable: bool = False
    folded: bool = False  # shown when the caption is clicked
    name: str = ""  # of its element, for links


@dataclass(frozen=True)
class Figure:
    """A figure that Plotly draws; `meta` of a trace says from which places of the file its numbers come."""

    kind: ClassVar = "figure"
    name: str  # of its element
    caption: str  # what is drawn, and what it says
    traces: tuple[dict[str, Any], ...]
    layout: dict[str, Any] = field(default_factory=dict)
    tall: bool = False  # room for a long legend


@dataclass(frozen=True)
class Drawing:
    """A drawing as SVG of the program itself, put into the page as it is."""

    kind: ClassVar = "drawing"
    caption: str
    svg: str


@dataclass(frozen=True)
class Words:
    """Paragraphs."""

    kind: ClassVar = "words"
    paragraphs: tuple[str, ...]
    grade: str = ""  # "danger", "good"


@dataclass(frozen=True)
class Items:
    """A list with a title."""

    kind: ClassVar = "items"
    title: str
    items: tuple[str, ...]
    grade: str = ""
    link: tuple[str, str] | None = None  # below the list: to where on the page, and its words
    name: str = ""  # of its element, for links


@dataclass(frozen=True)
class Verbatim:
    """A text letter by letter."""

    kind: ClassVar = "verbatim"
    title: str
    text: str


Block = Table | Figure | Drawing | Words | Items | Verbatim


@dataclass(frozen=True)
class Section:
    """A section with its blocks; one without blocks is left out."""

    name: str
    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Document:
    """A whole report."""

    title: str
    subtitle: str
    sections: tuple[Section, ...]
    download: tuple[str, str] | None = None  # name and text of a table to be saved

    @property
    def figures(self) -> list[Figure]:
        """Every figure in the order of the page."""
        return [block for section in self.sections for block in section.blocks if isinstance(block, Figure)]
