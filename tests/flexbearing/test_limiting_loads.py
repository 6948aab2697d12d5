"""Limiting static loads of four-point bearings against direct solves and a public script."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing.__main__ import command
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.limits import curves
from flexbearing.limits.curves import LimitedBearing, limit_curves
from flexbearing.progress import Logged
from quasidynamic.outcome.limiting_load import LIMITS, StaticLimits
from quasidynamic.solve.balls.load_distribution import ball_loads

PRESSURE, CORE, SHOULDER = LIMITS
INSTRUMENT = """kind = "four_point_ball"
title = "Thin four-point bearing of an instrument"
[bearing]
balls = 24
pitch_diameter = "83 mm"
contact_angle = "45 deg"
[bearing.ball]
diameter = "5.6 mm"
[bearing.inner]
conformity = 0.52
[bearing.outer]
conformity = 0.53
[materials.ball]
youngs_modulus = "208 GPa"
poisson_ratio = 0.3
[friction]
coefficient = 0.1
[operation.load]
axial = "8 kN"
"""


@pytest.fixture(scope="module")
def case(tmp_path_factory) -> Path:
    file = tmp_path_factory.mktemp("limits") / "thin.toml"
    file.write_text(INSTRUMENT)
    return file


def limited(case, *settings, **limits):
    return LimitedBearing.of(read_case(case, settings), StaticLimits(**limits), Logged())


def balls(bearing, axial, radial=0.0, moment=0.0):
    return ball_loads(bearing.bearing, np.array([axial, 0.0, radial, moment, 0.0]))


@pytest.mark.parametrize(("moment", "printed", "within"), [(588.0, 2678.8, 2e-3), (-588.0, 2478.8, 5e-3)])
def test_loads_of_both_senses_are_those_of_a_public_script(case, moment, printed, within):
    """24 balls of 5.6 mm on 83 mm, 45 deg, 0.52/0.53; F_r 7291, F_a 8235 N, M 588 N m; largest ball load.

    In the second sense the ball has 2489 and 659 N on its diagonals; the script lets each find a ball centre
    of its own, which is worth 0.4 %.
    """
    assert balls(limited(case), 8235.0, 7291.0, moment).loads.max() == approx(printed, rel=within)


def test_a_thrust_limit_is_that_of_every_ball(case):
    """Q = F/(Z sin(alpha)) at the angle under load, and the pressure goes with Q^(1/3)."""
    bearing = limited(case)
    (thrust, *_) = bearing.curve(0.0, 3)
    shared = balls(bearing, thrust.axial)
    assert bearing.shares(0.0, thrust.axial, 0.0)[0] == approx(1.0, rel=1e-7)
    assert shared.loads.max() == approx(thrust.axial / (24 * np.sin(shared.angles[0, 0, 0])), rel=1e-9)
    half = limited(case, safety=2.0)
    (halved, *_) = half.curve(0.0, 3)
    of_half = balls(half, halved.axial)
    assert shared.loads.max() / of_half.loads.max() == approx(2.0, rel=0.01)  # angles differ a little


@pytest.mark.slow
def test_straight_lines_between_points_of_a_curve_are_near_direct_solutions(case):
    """0.5 % of the load, here in a direction that is no point; in 200 directions in the documents."""
    bearing, radial = limited(case), 4000.0
    points = list(bearing.curve(radial, 3, refined=True))
    axial, moment = points[0].axial, points[-1].moment
    places = np.array([[each.axial / axial, each.moment / moment] for each in points])
    assert np.all(np.diff(np.arctan2(places[:, 1], places[:, 0])) > 0)
    for number in (1, len(points) // 2):
        middle = places[number : number + 2].mean(axis=0)
        scale, _ = bearing.point(radial, (axial * middle[0], moment * middle[1]))
        assert scale == approx(1.0, abs=5e-3)


def test_the_worse_sense_of_the_moment_counts(case):
    bearing = limited(case)
    scale, point = bearing.point(2000.0, (10e3, 300.0))
    loads = [bearing.shares(2000.0, scale * 10e3, sense * scale * 300.0).max() for sense in curves.SENSES]
    assert max(loads) == approx(1.0, rel=1e-7)
    assert point.sense == list(curves.SENSES)[int(np.argmax(loads))]


def test_shoulders_and_the_core_may_limit_before_the_pressure(case):
    free = next(limited(case).curve(0.0, 3))
    short = limited(case, "bearing.inner.shoulder=1.6 mm")
    cut = next(short.curve(0.0, 3))
    assert (free.limited_by, cut.limited_by) == (PRESSURE, SHOULDER)
    loads = balls(short, cut.axial)
    across = short.shares(0.0, cut.axial, 0.0)
    assert across[2] == approx(1.0, rel=1e-7)
    assert loads.angles[0, 0, 0] < short.bearing.groove_ends[0]
    soft = next(limited(case, case_depth=0.4e-3, core_yield=900e6).curve(0.0, 3))
    assert (soft.limited_by, soft.axial < free.axial) == (CORE, True)


def test_a_radial_load_beyond_the_limit_and_a_single_ball_have_no_curve(case):
    with pytest.raises(BadCase, match=r"radial load 1000 kN: the limit is passed without a load"):
        limit_curves(read_case(case), [1e6], 3, StaticLimits(), Logged())


def test_the_command_writes_a_table_and_a_picture(case, tmp_path, capsys):
    picture = tmp_path / "thin.png"
    words = ["limits", str(case), "--points", "3", "-o", str(picture)]
    assert command(words) == 0
    assert "radial load 0 kN: axial load" in capsys.readouterr().out
    rows = picture.with_suffix(".csv").read_text().splitlines()
    assert len(rows) > 1 + 3
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert command(["limits", str(case), "--radial", "-1 kN"]) == 2
    assert command(["limits", str(case), "--case-depth", "1 mm"]) == 2
