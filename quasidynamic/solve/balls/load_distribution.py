"""Load distribution of a four-point contact ball bearing with rigid rings."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_rings import RigidRings, RigidRingState, ring_levers
from quasidynamic.errors import NotSolved
from quasidynamic.parts.ball import FourPointBearing
from quasidynamic.solve.step_length import before_the_minimum

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring, moments over the pitch radius
ROUNDED = 1e-9  # the same, where rounding keeps a step from lowering it any more
STEPS = 200  # rarely more than twenty: the energy is convex
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no ball resists a direction


@dataclass(frozen=True)
class BallLoads:
    """How the balls share a load. Z balls, two diagonals: the first points outwards to positive x."""

    approach: NDArray  # (Z, 2) [m] on a diagonal, both contacts together; negative in a gap
    loads: NDArray  # (Z, 2) [N] the same at both ends of a diagonal
    angles: NDArray  # (Z, 2) [rad] contact angle from the radial plane, loaded
    displacement: NDArray  # (5) x, y, z [m] and tilts about y and z [rad] of the inner against the outer ring
    stiffness: NDArray  # (5, 5) tangent [N/m, N, N m], symmetric
    imbalance: float  # [-] unbalanced force over the largest force
    iterations: int  # evaluations of all balls


def ball_loads(bearing: FourPointBearing, load: NDArray) -> BallLoads:
    r"""Load of every diagonal under five loads on the inner ring, with contact angles that turn.

    .. math:: Q = K [L - A]_+^{3/2},\quad A = r_i + r_o - D,\quad L_0 = A - G,\\
              L = |(L_0 \cos\alpha_0 + u_r,\; L_0 \sin\alpha_0 \pm u_a)|,\quad
              u_r = u_y \sin\varphi + u_z \cos\varphi,\quad
              u_a = u_x + R_c (\theta_y \cos\varphi - \theta_z \sin\varphi)

    Newton's method on the convex energy of the contacts.

    Parameters
    ----------
    bearing : FourPointBearing
        D, r, contact angle alpha_0, clearance G of a diagonal, pitch radius R_c
    load : array (5)
        on the inner ring: axial x, radial y and z [N], moments about y and z [N m]

    Raises
    ------
    ImpossiblePart
        when a load is not finite
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    Amasorrain, Sagartzazu and Damian (2003), Mech. Mach. Theory 38, 479-496.

    Valid
    -----
    Slow, rigid and round rings; both diagonals with one contact angle and one clearance; the stiffness K is
    that of the unloaded contact angle; moments act on the pitch circle. No truncation at the groove edge.
    """
    rings = RigidRings.of(bearing, load)
    return _shared(bearing, rings, *balanced(rings))


def ball_loads_near(bearing: FourPointBearing, load: NDArray, near: BallLoads) -> BallLoads:
    """`ball_loads` of a bearing and a load that differ little from those of known ones.

    One step of Newton's method: exact to first order in the difference.

    Raises `NotSolved` where nothing resists some motion of the ring.
    """
    rings = RigidRings.of(bearing, load)
    state = rings.at(near.displacement * ring_levers(bearing))
    return _shared(bearing, rings, rings.at(state.place + resisted(state.stiffness, state.excess)), 2)


def resisted(stiffness: NDArray, force: NDArray) -> NDArray:
    """Change of the place of a ring (5) under a force (5).

    Raises `NotSolved` where nothing resists some motion.
    """
    try:
        return np.linalg.solve(stiffness, force)
    except np.linalg.LinAlgError:
        raise NotSolved("nothing resists some motion of the ring", "undetermined") from None


def _shared(
    bearing: FourPointBearing, rings: RigidRings, state: RigidRingState, evaluations: int
) -> BallLoads:
    lever = ring_levers(bearing)
    return BallLoads(
        approach=state.diagonals.approach,
        loads=state.diagonals.loads,
        angles=state.diagonals.angles,
        displacement=state.place / lever,
        stiffness=state.stiffness * np.outer(lever, lever),
        imbalance=rings.imbalance(state),
        iterations=evaluations,
    )


def balanced(rings: RigidRings) -> tuple[RigidRingState, int]:
    """State in which the balls carry the load, and the number of evaluations.

    Raises `NotSolved` when the iteration limit is reached.
    """
    state, evaluations, previous = rings.at(rings.first_place()), 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE or previous / 2 < imbalance < ROUNDED:
            return state, evaluations
        # A direction in which hardly anything resists is stiffened as long as forces are out of balance.
        stiffer = STIFFENING * min(imbalance, 1.0) * max(state.stiffness.trace(), rings.usual_stiffness())
        step = np.linalg.solve(state.stiffness + stiffer * np.eye(5), state.excess)
        state, trials = before_the_minimum(rings.at, state, step)
        evaluations, previous = evaluations + trials, imbalance
    raise NotSolved(
        f"the rings found no balance in {evaluations} evaluations: {rings.imbalance(state):.1e} of the "
        f"largest force is left, allowed {ROUNDED:.0e}; loads over the pitch radius {rings.load} N",
        "iteration limit",
    )
