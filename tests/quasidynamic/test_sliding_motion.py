"""Friction and motion of balls that slide on two or four contacts."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.contact.ellipse.full_sliding import (
    Ellipse,
    no_slip_positions,
    sliding_friction,
    slip_field,
)
from quasidynamic.contact.ellipse.point_contact import point_contact, race_curvatures
from quasidynamic.contact.ellipse.rigid_slip import SPIN, Spin, rigid_slip, sagitta
from quasidynamic.errors import ImpossiblePart, OutOfRange
from quasidynamic.motion.ball_slip import (
    SIDE,
    BallContacts,
    pressed_height,
    pressed_radius,
    slip_by_motion,
    slip_of,
)
from quasidynamic.outcome.ball_torque import race_torques
from quasidynamic.parts.ball import FrictionCurve
from quasidynamic.solve.balls.sliding_motion import sliding_motion
from tests.ball_bearings import one_ball, slow_bearing

RADIUS = 5e-3  # [m] R


def ellipse(across=0.6e-3, along=0.12e-3, traction=100.0, spin: Spin = "centre"):
    return Ellipse(np.array([across]), np.array([along]), np.array([RADIUS]), np.array([traction]), spin)


spins = pytest.mark.parametrize("spin", ["centre", "local"])


def slip(centre, roll, spin, across=0.6e-3):
    """From numbers of the size of one: slips over the sagitta of the contact and over its spin."""
    sag = across**2 / (2 * RADIUS)
    return np.array([[centre * sag * roll, roll, spin * sag * roll / across]])


slips = st.tuples(st.floats(-0.5, 1.5), st.floats(0.5, 20.0), st.floats(-20.0, 20.0)).map(lambda s: slip(*s))
smooth = st.tuples(st.floats(0.05, 0.8), st.floats(0.5, 20.0), st.floats(1.0, 20.0)).map(lambda s: slip(*s))


def summed(own, contact, points=400):
    """Heat, force and moments by a plain sum over a fine mesh (midpoints in ring-shaped coordinates)."""
    a, b = contact.across[0], contact.along[0]
    u = (np.arange(points) + 0.5) / points
    rho, angle = np.meshgrid(u, 2 * np.pi * u, indexing="ij")
    x, y = a * rho * np.cos(angle), b * rho * np.sin(angle)
    area = a * b * rho / points * 2 * np.pi / points
    along, across = slip_field(own, contact, x, y)
    limit = 1.5 * contact.traction[0] / (np.pi * a * b) * np.sqrt(1 - rho**2)
    shear, cross = (-limit * part / np.hypot(along, across) for part in (along, across))
    units = np.moveaxis(rigid_slip(x, y, np.array([RADIUS]), contact.spin)[..., :3], -1, 0)
    parts = [-(shear * unit[..., 0] + cross * unit[..., 1]) for unit in units]
    return (-(shear * along + cross * across) * area).sum(), np.array([(part * area).sum() for part in parts])


@spins
@pytest.mark.parametrize(
    "own", [slip(0.2, 3.0, 0.5), slip(0.0, 3.0, 8.0), slip(-0.3, 9.0, 0.1)], ids=["two lines", "spin", "none"]
)
def test_friction_is_that_of_a_plain_sum(own, spin):
    contact = ellipse(spin=spin)
    found, (power, moments) = sliding_friction(own, contact), summed(own, contact)
    size = np.array([100.0, 100.0 * 0.6e-3**2 / RADIUS, 100.0 * 0.6e-3])
    assert found.power[0] == approx(power, rel=1e-4)
    assert found.by_slip[0] / size == approx(moments / size, abs=5e-4)


@spins
@settings(max_examples=25)
@given(own=smooth)
def test_force_is_the_slope_of_the_heat_and_curvature_that_of_the_force(own, spin):
    contact = ellipse(spin=spin)
    found = sliding_friction(own, contact)
    curvature, _ = found.curvatures()
    for component in range(3):
        step = np.zeros(3)
        step[component] = 1e-5 * max(abs(own[0, component]), abs(slip(0.1, own[0, 1], 1.0)[0, component]))
        up, down = (sliding_friction(own + sign * step, contact) for sign in (1, -1))
        length = 2 * step[component]
        slope = (up.power - down.power)[0] / length
        assert found.by_slip[0, component] * length == approx(slope * length, abs=1e-8 * found.power[0])
        rise = (up.by_slip - down.by_slip)[0]
        scale = np.sqrt(np.diagonal(curvature[0]))
        assert curvature[0, component] * length / scale == approx(
            rise / scale, abs=2e-3 * length * scale[component]
        )


@spins
@given(here=slips, there=slips)
def test_heat_lies_between_its_tangent_and_its_majorant(here, there, spin):
    contact = ellipse(spin=spin)
    found, step = sliding_friction(here, contact), (there - here)[0]
    _, majorant = found.curvatures()
    tangent = found.power[0] + found.by_slip[0] @ step
    heat = sliding_friction(there, contact).power[0]
    assert tangent <= heat * (1 + 1e-8)
    assert heat <= (tangent + step @ majorant[0] @ step / 2) * (1 + 1e-8)


@given(slips)
def test_no_slip_where_the_closed_form_says(own):
    sag = np.abs(own).max() * 0.6e-3**2 / RADIUS
    for x in no_slip_positions(own, np.array([RADIUS])):
        if abs(x[0]) < 0.9e-3 and own[0, 2] ** 2 * RADIUS**2 + 2 * RADIUS * own[0, 1] * own[0, 0] > 1e-9:
            assert own[0, 0] + own[0, 1] * sagitta(x, np.array(RADIUS))[0] + own[0, 2] * x[0] == approx(
                0, abs=1e-9 * sag
            )


@given(slips, st.floats(1e-6, 1e6), st.floats(1e-3, 1e3))
def test_force_depends_on_friction_but_not_on_speed(own, speed, friction):
    one = sliding_friction(own, ellipse())
    other = sliding_friction(speed * own, ellipse(traction=100.0 * friction))
    assert other.by_slip / friction == approx(one.by_slip, rel=1e-9, abs=1e-12)
    assert other.power / (friction * speed) == approx(one.power, rel=1e-9)


@pytest.mark.parametrize(("lower", "upper"), [(-0.7, 0.1), (-0.3, 0.6), (-2.0, 0.1)])
def test_spin_moment_of_a_narrow_contact_follows_its_rolling_lines(lower, upper):
    """Two lines: 3/8 mu Q a [2(c1^2-c2^2) - (c1^4-c2^4)], one line: 3/8 mu Q a (1-c2^2)^2 (Rivera 22, 23)."""
    a = 0.05e-3
    contact = ellipse(across=a, along=1e-6 * a, traction=100.0)
    roll = -1.0  # v = A sigma + ... is proportional to (x - c1 a)(x - c2 a)
    own = np.array([[lower * upper * a**2 / (2 * RADIUS), roll, -(lower + upper) * a / (2 * RADIUS)]])
    c1 = max(lower, -1.0)
    two, one = 2 * (c1**2 - upper**2) - (c1**4 - upper**4), (1 - upper**2) ** 2
    printed = two if lower > -1.0 else one
    assert sliding_friction(own, contact).by_slip[0, SPIN] == approx(3 / 8 * 100.0 * a * printed, rel=1e-3)


BEARING = slow_bearing()
EITHER = st.sampled_from([BEARING, slow_bearing(spin="local")])  # spin that makes slip across
loads = st.tuples(st.floats(0.0, 4.0), st.floats(0.0, 4.0)).map(lambda powers: [10 * 10**p for p in powers])
angles = st.tuples(st.floats(5.0, 75.0), st.floats(5.0, 75.0)).map(list)


@settings(max_examples=25)
@given(EITHER, angles, loads)
def test_torque_is_the_same_on_both_rings_and_the_heat_per_speed(bearing, angle, load):
    balls = one_ball(bearing, angle, load)
    inner, outer = balls.torques.total[0]
    assert inner == approx(balls.sliding.power[0], rel=1e-8)
    assert outer == approx(-inner, rel=1e-8)


@settings(max_examples=15)
@given(EITHER, angles, loads)
def test_diagonals_are_mirror_images(bearing, angle, load):
    one, other = one_ball(bearing, angle, load), one_ball(bearing, angle[::-1], load[::-1])
    assert other.torque == approx(one.torque, rel=1e-8)
    assert other.axis_angle + one.axis_angle == approx(2 * np.pi, abs=1e-6)
    assert other.ball_speed == approx(one.ball_speed, rel=1e-6)


@settings(max_examples=15)
@given(angles, loads, st.floats(-3.0, 0.0))
def test_torque_is_linear_in_the_friction_coefficient(angle, load, power):
    less = one_ball(slow_bearing(friction=0.1 * 10**power), angle, load).torque
    assert less / 10**power == approx(one_ball(BEARING, angle, load).torque, rel=1e-9)


@settings(max_examples=15)
@given(EITHER, angles, loads, st.integers(0, 2**31))
def test_no_other_motion_makes_less_heat(bearing, angle, load, seed):
    balls = one_ball(bearing, angle, load)
    best = balls.sliding
    change = np.random.default_rng(seed).normal(size=(1, 3)) * 10 ** np.linspace(-6, 0, 3)
    moved = slip_of(best.motion + change * best.motion, slip_by_motion(balls.contacts))
    assert sliding_friction(moved, balls.ellipse).power.sum() >= best.power[0] * (1 - 1e-9)


def test_a_diagonal_without_load_is_none():
    alone = one_ball(BEARING, [40.0], [2000.0])
    idle = one_ball(BEARING, [40.0, 30.0], [2000.0, 0.0])
    assert idle.torque == approx(alone.torque, rel=1e-10)
    assert idle.axis_angle == approx(alone.axis_angle, abs=1e-8)


def test_ball_without_load_does_nothing():
    angle = np.full((2, 1, 2), 0.7)
    balls = BEARING.slide(angle, np.array([[[500.0, 500.0]], [[0.0, 0.0]]]))
    assert balls.sliding.driven.tolist() == [True, False]
    assert np.isnan(balls.ball_speed[1])
    assert balls.ball_torques[1] == 0.0
    assert balls.torque == balls.ball_torques[0] > 0.0
    assert balls.torques.total[1].tolist() == [0.0, 0.0]


def test_balls_side_by_side_are_each_alone():
    many = [([30.0, 40.0], [900.0, 300.0]), ([45.0, 45.0], [500.0, 500.0]), ([10.0, 60.0], [20.0, 2000.0])]
    shape = (3, 2, 2)
    angle, load = (np.broadcast_to(np.array([m[i] for m in many])[..., None], shape) for i in (0, 1))
    together = BEARING.slide(np.radians(angle), load)
    assert together.ball_torques == approx([one_ball(BEARING, *m).torque for m in many], rel=1e-9)


def test_ball_of_a_radial_bearing_rolls_without_spin():
    """At a contact angle of zero the axes are parallel and the heat is that of Heathcote's slip alone."""
    balls = one_ball(BEARING, [0.0], [2000.0])
    assert balls.axis_angle == approx(np.pi, abs=1e-6)
    assert balls.torques.spin == approx(np.zeros((1, 2)), abs=1e-9 * balls.torque)
    slightly = one_ball(BEARING, [0.01], [2000.0])
    assert slightly.torque == approx(balls.torque, rel=1e-3)


