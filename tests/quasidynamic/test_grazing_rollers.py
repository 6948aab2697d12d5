"""Rollers that hardly touch, or at one end alone: linearised steps send them anywhere."""

import numpy as np
import pytest

from quasidynamic import SolverOutcome, solve_many
from quasidynamic.solve.rollers.newton import shortened
from tests.bearings import paper_bearing
from tests.random_rollers import imbalance, wide_design
from tests.thick_films import design


@pytest.mark.sampled(3)
@pytest.mark.parametrize("number", [30, 45, 57])
def test_bearing_with_thick_oil_is_solved_though_a_roller_hardly_touches(number):
    """Tilted rollers touch at one end (30 and 45), or the last loaded roller just loses contact (57)."""
    model = design(np.random.default_rng([7, number]))
    state = solve_many([model])[0]
    assert state.status is SolverOutcome.CONVERGED
    assert imbalance(state) < 1e-8


@pytest.mark.parametrize("number", [166, 289])
def test_ring_under_a_moment_alone_is_solved(number):
    """Every loaded roller touches at one end."""
    model, _ = wide_design(np.random.default_rng([1, number]))
    state = solve_many([model])[0]
    assert state.status is SolverOutcome.CONVERGED
    assert imbalance(state) < 1e-8


def test_only_steps_of_a_roller_beyond_its_surroundings_are_shortened():
    state = paper_bearing(moment=5.0).solve()
    balance, unknowns = state.balance, state.balance.pack(state.unknowns)
    approach, tilt = (balance.layout.field(which) for which in (0, 1))
    change = np.zeros_like(unknowns)
    change[0, :2] = 3.0
    change[0, approach] = 2.0
    assert shortened(balance, unknowns, change) is not change
    assert shortened(balance, unknowns, change) == pytest.approx(change)
    thrown = change.copy()
    thrown[0, [approach.start + 4, tilt.start + 4]] = 1e5, -2e5
    held = shortened(balance, unknowns, thrown)
    size = np.abs(unknowns[0, [approach.start + 4, tilt.start + 4]]).max()
    moved = held[0, [approach.start + 4, tilt.start + 4]]
    assert moved[1] == pytest.approx(-2 * moved[0])
    assert np.abs(moved).max() == pytest.approx(3.0 + 0.5 * size)
    others = np.delete(np.arange(unknowns.shape[1]), [approach.start + 4, tilt.start + 4])
    assert held[0, others] == pytest.approx(change[0, others])
