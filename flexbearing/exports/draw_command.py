"""The command `draw`; nothing is solved for it."""

from pathlib import Path
from typing import Annotated

import typer

from flexbearing.printable import printable
from flexbearing.program.commands import CaseFile, Settings, keeping, say

FORMS = ("svg", "png", "pdf")


def draw(
    case: CaseFile,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="DIR", help="default: results/")
    ] = None,
    form: Annotated[str, typer.Option("--format", metavar="|".join(FORMS), help="of the files")] = "svg",
    keys: Annotated[bool, typer.Option("--keys", help="write keys without their values")] = False,
    settings: Settings = None,
) -> None:
    """Draw what a case describes to scale, with its keys as dimensions; nothing is solved."""
    from flexbearing import api
    from flexbearing.case import BadCase
    from flexbearing.files import require_folder, require_outputs, write
    from flexbearing.runs.run_case import stem_of_outputs

    if form not in FORMS:
        raise BadCase(f"--format {printable(form)}: it is one of {', '.join(FORMS)}")
    wanted = api.read_case(case, settings or [])
    drawings = api.drawings(wanted, values=not keys)
    folder, stem = require_folder(output or Path("results")), stem_of_outputs(case, settings or ())
    written: list[Path] = []
    with keeping(written):
        names = [folder / f"{stem}_{drawing.name}.{form}" for drawing in drawings]
        for drawing, place in zip(drawings, require_outputs(names, wanted.input_files), strict=True):
            write(place, drawing.content(form))
            written.append(place)
            say(f"drawing: {place}")
