"""Load distribution of a four-point contact ball bearing with rigid rings."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_rings import (
    ElasticRingState,
    RigidRings,
    RigidRingState,
    ring_levers,
)
from quasidynamic.errors import NotSolved
from quasidynamic.motion.ball_slip import INNER, SIDE
from quasidynamic.parts.ball import FourPointBearing
from quasidynamic.solve.balls.balls_on_arches import ball_step, balls_in_balance
from quasidynamic.solve.step_length import SolverOutcome, before_the_minimum

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring, moments over the pitch radius
ROUNDED = 1e-9  # the same, where rounding keeps a step from lowering it any more
LEAST_PART = 1e-2  # of what shoulders cut off: by which they close in on contacts at least
STEPS = 200  # rarely more than twenty: the energy is convex
BALL_SHARE = 0.1  # of the imbalance before a step: what the balls may leave to the next one
MOST_SPEEDS = 20  # that are tried on the way from balls without inertia, rarely more than three
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no ball resists a direction

S = TypeVar("S")


@dataclass(frozen=True)
class BallLoads:
    """How Z balls share a load, by diagonal and race; the first diagonal points outwards to positive x."""

    approach: NDArray  # (Z, 2, 2) [m] of ball and race; negative in a gap
    loads: NDArray  # (Z, 2, 2) [N]
    whole: NDArray  # (Z, 2, 2) [N] of contacts that no shoulder cuts off, same approach
    section_forces: NDArray  # (Z, 2, 2) [N] along the section: inner race on ball, ball on outer race
    angles: NDArray  # (Z, 2, 2) [rad] contact angle from the radial plane, loaded
    centres: NDArray  # (Z, 2) [m] axial and radial, from balls that touch the outer groove in its middle
    orbit: NDArray  # (Z) [rad/s] by which the centrifugal force is computed, see `arch_motion`
    centrifugal: NDArray  # (Z) [N]
    gyroscopic: NDArray  # (Z) [N m] positive where the first diagonal alone carries
    displacement: NDArray  # (5) x, y, z [m] and tilts about y and z [rad] of the inner against the outer ring
    stiffness: NDArray  # (5, 5) tangent [N/m, N, N m], symmetric without inertia
    imbalance: float  # [-] unbalanced force over the largest force
    iterations: int  # evaluations of all balls


def ball_loads(
    bearing: FourPointBearing, load: NDArray, speed: float = 0.0, start: BallLoads | None = None
) -> BallLoads:
    r"""Load of every contact under five loads on the inner ring, with contact angles that turn.

    .. math:: \sum_k (-Q_k + \mathrm i P_k)\, n_k + \mathrm i F_c = 0,\quad
              u_r = u_y \sin\varphi + u_z \cos\varphi,\quad
              u_a = u_x + R_c (\theta_y \cos\varphi - \theta_z \sin\varphi)

    Balls find their own place between the grooves, see `FourContacts`; the inner ring moves its one by u_a
    and u_r. Newton's method for the ring, and for each ball; without inertia on a convex energy.

    Parameters
    ----------
    bearing : FourPointBearing
        D, r, contact angle alpha_0, clearance of a diagonal, pitch radius R_c
    load : array (5)
        on the inner ring: axial x, radial y and z [N], moments about y and z [N m]
    speed : float
        of the inner ring, the outer one at rest [rad/s]
    start : BallLoads, optional
        of another load, where the search begins

    Raises
    ------
    ImpossiblePart
        when a load is not finite
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    Amasorrain, Sagartzazu and Damian (2003), Mech. Mach. Theory 38, 479-496, whose diagonals carry for
    themselves: the same where a ball is on one of them.

    Valid
    -----
    Rigid and round rings; both diagonals with one contact angle and one clearance; the stiffness K is that
    of the unloaded contact angle; moments act on the pitch circle. Shoulders as in `EndingRaces`.
    """
    rings = RigidRings.of(bearing, load, speed)
    state, count = _from_start(rings.of_whole_contacts, start)
    over = rings.contacts.over_shoulders(state.balls)
    if over > 0:
        state, more = as_shoulders_close(rings, over, state, _newton_from)
        count += more
    return _shared(bearing, rings, state, count)


def _from_start(rings: RigidRings, start: BallLoads | None) -> tuple[RigidRingState, int]:
    """State in which the balls carry the load, from that under another one if given, and evaluations."""
    if start is not None:
        try:
            levers = ring_levers(rings.contacts.bearing)
            state, evaluations = _newton(rings, start.displacement * levers, start.centres)
            require_held(state)
            return state, evaluations
        except NotSolved:
            pass  # a usual start is tried
    return balanced(rings)


def as_shoulders_close(
    rings: RigidRings, over: float, begin: S, solve: Callable[[RigidRings, S], tuple[S, int]]
) -> tuple[S, int]:
    """State as shoulders close in on whole contacts, which reach over them by an angle [rad].

    And evaluations.

    Raises `NotSolved` where balls climb over.
    """
    part, step, count = 0.0, 1.0, 0
    while part < 1.0:
        further = min(1.0, part + step)
        try:
            begin, more = solve(rings.withdrawn((1.0 - further) * over), begin)
        except NotSolved as problem:
            step /= 4
            if step < LEAST_PART:
                raise NotSolved(
                    "balls climb over the shoulders, which cut contacts off: whole ones would be in balance, "
                    f"but reach over them by {np.degrees(over):.1f} deg; give a smaller load, or higher "
                    "shoulders",
                    SolverOutcome.OVER_SHOULDER,
                ) from problem
            continue
        part, step, count = further, 2 * step, count + more
    return begin, count


def _newton_from(rings: RigidRings, begin: RigidRingState) -> tuple[RigidRingState, int]:
    state, evaluations = _newton(rings, begin.place, begin.centres)
    require_held(state)
    return state, evaluations


def ball_loads_near(
    bearing: FourPointBearing, load: NDArray, near: BallLoads, speed: float = 0.0
) -> BallLoads:
    """`ball_loads` of a bearing and a load that differ little from those of known ones.

    One step of Newton's method of the ring: exact to first order in the difference.

    Raises `NotSolved` where nothing resists some motion of the ring, or a ball finds no place.
    """
    rings = RigidRings.of(bearing, load, speed)
    state = _at(rings, near.displacement * ring_levers(bearing), near.centres)
    place = state.place + resisted(state.stiffness, state.excess)
    return _shared(bearing, rings, _moved(rings, state, 0.0, place), 2)


def resisted(stiffness: NDArray, force: NDArray) -> NDArray:
    """Change of the place of a ring (5) under a force (5).

    Raises `NotSolved` where nothing resists some motion.
    """
    try:
        return np.linalg.solve(stiffness, force)
    except np.linalg.LinAlgError:
        raise NotSolved("nothing resists some motion of the ring", "undetermined") from None


def _at(rings: RigidRings, place: NDArray, near: NDArray | None, share: float = 0.0) -> RigidRingState:
    """Ring at a place, the balls in balance but for a share of the largest force."""
    centres, balls = balls_in_balance(rings.contacts, place, 0.0, near, rings.largest_load, share)
    return rings.at(place, centres, balls, ball_step(rings.contacts, balls))


def _moved(rings: RigidRings, state: RigidRingState, share: float, place: NDArray) -> RigidRingState:
    """State at a place that is reached from another state."""
    arms = rings.contacts.arms_by_place @ (place - state.place)
    moves = state.moves + (state.balls.following @ arms[..., None])[..., 0]
    return _at(rings, place, state.centres + moves, share)


def what_balls_share(
    bearing: FourPointBearing, state: RigidRingState | ElasticRingState, stiffness: NDArray
) -> dict[str, NDArray]:
    """Fields of `BallLoads` by a state and a stiffness (5, 5) [N/m]."""
    lever, forces, angles = ring_levers(bearing), state.balls.forces, state.balls.angles
    along = np.stack([np.cos(angles), -np.sin(angles)], axis=-1)
    return {
        "approach": forces.approach,
        "loads": forces.loads,
        "whole": forces.whole,
        "section_forces": SIDE * (forces.on_races * along).sum(-1),
        "angles": angles,
        "centres": state.centres,
        "orbit": forces.orbit,
        "centrifugal": forces.centrifugal,
        "gyroscopic": forces.gyroscopic,
        "displacement": state.place / lever,
        "stiffness": stiffness * np.outer(lever, lever),
    }


def _shared(
    bearing: FourPointBearing, rings: RigidRings, state: RigidRingState, evaluations: int
) -> BallLoads:
    each = what_balls_share(bearing, state, state.stiffness)
    return BallLoads(**each, imbalance=rings.imbalance(state), iterations=evaluations)


def balanced(rings: RigidRings) -> tuple[RigidRingState, int]:
    """State in which the balls carry the load, and the number of evaluations.

    Where it is not found at once, from that of slower balls.
    Raises `NotSolved` when the iteration limit is reached, a ball finds no place, or no ball holds the ring.
    """
    try:
        state, evaluations = _newton(rings, rings.first_place(), None)
    except NotSolved:
        if not rings.contacts.speed:
            raise
        state, evaluations = _from_slower(rings)
    require_held(state)
    return state, evaluations


def _from_slower(rings: RigidRings) -> tuple[RigidRingState, int]:
    """State by that of balls without inertia, and of ever faster ones."""
    share, step, tries = 0.0, 1.0, 0
    state, evaluations = _newton(rings.at_speed(0.0), rings.first_place(), None)
    while share < 1.0:
        tries += 1
        step = min(step, 1.0 - share)
        faster = rings.at_speed(np.sqrt(share + step) * rings.contacts.speed)  # inertia grows with its square
        try:
            state, more = _newton(faster, state.place, state.centres)
        except NotSolved:
            if tries >= MOST_SPEEDS:
                raise
            step /= 4
            continue
        share, step, evaluations = share + step, 2 * step, evaluations + more
    return state, evaluations


def _newton(rings: RigidRings, place: NDArray, near: NDArray | None) -> tuple[RigidRingState, int]:
    """State in which the balls carry the load, from a place and places of balls near by, and evaluations."""
    state, evaluations, previous = _at(rings, place, near), 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE or previous / 2 < imbalance < ROUNDED:
            return _at(rings, state.place, state.centres), evaluations + 1  # balls as good as they can be
        state, trials = _next_state(rings, state, imbalance)
        evaluations, previous = evaluations + trials, imbalance
    raise NotSolved(
        f"the rings found no balance in {evaluations} evaluations: {rings.imbalance(state):.1e} of the "
        f"largest force is left, allowed {ROUNDED:.0e}; loads over the pitch radius {rings.load} N",
        "iteration limit",
    )


def _next_state(rings: RigidRings, state: RigidRingState, imbalance: float) -> tuple[RigidRingState, int]:
    """State after a step of Newton's method, and evaluations.

    Where balls left out of balance mislead it, a shorter one with all of them in balance.
    """
    step = _newton_step(rings, state, imbalance)
    trial = _moved(rings, state, BALL_SHARE * imbalance, state.place + step)
    if (trial.excess * step).sum() >= -0.5 * (state.excess * step).sum():
        return trial, 1
    if rings.imbalance(trial) < 0.5 * imbalance:
        return trial, 1
    state = _at(rings, state.place, state.centres)
    step = _newton_step(rings, state, rings.imbalance(state))
    state, trials = before_the_minimum(partial(_moved, rings, state, 0.0), state, step)
    return state, trials + 2


def _newton_step(rings: RigidRings, state: RigidRingState, imbalance: float) -> NDArray:
    """Newton's change of the place (5) [m].

    A direction in which hardly anything resists is stiffened as long as forces are out of balance.
    """
    stiffer = STIFFENING * min(imbalance, 1.0) * max(state.stiffness.trace(), rings.usual_stiffness())
    return np.linalg.solve(state.stiffness + stiffer * np.eye(5), state.excess)


def require_held(state: RigidRingState | ElasticRingState) -> None:
    """Check that a ball touches the inner ring.

    Raises `NotSolved` when none does.
    """
    if not (state.balls.forces.loads[..., INNER] > 0.0).any():
        raise NotSolved(
            "balls have left the inner ring by their centrifugal force: nothing holds it, its position is "
            "undetermined; give a load, a lower speed or more interference",
            "undetermined",
        )
