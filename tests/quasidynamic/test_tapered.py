"""Tapered rollers: printed values of an independent program, closed forms, limits and balances.

The values come from a plain program of its own (slices, Hertz rib, one convex potential; N, mm), of a bearing
with Z 19, D 10.5, L 15.5, d_m 71 mm, 40 slices, whose load law has 3.84e-5 of Palmgren for both contacts.
"""

from dataclasses import dataclass, replace
from math import radians

import numpy as np
import pytest
from pytest import approx

from quasidynamic import (
    Cage,
    CylindricalRollerBearing,
    Material,
    NotSolved,
    Rib,
    RingOperation,
    Roller,
    TaperedRollerBearing,
    static_loads,
    tapered_loads,
)
from quasidynamic.balance.rollers.inclined import InclinedRollers
from quasidynamic.contact.line.slices import Slices
from quasidynamic.motion.tapered_speeds import tapered_speeds
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.profile import STRAIGHT
from quasidynamic.parts.tapered_bearing import apex_angles, spherical_rib
from quasidynamic.tapered import least_thrust
from tests.random_tapered import drawn

RPM = np.pi / 30
BY_PALMGREN = 2 * (1 - 0.3**2) / np.pi / (3.84e-5 / 3.81) ** (1 / 0.9) * 1e6  # [Pa] modulus of 3.84e-5
STEEL = Material(youngs_modulus=BY_PALMGREN, poisson_ratio=0.3, density=7800)
NEWTON_PER_MM = 10**4.5  # N/mm^1.5 in N/m^1.5
STRAIGHTENED = (None, None, None, 0.0, 0.0)
ARCMIN = radians(2 / 60)


@dataclass(frozen=True)
class Crown:
    """A parabola."""

    end: float  # [m]

    def drop(self, position, length):
        return self.end * (2 * position / length) ** 2


def tapered(crown=4e-6, **changes):
    roller = Roller(
        diameter=10.5e-3, length=15.5e-3, material=STEEL, profile=Crown(crown) if crown else STRAIGHT
    )
    parts = {
        "rollers": 19, "pitch_diameter": 71e-3, "cup_angle": radians(15.6422), "cone_angle": radians(11.6462),
        "roller": roller, "inner_ring": STEEL, "outer_ring": STEEL, "side": -1,
        "rib": Rib(angle=radians(12.2434), stiffness=1.850367e6 * NEWTON_PER_MM, lever=3.48554e-3,
                   depth=3.675e-3, curvature=1 / 150.33e-3),
    }  # fmt: skip
    return TaperedRollerBearing(**{**parts, **changes})


def flat_ended(crown=None):
    """A bearing whose rib has the lever of a flat end; its apexes do not meet."""
    roller = Roller(
        diameter=10.5e-3, length=15e-3, material=STEEL, profile=Crown(crown) if crown else STRAIGHT
    )
    return tapered(
        rollers=17, pitch_diameter=62.5e-3, cup_angle=radians(14), cone_angle=radians(9), roller=roller,
        rib=Rib(angle=radians(11.5), stiffness=4e5 * NEWTON_PER_MM, lever=4.2e-3, depth=4.2e-3),
    )  # fmt: skip


def solved(bearing, axial, radial=0.0, held=(None,) * 5, speed=0.0):
    load = (1e3 * axial, 0.0, 1e3 * radial, 0.0, 0.0)
    return tapered_loads(bearing, RingOperation(load=load, displacement=held, inner_speed=speed * RPM))


