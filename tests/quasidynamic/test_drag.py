"""Oil and air that brake rollers and cage."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.contact.cage import couette_factor
from quasidynamic.contact.cage.land import ECCENTRICITY_LIMIT, land_drag, land_force, land_notes, land_torque
from quasidynamic.contact.drag.churning import churning_torque, cylinder_churning, end_face_churning
from quasidynamic.contact.drag.orbit_drag import (
    AIR_DENSITY,
    cylinder_drag,
    drag_notes,
    mixture_density,
    orbit_drag_force,
)
from quasidynamic.parts.material import Material
from quasidynamic.parts.oil_properties import Lubricant
from quasidynamic.parts.roller_bearing import Cage, CylindricalRollerBearing, Roller

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
ROLLER = Roller(diameter=5e-3, length=5e-3, material=STEEL)
OIL = Lubricant(
    temperature=493.15, viscosity=1.137e-3, pressure_viscosity=8.75e-9, temperature_viscosity=7.26e-3,
    conductivity=0.1205, density=835,
)  # fmt: skip
CAGE = Cage(
    guidance="outer", pocket_friction=0.05, thickness=2.5e-3, mass=0.025, land_diameter=74.6e-3,
    land_width=3e-3, land_clearance=0.4e-3, land_flow="vortices",
)  # fmt: skip
ROLLER_GUIDED = Cage(guidance="rollers", pocket_friction=0.05, thickness=2.5e-3, mass=0.025)
BEARING = CylindricalRollerBearing(
    rollers=30, outer_raceway_diameter=74.975e-3, clearance=0.0, roller=ROLLER, cage=CAGE, inner_ring=STEEL,
    outer_ring=STEEL,
)  # fmt: skip
CAGE_SPEED, SPIN = 1847.5, 27703.0  # [rad/s] at 38 000 rpm
CLEARANCE = 0.2e-3  # [m] radial, of the land
MIX = {"oil_fraction": 0.03, "gap": 0.2e-3}

signed = st.tuples(st.sampled_from([-1.0, 1.0]), st.floats(-3, 5)).map(
    lambda v: v[0] * 10.0 ** v[1]
)  # [rad/s]
offsets = st.tuples(st.floats(0.0, 1.2), st.floats(-3.14, 3.14)).map(
    lambda v: CLEARANCE * v[0] * np.array([np.sin(v[1]), np.cos(v[1])])
)


def difference(function, value, step):
    return (function(value + step) - function(value - step)) / (2 * step)


# ---- rollers across the stream


def test_drag_coefficient_of_the_table():
    reynolds = np.array([0.1, 1, 10, 100, 1e3, 1e4, 1e5, 2e5, 3e5, 4e5, 5e5, 1e6])
    printed = [60, 10, 3, 1.8, 1.0, 1.2, 1.2, 1.2, 0.9, 0.65, 0.3, 0.3]
    assert cylinder_drag(reynolds)[0] == approx(printed, rel=1e-12)
    assert cylinder_drag(np.array([0.0, 1e8]))[0] == approx([60, 0.3], rel=1e-12)


def test_drag_coefficient_at_engine_speed():
    """V = 64.64 m/s: Re = 2.37e5, C_d = 1.073."""
    speed = CAGE_SPEED * BEARING.pitch_diameter / 2
    reynolds = OIL.density * ROLLER.diameter * speed / OIL.viscosity
    assert speed == approx(64.64, rel=1e-4)
    assert reynolds == approx(2.37e5, rel=2e-3)
    assert cylinder_drag(reynolds)[0] == approx(1.073, abs=2e-3)


def test_drag_of_a_roller_at_engine_speed():
    """0.015 rho_oil C_d V^2 l D/2 = 0.70 N, a mixture of 3 percent of the oil's density."""
    fraction = (0.03 * OIL.density - AIR_DENSITY) / (OIL.density - AIR_DENSITY)
    assert mixture_density(OIL, fraction) == approx(0.03 * OIL.density, rel=1e-12)
    assert orbit_drag_force(CAGE_SPEED, BEARING, OIL, fraction)[0] == approx(0.70, abs=5e-3)


