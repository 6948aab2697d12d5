"""Raceways that grow softer step by step, where one step to the soft ones fails."""

import numpy as np
import pytest

from quasidynamic.solve.rollers.load_continuation import Continuation
from quasidynamic.solve.rollers.stiffness_continuation import (
    MAX_EVALUATIONS,
    STIFFEST,
    from_stiffer_raceways,
    softened,
)
from tests.bearings import paper_bearing


@pytest.fixture(scope="module")
def balance():
    """A bearing whose outer raceway has some compliance and a given shape."""
    model = paper_bearing(axial_modes=2, slices=10)
    shape = 1e-6 * np.ones((2, 30, 2))
    *_, last = model.iterate((None, 1e-9 * np.eye(60).reshape(30, 2, 30, 2)), model.solve(), shape)
    return last.balance


def _of(balance):
    """Compliance of the outer raceway."""
    _, outer = balance.compliance
    assert outer is not None
    return outer


def test_softened_raceways_have_a_share_of_compliance_and_shape(balance):
    half = softened(balance, 0.5)
    assert half.compliance[0] is None
    np.testing.assert_allclose(_of(half), 0.5 * _of(balance), rtol=1e-15, atol=0)
    assert half.deviation is not None
    np.testing.assert_allclose(half.deviation, 0.5 * balance.deviation, rtol=1e-15, atol=0)


def test_steps_are_halved_until_they_succeed_and_the_last_is_at_the_whole_compliance(balance):
    factors = [STIFFEST]

    def solve(softer, start, thoroughly):
        factor = _of(softer).max() / _of(balance).max()
        if factor > 1.6 * factors[-1]:
            return Continuation(None, 1)
        factors.append(factor)
        return Continuation(start + 1.0, 1)

    reached = from_stiffer_raceways(balance, np.zeros((1, 3)), solve)
    assert factors[-1] == pytest.approx(1.0, rel=1e-12)
    assert reached.unknowns is not None
    assert reached.unknowns[0, 0] == len(factors) - 1
    assert reached.evaluations > len(factors) - 1


def test_every_way_is_tried_before_the_search_is_given_up(balance):
    tried = []

    def solve(softer, start, thoroughly):
        tried.append(thoroughly)
        return Continuation(None, 1)

    assert from_stiffer_raceways(balance, np.zeros((1, 3)), solve).unknowns is None
    assert tried[-1]
    assert not tried[0]
    assert len(tried) < 10


def test_the_search_has_a_budget(balance):
    def solve(softer, start, thoroughly):
        return Continuation(start if _of(softer).max() < 1e-12 else None, 500)

    assert from_stiffer_raceways(balance, np.zeros((1, 3)), solve).evaluations < MAX_EVALUATIONS + 500
