"""A cage that floats in its land, rollers in pockets with clearance."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic import Cage, ImpossiblePart, NotSolved, solve_many
from quasidynamic.contact.cage import displacement_in_pocket, land_force, land_offset, roller_on_pocket_force
from tests.bearings import paper_bearing

MODEL = paper_bearing()
CAGE, OIL = MODEL.bearing.cage, MODEL.lubrication.oil
STOP = 1e9  # [N/m^(10/9)]


def floating(**changes):
    return paper_bearing(cage={"free": True, **changes})


@given(size=st.floats(1e-6, 1e3), angle=st.floats(0.0, 6.28), speed=st.sampled_from([-3e3, 50.0, 2e3]))
def test_land_carries_the_force_where_the_cage_is_put(size, angle, speed):
    force = size * np.array([[np.sin(angle), np.cos(angle)]])
    place = land_offset(force, speed, CAGE, OIL)
    assert land_force(place.offset, speed, CAGE, OIL).force == approx(force, rel=1e-8, abs=1e-9 * size)


@pytest.mark.parametrize("size", [1e-3, 0.1, 30.0])
def test_slopes_of_the_place(size):
    force, speed, step = np.array([[0.6 * size, -0.8 * size]]), 2e3, 1e-6
    place = land_offset(force, speed, CAGE, OIL)
    for k in (0, 1):
        change = np.zeros((1, 2))
        change[0, k] = step * size
        ahead, behind = (land_offset(force + s * change, speed, CAGE, OIL).offset for s in (1, -1))
        largest = np.abs(place.by_force).max()
        assert (ahead - behind) / (2 * step * size) == approx(place.by_force[..., k], abs=1e-6 * largest)
    ahead, behind = (land_offset(force, speed * (1 + s * step), CAGE, OIL).offset for s in (1, -1))
    largest = np.abs(place.by_speed).max()
    assert (ahead - behind) / (2 * step * speed) == approx(place.by_speed, abs=1e-6 * largest)


def test_a_land_under_a_light_force_is_nearly_centred_and_pushes_sideways():
    """Short bearing at small eccentricity: the force stands across the offset."""
    place = land_offset(np.array([[0.0, 1e-5]]), 2e3, CAGE, OIL).offset[0]
    assert np.hypot(*place) < 1e-2 * CAGE.land_clearance
    assert abs(place[1] / place[0]) < 1e-2


@pytest.mark.parametrize("guidance", ["outer", "inner"])
def test_land_pockets_weight_and_unbalance_balance_on_the_cage(guidance):
    diameter = {"outer": 74.6e-3, "inner": 65.4e-3}[guidance]
    model = floating(guidance=guidance, land_diameter=diameter, unbalance=50e-6, unbalance_azimuth=1.0)
    state = model.solve()
    points, azimuth = state.balance.points, model.bearing.azimuths
    ring = {"outer": points.outer_speed, "inner": points.inner_speed}[guidance][0, 0]
    land = land_force(state.cases.floating.offset, ring + state.cage_speed, model.bearing.cage, OIL).force[0]
    along, outward = state.rollers.pocket[:, 0]
    pockets = -np.array([
        (along * np.cos(azimuth) + outward * np.sin(azimuth)).sum(),
        (-along * np.sin(azimuth) + outward * np.cos(azimuth)).sum(),
    ])  # fmt: skip
    mass = model.bearing.cage.mass * 50e-6 * state.cage_speed**2
    thrown = mass * np.array([np.sin(1.0), np.cos(1.0)])
    weight = np.array([0.0, 9.81 * model.bearing.cage.mass])
    assert land + pockets + thrown + weight == approx(np.zeros(2), abs=1e-9 * np.abs(along).sum())
    assert np.hypot(*state.cage_offset) < 1.01 * model.bearing.cage.land_clearance / 2


def test_a_guiding_inner_ring_bears_the_cage():
    """Load on the ring, its rollers, the push of the cage and its weight together vanish."""
    model = floating(guidance="inner", land_diameter=65.4e-3)
    state = model.solve()
    azimuth, g = model.bearing.azimuths, model.bearing.diameter_ratio
    inner, tangential = state.loads[0], state.traction[0] + (1 - 2 * g) * state.rolling_shear[0]
    along, outward = state.rollers.pocket[:, 0]
    radial, sideways = -inner - outward, -tangential - along
    total = np.array([
        (radial * np.sin(azimuth) + sideways * np.cos(azimuth)).sum(),
        (radial * np.cos(azimuth) - sideways * np.sin(azimuth)).sum(),
    ])  # fmt: skip
    load = np.array([0.0, model.operation.radial_load + 9.81 * model.bearing.cage.mass])
    assert total + load == approx(np.zeros(2), abs=1e-9 * model.operation.radial_load)


def test_an_eccentric_land_brakes_more():
    held, free = paper_bearing().solve(), floating().solve()
    eccentricity = np.hypot(*free.cage_offset) / (CAGE.land_clearance / 2)
    assert eccentricity > 0.9
    assert abs(free.land_torque) > 2 * abs(held.land_torque)
    assert free.cage_slip > held.cage_slip


def test_power_goes_where_it_is_counted():
    state = replace(floating(unbalance=1e-4), spin_inertia=False).solve()
    assert state.driving_power == approx(state.losses.total, rel=1e-9)


def test_several_cases_float_as_alone():
    model = floating(unbalance=2e-5)
    models = [
        replace(model, operation=replace(model.operation, radial_load=load)) for load in (2e3, 5e3, 2e4)
    ]
    for together, model in zip(solve_many(models), models, strict=True):
        alone = model.solve()
        assert together.floating.offset == approx(alone.floating.offset, rel=1e-9)


def test_rollers_cannot_carry_a_free_cage():
    with pytest.raises(ImpossiblePart, match="needs a land"):
        Cage(guidance="rollers", pocket_friction=0.0, thickness=0.0, mass=1.0, free=True)
    with pytest.raises(ImpossiblePart, match="unbalance"):
        replace(CAGE, unbalance=-1e-6)


@given(force=st.floats(-1e3, 1e3), clearance=st.floats(1e-6, 1e-3))
def test_pocket_presses_back_where_the_roller_is_put(force, clearance):
    place = displacement_in_pocket(np.array(force), clearance, STOP)
    assert roller_on_pocket_force(place, clearance, STOP).force == approx(force, rel=1e-9, abs=1e-12)
    assert (abs(place) > clearance) == (abs(force) > 11 / 3 * (1 + 1e-12)) or abs(force) == approx(11 / 3)


def test_pocket_under_no_number_of_newtons():
    with pytest.raises(NotSolved):
        displacement_in_pocket(np.array([1.0, np.nan]), 1e-4, STOP)


def test_pockets_show_rollers_that_touch():
    state = paper_bearing(cage={"pocket_clearance": 1e-4}).solve()
    touching = np.abs(state.pocket_displacement) > 1e-4
    assert touching.tolist() == (np.abs(state.cage_force) > 11 / 3).tolist()
    assert (np.sign(state.pocket_displacement) == -np.sign(state.cage_force)).all()
