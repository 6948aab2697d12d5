"""Parts condensed in this process, as the tests of finite elements ask for them."""

from fem import Resolution
from fem.condense import BEAM, HARMONICS, SMEARED, SOLID, condense_in_process
from fem.section.expansion import raceway_expansion
from fem.stages import unheard


def by_harmonics(part, length, axial_modes, mesh, harmonics=None):
    return condense_in_process(part, HARMONICS, _resolution(length, axial_modes, mesh, harmonics))


def with_smeared_bars(part, length, axial_modes, mesh, harmonics=None):
    return condense_in_process(part, SMEARED, _resolution(length, axial_modes, mesh, harmonics))


def as_beam(part, length, axial_modes, harmonics=None):
    return condense_in_process(part, BEAM, _resolution(length, axial_modes, None, harmonics))


def as_solid(part, patches, mesh, threads=2, report=unheard):
    return condense_in_process(part, SOLID, of_a_solid(patches, mesh, threads), report)


def expansion_of(part, length, axial_modes, mesh, load):
    return raceway_expansion(part, _resolution(length, axial_modes, mesh, None), load)


def of_a_solid(patches, mesh, threads=2):
    return Resolution(
        length=patches.length, axial_modes=patches.axial_modes, mesh_size=mesh, azimuths=patches.azimuths,
        patch_width=patches.width, threads=threads,
    )  # fmt: skip


def _resolution(length, axial_modes, mesh, harmonics):
    return Resolution(length=length, axial_modes=axial_modes, mesh_size=mesh, harmonics=harmonics)
