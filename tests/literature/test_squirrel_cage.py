"""Squirrel cage with a rigid end ring: 24 bars of 4 x 3 x 40 mm on R 50 mm, E 200 GPa, nu 0.3.

A three-dimensional model of parallel-sided bars with a ring 1000 times stiffer gives 11083 N/mm at
order 4; the textbook formula for clamped bars, n E b h (b^2 + h^2)/(2 L^3), 11250 N/mm.
"""

import ngsolve as ngs
import pytest
from pytest import approx

from fem import Elastic, MeshSize, SquirrelCage
from fem.assembly.elasticity import elastic_energy
from fem.assembly.factorisation import factorised, threads
from fem.mesh.solid import meshed

STEEL = Elastic(youngs_modulus=200e9, poisson_ratio=0.3)
RIGID = Elastic(youngs_modulus=200e12, poisson_ratio=0.3)

CAGE = SquirrelCage(
    raceway_diameter=96e-3,
    thickness=4e-3,
    width=6e-3,
    bars=24,
    bar_width=4e-3,
    bar_thickness=3e-3,
    bar_length=40e-3,
    flange_length=2e-3,
    elastic=STEEL,
)


@pytest.mark.slow
def test_radial_stiffness_of_slender_bars():
    with threads(2):
        mesh = meshed(CAGE, 4e-3, MeshSize(order=3, size=4e-3, raceway_size=4e-3))
        space = ngs.VectorH1(mesh, order=3, dirichlet="clamped")
        materials = {"ring": RIGID, "bars": STEEL, "flange": RIGID}
        stiffness = factorised(space, elastic_energy(mesh, materials))
        ring = mesh.Materials("ring")
        volume = ngs.Integrate(ngs.CF(1), mesh, definedon=ring)
        v = space.TestFunction()
        form = ngs.LinearForm(v[2] / volume * ngs.dx(definedon=ring)).Assemble()  # 1 N on the ring
        load = form.vec.FV().NumPy().copy()
        compliance = load @ stiffness.solve(load)  # mean displacement of the ring [m/N]
    assert 1e-3 / compliance == approx(11083, rel=0.01)
    assert 1e-3 / compliance == approx(24 * 200e3 * 4 * 3 * (4**2 + 3**2) / (2 * 40**3), rel=0.02)
