"""From the entries of a catalogue page to a case file."""

from collections.abc import Callable, Mapping
from pathlib import Path

from flexbearing.case import BadCase, Head, understood
from flexbearing.case.family import Family
from flexbearing.catalogue import page as pages
from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.head import one_line, origin
from flexbearing.catalogue.lines import Line, Settings, as_settings, text
from flexbearing.catalogue.page import Page
from flexbearing.catalogue.ratings import table
from flexbearing.catalogue.weights import NO_RESULT, Measured, told, weighed
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput, require_output, write
from flexbearing.outputs import outputs
from quasidynamic import ImpossiblePart, OutOfRange

Tell = Callable[[str], None]
QUICK: dict[str, Settings] = {
    "squirrel_cage": {"accuracy.structure": "beam"}
}  # with which lives are compared


def new(  # noqa: PLR0913  # an argument for each option
    file: str | Path,
    like: str,
    options: Mapping[str, str | None],
    *,
    title: str = "",
    source: str = "",
    force: bool = False,
    tell: Tell = lambda words: None,
    assumed: Mapping[str, str] | None = None,
) -> str:
    """Write a case from the page of a catalogue.

    Parameters
    ----------
    file : path
        of the case
    like : str
        one of `flexbearing.catalogue.entries.LIKES`
    options : mapping
        name of an entry, such as "bore", to its text, such as "50 mm"
    title : str
        of the case; the name of the file without it
    source : str
        where the numbers come from, for the head of the file
    force : bool
        whether a file of this name is replaced
    tell : callable (words), optional
        hears how often the case is computed, before it is
    assumed : mapping, optional
        entries among the options that nobody gave, each with the reason for its value

    Returns
    -------
    str
        load ratings of the maker beside those of the formulas, as lines

    Raises
    ------
    BadCase
        one line for each entry that is missing or impossible, and where no case can be made of them
    BadOutput
        for a file that is there already, or cannot be written
    NotStored
        if it could not be written, as on a full disk
    """
    wanted = pages.read(like, options, assumed)
    place = require_output(file)
    if place.exists() and not force:
        raise BadOutput(f"{file}: is there already; --force replaces it.")
    try:
        written, ratings = _case(wanted, place, title, source, tell)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{problem}.") from problem
    write(place, written.encode())
    return ratings


def _case(page: Page, file: Path, title: str, source: str, tell: Tell) -> tuple[str, str]:
    """Text of the case of a page, and the ratings in it."""
    lines, ratings = _lines(page)
    from flexbearing.runs.validate import require_possible

    family = FAMILIES[LIKES[page.like].kind]
    model, comparable = family.case(), QUICK.get(page.like, {})
    plain = text("", title or file.stem, lines, model)
    require_possible(understood(plain, file, {}, FAMILIES), family)  # before anything is computed
    measured = _measured(
        family, lambda settings: understood(plain, file, as_settings(comparable | settings), FAMILIES)
    )
    tell(f"computing the case with {sum(len(line.others) for line in lines)} other values of what is assumed")
    try:
        basis = measured({})
        lines = weighed(lines, basis, measured)
        weights = told(basis, comparable)
    except NO_RESULT as problem:
        weights = f"How much assumed values matter is not known: {one_line(str(problem))}"
    head = [*origin(page, file, title, source), "", *weights.splitlines(), *ratings.splitlines()]
    return text("\n".join(head), title or file.stem, lines, model), ratings


def _lines(page: Page) -> tuple[list[Line], str]:
    """Lines of the case of a page, and its ratings; a refusal loads only what belongs to the kind."""
    if LIKES[page.like].kind == "cylindrical_roller":
        from flexbearing.catalogue import roller_lines
        from flexbearing.catalogue.roller_set import roller_set

        rollers = roller_set(page)
        return roller_lines.lines(page, rollers), table(page, rollers, "length")
    from flexbearing.catalogue import ball_lines
    from flexbearing.catalogue.ball_set import ball_set

    balls = ball_set(page, ball_lines.angle(page))
    return ball_lines.lines(page, balls), table(page, balls, "diameter")


def _measured(family: Family, case_with: Callable[[Settings], Head]) -> Measured:
    """What computes the outputs that are compared, of a case with settings."""
    from flexbearing.api import compute
    from flexbearing.quantities.effects import LIVES
    from flexbearing.runs import assumed_effects

    named = dict(family.layout().weighed)
    known = {each.name: each for each in outputs(family.layout())}

    def measured(settings: Settings) -> dict[str, float]:
        values = assumed_effects.measured(compute(case_with(settings), compared=True))
        life = [("life", values[each]) for each in LIVES if each in values]
        told = (each for each in named if each in values and not known[each].rounds_to_zero(values[each]))
        return dict([*life[:1], *((named[each], values[each]) for each in told)])

    return measured
