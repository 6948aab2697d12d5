"""The facts of a card: loads, stiffness, what was computed, whether it can be used, and what is uncertain."""

from collections.abc import Iterator, Sequence
from textwrap import shorten
from typing import Any

from flexbearing.findings import DANGER, NOT_CHECKED
from flexbearing.findings.load_limits import BARS, CONTACT_PRESSURE
from flexbearing.findings.running import REQUIRED_LIFE
from flexbearing.outputs import outputs
from flexbearing.quantities.attributes import GRADES
from flexbearing.quantities.effects import LIVES
from flexbearing.report.card.layout import Card, Item, Line
from flexbearing.report.html import checks, effects, inputs, lives as of_report, origin, ratings, rings
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
from flexbearing.report.html.elements import most_loaded
from flexbearing.report.html.lives import rounded
from flexbearing.report.html.reader import Reader, flat
from flexbearing.report.html.units import METRIC
from flexbearing.results import Result


def loads(reader: Reader) -> Iterator[Item]:
    """The largest load and the peak pressure."""
    most = most_loaded(reader, reader.last)
    if most is not None:
        yield Item(f"largest {most.word}", most.load, remark=f"{most.carrying} of {most.count} loaded")
    pressures = [
        check for check in checks.ranked(reader)
        if check.code == CONTACT_PRESSURE.code and isinstance(check.value, Number)
    ]  # fmt: skip
    if pressures:
        worst = max(pressures, key=lambda check: check.used)
        without_ends = worst.verdict == checks.MET_BY_SLICES
        yield Item(
            "peak pressure", worst.value, remark="ends left out" if without_ends else checks.used(worst)
        )


def stiffness(reader: Reader) -> Iterator[Item]:
    """Clearance, radial stiffness, viscosity ratio and film ratio, as far as the result has them."""
    yield from _clearance(reader)
    yield from _stiffness(reader)
    if (kappa := ratings.viscosity_ratio(reader)) is not None:
        yield Item("kappa", kappa)
    ratios = reader.summary[reader.last].get("minimum_lambda") or {}
    if known := {race: ratio for race, ratio in ratios.items() if ratio is not None}:
        race = min(known, key=known.__getitem__)
        path = f"summary/{reader.last}/minimum_lambda/{race}"
        yield Item("film ratio", reader.units.number(known[race], "", "", ".2f", path))


def _clearance(reader: Reader) -> Iterator[Item]:
    if (way := rings.along_diagonal(reader)) is not None:
        yield Item("clearance along a diagonal", way)
        return
    found = reader.attributes.get("clearance") or {}
    if found.get("operating_m") is None:
        return

    def number(path: str) -> Number:
        return reader.of_attribute(f"clearance/{path}", "m", "um", ".1f")

    ends = None
    if "ends" in found.get("tolerances", {}):
        ends = number(rings.TIGHT), number("tolerances/ends/loosest_m")
    mark = "" if found["steps"] else rings.clearance_origin(reader)
    yield Item("clearance", number("operating_m"), ends, mark if mark in ("assumed", "fitted") else "")


def _stiffness(reader: Reader) -> Iterator[Item]:
    """Of a bearing on elastic supports with and without them, as far as both are springs in series."""
    known, block = {each.name: each for each in outputs(reader.layout)}, reader.blocks[reader.last]
    name, label = ("stiffness",) * 2 if "stiffness" in known else ("stiffness_zz", "stiffness along z")
    both = reader.scalar(known["total_stiffness"]) if rings.supported(reader) else None
    if name in known and all(each in block for each in known[name].declared.of):
        yield Item(label, reader.scalar(known[name]), remark=f"{both.text} with supports" if both else "")
    elif both:
        yield Item("stiffness with supports", both)


def rigid(reader: Reader) -> Iterator[Item]:
    """What rigid rings would give, where rings are elastic; nothing where a cam is left out between them."""
    on_cam = (reader.attributes["case_si"].get("inner") or {}).get("kind") == "cam"
    if len(reader.blocks) < 2 or on_cam:
        return
    first = next(iter(reader.blocks))
    if (most := most_loaded(reader, first)) is not None:
        yield Item(f"largest {most.word}", most.load, remark=f"{most.carrying} loaded")
    for life in (life for life in of_report.lives(reader) if life.chosen):
        unit = life.hours.unit if isinstance(life.hours, Number) else life.turns.unit
        number = reader.output(life.output, unit, ",.4g", first)
        yield Item(f"{kind(life)}:", rounded(number))


_INPUTS = 2  # inputs that are named
_OPERATION = {  # keys of [operation] to words
    "radial_load": "radial load", "axial_load": "axial load", "moment": "moment", "load.axial": "axial load",
    "load.radial_y": "radial load along y", "load.radial_z": "radial load along z",
    "load.moment_y": "moment about y", "load.moment_z": "moment about z",
    "displacement.axial": "axial displacement", "displacement.radial_y": "displacement along y",
    "displacement.radial_z": "displacement along z", "speed": "", "inner_speed": "",
    "outer_speed": "outer ring",
}  # fmt: skip


