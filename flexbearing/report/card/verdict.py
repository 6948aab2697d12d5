"""Whether a bearing can be used, and how long."""

from collections.abc import Iterator, Sequence
from textwrap import shorten

from flexbearing.findings import DANGER, NOT_CHECKED
from flexbearing.findings.running import REQUIRED_LIFE
from flexbearing.report.card.card import Item
from flexbearing.report.html import effects, lives as of_report
from flexbearing.report.html.checks import (
    BUILD,
    NOTED,
    Check,
    judged,
    missed_at_low_end,
    ranked,
    used,
    verdict,
)
from flexbearing.report.html.document import Number
from flexbearing.report.html.lives import rounded
from flexbearing.report.html.reader import Reader

_LONGEST = 160  # characters of a danger
_MOST = 3  # limits of damage that are named
_AUTHORS = ", Lundberg and Palmgren"  # of a life, which its kind names


def usable(reader: Reader) -> Iterator[Item]:
    """The verdict of the report, then the limits that are not kept, or the nearest one."""
    checks = ranked(reader)
    yield Item(judged(reader).partition(":")[0].rstrip("."))
    broken = [check for check in checks if check.broken]
    yield from _missed(broken) if broken else _nearest(checks)
    for check in checks:
        if check.urgent and isinstance(check.value, Number):
            yield Item(
                check.place.removesuffix(" (nominal)") or lower(check.what), check.value, remark="no limit"
            )
        elif check.unchecked and check.code in NOTED:
            yield Item(lower(check.what), remark=NOT_CHECKED)


def dangers(reader: Reader) -> Iterator[Item]:
    """The first danger that no limit covers."""
    limits = {record["code"] for record in reader.attributes.get("findings") or ()}
    for note in reader.attributes["notes"]:
        if note["grade"] == DANGER and note["code"] not in limits:
            yield Item(shorten(note["text"], _LONGEST, placeholder=" ..."))
            return


def _missed(broken: Sequence[Check]) -> Iterator[Item]:
    """Limits of damage that are not kept, else the gravest of all, and how many others there are."""
    shown = [check for check in broken if check.grade == DANGER][:_MOST] or broken[:1]
    if len(broken) > 1 and [check.code for check in shown] == [REQUIRED_LIFE.code]:
        other = next(check for check in broken if check not in shown)
        yield Item(f"unmet: life, {lower(other.what)}")
        shown = [*shown, other]
    else:
        yield from map(_missing, shown)
    overlapping = [check for check in broken if check.grade == BUILD and check not in shown]
    yield from (Item(f"{lower(check.what)} overlap") for check in overlapping)
    if others := len(broken) - len(shown) - len(overlapping):
        yield Item(f"{others} more unmet")


def _missing(check: Check) -> Item:
    """A limit that is not kept; the numbers of a required life are those of the life."""
    if check.what.lower() == REQUIRED_LIFE.label:
        return Item("required life not reached")
    if isinstance(check.value, str):
        return Item(lower(f"{check.what} (required: {check.limit})"))
    return Item(lower(check.what), check.value, remark=check.limit)


def _nearest(checks: Sequence[Check]) -> Iterator[Item]:
    check = next((check for check in checks if check.used), None)
    if check is not None:
        yield Item(f"nearest limit: {lower(check.what)}", remark=used(check))


def lives(reader: Reader) -> Iterator[Item]:
    """The most detailed life with its range and against the required one; that of a catalogue."""
    required = (reader.attributes["case_si"].get("life") or {}).get("required")
    if why := of_report.why_none(reader):
        yield Item("none:", why)
    for life in of_report.lives(reader):
        number = life.hours if isinstance(life.hours, Number) else life.turns
        if life.chosen:
            yield Item(f"{kind(life)}:", rounded(number), _range(reader, number))
            yield _required(reader, required)
        elif life.key == "catalogue":
            yield Item(f"{kind(life).partition(',')[0]}:", rounded(number))


def _range(reader: Reader, number: Number) -> tuple[Number, Number] | None:
    span = effects.span(reader)
    return None if span is None else (rounded(number, span.squares[0]), rounded(number, span.squares[1]))


def _required(reader: Reader, required: float | None) -> Item:
    """The required life [s] with the verdict of the run."""
    if required is None:
        return Item("required: none")
    limit = reader.units.number(required, "s", "h", ",.4g", "case/life.required")
    known = verdict(reader, REQUIRED_LIFE.code) or NOT_CHECKED
    return Item(
        "required", limit, remark=f"{known}, not at the low end" if missed_at_low_end(reader) else known
    )


def kind(life: of_report.Life) -> str:
    """What life it is, in words."""
    return lower(life.name.removesuffix(_AUTHORS))


def lower(words: str) -> str:
    """Words that a sentence does not begin with."""
    return words[:1].lower() + words[1:]
