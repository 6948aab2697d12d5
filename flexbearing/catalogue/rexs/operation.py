"""Loads, speed and temperature of a bearing in the load cases of a gearbox model."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot

from flexbearing.catalogue.rexs.parts import Model, Part

CASING, SHAFT, GEAR_UNIT = "gear_casing", "shaft", "gear_unit"
RPM = "1 / min"
SPEEDS = ("rotational_speed", "speed")  # of a shaft
SHARES = {  # of the time: unit to attributes, whose names changed with 1.3
    "%": ("operating_time_fraction", "load_duration_fraction"),
    "h": ("operating_time", "load_duration"),
}
FORCES = (  # along u, the shaft, v and w; those on either component differ in sign alone
    ("N", tuple(f"force_acting_on_inner_component_{axis}" for axis in "uvw")),
    ("N", tuple(f"force_acting_on_outer_component_{axis}" for axis in "uvw")),
    ("kN", ("axial_force", "radial_force_in_v", "radial_force_in_w")),
)
VECTOR = "reaction_force"  # of some programs: an array along u, v, w
TO_NEWTON = {"N": 1.0, "kN": 1e3}


@dataclass(frozen=True)
class Point:
    """What a bearing has to do in a load case; None where the model does not say."""

    shares: dict[str, float]  # of the time by unit
    radial: float | None = None  # [N]
    axial: float | None = None  # [N]
    speed: float | None = None  # [rpm] of the inner ring over the outer one
    temperature: float | None = None  # [degC] of the oil
    used: frozenset[str] = frozenset()  # attributes of the bearing

    @property
    def load(self) -> float:
        """Size of the force [N]."""
        return hypot(self.radial or 0.0, self.axial or 0.0)


def points(model: Model, bearing: Part) -> list[Point]:
    """Operation of a bearing in every load case, or in the model itself, which then has none."""
    casing = _casing(model, bearing)
    return [_point(model, bearing, casing, number) for number in range(max(len(model.load_cases), 1))]


def heaviest(found: list[Point]) -> int:
    """Place of the load case that a single computation is of: that of most load among those that turn."""
    return max(range(len(found)), key=lambda place: (bool(found[place].speed), found[place].load))


def _point(model: Model, bearing: Part, casing: Part | None, number: int) -> Point:
    loaded = model.loaded(bearing, number)
    axial, radial, of_force = _forces(loaded)
    speed = _speed(model, loaded, number)
    temperature = loaded.number_of("temperature_lubricant", "C")
    if temperature is None and casing:
        temperature = model.loaded(casing, number).number_of("temperature_lubricant", "C")
    used = {*of_force, "temperature_lubricant"}
    used |= {"speed_inner_ring", "speed_outer_ring"} if speed is not None else set()
    return Point(_shares(model, number), radial, axial, speed, temperature, frozenset(used))


def _forces(bearing: Part) -> tuple[float | None, float | None, tuple[str, ...]]:
    """Axial and radial force [N], from the first form that the model has, and its attributes."""
    for unit, names in FORCES:
        given = [bearing.number_of(name, unit) for name in names]
        if any(each is not None for each in given):
            u, v, w = (TO_NEWTON[unit] * abs(each or 0.0) for each in given)
            return u, hypot(v, w), names
    vector = bearing.vector_of(VECTOR, "N")
    if len(vector) == 3:
        return abs(vector[0]), hypot(*vector[1:]), (VECTOR,)
    return None, None, ()


def _speed(model: Model, bearing: Part, number: int) -> float | None:
    """Speed of the inner ring over the outer one [rpm]."""
    inner, outer = (_ring_speed(model, bearing, ring, number) for ring in ("inner", "outer"))
    return None if inner is None or outer is None else abs(inner - outer)


def _ring_speed(model: Model, bearing: Part, ring: str, number: int) -> float | None:
    """Speed of a ring [rpm], its own or that of the part that it sits on; outer ones without one stand."""
    own = bearing.number_of(f"speed_{ring}_ring", RPM)
    if own is not None:
        return own
    carriers = [*model.all_of("side", bearing, "assembly", f"{ring}_part")]
    if not carriers:
        return 0.0 if ring == "outer" else None
    carrier = model.loaded(carriers[0], number)
    if carrier.kind == CASING:
        return 0.0
    return next((n for name in SPEEDS if (n := carrier.number_of(name, RPM)) is not None), None)


def _casing(model: Model, bearing: Part) -> Part | None:
    """The casing that a bearing sits in, or the only one."""
    for role in ("outer_part", "inner_part"):
        if found := model.one_of("side", bearing, "assembly", role, CASING):
            return found
    found = [part for part in model.parts.values() if part.kind == CASING]
    return found[0] if len(found) == 1 else None


def _shares(model: Model, number: int) -> dict[str, float]:
    """Shares of the time of a load case by unit, given for the gear unit."""
    if number >= len(model.load_cases):
        return {}
    units = [
        part
        for name, part in model.load_cases[number].items()
        if name in model.parts and model.parts[name].kind == GEAR_UNIT
    ]
    return dict(_share(units[0])) if units else {}


def _share(unit: Part) -> Iterator[tuple[str, float]]:
    for measure, names in SHARES.items():
        for name in names:
            if (value := unit.number_of(name, measure)) is not None:
                yield measure, value