def computed(reader: Reader) -> Iterator[Item]:
    """Loads, speeds and oil of the case."""
    yield from _operation(reader)
    yield from _oil(reader)


def _operation(reader: Reader) -> Iterator[Item]:
    """What is not zero of loads, displacements and speeds."""
    given = dict(flat(reader.attributes["case_si"].get("operation") or {}))
    for name, words in _OPERATION.items():
        value = given.get(name)
        if isinstance(value, int | float) and value:
            assumed = "assumed" if inputs.origin(reader, f"operation.{name}") == "assumed" else ""
            label = " ".join(filter(None, (assumed, words)))
            yield Item(label, reader.units.of_key(value, _unit(name), f"case/operation.{name}"))


def _unit(name: str) -> str:
    if "speed" in name:
        return "rad/s"
    if "moment" in name:
        return "N m"
    return "m" if name.startswith("displacement.") else "N"


def _oil(reader: Reader) -> Iterator[Item]:
    """Name and temperature of the oil, with where the temperature comes from."""
    known: dict[str, Any] = reader.attributes["case_si"].get("lubricant") or {}
    warm = known.get("inlet_temperature")
    if warm is None:
        return
    name = known["oil"] if isinstance(known.get("oil"), str) else "oil"
    mark = inputs.origin(reader, "lubricant.inlet_temperature")
    temperature = reader.units.of_key(warm, "K", "case/lubricant.inlet_temperature")
    yield Item(f"{name} at" if mark == "given" else f"{name} at {mark}", temperature)


def _moved(reader: Reader, output: str) -> str:
    return "life" if output in LIVES else effects.label(reader, output)


def uncertain(reader: Reader) -> Iterator[Item]:
    """Inputs that are not known and move the life most; without their effects, how many there are."""
    if reader.effects is not None:
        output = effects.most_moved(reader)
        for place, (key, ratios) in enumerate(effects.largest(reader, output, _INPUTS)):
            words = f"x{_span(ratios)} by {effects.name(key)}"
            yield Item(words if place else f"{_moved(reader, output)} {words}")
        return
    counts = {word: len(reader.attributes[name]) for word, name in _COUNTED.items()}
    if words := " and ".join(f"{count} {word}" for word, count in counts.items() if count):
        yield Item(f"not known: inputs {words}, effects not computed (outputs.assumed_effects = true)")


_COUNTED = {"assumed": "assumed", "fitted": "calibrated"}


def _span(ratios: list[Number]) -> str:
    return "..".join(dict.fromkeys(each.text for each in (ratios[0], ratios[-1])))


_LONGEST = 160  # characters of a danger
_MOST = 3  # limits of damage that are named
_PLACES = {BARS: "squirrel-cage bars"}  # in short


def usable(reader: Reader) -> Iterator[Item]:
    """The verdict of the report, then the limits that are not kept, or the nearest one."""
    checks = ranked(reader)
    yield Item(judged(reader)[0])
    broken = [check for check in checks if check.broken]
    yield from _missed(broken) if broken else _nearest(checks)
    for check in checks:
        if check.urgent and isinstance(check.value, Number):
            place = _PLACES.get(check.place, check.place)
            yield Item(place or lower(check.what), check.value, remark="no limit")
        elif check.unchecked and check.code in NOTED:
            yield Item(lower(check.what), remark=NOT_CHECKED)


def dangers(reader: Reader) -> Iterator[Item]:
    """The first danger that no limit covers."""
    limits = {record.code for record in reader.findings}
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
    if check.code == REQUIRED_LIFE.code:
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
            yield Item(f"{lower(life.kind)}:", rounded(number))


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
    return lower(life.kind if life.source == of_report.AUTHORS else life.name)


def lower(words: str) -> str:
    """Words that a sentence does not begin with."""
    return words[:1].lower() + words[1:]


_LONGEST_ENDING = 400  # characters of why there is no answer
_ANSWERS = {
    "usable": usable, "danger": dangers, "life": lives, "load": loads, "bearing": stiffness, "rigid": rigid,
    "uncertain": uncertain,
}  # fmt: skip


def of_result(result: Result) -> Card:
    """What was computed, whether it can be used, and its main numbers; of no solution, why there is none."""
    reader = Reader(result, METRIC)
    solved = reader.attributes["status"] == "converged" and bool(reader.blocks)
    known = {"": computed, **(_ANSWERS if solved else {"danger": dangers}), "notes": _notes}
    lines = ((label, tuple(items(reader))) for label, items in known.items())
    return Card(
        reader.attributes["title"] or result.stem,
        tuple(Line(label, items) for label, items in lines if items),
        "" if solved else shorten(origin.ending(reader), _LONGEST_ENDING, placeholder=" ..."),
    )


def _notes(reader: Reader) -> Iterator[Item]:
    """How many notes of each grade there are."""
    counts = {grade: len(reader.notes(grade)) for grade in GRADES}
    words = ", ".join(f"{count} {grade}" for grade, count in counts.items() if count)
    yield Item(words or "none")
