"""The command `select`; what it does not need is not loaded."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexbearing.program.commands import AsJson, end, keeping, say, say_json

if TYPE_CHECKING:
    from flexbearing.select.application import Application
    from flexbearing.select.candidates import Candidate
    from flexbearing.select.selection import Card, Selection

SHOWN = 6  # lines of lighter bearings, and of heavier ones
LINE = "{:<14}{:>16} {:>9} {:>8} {:>8} {:>8} {:>10} {:>6}  {}"
HEADS = ("designation", "d x D x B [mm]", "mass [kg]", "C [kN]", "P_m [kN]", "req. C", "life [h]", "s_0", "")


def select(  # noqa: PLR0913  # an argument for each option
    context: typer.Context,
    required_life: Annotated[
        str, typer.Option("--required-life", metavar="TIME", help='basic rating life, such as "20000 h"')
    ],
    table: Annotated[
        Path | None,
        typer.Argument(
            help="table of designations (CSV); by default those that `new` reads", metavar="TABLE"
        ),
    ] = None,
    load: Annotated[str | None, typer.Option("--load", metavar="FORCE", help="radial load")] = None,
    axial_load: Annotated[
        str | None, typer.Option("--axial-load", metavar="FORCE", help="axial load")
    ] = None,
    speed: Annotated[str | None, typer.Option("--speed", metavar="SPEED", help="of the inner ring")] = None,
    outer_speed: Annotated[
        str | None, typer.Option("--outer-speed", metavar="SPEED", help="of the outer ring")
    ] = None,
    spectrum: Annotated[
        Path | None,
        typer.Option(
            "--spectrum",
            metavar="FILE",
            help="table of loads and speeds with their shares (CSV), as of [duty]",
        ),
    ] = None,
    reliability: Annotated[
        float | None, typer.Option("--reliability", min=0.9, max=0.9995, help="of the life; by default 0.9")
    ] = None,
    application_factor: Annotated[
        float, typer.Option("--application-factor", min=1e-3, help="on loads for life and static safety")
    ] = 1.0,
    bore: Annotated[
        str | None, typer.Option("--bore", metavar="LENGTH", help="only bearings of this bore")
    ] = None,
    max_outside: Annotated[
        str | None, typer.Option("--max-outside", metavar="LENGTH", help="largest outside diameter")
    ] = None,
    max_width: Annotated[
        str | None, typer.Option("--max-width", metavar="LENGTH", help="largest width")
    ] = None,
    like: Annotated[
        str | None, typer.Option("--like", metavar="KIND", help="only bearings of this kind")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE.csv", help="all candidates as a table")
    ] = None,
    as_json: AsJson = False,
    run: Annotated[
        bool, typer.Option("--run", help="write the case of the chosen bearing as `new` does, and compute it")
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="replace the case that is there already")] = False,
) -> None:
    """Select the lightest bearing of a table that keeps life, static safety, speed and minimum load.

    Everything is by the formulas of a catalogue, ISO 281 and ISO 76; only --run computes the chosen one.
    """
    from flexbearing.files import as_csv, require_outputs, write
    from flexbearing.select import selection

    read = _tables(table)
    written = [output] if output else []
    require_outputs(written, [*read, *([spectrum] if spectrum else [])])
    options = {"load": load, "axial": axial_load, "speed": speed, "outer_speed": outer_speed}
    application = _application(options, spectrum, required_life, application_factor, reliability)
    sizes = {"bore": bore, "outside": max_outside, "width": max_width}
    found = selection.selection(application, _candidates(read, sizes, like))
    if output:
        write(output.resolve(), as_csv([selection.COLUMNS, *map(selection.row, found.cards)]).encode())
    with keeping(written):
        if as_json:
            say_json(selection.as_json(found))
        else:
            say(_words(found))
        if found.chosen is None:
            end("no bearing of the table keeps all limits")
        if run:
            _compute(context, found.chosen, application, [*read, *written], force=force)


def _tables(table: Path | None) -> list[Path]:
    """Tables whose bearings are candidates."""
    from flexbearing.catalogue.designations import tables

    return [table] if table else tables(Path(), Path(typer.get_app_dir("flexbearing")))


def _application(
    options: dict[str, str | None], spectrum: Path | None, life: str, factor: float, reliability: float | None
) -> "Application":
    """What the bearing is for; an option that cannot be read is called by its name."""
    from flexbearing.catalogue.page import value
    from flexbearing.select.application import read

    given = {name: text for name, text in options.items() if text}
    for name, text in given.items():
        value(name, text, "deep_groove_ball")
    return read(given, spectrum, life, factor, reliability)


def _candidates(tables: list[Path], limits: dict[str, str | None], like: str | None) -> "list[Candidate]":
    """Bearings of the tables that are small enough, of a kind."""
    from flexbearing.case import BadCase
    from flexbearing.catalogue.entries import LIKES
    from flexbearing.catalogue.page import value
    from flexbearing.select.candidates import SIZES, candidates

    if like is not None and like not in LIKES:
        raise BadCase(f"--like {like}: it is none of {', '.join(LIKES)}.")
    sizes = {name: value(name, text, "deep_groove_ball").si for name, text in limits.items() if text}
    found = [
        each
        for each in candidates(tables)
        if (like is None or each.like == like)
        and all(
            abs(size - sizes[name]) < 1e-9 if name == "bore" else size <= sizes[name] * (1 + 1e-9)
            for name, size in zip(SIZES, each.sizes, strict=True)
            if name in sizes
        )
    ]
    if not found:
        raise BadCase(f"{', '.join(map(str, tables))}: no bearing is of such a size and kind.")
    return found


def _words(found: "Selection") -> str:
    """The chosen bearing between its neighbours by mass, a line for each."""
    place = found.cards.index(found.chosen) if found.chosen else len(found.cards)
    first, last = max(0, place - SHOWN), place + SHOWN
    shown = found.cards[first:last]
    rest = len(found.cards) - len(shown)
    more = [f"{rest} more in the table of -o, and with --json"] * bool(rest)
    estimates = any(card.candidate.given_mass is None for card in shown)
    notes = ["~ mass estimated from d, D and B, * rating by ISO 281 and ISO 76 from the sizes"] * estimates
    return "\n".join([*_head(found), LINE.format(*HEADS).rstrip(), *map(_line, shown), *notes, *more])


def _head(found: "Selection") -> list[str]:
    """What is required, what is chosen."""
    from flexbearing.select.selection import HOUR, sentences

    of = found.application
    assert of.spectrum.required is not None
    rows = f", {len(of.spectrum.shares)} rows of loads" * (len(of.spectrum.shares) > 1)
    reliability = f"{100 * (of.reliability or 0.9):.4g} % reliability"
    lines = [
        f"required: {of.spectrum.required / HOUR:,.6g} h at {reliability}, "
        f"application factor {of.spectrum.application_factor:g}{rows}"
    ]
    if found.chosen is None:
        return [*lines, ""]
    chosen = found.chosen.candidate
    source = chosen.source or "no source given"
    lines.append(f"chosen: {chosen.designation}, the lightest that keeps all limits ({source})")
    lighter = [card for card in found.cards[: found.cards.index(found.chosen)] if card.rated]
    if lighter:
        why = sentences(lighter[-1])[0]
        lines.append(f"the next lighter one, {lighter[-1].candidate.designation}: {why}")
    return [*lines, ""]


def _line(card: "Card") -> str:
    from flexbearing.select.selection import HOUR, KN

    of, rated = card.candidate, card.rated
    sizes = " x ".join(f"{1e3 * size:g}" for size in of.sizes)
    mass = f"{'~' * (of.given_mass is None)}{of.mass:.3g}"
    numbers = ["-"] * 5
    if rated:
        by_formula = "*" * ("C_r" not in rated.by_maker)
        numbers = [
            f"{by_formula}{rated.dynamic_rating / KN:.4g}", f"{rated.mean_load / KN:.4g}",
            f"{rated.required_rating / KN:.4g}", f"{rated.life / HOUR:,.0f}", f"{rated.static_safety:.3g}",
        ]  # fmt: skip
    return LINE.format(of.designation, sizes, mass, *numbers, card.verdict or "keeps all limits")


def _compute(
    context: typer.Context, chosen: "Card", application: "Application", used: list[Path], *, force: bool
) -> None:
    """Write the case of the chosen bearing at the loads that do most damage, and compute it."""
    from flexbearing.catalogue.command import go_on
    from flexbearing.catalogue.new import new
    from flexbearing.files import require_outputs
    from flexbearing.runs.run_case import usual_output

    of, file = chosen.candidate, Path(chosen.candidate.file)
    require_outputs([file, usual_output(file)], used)
    assert chosen.rated is not None
    loads = {name: application.text(name, chosen.rated.row) for name in application.rows}
    ratings = new(file, of.like, {**of.entries, **loads}, title=of.designation, source=of.source, force=force)
    say(f"\ncase: {file}\n{ratings}")
    go_on(context, "run", file)
