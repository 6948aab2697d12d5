"""Load distribution of a four-point contact ball bearing whose rings yield to the balls."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.four_point import (
    ENOUGH,
    STIFFENING,
    TOLERANCE,
    BallLoads,
    RigidRings,
    balanced,
    levers,
)
from quasidynamic.balance.balls.four_point_diagonals import Pressed
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.ball import FourPointBearing

STEPS = 100  # rarely more than ten from the rigid rings
HALVINGS = 30
DESCENT = 1e-3  # part of the linear fall of the forces out of balance that a step must bring
SYMMETRIC = 1e-9  # allowed difference of a compliance from its mirror image, over the largest entry


@dataclass(frozen=True)
class YieldingBallLoads(BallLoads):
    """How the balls share a load between rings that yield to them."""

    yielded: (
        NDArray  # (Z, 2, 2) [m] by how much the groove centres of each diagonal came closer: radial, axial
    )


class _State(NamedTuple):
    """Forces on rings and balls at one place of the inner ring and one shape of the rings."""

    place: NDArray  # (5) [m]
    shape: NDArray  # (4 Z) [m] by how much the groove centres came closer
    pressed: Pressed
    excess: NDArray  # (5) load less what the balls carry [N]
    misfit: NDArray  # (4 Z) shape less what the forces make of it [m]


def yielding_ball_loads(bearing: FourPointBearing, load: NDArray, compliance: NDArray) -> YieldingBallLoads:
    r"""Load of every diagonal under five loads on the inner ring, between rings that yield.

    .. math:: v = v_0 + B a - s,\quad s = C F(v),\quad B^T F(v) = P

    with the distance v of opposite groove centres, the place a of the inner ring, the load P and the forces
    F of `Diagonals`. It is the stationary point of the energy of contacts and rings, which is convex as
    long as contacts and rings together yield to every force. Newton's method from the rigid rings.

    Parameters
    ----------
    bearing : FourPointBearing
        as for `ball_loads`
    load : array (5)
        P on the face of the inner ring, which moves as a rigid body: axial x, radial y and z [N], moments
        about y and z [N m]
    compliance : array (Z, 2, 2, 2, 2)
        C by which the groove centres of a diagonal come closer (diagonal, component) for a force of
        another diagonal so many balls before it (diagonal, component), both rings together, the contacts' own
        indentation left out [m/N]; diagonals as in `BallLoads`, components outward and along x; symmetric

    Returns
    -------
    YieldingBallLoads
        the displacement is that of the face of the inner ring against that of the outer one

    Raises
    ------
    ImpossiblePart
        when a load or a compliance is not finite, or a compliance does not fit or is not symmetric
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    Daidie, Chaib and Ghosn (2008), J. Mech. Des. 130, 082601, in the idea that groove centres follow the
    elastic rings; the equations are those of `ball_loads` with the shape of the rings as further unknowns.

    Valid
    -----
    As `ball_loads`; rings of revolution with small displacement, balls at equal pitches.
    """
    rings = RigidRings.of(bearing, load)
    matrix = _dense(np.asarray(compliance, dtype=float), bearing.balls)
    rigid, count = balanced(rings)
    soft = _SoftRings(rings, matrix, _contact_stiffness(rings, rigid.pressed.loads.max()))
    state, more = _settled(soft, soft.at(rigid.place, np.zeros(len(matrix))))
    _require_stable(matrix, state.pressed)
    lever = levers(bearing)
    return YieldingBallLoads(
        loads=state.pressed.loads,
        angles=state.pressed.angles,
        displacement=state.place / lever,
        stiffness=soft.stiffness(state) * np.outer(lever, lever),
        imbalance=soft.imbalance(state),
        iterations=count + more,
        yielded=state.shape.reshape(-1, 2, 2),
    )


def _dense(row: NDArray, balls: int) -> NDArray:
    """Compliance of all balls (4 Z, 4 Z) [m/N] by that of balls so many pitches apart."""
    if row.shape != (balls, 2, 2, 2, 2) or not np.isfinite(row).all():
        raise ImpossiblePart(
            f"compliance of shape {row.shape} must be finite, of shape {(balls, 2, 2, 2, 2)}"
        )
    apart = np.arange(balls)[:, None] - np.arange(balls)
    full = row.reshape(balls, 4, 4)[apart % balls].swapaxes(1, 2).reshape(4 * balls, 4 * balls)
    if not np.abs(full - full.T).max() <= SYMMETRIC * np.abs(full).max():
        raise ImpossiblePart(
            "the compliance is not symmetric: forces and displacements do not belong together"
        )
    return full


def _contact_stiffness(rings: RigidRings, largest: float) -> float:
    """Stiffness of a diagonal under the largest force [N/m]."""
    force = max(largest, float(np.abs(rings.load).max()))
    return 1.5 * rings.diagonals.coefficient ** (2 / 3) * force ** (1 / 3)


@dataclass(frozen=True)
class _SoftRings:
    """Two rings that yield, with balls between them."""

    rings: RigidRings
    compliance: NDArray  # (4 Z, 4 Z) [m/N]
    usual_stiffness: float  # [N/m] that weighs a misfit against forces

    def at(self, place: NDArray, shape: NDArray) -> _State:
        """Evaluate every diagonal."""
        pressed = self.rings.diagonals.at(place, shape.reshape(-1, 2, 2))
        excess = self.rings.load - self.rings.diagonals.carried(pressed.force)
        return _State(place, shape, pressed, excess, shape - self.compliance @ pressed.force.ravel())

    def imbalance(self, state: _State) -> float:
        """Largest force that balance or the shape of the rings asks for, over the largest force [-]."""
        largest = max(np.abs(self.rings.load).max(), state.pressed.loads.max())
        return float(max(np.abs(state.excess).max(), self._forced(state).max()) / largest)

    def size(self, state: _State) -> float:
        """Length of all that is out of balance [N]."""
        return float(np.hypot(np.linalg.norm(state.excess), np.linalg.norm(self._forced(state))))

    def _forced(self, state: _State) -> NDArray:
        return self.usual_stiffness * np.abs(state.misfit)

    def responses(self, state: _State) -> tuple[NDArray, NDArray]:
        """Change of the forces by the misfit (4 Z) and by the place of the ring (4 Z, 5) [N, N/m]."""
        each = state.pressed.stiffness
        moves = np.repeat(self.rings.diagonals.moves, 2, axis=0).reshape(-1, 2, 2, 5)
        coupled = np.eye(len(self.compliance)) + _by_blocks(each, self.compliance)
        given = np.concatenate([state.misfit.reshape(-1, 2, 2, 1), moves], axis=-1)
        answers = np.linalg.solve(
            coupled, np.einsum("jdab,jdbq->jdaq", each, given).reshape(len(coupled), -1)
        )
        return answers[:, 0], answers[:, 1:]

    def carried(self, forces: NDArray) -> NDArray:
        """Loads (5, ...) that forces (4 Z, ...) carry."""
        moves = np.repeat(self.rings.diagonals.moves, 2, axis=0).reshape(-1, 5)
        return moves.T @ forces

    def stiffness(self, state: _State) -> NDArray:
        """Tangent stiffness (5, 5) [N/m]: load over the place of the inner face."""
        tangent = self.carried(self.responses(state)[1])
        return (tangent + tangent.T) / 2

    def step(self, state: _State) -> tuple[NDArray, NDArray]:
        """Newton's changes of place (5) and shape (4 Z) [m].

        A direction in which hardly anything resists is stiffened as long as forces are out of balance.
        """
        by_misfit, by_place = self.responses(state)
        tangent = self.carried(by_place)
        stiffer = STIFFENING * min(self.imbalance(state), 1.0) * max(tangent.trace(), self.usual_stiffness)
        place = np.linalg.solve(tangent + stiffer * np.eye(5), state.excess - self.carried(by_misfit))
        return place, self.compliance @ (by_misfit + by_place @ place) - state.misfit


def _settled(rings: _SoftRings, here: _State) -> tuple[_State, int]:
    """State in which balls, rings and load are in balance, and the number of evaluations."""
    count, last = 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(here)
        if imbalance < TOLERANCE or last / 2 < imbalance < ENOUGH:
            return here, count
        here, tries = _next(rings, here)
        count, last = count + tries, imbalance
    raise NotSolved(
        f"the yielding rings found no balance in {count} evaluations: {rings.imbalance(here):.1e} of the "
        f"largest force is left, allowed {ENOUGH:.0e}; loads over the pitch radius {rings.rings.load} N",
        "iteration limit",
    )


def _next(rings: _SoftRings, here: _State) -> tuple[_State, int]:
    """A step of Newton's method, halved until less is out of balance."""
    place, shape = rings.step(here)
    size = rings.size(here)
    for halvings in range(HALVINGS):
        part = 0.5**halvings
        there = rings.at(here.place + part * place, here.shape + part * shape)
        if rings.size(there) <= (1 - DESCENT * part) * size:
            break
    return there, halvings + 1


