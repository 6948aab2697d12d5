"""Text and pictures of a result, by the record of its family."""

from io import StringIO
from pathlib import Path

from rich.console import Console, Group

from flexbearing.report.summary_values import summary
from flexbearing.results import Result


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
    with console.capture() as capture:
        console.print(Group(*result.family.report().page(summary(result))))
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
    for name, figure in result.family.report().pictures(result).items():
        paths.append(directory / f"{name}.png")
        figure.savefig(paths[-1], dpi=150)
    return paths
