"""The command line: check, run, summary, plot, fields, trace, pareto, explain."""

import sys
from os import environ
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from flexbearing import api

if TYPE_CHECKING:
    from rich.console import Console

CONVERGED, NOT_CONVERGED, BAD_INPUT, INTERNAL = range(4)

app = typer.Typer(
    help="Rolling bearings with thin, flexible rings.",
    no_args_is_help=True,
    rich_markup_mode=None,  # plain help: rich takes longer to load than everything else
    pretty_exceptions_enable=False,
)
DEBUG = "--debug"

CaseFile = Annotated[Path, typer.Argument(help="case file (TOML)", metavar="CASE")]
ResultPath = Annotated[Path, typer.Argument(help="result file (HDF5)", metavar="OUT.h5")]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="KEY=VALUE", help='replace a key of the case, "bearing.clearance=50 um"'),
]


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        sys.stdout.write(f"flexbearing {version('flexbearing')}\n")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="the version, and nothing else"
        ),
    ] = False,
    debug: Annotated[bool, typer.Option(DEBUG, help="show the traceback of an error")] = False,
) -> None:
    """Take note of what holds for every command; `main` looks for --debug itself."""


@app.command()
def check(case: CaseFile, settings: Settings = None) -> None:
    """Say whether a case can be computed, without computing it."""
    title = api.check(case, settings or []).title
    sys.stdout.write(f"{case}: {title}: nothing wrong with it\n")


@app.command()
def run(
    case: CaseFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="OUT.h5")] = None,
    settings: Settings = None,
    start: Annotated[
        Path | None,
        typer.Option("--start", metavar="OTHER.h5", help="result of a neighbouring case where newton begins"),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="only what went wrong")] = False,
) -> None:
    """Compute a case and store every iteration; prints a summary."""
    from flexbearing.progress import Logged, OnTerminal

    console = _terminal()
    if not quiet and console is None:
        import logging

        logging.basicConfig(level=logging.INFO, stream=sys.stdout, format="%(message)s")
    with OnTerminal(console) if console and not quiet else Logged() as report:
        result = api.run(case, output, settings or [], report=report, start=start)
    if not quiet:
        from flexbearing.report import text

        sys.stdout.write(text(result, console))
        sys.stdout.write(f"\nresults: {result.path}\n")
    elif result.attributes["status"] != "converged":
        sys.stderr.write(f"{case}: not converged: {result.attributes['message']}\n")
    raise typer.Exit(CONVERGED if result.attributes["status"] == "converged" else NOT_CONVERGED)


@app.command()
def summary(
    result: ResultPath,
    as_json: Annotated[bool, typer.Option("--json", help="one JSON object instead of text")] = False,
) -> None:
    """Print the numbers of a result."""
    from flexbearing.report import text

    found = api.read_result(result)
    if as_json:
        import json

        sys.stdout.write(json.dumps(api.summary(found), indent=2, allow_nan=False) + "\n")
    else:
        sys.stdout.write(text(found, _terminal()))


@app.command()
def plot(
    result: ResultPath,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="DIR")] = None,
) -> None:
    """Draw the pictures of a result as PNG files, with deformed rings where they are flexible."""
    from flexbearing.report import write_figures
    from flexbearing.report.roller import deformed

    found, directory = api.read_result(result), output or result.parent
    pictures = write_figures(found, directory)
    for picture in pictures:
        sys.stdout.write(f"picture: {picture}\n")
    for line in deformed.pictures(found, directory):
        sys.stdout.write(f"{line}\n")
    if not pictures:
        sys.stdout.write(f"{result}: nothing was solved, so there is nothing to draw\n")


@app.command()
def fields(
    result: ResultPath,
    part: Annotated[str | None, typer.Option("--part", metavar="inner|outer", help="only this one")] = None,
    state: Annotated[
        str, typer.Option("--state", metavar="STATE", help='"rigid", "flexible" or "iteration N"')
    ] = "flexible",
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="DIR")] = None,
) -> None:
    """Compute displacements and stresses of the flexible rings; writes VTU files for ParaView."""
    from rich.console import Console, Group

    from flexbearing.case import BadCase
    from flexbearing.report.sections import stresses
    from flexbearing.runs import fields as compute

    if part not in ("inner", "outer", None):
        raise BadCase(f'--part {part}: it is "inner" or "outer"')
    found = api.read_result(result)
    try:
        computed = compute.of_result(found, state, part)
    except compute.NoFields as problem:
        _fail(f"{result}: {problem}", NOT_CONVERGED)
    Console().print(Group(*stresses({one.race: one.record() for one in computed})))
    for one in computed:
        sys.stdout.write(f"fields: {compute.write(one, result, output or result.parent)}\n")


