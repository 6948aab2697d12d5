"""Production and the one-page model are the same bearing."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic import RollerRow
from quasidynamic.parts.raceway_waves import RacewayWaves
from tests.bearings import paper_bearing
from tests.reference.plain_bearing import PAPER, evaluate

HALF = 2.5e-3  # [m] of the roller length

CASES = {
    "clearance": {},
    "preload": {"clearance": -20e-6},
    "Eyring film": {"traction": "eyring"},
    "Eyring film, preload": {"traction": "eyring", "clearance": -20e-6},
    "tilt held": {"misalignment": 1e-3},
    "tilt held, load between the axes": {"misalignment": -8e-4, "load_direction": 0.7},
    "free tilt under a moment": {"moment": 20.0, "load_direction": 2.0},
    "two waves outside": {
        "outer_waves": RacewayWaves(numbers=(2,), amplitudes=(10e-6,), crests=(0.0,)),
    },
    "unlike rollers": {"roller_deviations": tuple(1e-6 * (n % 5 - 2) for n in range(30))},
    "waves of both raceways, tilt held": {
        "inner_waves": RacewayWaves(numbers=(3,), amplitudes=(4e-6,), crests=(0.3,)),
        "outer_waves": RacewayWaves(numbers=(2, 7), amplitudes=(-10e-6, 2e-6), crests=(0.1, -0.4)),
        "misalignment": 1e-3,
    },
    "two rows": {"rows": (RollerRow(axial=-4e-3), RollerRow(axial=4e-3)), "load": 40e3},
    "two unlike rows, free tilt under a moment across the load": {
        "rows": (RollerRow(axial=-5e-3), RollerRow(axial=4e-3, clearance=5e-6, azimuth=0.1)),
        "load": 30e3,
        "moment": 90.0,
        "tilt_direction": 1.4,
        "load_direction": 2.0,
    },
    "three rows, tilt held": {
        "rows": tuple(RollerRow(axial=x, clearance=1e-3 * abs(x)) for x in (-8e-3, 0.0, 8e-3)),
        "load": 50e3,
        "misalignment": 5e-4,
    },
}

OUTPUTS = {  # by the name in the plain model: from production, size that rounding is measured by
    "load": (lambda state: state.loads, 1.0),
    "moment": (lambda state: state.forces[..., 1] * HALF, HALF),
    "traction": (lambda state: state.traction, 1.0),
    "rolling": (lambda state: state.rolling_shear, 1.0),
    "sliding": (lambda state: state.sliding, 1.0),
    "entrainment": (lambda state: state.entrainment, 1.0),
    "film": (lambda state: state.film, 1e-7),
    "drag": (lambda state: np.full(state.loads.shape[1], state.rollers.drag[0, 0]), 1.0),
    "cage_force": (lambda state: state.cage_force, 1.0),
    "pocket_friction": (
        lambda state: np.array([state.rollers.pocket[1, 0], state.rollers.pocket_brake[0]]),
        1.0,
    ),
    "inertia": (lambda state: state.transport, 20.0),  # smoothed where the cage turns back: 1e-8 N m here
    "ring_moment": (lambda state: state.ring_moment, 1.0),
    "land_torque": (lambda state: state.land_torque, 1.0),
    "driving_torque": (lambda state: state.driving_torque, 1.0),
    "outer_torque": (lambda state: state.outer_torque, 1.0),
}


def plain(state, **changes):
    oil = state.balance.roller.lubrication.oil
    numbers = {
        "eta": oil.viscosity, "alpha": oil.pressure_viscosity, "beta": oil.temperature_viscosity,
        "k": oil.conductivity, "rho": oil.density, "T": oil.temperature,
    }  # fmt: skip
    changes["direction"] = changes.pop("load_direction", 0.0)
    rows = changes.pop("rows", (RollerRow(),))
    changes["rows"] = [(row.axial, row.clearance, row.azimuth) for row in rows]
    waves = [changes.pop(name, None) for name in ("inner_waves", "outer_waves")]
    changes["waves"] = [
        wave
        for form in waves
        if form
        for wave in zip(form.amplitudes, form.numbers, form.crests, strict=True)
    ]
    unknowns = state.unknowns
    return evaluate(
        PAPER | changes,
        numbers,
        *unknowns.ring[:2, 0, 0],
        unknowns.ring[2:, 0, 0],
        state.cage_speed,
        unknowns.approach[0],
        unknowns.tilt[0] / HALF,
        state.roller_speed,
        state.film,
    )


@pytest.fixture(scope="module", params=CASES.values(), ids=CASES.keys())
def solved(request):
    state = paper_bearing(**request.param).solve()
    return request.param, state, plain(state, **request.param)


def test_equilibrium_of_production_balances_the_plain_model(solved):
    changes, state, model = solved
    assert model["ring"] == approx((0.0, 0.0), abs=1e-4)  # [N] of 19 621
    assert model["cage"] == approx(0.0, abs=1e-6)  # [N m]
    assert np.abs(model["radial"]).max() < 1e-5  # [N]
    assert np.abs(model["tilting"]).max() < 1e-8  # [N m]
    assert np.abs(model["spinning"]).max() < 2e-8  # [N m]
    if "moment" in changes:
        direction = 2.0 + changes.get("tilt_direction", 0.0)
        along = changes["moment"] * np.array([np.cos(direction), np.sin(direction)])
        assert model["ring_moment"] == approx(along, abs=1e-6)
    elif "misalignment" in changes:
        direction = changes.get("load_direction", 0.0)
        slopes = changes["misalignment"] * np.array([np.cos(direction), np.sin(direction)])
        assert state.ring_tilt == approx(slopes, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("name", OUTPUTS)
def test_production_and_plain_model_give_the_same_output(solved, name):
    _, state, model = solved
    output, size = OUTPUTS[name]
    assert output(state) == approx(np.array(model[name]).T, rel=1e-8, abs=1e-9 * size)


def test_outputs_are_not_all_zero():
    """A moment, a traction or a force that vanished would agree with anything."""
    model = plain(paper_bearing(**(changes := CASES["tilt held"])).solve(), **changes)
    assert all(np.abs(model[name]).max() > 1e-4 * OUTPUTS[name][1] for name in OUTPUTS)
    assert set(model) - set(OUTPUTS) == {"ring", "cage", "radial", "tilting", "spinning"}


def test_plain_model_sees_a_state_that_is_not_in_equilibrium():
    """The check above can fail: a micrometre of ring displacement unbalances it by hundreds of newtons."""
    state = paper_bearing().solve()
    state.unknowns.ring[1] += 1e-6
    assert abs(plain(state)["ring"][1]) > 100.0
