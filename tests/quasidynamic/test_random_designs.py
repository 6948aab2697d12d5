"""Identities on bearings that nobody would design: random numbers draw geometry, oil, loads and speed.

The designs are those of `benchmarks/random_designs.py`: 10 N to 100 kN, 100 to 100 000 rpm, clearance from
-50 to 300 um, four traction laws, any direction of the load, a third of them tilted by a moment. Each
imbalance is measured against the forces that cause it, as their rounding is all that may remain: torques
against all roller loads times the raceway radius, powers against all roller loads times the surface speeds.
"""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest
from hypothesis import assume, example, given, settings, strategies as st
from pytest import approx

from quasidynamic import NotSolved, SolverOutcome, solve_many
from quasidynamic.balance.rollers.roller import POCKET_STANDSTILL
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.static import static_loads
from tests.bearings import RPM
from tests.quasidynamic.test_identities import torque_on_rollers_and_cage
from tests.random_rollers import design, imbalance, pocket_rounding, row_design

SEEDS, INERTIA = st.integers(1, 9999), st.booleans()  # 0 takes seconds without the inertia of spins
FEW = settings(max_examples=12, deadline=None)
FEWER = settings(max_examples=8, deadline=None)
PRESSED = 300.0  # [N]
LIGHT = {0: "10 N, slip 0.72", 4: "810 N, slip 0.32", 99: "96 N, slip 0.87"}  # most rollers spin backwards


@lru_cache(maxsize=256)
def ended(seed, spin_inertia=True):
    """Model and its last state, however the solve ended."""
    model, _ = design(np.random.default_rng(seed))
    model = replace(model, spin_inertia=spin_inertia)
    return model, solve_many([model])[0]


def solved(seed, spin_inertia=True):
    """A design whose rollers are pressed on the inner ring: lighter ones may take seconds."""
    model, _ = design(np.random.default_rng(seed))
    assume(model.operation.radial_load > PRESSED or seed in LIGHT)
    model, state = ended(seed, spin_inertia)
    assume(state.status is SolverOutcome.CONVERGED)
    return model, state


def bearing_speeds(state):
    """Surface speeds of rolling (2, Z) [m/s], signed."""
    bearing, points = state.balance.roller.bearing, state.balance.points
    inner = (points.inner_speed[0, 0] - state.cage_speed) * bearing.inner_radius
    outer = (state.cage_speed - points.outer_speed[0, 0]) * bearing.outer_radius
    return (np.array([[inner], [outer]]) + state.roller_speed * bearing.roller.diameter / 2) / 2


@pytest.mark.slow
@FEWER
@given(SEEDS, INERTIA)
def test_every_design_ends_by_name(seed, spin_inertia):
    model, state = ended(seed, spin_inertia)
    assert isinstance(state.status, SolverOutcome)
    assert state.status is not SolverOutcome.RUNNING
    if state.status is SolverOutcome.CONVERGED:
        assert state.residual <= 1e-9 * max(1.0, state.loads.max() / model.operation.radial_load)
        assert np.isfinite(state.loads).all()
    else:
        failure = NotSolved(state.failure(), state.status)
        assert failure.outcome == state.status
        assert "evaluations" in str(failure)


@pytest.mark.slow
@FEW
@given(SEEDS, INERTIA)
@example(0, False)
@example(4, True)
@example(99, False)
def test_angular_momentum_is_kept(seed, spin_inertia):
    """The transport of spin is handed from roller to roller: around the bearing it adds up to nothing."""
    _, state = solved(seed, spin_inertia)
    torque, size = torque_on_rollers_and_cage(state)
    assert torque == approx(0.0, abs=1e-12 * size)


@FEWER
@given(SEEDS, INERTIA)
@example(4, True)
@example(99, False)
def test_power_put_in_is_the_work_of_all_forces(seed, spin_inertia):
    """Summed from reported forces and speeds, and as the reported losses; none of them drives."""
    model, state = solved(seed, spin_inertia)
    cage, r_w, spin = model.bearing.cage, model.bearing.roller.diameter / 2, state.roller_speed
    rolling, losses = bearing_speeds(state), state.losses
    still = POCKET_STANDSTILL * np.abs(state.balance.rolling_spin[0, 0])
    force = state.cage_force**2 / np.hypot(state.cage_force, pocket_rounding(model.bearing))
    friction = cage.pocket_friction * force * spin / np.hypot(spin, still)
    work = [
        (state.traction * state.sliding).sum(),
        2 * (state.rolling_shear * rolling).sum(),
        losses.drag,
        float(friction @ spin) * r_w,
        losses.land,
        losses.churning,
        losses.transport,
    ]
    scale = (state.loads * np.abs(rolling)).sum()
    assert sum(work) == approx(state.driving_power, rel=0, abs=1e-12 * scale)
    assert losses.total == approx(state.driving_power, rel=0, abs=1e-12 * scale)
    assert min(losses.sliding, losses.rolling, losses.drag, losses.pocket, losses.land, losses.churning) >= 0


