"""Loads, speed and temperature of a bearing in the load cases of a gearbox model."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import copysign, hypot

from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.rexs.parts import Model, Part

CASING, SHAFT, GEAR_UNIT = "gear_casing", "shaft", "gear_unit"
RPM = "1 / min"
SPEEDS = ("rotational_speed", "speed")  # of a shaft
SHARES = {  # of the time: unit to attributes, whose names changed with 1.3
    "%": ("operating_time_fraction", "load_duration_fraction"),
    "h": ("operating_time", "load_duration"),
}
FORCES = (  # newtons on the inner ring, unit and attributes along u, the shaft, v and w
    (1.0, "N", tuple(f"force_acting_on_inner_component_{axis}" for axis in "uvw")),
    (-1.0, "N", tuple(f"force_acting_on_outer_component_{axis}" for axis in "uvw")),
    (1e3, "kN", ("axial_force", "radial_force_in_v", "radial_force_in_w")),
)
PRESSED = {  # kinds that carry axial loads in one direction
    "angular_contact_ball": "the balls on their shoulders",
    "tapered_roller": "the cone into the cup",
    "thrust_roller": "the shaft washer on the rollers",
}
VECTOR = "reaction_force"  # of some programs: an array along u, v, w


@dataclass(frozen=True)
class Point:
    """What a bearing has to do in a load case; None where the model does not say."""

    shares: dict[str, float]  # of the time by unit
    radial: float | None = None  # [N]
    axial: float | None = None  # [N] on the inner ring, along u
    speeds: tuple[float, float] | None = None  # [rpm] of the inner and the outer ring, about u
    temperature: float | None = None  # [degC] of the oil
    used: frozenset[str] = frozenset()  # attributes of the bearing

    @property
    def inner_speed(self) -> float | None:
        """Speed of the inner ring [rpm]."""
        return self.speeds and self.speeds[0]

    @property
    def outer_speed(self) -> float | None:
        """Speed of the outer ring [rpm]."""
        return self.speeds and self.speeds[1]

    @property
    def relative_speed(self) -> float | None:
        """Speed of one ring over the other [rpm], without its sign."""
        return self.speeds and abs(self.speeds[0] - self.speeds[1])

    @property
    def load(self) -> float:
        """Size of the force [N]."""
        return hypot(self.radial or 0.0, self.axial or 0.0)


def points(model: Model, bearing: Part) -> list[Point]:
    """Operation of a bearing in every load case, or in the model itself, which then has none."""
    casing = casing_of(model, bearing)
    return [_point(model, bearing, casing, number) for number in range(max(len(model.load_cases), 1))]


def heaviest(found: list[Point]) -> int:
    """Place of the load case that a single computation is of: that of most load among those that turn."""
    return max(range(len(found)), key=lambda place: (bool(found[place].relative_speed), found[place].load))


def oriented(found: list[Point], like: str) -> tuple[list[Point], str]:
    """Operation with axial forces as the case has them, and in words along what they are positive.

    Bearings of one direction have shoulders or ribs on one side, and no attribute says on which.
    """
    forces = [point.axial or 0.0 for point in found]
    if "axial" not in LIKES[like].taken or not any(forces):
        return found, ""
    if like not in PRESSED:
        return found, "axial force: on the inner ring, positive along u"
    largest = max(range(len(forces)), key=lambda place: abs(forces[place]))
    sign = copysign(1.0, forces[largest])
    case = f" of load case {largest + 1}" if len(forces) > 1 else ""
    along = "u" if sign > 0 else "-u"
    words = f"axial force: positive along {along}, assumed to press {PRESSED[like]}"
    turned = [
        point if point.axial is None else replace(point, axial=sign * point.axial or 0.0) for point in found
    ]
    return turned, f"{words}, as that{case} does" if case else words


def _point(model: Model, bearing: Part, casing: Part | None, number: int) -> Point:
    loaded = model.loaded(bearing, number)
    axial, radial, of_force = _forces(loaded)
    speeds = _speeds(model, loaded, number)
    temperature = loaded.number_of("temperature_lubricant", "C")
    if temperature is None and casing:
        temperature = model.loaded(casing, number).number_of("temperature_lubricant", "C")
    used = {*of_force, "temperature_lubricant"}
    used |= {"speed_inner_ring", "speed_outer_ring"} if speeds else set()
    shares = _shares(_gear_unit(model, number)) if number < len(model.load_cases) else {}
    return Point(shares, radial, axial, speeds, temperature, frozenset(used))


def _forces(bearing: Part) -> tuple[float | None, float | None, tuple[str, ...]]:
    """Axial and radial force on the inner ring [N], from the first form of the model, and its attributes."""
    for newton, unit, names in FORCES:
        given = [bearing.number_of(name, unit) for name in names]
        if any(each is not None for each in given):
            u, v, w = (newton * each if each else 0.0 for each in given)
            return u, hypot(v, w), names
    vector = bearing.vector_of(VECTOR, "N")
    if len(vector) == 3:
        return vector[0], hypot(*vector[1:]), (VECTOR,)
    return None, None, ()


def _speeds(model: Model, bearing: Part, number: int) -> tuple[float, float] | None:
    """Speeds of the inner and the outer ring [rpm]; None where one is not known."""
    inner, outer = (_ring_speed(model, bearing, ring, number) for ring in ("inner", "outer"))
    return None if inner is None or outer is None else (inner, outer)


def _ring_speed(model: Model, bearing: Part, ring: str, number: int) -> float | None:
    """Speed of a ring [rpm], its own or that of the part that it sits on; outer ones without one stand."""
    own = bearing.number_of(f"speed_{ring}_ring", RPM)
    if own is not None:
        return own
    carrier = next(carriers(model, bearing, ring), None)
    if carrier is None:
        return 0.0 if ring == "outer" else None
    carrier = model.loaded(carrier, number)
    if carrier.kind == CASING:
        return 0.0
    return next((n for name in SPEEDS if (n := carrier.number_of(name, RPM)) is not None), None)


def carriers(model: Model, bearing: Part, ring: str) -> Iterator[Part]:
    """What the inner or the outer ring sits on or in; the first one turns with it."""
    return model.all_of("side", bearing, "assembly", f"{ring}_part")


def used_speeds(model: Model, bearing: Part) -> Iterator[tuple[str, str]]:
    """Numbers of carriers with the attributes that speeds of rings without their own are read from."""
    for ring in ("inner", "outer"):
        carrier, own = next(carriers(model, bearing, ring), None), f"speed_{ring}_ring"
        parts = (case.get(bearing.number) for case in model.load_cases)
        if own in bearing.attributes or (model.load_cases and all(p and own in p.attributes for p in parts)):
            continue
        if carrier and carrier.kind != CASING:
            given = model.contents[carrier.number]
            yield from ((carrier.number, name) for name in [name for name in SPEEDS if name in given][:1])


def casing_of(model: Model, bearing: Part) -> Part | None:
    """The casing that a bearing sits in, or the only one."""
    for role in ("outer_part", "inner_part"):
        if found := model.one_of("side", bearing, "assembly", role, CASING):
            return found
    found = [part for part in model.parts.values() if part.kind == CASING]
    return found[0] if len(found) == 1 else None


def measure_of(shares: Sequence[Mapping[str, float]]) -> str | None:
    """The unit of the shares of the time that a duty cycle takes: the first that all load cases have."""
    return next((unit for unit in SHARES if shares and all(unit in each for each in shares)), None)


def used_shares(model: Model) -> set[str]:
    """Attributes of gear units that shares of the time of several load cases are read from."""
    units = [_gear_unit(model, number) for number in range(len(model.load_cases))]
    measure = measure_of([_shares(unit) for unit in units]) if len(units) > 1 else None
    return {name for unit in units for name, _ in _share(unit, measure)} if measure else set()


def used_temperature(model: Model, bearing: Part) -> Iterator[tuple[str, str]]:
    """Number of the casing with the attribute whose oil a bearing without a temperature of its own has."""
    casing, name = casing_of(model, bearing), "temperature_lubricant"
    cases = range(max(len(model.load_cases), 1))
    if casing and not all(name in model.loaded(bearing, number).attributes for number in cases):
        yield casing.number, name


def _gear_unit(model: Model, number: int) -> Part | None:
    """The gear unit with its attributes of a load case."""
    return next(
        (
            part
            for name, part in model.load_cases[number].items()
            if name in model.parts and model.parts[name].kind == GEAR_UNIT
        ),
        None,
    )


def _shares(unit: Part | None) -> dict[str, float]:
    """Shares of the time of a load case by unit, given for the gear unit."""
    return {measure: value for measure in SHARES for _, value in _share(unit, measure)}


def _share(unit: Part | None, measure: str) -> Iterator[tuple[str, float]]:
    """The attribute that a share is read from, and the share; none where the unit has none."""
    for name in SHARES[measure]:
        if unit is not None and (value := unit.number_of(name, measure)) is not None:
            yield name, value
            return
