"""Other equilibria of a solved bearing: what is stored, and said, of them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexbearing.coupling import LinearPair
from flexbearing.findings.running import SEVERAL_MOTIONS
from flexbearing.quantities.reductions import loaded_rollers
from quasidynamic import Equilibrium, NotSolved, RollerBearing
from quasidynamic.note import Note, danger, information
from quasidynamic.several.indicator import cage_balances_often

CODE = SEVERAL_MOTIONS.code
MATERIAL = SEVERAL_MOTIONS.limit  # of the largest load, life or torque, as of balls


@dataclass(frozen=True)
class SeveralEquilibria:
    """The equilibrium that a run computed, with others of the same operating point."""

    raceways: str  # between which all of them are
    computed: Equilibrium
    stable: bool  # whether small disturbances of the computed one decay
    others: tuple[Equilibrium, ...]  # stable
    passing: Any = None  # what rollers reach that pass pitches, where that was followed
    led_back: int = 0  # equilibria between raceways of the same shape that are none between elastic ones

    def record(self) -> dict[str, Any]:
        """What the result file holds."""
        record = {
            "raceways": self.raceways,
            "computed": _figures(self.computed),
            "computed_is_stable": self.stable,
            "others": [_figures(other) for other in self.others],
        }
        if self.passing is not None:
            ends = {"pitches": self.passing.pitches, "settled": self.passing.settled}
            record["after_passing_pitches"] = _figures(self.passing.state) | ends
        return record

    def note(self, *, answer: bool = True) -> Note:
        """The spread in a sentence, and the state that rollers reach when they pass a pitch.

        A danger where the computed equilibrium is the answer of the run, and not only on the way to it, and
        where they differ by more than `MATERIAL`.
        """
        if not self.others:
            return information(
                CODE,
                f"between {self.raceways} no other equilibrium was found: {self.led_back} that exist between "
                "raceways kept in the shape of the end state lead back to it when the raceways follow",
            )
        known = [_figures(state) for state in (self.computed, *self.others)]
        text = (
            f"several equilibria between {self.raceways}, {len(known)} known: largest roller load "
            f"{_range(known, 'largest_inner_load_N', ',.1f')} N, "
            f"{_range(known, 'loaded_rollers', 'd')} rollers loaded, "
            f"life {_range(known, 'life_L10_Mrev', ',.4g')} Mrev, driving torque "
            f"{_range(known, 'driving_torque_Nm', '.4g')} N m, cage slip "
            f"{_range(known, 'slip_percent', '.3g')} %; the computed one is one of them"
        )
        unstable = "" if self.stable else ", and not stable: the bearing leaves it"
        misleading = answer and (
            not self.stable or any(_spread(known, name) > MATERIAL for name in _DECIDING)
        )
        return (danger if misleading else information)(CODE, text + unstable + self._after_passing())

    def _after_passing(self) -> str:
        if self.passing is None:
            return ""
        reached = _figures(self.passing.state)
        ratio = reached["life_L10_Mrev"] / _figures(self.computed)["life_L10_Mrev"]
        ends = "reach" if self.passing.settled else "still change from pitch to pitch, at last"
        return (
            f"; rollers that move on by whole pitches {ends} {reached['largest_inner_load_N']:,.1f} N and "
            f"{reached['life_L10_Mrev']:,.4g} Mrev, {ratio:.2f} of the life computed"
        )


def between_rigid_raceways(model: RollerBearing, state: Equilibrium) -> SeveralEquilibria | None:
    """Other equilibria than one between rigid raceways; None without a hint at them, or without any."""
    from quasidynamic.several import after_passing_pitches, other_equilibria
    from quasidynamic.several.search import stable

    others = other_equilibria(state)
    if cage_balances_often(state.cases)[0] and model.operation.radial_load:
        others = _united(state, others, _over_the_load(model))
    if not others:
        return None
    passing = after_passing_pitches(state)
    return SeveralEquilibria("rigid raceways", state, stable(state), others, passing)


def between_flexible_raceways(state: Equilibrium, rings: LinearPair) -> SeveralEquilibria | None:
    """Other equilibria than a coupled end state; None where nothing hints at them or none was found.

    They are searched between raceways that keep the shape of the end state. What is found there is solved
    again between elastic raceways, linear near the loads of the end state.
    """
    from quasidynamic.several import other_equilibria
    from quasidynamic.several.search import between_elastic_raceways, stable

    kept = other_equilibria(state)
    coupled = [between_elastic_raceways(other, rings.compliance, rings.initial_deviation) for other in kept]
    others = _united(state, (), [other for other in coupled if other is not None])
    if kept and not others and None in coupled:  # not known what becomes of it when the raceways follow
        return SeveralEquilibria("raceways kept in the shape of the end state", state, stable(state), kept)
    if kept:
        return SeveralEquilibria("flexible raceways", state, stable(state), others, led_back=len(kept))
    return None


def _over_the_load(model: RollerBearing) -> list[Equilibrium]:
    """Equilibria that branches over the load pass."""
    from quasidynamic.trace import equilibria_at

    try:
        return list(equilibria_at(model))
    except NotSolved:
        return []


def _united(
    state: Equilibrium, known: tuple[Equilibrium, ...], further: list[Equilibrium]
) -> tuple[Equilibrium, ...]:
    """Known equilibria and further stable ones that differ from them and from the computed state."""
    from quasidynamic.several.search import differ, stable

    united = list(known)
    for other in further:
        if all(differ(other, one) for one in (state, *united)) and stable(other):
            united.append(other)
    return tuple(sorted(united, key=lambda other: float(other.loads[0].max())))


def _figures(state: Equilibrium) -> dict[str, Any]:
    return {
        "largest_inner_load_N": float(state.loads[0].max()),
        "loaded_rollers": int(loaded_rollers(state.loads[0])),
        "life_L10_Mrev": state.life,
        "driving_torque_Nm": state.driving_torque,
        "power_loss_W": state.driving_power,
        "slip_percent": 100 * state.cage_slip if np.isfinite(state.cage_slip) else None,
        "inner_loads_N": state.loads[0].tolist(),
    }


def _range(known: list[dict[str, Any]], name: str, digits: str) -> str:
    """Smallest and largest value, or the one value that all share."""
    values = [figures[name] for figures in known if figures[name] is not None] or [float("nan")]
    ends = [format(end(values), digits) for end in _ENDS]
    return " to ".join(dict.fromkeys(ends))


def _spread(known: list[dict[str, Any]], name: str) -> float:
    """Largest less smallest value over the largest size."""
    values = [figures[name] for figures in known]
    return (max(values) - min(values)) / max(abs(value) for value in values)


_DECIDING = ("largest_inner_load_N", "life_L10_Mrev", "driving_torque_Nm")
_ENDS: tuple[Callable, ...] = (min, max)
