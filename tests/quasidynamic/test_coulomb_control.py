"""What friction on both races makes balls do."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import AngularBalance, race_contacts
from quasidynamic.balance.balls.race_control import LoadedContacts
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.rigid_slip import sagitta
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.motion.ball_slip import BallContacts, pressed_height, pressed_radius
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.ball import Groove
from quasidynamic.parts.material import Material
from quasidynamic.solve.balls.ball_equilibrium import balance_balls
from quasidynamic.solve.balls.coulomb_control import NOISE, CoulombControl
from quasidynamic.solve.balls.ring_newton import _at
from quasidynamic.solve.balls.ring_on_balls import start
from quasidynamic.solve.balls.sliding_motion import sliding_motion
from tests.ball_bearings import fast_bearing
from tests.quasidynamic.test_angular_balance import require_slopes
from tests.random_balls import drawn_sliding, unbalanced

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
BEARING = fast_bearing(20e-3, 120e-3, 4, np.radians(40.0), 0.52, 0.53)
CONTACTS = race_contacts(BEARING)
STRAIGHT = (None, None, None, 0.0, 0.0)


def pressed(inner, outer, inner_load, outer_load):
    """Contacts (2, 1, N) of balls, their stiffness from the loads."""
    angles = np.broadcast_arrays(*np.atleast_1d(inner, outer))
    loads = np.broadcast_arrays(*np.atleast_1d(inner_load, outer_load))
    stiffness = [1.5 * c.coefficient ** (2 / 3) * np.cbrt(q) for c, q in zip(CONTACTS, loads, strict=True)]
    return LoadedContacts(*(np.array(pair, float)[:, None] for pair in (angles, loads, stiffness)))


def kinematics(contacts, speed=1000.0, outer_speed=0.0, friction=0.06, centrifugal=300.0):
    """BallKinematics of one ball, and the same control."""
    control = CoulombControl(BEARING, CONTACTS, friction)
    speeds = np.array([speed, outer_speed]).reshape(2, 1, 1)
    return control.kinematics(contacts, speeds, np.full((1, 1), centrifugal)), control


def friction_on_ball(contacts, found, friction, speeds, points=500):
    """Force and moment (3) of friction on one ball, its heat and spin, by plain sums in space: x, r, t."""
    radius, spin, orbit = BEARING.ball.diameter / 2, found.spin[0, 0], found.orbit[0, 0]
    tilt, yaw = found.attitude[0, 0], found.yaw[0, 0]
    ball = spin * np.array([-np.cos(tilt) * np.cos(yaw), np.sin(tilt) * np.cos(yaw), np.sin(yaw)])
    u = (np.arange(points) + 0.5) / points
    rho, turn = np.meshgrid(np.sin(np.pi / 2 * u), 2 * np.pi * u, indexing="ij")
    ring = rho * np.pi / 2 * np.cos(np.pi / 2 * u)[:, None] / points * 2 * np.pi / points
    total, moment, heat = np.zeros(3), np.zeros(3), 0.0
    for race, (side, groove) in enumerate([(-1, BEARING.inner), (1, BEARING.outer)]):
        angle, load = contacts.angles[race, 0, 0], contacts.loads[race, 0, 0]
        a, b = CONTACTS[race].semi_axes(load)
        surface = pressed_radius(radius, groove.conformity * BEARING.ball.diameter)
        normal = side * np.array([np.sin(angle), np.cos(angle), 0.0])
        along = np.array([-normal[1], normal[0], 0.0])
        x, y = a * rho * np.cos(turn), b * rho * np.sin(turn)
        height = pressed_height(radius, surface, a) + sagitta(x, surface)
        place = height[..., None] * normal + x[..., None] * along
        lever = place + y[..., None] * np.array([0.0, 0.0, 1.0])
        other = lever + np.array([0.0, BEARING.pitch_diameter / 2, 0.0])  # from the axis of the bearing
        slip = np.cross(ball, lever) - np.cross((speeds[race] - orbit) * np.array([1.0, 0, 0]), other)
        slip -= (slip @ normal)[..., None] * normal  # in the plane of the contact
        slip[..., 2] -= np.cross(ball, y[..., None] * np.array([0.0, 0.0, 1.0]))[..., 2]
        size = np.linalg.norm(slip, axis=-1)
        push = friction * load * 1.5 / np.pi * np.sqrt(1 - rho**2) * ring / size
        force = -push[..., None] * slip
        total += force.sum((0, 1))
        heat += (push * size**2).sum()
        moment += np.cross(lever, force).sum((0, 1))
    return total, moment, heat, ball


@pytest.mark.sampled(2)
@pytest.mark.parametrize("outer_speed", [0.0, -400.0])
@pytest.mark.parametrize("friction", [0.02, 0.08])
def test_friction_turns_the_spin_with_the_orbit_and_drives_nothing_along_it(friction, outer_speed):
    """Euler's equations: the moment of friction is J orbit x spin; by sums over the contacts in space."""
    contacts = pressed(0.8, 0.6, 900.0, 1150.0)
    found, control = kinematics(contacts, outer_speed=outer_speed, friction=friction)
    force, moment, heat, ball = friction_on_ball(contacts, found, friction, (1000.0, outer_speed))
    needed = BEARING.ball.inertia * np.cross(found.orbit[0, 0] * np.array([1.0, 0.0, 0.0]), ball)
    grip = friction * 2000.0
    assert force[2] / grip == approx(0.0, abs=1e-3)
    assert moment / (0.01 * grip) == approx(needed / (0.01 * grip), abs=1e-3)
    lateral = [np.array([np.cos(a), -np.sin(a), 0.0]) for a in contacts.angles[:, 0, 0]]
    across = found.tractions[0, 0, 0] * lateral[0] - found.tractions[1, 0, 0] * lateral[1]
    assert force[:2] / grip == approx(across[:2] / grip, abs=1e-3)
    speeds = np.array([1000.0, outer_speed]).reshape(2, 1, 1)
    assert control.heat(contacts, speeds, np.full((1, 1), 300.0))[0, 0] == approx(heat, rel=2e-4)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "where",
    [(0.6, 0.5, 3600.0, 3300.0), (0.7, 0.3, 75.0, 830.0), (1.35, 0.2, 450.0, 1160.0), (0.4, 0.1, 0.0, 400.0)],
    ids=["pressed", "lightly", "far apart", "off the inner race"],
)
@pytest.mark.parametrize("friction", [0.02, 0.1])
def test_slopes_by_loads_and_angles(friction, where):
    here, _ = kinematics(pressed(*where), friction=friction)
    contacts, places = pressed(*where), np.array(where)
    for slot, column in enumerate([2, 0, 3, 1]):  # L_i, alpha_i, L_o, alpha_o
        stiffness = contacts.stiffness[slot // 2, 0, 0] if column > 1 else 1.0
        step = 1e-5 * (places[column] if column > 1 else 1.0)
        if step == 0.0:
            continue
        moved = [
            kinematics(pressed(*(places + s * step * np.eye(4)[column])), friction=friction)[0]
            for s in (1, -1)
        ]
        by_force = (moved[0].centrifugal - moved[1].centrifugal) / (2 * step) * stiffness
        by_traction = (moved[0].tractions - moved[1].tractions) / (2 * step) * stiffness
        size = 1e-5 * max(places[2:]) * (stiffness / max(places[2:]) if column > 1 else 1.0)
        assert here.centrifugal_slopes[slot] == approx(by_force, rel=1e-4, abs=10 * size)
        assert here.traction_slopes[:, slot] == approx(by_traction, rel=1e-3, abs=10 * size)


def test_slow_balls_move_as_friction_without_inertia_has_it():
    contacts = pressed([0.7, 0.75, 0.8], [0.7, 0.65, 0.6], 1000.0, [1000.0, 1010.0, 1050.0])
    found, _ = kinematics(contacts, speed=1e-3, centrifugal=0.0)
    radius, count = np.full(3, BEARING.ball.diameter / 2), 3
    grooves = BEARING.ball.diameter * np.array([BEARING.inner.conformity, BEARING.outer.conformity])
    surface = pressed_radius(radius[:, None], grooves)
    axes = np.array([c.semi_axes(q) for c, q in zip(CONTACTS, contacts.loads[:, 0], strict=True)])
    places = BallContacts(
        radius,
        np.full(count, BEARING.pitch_diameter / 2),
        contacts.angles[:, 0].T[:, None],
        pressed_height(radius[:, None], surface, axes[:, 0].T)[:, None],
    )
    ellipse = Ellipse(axes[:, 0].T, axes[:, 1].T, surface, 0.06 * contacts.loads[:, 0].T)
    one = Ellipse(*(array[:, None] for array in (ellipse.across, ellipse.along, surface, ellipse.traction)))
    known = sliding_motion(places, one)
    assert found.orbit[0] == approx(-1e-3 * known.motion[:, 0], rel=1e-6)
    spin = 1e-3 * known.motion[:, 1:]
    assert -found.spin[0] * np.cos(found.attitude[0]) == approx(spin[:, 0], rel=1e-6)
    assert found.spin[0] * np.sin(found.attitude[0]) == approx(spin[:, 1], rel=1e-6)
    assert np.abs(found.yaw).max() < 1e-9


def test_strong_friction_leaves_control_to_the_race_that_presses_harder():
    """Much friction: the gyroscopic moment is a trifle, and the spin is that of the least heat."""
    light, heavy = (
        kinematics(pressed(0.5, 0.4, 50.0, q), speed=100.0, friction=0.3, centrifugal=3.0)[0]
        for q in (50.0, 2000.0)
    )
    outer = np.arctan2(np.sin(0.4), np.cos(0.4) + BEARING.diameter_ratio)
    assert heavy.attitude[0, 0] == approx(outer, abs=4e-3)
    assert abs(heavy.yaw[0, 0]) < 1e-3
    assert light.attitude[0, 0] > outer + 1e-2


def test_weak_friction_lets_the_axis_lie_down():
    """Where friction cannot hold the gyroscopic moment the axis turns until it can."""
    contacts = pressed(0.7, 0.6, 300.0, 600.0)
    axes = [kinematics(contacts, speed=3000.0, friction=mu)[0] for mu in (0.005, 0.02, 0.2)]
    tilt = [found.attitude[0, 0] for found in axes]
    assert tilt[0] < 0.1 * tilt[2]
    assert tilt[0] < tilt[1] < tilt[2]
    for found, mu in zip(axes, (0.005, 0.02, 0.2), strict=True):
        assert (np.abs(found.tractions[:, 0, 0]) < mu * contacts.loads[:, 0, 0]).all()
        assert found.tractions.sum() == approx(2 * found.gyroscopic[0, 0] / BEARING.ball.diameter, rel=0.03)


@pytest.mark.parametrize("outer_speed", [0.0, 300.0])
def test_both_senses_of_rotation_are_alike(outer_speed):
    contacts = pressed(0.8, 0.6, 900.0, 1150.0)
    one, other = (kinematics(contacts, s * 1000.0, s * outer_speed)[0] for s in (1, -1))
    assert other.tractions == approx(one.tractions, rel=1e-9)
    assert other.centrifugal == approx(one.centrifugal, rel=1e-9)
    assert other.orbit == approx(-one.orbit, rel=1e-9)
    assert other.yaw == approx(-one.yaw, rel=1e-9)
    assert other.traction_slopes == approx(one.traction_slopes, rel=1e-9)


def test_rings_that_do_not_turn_against_each_other_carry_the_balls_along():
    found, _ = kinematics(pressed(0.8, 0.6, 900.0, 1150.0), speed=500.0, outer_speed=500.0)
    assert found.orbit[0, 0] == 500.0
    assert (found.tractions == 0).all()
    assert (found.spin == 0).all()


def test_a_ball_that_the_inner_race_lets_go_rolls_on_at_the_bottom_of_the_outer_one():
    """No load, no traction there; the orbit is that of rolling at no contact angle, but for some slip."""
    found, _ = kinematics(pressed(1.2, 0.0, 0.0, 340.0), friction=0.05)
    assert found.tractions[0, 0, 0] == 0.0
    assert found.tractions[1, 0, 0] == approx(0.0, abs=1e-6)
    assert found.orbit[0, 0] == approx(500.0 * (1 - BEARING.diameter_ratio), rel=0.02)


# -- the whole bearing -----------------------------------------------------------------------------


def solved(friction=0.06, speed=1000.0, load=(6000.0, 0.0, 0.0, 0.0, 0.0), held=STRAIGHT):
    operation = RingOperation(load=load, displacement=held, inner_speed=speed)
    return AngularContactBallBearing(bearing=BEARING, control="coulomb", friction=friction).solve(operation)


def test_thrust_makes_all_balls_alike_and_the_heat_is_the_power_of_the_shaft():
    state = solved()
    for values in (state.loads, state.tractions, state.contact_angles):
        assert values == approx(np.tile(values[:, :1], 4), rel=1e-8)
    assert state.friction_torque * 1000.0 == approx(state.friction_heat.sum(), rel=1e-12)
    assert (state.friction_heat > 0).all()
    assert state.guided.all()
    assert state.upright.all()
    assert not solved(friction=0.005).upright.any()
    assert (np.abs(state.tractions) < 0.06 * state.loads).all()


def test_balls_and_ring_are_in_balance_under_a_load_that_frees_some_balls():
    load = (3000.0, 0.0, 2000.0, 0.0, 0.0)
    state = solved(load=load, held=(None, None, None, 0.0, 0.0))
    (inner, outer), q, t = state.contact_angles, state.loads, state.tractions
    axial, radial = q[0] * np.sin(inner) + t[0] * np.cos(inner), q[0] * np.cos(inner) - t[0] * np.sin(inner)
    left = axial - q[1] * np.sin(outer) - t[1] * np.cos(outer)
    lifted = radial - q[1] * np.cos(outer) + t[1] * np.sin(outer) + state.centrifugal_force
    assert np.abs([left, lifted]).max() < 1e-9 * q.max()
    azimuth = BEARING.azimuths
    carried = [axial.sum(), (radial * np.sin(azimuth)).sum(), (radial * np.cos(azimuth)).sum()]
    assert carried == approx(load[:3], abs=1e-8 * q.max())


def test_a_bearing_at_rest_has_no_friction():
    state = solved(speed=0.0)
    assert state.friction_torque == 0.0
    assert state.upright.all()
    assert (state.tractions == 0).all()
    other = AngularContactBallBearing(bearing=BEARING).solve(state.operation)
    assert state.loads == approx(other.loads, rel=1e-9)


def test_balls_pressed_outwards_lie_beside_outer_control():
    """The 218 bearing at 10 000 rpm: 49.95 and 31.33 deg by outer control; less so where friction is weak."""
    bearing = fast_bearing(22.23e-3, 125.26e-3, 16, np.radians(40.0), 11.63 / 22.23)
    operation = RingOperation(load=(17800.0, 0.0, 0.0, 0.0, 0.0), inner_speed=10000 * np.pi / 30)
    off = []
    for friction in (0.03, 0.06, 0.1):
        state = AngularContactBallBearing(bearing=bearing, control="coulomb", friction=friction).solve(
            operation
        )
        off.append(np.abs(np.degrees(state.contact_angles[:, 0]) - [49.95, 31.33]).max())
        assert (np.abs(state.tractions) < friction * state.loads).all()
    assert off == sorted(off, reverse=True)
    assert off[2] < 0.5 * off[0] < 1.0


def test_coulomb_control_needs_a_coefficient_of_friction():
    with pytest.raises(ImpossiblePart, match="needs a coefficient"):
        AngularContactBallBearing(bearing=BEARING, control="coulomb")
    with pytest.raises(ImpossiblePart, match="friction"):
        AngularContactBallBearing(bearing=BEARING, control="coulomb", friction=-0.1)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("seed", [3, 12, 25])
def test_semi_axes_of_the_loaded_angle_hardly_change_the_friction_of_free_balls(seed):
    """The motion is found with those of the angle without load, an error that the documents state."""
    model, operation = drawn_sliding(seed)
    state = model.solve(operation)
    contacts = LoadedContacts(state.contact_angles, state.loads, np.full_like(state.loads, 1e7))
    speeds = np.array([[operation.inner_speed], [operation.outer_speed]])
    pairs = race_contacts(model.bearing), race_contacts(model.bearing, state.contact_angles)
    with np.errstate(all="ignore"):  # balls far above their driving load
        heat = [
            CoulombControl(model.bearing, pair, state.friction)
            .heat(contacts, speeds, state.centrifugal_force)
            .sum()
            for pair in pairs
        ]
    assert heat[1] == approx(heat[0], rel=0.01)
    assert heat[1] != heat[0]


def test_contacts_as_wide_as_the_ball_are_refused():
    soft = replace(BEARING, inner=Groove(conformity=0.5005, material=STEEL))
    operation = RingOperation(load=(2e5, 0.0, 0.0, 0.0, 0.0), displacement=STRAIGHT, inner_speed=100.0)
    with pytest.raises(NotSolved, match="as wide as the ball"):
        AngularContactBallBearing(bearing=soft, control="coulomb", friction=0.1).solve(operation)


PLACES = {  # contact angles [rad], approaches [m]
    "pressed": (0.6, 0.5, 2e-5, 2e-5),
    "contacts far apart": (1.35, 0.2, 5e-6, 1e-5),
    "on the wall of the inner groove": (1.75, 0.2, 8e-6, 1e-5),
    "off the inner race": (0.4, 0.1, -1e-5, 1e-5),
}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("where", PLACES.values(), ids=PLACES.keys())
def test_derivatives_by_the_places_of_ball_and_groove(where):
    own = AngularBalance(
        bearing=BEARING,
        contacts=CONTACTS,
        control=CoulombControl(BEARING, CONTACTS, 0.05),
        load=np.zeros((1, 5)),
        held=np.zeros((1, 5), bool),
        place=np.zeros((1, 5)),
        speeds=np.array([1000.0, 0.0]).reshape(2, 1, 1),
    )
    inner, outer, inner_approach, outer_approach = where
    centre = (BEARING.outer_reach + outer_approach) * 1j * np.exp(-1j * outer)
    groove = centre + (BEARING.inner_reach + inner_approach) * 1j * np.exp(-1j * inner)
    groove, centre = np.full((1, 4), groove, complex), np.full((1, 4), centre, complex)
    require_slopes(own, groove, centre)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("seed", [502, 668])
def test_what_the_search_of_friction_leaves_does_not_stall_the_ring(seed):
    """Both found no balance to 1e-11 of the largest force, nor did the balls to 1e-12."""
    model, operation = drawn_sliding(seed)
    assert unbalanced(model.solve(operation)) < 2 * NOISE


def test_imbalance_is_told_over_the_largest_force():
    operation = RingOperation(load=(6000.0, 0.0, 0.0, 0.0, 0.0), displacement=STRAIGHT, inner_speed=1000.0)
    model = AngularContactBallBearing(bearing=BEARING, control="coulomb", friction=0.06)
    balance = model.equations([operation])
    ring, centres = start(replace(balance, load=1.1 * balance.load))
    found = balance_balls(balance, balance.grooves(ring), centres)
    state = _at(balance, ring, found)
    assert state.imbalance[0] == approx(
        np.abs(state.balance.excess).max() / found.scales.largest[0], rel=1e-6
    )
    assert 0.01 < state.imbalance[0] < 0.2
