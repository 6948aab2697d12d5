"""Closed forms of stresses below Hertz contacts.

Sources: Johnson, Contact Mechanics (1985): sec. 4.2 for the line (largest shear stress 0.30 p0 at 0.786 b),
sec. 3.4 for the axis of the circle, with nu = 0.3 0.31 p0 at 0.48 a, sec. 7.1 for the sliding line of McEwen
(1949) and Smith and Liu (1953): 2 mu p0 of tension behind it, as much pressure ahead. Lundberg and Palmgren
(1947) for the orthogonal shear stress: line 0.25 at 0.5, circle 0.214 at 0.35. Line in plane strain,
nu = 0.3: von Mises 0.558 at 0.704, as textbooks of machine elements have it.
"""

from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse.subsurface import ellipse_stress, orthogonal_shear
from quasidynamic.contact.line.slices import line_contact_stress
from quasidynamic.outcome.subsurface import largest_von_mises

DEPTH = np.linspace(0.3, 1.0, 14001)
# largest stress over p0 and its depth over b or a
SHEAR = {"line": (0.300, 0.786), "circle": (0.310, 0.481)}
VON_MISES = {"line": (0.558, 0.704), "circle": (0.620, 0.481)}
ORTHOGONAL = {"line": (0.25, 0.5), "circle": (0.214, 0.35)}


def largest_on_the_axis(stress):
    shear = stress.principal_shear
    return shear.max(), DEPTH[shear.argmax()]


def test_largest_shear_stress_below_a_line():
    found = largest_on_the_axis(line_contact_stress(0.0, DEPTH, 0.3))
    assert found == approx(SHEAR["line"], rel=0, abs=6e-4)


def test_axis_of_a_line():
    stress, root = line_contact_stress(0.0, DEPTH, 0.3), np.sqrt(1 + DEPTH**2)
    assert stress.along == approx(2 * DEPTH - (1 + 2 * DEPTH**2) / root, rel=0, abs=1e-13)
    assert stress.normal == approx(-1 / root, rel=0, abs=1e-13)
    assert stress.shear == approx(0.0, rel=0, abs=1e-13)


def test_surface_behind_a_sliding_line_is_pulled():
    friction = 0.2  # traction on the body towards +x, in which what slides on it moves
    behind, ahead = (line_contact_stress(x, 1e-12, 0.3, friction).along for x in (-1.0, 1.0))
    assert behind == approx(2 * friction, rel=0, abs=1e-5)
    assert ahead == approx(-2 * friction, rel=0, abs=1e-5)


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
    found = largest_on_the_axis(ellipse_stress(0.0, DEPTH, 1.0, 0.3))
    assert found == approx(SHEAR["circle"], rel=0, abs=6e-4)


def test_von_mises_stress_below_line_and_circle():
    line = largest_von_mises(partial(line_contact_stress, poisson_ratio=0.3))
    circle = largest_von_mises(partial(ellipse_stress, axis_ratio=1.0, poisson_ratio=0.3))
    assert line == approx(VON_MISES["line"], rel=0, abs=6e-4)
    assert circle == approx(VON_MISES["circle"], rel=0, abs=6e-4)


@pytest.mark.parametrize(("axis_ratio", "printed"), list(zip((0.0, 1.0), ORTHOGONAL.values(), strict=True)))
def test_orthogonal_shear_stress(axis_ratio, printed):
    amplitude, depth = orthogonal_shear(1.0, 1.0, axis_ratio)
    assert (amplitude, depth) == approx(printed, rel=0, abs=1e-3)
