"""Ratings of a tapered roller bearing, and its life: by ISO/TS 16281 under the loads of its slices."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from flexbearing.build.ball_fits import kinematic_viscosity
from flexbearing.build.tapered_bearing import bearing
from flexbearing.case.as_written import TAPERED_SIZES, as_written
from flexbearing.case.tapered import TaperedCase
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
from quasidynamic import OutOfRange, TaperedLoads
from quasidynamic.note import Note
from quasidynamic.outcome.life import reference_load, turning_share
from quasidynamic.outcome.life_factors import (
    CLEANLINESS,
    ROLLERS,
    LifeFactor,
    contamination_factor,
    modification_factor,
    modification_slope,
    viscosity_ratio,
)
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT, rating_life, static_safety
from quasidynamic.outcome.tapered_life import (
    InclinedRow,
    axial_factor,
    induced_thrust,
    load_limit,
    tapered_dynamic_load,
    tapered_raceway_lives,
    tapered_reference_life,
    tapered_static_load,
)

FORMULAS: dict[str, Callable[[InclinedRow], float]] = {
    "dynamic_rating": lambda row: row.dynamic_rating,
    "static_rating": lambda row: row.static_rating,
    "fatigue_limit_load": lambda row: row.fatigue_load_limit(row.static_rating),
}


@dataclass(frozen=True)
class Rated:
    """What ratings say of the loads on a ring [N]."""

    dynamic: float | None  # C_r
    equivalent: float  # P
    limit: float  # e [-]
    factor: float  # Y [-]
    induced: float
    static_safety: float | None  # [-] s_0


def rated(case: TaperedCase, loads: TaperedLoads) -> Rated:
    """Ratings and equivalent loads; those of ISO 281 are absent beyond its table."""
    angle, (radial, axial) = case.bearing.cup_angle, _forces(loads)
    static = tapered_static_load(radial, axial, angle).value
    return Rated(
        dynamic=None if unrated(case) else rating(case, "dynamic_rating").value,
        equivalent=tapered_dynamic_load(radial, axial, angle).value,
        limit=load_limit(angle),
        factor=axial_factor(angle),
        induced=induced_thrust(radial, angle),
        static_safety=float(static_safety(rating(case, "static_rating").value, static)),
    )


def _forces(loads: TaperedLoads) -> tuple[float, float]:
    """Radial and axial load that the rollers carry [N]."""
    axial, y, z = loads.load[:3]
    return float(np.hypot(y, z)), abs(float(axial))


def lives(case: TaperedCase, loads: TaperedLoads) -> ReferenceLives | None:
    """Lives under the loads of all slices; None at rest, without load, and where no rating is known."""
    relative = loads.operation.relative_speed
    if not relative or unrated(case) or not loads.loads.any():
        return None
    operation = loads.operation
    turning = (
        turning_share(operation.inner_speed, relative), turning_share(operation.outer_speed, relative)
    )  # fmt: skip
    inner, outer = loads.slice_loads * loads.slices.widths
    row, dynamic = InclinedRow.of(loads.bearing), rating(case, "dynamic_rating").value
    basic = float(tapered_reference_life(inner, outer, row, turning, dynamic))
    raceways = tapered_raceway_lives(inner, outer, row, turning, dynamic) * MREV
    modified = None if case.life.is_basic or unmodified(case) else _modified(case, basic)
    return ReferenceLives(basic * MREV, raceways, modified)


def reference(case: TaperedCase, basic: float) -> float:
    """Load that gives a life [10^6 revolutions] by C_r [N]."""
    return float(reference_load(basic, rating(case, "dynamic_rating").value, ROLLER_EXPONENT))


def _modified(case: TaperedCase, basic: float) -> LifeOfState:
    """The life after every factor, from the basic one [10^6 revolutions]."""
    by_loads, load = [], reference(case, basic)
    if case.life.loads == "rating":
        load = dynamic_load(case)
        value = _by_rating(case, load) / basic
        by_loads.append(Factor("rating", value, BY_LOADS, "ISO 281: (C_r/P)^(10/3)", 0.0))
    factors = (*_lubrication(case, load), *of_reliability(case.life.reliability))
    return LifeOfState.of(basic, by_loads, factors)


def _by_rating(case: TaperedCase, load: float) -> float:
    return float(rating_life(rating(case, "dynamic_rating").value, load))


def by_rating(case: TaperedCase) -> float | None:
    """Life by ratings alone [rev], which needs no equilibrium; None where the loads of the slices count.

    None, too, where ISO 281 has no such life.
    """
    if case.life.loads != "rating" or unmodified(case):
        return None
    load = dynamic_load(case)
    factors = (*_lubrication(case, load), *of_reliability(case.life.reliability))
    return LifeOfState.of(_by_rating(case, load), (), factors).modified


def dynamic_load(case: TaperedCase) -> float:
    """P of ISO 281 [N], of a case whose forces are known."""
    return tapered_dynamic_load(*case.operation.forces, case.bearing.cup_angle).value


def _lubrication(case: TaperedCase, load: float) -> Iterator[LifeFactor]:
    """Factor a_ISO where the case requires it, at an equivalent load [N]."""
    if case.life.lubrication is None:
        return
    ratio, share = kappa(case), fatigue_share(case) / load
    words = f"kappa {ratio:.3g}, e_C C_u/P {share:.3g}, equivalent load {load:.4g} N"
    factor = explained(modification_factor(ratio, share, ROLLERS), words)
    slope = float(modification_slope(ratio, share, ROLLERS)) / ROLLER_EXPONENT
    yield replace(factor, life_exponent=slope if case.life.loads != "rating" else 0.0)


def rating(case: TaperedCase, name: str) -> Rating:
    """A rating of the case."""
    now, given = InclinedRow.of(bearing(case)), getattr(case.life, name)
    return Rating(FORMULAS[name], now, given, now if given is None else _rated(case, now, name))


def _rated(case: TaperedCase, now: InclinedRow, name: str) -> InclinedRow:
    """The row for which a rating of the case was given."""
    rollers, pitch, angle, diameter, length = as_written(case, f"life.{name}", TAPERED_SIZES)
    angle = now.contact_angle if angle is None else angle
    length = case.bearing.roller.length if length is None else length
    diameter = case.bearing.roller.diameter if diameter is None else diameter
    roller = replace(now.roller, diameter=diameter, length=length * float(np.cos(angle)))
    then = InclinedRow(rollers or now.rollers, roller, pitch or now.pitch_diameter, angle)
    return now if then == now else then


def ratings(case: TaperedCase) -> dict[str, Rating]:
    """Ratings that the case gives, by their keys."""
    return {name: rating(case, name) for name in LETTERS if getattr(case.life, name) is not None}


def unrated(case: TaperedCase) -> str:
    """Why there is no dynamic rating; empty where there is one."""
    return why_none(lambda: rating(case, "dynamic_rating").value)


def unmodified(case: TaperedCase) -> str:
    """Why a case has no modified life; empty where it has one, or requires none."""
    if case.life.is_basic:
        return ""
    return unrated(case) or why_none(lambda: _require_factors(case))


def _require_factors(case: TaperedCase) -> None:
    """Raise `OutOfRange` where the geometry, speed or oil has no factor of the life, under any load."""
    if case.life.lubrication:
        modification_factor(kappa(case), fatigue_share(case), ROLLERS)


def notes(case: TaperedCase) -> tuple[Note, ...]:
    """What keeps the life away, and what must be known of the oil."""
    if case.operation.inner_speed == case.operation.outer_speed:
        return ()
    lines = no_life(unrated(case), unmodified(case), rated_kappa(case))
    if case.life.lubrication and case.lubricant is not None and known_kappa(case) is not None:
        lines += kinematic_viscosity(case.lubricant)[1]
    return lines


def kappa(case: TaperedCase) -> float:
    """Viscosity ratio of ISO 281 [-]; raises `OutOfRange` beyond the data of the oil."""
    assert case.lubricant is not None  # checked on reading
    speed = case.operation.inner_speed - case.operation.outer_speed
    viscosity, _ = kinematic_viscosity(case.lubricant)
    return float(viscosity_ratio(viscosity, speed, case.bearing.pitch_diameter))


def known_kappa(case: TaperedCase) -> float | None:
    """Viscosity ratio of the oil [-]; None without an oil, at rest, and beyond its data."""
    if case.lubricant is None or case.operation.inner_speed == case.operation.outer_speed:
        return None
    try:
        return kappa(case)
    except OutOfRange:
        return None


def rated_kappa(case: TaperedCase) -> float | None:
    """The same of a life with a_ISO alone."""
    return known_kappa(case) if case.life.lubrication else None


def fatigue_share(case: TaperedCase) -> float:
    """Fatigue load limit that hard particles leave [N]."""
    cleanliness = CLEANLINESS[str(case.life.cleanliness)]
    left = contamination_factor(kappa(case), case.bearing.pitch_diameter, cleanliness)
    return float(left) * fatigue_limit(case)


def fatigue_limit(case: TaperedCase) -> float:
    """C_u of the case, or of ISO 281 from C_0r [N]."""
    limit = rating(case, "fatigue_limit_load")
    if limit.given is not None:
        return limit.value
    return InclinedRow.of(bearing(case)).fatigue_load_limit(rating(case, "static_rating").value)
