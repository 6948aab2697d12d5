"""The command `map`; what it does not need is not loaded."""

from pathlib import Path
from typing import Annotated

import typer

from flexbearing.program.commands import CONVERGED, NOT_CONVERGED, CaseFile, Settings, end, keeping, say


def map_(
    case: CaseFile,
    over: Annotated[
        list[str],
        typer.Option(
            "--over",
            metavar="KEY=FROM..TO,N",
            help='one to three keys, "operation.radial_load=log 500 N..20 kN,100"; a load or speed alone, '
            "without N, is followed around its folds",
        ),
    ],
    of: Annotated[
        str | None, typer.Option("--of", metavar="OUTPUT,...", help='outputs, "life_L10 [h],cage_slip [%]"')
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="OUT.csv", help="table; all others are next to it"),
    ] = None,
    form: Annotated[
        str,
        typer.Option(
            "--format", metavar="png|svg|pdf", show_default=False, help="of the picture; png by default"
        ),
    ] = "png",
    settings: Settings = None,
) -> None:
    """Map a case over one to three keys: every equilibrium of every point, folds, regions of several."""
    from flexbearing.progress import shown
    from flexbearing.studies.maps.map import MapRequest, map_case
    from quasidynamic import NotSolved

    try:
        outputs = tuple(of.split(",")) if of else ()
        request = MapRequest(case, tuple(over), outputs, output, tuple(settings or ()), form)
        with shown("map") as report:
            found = map_case(request, report)
    except NotSolved as problem:
        end(f"{case}: not converged: {problem}")
    with keeping(list(found.files.values())):
        files = "\n".join(f"{name}: {path}" for name, path in found.files.items())
        say(f"{found.text}\n{files}")
    raise typer.Exit(CONVERGED if found.complete else NOT_CONVERGED)
