"""Text and pictures of a result, by the record of its family."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console, Group, RenderableType

from flexbearing.files import require_folder, require_outputs, write
from flexbearing.report.balls import side_by_side
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.page import page
from flexbearing.report.picture import PNG, Format, LeftOut, picture_bytes
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def text(result: Result, console: Console | None = None, encoding: str = "utf-8") -> str:
    """Lay the summary out as text."""
    return laid_out(page(Reader(result, METRIC)), console, encoding)


def laid_out(
    sections: Iterable[RenderableType], console: Console | None = None, encoding: str = "utf-8"
) -> str:
    """Lay sections out as text; everything else as for `text`."""
    console = console or _plain(encoding)
    with console.capture() as capture:
        console.print(Group(*sections))
    return "\n".join(line.rstrip() for line in capture.get().splitlines()) + "\n"


def write_figures(result: Result, directory: str | Path) -> list[Path]:
    """Draw every picture of a result into PNG files; returns those that `pictures` names."""
    return [picture for picture in pictures(result, directory) if isinstance(picture, Path)]


def pictures(result: Result, directory: str | Path, form: Format = PNG) -> Iterator[Path | LeftOut]:
    """Draw every picture of a result into files that are named after it.

    Raises `BadOutput` if the folder, or a file in it, cannot be written; `NotStored` if there is no room for
    a picture.
    """
    figures = result.family.report().pictures()(result)
    named = {f"{result.stem}_{name}": figure for name, figure in figures.items()}
    yield from (LeftOut(name, reason) for name, reason in named.items() if isinstance(reason, str))
    drawn = {name: figure for name, figure in named.items() if not isinstance(figure, str)}
    yield from _drawn(drawn, directory, form, result)


def compared_pictures(
    one: Result, other: Result, directory: str | Path, form: Format = PNG
) -> Iterator[Path]:
    """Draw the contacts of two results side by side into files.

    Raises `BadResult` if they have no cells of the same ball; `BadOutput` if the folder, or a file in it,
    cannot be written; `NotStored` if there is no room for a picture.
    """
    stem, figures = f"{one.stem}_against_{other.stem}", side_by_side.compared(one, other)
    named = {f"{stem}_ball_{ball}": figure for ball, figure in figures.items()}
    yield from _drawn(named, directory, form, one, other)


def _drawn(
    figures: Mapping[str, Figure], directory: str | Path, form: Format, *read: Result
) -> Iterator[Path]:
    """Write figures by the stems of their files, none of which may be what was read."""
    folder = require_folder(directory)
    paths = {folder / f"{stem}.{form.name}": figure for stem, figure in figures.items()}
    places = require_outputs(paths, (file for result in read for file in result.files))
    for place, (path, figure) in zip(places, paths.items(), strict=True):
        write(place, picture_bytes(figure, form))
        yield path


def _plain(encoding: str) -> Console:
    """Eighty columns for a file."""
    return Console(width=80, file=_Encoded(encoding), force_terminal=False, color_system=None)


class _Encoded(StringIO):
    """A text whose encoding is known, by which frames are chosen."""

    def __init__(self, encoding: str):
        super().__init__()
        self._encoding = encoding

    @property
    def encoding(self) -> str:
        return self._encoding
