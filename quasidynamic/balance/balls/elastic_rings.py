"""Balance of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.diagonals import Diagonals, LoadedDiagonals
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.ball import FourPointBearing

SYMMETRIC = 1e-9  # allowed difference of a compliance from its mirror image, over the largest entry


class RigidRingState(NamedTuple):
    """Forces on the inner ring at one place of it; moments and tilts are taken over the pitch radius."""

    place: NDArray  # (5) [m]
    diagonals: LoadedDiagonals
    excess: NDArray  # (5) load less what the balls carry [N]
    stiffness: NDArray  # (5, 5) [N/m]


def ring_levers(bearing: FourPointBearing) -> NDArray:
    """Over which moments become forces, and tilts displacements (5) [-, m]."""
    pitch = bearing.pitch_diameter / 2
    return np.array([1.0, 1.0, 1.0, pitch, pitch])


@dataclass(frozen=True)
class RigidRings:
    """Two rigid rings with balls between them."""

    diagonals: Diagonals
    load: NDArray  # (5) [N] moments over the pitch radius

    @classmethod
    def of(cls, bearing: FourPointBearing, load: NDArray) -> "RigidRings":
        """Build from a bearing and a load [N, N m].

        Raises
        ------
        ImpossiblePart
            for a load that is not five finite numbers
        NotSolved
            when neither load nor interference holds the ring
        """
        load = np.asarray(load, dtype=float)
        if load.shape != (5,) or not np.isfinite(load).all():
            raise ImpossiblePart(f"load = {load} must be five finite numbers: Fx, Fy, Fz, My, Mz")
        if not load.any() and bearing.clearance >= 0.0:
            raise NotSolved(
                f"no load, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds the ring, its "
                "position is undetermined; give a load or an interference (negative clearance)",
                "undetermined",
            )
        return cls(Diagonals.of(bearing), load / ring_levers(bearing))

    def at(self, place: NDArray) -> RigidRingState:
        """Evaluate every diagonal."""
        loaded = self.diagonals.at(place)
        excess = self.load - self.diagonals.carried(loaded.force)
        return RigidRingState(place, loaded, excess, self.diagonals.stiffness(loaded.stiffness))

    def imbalance(self, state: RigidRingState) -> float:
        """Largest unbalanced force over the largest force [-]."""
        return float(np.abs(state.excess).max() / max(np.abs(self.load).max(), state.diagonals.loads.max()))

    def usual_stiffness(self, largest: float = 0.0) -> float:
        """Stiffness of a diagonal under the largest load, or the largest force [N] on a diagonal [N/m]."""
        force = max(largest, float(np.abs(self.load).max()))
        return 1.5 * self.diagonals.coefficient ** (2 / 3) * force ** (1 / 3)

    def first_place(self) -> NDArray:
        """Ring (5) pushed along its load to where about one ball would carry it: rather too far."""
        size, diagonals = np.abs(self.load).max(), self.diagonals
        if size == 0.0:
            return np.zeros(5)
        direction = self.load / np.linalg.norm(self.load)
        moves = np.hypot(*(diagonals.moves @ direction).T).max()
        distance = np.hypot(*diagonals.start[0])
        gap = max(diagonals.touching - distance, 0.0)
        squeeze = (size / diagonals.coefficient) ** (2 / 3)
        return direction * (gap + squeeze) / (moves * diagonals.start[0].min() / distance)


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
