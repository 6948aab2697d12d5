"""The text of a case file: keys with comments, table by table."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from textwrap import wrap

from flexbearing.case.declarations import by_path, toml
from flexbearing.case.quantity import Section
from flexbearing.catalogue.element_set import ElementSet, span
from flexbearing.catalogue.page import Page

WIDTH = 110  # characters of a line
COLUMN = 40  # where short comments begin
THUMB = "rule of thumb"
RATED = "C_0 of the maker by ISO 76"
WITHOUT_CLEARANCE = (  # classes of ISO 5753-1: their clearance follows from the contact angle, or is stated
    "angular_contact_ball", "tapered_roller", "thrust_roller", "spherical_roller"
)  # fmt: skip
CHOSEN = "chosen, no catalogue has it"  # load, speed, fits, oil


@dataclass(frozen=True)
class Line:
    """A key of a case with its value."""

    key: str
    value: str | float | bool
    why: str = ""  # where it comes from
    assumed: bool = False


def assumed(key: str, value: str | float | bool, why: str) -> Line:
    """A line whose value nothing gives."""
    return Line(key, value, why, assumed=True)


def entry(page: Page, name: str, key: str, why: str = "") -> Line:
    """The line of an entry, marked where the entry is assumed."""
    if name in page.assumed:
        return assumed(key, page[name].text, page.assumed[name])
    return Line(key, page[name].text, why)


def speeds(page: Page) -> Iterator[Line]:
    """Speed of the inner ring, and of an outer one that turns."""
    yield entry(page, "speed", "operation.inner_speed", CHOSEN)
    if "outer_speed" in page:
        yield entry(page, "outer_speed", "operation.outer_speed", CHOSEN)


def from_rating(page: Page, elements: ElementSet) -> str:
    """Where an assumed size of rolling elements comes from, with a static rating of the maker."""
    ratio = elements.rated(*elements.chosen).static / page["static_rating"].si
    return f"{'from' if abs(ratio - 1) < 1e-6 else 'nearest to'} {RATED}"


def usual_number(elements: ElementSet, usual: str, size: str, rated: bool) -> str:
    """Where an assumed number of rolling elements comes from."""
    few, many = elements.pairs[0][0], elements.pairs[-1][0]
    verb = "fit" if few < many else "alone fits"
    of_size = f", and C_0 of the maker then gives a usual {size}" if rated else ""
    return f"{span(few, many)} {verb} {usual}{of_size}"


def rollers_of(page: Page, rollers: ElementSet, usual: str, lengths: str) -> tuple[Line, Line]:
    """Number and effective length of the rollers; where assumed, a pair that has C_0 of the maker."""
    rated, counted, measured = (name in page for name in ("static_rating", "elements", "length"))
    number, length = rollers.chosen
    count = Line("bearing.rollers", number)
    if not counted:
        why = f"nearest to {RATED}" if rated and measured else usual_number(rollers, usual, "length", rated)
        count = assumed("bearing.rollers", number, why)
    if measured:
        return count, Line("bearing.roller.length", page["length"].text)
    why = from_rating(page, rollers) if rated else f"{THUMB}, the middle of {lengths}"
    return count, assumed("bearing.roller.length", mm(length), why)


def materials(page: Page) -> Iterator[Line]:
    """Materials of rollers and rings."""
    for part in ("roller", "inner_ring", "outer_ring"):
        if "material" in page:
            yield Line(f"materials.{part}", page["material"].text)
        else:
            yield assumed(f"materials.{part}", "100Cr6", "the usual bearing steel")


def mm(length: float) -> str:
    """Write a length [m] as a case would, rounded."""
    return f"{length * 1e3:.4g} mm"


def text(head: str, title: str, lines: Iterable[Line], model: type[Section]) -> str:
    """Write a case file."""
    tables: dict[str, list[Line]] = {}
    for line in lines:
        assert line.key in by_path(model), line.key
        tables.setdefault(line.key.rpartition(".")[0], []).append(line)
    parts = [f"# {words}".rstrip() for words in head.splitlines()]
    parts += [f"{line.key} = {toml(line.value)}" for line in tables.pop("", ())]
    inside_tables = [line for inside in tables.values() for line in inside]
    parts += [f"title = {toml(title)}", "", *_assumed(inside_tables)]
    for table, inside in tables.items():
        parts += ["", f"[{table}]", *(written for line in inside for written in _written(line))]
    return "\n".join(parts) + "\n"


def _assumed(lines: list[Line]) -> list[str]:
    names = ", ".join(toml(line.key) for line in lines if line.assumed)
    indent = " " * 4
    rows = wrap(names + ",", WIDTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False)
    return ["assumed = [", *rows, "]"]


def _written(line: Line) -> Iterator[str]:
    given = f"{line.key.rpartition('.')[2]} = {toml(line.value)}"
    why = ("assumed: " if line.assumed else "") + line.why
    beside = f"{given.ljust(COLUMN - 1)} # {why}"
    if why and len(beside) > WIDTH:
        yield from wrap(why, WIDTH, initial_indent="# ", subsequent_indent="# ", break_on_hyphens=False)
        yield given
    else:
        yield beside if why else given


def oil(page: Page) -> Iterator[Line]:
    """The oil and its temperature."""
    if "oil" in page:
        yield Line("lubricant.oil", page["oil"].text, CHOSEN)
    else:
        yield assumed("lubricant.oil", "ISO VG 68", "usual for rolling bearings")
    if "temperature" in page:
        yield Line("lubricant.inlet_temperature", page["temperature"].text)
    else:
        yield assumed("lubricant.inlet_temperature", "70 degC", THUMB)


def life(page: Page) -> Iterator[Line]:
    """Ratings of the maker where they are given, and what modifies the life."""
    why = "of the maker, with these balls" if "balls" in page else "of the maker"
    ratings = {"dynamic_rating": "", "static_rating": "", "fatigue_limit": "_load"}
    for name, ending in ratings.items():
        if name in page:
            yield Line(f"life.{name}{ending}", page[name].text, why)
    yield Line("life.lubrication", "a_ISO", "modified life of ISO 281")
    if "cleanliness" in page:
        yield Line("life.cleanliness", page["cleanliness"].text)
    else:
        yield assumed("life.cleanliness", "oil, in-line filter, -/17/14", "usual cleanliness")


def mounting(page: Page) -> Iterator[Line]:
    """Clearance in operation, or before mounting with the fits that change it."""
    if "clearance" in page:
        yield Line("bearing.clearance", page["clearance"].text, "in operation")
    elif page.like not in WITHOUT_CLEARANCE:
        yield _clearance_class(page)
    if not _fitted(page):
        return
    if "shaft" in page:
        yield Line("bearing.fits.shaft", page["shaft"].text, CHOSEN)
    else:
        yield assumed("bearing.fits.shaft", "k5", f"{THUMB} for a rotating inner ring")
    yield Line("bearing.fits.bore", page["bore"].text)
    yield Line("bearing.fits.at", "mean", "the middle of all tolerance classes")
    if page.like != "squirrel_cage":
        yield Line("bearing.fits.outer_diameter", page["outside"].text)
    if "housing" in page:
        yield Line("bearing.fits.housing.tolerance_class", page["housing"].text, CHOSEN)
        why = f"{THUMB}, 1.5 times that of the bearing"
        yield assumed("bearing.fits.housing.diameter", mm(1.5 * page["outside"].si), why)


def surroundings(page: Page) -> Iterator[Line]:
    """Materials of shaft and housing, where fits need them."""
    if _fitted(page):
        yield assumed("materials.shaft", "structural steel", "the usual")
    if _fitted(page) and "housing" in page:
        yield assumed("materials.housing", "grey cast iron", "the usual")


def _fitted(page: Page) -> bool:
    """Whether the fits of the rings count."""
    if page.like in WITHOUT_CLEARANCE:
        return "shaft" in page or "housing" in page
    return "clearance" not in page


def _clearance_class(page: Page) -> Line:
    if "clearance_class" in page:
        return Line(
            "bearing.clearance_class", page["clearance_class"].text, "chosen among those of ISO 5753-1"
        )
    why = "bearings without suffix have the Normal class"
    return assumed("bearing.clearance_class", "CN", why)
