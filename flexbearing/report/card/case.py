"""What was computed, and what of it is least certain."""

from collections.abc import Iterator
from typing import Any

from flexbearing.quantities.effects import LIVES
from flexbearing.report.card.card import Item
from flexbearing.report.html import effects
from flexbearing.report.html.document import Number
from flexbearing.report.html.inputs import origin
from flexbearing.report.html.reader import Reader, flat

_MOST = 2  # inputs that are named
_OPERATION = {  # keys of [operation] to words
    "radial_load": "radial load", "moment": "moment", "load.axial": "axial load",
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
            assumed = "assumed" if origin(reader, f"operation.{name}") == "assumed" else ""
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
    mark = origin(reader, "lubricant.inlet_temperature")
    temperature = reader.units.of_key(warm, "K", "case/lubricant.inlet_temperature")
    yield Item(f"{name} at" if mark == "given" else f"{name} at {mark}", temperature)


def _moved(reader: Reader, output: str) -> str:
    return "life" if output in LIVES else effects.label(reader, output)


def uncertain(reader: Reader) -> Iterator[Item]:
    """Inputs that are not known and move the life most; without their effects, how many there are."""
    if reader.attributes.get("assumed_effects"):
        output = effects.most_moved(reader)
        for place, (key, ratios) in enumerate(effects.largest(reader, output, _MOST)):
            words = f"x{_span(ratios)} by {effects.name(key)}"
            yield Item(words if place else f"{_moved(reader, output)} {words}")
        return
    counts = {word: len(reader.attributes[name]) for word, name in _COUNTED.items()}
    if words := " and ".join(f"{count} {word}" for word, count in counts.items() if count):
        yield Item(f"not known: inputs {words}, effects not computed (outputs.assumed_effects = true)")


_COUNTED = {"assumed": "assumed", "fitted": "calibrated"}


def _span(ratios: list[Number]) -> str:
    return "..".join(dict.fromkeys(each.text for each in (ratios[0], ratios[-1])))
