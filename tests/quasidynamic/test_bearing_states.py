"""States side by side: every quantity of every case is that of the case alone."""

from dataclasses import fields, replace
from functools import cached_property

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Equilibrium, FourPointCurve, Logarithmic, solve_many
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.columns import kind_and_numbers, kinds_and_numbers, side_by_side, taken, with_columns
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.several.indicator import (
    cage_balances_often,
    doubts,
    each_several_likely,
    several_likely,
)
from quasidynamic.solve.rollers import bordered_system
from tests.bearings import RPM, paper_bearing
from tests.thick_films import design

POCKETS = {"guidance": "inner", "land_diameter": 65.4e-3, "pocket_clearance": 1e-4}
BEARINGS = {
    "aligned rollers": {},
    "pockets of known clearance, middle slice": {"cage": POCKETS, "slices": 21},
    "held tilt": {"misalignment": 3e-4, "load_direction": 0.4},
    "free tilt": {"moment": 4.0},
    "both rings turn": {"outer_speed": -5000 * RPM, "clearance": -5e-6},
    "cage with a free centre": {"cage": {"free": True}},
}
OTHERWISE = (
    "system",
    "unknowns",
    "rollers",
    "residual",
    "floating",
    "turning",
    "losses",
    "tangent",
    "acting",
)
QUANTITIES = [
    name
    for name, value in vars(BearingStates).items()
    if isinstance(value, property | cached_property) and name[0] != "_" and name not in OTHERWISE
]


def together(states: list[Equilibrium], operations) -> BearingStates:
    """States of one bearing under several operations as arrays."""
    points = OperatingPoints.of(side_by_side(operations), len(operations))
    balance = replace(states[0].balance, points=points)
    return BearingStates(balance, np.array([state.scaled for state in states]), states[0].axial_modes)


def operations(model):
    given = model.operation
    return [
        replace(given, radial_load=f * given.radial_load, inner_speed=given.inner_speed / f)
        for f in (0.2, 1.0, 1.4)
    ]


def soft(rollers: int, modes: int) -> np.ndarray:
    """Compliance (Z, M, Z, M) of a raceway that gives way under each roller and its neighbours [m/N]."""
    around = np.arange(rollers)
    near = np.exp(-((np.minimum(around, rollers - around)) ** 2) / 4.0)
    of_mode = 2e-9 * np.diag(0.3 ** np.arange(modes))
    return np.einsum("zy,mn->zmyn", near[(around - around[:, None]) % rollers], of_mode)


def alone(model):
    return [replace(model, operation=operation).solve() for operation in operations(model)]


def between_elastic_raceways(model):
    rings = (None, soft(model.bearing.rollers, model.axial_modes))
    for start, operation in zip(alone(model), operations(model), strict=True):
        *_, end = replace(model, operation=operation).iterate(rings, start)
        yield end


@pytest.fixture(scope="module", params=[*BEARINGS, "elastic raceway"])
def cases(request):
    """Solved one by one, and the same as arrays."""
    if request.param == "elastic raceway":
        model = paper_bearing(axial_modes=3)
        states = list(between_elastic_raceways(model))
    else:
        model = paper_bearing(**BEARINGS[request.param])
        states = alone(model)
    return states, together(states, operations(model))


def assert_same(of_all, of_each):
    assert len(of_all) == len(of_each)
    for found, expected in zip(of_all, of_each, strict=True):
        assert np.shape(found) == np.shape(expected)
        size = np.abs(expected).max(initial=0.0, where=np.isfinite(expected))
        assert found == approx(expected, rel=0, abs=1e-11 * size, nan_ok=True)


@pytest.mark.sampled(2)
def test_every_quantity_of_many_states_is_that_of_each_alone(cases):
    states, many = cases
    for name in QUANTITIES:
        of_each, of_all = [getattr(state, name) for state in states], getattr(many, name)
        if of_each[0] is None:
            assert of_all is None
        else:
            assert_same(of_all, of_each)
    for name in ("inlet_pressure", "load_moment", "drag", "weight", "pocket_friction", "radii"):
        assert_same(getattr(many.acting, name), [getattr(state.cases.acting, name)[0] for state in states])


def test_losses_and_shares_of_turning_of_many_states(cases):
    states, many = cases
    for name in [field.name for field in fields(many.losses)]:
        of_each = [getattr(state.losses, name) for state in states]
        assert getattr(many.losses, name) == approx(of_each, rel=1e-9, abs=1e-12 * states[0].losses.total)
    assert np.transpose(many.turning) == approx(np.array([state.turning for state in states]), rel=1e-12)
    assert (many.losses.total == sum(vars(many.losses).values())).all()


def test_tangents_of_many_states_come_from_one_solve(cases, monkeypatch):
    states, many = cases
    of_each = [state.tangent for state in states]
    solve, calls = bordered_system.solve, []
    monkeypatch.setattr(bordered_system, "solve", lambda *given: calls.append(1) or solve(*given))
    many = many.take(np.arange(len(states)))
    assert many.tangent.radial_stiffness == approx([one.radial_stiffness for one in of_each], rel=1e-9)
    assert len(calls) == 1
    assert_same(many.tangent.stiffness, [one.stiffness for one in of_each])
    assert_same(many.tangent.compliance[:, 1:, 1:], [one.compliance[1:, 1:] for one in of_each])


