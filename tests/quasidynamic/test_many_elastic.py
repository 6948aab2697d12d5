"""Bearings between the same elastic raceways, solved side by side, are those of one solve after the other."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import SolverOutcome, solve_many, solve_many_elastic
from quasidynamic.roller import side_by_side_batches
from quasidynamic.solve.rollers import many_elastic
from quasidynamic.solve.rollers.contact_search import contact_search
from quasidynamic.solve.rollers.many_elastic import Way
from quasidynamic.solve.rollers.parametric_balance import between
from quasidynamic.solve.rollers.solved_neighbours import coordinates, local_fit, spread_out
from tests.bearings import RPM, paper_bearing
from tests.quasidynamic.test_contact_search import ring


def map_of(loads, speeds, **changes):
    """The same bearing over loads [N] and speeds [rpm]."""
    model = paper_bearing(slices=10, **changes)
    points = [(load, speed) for load in loads for speed in speeds]
    return [
        replace(model, operation=replace(model.operation, radial_load=load, inner_speed=speed * RPM))
        for load, speed in points
    ]


def raceways(model, inner=True, outer=True):
    """Compliances of a stiff inner and a soft outer ring, or of one of them."""
    azimuths, modes = model.bearing.azimuths, model.axial_modes
    soft = ring(azimuths, 6e-3, 1e9, max(modes, 3))[:, :modes, :, :modes]
    stiff = ring(azimuths, 10e-3, 1e10, max(modes, 3))[:, :modes, :, :modes]
    return stiff if inner else None, soft if outer else None


def alone(model, compliance, deviation=None):
    *_, last = model.iterate(compliance, model.solve(), deviation)
    return last


def same_as_alone(models, compliance, deviation=None):
    """Loads to 1e-9 of the largest, slips to 1e-9, lives to a share of 1e-9; returns all of them."""
    many = solve_many_elastic(models, compliance, solve_many(models), deviation)
    assert len(many) == len(models)
    for number, (model, state) in enumerate(zip(models, many, strict=True)):
        one = alone(model, compliance, deviation if np.ndim(deviation) < 4 else deviation[number])
        assert state.status is one.status is SolverOutcome.CONVERGED
        assert state.loads == approx(one.loads, rel=0, abs=1e-9 * one.loads.max())
        assert state.cage_slip == approx(one.cage_slip, rel=0, abs=1e-9)
        assert state.life == approx(one.life, rel=1e-9)
    return many


def test_loads_and_speeds():
    models = map_of(np.geomspace(5e3, 3e4, 6), np.linspace(1e4, 4e4, 5), axial_modes=3)
    many = same_as_alone(models, raceways(models[0]))
    assert many.ways[Way.FITTED] > 5


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("modes", "races"),
    [(1, (True, False)), (2, (False, True)), (4, (True, False))],
    ids=["inner", "outer, tilted", "inner, four shapes"],
)
def test_one_elastic_raceway(modes, races):
    models = map_of([3e3, 1e4, 2e4], [1e4, 2e4, 3e4, 4e4], axial_modes=modes)
    same_as_alone(models, raceways(models[0], *races))


@pytest.mark.slow
def test_clearances_tilts_and_shapes_that_differ():
    rng = np.random.default_rng(7)
    models, shapes = [], []
    for _ in range(24):
        held = rng.random() < 0.5
        clearance, load = rng.uniform(2e-5, 9e-5), rng.uniform(5e3, 3e4)
        tilted = {"misalignment": 2e-4 * rng.random()} if held else {"moment": 20.0}
        models.append(paper_bearing(slices=10, axial_modes=2, clearance=clearance, load=load, **tilted))
        shapes.append(rng.random() * 5e-6 * np.cos(2 * models[0].bearing.azimuths)[:, None] * [1.0, 0.1])
    deviation = np.array([[0 * shape, shape] for shape in shapes])
    same_as_alone(models, raceways(models[0]), deviation)
    same_as_alone(models[:3], raceways(models[0]), deviation[0])


def test_no_answer_depends_on_its_neighbours_or_their_order():
    models = map_of(np.geomspace(1e3, 3e4, 6), np.linspace(5e3, 4e4, 6), axial_modes=2)
    compliance = raceways(models[0])
    whole = solve_many_elastic(models, compliance, solve_many(models))
    some = np.random.default_rng(2).permutation(len(models))[:15]
    chosen = [models[place] for place in some]
    part = solve_many_elastic(chosen, compliance, solve_many(chosen))
    for place, state in zip(some, part, strict=True):
        assert state.loads == approx(whole[int(place)].loads, rel=0, abs=1e-9 * state.loads.max())


def test_what_no_fit_leads_to_is_searched(monkeypatch):
    def far_off(solved, places):
        fit = local_fit(solved, places)
        return fit._replace(weights=0 * fit.weights + np.nan)

    monkeypatch.setattr(many_elastic, "local_fit", far_off)
    models = map_of([3e3, 1e4, 2e4], [1e4, 2e4, 3e4, 4e4], axial_modes=2)
    many = same_as_alone(models, raceways(models[0]))
    assert many.ways[Way.FITTED] == 0


def test_what_no_search_leads_to_is_solved_alone(monkeypatch):
    def without_steps(balance, unknowns):
        yield next(contact_search(balance, np.full(unknowns.shape, np.nan)))

    monkeypatch.setattr(many_elastic, "contact_search", without_steps)
    models = map_of([3e3, 1e4, 2e4], [1e4, 2e4], axial_modes=2)
    many = same_as_alone(models, raceways(models[0]))
    assert many.ways == {Way.ALONE: 6}


def test_where_several_equilibria_are_likely_the_start_decides(monkeypatch):
    def doubtful(states):
        return np.ones(len(states.scaled), bool)

    monkeypatch.setattr("quasidynamic.many_elastic.each_several_likely", doubtful)
    models = map_of([3e3, 1e4, 2e4], [1e4, 2e4, 3e4, 4e4], axial_modes=2)
    assert same_as_alone(models, raceways(models[0])).ways == {Way.ALONE: 8, Way.CONFIRMED: 4}


def test_start_that_is_not_solved_is_the_answer():
    models = map_of([3e3, 0.0, 2e4], [1e4], axial_modes=2)
    many = solve_many_elastic(models, raceways(models[0]), solve_many(models))
    assert [state.status for state in many] == ["converged", "undetermined", "converged"]
    assert many.unsolved == (1,)


def test_starts_are_solved_where_they_are_needed(monkeypatch):
    models = map_of(np.geomspace(5e3, 3e4, 8), np.linspace(1e4, 4e4, 6), axial_modes=2)
    compliance, solved = raceways(models[0]), []

    def counted(bearings):
        solved.append(len(bearings))
        return solve_many(bearings)

    known = solve_many_elastic(models, compliance, solve_many(models))
    monkeypatch.setattr("quasidynamic.many_elastic.solve_many", counted)
    lazy = solve_many_elastic(models, compliance)
    assert sum(solved) == len(models) - lazy.ways[Way.FITTED] < len(models)
    for one, other in zip(known, lazy, strict=True):
        assert np.array_equal(one.scaled, other.scaled)


def test_start_that_is_needed_and_not_solved_is_the_answer():
    models = map_of([3e3, 0.0, 2e4], [1e4], axial_modes=2)
    many = solve_many_elastic(models, raceways(models[0]))
    assert [state.status for state in many] == ["converged", "undetermined", "converged"]


@pytest.mark.parametrize("damped", [False, True], ids=["full steps", "damped"])
def test_searches_side_by_side_end_where_each_ends_alone(damped):
    """After 3 to 7 full steps, after 5 to 9 damped ones."""
    models = map_of([100.0, 500.0, 2e4, 3e4], [2e4], axial_modes=3)
    soft = None, ring(models[0].bearing.azimuths, 3.6e-3, 1e8, 3)
    _, many = next(side_by_side_batches(models, len(models)))
    balances = [between(model.balance(aligned=False), soft) for model in models]
    starts = [b.pack(model.solve().unknowns) for b, model in zip(balances, models, strict=True)]
    together = between(many.balance(len(models), aligned=False), soft)
    ends: dict[int, tuple] = {}
    for iterate in contact_search(together, np.concatenate(starts), damped=damped):
        ends |= {case: (iterate.number, x) for case, x in zip(iterate.cases, iterate.unknowns, strict=True)}
    for case, (balance, start) in enumerate(zip(balances, starts, strict=True)):
        *_, last = contact_search(balance, start, damped=damped)
        assert ends[case][0] == last.number
        assert ends[case][1] == approx(last.unknowns[0], rel=0, abs=1e-4 * np.abs(last.unknowns).max())
    assert len({number for number, _ in ends.values()}) > 1


@pytest.mark.parametrize(("solved", "highest"), [(14, 1), (15, 2), (40, 2)])
def test_fit_is_exact_for_polynomials_of_scattered_coordinates(solved, highest):
    rng = np.random.default_rng(4)
    numbers = np.exp(rng.uniform(-2, 2, (60, 3)))
    places = coordinates(np.column_stack([numbers, np.full(60, 5.0)]))
    assert places.shape == (60, 3)
    assert places.min() == 0
    assert places.max() == 1
    values = (places @ rng.normal(size=(3, 4)) + 1.0) ** highest
    fit = local_fit(places[:solved], places[40:])
    assert fit.of(values[:solved]) == approx(values[40:], rel=0, abs=1e-6)


def test_numbers_that_follow_from_another_share_a_coordinate_with_it():
    warm, load = np.random.default_rng(4).uniform(1, 2, (2, 60))
    places = coordinates(np.column_stack([load, warm, warm**-3, 5 * warm**2]))
    assert places.shape == (60, 2)


def test_numbers_that_differ_in_their_last_digit_alone_are_no_coordinate():
    numbers = np.full((20, 1), 1e10)
    numbers[0] = np.nextafter(1e10, 2e10)
    assert (coordinates(numbers) == 0).all()


def test_cases_that_are_alike_have_one_place():
    places = coordinates(np.ones((20, 3)))
    assert places.shape == (20, 1)
    assert sorted(spread_out(places, 8)) == list(range(20))
    values = np.arange(12.0)[:, None]
    assert 0 <= local_fit(places[:12], places[12:]).of(values).min() <= 11
