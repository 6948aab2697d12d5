"""What rollers reach that pass pitches is what rollers run in that move with their own inertia."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.several import after_passing_pitches, other_equilibria
from tests.cold_oil import cold_bearing
from tests.reference.moving_rollers import moved
from tests.thick_films import design

STEPS = 40  # of a pitch; 20 change the largest load of the cold bearing by 2e-5


def largest_load_at_last(state, pitches=3):
    *_, (balance, unknowns) = moved(state, pitches, STEPS)
    return balance.evaluate(unknowns[None]).state.contact.force[0, 0, 0].max()


@pytest.mark.slow
def test_moving_rollers_end_in_one_motion_whichever_equilibrium_they_leave(tmp_path):
    """The cold bearing has four; the motion is nearest to that which passing a pitch leads to."""
    state = cold_bearing(13.0, tmp_path).solve()
    known = (state, *other_equilibria(state))
    assert len(known) == 4
    ends = [largest_load_at_last(one) for one in known]
    assert ends == approx(np.full(4, ends[0]), rel=1e-4, abs=0)
    passing = after_passing_pitches(state)
    assert passing.settled
    assert passing.equilibrium.loads[0].max() == approx(ends[0], rel=2e-3, abs=0)
    assert abs(state.loads[0].max() / ends[0] - 1) > 0.02  # the default start is another state


@pytest.mark.slow
@pytest.mark.parametrize(("number", "changed"), [(2, False), (18, True), (29, True), (30, True)])
def test_moving_rollers_end_near_the_state_after_passing_pitches(number, changed):
    state = design(np.random.default_rng([1, number])).solve()
    passing = after_passing_pitches(state).equilibrium.loads[0].max()
    assert (abs(passing / state.loads[0].max() - 1) > 0.01) == changed
    assert largest_load_at_last(state) == approx(passing, rel=5e-3, abs=0)