FAST = 10_000
PRINTED = {  # bearing, loads [kN] and what is held: place [um, urad], held moments [N m], Q_o, Q_f [N], K
    "TA": (
        tapered(None), (-10,), (-29.516, 0, 0, 0, 0), (0, 0), [1952.0], [136.03],
        (377.95, 2410.41, 2410.41, 284.700, 284.700, -23655)),
    "TA2": (
        tapered(), (-10,), (-39.227, 0, 0, 0, 0), (0, 0), [1952.0], [136.03],
        (375.52, 2394.91, 2394.91, 280.986, 280.986, -23503)),
    "TB": (
        tapered(), (-10, 15, STRAIGHTENED), (-38.249, 0, 6.530, 0, 0), (-147.208, 0),
        [3653.7, 3554.6, 3269.8, 2834.7, 2303.3, 1740.5, 1215.3, 810.2, 554.4, 434.3],
        [254.63, 247.72, 227.87, 197.55, 160.52, 121.30, 84.69, 56.47, 38.64, 30.27],
        (345.99, 2298.24, 2114.95, 241.764, 267.193, -20755)),
    "TC": (
        tapered(), (-10, 15), (0.425, 0, 74.985, 6449.37, 0), (0, 0),
        [5042.0, 4713.7, 3777.6, 2378.4, 760.7, 0, 388.3, 958.4, 1402.4, 1643.5], [351.38],
        (174.17, 953.41, 1268.14, 144.622, 99.569, None)),
    "TD": (
        tapered(), (-10, 15, (None, None, None, ARCMIN, 0.0)), (-37.680, 0, 12.472, 581.78, 0),
        (-125.027, 0), [3683.9, 3580.5, 3283.2, 2829.8, 2277.1, 1694.7, 1174.6, 805.4, 580.4, 476.4],
        [256.73], (343.43, 2272.69, 2107.77, 270.205, 276.316, None)),
    "TD2": (
        tapered(), (-10, 15, (None, None, None, 0.0, ARCMIN)), (-37.794, -5.709, 6.648, 0, 581.78),
        (-147.208, 25.622), [3651.3, 3551.5, 3264.6, 2826.7, 2295.5, 1752.3, 1253.4, 837.0, 539.6, 397.8],
        [254.46], (336.45, 2208.63, 2082.82, 238.299, 254.686, None)),
    "TE": (
        tapered(), (-10, 0, (None,) * 5, FAST), (-38.767, 0, 0, 0, 0), (0, 0), [1952.0], [151.11],
        (374.85, 2390.65, 2390.65, 280.434, 280.434, None)),
    "TF": (
        tapered(), (-10, 15, STRAIGHTENED, FAST), (-37.728, 0, 6.566, 0, 0), (-147.228, 0),
        [3656.9, 3557.4, 3271.2, 2834.2, 2300.6, 1735.8, 1210.4, 809.2, 557.1, 439.6],
        [269.93, 262.99, 243.05, 212.60, 175.41, 136.05, 99.43, 71.47, 53.90, 45.71],
        (342.89, 2284.42, 2089.21, 238.509, 265.269, -20510)),
    "TG": (
        tapered(None), (-10, 15, (None, None, None, ARCMIN, 0.0), FAST), (-28.039, 0, 12.224, 581.78, 0),
        (-120.131, 0), [3658.5, 3558.9, 3272.5, 2835.2, 2301.4, 1736.7, 1209.2, 781.7, 550.4, 468.8],
        [270.04], (346.20, 2333.70, 2082.12, 272.474, 280.882, None)),
    "T1": (
        flat_ended(), (-8,), (-35.267, 0, 0, 0, 0), (0, 0), [1945.2], [169.70],
        (255.87, 2058.03, 2058.03, 161.84, 161.84, -15646.6)),
    "T2": (
        flat_ended(), (-4, 8), (0.089, 0, 30.876, 3025.7, 0), (0, 0),
        [2579.6, 2384.8, 1836.2, 1039.1, 173.9, 137.1, 334.4, 492.4, 579.5],
        [225.04, 208.04, 160.19, 90.65, 15.17, 11.96, 29.17, 42.95, 50.55],
        (122.82, 946.59, 1029.12, 76.741, 65.400, None)),
    "T3": (
        flat_ended(), (-4, 8, (None,) * 5, FAST), (4.438, 0, 33.145, 3247.8, 0), (0, 0),
        [2631.5, 2422.5, 1835.0, 985.9, 123.1, 143.4, 342.3, 504.2, 595.0],
        [239.05, 220.82, 169.56, 95.49, 20.22, 21.99, 39.35, 53.47, 61.39],
        (105.26, 738.85, 954.43, 68.662, 49.781, None)),
    "T5": (
        flat_ended(6e-6), (-4, 8), (-3.213, 0, 40.563, 4336.6, 0), (0, 0),
        [2754.1, 2515.2, 1845.0, 883.0, 75.2, 7.9, 264.1, 564.9, 734.9],
        [240.26, 219.42, 160.96, 77.03, 6.56, 0.69, 23.04, 49.28, 64.11], None),
}  # fmt: skip


