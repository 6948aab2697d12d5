"""The whole solid of a part, factored once, with its fields under any roller forces."""

import logging
from dataclasses import dataclass

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import roller_loads
from fem.assembly.elasticity import elastic_energy
from fem.assembly.factorisation import Factorisation, factorised, threads
from fem.mesh.solid import meshed
from fem.parts.rings import ImpossiblePart, MeshSize, Part, Patches
from fem.parts.step_solid import StepSolid
from fem.solid.fields import LoadedSolid

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class FactoredSolid:
    """A part as one factored stiffness."""

    part: Part | StepSolid
    patches: Patches
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

    def under(self, forces: NDArray) -> LoadedSolid:
        """Displacement and stress under generalised forces (Z, M) [N], positive outward.

        Raises `ImpossiblePart` for forces of another shape, or not finite; `NotSolved` if the residual is too
        large, or the mesh too coarse for the patches.

        Valid
        -----
        Small displacement, perfect bonds, rigid clamps; no load outside the band.
        """
        shape = len(self.patches.azimuths), self.patches.axial_modes
        if np.shape(forces) != shape or not np.isfinite(forces).all():
            raise ImpossiblePart(
                f"forces of shape {np.shape(forces)}; allowed are finite ones of shape {shape}"
            )
        displacement = ngs.GridFunction(self.space)
        with threads(self.thread_number):
            loads = roller_loads.roller_forces(self.band, self.patches) @ np.ravel(forces)
            displacement.vec.FV().NumPy()[:] = self.stiffness.solve(loads)
        return LoadedSolid(
            part=self.part, patches=self.patches, forces=np.array(forces, dtype=float),
            displacement=displacement, radius=self.band.radius,
        )  # fmt: skip


def factored(
    part: Part | StepSolid, patches: Patches, mesh_size: MeshSize, thread_number: int = 2
) -> FactoredSolid:
    """Mesh and factor a part with some threads of NGSolve; order 3 of the elements pays.

    Raises `ImpossiblePart` if the loaded band is longer than the track, or a drawing or a support has no
    solid; `NotSolved` if the solver refuses the matrix.
    """
    return factored_on(meshed(part, patches.length, mesh_size), part, patches, mesh_size, thread_number)


def factored_on(
    mesh: ngs.Mesh, part: Part | StepSolid, patches: Patches, mesh_size: MeshSize, thread_number: int
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
