"""The life of a case after everything that modifies it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.build.lubrication import oil, roughness
from flexbearing.build.roller_bearing import nominal
from flexbearing.case.as_written import ROLLER_SIZES, as_written
from flexbearing.case.roller import Case
from flexbearing.life.life_of_state import CAPACITY, EDGE_STRESS, LifeOfState, explained
from flexbearing.life.rated_bearing import LoadedParts, RatedBearing, Rating
from flexbearing.quantities.life_records import BY_LOADS, ROLLER_BODY, Factor
from quasidynamic import CylindricalRollerBearing
from quasidynamic.note import Note
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
    slice_damages,
    slice_life,
    slice_reference_loads,
)
from quasidynamic.outcome.life_factors import (
    ROLLERS,
    LifeFactor,
    film_factor,
    material_factor,
)
from quasidynamic.outcome.raceway_damage import LINE
from quasidynamic.outcome.rating_life import LINE_EXPONENT, ROLLER_EXPONENT, EquivalentLoad
from quasidynamic.parts.profile import STRAIGHT


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
    own = rated(case, state.bearing)
    if case.life.is_basic or not np.isfinite(state.basic) or own.unrated:
        return None
    by_loads = tuple(_slice_factors(case, state, own))
    if own.without_factor:
        return LifeOfState(state.basic, by_loads, None)
    return LifeOfState.of(state.basic, by_loads, (*_lubrication_factors(case, state, own), *own.fixed))


def _slice_factors(case: Case, state: LoadedState, own: RatedBearing) -> Iterator[Factor]:
    """What capacity, edge stress and rollers make of the basic life, one after the other."""
    bearing, (inner, outer) = state.bearing, state.loads
    before, edge, capacity = state.basic, None, raceway_capacity(bearing)

    def life(rollers: RollerBody | None = None) -> float:
        loads = (inner, outer) if edge is None else (edge * inner, edge * outer)
        return float(slice_life(*loads, capacity, state.turning, rollers=rollers, rows=bearing.row_count))

    if case.life.loads == "rating":
        after = own.by_rating(case.operation.radial_load)
        reduced = "" if case.life.stress_reduction else f", C_r / {STRESS_REDUCTION}"
        note = f"ISO 281: (C_r/P)^({case.life.load_exponent}){reduced}"
        yield Factor("rating", after / before, BY_LOADS, note, 0.0)
        return
    if case.life.capacity == "iso281":
        rating = own.rating("dynamic_rating")
        capacity = reference_raceway_capacity(bearing, rating.value)
        after = life()
        note = f"ISO/TS 16281 by C_r = {rating.value:.5g} N, {rating.origin('ISO 281')}"
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


def _lubrication_factors(case: Case, state: LoadedState, own: RatedBearing) -> Iterator[LifeFactor]:
    if case.life.lubrication == "film":
        ratio = float((state.minimum_film / roughness(case)).min())
        yield explained(film_factor(ratio), f"smallest film ratio {ratio:.3g}")
    elif own.by_oil:
        load = case.operation.radial_load
        if not own.life_by_rating:
            load = own.reference_load(float(_reference(state, own, case.life.edge_stress)))
        yield from own.oil_factors(load, None if own.life_by_rating else _slices(case, state, own))


def _reference(state: LoadedState, own: RatedBearing, edge: bool) -> float:
    """Basic reference life [10^6 revolutions]."""
    inner, outer = state.loads
    return reference_life(inner, outer, state.bearing, state.turning, edge_stress=edge, rating=own.dynamic)


def _slices(case: Case, state: LoadedState, own: RatedBearing) -> LoadedParts:
    """Slices with the capacities of ISO/TS 16281."""
    edge, bearing = edge_stress(case, state.loads.shape[-1]), state.bearing
    inner, outer = state.loads if edge is None else edge * state.loads
    capacity = reference_raceway_capacity(bearing, own.dynamic)
    damages = slice_damages(inner, outer, capacity, state.turning, bearing.row_count)
    loads = slice_reference_loads(damages, capacity, bearing.rollers)
    return LoadedParts(loads, damages.sum(axis=0), LINE)


def edge_stress(case: Case, slices: int) -> NDArray | None:
    """Factor on the load of each slice (K) [-]; None where the case takes none."""
    return edge_stress_factor(slices) if case.life.edge_stress else None


def rated(case: Case, bearing: CylindricalRollerBearing) -> RatedBearing:
    """The bearing as the standards rate it, with the dimensions of its drawing."""
    life, drawn, operation = case.life, nominal(case, bearing), case.operation
    load = EquivalentLoad(operation.radial_load, 1.0, 0.0)
    return RatedBearing(
        life=life,
        rating=partial(_rating, case, drawn),
        limit_of_static=partial(fatigue_load_limit, drawn),
        load=lambda: load,
        static_load=lambda: load,
        elements=ROLLERS,
        exponent=ROLLER_EXPONENT,
        pitch_diameter=drawn.pitch_diameter,
        speed=operation.inner_speed - operation.outer_speed,
        viscosity=partial(_viscosity, case),
        needs_rating=life.capacity == "iso281" or life.loads == "rating" or life.lubrication == "a_ISO",
        rating_factor=1.0 if life.stress_reduction else 1 / STRESS_REDUCTION,
        load_exponent=ROLLER_EXPONENT if life.load_exponent == "10/3" else LINE_EXPONENT,
        material=tuple(_steel(case)),
    )


def _viscosity(case: Case) -> tuple[float, tuple[Note, ...]]:
    lubricant = oil(case)
    return lubricant.viscosity / lubricant.density, ()  # its notes are those of the films


def _steel(case: Case) -> Iterator[LifeFactor]:
    life = case.life
    if life.steel and life.melting:
        factor = material_factor(life.steel, life.melting)
        yield explained(
            factor, "ISO 281 has no such factor beside a_ISO" if life.lubrication == "a_ISO" else ""
        )


FORMULAS = {
    "dynamic_rating": dynamic_rating,
    "static_rating": static_rating,
    "fatigue_limit_load": fatigue_load_limit,
}


def _rating(case: Case, drawn: CylindricalRollerBearing, name: str) -> Rating:
    """A rating of the case for the dimensions of the drawing."""
    given = getattr(case.life, name)
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
