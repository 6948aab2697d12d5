"""Maps: states of neighbouring points on one sheet, folds between points, states of other sheets."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from pytest import approx

from quasidynamic import OutOfRange
from quasidynamic.maps import GridPoints, SolvedGrid, folds, solve
from quasidynamic.maps.examined import each_examined, examined, implied
from quasidynamic.maps.filled import nested, one_state_each, through
from quasidynamic.maps.folds import End
from quasidynamic.maps.newton_states import Reached
from quasidynamic.maps.other_sheets import MOST_ROUNDS, search
from quasidynamic.maps.sheets import FINEST, connect_all
from quasidynamic.maps.states import OUTSIDE, States
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.step_length import SolverOutcome
from quasidynamic.trace import trace
from tests import thick_films
from tests.bearings import RPM
from tests.cold_oil import cold_bearing
from tests.quasidynamic.test_trace import SPAN, falling

LOADS = np.geomspace(*SPAN, 9)  # [N]
STARTS = 40  # by lot at a point


def over(shape, loads, speeds=(38000 * RPM,), model=None):
    model = model or falling(1e3)
    operations = (
        replace(model.operation, radial_load=float(load), inner_speed=float(speed))
        for load in loads
        for speed in speeds
    )
    return GridPoints.of(shape, [replace(model, operation=operation) for operation in operations])


@pytest.fixture(scope="module")
def line():
    """An S of the slip over the load, its sheets followed from one state of each point."""
    points = over((len(LOADS),), LOADS)
    states = States(points, one_state_each(points, map))
    connect_all(points, states, map)
    return states


@pytest.fixture(scope="module")
def exact():
    """Loads of the folds by continuation along the branch, rising."""
    return sorted(fold.value for fold in trace(falling(SPAN[0]), span=SPAN).folds)


@pytest.mark.slow
def test_both_stable_states_are_at_every_load_between_the_folds(line, exact):
    between = (exact[0] < LOADS) & (exact[1] > LOADS)
    assert (line.stable_count == np.where(between, 2, 1)).all()


@pytest.mark.slow
def test_sheets_end_at_the_folds_of_the_branch(line, exact):
    ended = folds(SolvedGrid.of(over((len(LOADS),), LOADS), line))
    assert ended.located.all()
    assert np.interp(np.sort(ended.places[:, 0]), np.arange(len(LOADS)), LOADS) == approx(
        exact, rel=1e-6, abs=0
    )


def test_two_points_have_a_state_each():
    solved = solve(over((2,), (400.0, 1000.0)))
    assert solved.point.tolist() == [0, 1]
    assert solved.continues.tolist() == [[OUTSIDE, 1], [0, OUTSIDE]]


@pytest.mark.slow
def test_ends_that_are_no_folds_are_not_located(line):
    solved = SolvedGrid.of(over((len(LOADS),), LOADS), line)
    ended = folds(replace(solved, last={}))
    assert not ended.located.any()
    whole = folds(solved)
    assert np.abs(ended.places - whole.places).max() < 2 * FINEST


def test_rounds_and_folds_are_told_with_their_numbers(line):
    """How much there is to do is known before it takes its time."""
    points, told = over((len(LOADS),), LOADS), []

    def tell(text):
        told.append(text)
        raise InterruptedError

    with pytest.raises(InterruptedError):
        search(points, line, map, tell)
    likely = np.union1d(line.point[line.doubtful], np.flatnonzero(line.stable_count > 1))
    where = f"from {len(likely)} of {len(likely)} points where several states are likely"
    assert told == [f"other sheets: round 1 of at most {MOST_ROUNDS}, {where}"]
    told.clear()
    folds(replace(SolvedGrid.of(points, line), last={}), told.append)
    assert told == [f"folds: {number} of 2 ends of stable states" for number in (1, 2)]


def test_folds_of_an_end_come_before_the_next_point():
    up, down = (End(0, side, np.array([2.25]), None) for side in (1, 0))
    assert [up.before_next_point(place) for place in (2.9, 3.1)] == [True, False]
    assert [down.before_next_point(place) for place in (2.1, 1.9)] == [True, False]


def test_states_continue_forth_and_back(line):
    for state, side in np.argwhere(line.continues >= 0):
        other = line.continues[state, side]
        assert line.continues[other, side ^ 1] == state
        assert abs(int(line.point[other]) - int(line.point[state])) == 1


def test_points_between_two_others_are_the_bearings_there():
    points = over((3,), [1e3, 2e3, 4e3])
    alone = points.between(np.array([0]), np.array([1]), np.array([0.25]))
    assert alone.points.load[0, 0] == approx(1250.0, rel=1e-14, abs=0)
    both = points.between(np.array([0, 2]), np.array([1, 1]), np.array([0.5, 0.5]))
    assert both.points.load[:, 0] == approx([1500.0, 3000.0], rel=1e-14, abs=0)


def test_points_of_other_equations_are_refused():
    one = falling(1e3)
    with pytest.raises(OutOfRange, match="not the same equations"):
        GridPoints.of((2,), [one, replace(one, slices=5)])


def test_neighbours_stand_along_each_axis():
    points = over((2, 3), [1e3, 2e3], (100.0, 200.0, 300.0))
    assert points.neighbours.tolist() == [
        [-1, 3, -1, 1], [-1, 4, 0, 2], [-1, 5, 1, -1], [0, -1, -1, 4], [1, -1, 3, 5], [2, -1, 4, -1]
    ]  # fmt: skip


@pytest.mark.parametrize("shape", [(100, 100), (7, 33), (2, 3), (90,), (20, 20, 20)])
def test_nested_grids_hold_each_other_and_the_ends(shape):
    grids = nested(shape)
    assert [len(places) for places in grids[-1]] == list(shape)
    for coarse, fine in pairwise(grids):
        assert all(np.isin(some, others).all() for some, others in zip(coarse, fine, strict=True))
        assert all(some[0] == 0 and some[-1] == n - 1 for some, n in zip(coarse, shape, strict=True))
    assert np.prod([len(places) for places in grids[0]]) <= max(8, 2 * np.sqrt(np.prod(shape)))


def test_starts_are_exact_where_states_are_cubic_along_the_axes():
    shape, nodes = (14, 9), [np.array([0, 4, 8, 12, 13]), np.array([0, 3, 6, 8])]
    x, y = np.meshgrid(*map(np.arange, shape), indexing="ij")
    values = np.stack([x**3 - 5 * x * y**2, y**3 + x**2], axis=-1).astype(float)
    assert through(nodes, shape, values[np.ix_(*nodes)]) == approx(values, rel=0, abs=1e-9)


def neighbours(rate=-100.0, spin=1.0, middle=1.0, likely=0.0):
    """Three points: both ends examined, rates of -100 1/s and `rate`, spins of 1 and `spin`."""
    spins = np.array([[1.0], [middle], [spin]])
    states = Reached(np.ones((3, 1)), np.ones((3, 2, 1)), spins)
    return states, np.array([[-100.0, 0.0], [np.nan, np.nan], [rate, likely]])


@pytest.mark.parametrize(
    ("around", "stable"),
    [
        ({}, True),
        ({"rate": -51.0}, True),
        ({"rate": -49.0}, False),
        ({"rate": 10.0}, False),
        ({"rate": np.nan}, False),
        ({"likely": 1.0}, False),
        ({"middle": 0.9}, False),
        ({"middle": 0.9, "spin": 0.8}, True),
    ],
)
def test_neighbours_imply_stability_where_their_rates_and_states_are_alike(around, stable):
    assert implied(over((3,), [1e3, 2e3, 4e3]), *neighbours(**around))[1] == stable


def test_what_neighbours_imply_is_what_an_examination_finds():
    loads, speeds = np.geomspace(1e3, 8e3, 5), np.linspace(25e3, 38e3, 3) * RPM
    points = over((5, 3), loads, speeds)
    states = one_state_each(points)
    each, every = each_examined(points, states), examined(points, np.arange(15), states)
    assert (each[:, 0] == (every[:, 0] < 0)).all()
    assert not (each[:, 1] & ~(every[:, 1] > 0)).any()


@pytest.fixture
def few_rounds(monkeypatch):
    """Searches that end early: regions are found by the first rounds, all their states by many."""
    monkeypatch.setattr("quasidynamic.maps.other_sheets.MOST_ROUNDS", 2)


@pytest.mark.slow
@pytest.mark.usefixtures("few_rounds")
def test_fold_curves_bound_the_points_with_several_states():
    """They pass between points with different numbers of states, and are followed to the edges of a map."""
    speeds = np.linspace(25e3, 38e3, 4) * RPM
    points = over((len(LOADS), len(speeds)), LOADS, speeds)
    solved = solve(points)
    count = solved.stable_count.reshape(points.shape)
    assert (count > 1).any()
    ended = folds(solved)
    assert ended.located.mean() > 0.9
    assert ended.curves
    assert ended.cut == 0
    pieces = [
        piece for curve in ended.curves for piece in zip(curve.places[:-1], curve.places[1:], strict=True)
    ]
    for column in range(len(speeds)):
        crossings = np.array([crossing for piece in pieces for crossing in crossed(*piece, column)])
        for change in np.flatnonzero(np.diff(count[:, column])):
            assert ((crossings > change - 0.05) & (crossings < change + 1.05)).any()
    for curve in ended.curves:
        assert curve.errors.max() < 1e-6


def crossed(one, other, column):
    """Places along the first axis at which a piece passes a column of the grid."""
    before, after = one[1] - column, other[1] - column
    if before * after <= 0 and before != after:
        yield one[0] + before / (before - after) * (other[0] - one[0])


@pytest.mark.slow
@pytest.mark.usefixtures("few_rounds")
@pytest.mark.parametrize("oil", ["falling traction", "cold oil"])
def test_no_region_of_several_states_is_missed(oil, tmp_path):
    """Where random starts at a point find another state than the one of a map, the map has several there."""
    if oil == "cold oil":
        loads, speeds, model = (
            np.geomspace(1e3, 4e3, 6),
            np.geomspace(1e3, 6e3, 6),
            cold_bearing(13, tmp_path),
        )
    else:
        loads, speeds, model = np.geomspace(1.5e3, 6e3, 6), np.linspace(25e3, 38e3, 6), falling(1e3)
    points = over((len(loads), len(speeds)), loads, speeds * RPM, model)
    solved, rng, several = solve(points), np.random.default_rng(3), 0
    for point in rng.choice(len(points.bearings), 8, replace=False):
        known = solved.scaled[(solved.point == point) & solved.stable]
        state = Equilibrium(points.at(np.array([point])), known[0], SolverOutcome.CONVERGED, 0, 2)
        others = thick_films.others_by_search(state, rng, STARTS)
        assert not others or len(known) > 1
        several += len(known) > 1
    assert several
