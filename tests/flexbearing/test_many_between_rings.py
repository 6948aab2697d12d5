"""Random bearings between random rings: many operating points and clearances side by side as one by one."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from quasidynamic import SolverOutcome, solve_many, solve_many_elastic
from tests.random_coupled import design

SEED, VARIANTS = 0x77, 8


def variants(model, rng):
    """Loads and speeds from half to twice as large, clearances 10 um larger or smaller."""
    for _ in range(VARIANTS):
        load, speed = np.exp(rng.uniform(-0.7, 0.7, 2))
        operation = replace(
            model.operation,
            radial_load=float(load) * model.operation.radial_load,
            inner_speed=float(speed) * model.operation.inner_speed,
        )
        clearance = model.bearing.clearance + float(rng.uniform(-10e-6, 10e-6))
        yield replace(model, operation=operation, bearing=replace(model.bearing, clearance=clearance))


@pytest.mark.slow
@pytest.mark.parametrize("number", [1, 5, 10, 13])
def test_every_answer_is_that_of_a_run_alone(number):
    """A ring that is not linear keeps the tangent at the loads of the design."""
    chosen = design(SEED, number)
    case = read_case(chosen.case, chosen.settings)
    model = roller_bearing.bearing(case)
    rings = condensed_raceways(case, model.bearing.azimuths, Logged())
    linear = rings.linearised(model.solve().forces)
    models = list(variants(model, np.random.default_rng(number)))
    starts = solve_many(models)
    many = solve_many_elastic(models, linear.compliance, starts, linear.initial_deviation)
    for one, start, state in zip(models, starts, many, strict=True):
        *_, alone = one.iterate(linear.compliance, start, linear.initial_deviation)
        assert state.status is alone.status is SolverOutcome.CONVERGED
        assert state.loads == approx(alone.loads, rel=0, abs=1e-9 * alone.loads.max())
        assert state.cage_slip == approx(alone.cage_slip, rel=0, abs=1e-9)
        assert state.life == approx(alone.life, rel=1e-9)
