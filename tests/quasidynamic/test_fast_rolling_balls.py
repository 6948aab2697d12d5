"""Fast balls whose contacts stick and slip, at the motion of their balance."""

from typing import Any

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.contact.rolling.full_sliding import full_sliding
from quasidynamic.errors import OutOfRange
from quasidynamic.motion.ball_slip import TURN
from quasidynamic.parts.angular_contact_bearing import RingOperation
from tests.ball_bearings import fast_bearing

BEARING = fast_bearing(22.23e-3, 125.26e-3, 4, np.radians(40.0), 0.5232)
LOAD, UPRIGHT = (4450.0, 0.0, 1000.0, 0.0, 0.0), (None, None, None, 0.0, 0.0)
FAST = 10000 * np.pi / 30
CELLS = (16, 32)
CONTROLS = pytest.mark.parametrize("control", ["outer", "inner", "equal", "coulomb"])
SPINS = pytest.mark.parametrize("spin", ["centre", "local"])
STICKING = pytest.mark.parametrize("model", ["fastsim", "kalker"])


def balanced(control: Any = "outer", spin: Any = "centre", speed=FAST, friction: Any = 0.1, outer_speed=0.0):
    model = AngularContactBallBearing(bearing=BEARING, control=control, friction=friction, spin=spin)
    operation = RingOperation(load=LOAD, displacement=UPRIGHT, inner_speed=speed, outer_speed=outer_speed)
    return model, model.solve(operation)


def rolled(model: Any = "kalker", cells=CELLS, **changes):
    bearing, state = balanced(**changes)
    return bearing.roll(state, model, cells)


def contact_heat(balls, ball, race):
    """Heat of one contact [W] from its cells: the shear stress on the slip of the surfaces."""
    field = balls.field(ball, race)
    area = abs(np.diff(field["x"][:, 0])[0] * np.diff(field["y"][0])[0])
    power = field["shear_along"] * field["slip_along"] + field["shear_across"] * field["slip_across"]
    return -power.sum() * area


@pytest.mark.sampled(2)
@CONTROLS
@SPINS
def test_full_sliding_on_the_grid_has_the_torque_of_the_strips(control, spin):
    balls = rolled("full_sliding", control=control, spin=spin)
    assert balls.friction_torque == approx(balls.state.friction_torque, abs=balls.grid_error.sum())
    assert balls.grid_error.sum() < 5e-3 * balls.friction_torque
    assert np.all(balls.unbalanced_moment == 0.0)
    assert np.all(balls.stick_share == 0.0)


@pytest.mark.parametrize(
    ("model", "tolerance"), [("full_sliding", 1e-3), ("fastsim", 0.02), ("kalker", 0.02)]
)
def test_heat_is_the_power_of_the_cells_and_that_of_the_torque(model, tolerance):
    """Elastic slip has no power in steady rolling, but for a step of a cell; slip is taken a sixth ahead."""
    balls = rolled(model, control="coulomb", outer_speed=-100.0)
    cells = [sum(contact_heat(balls, ball, race) for race in (0, 1)) for ball in range(4)]
    assert balls.friction_heat == approx(np.array(cells), rel=tolerance)
    assert balls.friction_heat.sum() == approx(balls.friction_torque * (FAST + 100.0), rel=1e-12)


@pytest.mark.sampled(4)
@CONTROLS
@SPINS
@STICKING
def test_stick_takes_from_full_sliding_at_the_same_slip(control, spin, model):
    balls = rolled(model, control=control, spin=spin)
    for ball in filter(None, balls.rolled):
        most = ball.fine.ball.full_sliding_power(ball.fine.motion)
        assert 0.9 * most < ball.torque <= most
    assert balls.friction_torque <= balls.state.friction_torque + balls.grid_error.sum()
    assert np.all((balls.unbalanced_moment > 0.0) & (balls.unbalanced_moment < 0.1))


