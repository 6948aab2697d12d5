"""The analytic Jacobian is the derivative of the residual."""

from dataclasses import replace

import numpy as np
import pytest

from quasidynamic.start import static_start
from tests.bearings import paper_bearing

CASES = {
    "regression, rigid": ({}, False),
    "eyring, rigid": ({"traction": "eyring"}, False),
    "eyring, below its limit": ({"traction": "eyring", "limiting_ratio": 0.4, "eyring_stress": 5e6}, False),
    "tilt free, yielding": ({"moment": 20.0, "shapes": 4}, True),
    "yielding": ({"shapes": 3}, True),
    "backwards, inner guided": (
        {"speed": -2000.0, "cage": {"guidance": "inner", "land_diameter": 65.4e-3}},
        False,
    ),
}


@pytest.mark.parametrize(("changes", "yielding"), CASES.values(), ids=CASES.keys())
def test_jacobian_against_central_differences(changes, yielding):
    rng = np.random.default_rng(20161214)
    model = paper_bearing(**changes)
    balance = model.balance
    if yielding:
        size = model.bearing.rollers * model.shapes
        root = rng.normal(size=(size, size)) * 3e-6
        balance = replace(balance, compliance=(root @ root.T, 2 * root @ root.T))
    unknowns, film = static_start(balance)
    unknowns = unknowns * (1 + 0.01 * rng.normal(size=balance.size))
    unknowns[balance.displacements] += 0.3 * rng.normal(size=len(balance.displacements))
    jacobian = balance.evaluate(unknowns, film).jacobian
    # Speeds are scaled by their nominal value, displacements by a micrometre.
    steps = np.full(balance.size, 1e-8)
    steps[balance.displacements] = 1e-5
    columns = []
    for i, step in enumerate(steps):
        change = np.zeros(balance.size)
        change[i] = step
        ahead, behind = (balance.residual(unknowns + s * change, film)[0] for s in (1, -1))
        columns.append((ahead - behind) / (2 * step))
    error = np.abs(np.array(columns).T - jacobian)
    assert (error / np.abs(jacobian).max(axis=1, keepdims=True)).max() < 1e-6
