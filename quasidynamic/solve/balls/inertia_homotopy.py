"""Ring on balls whose forces of inertia grow from constant ones to those of their places."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.solve.arclength import LinearisedEquations
from quasidynamic.solve.balls.ball_equilibrium import force_scales
from quasidynamic.solve.balls.frozen_solve import BorderedMatrix, frozen_solve
from quasidynamic.solve.balls.ring_on_springs import first_place
from quasidynamic.solve.corners import followed_through

TOLERANCE = 5e-13  # of the largest force: unbalanced force
START_TOLERANCE, START_STEPS = (
    1e-6,
    1000,
)  # of the largest force, what the start may leave; Newton steps it may take
SCALES = (1.0, 0.5, 2.0)  # s, of the constant centrifugal forces at the beginning of a path
FLOATING = 1e-15  # of the largest derivative, given to balls that touch nothing


class BudgetSpent(Exception):
    """A path has cost all evaluations that it may."""


def inertia_homotopy(balance: AngularBalance, budget: int) -> tuple[tuple[NDArray, Vectors] | None, int]:
    r"""Balance of one case at the end of a path that begins where there is one balance only.

    .. math:: (1 - p)\,[R_0(x) + s F_{c0}] + p\, R(x) = 0, \qquad 0 \le p \le 1

    R are the unbalanced forces at the places x of ring and balls, R_0 those without inertia, F_c0 the
    constant centrifugal forces of balls on the outer race alone. At p = 0 an energy that is convex in all
    places has its minimum. Forces of inertia and tractions are bounded, contact forces are not, so the places
    stay bounded, and the path from p = 0 leads to p = 1 however often p turns back on its way. Should it be
    lost all the same, another s draws another path.

    Ring (1, 5) and ball centres (1, Z) [m] are in balance, None where every path was lost or the budget of
    evaluations of all balls is spent; then how many these were.

    Source
    ------
    Allgower and Georg, Introduction to Numerical Continuation Methods (2003), ch. 6 and 11.
    """
    first = first_place(balance)
    resting, evaluations = balance.places.resting(balance.grooves(first)), 0
    for scale in SCALES:
        if evaluations >= budget:
            break
        pull = scale * 1j * balance.free_centrifugal + np.zeros_like(resting)
        start = frozen_solve(
            balance, (first, resting), (pull, np.zeros_like(first)), START_TOLERANCE, START_STEPS
        )
        family = InertiaFamily(balance, pull, budget - evaluations)
        try:
            end = followed_through(family, family.packed(*start))
        except BudgetSpent:
            end = None
        evaluations += family.evaluations
        if end is not None:
            return family.unpacked(end.state), evaluations
    return None, evaluations


@dataclass
class InertiaFamily:
    """Equations of one case; unknowns are the free ring displacements, then the ball places, over a reach.

    They raise `BudgetSpent` beyond their budget.
    """

    balance: AngularBalance
    pull: Vectors  # (1, Z) [N] constant forces on the balls at parameter 0
    budget: int  # evaluations of all balls that are allowed
    evaluations: int = 0

    @property
    def weight(self) -> NDArray:
        """Balls count together as much as a direction of the ring."""
        count = len(self.balance.bearing.azimuths)
        return np.concatenate([np.ones(len(self._free)), np.full(2 * count, 1 / count)])

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Places may be anywhere."""
        return after

    def packed(self, ring: NDArray, centres: Vectors) -> NDArray:
        """Unknowns (N) from places of ring (1, 5) and balls (1, Z)."""
        return np.concatenate([ring[0, self._free], centres[0].view(float)]) / self._length

    def unpacked(self, state: NDArray) -> tuple[NDArray, Vectors]:
        """Places of ring (1, 5) and balls (1, Z) from unknowns (N)."""
        ring, free = self.balance.place.copy(), self._free
        ring[0, free] = self._length * state[: len(free)]
        return ring, (self._length * state[len(free) :]).view(complex)[None]

    def orientation(self, state: NDArray, parameter: float) -> float:
        """Sign of the determinant of the derivatives."""
        return self._linear(state, parameter)[2].sign()

    def at(self, state: NDArray, parameter: float) -> LinearisedEquations:
        """Forces on ring and balls, over the largest one."""
        residual, by_parameter, matrix, allowed = self._linear(state, parameter)
        return LinearisedEquations(
            residual=residual,
            by_parameter=by_parameter,
            solve=matrix.solved,
            converged=self._largest(residual) <= allowed,
        )

    def _linear(self, state: NDArray, parameter: float) -> tuple[NDArray, NDArray, BorderedMatrix, float]:
        """Forces over the largest one, derivatives by parameter and unknowns, size that counts as none."""
        if self.evaluations >= self.budget:
            raise BudgetSpent
        ring, centres = self.unpacked(state)
        grooves = self.balance.grooves(ring)
        rest, full = (system.balls(grooves, centres) for system in (self._at_rest, self.balance))
        self.evaluations += 2
        begin = rest.forces.copy()
        begin[0] += self.pull
        sizes = force_scales(self.balance, full, grooves)
        largest, noise = float(sizes.largest[0]), float(sizes.noise[0])

        def blended(start: NDArray, end: NDArray) -> NDArray:
            return (1 - parameter) * start + parameter * end

        scale = self._length / largest
        matrix = self._matrix(
            blended(scale * rest.by_ball, scale * full.by_ball),
            blended(scale * rest.by_groove, scale * full.by_groove),
        )
        return (
            self._residual(blended(begin, full.forces), 1.0) / largest,
            self._residual(full.forces - begin, 0.0) / largest,
            matrix,
            max(TOLERANCE, noise / largest),
        )

    def _residual(self, forces: Vectors, loaded: float) -> NDArray:
        """Unbalanced forces (N) of ring and balls from those of the balls (3, 1, Z)."""
        excess, force, traction = forces
        left = loaded * self.balance.load - self.balance.on_ring(force, traction)
        return np.concatenate([left[0, self._free], excess[0].view(float)])

    def _largest(self, residual: NDArray) -> float:
        """Largest force in a direction of the ring, or on a ball as a vector."""
        ring, balls = np.split(residual, [len(self._free)])
        return float(max(np.abs(ring).max(initial=0.0), np.abs(balls.view(complex)).max()))

    def _matrix(self, by_ball: Vectors, by_groove: Vectors) -> BorderedMatrix:
        """Derivatives of the unbalanced forces by the places, from (2, 3, 1, Z)."""
        balance, free = self.balance, self._free
        unknowns = 2 * by_ball.shape[-1]
        to_groove = balance.ring_to_groove[:, free].T  # (F, Z)
        by_ring = by_groove[0, :, 0, None] * to_groove.real + by_groove[1, :, 0, None] * to_groove.imag
        excess, force, traction = by_ring  # (F, Z)
        _, ball_force, ball_traction = np.moveaxis(by_ball[:, :, 0], 1, 0)  # (2, Z)
        on_ring = ball_force[..., None] * balance.groove_to_ring[:, free]
        on_ring = (on_ring - ball_traction[..., None] * balance.ring_to_lever[:, free]).real  # (2, Z, F)
        balls = np.stack([by_ball[:, 0, 0].real, by_ball[:, 0, 0].imag]).T.swapaxes(-1, -2)  # (Z, 2, 2)
        largest = max(np.abs(balls).max(), np.abs(on_ring).max(initial=0.0))
        return BorderedMatrix(
            ring=-balance.on_ring(force, traction)[:, free].T,
            ring_by_balls=-on_ring.transpose(2, 1, 0).reshape(len(free), unknowns),
            balls_by_ring=np.stack([excess.real, excess.imag], axis=-1).reshape(len(free), unknowns).T,
            balls=balls - FLOATING * largest * np.eye(2),
        )

    @cached_property
    def _free(self) -> NDArray:
        """Directions in which the ring is free."""
        return np.flatnonzero(~self.balance.held[0])

    @cached_property
    def _at_rest(self) -> AngularBalance:
        return replace(self.balance, speeds=np.zeros_like(self.balance.speeds))

    @property
    def _length(self) -> float:
        return min(self.balance.bearing.inner_reach, self.balance.bearing.outer_reach)
