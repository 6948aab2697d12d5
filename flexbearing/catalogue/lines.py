"""The text of a case file: keys with comments, table by table."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from textwrap import wrap

from flexbearing.case.declarations import by_path, toml
from flexbearing.case.quantity import Section
from flexbearing.catalogue.element_set import ElementSet, span
from flexbearing.catalogue.page import Page

WIDTH = 110  # characters of a line
COLUMN = 40  # where short comments begin
THUMB = "rule of thumb"
RATED = "C_0 of the maker by ISO 76"
CHOSEN = "chosen, no catalogue has it"  # load, speed, fits, oil
HALF_OR_TWICE = (0.5, 2.0)
GLUE = "\0"  # stands for a space at which no line ends


Settings = dict[str, str | float]  # key to value; an empty text takes the key out


@dataclass(frozen=True)
class Other:
    """Another value that an assumed one might have."""

    words: str
    settings: Settings


@dataclass(frozen=True)
class Line:
    """A key of a case with its value."""

    key: str
    value: str | float | bool
    why: str = ""  # where it comes from
    assumed: bool = False
    others: tuple[Other, ...] = ()  # for its weight


def assumed(key: str, value: str | float | bool, why: str, *others: str | float) -> Line:
    """A line whose value nothing gives, and what it might be instead."""
    return Line(
        key, value, why, assumed=True, others=tuple(Other(toml(other), {key: other}) for other in others)
    )


def entry(page: Page, name: str, key: str, why: str = "", shares: tuple[float, ...] = ()) -> Line:
    """The line of an entry; where it is assumed, marked, with shares of it that it might be instead."""
    given = page[name]
    if name not in page.assumed:
        return Line(key, given.text, why)
    return assumed(
        key, given.text, page.assumed[name], *(given.with_unit_of_this(share * given.si) for share in shares)
    )


def as_settings(settings: Settings) -> list[str]:
    """Write settings as `key=value`."""
    return [f"{key}={value if isinstance(value, str) else toml(value)}" for key, value in settings.items()]


def usual_number(elements: ElementSet, usual: str, size: str, rated: bool) -> str:
    """Where an assumed number of rolling elements comes from."""
    few, many = elements.pairs[0][0], elements.pairs[-1][0]
    verb = "fit" if few < many else "alone fits"
    of_size = f", and C_0 of the maker then gives a usual {size}" if rated else ""
    return f"{span(few, many)} {verb} {usual}{of_size}"


def mm(length: float) -> str:
    """Write a length [m] as a case would, rounded."""
    return f"{length * 1e3:.4g} mm"


def um(length: float) -> str:
    """Write a small length [m] as a case would, rounded."""
    return f"{length * 1e6:.3g} um"


def text(head: str, title: str, lines: Iterable[Line], model: type[Section]) -> str:
    """Write a case file.

    Parameters
    ----------
    head : str
        what stands above it, as comment
    title : str
        of the case
    lines : iterable of Line
        those of a table in the order in which they are to stand
    model : type
        schema of the case

    Returns
    -------
    str
        TOML
    """
    tables: dict[str, list[Line]] = {}
    for line in lines:
        assert line.key in by_path(model), line.key
        tables.setdefault(line.key.rpartition(".")[0], []).append(line)
    parts = [f"# {words}".rstrip() for words in head.splitlines()]
    parts += [f"{line.key} = {toml(line.value)}" for line in tables.pop("", ())]
    inside_tables = [line for inside in tables.values() for line in inside]
    parts += [f"title = {toml(title)}", "", *_assumed(inside_tables)]
    for table, inside in tables.items():
        parts += ["", f"[{table}]", *(written for line in inside for written in _written(line))]
    return "\n".join(parts) + "\n"


def _assumed(lines: list[Line]) -> list[str]:
    names = ", ".join(toml(line.key) for line in lines if line.assumed)
    indent = " " * 4
    rows = wrap(names + ",", WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False)
    return ["assumed = [", *rows, "]"]


def _written(line: Line) -> Iterator[str]:
    given = f"{line.key.rpartition('.')[2]} = {toml(line.value)}"
    why = ("assumed: " if line.assumed else "") + line.why
    beside = f"{given.ljust(COLUMN - 1)} # {why}"
    if why and len(beside) > WIDTH:
        whole = re.sub(r'"[^"]*"', lambda quoted: quoted[0].replace(" ", GLUE), why)
        yield from (
            row.replace(GLUE, " ")
            for row in wrap(whole, WIDTH, initial_indent="# ", subsequent_indent="# ", break_on_hyphens=False)
        )
        yield given
    else:
        yield beside if why else given
