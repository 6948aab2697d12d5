"""What ISO 281 says of the oil of a case: both viscosities, their ratio, and the largest a_ISO."""

from collections.abc import Callable
from math import floor, inf

from flexbearing.findings.running import VISCOSITY_RATIO
from flexbearing.report.html import ratings
from flexbearing.report.html.document import Number
from flexbearing.report.html.reader import Reader, once

_LOW, _HIGH, _STEP = -20, 300, 10  # [°C] temperatures that are tried
_ZERO = 273.15  # [K]
_WARMER = 20.0  # [K] by which rings are warmer than the oil that is worth a remark, a rule of thumb


@once
def _rated(reader: Reader, settings: tuple[str, ...] = ()) -> dict[str, float]:
    """Of the oil, at the loads of the case; empty without one, at rest, and where its data do not reach."""
    catalogue, path = reader.result.family.catalogue, life_of_loads(reader)
    if catalogue is None or not path:
        return {}
    try:
        return catalogue().oil(reader.case_with(settings), _life(reader, path))
    except ValueError:
        return {}


@once
def life_of_loads(reader: Reader) -> str:
    """Place of the life by loads alone, whose equivalent load a_ISO takes; empty without a finite one."""
    rated, block = ratings.found(reader), reader.blocks.get(reader.last, {})
    if isinstance(rated, str):
        return ""
    name = next((each for each in ("reference_life", "life_L10") if each in block), "")
    if not name or reader.attributes["case_si"]["life"].get("loads") == "rating":
        return f"{rated[1]}/life_Mrev"
    return f"outputs/{reader.last}.{name} [Mrev]" if 0 < float(block[name]) < inf else ""


def _life(reader: Reader, path: str) -> float:
    kind, _, rest = path.partition("/")
    if kind == "outputs":
        return float(reader.result[rest].number)
    known = ratings.found(reader)
    assert not isinstance(known, str)
    return known[0]["life_Mrev"]


def _number(stored: str, people: str, name: str) -> Callable[[Reader], Number | None]:
    def read(reader: Reader) -> Number | None:
        value = _rated(reader).get(name)
        place = f"oil/{name}/{life_of_loads(reader)}"
        return None if value is None else reader.units.number(value, stored, people, ".3g", place)

    return read


viscosity = _number("m^2/s", "mm^2/s", "viscosity")
reference_viscosity = _number("m^2/s", "mm^2/s", "reference_viscosity")
largest_a_iso = _number("", "", "largest_a_ISO")


def sufficient_at(reader: Reader) -> tuple[int | None, int]:
    """Highest whole temperature [°C] of this oil with a viscosity ratio of 1, and how far was tried.

    The first is None where the oil has no such temperature as far as its data reach.
    """
    given = floor(reader.attributes["case_si"]["lubricant"]["inlet_temperature"] - _ZERO)
    start = _ratio(reader, given)  # also at other temperatures, where the case gives the viscosity
    enough = (start or 0.0) >= VISCOSITY_RATIO.limit
    step, reached = (_STEP if enough else -_STEP), given
    while _LOW <= reached + step <= _HIGH and (ratio := _ratio(reader, reached + step)) not in (None, start):
        reached += step
        if (ratio >= VISCOSITY_RATIO.limit) != enough:
            return _between(reader, *sorted((reached - step, reached))), reached
    return None, reached


def heated(reader: Reader, celsius: int) -> str:
    """That rings warmer than the oil heat it in the inlets, for a sentence; empty where they are not."""
    parts = reader.attributes["case_si"].get("operation", {}).get("temperatures") or {}
    rings = [parts[name] - _ZERO for name in ("inner_ring", "outer_ring") if parts.get(name) is not None]
    if not rings or min(rings) - celsius < _WARMER:
        return ""
    ends = " to ".join(dict.fromkeys(f"{end:.0f}" for end in (min(rings), max(rings))))
    return f", but the rings, given at {ends} °C, heat it in the inlets: they must be cooler too"


def _between(reader: Reader, low: int, high: int) -> int:
    """Highest whole temperature [°C] with a ratio of 1 or more, between one with it and one without."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (
            (middle, high) if (_ratio(reader, middle) or 0.0) >= VISCOSITY_RATIO.limit else (low, middle)
        )
    return low


def _ratio(reader: Reader, celsius: int) -> float | None:
    setting = f"lubricant.inlet_temperature={celsius + _ZERO:.6g} K"
    return _rated(reader, (setting,)).get("viscosity_ratio")
