"""The half-space under a roller's patch."""

import numpy as np
import pytest
from numpy.polynomial import legendre
from pytest import approx

from fem import Elastic, Patches
from fem.half_space.load_patch import half_space, kernel

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
L = 5e-3


def patches(width, shapes=3):
    return Patches(azimuths=(0.0,), length=L, axial_modes=shapes, width=width)


@pytest.mark.parametrize("s", [1e-6, 1e-4, 3e-3])
def test_two_uniform_lines_at_a_distance(s):
    closed = 2 * (L * np.arcsinh(L / s) - np.hypot(L, s) + s) / L**2
    assert kernel(np.array([s]), L, 1)[0, 0, 0] == approx(closed, rel=1e-12)


def test_shapes_against_brute_force():
    """Product Gauss rule at a distance where the kernel is smooth."""
    s, x, w = 4e-3, *legendre.leggauss(60)
    a = legendre.legvander(x, 2) * (2 * np.arange(3) + 1) / L  # (2m + 1)/l L_m
    distance = np.hypot(s, (x[:, None] - x) * L / 2)
    brute = np.einsum("pm,qn,p,q,pq->mn", a, a, w * L / 2, w * L / 2, 1 / distance)
    assert kernel(np.array([s]), L, 3)[0] == approx(brute, rel=1e-10, abs=1e-12 * brute.max())


def test_indentation_under_a_narrow_uniform_patch():
    r"""With E[ln|s|] = ln(width sqrt 2) - (gamma + ln 2)/2 of a Gaussian, and l far above the width."""
    width = 1e-6
    mean_log = np.log(np.sqrt(2) * width) - (np.euler_gamma + np.log(2)) / 2
    expected = (1 - 0.28**2) / (np.pi * 203e9) * 2 / L * (np.log(2 * L) - mean_log - 1)
    assert half_space(patches(width), STEEL)[0, 0] == approx(expected, rel=1e-3)


def test_indentation_is_symmetric_and_positive():
    matrix = half_space(patches(0.5e-3, shapes=5), STEEL)
    assert matrix == approx(matrix.T, abs=1e-15 * matrix.max())
    assert np.linalg.eigvalsh(matrix).min() > 0


def test_indentation_falls_with_stiffness():
    stiff = Elastic(youngs_modulus=2 * 203e9, poisson_ratio=0.28)
    assert half_space(patches(1e-3), stiff) == approx(half_space(patches(1e-3), STEEL) / 2, rel=1e-12)
