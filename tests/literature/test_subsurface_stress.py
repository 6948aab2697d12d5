"""Closed forms of stresses below Hertz contacts.

Sources: Johnson, Contact Mechanics (1985): sec. 4.2 for the line (largest shear stress 0.30 p0 at 0.786 b),
sec. 3.4 for the axis of the circle, with nu = 0.3 0.31 p0 at 0.48 a. Lundberg and Palmgren (1947) for the
orthogonal shear stress: line 0.25 at 0.5, circle 0.214 at 0.35. Line in plane strain, nu = 0.3: von Mises
0.558 at 0.704, as textbooks of machine elements have it.
"""

from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse.subsurface import ellipse_stress, orthogonal_shear
from quasidynamic.contact.line.subsurface import line_contact_stress
from quasidynamic.outcome.subsurface import largest_von_mises

DEPTH = np.linspace(0.3, 1.0, 14001)


def largest_on_the_axis(stress):
    shear = stress.principal_shear
    return DEPTH[shear.argmax()], shear.max()


def test_largest_shear_stress_below_a_line():
    depth, shear = largest_on_the_axis(line_contact_stress(0.0, DEPTH, 0.3))
    assert (depth, shear) == approx((0.786, 0.300), rel=0, abs=6e-4)


def test_axis_of_a_line():
    stress, root = line_contact_stress(0.0, DEPTH, 0.3), np.sqrt(1 + DEPTH**2)
    assert stress.along == approx(2 * DEPTH - (1 + 2 * DEPTH**2) / root, rel=0, abs=1e-13)
    assert stress.normal == approx(-1 / root, rel=0, abs=1e-13)
    assert stress.shear == approx(0.0, rel=0, abs=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize("poisson_ratio", [0.0, 0.26, 0.3])
def test_axis_of_a_circle(poisson_ratio):
    stress = ellipse_stress(0.0, DEPTH, 1.0, poisson_ratio)
    normal = -1 / (1 + DEPTH**2)
    radial = -(1 + poisson_ratio) * (1 - DEPTH * np.arctan(1 / DEPTH)) - normal / 2
    assert stress.normal == approx(normal, rel=0, abs=1e-13)
    assert stress.along == approx(radial, rel=0, abs=1e-13)
    assert stress.across == approx(radial, rel=0, abs=1e-13)


def test_largest_shear_stress_below_a_circle():
    depth, shear = largest_on_the_axis(ellipse_stress(0.0, DEPTH, 1.0, 0.3))
    assert (depth, shear) == approx((0.481, 0.310), rel=0, abs=6e-4)


def test_von_mises_stress_below_line_and_circle():
    line = largest_von_mises(partial(line_contact_stress, poisson_ratio=0.3))
    circle = largest_von_mises(partial(ellipse_stress, axis_ratio=1.0, poisson_ratio=0.3))
    assert line == approx((0.558, 0.704), rel=0, abs=6e-4)
    assert circle == approx((0.620, 0.481), rel=0, abs=6e-4)


@pytest.mark.parametrize(("axis_ratio", "printed"), [(0.0, (0.25, 0.5)), (1.0, (0.214, 0.35))])
def test_orthogonal_shear_stress(axis_ratio, printed):
    amplitude, depth = orthogonal_shear(1.0, 1.0, axis_ratio)
    assert (amplitude, depth) == approx(printed, rel=0, abs=1e-3)
