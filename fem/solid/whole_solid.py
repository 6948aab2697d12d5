"""A whole solid under its rollers by two orders of displacements, for its largest stresses."""

from collections.abc import Iterable
from dataclasses import dataclass

import ngsolve as ngs
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.solid.extremes import Samples, cylinder_axes, in_axes
from fem.solid.fields import LoadedSolid
from fem.solid.lattice import Spread, hooke, located, spread, strain_of


@dataclass(frozen=True)
class WholeSolid:
    """The same loads on the same elements; see `fem.solid.extremes.Sampled`."""

    lower: LoadedSolid
    higher: LoadedSolid

    def pieces(self, body: str) -> Iterable[int]:
        """The whole in one."""
        return (0,)

    def samples(
        self, body: str, piece: int, intervals: int, keys: NDArray | None = None, *, higher: bool = True
    ) -> Samples:
        """Samples of the whole solid."""
        solid = self.higher if higher else self.lower
        return self._of(solid, body, spread(solid.mesh, body, intervals, keys))

    def at(self, body: str, piece: int, places: NDArray, *, higher: bool = True) -> Samples:
        """Samples at those of some places (n, 3) [m] that lie in a body, in axes x, r, t."""
        solid = self.higher if higher else self.lower
        points, _ = located(solid.mesh, body, places * MILLIMETRES)
        samples = self._of(solid, body, points)
        return in_axes(samples, cylinder_axes(*samples.place[:, 1:].T))

    def _of(self, solid: LoadedSolid, body: str, points: Spread) -> Samples:
        gradient, moved = ngs.Grad(solid.displacement)(points.mapped), solid.displacement(points.mapped)
        place = ngs.CF((ngs.x, ngs.y, ngs.z))(points.mapped) / MILLIMETRES
        stress = hooke(strain_of(gradient), solid.part.materials[body])
        return Samples(points.key, points.even, place, moved, stress)