@FEW
@given(SEEDS, INERTIA)
@example(0, True)
@example(4, True)
@example(99, False)
def test_rollers_ring_and_cage_are_in_balance(seed, spin_inertia):
    """Every balance summed again from what is reported, over the largest force."""
    _, state = solved(seed, spin_inertia)
    assert imbalance(state) < 1e-11
    pitch, rolling = state.balance.roller.bearing.pitch_diameter, state.balance.rolling_cage[0, 0]
    sliding, lag = state.sliding.sum(0), rolling - state.cage_speed
    assert sliding == approx(np.full(sliding.shape, pitch * lag), rel=0, abs=1e-12 * pitch * rolling)


@pytest.mark.slow
@FEWER
@given(SEEDS, INERTIA)
def test_rollers_shifted_by_one_pitch_share_the_load_alike(seed, spin_inertia):
    model, here = solved(seed, spin_inertia)
    step = 2 * np.pi / model.bearing.rollers
    bearing = replace(model.bearing, first_roller_azimuth=model.bearing.first_roller_azimuth + step)
    shifted = solve_many([replace(model, bearing=bearing)])[0]
    assume(shifted.status is SolverOutcome.CONVERGED)
    assert shifted.loads == approx(np.roll(here.loads, -1, axis=1), rel=0, abs=1e-11 * here.loads.max())


@FEWER
@given(SEEDS, INERTIA)
def test_linear_solve_inverts_the_differenced_jacobian(seed, spin_inertia):
    """Along one random direction; what its inverse misses is put back through the differences."""
    _, state = solved(seed, spin_inertia)
    assume(state.cage_slip > 1e-4)  # traction is too curved for differences where it changes side
    balance, here = state.balance, state.scaled[None]
    steps = np.full(balance.layout.size, 1e-9)
    steps[balance.layout.displacements] = 1e-6
    steps[balance.layout.field(-2)] = steps[balance.layout.field(-3)] = 1e-6

    def change(direction):
        ahead, behind = (balance.evaluate(here + sign * direction).residual[0] for sign in (1, -1))
        return (ahead - behind) / 2

    direction = steps * np.random.default_rng(seed).normal(size=balance.layout.size)
    right = change(direction)
    error = bordered_system.solve(balance, balance.evaluate(here), right[None, :, None])[0, :, 0] - direction
    size = np.abs(error / steps).max()
    assert size * np.abs(change(error / size)).max() < 1e-5 * np.abs(right).max()


@FEWER
@given(SEEDS)
def test_stiffness_is_the_slope_of_load_over_displacement(seed):
    model, state = solved(seed)
    load = model.operation.radial_load
    ahead, behind = (
        replace(model, operation=replace(model.operation, radial_load=load * (1 + part))).solve(state)
        for part in (1e-5, -1e-5)
    )
    direction = model.operation.load_direction
    along = np.array([np.sin(direction), np.cos(direction)])
    moved = float(along @ (ahead.ring_displacement - behind.ring_displacement))
    assert state.tangent.radial_stiffness * moved == approx(2e-5 * load, rel=1e-5)


@FEW
@given(SEEDS)
def test_slow_bearing_is_a_static_one(seed):
    """Hardly any film or centrifugal force, no weight: the loads of `static_loads`, tilted or not."""
    model, _ = design(np.random.default_rng(seed))
    operation = replace(model.operation, inner_speed=1e-4 * RPM, gravity=0.0)
    state = solve_many([replace(model, operation=operation)])[0]
    assume(state.status is SolverOutcome.CONVERGED)
    load, moment, direction = operation.radial_load, operation.moment, operation.load_direction
    found = static_loads(model.bearing, load, direction, moment, model.slices)
    size = 2e-4 * found.loads.max()  # 1.3e-4 is the most of 600 designs
    assert state.loads == approx(np.array([found.loads] * 2), rel=0, abs=size)


@pytest.mark.parametrize("seed", range(1, 13))
def test_two_rows_are_solved_and_in_balance(seed):
    """Alike or not, held or free to tilt, under a couple in any plane that may take the load off a row."""
    model, _ = row_design(np.random.default_rng(seed))
    state = model.solve()
    assert imbalance(state) < 1e-9
    if not model.operation.free_tilt:
        return
    applied = state.balance.points.moment_z[0, 0], state.balance.points.moment_y[0, 0]
    assert state.ring_moment == approx(applied, abs=1e-9 * np.abs(state.row_load).max())
