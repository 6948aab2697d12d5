"""The command `report`; what it does not need is not loaded."""

from pathlib import Path
from typing import Annotated

import typer

from flexbearing.program.commands import say


def report(
    source: Annotated[
        Path,
        typer.Argument(
            help="result file (HDF5), table of a study (CSV, Parquet) or its folder", metavar="OUT.h5"
        ),
    ],
    against: Annotated[
        Path | None, typer.Option("--against", metavar="OTHER.h5", help="result to compare with")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="REPORT.html", help="default: OUT_report.html beside the source"
        ),
    ] = None,
    pdf: Annotated[
        bool, typer.Option("--pdf", help="print it to a PDF as well, by an installed Chromium")
    ] = False,
    units: Annotated[
        str, typer.Option("--units", metavar="metric|imperial", help="of the numbers in it")
    ] = "metric",
) -> None:
    """Write the report of a result or a study: one HTML file that opens without a network and prints."""
    from flexbearing.pages.make import report as written
    from flexbearing.progress import shown

    with shown("report"):
        paths = list(written(source, output, against=against, units=units, pdf=pdf))
    for path in paths:
        say(f"report: {path}")
