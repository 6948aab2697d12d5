"""Cage and spins that settle while ring and rollers rest: where Newton's method finds no way."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import SolverOutcome, solve_many
from quasidynamic.solve.rollers.newton import newton
from quasidynamic.solve.rollers.normal_equilibrium import normal_equilibrium
from quasidynamic.solve.rollers.settled_time import through_settled_time
from quasidynamic.solve.start import static_start
from tests.bearings import paper_bearing
from tests.random_rollers import imbalance, wide_design

# Numbers of wide designs of seed 1 that were left unsolved before.
MOMENT_ALONE, COLD_OIL, COLD_AND_SLOW = 289, 103, 106


def design(number):
    return wide_design(np.random.default_rng([1, number]))[0]


def balance_of(model):
    return model.balance()


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "number",
    [
        MOMENT_ALONE,
        COLD_AND_SLOW,
        166,
        *(pytest.param(n, marks=pytest.mark.slow) for n in (COLD_OIL, 172, 257)),
    ],
)
def test_design_that_newton_left_unsolved_is_solved(number):
    model = design(number)
    balance = balance_of(model)
    with np.errstate(all="ignore"):
        found = through_settled_time(balance, static_start(balance)).unknowns
    assert found is not None
    system = balance.evaluate(found)
    assert np.abs(system.residual).max() <= 1e-10 * system.loading[0]


@pytest.mark.slow
@pytest.mark.parametrize("number", [MOMENT_ALONE, COLD_AND_SLOW, 185, 199, 221])
def test_whole_solve_ends_in_balance(number):
    model = design(number)
    state = solve_many([model])[0]
    assert state.status is SolverOutcome.CONVERGED
    assert imbalance(state) < 1e-11


def test_normal_equilibrium_is_found_from_far_away():
    """Ring and rollers of the paper's bearing, thrown by a fifth of their clearance, come back."""
    model = paper_bearing()
    solved, balance = model.solve(), balance_of(model)
    thrown = solved.scaled[None].copy()
    moved = balance.layout.displacements
    thrown[0, moved] += np.random.default_rng(3).uniform(-15, 15, len(moved))
    rested = thrown
    for _ in range(4):
        rested = normal_equilibrium(balance, rested)
    assert rested[0, moved] == approx(solved.scaled[moved], rel=0, abs=1e-3)
    rest = np.setdiff1d(np.arange(balance.layout.size), moved)
    films = np.r_[tuple(np.arange(balance.layout.size)[balance.layout.field(k)] for k in (-3, -2))]
    kept = np.setdiff1d(rest, films)
    assert rested[0, kept] == approx(thrown[0, kept], rel=1e-12, abs=0)


@pytest.mark.parametrize("axial_modes", [2, 3])
def test_ring_without_free_tilt_keeps_its_slope(axial_modes):
    """Rigid raceways shift and tilt, however many axial modes are exchanged with elastic ones."""
    model = replace(paper_bearing(), axial_modes=axial_modes)
    model = replace(model, operation=replace(model.operation, misalignment=1e-4))
    balance = balance_of(model)
    start = static_start(balance)
    rested = balance.unpack(normal_equilibrium(balance, start))
    assert np.hypot(*rested.ring[2:, 0, 0]) == approx(1e-4, rel=1e-12)


def test_moment_alone_starts_at_the_slip_of_tilted_rollers():
    """Untilted rollers carry nothing: the slip at which they drive the cage is no start for Newton."""
    balance = balance_of(design(146))
    with np.errstate(all="ignore"):
        *_, last = newton(balance, static_start(balance))
    assert last.outcomes[0] is SolverOutcome.CONVERGED
