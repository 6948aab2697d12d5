"""What the life of a tapered roller bearing has that a catalogue leaves out."""

from collections.abc import Callable
from typing import Any

from flexbearing.build.ball_fits import kinematic_viscosity
from flexbearing.build.tapered_bearing import bearing
from flexbearing.case import BadCase
from flexbearing.case.roller.profile import SHAPES
from flexbearing.case.tapered import TaperedCase
from flexbearing.quantities.life_records import Ratings
from flexbearing.runs import tapered_life
from flexbearing.runs.catalogue_life import Catalogue, Influence
from flexbearing.runs.life_of_state import LETTERS, of_oil
from quasidynamic import OutOfRange
from quasidynamic.outcome.life_factors import ROLLERS, modification_factor
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT, rating_life, static_safety
from quasidynamic.outcome.tapered_life import (
    InclinedRow,
    load_limit,
    tapered_dynamic_load,
    tapered_static_load,
)

WEIGHTLESS = "0.001 kg/m^3"  # of rollers without inertia
RATING = (
    Influence(
        "ISO 281: (C_r/P)^(10/3), P = X F_r + Y F_a",
        {"life.loads": "rating"},
        "One load P replaces radial and axial load; nothing else of the case counts.",
    ),
    Influence(
        "loads of all slices of straight rollers, without inertia or tilt",
        {},
        "The loads of all slices instead of one load P, with the exponent 4 of lines and without the factor "
        "0.83 of C_r for loads that are uneven along the rollers.",
    ),
)
INFLUENCES = (
    Influence(
        "profile of rollers and raceways",
        {
            "bearing.roller.profile": "straight",
            **{f"bearing.roller.{name}": "" for name in SHAPES},
            "bearing.inner_raceway": "",
            "bearing.outer_raceway": "",
        },
        "A profile takes load from the ends to the middle of the rollers.",
    ),
    Influence(
        "tilt of the inner ring",
        {
            "operation.tilt": "fixed",
            **{f"operation.load.moment_{axis}": "" for axis in "yz"},
            **{f"operation.displacement.tilt_{axis}": "" for axis in "yz"},
        },
        "A ring that turns, or is held askew, presses the rollers at one end.",
    ),
    Influence(
        "inertia of the rollers at speed",
        {"materials.roller.density": WEIGHTLESS},
        "Centrifugal forces press the rollers to the cup and the rib.",
    ),
    Influence(
        "lubrication",
        {"life.lubrication": "", "life.cleanliness": ""},
        "a_ISO: oil film, particles in it and fatigue limit; see the factor in its own table.",
    ),
    Influence(
        "reliability",
        {"life.reliability": ""},
        "More bearings than 90 % must survive this life, so it is shorter.",
    ),
)


def require_load(case: TaperedCase) -> None:
    """Require forces that are known before the case is solved, and a ring that turns.

    Raises `BadCase` where one of them is missing.
    """
    for name in case.operation.held:
        raise BadCase(f"[operation] {name}: a catalogue knows lives under given forces only; give a force.")
    if case.operation.inner_speed == case.operation.outer_speed:
        raise BadCase("[operation] inner_speed: no ring turns against the other; there is no life.")


def ratings(case: TaperedCase, hours: float) -> Ratings:
    """What a catalogue's page says, and what it says of the load."""
    angle, (radial, axial) = case.bearing.cup_angle, case.operation.forces
    load, at_rest = (of(radial, axial, angle) for of in (tapered_dynamic_load, tapered_static_load))
    dynamic, static = (tapered_life.rating(case, name).value for name in ("dynamic_rating", "static_rating"))
    lived, stated = float(rating_life(dynamic, load.value)), tapered_life.ratings(case)
    row = InclinedRow.of(bearing(case))
    return Ratings(
        ratings_N={"C_r": dynamic, "C_0r": static, "C_u": tapered_life.fatigue_limit(case)},
        given=[LETTERS[name] for name in stated],
        scales={LETTERS[name]: rating.scale for name, rating in stated.items()},
        formulas_N={LETTERS[name]: _known(of, row) for name, of in tapered_life.FORMULAS.items()},
        load_N=load.value,
        equivalent_load={
            "F_r_N": radial, "F_a_N": axial, "e": load_limit(angle),
            "X": load.radial_factor, "Y": load.axial_factor, "note": "",
            "X_0": at_rest.radial_factor, "Y_0": at_rest.axial_factor, "P_0_N": at_rest.value,
        },
        static_safety=float(static_safety(static, at_rest.value)),
        life_Mrev=lived,
        life_h=lived * hours,
        **_by_oil(case, load.value, lived, hours),
    )  # fmt: skip


def _known(formula: Callable[[InclinedRow], float], row: InclinedRow) -> float | None:
    """A rating by its formula; None where that does not hold."""
    try:
        return formula(row)
    except OutOfRange:
        return None


def _by_oil(case: TaperedCase, load: float, lived: float, hours: float) -> dict[str, Any]:
    """Modified rating life of ISO 281, where the case says how clean the oil is."""
    kappa = tapered_life.rated_kappa(case)
    if kappa is None:
        return {}
    if tapered_life.unmodified(case):
        return {"viscosity_ratio": kappa}
    factor = float(modification_factor(kappa, tapered_life.fatigue_share(case) / load, ROLLERS).value)
    return {
        "viscosity_ratio": kappa, "a_ISO": factor, "modified_Mrev": lived * factor,
        "modified_h": lived * factor * hours,
    }  # fmt: skip


def oil(case: TaperedCase, lived: float) -> dict[str, float]:
    """What ISO 281 says of the oil of a case, at the load that has a life [10^6 revolutions]."""
    if case.lubricant is None:
        return {}
    viscosity, _ = kinematic_viscosity(case.lubricant)
    return of_oil(
        viscosity,
        case.operation.inner_speed - case.operation.outer_speed,
        case.bearing.pitch_diameter,
        lived ** (1 / ROLLER_EXPONENT) * tapered_life.fatigue_limit(case) / dynamic(case),
        ROLLERS,
    )


def dynamic(case: TaperedCase) -> float:
    """C_r of a case [N]."""
    return tapered_life.rating(case, "dynamic_rating").value


def load(case: TaperedCase) -> float:
    """P_r of ISO 281 [N].

    Raises `OutOfRange` where the ring is held, whose force is not known before it is solved.
    """
    if case.operation.held:
        raise OutOfRange("a ring that is held has a load that is not known")
    return tapered_life.dynamic_load(case)


CATALOGUE = Catalogue(
    RATING, lambda case: INFLUENCES, require_load, ratings, tapered_life.ratings, oil,
    tapered_life.by_rating, tapered_life.rated_kappa, load, lambda case: ROLLER_EXPONENT,
    lambda case: 1.0, dynamic,
)  # fmt: skip
