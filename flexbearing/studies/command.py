"""The command `study`; what it does not need is not loaded."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from flexbearing.printable import printable
from flexbearing.program.commands import BAD_INPUT, CONVERGED, NOT_CONVERGED, say


def study(  # noqa: PLR0913  # an argument for each option
    file: Annotated[Path, typer.Argument(help="study file (TOML)", metavar="FILE")],
    check: Annotated[
        bool, typer.Option("--check", help="list the variants, what is wrong and how long; compute nothing")
    ] = False,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="of the table and of what is finished")
    ] = Path("results"),
    jobs: Annotated[
        int | None,
        typer.Option(
            "--jobs", metavar="N", min=1, help="processes that compute, a core each; else by cores and work"
        ),
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option("--scheduler", metavar="ADDRESS", help="running Dask scheduler, tls://...")
    ] = None,
    slurm: Annotated[
        Path | None, typer.Option("--slurm", metavar="PROFILE.toml", help="workers in jobs of a SLURM queue")
    ] = None,
    tls_ca: Annotated[
        Path | None, typer.Option("--tls-ca", metavar="PEM", help="authority of --scheduler, --slurm")
    ] = None,
    tls_cert: Annotated[
        Path | None, typer.Option("--tls-cert", metavar="PEM", help="certificate that it signed")
    ] = None,
    tls_key: Annotated[
        Path | None, typer.Option("--tls-key", metavar="PEM", help="key of that certificate")
    ] = None,
    retry_failed: Annotated[
        bool, typer.Option("--retry-failed", help="compute rows that failed once more")
    ] = False,
    part: Annotated[
        str | None, typer.Option("--part", metavar="k/N", help="compute a part; without it all are gathered")
    ] = None,
    emit: Annotated[
        str | None, typer.Option("--emit", metavar="sbatch", help="print the script of a job array instead")
    ] = None,
    status: Annotated[bool, typer.Option("--status", help="count what is finished; compute nothing")] = False,
) -> None:
    """Compute the variants of a case into one table; a second start goes on where the first one ended."""
    from flexbearing.case import BadCase
    from flexbearing.printable import excerpt
    from flexbearing.program.threads import limited_to
    from flexbearing.progress import shown
    from flexbearing.studies import messages
    from flexbearing.studies.placement import Placement, sbatch
    from flexbearing.studies.plan import Part
    from flexbearing.studies.prepare import compute, prepare_source

    chosen = None if part is None else Part.parsed(part)
    if emit not in (None, "sbatch"):
        raise BadCase(f'--emit {excerpt(emit)}: it must be "sbatch"')
    with limited_to(jobs), shown("check") as report:
        prepared = prepare_source(file, messages.Checking(report))
    if check or status:
        say(messages.status(prepared, output) if status else messages.variants(prepared))
        raise typer.Exit(BAD_INPUT if prepared.plan.problems else CONVERGED)
    prepared.plan.require_sound()
    if emit:
        say(sbatch(prepared, output, jobs).rstrip())
        raise typer.Exit(CONVERGED)
    prepared = prepared.of_part(chosen) if chosen else prepared
    placement = Placement(jobs, scheduler, slurm, (tls_ca, tls_cert, tls_key))
    with shown("study") as report:
        table = compute(prepared, output, placement, retry_failed=retry_failed, tell=messages.follow(report))
    sys.stderr.writelines(printable(f"{words}; {messages.ADVICE}\n") for words in table.complaints)
    say(messages.end(prepared, table, output))
    raise typer.Exit(NOT_CONVERGED if table.failed else CONVERGED)
