"""Lines of pure rolling in a ball contact."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx
from scipy.integrate import quad

from quasidynamic.errors import OutOfRange
from quasidynamic.motion.rolling_lines import (
    ball_friction,
    rolling_lines,
    slip_velocity,
    spin_torque_factor,
    spin_torque_integral,
)


@given(st.floats(-10.0, 10.0), st.floats(-0.999, 0.999))
def test_lines_hold_the_spin_and_the_net_friction(spin, force):
    lines = rolling_lines(spin, force)
    assert lines.first + lines.second == approx(-spin, abs=1e-13)
    low, high = max(float(lines.first), -1.0), min(float(lines.second), 1.0)
    between = quad(lambda x: 0.75 * (1 - x * x), low, high)[0]  # part of the load between the lines
    assert 1 - 2 * between == approx(force, abs=1e-9)
    assert int(lines.count) == (2 if lines.first > -1 and lines.second < 1 else 1)


@given(st.floats(-0.9, 0.9))
def test_lines_move_without_a_jump_where_one_leaves_the_contact(force):
    limit = 1 + 2 * np.sin(np.arcsin(force) / 3)
    lines = rolling_lines(limit + np.array([-1e-9, 1e-9]), force)
    assert list(lines.count) == [2, 1]
    assert lines.second[0] == approx(lines.second[1], abs=1e-8)


def test_ball_that_rolls_straight_has_heathcotes_lines():
    lines = rolling_lines(0.0)
    assert float(lines.second) == approx(2 * np.cos(4 * np.pi / 9), abs=1e-14)  # c^3 - 3 c + 1 = 0
    assert spin_torque_factor(lines) == approx(0.0, abs=1e-15)


def test_torque_of_the_lines_is_the_narrow_limit_of_the_integral():
    lines = rolling_lines(np.array([0.2, 0.6, 0.95, 1.5, 4.0]))
    narrow = spin_torque_factor(lines)
    errors = [np.abs(spin_torque_integral(lines, ratio) / narrow - 1).max() for ratio in (1e-1, 1e-2, 1e-3)]
    assert errors[2] < 3e-5
    assert errors[0] > 20 * errors[1] > 400 * errors[2]  # second order, but for a logarithm


def test_integral_against_a_fine_grid():
    x, y = (np.arange(-1500, 1500) + 0.5)[:, None] / 1500, (np.arange(-400, 400) + 0.5)[None, :] / 400
    pressure = np.sqrt(np.maximum(1 - x**2 - y**2, 0.0))
    lines = rolling_lines(0.7, 0.1)
    slip, lateral = (x - lines.first) * (x - lines.second), 0.2 * 0.7 * y
    shear = (x * slip + 0.2 * y * lateral) / np.hypot(slip, lateral)
    grid = (pressure * shear).sum() / pressure.sum()
    assert spin_torque_integral(lines, 0.2) == approx(grid, rel=1e-4)


@given(st.floats(0.0, 10.0), st.floats(-0.9, 0.9))
def test_spin_the_other_way_has_the_mirrored_lines_and_the_opposite_torque(spin, force):
    lines, other = rolling_lines(spin, force), rolling_lines(-spin, force)
    assert (other.first, other.second) == (approx(-lines.second), approx(-lines.first))
    assert spin_torque_factor(other) == approx(-spin_torque_factor(lines), abs=1e-14)
    assert spin_torque_integral(other, 0.1) == approx(-spin_torque_integral(lines, 0.1), abs=1e-12)


@pytest.mark.parametrize("spin", [0.02, 0.0, -3e-18, -0.02])
def test_slip_vanishes_on_both_lines(spin):
    a, radius = 0.2e-3, 4e-3
    lines = rolling_lines(2 * radius * spin / a)
    here = np.array([lines.first, lines.second])
    slip = slip_velocity(here, lines, a, radius, 100.0, spin)
    largest = np.abs(slip_velocity(np.linspace(-1, 1, 9), lines, a, radius, 100.0, spin)).max()
    near, far = np.sort(np.abs(slip))
    assert near == approx(0.0, abs=1e-15)
    assert far < (a / radius) ** 2 * largest


def test_friction_of_a_ball_balances_its_moments():
    loads, axes = np.array([[100.0], [140.0]]), np.array([[0.2e-3], [0.25e-3]])
    angles, spin = np.array([[0.2], [-0.15]]), np.array([[0.8], [0.6]])
    net = ball_friction(spin, loads, axes, angles, 8e-3)
    assert loads[0] * net[0] == approx(loads[1] * net[1], rel=1e-13)
    torque = loads * axes * spin_torque_factor(rolling_lines(spin, net))
    driving = 4e-3 * (loads * net * np.cos(angles)).sum(0)
    assert driving == approx(torque[0] * np.sin(angles[0]) - torque[1] * np.sin(angles[1]), rel=1e-11)


def test_ball_that_slides_on_one_race_leaves_the_others_their_friction():
    """Its inner race presses a thousandth of its outer one: no net force there balances the moments."""
    loads, axes = np.array([[100.0, 0.1], [140.0, 100.0]]), np.array([[2e-4, 2e-5], [2.5e-4, 2e-4]])
    angles, spin = np.array([[0.2, 1.2], [-0.15, -0.9]]), np.array([[0.8, 0.8], [0.6, 3.0]])
    net = ball_friction(spin, loads, axes, angles, 8e-3)
    alone = ball_friction(spin[:, :1], loads[:, :1], axes[:, :1], angles[:, :1], 8e-3)
    assert np.isnan(net[:, 1]).all()
    assert net[:, 0] == approx(alone[:, 0], rel=1e-13)


def test_what_no_lines_describe_is_refused():
    with pytest.raises(OutOfRange, match="slides everywhere"):
        rolling_lines(0.5, 1.0)
