"""The command `new`; what it does not need is not loaded."""

import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.printable import printable


def _option(name: str) -> Any:
    entry = ENTRIES[name]
    return typer.Option(
        *filter(None, (entry.option, entry.letter)), metavar=entry.placeholder, help=entry.meaning
    )


def new(  # noqa: PLR0913  # an argument for each option
    context: typer.Context,
    file: Annotated[Path, typer.Argument(help="case file to write (TOML)", metavar="FILE")],
    like: Annotated[
        str, typer.Option("--like", metavar="KIND", help=" or ".join(LIKES))
    ] = "cylindrical_roller",
    bore: Annotated[str | None, _option("bore")] = None,
    outside: Annotated[str | None, _option("outside")] = None,
    width: Annotated[str | None, _option("width")] = None,
    inner_raceway: Annotated[str | None, _option("inner_raceway")] = None,
    outer_raceway: Annotated[str | None, _option("outer_raceway")] = None,
    elements: Annotated[str | None, _option("elements")] = None,
    diameter: Annotated[str | None, _option("diameter")] = None,
    length: Annotated[str | None, _option("length")] = None,
    dynamic_rating: Annotated[str | None, _option("dynamic_rating")] = None,
    static_rating: Annotated[str | None, _option("static_rating")] = None,
    fatigue_limit: Annotated[str | None, _option("fatigue_limit")] = None,
    clearance: Annotated[str | None, _option("clearance")] = None,
    clearance_class: Annotated[str | None, _option("clearance_class")] = None,
    shaft: Annotated[str | None, _option("shaft")] = None,
    housing: Annotated[str | None, _option("housing")] = None,
    material: Annotated[str | None, _option("material")] = None,
    oil: Annotated[str | None, _option("oil")] = None,
    temperature: Annotated[str | None, _option("temperature")] = None,
    cleanliness: Annotated[str | None, _option("cleanliness")] = None,
    contact_angle: Annotated[str | None, _option("angle")] = None,
    load: Annotated[str | None, _option("load")] = None,
    axial_load: Annotated[str | None, _option("axial")] = None,
    speed: Annotated[str | None, _option("speed")] = None,
    from_rexs: Annotated[
        Path | None,
        typer.Option(
            "--from-rexs",
            metavar="MODEL.rexs",
            help="take what is not given from a model of a gearbox program",
        ),
    ] = None,
    rexs_bearing: Annotated[
        str | None, typer.Option("--rexs-bearing", metavar="ID", help="component of it, where it has several")
    ] = None,
    title: Annotated[str, typer.Option("--title", help="what the case is, for people")] = "",
    source: Annotated[str, typer.Option("--source", help="where the numbers come from")] = "",
    force: Annotated[
        bool, typer.Option("--force", help="replace a file that is there already, except one that is read")
    ] = False,
    run: Annotated[bool, typer.Option("--run", help="compute the case as well")] = False,
    life: Annotated[
        bool, typer.Option("--life", help="compare its life with the catalogue's as well")
    ] = False,
) -> None:
    """Write a case from a catalogue page; what the page lacks is assumed, and how much it matters is told.

    Numbers have units, such as --bore "50 mm" or --load "5 kN". On a terminal, what is missing is asked for.
    """
    from flexbearing.catalogue.new import new as write

    options: dict[str, str | None] = {
        name: context.params[entry.option.strip("-").replace("-", "_")] for name, entry in ENTRIES.items()
    }
    if from_rexs:
        from flexbearing.catalogue.rexs import options as of_model
        from flexbearing.files import require_outputs
        from flexbearing.runs.run_case import usual_output

        require_outputs([file, *([usual_output(file)] if run else [])], [from_rexs])
        like, found = of_model(from_rexs, rexs_bearing)
        options = {**found, **{name: text for name, text in options.items() if text}}
        source = source or f"REXS, {from_rexs.name}"
    if sys.stdin.isatty() and sys.stdout.isatty():
        from flexbearing.catalogue.questions import answers

        options |= answers(like, {name: text for name, text in options.items() if text})

    def tell(words: str) -> None:
        sys.stderr.write(printable(f"{words}\n"))

    ratings = write(file, like, options, title=title, source=source, force=force, tell=tell)
    sys.stdout.write(printable(f"case: {file}\n{ratings}"))
    for wanted, name in ((life, "life"), (run, "run")):
        if wanted:
            _go_on(context, name, file)


def _go_on(context: typer.Context, name: str, file: Path) -> None:
    """Do what another command does with the case."""
    program = context.parent
    assert program is not None
    command = program.command.get_command(program, name)  # type: ignore[attr-defined]
    with command.make_context(name, [str(file)], parent=program) as further:
        command.invoke(further)
