"""Displacement and stress of a solid under its rollers, with the largest of each body."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.mesh.notches import notches
from fem.mesh.solid import MILLIMETRES
from fem.parts.rings import ImpossiblePart, Part, Patches
from fem.parts.step_solid import StepSolid
from fem.solid.stress import principal, stress, von_mises

CONTACT = 4.0  # standard deviations of a load patch: within them its own stress rules, which is the contact's
UNLOADED = 1e-3  # of the largest roller force: below it there is no contact to keep away from
SAMPLES = 6  # intervals along an element edge at whose ends stresses are read
MEGA = 1e6  # Pa per MPa


@dataclass(frozen=True, kw_only=True)
class BodyExtremes:
    """Extremes of one body; stresses away from loaded rollers and sharp edges."""

    displacement: float  # [m] anywhere
    von_mises: float  # [Pa]
    tension: float  # [Pa] largest principal stress
    compression: float  # [Pa] smallest principal stress, negative in compression
    x: float  # [m] of the largest von Mises stress, here and below
    radius: float  # [m]
    azimuth: float  # [rad] from z towards y


@dataclass(frozen=True, kw_only=True)
class LoadedSolid:
    """A solid under roller forces."""

    part: Part | StepSolid
    patches: Patches
    forces: NDArray  # (Z, M) [N] positive outward
    displacement: Any  # ngsolve.GridFunction (3,) [m] on a mesh in millimetres
    radius: float  # [m] of the raceway

    @property
    def mesh(self) -> ngs.Mesh:
        """Elements, in millimetres."""
        return self.displacement.space.mesh

    @cached_property
    def stress(self):
        """Stress of every element by itself, an ngsolve.CoefficientFunction (3, 3) [Pa]."""
        return stress(self.displacement, self.part.materials)

    @cached_property
    def smooth_stress(self):
        """Stress averaged where elements of one body meet, an ngsolve.CoefficientFunction (3, 3) [Pa].

        Bodies keep their own: across a bond of two materials the stress does jump.
        """
        return self.mesh.MaterialCF({name: self._averaged(name) for name in self.part.materials})

    def _averaged(self, body: str):
        region, order = self.mesh.Materials(body), max(self.displacement.space.globalorder - 1, 1)
        averaged = ngs.GridFunction(ngs.H1(self.mesh, order=order, definedon=region, dim=6))
        averaged.Set(_six(self.stress).Compile(), definedon=region)
        xx, yy, zz, xy, yz, xz = (averaged[k] for k in range(6))
        return ngs.CF((xx, xy, xz, xy, yy, yz, xz, yz, zz), dims=(3, 3))

    def largest(self) -> dict[str, BodyExtremes]:
        """Extremes of every body.

        Stresses are the averaged ones, read at vertices and between them. Left out is what lies within
        `CONTACT` patch widths of a loaded roller's line, where the Gaussian patch rules, which is not the
        true contact, and close to sharp edges (`fem.mesh.notches`), where a finer mesh gives ever more.

        Returns
        -------
        dict
            `BodyExtremes` by the name of the body

        Raises
        ------
        ImpossiblePart
            if a body is so small that nothing of it is left
        """
        return {name: self._largest(name) for name in self.part.materials}

    def _largest(self, body: str) -> BodyExtremes:
        points = self.mesh.MapToAllElements(_nodes(), self.mesh.Materials(body))
        x, y, z = ngs.CF((ngs.x, ngs.y, ngs.z))(points).T / MILLIMETRES
        far = self._clear(x, y, z)
        if not far.any():
            raise ImpossiblePart(f"every place of {body!r} is close to a loaded roller or to a sharp edge")
        displacement = ngs.Norm(self.displacement)(points)
        averaged = self._averaged(body)
        mises, first, _, third = ngs.CF((von_mises(averaged), principal(averaged))).Compile()(points).T
        peak = np.flatnonzero(far)[mises[far].argmax()]
        return BodyExtremes(
            displacement=float(displacement.max()),
            von_mises=float(mises[peak]),
            tension=float(first[far].max()),
            compression=float(third[far].min()),
            x=float(x[peak]),
            radius=float(np.hypot(y[peak], z[peak])),
            azimuth=float(np.arctan2(y[peak], z[peak])),
        )

    def _clear(self, x: NDArray, y: NDArray, z: NDArray) -> NDArray:
        """Whether places (n,) [m] are away from loaded rollers and from sharp edges."""
        far = notches(self.part).clear(x, np.hypot(y, z))
        reach = CONTACT * self.patches.width
        beyond = np.maximum(np.abs(x) - self.patches.length / 2, 0)
        load = np.abs(self.forces[:, 0])
        for phi in np.array(self.patches.azimuths)[load > UNLOADED * load.max()]:
            across = np.hypot(y - self.radius * np.sin(phi), z - self.radius * np.cos(phi))
            far &= np.hypot(beyond, across) > reach
        return far

    def write(self, path: Path | str) -> Path:
        """Write displacement and stresses for ParaView.

        Parameters
        ----------
        path : Path
            ends in .vtu

        Returns
        -------
        Path
            the file: places [mm], "displacement" [mm], "von_mises" and "principal" [MPa], largest first,
            "stress" [MPa] as xx, yy, zz, xy, yz, xz, and the number of the "body" in the order of
            `materials`

        Raises
        ------
        ImpossiblePart
            for a name that does not end in .vtu
        """
        path = Path(path)
        if path.suffix != ".vtu":
            raise ImpossiblePart(f"path = {str(path)!r}; allowed is a name that ends in .vtu")
        s, number = self.smooth_stress / MEGA, {name: float(k) for k, name in enumerate(self.part.materials)}
        fields = {
            "displacement": self.displacement * MILLIMETRES,
            "von_mises": self._by_elements(von_mises(s)),
            "principal": self._by_elements(principal(s)),
            "stress": self._by_elements(_six(s)),
            "body": self.mesh.MaterialCF(number),
        }
        ngs.VTKOutput(
            self.mesh, coefs=list(fields.values()), names=list(fields), filename=str(path.with_suffix("")),
            subdivision=1, floatsize="single",
        ).Do()  # fmt: skip
        return path

    def _by_elements(self, field):
        """A field as a polynomial on each element, which is written a hundred times faster."""
        stored = ngs.GridFunction(ngs.L2(self.mesh, order=self.displacement.space.globalorder, dim=field.dim))
        stored.Set(field.Compile())
        return stored


def _six(stress):
    """Components xx, yy, zz, xy, yz, xz."""
    return ngs.CF(tuple(stress[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))))


def _nodes():
    """Places of a tetrahedron at which stresses are read."""
    steps = range(SAMPLES + 1)
    places = [
        (i / SAMPLES, j / SAMPLES, k / SAMPLES)
        for i in steps for j in steps for k in steps if i + j + k <= SAMPLES
    ]  # fmt: skip
    return ngs.IntegrationRule(points=places, weights=[1.0] * len(places))