def test_a_free_cage_floats_in_each_of_many_states_as_alone():
    model = paper_bearing(cage={"free": True})
    states = alone(model)
    many = together(states, operations(model))
    assert many.floating.offset == approx(np.array([one.floating.offset for one in states]), rel=1e-9)


def test_taken_cases_keep_their_quantities(cases):
    states, many = cases
    taken = many.take(np.array([2, 0]))
    assert_same(taken.loads, [states[2].loads, states[0].loads])


def test_indicator_of_several_equilibria_tells_each_case_what_it_tells_it_alone(cases):
    states, many = cases
    assert each_several_likely(many).tolist() == [several_likely(state) for state in states]
    assert_same(doubts(many), [doubts(state.cases)[0] for state in states])


def test_films_decide_under_little_load_alone():
    thick = design(np.random.default_rng([1, 2]))
    loads = [replace(thick.operation, radial_load=f * thick.operation.radial_load) for f in (1.0, 1000.0)]
    states = [replace(thick, operation=load).solve() for load in loads]
    assert each_several_likely(together(states, loads)).tolist() == [True, False]


def test_cage_is_in_balance_at_several_slips_between_the_folds_alone():
    """A falling traction curve, folds at about 1.9 and 5 kN."""
    curve = FourPointCurve.through(at_rest=0.0, peak=0.06, peak_slip=0.01, far=0.02)
    model = paper_bearing(traction=lambda **pair: curve, oil_fraction=0.3)
    loads = [replace(model.operation, radial_load=load) for load in (500.0, 3000.0, 20000.0)]
    states = [replace(model, operation=load).solve() for load in loads]
    assert cage_balances_often(together(states, loads)).tolist() == [False, True, False]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", [*BEARINGS, "tilting, known pockets"])
def test_states_of_bearings_that_differ_in_every_number(name):
    model = paper_bearing(
        **BEARINGS.get(name, {"cage": POCKETS, "moment": 3.0}), profile=Logarithmic(amplitude=2e-6)
    )
    numbers, rng = np.array(kind_and_numbers(model)[1]), np.random.default_rng(3)
    (batch,) = solve_many(
        [differing(model, numbers * rng.uniform(0.98, 1.02, len(numbers))) for _ in range(4)]
    ).batches
    states = [batch[case] for case in range(4)]
    for quantity in QUANTITIES:
        of_each = [getattr(state, quantity) for state in states]
        if of_each[0] is not None:
            assert_same(getattr(batch.states, quantity), of_each)
    assert_same(batch.states.tangent.stiffness, [state.tangent.stiffness for state in states])
    assert batch.states.losses.total == approx([state.losses.total for state in states], rel=1e-11)
    assert_same(doubts(batch.states), [doubts(state.cases)[0] for state in states])
    assert cage_balances_often(batch.states).tolist() == [
        bool(cage_balances_often(s.cases)[0]) for s in states
    ]


def test_parts_that_share_objects_have_the_kinds_and_numbers_of_each():
    model = paper_bearing()
    others = [replace(model.operation, radial_load=load) for load in (1e3, 2e3)]
    models = [model, *(replace(model, operation=operation) for operation in others)]
    kinds, numbers = kinds_and_numbers(models)
    assert len(kinds) == 1
    assert (numbers == [kind_and_numbers(each)[1] for each in models]).all()
    assert len(kinds_and_numbers([model, replace(model, slices=5)])[0]) == 2


def differing(model, numbers):
    """The same bearing with other numbers."""
    both = with_columns(model, np.array([kind_and_numbers(model)[1], numbers]))
    return taken(both, np.array([1]))


@pytest.mark.parametrize("elastic", [False, True])
def test_tangent_of_a_near_state_is_of_first_order(elastic):
    """Taken from a state near by, its error falls with the square of how far the other state is away."""
    model = paper_bearing(axial_modes=2)
    state = model.solve()
    if elastic:
        both = 1e-9 * soft(model.bearing.rollers, 2)
        *_, state = model.iterate((both, 2 * both), state)

    def error(share):
        points = OperatingPoints.of(
            replace(model.operation, radial_load=(1 + share) * model.operation.radial_load)
        )
        scaled = state.scaled[None] * (1 + share)
        there = BearingStates(replace(state.balance, points=points), scaled, state.axial_modes)
        tangents = replace(there, near=state.cases).tangent, state.tangent, there.tangent
        near, here, exact = (tangent.radial_stiffness for tangent in tangents)
        return abs(near / exact - 1).item(), abs(here / exact - 1).item()

    (far, of_far), (half, of_half) = error(1e-5), error(5e-6)
    assert of_far > 20 * far > 0  # the change itself is seen
    assert far / half == approx(4, rel=0.2)
    assert of_far / of_half == approx(2, rel=0.2)
