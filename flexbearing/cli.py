"""The command line: every command reads its arguments and calls the program."""

import sys
from contextlib import nullcontext
from importlib import import_module
from os import environ
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexbearing import api
from flexbearing.printable import all_printable, printable
from flexbearing.program.commands import (
    CONVERGED,
    NOT_CONVERGED,
    AsJson,
    CaseFile,
    Settings,
    end,
    keeping,
    say,
    say_json,
)

if TYPE_CHECKING:
    from rich.console import Console

    from flexbearing.report.picture import Format
    from flexbearing.report.studies.pareto_table import Measured
    from flexbearing.results import Result

UNMET_TARGET = "unmet-target"  # the one danger that is no success without --strict

COMMANDS = {  # in the order of the help
    "new": "catalogue.command:new",
    "check": "cli:check",
    "run": "cli:run",
    "life": "cli:life",
    "summary": "cli:summary",
    "diff": "pages.diff_command:diff",
    "report": "pages.command:report",
    "plot": "cli:plot",
    "export": "exports.command:export",
    "draw": "exports.draw_command:draw",
    "map": "studies.maps.command:map_",
    "pareto": "cli:pareto",
    "sensitivity": "sensitivity.command:sensitivity",
    "goal": "goal.command:goal",
    "limits": "limits.command:limits",
    "select": "select.command:select",
    "study": "studies.command:study",
    "optimise": "optimise.command:optimise",
    "explain": "cli:explain_key",
}

ResultPath = Annotated[Path, typer.Argument(help="result file (HDF5)", metavar="OUT.h5")]
Everything = Annotated[bool, typer.Option("--all", help="print all numbers and notes first")]
Notes = Annotated[bool, typer.Option("--notes", help="print the notes first")]


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        sys.stdout.write(f"flexbearing {version('flexbearing')}\n")
        raise typer.Exit


def application(first: str = "") -> typer.Typer:
    """The program with all commands, or with the first word alone: declaring all takes as long as a check."""
    app = typer.Typer(
        help="Rolling bearings with thin, flexible rings.",
        no_args_is_help=True,
        rich_markup_mode=None,  # plain help: rich takes longer to load than everything else
        pretty_exceptions_enable=False,
    )
    app.callback()(options)
    for name, place in COMMANDS.items():
        if first in (name, "new", "select") or first not in COMMANDS:  # these run what they wrote
            module, _, function = place.partition(":")
            app.command(name)(getattr(import_module(f"flexbearing.{module}"), function))
    if first not in COMMANDS:
        app.add_typer(cache_app, name="cache")
    return app


def options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_print_version, is_eager=True, help="print the version"),
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", help="show the traceback of an error")] = False,
) -> None:
    """Take note of what holds for every command; the program looks for --debug itself."""


def check(case: CaseFile, settings: Settings = None) -> None:
    """Check a case for errors, without computing it."""
    title = api.check(case, settings or []).title
    say(f"{case}: {title}: no errors found")


def run(  # noqa: PLR0913  # an argument for each option
    case: CaseFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="OUT.h5")] = None,
    settings: Settings = None,
    start: Annotated[
        Path | None,
        typer.Option("--start", metavar="OTHER.h5", help="result of a neighbouring case where newton begins"),
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="print errors only")] = False,
    everything: Everything = False,
    notes: Notes = False,
    strict: Annotated[bool, typer.Option("--strict", help="exit code 1 where a danger is noted")] = False,
) -> None:
    """Compute a case and store every iteration; prints its answer in a few lines."""
    from flexbearing.progress import Silent, shown
    from flexbearing.runs.run_case import default_output

    console = _terminal()
    _log(everything=not quiet and not sys.stderr.isatty())
    wanted = api.read_case(case, settings or [])
    place = output or default_output(wanted)
    with nullcontext(Silent()) if quiet else shown("run") as report:
        result = api.compute(wanted, output=place, report=report, start=start)
    wrong = _what_went_wrong(result, strict=strict)
    with keeping([place]):
        if not quiet:
            say(f"results: {place}\n")
            _show(result, console, everything=everything, notes=notes)
        for words in wrong if quiet else ():
            sys.stderr.write(f"{case}: {printable(words)}\n")
    raise typer.Exit(NOT_CONVERGED if wrong else CONVERGED)


