"""What rollers reach that pass pitches, against a motion in finer steps and from other states."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.several import after_passing_pitches, other_equilibria
from tests.cold_oil import cold_bearing
from tests.reference.moving_rollers import moved
from tests.thick_films import design

STEPS = 60  # of a pitch


def largest_load_at_last(state, pitches=3):
    *_, (balance, unknowns) = moved(state, pitches, STEPS)
    return balance.evaluate(unknowns[None]).state.contact.force[0, 0, 0].max()


@pytest.mark.slow
def test_moving_rollers_end_in_one_motion_whichever_equilibrium_they_leave(tmp_path):
    state = cold_bearing(13.0, tmp_path).solve()
    known = (state, *other_equilibria(state))
    assert len(known) > 2
    ends = [largest_load_at_last(one) for one in known]
    assert ends == approx(np.full(len(known), ends[0]), rel=1e-4, abs=0)
    for one in known:
        passing = after_passing_pitches(one)
        assert passing.settled
        assert passing.state.loads[0].max() == approx(ends[0], rel=3e-4, abs=0)
    assert abs(state.loads[0].max() / ends[0] - 1) > 0.02  # the default start is another state


@pytest.mark.slow
@pytest.mark.parametrize("number", [2, 8, 18, 29])
def test_rollers_that_pass_pitches_end_in_the_motion_of_finer_steps(number):
    state = design(np.random.default_rng([1, number])).solve()
    passing = after_passing_pitches(state)
    assert passing.settled
    assert passing.state.loads[0].max() == approx(largest_load_at_last(state), rel=3e-3, abs=0)
