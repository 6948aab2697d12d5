"""Carter's rolling cylinders: limits in closed form, the half-space solver, slopes, slow bearings."""

from functools import partial
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from pytest import approx

from quasidynamic import SolverOutcome, solve_many
from quasidynamic.contact.half_space import CellGrid, ElasticPair
from quasidynamic.contact.line import half_width, peak_pressure
from quasidynamic.contact.rolling.kalker import kalker
from quasidynamic.contact.rolling.rolling_contact import RollingContacts
from quasidynamic.contact.traction import in_any_contact
from quasidynamic.contact.traction.asperity_friction import (
    Carter,
    RoundedCoulomb,
    creep_friction,
    full_slip_creep,
)
from quasidynamic.contact.traction.mixed import ZHOU_HOEPRICH, RoughContacts
from tests.bearings import RPM, eyring, paper_bearing
from tests.quasidynamic.test_identities import torque_on_rollers_and_cage
from tests.random_rollers import imbalance, slow_design

RADIUS, SHEAR, POISSON, FRICTION = 4e-3, 80e9, 0.28, 0.1
MODULUS = 2 * SHEAR / (1 - POISSON)  # E' of two bodies of one steel
LAW = Carter(radius=RADIUS, modulus=MODULUS, coefficient=FRICTION)


def on_steel(load, sliding, entrainment, share=1.0):
    return LAW(*map(np.array, (load, sliding, entrainment, share)))


def test_small_creep_has_the_stiffness_of_rolling_cylinders_that_stick():
    """pi G b/(2 (1 - nu)) per creep, Kalker (1990), whatever friction and share are."""
    width = half_width(2e5, RADIUS, MODULUS)
    for share in (1.0, 0.3):
        creep = 1e-6 * share * FRICTION * width / RADIUS
        stiffness = np.pi * SHEAR * width / (2 * (1 - POISSON))
        assert on_steel(2e5, 0.5 * creep, 0.5, share).force == approx(stiffness * creep, rel=1e-6)
        assert on_steel(2e5, 0.0, 0.5, share).by_sliding == approx(stiffness / 0.5, rel=1e-7)


@pytest.mark.parametrize("share", [1.0, 0.2])
def test_all_of_the_contact_slips_from_the_creep_of_johnson(share):
    """2 mu p0/E*, Johnson (1985), sec. 8.3."""
    creep = 2 * share * FRICTION * peak_pressure(2e5, RADIUS, MODULUS) / (MODULUS / 2)
    limit = share * FRICTION * 2e5
    assert on_steel(2e5, creep, 1.0, share).force == approx(limit, rel=1e-7)
    assert on_steel(2e5, -7 * creep, 1.0, share).force == approx(-limit, rel=1e-7)
    assert on_steel(2e5, 0.5 * creep, 1.0, share).force == approx(0.75 * limit, rel=1e-7)


def half_space_friction(ratio, length, cells):
    """Friction over its limit at a share of full slip's creep; length over half-width, cells (nx, ny)."""
    b, peak = (float(each(2e5, RADIUS, MODULUS)) for each in (half_width, peak_pressure))
    grid = CellGrid((2 * b / cells[0], length * b / cells[1]), cells)
    edges = np.linspace(-1, 1, cells[0] + 1)
    area = (edges * np.sqrt(1 - edges**2) + np.arcsin(edges)) / 2
    limit = FRICTION * peak * np.diff(area) * cells[0] / 2
    steel = ElasticPair(shear=1 / SHEAR, poisson=POISSON / SHEAR)
    contacts = RollingContacts((grid,), (steel,), np.repeat(limit[None, :, None], cells[1], axis=2))
    creep = np.zeros((1, 2, *cells))
    creep[0, 0] = ratio * 2 * FRICTION * peak * (1 - POISSON) / SHEAR
    rolled = kalker(contacts, creep)
    return -rolled.force[0, 0] / (contacts.limit.sum() * grid.cell_area)


@pytest.mark.parametrize("ratio", [-0.15, 0.3, 0.6, 0.9])
def test_rolling_cylinders_as_half_spaces(ratio):
    """A strip so long that it is a line contact, with stick and slip solved on 200 cells."""
    creep = ratio * FRICTION * half_width(2e5, RADIUS, MODULUS) / RADIUS
    expected = half_space_friction(ratio, 1000.0, (200, 1))
    assert on_steel(2e5, creep, 1.0).force / (FRICTION * 2e5) == approx(expected, rel=0.005)


def test_contacts_of_finite_length_have_more_friction_by_their_width_over_it():
    """About half of it at small creep, which Carter leaves out; by the same cells, whose error is alike."""
    long = half_space_friction(0.1, 1e4, (32, 1))
    for length in (10, 20, 40):
        excess = half_space_friction(0.1, float(length), (32, 2 * length)) / long - 1
        assert excess * length == approx(0.5, rel=0.05)


