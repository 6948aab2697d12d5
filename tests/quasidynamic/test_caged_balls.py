"""What a cage makes balls in oil do."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.caged_ball import Pockets
from quasidynamic.balance.balls.race_control import LoadedContacts
from quasidynamic.contact.cage import ball_on_pocket_force
from quasidynamic.errors import ImpossiblePart
from quasidynamic.motion.ball_slip import ORBIT
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.ball_cage import BallCage
from quasidynamic.solve.balls.cage_speed import HeldCage, by_cage_speed
from quasidynamic.solve.balls.ring_on_balls import solve
from tests.quasidynamic.test_oiled_balls import BEARING, OILED, solved, thrust
from tests.random_balls import RPM, drawn_caged, identities, unbalanced

CAGE = BallCage(guidance="balls", pocket_clearance=0.15e-3, pocket_friction=0.05)
SLOW_SEEDS = [pytest.param(seed, marks=pytest.mark.slow) for seed in (220, 267)]
LAND = {"land_diameter": 60e-3, "land_width": 4e-3, "land_clearance": 0.4e-3}


def combined(speed, radial=300.0):
    """Axial and radial load without tilt; speed in rpm."""
    return RingOperation(
        load=(300.0, 0.0, radial, 0.0, 0.0),
        displacement=(None, None, None, 0.0, 0.0),
        inner_speed=speed * RPM,
    )


def caged(operation, cage=CAGE, lubrication=OILED):
    model = AngularContactBallBearing(bearing=BEARING, control="oil", lubrication=lubrication, cage=cage)
    return model.solve(operation)


def test_pocket_holds_a_ball_by_a_film_and_then_by_its_wall():
    places = np.array([-2e-4, 0.0, 1e-4, 2e-4])
    law = ball_on_pocket_force(places, 1.5e-4, 1e9)
    beyond = 11.0 / 1.5e-4 * 2e-4 + 1e9 * 5e-5**1.5
    assert law.force == approx([-beyond, 0.0, 11.0 * 2 / 3, beyond], rel=1e-12)
    step = 1e-9
    change = ball_on_pocket_force(places + step, 1.5e-4, 1e9).force
    change = change - ball_on_pocket_force(places - step, 1.5e-4, 1e9).force
    assert law.by_displacement == approx(change / (2 * step), rel=1e-6)


@pytest.mark.parametrize("inner_load", [0.02, 0.3, 40.0])
def test_slopes_of_the_loads_that_drive_a_ball_in_a_cage(inner_load):
    """By the load of the other race, too, where hardly anything presses the ball."""
    count = BEARING.balls
    model = AngularContactBallBearing(bearing=BEARING, control="oil", lubrication=OILED, cage=CAGE)
    control = model.equations([combined(10_000)]).control

    def driven(inner, outer):
        loads = np.array([np.full(count, inner), np.full(count, outer)])
        loads[:, 0] = 60.0  # the largest, from which the least load that drives is
        contacts = LoadedContacts(np.full((2, count), 0.5), loads, np.ones((2, count)))
        return control.driven(contacts, np.full(count, 2.0))

    here = driven(inner_load, 45.0)
    for column, step in ((0, (1e-6 * inner_load, 0.0)), (2, (0.0, 45e-6))):
        more, less = (driven(inner_load + s * step[0], 45.0 + s * step[1]) for s in (1, -1))
        by_load = (np.log(more.loads) - np.log(less.loads)) / (2 * sum(step))
        assert here.chain[1:, [0, 2], column].T == approx(by_load[:, 1:], rel=1e-6, abs=1e-9)


def test_slopes_of_pockets_by_the_motion():
    pockets = Pockets(
        cage=CAGE, stop=1e9, ball_radius=4e-3, pitch_radius=27e-3,
        advance=np.full(2, 0.02), outer_speed=np.zeros(2), base=np.full(2, 0.4), speed=np.array([0.03, 0.04]),
    )  # fmt: skip
    motion = np.array([[-0.431, 3.0, 0.5, 0.1], [-0.42, 2.0, -0.7, 0.0]])

    def at(motion, pockets=pockets):
        return pockets.forces(motion, pockets.lead(0.0, motion[:, ORBIT]))

    forces = at(motion)
    for k in range(4):
        step = 1e-7 * np.eye(4)[k]
        change = (at(motion + step).left - at(motion - step).left) / 2e-7
        assert change == approx(forces.slopes[:, :, k], rel=1e-5, abs=1e-7)
    faster = at(motion, pockets.at_speed(pockets.speed + 1e-7)).left
    slower = at(motion, pockets.at_speed(pockets.speed - 1e-7)).left
    assert (faster - slower) / 2e-7 == approx(forces.slopes[:, :, ORBIT], rel=1e-5, abs=1e-7)


def test_balls_that_are_alike_do_not_feel_a_cage_that_nothing_brakes():
    alone, in_cage = solved(thrust(300.0, 15000.0)), caged(thrust(300.0, 15000.0))
    for name in ("orbital_speed", "ball_speed", "attitude", "loads", "contact_angles", "tractions"):
        assert getattr(in_cage, name) == approx(getattr(alone, name), rel=1e-9), name
    assert in_cage.oil.heat == approx(alone.oil.heat, rel=1e-9)
    assert in_cage.oil.cage_speed == approx(alone.orbital_speed, rel=1e-9)
    assert np.abs(in_cage.oil.pocket_displacement).max() < 1e-9 * CAGE.pocket_clearance


def test_a_cage_without_land_and_friction_has_the_mean_speed_of_its_balls():
    state = caged(combined(15000.0), replace(CAGE, pocket_friction=0.0))
    assert np.ptp(state.orbital_speed) > 1e-4 * state.orbital_speed.mean()
    assert np.abs(state.oil.pocket_displacement).max() < CAGE.pocket_clearance  # the film is linear there
    assert state.oil.cage_speed == approx(state.orbital_speed.mean(), rel=1e-12)


def test_lands_brake_or_drive_a_cage():
    outer, balls, inner = (
        caged(combined(15000.0), replace(CAGE, guidance=name, **LAND)) for name in ("outer", "balls", "inner")
    )
    assert outer.oil.cage_speed[0] < balls.oil.cage_speed[0] < inner.oil.cage_speed[0]
    assert outer.oil.land_torque[0] < 0 < inner.oil.land_torque[0]
    for state in (outer, balls, inner):
        power, _, cage = identities(state)
        assert abs(power) < 1e-9
        assert cage < 1e-9
    assert (outer.oil.land_heat > 0).all()
    assert (inner.oil.pocket_heat > 0).all()


def test_momentum_of_the_rings_is_that_of_the_drag_also_with_a_cage():
    still = replace(OILED, churning_gap=None)
    land = replace(CAGE, guidance="outer", **LAND)
    assert identities(caged(combined(15000.0), land, still))[1] < 1e-9


def test_a_mirrored_sense_mirrors_the_cage():
    land = replace(CAGE, guidance="outer", **LAND)
    forward, back = (caged(combined(speed), land) for speed in (12000.0, -12000.0))
    assert back.oil.cage_speed == approx(-forward.oil.cage_speed, rel=1e-10)
    mirrored = -back.oil.pocket_force
    assert mirrored == approx(forward.oil.pocket_force, rel=1e-6, abs=1e-8)
    assert back.oil.land_torque == approx(-forward.oil.land_torque, rel=1e-9)


def test_idle_balls_at_one_turn_a_minute_stay_in_their_pockets():
    state = caged(combined(1.0, radial=2000.0))
    assert (state.loads[0] == 0).any()
    assert np.abs(state.oil.pocket_displacement).max() < 2 * CAGE.pocket_clearance
    assert abs(identities(state)[0]) < 1e-9


def test_light_balls_in_a_cage_are_guided_by_what_presses_them():
    """A third of the centrifugal force on the inner race drives a ball, as a cage carries what cannot."""
    light = caged(thrust(60.0, 25000.0))
    assert (light.loads[0] < 0.4 * light.centrifugal_force).all()
    assert light.guided.all()
    idle = caged(combined(1.0, radial=2000.0))
    assert (idle.guided == (idle.loads[0] > 0)).all()


def test_a_cage_needs_oil():
    with pytest.raises(ImpossiblePart, match="cage"):
        AngularContactBallBearing(bearing=BEARING, control="outer", cage=CAGE)
    with pytest.raises(ImpossiblePart, match="land_diameter"):
        BallCage(guidance="outer", pocket_clearance=1e-4, pocket_friction=0.1)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(20))
def test_random_bearings_with_a_cage_are_in_balance(seed):
    model, operation = drawn_caged(seed)
    state = model.solve(operation)
    assert unbalanced(state) < 2e-9
    power, _, cage = identities(state)
    assert abs(power) < 1e-9
    assert cage < 1e-9


@pytest.mark.parametrize("seed", [48, 120, 122, 135, 164, 435, *SLOW_SEEDS])
def test_light_loads_in_a_cage_are_solved(seed):
    """Balls with two motions (48, 120), idle ones that friction could not drive, a cage that lags (220, 267).

    Torques of no more than rounding of speeds (122), contacts that hardly slip (435).
    """
    test_random_bearings_with_a_cage_are_in_balance(seed)


def test_digits_of_the_lead_are_not_those_of_the_speeds():
    pockets = Pockets(
        cage=CAGE, stop=1e9, ball_radius=4e-3, pitch_radius=27e-3,
        advance=np.full(1, 0.02), outer_speed=np.zeros(1), base=np.full(1, 0.4), speed=np.zeros(1),
    )  # fmt: skip
    tiny = np.full(1, 1e-25)
    assert pockets.lead(np.full(1, -0.4), tiny) == approx(-tiny, rel=1e-12)
    assert pockets.at_speed(tiny).lead(np.full(1, -0.4), np.zeros(1)) == approx(-tiny, rel=1e-12)


@pytest.mark.slow
def test_thrust_falls_with_the_cage():
    """At 40 000 rpm: 27.2 N at -18.7 um, 6.27 N at -19.2 um; a held ring has three motions between."""

    def pressed(place):
        held = RingOperation(
            load=(0.0,) * 5, displacement=(place, 0.0, 0.0, 0.0, 0.0), inner_speed=40e3 * RPM
        )
        state = caged(held)
        return state.ring_load[0], state.orbital_speed[0] / held.inner_speed

    (much, fast), (little, slow) = pressed(-18.7e-6), pressed(-19.2e-6)
    assert (much, fast) == approx((27.2, 0.314), rel=0.01)
    assert (little, slow) == approx((6.27, 0.1332), rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize(("place", "count"), [(-10e-6, 0), (-18.85e-6, 1), (-19.5e-6, 0)])
def test_stable_motions_of_a_held_ring(place, count):
    """Where the thrust falls with the cage a fast one and a slow one are stable; a given load finds each."""
    held = RingOperation(load=(0.0,) * 5, displacement=(place, 0.0, 0.0, 0.0, 0.0), inner_speed=40e3 * RPM)
    model = AngularContactBallBearing(bearing=BEARING, control="oil", lubrication=OILED, cage=CAGE)
    others = model.other_motions(model.solve(held))
    assert len(others) == count
    for other in others:
        operation = replace(thrust(other.ring_load[0], 40e3), displacement=(None, 0.0, 0.0, 0.0, 0.0))
        loaded = caged(operation)
        assert loaded.ring_displacement[0] == approx(place, abs=1e-10)
        assert loaded.oil.cage_speed[0] == approx(other.oil.cage_speed[0], rel=1e-4)


@pytest.mark.slow
def test_a_given_load_has_a_motion_also_where_the_place_turns_back():
    """Faster balls push the ring back: its place has a least value near 20 N and a largest near 12 N."""

    def under(load):
        operation = replace(thrust(load, 40e3), displacement=(None, 0.0, 0.0, 0.0, 0.0))
        state = caged(operation)
        power, _, cage = identities(state)
        assert abs(power) < 1e-9
        assert cage < 1e-9
        assert unbalanced(state) < 2e-9
        return state.ring_displacement[0] * 1e6, state.oil.cage_speed[0] / operation.inner_speed

    places, cages = np.transpose([under(load) for load in (20.0, 12.0, 7.0)])
    assert places == approx([-18.914, -18.792, -19.104], abs=0.002)
    assert cages == approx([0.2587, 0.1899, 0.1412], rel=1e-3)


def test_torque_on_a_held_cage_turns_round_at_the_speed_of_its_balance():
    """Ring and balls are in balance at any speed of the cage, of which one balances it."""
    operation = replace(thrust(300.0, 15000.0), displacement=(None, 0.0, 0.0, 0.0, 0.0))
    free = caged(operation)
    speed = free.oil.cage_speed[0] / operation.inner_speed
    model = AngularContactBallBearing(bearing=BEARING, control="oil", lubrication=OILED, cage=CAGE)
    found, _ = by_cage_speed(model.equations([operation]), solve)
    assert found.ring[0, 0] == approx(free.ring_displacement[0], rel=1e-7)
    held = HeldCage(model.equations([operation]), solve)
    assert held.torque(0.99 * speed) > 1e-3
    assert held.torque(1.01 * speed) < -1e-3
