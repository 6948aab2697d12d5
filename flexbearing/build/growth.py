"""How far heat, speed and fits widen the raceways of flexible rings: harmonic 0 of their finite elements."""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

import fem
from fem.errors import NotSolved
from flexbearing.build.expansion import expansion_coefficient, hot_over_cold, material, roller_length
from flexbearing.build.mesh_sizes import ON_A_SECTION, mesh_size, nodes_of
from flexbearing.build.ring_parts import (
    inner_part,
    outer_part,
)
from flexbearing.build.seat_growth import seat_growth, seat_strain
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from quasidynamic.clearance import FitConditions, RacewayExpansion, Seat
from quasidynamic.clearance.operating_clearance import Expansion

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from fem.joint.fitted_ring import FittedBodies, FittedRing, HousedRing
    from fem.joint.preloaded_fit import Fit, PreloadedFit
    from fem.section.expansion import Along


def expansions(case: Case) -> tuple[Expansion | None, Expansion | None]:
    """Expansion of the inner and the outer raceway by the conditions of their fits; None in closed form.

    Rings on a flexible shaft and rings that touch a flexible housing are expanded by the finite elements that
    also tell the pressure of their fits; of all others the closed form knows as much.
    """
    inner = None if case.inner.kind == "rigid" else _inner(case)
    outer = _outer(case) if case.lifts_off else None
    return inner, outer


def mean_seat_growth(case: Case) -> float:
    """Mean expansion of the outer raceway by its seat beyond its own heat [m]."""
    growth = seat_growth(case)
    return 0.0 if growth is None else seat_strain(case) * growth.mean


def _inner(case: Case) -> Expansion:
    def expansion(conditions: FitConditions) -> RacewayExpansion:
        state = _pressed_inner(case, conditions)
        return RacewayExpansion(mean_growth(state, hot_over_cold(case, "inner_ring")), _seat(state))

    return expansion


def pressed_inner_ring(case: Case) -> "NDArray":
    """Growth (M,) [m] of the inner raceway, pressed on its shaft without friction, hot and turning."""
    temperatures = case.operation.temperatures
    rises = {"inside_rise": 0.0, "outside_rise": 0.0}
    if temperatures is not None:
        rises = {
            "inside_rise": temperatures.shaft - temperatures.reference,
            "outside_rise": temperatures.inner_ring - temperatures.reference,
        }
    return _pressed_inner(case, FitConditions(speed=case.operation.inner_speed, **rises)).expansion


def _pressed_inner(case: Case, conditions: FitConditions) -> "PreloadedFit":
    from fem.joint.fitted_ring import FittedRing
    from fem.joint.preloaded_fit import Fit

    seat = inner_part(case)
    assert seat  # or the ring would be rigid
    ring, shaft = material(case, "inner_ring"), material(case, "shaft")
    fit = Fit(
        interference=case.shaft_interference,
        friction=0.0,
        clamping=case.inner.clamping,
        thermal_strains=(
            expansion_coefficient(case, "inner_ring") * conditions.outside_rise,
            expansion_coefficient(case, "shaft") * conditions.inside_rise,
        ),
        densities=(ring.density, shaft.density),
        speed=conditions.speed,
    )
    along = expansions_along(case, ring="inner_ring", shaft="shaft") if _hot(conditions) else {}
    return _preloaded(case, FittedRing(seat=seat, shoulder_diameter=case.inner.shoulder_diameter), along, fit)


def _outer(case: Case) -> Expansion:
    from fem.joint.fitted_ring import HousedRing
    from fem.joint.preloaded_fit import Fit

    seat = outer_part(case)
    assert isinstance(seat, fem.OuterRing)  # or it would not be in a housing
    part = HousedRing(seat=seat)
    ring, housing = material(case, "outer_ring"), material(case, "housing")

    def expansion(conditions: FitConditions) -> RacewayExpansion:
        fit = Fit(
            interference=case.housing_interference,
            friction=0.0,
            thermal_strains=(
                expansion_coefficient(case, "outer_ring") * conditions.inside_rise,
                expansion_coefficient(case, "housing") * conditions.outside_rise,
            ),
            densities=(ring.density, housing.density),
            speed=conditions.speed,
        )
        along = expansions_along(case, ring="outer_ring", housing="housing") if _hot(conditions) else {}
        state = _preloaded(case, part, along, fit)
        return RacewayExpansion(mean_growth(state, hot_over_cold(case, "outer_ring")), _seat(state))

    return expansion


def _hot(conditions: FitConditions) -> bool:
    return bool(conditions.inside_rise or conditions.outside_rise)


def _preloaded(
    case: Case, part: "FittedRing | HousedRing", along: Mapping[str, "Along"], fit: "Fit"
) -> "PreloadedFit":
    from fem.joint.preloaded_fit import preloaded

    try:
        return preloaded(_condensed(part, fit_resolution(case, part), tuple(along.items())), fit)
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    except NotSolved as problem:
        raise BadCase(f"{case.source.path}: growth of the raceway: {problem}") from problem


def mean_growth(state: "PreloadedFit", hot: float) -> float:
    """Mean expansion [m] of a raceway from its cold radius, on the mesh of a ring that is `hot` over cold."""
    cold_radius = state.bodies.part.seat.raceway_diameter / 2 / hot
    twice = state.fit.thermal_strains[0] * (hot - 1) * cold_radius  # the mesh has expanded already
    return state.growth - twice


def _seat(state: "PreloadedFit") -> Seat:
    """Mean pressure over the bore, or the mean gap of a fit that is open all over."""
    if (state.force > 0).any():
        return Seat(pressure=state.mean_pressure, gap=0.0)
    return Seat(pressure=0.0, gap=float(state.gap.mean()))


@lru_cache(maxsize=8)
def _condensed(
    part: "FittedRing | HousedRing", resolution: fem.Resolution, along: "tuple[tuple[str, Along], ...]"
) -> "FittedBodies":
    """Bodies of a fit by harmonic 0; the lowest that a fit can be condensed with are enough."""
    from fem.joint.fitted_ring import condense_axisymmetric

    return condense_axisymmetric(part, resolution, dict(along))


def fit_resolution(case: Case, part: "FittedRing | HousedRing") -> fem.Resolution:
    """How finely a ring in its fit is resolved, perhaps on the moved nodes of another case."""
    from fem.joint.fitted_ring import FittedRing

    resolution = fem.Resolution(
        length=roller_length(case),
        axial_modes=case.accuracy.axial_shapes,
        mesh_size=mesh_size(case, ON_A_SECTION),
    )
    other, is_inner = case.nodes_of, isinstance(part, FittedRing)
    shape = nodes_of(case, "inner" if is_inner else "outer")
    if shape is None or other is None:
        return resolution
    shoulder = {"shoulder_diameter": other.inner.shoulder_diameter} if is_inner else {}
    return replace(resolution, nodes_of=replace(shape, part=replace(part, seat=shape.part, **shoulder)))


def expansions_along(case: Case, **bodies: str) -> "dict[str, Along]":
    """Free expansions along the axis beyond those of the middle, where temperatures vary."""
    from fem.section.expansion import Along

    temperatures, expansions = case.operation.temperatures, {}
    if temperatures is None:
        return {}
    hot = hot_over_cold(case, bodies["ring"])  # both bodies are meshed as warm as the ring
    for body, part in bodies.items():
        along = getattr(temperatures, f"{part}_along")
        if along is not None:
            rise = np.array(along.temperatures) - getattr(temperatures, part)
            strain = expansion_coefficient(case, part) * rise
            expansions[body] = Along(at=np.multiply(along.at, hot), values=strain)
    return expansions
