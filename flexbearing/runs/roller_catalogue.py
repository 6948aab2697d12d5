"""What the life of a roller bearing has that a catalogue leaves out."""

from operator import attrgetter
from typing import Any

from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.case.roller.profile import SHAPES
from flexbearing.quantities.life_records import Ratings
from flexbearing.runs import life
from flexbearing.runs.catalogue_life import Catalogue, Influence
from flexbearing.runs.life_of_state import LETTERS, Rating, of_oil
from quasidynamic import CylindricalRollerBearing
from quasidynamic.outcome.life_factors import ROLLERS, modification_factor
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT, rating_life, static_safety

RATING = (
    Influence(
        "ISO 281: (C_r/P)^(10/3)",
        {"life.loads": "rating"},
        "One load P; nothing else of the case counts.",
    ),
    Influence(
        "load exponent 4 of line contacts",
        {"life.loads": "rating", "life.load_exponent": "4"},
        "ISO 281 takes 10/3, between points and lines. Slices are lines, whose damage grows with the fourth "
        "power of their load: the lighter the load, the larger this factor.",
    ),
    Influence(
        "lambda nu = 0.83 taken out of C_r",
        {"life.loads": "rating", "life.load_exponent": "4", "life.stress_reduction": "false"},
        "C_r contains a factor 0.83 for loads that are uneven along the rollers. Here every slice carries "
        "its own load, so ISO/TS 16281 takes it out; tilt, profile and edge stress below replace it.",
    ),
    Influence(
        "loads of all rollers at speed, straight, without clearance or tilt, rigid rings",
        {},
        "The loads of all rollers at this speed instead of the load distribution that C_r is made for; the "
        "rollers' own centrifugal force counts.",
    ),
)
CLEARANCE = Influence(
    "operating clearance",
    {"bearing.clearance": "0 um", "bearing.fits.cold_clearance": "", "bearing.clearance_class": ""},
    "Clearance leaves fewer rollers to carry the load; a light preload spreads it over more, a strong one "
    "adds to it.",
)
HELD = {"operation.misalignment": "0 deg", "operation.moment": "0 N m", "operation.tilt": "fixed"}
TILT = Influence(
    "tilt of the inner ring between rigid rings",
    HELD,
    "A tilted ring presses the rollers at one end; between rigid rings only a misalignment or a moment tilts "
    "it.",
)
FREE_TILT = Influence(
    "inner ring free to tilt between the flexible rings",
    HELD,
    "The line above holds the inner ring straight. Free, it follows the flexible rings until the moments "
    "balance, which changes how the load is shared along the rollers.",
)
RINGS = Influence(
    "flexible rings",
    {"outer": "", "outer.kind": "rigid", "inner": "", "inner.kind": "rigid"},
    "Elastic rings change how many rollers carry the load, and how evenly it is shared along them.",
)
BETWEEN_RIGID_RINGS = (
    Influence(
        "form errors of the raceways",
        {"bearing.form_error": ""},
        "Raceways that are not round change which rollers carry the load.",
    ),
    Influence(
        "profile of the rollers",
        {f"bearing.roller.{name}": "" for name in SHAPES} | {"bearing.roller.profile": "straight"},
        "A profile takes load from the ends of the rollers: the middle carries more, and a tilted ring "
        "presses the ends less.",
    ),
    Influence(
        "profile of the raceways",
        {"bearing.inner_raceway": "", "bearing.outer_raceway": ""},
        "As the profile of the rollers: it takes load from their ends.",
    ),
    Influence(
        "edge stress by ISO/TS 16281",
        {"life.edge_stress": "false"},
        "The load of slices near the ends counts more, for the stress at the edges.",
    ),
    Influence(
        "pressure of the whole roller",
        {"bearing.contact": "slices"},
        "The most loaded roller is computed as a whole on half-spaces, where every place presses its "
        "neighbours, too.",
    ),
)
MODIFYING = (
    Influence(
        "capacity of the raceways by Lundberg and Palmgren",
        {"life.capacity": "iso281"},
        "Each raceway is rated by the formula of Lundberg and Palmgren instead of by C_r, that of ISO 281 or "
        "the maker's.",
    ),
    Influence(
        "rollers that fail", {"life.roller_body": "false"}, "Rollers may fail, too, not the raceways alone."
    ),
    Influence(
        "lubrication",
        {"life.lubrication": "", "life.cleanliness": ""},
        "Oil film, and with a_ISO the particles in it and fatigue limit: see the factor in its own table.",
    ),
    Influence(
        "steel",
        {"life.steel": "", "life.melting": ""},
        "Steel and its melting, by the factors of STLE.",
    ),
    Influence(
        "reliability",
        {"life.reliability": ""},
        "More bearings than 90 % must survive this life, so it is shorter.",
    ),
)


