"""Lundberg-Palmgren life of the paper's bearing, re-solved independently with b_m = 1.1."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.outcome.life import basic_life, raceway_capacity
from tests.bearings import paper_bearing


def test_capacities():
    """552-form with gamma 0.07145, Z 30, D = l = 5 mm: 2580.5 and 3119.1 N."""
    inner, outer = raceway_capacity(paper_bearing().bearing)
    assert inner == approx(2580.5, rel=1e-3)
    assert outer == approx(3119.1, rel=1e-3)


@pytest.mark.parametrize(
    ("clearance", "life"), [(50e-6, 1.831), (75e-6, 1.517)], ids=["11 loaded", "9 loaded"]
)
def test_life_of_the_rigid_bearing(clearance, life):
    """Static loads, ISO capacities: 1.831 and 1.517 10^6 revolutions; the 552-form is 0.5 % stronger."""
    assert paper_bearing(clearance=clearance).solve().life == approx(life, rel=0.04)


def test_uniform_slices_give_the_life_of_the_whole_roller():
    rng = np.random.default_rng(4)
    whole = np.array([rng.uniform(100, 3000, 30), rng.uniform(100, 3000, 30)])
    bearing = paper_bearing().bearing
    for count in (1, 20, 60):
        sliced = np.repeat(whole[:, :, None] / count, count, axis=2)
        assert basic_life(*sliced, bearing, (True, False)) == approx(
            basic_life(*whole[:, :, None], bearing, (True, False)), rel=1e-12
        )


def test_life_falls_with_the_power_of_ten_thirds_nearly():
    """Exponents 4 and 4.5 on slices, 9/8 Weibull: doubling all loads costs 2^4."""
    loads = np.full((30, 20), 50.0)
    bearing = paper_bearing().bearing
    assert basic_life(loads, loads, bearing, (True, False)) / basic_life(
        2 * loads, 2 * loads, bearing, (True, False)
    ) == approx(2.0**4, rel=1e-12)


def test_unloaded_bearing_lives_for_ever():
    none = np.zeros((30, 20))
    assert basic_life(none, none, paper_bearing().bearing, (True, False)) == float("inf")
