"""How the shaft holds the inner ring, what the other way makes of the life, and tilts that no shaft has."""

from math import log, pi

import numpy as np

from flexbearing.report.html.assumptions import WORTH
from flexbearing.report.html.reader import Reader

WHO = "shaft or rotor designer: how far the shaft holds the inner ring, and its slope at the bearing"
_CLAMPS = (
    "Position and tilt of the ring are those of its piece of shaft as a whole: the position is free, the "
    "tilt is free or held by operation.tilt. The clamped ends hold that piece only in the finite elements "
    "that give the elastic deflection on top"
)
_ARCMIN = pi / 180 / 60  # [rad]
_STEEP = 10 * _ARCMIN  # slope that hardly any shaft has at a bearing, a rule of thumb


def otherwise(reader: Reader) -> tuple[str, float] | None:
    """The other `operation.tilt`, and its basic life over that of the case; None where it is not known."""
    other, life = (reader.attributes.get("tilt") or {}).get("otherwise"), _life(reader)
    return (other["inner_ring"], other["life_L10_Mrev"] / life) if other and life else None


def stiffness(reader: Reader) -> str:
    """Radial stiffnesses where the shaft holds the ring otherwise, in words; empty where none are known."""
    other = (reader.attributes.get("tilt") or {}).get("otherwise") or {}
    if "total_stiffness_z_N_per_m" not in other:
        return ""

    def stated(which: str) -> str:
        paths = {axis: f"tilt/otherwise/{which}stiffness_{axis}_N_per_m" for axis in "zy"}
        numbers = {axis: reader.of_attribute(path, "N/m", "kN/mm", ",.4g") for axis, path in paths.items()}
        return ", ".join(f"{number.text} {number.unit} along {axis}" for axis, number in numbers.items())

    how = other["inner_ring"]
    alone = f"bearing alone, {stated('')}; " if "stiffness_z_N_per_m" in other else ""
    return f'With operation.tilt = "{how}": {alone}with supports, {stated("total_")}.'


def loads(reader: Reader) -> str:
    """Pressure, stress of the bars and life where the shaft holds the ring otherwise; empty: not known."""
    other = (reader.attributes.get("tilt") or {}).get("otherwise") or {}
    if "peak_pressure_MPa" not in other:
        return ""
    named = {"peak pressure": "peak_pressure_MPa", "nominal stress of the bars": "nominal_bar_stress_MPa"}
    numbers = {
        words: reader.of_attribute(f"tilt/otherwise/{name}", "MPa", "MPa", ",.4g")
        for words, name in named.items()
        if name in other
    }
    life = reader.of_attribute("tilt/otherwise/life_L10_Mrev", "Mrev", "Mrev", ",.4g")
    stated = ", ".join(f"{words} {number.text} {number.unit}" for words, number in numbers.items())
    how = other["inner_ring"]
    return f'With operation.tilt = "{how}": {stated}, basic life {life.text} million revolutions.'


def _life(reader: Reader) -> float | None:
    return (reader.summary.get(reader.last) or {}).get("life_L10_Mrev")


def free(reader: Reader) -> bool:
    """Whether nothing but the bearing holds the tilt of the inner ring."""
    return (reader.attributes.get("tilt") or {}).get("inner_ring") == "free"


def clamps(reader: Reader) -> str:
    """What the clamped ends of the shaft hold, without a stop; empty without such a shaft."""
    kind = (reader.attributes["case_si"].get("inner") or {}).get("kind")
    return _CLAMPS if kind == "ring_on_shaft" else ""


def steep(reader: Reader) -> str:
    """That a free ring tilts more than shafts do, for a sentence; empty where it does not."""
    slopes = reader.blocks.get(reader.last, {}).get("ring_tilt")
    if not free(reader) or slopes is None:
        return ""
    size = float(np.hypot(*np.ravel(slopes)))
    return f"{size / _ARCMIN:.0f} arcmin, which hardly any shaft allows" if size > _STEEP else ""


def step(reader: Reader) -> str:
    """To ask how the shaft holds the inner ring, where that matters for the life; empty elsewhere."""
    known = otherwise(reader)
    if known is None or abs(log(known[1])) < log(WORTH):
        return ""
    how, ratio = known
    tilts = f"; free, it tilts by {words}" if (words := steep(reader)) else ""
    return (
        "ask the shaft or rotor designer whether the shaft lets the inner ring tilt (operation.tilt): with "
        f'"{how}" the basic life is {ratio:.3g} times as long{tilts}'
    )
