"""The command `goal`; what it does not need is not loaded."""

import sys
from pathlib import Path
from typing import Annotated

import typer

NOT_REACHED = 1


def goal(
    case: Annotated[Path, typer.Argument(help="case file (TOML)", metavar="CASE")],
    life: Annotated[
        str, typer.Option("--life", metavar="xFACTOR|LIFE", help='that is wanted: x2, or "20000 h"')
    ],
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="replace a key of the case, as of run"),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="one JSON object instead of text")] = False,
) -> None:
    """Find what to change for a life: every lever alone, and the best pair, each verified by a run."""
    from flexbearing import api
    from flexbearing.families import FAMILIES
    from flexbearing.goal.search import goal as search
    from flexbearing.printable import all_printable, printable
    from flexbearing.progress import shown

    wanted = api.read_case(case, settings or [])
    with shown("goal") as report:
        found = search(wanted, FAMILIES[wanted.kind], life, report)
    if as_json:
        import json

        sys.stdout.write(json.dumps(all_printable(found.as_json()), indent=2, allow_nan=False) + "\n")
    else:
        sys.stdout.write(printable(f"{found!r}\n"))
    if not found.reached:
        raise typer.Exit(NOT_REACHED)
