"""From the entries of a catalogue page to a case file."""

from collections.abc import Mapping
from pathlib import Path

from flexbearing.case import BadCase, understood
from flexbearing.catalogue import page as pages
from flexbearing.catalogue.element_set import table
from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.catalogue.lines import WIDTH, Line, text
from flexbearing.catalogue.page import Page
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput, require_output, write
from flexbearing.printable import printable
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange

EFFECTS = "outputs.assumed_effects"
ELASTIC = "squirrel_cage"  # whose effects take minutes
NO_RESULT = (BadCase, NotSolved, OutOfRange)  # of a case that cannot be computed


def new(  # noqa: PLR0913  # an argument for each option
    file: str | Path,
    like: str,
    options: Mapping[str, str | None],
    *,
    title: str = "",
    source: str = "",
    force: bool = False,
    assumed: Mapping[str, str] | None = None,
) -> str:
    """Write a case from the page of a catalogue; of the options, `assumed` are those that nobody gave.

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
    from flexbearing.runs import effects_file

    place = require_output(file)
    stored = require_output(effects_file.name(place))
    if place.exists() and not force:
        raise BadOutput(f"{file}: is there already; --force replaces it.")
    try:
        written, ratings = _case(wanted, place, title, source)
        effects = _effects(like, written, place)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{problem}.") from problem
    write(place, written.encode())
    if isinstance(effects, str):
        return f"{ratings}effects: {effects}\n"
    write(stored, effects)
    return f"{ratings}effects: {effects_file.name(Path(file))}\n"


def case_text(
    like: str, options: Mapping[str, str | None], file: Path, title: str = "", source: str = ""
) -> tuple[str, str]:
    """Text of the case of a catalogue page, and the ratings in it; nothing is written.

    Raises `BadCase` as `new`.
    """
    try:
        return _case(pages.read(like, options), file, title, source)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{problem}.") from problem


def _case(page: Page, file: Path, title: str, source: str) -> tuple[str, str]:
    """Text of the case of a page, and the ratings in it."""
    lines, ratings = _lines(page)
    head = [*origin(page, file, title, source), *ratings.splitlines()]
    model = FAMILIES[LIKES[page.like].kind].case()
    return text("\n".join(head), title or file.stem, lines, model), ratings


def _lines(page: Page) -> tuple[list[Line], str]:
    """Lines of the case of a page, and its ratings; a refusal loads only what belongs to the kind."""
    if LIKES[page.like].kind == "cylindrical_roller":
        from flexbearing.catalogue import roller_lines
        from flexbearing.catalogue.roller_set import roller_set

        rollers = roller_set(page)
        return roller_lines.lines(page, rollers), table(page, rollers, "length")
    if page.like in ("tapered_roller", "thrust_roller", "spherical_roller"):
        from flexbearing.catalogue import tapered_lines
        from flexbearing.catalogue.tapered_set import tapered_set

        rollers = tapered_set(page)
        return tapered_lines.lines(page, rollers), table(page, rollers, "length")
    from flexbearing.catalogue import ball_lines
    from flexbearing.catalogue.ball_set import ball_set

    balls = ball_set(page, ball_lines.angle(page))
    return ball_lines.lines(page, balls), table(page, balls, "diameter")


def _effects(like: str, written: str, file: Path) -> bytes | str:
    """The file of what other values of assumed keys make of the case, or why there is none."""
    from flexbearing.progress import shown
    from flexbearing.runs import effects_file
    from flexbearing.runs.run_case import effects
    from flexbearing.runs.validate import require_possible

    family = FAMILIES[LIKES[like].kind]
    case = understood(written, file, {}, FAMILIES)
    require_possible(case, family)  # before anything is computed
    if like == ELASTIC:
        return f"flexbearing run {file} --set {EFFECTS}=true; flexbearing export OUT.h5 --to effects"
    try:
        with shown("new") as report:
            return effects_file.content(case, effects(case, family, report))
    except NO_RESULT as problem:
        return f"not known: {one_line(str(problem))}"


def origin(page: Page, file: Path, title: str, source: str) -> list[str]:
    """Source of the numbers, and the command."""
    words = [f"flexbearing new {_quoted(file.name)}", f"--like {page.like}"]
    estimated = {*LIKES[page.like].two_of} & {*page.assumed}
    words += [
        f"{ENTRIES[name].option} {_quoted(value.text)}"
        for name, value in page.values.items()
        if name not in estimated
    ]
    words += [f"{name} {_quoted(text)}" for name, text in (("--title", title), ("--source", source)) if text]
    rows = [f"  {words[0]}"]
    for word in words[1:]:
        if len(rows[-1]) + len(word) > WIDTH - 5:
            rows[-1] += " \\"
            rows.append("     ")
        rows[-1] += f" {word}"
    whence = f"From a catalogue: {one_line(source)}." if source else "From the page of a catalogue."
    return [whence, "Written by", "", *rows]


def one_line(text: str) -> str:
    """Write a text so that it is one line of a comment."""
    return printable(" ".join(text.split()))


def _quoted(text: str) -> str:
    """Write a text as a word of a command line, where it needs it."""
    plain = one_line(text)
    for special in '\\"$`':
        plain = plain.replace(special, f"\\{special}")
    return plain if plain.replace(".", "").replace("-", "").isalnum() else f'"{plain}"'
