"""Balance of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.diagonals import LoadedDiagonals
from quasidynamic.balance.balls.rigid_rings import RigidRings
from quasidynamic.errors import ImpossiblePart

SYMMETRIC = 1e-9  # allowed difference of a compliance from its mirror image, over the largest entry


class ElasticRingState(NamedTuple):
    """Forces on rings and balls at one place of the inner ring and one shape of the rings."""

    place: NDArray  # (5) [m]
    shape: NDArray  # (4 Z) [m] by how much the groove centres came closer
    diagonals: LoadedDiagonals
    excess: NDArray  # (5) load less what the balls carry [N]
    misfit: NDArray  # (4 Z) shape less what the forces make of it [m]


@dataclass(frozen=True)
class ElasticRings:
    """Two elastic rings with balls between them."""

    rigid: RigidRings  # the same rings without their elasticity
    compliance: NDArray  # (4 Z, 4 Z) [m/N]
    usual_stiffness: float  # [N/m] that weighs a misfit against forces

    def at(self, place: NDArray, shape: NDArray) -> ElasticRingState:
        """Evaluate every diagonal."""
        loaded = self.rigid.diagonals.at(place, shape.reshape(-1, 2, 2))
        excess = self.rigid.load - self.rigid.diagonals.carried(loaded.force)
        return ElasticRingState(place, shape, loaded, excess, shape - self.compliance @ loaded.force.ravel())

    def imbalance(self, state: ElasticRingState) -> float:
        """Largest force that balance or the shape of the rings requires, over the largest force [-]."""
        largest = max(np.abs(self.rigid.load).max(), state.diagonals.loads.max())
        return float(max(np.abs(state.excess).max(), self._misfit_forces(state).max()) / largest)

    def size(self, state: ElasticRingState) -> float:
        """Length of all that is out of balance [N]."""
        return float(np.hypot(np.linalg.norm(state.excess), np.linalg.norm(self._misfit_forces(state))))

    def _misfit_forces(self, state: ElasticRingState) -> NDArray:
        return self.usual_stiffness * np.abs(state.misfit)

    def responses(self, state: ElasticRingState) -> tuple[NDArray, NDArray]:
        """Change of the forces by the misfit (4 Z) and by the place of the ring (4 Z, 5) [N, N/m]."""
        stiffness = state.diagonals.stiffness
        moves = np.repeat(self.rigid.diagonals.moves, 2, axis=0).reshape(-1, 2, 2, 5)
        coupled = np.eye(len(self.compliance)) + _by_blocks(stiffness, self.compliance)
        changes = np.concatenate([state.misfit.reshape(-1, 2, 2, 1), moves], axis=-1)
        answers = np.linalg.solve(
            coupled, np.einsum("jdab,jdbq->jdaq", stiffness, changes).reshape(len(coupled), -1)
        )
        return answers[:, 0], answers[:, 1:]

    def carried(self, forces: NDArray) -> NDArray:
        """Loads (5, ...) that forces (4 Z, ...) carry."""
        return np.repeat(self.rigid.diagonals.moves, 2, axis=0).reshape(-1, 5).T @ forces

    def stiffness(self, state: ElasticRingState) -> NDArray:
        """Tangent stiffness (5, 5) [N/m]: load over the place of the inner face."""
        tangent = self.carried(self.responses(state)[1])
        return (tangent + tangent.T) / 2

    def lowest_eigenvalue(self, state: ElasticRingState) -> float:
        """Lowest eigenvalue of 1 + sqrt(K) C sqrt(K); above zero there is one balance only."""
        stiffness = state.diagonals.stiffness.reshape(-1, 2, 2)
        product = np.sqrt(np.linalg.det(stiffness).clip(0.0))[:, None, None]
        trace = np.trace(stiffness, axis1=1, axis2=2)[:, None, None]
        # the square root of a symmetric 2 x 2 matrix, zero where nothing is pressed
        root = (stiffness + product * np.eye(2)) / np.sqrt(np.where(trace > 0, trace + 2 * product, 1.0))
        half = _by_blocks(root, self.compliance)
        return float(np.linalg.eigvalsh(np.eye(len(half)) + _by_blocks(root, half.T))[0])


def dense_compliance(row: NDArray, balls: int) -> NDArray:
    """Compliance of all balls (4 Z, 4 Z) [m/N] by that of balls so many pitches apart.

    Raises
    ------
    ImpossiblePart
        when it is not finite, of another shape or not symmetric
    """
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


def _by_blocks(blocks: NDArray, full: NDArray) -> NDArray:
    """Product of a matrix of 2 x 2 blocks on the diagonal (Z, 2, 2, 2) with a full one (4 Z, 4 Z)."""
    rows = full.reshape(-1, 2, len(full))
    return (blocks.reshape(-1, 2, 2) @ rows).reshape(full.shape)
