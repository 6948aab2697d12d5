"""Residuals and derivatives that stay known after a solve of many are those evaluated anew."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic import solve_many
from quasidynamic.solve.rollers.strategy import NotAlike, overlaid
from tests.bearings import RPM, paper_bearing


def leaves(part, path=""):
    """Arrays of nested named tuples, with where they stand."""
    if not isinstance(part, tuple):
        if part is not None:
            yield path, np.asarray(part)
        return
    for name, inside in zip(part._fields, part, strict=True):
        yield from leaves(inside, f"{path}.{name}")


def test_a_batch_knows_its_last_residuals_and_derivatives():
    """Cases that leave Newton's method at different iterates."""
    usual = {"load": 9000.0, "speed": 12_000 * RPM, "clearance": 40e-6, "oil_fraction": 0.2}
    bearings = [
        paper_bearing(**usual | {name: value * factor})
        for name, value in usual.items() for factor in (0.3, 0.7, 3.0)
    ]  # fmt: skip
    known = 0
    for batch in solve_many(bearings).batches:
        states = batch.states
        if "system" not in states.__dict__:
            continue
        known += len(batch)
        anew = states.balance.evaluate(states.scaled)
        for (path, kept), (_, fresh) in zip(leaves(states.system), leaves(anew), strict=True):
            kept, fresh = np.broadcast_arrays(kept, fresh)
            assert kept == approx(fresh, rel=1e-9, abs=max(1e-14, 1e-9 * np.abs(fresh).max())), path
    assert known > len(bearings) / 2


def test_arrays_that_only_one_of_them_has_by_case_are_refused():
    with pytest.raises(NotAlike):
        overlaid(np.zeros((2, 3)), [(np.array([1]), np.zeros(3))])
    with pytest.raises(NotAlike):
        overlaid(np.zeros((2, 3)), [(np.array([1]), np.zeros((1, 2)))])
