"""What findings judge of the states of a run, and the notes on what is not kept."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexbearing import findings
from flexbearing.case.roller import Case
from flexbearing.coupled.states import EndState
from flexbearing.findings import OUTSIDE, USUAL, Judged
from flexbearing.runs import life
from quasidynamic import Equilibrium
from quasidynamic.contact.film.roughness import MIXED_FROM
from quasidynamic.note import Grade, Note
from quasidynamic.outcome.static_pressure import ROLLERS

RACES = ("inner raceway", "outer raceway")  # places
_GRADES: dict[str, Grade] = {findings.DANGER: "danger", OUTSIDE: "outside validity", USUAL: "information"}


def notes(judged: Iterable[Judged], case: Any = ()) -> tuple[Note, ...]:
    """A note for each code whose limit a case does not keep, in the order of the findings."""
    broken = [each for each in judged if each.finding.noted and each.broken[case]]
    by_code: dict[str, list[dict[str, Any]]] = {}
    for record in findings.records(broken, case):
        by_code.setdefault(record["code"], []).append(record)
    return tuple(map(_note, by_code.values()))


def _note(records: list[dict[str, Any]]) -> Note:
    worst = findings.gravest(records)
    return Note(_GRADES[worst["grade"]], worst["code"], findings.text(worst))


def of_rollers(case: Case, end: EndState, modified_life: float | None) -> dict[str, Any]:
    """Values of a solved state of a roller bearing, without stresses.

    Parameters
    ----------
    case : Case
        of the state
    end : EndState
        solved
    modified_life : float or None
        life after every factor [10^6 revolutions]; None where the case modifies nothing
    """
    state, bearing = end.equilibrium, end.equilibrium.balance.roller.bearing
    basic = state.life if end.whole is None else end.whole.life
    films = None if end.film_ratio is None else _smallest(end.film_ratio)
    return {
        **pressures(bounded_pressure(end), ROLLERS),
        "static_safety": end.static_safety,
        "life": seconds(basic if modified_life is None else modified_life, end.relative_speed),
        "load": float(np.hypot(*state.applied_load)),
        "dynamic_rating": life.dynamic(case, bearing),
        "viscosity_ratio": life.kappa(case, bearing) if end.relative_speed else None,
        "film_ratio": films,
        "mixed_film_ratio": MIXED_FROM,
        "raceway_slope": _slope(state) if np.any(state.ring_tilt) else None,
    }


def pressures(largest: Iterable[Any], limit: float) -> dict[str, Any]:
    """Contact pressure of both raceways [Pa], and that of the static rating."""
    return {"contact_pressure": dict(zip(RACES, largest, strict=True)), "static_pressure": limit}


def bounded_pressure(end: EndState) -> NDArray:
    """Largest contact pressure (2) [Pa]; of slices where it has no bound, at a sharp end."""
    if end.whole is None:
        return end.peak_pressure
    return np.where(end.whole.peak_at_ends, end.equilibrium.peak_pressure, end.peak_pressure)


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


def _smallest(ratios: NDArray) -> dict[str, float]:
    """Smallest film ratio of each raceway; of rollers with load."""
    return {race: float(of.min(where=of > 0, initial=np.inf)) for race, of in zip(RACES, ratios, strict=True)}
