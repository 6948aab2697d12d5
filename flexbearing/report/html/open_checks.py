"""What no run can judge: each item with who checks it, and with what."""

from collections.abc import Iterator
from math import pi
from typing import Any

import numpy as np

from flexbearing.findings.running import REQUIRED_LIFE
from flexbearing.report.html import heat, shaft_tilt
from flexbearing.report.html.check import Check, unchecked
from flexbearing.report.html.document import Number
from flexbearing.report.html.lives import lives
from flexbearing.report.html.reader import Reader

_SLIP = (
    "no standard limits it; a minimum load is the usual rule against smearing. It is how far the cage lags "
    "behind pure rolling"
)
_ROLLS = (
    "met: zero to the printed digit, as traction of the loaded rollers is far above drag and friction of the "
    "cage; unloaded rollers may slip"
)
_FITTED = "lubricant.oil_fraction was fitted to a cage slip, so this is no prediction"
_TILT = "no standard limits it; makers give the tilt that a bearing may have"
_TILT_OF_ROLLERS = {
    "ring_tilt": "slope of its axis, dz/dx (dy/dx where that is larger); an outer ring on an elastic support "
    "tilts along: see the slope between the raceways",
    "roller_tilt": "no standard limits it, positive: +x end further out; it presses the ends of the roller",
}
_LIMITS_OF_HEAT = "bearing maker: steel and cage; oil supplier: oil"
_THERMAL = "thermal analyst or a test: temperatures of shaft, rings and housing"
_MAKER_OF_TILT = "bearing maker: permissible tilt"
_ALIGNED = (
    "operation.misalignment is 0, as the case gives no slope of the shaft; a bent shaft or seats out of line "
    "press the roller ends"
)
_NEVER = {  # why, who checks it
    "Strength of the cage": (
        "no stress of the cage is computed",
        "cage maker: pocket forces (Rollers) and speed",
    ),
    "Creep of the rings in their seats": (
        "whether a ring turns in its seat is not computed",
        "designer: fit tables of the maker for a rotating or a stationary load",
    ),
}
_HOOP = "Hoop stress of the rings by fit and speed"
_IN_RINGS = {False: "rigid rings have no stress", True: "not in the stress of a flexible ring"}  # flexible


def checks(reader: Reader) -> Iterator[Check]:
    """Life, tilt, slip, heat and speed, then what is not computed at all."""
    yield from _life(reader)
    yield from _tilts(reader)
    yield from _alignment(reader)
    yield from _slip(reader)
    yield _temperature(reader)
    yield _heat(reader)
    yield _speed(reader)
    for what, (why, who) in _NEVER.items():
        yield unchecked(what, why, who)
    yield unchecked(
        _HOOP,
        _IN_RINGS["flexible" in reader.blocks],
        "designer: formulas of thick rings with fit pressure and speed",
    )


def _life(reader: Reader) -> Iterator[Check]:
    """The life has a limit that only the reader knows."""
    first = next(iter(lives(reader)), None)
    judged = {each["code"] for each in reader.attributes.get("findings") or ()}
    if first is not None and first.chosen and REQUIRED_LIFE.code not in judged:
        do = "give life.required, or compare the life with the required one"
        why, who = "the case states no life.required", "designer: required life, of the kind that it names"
        yield unchecked(f"Life: {first.name}", why, who, first.hours or first.turns, do)


def _tilts(reader: Reader) -> Iterator[Check]:
    """Largest slopes of inner ring and rollers."""
    block = reader.blocks[reader.last]
    for name, what in (("ring_tilt", "Tilt of the inner ring"), ("roller_tilt", "Largest tilt of a roller")):
        if name in block and np.any(sizes := np.abs(np.ravel(block[name]))):
            value = reader.element(reader.last, name, int(np.argmax(sizes)), digits=".3g")
            why = _TILT_OF_ROLLERS[name] if reader.of_rollers else _TILT
            who = _MAKER_OF_TILT
            if name == "ring_tilt" and shaft_tilt.free(reader):
                why, who = "; ".join(filter(None, (shaft_tilt.steep(reader), why))), shaft_tilt.WHO
                why = ". ".join(filter(None, (why, shaft_tilt.clamps(reader))))
            yield unchecked(what, why, who, value)


