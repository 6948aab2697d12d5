"""Files of pictures: their format, headings, look of axes, drawn as they are written."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING

from flexbearing.printable import printable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.transforms import Bbox


LINES = 4  # of a title, at most
FORMATS = ("png", "svg", "pdf")
_UNDATED = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}  # metadata


@dataclass(frozen=True)
class Format:
    """How pictures are written."""

    name: str = "png"  # one of FORMATS, also the ending of the files
    titles: bool = True  # whether the heading is above each picture


PNG = Format()


@dataclass(frozen=True)
class LeftOut:
    """A picture that would be empty."""

    name: str  # of the file, without its ending
    reason: str

    def __str__(self) -> str:
        return f"{self.name}: {self.reason}"


def form_of(picture: Path) -> str:
    """Format of a picture that a command writes, by its ending.

    Raises `BadCase` for another ending.
    """
    from flexbearing.case import BadCase

    form = picture.suffix.removeprefix(".")
    if form not in FORMATS:
        allowed = ", ".join(f".{each}" for each in FORMATS)
        raise BadCase(f"--output {picture}: the chart is a picture; its name ends in {allowed}")
    return form


def set_heading(figure: Figure, title: str, what: str, width: int) -> None:
    """Write the title of a case above a figure, in lines of at most `width` characters, and what is drawn."""
    heading = "\n".join(filter(None, (titled(title, width), what)))
    figure.suptitle(heading, fontsize=11, parse_math=False)


def titled(title: str, width: int) -> str:
    """Break the title of a case into lines, for texts that are drawn with ``parse_math=False``."""
    return fill(printable(title), width, max_lines=LINES, placeholder=" ...")


@contextmanager
def boxes_for_glyphs() -> Iterator[None]:
    """Let characters that a font lacks be empty boxes, without a warning."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from", UserWarning)
        yield


def picture_bytes(figure: Figure, form: Format = PNG, dpi: int = 150) -> bytes:
    """Draw a figure; characters that its font lacks become empty boxes."""
    from matplotlib import rc_context

    page = None if form.titles else _without_heading(figure)
    file = BytesIO()
    with boxes_for_glyphs(), rc_context({"svg.hashsalt": "flexbearing"}):
        metadata = _UNDATED[form.name]
        figure.savefig(file, format=form.name, dpi=dpi, metadata=metadata, bbox_inches=page)
    return file.getvalue()


def _without_heading(figure: Figure) -> Bbox | None:
    """Take the heading away; what is left of a figure that no layout spreads over its room."""
    from matplotlib.transforms import Bbox

    heading = next(text for text in figure.texts if text.get_text() == figure.get_suptitle())
    below = heading.get_window_extent().y0 / figure.dpi
    heading.set_text("")
    heading.set_in_layout(False)
    return Bbox([[0, 0], [figure.get_figwidth(), below]]) if figure.get_layout_engine() is None else None


NUMBERS = "{x:,.10g}"  # of ticks, with separated thousands as in tables


def plain_grid(axes: Axes) -> None:
    """Draw a light grid below everything, no frame above and to the right."""
    axes.set_axisbelow(True)
    axes.grid(color="0.88", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
