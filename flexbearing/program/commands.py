"""What commands share: options of their line, what they print, and what an early end says of their files."""

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer

from flexbearing.printable import all_printable, printable

CONVERGED, NOT_CONVERGED, BAD_INPUT = range(3)  # exit codes
CaseFile = Annotated[Path, typer.Argument(help="case file (TOML)", metavar="CASE")]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help='replace a key of the case, "bearing.clearance=50 um"; "KEY=" takes it out',
    ),
]
AsJson = Annotated[bool, typer.Option("--json", help="one JSON object instead of text")]


def say(words: str) -> None:
    """Print lines in which nothing controls the terminal."""
    sys.stdout.write(printable(words) + "\n")


def say_json(value: Any) -> None:
    """Print one JSON object."""
    sys.stdout.write(json.dumps(all_printable(value), indent=2, allow_nan=False) + "\n")


def end(problem: object) -> NoReturn:
    """End a command without a result, and say why.

    Raises `Exit`, always.
    """
    sys.stderr.write(f"{printable(str(problem))}\n")
    raise typer.Exit(NOT_CONVERGED)


@contextmanager
def keeping(written: list[Path], words: str = "complete") -> Iterator[None]:
    """Let an exception that ends a command early say which files are complete."""
    try:
        yield
    except BaseException as problem:  # only a note is added
        if written:
            problem.add_note(f"{words}: {', '.join(map(str, written))}")
        raise
