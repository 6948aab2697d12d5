"""Pairs of spindle bearings of the size of a 7014 against an independent program and a maker's catalogue.

Source of the values of the first: balls as springs between groove centres with the contact law of Hertz, both
rows on one ring, Newton's method, stiffnesses confirmed by differences; at speed with outer control. Its rows
are at their groove centres, 0.06 mm beside the balls. Of the second: a bearing maker's catalogue of 2010 for
the pair 7014 C, 15 degrees, C 50.5 kN, C_0 43.5 kN, whose balls and grooves are not printed: those of the
first are assumed.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pytest import approx

from quasidynamic import AngularContactBallBearing, preloaded_place, unloading_force
from quasidynamic.parts.angular_contact_bearing import RingOperation, RowPlace
from tests.ball_bearings import fast_bearing

ROW = fast_bearing(11.36e-3, 90e-3, 22, np.radians(15.0), 0.52, 0.53)
PRELOAD = 610.0
DB, DF, DT = (False, True), (True, False), (False, False)  # whether rows are mirrored


def pair(mirrored, preload=PRELOAD):
    closer = preloaded_place(ROW, preload) if preload else 0.0
    rows = zip((-10e-3, 10e-3), mirrored, strict=True)
    return replace(ROW, rows=tuple(RowPlace(axial=at, mirrored=m, closer=closer) for at, m in rows))


@cache
def solved(mirrored, load, speed=0.0, preload=PRELOAD):
    operation = RingOperation(load=load, inner_speed=speed * np.pi / 30)
    return AngularContactBallBearing(bearing=pair(mirrored, preload)).solve(operation)


def stiffness(state):
    """K_xx, K_yy, K_zz [N/um] and those about y and z [kN m/rad]."""
    return np.diag(state.stiffness) * [1e-6, 1e-6, 1e-6, 1e-3, 1e-3]


@pytest.mark.parametrize(
    ("preload", "place", "axial", "unloads"),
    [
        (140, 6.5759, 66.86, 424.2),
        (270, 9.9494, 87.06, 845.0),
        (610, 16.3916, 123.94, 2020.4),
        (1230, 24.7634, 172.66, 4348.0),
    ],
)
def test_preload(preload, place, axial, unloads):
    assert 1e6 * preloaded_place(ROW, preload) == approx(place, abs=1e-4)
    assert stiffness(solved(DB, (0.0,) * 5, preload=preload))[0] == approx(axial, abs=5e-3)
    assert unloading_force(pair(DB, preload)) == approx(unloads, abs=0.06)
    beyond, before = (solved(DB, (share * unloads, 0, 0, 0, 0), preload=preload) for share in (1.01, 0.99))
    assert not beyond.loads[:, 22:].any()
    assert before.loads[:, 22:].all()


@pytest.mark.parametrize(
    ("mirrored", "load", "place", "loads", "others", "stiff"),
    [
        (DB, (0,) * 5, (0, 0, 0), (97.1, 97.1), (97.1, 97.1), (123.94, 660.28, 660.28, 369.584, 369.584)),
        (DF, (0,) * 5, (0, 0, 0), (97.1, 97.1), (97.1, 97.1), (123.94, 660.28, 660.28, 15.901, 15.901)),
        (DB, (1000, 0, 0, 0, 0), (8.062, 0, 0), (183.4, 183.4), (33.9, 33.9),
         (124.17, 639.09, 639.09, 364.107, 364.107)),
        (DB, (1000, 0, 1500, 0, 0), (9.044, 2.896, -45.96), (269.8, 266.6, 257.4, 243.2, 225.2, 205.4, 185.5),
         (141.8, 136.1, 120.0, 96.1, 68.1, 40.4, 17.2, 2.3, 0.0), (119.91, 607.66, 593.37, 343.189, 349.784)),
        (DF, (1000, 0, 1500, 0, 0), (8.718, 2.729, -160.90), (119.6,), (279.8,),
         (120.00, 612.92, 585.57, 19.056, 18.245)),
        (DB, (0, 0, 0, 50, 0), (0, 0, 136.84), (214.5,), (17.3,), (122.20, 649.82, 626.87, 356.020, 365.396)),
        (DF, (0, 0, 0, 50, 0), (0, 0, 1586.44), (79.5,), (561.1,), (187.02, 711.84, 816.69, 64.003, 31.517)),
    ],
)  # fmt: skip
def test_loads_at_rest(mirrored, load, place, loads, others, stiff):
    state = solved(mirrored, load)
    moved = 1e6 * state.ring_displacement
    assert (moved[0], moved[2], moved[3]) == approx(place, abs=6e-3)
    assert state.loads[0, : len(loads)] == approx(loads, abs=0.06)
    assert state.loads[0, 22 : 22 + len(others)] == approx(others, abs=0.06)
    assert stiffness(state) == approx(stiff, abs=6e-3)


def test_tandem_is_two_single_rows():
    state = solved(DT, (2000, 0, 0, 0, 0), preload=0)
    assert 1e6 * state.ring_displacement[0] == approx(21.965, abs=6e-4)
    assert state.loads == approx(154.4, abs=0.06)
    assert stiffness(state) == approx([156.11, 766.45, 766.45, 236.256, 236.256], abs=6e-3)
    single = AngularContactBallBearing(bearing=ROW).solve(RingOperation(load=(1000, 0, 0, 0, 0)))
    assert state.loads[:, :22] == approx(single.loads, rel=1e-9)


@pytest.mark.parametrize(
    ("speed", "loads", "angles", "axial"),
    [
        (5000, (96.9, 110.6), (18.47, 15.33), 115.05),
        (10000, (124.1, 179.4), (21.74, 13.15), 97.48),
        (15000, (167.3, 293.9), (24.29, 11.46), 103.97),
    ],
)
def test_preload_grows_with_speed(speed, loads, angles, axial):
    state = solved(DB, (0,) * 5, speed)
    assert state.loads[:, 0] == approx(loads, abs=0.06)
    assert np.degrees(state.contact_angles[:, 0]) == approx(angles, abs=6e-3)
    assert stiffness(state)[0] == approx(axial, abs=6e-3)


@pytest.mark.parametrize(("preload", "axial", "radial"), [(140, 70, 460), (610, 130, 650), (1230, 180, 830)])
def test_catalogue_of_a_maker(preload, axial, radial):
    """Axial stiffness within 8 %, radial within 15 % of the printed ones.

    That of 270 N is 8.4 % below the printed 95 N/um. Printed unloading forces follow 2.83 times the preload,
    which holds for a constant contact angle; with the angle free a pair unloads at 3.03 to 3.53 times.
    """
    found = stiffness(solved(DB, (0.0,) * 5, preload=preload))
    assert found[0] == approx(axial, rel=0.08)
    assert found[1] == approx(radial, rel=0.15)
