"""What is shown of a result, by the kind of bearing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console, Group, RenderableType

from flexbearing.report import (
    angular_figures,
    angular_tables,
    ball_page,
    figures,
    four_point_figures,
    four_point_tables,
    page,
    tables,
)
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Look:
    """How results of one kind are shown."""

    summary: Callable[[Result], dict[str, Any]]
    page: Callable[[dict[str, Any]], Iterator[RenderableType]]  # of the summary
    pictures: Callable[[Result], dict[str, Figure]]  # by the names of their files


LOOKS = {
    "cylindrical_roller": Look(tables.summary, page.page, figures.pictures),
    "four_point_ball": Look(
        four_point_tables.summary, ball_page.four_point_page, four_point_figures.pictures
    ),
    "angular_contact_ball": Look(angular_tables.summary, ball_page.angular_page, angular_figures.pictures),
}


def summary(result: Result) -> dict[str, Any]:
    """Numbers of a run as one object that JSON can hold; a name carries its unit."""
    return LOOKS[result.kind].summary(result)


def text(result: Result, console: Console | None = None) -> str:
    """Lay the summary out as text.

    Parameters
    ----------
    result : Result
        what the run left behind
    console : rich.console.Console, optional
        the terminal it is meant for, with its width and colours; without one, 80 plain columns

    Returns
    -------
    str
        tables, the assumed and calibrated keys, the notes, and how the run ended; nothing is printed
    """
    console = console or Console(width=80, file=StringIO(), force_terminal=False, color_system=None)
    look = LOOKS[result.kind]
    with console.capture() as capture:
        console.print(Group(*look.page(look.summary(result))))
    return "\n".join(line.rstrip() for line in capture.get().splitlines()) + "\n"


def write_figures(result: Result, directory: str | Path) -> list[Path]:
    """Draw every picture of a result into PNG files.

    Parameters
    ----------
    result : Result
        what the run left behind
    directory : path
        where to write; it is made when missing

    Returns
    -------
    list of Path
        the files, such as ``roller_loads.png``; none of a ball bearing that was not solved
    """
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, figure in LOOKS[result.kind].pictures(result).items():
        paths.append(directory / f"{name}.png")
        figure.savefig(paths[-1], dpi=150)
    return paths
