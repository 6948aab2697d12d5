"""Sjovall's radial integral and Stribeck's constants.

.. math:: J_r = \\frac{1}{2\\pi} \\int [1 - (1 - \\cos\\psi)/(2\\epsilon)]_+^n \\cos\\psi\\, d\\psi,\\quad
          F = Z Q_{max} J_r,\\quad \\epsilon = (1 - G/(2\\delta_r))/2

Source: the table printed in Harris, Rolling Bearing Analysis, and in makers' catalogues (line and point
contact); its numbers are met by n = 1.1 and 1.5, to one unit of the last digit once the row 1.67 is read
as 5/3. The columns for n = 10/9, the exponent of the load laws here, were computed independently, as were
the discrete constants Q_max Z / F without clearance.
"""

import numpy as np
import pytest
from pytest import approx
from scipy.integrate import quad

from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.contact.line import EXPONENT, iso16281
from quasidynamic.static import static_loads
from tests.deep_groove import LEVEL, deep_groove, solved
from tests.literature.steel_bearings import steel_bearing

# eps: line contact and point contact as printed, line contact with n = 10/9
TABLE = {
    0.1: (0.1268, 0.1156, 0.12641),
    0.2: (0.1737, 0.1590, 0.17317),
    0.3: (0.2055, 0.1892, 0.20496),
    0.4: (0.2286, 0.2117, 0.22804),
    0.5: (0.2453, 0.2288, 0.24480),
    0.6: (0.2568, 0.2416, 0.25636),
    0.7: (0.2636, 0.2505, 0.26324),
    0.8: (0.2658, 0.2559, 0.26549),
    0.9: (0.2628, 0.2576, 0.26266),
    1.0: (0.2523, 0.2546, 0.25253),
    1.25: (0.2078, 0.2289, 0.20867),
    1.67: (0.1589, 0.1871, 0.15951),
    2.5: (0.1075, 0.1339, 0.10831),
    5.0: (0.0544, 0.0711, 0.05490),
}
MANY = 1440  # rollers that stand for an integral


def meant(eps):
    """The row printed as 1.67 is 5/3."""
    return 5 / 3 if eps == 1.67 else eps


def radial_integral(eps, exponent):
    end = np.arccos(max(1 - 2 * eps, -1.0))
    value, _ = quad(lambda p: (1 - (1 - np.cos(p)) / (2 * eps)) ** exponent * np.cos(p), 0, end)
    return value / np.pi


@pytest.mark.parametrize("eps", TABLE, ids=str)
def test_printed_table_belongs_to_the_exponents_of_its_time(eps):
    line, point, _ = TABLE[eps]
    assert radial_integral(meant(eps), 1.1) == approx(line, abs=1.01e-4)
    assert radial_integral(meant(eps), 1.5) == approx(point, abs=1.01e-4)


@pytest.mark.parametrize("eps", TABLE, ids=str)
def test_many_rollers_share_the_load_as_the_integral_says(eps):
    """The load that the integral gives for 10 um at the deepest roller, with the clearance of eps."""
    printed, deepest, length = TABLE[eps][2], 10e-6, 10e-3
    shift = deepest / (2 * eps)
    bearing = steel_bearing(MANY, clearance=2 * shift * (1 - 2 * eps), contact_law="iso16281")
    largest = iso16281(length) * (deepest / 2) ** EXPONENT * length
    found = static_loads(bearing, printed * MANY * largest)
    rounding = 0.6e-5 / printed  # of the printed integral
    assert found.loads.max() == approx(largest, rel=rounding)
    assert found.ring_displacement == approx([0.0, shift], rel=rounding, abs=1e-14)
    assert radial_integral(eps, EXPONENT) == approx(printed, abs=0.6e-5)


@pytest.mark.parametrize("eps", TABLE, ids=str)
def test_many_balls_share_the_load_as_the_integral_says(eps):
    """The radial load of the printed integral, at rest, with the clearance of eps; negative beyond 0.5."""
    deepest, balls = 5e-6, 600
    shift = deepest / (2 * meant(eps))
    bearing = deep_groove(2 * shift * (1 - 2 * meant(eps)), balls=balls, ball=5e-3, pitch=1.0, groove=2.6e-3)
    largest = in_series(*race_contacts(bearing)) * deepest**1.5
    load = radial_integral(meant(eps), 1.5) * balls * largest
    found = solved(bearing, (0.0, 0.0, load, 0.0, 0.0), LEVEL)
    assert found.loads.max() == approx(largest, rel=1e-5)
    assert found.ring_displacement[2] == approx(shift, rel=1e-5)
    assert TABLE[eps][1] * balls * found.loads.max() == approx(load, rel=1.01e-4 / TABLE[eps][1])


# Z: Q_max Z / F with a roller on the load line, the same with the load between two rollers
STRIBECK = {
    9: (4.1114, 3.7888),
    10: (4.0880, 3.8598),
    12: (4.0828, 3.9323),
    14: (4.0860, 3.9700),
    18: (4.0855, 4.0155),
    30: (4.0851, 4.0600),
}


@pytest.mark.parametrize("law", ["palmgren", "iso16281"])
@pytest.mark.parametrize("rollers", STRIBECK, ids=str)
def test_discrete_constants_without_clearance(rollers, law):
    bearing, load = steel_bearing(rollers, contact_law=law), 2e4
    on, between = (static_loads(bearing, load, turn * np.pi / rollers) for turn in (0, 1))
    assert on.loads.max() * rollers / load == approx(STRIBECK[rollers][0], abs=1e-4)
    assert between.loads.max() * rollers / load == approx(STRIBECK[rollers][1], abs=1e-4)


FULL_ROW = (4.0850, 4.0766)  # with n = 10/9, and with the exponent 1.1 of the printed table


def test_constants_of_a_full_row_without_clearance():
    """And 4.3701 with the exponent of the printed table for point contact."""
    of_ten_ninths, of_table = FULL_ROW
    assert static_loads(steel_bearing(MANY), 1e6).loads.max() * MANY / 1e6 == approx(of_ten_ninths, abs=1e-4)
    assert 1 / radial_integral(0.5, 1.1) == approx(of_table, abs=1e-4)
    assert 1 / radial_integral(0.5, 1.5) == approx(4.3701, abs=1e-4)
