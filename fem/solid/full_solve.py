"""A raceway that answers roller forces by one solve of its whole solid."""

from dataclasses import dataclass
from functools import cached_property

from numpy.typing import NDArray

from fem.assembly import roller_loads
from fem.assembly.factorisation import threads
from fem.half_space.load_patch import half_space
from fem.raceway.compliance import RacewayCompliance
from fem.solid.condensation import condensed
from fem.solid.factored_solid import FactoredSolid


@dataclass(frozen=True, kw_only=True)
class FullSolve:
    """The raceway of a factored solid; symbols as in `fem.assembly.roller_loads`."""

    solid: FactoredSolid

    def answer(self, forces: NDArray) -> tuple[NDArray, NDArray]:
        r"""Outward deviations from the ground, and the mean translation that they contain.

        .. math:: w = B^T u - H F,\quad t = T^T u,\quad K u = B F

        with K the stiffness, B the load vectors of unit forces, T those that read the mean translation, and H
        the deflection of a half-space under a roller's own load, which the contact law holds.

        w (Z, M) [m] is positive outward like the forces F (Z, M) [N]; t (2) [m] is along y and z.
        Raises `NotSolved` if the residual of the solve is too large, or the mesh too coarse for the patches.

        Source
        ------
        Finite elements under the forces of all rollers, the half-space taken out; derived here.

        Valid
        -----
        Small displacement, perfect bonds, rigid clamps; no load outside the band.
        """
        with threads(self.solid.thread_number):
            displacement = self.solid.stiffness.solve(self._rollers @ forces.ravel())
        translation = self._translations.T @ displacement
        deviation = (self._rollers.T @ displacement).reshape(forces.shape) - forces @ self._half_space
        return deviation, translation

    def condensed(self) -> RacewayCompliance:
        """All of its answers as one operator, by as few solves as symmetry leaves."""
        return condensed(self.solid)

    @cached_property
    def _rollers(self):
        return roller_loads.roller_forces(self.solid.band, self.solid.patches)

    @cached_property
    def _translations(self) -> NDArray:
        return roller_loads.translation_forces(self.solid.band)

    @cached_property
    def _half_space(self) -> NDArray:
        return half_space(self.solid.patches, self.solid.part.materials["ring"])