def test_circumferential_traction_alone_misses_what_lateral_slip_adds():
    """By a seventh where the ellipse is wide and the ball spins (ED20), by little else."""
    wide = one_ball(slow_bearing(7.14e-3, 31e-3, 3, conformity=0.57, modulus=207e9), [15.0], [772.7])
    assert wide.torques.circumferential[0, 0] / wide.torque == approx(0.91, abs=0.02)
    assert abs(wide.torques.circumferential[0, 1]) / wide.torque == approx(0.87, abs=0.02)


def test_hysteresis_adds_three_sixteenths_of_the_loss_per_rolling_contact():
    plain, lossy = (one_ball(slow_bearing(loss=loss), [45.0], [1000.0]) for loss in (0.0, 0.01))
    b = lossy.ellipse.along[0, 0]
    rolling = np.abs(lossy.sliding.slip[0, 0, :, 1])
    assert lossy.torque - plain.torque == approx(3 / 16 * 0.01 * 1000.0 * (b * rolling).sum(), rel=1e-9)


def test_friction_against_pressure_and_a_word_outside_it():
    curve = FrictionCurve(pressures=(1e9, 2e9), coefficients=(0.1, 0.2))
    between = one_ball(slow_bearing(friction=curve), [45.0], [2000.0])
    pressure = between.peak_pressure[0, 0]
    assert between.friction[0, 0] == approx(0.1 + 0.1 * (pressure - 1e9) / 1e9, rel=1e-12)
    assert between.notes == ()
    outside = one_ball(slow_bearing(friction=curve), [45.0], [1.0])
    assert outside.friction.tolist() == [[[0.1, 0.1]]]
    assert "outside the 1 to 2 GPa" in outside.notes[0].text


