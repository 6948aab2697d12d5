"""The life of a case after everything that modifies it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.build.lubrication import oil, roughness
from flexbearing.build.roller_bearing import nominal
from flexbearing.case.as_written import ROLLER_SIZES, as_written
from flexbearing.case.roller import Case
from flexbearing.quantities.life_records import BY_LOADS, ROLLER_BODY, Factor
from flexbearing.runs.life_of_state import (
    CAPACITY,
    EDGE_STRESS,
    LETTERS,
    LifeOfState,
    Rating,
    explained,
    of_reliability,
    why_none,
)
from quasidynamic import CylindricalRollerBearing
from quasidynamic.outcome.capacity import (
    STRESS_REDUCTION,
    dynamic_rating,
    fatigue_load_limit,
    raceway_capacity,
    reference_raceway_capacity,
    roller_capacity,
    static_rating,
)
from quasidynamic.outcome.life import (
    RollerBody,
    edge_stress_factor,
    reference_life,
    reference_load,
    slice_life,
)
from quasidynamic.outcome.life_factors import (
    CLEANLINESS,
    LifeFactor,
    contamination_factor,
    film_factor,
    material_factor,
    modification_factor,
    modification_slope,
    viscosity_ratio,
)
from quasidynamic.outcome.rating_life import LINE_EXPONENT, ROLLER_EXPONENT, rating_life
from quasidynamic.parts.profile import STRAIGHT


def unrated(case: Case, bearing: CylindricalRollerBearing) -> str:
    """Why the life of a case has no dynamic rating; empty where it has one, or needs none."""
    if case.life.capacity == "iso281" or case.life.loads == "rating" or case.life.lubrication == "a_ISO":
        return why_none(lambda: dynamic(case, bearing))
    return ""


def without_oil_factor(case: Case, bearing: CylindricalRollerBearing) -> str:
    """Why a case has no a_ISO under any load; empty where it has one, or requires none."""
    if case.life.lubrication != "a_ISO":
        return ""
    return why_none(lambda: modification_factor(kappa(case, bearing), fatigue_share(case, bearing)))


def unmodified(case: Case, bearing: CylindricalRollerBearing) -> str:
    """Why a case has no modified life; empty where it has one, or requires none."""
    return unrated(case, bearing) or without_oil_factor(case, bearing)


@dataclass(frozen=True)
class LoadedState:
    """What the life of one state of a bearing depends on."""

    bearing: CylindricalRollerBearing
    basic: float  # basic reference life [10^6 revolutions]
    loads: NDArray  # (2, Z, K) of each slice [N]
    turning: tuple[Any, Any]  # how far both rings turn against the load [-]
    minimum_film: NDArray  # (2) [m]


def modified(case: Case, state: LoadedState) -> LifeOfState | None:
    """Life after every factor of a case; None where nothing modifies it, carries load or rates it.

    Without the modified life where a_ISO does not hold for this bearing, speed and oil.
    """
    if case.life.is_basic or not np.isfinite(state.basic) or unrated(case, state.bearing):
        return None
    by_loads = tuple(_slice_factors(case, state))
    if without_oil_factor(case, state.bearing):
        return LifeOfState(state.basic, by_loads, None)
    factors = (*_lubrication_factors(case, state), *_fixed_factors(case))
    return LifeOfState.of(state.basic, by_loads, factors)


def rated(case: Case, bearing: CylindricalRollerBearing) -> float | None:
    """Life by ratings alone [rev], which needs no equilibrium; None where loads of rollers or films count.

    None, too, where ISO 281 has no such life.
    """
    if case.life.loads != "rating" or case.life.lubrication == "film" or unmodified(case, bearing):
        return None
    factors = (*_oil_factor(case, bearing, case.operation.radial_load), *_fixed_factors(case))
    return LifeOfState.of(_by_rating(case, bearing), (), factors).modified


def _slice_factors(case: Case, state: LoadedState) -> Iterator[Factor]:
    """What capacity, edge stress and rollers make of the basic life, one after the other."""
    bearing, (inner, outer) = state.bearing, state.loads
    before, edge, capacity = state.basic, None, raceway_capacity(bearing)

    def life(rollers: RollerBody | None = None) -> float:
        return float(slice_life(inner, outer, capacity, state.turning, edge=edge, rollers=rollers))

    if case.life.loads == "rating":
        after = _by_rating(case, bearing)
        reduced = "" if case.life.stress_reduction else f", C_r / {STRESS_REDUCTION}"
        note = f"ISO 281: (C_r/P)^({case.life.load_exponent}){reduced}"
        yield Factor("rating", after / before, BY_LOADS, note, 0.0)
        return
    if case.life.capacity == "iso281":
        rating = dynamic(case, bearing)
        capacity = reference_raceway_capacity(bearing, rating)
        after = life()
        origin = _rating(case, bearing, "dynamic_rating").origin("ISO 281")
        note = f"ISO/TS 16281 by C_r = {rating:.5g} N, {origin}"
        yield Factor(CAPACITY, after / before, BY_LOADS, note, 0.0)
        before = after
    if case.life.edge_stress:
        edge = edge_stress(case, inner.shape[-1])
        after = life()
        note = f"ISO/TS 16281, {inner.shape[-1]} slices"
        yield Factor(EDGE_STRESS, after / before, BY_LOADS, note, 0.0)
        before = after
    if case.life.roller_body:
        ratio = bearing.diameter_ratio
        turns = (1 - ratio**2) / (2 * ratio)
        after = life(rollers=RollerBody(capacity=roller_capacity(bearing), speed_ratio=turns))
        note = f"rollers fail too; {turns:.3g} turns of a roller in one of the ring"
        yield Factor(ROLLER_BODY, after / before, BY_LOADS, note, 0.0)


def _by_rating(case: Case, bearing: CylindricalRollerBearing) -> float:
    """L10 of the radial load [10^6 revolutions]."""
    rating = rating_factor(case) * dynamic(case, bearing)
    return float(rating_life(rating, case.operation.radial_load, exponent(case)))


def rating_factor(case: Case) -> float:
    """C_r of a life by ratings over that of the case [-]."""
    return 1.0 if case.life.stress_reduction else 1 / STRESS_REDUCTION


def exponent(case: Case) -> float:
    """Exponent of the load in a life by ratings [-]."""
    return ROLLER_EXPONENT if case.life.load_exponent == "10/3" else LINE_EXPONENT


def _lubrication_factors(case: Case, state: LoadedState) -> Iterator[LifeFactor]:
    if case.life.lubrication == "film":
        ratio = float((state.minimum_film / roughness(case)).min())
        yield explained(film_factor(ratio), f"smallest film ratio {ratio:.3g}")
    elif case.life.lubrication == "a_ISO":
        bearing, (inner, outer) = state.bearing, state.loads
        rating = dynamic(case, bearing)
        edge = case.life.edge_stress
        load = case.operation.radial_load
        if case.life.loads == "rollers":
            life = reference_life(inner, outer, bearing, state.turning, edge_stress=edge, rating=rating)
            load = float(reference_load(life, rating))
        yield from _oil_factor(case, bearing, load)


def _oil_factor(case: Case, bearing: CylindricalRollerBearing, load: float) -> Iterator[LifeFactor]:
    """a_ISO at an equivalent load [N], where the case has it."""
    if case.life.lubrication == "a_ISO":
        ratio_of_oil, ratio = kappa(case, bearing), fatigue_share(case, bearing) / load
        words = f"kappa {ratio_of_oil:.3g}, e_C C_u/P {ratio:.3g}, equivalent load {load:.4g} N"
        factor = explained(modification_factor(ratio_of_oil, ratio), words)
        slope = float(modification_slope(ratio_of_oil, ratio)) / ROLLER_EXPONENT
        yield replace(factor, life_exponent=slope if case.life.loads == "rollers" else 0.0)


def _fixed_factors(case: Case) -> list[LifeFactor]:
    """Factors that the loads do not change."""
    life, factors = case.life, []
    if life.steel and life.melting:
        factor = material_factor(life.steel, life.melting)
        beside = "ISO 281 has no such factor beside a_ISO" if life.lubrication == "a_ISO" else ""
        factors.append(explained(factor, beside))
    return [*factors, *of_reliability(life.reliability)]


def edge_stress(case: Case, slices: int) -> NDArray | None:
    """Factor on the load of each slice (K) [-]; None where the case takes none."""
    return edge_stress_factor(slices) if case.life.edge_stress else None


def dynamic(case: Case, bearing: CylindricalRollerBearing) -> float:
    """C_r of the case, or of ISO 281 for the dimensions of the drawing [N]."""
    return _rating(case, bearing, "dynamic_rating").value


def static(case: Case, bearing: CylindricalRollerBearing) -> float:
    """C_0r of the case, or of ISO 76 for the dimensions of the drawing [N]."""
    return _rating(case, bearing, "static_rating").value


def fatigue_limit(case: Case, bearing: CylindricalRollerBearing) -> float:
    """C_u of the case, or of ISO 281 from C_0r [N]."""
    if case.life.fatigue_limit_load is None:
        return fatigue_load_limit(nominal(case, bearing), static(case, bearing))
    return _rating(case, bearing, "fatigue_limit_load").value


def ratings(case: Case, bearing: CylindricalRollerBearing) -> dict[str, Rating]:
    """Ratings that the case gives, by their keys."""
    given = (name for name in LETTERS if getattr(case.life, name) is not None)
    return {name: _rating(case, bearing, name) for name in given}


FORMULAS = {
    "dynamic_rating": dynamic_rating,
    "static_rating": static_rating,
    "fatigue_limit_load": fatigue_load_limit,
}


def _rating(case: Case, bearing: CylindricalRollerBearing, name: str) -> Rating:
    """A rating of the case for the dimensions of the drawing."""
    drawn, given = nominal(case, bearing), getattr(case.life, name)
    return Rating(FORMULAS[name], drawn, given, drawn if given is None else _rated(case, drawn, name))


def _rated(case: Case, drawn: CylindricalRollerBearing, name: str) -> CylindricalRollerBearing:
    """The bearing for which a rating of the case was given."""
    sizes = drawn.rollers, drawn.outer_raceway_diameter, drawn.roller.diameter, drawn.roller.length
    stated = as_written(case, f"life.{name}", ROLLER_SIZES)
    written = tuple(now if then is None else then for now, then in zip(sizes, stated, strict=True))
    if written == sizes:
        return drawn
    rollers, outer, diameter, length = written
    return replace(
        drawn,
        rollers=rollers,
        outer_raceway_diameter=outer,
        roller=replace(drawn.roller, diameter=diameter, length=length, profile=STRAIGHT),
        inner_profile=STRAIGHT,
        outer_profile=STRAIGHT,
        inner_waves=None,
        outer_waves=None,
        roller_deviations=(),
    )


def kappa(case: Case, bearing: CylindricalRollerBearing) -> float:
    """Viscosity ratio of ISO 281 [-]."""
    lubricant, operation = oil(case), case.operation
    speed, pitch = operation.inner_speed - operation.outer_speed, nominal(case, bearing).pitch_diameter
    return float(viscosity_ratio(lubricant.viscosity / lubricant.density, speed, pitch))


def rated_kappa(case: Case, bearing: CylindricalRollerBearing) -> float | None:
    """Viscosity ratio of a life with a_ISO [-]; None without, and at rest."""
    operation = case.operation
    turns = operation.inner_speed != operation.outer_speed
    return kappa(case, bearing) if turns and case.life.lubrication == "a_ISO" else None


def fatigue_share(case: Case, bearing: CylindricalRollerBearing) -> float:
    """Fatigue load limit that hard particles leave [N]."""
    cleanliness = CLEANLINESS[str(case.life.cleanliness)]
    pitch = nominal(case, bearing).pitch_diameter
    left = contamination_factor(kappa(case, bearing), pitch, cleanliness)
    return float(left) * fatigue_limit(case, bearing)
