"""Elliptic Hertz contact of ball and groove."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe, ellipkm1

from quasidynamic.contact.ellipse.point_contact import (
    INNER,
    OUTER,
    Curvatures,
    in_series,
    log_axis_ratio,
    point_contact,
    race_curvatures,
)
from quasidynamic.errors import OutOfRange

E = 228e9  # [Pa] E' = 2 E*
ratios = st.floats(-16.0, 16.0).map(np.exp)


def contact(across, along=100.0):
    return point_contact(Curvatures(np.array(across), np.array(along)), E)


def test_sphere_is_the_circle_of_johnson():
    """Q = 4/3 E* sqrt(R) delta^1.5, a^2 = R delta, p0 = (6 Q E*^2/(pi^3 R^2))^(1/3)."""
    sphere, R, Q = contact(100.0), 10e-3, 1000.0
    assert sphere.coefficient == approx(4 / 3 * (E / 2) * np.sqrt(R), rel=1e-14)
    a, b = sphere.semi_axes(Q)
    assert a == approx(b, rel=1e-14)
    assert a**2 == approx(R * sphere.approach(Q), rel=1e-14)
    assert sphere.peak_pressure(Q) == approx((6 * Q * (E / 2) ** 2 / (np.pi**3 * R**2)) ** (1 / 3), rel=1e-14)


@given(ratios)
def test_hertz_pressure_presses_the_surfaces_together(ratio):
    """The curvature of the displacement under p = p0 sqrt(1 - x2/a2 - y2/b2) is that of the bodies."""
    found, Q = contact(100.0 * ratio), 1000.0
    a, b = found.semi_axes(Q)
    k = float(a / b)
    unit = 3 * Q / (np.pi * E)  # displacement w = unit/2 int (1 - x2/(a2+s) - y2/(b2+s)) ds/sqrt(..)

    def shape(power_a, power_b):  # s = b^2 exp(2 t), over lengths b
        inner = lambda t: 2 * np.exp(t) / (k**2 + np.exp(2 * t)) ** power_a / (1 + np.exp(2 * t)) ** power_b  # noqa: E731
        middle = max(np.log(k), 0.0)
        parts = (-40.0, min(np.log(k), 0.0), middle, middle + 40.0)
        return sum(
            quad(inner, low, high, epsabs=0, epsrel=1e-11, limit=200)[0] for low, high in pairwise(parts)
        )

    assert 100.0 * ratio == approx(unit * shape(1.5, 0.5) / b**3, rel=1e-8)
    assert 100.0 == approx(unit * shape(0.5, 1.5) / b**3, rel=1e-8)
    assert found.approach(Q) == approx(unit / 2 * shape(0.5, 0.5) / b, rel=1e-8)


@given(st.floats(0.0005, 0.95))
def test_ratio_of_the_axes_solves_the_printed_equation(ratio):
    difference = (1 - ratio) / (1 + ratio)

    def printed(u):
        q = np.exp(-2 * u)
        K, second = ellipkm1(q), ellipe(1 - q)
        return ((1 / q + 1) * second - 2 * K) / ((1 / q - 1) * second) - difference

    assert log_axis_ratio(ratio) == approx(brentq(printed, 1e-3, 12, xtol=1e-14), abs=1e-12, rel=1e-12)


@given(ratios)
def test_turned_by_a_quarter_the_ellipse_is_the_same(ratio):
    one, other = contact(100.0 * ratio, 100.0), contact(100.0, 100.0 * ratio)
    assert one.coefficient == approx(other.coefficient, rel=1e-12)
    assert one.across == approx(other.along, rel=1e-12)
    assert one.along == approx(other.across, rel=1e-12)


def test_many_ratios_at_once_are_each_alone():
    ratio = np.geomspace(1e-8, 1e8, 101)
    together = log_axis_ratio(ratio)
    assert together == approx([float(log_axis_ratio(r)) for r in ratio], abs=1e-14, rel=1e-14)
    assert together + together[::-1] == approx(np.zeros(101), abs=1e-14)


@given(st.floats(1e-9, 1e-4))
def test_load_approach_and_stiffness_belong_together(approach):
    groove = contact(4.0, 104.0)
    load = groove.load(approach)
    assert groove.approach(load) == approx(approach, rel=1e-12)
    step = 1e-5 * approach
    slope = (groove.load(approach + step) - groove.load(approach - step)) / (2 * step)
    assert groove.stiffness(approach) == approx(slope, rel=1e-8)
    a, b = groove.semi_axes(load)
    assert groove.peak_pressure(load) == approx(1.5 * load / (np.pi * a * b), rel=1e-12)


def test_bodies_apart_carry_nothing():
    assert contact(4.0, 104.0).load([-1e-6, 0.0]).tolist() == [0.0, 0.0]
    assert contact(4.0, 104.0).stiffness([-1e-6, 0.0]).tolist() == [0.0, 0.0]


def test_curvatures_of_the_218_bearing():
    """Harris: D 22.23, grooves 11.63 mm, pitch 125.26 mm, 40 degrees; sums 0.108 and 0.083 per mm."""
    sums = [
        sum(race_curvatures(22.23e-3, 11.63e-3, 125.26e-3, np.radians(40), side)) for side in (INNER, OUTER)
    ]
    assert sums == approx([108.1, 83.2], rel=1e-3)


def test_contacts_in_series_add_their_approaches():
    one, other = contact(4.0, 104.0), contact(4.0, 79.0)
    depth = one.approach(500.0) + other.approach(500.0)
    assert in_series(one, other) * depth**1.5 == approx(500.0, rel=1e-12)


def test_groove_as_narrow_as_the_ball_is_no_point_contact():
    with pytest.raises(OutOfRange, match="above the ball radius"):
        race_curvatures(10e-3, 5e-3, 50e-3, 0.3, INNER)
    with pytest.raises(OutOfRange, match="above zero"):
        contact(-1.0)