@pytest.mark.parametrize(
    ("bearing", "asked", "place", "moments", "outer", "rib", "stiffness"), PRINTED.values(), ids=PRINTED
)
def test_bearing_of_the_independent_program(bearing, asked, place, moments, outer, rib, stiffness):
    found = solved(bearing, *asked)
    assert found.displacement * 1e6 == approx(place, rel=2e-5, abs=6e-3)
    assert found.load[3:] == approx(moments, rel=0, abs=1e-3)
    assert found.loads[1][: len(outer)] == approx(outer, rel=0, abs=0.06)
    assert found.rib_loads[: len(rib)] == approx(rib, rel=0, abs=0.011)
    if stiffness:
        *diagonal, coupled = stiffness
        assert np.diag(found.stiffness) / [1e6, 1e6, 1e6, 1e3, 1e3] == approx(diagonal, rel=1e-4)
        if coupled:
            assert found.stiffness[2, 3] / 1e3 == approx(coupled, rel=5e-5)


def test_speeds_and_inertia_of_pure_rolling():
    speeds = tapered_speeds(tapered(), FAST * RPM)
    assert speeds.orbit == approx(448.305, rel=2e-6)
    assert speeds.spin == approx(3463.09, rel=2e-6)
    assert speeds.centrifugal_force == approx(74.691, rel=1e-5)
    assert speeds.gyroscopic_moment == approx(59.169e-3, rel=1e-5)
    assert speeds.rib_sliding == approx((1047.2 - 448.3) * 33.75e-3 - 3463 * 3.675e-3, rel=1e-3)


def test_pressed_ends_of_a_straight_roller():
    line_loads = solved(tapered(None), -10).slice_loads[:, 0] / 1e3  # of straight rollers, N/mm
    assert line_loads[1, [0, -1]] == approx([131.7, 120.2], abs=0.06)
    assert line_loads[0, [0, -1]] == approx([120.0, 131.5], abs=0.06)


def test_pure_thrust_is_a_closed_form():
    bearing = replace(tapered(), side=1)
    found = solved(bearing, 10)
    inner, outer, rib = found.loads[0], found.loads[1], found.rib_loads
    cone, cup, face = bearing.cone_angle, bearing.cup_angle, bearing.rib.angle
    assert outer == approx(1e4 / 19 / np.sin(cup), rel=1e-9)
    assert inner * np.sin(cone) + rib * np.cos(face) == approx(outer * np.sin(cup), rel=1e-9)
    assert inner * np.cos(cone) - rib * np.sin(face) == approx(outer * np.cos(cup), rel=1e-9)


def test_a_gap_moves_the_ring_and_nothing_else():
    bearing, gap = tapered(), 20e-6
    tight, loose = (solved(replace(bearing, clearance=clearance), -10) for clearance in (0.0, gap))
    cone, cup, face = bearing.cone_angle, bearing.cup_angle, bearing.rib.angle
    way = gap / 2 * np.cos(cone) / np.sin(cup) * np.cos(cup - face) / np.cos(cone - face)
    assert loose.displacement[0] - tight.displacement[0] == approx(-way, rel=1e-9)
    assert loose.loads == approx(tight.loads, rel=1e-9)


