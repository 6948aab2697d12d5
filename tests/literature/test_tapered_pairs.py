"""Pairs of tapered rows on common rings: values of an independent program, one convex potential for all rows.

The rows are those of tests/quasidynamic/test_tapered.py (Z 19, D 10.5, L 15.5, d_m 71 mm, crown 4 um), 60 mm
apart, each 18.3525 um into its cup, which is a preload of 3 kN.
"""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import RingOperation, tapered_loads
from quasidynamic.parts.angular_contact_bearing import RowPlace
from tests.quasidynamic.test_tapered import tapered

OFFSET = 18.3525e-6


def rows(arrangement, offset=OFFSET, distance=60e-3):
    first = RowPlace(axial=-distance / 2, closer=offset, mirrored=arrangement == "X")
    second = RowPlace(axial=distance / 2, closer=offset, mirrored=arrangement == "O")
    return first, second


def solved(arrangement, axial=0.0, radial=0.0, moment=0.0, **changes):
    model = replace(tapered(), side=1, rows=rows(arrangement, **changes))
    return tapered_loads(model, RingOperation(load=(1e3 * axial, 0.0, 1e3 * radial, moment, 0.0)))


PRINTED = {  # loads [kN, N m]: place [um, urad], axial and radial loads of rows [N], Q_o of both rows, K
    "O, no load": (
        ("O",), (0, 0, 0), ((3000, 0), (-3000, 0)), ([], []),
        (523.59, 3339.24, 3339.24, 5334.115, 5334.115)),
    "O, Fx 4 Fz 20": (
        ("O", 4, 20), (13.200, 7.702, -77.99), ((7467.6, 10058.6), (-3467.6, 9941.4)),
        ([2604.3, 2537.1, 2343.6, 2048.1, 1687.2, 1305.5, 961.0, 697.0, 524.8, 441.4],
         [2286.9, 2131.5, 1689.5, 1043.6, 406.4, 15.9, 0]),
        (496.24, 3117.23, 3212.46, 5169.127, 5009.016)),
    "O, Fz 20 My 300": (
        ("O", 0, 20, 300), (-6.102, 7.340, 103.93), ((5012.6, 13692.6), (-5012.6, 6307.4)),
        ([3006.6, 2836.3, 2350.3, 1621.8, 802.3, 181.3, 0], [1710.0]),
        (493.10, 3161.46, 3128.07, 5030.775, 5067.340)),
    "X, no load": (
        ("X",), (0, 0, 0), ((-3000, 0), (3000, 0)), ([], []),
        (523.59, 3339.24, 3339.24, 1401.708, 1401.708)),
    "X, Fx 4 Fz 20": (
        ("X", 4, 20), (12.992, 7.647, 146.16), ((-3419.8, 9785.0), (7419.8, 10215.0)),
        ([2247.3, 2095.1, 1662.6, 1032.8, 407.8, 19.7, 0], [2616.1]),
        (495.11, 3117.97, 3197.26, 1380.273, 1339.414)),
}  # fmt: skip


@pytest.mark.parametrize(("asked", "place", "loads", "outer", "stiffness"), PRINTED.values(), ids=PRINTED)
def test_pair_of_the_independent_program(asked, place, loads, outer, stiffness):
    found = solved(*asked)
    assert found.displacement[[0, 2, 3]] * 1e6 == approx(place, rel=1e-4, abs=2e-3)
    row_load = found.row_load
    assert row_load[:, 0] == approx([axial for axial, _ in loads], rel=1e-4, abs=0.2)
    assert row_load[:, 2] == approx([radial for _, radial in loads], rel=1e-4, abs=0.2)
    each = found.loads[1].reshape(2, -1)
    for row, printed in zip(each, outer, strict=True):
        assert row[: len(printed)] == approx(printed, rel=0, abs=0.3)
    assert np.diag(found.stiffness) / [1e6, 1e6, 1e6, 1e3, 1e3] == approx(stiffness, rel=1e-4)


def test_a_pair_unloads_at_three_times_its_preload():
    """9058.2 N of the crowned rows, where 2 (10/9)-powers would leave 2.16 times."""
    before, after = (np.abs(solved("O", axial).row_load[1, 0]) for axial in (9.05, 9.07))
    assert before > 0.01
    assert after == approx(0.0, abs=1e-3)


def test_rows_in_tandem_share_a_thrust():
    found = solved("T", 20, offset=0.0)
    assert found.row_load[:, 0] == approx([1e4, 1e4], rel=1e-9)
    alone = tapered_loads(replace(tapered(), side=1), RingOperation(load=(1e4, 0.0, 0.0, 0.0, 0.0)))
    assert found.loads[:, :19] == approx(alone.loads, rel=1e-9)
    assert found.displacement[0] == approx(alone.displacement[0], rel=1e-9)


def test_two_rows_are_as_stiff_as_statics_says():
    """K_tilt = 2 K_tilt,1 + (a^2/2) K_radial,1 where tilt and translation of one row are not coupled."""
    held = RingOperation(displacement=(20e-6, 0.0, 0.0, 0.0, 0.0))
    one = tapered_loads(replace(tapered(), side=1), held).stiffness
    both = tapered_loads(replace(tapered(), side=1, rows=rows("T", 0.0)), held).stiffness
    assert both[:3, :3] == approx(2 * one[:3, :3], rel=1e-9, abs=1.0)
    assert both[3, 3] == approx(2 * one[3, 3] + 0.06**2 / 2 * one[2, 2], rel=1e-9)


def test_a_row_far_apart_leaves_the_other_alone():
    """A millimetre of play between the rows, the radial load on the first one."""
    asked = RingOperation(load=(1e4, 0.0, 1.5e4, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0))
    alone = tapered_loads(replace(tapered(), side=1), asked)
    idle = RowPlace(axial=60e-3, closer=-1e-3, mirrored=True)
    found = tapered_loads(replace(tapered(), side=1, rows=(RowPlace(), idle)), asked)
    assert found.loads[:, :19] == approx(alone.loads, rel=1e-9)
    assert found.loads[:, 19:] == approx(0.0, abs=1e-3)
    assert found.displacement == approx(alone.displacement, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("arrangement", ["O", "X"])
def test_equal_rows_share_a_radial_load(arrangement):
    row_load = solved(arrangement, 0, 20).row_load
    assert row_load[:, 2] == approx([1e4, 1e4], rel=1e-9)
    assert row_load[0, 0] == approx(-row_load[1, 0], rel=1e-9)


def test_rollers_off_the_cone_rest_on_cup_and_rib_and_cost_no_search():
    """Q_o N_o + Q_f N_f = (0, F_c) alone; two rows take less than twice the steps of one."""
    asked = RingOperation(
        load=(4e3, 0.0, 8e3, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0), inner_speed=200.0
    )
    alone = replace(tapered(), side=1)
    found = tapered_loads(replace(alone, rows=rows("O", 5e-6)), asked)
    off = found.loads[0] < 1e-9 * found.loads.max()
    assert 5 < off.sum() < 38
    ways = [[-np.sin(alone.cup_angle), np.cos(alone.rib.angle)],
            [np.cos(alone.cup_angle), np.sin(alone.rib.angle)]]  # fmt: skip
    on_cup, on_rib = np.linalg.solve(ways, [0.0, found.speeds.centrifugal_force])
    assert found.loads[1, off] == approx(on_cup, rel=1e-6)
    assert found.rib_loads[off] == approx(on_rib, rel=1e-6)
    assert found.solution.evaluations < 2 * tapered_loads(alone, asked).solution.evaluations
