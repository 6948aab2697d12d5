"""Displacement and stress of one ring under the rollers of one state, on its whole solid."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

import fem
from fem.parts.resolution import neighbour
from fem.parts.surroundings import Surroundings
from flexbearing.program.threads import linear_algebra_alone

if TYPE_CHECKING:
    from fem.parts.part import Part
    from fem.parts.probe import Probe
    from fem.parts.resolution import Shape
    from fem.parts.step_solid import StepSolid
    from fem.solid.extremes import BodyExtremes, Sampled
    from fem.solid.factored_solid import FactoredSolid
    from fem.solid.fields import LoadedSolid
    from fem.solid.probes import Readings

Race = Literal["inner", "outer"]

NAMES = {"inner": "inner ring and shaft", "outer": "outer ring"}
MEGA = 1e6  # Pa per MPa


class NoFields(RuntimeError):
    """A part that displacements and stresses cannot be computed of; the message says why."""


@dataclass(frozen=True, kw_only=True)
class PartFields:
    """A part under the rollers or balls of one state; what is requested is solved then, and kept."""

    race: Race
    state: str  # "rigid", "flexible", "iteration 3"
    part: Part | StepSolid
    patches: Any  # fem.Patches of rollers, BallPatches of balls
    forces: NDArray  # (Z, M) [N] positive outward, of balls on stations
    sizes: Sizes
    surroundings: Surroundings  # heat and rotation, which the largest stresses hold
    left_out: str  # what they do not hold; empty: nothing
    nodes_of: Shape | None = None  # whose mesh for stresses is taken with its nodes moved

    @cached_property
    def solid(self) -> FactoredSolid:
        """The whole solid, factored; raises `NoFields`."""
        from fem.condense import require_drawing
        from fem.solid.factored_solid import factored

        with self._solving():
            require_drawing(self.part, self.patches.length)
            return factored(self.part, self.patches, self.sizes.solid, self.sizes.threads)

    @cached_property
    def loaded(self) -> LoadedSolid:
        """The whole solid under its rollers; raises `NoFields`."""
        with self._solving():
            return self.solid.under(self.forces)

    @cached_property
    def extremes(self) -> dict[str, BodyExtremes]:
        """Largest stresses of every body with their errors; raises `NoFields`."""
        from fem.solid.clearing import clearing
        from fem.solid.extremes import extremes

        with self._solving():
            radius, sampled = self._sampled
            clear = clearing(self.part, self.patches, self.forces, radius)
            return {body: extremes(sampled, body, clear) for body in self.part.materials}

    def readings(self, probes: Sequence[Probe]) -> Readings:
        """What probes read; raises `NoFields`."""
        from fem.solid.probes import readings

        with self._solving():
            return readings(self._sampled[1], self.part, probes, self.patches.width)

    @cached_property
    def _sampled(self) -> tuple[float, Sampled]:
        """Radius of the raceway [m], and the part by two orders of displacements on a mesh for stresses."""
        loads = self.patches, self.forces
        if isinstance(self.part, fem.SquirrelCage):
            from fem.squirrel_cage.loaded_cage import feet_size, loaded_cage

            meshed = self.part if self.nodes_of is None else self.nodes_of.part
            feet = feet_size(meshed) * self.sizes.coarseness
            cage = loaded_cage(self.part, *loads, self.sizes.stresses, feet, self.nodes_of)
            return cage.radius, cage
        if isinstance(self.part, fem.OuterRing | fem.RingOnShaft):
            from fem.section.loaded_section import loaded_section

            sizes = self.sizes.stresses
            section = loaded_section(self.part, *loads, sizes, self.surroundings, self.nodes_of)
            return section.radius, section
        from fem.solid.whole_solid import WholeSolid

        return self.loaded.radius, WholeSolid(self._neighbour.under(self.forces), self.loaded)

    @property
    def _neighbour(self) -> FactoredSolid:
        """The whole solid by another order of displacements, which gives the error."""
        return self.solid.of_order(neighbour(self.sizes.solid.order))

    def support(self) -> dict[str, float]:
        """Stiffness of the support against tilt and along the axis, with estimated errors."""
        from fem.solid.support_stiffness import support_stiffness

        with self._solving():
            held, other = (support_stiffness(solid) for solid in (self.solid, self._neighbour))
        return {
            "tilting_Nm_per_rad": held.tilting,
            "tilting_error_Nm_per_rad": abs(held.tilting - other.tilting),
            "axial_N_per_m": held.axial,
            "axial_error_N_per_m": abs(held.axial - other.axial),
        }

    def record(self) -> dict[str, Any]:
        """Largest values with their errors and units, as JSON can hold them."""
        began = perf_counter()
        bodies = {name: body_record(most) for name, most in self.extremes.items()}
        record = stress_record(bodies, "rollers", self.surroundings, self.left_out)
        return record | {"support": self.support(), "seconds": perf_counter() - began}

    @contextmanager
    def _solving(self) -> Iterator[None]:
        from fem.assembly.factorisation import NotSolved

        try:
            # threads of the linear algebra would fight with those of the finite elements
            with linear_algebra_alone():
                yield
        except (fem.ImpossiblePart, NotSolved) as problem:
            raise NoFields(f"{NAMES[self.race]}: {problem}") from problem


@dataclass(frozen=True)
class Sizes:
    """Elements of the whole solid, those of the mesh for stresses, and threads."""

    solid: fem.MeshSize
    stresses: fem.MeshSize
    coarseness: float  # of the latter over that of the usual mesh, where the case requires another [-]
    threads: int


def stress_record(
    bodies: dict[str, dict[str, float]], elements: str, around: Surroundings, left_out: str
) -> dict[str, Any]:
    """Largest values of all bodies of a part, and the loads they hold."""
    steady = around.speed or any(around.thermal_strains.values())
    loads = f"{elements}, heat and rotation" if steady else elements
    return {"bodies": bodies, "loads": loads, "left_out": left_out}


def body_record(most: BodyExtremes) -> dict[str, float]:
    """Extremes of a body with their units; the place is that of the largest von Mises stress."""
    record = {}
    for name in ("von_mises", "tension", "compression"):
        largest = getattr(most, name)
        record[f"{name}_MPa"] = largest.value / MEGA
        record[f"{name}_error_MPa"] = largest.error / MEGA
    return record | {
        "displacement_um": 1e6 * most.displacement,
        "x_mm": 1e3 * most.von_mises.x,
        "radius_mm": 1e3 * most.von_mises.radius,
        "azimuth_deg": float(np.degrees(most.von_mises.azimuth)),
    }