def force_along_orbit(balls, ball):
    """Force on a ball towards growing azimuth [N], from the cells of both contacts."""
    fields = [balls.field(ball, race) for race in (0, 1)]
    return sum(
        field["shear_along"].sum() * abs(np.diff(field["x"][:, 0])[0] * np.diff(field["y"][0])[0])
        for field in fields
    )


@pytest.mark.sampled(3)
@CONTROLS
@pytest.mark.parametrize("speed", [FAST, -FAST])
def test_force_along_the_orbit_that_stick_leaves_is_that_of_the_cells(control, speed):
    """Beyond that of full sliding on the same cells."""
    sticking, sliding = (rolled(model, control=control, speed=speed) for model in ("fastsim", "full_sliding"))
    for ball in range(4):
        largest = 0.1 * sticking.state.loads[:, ball].sum()
        left = force_along_orbit(sticking, ball) - force_along_orbit(sliding, ball)
        assert sticking.unbalanced_force[ball] == approx(left / largest, rel=5e-3)
    assert np.abs(sticking.unbalanced_force).max() > 1e-4


def test_contacts_stick_on_the_race_that_rolls_without_spin():
    """Race control leaves no spin on one race: there, and only there, contacts stick."""
    outer, inner = (rolled(control=control).stick_share for control in ("outer", "inner"))
    assert np.all(outer[1] > 0.15)
    assert np.all(outer[0] < 0.02)
    assert np.all(inner[0] > 0.15)
    assert np.all(inner[1] < 0.02)


def test_centrifugal_force_loads_the_grid_of_the_outer_race_more():
    fast, slow = (rolled("full_sliding", control="equal", speed=speed) for speed in (FAST, 0.01 * FAST))
    for balls, differ in ((fast, True), (slow, False)):
        (contacts, *_) = [ball.fine.ball.contacts for ball in filter(None, balls.rolled)]
        force = contacts.limit.sum((1, 2)) * contacts.cell_area
        assert force == approx(0.1 * balls.state.loads[:, 0], rel=5e-3)
        assert (force[1] > 1.1 * force[0]) == differ


def test_friction_of_the_kept_motion_holds_the_gyroscopic_moment():
    """With Coulomb control the moment of full sliding about the rolling direction is that of the balance."""
    balls = rolled("full_sliding", control="coulomb", cells=(40, 80))
    for number, ball in enumerate(filter(None, balls.rolled)):
        state = ball.fine
        moment = state.ball.power_by_motion(
            state.motion, full_sliding(state.ball.contacts, state.ball.creep(state.motion))
        )
        assert abs(moment[TURN]) == approx(abs(balls.state.gyroscopic_moment[number]), rel=0.02)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("control", ["outer", "coulomb"])
def test_rings_that_turn_backwards_mirror_the_fields(control):
    ahead, back = (rolled(control=control, speed=speed) for speed in (FAST, -FAST))
    assert back.friction_heat == approx(ahead.friction_heat, rel=1e-4)
    one, other = (balls.field(0, 1) for balls in (ahead, back))
    most = np.hypot(one["shear_along"], one["shear_across"]).max()
    assert one["y"] == approx(other["y"])
    assert other["shear_along"] / most == approx(-one["shear_along"][:, ::-1] / most, abs=0.02)
    assert other["shear_across"] / most == approx(one["shear_across"][:, ::-1] / most, abs=0.02)


def test_rings_that_turn_alike_make_no_heat():
    balls = rolled(outer_speed=FAST)
    assert balls.rolled == (None,) * 4
    assert balls.friction_torque == 0.0


def test_stick_and_slip_need_a_coefficient_of_friction():
    bearing, state = balanced(friction=None)
    with pytest.raises(OutOfRange, match="no coefficient of friction"):
        bearing.roll(state, "kalker", CELLS)


def test_the_part_of_the_balls_that_are_solved_is_told():
    bearing, state = balanced()
    told = []
    bearing.roll(state, "fastsim", CELLS, told.append)
    assert told == [0.25, 0.5, 0.75, 1.0]
