"""Pictures as PNG, and titles that are drawn as they are written."""

from __future__ import annotations

import warnings
from io import BytesIO
from textwrap import fill
from typing import TYPE_CHECKING

from flexbearing.printable import printable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LINES = 4  # of a title, at most


def titled(title: str, width: int) -> str:
    """Break the title of a case into lines, for texts that are drawn with ``parse_math=False``.

    Parameters
    ----------
    title : str
        with anything in it
    width : int
        characters in a line

    Returns
    -------
    str
        without characters that no font draws
    """
    return fill(printable(title), width, max_lines=LINES, placeholder=" ...")


def png_bytes(figure: Figure, dpi: int = 150) -> bytes:
    """Draw a figure; characters that its font lacks become empty boxes.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        as it was made
    dpi : int
        dots per inch

    Returns
    -------
    bytes
        content of a PNG file
    """
    file = BytesIO()
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from", UserWarning)
        figure.savefig(file, format="png", dpi=dpi)
    return file.getvalue()
