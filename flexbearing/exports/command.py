"""The command `export`; what it does not need is not loaded."""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer

from flexbearing.printable import printable
from flexbearing.program.commands import end, keeping, say

FORMS = ("csv", "vtu", "netcdf", "ross", "rexs", "effects")
FORMS_OF_ARRAYS = ("csv", "netcdf", "effects")  # functions of `flexbearing.exports.files`


def export(
    file: Annotated[
        Path, typer.Argument(help="result file (HDF5); for ross also the table of a study", metavar="OUT.h5")
    ],
    to: Annotated[str, typer.Option("--to", metavar="|".join(FORMS), help="form of the files")],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="DIR", help="default: where the result is")
    ] = None,
    part: Annotated[
        str | None, typer.Option("--part", metavar="inner|outer", help="of vtu: only this one")
    ] = None,
    state: Annotated[
        str | None,
        typer.Option("--state", metavar="STATE", help='of vtu: "rigid", "flexible" or "iteration N"'),
    ] = None,
) -> None:
    """Write a result for other programs: tables, fields of the rings, netCDF, ROSS, REXS, effects."""
    options = {name: value for name, value in (("part", part), ("state", state)) if value is not None}
    _require_belonging(to, options)
    written: list[Path] = []
    with keeping(written):
        for path in _files(file, to, output or file.parent, options):
            written.append(path)
            say(f"{to}: {path}")


def _require_belonging(to: str, options: dict[str, str]) -> None:
    from flexbearing.case import BadCase

    if to not in FORMS:
        raise BadCase(f"--to {printable(to)}: it is one of {', '.join(FORMS)}")
    if options and to != "vtu":
        raise BadCase(f"--{next(iter(options))}: it belongs to --to vtu")


def _files(file: Path, to: str, directory: Path, options: dict[str, str]) -> Iterator[Path]:
    """Write the files one after the other."""
    from flexbearing import api

    if to == "ross":
        from flexbearing.exports import ross

        yield from ross.export(file if file.suffix == ".csv" else api.read(file), directory)
        return
    result = api.read(file)
    if to in FORMS_OF_ARRAYS:
        from flexbearing.exports import files

        yield from getattr(files, to)(result, directory)
    elif to == "rexs":
        from flexbearing.exports import rexs

        yield from rexs.export(result, directory)
    else:
        from flexbearing.exports import vtu
        from flexbearing.runs.part_fields import NoFields

        try:
            yield from vtu.export(result, directory, **options)
        except NoFields as problem:
            end(f"{file}: {problem}")