def test_mixture_lies_between_air_and_oil():
    assert mixture_density(OIL, 0.0) == AIR_DENSITY
    assert mixture_density(OIL, 1.0) == OIL.density


def test_drag_of_several_cage_speeds_at_once():
    speeds = np.array([[-1847.5], [0.0], [1e-3], [50.0], [1847.5]])
    force, slope = orbit_drag_force(speeds, BEARING, OIL, 0.03)
    assert force.shape == slope.shape == (5, 1)
    for each, one, its_slope in zip(speeds[:, 0], force[:, 0], slope[:, 0], strict=True):
        assert orbit_drag_force(float(each), BEARING, OIL, 0.03) == approx((one, its_slope), rel=1e-14)
    assert force[1] == slope[1] == 0.0
    assert force[0] == -force[4]


@given(speed=signed)
def test_slope_of_the_roller_drag(speed):
    knots = np.array([0.1, 1, 10, 100, 1e3, 1e4, 1e5, 2e5, 3e5, 4e5, 5e5, 1e6])
    per_speed = OIL.density * ROLLER.diameter / OIL.viscosity * BEARING.pitch_diameter / 2
    if np.abs(np.log(abs(speed) * per_speed / knots)).min() < 1e-4:
        return  # the slope jumps there, and the docstring says so
    value, slope = orbit_drag_force(speed, BEARING, OIL, 0.03)
    numeric = difference(lambda w: orbit_drag_force(w, BEARING, OIL, 0.03)[0], speed, 1e-5 * abs(speed))
    assert slope * speed == approx(numeric * speed, rel=1e-6, abs=1e-6 * abs(float(value)))


def test_leaving_the_table_is_told():
    assert drag_notes(np.array([0.1, 1e3, 1e6])) == ()
    assert "1.2e+06" in drag_notes(np.array([1e3, 1.2e6]))[0].text
    assert "0.05" in drag_notes(0.05)[0].text


# ---- vortices and turbulence


def test_a_slow_film_is_laminar():
    assert couette_factor(np.array(0.0), 0.005) == (1.0, 0.0)
    assert couette_factor(np.array(50.0), 0.005).factor == approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("reynolds", "gap_ratio", "printed"),
    [
        (1000.0, 0.1, 1.3 * (1000 * np.sqrt(0.1) / 41) ** 0.539474),
        (2.5e4, 1e-6, 3.0 * (2.5e4 / 2500) ** 0.85596),
        (2500.0, 1e-8, 3.0),
    ],
    ids=["Taylor vortices", "turbulent", "turbulent at 2500"],
)
def test_friction_factors_as_printed(reynolds, gap_ratio, printed):
    """Away from the corners the smooth maximum is the printed branch."""
    assert couette_factor(np.array(reynolds), gap_ratio).factor == approx(printed, rel=2e-2)


@given(st.floats(0.0, 6.0), st.floats(-4.0, -0.5))
def test_smooth_maximum_stays_close_to_the_sharp_one(reynolds, gap_ratio):
    re, ratio = 10.0**reynolds, 10.0**gap_ratio
    sharp = max(1.0, 1.3 * (re * np.sqrt(ratio) / 41) ** 0.539474, 3.0 * (re / 2500) ** 0.85596)
    assert sharp * (1 - 1e-12) <= couette_factor(np.array(re), ratio).factor <= sharp * 3 ** (1 / 8)


@given(st.floats(-3.0, 6.0))
def test_slope_of_the_friction_factor(power):
    numeric = difference(lambda p: np.log(couette_factor(10.0 ** np.array(p), 0.005).factor), power, 1e-5)
    assert couette_factor(np.array(10.0**power), 0.005).slope == approx(numeric / np.log(10), abs=1e-8)


# ---- land of the cage


def test_petroff():
    """Radius 37.3 mm, width 3 mm, gap 0.2 mm, 220 degC: 1.027e-2 N m."""
    assert land_drag(CAGE, OIL) * CAGE_SPEED == approx(1.027e-2, rel=1e-3)


def test_slow_land_turns_as_petroff_says():
    assert land_torque(np.array(1e-3), CAGE, OIL).torque == approx(1e-3 * land_drag(CAGE, OIL), rel=1e-9)


