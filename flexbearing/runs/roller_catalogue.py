"""What the life of a roller bearing has that a catalogue leaves out."""

from typing import Any

from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.case.roller.profile import SHAPES
from flexbearing.runs import life
from flexbearing.runs.catalogue_life import Catalogue, Influence, Settings
from quasidynamic import CylindricalRollerBearing
from quasidynamic.outcome.capacity import dynamic_rating, fatigue_load_limit, static_rating
from quasidynamic.outcome.life_factors import modification_factor
from quasidynamic.outcome.rating_life import rating_life, static_safety

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
        {f"bearing.roller.{name}": "" for name in SHAPES} | {"bearing.roller.profile": "straight"},
    ),
    Influence("profile of the raceways", {"bearing.inner_raceway": "", "bearing.outer_raceway": ""}),
    Influence("edge stress by ISO/TS 16281", {"life.edge_stress": "false"}),
    Influence("pressure of the whole roller", {"bearing.contact": "slices"}),
    Influence("flexible rings", {"outer": "", "outer.kind": "rigid", "inner": "", "inner.kind": "rigid"}),
    Influence("capacity of the raceways by Lundberg and Palmgren", {"life.capacity": "iso281"}),
    Influence("rollers that fail", {"life.roller_body": "false"}),
    Influence("lubrication", {"life.lubrication": "", "life.cleanliness": ""}),
    Influence("steel", {"life.steel": "", "life.melting": ""}),
    Influence("reliability", {"life.reliability": ""}),
)


def require_load(case: Case) -> None:
    """Require a radial load.

    Raises
    ------
    BadCase
        without one
    """
    if not case.operation.radial_load > 0:
        raise BadCase("[operation] radial_load: without a radial load a catalogue knows no life.")


def ratings(case: Case, hours: float) -> dict[str, Any]:
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


# Clearance and tilt come before profiles, and rings before what the oil does.
CATALOGUE = Catalogue(RATING, lambda case: INFLUENCES, require_load, ratings)
