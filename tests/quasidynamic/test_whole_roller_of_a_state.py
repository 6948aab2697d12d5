"""The most loaded roller of a bearing on half-spaces, beside its slices."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Crowned, Logarithmic, Straight
from quasidynamic.outcome.life import basic_life
from quasidynamic.outcome.whole_roller import whole_roller
from tests.bearings import paper_bearing

LOGARITHMIC = Logarithmic(amplitude=1.75e-6)
MODERATE = {"load": 4000.0, "speed": 100.0, "profile": LOGARITHMIC}


@pytest.fixture(scope="module")
def tilted():
    return paper_bearing(**MODERATE, misalignment=6e-4).solve()


@pytest.fixture(scope="module")
def whole(tilted):
    return whole_roller(tilted)


def test_whole_roller_carries_the_load_of_its_slices_at_their_tilt_where_that_is_held(tilted, whole):
    assert whole.number == np.argmax(tilted.loads[0])
    for race, contact in enumerate(whole.contacts):
        assert contact.contact.force == approx(tilted.loads[race, whole.number], rel=1e-6)
    assert whole.tilt.sum() == approx(6e-4, rel=1e-6)  # of both raceways against the roller
    assert whole.tilt[0] == approx(whole.tilt[1], rel=0.02)
    inner, outer = (contact.moment for contact in whole.contacts)
    assert inner == approx(outer, rel=0.06)
    length = tilted.balance.roller.bearing.roller.length
    assert inner > 1.05 * tilted.forces[0, whole.number, 1] * length / 2  # stiffer than the slices


@pytest.mark.slow
def test_whole_roller_carries_load_and_moment_of_its_slices_below_a_ring_that_tilts_freely():
    state = paper_bearing(**MODERATE, moment=10.0).solve()
    whole = whole_roller(state)
    length = state.balance.roller.bearing.roller.length
    for race, contact in enumerate(whole.contacts):
        assert contact.contact.force == approx(state.loads[race, whole.number], rel=1e-6)
        assert contact.moment == approx(state.forces[race, whole.number, 1] * length / 2, rel=1e-5)
    assert abs(whole.contacts[0].moment) > 0.02 * whole.contacts[0].contact.force * length


def test_only_one_roller_leaves_its_slices(tilted, whole):
    changed = np.abs(whole.slice_loads - tilted.slice_loads).max(axis=-1) > 0
    assert changed.sum(axis=-1).tolist() == [1, 1]
    width = tilted.balance.roller.raceways.slices.width
    assert whole.slice_loads.sum(axis=-1) * width == approx(tilted.loads, rel=1e-6, abs=1e-6)


def test_life_is_that_of_the_lamina_formula(tilted, whole):
    inner, outer = whole.slice_loads * tilted.balance.roller.raceways.slices.width
    bearing = tilted.balance.roller.bearing
    assert whole.life == approx(basic_life(inner, outer, bearing, tilted.turning), rel=1e-12)
    assert np.sum(whole.raceway_lives ** (-9 / 8)) == approx(whole.life ** (-9 / 8), rel=1e-12)
    assert whole.life == approx(tilted.life, rel=0.2)


def test_aligned_profiled_roller_presses_like_its_slices():
    state = paper_bearing(**MODERATE).solve()
    whole = whole_roller(state)
    assert whole.peak_pressure == approx(state.peak_pressure, rel=0.05)
    assert np.abs(whole.tilt).max() < 1e-9
    assert not whole.at_ends
    assert np.all(whole.pressure_error < 5e-3 * whole.peak_pressure)


def test_straight_roller_has_ends_that_slices_do_not_see():
    state = paper_bearing(**{**MODERATE, "profile": Straight()}).solve()
    whole = whole_roller(state)
    assert whole.at_ends
    assert np.all(whole.slice_loads[:, whole.number, -1] > 1.5 * state.slice_loads[:, whole.number, -1])
    assert whole.life < state.life


def test_deflection_of_a_raceway_moves_pressure_along_the_whole_roller():
    """An outward bulge in the middle of the outer raceway, of the shape L_2, unloads mid-roller."""
    bearing = paper_bearing(**{**MODERATE, "profile": Crowned(straight_length=4e-3, crown_radius=0.6)})
    flat = whole_roller(bearing.solve())
    deviation = np.zeros((2, bearing.bearing.rollers, 3))
    deviation[1, :, 2] = -1e-6
    bent_bearing = paper_bearing(
        **{**MODERATE, "profile": Crowned(straight_length=4e-3, crown_radius=0.6)}, axial_modes=3
    )
    bent = whole_roller(bent_bearing.solve(deviation=deviation))
    middle = len(flat.positions) // 2
    share = bent.line_load[:, middle] / flat.line_load[:, middle]
    assert share[0] == approx(1.0, abs=0.02)
    assert share[1] < 0.97


def test_fields_integrate_to_the_line_load(whole):
    spacing = np.diff(whole.across, axis=1)[:, :1]
    assert whole.pressure.sum(axis=1) * spacing == approx(whole.line_load, rel=1e-12)
    assert whole.positions[0] == approx(-whole.positions[-1], rel=1e-12)
