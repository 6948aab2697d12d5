"""What an input that no source gives might be instead, and where that range comes from."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import isclose, pi
from typing import Any

from flexbearing.build.clearance import operating
from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.case.key_ranges import FROM_ZERO, GRADED, THUMB, range_of
from flexbearing.quantities.effects import CHOICE, COMPARISON, INPUT
from flexbearing.runs.roller_counts import SPACING, TAPERED_SPACING, plausible_numbers

LIMITING_RATIO = 0.05  # usual, where a law needs one
CHOICES = "other choices of the key"
EDGE_SLICES = 30  # that the edge stress of ISO/TS 16281 needs at least
MOST_COUNTS = 5  # elements less and more
FEW = 5  # choices of which all others are tried; of more the neighbours in their list
STEELS, BODIES = ("100Cr6", "M50"), ("structural steel", "grey cast iron")
MATERIALS = {"shaft": BODIES, "housing": BODIES}  # by parts; of all others bearing steels


@dataclass(frozen=True)
class Other:
    """Another value that a key might have."""

    words: str
    settings: tuple[str, ...]  # "key=value"


@dataclass(frozen=True)
class Plausible:
    """Other values of a key, and the source of their range."""

    key: str
    others: tuple[Other, ...]
    source: str
    role: str = INPUT


def plausible(case: Any) -> Iterator[Plausible]:
    """What every assumed or calibrated key of a case might be instead, tolerances, rules and loads."""
    known = by_path(type(case))
    if getattr(case, "bands", None) and case.bearing.mounting:
        yield Plausible(
            "bearing.fits.at", tuple(_at_ends(case)), "classes of the case, ISO 5753-1 and ISO 286"
        )
    marked = tuple(dict.fromkeys((*case.calibrated, *case.assumed)))
    for path in marked:
        yield from _of_key(case, known, path)
    yield from (each for each in (*_choices(case), *_loads(case)) if each.key not in marked)


def graded(case: Any, *, every: bool = False) -> Iterator[Plausible]:
    """Other choices of keys whose choices are steps: the next ones, or `every` one from low to high."""
    known = by_path(type(case))
    for path in GRADED:
        declared, value = known.get(path), _at(case, path)
        if declared is None or value is None:
            continue
        if not every or (path in FURTHER and not declared.whole):
            yield Plausible(path, *_others(case, declared, value), CHOICE)
        elif declared.whole:
            counts = range(max(value - MOST_COUNTS, 1), value + MOST_COUNTS + 1)
            yield Plausible(path, tuple(_set(path, count) for count in counts), CHOICES, CHOICE)
        else:
            yield Plausible(path, tuple(_set(path, each) for each in declared.choices), CHOICES, CHOICE)


def _choices(case: Any) -> Iterator[Plausible]:
    """Rules of the life that a case of cylinders could choose otherwise, and how the shaft holds the ring."""
    if not hasattr(getattr(case, "life", None), "capacity") or not case.operation.radial_load:
        return
    life, operation = case.life, case.operation
    if any(ring.kind != "rigid" for ring in (case.outer, case.inner)):
        tilt = "fixed" if operation.free_tilt else "free"
        without = tuple(
            f"operation.{name}=" for name in ("misalignment", "carrier", "moment") if getattr(operation, name)
        )
        yield Plausible(
            "operation.tilt", (Other(tilt, (f"operation.tilt={tilt}", *without)),), CHOICES, CHOICE
        )
    if not operation.free_tilt and operation.misalignment == 0:
        yield Plausible(
            "operation.misalignment", (_set("operation.misalignment", "1 arcmin"),),
            f"1 arcmin of a mounted shaft: {THUMB}", CHOICE,
        )  # fmt: skip
    if life.loads != "rollers":
        return
    if life.capacity != "iso281":
        yield Plausible("life.capacity", (_set("life.capacity", "iso281"),), "rule of ISO/TS 16281", CHOICE)
    if not life.edge_stress and case.bearing.relieved and case.bearing.contact == "slices":
        slices = (f"accuracy.slices={EDGE_SLICES}",) if case.accuracy.slices < EDGE_SLICES else ()
        edge = Other("true", ("life.edge_stress=true", *slices))
        yield Plausible("life.edge_stress", (edge,), "rule of ISO/TS 16281", CHOICE)


def _loads(case: Any) -> Iterator[Plausible]:
    """Loads a tenth less and more, for comparison: a case knows its loads."""
    for name in ("radial_load", "axial_load"):
        load = getattr(case.operation, name, None)
        if load:
            others = tuple(_set(f"operation.{name}", f"{factor * load:.6g} N") for factor in (0.9, 1.1))
            yield Plausible(f"operation.{name}", others, "10 %, for comparison", COMPARISON)


def _at_ends(case: Any) -> Iterator[Other]:
    """Both ends of the tolerances, with the clearance there."""
    for place in ("tightest", "loosest"):
        clearance = operating(case.within_tolerances(place))
        words = f"{place}, clearance {1e6 * clearance:.1f} um"
        yield Other(words, (f"bearing.fits.at={place}",))


def _of_key(case: Any, known: dict[str, Declaration], path: str) -> Iterator[Plausible]:
    declared, value = known.get(path), _at(case, path)
    if declared is None or value is None:
        return
    if declared.section is None:
        others, source = _others(case, declared, value)
        yield Plausible(path, others, source)
    elif declared.choices:  # a material, which has a name
        names = MATERIALS.get(path.rpartition(".")[2], STEELS)
        yield Plausible(path, tuple(_set(path, name) for name in names), "other materials in use")
    else:
        for name in declared.section.model_fields:
            yield from _of_key(case, known, f"{path}.{name}")


def _others(case: Any, declared: Declaration, value: Any) -> tuple[tuple[Other, ...], str]:
    """Other values of a key, and where they come from."""
    path = declared.path
    if isinstance(value, bool):
        return (_set(path, not value),), CHOICES
    if path in FURTHER:
        return FURTHER[path](case)
    if declared.choices:
        return tuple(_set(path, other) for other in _beside(declared.choices, value)), CHOICES
    if path == "bearing.first_roller_azimuth":
        half = declared.kind.written(value + pi / case.bearing.rollers, "1 deg")  # type: ignore[union-attr]
        return (_set(path, half),), "half a pitch, the farthest that there is"
    if declared.kind is None and not declared.number:
        return (), "a text, for which no others are known"
    if value == 0 and (step := FROM_ZERO.get(declared.kind.unit if declared.kind else "")):
        return tuple(_set(path, f"{sign}{step[1]}") for sign in ("-", "")), f"{step[1]} either way: {THUMB}"
    known = range_of(path)
    change, source = known.plausible, known.source
    if isinstance(value, list | tuple):
        changed = zip(*(change(each) for each in value), strict=True)
        return tuple(_set(path, [_written(declared, each) for each in row]) for row in changed), source
    written = (_written(declared, other) for other in change(value) if not isclose(other, value))
    return tuple(_set(path, each) for each in written), source


def _profiles(case: Any) -> tuple[tuple[Other, ...], str]:
    """Straight rollers; and in place of that of ISO/TS 16281 the same of half and of twice the drop."""
    path, found = "bearing.roller", []
    if case.bearing.roller.profile == "iso16281":
        for factor in (0.5, 2.0):
            drop = f"{factor * 350 * case.bearing.roller.diameter:.6g} um"
            found.append(Other(f"drop A of {drop}", (f"{path}.profile=logarithmic", f"{path}.drop={drop}")))
    without = ("life.edge_stress=false",) if getattr(case.life, "edge_stress", False) else ()
    given = ("drop", "design_load", "points")
    left_out = tuple(
        f"{path}.{name}=" for name in given if getattr(case.bearing.roller, name, None) is not None
    )
    straight = Other("straight", (f"{path}.profile=straight", *left_out, *without))
    return (*found, straight), f"the ends of usual profiles: {THUMB}"


def _guidances(case: Any) -> tuple[tuple[Other, ...], str]:
    """A cage on the rollers, or on a land of usual size."""
    cage, path = case.bearing.cage, "bearing.cage"
    if cage.guidance != "rollers":
        lands = ("land_diameter", "land_width", "land_clearance")
        left_out = (f"{path}.{name}=" for name in lands)
        return (Other("rollers", (f"{path}.guidance=rollers", *left_out)),), CHOICES
    bearing = case.bearing
    land = 1e3 * (bearing.outer_raceway_diameter - bearing.roller.diameter / 2)
    settings = {
        "guidance": "outer", "land_diameter": f"{land:.6g} mm", "land_clearance": "0.4 mm",
        "land_width": f"{400 * bearing.roller.length:.4g} mm",
    }  # fmt: skip
    outer = Other("outer ring", tuple(f"{path}.{name}={value}" for name, value in settings.items()))
    return (outer,), f"a land of usual size: {THUMB}"


def _counts(case: Any) -> tuple[tuple[Other, ...], str]:
    """Other numbers of rollers; with a length that nobody gave either, that of the same static rating.

    C_0 of ISO 76 holds the product of both: the fewest and the most rollers that fit, else one less and more.
    """
    bearing, path = case.bearing, "bearing.rollers"
    beside = (bearing.rollers - 1, bearing.rollers + 1)
    if "bearing.roller.length" not in case.assumed:
        return tuple(_set(path, count) for count in beside), "one less, one more"
    spacing = TAPERED_SPACING if case.kind in ("tapered_roller", "spherical_roller") else SPACING
    fitting = plausible_numbers(bearing.roller.diameter / bearing.pitch_diameter, spacing)
    ends = [count for count in (fitting[0], fitting[-1]) if count != bearing.rollers]
    others = []
    for count in ends or beside:
        length = f"{1e3 * bearing.roller.length * bearing.rollers / count:.4g} mm"
        settings = (f"{path}={count}", f"bearing.roller.length={length}")
        others.append(Other(f"{count} rollers of {length}", settings))
    return tuple(others), f"as many as fit beside each other in a cage, C_0 of ISO 76 kept: {THUMB}"


def _diameters(case: Any) -> tuple[tuple[Other, ...], str]:
    """Rollers a tenth smaller and larger; with an outer raceway that nobody gave the inner one is kept."""
    bearing, raceway = case.bearing, "bearing.outer_raceway_diameter"
    others = []
    for factor in (0.9, 1.1):
        diameter = factor * bearing.roller.diameter
        settings = [f"bearing.roller.diameter={1e3 * diameter:.6g} mm"]
        words = f"{1e3 * diameter:.4g} mm"
        if raceway in case.assumed:
            outer = bearing.outer_raceway_diameter + 2 * (diameter - bearing.roller.diameter)
            settings.append(f"{raceway}={1e3 * outer:.6g} mm")
            words += f", raceway of {1e3 * outer:.4g} mm"
        others.append(Other(words, tuple(settings)))
    return tuple(others), f"10 %, the inner or the outer raceway kept: {THUMB}"


def _pitches(case: Any) -> tuple[tuple[Other, ...], str]:
    """Pitch circles of inclined rollers about the mean of a catalogue's diameters; of balls by a fifth."""
    rollers = hasattr(case.bearing, "roller")
    factors, source = ((0.99, 1.02), "1 to 2 %") if rollers else ((0.8, 1.25), "a fifth less, a quarter more")
    path = "bearing.pitch_diameter"
    others = (f"{1e3 * factor * case.bearing.pitch_diameter:.6g} mm" for factor in factors)
    return tuple(_set(path, each) for each in others), f"{source}: {THUMB}"


