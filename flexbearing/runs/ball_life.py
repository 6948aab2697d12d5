"""The life of a ball bearing: by ISO/TS 16281 under the loads of its balls, and what modifies it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

import quasidynamic as qd
from flexbearing.build.ball_fits import kinematic_viscosity, solid
from flexbearing.build.ball_rows import rating_factor
from flexbearing.case.as_written import BALL_SIZES, as_written
from flexbearing.case.balls.angular_contact import AngularBearing, FastCase
from flexbearing.case.balls.mounting import MountedMaterials
from flexbearing.quantities.life_records import BY_LOADS, Factor
from flexbearing.runs.life_of_state import (
    LETTERS,
    MREV,
    LifeOfState,
    Rating,
    ReferenceLives,
    explained,
    no_life,
    of_reliability,
    why_none,
)
from quasidynamic import OutOfRange
from quasidynamic.note import Note, information
from quasidynamic.outcome.ball_capacity import (
    RATED_STEEL,
    ball_dynamic_rating,
    ball_fatigue_load_limit,
    ball_static_rating,
    require_radial,
    static_factor,
)
from quasidynamic.outcome.ball_equivalent_load import EquivalentLoad, ball_dynamic_load, ball_static_load
from quasidynamic.outcome.ball_life import ball_raceway_lives, ball_reference_life
from quasidynamic.outcome.life import reference_load, turning_share
from quasidynamic.outcome.life_factors import (
    BALLS,
    CLEANLINESS,
    LifeFactor,
    contamination_factor,
    modification_factor,
    modification_slope,
    viscosity_ratio,
)
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life, static_safety
from quasidynamic.parts.ball import BallRow
from quasidynamic.parts.material import Material


def lives(case: FastCase, state: qd.AngularContactState) -> ReferenceLives | None:
    """Lives under the loads of all balls; None at rest, without load, and where no rating is known.

    None, too, between rigid rings, where a cam is left out. The load of balls on a cam turns with it.
    """
    relative, on_cam = case.operation.inner_speed - case.operation.outer_speed, case.inner.kind == "cam"
    if not relative or unrated(case) or (on_cam and state.groove_displacement is None):
        return None
    of_load = case.operation.inner_speed if on_cam else 0.0
    speeds = case.operation.inner_speed - of_load, case.operation.outer_speed - of_load
    turning = turning_share(speeds[0], relative), turning_share(speeds[1], relative)
    balls, rating = row(case), dynamic(case)
    basic = ball_reference_life(state.loads, balls, turning, rating)
    if not np.isfinite(basic):
        return None
    raceways = ball_raceway_lives(state.loads, balls, turning, rating) * MREV
    modified = None if case.life.is_basic or unmodified(case) else _modified(case, basic)
    return ReferenceLives(basic * MREV, raceways, modified)


def equivalent(case: FastCase, lives: ReferenceLives) -> float:
    """Load that gives the same life by C_r, P_ref of ISO/TS 16281 [N]."""
    return _reference(case, lives.basic / MREV)


def _reference(case: FastCase, basic: float) -> float:
    """Load that gives a life [10^6 revolutions] by C_r of all rows [N]."""
    return float(reference_load(basic, rating_factor(case) * dynamic(case), BALL_EXPONENT))


def _modified(case: FastCase, basic: float) -> LifeOfState:
    """The life after every factor, from the basic one [10^6 revolutions]."""
    by_loads, load = [], _reference(case, basic)
    if case.life.loads == "rating":
        load = dynamic_load(case).value
        value, note = float(rating_life(dynamic(case), load, BALL_EXPONENT)) / basic, "ISO 281: (C_r/P)^3"
        by_loads.append(Factor("rating", value, BY_LOADS, note, 0.0))
    return LifeOfState.of(
        basic, by_loads, (*_lubrication(case, load), *of_reliability(case.life.reliability))
    )


def rated(case: FastCase) -> float | None:
    """Life by ratings alone [rev], which needs no equilibrium; None where the loads of the balls count.

    None, too, where ISO 281 has no such life.
    """
    if case.life.loads != "rating" or unmodified(case):
        return None
    load = dynamic_load(case).value
    basic = float(rating_life(dynamic(case), load, BALL_EXPONENT))
    return LifeOfState.of(
        basic, (), (*_lubrication(case, load), *of_reliability(case.life.reliability))
    ).modified


def _lubrication(case: FastCase, load: float) -> Iterator[LifeFactor]:
    """Factor a_ISO where the case requires it, at an equivalent load [N]."""
    if case.life.lubrication is None:
        return
    ratio_of_oil, share = kappa(case), fatigue_share(case) / load
    words = f"kappa {ratio_of_oil:.3g}, e_C C_u/P {share:.3g}, equivalent load {load:.4g} N"
    factor = explained(modification_factor(ratio_of_oil, share, BALLS), words)
    slope = float(modification_slope(ratio_of_oil, share, BALLS)) / BALL_EXPONENT
    yield replace(factor, life_exponent=slope if case.life.loads != "rating" else 0.0)


def unrated(case: FastCase) -> str:
    """Why there is no dynamic rating; empty where there is one."""
    return why_none(lambda: dynamic(case))


def unmodified(case: FastCase) -> str:
    """Why a case has no modified life; empty where it has one, or requires none."""
    if case.life.is_basic:
        return ""
    return unrated(case) or why_none(lambda: _require_factors(case))


def _require_factors(case: FastCase) -> None:
    """Raise `OutOfRange` where the geometry, speed or oil has no factor of the life, under any load."""
    if case.life.loads == "rating":
        dynamic_load(case)
    if case.life.lubrication:
        modification_factor(kappa(case), fatigue_share(case), BALLS)


def notes(case: FastCase) -> tuple[Note, ...]:
    """What keeps the life away, and what must be known of given ratings and of the oil."""
    changed = _of_other_balls(case)
    if case.operation.inner_speed == case.operation.outer_speed:
        return changed
    lines = changed + no_life(unrated(case), unmodified(case), rated_kappa(case))
    if case.life.lubrication and case.lubricant is not None and not unviscous(case):
        lines += kinematic_viscosity(case.lubricant)[1]
    return lines


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


BY_PRESSURE = "as the load that presses these contacts with 4200 MPa by Hertz"
PARTS = {part: f"materials.{part}" for part in ("ball", "inner_ring", "outer_ring")}


def dynamic(case: FastCase) -> float:
    """C_r of the case, or of ISO 281, of one row [N].

    Raises `OutOfRange` where ISO 281 has none: balls that are not of steel, contact angles and sizes beyond
    its table.
    """
    require_radial(row(case))
    materials = case.materials
    if case.life.dynamic_rating is None and not (materials.steel_balls or materials.hybrid):
        raise OutOfRange(
            f"balls of {materials.ball.youngs_modulus / 1e9:.4g} GPa: ISO 281 rates balls of steel, ISO "
            "20056-1 those of silicon nitride between rings of steel; give life.dynamic_rating"
        )
    return _rating(case, "dynamic_rating").value


def static(case: FastCase) -> float:
    """C_0r of the case, or of ISO 76, of one row [N]."""
    return _rating(case, "static_rating").value


def fatigue_limit(case: FastCase) -> float:
    """C_u of the case, or of ISO 281 from C_0r, of one row [N]."""
    if case.life.fatigue_limit_load is None:
        return ball_fatigue_load_limit(row(case), static(case))
    return _rating(case, "fatigue_limit_load").value


def ratings(case: FastCase) -> dict[str, Rating]:
    """Ratings that the case gives, by their keys."""
    given = (name for name in LETTERS if getattr(case.life, name) is not None)
    return {name: _rating(case, name) for name in given}


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


def _rating(case: FastCase, name: str) -> Rating:
    """A rating of the case."""
    now, given = rated_balls(case), getattr(case.life, name)
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
    for name in ratings(case):
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


def static_or_none(case: FastCase) -> float | None:
    """The same; None where ISO 76 has none."""
    try:
        return static(case)
    except OutOfRange:
        return None


def safety(case: FastCase, state: qd.AngularContactState) -> float | None:
    """Static safety s_0 under what the balls carry for the ring, preload with it; None of two rows."""
    rated = case.materials.steel_balls or case.materials.hybrid
    if case.bearing.second_row is not None or (case.life.static_rating is None and not rated):
        return None
    axial, radial_y, radial_z = state.ring_load[:3]
    try:
        load = ball_static_load(
            float(np.hypot(radial_y, radial_z)), abs(float(axial)), row(case).contact_angle
        )
        return float(static_safety(static(case), load.value))
    except OutOfRange:
        return None


def dynamic_load(case: FastCase) -> EquivalentLoad:
    """P_r of ISO 281; raises `OutOfRange` of two rows."""
    _require_one_row(case)
    balls, (radial, axial) = rated_balls(case), case.operation.forces
    ratio = static_factor(*balls) * axial / static(case)
    return ball_dynamic_load(radial, axial, balls.row.contact_angle, ratio)


def static_load(case: FastCase) -> EquivalentLoad:
    """P_0r of ISO 76; raises `OutOfRange` of two rows."""
    _require_one_row(case)
    radial, axial = case.operation.forces
    return ball_static_load(radial, axial, row(case).contact_angle)


def _require_one_row(case: FastCase) -> None:
    if case.bearing.second_row is not None:
        raise OutOfRange("equivalent loads of two rows are not offered")


def kappa(case: FastCase) -> float:
    """Viscosity ratio of ISO 281 [-]."""
    assert case.lubricant is not None  # checked on reading
    speed = case.operation.inner_speed - case.operation.outer_speed
    viscosity, _ = kinematic_viscosity(case.lubricant)
    return float(viscosity_ratio(viscosity, speed, case.bearing.pitch_diameter))


def unviscous(case: FastCase) -> str:
    """Why the oil has no viscosity at its temperature; empty where it has one."""
    oil = case.lubricant
    return "no oil is given" if oil is None else why_none(lambda: kinematic_viscosity(oil))


def rated_kappa(case: FastCase) -> float | None:
    """Viscosity ratio of a life with a_ISO [-]; None without, at rest, and beyond the data of the oil."""
    turns = case.operation.inner_speed != case.operation.outer_speed
    return kappa(case) if turns and case.life.lubrication and not unviscous(case) else None


def fatigue_share(case: FastCase) -> float:
    """Fatigue load limit of all rows that hard particles leave [N]."""
    cleanliness = CLEANLINESS[str(case.life.cleanliness)]
    left = contamination_factor(kappa(case), case.bearing.pitch_diameter, cleanliness)
    rows = 1 if case.bearing.second_row is None else 2
    return float(left) * rows * fatigue_limit(case)
