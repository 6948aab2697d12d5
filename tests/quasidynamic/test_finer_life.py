"""Line loads that a richer resolution finds at the loads of a coarser one."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Logarithmic, solve_many
from quasidynamic.outcome.finer_life import _FinerContacts, _solved, life_errors
from tests.bearings import paper_bearing

TILTED = {"misalignment": 1e-3, "load": 8000.0, "axial_modes": 3, "profile": Logarithmic(amplitude=1e-6)}


def soft(modes, size=2e-9):
    """Raceway that gives way under each roller alone, softly in its further shapes."""
    own = np.diag(size / np.arange(1, modes + 1.0) ** 2)
    own[0, 2] = own[2, 0] = own[1, 3] = own[3, 1] = -0.2 * size
    return np.einsum("zy,mn->zmyn", np.eye(30), own)


def test_nothing_richer_changes_nothing():
    state = paper_bearing(**TILTED).solve()
    same = _FinerContacts.of(state.cases, 20, (None, None))
    assert same.line_loads()[:, :, 0].transpose(1, 2, 0) == approx(state.slice_loads, rel=1e-6, abs=1.0)


def test_shapes_of_one_raceway_change_nothing_at_the_other():
    state = paper_bearing(**TILTED).solve()
    alone, beside = (
        _FinerContacts.of(state.cases, 40, (None, outer)).line_loads() for outer in (None, soft(5))
    )
    assert beside[:, 0] == approx(alone[:, 0], rel=1e-9, abs=1e-6)
    assert np.abs(beside[:, 1] - alone[:, 1]).max() > 1e-3 * alone[:, 1].max()


def test_load_and_moment_are_kept():
    state = paper_bearing(**TILTED).solve()
    finer = _FinerContacts.of(state.cases, 80, (None, soft(5)))
    force = finer.line_loads()[:, 1, 0].T @ finer.slices.weights
    loaded = state.loads[1] > 1e-3 * state.loads[1].max()
    assert force[loaded, :2] == approx(state.forces[1, loaded, :2], rel=1e-5, abs=0.01)


def test_further_shapes_are_those_of_the_deflected_raceway():
    state = paper_bearing(**TILTED).solve()
    compliance, finer = soft(5), _FinerContacts.of(state.cases, 80, (None, soft(5)))
    loads = finer.line_loads()[:, 1, 0].T
    closed = loads > 0.3 * loads.max()
    force = loads @ finer.slices.weights
    before = np.zeros((30, 5))
    before[:, :3] = np.einsum("zmyn,yn->zm", compliance[:, :3, :, :3], finer.force[:, 1, 0].T)
    deflection = np.einsum("zmyn,yn->zm", compliance, force) - before
    approach = (loads / np.ravel(finer.law.coefficient)[1]) ** 0.9 + finer.drop[
        :, 0, 0, 0
    ]  # what carries these loads
    wanted = finer.approach[:, 1, 0].T - deflection
    for roller in np.flatnonzero(closed.sum(1) > 20):
        beyond = approach[roller] - finer.slices.modes[:, 2:] @ wanted[roller, 2:]
        x = finer.slices.centres[closed[roller]]
        line = np.polyfit(x, beyond[closed[roller]], 1)  # place and tilt of the roller are left
        assert np.polyval(line, x) == approx(beyond[closed[roller]], abs=1e-4 * approach.max())


def test_error_falls_as_slices_grow():
    errors = [life_errors(paper_bearing(**TILTED, slices=n).solve().cases)[0] for n in (10, 40, 160)]
    assert errors[0] > 2 * errors[1] > 4 * errors[2] > 0


@pytest.mark.parametrize("slices", [10, 20])
def test_error_of_a_rigid_bearing_holds_the_truth(slices):
    state = paper_bearing(**TILTED, slices=slices).solve()
    truth = paper_bearing(**TILTED, slices=640).solve().life
    assert abs(state.life / truth - 1) < life_errors(state.cases)[0] < 0.3


@pytest.mark.parametrize("compliance", [(None, None), (None, soft(5))], ids=["rigid", "elastic"])
def test_errors_of_many_states_are_those_of_each_alone(compliance):
    model = paper_bearing(**TILTED)
    models = [
        replace(model, operation=replace(model.operation, radial_load=load)) for load in (900.0, 8e3, 3e4)
    ]
    (batch,) = solve_many(models).batches
    of_each = [life_errors(batch[case].cases, compliance)[0] for case in range(3)]
    assert life_errors(batch.states, compliance) == approx(of_each, rel=1e-9)


def test_an_error_that_is_not_found_is_no_number(monkeypatch):
    monkeypatch.setattr("quasidynamic.outcome.finer_life.LIMIT", 1)
    assert np.isnan(life_errors(paper_bearing(**TILTED).solve().cases, (None, soft(5)))).all()


def test_a_singular_system_is_without_an_answer_and_the_others_have_theirs():
    matrices, right = np.array([np.eye(2), np.diag([1.0, 0.0]), 2 * np.eye(2)]), np.ones((3, 2))
    found = _solved(matrices, right)
    assert found[[0, 2]] == approx(np.array([[1.0, 1.0], [0.5, 0.5]]))
    assert np.isnan(found[1]).all()
