"""A body that another finite element program reduced to the nodes of a seat, as data."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import ImpossiblePart

LOOSE = 1e-9  # smallest stiffness against rigid motions of a body that is held, over that of its entries
FEWEST = 8  # azimuths of nodes, by which the harmonics of a translation are distinguished from others


@dataclass(frozen=True, eq=False)
class ReducedBody:
    """What an outer ring is bonded to at the nodes of its outer surface; it is held itself.

    Places count from the middle of the raceway, x along the axis, as in `fem.parts.rings`.
    """

    places: NDArray  # (K, 3) [m]
    stiffness: NDArray  # (3 K, 3 K) [N/m] symmetric; node by node along x, y, z

    def __post_init__(self):
        count = len(self.places)
        if self.places.shape != (count, 3) or self.stiffness.shape != (3 * count, 3 * count):
            raise ImpossiblePart(f"a matrix {self.stiffness.shape} does not fit {count} nodes")
        if self.azimuths < FEWEST:
            raise ImpossiblePart(
                f"nodes stand at {self.azimuths} azimuths of the seat; allowed are {FEWEST} or more"
            )
        if self.hold <= LOOSE:
            raise ImpossiblePart("the body of the matrix can move or turn without force: hold it there")

    @property
    def azimuths(self) -> int:
        """Number of different azimuths of its nodes."""
        _, y, z = self.places.T
        angles = np.sort(np.arctan2(y, z) % (2 * np.pi))
        apart = np.diff(angles, append=angles[0] + 2 * np.pi)
        return int(np.count_nonzero(apart > 1e-6))

    @property
    def rigid_stiffness(self) -> NDArray:
        """Stiffness against rigid motions (6, 6) [N/m]: translations, turns times the size of the seat."""
        R = self._rigid_motions
        return R.T @ self.stiffness @ R

    @property
    def hold(self) -> float:
        """Least stiffness against a rigid motion over what its entries add up to; rounding of a free body."""
        R = abs(self._rigid_motions)
        entries = np.diag(R.T @ abs(self.stiffness) @ R).max()
        return float(np.linalg.eigvalsh(self.rigid_stiffness)[0] / entries)

    @property
    def _rigid_motions(self) -> NDArray:
        """Displacements of the nodes (3 K, 6)."""
        x, y, z = self.places.T / np.abs(self.places).max()
        o, i = np.zeros_like(x), np.ones_like(x)
        motions = [(i, o, o), (o, i, o), (o, o, i), (o, -z, y), (z, o, -x), (-y, x, o)]
        return np.stack([np.stack(motion, axis=1).ravel() for motion in motions], axis=1)
