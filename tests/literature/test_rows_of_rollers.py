"""A planet on two rows of cylindrical rollers against an independent program.

Source of the values: all rows in one potential of the ring's five displacements, 40 slices, law of Palmgren,
Newton's method by SciPy. The pin stands still and teeth push the planet with 24 kN towards -z; helical ones,
2.55 kN along the axis at a radius of 55 mm at sun and ring, also tilt it about z. Printed with one digit.
"""

import numpy as np
import pytest
from pytest import approx

from flexbearing import run
from quasidynamic import Cage, CylindricalRollerBearing, Material, Roller, RollerRow, static_loads
from quasidynamic.parts.profile import STRAIGHT, Crowned
from tests.literature.calculix import TWO_ROWS

PALMGREN = (2 * 0.91 / np.pi) * (3.81 / 3.84e-5) ** (1 / 0.9) * 1e6  # [Pa] E of 3.84e-5 Q^0.9 / l^0.8
STEEL = Material(youngs_modulus=PALMGREN, poisson_ratio=0.3, density=7800)
LENGTH, DISTANCE = 17e-3, 22e-3  # [m]
PARABOLA = Crowned(straight_length=0.0, crown_radius=(LENGTH / 2) ** 2 / 12e-6)  # 6 um at the ends
ROWS = (RollerRow(axial=-DISTANCE / 2), RollerRow(axial=DISTANCE / 2))
FORCE, COUPLE = 24e3, 280.5  # [N], [N m]
ACROSS = np.pi / 2  # the couple of helical teeth tilts across the load


def planet(rows=ROWS, clearance=0.0, profile=STRAIGHT):
    return CylindricalRollerBearing(
        rollers=14,
        outer_raceway_diameter=99e-3,
        clearance=clearance,
        roller=Roller(diameter=16e-3, length=LENGTH, material=STEEL, profile=profile),
        cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=5e-3),
        inner_ring=STEEL,
        outer_ring=STEEL,
        rows=rows,
    )


REAL = planet(clearance=40e-6, profile=PARABOLA)


def helical(bearing, couple=COUPLE):
    return static_loads(bearing, FORCE, moment=couple, tilt_direction=ACROSS, slices=40)


def moments(found):
    """Moments (2 rows, y and z) [N m] about the middle of each row that tilt the ring in both planes."""
    x = (np.arange(40) + 0.5) * LENGTH / 40 - LENGTH / 2
    of_rollers = (found.slice_loads * x).sum(-1) * LENGTH / 40
    phi = 2 * np.pi * np.arange(28) / 14
    return (of_rollers * [np.sin(phi), np.cos(phi)]).reshape(2, 2, 14).sum(-1).T


def test_one_row():
    """P0; two rows under twice the load have the loads of the one."""
    one = static_loads(planet(rows=(RollerRow(),)), FORCE / 2, slices=40)
    assert 1e6 * one.ring_displacement[1] == approx(12.329, abs=2e-3)
    assert one.loads[:5] == approx([3502.3, 3119.1, 2072.0, 659.5, 0.0], abs=0.06)
    assert 1e-6 * np.diag(one.stiffness) == approx([991.37, 1081.48], abs=0.02)
    two = static_loads(planet(), FORCE, slices=40)
    assert two.loads == approx(np.tile(one.loads, 2), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("bearing", "couple", "place", "tilt", "loads", "force", "own"),
    [
        pytest.param(planet(), COUPLE, 11.970, 950.08,
                     [3389.1, 1657.3, 306.7, 0.7, 0, 0, 0, 0, 0, 493.5, 2076.9, 3697.2, 4575.4, 4462.7],
                     10569.2, 23.989, id="P1 straight, no clearance"),
        pytest.param(REAL, COUPLE, 34.542, 2350.01,
                     [2967.2, 74.7, 0, 0, 0, 0, 0, 0, 0, 0, 433.9, 3250.2, 5440.2, 5490.6],
                     10194.9, 28.107, id="P2 crowned, 40 um"),
        pytest.param(REAL, 316.2, 33.767, 2528.05,
                     [2729.8, 2.3, 0, 0, 0, 0, 0, 0, 0, 0, 810.2, 3765.9, 5796.6, 5545.5],
                     11398.4, 32.718, id="R teeth at 62 mm"),
    ],
)  # fmt: skip
def test_helical_teeth(bearing, couple, place, tilt, loads, force, own):
    """Rows are loaded askew, each on its side, and carry what their own moments leave of the couple."""
    found = helical(bearing, couple)
    assert 1e6 * found.ring_displacement == approx([0.0, place], abs=2e-3)
    assert 1e6 * found.ring_tilt == approx([0.0, tilt], abs=0.06)
    mirrored = np.take(found.loads[14:], -np.arange(14))
    assert found.loads[:14] == approx(loads, abs=0.06)
    assert mirrored == approx(loads, abs=0.06)
    across = (found.loads * np.sin(2 * np.pi * np.arange(28) / 14)).reshape(2, 14).sum(1)
    assert across == approx([-force, force], abs=0.3)
    about = moments(found)[:, 0]
    assert about == approx([own, own], abs=2e-3)
    assert (across[1] * DISTANCE + about.sum()) == approx(couple, rel=1e-9)


