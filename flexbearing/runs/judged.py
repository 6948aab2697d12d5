"""What findings judge of the states of a run, and the notes on what is not kept."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexbearing import findings
from flexbearing.findings import DANGER, OUTSIDE, USUAL, Judged, declared, evaluate
from flexbearing.findings.strength import BARS
from flexbearing.runs import life
from flexbearing.runs.life_of_state import MREV
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium
from quasidynamic.contact.film.roughness import MIXED_FROM
from quasidynamic.note import Grade, Note
from quasidynamic.outcome.static_pressure import ROLLERS

RACES = ("inner raceway", "outer raceway")  # places
_GRADES: dict[str, Grade] = {DANGER: "danger", OUTSIDE: "outside validity", USUAL: "information"}


def notes(judged: Iterable[Judged], case: int = 0) -> tuple[Note, ...]:
    """A note for each code whose limit a case does not keep, in the order of the findings."""
    broken = [each for each in judged if each.finding.noted and each.broken[case]]
    by_code: dict[str, list[dict[str, Any]]] = {}
    for record in findings.records(broken, case):
        by_code.setdefault(record["code"], []).append(record)
    return tuple(map(_note, by_code.values()))


def _note(records: list[dict[str, Any]]) -> Note:
    worst = findings.gravest(records)
    places = [each["place"] for each in records if each["grade"] == worst["grade"]]
    return Note(_GRADES[worst["grade"]], worst["code"], findings.text(worst, list(dict.fromkeys(places))))


def of_rollers(rows: SolvedRows) -> dict[str, Any]:
    """Values of solved states of roller bearings, cases first; without stresses of solids."""
    each = list(zip(rows.cases, (model.bearing for model in rows.models), strict=True))
    turns = rows.relative_speed != 0
    return {
        **of_dangers(rows),
        **_stress_of_bars(rows),
        "load": np.hypot(*rows.states.applied_load.T),
        "dynamic_rating": np.array([life.dynamic(*of) for of in each]),
        "viscosity_ratio": np.array(
            [life.kappa(*of) if k else np.nan for of, k in zip(each, turns, strict=True)]
        ),
        "film_ratio": None if rows.film_ratio is None else _smallest(rows.film_ratio),
        "mixed_film_ratio": MIXED_FROM,
        "raceway_slope": np.array(
            [_slope(state) if np.any(state.ring_tilt) else np.nan for state in rows.each]
        ),
    }


def of_dangers(rows: SolvedRows) -> dict[str, Any]:
    """Those values that dangers are judged by, which are cheap."""
    lives = [
        basic if life is None else life.modified
        for basic, life in zip(rows.basic_life, rows.life, strict=True)
    ]
    limited = any(case.materials.outer_ring.yield_stress is not None for case in rows.cases)
    return {
        **pressures(rows.bounded_pressure.T, ROLLERS),
        "static_safety": rows.static_safety,
        "life": seconds(np.array(lives) / MREV, rows.relative_speed),
        **(_stress_of_bars(rows) if limited else {}),
    }


def dangers(rows: SolvedRows) -> list[tuple[Note, ...]]:
    """What makes the answer of each case dangerous."""
    found = evaluate((each for each in declared.OF_ROLLERS if each.grade == DANGER), of_dangers(rows))
    broken = np.any([each.broken for each in found], axis=0)
    return [notes(found, case) if broken[case] else () for case in range(len(rows))]


def _stress_of_bars(rows: SolvedRows) -> dict[str, Any]:
    """Largest nominal stress of the bars of squirrel cages and its limit [Pa]; empty without bars."""
    if rows.bars is None:
        return {}
    limits = [case.materials.outer_ring.yield_stress for case in rows.cases]
    return {"stress": {BARS: rows.bars.largest}, "yield_stress": {BARS: limits}}


def pressures(largest: Iterable[Any], limit: float) -> dict[str, Any]:
    """Contact pressure of both raceways [Pa], and that of the static rating."""
    return {"contact_pressure": dict(zip(RACES, largest, strict=True)), "static_pressure": limit}


def seconds(life: ArrayLike, speed: ArrayLike) -> Any:
    """Time [s] that a life [10^6 revolutions] lasts at a speed of one ring against the other [rad/s]."""
    with np.errstate(divide="ignore"):
        return 1e6 * 2 * np.pi * np.asarray(life) / np.abs(speed)


def clearances(record: Mapping[str, Any]) -> dict[str, float]:
    """Diametral clearance as computed, and at the tight end of the tolerances [m]."""
    ends = record.get("tolerances", {}).get("ends")
    tight = {"tight end of the tolerances": ends["tightest_m"]} if ends else {}
    return {"as computed": record["operating_m"], **tight}


def _slope(state: Equilibrium) -> float:
    """Size of the slope of the inner raceway against the outer one along the most loaded roller [rad].

    Raceways of elastic rings lean with their supports: straight lines are fitted through their deviations.
    """
    roller = int(np.argmax(state.loads[0]))
    azimuth = state.balance.roller.bearing.azimuths[roller]
    inner, outer = (
        np.polyfit(state.slice_positions, of[roller], 1)[0] for of in state.deviation_along_rollers
    )
    return abs(float(np.dot(state.ring_tilt, (np.cos(azimuth), np.sin(azimuth))) + inner - outer))


def _smallest(ratios: NDArray) -> dict[str, NDArray]:
    """Smallest film ratio of each raceway; of rollers with load."""
    smallest = ratios.min(axis=2, where=ratios > 0, initial=np.inf)
    return dict(zip(RACES, smallest.T, strict=True))
