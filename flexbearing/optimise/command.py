"""The command `optimise`; what it does not need is not loaded."""

import sys
from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from flexbearing.printable import printable
from flexbearing.program.commands import CONVERGED, NOT_CONVERGED, say


def optimise(
    file: Annotated[Path, typer.Argument(help="optimisation file (TOML)", metavar="FILE")],
    output: Annotated[
        Path,
        typer.Option(
            "-o", "--output", metavar="DIR", help="of the table, the best case and what is finished"
        ),
    ] = Path("results"),
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", metavar="N", min=1, help="processes that compute; else by cores and work"),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="print errors only")] = False,
) -> None:
    """Find the design with the best output within limits; a second start goes on where the first ended."""
    from flexbearing.optimise import messages
    from flexbearing.optimise.run import optimise as optimised
    from flexbearing.optimise.search import SearchResult
    from flexbearing.progress import shown

    with nullcontext() if quiet else shown("optimisation") as report:

        def tell(found: SearchResult) -> None:
            if report:
                report.line(messages.start(found))

        optimum = optimised(file, output, jobs=jobs, tell=tell)
    if not quiet:
        say(messages.page(optimum, output))
    elif not optimum.converged:
        sys.stderr.write(printable(f"{file}: {optimum.ending}") + "\n")
    raise typer.Exit(CONVERGED if optimum.converged else NOT_CONVERGED)
