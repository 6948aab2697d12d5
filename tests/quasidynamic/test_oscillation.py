"""Fatigue of oscillating raceways: limits, the theory it comes from, and the guideline DG03."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.outcome.four_point_life import RatedArcs, arc_lives, four_point_life, guideline_life
from quasidynamic.outcome.oscillation import (
    critical_oscillation,
    guideline_factor,
    oscillating_damage,
    spread_by_oscillation,
)
from quasidynamic.outcome.raceway_damage import LINE, POINT, raceway_damage
from quasidynamic.parts.ball import BallRow

ROW = BallRow(
    balls=156, ball_diameter=35e-3, pitch_diameter=1.9, contact_angle=np.pi / 4, inner_conformity=0.525,
    outer_conformity=0.525,
)  # fmt: skip
ARCS = RatedArcs.of(ROW)
AZIMUTHS = 2 * np.pi * np.arange(156) / 156
LOADS = np.broadcast_to(
    np.stack([np.maximum(np.cos(AZIMUTHS), 0.0), np.maximum(-np.cos(AZIMUTHS), 0.0)]) * 10e3, (2, 2, 156)
)


@pytest.mark.parametrize("turns", [1, 2, 5])
def test_whole_turns_to_and_fro_are_a_turning_bearing(turns):
    whole = 2 * np.pi * turns
    assert four_point_life(LOADS, ARCS, whole) == approx(four_point_life(LOADS, ARCS), rel=1e-12)
    assert arc_lives(LOADS, ARCS, whole) == approx(arc_lives(LOADS, ARCS), rel=1e-12)


def test_half_a_turn_there_and_back_is_a_revolution():
    """By the guideline an oscillation of 180 deg counts as a revolution, of 360 deg as two."""
    life = four_point_life(LOADS, ARCS)
    assert guideline_factor(np.pi, 156, 0.013) == approx(1.0, rel=1e-12)
    for degrees in (720, 360, 180, 90, 10):
        assert guideline_life(life, ARCS, np.radians(degrees)) == approx(life, rel=1e-12)


@pytest.mark.parametrize(
    ("degrees", "factor"),
    [(90, 1.2599210), (30, 1.8171206), (10, 2.6207414), (4, 3.7011515), (1, 5.6098967)],
)
def test_factors_of_the_guideline(degrees, factor):
    """DG03, for small angles as frasere/ISO-281 has it: (180/theta)^(1/3), or to 0.3 times Z^0.033.

    Z 156, gamma 0.013: theta_crit is 4.56 and 4.68 deg.
    """
    assert guideline_factor(np.radians(degrees), 156, 0.013) == approx(factor, rel=1e-7)


def test_critical_angles():
    """720 deg/(Z (1 +- gamma)): balls of neighbouring places meet after half of that on each raceway."""
    inner, outer = np.degrees(critical_oscillation(60, 0.02))
    assert (inner, outer) == approx((12 / 1.02, 12 / 0.98), rel=1e-12)
    assert inner * 1.02 / 2 == approx(360 / 60, rel=1e-12)


def test_life_has_no_step_at_the_critical_angle():
    for critical in critical_oscillation(156, ROW.diameter_ratio):
        below, above = (four_point_life(LOADS, ARCS, critical * (1 + side * 1e-9)) for side in (-1, 1))
        assert below == approx(above, rel=1e-7)
    steps = [guideline_factor(critical * (1 + side * 1e-9), 156, ROW.diameter_ratio) for side in (-1, 1)]
    assert steps[0] / steps[1] == approx(4 ** (1 / 30), rel=0.002)


def test_small_angles_follow_the_theory_of_lundberg_and_palmgren():
    """ln(1/S) goes with N^e V: Z zones of theta (1 + gamma)/2, each rolled over twice an oscillation."""
    gamma, balls, e = ROW.diameter_ratio, 156, POINT.weibull
    loads, angle = np.full((balls, 1), 5e3), np.radians(1.0)
    critical = float(critical_oscillation(balls, gamma)[0])
    turning = raceway_damage(loads, 10e3, 1.0, POINT)
    oscillating = oscillating_damage(loads, 10e3, angle, critical, moves=True)
    passed, rolled = balls * (1 + gamma) / 2, balls * angle * (1 + gamma) / 2
    oscillations = np.pi / angle  # of a revolution
    by_theory = (2 * oscillations / passed) ** e * rolled / (2 * np.pi)
    assert oscillating / turning == approx(by_theory, rel=1e-12)


@pytest.mark.parametrize("degrees", [1.0, 7.3, 90.0, 200.0])
def test_moving_places_meet_the_mean_of_their_way(degrees):
    """Against sums over 20 000 places of the way, straight between the balls."""
    rng, angle = np.random.default_rng(41), np.radians(degrees)
    damage, places = rng.uniform(0.0, 1.0, 24), 2 * np.pi * np.arange(24) / 24
    way = (np.arange(20_000) + 0.5) / 20_000 * angle - angle / 2
    sums = [np.interp(place + way, places, damage, period=2 * np.pi).mean() for place in places]
    assert spread_by_oscillation(damage[:, None], angle)[:, 0] == approx(sums, rel=1e-6)


def test_slices_of_lines_spread_each_on_its_own():
    loads = np.random.default_rng(1).uniform(1.0, 2.0, (3, 14, 5))
    whole = oscillating_damage(loads, 1e3, 2 * np.pi, 0.1, moves=True, fatigue=LINE)
    assert whole == approx(raceway_damage(loads, 1e3, 1.0, LINE), rel=1e-12)
    still = oscillating_damage(loads, 1e3, 1.0, 0.1, moves=False, fatigue=LINE)
    assert still == approx(raceway_damage(loads, 1e3, 0.0, LINE), rel=1e-12)


def test_smaller_oscillations_live_shorter_for_the_same_way():
    lives = [four_point_life(LOADS, ARCS, np.radians(degrees)) for degrees in (360, 90, 20, 5, 2, 0.5)]
    assert np.all(np.diff(lives) < 0)


@pytest.mark.parametrize(
    ("fatigue", "of_angle", "of_elements"),
    [(POINT, 3 / 10, 0.033), (LINE, 2 / 9, 0.028)],
    ids=["balls", "rollers"],
)
def test_small_angles_have_the_exponents_of_the_guideline(fatigue, of_angle, of_elements):
    """Rating times (180/theta)^0.3 Z^0.033 of balls, (180/theta)^(2/9) Z^0.028 of rollers.

    As frasere/ISO-281 has DG03; its rollers have no part in `guideline_factor`.
    """

    def factor(degrees, elements):
        angle, loads = np.radians(degrees), np.full((elements, 1), 5e3)
        critical = float(critical_oscillation(elements, 0.013)[0])
        oscillating = oscillating_damage(loads, 10e3, angle, critical, moves=True, fatigue=fatigue)
        life = (oscillating / raceway_damage(loads, 10e3, 1.0, fatigue)) ** (-1 / fatigue.weibull)
        return (life * np.pi / angle) ** (1 / fatigue.load_exponent)

    assert np.log2(factor(0.5, 100) / factor(1.0, 100)) == approx(of_angle, rel=1e-9)
    assert np.log2(factor(0.5, 200) / factor(0.5, 100)) == approx(of_elements, abs=5e-4)
