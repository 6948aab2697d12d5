"""Tangent compliance and stiffness of the ring at an equilibrium."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z, Unknowns, Y, Z
from quasidynamic.solve.rollers import bordered_system

RING = (Y, Z, TILT_Z, TILT_Z + 1)  # the ring's places among the unknowns
TILTS = np.array([1.0, 1.0, -1.0, 1.0])  # y, z, tilts about y and z, over y, z, slopes dz/dx and dy/dx


@dataclass(frozen=True)
class Tangent:
    """Derivatives of an equilibrium, by implicit differentiation: nothing is solved again.

    Rollers, films, cage and elastic raceways follow. The ring is free to tilt here even where a
    guide holds it, so that the tilting rows mean something.
    """

    balance: BearingBalance  # of one case, free to tilt
    scaled: NDArray  # (1, N)
    held: bool  # whether a guide holds the tilts of the real ring

    @classmethod
    def at(cls, balance: BearingBalance, unknowns: Unknowns) -> "Tangent":
        """Tangent at the unknowns of an equilibrium of one case."""
        raceways = balance.roller.raceways
        slices = replace(raceways.slices, axial_modes=max(raceways.slices.axial_modes, 2))
        whole_rollers = replace(raceways, slices=slices, drop=raceways.slices.unfolded(raceways.drop))
        free = replace(
            balance,
            roller=replace(balance.roller, raceways=whole_rollers),
            points=replace(balance.points, free_tilt=np.array([[True]])),
        )
        return cls(free, free.pack(unknowns), not balance.points.free_tilt[0, 0])

    @cached_property
    def response(self) -> NDArray:
        """Change of all unknowns (N, 4) per newton along y and z, per newton metre on dz/dx and dy/dx."""
        loads = np.zeros((1, self.balance.layout.size, len(RING)))
        loads[0, RING, range(len(RING))] = -1.0 / self.balance.scales.residual[0, RING]
        system = self.balance.evaluate(self.scaled)
        return bordered_system.solve(self.balance, system, loads)[0] * self.balance.scales.unknown.T

    @property
    def compliance(self) -> NDArray:
        """Tangent compliance (5, 5): x, y, z [m], tilts about y and z [rad] per N and N m.

        Infinite along x, where a bearing without flanges carries nothing.
        """
        matrix = np.zeros((5, 5))
        matrix[0, 0] = np.inf
        matrix[1:, 1:] = self.response[:CAGE] * np.outer(TILTS, TILTS)
        return matrix

    @property
    def stiffness(self) -> NDArray:
        """Tangent stiffness (5, 5), the inverse of `compliance`; zero along x."""
        matrix = np.zeros((5, 5))
        matrix[1:, 1:] = np.linalg.inv(self.response[:CAGE]) * np.outer(TILTS, TILTS)
        return matrix

    @property
    def radial_stiffness(self) -> float:
        """Load along the load direction per displacement there [N/m]; the ring may move aside."""
        change = self.response[:CAGE] @ self._load
        return float(1.0 / (self._direction @ change[:2]))

    @property
    def _direction(self) -> NDArray:
        """Unit vector (y, z) of the radial load, or z when there is none."""
        points = self.balance.points
        load = np.array([points.load_y[0, 0], points.load_z[0, 0]])
        return load / np.hypot(*load) if load.any() else np.array([0.0, 1.0])

    @property
    def _load(self) -> NDArray:
        """A newton of radial load, with the moments (4) that hold the tilts if a guide does."""
        load = np.concatenate([self._direction, [0.0, 0.0]])
        if self.held:
            tilts = self.response[TILT_Z:CAGE]
            load[2:] = -np.linalg.solve(tilts[:, 2:], tilts[:, :2] @ load[:2])
        return load