@pytest.mark.parametrize(
    ("profile", "moment", "digits"), [(STRAIGHT, 0.0, 1e-9), (Crown(3.5e-6), 10.0, 1e-8)]
)
def test_angle_zero_is_the_cylindrical_roller(profile, moment, digits):
    """To where contact begins, which is rounded at each contact here and at both together there."""
    roller = Roller(diameter=10e-3, length=9.601e-3, material=STEEL, profile=profile)
    cylinder = CylindricalRollerBearing(
        rollers=14, outer_raceway_diameter=75.032e-3, clearance=41e-6, roller=roller, inner_ring=STEEL,
        outer_ring=STEEL, cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=5e-3, mass=0.1),
    )  # fmt: skip
    same = tapered(
        rollers=14, pitch_diameter=65.032e-3, clearance=41e-6, roller=roller, cup_angle=0.0, cone_angle=0.0,
        rib=Rib(angle=0.0, stiffness=1e13, lever=0.0, depth=4e-3),
    )  # fmt: skip
    expected = static_loads(cylinder, 8e3, moment=moment, slices=20)
    tilt = -expected.ring_tilt[0]  # about y is -dz/dx
    held = (0.0, None, None, tilt, 0.0)
    found = tapered_loads(same, RingOperation(load=(0, 0, 8e3, 0, 0), displacement=held), slices=20)
    assert found.loads[0] == approx(expected.loads, rel=digits, abs=1e-5)
    assert found.displacement[1:3] == approx(expected.ring_displacement, rel=digits, abs=1e-15)
    assert found.load[3] == approx(-moment, rel=1e-7, abs=1e-6)
    assert found.stiffness[1:3, 1:3] == approx(expected.stiffness, rel=1e-5, abs=1.0)


def test_scaled_bearing_has_scaled_loads():
    """Lengths times k, forces times k^2: the load law of Palmgren is not quite of this form."""
    bearing, factor = replace(tapered(None), contact_law="iso16281"), 2.0
    exponent = factor ** (8 / 9 + 10 / 9)  # of the forces at displacements times k
    roller = replace(bearing.roller, diameter=factor * 10.5e-3, length=factor * 15.5e-3)
    rib = replace(bearing.rib, stiffness=bearing.rib.stiffness * factor**0.5, lever=factor * 3.48554e-3)
    large = replace(bearing, pitch_diameter=factor * 71e-3, roller=roller, rib=rib)
    held = (-30e-6, 0.0, 10e-6, 2e-4, 0.0)
    larger = (-30e-6 * factor, 0.0, 10e-6 * factor, 2e-4, 0.0)
    first, second = (
        tapered_loads(each, RingOperation(displacement=place))
        for each, place in ((bearing, held), (large, larger))
    )
    assert second.loads == approx(exponent * first.loads, rel=1e-9)
    assert second.rib_loads == approx(exponent * first.rib_loads, rel=1e-7)


def test_forces_are_the_derivatives_of_each_other():
    bearing = tapered()
    model = InclinedRollers.of(bearing, Slices(40, bearing.roller.length), np.array([0.0, 70.0, 7.0]))
    ring, step = np.array([-38e-6, 1e-6, 7e-6, 2e-6, -1e-6]), 1e-11
    rollers = 0.4 * (model.sections @ ring)
    state = model.at(ring, rollers)
    for column in range(3):
        moved = np.zeros(3)
        moved[column] = step
        ahead, behind = (model.at(ring, rollers + sign * moved) for sign in (1, -1))
        change = -(ahead.excess - behind.excess) / (2 * step)
        assert state.stiffness[:, :, column] == approx(change, rel=1e-5, abs=1e3)
        by_ring = (ahead.on_ring - behind.on_ring) / (2 * step)
        assert state.by_ring[:, :, column] == approx(by_ring, rel=1e-5, abs=1e3)


def test_a_cone_that_grows_with_its_rib_is_as_one_that_is_closer():
    """By u/tan(alpha_o), with the rollers u higher on the cup: what fits do to end play and preload."""
    grown, bearing = 8e-6, tapered()
    along = grown / np.tan(bearing.cup_angle)
    slices, dead = Slices(40, bearing.roller.length), np.array([0.0, 70.0, 7.0])
    ring = np.array([-38e-6, 1e-6, 7e-6, 2e-6, -1e-6])
    cold = InclinedRollers.of(bearing, slices, dead)
    rollers = 0.4 * (cold.sections @ ring) - [along / 2, 0.0, 0.0]
    closer = InclinedRollers.of(replace(bearing, rows=(RowPlace(closer=along),)), slices, dead)
    warm = replace(cold, shifts=np.tile([0.0, grown, 0.0], (bearing.rollers, 1)))
    same, found = closer.at(ring, rollers), warm.at(ring, rollers + np.array([along, grown, 0.0]))
    assert np.abs(same.on_ring).max() > 1e3
    assert found.on_ring == approx(same.on_ring, rel=1e-9, abs=1e-6)
    assert found.excess == approx(same.excess, rel=1e-9, abs=1e-6)


