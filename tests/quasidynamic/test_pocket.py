"""Rollers in the pockets of the cage."""

import numpy as np
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.contact.cage import roller_on_pocket_force
from quasidynamic.contact.line import palmgren
from quasidynamic.parts.material import Material

CLEARANCE = 0.1e-3  # [m]
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
STOP = palmgren(STEEL, STEEL, 5e-3) * 5e-3


def pocket(displacement):
    return roller_on_pocket_force(np.array(displacement), CLEARANCE, STOP)


def test_film_carries_eleven_thirds_of_a_newton_at_the_wall():
    """K = 11 / (3 C_p) [N/m]."""
    assert pocket(CLEARANCE).force == approx(11 / 3, rel=1e-12)
    assert pocket(0.3 * CLEARANCE).force == approx(0.3 * 11 / 3, rel=1e-12)
    assert pocket(0.3 * CLEARANCE).by_displacement == approx(11 / (3 * CLEARANCE), rel=1e-12)


def test_wall_is_a_line_contact():
    """What the force gains behind the clearance is Palmgren's load."""
    depth = 2e-6
    wall = pocket(CLEARANCE + depth).force - 11 / 3 * (1 + depth / CLEARANCE)
    assert wall == approx(STOP * depth ** (10 / 9), rel=1e-3)


@given(st.floats(-3e-4, 3e-4))
def test_pocket_force_is_odd_and_pushes_back(displacement):
    there, back = pocket(displacement), pocket(-displacement)
    assert back.force == -there.force
    assert back.by_displacement == there.by_displacement > 0
    assert there.force * displacement >= 0


@given(st.floats(-3e-4, 3e-4).filter(lambda z: abs(abs(z) - CLEARANCE) > 1e-9))
def test_stiffness_of_the_pocket(displacement):
    step = 1e-12
    rise = (pocket(displacement + step).force - pocket(displacement - step).force) / (2 * step)
    assert pocket(displacement).by_displacement == approx(rise, rel=1e-4, abs=1.0)


def test_stiffness_has_no_jump_at_the_wall():
    """It rises by K 10/9 depth^(1/9): to nothing as the depth does, however slowly."""
    film = pocket(0.0).by_displacement
    jump = [float(pocket(CLEARANCE * (1 + part)).by_displacement - film) for part in (0.0, 1e-9, 1e-3)]
    assert jump[0] == 0.0
    assert jump[1] / jump[2] == approx(10 ** (-6 / 9), rel=1e-5)
