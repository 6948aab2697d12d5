"""Ratings of a tapered roller bearing, and its life: by ISO/TS 16281 under the loads of its slices."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from flexbearing.build.ball_fits import kinematic_viscosity
from flexbearing.build.tapered_bearing import bearing
from flexbearing.case.as_written import TAPERED_SIZES, as_written
from flexbearing.case.tapered import TaperedCase
from flexbearing.case.tapered.tapered_case import STEEPEST
from flexbearing.life.life_of_state import MREV, ReferenceLives
from flexbearing.life.rated_bearing import LoadedParts, RatedBearing, Rating
from quasidynamic import OutOfRange, RingOperation, TaperedLoads, TaperedRollerBearing, tapered_loads
from quasidynamic.outcome.capacity import fatigue_load_limit
from quasidynamic.outcome.life import slice_damages, slice_reference_loads, turning_share
from quasidynamic.outcome.life_factors import ROLLERS
from quasidynamic.outcome.raceway_damage import LINE
from quasidynamic.outcome.rating_life import (
    ROLLER_EXPONENT,
    EquivalentLoad,
    effective_static_safety,
    static_safety,
)
from quasidynamic.outcome.tapered_life import (
    InclinedRow,
    SphericalRow,
    axial_factor,
    induced_thrust,
    load_limit,
    tapered_dynamic_load,
    tapered_static_load,
)
from quasidynamic.outcome.thrust_roller_capacity import ThrustRow
from quasidynamic.parts.angular_contact_bearing import RowPlace

FORMULAS: dict[str, Callable[[InclinedRow], float]] = {
    "dynamic_rating": lambda row: row.dynamic_rating,
    "static_rating": lambda row: row.static_rating,
    "fatigue_limit_load": lambda row: fatigue_load_limit(row, row.static_rating),
}


@dataclass(frozen=True)
class LoadsRated:
    """What ratings say of the loads on a ring [N]."""

    dynamic: float | None  # C_r
    equivalent: float  # P
    limit: float  # e [-]
    factor: float  # Y [-]
    induced: float | None  # of one row
    unloading_force: float | None  # of rows against each other
    static_safety: float  # [-] s_0
    effective_static_safety: float  # [-] S_0,eff


def loads_rated(case: TaperedCase, loads: TaperedLoads) -> LoadsRated:
    """Ratings and equivalent loads; those of ISO 281 are absent beyond its table."""
    angle, (radial, axial), opposed = case.bearing.cup_angle, _forces(loads), case.bearing.opposed
    own, model = rated(case), loads.bearing
    largest = float(loads.slice_loads.max()) * model.roller.length
    return LoadsRated(
        dynamic=None if own.unrated else own.dynamic,
        equivalent=_equivalent(case, radial, axial, tapered_dynamic_load).value,
        limit=load_limit(angle),
        factor=axial_factor(angle, opposed=opposed),
        induced=None if case.bearing.pair else induced_thrust(radial, angle),
        unloading_force=_unloading_force(case, loads),
        static_safety=float(
            static_safety(own.static, _equivalent(case, radial, axial, tapered_static_load).value)
        ),
        effective_static_safety=float(
            effective_static_safety(own.static, largest, model.rollers, model.cup_angle, len(model.rows))
        ),
    )


def rated_row(bearing: TaperedRollerBearing) -> InclinedRow:
    """The rows of a bearing as ratings see them."""
    kind = (
        ThrustRow if bearing.cup_angle > STEEPEST else SphericalRow if any(bearing.hollows) else InclinedRow
    )
    return kind.of(bearing)


def _unloading_force(case: TaperedCase, loads: TaperedLoads) -> float | None:
    """Axial load at which the row that it relieves just touches: what the other one carries then, at rest."""
    if not loads.bearing.opposed:
        return None
    closer = loads.bearing.rows[0].closer
    if closer <= 0.0:
        return 0.0
    alone = replace(loads.bearing, rows=(RowPlace(),))
    held = RingOperation(displacement=(2 * closer, 0.0, 0.0, 0.0, 0.0))
    return float(tapered_loads(alone, held, case.accuracy.slices).load[0])


def _forces(loads: TaperedLoads) -> tuple[float, float]:
    """Radial and axial load that the rollers carry [N]."""
    axial, y, z = loads.load[:3]
    return float(np.hypot(y, z)), abs(float(axial))


def lives(case: TaperedCase, loads: TaperedLoads) -> ReferenceLives | None:
    """Lives under the loads of all slices; None at rest, without load, and where no rating is known.

    Ribs are left out: they wear, or seize, before they fatigue.
    """
    relative, own = loads.operation.relative_speed, rated(case)
    if not relative or own.unrated or not loads.loads.any():
        return None
    operation = loads.operation
    turning = (
        turning_share(operation.inner_speed, relative), turning_share(operation.outer_speed, relative)
    )  # fmt: skip
    inner, outer = loads.slice_loads * loads.slices.widths
    row, dynamic = rated_row(loads.bearing), own.dynamic
    capacity, parts = row.raceway_capacity(dynamic), None
    damages = slice_damages(inner, outer, capacity, turning, row.row_count)
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        raceways = damages.sum(axis=(1, 2)) ** (-1 / LINE.weibull) * MREV
    basic = float(damages.sum() ** (-1 / LINE.weibull))
    if case.life.modification == "slices":
        slices = slice_reference_loads(damages, capacity, row.rollers, row.contact_angle)
        parts = LoadedParts(slices, damages.sum(axis=0), LINE)
    return ReferenceLives(basic * MREV, raceways, own.modified(basic, parts))


def rated(case: TaperedCase) -> RatedBearing:
    """The bearing as the standards rate it."""
    row, operation = rated_row(bearing(case)), case.operation
    return RatedBearing(
        life=case.life,
        rating=partial(_rating, case, row),
        limit_of_static=partial(fatigue_load_limit, row),
        load=partial(_load, case, tapered_dynamic_load),
        static_load=partial(_load, case, tapered_static_load),
        forces=operation.forces,
        elements=ROLLERS,
        exponent=ROLLER_EXPONENT,
        pitch_diameter=row.pitch_diameter,
        speed=operation.inner_speed - operation.outer_speed,
        viscosity=None if case.lubricant is None else partial(kinematic_viscosity, case.lubricant),
    )


Formula = Callable[..., EquivalentLoad]  # of F_r, F_a, contact angle, opposed


def _load(case: TaperedCase, formula: Formula) -> EquivalentLoad:
    """An equivalent load of a case whose forces are known."""
    if case.operation.held:
        raise OutOfRange("a ring that is held has a load that is not known")
    return _equivalent(case, *case.operation.forces, formula)


def _equivalent(case: TaperedCase, radial: float, axial: float, formula: Formula) -> EquivalentLoad:
    """An equivalent load, by a formula of radial bearings; that of washers is the axial load."""
    angle = case.bearing.cup_angle
    if angle > STEEPEST:
        return EquivalentLoad(axial, 0.0, 1.0)
    return formula(radial, axial, angle, opposed=case.bearing.opposed)


def _rating(case: TaperedCase, now: InclinedRow, name: str) -> Rating:
    """A rating of the case."""
    given = getattr(case.life, name)
    return Rating(FORMULAS[name], now, given, now if given is None else _rated(case, now, name))


def _rated(case: TaperedCase, now: InclinedRow, name: str) -> InclinedRow:
    """The row for which a rating of the case was given."""
    rollers, pitch, cup, angle, diameter, length = as_written(case, f"life.{name}", TAPERED_SIZES)
    angle = next((each for each in (cup, angle) if each is not None), now.contact_angle)
    length = case.bearing.roller.length if length is None else length
    diameter = case.bearing.roller.diameter if diameter is None else diameter
    roller = replace(now.roller, diameter=diameter, length=length * now.projection(angle))
    then = type(now)(rollers or now.rollers, roller, pitch or now.pitch_diameter, angle, now.row_count)
    return now if then == now else then
