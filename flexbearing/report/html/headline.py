"""First block: what the verdict is, then in a short list what it rests on."""

from collections.abc import Iterator, Sequence

from flexbearing.findings import DANGER, OUTSIDE, USUAL
from flexbearing.quantities.effects import CHOICE
from flexbearing.report.html import assumed_effects, beyond_range, clearance, combined
from flexbearing.report.html.against_limits import ranked
from flexbearing.report.html.check import BUILD, MISSED, WORST_FIRST, Check, one, text_of
from flexbearing.report.html.document import Block, Items, Number, Words
from flexbearing.report.html.lives import lives
from flexbearing.report.html.open_checks import straight
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.sentences import rounded

LONG = 1e5  # [h] life above which fatigue does not end the service of a machine
HALF = 0.5  # of every limit: below, none is near
_SHORT = {  # by the worst grade
    DANGER: "No: a limit of damage is exceeded.",
    OUTSIDE: "Not assured: a law is used outside its range.",
    BUILD: "Not as drawn: dimensions overlap.",
    USUAL: "Only with a reason: a usual minimum or maximum is not kept.",
    "": "Yes, as far as checked.",
}
_REMAINS = "A life this long means that lubricant, wear or seals end the service, not fatigue."


def blocks(reader: Reader) -> Iterator[Block]:
    """The verdict in a sentence for each grade that is not kept; then lives, what is open, what is left."""
    checks = ranked(reader)
    for sentence, colour in _sentences(reader, checks):
        yield Words((sentence,), colour)
    yield Items("", tuple(filter(None, _lines(reader, checks))))


def grade(reader: Reader, checks: Sequence[Check]) -> str:
    """The worst grade of what is not kept; empty where all is."""
    found = {check.grade for check in checks if check.broken} | ({DANGER} if reader.notes(DANGER) else set())
    return next((each for each in WORST_FIRST if each in found), "")


def judged(reader: Reader) -> str:
    """Whether the bearing can be used, in a few words."""
    checks = ranked(reader)
    if reader.notes(DANGER) and not _of(checks, DANGER):
        return "No: see the dangers."
    return _SHORT[grade(reader, checks)]


def _of(checks: Sequence[Check], wanted: str) -> list[Check]:
    return [check for check in checks if check.broken and check.grade == wanted]


def _named(checks: Sequence[Check]) -> str:
    return "; ".join(map(one, checks))


def _sentences(reader: Reader, checks: Sequence[Check]) -> Iterator[tuple[str, str]]:
    """A sentence for each grade with its colour, the worst first; where all is kept, the nearest limit."""
    damage, validity, aims = (_of(checks, each) for each in (DANGER, OUTSIDE, USUAL))
    warned = bool(reader.notes(DANGER))
    if damage:
        yield f"Not to be used as computed. Limits of damage exceeded: {_named(damage)}.", "danger"
    elif warned:
        yield "Not to be used as computed: see the dangers below.", "danger"
    if validity:
        kept = "" if damage or warned else " No limit of damage that was checked is exceeded."
        yield f"Not assured, outside the range of a law: {_named(validity)}.{kept}", "danger"
    if _of(checks, BUILD):
        yield "It cannot be built as assumed: dimensions overlap, see the notes.", "danger"
    for side, words in MISSED.items():
        if found := [check for check in aims if check.side == side]:
            yield f"{words}: {_named(found)}.", "warning"
    if not grade(reader, checks):
        yield _kept(reader, checks), "good"


def _kept(reader: Reader, checks: Sequence[Check]) -> str:
    """That all is kept, how far the nearest limit is, and which warmth takes all clearance."""
    nearest = next((check for check in checks if check.used), None)
    words = "Usable as far as checked: every limit that was checked is met."
    if nearest is None:
        return words
    near = "Nearest" if nearest.used > HALF else "None is near at this load; nearest"
    return " ".join(filter(None, (f"{words} {near}: {one(nearest)}.", tight_end(reader))))


def _lines(reader: Reader, checks: Sequence[Check]) -> Iterator[str]:
    yield from _life(reader)
    if urgent := [f"{check.what}: {text_of(check.value)}" for check in checks
                  if check.urgent and isinstance(check.value, Number)]:  # fmt: skip
        yield f"Possibly the first limit, without a strength in the case: {'; '.join(urgent)}."
    yield tight_end(reader) if grade(reader, checks) else ""  # else beside the nearest limit
    if straight(reader) and (changed := assumed_effects.of_life(reader, "operation.misalignment")):
        yield f"Misalignment of the shaft is assumed to be none: {changed}."
    left = sum(check.unchecked for check in checks)
    yield f"{left} items are not checked here: [who checks them, with what](#not-checked)."


def _life(reader: Reader) -> Iterator[str]:
    """The life of the case with its range, what it leaves out, and the catalogue's."""
    first = next(iter(lives(reader)), None)
    if first is None or not first.chosen:
        return
    number, unit = (
        (first.hours, "h") if isinstance(first.hours, Number) else (first.turns, "million revolutions")
    )
    words = f"{first.name} of this case: {rounded(number)} {unit}{beyond_range.with_oil(reader)}."
    if (span := combined.of(reader, combined.LIFE)) is not None:
        low, high = (rounded(number, times) for times in span.squares)
        oil = beyond_range.of_oil(reader)
        words += (
            f" Range{' without the oil' * bool(oil)}: {low} to {high} {unit} by what is assumed, fitted or "
        )
        words += f"toleranced{', and by choices of the case' * bool(assumed_effects.keys(reader, CHOICE))}"
        words += f"; all changes that shorten it at once leave {rounded(number, span.worst[0])} {unit}."
        words += f" {end}" if (end := beyond_range.of_upper_end(reader)) else ""
        missing = [each for each in beyond_range.left_out(reader) if each != oil]
        words += f" Not in this range: {'; '.join(missing)}." if missing else ""
    if unit == "h" and number.size > LONG:
        words += f" {_REMAINS}"
    yield words
    rated = next((life.hours for life in lives(reader) if life.key == "catalogue"), None)
    if isinstance(rated, Number):
        yield (
            f"Catalogue's life L10h of ISO 281: {rounded(rated)} h. Compare it with a required life, for "
            "requirements that name no other."
        )


def tight_end(reader: Reader) -> str:
    """Which warmth takes all clearance at its tight end, where no temperatures are given; else empty."""
    tight = "ends" in ((reader.attributes.get("clearance") or {}).get("tolerances") or {})
    warmer = clearance.warmth(reader, clearance.TIGHT) if tight else None
    if warmer is None or reader.attributes["case_si"]["operation"].get("temperatures"):
        return ""
    return (
        "The case gives no temperatures: at the tight end of the tolerances an inner ring "
        f"{warmer} K warmer than the outer one takes all clearance."
    )