def test_fast_land_is_turbulent():
    """Re = 1.01e4 at 38 000 rpm: 3 (Re/2500)^0.856 = 9.9 times the torque of Petroff."""
    reynolds = OIL.density * 37.3e-3 * CAGE_SPEED * CLEARANCE / OIL.viscosity
    raised = 3.0 * (reynolds / 2500) ** 0.85596
    assert raised == approx(9.9, abs=0.1)
    assert land_torque(np.array(CAGE_SPEED), CAGE, OIL).torque == approx(raised * 1.027e-2, rel=0.02)
    laminar = replace(CAGE, land_flow="laminar")
    assert land_torque(np.array(CAGE_SPEED), laminar, OIL).torque == approx(1.027e-2, rel=1e-3)


def test_eccentric_land_turns_harder():
    """e = 0.5: laminar 1.19e-2 N m."""
    ratio = (
        land_torque(np.array(CAGE_SPEED), CAGE, OIL, 0.5).torque / land_torque(CAGE_SPEED, CAGE, OIL).torque
    )
    assert ratio * 1.027e-2 == approx(1.19e-2, rel=5e-3)


@given(speed=signed, eccentricity=st.floats(0.0, 1.5))
def test_slopes_of_the_land_torque(speed, eccentricity):
    land = land_torque(np.array(speed), CAGE, OIL, np.array(eccentricity))
    opposite = land_torque(np.array(-speed), CAGE, OIL, np.array(eccentricity))
    assert opposite.torque == -land.torque
    assert opposite.by_speed == land.by_speed
    faster = difference(lambda w: land_torque(w, CAGE, OIL, eccentricity).torque, speed, 1e-5 * abs(speed))
    assert land.by_speed == approx(faster, rel=1e-7)
    if 1e-6 < abs(eccentricity - ECCENTRICITY_LIMIT):
        wider = difference(lambda e: land_torque(speed, CAGE, OIL, e).torque, eccentricity, 1e-7)
        assert land.by_eccentricity == approx(wider, rel=1e-4, abs=1e-7 * abs(float(land.torque)))


def test_short_bearing_forces_of_the_land():
    """One land of 3 mm, e = 0.5: F_r = 0.0235 N back to the centre, F_t = 0.0320 N ahead, towards +phi."""
    upwards = np.array([0.0, 0.5 * CLEARANCE])  # along z; +phi turns z into y
    tangential, radial = land_force(upwards, CAGE_SPEED, CAGE, OIL, lands=1).force
    assert radial == approx(-0.0235, abs=5e-5)
    assert tangential == approx(0.0320, abs=5e-5)


def test_two_half_lands_carry_a_quarter():
    offset = np.array([0.1e-3, 0.05e-3])
    one, two = (land_force(offset, 1e3, CAGE, OIL, lands).force for lands in (1, 2))
    assert two == approx(one / 4, rel=1e-12)


def test_reversed_cage_is_pushed_back_all_the_same():
    offset = np.array([0.0, 0.1e-3])
    ahead, reverse = (land_force(offset, u, CAGE, OIL).force for u in (1e3, -1e3))
    assert reverse == approx(ahead * [-1, 1], rel=1e-12)


@given(offset=offsets, speed=signed)
def test_slopes_of_the_land_force(offset, speed):
    if abs(np.hypot(*offset) / CLEARANCE - 0.95) < 1e-5:
        return  # the slope of the tangent's slope jumps there
    land = land_force(offset, speed, CAGE, OIL)
    size = np.abs(land.by_offset).max()
    for component in (0, 1):
        step = 1e-6 * CLEARANCE * np.eye(2)[component]
        numeric = (
            land_force(offset + step, speed, CAGE, OIL).force
            - land_force(offset - step, speed, CAGE, OIL).force
        ) / (2e-6 * CLEARANCE)
        assert land.by_offset[:, component] == approx(numeric, rel=1e-5, abs=5e-6 * size)
    assert land.by_speed * speed == approx(land.force, rel=1e-12)


@given(angle=st.floats(-3.14, 3.14), speed=signed)
def test_land_force_turns_with_the_offset(angle, speed):
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    offset = np.array([0.03e-3, 0.1e-3])
    plain = land_force(offset, speed, CAGE, OIL).force
    assert land_force(turn @ offset, speed, CAGE, OIL).force == approx(
        turn @ plain, rel=1e-9, abs=1e-12 * np.abs(plain).max()
    )


