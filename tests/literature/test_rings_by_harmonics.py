"""Free and supported rings by azimuthal harmonics: plane elasticity, beam theory, two independent codes."""

from dataclasses import replace

import ngsolve as ngs
import numpy as np
import pytest
from pytest import approx

from fem import Elastic, LineForce, LineSupports, MeshSize, OuterRing, PlanetGear
from fem.mesh.axial_section import AxialSection
from fem.section.revolved_body import assembled
from fem.section.ring_on_lines import RingOnLines
from tests.fem.condensed import by_harmonics
from tests.literature.test_rings import MICHELL, OUTSIDE, plane_ring, polar, solved

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
FAIR = MeshSize(order=5, size=4e-3, raceway_size=1.25e-3)
MIDDLE = np.array([1, 0, -1 / 2, 0, 3 / 8, 0, -5 / 16])  # L_m(0): from the shapes to mid-width
PINCHED = PlanetGear(
    forces=tuple(LineForce(azimuth=phi, radial=-1.0, tangential=0.0) for phi in (0.0, np.pi))
)


def ring(support, width, inner=37.5e-3, thickness=3.6e-3, elastic=STEEL):
    return OuterRing(
        raceway_diameter=2 * inner, thickness=thickness, width=width, elastic=elastic, support=support
    )


def inner_diameters(pinched):
    """Change along the two forces and across them, at mid-width."""
    rim = by_harmonics(pinched, pinched.width, MIDDLE.size, FAIR)
    return 2 * rim.at([0.0, np.pi / 2]).initial_deviation @ MIDDLE


@pytest.fixture(scope="module")
def thin():
    """So narrow that it is in plane stress."""
    return by_harmonics(ring(PINCHED, 0.5e-3), 0.5e-3, 1, FAIR).ring


@pytest.mark.slow
def test_pinched_ring_is_that_of_two_other_codes():
    """82.2/75 x 10 mm, 1 kN inward on two opposite lines: both codes agree to 1e-5."""
    assert 1e6 * inner_diameters(ring(PINCHED, 10e-3)) == approx([-1.15124, 1.04936], rel=2e-5)


def test_pinched_narrow_ring_is_that_of_plane_elasticity(thin):
    """10 N/mm on two points outside: exact in plane stress, 58 harmonics."""
    answers = thin.under_radial(np.array([0.0, np.pi / 2]), np.array([0.0, np.pi]))[:, 0, :, 0].sum(axis=1)
    assert -2 * 5.0 * 1e3 * answers == approx([-0.115690, 0.105326], rel=2e-4)


SLENDER = {  # [m] half of the diameter change along the forces, and across them
    "femorph-solver, beams": (3.57e-5, None),
    "Roark, shear and extension": (3.58537e-5, 3.2828e-5),
}


def slender():
    steel = Elastic(youngs_modulus=200e9, poisson_ratio=0.3)
    along, across = 10 / 2 * inner_diameters(ring(PINCHED, 10e-3, 97.5e-3, 5e-3, steel))
    return -along, across


@pytest.mark.slow
def test_pinched_slender_ring_is_that_of_a_beam_program():
    """R 100 mm, 5 x 10 mm, 10 N: femorph-solver prints 3.57e-5 m for half of the diameter change.

    Roark's formula with shear and extension gives 3.585e-5 m along and 3.283e-5 m across the forces.
    """
    found = slender()
    assert found[0] == approx(SLENDER["femorph-solver, beams"][0], rel=5e-3)
    assert found == approx(SLENDER["Roark, shear and extension"], rel=2e-3)


@pytest.mark.parametrize("n", MICHELL)
def test_outer_pressure_moves_a_free_ring_as_michell_says(thin, n):
    """0.1 MPa cos(n phi) inward outside: radial motion inside and outside, tangential motion outside."""
    inner, outer, _, _ = (1e-6 * value for value in MICHELL[n])
    force = -0.1e6 * 0.5e-3 * OUTSIDE * 1e-3 * 2 * np.pi  # amplitude per harmonic, as it stands under W_n
    assert force * thin.radial[n, 0, 0] == approx(inner, rel=1e-4)
    assert force * np.real(thin.lines.response[thin.lines.harmonics == n, 0, 0]) == approx(outer, rel=1e-4)