def _what_went_wrong(result: "Result", *, strict: bool) -> list[str]:
    """Why a run is no success: it did not converge, missed its target, or is dangerous in a strict run."""
    missed = [note["text"] for note in result.dangers if strict or note["code"] == UNMET_TARGET]
    converged = result.attributes["status"] == "converged"
    return missed if converged else [f"not converged: {result.attributes['message']}", *missed]


def life(
    case: CaseFile,
    settings: Settings = None,
    as_json: AsJson = False,
) -> None:
    """Compare the life of a case with that of a catalogue, and tell what lies between, factor by factor."""
    from flexbearing.progress import shown

    with shown("life"):
        found = api.against_catalogue(case, settings or [])
    if as_json:
        say_json(found)
        return
    from flexbearing.report.catalogue_life import sections
    from flexbearing.report.output import laid_out

    page = sections(all_printable(found))
    sys.stdout.write(laid_out(page, _terminal(), encoding=sys.stdout.encoding))


def summary(
    result: ResultPath,
    everything: Everything = False,
    notes: Notes = False,
    as_json: AsJson = False,
) -> None:
    """Print the answer of a result in a few lines."""
    found = api.read(result)
    if as_json:
        import json

        numbers = json.dumps(found.summary(), indent=2, allow_nan=False)
        sys.stdout.write(numbers.replace("\x7f", r"\u007f") + "\n")  # JSON escapes every other one
    else:
        _show(found, _terminal(), everything=everything, notes=notes)


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
    form: Annotated[
        str,
        typer.Option(
            "--format", metavar="png|svg|pdf", show_default=False, help="of the files; png by default"
        ),
    ] = "png",
    without_titles: Annotated[
        bool, typer.Option("--no-titles", help="no headings, as for a publication")
    ] = False,
) -> None:
    """Draw the pictures of a result, with deformed rings where they are flexible."""
    from flexbearing.case import BadCase
    from flexbearing.report.output import pictures
    from flexbearing.report.picture import FORMATS, Format
    from flexbearing.report.roller import deformed

    if form not in FORMATS:
        raise BadCase(f"--format {printable(form)}: it is one of {', '.join(FORMATS)}")
    style, written = Format(form, titles=not without_titles), []
    found, directory = api.read(result), output or result.parent
    if against is not None:
        _plot_against(found, api.read(against), directory, style)
        return
    with keeping(written):
        for words, draw in (("", pictures), ("of a deformed part: ", deformed.pictures)):
            for picture in draw(found, directory, style):
                if isinstance(picture, Path):
                    written.append(picture)
                    say(f"picture: {picture}")
                else:
                    say(f"no picture {words}{picture}")
    if not written:
        say(f"{result}: nothing was solved, so there is nothing to draw")


def _plot_against(one: "Result", other: "Result", directory: Path, style: "Format") -> None:
    """Draw contacts of two results side by side, and say what else differs in their cases."""
    from flexbearing.report.balls.side_by_side import notes
    from flexbearing.report.output import compared_pictures

    written: list[Path] = []
    with keeping(written):
        for picture in compared_pictures(one, other, directory, style):
            written.append(picture)
            say(f"picture: {picture}")
        for note in notes(one, other):
            say(note)


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
    from flexbearing.progress import shown
    from flexbearing.report.studies.pareto_table import text
    from flexbearing.runs.run_case import stem_of_outputs
    from flexbearing.studies.pareto import NoReference, pareto as study
    from flexbearing.studies.pareto_files import destinations, store

    inputs = api.read_case(case, settings or []).input_files
    if name is None:
        name = stem_of_outputs(case, settings or ()).lstrip(".")
    table, picture = destinations(output, name, inputs)
    try:
        with shown("pareto") as report:
            tell = lambda measured: report.line(_line(measured))  # noqa: E731
            found = study(case, settings or [], solid=solid, tell=tell)
    except NoReference as problem:
        end(problem)
    store(found, table, picture)
    with keeping([table, picture]):
        say(f"\n{text(found)}\ntable: {table}\npicture: {picture}")