def test_impossible_balls_are_refused():
    with pytest.raises(ImpossiblePart, match="must both be"):
        BEARING.slide(np.zeros((1, 2)), np.zeros((1, 2)))
    with pytest.raises(ImpossiblePart, match=">= 0"):
        one_ball(BEARING, [45.0], [-1.0])
    with pytest.raises(OutOfRange, match=r"95.0 deg: balls leave their grooves"):
        one_ball(BEARING, [95.0], [1.0])
    with pytest.raises(OutOfRange, match="far too high"):
        one_ball(slow_bearing(conformity=0.501), [45.0], [1e8])
    with pytest.raises(ImpossiblePart, match="hysteresis_loss"):
        slow_bearing(loss=-0.1)
    with pytest.raises(ImpossiblePart, match="grow"):
        FrictionCurve(pressures=(2e9, 1e9), coefficients=(0.1, 0.2))


def test_shear_field_of_a_contact_carries_its_force():
    balls = one_ball(BEARING, [45.0, 45.0], [1000.0, 800.0])
    field = balls.field(0, 0, 1, points=401)
    cell = np.ptp(field["x"]) * np.ptp(field["y"]) / 400**2
    size = np.hypot(field["shear_along"], field["shear_across"]).sum() * cell
    assert size == approx(0.1 * 1000.0, rel=1e-3)


