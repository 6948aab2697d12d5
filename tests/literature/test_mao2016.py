"""Mao, Wang and Zhang (2016), Appl. Sci. 6, 415: the rigid bearing.

The paper states a clearance of 0.05 mm, with which its own load law gives 3301 N and 11 loaded
rollers; its 3537 N and 9 rollers need an operating clearance of 75 to 76 um.
"""

import pytest
from pytest import approx

from tests.bearings import paper_bearing


@pytest.mark.parametrize(
    ("clearance", "largest", "tolerance", "loaded"),
    [(75.5e-6, 3537.0, 0.01, 9), (50e-6, 3301.0, 0.015, 11)],
    ids=["operating clearance that closes", "stated clearance"],
)
def test_rigid_load_distribution(clearance, largest, tolerance, loaded):
    loads = paper_bearing(clearance=clearance).solve().forces[0, :, 0]
    assert loads.max() == approx(largest, rel=tolerance)
    assert (loads > 1.0).sum() == loaded


def test_loads_fall_with_preload_at_the_rate_of_an_independent_program():
    """dQmax/dG = 7.9 N/um around the operating clearance."""
    low, high = (paper_bearing(clearance=g).solve().forces[0, :, 0].max() for g in (74.5e-6, 76.5e-6))
    assert (high - low) / 2 == approx(7.9, rel=0.05)


def test_tangent_stiffness():
    """An independent implementation finds 770 kN/mm."""
    assert paper_bearing().solve().tangent.radial_stiffness == approx(770e6, rel=0.01)


def test_centrifugal_force_of_a_roller():
    """92 N at 38 000 rpm without slip."""
    state = paper_bearing().solve()
    roller, rolling = state.balance.roller.bearing.roller, state.balance.rolling_cage[0, 0]
    assert roller.mass * 35e-3 * rolling**2 == approx(92.0, abs=0.3)
