"""The motion that rollers end in when they really move on, from place to place around the bearing."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.kinematics import next_in_row
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import bounded
from quasidynamic.solve.rollers.pseudo_time import scaled_inertia

STEPS = 16  # in which rollers move on by a pitch; 80 change the largest load of cold oil by 1e-4
HALVINGS = 6  # of such a step, where it is not solved
SETTLED = 1e-3  # of the largest load, that a load may change in a pitch
MOST_PITCHES = 8  # after which a motion that still changes is called unsettled
EVALUATIONS = 40  # of Newton's method in a step
DAMPINGS = 2.0 ** -np.arange(10)
BALANCED = 1e-9  # residual
SLOWEST = 1e-3  # cage speed over that of pure rolling: slower rollers hardly pass a pitch


@dataclass(frozen=True)
class Passage:
    """How rollers that moved on ended."""

    state: (
        Equilibrium  # when they are at the places where they began; spins change on, all else is in balance
    )
    pitches: int  # that they passed
    settled: bool  # whether the last pitch changed no load any more


def after_passing_pitches(state: Equilibrium) -> Passage | None:
    r"""Let the rollers move on by whole pitches, with their own inertia, and see where they end.

    .. math:: J \dot\omega_j = M_j,\quad \dot\varphi_j = \omega_c

    with the torque M_j of all forces on a roller. A roller enters the loaded zone as slow as it came, and not
    as fast as the start of a solve made it; an equilibrium, where rollers keep their places, takes the spin
    that a roller brings along from a whole pitch behind. Ring, cage, the rollers across the raceways and
    their films follow at once. After a pitch the bearing is the same again, its state may be another one.

    The state is between rigid raceways. None where the motion could not be followed, or hardly goes on.

    Source
    ------
    Angular momentum of each roller; implicit Euler steps of a sixteenth of a pitch.

    Valid
    -----
    Loads settle within a few pitches; a spin that changed comes back to the loaded zone only after all the
    others. Squeeze and lag of the films, and changes of the cage speed within a pitch, are left out.
    """
    if not abs(state.cage_speed) > SLOWEST * abs(state.balance.rolling_cage[0, 0]):
        return None
    balance = replace(state.balance, spin_inertia=False)  # a roller brings along its own spin
    before, sense = replace(state, balance=balance), 1 if state.cage_speed > 0 else -1
    for pitches in range(1, MOST_PITCHES + 1):
        scaled = _after_a_pitch(balance, before.scaled, sense)
        if scaled is None:
            return None
        after = replace(before, scaled=scaled)
        if np.abs(after.loads - before.loads).max() < SETTLED * after.loads.max():
            return Passage(after, pitches, settled=True)
        before = after
    return Passage(before, MOST_PITCHES, settled=False)


def _after_a_pitch(balance: BearingBalance, scaled: NDArray, sense: int) -> NDArray | None:
    """Unknowns (N) with every roller where the next one was; None where a step was not solved."""
    bearing, unknowns = balance.roller.bearing, scaled
    angle = sense * 2 * np.pi / bearing.rollers / STEPS
    for number in range(STEPS):
        azimuth = bearing.first_roller_azimuth + number * angle
        moved = _moved(balance, unknowns, (azimuth, azimuth + angle), HALVINGS)
        if moved is None:
            return None
        unknowns = moved
    return balance.pack(_renumbered(balance.unpack(unknowns[None]), sense, balance.layout.rows))[0]


def _moved(
    balance: BearingBalance, scaled: NDArray, azimuths: tuple[float, float], halvings: int
) -> NDArray | None:
    """Unknowns with the first roller moved between azimuths [rad], in shorter steps where one is too long."""
    begin, end = azimuths
    there = _euler_step(_turned(balance, end), scaled, end - begin)
    if there is not None or not halvings:
        return there
    middle = (begin + end) / 2
    half = _moved(balance, scaled, (begin, middle), halvings - 1)
    return None if half is None else _moved(balance, half, (middle, end), halvings - 1)


def _turned(balance: BearingBalance, first_roller_azimuth: float) -> BearingBalance:
    bearing = replace(balance.roller.bearing, first_roller_azimuth=first_roller_azimuth)
    return replace(balance, roller=replace(balance.roller, bearing=bearing))


@np.errstate(all="ignore")
def _euler_step(balance: BearingBalance, before: NDArray, angle: float) -> NDArray | None:
    """Unknowns (N) after the cage turned by an angle [rad] with its speed before; None where not solved."""
    spins = balance.layout.field(-1)
    inertia = np.zeros(len(before))
    cage_speed = balance.speeds(balance.unpack(before[None]))[1][0, 0]
    inertia[spins] = scaled_inertia(balance)[0, spins] * cage_speed / angle
    shift, scaled = bordered_system.Shift(spin=inertia[None, spins]), before
    system, unbalanced = _unbalanced(balance, scaled, before, inertia)
    for _ in range(EVALUATIONS):
        if np.abs(unbalanced).max() < BALANCED:
            return scaled
        change = bordered_system.solve(balance, system, -unbalanced[None, :, None], shift)[0, :, 0]
        size = np.linalg.norm(unbalanced)
        for damping in DAMPINGS:
            trial = bounded(balance, scaled[None], (scaled + damping * change)[None])[0]
            system, unbalanced = _unbalanced(balance, trial, before, inertia)
            if np.linalg.norm(unbalanced) < size:
                break
        scaled = trial  # also where none was better: a kink, which a small step passes
    return None


def _unbalanced(
    balance: BearingBalance, scaled: NDArray, before: NDArray, inertia: NDArray
) -> tuple[Linearisation, NDArray]:
    """Forces, and their scaled sum (N) with that which changes the spins."""
    system = balance.evaluate(scaled[None])
    return system, system.residual[0] - inertia * (scaled - before)


def _renumbered(unknowns: Unknowns, places: int, rows: int) -> Unknowns:
    """What belongs to a roller, given to the one so many places ahead in its row."""
    moved = {
        name: next_in_row(getattr(unknowns, name), -places, rows)
        for name in ("approach", "tilt", "film", "spin_drift", "deviation")
    }
    return unknowns._replace(**moved)
