"""The equilibrium that rollers reach when they really move on, from place to place around the bearing."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.several.search import differ
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.strategy import solve_each

STEPS = 6  # in which rollers move on by a pitch
MOST_PITCHES = 4  # after which an equilibrium that still changes is called unsettled
ROUNDS = 3  # of pseudo-time where Newton's method fails


@dataclass(frozen=True)
class Passage:
    """How rollers that moved on ended."""

    equilibrium: Equilibrium  # with the rollers at the places where they were
    pitches: int  # after which it came back
    settled: bool  # whether the last pitch changed nothing any more


def after_passing_pitches(state: Equilibrium) -> Passage | None:
    """Let the rollers move on by whole pitches and see where they end.

    The places of the rollers advance by a sixth of a pitch at a time; films, spins and loads follow from
    where they were before. A roller enters the loaded zone as slow as it came, and not as fast as the start
    of a solve made it. After a pitch the bearing is the same again, but its state may be another one.

    Parameters
    ----------
    state : Equilibrium
        between rigid raceways

    Returns
    -------
    Passage or None
        None where no equilibrium was found on the way

    Valid
    -----
    Quasi-static: every place is an equilibrium, with the spin transported over a whole pitch. Squeeze and
    lag of the films are left out.
    """
    before, pitches = state, 0
    for pitches in range(1, MOST_PITCHES + 1):
        after = _after_a_pitch(before)
        if after is None:
            return None
        if not differ(before, after):
            return Passage(after, pitches, settled=True)
        before = after
    return Passage(before, pitches, settled=False)


def _after_a_pitch(state: Equilibrium) -> Equilibrium | None:
    """The state with every roller where the next one was; None where there is none on the way."""
    sense = 1 if state.cage_speed >= 0 else -1
    bearing, balance = state.balance.roller.bearing, state.balance
    pitch, unknowns = 2 * np.pi / bearing.rollers, state.scaled[None]
    for part in range(1, STEPS):
        azimuth = bearing.first_roller_azimuth + sense * pitch * part / STEPS
        ahead = _solved(_turned(balance, azimuth), unknowns)
        if ahead is None:
            return None
        unknowns = ahead
    there = _solved(balance, balance.pack(_renumbered(balance.unpack(unknowns), sense)))
    if there is None:
        return None
    return replace(state, scaled=there[0], status=SolverOutcome.CONVERGED)


def _turned(balance: BearingBalance, first_roller_azimuth: float) -> BearingBalance:
    bearing = replace(balance.roller.bearing, first_roller_azimuth=first_roller_azimuth)
    return replace(balance, roller=replace(balance.roller, bearing=bearing))


def _solved(balance: BearingBalance, unknowns: NDArray) -> NDArray | None:
    with np.errstate(all="ignore"):
        solved = solve_each(balance, unknowns, ROUNDS)
    return solved.unknowns if solved.outcomes[0] is SolverOutcome.CONVERGED else None


def _renumbered(unknowns: Unknowns, places: int) -> Unknowns:
    """What belongs to a roller, given to the one so many places ahead."""
    moved = {
        name: np.roll(getattr(unknowns, name), places, axis=-1)
        for name in ("approach", "tilt", "film", "spin_drift", "deviation")
    }
    return unknowns._replace(**moved)