def test_lands_of_several_cases_at_once():
    offset = np.array([[0.0, 0.0], [0.1e-3, 0.0], [0.15e-3, -0.1e-3]])
    speed = np.array([1e3, 0.0, -500.0])
    together = land_force(offset, speed, CAGE, OIL)
    assert together.by_offset.shape == (3, 2, 2)
    for case in range(3):
        alone = land_force(offset[case], speed[case], CAGE, OIL)
        for joint, single in zip(together, alone, strict=True):
            assert joint[case] == approx(single, rel=1e-14)
    assert together.force[0] == approx(0.0, abs=1e-300)


def test_rollers_that_guide_leave_the_land_alone():
    assert land_drag(ROLLER_GUIDED, OIL) == 0.0
    assert not np.any(land_torque(np.ones(3), ROLLER_GUIDED, OIL).torque)
    assert land_force(np.ones((3, 2)), 1.0, ROLLER_GUIDED, OIL).by_offset.shape == (3, 2, 2)


def test_a_land_that_touches_is_told():
    assert land_notes(np.array([0.0, 0.99])) == ()
    assert "0.997" in land_notes(np.array([0.1, 0.997]))[0].text


# ---- spinning rollers


def test_slow_roller_is_braked_by_a_laminar_film():
    """2 pi eta r^3 l omega / c, Petroff again."""
    laminar = 2 * np.pi * OIL.viscosity * 2.5e-3**3 * 5e-3 / 0.2e-3
    assert cylinder_churning(np.array(1e-3), ROLLER, OIL, 0.2e-3).torque == approx(1e-3 * laminar, rel=1e-9)


@pytest.mark.parametrize(
    ("reynolds", "coefficient"),
    [(1e3, 3.87 / np.sqrt(1e3)), (1e7, 0.146 / 1e7**0.2)],
    ids=["laminar", "turbulent"],
)
def test_end_faces_are_free_discs(reynolds, coefficient):
    spin = reynolds * OIL.viscosity / OIL.density / 2.5e-3**2
    torque = end_face_churning(np.array(spin), ROLLER, OIL).torque
    assert torque == approx(coefficient * 0.5 * OIL.density * spin**2 * 2.5e-3**5, rel=5e-3)


def test_churning_is_that_of_the_mixture():
    whole, thin = (
        churning_torque(np.array(SPIN), ROLLER, OIL, oil_fraction=x, gap=0.2e-3).torque for x in (1.0, 0.0)
    )
    assert thin / whole == approx(AIR_DENSITY / OIL.density, rel=1e-12)
    parts = (
        cylinder_churning(np.array(SPIN), ROLLER, OIL, 0.2e-3),
        end_face_churning(np.array(SPIN), ROLLER, OIL),
    )
    assert whole == approx(parts[0].torque + parts[1].torque, rel=1e-12)


def test_churning_at_engine_speed_is_small():
    """At 3 percent of oil some hundredths of a newton at the roller's surface."""
    assert churning_torque(np.array(SPIN), ROLLER, OIL, **MIX).torque / 2.5e-3 == approx(0.016, abs=0.004)


@given(spin=signed)
def test_slope_and_oddness_of_churning(spin):
    state, opposite = (churning_torque(np.array(w), ROLLER, OIL, **MIX) for w in (spin, -spin))
    assert opposite.torque == -state.torque
    assert opposite.by_spin == state.by_spin > 0
    numeric = difference(
        lambda w: churning_torque(np.array(w), ROLLER, OIL, **MIX).torque, spin, 1e-5 * abs(spin)
    )
    assert state.by_spin == approx(numeric, rel=1e-7)


def test_churning_starts_smoothly():
    rest, creep = (churning_torque(np.array(w), ROLLER, OIL, **MIX) for w in (0.0, 1e-9))
    assert rest.torque == 0.0
    assert creep.by_spin == approx(rest.by_spin, rel=1e-3)
    assert churning_torque(np.zeros((4, 30)), ROLLER, OIL, **MIX).by_spin.shape == (4, 30)
