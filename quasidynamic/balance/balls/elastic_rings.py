"""Balance of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.diagonals import Diagonals, LoadedDiagonals
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves, shape_of
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.ball import FourPointBearing


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

        Raises `ImpossiblePart` for a load that is not five finite numbers; `NotSolved` when neither load nor
        interference holds the ring.
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
        moves = np.linalg.norm(diagonals.moves[:, 0] @ direction, axis=1).max()
        distance = np.hypot(*diagonals.start)
        gap = max(diagonals.touching - distance, 0.0)
        squeeze = (size / diagonals.coefficient) ** (2 / 3)
        return direction * (gap + squeeze) / (moves * diagonals.start.min() / distance)


class ElasticRingState(NamedTuple):
    """Forces on rings and balls at one place of the inner ring and one shape of the rings."""

    place: NDArray  # (5) [m]
    shape: NDArray  # (4 Z) [m] by how much the groove centres came closer
    diagonals: LoadedDiagonals
    excess: NDArray  # (5) load less what the balls carry [N]
    misfit: NDArray  # (4 Z) shape less what the forces make of it [m]
    softness: NDArray  # (4 Z, 4 Z) [-] change of what the forces make of it by the distance of groove centres
    forces: NDArray  # (4 Z, 6) [N/m, N] change of the forces by the place, and by the misfit once it closes
    approach: NDArray  # (4 Z, 6) [-, m] and that of the distances of groove centres


@dataclass(frozen=True)
class ElasticRings:
    """Two elastic rings with balls between them."""

    rigid: RigidRings  # the same rings without their elasticity
    grooves: ElasticGrooves  # two arcs each, a ball's contacts side by side
    usual_stiffness: float  # [N/m] that weighs a misfit against forces

    def at(self, place: NDArray, shape: NDArray) -> ElasticRingState:
        """Evaluate every diagonal."""
        diagonals = self.rigid.diagonals
        loaded = diagonals.at(place, shape.reshape(-1, 2, 2))
        excess = self.rigid.load - diagonals.carried(loaded.force)
        closed, softness = self._closed(loaded)
        misfit = shape - closed
        columns = np.concatenate([diagonals.moves.reshape(-1, 5), misfit[:, None]], axis=1)
        approach = np.linalg.solve(np.eye(len(softness)) + softness, columns)
        forces = loaded.stiffness @ approach.reshape(*loaded.force.shape, 6)
        return ElasticRingState(
            place, shape, loaded, excess, misfit, softness, forces.reshape(-1, 6), approach
        )

    def _closed(self, loaded: LoadedDiagonals) -> tuple[NDArray, NDArray]:
        """What forces close of the distances of groove centres (4 Z) [m], and its change by them [-]."""
        angles, force = loaded.angles.reshape(1, -1), loaded.force.reshape(-1, 2)
        vectors = force[None, :, 0] + 1j * force[None, :, 1]
        contacts = len(force)
        closed, softness = np.zeros((contacts, 2)), np.zeros((contacts, 2, contacts, 2))
        for groove, sign in ((self.grooves.outer, 1), (self.grooves.inner, -1)):
            if groove is None:
                continue
            shape = shape_of(groove, angles, sign * vectors)
            closed += sign * shape.moved[0]
            by_force = shape.by_force[0].swapaxes(1, 2)  # contact, contact of the force, components
            softness += (by_force @ loaded.stiffness.reshape(-1, 2, 2)).swapaxes(1, 2)
            softness += sign * shape.by_angle[0][..., None] * loaded.turn.reshape(-1, 2)
        return closed.ravel(), softness.reshape(2 * contacts, -1)

    def imbalance(self, state: ElasticRingState) -> float:
        """Largest force that balance or the shape of the rings requires, over the largest force [-]."""
        largest = max(np.abs(self.rigid.load).max(), state.diagonals.loads.max())
        return float(max(np.abs(state.excess).max(), self._misfit_forces(state).max()) / largest)

    def size(self, state: ElasticRingState) -> float:
        """Length of all that is out of balance [N]."""
        return float(np.hypot(np.linalg.norm(state.excess), np.linalg.norm(self._misfit_forces(state))))

    def _misfit_forces(self, state: ElasticRingState) -> NDArray:
        return self.usual_stiffness * np.abs(state.misfit)

    def carried(self, forces: NDArray) -> NDArray:
        """Loads (5, ...) that forces (4 Z, ...) carry."""
        return self.rigid.diagonals.moves.reshape(-1, 5).T @ forces

    def stiffness(self, state: ElasticRingState) -> NDArray:
        """Tangent stiffness (5, 5) [N/m]: load over the place of the inner face."""
        tangent = self.carried(state.forces[:, :5])
        return (tangent + tangent.T) / 2

    def step(self, state: ElasticRingState, place: NDArray) -> NDArray:
        """Change of the shape (4 Z) [m] that closes the misfit while the ring moves (5) [m]."""
        return self.rigid.diagonals.moves.reshape(-1, 5) @ place - state.approach @ np.append(place, 1.0)

    def lowest_eigenvalue(self, state: ElasticRingState) -> float:
        """Lowest eigenvalue of the softness plus one [-]; below zero, contacts and rings snap together."""
        return 1.0 + float(np.linalg.eigvals(state.softness).real.min())
