"""Displacement and stress of a solid under its rollers."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import ngsolve as ngs
from numpy.typing import NDArray

from fem.parts.groove import BallPatches
from fem.parts.part import Part
from fem.parts.rings import ImpossiblePart, Patches
from fem.parts.step_solid import StepSolid
from fem.solid.stress import stress
from fem.solid.vtu import vtu


@dataclass(frozen=True, kw_only=True)
class LoadedSolid:
    """A solid under forces of rollers or balls."""

    part: Part | StepSolid
    patches: Patches | BallPatches
    forces: NDArray  # (Z, M) [N] positive outward, of balls on stations
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

    def write(self, path: Path | str) -> Path:
        """Write displacement and stresses for ParaView, see `fem.solid.vtu`.

        Raises `ImpossiblePart` for a name that does not end in .vtu.
        """
        path = Path(path)
        if path.suffix != ".vtu":
            raise ImpossiblePart(f"path = {str(path)!r}; allowed is a name that ends in .vtu")
        path.write_bytes(vtu(self.displacement, self.part.materials))
        return path
