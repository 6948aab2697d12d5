"""Production and the one-page model are the same bearing."""

import numpy as np
import pytest
from pytest import approx

from tests.bearings import paper_bearing
from tests.reference.plain_bearing import PAPER, unbalanced


def plain(state, **changes):
    oil = state.balance.roller.lubrication.oil
    numbers = {
        "eta": oil.viscosity, "alpha": oil.pressure_viscosity, "beta": oil.temperature_viscosity,
        "k": oil.conductivity, "rho": oil.density, "T": oil.temperature,
    }  # fmt: skip
    unknowns = state.unknowns
    return unbalanced(
        PAPER | changes,
        numbers,
        *unknowns.ring[:2, 0, 0],
        state.cage_speed,
        unknowns.approach[0],
        unknowns.tilt[0] / 2.5e-3,
        state.roller_speed,
        state.film,
    )


@pytest.mark.parametrize("traction", ["4109", "eyring"])
@pytest.mark.parametrize("clearance", [75.5e-6, -20e-6], ids=["clearance", "preload"])
def test_equilibrium_of_production_balances_the_plain_model(traction, clearance):
    state = paper_bearing(traction=traction, clearance=clearance).solve()
    ring, cage, rollers, films = plain(state, traction=traction, clearance=clearance)
    assert ring == approx((0.0, 0.0), abs=1e-4)  # [N] of 19 621
    assert cage == approx(0.0, abs=1e-6)  # [N m]
    assert np.abs([r[0] for r in rollers]).max() < 1e-5  # [N]
    assert np.abs([r[2] for r in rollers]).max() < 1e-8  # [N m]
    assert np.array(films).T == approx(state.film, rel=1e-9)


def test_plain_model_sees_a_state_that_is_not_in_equilibrium():
    """The check above can fail: a micrometre of ring displacement unbalances it by hundreds of newtons."""
    state = paper_bearing().solve()
    state.unknowns.ring[1] += 1e-6
    ring, *_ = plain(state)
    assert abs(ring[1]) > 100.0
