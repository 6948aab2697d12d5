"""The command `diff`; what it does not need is not loaded."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from flexbearing.program.commands import AsJson, say_json


def diff(
    one: Annotated[Path, typer.Argument(help="result file (HDF5)", metavar="A.h5")],
    other: Annotated[Path, typer.Argument(help="another one of the same kind", metavar="B.h5")],
    as_json: AsJson = False,
) -> None:
    """Compare two results: keys that differ, then outputs that differ by more than their estimated errors."""
    from flexbearing import api
    from flexbearing.differences.compared import compared

    both = api.read(one), api.read(other)
    if as_json:
        say_json(compared(*both).as_json())
        return
    from flexbearing.pages.against import sections
    from flexbearing.printable import printable
    from flexbearing.report.output import laid_out

    sys.stdout.write(printable(laid_out(sections(*both), encoding=sys.stdout.encoding)))
