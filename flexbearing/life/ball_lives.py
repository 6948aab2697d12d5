"""The life of a ball bearing: by ISO/TS 16281 under the loads of its balls, and what modifies it."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

import quasidynamic as qd
from flexbearing.build.ball_fits import kinematic_viscosity, solid
from flexbearing.build.ball_rows import rating_factor
from flexbearing.case.as_written import BALL_SIZES, as_written
from flexbearing.case.balls.angular_contact import AngularBearing, FastCase
from flexbearing.case.balls.mounting import MountedMaterials
from flexbearing.life.life_of_state import MREV, ReferenceLives, why_none
from flexbearing.life.rated_bearing import LETTERS, LoadedParts, RatedBearing, Rating
from quasidynamic import OutOfRange
from quasidynamic.note import Note, information, outside
from quasidynamic.outcome.ball_capacity import (
    RATED_STEEL,
    ball_dynamic_rating,
    ball_fatigue_load_limit,
    ball_static_rating,
    require_radial,
    static_factor,
)
from quasidynamic.outcome.ball_equivalent_load import ball_dynamic_load, ball_static_load
from quasidynamic.outcome.ball_life import ball_raceway_lives, ball_reference_life, ball_row_damages
from quasidynamic.outcome.life import turning_share
from quasidynamic.outcome.life_factors import BALLS
from quasidynamic.outcome.raceway_damage import POINT
from quasidynamic.outcome.rating_life import (
    BALL_EXPONENT,
    EquivalentLoad,
    effective_static_safety,
    static_safety,
)
from quasidynamic.parts.ball import BallRow
from quasidynamic.parts.material import Material


def lives(case: FastCase, state: qd.AngularContactState) -> ReferenceLives | None:
    """Lives under the loads of all balls; None at rest, without load, and where no rating is known.

    None, too, between rigid rings, where a cam is left out. The load of balls on a cam turns with it.
    """
    relative, on_cam = case.operation.inner_speed - case.operation.outer_speed, case.inner.kind == "cam"
    own = rated(case)
    if not relative or own.unrated or (on_cam and state.groove_displacement is None):
        return None
    of_load = case.operation.inner_speed if on_cam else 0.0
    speeds = case.operation.inner_speed - of_load, case.operation.outer_speed - of_load
    turning = turning_share(speeds[0], relative), turning_share(speeds[1], relative)
    balls, rating = row(case), own.dynamic
    basic = ball_reference_life(state.loads, balls, turning, rating)
    if not np.isfinite(basic):
        return None
    raceways = ball_raceway_lives(state.loads, balls, turning, rating) * MREV
    damages = ball_row_damages(state.loads, balls, turning, rating).sum(axis=0)
    loads = len(damages) * rating * damages ** (1 / (POINT.weibull * BALL_EXPONENT))
    parts = LoadedParts(loads, damages, POINT)
    return ReferenceLives(basic * MREV, raceways, own.modified(basic, parts))


def rated(case: FastCase) -> RatedBearing:
    """The bearing as the standards rate it; each of two rows alike."""
    balls, operation, pair = rated_balls(case), case.operation, case.bearing.second_row is not None
    return RatedBearing(
        life=case.life,
        rating=partial(_rating, case, balls),
        limit_of_static=partial(ball_fatigue_load_limit, balls.row),
        load=partial(_dynamic_load, case, balls),
        static_load=partial(_static_load, case, balls),
        forces=operation.forces,
        elements=BALLS,
        exponent=BALL_EXPONENT,
        pitch_diameter=case.bearing.pitch_diameter,
        speed=operation.inner_speed - operation.outer_speed,
        viscosity=None if case.lubricant is None else partial(kinematic_viscosity, case.lubricant),
        require_rated=partial(_require_rated, case, balls),
        rows=1 + pair,
        rows_rating=rating_factor(case),
    )


def _require_rated(case: FastCase, balls: "RatedBalls") -> None:
    """Refuse balls that are not of steel or ceramics, and contact angles and sizes beyond the table."""
    require_radial(balls.row)
    materials = case.materials
    if case.life.dynamic_rating is None and not (materials.steel_balls or materials.hybrid):
        raise OutOfRange(
            f"balls of {materials.ball.youngs_modulus / 1e9:.4g} GPa: ISO 281 rates balls of steel, ISO "
            "20056-1 those of silicon nitride between rings of steel; give life.dynamic_rating"
        )


def _dynamic_load(case: FastCase, balls: "RatedBalls") -> EquivalentLoad:
    """P_r of ISO 281."""
    _require_known(case)
    radial, axial = case.operation.forces
    ratio = static_factor(*balls) * axial / _rating(case, balls, "static_rating").value
    return ball_dynamic_load(radial, axial, balls.row.contact_angle, ratio)


def _static_load(case: FastCase, balls: "RatedBalls") -> EquivalentLoad:
    """P_0r of ISO 76."""
    _require_known(case)
    return ball_static_load(*case.operation.forces, balls.row.contact_angle)


def _require_known(case: FastCase) -> None:
    if case.operation.held:
        raise OutOfRange("a ring that is held has a load that is not known")
    if case.bearing.second_row is not None:
        raise OutOfRange("equivalent loads of two rows are not offered")


def notes(case: FastCase) -> tuple[Note, ...]:
    """What keeps the life away, and what must be known of given ratings and of the oil."""
    own = rated(case)
    hybrid = (HYBRID_MODIFIED,) if case.materials.hybrid and own.by_oil and own.speed else ()
    return _of_other_balls(case) + hybrid + own.notes


def _of_other_balls(case: FastCase) -> tuple[Note, ...]:
    """Why given ratings are scaled by the material of the balls."""
    factors = {LETTERS[name]: factor for name, factor in of_other_balls(case).items() if factor != 1}
    if not factors:
        return ()
    times = ", ".join(f"{letter} times {factor:.2f}" for letter, factor in factors.items())
    with_static = "" if "C_u" in factors or "C_0r" not in factors else ", and C_u with C_0r"
    text = (
        f"given for balls of another material in the file: {times}{with_static}, {BY_PRESSURE}; C_r as given"
    )
    return (information("rating-of-other-balls", text),)


def row(case: FastCase) -> BallRow:
    """The balls as the standards see them: with the contact angle of the design, at any clearance."""
    parts, diameter = case.bearing, case.bearing.ball.diameter
    return BallRow(
        balls=parts.balls,
        ball_diameter=diameter,
        pitch_diameter=parts.pitch_diameter,
        contact_angle=parts.contact_angle if isinstance(parts, AngularBearing) else 0.0,
        inner_conformity=parts.inner.over(diameter),
        outer_conformity=parts.outer.over(diameter),
    )


HYBRID_MODIFIED = outside(
    "hybrid-modified-life",
    "a_ISO of steel balls for balls of silicon nitride: by its scope ISO 16281 (2025) has a basic reference "
    "life of hybrids, and no modified one",
)
BY_PRESSURE = "as the load that presses these contacts with 4200 MPa by Hertz"
PARTS = {part: f"materials.{part}" for part in ("ball", "inner_ring", "outer_ring")}


class RatedBalls(NamedTuple):
    """What the formulas of the standards rate."""

    row: BallRow
    material: Material  # for the static rating: that of the balls in hybrids, else the steel of ISO 76


FORMULAS: dict[str, Callable[[RatedBalls], float]] = {
    "dynamic_rating": lambda balls: ball_dynamic_rating(balls.row),
    "static_rating": lambda balls: ball_static_rating(*balls),
    "fatigue_limit_load": lambda balls: ball_fatigue_load_limit(balls.row, ball_static_rating(*balls)),
}


def rated_balls(case: FastCase) -> RatedBalls:
    """The balls of a case for its ratings."""
    return RatedBalls(row(case), rated_material(case.materials))


def rated_material(materials: MountedMaterials) -> Material:
    """Material of the balls in the static rating."""
    return solid(materials.ball) if materials.hybrid else RATED_STEEL


def _rating(case: FastCase, now: RatedBalls, name: str) -> Rating:
    """A rating of the case."""
    given = getattr(case.life, name)
    return Rating(FORMULAS[name], now, given, now if given is None else _rated(case, now, name))


def _rated(case: FastCase, now: RatedBalls, name: str) -> RatedBalls:
    """The balls for which a rating of the case was given."""
    sizes = as_written(case, f"life.{name}", BALL_SIZES)
    parts = dict(zip(PARTS, as_written(case, f"life.{name}", tuple(PARTS.values())), strict=True))
    materials = case.materials.model_copy(
        update={key: each for key, each in parts.items() if each is not None}
    )
    then = RatedBalls(row_of(now.row, sizes), rated_material(materials))
    return now if then == now else then


def of_other_balls(case: FastCase) -> dict[str, float]:
    """Given ratings of balls of another material, and by what the balls of the case change them [-]."""
    now = rated_balls(case)
    found = dict[str, float]()
    for name in rated(case).given:
        then = now._replace(material=_rated(case, now, name).material)
        if then != now and not why_none(lambda: FORMULAS["static_rating"](now)):
            found[name] = FORMULAS[name](now) / FORMULAS[name](then)
    return found


def row_of(now: BallRow, sizes: Sequence[Any]) -> BallRow:
    """A row of balls with the sizes that are stated, None of others."""
    balls, diameter, pitch, angle, *grooves = sizes
    size = diameter or now.ball_diameter
    stated = {
        "balls": balls,
        "ball_diameter": diameter,
        "pitch_diameter": pitch,
        "contact_angle": angle,
        "inner_conformity": _conformity(grooves[0], grooves[1], size),
        "outer_conformity": _conformity(grooves[2], grooves[3], size),
    }
    return replace(now, **{key: value for key, value in stated.items() if value is not None})


def _conformity(conformity: float | None, radius: float | None, diameter: float) -> float | None:
    """Groove radius over ball diameter; None of a groove that is not stated."""
    return radius / diameter if conformity is None and radius is not None else conformity


def safety(case: FastCase, state: qd.AngularContactState) -> float | None:
    """Static safety s_0 under what the balls carry for the ring, preload with it; None of two rows."""
    static = _static(case)
    if static is None or case.bearing.second_row is not None:
        return None
    axial, radial_y, radial_z = state.ring_load[:3]
    try:
        load = ball_static_load(
            float(np.hypot(radial_y, radial_z)), abs(float(axial)), row(case).contact_angle
        )
    except OutOfRange:
        return None
    return float(static_safety(static, load.value))


def effective_safety(case: FastCase, state: qd.AngularContactState) -> float | None:
    """Static safety under the largest contact load; None where there is no static rating."""
    static, balls = _static(case), row(case)
    if static is None:
        return None
    return float(effective_static_safety(static, state.loads.max(), balls.balls, balls.contact_angle))


def _static(case: FastCase) -> float | None:
    """C_0r of one row [N]; None where ISO 76 has none and the case gives none."""
    known = case.materials.steel_balls or case.materials.hybrid or case.life.static_rating is not None
    return rated(case).static_or_none if known else None
