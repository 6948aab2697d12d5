"""Balance of a four-point contact ball bearing with rigid rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.diagonals import Diagonals, LoadedDiagonals
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
