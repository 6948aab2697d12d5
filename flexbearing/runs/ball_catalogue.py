"""What the life of a ball bearing has that a catalogue leaves out."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from flexbearing.build.ball_fits import kinematic_viscosity
from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.deep_groove import DeepGrooveBearing
from flexbearing.quantities.life_records import Ratings
from flexbearing.runs import ball_life
from flexbearing.runs.catalogue_life import Catalogue, Influence
from flexbearing.runs.life_of_state import LETTERS, of_oil
from quasidynamic import OutOfRange
from quasidynamic.outcome.life_factors import BALLS, modification_factor
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life, static_safety

WEIGHTLESS = "0.001 kg/m^3"  # of balls without inertia

RATING = (
    Influence(
        "ISO 281: (C_r/P)^3, P = X F_r + Y F_a",
        {"life.loads": "rating"},
        "One load P replaces radial and axial load; nothing else of the case counts.",
    ),
    Influence(
        "loads of all balls, without inertia, tilt or clearance",
        {},
        "The loads of all balls at their own contact angles instead of one load P: X and Y are the larger "
        "step away from them the more balls the axial load presses.",
    ),
)
MOUNTING = {
    "bearing.fits": "",
    "operation.temperatures": "",
    **{f"materials.{ring}.density": "" for ring in ("inner_ring", "outer_ring")},
    **{f"materials.{part}.expansion": "" for part in ("ball", "inner_ring", "outer_ring")},
}
FITS = Influence(
    "fits and heat, which change the contact angle",
    {},
    "Fits and heat change the clearance, and with it the angle at which the balls carry.",
)
CLEARANCE = Influence(
    "operating clearance",
    {"bearing.clearance": "0 um", "bearing.clearance_class": ""},
    "Clearance leaves fewer balls to carry a radial load, and gives an axial load a steeper contact angle.",
)
ELASTIC_RINGS = Influence(
    "elastic rings",
    {"outer": "", "outer.kind": "rigid", "inner": "", "inner.kind": "rigid", "accuracy": ""},
    "Elastic rings change how many balls carry the load, and at which contact angles.",
)
TILT = Influence(
    "tilt of the inner ring",
    {
        "operation.load.moment_y": "0 N m",
        "operation.load.moment_z": "0 N m",
        "operation.displacement.tilt_y": "0 deg",
        "operation.displacement.tilt_z": "0 deg",
    },
    "A moment, or a ring that is held askew or straight, loads the balls unevenly.",
)
NOT_ROUND = Influence(
    "form errors of the raceways",
    {"bearing.form_error": ""},
    "Raceways that are not round change which balls carry the load.",
)
AT_SPEED = (
    Influence(
        "inertia of the balls at speed",
        {"materials.ball.density": WEIGHTLESS},
        "Centrifugal forces press the balls to the outer race and part the contact angles.",
    ),
    Influence(
        "friction that decides how the balls turn",
        {
            "operation.control": "outer",
            "friction.model": "full_sliding",
            "friction.cells": "",
            "friction.interface_compliance": "",
        },
        "Which race controls how the balls turn decides who bears their gyroscopic moment.",
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


def influences(case: FastCase) -> tuple[Influence, ...]:
    """What may act, in the order in which it enters: clearance, tilt and preload, then what speed does."""
    clearance, elastic = _with_materials(case)
    preload, first = case.operation.preload, (clearance, TILT, NOT_ROUND)
    if preload is None:
        return (*first, *elastic, *AT_SPEED)
    of_spring = {"operation.preload": "", "operation.load.axial": f"{preload.force!r} N"}
    preloaded = Influence(
        "rigid preload instead of that of a spring",
        of_spring,
        "A rigid preload changes with the load, one by a spring does not.",
    )
    return (*first, preloaded, *elastic, *AT_SPEED)


def _with_materials(case: FastCase) -> tuple[Influence, tuple[Influence, ...]]:
    """Clearance or fits, and elastic rings; materials of shaft and housing go with what needs them."""
    fits, first = case.bearing.fits, CLEARANCE if isinstance(case.bearing, DeepGrooveBearing) else FITS
    by_fits = {"shaft": fits is not None, "housing": fits is not None and bool(fits.housing)}
    by_rings = {"shaft": case.inner.kind != "rigid", "housing": case.outer.support == "housing"}

    def without(of_fits: bool, of_rings: bool) -> dict[str, str]:
        needed = (of_fits, of_rings)
        return {f"materials.{name}": "" for name in by_fits if (by_fits[name], by_rings[name]) == needed}

    mounting = {} if fits is None else MOUNTING
    first = replace(
        first, out={**first.out, **mounting, **without(True, False)}, also_out=without(True, True)
    )
    rings = replace(ELASTIC_RINGS, out={**ELASTIC_RINGS.out, **without(False, True)})
    return first, () if case.rigid else (rings,)


def require_load(case: FastCase) -> None:
    """Require forces that are known before the case is solved, and a ring that turns.

    Raises `BadCase` where one of them is missing.
    """
    for name in case.operation.held:
        raise BadCase(f"[operation] {name}: a catalogue knows lives under given forces only; give a force.")
    if not any(case.operation.forces):
        raise BadCase("[operation.load]: without a force a catalogue knows no life.")
    if case.operation.inner_speed == case.operation.outer_speed:
        raise BadCase("[operation] inner_speed: no ring turns against the other; there is no life.")


def ratings(case: FastCase, hours: float) -> Ratings:
    """What a catalogue's page says, and what it says of the load."""
    load, at_rest = ball_life.dynamic_load(case), ball_life.static_load(case)
    radial, axial = case.operation.forces
    static = ball_life.static(case)
    lived = float(rating_life(ball_life.dynamic(case), load.value, BALL_EXPONENT))
    balls, stated = ball_life.rated_balls(case), ball_life.ratings(case)
    return Ratings(
        ratings_N={"C_r": ball_life.dynamic(case), "C_0r": static, "C_u": ball_life.fatigue_limit(case)},
        given=[LETTERS[name] for name in stated],
        scales={LETTERS[name]: rating.scale for name, rating in stated.items()},
        formulas_N={LETTERS[name]: _known(of, balls) for name, of in ball_life.FORMULAS.items()},
        load_N=load.value,
        equivalent_load={
            "F_r_N": radial, "F_a_N": axial,
            "e": load.limit, "X": load.radial_factor, "Y": load.axial_factor, "note": load.note,
            "X_0": at_rest.radial_factor, "Y_0": at_rest.axial_factor, "P_0_N": at_rest.value,
        },
        static_safety=float(static_safety(static, at_rest.value)),
        life_Mrev=lived,
        life_h=lived * hours,
        **_by_oil(case, load.value, lived, hours),
    )  # fmt: skip


