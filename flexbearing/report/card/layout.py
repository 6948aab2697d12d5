"""What a card holds, and the words that are made of it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from html import escape
from textwrap import wrap

from flexbearing.report.html.document import Number

WIDTH, NARROWEST = 100, 60  # characters of a line
_INDENT = 11  # of facts, behind their subject


@dataclass(frozen=True)
class Item:
    """A fact: what it is, its value with a unit, its range where the result has one, a short remark."""

    label: str
    value: Number | str = ""
    ends: tuple[Number, Number] | None = None
    remark: str = ""

    @property
    def words(self) -> str:
        """The fact in words: "clearance 33.6 um (8.9..58.3)"."""
        span = f"({self.ends[0].text}..{self.ends[1].text})" if self.ends else ""
        value = self.value if isinstance(self.value, str) else f"{self.value.text} {self.value.unit}".rstrip()
        return ", ".join(filter(None, (" ".join(filter(None, (self.label, value, span))), self.remark)))


@dataclass(frozen=True)
class Line:
    """Facts of one subject."""

    subject: str
    items: tuple[Item, ...]

    @property
    def words(self) -> str:
        """All of them, one after the other."""
        return "; ".join(item.words for item in self.items)

    def rows(self, room: int) -> Iterator[str]:
        """The same in rows of so many characters; no fact is broken that fits into one."""
        row = ""
        for item in self.items:
            if row and len(row) + len(item.words) + 2 > room:
                yield row
                row = ""
            *full, row = wrap(f"{row}; {item.words}" if row else item.words, room) or [""]
            yield from full
        yield row


@dataclass(frozen=True)
class Card:
    """The answer of a result: what was computed, then a line for each subject that it knows."""

    title: str
    lines: tuple[Line, ...]
    unsolved: str = ""  # how the run ended, where it has no result

    def with_hint(self, words: str) -> "Card":
        """The same with where more is, behind its notes."""
        *others, notes = self.lines
        return replace(self, lines=(*others, replace(notes, items=(*notes.items, Item(words)))))

    def text(self, width: int = WIDTH) -> str:
        """Lines of a terminal of a width in characters: a subject, then its facts."""
        width = min(WIDTH, max(NARROWEST, width))
        head = [*wrap(self.unsolved, width), *wrap(self.title, width)]
        return "\n".join((*head, *(row for line in self.lines for row in _labelled(line, width)))) + "\n"

    def html(self) -> str:
        """A table with a row for each subject, as a notebook shows it."""
        left = 'style="text-align:left"'
        rows = (
            f"<tr><th {left}>{escape(line.subject)}</th><td {left}>{escape(line.words)}</td></tr>"
            for line in self.lines
        )
        head = "<br>".join(escape(each) for each in (self.unsolved, self.title) if each)
        return f"<table><caption {left}><b>{head}</b></caption>{''.join(rows)}</table>"


def _labelled(line: Line, width: int) -> Iterator[str]:
    for number, row in enumerate(line.rows(width - _INDENT)):
        yield f"{'' if number else line.subject:<{_INDENT}}{row}".rstrip()
