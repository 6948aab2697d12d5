"""The command `goal`; what it does not need is not loaded."""

from typing import Annotated

import typer

from flexbearing.program.commands import NOT_CONVERGED, AsJson, CaseFile, Settings, say, say_json


def goal(
    case: CaseFile,
    life: Annotated[
        str, typer.Option("--life", metavar="xFACTOR|LIFE", help='that is wanted: x2, or "20000 h"')
    ],
    settings: Settings = None,
    as_json: AsJson = False,
) -> None:
    """Find what to change for a life: every lever alone, and the best pair, each verified by a run."""
    from flexbearing import api
    from flexbearing.families import FAMILIES
    from flexbearing.goal.search import goal as search
    from flexbearing.progress import shown

    wanted = api.read_case(case, settings or [])
    with shown("goal") as report:
        found = search(wanted, FAMILIES[wanted.kind], life, report)
    if as_json:
        say_json(found.as_json())
    else:
        say(f"{found!r}")
    if not found.reached:
        raise typer.Exit(NOT_CONVERGED)