def test_tangential_forces_bend_a_ring_as_in_the_plane(thin):
    """0.1 MPa (cos 2 phi + cos 3 phi) anticlockwise outside: radial motion inside."""
    places, lines = np.array([0.35, 0.8, 2.2]), 2 * np.pi * np.arange(16) / 16
    theta, along = ngs.atan2(ngs.y, ngs.x), ngs.CF((-ngs.y, ngs.x)) / ngs.sqrt(ngs.x**2 + ngs.y**2)
    pull = 0.1 * (ngs.cos(2 * theta) + ngs.cos(3 * theta)) * along
    mesh = plane_ring(order=4, size=1.8)
    shift = solved(mesh, 4, lambda v: ngs.InnerProduct(pull, v) * ngs.ds("outer", bonus_intorder=8))
    plane = [polar(shift, mesh, 37.5, angle)[0] for angle in places]
    forces = 0.1e6 * (np.cos(2 * lines) + np.cos(3 * lines)) * 0.5e-3 * OUTSIDE * 1e-3 * 2 * np.pi / 16
    few = replace(thin, tangential=thin.tangential[:8])  # lines stand for the spread forces up to there
    found = 1e3 * few.under_tangential(places, lines)[:, 0] @ forces
    assert found == approx(plane, rel=0, abs=2e-4 * np.abs(plane).max())


BEAM_ON_SPRINGS = (752.284, 150.925, -28.916, -12.447, -3.161, -3.340, -3.778, -3.797, -3.778)  # [N]


def on_thirty_springs():
    """Forces [N] of springs of 1.5e5 N/mm under R 39.3, 3.6 x 5 mm, 1 kN outward at one of them."""
    lines = 2 * np.pi * np.arange(30) / 30
    support = LineSupports(azimuths=tuple(lines), stiffness=1.5e8)
    held = RingOnLines(by_harmonics(ring(support, 5e-3), 5e-3, 1, FAIR).ring, support)
    return held.line_forces([0.0], np.array([[1000.0]])).sum(axis=1)


def test_ring_on_thirty_springs_is_that_of_beam_theory():
    """Timoshenko's beam has no indentation; the solid ring meets line supports with it, less that of a
    half-space. So it differs by 0.6 % of the load.
    """
    forces = on_thirty_springs()
    assert forces[:9] == approx(BEAM_ON_SPRINGS, rel=0, abs=7)
    assert forces[:15:-1] == approx(forces[1:15], rel=0, abs=1e-8)


ALTERNATING = {"tetrahedra": 0.118985, "beams with shear": 0.118967}  # [mm]


def under_alternating_forces():
    """Motion [mm] under 100 N of a ring of R 100, 10 x 10 mm, E 200 GPa, nu 0.3."""
    half, inner, outer = 5e-3, 95e-3, 105e-3
    square = AxialSection("ring", (
        (-half, inner, "left"), (half, inner, "inside"), (half, outer, "right"), (-half, outer, "outside")
    ))  # fmt: skip
    steel = Elastic(youngs_modulus=200e9, poisson_ratio=0.3)
    body = assembled([square], {"ring": steel}, FAIR)
    v = body.space.TestFunction()
    left, right = (
        body.load(v[0] * ngs.ds(definedon=body.space.mesh.Boundaries(name))) / (1e3 * (outer - inner))
        for name in ("left", "right")
    )  # means over the end faces
    n = range(2, 120, 4)
    w = [4 * 100 / np.pi * right @ body.stiffness.solve(k, left[:, None])[:, 0] for k in n]
    return 1e3 * sum(w)


def test_ring_under_four_alternating_axial_forces():
    assert under_alternating_forces() == approx(ALTERNATING["tetrahedra"], rel=1e-3)
