"""Rings as curved beams, and bars that hold them: handbook formulas, plane elasticity, solids."""

import numpy as np
import pytest
from pytest import approx

from fem import Elastic
from fem.beam.curved_beam import CurvedBeam, twist_constant
from fem.beam.support_springs import slide
from fem.beam.thin_ring import U, W
from tests.literature.test_rings import MICHELL

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
PLAIN = Elastic(youngs_modulus=200e9, poisson_ratio=0.3)


def ring(radius, thickness, width, elastic):
    return CurvedBeam(
        inside=radius - thickness / 2, outside=radius + thickness / 2, width=width, elastic=elastic
    )


def answer(beam, harmonics, motion):
    """Compliance [m/N] per radian of one motion."""
    return np.linalg.inv(beam.stiffness(harmonics))[:, motion, motion]


def diameters(beam, force):
    """Change along two opposite inward forces and across them [m]."""
    n = np.arange(2, 20_000, 2)
    even = answer(beam, n, W) * 2 / np.pi
    mean = 1 / beam.stiffness([0])[0, W, W] / np.pi
    return -2 * force * (mean + even.sum()), -2 * force * (mean + even @ np.cos(n * np.pi / 2))


def test_pinched_ring_is_that_of_the_handbook():
    """R 0.1 m, 5 x 10 mm, 10 N: Roark table 9.2 case 1 with shear and extension; a frame gives 71.7327 um."""
    along, across = diameters(ring(0.1, 5e-3, 10e-3, PLAIN), 10.0)
    assert along == approx(-71.7074e-6, rel=1e-3)
    assert across == approx(65.656e-6, rel=1e-3)


def test_pinched_wide_ring_is_nearly_that_in_space():
    """82.2/75 x 10 mm, 1 kN on opposite lines: two codes give 1.15124 and -1.04936 mm inside."""
    along, across = diameters(ring(39.3e-3, 3.6e-3, 10e-3, STEEL), 1e3)
    assert (along, across) == approx((-1.15124e-3, 1.04936e-3), rel=0.01)


@pytest.mark.parametrize(("n", "exact"), MICHELL.items())
def test_ring_under_a_cosine_pressure_is_nearly_that_of_plane_elasticity(n, exact):
    """0.1 MPa outside; mean of the displacements of both surfaces [um]. Waves of n = 4 are 17 walls long."""
    beam = ring(39.3e-3, 3.6e-3, 1.0, STEEL)
    found = -0.1e6 * beam.outside * beam.width * answer(beam, [n], W)[0]
    assert 1e6 * found == approx((exact[0] + exact[1]) / 2, rel=0.01)


def test_ring_with_four_alternating_axial_loads():
    """R 0.1 m, 10 x 10 mm, 100 N: beam theory 118.967 um, tetrahedra of order 4 118.985 um."""
    n = np.arange(2, 20_000, 4)
    moved = 4 * 100.0 / np.pi * answer(ring(0.1, 10e-3, 10e-3, PLAIN), n, U).sum()
    assert moved == approx(118.985e-6, rel=2e-3)


def test_torsion_constant_of_a_square():
    """Timoshenko and Goodier, sec. 109: 0.1406 of the fourth power; 0.140577 to six digits."""
    assert twist_constant(2e-3, 2e-3) == approx(0.140577 * (2e-3) ** 4, rel=1e-5)
    assert twist_constant(1.0, 1e-3) == approx(1e-9 / 3, rel=1e-3)


@pytest.mark.parametrize(
    ("number", "width", "height", "length", "found"),
    [(24, 4e-3, 3e-3, 40e-3, 10935.7e3), (16, 5e-3, 4e-3, 60e-3, 5946.5e3)],
)
def test_bars_hold_a_rigid_ring_as_a_frame_of_timoshenko_beams(number, width, height, length, found):
    """The frame's ring may tilt, which is less than 0.4 %."""
    one = sum(1 / slide(length, *sides, PLAIN) for sides in ((width, height), (height, width)))
    assert number / 2 * one == approx(found, rel=4e-3)