def _known(formula: Callable[[Any], float], balls: ball_life.RatedBalls) -> float | None:
    """A rating by its formula; None where that does not hold."""
    try:
        return formula(balls)
    except OutOfRange:
        return None


def _by_oil(case: FastCase, load: float, lived: float, hours: float) -> dict[str, Any]:
    """Modified rating life of ISO 281, where the case says how clean the oil is."""
    kappa = ball_life.rated_kappa(case)
    if kappa is None:
        return {}
    if ball_life.unmodified(case):
        return {"viscosity_ratio": kappa}
    factor = float(modification_factor(kappa, ball_life.fatigue_share(case) / load, BALLS).value)
    return {
        "viscosity_ratio": kappa, "a_ISO": factor, "modified_Mrev": lived * factor,
        "modified_h": lived * factor * hours,
    }  # fmt: skip


def oil(case: FastCase, lived: float) -> dict[str, float]:
    """What ISO 281 says of the oil of a case, at the load that has a life [10^6 revolutions]."""
    if case.lubricant is None:
        return {}
    viscosity, _ = kinematic_viscosity(case.lubricant)
    return of_oil(
        viscosity,
        case.operation.inner_speed - case.operation.outer_speed,
        case.bearing.pitch_diameter,
        lived ** (1 / BALL_EXPONENT) * ball_life.fatigue_limit(case) / ball_life.dynamic(case),
        BALLS,
    )


def load(case: FastCase) -> float:
    """P_r of ISO 281 [N].

    Raises `OutOfRange` where the ring is held, whose force is not known before it is solved, and beyond the
    table of X, Y.
    """
    if case.operation.held:
        raise OutOfRange("a ring that is held has a load that is not known")
    return ball_life.dynamic_load(case).value


CATALOGUE = Catalogue(
    RATING, influences, require_load, ratings, ball_life.ratings, oil,
    ball_life.rated, ball_life.rated_kappa, load, lambda case: BALL_EXPONENT,
    lambda case: 1.0, ball_life.dynamic,
)  # fmt: skip
