"""Four-point traction curve: it passes through its points, and its slopes are slopes."""

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from pytest import approx

from quasidynamic.contact.traction.measured_curve import FourPointCurve
from quasidynamic.errors import ImpossiblePart

FLUID = FourPointCurve.through(at_rest=0.0, peak=0.05, peak_slip=0.02, far=0.03)
GREASE = FourPointCurve.through(at_rest=0.04, peak=0.06, peak_slip=0.05, far=0.02, sign_slip=1e-3)

frictions = st.floats(0.0, 0.3)
slips = st.floats(1e-4, 1.0)


@given(at_rest=frictions, peak=frictions, slip=slips, far=frictions)
def test_curve_passes_through_its_points_and_peaks_there(at_rest, peak, slip, far):
    assume(peak > max(at_rest, far) + 1e-4)
    curve = FourPointCurve.through(at_rest=at_rest, peak=peak, peak_slip=slip, far=far)
    start, top, end = curve.coefficient(np.array([0.0, slip, 1e6]))
    assert start == approx(at_rest, abs=1e-12)
    assert top == approx(peak, rel=1e-9)
    assert end == approx(far, abs=1e-12)
    around = curve.coefficient(slip * np.linspace(0.0, 10.0, 201))
    assert np.argmax(around) == 20
    assert np.all(np.diff(around[20:]) <= 1e-15)


def test_coefficients_solve_the_rule_of_the_source():
    """D = mu_inf, A = mu0 - mu_inf, (A + B u) exp[-B u/(A + B u)] + D = mu_max, C = B/(A + B u)."""
    curve, u = GREASE, 0.05
    assert curve.d == 0.02
    assert curve.a == approx(0.02, rel=1e-12)
    w = curve.a + curve.b * u
    assert w * np.exp(-curve.b * u / w) + curve.d == approx(0.06, rel=1e-12)
    assert curve.c == approx(curve.b / w, rel=1e-12)


def test_printed_curve_of_a_thesis_oil():
    """A, B, C, D = -0.01999, 1.539, 34.92, 0.02076 (60 degC, 0.8 GPa): mu at S = 0 ... 0.2."""
    curve = FourPointCurve(a=-0.01999, b=1.539, c=34.92, d=0.02076)
    slip = np.array([0.0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2])
    printed = np.array([0.0008, 0.0104, 0.0175, 0.0261, 0.0307, 0.0248, 0.0210])
    assert curve.coefficient(slip) == approx(printed, abs=0.6e-4)


@pytest.mark.parametrize(
    "points",
    [
        {"at_rest": 0.0, "peak": 0.02, "peak_slip": 0.02, "far": 0.03},
        {"at_rest": 0.06, "peak": 0.05, "peak_slip": 0.02, "far": 0.03},
        {"at_rest": 0.05, "peak": 0.05, "peak_slip": 0.02, "far": 0.03},
        {"at_rest": 0.0, "peak": 0.05, "peak_slip": 0.02, "far": 0.05},
        {"at_rest": 0.0, "peak": 0.05, "peak_slip": 0.0, "far": 0.03},
        {"at_rest": -0.01, "peak": 0.05, "peak_slip": 0.02, "far": 0.03},
        {"at_rest": 0.0, "peak": float("nan"), "peak_slip": 0.02, "far": 0.03},
    ],
    ids=[
        "peak below far",
        "peak below rest",
        "flat start",
        "flat end",
        "peak at rest",
        "negative",
        "not a number",
    ],
)
def test_points_without_a_curve_are_refused(points):
    with pytest.raises(ImpossiblePart, match=r"without a maximum|peak_slip"):
        FourPointCurve.through(**points)


@pytest.mark.parametrize(
    "numbers",
    [(-0.03, 1.0, 30.0, 0.02), (0.01, 1.0, -30.0, 0.02), (0.01, -1.0, 30.0, 0.02), (0.03, 1.0, 30.0, -0.02)],
    ids=["negative at rest", "growing", "falling first", "negative far"],
)
def test_coefficients_that_would_drive_are_refused(numbers):
    with pytest.raises(ImpossiblePart):
        FourPointCurve(**dict(zip("abcd", numbers, strict=True)))


@pytest.mark.parametrize("law", [FLUID, GREASE], ids=["fluid", "grease"])
@given(
    load=st.floats(0.0, 2e6),
    ratio=st.tuples(st.sampled_from([-1.0, 1.0]), st.floats(-6, 1)).map(lambda v: v[0] * 10 ** v[1]),
    speed=st.floats(-4, 2.3).map(lambda n: 10.0**n),
)
def test_signed_traction_is_odd_and_its_slopes_are_slopes(law, load, ratio, speed):
    def force(*values):
        return law(*map(np.array, values), np.array(1e-7)).force

    point = load, ratio * speed, speed
    here = law(*map(np.array, point), np.array(1e-7))
    assert here.force == approx(-force(load, -ratio * speed, speed), rel=1e-12, abs=0)
    assert here.force * ratio >= 0
    assert here.by_film == 0
    for index, name in enumerate(("by_load", "by_sliding", "by_entrainment")):
        step = 1e-4 * (abs(point[index]) + (index == 0))
        move = np.eye(3)[index] * step
        f = [force(*(np.array(point) + n * move)) for n in (-2, -1, 1, 2)]
        slope = (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * step)
        assert getattr(here, name) == approx(slope, rel=1e-7, abs=1e-10 * (load + 1) / (step / 1e-4))


def test_friction_at_rest_is_rounded_over_the_sign_slip():
    slip = 1e-3 * np.array([-7.0, 0.0, 1.0, 7.0])
    rounded = GREASE(np.array(1.0), slip, np.array(1.0), np.array(1e-7)).force
    rise = np.sign(slip) * (GREASE.coefficient(np.abs(slip)) - 0.04)
    assert rounded - rise == approx(0.04 * np.array([-0.99, 0.0, 2**-0.5, 0.99]), rel=1e-3, abs=1e-15)


@pytest.mark.parametrize("law", [FLUID, GREASE], ids=["fluid", "grease"])
def test_everything_stays_finite_at_rest(law):
    corners = np.meshgrid([0.0, 2e6], [-60.0, 0.0, 60.0], [0.0, 1e-6, 200.0], [5e-9])
    for value in law(*corners):
        assert value.shape == corners[0].shape
        assert np.all(np.isfinite(value))
