"""Why the life of a case is not that of a catalogue: one setting after the other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import pi
from typing import Any

from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.results import Result
from flexbearing.runs import life
from quasidynamic import CylindricalRollerBearing
from quasidynamic.outcome.capacity import dynamic_rating, fatigue_load_limit, static_rating
from quasidynamic.outcome.life_factors import modification_factor
from quasidynamic.outcome.rating_life import rating_life, static_safety

Settings = Mapping[str, str]


@dataclass(frozen=True)
class Influence:
    """Something that a catalogue leaves out, and the settings that leave it out of a case as well."""

    name: str
    out: Settings


# In the order in which they enter; an empty setting takes a key or table out, also one given by settings.
RATING: tuple[tuple[str, Settings], ...] = (
    ("ISO 281: (C_r/P)^(10/3)", {"life.loads": "rating"}),
    ("load exponent 4 of line contacts", {"life.loads": "rating", "life.load_exponent": "4"}),
    (
        "lambda nu = 0.83 taken out of C_r",
        {"life.loads": "rating", "life.load_exponent": "4", "life.stress_reduction": "false"},
    ),
    ("loads of all rollers at speed, straight, without clearance or tilt, rigid rings", {}),
)
INFLUENCES = (
    Influence(
        "operating clearance",
        {"bearing.clearance": "0 um", "bearing.fits.cold_clearance": "", "bearing.clearance_class": ""},
    ),
    Influence(
        "tilt of the inner ring",
        {"operation.misalignment": "0 deg", "operation.moment": "0 N m", "operation.tilt": "fixed"},
    ),
    Influence("form errors of the raceways", {"bearing.form_error": ""}),
    Influence(
        "profile of the rollers",
        {
            "bearing.roller.drop": "",
            "bearing.roller.straight_length": "",
            "bearing.roller.crown_radius": "",
            "bearing.roller.profile": "straight",
        },
    ),
    Influence("edge stress by ISO/TS 16281", {"life.edge_stress": "false"}),
    Influence("pressure of the whole roller", {"bearing.contact": "slices"}),
    Influence("flexible rings", {"outer": "", "outer.kind": "rigid", "inner": "", "inner.kind": "rigid"}),
    Influence("capacity of the raceways by Lundberg and Palmgren", {"life.capacity": "iso281"}),
    Influence("rollers that fail", {"life.roller_body": "false"}),
    Influence("lubrication", {"life.lubrication": "", "life.cleanliness": ""}),
    Influence("steel", {"life.steel": "", "life.melting": ""}),
    Influence("reliability", {"life.reliability": ""}),
)


@dataclass(frozen=True)
class Stage:
    """A life, and what makes it another one than the life before."""

    name: str
    settings: tuple[str, ...]  # "key=value" with which `run` computes this life
    left_out: tuple[str, ...]  # those that leave out what it is named after
    life: float  # [10^6 revolutions]
    factor: float | None  # over the life before

    def record(self, hours: float) -> dict[str, Any]:
        """The same as JSON can hold it; hours in a million revolutions."""
        return {
            "name": self.name, "settings": list(self.settings), "left_out_by": list(self.left_out),
            "life_Mrev": self.life, "life_h": self.life * hours, "factor": self.factor,
        }  # fmt: skip


def against_catalogue(
    case: Case, read: Callable[[Sequence[str]], Case], solved: Callable[[Case], Result]
) -> dict[str, Any]:
    """Ratings of a roller bearing, and the way from the catalogue's life to that of the case.

    Every life is that of the case with settings; those next to each other differ in what the second is named
    after. So the factors multiply to the last life over the first, and nothing is left over. They depend on
    the order, in which clearance and tilt come before profiles, and rings before what the oil does.

    Parameters
    ----------
    case : Case
        as it was read
    read : callable
        the same case with further settings
    solved : callable
        computes a case

    Returns
    -------
    dict
        "title", "ratings", and "stages" from the first life to the last

    Raises
    ------
    BadCase
        without a radial load, for a case that asks for the life by rating alone, and where a case of the way
        has no solution
    """
    _require_a_way(case)
    stages: list[Stage] = []
    for name, settings, left_out in _way(_acting(case, read)):
        found = _lived(solved(read(settings)), name)
        stages.append(Stage(name, settings, left_out, found, found / stages[-1].life if stages else None))
    hours = _hours(case)
    return {
        "title": case.title,
        "ratings": _ratings(case, hours),
        "stages": [stage.record(hours) for stage in stages],
    }


def _require_a_way(case: Case) -> None:
    if not case.operation.radial_load > 0:
        raise BadCase("[operation] radial_load: without a radial load a catalogue knows no life.")
    if case.life.loads == "rating":
        raise BadCase('[life] loads = "rating": this is the life of a catalogue already; leave it out.')


def _acting(case: Case, read: Callable[[Sequence[str]], Case]) -> list[Influence]:
    """Influences that a case has anything of, with the settings that change it."""
    bare = read(_written(*(influence.out for influence in INFLUENCES))).to_json()
    full = case.to_json()
    changing = [
        {key: value for key, value in influence.out.items() if _at(full, key) != _at(bare, key)}
        for influence in INFLUENCES
    ]
    pairs = zip(INFLUENCES, changing, strict=True)
    return [replace(influence, out=out) for influence, out in pairs if out]


def _at(table: Any, key: str) -> Any:
    """The value of a dotted key; None where there is none."""
    for part in key.split("."):
        table = table.get(part) if isinstance(table, dict) else None
    return table


def _way(acting: Sequence[Influence]) -> Iterator[tuple[str, tuple[str, ...], tuple[str, ...]]]:
    """Name of every life, the settings that give it, and those that leave out what it is named after."""
    for name, rating in RATING:
        yield name, _written(rating, *(influence.out for influence in acting)), ()
    for place, influence in enumerate(acting):
        yield influence.name, _written(*(later.out for later in acting[place + 1 :])), _written(influence.out)


def _written(*settings: Settings) -> tuple[str, ...]:
    return tuple(f"{key}={value}" for each in settings for key, value in each.items())


def _lived(result: Result, name: str) -> float:
    """The life at the end of a run [10^6 revolutions]."""
    if result.attributes["status"] != "converged":
        raise BadCase(f"{name}: not converged: {result.attributes['message']}")
    modified = result.attributes["life"].get("flexible")
    return float(modified["modified_Mrev"] if modified else result["flexible.life_L10"].to("Mrev"))


def _ratings(case: Case, hours: float) -> dict[str, Any]:
    """What a catalogue's page says, and what it says of the load."""
    bearing, load = roller_bearing.bearing(case).bearing, case.operation.radial_load
    dynamic, static = life.dynamic(case, bearing), life.static(case, bearing)
    lived = float(rating_life(dynamic, load))
    given = {
        "C_r": case.life.dynamic_rating, "C_0r": case.life.static_rating, "C_u": case.life.fatigue_limit_load
    }  # fmt: skip
    found = {"C_r": dynamic, "C_0r": static, "C_u": life.fatigue_limit(case, bearing)}
    formulas = {
        "C_r": dynamic_rating(bearing), "C_0r": static_rating(bearing), "C_u": fatigue_load_limit(bearing)
    }  # fmt: skip
    return {
        "ratings_N": found,
        "given": [name for name, value in given.items() if value is not None],
        "formulas_N": formulas,
        "load_N": load,
        "static_safety": static_safety(static, load),
        "life_Mrev": lived,
        "life_h": lived * hours,
    } | _by_oil(case, bearing, lived, hours)


def _by_oil(case: Case, bearing: CylindricalRollerBearing, lived: float, hours: float) -> dict[str, Any]:
    """Modified rating life of ISO 281, where the case says how clean the oil is."""
    if case.life.lubrication != "a_ISO":
        return {}
    kappa, left = life.kappa(case, bearing), life.fatigue_share(case, bearing)
    factor = float(modification_factor(kappa, left / case.operation.radial_load).value)
    return {
        "viscosity_ratio": kappa, "a_ISO": factor, "modified_Mrev": lived * factor,
        "modified_h": lived * factor * hours,
    }  # fmt: skip


def _hours(case: Case) -> float:
    """Hours that a million revolutions take."""
    turning = abs(case.operation.inner_speed - case.operation.outer_speed) / (2 * pi)  # [1/s]
    return 1e6 / turning / 3600