def test_friction_is_odd_and_rises_to_its_limit():
    creep = np.linspace(-2.0, 2.0, 401)
    ratio, friction = creep_friction(creep, np.array(1.0))
    assert friction == approx(-friction[::-1], rel=0, abs=1e-15)
    assert np.all(np.diff(friction) >= 0)
    assert np.abs(friction).max() == 1.0
    assert np.gradient(friction, creep)[1:-1] == approx(2 * (1 - np.abs(ratio))[1:-1], rel=0, abs=0.011)


@given(
    load=st.floats(3.0, 6.0).map(lambda n: 10.0**n),
    ratio=st.floats(0.01, 3.0),
    speed=st.floats(-5, 2).map(lambda n: 10.0**n),
    share=st.floats(1e-4, 1.0),
    sign=st.sampled_from([-1.0, 1.0]),
)
def test_every_derivative_is_the_slope_of_the_force(load, ratio, speed, share, sign):
    assume(abs(ratio - 1) > 0.01)
    floored = np.hypot(load, LAW.smallest_load * MODULUS * RADIUS)
    width = half_width(floored, RADIUS, MODULUS)
    sliding = sign * ratio * speed * full_slip_creep(np.array(share * FRICTION), width, RADIUS)
    point = np.array([load, sliding, speed, share])
    here = on_steel(*point)
    for index, size in enumerate(np.abs(point)):
        step = 1e-4 * size
        f = [on_steel(*(point + n * step * np.eye(4)[index])).force for n in (-2, -1, 1, 2)]
        slope = (f[0] - 8 * f[1] + 8 * f[2] - f[3]) / (12 * step)
        assert here[1 + index] == approx(slope, rel=1e-6, abs=1e-8 * FRICTION * share * load / size)


def test_no_load_no_asperities_and_no_slip_are_no_corner():
    for point in ((0.0, 1e-3, 0.1, 1.0), (1e5, 1e-3, 0.1, 0.0), (1e5, 0.0, 0.1, 0.0), (0.0, 0.0, 0.1, 0.0)):
        law = on_steel(*point)
        assert np.all(np.isfinite(law))
        assert law.force == 0.0


# -- slow bearings -----------------------------------------------------------------------------


CREEPING = partial(Carter, coefficient=0.1)


def slow(asperities: Any = CREEPING, **changes):
    """A light slow bearing whose surfaces touch."""
    rough = RoughContacts(
        fluid=lambda **contact: eyring(contact["oil"])(**contact),
        share=ZHOU_HOEPRICH,
        asperities=asperities,
        inner_roughness=0.3e-6,
        outer_roughness=0.3e-6,
    )
    settings = {"traction": rough, "load": 1000.0, "speed": 5 * RPM, "cage": {"guidance": "rollers"}}
    return paper_bearing(**{**settings, **changes}, spin_inertia=False)


def test_slow_bearing_with_creeping_rollers_is_in_balance():
    state = slow().solve()
    law: Any = state.balance.roller.raceways.traction
    assert law.share(state.film / 0.3e-6)[0].min() > 0.8
    losses = state.losses
    assert state.driving_power == approx(losses.total, rel=1e-9)
    assert min(losses.sliding, losses.rolling, losses.drag, losses.pocket, losses.land) >= 0
    torque, size = torque_on_rollers_and_cage(state)
    assert torque == approx(0.0, abs=1e-12 * size)


def test_loaded_rollers_creep_by_the_stiffness_of_their_contacts():
    """pi E' b/4 per creep: far from slip, and the film carries next to nothing at such sliding."""
    state = slow(load=5000.0).solve()
    raceways, roller = state.balance.roller.raceways, np.argmax(state.loads[0])
    radius, modulus = raceways.radius[:, 0], raceways.modulus[:, 0]
    width = half_width(state.slice_loads[:, roller], radius, modulus).mean(-1, keepdims=True)
    stiffness = np.pi * modulus * width / 4 * raceways.slices.length
    creep = (state.sliding / state.entrainment)[:, roller, None]
    assert np.abs(creep).max() < 1e-2 * 0.1 * (width / radius).min()
    assert state.traction[:, roller, None] == approx(stiffness * creep, rel=0.02)


def test_friction_rounded_over_a_speed_makes_slow_rollers_slip():
    rounded = partial(in_any_contact, RoundedCoulomb(coefficient=0.1, sign_speed=1e-3))
    slips = []
    for asperities in (rounded, CREEPING):
        state = slow(asperities).solve()
        slips.append(np.abs(state.roller_slip[state.loads[0] > 0.1 * state.loads[0].max()]).max())
    assert slips[0] > 50 * slips[1]


@pytest.mark.slow
def test_random_slow_bearings_are_solved():
    for seed in range(6):
        model, _ = slow_design(np.random.default_rng([1, seed]))
        (state,) = solve_many([model])
        assert state.status is SolverOutcome.CONVERGED
        assert imbalance(state) < 1e-9
