"""The command `new`; what it does not need is not loaded."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated, Any

import typer

from flexbearing.catalogue.entries import ENTRIES, LIKES, MODELS
from flexbearing.printable import printable


def _option(name: str) -> Any:
    entry = ENTRIES[name]
    return typer.Option(
        *filter(None, (entry.option, entry.letter)), metavar=entry.placeholder, help=entry.meaning
    )


def new(  # noqa: PLR0913  # an argument for each option
    context: typer.Context,
    file: Annotated[
        Path,
        typer.Argument(
            help="case file to write (TOML), a designation such as NU210, or the model"
            " of a gearbox (REXS), whose cases are written to the folder of work",
            metavar="FILE",
        ),
    ],
    like: Annotated[
        str, typer.Option("--like", metavar="KIND", help=" or ".join(LIKES))
    ] = "cylindrical_roller",
    bore: Annotated[str | None, _option("bore")] = None,
    outside: Annotated[str | None, _option("outside")] = None,
    width: Annotated[str | None, _option("width")] = None,
    inner_raceway: Annotated[str | None, _option("inner_raceway")] = None,
    outer_raceway: Annotated[str | None, _option("outer_raceway")] = None,
    pitch_diameter: Annotated[str | None, _option("pitch_diameter")] = None,
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
    balls: Annotated[str | None, _option("balls")] = None,
    oil: Annotated[str | None, _option("oil")] = None,
    temperature: Annotated[str | None, _option("temperature")] = None,
    cleanliness: Annotated[str | None, _option("cleanliness")] = None,
    contact_angle: Annotated[str | None, _option("angle")] = None,
    load: Annotated[str | None, _option("load")] = None,
    axial_load: Annotated[str | None, _option("axial")] = None,
    speed: Annotated[str | None, _option("speed")] = None,
    outer_speed: Annotated[str | None, _option("outer_speed")] = None,
    from_rexs: Annotated[
        Path | None,
        typer.Option(
            "--from-rexs",
            metavar="MODEL.rexs",
            help="take what is not given from a model of a gearbox program; a case for each of its bearings",
        ),
    ] = None,
    rexs_bearing: Annotated[
        str | None,
        typer.Option(
            "--rexs-bearing", metavar="ID", help="component of it, where only one of several is wanted"
        ),
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
    """Write a case from a catalogue page; what the page lacks is assumed, and how much it matters is printed.

    Numbers have units, such as --bore "50 mm" or --load "5 kN". On a terminal, missing entries are prompted.
    """
    options = {
        name: text
        for name, entry in ENTRIES.items()
        if (text := context.params[entry.option.strip("-").replace("-", "_")])
    }

    def tell(words: str) -> None:
        sys.stderr.write(printable(f"{words}\n"))

    about = {"title": title, "source": source, "force": force}
    if from_rexs or file.name.lower().endswith(MODELS):
        written = _of_model(file, from_rexs, rexs_bearing, run, {"given": options, **about}, tell)
    else:
        file, like, options, about = _designated(file, like, options, about, tell)
        written = _of_page(file, like, options, about)
    for case, ratings in written:
        sys.stdout.write(printable(f"case: {case}\n{ratings}"))
        for wanted, name in ((life, "life"), (run, "run")):
            if wanted:
                go_on(context, name, case)


def _designated(
    file: Path, like: str, options: dict[str, str], about: dict[str, Any], tell: Callable[[str], None]
) -> tuple[Path, str, dict[str, str], dict[str, Any]]:
    """What a designation in place of a file stands for; options that are given count more."""
    if file.suffix:
        return file, like, options, about
    from flexbearing.catalogue.designations import designated, plain, unknown

    folder, designation = file.parent, file.name
    settings = _settings()
    found = designated(designation, folder, settings)
    if found is None and not folder.exists():  # a slash of the designation itself, 6208-2RS1/C3
        folder, designation = folder.parent, f"{folder.name}/{designation}"
        found = designated(designation, folder, settings)
    if found is None:
        if "bore" not in options:  # else it is the file of a whole page
            tell(unknown(designation, folder, settings))
        return file, like, options, about
    if plain(found["designation"]) != plain(designation):
        page = found["designation"]
        tell(f"{designation}: the page of {page}; of its suffixes only a clearance class has an effect")
    taken = {name: text for name, text in found.items() if name in ENTRIES}
    about = {
        **about,
        "title": about["title"] or designation,
        "source": about["source"] or found.get("source", ""),
    }
    name = designation.replace(" ", "").replace("/", "-").lower()
    return folder / f"{name}.toml", found.get("like", like), taken | options, about


def _settings() -> Path:
    """The folder of a user's own tables."""
    return Path(typer.get_app_dir("flexbearing"))


def _of_page(
    file: Path, like: str, options: dict[str, str], about: dict[str, Any]
) -> Iterator[tuple[Path, str]]:
    """The case of a page, with questions for what it lacks."""
    from flexbearing.catalogue.new import new as write

    if sys.stdin.isatty() and sys.stdout.isatty():
        from flexbearing.catalogue.questions import answers

        options = options | answers(like, options)
    yield file, write(file, like, options, **about)


def _of_model(
    file: Path, model: Path | None, number: str | None, run: bool, about: dict[str, Any],
    tell: Callable[[str], None],
) -> Iterator[tuple[Path, str]]:  # fmt: skip
    """The cases of a model, which is the file itself where no other is given."""
    from flexbearing.catalogue.rexs import Order, case_file, cases
    from flexbearing.files import require_outputs
    from flexbearing.runs.run_case import usual_output

    if model is None:
        file, model = case_file(file), file
    require_outputs([file, *([usual_output(file)] if run else [])], [model])
    yield from cases(file, Order(model, number, settings=_settings(), **about), tell)


def go_on(context: typer.Context, name: str, file: Path) -> None:
    """Do what another command does with the case."""
    program = context.parent
    assert program is not None
    command = program.command.get_command(program, name)  # type: ignore[attr-defined]
    with command.make_context(name, [str(file)], parent=program) as further:
        command.invoke(further)