def influences(case: Case) -> tuple[Influence, ...]:
    """What may act, in the order in which it enters.

    Clearance and tilt come before profiles, and rings before what the oil does. A ring that is free to tilt
    does so with flexible rings: there its tilt comes after them.
    """
    flexible = any(ring.kind != "rigid" for ring in (case.outer, case.inner))
    if flexible and case.operation.free_tilt:
        return (CLEARANCE, *BETWEEN_RIGID_RINGS, RINGS, FREE_TILT, *MODIFYING)
    return (CLEARANCE, TILT, *BETWEEN_RIGID_RINGS, RINGS, *MODIFYING)


def require_load(case: Case) -> None:
    """Require a radial load.

    Raises `BadCase` without one.
    """
    if not case.operation.radial_load > 0:
        raise BadCase("[operation] radial_load: without a radial load a catalogue knows no life.")


def ratings(case: Case, hours: float) -> Ratings:
    """What a catalogue's page says, and what it says of the load."""
    bearing, load = roller_bearing.bearing(case).bearing, case.operation.radial_load
    rating, static = life.dynamic(case, bearing), life.static(case, bearing)
    lived = float(rating_life(rating, load))
    found = {"C_r": rating, "C_0r": static, "C_u": life.fatigue_limit(case, bearing)}
    drawn = roller_bearing.nominal(case, bearing)
    stated = life.ratings(case, bearing)
    formulas = {LETTERS[name]: formula(drawn) for name, formula in life.FORMULAS.items()}
    return Ratings(
        ratings_N=found,
        given=[LETTERS[name] for name in stated],
        scales={LETTERS[name]: rating.scale for name, rating in stated.items()},
        formulas_N=formulas,
        load_N=load,
        static_safety=static_safety(static, load),
        life_Mrev=lived,
        life_h=lived * hours,
        **_by_oil(case, bearing, lived, hours),
    )


def _by_oil(case: Case, bearing: CylindricalRollerBearing, lived: float, hours: float) -> dict[str, Any]:
    """Modified rating life of ISO 281, where the case says how clean the oil is."""
    if case.life.lubrication != "a_ISO":
        return {}
    kappa = life.rated_kappa(case, bearing)
    if kappa is None:
        return {}
    if life.without_oil_factor(case, bearing):
        return {"viscosity_ratio": kappa}
    left = life.fatigue_share(case, bearing)
    factor = float(modification_factor(kappa, left / case.operation.radial_load).value)
    return {
        "viscosity_ratio": kappa, "a_ISO": factor, "modified_Mrev": lived * factor,
        "modified_h": lived * factor * hours,
    }  # fmt: skip


def oil(case: Case, lived: float) -> dict[str, float]:
    """What ISO 281 says of the oil of a case, at the load that has a life [10^6 revolutions]."""
    bearing = roller_bearing.bearing(case).bearing
    lubricant, operation = life.oil(case), case.operation
    return of_oil(
        lubricant.viscosity / lubricant.density,
        operation.inner_speed - operation.outer_speed,
        life.nominal(case, bearing).pitch_diameter,
        lived ** (1 / ROLLER_EXPONENT) * life.fatigue_limit(case, bearing) / life.dynamic(case, bearing),
        ROLLERS,
    )


def rated(case: Case) -> float | None:
    """Life by ratings alone [rev]; None where the case has another."""
    return life.rated(case, roller_bearing.parts(case))


def viscosity_ratio(case: Case) -> float | None:
    """Viscosity ratio kappa of ISO 281 [-]; None at rest, and without a_ISO."""
    return life.rated_kappa(case, roller_bearing.parts(case))


def given(case: Case) -> dict[str, Rating]:
    """Ratings that the case gives, by their keys."""
    return life.ratings(case, roller_bearing.parts(case))


def dynamic(case: Case) -> float:
    """C_r of the case [N]."""
    return life.dynamic(case, roller_bearing.parts(case))


CATALOGUE = Catalogue(
    RATING, influences, require_load, ratings, given, oil,
    rated, viscosity_ratio, attrgetter("operation.radial_load"), life.exponent,
    life.rating_factor, dynamic,
)  # fmt: skip
