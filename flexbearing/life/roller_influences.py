"""What the life of a roller bearing has that a catalogue leaves out."""

from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.case.roller.profile import SHAPES
from flexbearing.life import roller_lives
from flexbearing.life.against_catalogue import RELIABILITY, Catalogue, Influence
from flexbearing.life.rated_bearing import RatedBearing

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
HELD = {
    "operation.misalignment": "0 deg", "operation.carrier": "", "operation.moment": "0 N m",
    "operation.tilt": "fixed",
}  # fmt: skip
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
    RELIABILITY,
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


def rated(case: Case) -> RatedBearing:
    """The bearing as the standards rate it."""
    return roller_lives.rated(case, roller_bearing.parts(case))


CATALOGUE = Catalogue(RATING, influences, require_load, rated)
