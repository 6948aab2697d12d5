"""Rolling with stick and slip: what must hold whatever the contact."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.rolling.fastsim import fastsim, fastsim_changes, flexibility
from quasidynamic.contact.rolling.full_sliding import full_sliding, hertz_pressure, sliding_changes
from quasidynamic.contact.rolling.kalker import kalker, kalker_changes
from quasidynamic.contact.rolling.rolling_contact import MID_STEP, RollingContacts
from quasidynamic.contact.rolling.stick_slip import solved
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange
from tests.random_contacts import STEEL, drawn
from tests.reference.rolling_steps import RollingSteps

CHANGES = {kalker: kalker_changes, fastsim: fastsim_changes, full_sliding: sliding_changes}
LAWS = pytest.mark.parametrize("law", [kalker, fastsim, full_sliding])


def power(rolled):
    """Heat over rolling speed, counted by the rigid slip."""
    return -(rolled.traction * rolled.creep).sum((1, 2, 3)) * rolled.contacts.cell_area


def heathcote(shape, size=2e-4, axes=(3e-4, 2e-3)):
    """A narrow contact with spin, and slip along that changes its sign across, partly sticking."""
    grid = grid_over(axes, shape)
    contacts = RollingContacts((grid,), (STEEL,), 0.1 * hertz_pressure(grid, axes, 2000.0)[None])
    x, y = contacts.places(MID_STEP)
    along = size * (4 * (y / axes[1]) ** 2 - 0.7) - 0.5 * size * y / axes[1] + 0 * x
    return contacts, np.stack([along, 0.5 * size * x / axes[1] + 0 * y], 1)


def test_a_drawn_layer_is_between_the_bodies():
    (bare, creep), (layered, same) = drawn(3), drawn(3, layers=True)
    assert np.array_equal(creep, same)
    assert layered.pressure is None
    assert (
        np.abs(kalker(layered, creep).traction - kalker(bare, creep).traction).max() > 1e-3 * bare.limit.max()
    )


def check_coulomb(seed):
    contacts, creep = drawn(seed, layers=seed % 3 == 0)
    rolled, most = kalker(contacts, creep), contacts.limit.max()
    slip, size = rolled.slip, np.hypot(rolled.traction[:, 0], rolled.traction[:, 1])
    assert np.all(size <= contacts.limit + 1e-4 * most)
    assert np.all((rolled.traction * slip).sum(1) <= 1e-5 * most * np.abs(creep).max())
    assert power(rolled)[0] <= power(full_sliding(contacts, creep))[0] * (1 + 1e-5)
    assert power(rolled)[0] >= 0.0


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 2**31))
def test_traction_keeps_its_limit_and_opposes_slip_and_heats_less_than_full_sliding(seed):
    check_coulomb(seed)


@pytest.mark.long
@settings(max_examples=1000, deadline=None)
@given(seed=st.integers(0, 2**31))
def test_a_thousand_contacts_heat_less_than_full_sliding(seed):
    check_coulomb(seed)


@pytest.mark.parametrize("law", [kalker, fastsim])
def test_nothing_slips_where_it_sticks_and_traction_is_at_its_limit_where_it_slips(law):
    contacts, creep = heathcote((20, 40))
    rolled = law(contacts, creep)
    slip, size = rolled.slip, np.hypot(rolled.traction[:, 0], rolled.traction[:, 1])
    assert 0.1 < rolled.stick_share[0] < 0.95
    assert np.abs(slip[:, :, rolled.stick[0] & (contacts.limit[0] > 0)]).max() < 1e-5 * np.abs(creep).max()
    assert size[~rolled.stick] == approx(contacts.limit[~rolled.stick], rel=1e-5)


@pytest.mark.parametrize("law", [kalker, fastsim])
def test_slip_heats_as_the_rigid_slip_does(law):
    """Elastic displacements have no power in a steady state, to the first order of the cells."""
    errors = []
    for shape in ((20, 40), (40, 80)):
        contacts, creep = heathcote(shape, size=1e-3)
        rolled = law(contacts, creep)
        by_slip = -(rolled.traction * rolled.slip).sum() * contacts.cell_area[0]
        errors.append(abs(by_slip / power(rolled)[0] - 1))
    assert errors[1] < 0.7 * errors[0] < 0.15


def test_unequal_bodies_are_sheared_by_pressure():
    """Of bodies that pressure draws outwards, each half resists; without creep the forces cancel."""
    contacts, creep = heathcote((20, 40))
    unequal = (ElasticPair(STEEL.shear, STEEL.poisson, 0.2 * STEEL.shear),)
    with pytest.raises(ImpossiblePart, match="`pressure` is needed"):
        replace(contacts, pairs=unequal)
    pressed = replace(contacts, pairs=unequal, pressure=10 * contacts.limit)
    rolled = kalker(pressed, 0 * creep)
    largest = contacts.limit.sum() * contacts.cell_area[0]
    assert np.hypot(*rolled.traction[0]).max() > 0.1 * contacts.limit.max()
    assert rolled.force[0, 1] == approx(0.0, abs=1e-6 * largest)
    assert rolled.traction[0, 1] == approx(-rolled.traction[0, 1, :, ::-1], abs=1e-5 * contacts.limit.max())


def test_stiff_bodies_slide_everywhere():
    contacts, creep = heathcote((20, 40))
    stiff = replace(contacts, pairs=(ElasticPair(STEEL.shear / 1e3, STEEL.poisson / 1e3),))
    sliding = power(full_sliding(contacts, creep))
    for law in (kalker, fastsim):
        assert power(law(stiff, creep)) == approx(sliding, rel=1e-4)


def test_heat_converges_with_the_cells():
    """By at least half with cells of half the size."""
    heats = [power(kalker(*heathcote(shape, size=1e-3)))[0] for shape in ((10, 20), (20, 40), (40, 80))]
    changes = np.abs(np.diff(heats)) / heats[-1]
    assert changes[1] < 0.5 * changes[0]
    assert changes[1] < 0.012


def test_rolling_from_rest_ends_in_the_steady_state():
    contacts, creep = heathcote((10, 20))
    steps = RollingSteps(contacts.grids[0], STEEL)
    traction = np.zeros_like(creep[0])
    for _ in range(60):
        traction = steps.after(traction, creep[0] * contacts.step[0], contacts.limit[0]).traction
    steady = kalker(contacts, creep).traction[0]
    assert traction == approx(steady, abs=2e-3 * contacts.limit.max())


def test_first_contact_without_rolling_does_not_stick_at_the_leading_edge_alone():
    """Symmetric before rolling, by the kernel that has no direction."""
    contacts, creep = heathcote((20, 40))
    even = np.stack([np.broadcast_to(creep[0, 0, :1], (20, 40)), np.zeros((20, 40))]) * contacts.step[0]
    steps = RollingSteps(contacts.grids[0], STEEL, cells=0)
    traction = steps.after(np.zeros_like(even), even, contacts.limit[0]).traction
    assert traction[0] == approx(traction[0, ::-1], abs=1e-5 * contacts.limit.max())


def test_fastsim_heats_as_half_spaces_do():
    contacts, creep = heathcote((20, 40), size=1e-3)
    assert power(fastsim(contacts, creep)) == approx(power(kalker(contacts, creep)), rel=0.05)


@LAWS
def test_changes_of_traction_are_its_derivative(law, monkeypatch):
    """That of FASTSIM with the flexibility as it is."""
    contacts, creep = heathcote((10, 20))
    springs = flexibility(contacts, creep)
    monkeypatch.setattr("quasidynamic.contact.rolling.fastsim.flexibility", lambda *_: springs)
    way = np.array([[np.ones((10, 20)), np.zeros((10, 20))], [np.zeros((10, 20)), np.ones((10, 20))]])[None]
    step = 1e-4 * np.abs(creep).max()
    rolled = law(contacts, creep)
    for change, each in zip(CHANGES[law](rolled, way)[0], way[0], strict=True):
        up, down = (law(contacts, creep + sign * step * each).force[0] for sign in (1, -1))
        found = change.sum((-2, -1)) * contacts.cell_area[0]
        assert found == approx((up - down) / (2 * step), rel=0.03, abs=0.02 * np.abs(found).max())


@pytest.mark.parametrize("size", [3e-4, 2e-3])
def test_changes_of_fastsim_are_its_derivative_cell_by_cell(size, monkeypatch):
    """Where it sticks and where it slips; no cell changes between both within the difference."""
    contacts, creep = heathcote((10, 20), size=size)
    springs = flexibility(contacts, creep)
    monkeypatch.setattr("quasidynamic.contact.rolling.fastsim.flexibility", lambda *_: springs)
    rolled = fastsim(contacts, creep)
    assert 0.02 < rolled.stick_share[0] < 0.98
    way = np.array([[np.ones((10, 20)), np.zeros((10, 20))], [np.zeros((10, 20)), np.ones((10, 20))]])[None]
    step = 1e-6 * np.abs(creep).max()
    for change, each in zip(fastsim_changes(rolled, way)[0], way[0], strict=True):
        up, down = (fastsim(contacts, creep + sign * step * each).traction[0] for sign in (1, -1))
        assert change == approx((up - down) / (2 * step), rel=0.0, abs=1e-5 * np.abs(change).max())


@LAWS
def test_contacts_side_by_side_are_those_alone(law):
    first, second = heathcote((10, 20)), heathcote((10, 20), size=5e-4, axes=(4e-4, 1e-3))
    both = RollingContacts(
        first[0].grids + second[0].grids, (STEEL, STEEL), np.concatenate([first[0].limit, second[0].limit])
    )
    together = law(both, np.concatenate([first[1], second[1]]))
    for number, (contacts, creep) in enumerate((first, second)):
        alone = law(contacts, creep)
        assert together.traction[number] == approx(alone.traction[0], rel=1e-9, abs=1e-3)


@pytest.mark.parametrize("law", [kalker, fastsim])
def test_a_soft_layer_makes_more_stick_and_less_heat(law):
    contacts, creep = heathcote((20, 40))
    layer = np.full_like(contacts.limit, 2e-6 / contacts.limit.max())  # 2 um at the largest traction
    stiff, soft = law(contacts, creep), law(replace(contacts, compliance=layer), creep)
    assert soft.stick_share[0] > stiff.stick_share[0]
    assert power(soft)[0] < power(stiff)[0]


def test_a_start_near_the_solution_finds_the_same_one():
    contacts, creep = heathcote((20, 40))
    cold = kalker(contacts, creep)
    warm = kalker(contacts, creep, fastsim(contacts, creep).traction)
    assert warm.traction == approx(cold.traction, abs=1e-5 * contacts.limit.max())


def test_pressure_of_cells_sums_to_the_load():
    for shape in ((1, 1), (7, 12), (40, 80)):
        grid = grid_over((1e-3, 2e-3), shape)
        pressure = hertz_pressure(grid, (1e-3, 2e-3), 500.0)
        assert pressure.sum() * grid.cell_area == approx(500.0, rel=2e-3)
        assert pressure.max() <= 1.5 * 500.0 / (np.pi * 2e-6)


def test_linear_solve_meets_a_direct_one_also_after_a_new_start(monkeypatch):
    matrix = np.eye(30) + 0.3 * np.random.default_rng(3).normal(size=(30, 30)) / np.sqrt(30)
    right = np.random.default_rng(4).normal(size=(2, 5, 3))
    for basis in (80, 8):
        monkeypatch.setattr("quasidynamic.contact.rolling.stick_slip.BASIS", basis)
        found = solved(lambda change: (matrix @ change.ravel()).reshape(right.shape), right, 1e-9)
        assert found.ravel() == approx(np.linalg.solve(matrix, right.ravel()), abs=1e-8)


def test_newton_that_ends_too_early_is_told(monkeypatch):
    monkeypatch.setattr("quasidynamic.contact.rolling.stick_slip.LIMIT", 2)
    with pytest.raises(NotSolved, match="left after 2 Newton steps") as stopped:
        kalker(*heathcote((10, 20)))
    assert stopped.value.outcome == "iteration limit"


def test_impossible_contacts_are_refused():
    contacts, _ = heathcote((10, 20))
    with pytest.raises(ImpossiblePart, match="limit must be finite"):
        replace(contacts, limit=-contacts.limit)
    with pytest.raises(ImpossiblePart, match="compliance must be finite"):
        replace(contacts, compliance=np.full_like(contacts.limit, np.nan))
    with pytest.raises(ImpossiblePart, match="do not fit"):
        replace(contacts, limit=contacts.limit[:, 1:])


def test_fastsim_refuses_patches_beyond_its_table():
    with pytest.raises(OutOfRange, match="a/b = 0\\.01"):
        fastsim(*heathcote((10, 20), axes=(2e-5, 2e-3)))
