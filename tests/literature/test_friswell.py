"""Stiffness of cylindrical roller bearings by the formula of Friswell et al.

Source: Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), pp. 182-185, as documented by
the rotor program ROSS (RollerBearingElement): k = 1e9 n^0.9 l^0.8 f^0.1 cos(alpha)^1.9 along the load and
0.49, 0.66, 0.74 of it across for 8, 12, 16 rollers. Tangents of Palmgren's law on both raceways without
clearance, a roller on the load line, l = 30 mm and f = 500 N, were computed independently; that
programme's 0.498, 0.645, 0.715 across the load contain the rollers at right angles to it, which just touch
and whose stiffness ~ approach^(1/9) makes something of a rounding error. Without them the sums over the
loaded rollers give 0.490, 0.640, 0.711.
"""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.static import static_loads
from tests.literature.steel_bearings import PALMGREN_STEEL, steel_bearing

LENGTH, LOAD = 30e-3, 500.0
GAP = 20e-9  # [m] enough to keep the rollers across the load from touching
# rollers: tangent stiffness [N/m], anisotropy of Palmgren's law; anisotropy of the formula
PRINTED = {
    8: (7.507e8, 0.498, 0.49),
    12: (1.080e9, 0.645, 0.66),
    16: (1.399e9, 0.715, 0.74),
}


def friswell(rollers, cosine=1.0):
    return 1e9 * rollers**0.9 * LENGTH**0.8 * LOAD**0.1 * cosine**1.9


@pytest.fixture(params=PRINTED, ids=str)
def rollers(request):
    return request.param


@pytest.fixture
def stiffness(rollers):
    return static_loads(steel_bearing(rollers, GAP, length=LENGTH, material=PALMGREN_STEEL), LOAD).stiffness


def test_tangent_along_the_load(stiffness, rollers):
    assert stiffness[1, 1] == approx(PRINTED[rollers][0], rel=5e-4)
    assert stiffness[1, 1] == approx(friswell(rollers), rel=0.05)


def test_anisotropy(stiffness, rollers):
    across = stiffness[0, 0] / stiffness[1, 1]
    angle = 2 * np.pi * np.arange(-((rollers - 1) // 4), (rollers - 1) // 4 + 1) / rollers
    loaded = np.cos(angle) ** (1 / 9)
    assert across == approx(loaded @ np.sin(angle) ** 2 / (loaded @ np.cos(angle) ** 2), rel=5e-3)
    assert across == approx(PRINTED[rollers][1], rel=0.02)
    assert across == approx(PRINTED[rollers][2], rel=0.05)
    assert stiffness[0, 1] == approx(0.0, abs=1e-9 * stiffness[1, 1])


def test_formula_is_the_documented_one():
    assert friswell(8, 0.75**0.5) == approx(5.56779444e8, rel=1e-8)
