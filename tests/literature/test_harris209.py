"""The 209 cylindrical roller bearing of Harris, Rolling Bearing Analysis: how 14 rollers share 4450 N.

Inputs as in the textbook: raceways 54.991 and 75.032 mm, rollers of 10 x 9.601 mm, 41 um of clearance.
Source of the outputs: independent solutions of the same equations, Q in N at 0, 25.7 and 51.4 degrees. The
textbook's largest load, about 1915 N, belongs to Sjovall's integral, here within 0.8 %; rollers one by one
give 2 % more.
"""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.static import static_loads
from tests.literature.steel_bearings import PALMGREN_STEEL, material_of, steel_bearing

LOAD, CLEARANCE = 4450.0, 0.041e-3
TEXTBOOK_LARGEST, RE_SOLVED_LARGEST = 1915.0, 1928.7  # [N] by the integral
PER_CONTACT = material_of(8.05e4**-0.9)  # Q = 8.05e4 l^(8/9) delta^(10/9) (N, mm) at one raceway


def harris(clearance=CLEARANCE, rollers=14, **changes):
    raceway = 75.032e-3 * max(1.0, rollers / 14)
    return steel_bearing(rollers, clearance, outer_raceway=raceway, length=9.601e-3, **changes)


# contact, shift of the ring [mm], load zone parameter, half of the load zone [deg], loads [N]
ROWS = {
    "8.05e4 per contact": ({"material": PER_CONTACT}, 0.03210, 0.1807, 50.31, (1967.0, 1378.0, 0.0)),
    "Palmgren": ({"material": PALMGREN_STEEL}, 0.03209, 0.1806, 50.29, (1967.3, 1377.8, 0.0)),
    "ISO/TS 16281": ({"contact_law": "iso16281"}, 0.03243, 0.1840, 50.80, (1958.7, 1382.6, 0.0)),
}


@pytest.mark.parametrize(("contact", "shift", "zone", "angle", "loads"), ROWS.values(), ids=ROWS.keys())
def test_loads_of_single_rollers(contact, shift, zone, angle, loads):
    found = static_loads(harris(**contact), LOAD)
    along = found.ring_displacement[1]
    assert along * 1e3 == approx(shift, abs=0.6e-5)
    assert (1 - CLEARANCE / (2 * along)) / 2 == approx(zone, abs=0.6e-4)
    assert np.degrees(np.arccos(CLEARANCE / (2 * along))) == approx(angle, abs=0.011)
    assert found.loads[:3] == approx(loads, abs=0.06)
    assert found.loads[-1:-3:-1] == approx(loads[1:], abs=0.06)
    assert found.loads[3:-2] == approx(np.zeros(9), abs=1e-3)


def test_sjovall_integral():
    """A full row of many rollers, each with the same share of the load."""
    many = 100
    found = static_loads(harris(rollers=14 * many, material=PER_CONTACT), many * LOAD)
    along = found.ring_displacement[1]
    assert along * 1e3 == approx(0.03189, abs=0.6e-5)
    assert (1 - CLEARANCE / (2 * along)) / 2 == approx(0.1786, abs=0.6e-4)
    assert found.loads.max() == approx(RE_SOLVED_LARGEST, abs=0.1)
    assert found.loads.max() == approx(TEXTBOOK_LARGEST, rel=0.008)


def test_no_clearance():
    found = static_loads(harris(clearance=0.0, material=PER_CONTACT), LOAD)
    assert found.ring_displacement * 1e3 == approx([0.0, 0.00798], abs=0.6e-5)
    assert found.loads[:4] == approx([1298.8, 1156.7, 768.4, 244.6], abs=0.06)