def _tractions(case: Any) -> tuple[tuple[Other, ...], str]:
    """Other traction laws of any oil, with a usual limit of the shear stress where the case has none."""
    limit = getattr(case.lubricant, "limiting_ratio", None)
    usual = () if limit is not None else (f"lubricant.limiting_ratio={LIMITING_RATIO}",)
    names = (name for name in ("eyring", "bair-winer") if name != case.lubricant.traction)
    others = tuple(Other(name, (f"lubricant.traction={name}", *usual)) for name in names)
    paper = () if case.lubricant.traction == "4109" else (_set("lubricant.traction", "4109"),)
    return (*others, *paper), "other laws that need no data of the oil"


FURTHER: dict[str, Callable[[Any], tuple[tuple[Other, ...], str]]] = {  # keys that change with others
    "bearing.pitch_diameter": _pitches,
    "bearing.rollers": _counts,
    "bearing.roller.diameter": _diameters,
    "bearing.roller.profile": _profiles,
    "bearing.cage.guidance": _guidances,
    "lubricant.traction": _tractions,
}


def _beside(choices: list[Any], value: Any) -> list[Any]:
    """All other choices; of many the neighbours in their list."""
    if len(choices) <= FEW or value not in choices:
        return [choice for choice in choices if choice != value][:FEW]
    place = choices.index(value)
    return [choices[near] for near in (place - 1, place + 1) if 0 <= near < len(choices)]


def _written(declared: Declaration, value: float) -> str | float:
    """A value in SI units as a case would have it."""
    if declared.kind is None:
        return round(value) if declared.whole else float(f"{value:.6g}")
    example = declared.field.examples[0] if declared.field.examples else declared.kind.example
    return declared.kind.written(value, example[0] if isinstance(example, list | tuple) else example)


def _set(path: str, value: Any) -> Other:
    text = value if isinstance(value, str) else toml(value)
    return Other(text, (f"{path}={text}",))


def _at(case: Any, path: str) -> Any:
    """The value of a dotted key; None where it, or a table above it, is not given."""
    value = case
    for name in path.split("."):
        value = getattr(value, name, None)
    return value
