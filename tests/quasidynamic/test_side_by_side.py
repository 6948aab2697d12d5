"""Bearings solved side by side are those of one solve after the other."""

from dataclasses import replace

import numpy as np
from pytest import approx

from quasidynamic import solve_many
from tests.bearings import RPM, paper_bearing


def same_as_alone(models):
    """Each of the answers is that of a solve alone, to 1e-10 of its largest load, slips to 1e-10."""
    many = solve_many(models)
    assert len(many) == len(models)
    for model, state in zip(models, many, strict=True):
        alone = solve_many([model])[0]
        assert state.status is alone.status
        assert state.loads == approx(alone.loads, rel=0, abs=1e-10 * alone.loads.max())
        assert state.cage_slip == approx(alone.cage_slip, rel=0, abs=1e-10)


def test_clearances_and_directions_of_the_load():
    rng = np.random.default_rng(1)
    models = []
    for load in np.geomspace(30.0, 2e4, 7):
        model = paper_bearing(load=float(load), clearance=rng.uniform(-2e-5, 2e-4), load_direction=load)
        operation = replace(model.operation, inner_speed=rng.uniform(10, 38000) * RPM)
        models.append(replace(model, operation=operation))
    same_as_alone(models)


def test_moments_tilt_bearings_of_any_clearance():
    pairs = ((0.0, 1e-5), (2e-5, 5e-5), (-1e-5, 9e-5))
    same_as_alone([paper_bearing(clearance=c, load=s * 1e7, moment=s * 4e5) for c, s in pairs])
    same_as_alone([paper_bearing(clearance=c, load=0.0, moment=s * 4e5) for c, s in pairs])


def test_answers_come_in_the_order_of_the_bearings():
    """Those that are tilted, aligned, or have other numbers of rollers are not solved together."""
    models = [
        paper_bearing(load=load, rollers=rollers, misalignment=slope)
        for load, rollers, slope in ((1e3, 30, 0.0), (2e3, 28, 0.0), (3e3, 30, 1e-4), (4e3, 30, 0.0))
    ]
    many = solve_many(models)
    assert [len(batch) for batch in many.batches] == [2, 1, 1]
    assert [state.balance.points.load[0, 0] for state in many] == [1e3, 2e3, 3e3, 4e3]
    slips = many.in_order(lambda batch: batch.states.cage_slip)
    assert slips == approx([state.cage_slip for state in many], rel=1e-12)
