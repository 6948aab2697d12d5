"""Balls on the pressure of true arcs instead of the ellipses of Hertz."""

import pickle
from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.errors import OutOfRange
from tests.ball_bearings import one_ball, slow_bearing
from tests.random_rolling_balls import drawn

CELLS = (12, 24)
COMPUTED = pytest.mark.parametrize("pressure", ["offset", "translation"])


def rolled(pressure, loads=(20e3,), model="kalker", cells=CELLS, ends=None, **parts):
    """One ball of 30 mm with its contacts at 45 degrees."""
    bearing = slow_bearing(friction=0.1, conformity=0.5208, spin="local", **parts)
    bearing = replace(bearing, contact_pressure=pressure)
    if ends is not None:
        bearing = replace(bearing, bearing=replace(bearing.bearing, groove_ends=ends))
    return bearing.roll(one_ball(bearing, [45.0] * len(loads), loads), model, cells)


def contacts_of(balls):
    return balls.rolled[0].fine.ball.contacts


def along_normal(balls):
    """Force of the pressure along each contact normal (C) [N], the slope of the arcs by their radius."""
    contacts, radius = contacts_of(balls), balls.ellipse.radius[0, :, :].ravel()
    cosine = np.cos(contacts.places()[1] / radius[:, None, None])
    return (contacts.pressure * cosine).sum((1, 2)) * contacts.cell_area


@pytest.mark.parametrize("pressure", ["offset", "hertz"])
def test_balls_may_be_rolled_by_other_processes(pressure):
    def elsewhere(function, balls):
        return [pickle.loads(pickle.dumps(function))(ball) for ball in pickle.loads(pickle.dumps(balls))]

    bearing = replace(slow_bearing(friction=0.1, spin="local"), contact_pressure=pressure)
    balls = one_ball(bearing, [45.0], [20e3])
    here, there = (bearing.roll(balls, "fastsim", CELLS, mapped=each) for each in (map, elsewhere))
    assert there.rolled[0].extrapolated_torque == here.rolled[0].extrapolated_torque


@COMPUTED
def test_pressure_along_the_normals_balances_the_loads(pressure):
    loads = np.array([20e3, 6e3])
    balls = rolled(pressure, loads, "fastsim")
    assert along_normal(balls) == approx(np.repeat(loads, 2), rel=1e-4)


@pytest.mark.sampled(3)
@COMPUTED
@pytest.mark.parametrize(("model", "apart"), [("full_sliding", 2e-3), ("kalker", 2e-3), ("fastsim", 1e-2)])
def test_small_patches_are_those_of_hertz(pressure, model, apart):
    """A ten-thousandth of the load: the angle of the patch, and what it changes, is small.

    FASTSIM takes its springs from whole cells in contact.
    """
    light, heavy = (
        [rolled(each, (load,), model, (20, 40)).rolled[0].extrapolated_torque for each in (pressure, "hertz")]
        for load in (4.0, 40e3)
    )
    assert light[0] == approx(light[1], rel=apart)
    assert abs(heavy[0] / heavy[1] - 1) > 0.01


def test_offset_spreads_the_pressure_and_a_ring_that_moves_does_not():
    offset, hertz, translation = (rolled(each, (40e3,)) for each in ("offset", "hertz", "translation"))
    assert np.all(offset.reach > hertz.reach)
    assert np.all(translation.reach < hertz.reach)
    assert np.all(translation.peak_pressure > offset.peak_pressure)
    assert translation.torque < 0.95 * hertz.torque < 0.95 * offset.torque


@COMPUTED
def test_pressure_is_symmetric_but_for_the_curvature_of_the_race(pressure):
    """Along the rolling direction always; across as the race is flat, on a pitch circle of a kilometre."""
    balls = rolled(pressure, pitch=1e3, balls=3, model="full_sliding")
    for each in contacts_of(balls).pressure:
        assert each == approx(each[::-1], abs=1e-9 * each.max())
        assert each == approx(each[:, ::-1], abs=1e-4 * each.max())
    tight = contacts_of(rolled(pressure, pitch=0.1, balls=3, model="full_sliding")).pressure
    assert np.abs(tight - tight[:, :, ::-1]).max() > 0.1 * tight.max()


