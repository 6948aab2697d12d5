"""Balls under light loads, in clearance and at speed: from any start the same equilibrium is found."""

from dataclasses import replace

import numpy as np
import pytest

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.solve.balls.ring_in_elastic_grooves import (
    Places,
    _last,
    _newton,
    as_solution,
    solve_elastic,
)
from quasidynamic.solve.balls.ring_newton import newton
from quasidynamic.solve.balls.ring_on_balls import solve
from quasidynamic.solve.step_length import SolverOutcome
from tests.quasidynamic.test_elastic_grooves import random_groove
from tests.random_balls import drawn, drawn_deep_groove

CASES = [(family, seed) for family in (drawn, drawn_deep_groove) for seed in range(50)]
STARTS, SOME = 12, 2  # and how many of them must end
SAME = 1e-5  # of the largest load


def lightened(family, seed):
    """A random bearing under a load up to a thousand times lighter than it would be, with random numbers."""
    model, operation = family(seed)
    random = np.random.default_rng([seed, 7])
    share = 10 ** random.uniform(-3, 0)
    return model, replace(operation, load=tuple(share * force for force in operation.load)), random


def moved(balance: AngularBalance, ring, random):
    """A ring displaced by up to a third of what lies between grooves and balls."""
    size = min(balance.bearing.inner_reach, balance.bearing.outer_reach) * 10 ** random.uniform(-3, -0.5)
    return ring + np.where(balance.held, 0.0, size * random.normal(size=ring.shape)), size


def centres(balance: AngularBalance, grooves, number, random):
    """Balls between both grooves, at the bottom of the outer ones, or anywhere on them."""
    if number % 3 == 0:
        return balance.places.resting(grooves)
    at = np.zeros(grooves.shape) if number % 3 == 1 else random.uniform(-1.2, 1.2, grooves.shape)
    return balance.bearing.outer_reach * (np.sin(at) + 1j * np.cos(at))


def require_same(found, known):
    """Every start that leads to an equilibrium leads to the known one."""
    if len(found) < SOME:
        pytest.skip("Newton's method alone ends from too few starts to compare")
    assert np.abs(found - known).max() <= SAME * known.max()


@pytest.mark.sampled(25)
@pytest.mark.parametrize(("family", "seed"), CASES)
@np.errstate(all="ignore")
def test_every_start_between_rigid_rings_leads_to_the_same_loads(family, seed):
    model, operation, random = lightened(family, seed)
    balance = model.equations([operation])
    known, loads = solve(balance), []
    if known.outcomes[0] is not SolverOutcome.CONVERGED:
        pytest.skip("nothing holds this ring")
    for number in range(STARTS):
        ring, _ = moved(balance, known.ring, random)
        end = newton(balance, ring, centres(balance, balance.grooves(ring), number, random))
        if end.outcomes[0] is SolverOutcome.CONVERGED:
            loads.append(end.forces(balance)[0].contacts.loads)
    require_same(np.array(loads), known.forces(balance)[0].contacts.loads)


@pytest.mark.sampled(25)
@pytest.mark.parametrize(("family", "seed"), CASES)
@np.errstate(all="ignore")
def test_every_start_between_elastic_rings_leads_to_the_same_loads(family, seed):
    model, operation, random = lightened(family, seed)
    softness = 0.02 * 10 ** random.uniform(-2, 0) * model.bearing.outer_reach
    softness /= max(np.abs(operation.load).max(), 1.0)
    pair = ElasticGrooves(*(random_groove(seed + k, model.bearing.balls, softness) for k in (0, 100)))
    balance = model.equations([operation])
    known, loads = solve_elastic(balance, pair), []
    if known.rings.outcomes[0] is not SolverOutcome.CONVERGED:
        pytest.skip("nothing holds this ring")
    for number in range(STARTS):
        ring, size = moved(balance, known.rings.ring, random)
        vectors = random.normal(size=(*known.moved.shape[:-1], 2)).view(complex)[..., 0]
        shapes = random.uniform(0, 2) * known.places.grooves + size / 2 * vectors
        at = balance.grooves(ring) + shapes[:, 0] - shapes[:, 1]
        start = Places(ring, shapes, np.zeros_like(shapes), centres(balance, at, number, random))
        state, (outcome,) = _last(_newton(balance, pair, start))
        if outcome is SolverOutcome.CONVERGED:
            end = as_solution(balance, state, [outcome]).rings
            loads.append(end.forces(balance)[0].contacts.loads)
    require_same(np.array(loads), known.rings.forces(balance)[0].contacts.loads)
