"""Angular-contact ball bearings: balance, stiffness, symmetry, limits, refusals."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material
from quasidynamic.solve.step_length import SolverOutcome
from tests.ball_bearings import fast_bearing
from tests.random_balls import drawn_pair, unbalanced

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
BEARING = fast_bearing(22.23e-3, 125.26e-3, 16, np.radians(40.0), 0.5232, 0.5265)

LOAD = (9000.0, 1000.0, 3000.0, 100.0, -50.0)
FREE = (None,) * 5
CONTROLS = pytest.mark.parametrize("control", ["outer", "inner", "equal"])


def solved(load=LOAD, speed=1000.0, control="outer", bearing=BEARING, friction=None, **changes):
    operation = RingOperation(load=load, inner_speed=speed, **changes)
    return AngularContactBallBearing(bearing=bearing, control=control, friction=friction).solve(operation)


def ring_load(state):
    """Load from the contact forces of the balls, by vectors from the plane of the inner groove centres."""
    own, azimuth = state.bearing, state.bearing.azimuths
    axial, radial = np.array([[1.0, 0.0, 0.0]]).T, np.array([0 * azimuth, np.sin(azimuth), np.cos(azimuth)])
    sine, cosine = np.sin(state.contact_angles[0]), np.cos(state.contact_angles[0])
    normal, along = sine * axial + cosine * radial, cosine * axial - sine * radial
    force = state.loads[0] * normal + state.tractions[0] * along  # the ring on the balls
    centre = own.inner_groove_radius * radial
    point = -own.inner.conformity * own.ball.diameter * normal  # of the contact from the groove centre
    moment = np.cross(centre, (force * axial) * axial, axis=0) + np.cross(
        point, state.tractions[0] * along, axis=0
    )
    return np.concatenate([force.sum(1), moment.sum(1)[1:]])


@CONTROLS
@pytest.mark.parametrize("speed", [0.0, 1000.0, -1500.0])
def test_balls_carry_the_load_of_the_ring(control, speed):
    state = solved(speed=speed, control=control)
    scale = np.array([1.0, 1.0, 1.0, 0.06, 0.06]) * state.loads.max()
    assert ring_load(state) / scale == approx(np.array(LOAD) / scale, abs=1e-10)
    assert state.ring_load / scale == approx(np.array(LOAD) / scale, abs=1e-10)


@CONTROLS
def test_every_ball_is_in_balance(control):
    state = solved(control=control)
    (inner, outer), load, traction = state.contact_angles, state.loads, state.tractions
    axial = load[0] * np.sin(inner) - load[1] * np.sin(outer)
    axial += traction[0] * np.cos(inner) - traction[1] * np.cos(outer)
    radial = load[0] * np.cos(inner) - load[1] * np.cos(outer) + state.centrifugal_force
    radial += traction[1] * np.sin(outer) - traction[0] * np.sin(inner)
    moment = state.bearing.ball.diameter / 2 * traction.sum(0)
    assert np.abs([axial, radial]).max() < 1e-10 * load.max()
    assert moment == approx(state.gyroscopic_moment, rel=1e-12)
    assert (state.gyroscopic_moment > 0).all()


@CONTROLS
def test_stiffness_is_the_derivative_of_the_load(control):
    state = solved(control=control)
    place, units = state.ring_displacement, np.array([1.0, 1.0, 1.0, 1 / 0.06, 1 / 0.06])
    model = AngularContactBallBearing(bearing=BEARING, control=control)

    def load_at(shift):
        held = RingOperation(displacement=tuple(place + shift), inner_speed=1000.0)
        return model.solve(held).ring_load

    columns = []
    for k in range(5):
        step = 2e-8 * units * np.eye(5)[k]
        columns.append((load_at(step) - load_at(-step)) / (2 * step[k]))
    size = np.abs(state.stiffness).max() / np.outer(units, units)
    assert (
        np.abs(np.array(columns).T - state.stiffness)[np.ix_([0, 1, 2], [0, 1, 2])].max() < 1e-6 * size[0, 0]
    )
    assert (np.abs(np.array(columns).T - state.stiffness) < 1e-6 * np.abs(state.stiffness).max()).all()


def test_stiffness_is_symmetric_at_rest_and_not_at_speed():
    def skew(matrix):
        scaled = matrix / np.outer(*[[1.0, 1.0, 1.0, 0.06, 0.06]] * 2)
        return np.abs(scaled - scaled.T).max() / np.abs(scaled).max()

    assert skew(solved(speed=0.0).stiffness) < 1e-13
    assert skew(solved(speed=1000.0).stiffness) > 1e-5


def test_slow_bearing_tends_to_the_static_one():
    rest = solved(speed=0.0)
    gaps = [
        np.abs(solved(speed=n).ring_displacement - rest.ring_displacement).max() for n in (40.0, 20.0, 10.0)
    ]
    assert gaps[0] / gaps[1] == approx(4.0, rel=0.01)  # inertia grows as the square of speed
    assert gaps[1] / gaps[2] == approx(4.0, rel=0.01)


def test_thrust_at_rest_in_closed_form():
    """Every ball the same, on the line of the groove centres: K (L - A)^1.5 sin(alpha) = F/Z."""
    state = solved(load=(9000.0, 0.0, 0.0, 0.0, 0.0), speed=0.0)
    distance = BEARING.inner_reach + BEARING.outer_reach
    axial = distance * np.sin(BEARING.contact_angle) + state.ring_displacement[0]
    length = np.hypot(axial, distance * np.cos(BEARING.contact_angle))
    force = in_series(*race_contacts(BEARING)) * (length - distance) ** 1.5 * axial / length
    assert 16 * force == approx(9000.0, rel=1e-10)


@CONTROLS
def test_mirrored_load_gives_the_mirrored_state(control):
    state = solved(control=control)
    mirrored = solved(load=(9000.0, -1000.0, 3000.0, 100.0, 50.0), control=control)
    order = (-np.arange(16)) % 16
    assert mirrored.loads == approx(state.loads[:, order], rel=1e-8)
    assert mirrored.ring_displacement == approx(
        state.ring_displacement * [1, -1, 1, 1, -1], rel=1e-6, abs=1e-14
    )


def test_load_turned_by_a_ball_pitch_turns_the_state():
    angle = 2 * np.pi / 16
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    load = np.array(LOAD)
    load[[2, 1]], load[[4, 3]] = turn @ load[[2, 1]], turn @ load[[4, 3]]  # azimuths grow from z to y
    assert solved(load=tuple(load)).loads == approx(np.roll(solved().loads, 1, axis=1), rel=1e-8)


def test_displacement_of_a_load_brings_back_the_load():
    state = solved()
    held = solved(load=(0.0,) * 5, displacement=tuple(state.ring_displacement))
    assert held.ring_load == approx(LOAD, rel=1e-8, abs=1e-6)
    mixed = solved(load=(*LOAD[:3], 0.0, 0.0), displacement=(None, None, None, *state.ring_displacement[3:]))
    assert mixed.ring_displacement == approx(state.ring_displacement, rel=1e-7)
    assert mixed.ring_load[3:] == approx(LOAD[3:], rel=1e-5)


@pytest.mark.parametrize("control", ["outer", "coulomb"])
def test_operations_side_by_side_are_those_alone(control):
    model = AngularContactBallBearing(bearing=BEARING, control=control, friction=0.06)
    cases = ((None, 4e3), 0.5, 0.0, 0.0), ((60e-6, 0.0), 1.0, 500.0, 0.0), ((40e-6, 0.0), 0.7, 1500.0, -300.0)
    operations = [
        RingOperation(
            load=(thrust, *(part * each for each in LOAD[1:])),
            displacement=(place, *FREE[1:]),
            inner_speed=inner,
            outer_speed=outer,
        )
        for (place, thrust), part, inner, outer in cases
    ]
    for operation, state in zip(operations, model.solve_many(operations), strict=True):
        alone = model.solve(operation)
        assert state.loads == approx(alone.loads, rel=1e-7)
        assert state.orbital_speed == approx(alone.orbital_speed, rel=1e-6)


@CONTROLS
def test_ball_that_leaves_the_inner_race_rests_on_the_outer_one(control):
    state = solved(
        load=(4000.0, 0.0, 8000.0, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0), control=control
    )
    resting = ~state.on_inner
    assert resting.any()
    assert not resting.all()
    assert state.loads[1, resting] == approx(state.centrifugal_force[resting], rel=1e-9)
    assert np.abs(state.contact_angles[1, resting]).max() < 1e-9
    assert np.abs(state.tractions[:, resting]).max() < 1e-9


@pytest.mark.parametrize("outer_speed", [0.0, -400.0])
def test_speed_enters_against_the_outer_ring(outer_speed):
    """Turning both senses round changes nothing but the signs of the speeds."""
    ahead, back = (solved(speed=s * 800.0, outer_speed=s * outer_speed) for s in (1, -1))
    assert back.loads == approx(ahead.loads, rel=1e-9)
    assert back.orbital_speed == approx(-ahead.orbital_speed, rel=1e-9)


def test_ring_that_nothing_holds_is_refused():
    with pytest.raises(NotSolved, match="nothing holds") as caught:
        solved(load=(0.0,) * 5, speed=500.0)
    assert caught.value.outcome is SolverOutcome.UNDETERMINED


@CONTROLS
@pytest.mark.parametrize("seed", range(10))
def test_every_ball_on_both_races_of_an_ordinary_bearing_has_rolling_lines(control, seed):
    random = np.random.default_rng(seed)
    bearing = replace(
        BEARING, ball=Ball(diameter=9.5e-3, material=STEEL), pitch_diameter=60e-3, balls=14,
        contact_angle=np.radians(random.uniform(15.0, 40.0)),
    )  # fmt: skip
    load = (random.uniform(500.0, 3000.0), 0.0, random.uniform(0.0, 500.0), 0.0, 0.0)
    state = solved(load, random.uniform(100.0, 2000.0), control, bearing)
    contact = state.rolling_contact()
    assert contact.balls.tolist() == np.flatnonzero((state.loads > 0).all(0)).tolist()
    assert np.isfinite(contact.slip_velocity(np.linspace(-1, 1, 5))).all()
    if control != "equal":
        race = {"outer": 1, "inner": 0}[control]
        guided = state.guided[contact.balls]
        assert guided.any()
        assert contact.parameter[race, guided] == approx(0.0, abs=1e-3)  # their spin as good as fades out
        assert contact.lines.second[race, guided] == approx(0.3472963553, abs=1e-3)  # Heathcote's line


@CONTROLS
def test_thrust_the_other_way_mirrors_rolling_lines_and_keeps_the_torque(control):
    bearing = replace(BEARING, contact_angle=0.0)
    there, back = (
        solved((sign * 9000.0, 0.0, 0.0, 0.0, 0.0), control=control, bearing=bearing, friction=0.1)
        for sign in (1, -1)
    )
    lines, mirrored = (state.rolling_contact(friction="balanced") for state in (there, back))
    assert there.contact_angles.min() > 0.1
    assert mirrored.parameter == approx(-lines.parameter, abs=1e-9)
    assert mirrored.lines.first == approx(-lines.lines.second, abs=1e-9)
    assert back.friction_torque == approx(there.friction_torque, rel=1e-9)


def test_radial_bearing_without_thrust_has_heathcotes_lines():
    bearing = replace(BEARING, contact_angle=0.0)
    held = (0.0, None, None, 0.0, 0.0)
    contact = solved(
        (0.0, 0.0, 9000.0, 0.0, 0.0), 100.0, "outer", bearing, displacement=held
    ).rolling_contact()
    assert len(contact.balls) > 3
    assert contact.parameter == approx(np.zeros_like(contact.parameter), abs=1e-12)
    assert contact.lines.second == approx(np.full(contact.parameter.shape, 0.3472963553), abs=1e-9)


def test_no_race_control_makes_less_friction_than_free_balls():
    """Slow balls: their heat is least where friction decides, and nearly so with as much spin on both."""
    torque = {control: solved(speed=1.0, control=control, friction=0.1).friction_torque for control in
              ("outer", "inner", "equal", "coulomb")}  # fmt: skip
    assert all(torque[control] > 1.001 * torque["coulomb"] for control in ("outer", "inner"))
    assert torque["equal"] == approx(torque["coulomb"], rel=0.02)


@CONTROLS
def test_friction_torque_is_in_proportion_to_the_coefficient_and_none_without(control):
    one, other = (solved(control=control, friction=friction).friction_torque for friction in (0.05, 0.1))
    assert other == approx(2 * one, rel=1e-9)
    assert solved(control=control).friction_torque is None
    assert solved(control=control, friction=0.1, outer_speed=1000.0).friction_torque == 0.0


@pytest.mark.sampled(2)
@pytest.mark.parametrize("thrust", [0.0, 100.0])
def test_forces_beyond_all_numbers_are_told_without_a_share_of_them(thrust):
    operation = RingOperation(
        load=(thrust, 0.0, 0.0, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0), inner_speed=1e160
    )
    with pytest.raises(NotSolved, match="forces on ring and balls are not finite") as refused:
        AngularContactBallBearing(bearing=BEARING).solve(operation)
    assert "nan" not in str(refused.value)
    assert refused.value.outcome is SolverOutcome.NOT_FINITE


def test_impossible_parts_are_refused():
    with pytest.raises(ImpossiblePart, match="both a load"):
        RingOperation(load=LOAD, displacement=(1e-6, None, None, None, None))
    with pytest.raises(ImpossiblePart, match="five entries"):
        RingOperation(load=(1.0, 2.0, 3.0))  # type: ignore
    with pytest.raises(ImpossiblePart, match="do not fit"):
        replace(BEARING, balls=20)
    with pytest.raises(ImpossiblePart, match="contact_angle"):
        replace(BEARING, contact_angle=2.0)
    with pytest.raises(ImpossiblePart, match="finite"):
        RingOperation(inner_speed=float("nan"))


@settings(max_examples=15, deadline=None)
@given(
    st.floats(1.0, 5.0), st.floats(0.0, 1.0), st.floats(0.0, 6.3), st.floats(0.0, 1500.0), st.floats(0.2, 0.7)
)
def test_any_sensible_load_is_carried(decades, radial, azimuth, speed, angle):
    bearing = replace(BEARING, contact_angle=angle)
    thrust = max(10.0**decades, 16 * 1e-3 * speed**2)  # keeps the balls on both races
    load = (thrust, radial * thrust * np.sin(azimuth), radial * thrust * np.cos(azimuth), 0.0, 0.0)
    state = solved(load=load, speed=speed, bearing=bearing, displacement=(None, None, None, 0.0, 0.0))
    assert state.ring_load[:3] == approx(np.array(load[:3]), abs=1e-9 * state.loads.max())


RESTLESS = replace(
    BEARING, inner=Groove(conformity=0.5175, material=STEEL), contact_angle=np.radians(43.5), balls=14
)


@CONTROLS
@pytest.mark.parametrize("load", [4e4, 200.0, 0.5])
def test_balls_wedged_by_their_centrifugal_force_are_in_balance(control, load):
    """Tilt held, the load leaning far over: idle balls touch the inner race near their poles."""
    state = solved(
        load=(0.57 * load, 0.18 * load, 0.8 * load, 0.0, 0.0),
        displacement=(None, None, None, 0.0, 0.0),
        speed=100.0,
        control=control,
        bearing=RESTLESS,
    )
    assert ring_load(state)[:3] == approx(
        [0.57 * load, 0.18 * load, 0.8 * load], abs=1e-7 * state.loads.max()
    )
    assert np.abs(state.contact_angles).max() <= np.pi / 2
    assert (np.abs(state.tractions) <= 0.6 * state.loads).all()


def test_races_guide_pressed_balls_and_leave_idle_ones():
    assert solved(load=(9000.0, 0.0, 0.0, 0.0, 0.0)).guided.all()
    state = solved(load=(4000.0, 0.0, 8000.0, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0))
    assert not state.guided[~state.on_inner].any()
    assert state.guided.any()


@settings(max_examples=25, deadline=None, derandomize=True)
@given(
    st.floats(-5.0, 0.0),
    st.floats(0.0, 1.57),
    st.floats(0.0, 1.0),
    st.floats(0.0, 2500.0),
    st.floats(0.1, 0.78),
    st.sampled_from(["free", "straight", "preloaded"]),
)
def test_any_load_is_carried_or_refused_by_name(decades, lean, tilting, speed, angle, holding):
    """From axial to radial, moments up to load times pitch radius, loads far below the centrifugal forces."""
    bearing = replace(BEARING, contact_angle=angle)
    size = 4e5 * 10.0**decades
    thrust = 0.0 if holding == "preloaded" else size * np.cos(lean)
    tilt = tilting * size * bearing.pitch_diameter / 2 if holding == "free" else 0.0
    load = (thrust, 0.0, size * np.sin(lean), -tilt, 0.0)
    held = {
        "free": (None,) * 5,
        "straight": (None, None, None, 0.0, 0.0),
        "preloaded": (2e-5, None, None, 0.0, 0.0),
    }[holding]
    try:
        state = solved(load=load, speed=speed, bearing=bearing, displacement=held)
    except NotSolved as refused:
        assert refused.outcome is SolverOutcome.UNDETERMINED  # noqa: PT017
        return
    free = [place is None for place in held]
    left = (ring_load(state) - load) / [1.0, 1.0, 1.0, 0.06, 0.06]
    assert np.abs(left[free]).max() < 1e-7 * max(state.loads.max(), size)


def test_contacts_reach_up_the_races():
    """Height over the groove bottom of the edge of the contact, by points of ball and groove."""
    state = solved(load=(9000.0, 0.0, 0.0, 0.0, 0.0))
    for race, groove in enumerate((BEARING.inner, BEARING.outer)):
        angle, half = state.contact_angles[race, 0], state.semi_axes[0][race, 0]
        radius, ball = groove.conformity * BEARING.ball.diameter, BEARING.ball.diameter / 2
        way = np.array([np.sin(angle), np.cos(angle)])
        edge = np.sqrt(ball**2 - half**2) * way + half * way[::-1] * [1, -1]  # on the ball, from its centre
        height = radius * (1 - edge[1] / ball)
        assert state.needed_shoulders[race] == approx(np.full(16, height), rel=1e-9)
    idle = solved(load=(4000.0, 0.0, 8000.0, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0))
    assert (idle.needed_shoulders[0, ~idle.on_inner] == 0).all()


@pytest.mark.parametrize("seed", range(6))
def test_random_pairs_are_in_balance(seed):
    model, operation = drawn_pair(seed)
    assert unbalanced(model.solve(operation)) < 1e-9
