"""Loads, pressure, clearance, stiffness and lubrication of the bearing."""

from collections.abc import Iterator

from flexbearing.findings.strength import CONTACT_PRESSURE
from flexbearing.outputs import outputs
from flexbearing.report.card.card import Item
from flexbearing.report.card.verdict import kind
from flexbearing.report.html import checks, clearance, ratings, stiffness as supports
from flexbearing.report.html.document import Number
from flexbearing.report.html.elements import most_loaded
from flexbearing.report.html.lives import lives, rounded
from flexbearing.report.html.reader import Reader


def loads(reader: Reader) -> Iterator[Item]:
    """The largest load and the peak pressure."""
    most = most_loaded(reader, reader.last)
    if most is not None:
        yield Item(f"largest {most.word}", most.load, remark=f"{most.carrying} of {most.count} loaded")
    pressures = [
        check for check in checks.ranked(reader)
        if check.what.lower().startswith(CONTACT_PRESSURE.label) and isinstance(check.value, Number)
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
    if (way := clearance.along_diagonal(reader)) is not None:
        yield Item("clearance along a diagonal", way)
        return
    found = reader.attributes.get("clearance") or {}
    if found.get("operating_m") is None:
        return

    def number(path: str) -> Number:
        return reader.of_attribute(f"clearance/{path}", "m", "um", ".1f")

    ends = None
    if "ends" in found.get("tolerances", {}):
        ends = number(clearance.TIGHT), number("tolerances/ends/loosest_m")
    mark = "" if found["steps"] else clearance.origin(reader).partition(",")[0]
    yield Item("clearance", number("operating_m"), ends, mark if mark in ("assumed", "fitted") else "")


def _stiffness(reader: Reader) -> Iterator[Item]:
    """Of a bearing on elastic supports with and without them, as far as both are springs in series."""
    known, block = {each.name: each for each in outputs(reader.layout)}, reader.blocks[reader.last]
    name, label = ("stiffness",) * 2 if "stiffness" in known else ("stiffness_zz", "stiffness along z")
    both = reader.scalar(known["total_stiffness"]) if supports.supported(reader) else None
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
    for life in (life for life in lives(reader) if life.chosen):
        unit = life.hours.unit if isinstance(life.hours, Number) else life.turns.unit
        number = reader.output(life.output, unit, ",.4g", first)
        yield Item(f"{kind(life)}:", rounded(number))