@app.command()
def trace(
    case: CaseFile,
    over: Annotated[
        str,
        typer.Option(
            "--over", metavar="KEY=FROM..TO", help='load or speed, "operation.radial_load=500 N..20 kN"'
        ),
    ],
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="OUT.csv")] = None,
    settings: Settings = None,
) -> None:
    """Follow the equilibria of a case over its load or speed, around folds; writes a table and a picture."""
    from flexbearing.studies.trace import trace as follow
    from quasidynamic import NotSolved

    try:
        found = follow(case, over, output, settings or [])
    except NotSolved as problem:
        sys.stderr.write(f"{case}: not converged: {problem}\n")
        raise typer.Exit(NOT_CONVERGED) from problem
    sys.stdout.write(f"{found.text()}\ntable: {found.table}\npicture: {found.picture}\n")
    raise typer.Exit(CONVERGED if found.complete else NOT_CONVERGED)


@app.command()
def pareto(
    case: CaseFile,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FOLDER", help="of the table and the picture")
    ] = Path("results"),
    name: Annotated[
        str | None, typer.Option("--name", help="of both files, pareto_NAME; by default that of the case")
    ] = None,
    solid: Annotated[bool, typer.Option("--solid", help="also the full solid, which takes long")] = False,
    settings: Settings = None,
) -> None:
    """Run a case on every level of accuracy; draws time against error and names the cheapest levels."""
    from flexbearing.report.studies.pareto_figure import write_pareto
    from flexbearing.report.studies.pareto_table import text, write_table
    from flexbearing.studies.pareto import NoReference, pareto as study

    try:
        found = study(case, settings or [], solid=solid, tell=_tell)
    except NoReference as problem:
        _fail(problem, NOT_CONVERGED)
    output.mkdir(parents=True, exist_ok=True)
    table, picture = (output / f"pareto_{name or case.stem}{suffix}" for suffix in (".csv", ".png"))
    write_table(table, found)
    write_pareto(picture, found)
    sys.stdout.write(f"\n{text(found)}\ntable: {table}\npicture: {picture}\n")


def _tell(measured) -> None:
    """One line for a level that was measured; not into the table that follows."""
    times = ", ".join(f"{seconds:.2f} s {when}" for when, seconds in measured.times.items())
    sys.stderr.write(f"{measured.name}: {measured.message or times}\n")


cache_app = typer.Typer(help="Condensed rings that are kept on disk.", no_args_is_help=True)
app.add_typer(cache_app, name="cache")


@cache_app.command("list")
def cache_list() -> None:
    """List what is kept, with size and last use."""
    from flexbearing.cache import configured, listing

    sys.stdout.write(listing(configured()) + "\n")


@cache_app.command("clear")
def cache_clear() -> None:
    """Delete what is kept."""
    from flexbearing.cache import configured

    sys.stdout.write(f"{configured().clear()} condensed rings deleted\n")


@cache_app.command("path")
def cache_path() -> None:
    """Say where it is kept; the environment variable FLEXBEARING_CACHE names another folder, or "off"."""
    from flexbearing.cache import configured

    sys.stdout.write(f"{configured().folder or 'nothing is kept'}\n")


@app.command(name="explain")
def explain_key(key: Annotated[str | None, typer.Argument(metavar="[KEY]")] = None) -> None:
    """Explain a key of the case file: unit, default, allowed values, meaning."""
    sys.stdout.write(api.explain(key).rstrip() + "\n")


def _terminal() -> "Console | None":
    """The terminal with its width and colours; None where the output goes to a file."""
    if not (sys.stdout.isatty() or {"FORCE_COLOR", "TTY_COMPATIBLE"} & set(environ)):
        return None  # rich need not be loaded to know
    from rich.console import Console

    console = Console()
    return console if console.is_terminal else None


def main() -> None:
    """Run the command line; no traceback reaches a user who does not ask for it by --debug."""
    environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # a search through every installed package
    debug = DEBUG in sys.argv
    if debug:  # also behind the command
        sys.argv.remove(DEBUG)
    try:
        app()
    except Exception as problem:
        from flexbearing.case import BadCase

        if debug:
            import traceback

            traceback.print_exc()
        if isinstance(problem, BadCase):
            _fail(problem, BAD_INPUT)
        from flexbearing.files import BadOutput  # checking a case does without
        from flexbearing.results import BadResult, NotInLayout

        if isinstance(problem, BadResult | NotInLayout | BadOutput):
            _fail(problem, BAD_INPUT)
        _fail(f"internal error: {type(problem).__name__}: {problem}", INTERNAL)


def _fail(problem: object, code: int) -> NoReturn:
    sys.stderr.write(f"{problem}\n")
    sys.exit(code)
