"""Several equilibria by films: the indicator costs no solve, what is told is solved, stable and different."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import SolverOutcome
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.several import after_passing_pitches, other_equilibria, several_likely
from quasidynamic.several.search import between_elastic_raceways
from tests.bearings import RPM, paper_bearing
from tests.thick_films import DIFFERENT, apart, decays, design, others_by_search

SLOW = pytest.mark.slow
# Designs of seed 1 with few rollers.
SEVERAL = (pytest.param(2, marks=SLOW), 8, pytest.param(29, marks=SLOW))
ONE = (0, pytest.param(16, marks=SLOW), pytest.param(20, marks=SLOW))


def designed(number):
    return design(np.random.default_rng([1, number]))


@pytest.fixture(scope="module", params=SEVERAL)
def state(request):
    return designed(request.param).solve()


@pytest.fixture(scope="module")
def others(state):
    return other_equilibria(state)


def test_films_thick_enough_for_another_equilibrium_are_noticed(state):
    assert several_likely(state)


def test_what_is_told_is_solved_and_stable_and_differs(state, others):
    known = [state, *others]
    assert others
    for place, other in enumerate(others):
        assert other.residual < 1e-9
        assert decays(other)
        assert all(apart(other, one) > DIFFERENT for one in known[: place + 1])
    largest = [other.loads[0].max() for other in others]
    assert largest == sorted(largest)


@pytest.mark.slow
def test_restarts_span_the_loads_of_an_exhaustive_search(state, others):
    found = others_by_search(state, np.random.default_rng(1), 60)
    spans = [np.array([one.loads[0].max() for one in (state, *some)]) for some in (others, found)]
    assert np.ptp(spans[0]) > 0.9 * np.ptp(spans[1])


@pytest.mark.slow
def test_equilibrium_that_differs_in_two_rollers_is_told():
    """Where three rollers carry, the other one has the one under the load alone: both beside it are slow."""
    state = design(np.random.default_rng([3, 14])).solve()
    assert max(other.loads[0].max() for other in other_equilibria(state)) > 1.5 * state.loads[0].max()


@pytest.mark.parametrize("number", ONE)
def test_no_other_equilibrium_is_told_where_random_starts_find_none(number):
    state = designed(number).solve()
    assert not others_by_search(state, np.random.default_rng(1), 20)
    assert not other_equilibria(state)


def test_indicator_is_silent_where_films_are_thin_beside_the_gaps():
    for load, speed in ((19621.1, 38000), (5000.0, 3000), (19621.1, 100)):
        assert not several_likely(paper_bearing(load=load, speed=speed * RPM).solve())


def test_indicator_costs_no_evaluation_of_the_balance(monkeypatch):
    """A solved state is all it needs."""
    state, calls = paper_bearing().solve(), []
    state.loads  # noqa: B018  evaluated once, as every result stores them
    evaluate = BearingBalance.evaluate
    monkeypatch.setattr(BearingBalance, "evaluate", lambda *given: calls.append(1) or evaluate(*given))
    several_likely(state)
    assert not calls


@pytest.mark.slow
def test_rollers_that_pass_pitches_end_where_all_but_their_spins_balances(state):
    passing = after_passing_pitches(state)
    assert passing.settled
    residual = passing.state.system.residual[0].copy()
    residual[passing.state.balance.layout.field(-1)] = 0.0
    assert np.abs(residual).max() < 1e-8


def test_rollers_with_one_equilibrium_come_back_to_it():
    """But for what a whole pitch smears out: the spin that a roller brings along."""
    state = paper_bearing().solve()
    passing = after_passing_pitches(state)
    assert passing.settled
    assert passing.state.loads == approx(state.loads, rel=0, abs=1e-3 * state.loads.max())


def test_no_pitch_is_passed_by_a_cage_that_hardly_turns():
    state = paper_bearing().solve()
    unknowns = state.unknowns
    still = state.balance.pack(unknowns._replace(cage_drift=-state.balance.rolling_cage))
    assert after_passing_pitches(replace(state, scaled=still[0])) is None


@pytest.mark.slow
def test_backwards_the_same_equilibria_are_told():
    model = designed(8)
    back = replace(model, operation=replace(model.operation, inner_speed=-model.operation.inner_speed))
    mirrored = replace(
        back,
        bearing=replace(back.bearing, first_roller_azimuth=-back.bearing.first_roller_azimuth),
        operation=replace(back.operation, load_direction=-back.operation.load_direction),
    )
    told = [
        sorted(round(float(one.loads[0].max()), 3) for one in other_equilibria(each.solve()))
        for each in (model, mirrored)
    ]
    assert told[0]
    assert told[0] == told[1]


@pytest.mark.slow
def test_raceways_that_hardly_give_way_keep_the_equilibria_of_rigid_ones():
    """Solved again between elastic raceways of a thousandth of a contact's compliance."""
    model = designed(8)
    rollers, modes = model.bearing.rollers, model.axial_modes
    state = model.solve(deviation=np.zeros((2, rollers, modes)))
    soft = 1e-12 * np.eye(rollers * modes).reshape(rollers, modes, rollers, modes)
    others = other_equilibria(state)
    assert others
    for other in others:
        elastic = between_elastic_raceways(other, (None, soft), None)
        assert elastic is not None
        assert elastic.status is SolverOutcome.CONVERGED
        assert elastic.loads == approx(other.loads, rel=0, abs=2e-2 * other.loads.max())
        assert apart(elastic, state) > DIFFERENT