def test_a_planet_that_is_held_straight_has_spur_loads():
    """P2s."""
    found = static_loads(REAL, FORCE, slices=40)
    assert 1e6 * found.ring_displacement[1] == approx(40.479, abs=2e-3)
    loads = [4850.4, 3567.4, 578.4, *[0] * 9, 578.4, 3567.4]
    assert found.loads == approx(loads * 2, abs=0.06)
    assert 1e-6 * np.diag(found.stiffness) == approx([667.38, 1945.12], abs=0.02)


def test_couple_in_the_plane_of_the_load():
    """Rows far apart carry F/2 + M/a and F/2 - M/a: what they hold by themselves is little."""
    far = planet(rows=(RollerRow(axial=-0.5), RollerRow(axial=0.5)))
    found = static_loads(far, FORCE, moment=6e3, slices=40)
    along = (found.loads * np.cos(2 * np.pi * np.arange(28) / 14)).reshape(2, 14).sum(1)
    own = moments(found)[:, 1].sum()
    assert along == approx([FORCE / 2 - (6e3 - own), FORCE / 2 + (6e3 - own)], rel=1e-9)
    assert along == approx([6e3, 18e3], rel=2e-3)


def test_a_row_with_room_leaves_the_other_alone():
    loose = planet(rows=(RollerRow(), RollerRow(axial=DISTANCE, clearance=1e-3)))
    one = static_loads(planet(rows=(RollerRow(),)), FORCE, slices=40)
    held = static_loads(loose, FORCE, slices=40)
    assert held.loads[:14] == approx(one.loads, rel=1e-9, abs=1e-9)
    assert held.loads[14:] == approx(0.0, abs=1e-6)  # what rounds the contact law


@pytest.mark.parametrize("ring", TWO_ROWS)
def test_two_rows_in_one_elastic_ring_as_a_whole_in_calculix(ring, tmp_path):
    """Of `python -m benchmarks.calculix_bearing`, whose settings these are; 0.5 % of the largest load."""
    load, *rows = TWO_ROWS[ring]
    settings = [
        "outer.kind=ring", "outer.thickness=4 mm", "outer.width=28 mm", "bearing.second_row.distance=14 mm",
        "accuracy.slices=10", "operation.inner_speed=1 rpm", f"operation.radial_load={load} N",
    ]  # fmt: skip
    if ring == "rim":
        settings += [
            "bearing.second_row.clearance=20 um", "operation.tilt=free", "operation.moment=0 N m",
            "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]',
            f'outer.tooth_tangential=["{load / 2} N", "{-load / 2} N"]', 'outer.tooth_radial=["0 N", "0 N"]',
        ]  # fmt: skip
    found = run("configs/nu209.toml", settings, output=tmp_path / "out.h5").flexible["outer_load"]
    assert np.abs(found.reshape(2, 14)[:, :8] - rows).max() < 5e-3 * np.max(rows)