def test_stiffness_is_that_of_differences():
    bearing, held = tapered(), np.array([-38e-6, 1e-6, 7e-6, 2e-4, -1e-4])
    step = np.array([1e-9, 1e-9, 1e-9, 1e-8, 1e-8])

    def reaction(place):
        found = tapered_loads(bearing, RingOperation(displacement=tuple(place), inner_speed=FAST * RPM))
        return -found.reaction

    state = tapered_loads(bearing, RingOperation(displacement=tuple(held), inner_speed=FAST * RPM))
    differences = np.array([
        (reaction(held + step * unit) - reaction(held - step * unit)) / (2 * step @ unit)
        for unit in np.eye(5)
    ]).T  # fmt: skip
    assert state.stiffness == approx(differences, rel=1e-4, abs=1e-4 * np.abs(differences).max())
    assert state.stiffness == approx(state.stiffness.T, rel=1e-12, abs=1e-3)


@pytest.mark.parametrize("seed", range(12))
def test_random_bearings_are_in_balance(seed):
    bearing, asked = drawn(seed)
    found = tapered_loads(bearing, asked)
    cone, cup, rib = bearing.cone_angle, bearing.cup_angle, bearing.rib
    inner, outer, axial = *found.loads, found.rib_loads
    centrifugal, lift = found.speeds.centrifugal_force, found.speeds.gyroscopic_moment
    size = 1e-9 * max(outer.max(), np.abs(found.load[:3]).max())
    along = inner * np.sin(cone) - outer * np.sin(cup) + axial * np.cos(rib.angle)
    across = outer * np.cos(cup) - inner * np.cos(cone) + axial * np.sin(rib.angle) - centrifugal
    moments = found.slice_loads * found.slices.widths @ found.slices.centres
    turning = moments[1] - moments[0] + axial * rib.lever - lift
    assert along == approx(0.0, abs=size)
    assert across == approx(0.0, abs=size)
    assert turning == approx(0.0, abs=size * bearing.roller.length)
    towards = np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)])
    on_ring = [-bearing.side * (inner * np.sin(cone) + axial * np.cos(rib.angle)).sum()]
    on_ring += [*towards @ (axial * np.sin(rib.angle) - inner * np.cos(cone))]
    assert np.array(on_ring) + found.load[:3] == approx(0.0, abs=len(inner) * size)


def test_an_axial_load_that_is_too_small_has_no_balance():
    bearing = tapered()
    least = least_thrust(bearing, 15e3, 0.0)
    assert least == approx(15e3 * np.tan(bearing.cup_angle), rel=1e-12)
    assert solved(bearing, -1.05e-3 * least, 15, STRAIGHTENED).loads.max() > 0
    with pytest.raises(NotSolved, match="the cone leaves the cup") as why:
        solved(bearing, -0.999e-3 * least, 15, STRAIGHTENED)
    assert why.value.outcome == "undetermined"


def test_one_apex():
    axis, cone = apex_angles(radians(15.6422), 10.5 / 71)
    assert np.degrees([axis, cone]) == approx([13.6442, 11.6462], abs=5e-3)
    assert np.sin(2 * (radians(15.6422) - axis)) == approx(2 * 10.5 / 71 * np.sin(axis), rel=1e-12)


def test_rib_of_a_spherical_end():
    steel = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
    roller = Roller(diameter=10.5e-3, length=15.5e-3, material=steel)
    rib = spherical_rib(roller, radians(13.6442), radians(12.2434), 150.330e-3, steel)
    assert rib.stiffness / NEWTON_PER_MM == approx(1.850367e6, rel=2e-6)
    assert rib.depth == approx(3.675e-3, rel=1e-4)
    assert rib.lever == approx(3.48554e-3, rel=1e-4)