def _by_blocks(each: NDArray, full: NDArray) -> NDArray:
    """Product of a matrix of 2 x 2 blocks on the diagonal (Z, 2, 2, 2) with a full one (4 Z, 4 Z)."""
    rows = full.reshape(-1, 2, len(full))
    return (each.reshape(-1, 2, 2) @ rows).reshape(full.shape)


def _require_stable(compliance: NDArray, pressed: Pressed) -> None:
    """Raise unless contacts and rings together yield to every force: then there is one balance only."""
    stiffness = pressed.stiffness.reshape(-1, 2, 2)
    product = np.sqrt(np.linalg.det(stiffness).clip(0.0))[:, None, None]
    trace = np.trace(stiffness, axis1=1, axis2=2)[:, None, None]
    # the square root of a symmetric 2 x 2 matrix, zero where nothing is pressed
    root = (stiffness + product * np.eye(2)) / np.sqrt(np.where(trace > 0, trace + 2 * product, 1.0))
    half = _by_blocks(root, compliance)
    both = np.eye(len(compliance)) + _by_blocks(root, half.T)
    lowest = float(np.linalg.eigvalsh(both)[0])
    if not lowest > 0:
        raise NotSolved(
            "contacts and rings together do not yield to every force, so the balance that was found may be "
            f"one of several: the lowest eigenvalue is {lowest:.2g}; is the compliance that of these rings?",
            "not unique",
        )