def _alignment(reader: Reader) -> Iterator[Check]:
    """That the slope of the shaft is not known, where the case holds the inner ring straight."""
    if straight(reader):
        do = "set operation.misalignment to the slope of the shaft"
        yield unchecked("Misalignment of the shaft", _ALIGNED, "shaft designer: slope at the bearing", do=do)


def straight(reader: Reader) -> bool:
    """Whether the inner ring is held without slope, and nobody said so."""
    operation, about = reader.attributes["case_si"].get("operation", {}), reader.attributes
    held = reader.of_rollers and operation.get("tilt") == "fixed" and not operation.get("misalignment")
    given = "operation.misalignment" in reader.written
    return held and (not given or "operation.misalignment" in about["assumed"])


def rolls(reader: Reader) -> bool:
    """Whether the cage turns as in pure rolling, to the printed digit."""
    slips = (entry for entry in reader.layout.summary if entry.label == "cage slip")
    return any(not reader.declared(entry, reader.last).text.strip("0.") for entry in slips)


def _slip(reader: Reader) -> Iterator[Check]:
    for entry in (entry for entry in reader.layout.summary if entry.label == "cage slip"):
        value = reader.declared(entry, reader.last)
        if rolls(reader):
            yield Check("Cage slip", value, verdict=_ROLLS)
            continue
        fitted = f"; {_FITTED}" * ("lubricant.oil_fraction" in reader.attributes["calibrated"])
        yield unchecked("Cage slip", _SLIP + fitted, "bearing maker, or a measured cage speed", value)


def _temperature(reader: Reader) -> Check:
    """The highest temperature, whose limits no case has."""
    known = reader.attributes["case_si"].get("operation", {}).get("temperatures") or {}
    parts = {name: value for name, value in known.items() if name != "reference" and isinstance(value, float)}
    who = _LIMITS_OF_HEAT
    if parts:
        part = max(parts, key=parts.__getitem__)
        path = f"case/operation.temperatures.{part}"
        value: Any = reader.units.number(parts[part], "K", "degC", ",.4g", path)
        what = f"Highest temperature given, {part.replace('_', ' ')}"
        return unchecked(what, "the case has no limits of steel, cage and lubricant", who, value)
    steps = (reader.attributes.get("clearance") or {}).get("steps")
    do = "give [operation.temperatures]: a warmer inner ring takes clearance" if steps else ""
    who = f"{_THERMAL}, for the clearance; limits: {who}" if steps else who
    return unchecked("Temperature", "the case gives no temperatures of parts", who, do=do)


def _heat(reader: Reader) -> Check:
    """Power to be carried away, and how much of it hangs on a fitted oil fraction."""
    who = "thermal analyst: power against oil flow times its warming"
    power = float(reader.blocks[reader.last].get("driving_power", 0.0))
    if not power:
        return unchecked("Heat balance", "power and temperatures are not computed", who)
    given = reader.attributes["case_si"].get("operation", {}).get("temperatures")
    why = f"temperatures are {'given, ' if given else ''}not computed from the power and the oil flow"
    if bound := heat.at_most(reader):
        why += f"; {bound}"
    if "lubricant.oil_fraction" in reader.attributes["calibrated"]:
        share = float(reader.blocks[reader.last]["loss_drag"]) / power
        why += f"; {share:.0%} of it are drag by the fitted lubricant.oil_fraction"
    value = reader.element(reader.last, "driving_power", digits=",.4g")
    return unchecked("Heat balance: driving power", why, who, value)


def _speed(reader: Reader) -> Check:
    """The speed factor n d_m, which makers limit."""
    value = speed_factor(reader)
    what = "Speed" if value is None else "Speed: n·d_m [mm/min]"
    who = "bearing maker: limiting speed of bearing and cage"
    return unchecked(what, "the case has no limiting speed of the maker", who, value or "")


def speed_factor(reader: Reader) -> Number | None:
    """Speed of the rings in 1/min times the pitch diameter in mm; None where one of them is missing."""
    bearing, turning = reader.bearing, reader.blocks[reader.last].get("relative_speed")
    pitch = bearing.get("pitch_diameter")
    if reader.of_rollers:
        pitch = bearing["outer_raceway_diameter"] - bearing["roller"]["diameter"]
    if not turning or not pitch:
        return None
    value = abs(float(turning)) * 30 / pi * 1e3 * pitch
    return reader.units.number(value, "", "", ",.3g", f"speed_factor/{reader.last}")