@COMPUTED
def test_both_diagonals_are_mirror_images(pressure):
    """Places across count towards the shoulder on the second diagonal, away from it on the first."""
    contacts = contacts_of(rolled(pressure, (20e3, 20e3), "full_sliding", pitch=0.1, balls=3))
    first, second = contacts.pressure[:2], contacts.pressure[2:]
    assert first == approx(second[:, :, ::-1], rel=1e-9)
    assert np.abs(first - second).max() > 0.01 * first.max()


@COMPUTED
def test_stick_and_slip_on_computed_pressure_never_turn_harder_than_full_sliding(pressure):
    balls = rolled(pressure, (20e3, 2e3))
    (ball,) = balls.rolled
    start = np.append(balls.sliding.motion[0], 0.0)
    assert 0.0 < ball.torque <= ball.fine.ball.full_sliding_power(start) * (1 + 1e-5)
    assert ball.fine.imbalance <= 1e-3


@pytest.mark.slow
@COMPUTED
def test_the_error_told_is_that_of_the_grid(pressure):
    """Against cells of a quarter of the size."""
    ball, finer = (rolled(pressure, cells=cells).rolled[0] for cells in ((16, 32), (64, 128)))
    assert abs(ball.torque - finer.extrapolated_torque) <= ball.grid_error


@COMPUTED
def test_torque_grows_as_the_cube_of_the_size_of_everything(pressure):
    torques = [
        rolled(pressure, (20e3 * size**2,), ball=30e-3 * size, pitch=size).torque / size**3
        for size in (1.0, 2.0)
    ]
    assert torques[1] == approx(torques[0], rel=1e-5)


def test_shoulder_cuts_the_pressure_on_its_side():
    """At the outer race, 3 mm of arc above the contact angle."""
    whole = rolled("offset", (20e3, 2e3), "full_sliding")
    radius = 0.5208 * 30e-3
    cut = rolled("offset", (20e3, 2e3), "full_sliding", ends=(np.inf, np.pi / 4 + 3e-3 / radius))
    assert not whole.cut.any()
    assert cut.cut[0].tolist() == [[False, True], [False, False]]
    assert cut.reach[0, 0, 1] == approx(3e-3, abs=contacts_of(cut).grids[1].spacing[1])
    assert cut.peak_pressure[0, 0, 1] > 1.1 * whole.peak_pressure[0, 0, 1]
    assert along_normal(cut)[1] == approx(20e3, rel=1e-4)
    _, y = contacts_of(cut).places()
    carried = (contacts_of(cut).pressure[1] > 0).any(0)
    assert y[1, 0, carried].min() >= -3e-3  # on the first diagonal shoulders lie at negative places
    assert y[1, 0, carried].max() == approx(whole.reach[0, 0, 1], rel=0.1)


def test_ball_on_a_shoulder_is_refused():
    with pytest.raises(OutOfRange, match=r"over the shoulder at 44\.0 deg"):
        rolled("translation", ends=(np.radians(44.0), np.inf))


def test_peak_pressure_and_reach_of_hertz_stay_exact():
    balls = rolled("hertz")
    bearing = slow_bearing(friction=0.1, conformity=0.5208, spin="local")
    sliding = one_ball(bearing, [45.0], [20e3])
    assert balls.peak_pressure.tolist() == sliding.peak_pressure.tolist()
    assert balls.reach.tolist() == sliding.ellipse.across.tolist()


@pytest.mark.long
@COMPUTED
def test_the_error_told_holds_for_nearly_all_random_balls(pressure):
    """In 95 of 100, against the limit of four times as many cells in each direction."""
    held = []
    for seed in range(48):
        bearing, sliding = drawn(seed)
        bearing = replace(bearing, contact_pressure=pressure)
        ball, finer = (bearing.roll(sliding, "kalker", cells).rolled[0] for cells in ((20, 40), (80, 160)))
        held.append(abs(ball.torque - finer.extrapolated_torque) <= ball.grid_error)
    assert np.mean(held) >= 0.95
