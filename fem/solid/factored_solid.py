"""The whole solid of a part, factored once, with its fields under any roller forces."""

import logging
from dataclasses import dataclass
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from fem.assembly import ball_loads, roller_loads
from fem.assembly.elasticity import elastic_energy
from fem.assembly.factorisation import Factorisation, factorised, threads
from fem.mesh.solid import meshed
from fem.parts.groove import BallPatches
from fem.parts.part import Part
from fem.parts.rings import ImpossiblePart, MeshSize, Patches
from fem.parts.step_solid import StepSolid
from fem.solid.fields import LoadedSolid

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class FactoredSolid:
    """A part as one factored stiffness."""

    part: Part | StepSolid
    patches: Any  # Patches of rollers, BallPatches of balls
    space: ngs.VectorH1  # of displacements [m], on a mesh in millimetres
    stiffness: Factorisation
    band: roller_loads.Band
    thread_number: int

    def of_order(self, order: int) -> "FactoredSolid":
        """The same elements with displacements of another order, >= 1, factored anew.

        Raises `NotSolved` if the solver refuses the matrix.
        """
        mesh, size = self.space.mesh, MeshSize(order=order, size=1.0, raceway_size=1.0)
        return factored_on(mesh, self.part, self.patches, size, self.thread_number)

    @property
    def loads(self) -> sparse.csc_array:
        """Load vectors (unknowns, Z M) of unit forces [N/N], which also read such displacements.

        Raises `NotSolved` if the mesh is too coarse for the patches.
        """
        if isinstance(self.patches, BallPatches):
            assert self.part.groove  # of every part under balls
            return ball_loads.ball_forces(self.band, self.part.groove, self.patches)
        return roller_loads.roller_forces(self.band, self.patches)

    def under(self, forces: NDArray) -> LoadedSolid:
        """Displacement and stress under generalised forces (Z, M) [N], or on stations, positive outward.

        Raises `ImpossiblePart` for forces of another shape, or not finite; `NotSolved` if the residual is too
        large, or the mesh too coarse for the patches.

        Valid
        -----
        Small displacement, perfect bonds, rigid clamps; no load outside the band.
        """
        loads: Any = self.loads
        shape = len(self.patches.azimuths), loads.shape[1] // len(self.patches.azimuths)
        if np.shape(forces) != shape or not np.isfinite(forces).all():
            raise ImpossiblePart(
                f"forces of shape {np.shape(forces)}; allowed are finite ones of shape {shape}"
            )
        displacement = ngs.GridFunction(self.space)
        with threads(self.thread_number):
            displacement.vec.FV().NumPy()[:] = self.stiffness.solve(loads @ np.ravel(forces))
        return LoadedSolid(
            part=self.part, patches=self.patches, forces=np.array(forces, dtype=float),
            displacement=displacement, radius=self.band.radius,
        )  # fmt: skip


def factored(
    part: Part | StepSolid, patches: Patches | BallPatches, mesh_size: MeshSize, thread_number: int = 2
) -> FactoredSolid:
    """Mesh and factor a part with some threads of NGSolve; order 3 of the elements pays.

    Raises `ImpossiblePart` if the loaded band is longer than the track, or a drawing or a support has no
    solid; `NotSolved` if the solver refuses the matrix.
    """
    mesh = meshed(part, patches.length, mesh_size, balls_of(patches))
    return factored_on(mesh, part, patches, mesh_size, thread_number)


def balls_of(patches: Patches | BallPatches) -> BallPatches | None:
    """Patches of balls; None of rollers."""
    return patches if isinstance(patches, BallPatches) else None


def factored_on(
    mesh: ngs.Mesh,
    part: Part | StepSolid,
    patches: Patches | BallPatches,
    mesh_size: MeshSize,
    thread_number: int,
) -> FactoredSolid:
    """Assemble and factor a part that is meshed in millimetres, as `factored`."""
    with threads(thread_number):
        space = ngs.VectorH1(mesh, order=mesh_size.order, dirichlet="clamped")
        stiffness = factorised(space, elastic_energy(mesh, part.materials))
        band = roller_loads.band(space, "raceway", roller_loads.quadrature_order(patches, mesh_size))
    _log.info("%s: %d unknowns in space", type(part).__name__, space.ndof)
    return FactoredSolid(
        part=part, patches=patches, space=space, stiffness=stiffness, band=band, thread_number=thread_number
    )
