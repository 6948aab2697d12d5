"""Fast balls that stick and slip in the balance that friction decides."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.contact.half_space import ElasticPair
from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.solve.balls import coulomb_control
from tests.quasidynamic.test_fast_rolling_balls import BEARING, FAST, UPRIGHT

CELLS = (16, 32)
SLIDING = AngularContactBallBearing(bearing=BEARING, control="coulomb", friction=0.1, spin="local")
STICKING = replace(SLIDING, sticking=CELLS)
OPERATION = RingOperation(load=(4450.0, 0.0, 500.0, 0.0, 0.0), displacement=UPRIGHT, inner_speed=FAST)


@pytest.mark.parametrize(
    ("spin", "speeds", "interface"),
    [("local", (FAST, 0.0), 0.0), ("centre", (-0.1 * FAST, 100.0), 0.0), ("local", (FAST, 0.0), 2e-6)],
)
def test_friction_of_the_balance_is_that_of_fastsim_on_its_cells(spin, speeds, interface, monkeypatch):
    """The same by another way, one ball after the other; heat is torque times speed."""
    monkeypatch.setattr(coulomb_control, "BLOCK", 3)  # of four balls, as of more in many cases
    bearing = replace(STICKING, spin=spin, interface_compliance=interface)
    operation = replace(OPERATION, inner_speed=speeds[0], outer_speed=speeds[1])
    state = bearing.solve(operation)
    balls = bearing.roll(state, "fastsim", CELLS)
    assert state.friction_heat is not None
    assert state.friction_torque is not None
    assert balls.friction_heat == approx(state.friction_heat, rel=2e-3)  # Hertz at the loaded angle
    assert state.friction_torque * abs(speeds[0] - speeds[1]) == approx(state.friction_heat.sum(), rel=1e-12)
    assert np.all(balls.unbalanced_section_force == 0.0)
    for number, ball in enumerate(filter(None, balls.rolled)):
        across = ball.fine.ball.power_by_slip(ball.fine.motion, ball.fine.rolled).sum(0)[:, 3]
        largest = 0.1 * state.loads[:, number].sum()
        assert across == approx(state.tractions[:, number], abs=5e-3 * largest)


def test_contacts_that_spin_push_across_and_part_the_contact_angles():
    """Johnson (1958): slow balls, which inertia does not part."""
    slow = replace(OPERATION, inner_speed=0.1 * FAST)
    sliding, sticking = SLIDING.solve(slow), STICKING.solve(slow)
    (inner, outer), largest = sticking.tractions, 0.1 * sticking.loads
    assert np.all(np.abs(sliding.tractions) < 0.02 * largest)
    assert np.all((inner < -0.05 * largest[0]) & (outer > 0.05 * largest[1]))
    assert inner + outer == approx(sliding.tractions.sum(0), abs=0.01 * largest.max())
    apart = np.degrees([state.contact_angles[0] - state.contact_angles[1] for state in (sliding, sticking)])
    assert np.all(apart[1] > apart[0] + 0.5)


def test_stiff_bodies_slide():
    """The flexibility along the surfaces falls to a thousandth: the balance of full sliding, at that rate."""
    sliding = SLIDING.solve(OPERATION)
    pair = STICKING._pairs[0]
    changes = []
    for share in (1.0, 1e-3):
        bearing = replace(STICKING, sticking=(24, 48))
        bearing.__dict__["_pairs"] = (ElasticPair(pair.shear * share, pair.poisson * share),) * 2
        state = bearing.solve(OPERATION)
        changes.append(np.abs(state.contact_angles - sliding.contact_angles).max())
    assert changes[1] < 0.15 * changes[0]


def test_contacts_stick_in_the_balance_of_friction_alone():
    with pytest.raises(ImpossiblePart, match="sticking"):
        AngularContactBallBearing(bearing=BEARING, control="outer", friction=0.1, sticking=CELLS)
