"""Volume of outer rings and squirrel cages against their meshes."""

from dataclasses import replace

import ngsolve as ngs
import pytest
from pytest import approx

from fem import ClampedFace, MeshSize, OuterRing
from fem.mesh.half_pitch import half_pitch
from fem.parts.volume import volume
from tests.fem.test_parts import CAGE, STEEL

CAGES = {
    "one side": CAGE,
    "both sides": replace(CAGE, two_sided=True),
    "collar": replace(CAGE, collar_length=3e-3, collar_thickness=5e-3),
}


@pytest.mark.parametrize("name", CAGES)
def test_cage_has_the_volume_of_its_mesh(name):
    cage = CAGES[name]
    mesh = half_pitch(cage, 5e-3, MeshSize(order=3, size=4e-3, raceway_size=3e-3))
    meshed = 2e-9 * cage.bars * ngs.Integrate(ngs.CF(1.0), mesh)  # meshes are in millimetres
    assert volume(cage) == approx(meshed, rel=1e-5)


def test_plain_ring_has_the_volume_of_a_tube():
    ring = OuterRing(raceway_diameter=0.1, thickness=0.01, width=0.02, elastic=STEEL, support=ClampedFace())
    assert volume(ring) == approx(3.14159265 / 4 * (0.12**2 - 0.1**2) * 0.02, rel=1e-8)
