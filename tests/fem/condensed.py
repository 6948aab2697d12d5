"""Parts condensed in this process, as the tests of finite elements ask for them."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from fem import Resolution
from fem.assembly.factorisation import threads
from fem.condense import BEAM, HARMONICS, SMEARED, SOLID, condense_in_process
from fem.section.expansion import heating, radial_expansion, rotation
from fem.section.rigid_body_modes import body_of, held_on_points
from fem.stages import unheard


@dataclass(frozen=True, kw_only=True)
class AxisymmetricLoad:
    """Heat and rotation of a part, by the names of its bodies."""

    thermal_strains: Mapping = field(default_factory=dict)  # alpha (T - T0) [-]
    densities: Mapping = field(default_factory=dict)  # [kg/m^3]
    speed: float = 0.0  # [rad/s]


def by_harmonics(part, length, axial_modes, mesh, harmonics=None):
    return condense_in_process(part, HARMONICS, _resolution(length, axial_modes, mesh, harmonics))


def with_smeared_bars(part, length, axial_modes, mesh, harmonics=None):
    return condense_in_process(part, SMEARED, _resolution(length, axial_modes, mesh, harmonics))


def as_beam(part, length, axial_modes, harmonics=None):
    return condense_in_process(part, BEAM, _resolution(length, axial_modes, None, harmonics))


def as_solid(part, patches, mesh, threads=2, report=unheard):
    return condense_in_process(part, SOLID, of_a_solid(patches, mesh, threads), report)


def expansion_of(part, length, axial_modes, mesh, load):
    """Expansion w_m [m] of a raceway by heat and rotation, as it is supported."""
    with threads(1):
        body = body_of(part, Resolution(length=length, mesh_size=mesh))
        vector = np.zeros(body.stiffness.unknowns)
        if load.thermal_strains:
            vector += heating(body, load.thermal_strains)
        if load.speed:
            vector += rotation(body, load.densities, load.speed)
        held = replace(body, stiffness=held_on_points(body, part.free_motions, 0))
        return radial_expansion(held, vector, "raceway", axial_modes)


def of_a_solid(patches, mesh, threads=2):
    return Resolution(
        length=patches.length, axial_modes=patches.axial_modes, mesh_size=mesh, azimuths=patches.azimuths,
        patch_width=patches.width, threads=threads,
    )  # fmt: skip


def _resolution(length, axial_modes, mesh, harmonics):
    return Resolution(length=length, axial_modes=axial_modes, mesh_size=mesh, harmonics=harmonics)
