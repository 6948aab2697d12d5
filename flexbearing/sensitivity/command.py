"""The command `sensitivity`; what it does not need is not loaded."""

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexbearing.program.commands import CaseFile, Settings, end, keeping, say, say_json

if TYPE_CHECKING:
    from flexbearing.case import Head
    from flexbearing.derivatives.table import Sensitivities


def sensitivity(
    case: CaseFile,
    of: Annotated[
        str | None,
        typer.Option(
            "--of", metavar="OUTPUT,...", help='outputs, "life,cage_slip [%]" or all; default: the main ones'
        ),
    ] = None,
    by: Annotated[
        list[str] | None,
        typer.Option("--by", metavar="KEY", help="a key, once for each; default: all that the case states"),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="picture (.png, .svg, .pdf), beside it a table"),
    ] = None,
    settings: Settings = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="one JSON object instead of text and files")
    ] = False,
) -> None:
    """Compute how much each key of a case changes its outputs: derivatives, largest first."""
    from flexbearing import api
    from flexbearing.files import require_outputs
    from flexbearing.report.picture import form_of
    from flexbearing.runs.run_case import stem_of_outputs

    wanted = api.read_case(case, settings or [])
    picture = output or Path("results") / f"{stem_of_outputs(case, settings or ())}_sensitivity.png"
    form = form_of(picture)
    table = picture.with_suffix(".csv")
    if not as_json:
        require_outputs((picture, table), wanted.input_files)
    found = _differentiated(wanted, of.split(",") if of else (), by or ())
    if as_json:
        say_json(_as_json(found))
        return
    _write(found, picture, table, form)
    with keeping([picture, table]):
        from flexbearing.report.output import laid_out
        from flexbearing.sensitivity.page import sections

        page = laid_out(sections(found), encoding=sys.stdout.encoding)
        say(f"{page}table: {table}\npicture: {picture}")


def _differentiated(case: "Head", of: Sequence[str], by: Sequence[str]) -> "Sensitivities":
    from flexbearing import api
    from flexbearing.case import BadCase
    from flexbearing.outputs import UnknownOutput, WrongUnit
    from flexbearing.progress import shown
    from quasidynamic import NotSolved

    try:
        with shown("sensitivity") as report:
            return api.sensitivities(case, of, by, report)
    except (UnknownOutput, WrongUnit) as problem:
        raise BadCase(f"--of {problem}") from None
    except NotSolved as problem:
        end(f"{case.source.path}: not converged: {problem}")


def _write(found: "Sensitivities", picture: Path, table: Path, form: str) -> None:
    from flexbearing.files import write
    from flexbearing.report.picture import Format, picture_bytes
    from flexbearing.sensitivity.page import draw_tornado

    write(table.resolve(), _csv(found).encode())
    with keeping([table], "the table is complete"):
        write(picture.resolve(), picture_bytes(draw_tornado(found), Format(form)))


def _csv(found: "Sensitivities") -> str:
    from flexbearing.derivatives.table import COLUMNS
    from flexbearing.files import as_csv

    return as_csv([COLUMNS, *([record[name] for name in COLUMNS] for record in found.records())])


def _as_json(found: "Sensitivities") -> dict[str, object]:
    return {
        "title": found.title,
        "raceways": found.raceways,
        "derivatives": found.records(),
        "without_derivatives": [{"key": key, "why": why} for key, why in found.left_out],
    }