def _line(measured: "Measured") -> str:
    """One line for a level that was measured."""
    times = ", ".join(f"{seconds:.2f} s {when}" for when, seconds in measured.times.items())
    return f"{measured.name}: {measured.message or times}"


cache_app = typer.Typer(help="Condensed rings that are kept on disk.", no_args_is_help=True)


@cache_app.command("list")
def cache_list() -> None:
    """List what is kept, with size and last use."""
    from flexbearing.cache import configured, listing

    say(listing(configured()))


@cache_app.command("clear")
def cache_clear() -> None:
    """Delete what is kept."""
    from flexbearing.cache import configured

    say(f"{configured().clear()} condensed rings deleted")


@cache_app.command("path")
def cache_path() -> None:
    """Say where it is kept; the environment variable FLEXBEARING_CACHE names another folder, or "off"."""
    from flexbearing.cache import configured

    say(f"{configured().folder or 'nothing is kept'}")


def explain_key(key: Annotated[str | None, typer.Argument(metavar="[KEY]")] = None) -> None:
    """Explain a key of the case file: unit, default, allowed values, meaning; or study.KEY, optimise.KEY."""
    first, _, rest = (key or "").partition(".")
    if first in ("study", "optimise"):
        from flexbearing.case.explain import explain_file
        from flexbearing.optimise.schema import OptimisationFile
        from flexbearing.studies.file.schema import StudyFile

        model = StudyFile if first == "study" else OptimisationFile
        say(explain_file(rest or None, model).rstrip())
    else:
        say(api.explain(key).rstrip())


def _terminal() -> "Console | None":
    """The terminal with its width and colours; None where the output goes to a file."""
    if not (sys.stdout.isatty() or {"FORCE_COLOR", "TTY_COMPATIBLE"} & set(environ)):
        return None  # rich need not be loaded to know
    from rich.console import Console

    console = Console()
    return console if console.is_terminal else None


def _show(result: "Result", terminal: "Console | None", *, everything: bool, notes: bool) -> None:
    """Print the card of a result, below what else of it is wanted."""
    from flexbearing.results import BadResult

    try:
        card = result.card.with_hint("see --notes, --all")
    except BadResult as problem:  # in its case: its numbers are still there
        say(f"no card: {problem}")
        card, everything = None, True
    if everything:
        from flexbearing.report.output import text

        sys.stdout.write(text(result, terminal, encoding=sys.stdout.encoding) + "\n")
    elif notes:
        from flexbearing.report.output import laid_out
        from flexbearing.report.sections import noted

        sections = noted(all_printable(result.summary()["notes"]))
        sys.stdout.write(laid_out(sections, terminal, encoding=sys.stdout.encoding))
    if card is None:
        return
    sys.stdout.write(card.text(terminal.width) if terminal else card.text())


def _log(*, everything: bool) -> None:
    """Print what the library logs on the error stream: all of it, or only warnings."""
    import logging

    class Shown(logging.Formatter):
        def format(self, record: logging.LogRecord) -> str:
            return printable(super().format(record))

    handler = logging.StreamHandler(sys.stderr) if everything else logging.lastResort
    assert handler
    handler.setFormatter(Shown("%(message)s"))
    if everything:
        logging.basicConfig(handlers=[handler])
        logging.getLogger("flexbearing").setLevel(logging.INFO)