def random_balls(number, seed):
    """Sizes over two decades, angles of 2 to 80 degrees, loads from that of 3 GPa down to 1e-5 of it."""
    rng = np.random.default_rng(seed)
    shape = (number, 2, 2)
    diameter = 10 ** rng.uniform(-3, -1, (number, 1, 1))
    pitch = diameter * 10 ** rng.uniform(0.45, 2, (number, 1, 1))
    angle = np.radians(rng.uniform(2, 80, (number, 2, 1))) * np.ones(shape)
    same = rng.random(number) < 0.5
    angle[same, 1] = angle[same, 0]
    groove = diameter * rng.uniform(0.505, 0.6, (number, 1, 2))
    hertz = point_contact(race_curvatures(diameter, groove, pitch, angle, SIDE), 230e9)
    heaviest = (3e9 / hertz.peak_pressure(np.ones(shape)).max((1, 2), keepdims=True)) ** 3
    load = heaviest * 10 ** rng.uniform(-5, 0, (number, 1, 1)) * np.ones(shape)
    weaker = 10 ** rng.uniform(-4, 0, number)
    weaker[rng.random(number) < 0.2] = 0.0
    load[np.arange(number), rng.integers(0, 2, number)] *= weaker[:, None]
    across, along = hertz.semi_axes(load)
    radius = np.broadcast_to(pressed_radius(diameter / 2, groove), shape)
    height = pressed_height(diameter / 2, radius, across)
    contacts = BallContacts(diameter[:, 0, 0] / 2, pitch[:, 0, 0] / 2, angle, height)
    return contacts, Ellipse(across, along, radius, 0.1 * load)


@pytest.mark.parametrize("number", [150, pytest.param(1000, marks=pytest.mark.slow)])
def test_random_balls_find_their_balance(number):
    contacts, contact = random_balls(number, seed=number)
    found = sliding_motion(contacts, contact)
    total = race_torques(contacts, found.slip, contact).total
    assert found.driven.all()
    assert found.imbalance.max() < 1e-9
    assert total[:, 0] == approx(found.power, rel=1e-8)
    assert total[:, 1] == approx(-found.power, rel=1e-8)
