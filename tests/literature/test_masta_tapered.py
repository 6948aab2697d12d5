"""Capacities and a_ISO of a tapered roller bearing, as MASTA prints them.

HR30306J under 30 kN and 9 kN at 1500 rpm in 40 slices, in the manual of a public program that compares itself
(CHOICHOI-KIMM/AI_Seminar, CRB-main/Manual/10_FatigueLife.md, section 10.13; sizes from chapter 13).
"""

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq

from quasidynamic.outcome.life import slice_damages, slice_reference_loads
from quasidynamic.outcome.life_factors import modification_factor, modification_of_parts
from quasidynamic.outcome.raceway_damage import LINE
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT
from quasidynamic.outcome.tapered_life import InclinedRow
from quasidynamic.parts.roller_bearing import Roller
from tests.literature.steel_bearings import STEEL

ANGLE, RATING, SLICES = np.radians(11.859), 59.5e3, 40
LENGTH = 11.65e-3 * np.cos(ANGLE)
ROW = InclinedRow(14, Roller(diameter=10.53e-3, length=LENGTH, material=STEEL), 51.0e-3, ANGLE)
LOADS = np.array([8487, 7757, 5773, 3175, 949, 0, 0, 0, 0, 0, 949, 3175, 5773, 7757])  # [N] of each roller
LIFE, A_ISO, KAPPA, FATIGUE_SHARE = 19.43, 1.154, 3.413, 0.8174 * 7.317e3  # Mrev, ..., N
PLACES = (np.arange(SLICES) + 0.5) / SLICES * 2 - 1
SHAPES = {"tilted": PLACES, "crowned": -(PLACES**2)}  # along the roller, which is not printed


def damages(along):
    loads = LOADS[:, None] * along / along.sum()
    return slice_damages(loads, loads, ROW.raceway_capacity(RATING), (1.0, 0.0))


def life(along):
    return damages(along).sum() ** (-1 / LINE.weibull)


def test_capacities():
    assert ROW.raceway_capacity(RATING) == approx((14.16e3, 24.20e3), rel=7e-3)


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_a_iso_of_slices_at_the_printed_life(shape):
    """As uneven along the rollers as the printed life requires; the shape changes a_ISO by 4 %."""
    along = 1 + brentq(lambda uneven: life(1 + uneven * shape) - LIFE, 0, 0.99) * shape
    each = damages(along)
    loads = slice_reference_loads(each, ROW.raceway_capacity(RATING), ROW.rollers, ANGLE)
    found = modification_of_parts(KAPPA, FATIGUE_SHARE, loads, each.sum(axis=0)).value
    assert found == approx(A_ISO, rel=0.08)
    once = modification_factor(KAPPA, FATIGUE_SHARE / (RATING * LIFE ** (-1 / ROLLER_EXPONENT))).value
    assert once > 1.3 * A_ISO
