"""What solved roller bearings are judged by, and which of them are in danger; cases first."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller.consistency import bore_diameter, outside_diameter
from flexbearing.findings import Record, declared, evaluate, records
from flexbearing.findings.load_limits import BARS
from flexbearing.findings.row import in_rows
from flexbearing.life import rated_bearing
from flexbearing.life.life_of_state import MREV
from flexbearing.life.rated_bearing import RatedBearing
from flexbearing.runs import judged
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, OutOfRange
from quasidynamic.contact.film.roughness import MIXED_FROM
from quasidynamic.outcome.axial_capacity import rib_strength, rib_strength_of_series_2, warm_rib_load
from quasidynamic.outcome.neglected import tilting_share
from quasidynamic.outcome.rating_life import ROLLERS


def values(rows: SolvedRows) -> dict[str, Any]:
    """Values of solved states of roller bearings, cases first; without stresses of solids."""
    return {
        **values_of_dangers(rows),
        **_stress_of_bars(rows),
        "load": np.hypot(*rows.states.applied_load.T),
        "dynamic_rating": np.array([_dynamic_rating(each) for each in rows.rated]),
        **rated_bearing.rating_ratios([each.given for each in rows.rated]),
        "viscosity_ratio": np.array([each.known_kappa for each in rows.rated], dtype=float),
        "film_ratio": None if rows.film_ratio is None else _smallest(rows.film_ratio),
        "mixed_film_ratio": MIXED_FROM,
        "series_error": None if rows.rings[0].rigid else rows.end.series_error,
        "least_stiffness": judged.least_stiffness(rows.end.with_supports.radial_matrix),
        "raceway_slope": np.array(
            [_slope(state) if np.any(state.ring_tilt) else np.nan for state in rows.each]
        ),
    }


def _dynamic_rating(own: RatedBearing) -> float:
    """C_r [N]; not a number where none is given and ISO 281 has none."""
    try:
        return own.dynamic
    except OutOfRange:
        return np.nan


def values_of_dangers(rows: SolvedRows) -> dict[str, Any]:
    """Those values that rows of a table are judged by, which are cheap."""
    lives = [
        basic if found is None or found.modified is None else found.modified
        for basic, found in zip(rows.basic_life, rows.life, strict=True)
    ]
    limited = any(case.materials.outer_ring.yield_stress is not None for case in rows.cases)
    return {
        **judged.pressures(rows.bounded_pressure.T, ROLLERS),
        "sliced_peak_error": rows.sliced_peak_error,
        "static_safety": rows.static_safety,
        **judged.lives(
            np.array(lives) / MREV, rows.relative_speed, (case.life.required for case in rows.cases)
        ),
        **_thrust(rows),
        "neglected": {"gyroscopic moment of the rollers": _gyroscopic(rows)},
        "rated_viscosity_ratio": np.array([each.rated_kappa for each in rows.rated], dtype=float),
        **rated_bearing.rating_changes([each.given for each in rows.rated]),
        **(_stress_of_bars(rows) if limited else {}),
    }


def _thrust(rows: SolvedRows) -> dict[str, Any]:
    """Axial load on ribs, and what a maker permits of it [N]; not a number where the case lacks a size."""
    states = rows.states
    if states.axial_load is None:
        return {}
    radial = np.hypot(*states.applied_load.T)
    sizes = [
        (
            bore_diameter(case.bearing, case.inner),
            outside_diameter(case.bearing, case.outer),
            own.static_or_none,
        )
        for case, own in zip(rows.cases, rows.rated, strict=True)
    ]
    bore, outside, static = np.array(sizes, dtype=float).T
    width = [model.bearing.roller.length for model in rows.models]
    return {
        "axial_load": np.abs(states.axial_load),
        "radial_load": radial,
        "rib_strength": rib_strength(outside),
        "rib_strength_of_series_2": rib_strength_of_series_2(outside),
        "warm_rib_load": warm_rib_load(static, rows.relative_speed, bore, outside, width, radial),
    }


def _gyroscopic(rows: SolvedRows) -> NDArray:
    """Gyroscopic moments of tilted rollers; centrifugal forces, weight and friction are computed."""
    states, rollers = rows.states, [model.bearing.roller for model in rows.models]
    inertia = np.array([each.mass * each.diameter**2 / 8 for each in rollers])
    length = np.array([each.length for each in rollers])
    loads = states.loads[:, 0]
    speed, tilt = (
        np.abs(each).max(axis=1, where=loads > 0, initial=0.0)
        for each in (states.roller_speed, states.roller_tilt)
    )
    load = np.where(loads.max(axis=1) > 0, loads.max(axis=1), np.inf)
    return tilting_share(inertia, length, states.cage_speed, speed, tilt, load)


def of_rows(rows: SolvedRows) -> list[list[Record]]:
    """Records of each case that its row may report, see `in_rows`, of limits that are not kept."""
    found = evaluate(
        (each for each in declared.OF_ROLLERS if in_rows(each.code, each.grade)), values_of_dangers(rows)
    )
    return [records((each for each in found if each.broken[case]), case) for case in range(len(rows))]


def _stress_of_bars(rows: SolvedRows) -> dict[str, Any]:
    """Largest nominal stress of the bars of squirrel cages and its limit [Pa]; empty without bars."""
    if rows.bars is None:
        return {}
    limits = [case.materials.outer_ring.yield_stress for case in rows.cases]
    return {"stress": {BARS: rows.bars.largest}, "yield_stress": {BARS: limits}}


def _slope(state: Equilibrium) -> float:
    """Size of the slope of the inner raceway against the outer one along the most loaded roller [rad].

    Raceways of elastic rings tilt with their supports: straight lines are fitted through their deviations.
    """
    roller = int(np.argmax(state.loads[0]))
    azimuth = state.balance.roller.bearing.azimuths[roller]
    places = state.slice_positions  # symmetrical about mid-roller
    inner, outer = (places @ of[roller] / (places @ places) for of in state.deviation_along_rollers)
    return abs(float(np.dot(state.ring_tilt, (np.cos(azimuth), np.sin(azimuth))) + inner - outer))


def _smallest(ratios: NDArray) -> dict[str, NDArray]:
    """Smallest film ratio of each raceway; of rollers with load."""
    smallest = ratios.min(axis=2, where=ratios > 0, initial=np.inf)
    return dict(zip(judged.RACES, smallest.T, strict=True))
