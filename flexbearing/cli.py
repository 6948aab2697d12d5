"""The command line: check, run, study, summary, plot, fields, trace, pareto, explain."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from os import environ
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from flexbearing import api
from flexbearing.printable import printable
from flexbearing.studies.command import study

if TYPE_CHECKING:
    from rich.console import Console

    from flexbearing.results import Result

CONVERGED, NOT_CONVERGED = 0, 1
UNMET_TARGET = "unmet-target"  # the one danger that is no success without --strict

app = typer.Typer(
    help="Rolling bearings with thin, flexible rings.",
    no_args_is_help=True,
    rich_markup_mode=None,  # plain help: rich takes longer to load than everything else
    pretty_exceptions_enable=False,
)

CaseFile = Annotated[Path, typer.Argument(help="case file (TOML)", metavar="CASE")]
ResultPath = Annotated[Path, typer.Argument(help="result file (HDF5)", metavar="OUT.h5")]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help='replace a key of the case, "bearing.clearance=50 um"; "KEY=" takes it out',
    ),
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
    debug: Annotated[bool, typer.Option("--debug", help="show the traceback of an error")] = False,
) -> None:
    """Take note of what holds for every command; the program looks for --debug itself."""


@app.command()
def check(case: CaseFile, settings: Settings = None) -> None:
    """Say whether a case can be computed, without computing it."""
    title = api.check(case, settings or []).title
    _say(f"{case}: {title}: nothing wrong with it")


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
    strict: Annotated[bool, typer.Option("--strict", help="exit code 1 where a danger is noted")] = False,
) -> None:
    """Compute a case and store every iteration; prints a summary."""
    from flexbearing.progress import Logged, OnTerminal
    from flexbearing.runs.run_case import default_output

    console = _terminal()
    _log(everything=not quiet and console is None)
    wanted = api.read_case(case, settings or [])
    place = output or default_output(wanted)
    with OnTerminal(console) if console and not quiet else Logged() as report:
        result = api.compute(wanted, output=place, report=report, start=start)
    wrong = _what_went_wrong(result, strict=strict)
    with _keeping([place]):
        if not quiet:
            _show(result, console)
            _say(f"\nresults: {place}")
        for words in wrong if quiet else ():
            sys.stderr.write(f"{case}: {printable(words)}\n")
    raise typer.Exit(NOT_CONVERGED if wrong else CONVERGED)


def _what_went_wrong(result: "Result", *, strict: bool) -> list[str]:
    """Why a run is no success: it did not converge, missed its target, or is dangerous in a strict run."""
    missed = [note["text"] for note in result.dangers if strict or note["code"] == UNMET_TARGET]
    converged = result.attributes["status"] == "converged"
    return missed if converged else [f"not converged: {result.attributes['message']}", *missed]


@app.command()
def life(
    case: CaseFile,
    settings: Settings = None,
    as_json: Annotated[bool, typer.Option("--json", help="one JSON object instead of text")] = False,
) -> None:
    """Compare the life of a case with that of a catalogue, and tell what lies between, factor by factor."""
    from flexbearing.printable import all_printable

    found = api.against_catalogue(case, settings or [])
    if as_json:
        import json

        sys.stdout.write(json.dumps(all_printable(found), indent=2, allow_nan=False) + "\n")
        return
    from flexbearing.report import laid_out
    from flexbearing.report.roller.catalogue_life import sections

    page = sections(all_printable(found))
    sys.stdout.write(laid_out(page, _terminal(), encoding=sys.stdout.encoding))


@app.command()
def summary(
    result: ResultPath,
    as_json: Annotated[bool, typer.Option("--json", help="one JSON object instead of text")] = False,
) -> None:
    """Print the numbers of a result."""
    found = api.read(result)
    if as_json:
        import json

        numbers = json.dumps(found.summary(), indent=2, allow_nan=False)
        sys.stdout.write(numbers.replace("\x7f", r"\u007f") + "\n")  # JSON escapes every other one
    else:
        _show(found, _terminal())


@app.command()
def plot(
    result: ResultPath,
    against: Annotated[
        Path | None,
        typer.Option(
            "--against",
            metavar="OTHER.h5",
            help="draw only the contacts of a ball, beside those of this result, such as of another "
            "friction.model",
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="DIR", help="default: where the result is")
    ] = None,
) -> None:
    """Draw the pictures of a result as PNG files, with deformed rings where they are flexible."""
    from flexbearing.report import pictures
    from flexbearing.report.roller import deformed

    found, directory, written = api.read(result), output or result.parent, []
    if against is not None:
        _plot_against(found, api.read(against), directory)
        return
    with _keeping(written):
        for picture in pictures(found, directory):
            written.append(picture)
            _say(f"picture: {picture}")
        for picture in deformed.pictures(found, directory):
            if isinstance(picture, Path):
                written.append(picture)
                _say(f"picture: {picture}")
            else:
                _say(f"no picture of a deformed part: {picture}")
    if not written:
        _say(f"{result}: nothing was solved, so there is nothing to draw")


def _plot_against(one: "Result", other: "Result", directory: Path) -> None:
    """Draw contacts of two results side by side, and say what else differs in their cases."""
    from flexbearing.report import compared_pictures
    from flexbearing.report.balls.side_by_side import notes

    written: list[Path] = []
    with _keeping(written):
        for picture in compared_pictures(one, other, directory):
            written.append(picture)
            _say(f"picture: {picture}")
        for note in notes(one, other):
            _say(note)


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
    from flexbearing.printable import all_printable
    from flexbearing.report.sections import held, stresses
    from flexbearing.runs import stored_fields as compute
    from flexbearing.runs.part_fields import NoFields

    if part not in ("inner", "outer", None):
        raise BadCase(f'--part {part}: it is "inner" or "outer"')
    found = api.read(result)
    try:
        paths = compute.destinations(found, output or result.parent, state, part)
        solved = compute.of_result(found, state, part)
    except NoFields as problem:
        _end(f"{result}: {problem}")
    try:
        records = {one.race: one.record() for one in solved}
    except NoFields as problem:
        _end(f"{result}: {problem}")
    supports = held(found.attributes["structure"])
    Console().print(Group(*stresses(all_printable(records)), *supports))
    written: list[Path] = []
    with _keeping(written):
        for one in solved:
            compute.write(one, paths[one.race])
            written.append(paths[one.race])
            _say(f"fields: {written[-1]}")


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
        _end(f"{case}: not converged: {problem}")
    with _keeping([found.table, found.picture]):
        _say(f"{found.text()}\ntable: {found.table}\npicture: {found.picture}")
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
    from flexbearing.report.studies.pareto_table import text
    from flexbearing.runs.run_case import stem_of_outputs
    from flexbearing.studies.pareto import NoReference, pareto as study
    from flexbearing.studies.pareto_files import destinations, store

    inputs = api.read_case(case, settings or []).input_files
    if name is None:
        name = stem_of_outputs(case, settings or ()).lstrip(".")
    table, picture = destinations(output, name, inputs)
    try:
        found = study(case, settings or [], solid=solid, tell=_tell)
    except NoReference as problem:
        _end(problem)
    store(found, table, picture)
    with _keeping([table, picture]):
        _say(f"\n{text(found)}\ntable: {table}\npicture: {picture}")


app.command(name="study")(study)


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

    _say(listing(configured()))


@cache_app.command("clear")
def cache_clear() -> None:
    """Delete what is kept."""
    from flexbearing.cache import configured

    _say(f"{configured().clear()} condensed rings deleted")


@cache_app.command("path")
def cache_path() -> None:
    """Say where it is kept; the environment variable FLEXBEARING_CACHE names another folder, or "off"."""
    from flexbearing.cache import configured

    _say(f"{configured().folder or 'nothing is kept'}")


@app.command(name="explain")
def explain_key(key: Annotated[str | None, typer.Argument(metavar="[KEY]")] = None) -> None:
    """Explain a key of the case file: unit, default, allowed values, meaning; of a study file, study.KEY."""
    first, _, rest = (key or "").partition(".")
    if first == "study":
        from flexbearing.case.explain import explain_file
        from flexbearing.studies.file.schema import StudyFile

        _say(explain_file(rest or None, StudyFile).rstrip())
    else:
        _say(api.explain(key).rstrip())


def _terminal() -> "Console | None":
    """The terminal with its width and colours; None where the output goes to a file."""
    if not (sys.stdout.isatty() or {"FORCE_COLOR", "TTY_COMPATIBLE"} & set(environ)):
        return None  # rich need not be loaded to know
    from rich.console import Console

    console = Console()
    return console if console.is_terminal else None


def _say(words: str) -> None:
    """Print lines in which nothing controls the terminal."""
    sys.stdout.write(printable(words) + "\n")


def _show(result: "Result", terminal: "Console | None") -> None:
    """Print the summary of a result; without a terminal, in what its encoding has of frames."""
    from flexbearing.report import text

    sys.stdout.write(text(result, terminal, encoding=sys.stdout.encoding))


def _log(*, everything: bool) -> None:
    """Print what the library logs: everything to the output, or only warnings as errors."""
    import logging

    class Shown(logging.Formatter):
        def format(self, record: logging.LogRecord) -> str:
            return printable(super().format(record))

    handler = logging.StreamHandler(sys.stdout) if everything else logging.lastResort
    assert handler
    handler.setFormatter(Shown("%(message)s"))
    if everything:
        logging.basicConfig(level=logging.INFO, handlers=[handler])


@contextmanager
def _keeping(written: list[Path]) -> Iterator[None]:
    """Let whatever ends a command early say which files are complete."""
    try:
        yield
    except typer.Exit:
        raise
    except BaseException as problem:  # only a note is added
        if written:
            problem.add_note(f"complete: {', '.join(map(str, written))}")
        raise


def _end(problem: object) -> NoReturn:
    sys.stderr.write(f"{printable(str(problem))}\n")
    raise typer.Exit(NOT_CONVERGED)
