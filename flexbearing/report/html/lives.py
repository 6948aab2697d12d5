"""Lives of a result from the basic to the modified one, each with what it is."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi, prod
from typing import Any

from flexbearing.report.html.document import Cell, Number
from flexbearing.report.html.reader import Reader

_BASIC_OF_ROLLERS = "capacities of Lundberg and Palmgren, loads of all slices of all rollers"
_BASIC_OF_BALLS = "ISO/TS 16281: loads of all balls on both raceways"
_LOADS = "load"  # effect of factors on capacities and loads, which make the reference life of the basic one
_NAMES = {  # of the life after the factors of loads, by that which says most
    "rating": "Life L10 of the radial load alone, ISO 281",
    "capacity": "Reference life L10r, ISO/TS 16281",
}


@dataclass(frozen=True)
class Life:
    """A life of the last end state."""

    name: str
    turns: Number  # [10^6 revolutions]
    hours: Cell  # empty where nothing turns
    meaning: str


def lives(reader: Reader) -> Iterator[Life]:
    """Basic life, reference life and modified life, as far as the case asks for them."""
    block = reader.blocks.get(reader.last, {})
    if "life_L10" not in block:
        return
    yield _output(reader, "life_L10", "Basic life L10", basic(reader))
    found = (reader.attributes.get("life") or {}).get(reader.last)
    if not found:
        return
    of_loads = [factor for factor in found["factors"] if factor["effect"] == _LOADS]
    if of_loads:
        names = [factor["name"] for factor in of_loads]
        name = next((words for key, words in _NAMES.items() if key in names), "Life L10 with these factors")
        value = found["basic_Mrev"] * prod(factor["value"] for factor in of_loads)
        yield _product(reader, name, value, f"basic life times the factors of {', '.join(names)}")
    if "modified_life" in block and len(of_loads) < len(found["factors"]):
        names = [factor["name"] for factor in found["factors"] if factor["effect"] != _LOADS]
        meaning = f"{'the life above' if of_loads else 'basic life'} times {', '.join(names)}"
        yield _output(reader, "modified_life", "Modified life", meaning)


def basic(reader: Reader) -> str:
    """What the basic life of a result is: its capacities and loads."""
    bearing = reader.attributes["case_si"]["bearing"]
    if "roller" not in bearing:
        return _BASIC_OF_BALLS
    whole = "; the most loaded roller on half-spaces" if bearing.get("contact") == "half_space" else ""
    return _BASIC_OF_ROLLERS + whole


def _output(reader: Reader, name: str, label: str, meaning: str) -> Life:
    turning = reader.blocks[reader.last].get("relative_speed")
    hours: Cell = reader.output(name, "h", ",.4g") if turning else ""
    return Life(label, reader.output(name, "Mrev", ",.4g"), hours, meaning)


def _product(reader: Reader, label: str, turns: float, meaning: str) -> Life:
    place = f"reference_life/{reader.last}"
    speed: Any = reader.blocks[reader.last].get("relative_speed")
    hours: Cell = ""
    if speed:
        value = 1e6 * turns * 2 * pi / abs(float(speed)) / 3600
        hours = reader.units.number(value, "h", "h", ",.4g", f"{place}/h")
    return Life(label, reader.units.number(turns, "Mrev", "Mrev", ",.4g", f"{place}/Mrev"), hours, meaning)
