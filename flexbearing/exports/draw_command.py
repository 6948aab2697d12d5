"""The command `draw`; nothing is solved for it."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from flexbearing.printable import printable
from flexbearing.program.complete_files import keeping

FORMS = ("svg", "png", "pdf")


def draw(
    case: Annotated[Path, typer.Argument(help="case file (TOML)", metavar="CASE")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="DIR", help="default: results/")
    ] = None,
    form: Annotated[str, typer.Option("--format", metavar="|".join(FORMS), help="of the files")] = "svg",
    keys: Annotated[bool, typer.Option("--keys", help="write keys without their values")] = False,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="replace a key of the case, as of run"),
    ] = None,
) -> None:
    """Draw what a case describes to scale, with its keys as dimensions; nothing is solved."""
    from flexbearing import api
    from flexbearing.files import require_folder, require_outputs, write
    from flexbearing.runs.run_case import stem_of_outputs

    _require_known(form)
    wanted = api.read_case(case, settings or [])
    folder, stem = require_folder(output or Path("results")), stem_of_outputs(case, settings or ())
    written: list[Path] = []
    with keeping(written):
        drawings = api.drawings(wanted, values=not keys)
        names = [folder / f"{stem}_{drawing.name}.{form}" for drawing in drawings]
        for drawing, place in zip(drawings, require_outputs(names, wanted.input_files), strict=True):
            write(place, drawing.content(form))
            written.append(place)
            sys.stdout.write(printable(f"drawing: {place}\n"))


def _require_known(form: str) -> None:
    from flexbearing.case import BadCase

    if form not in FORMS:
        raise BadCase(f"--format {printable(form)}: it is one of {', '.join(FORMS)}")
