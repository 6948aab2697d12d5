"""Balls on two to four contacts with centrifugal force and gyroscopic moment."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.balance.balls.four_contacts import FourContacts
from quasidynamic.errors import NotSolved
from quasidynamic.four_point import RingLoad
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Groove
from quasidynamic.solve.balls.elastic_load_distribution import elastic_ball_loads
from quasidynamic.solve.balls.load_distribution import ball_loads, ball_loads_near
from quasidynamic.solve.balls.ring_on_balls import solve
from tests.ball_bearings import slow_bearing
from tests.quasidynamic.test_four_point_elastic import soft

QJ309 = slow_bearing(18.25e-3, 72.38e-3, 10, 35.0, 0.5165, 0.5305)  # of Joshi et al. (2015)
FAST = 10_000 * np.pi / 30
THRUST = np.array([2000.0, 0.0, 0.0, 0.0, 0.0])
MIXED = np.array([2000.0, 500.0, 3000.0, 20.0, -10.0])
LEVER = np.array([1.0, 1.0, 1.0, 72.38e-3 / 2, 72.38e-3 / 2])


def split_inner(shim=20.0, angle=35.0):
    """The same with one outer arc: shim angle [deg], contact angle [deg] under light thrust."""
    bearing, shim = QJ309.bearing, np.radians(shim)
    axial = (bearing.inner.conformity - 0.5) * bearing.ball.diameter * np.sin(shim)
    radial = bearing.centre_distance * np.cos(np.radians(angle))
    apart = np.hypot(axial, radial)
    middle = np.arctan2(axial, radial)
    return replace(bearing, outer_arches=1, contact_angle=middle, clearance=bearing.centre_distance - apart)


def single_diagonal(bearing, speed):
    """A bearing with two contacts of each ball, of the same stiffness: loads, angles, axial stiffness."""
    parts = {name: getattr(bearing, name) for name in ("ball", "inner", "outer", "balls", "pitch_diameter")}
    model = AngularContactBallBearing(
        bearing=AngularContactBearing(**parts, contact_angle=np.radians(35.0)), control="outer"
    )
    operation = RingOperation(load=tuple(THRUST), inner_speed=speed)
    balance = model.equations([operation])
    stiff = race_contacts(model.bearing, np.full(2, bearing.contact_angle))
    balance = replace(balance, contacts=stiff)
    (state,) = model.states([operation], balance, solve(balance))
    return state


@pytest.mark.parametrize("rpm", [0, 3000, 6000, 10_000])
def test_one_diagonal_is_that_of_the_angular_contact_bearing(rpm):
    """At 10 000 rpm the inner race begins to let go of balls, by 1e-8, otherwise in both models."""
    limit = 1e-9 if rpm < 10_000 else 1e-7
    bearing, speed = split_inner(), rpm * np.pi / 30
    found, known = ball_loads(bearing, THRUST, speed), single_diagonal(bearing, speed)
    assert found.loads[:, 0] == approx(known.loads.T, rel=limit)
    assert not found.loads[:, 1].any()
    assert found.angles[:, 0] == approx(known.contact_angles.T, rel=limit)
    assert found.centrifugal == approx(known.centrifugal_force, rel=limit)
    assert found.gyroscopic == approx(known.gyroscopic_moment, rel=limit)
    assert found.stiffness[:3, :3] == approx(known.stiffness[:3, :3], rel=10 * limit, abs=1e-3)


def test_split_inner_ring_at_speed_has_the_loads_of_its_diagonal():
    """258 and 407 N, 50.8 and 24.8 degrees: of an angular contact bearing with 35 degrees, outer control."""
    found = ball_loads(split_inner(), THRUST, FAST)
    assert found.loads[0, 0] == approx([258.0, 407.0], rel=0.01)
    assert np.degrees(found.angles[0, 0]) == approx([50.8, 24.8], rel=0.01)


def test_second_outer_arch_holds_balls_that_the_centrifugal_force_presses():
    """On one arc they would roll down to 25 degrees; the arches of a gothic groove meet before."""
    found = ball_loads(QJ309.bearing, THRUST, FAST)
    inner, outer = found.loads[0].T
    assert inner[0] == approx(329.5, rel=1e-3)
    assert inner[1] == 0.0
    assert outer == approx([430.9, 86.8], rel=0.01)


@pytest.mark.parametrize("load", [THRUST, MIXED])
def test_slow_balls_are_their_limit(load):
    still, slow = (ball_loads(QJ309.bearing, load, speed) for speed in (0.0, 1e-3))
    assert slow.loads == approx(still.loads, abs=1e-9 * still.loads.max())
    assert slow.displacement == approx(still.displacement, rel=1e-9, abs=1e-15)
    assert not still.centrifugal.any()


@pytest.mark.parametrize("speed", [0.0, 300.0, FAST, 3 * FAST])
def test_forces_and_moments_on_each_ball_and_ring_balance(speed):
    """Summed up again, contact by contact, with the tractions that the theory states."""
    bearing = QJ309.bearing
    found = ball_loads(bearing, MIXED, speed)
    side, largest = np.array([1, -1]), found.loads.max()
    towards = side[:, None] * [-1, 1] * np.sin(found.angles) + 1j * np.array([-1, 1]) * np.cos(found.angles)
    outer = found.loads[..., 1]
    tractions = 2 * found.gyroscopic[:, None] / bearing.ball.diameter * outer / outer.sum(1)[:, None]
    on_ball = -(found.loads * towards).sum((1, 2)) + (1j * tractions * towards[..., 1]).sum(1)
    assert np.abs(on_ball + 1j * found.centrifugal).max() < 1e-9 * largest
    by_inner = -(found.loads * towards)[..., 0].sum(1)
    cosine, sine, pitch = np.cos(bearing.azimuths), np.sin(bearing.azimuths), bearing.pitch_diameter / 2
    axial, radial = by_inner.real, by_inner.imag
    moments = axial @ cosine * pitch, -axial @ sine * pitch
    carried = [axial.sum(), radial @ sine, radial @ cosine, *moments]
    assert carried == approx(MIXED, abs=1e-9 * largest)


@pytest.mark.parametrize("speed", [0.0, FAST, 5 * FAST])
@pytest.mark.parametrize(
    "bearing",
    [QJ309.bearing, split_inner(), replace(QJ309.bearing, groove_ends=(0.5, 0.6))],
    ids=["gothic", "one arc", "on shoulders"],
)
def test_slopes_are_those_of_differences(bearing, speed):
    contacts, draw = FourContacts.of(bearing, speed), np.random.default_rng(1)
    approach = (
        1e-6 * draw.uniform(2, 15, (40, 2, 2)) * draw.choice([1, 1, -1], (40, 2, 2))
    )  # none at its edge
    length, angle = contacts.reach + approach, draw.uniform(0.1, 0.8, (40, 2, 2))
    if bearing.outer_arches == 1:
        angle[:, 1, 1] *= -1  # on the other half
    arms = length[..., None] * np.stack([np.sin(angle), np.cos(angle)], -1)
    balls = contacts.at(arms)
    pressed = (balls.forces.loads > 1.0).any(1).all(1)  # others are in no balance
    assert pressed.sum() > 10
    assert (balls.forces.loads[pressed] == 0.0).any()
    for component, step in enumerate(1e-9 * np.eye(8).reshape(8, 2, 2, 2)):
        up, down = contacts.at(arms + step), contacts.at(arms - step)
        races = (up.forces.on_races - down.forces.on_races).reshape(-1, 8)[pressed] / 2e-9
        excess = (up.excess - down.excess)[pressed] / 2e-9
        largest = np.abs(balls.force_slopes).max()
        assert balls.force_slopes[pressed, :, component] == approx(races, abs=1e-6 * largest)
        assert balls.excess_slopes[pressed, :, component] == approx(excess, abs=1e-6 * largest)


def test_stiffness_is_that_of_small_further_loads():
    found = ball_loads(QJ309.bearing, MIXED, FAST)
    further = 0.1 * LEVER
    for direction in np.diag(further):
        up, down = (ball_loads(QJ309.bearing, MIXED + sign * direction, FAST) for sign in (1, -1))
        change = (up.displacement - down.displacement) / 2
        assert found.stiffness @ change / further == approx(direction / further, abs=1e-5)


def test_one_step_from_known_loads_is_exact_to_first_order():
    known = ball_loads(QJ309.bearing, MIXED, FAST)
    errors = []
    for part in (1e-2, 1e-3):
        load, speed = MIXED * (1 + part), FAST * (1 - part)
        near, exact = (
            ball_loads_near(QJ309.bearing, load, known, speed),
            ball_loads(QJ309.bearing, load, speed),
        )
        errors.append(np.abs(near.loads - exact.loads).max())
    assert errors[1] < 0.03 * errors[0]


def test_centrifugal_force_moves_load_from_the_inner_to_the_outer_race():
    speeds = np.array([0.0, 0.5, 1.0, 2.0, 4.0]) * FAST
    found = [ball_loads(QJ309.bearing, THRUST, speed) for speed in speeds]
    outer = [each.loads[..., 1].sum() for each in found]
    inner = [each.loads[..., 0].sum() for each in found]
    assert (np.diff(outer) > 0).all()
    assert (np.diff(inner) < 0).all()
    play = [each.loads[0, 1, 1] for each in found]
    assert (np.diff(play) > 0).all()


def test_orbit_is_that_of_friction_where_balls_touch_four_times():
    """The motion that is assumed, against that in which the friction of all contacts is in balance."""
    bearing = replace(QJ309, bearing=replace(QJ309.bearing, clearance=-5e-6))
    state = bearing.solve(RingLoad(axial=2000.0, radial_z=3000.0), speed=FAST)
    friction = -state.balls.sliding.motion[:, 0] * FAST
    four = (state.distribution.loads > 100.0).all((1, 2))
    assert four.sum() > 2
    assert state.distribution.orbit[four] == approx(friction[four], rel=5e-3)


def test_inertia_acts_between_elastic_rings():
    """Rings without compliance are rigid ones; soft ones share the load otherwise, at speed as well."""
    bearing = slow_bearing(clearance=-10e-6, balls=6, ball=30e-3, pitch=0.2).bearing
    load, speed = np.array([1e4, 5e3, 2e4, 400.0, -300.0]), 500.0
    rigid = ball_loads(bearing, load, speed)
    stiff, elastic = (elastic_ball_loads(bearing, load, soft(6, size), speed) for size in (1e-20, 4e-10))
    assert stiff.loads == approx(rigid.loads, abs=1e-8 * rigid.loads.max())
    assert stiff.stiffness == approx(rigid.stiffness, abs=1e-7 * np.abs(rigid.stiffness).max())
    assert elastic.imbalance < 1e-9
    still = elastic_ball_loads(bearing, load, soft(6, 4e-10))
    assert (elastic.loads - still.loads)[..., 1].sum() > 0.5 * elastic.centrifugal.sum()


def test_ring_that_balls_have_left_is_refused():
    tight = replace(QJ309.bearing, clearance=-1e-6)
    assert ball_loads(tight, np.zeros(5)).loads.min() > 0
    with pytest.raises(NotSolved, match="left the inner ring"):
        ball_loads(tight, np.zeros(5), 3 * FAST)


@pytest.mark.parametrize("number", [20, pytest.param(100, marks=pytest.mark.slow)])
def test_random_fast_bearings_find_their_balance(number):
    """Light to heavy loads, one or two outer arches, to three million mm/min."""
    rng = np.random.default_rng(number + 7)
    for _ in range(number):
        ball = 10 ** rng.uniform(-2.7, -1.3)
        pitch = ball * 10 ** rng.uniform(0.6, 1.2)
        inner, outer = rng.uniform(0.51, 0.54, 2)
        bearing = slow_bearing(
            ball, pitch, balls=int(rng.integers(5, int(0.9 * np.pi * pitch / ball))),
            angle=rng.uniform(15, 45), conformity=inner, outer_conformity=outer,
            clearance=ball * rng.uniform(-0.3, 1) * 10 ** rng.uniform(-4, -3),
        ).bearing  # fmt: skip
        if rng.random() < 0.3:
            axial = (inner - 0.5) * ball * np.sin(rng.uniform(0.1, 0.5))
            radial = bearing.centre_distance * np.cos(rng.uniform(0.3, 0.7))
            free = bearing.centre_distance - np.hypot(axial, radial)
            bearing = replace(
                bearing, outer_arches=1, contact_angle=np.arctan2(axial, radial), clearance=free
            )
        load = rng.normal(size=5) * (rng.random(5) < 0.7) + 1e-3
        load *= 8e6 * ball**2 * bearing.balls * 10 ** rng.uniform(-4, -0.5)
        load[3:] *= pitch / 4
        speed = 10 ** rng.uniform(-1, 0.5) / pitch * 100 / 6  # n d_m of 0.1 to 3 million mm/min
        found = ball_loads(bearing, load, speed)
        assert found.imbalance < 1e-9


def test_groove_of_one_arc_counts_a_contact_once():
    """Under a radial load the most loaded ball lies in the middle of the arc, on one contact."""
    wide = Groove(conformity=0.52, material=QJ309.bearing.ball.material)
    bearing = replace(split_inner(), inner=wide, outer=wide, clearance=20e-6)
    found = ball_loads(bearing, np.array([0.0, 0.0, 3000.0, 0.0, 0.0]), 100.0)
    assert (found.loads[..., 1] > 0).sum(1).max() == 1
    assert found.loads[0, :, 1].sum() > found.loads[0, :, 0].max()
