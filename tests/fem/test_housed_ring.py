"""An outer ring with clearance in its housing."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from fem import (
    Elastic,
    Foundation,
    Housing,
    ImpossiblePart,
    LineForce,
    LineSupports,
    MeshSize,
    OuterRing,
    PlanetGear,
    Resolution,
)
from fem.assembly.factorisation import NotSolved
from fem.joint.fitted_ring import FitGrid, HousedRing, condense_fitted
from fem.joint.loaded_fit import loaded
from fem.joint.preloaded_fit import Fit, fitted, preloaded
from fem.raceway.harmonics import TRUNCATED
from fem.section.planet_rim import PlanetRim
from tests.fem.condensed import by_harmonics
from tests.fem.test_parts import STEEL

L, M = 5e-3, 3
COARSE = MeshSize(order=3, size=8e-3, raceway_size=2e-3)
FAIR = MeshSize(order=4, size=8e-3, raceway_size=2e-3)
BAND = Resolution(length=L, axial_modes=M, mesh_size=FAIR)
SMALL = FitGrid(bore_points=5, harmonics=18)
RIGID = Elastic(youngs_modulus=1e17, poisson_ratio=0.28)
ROLLERS = 0.05 + 2 * np.pi * np.arange(24) / 24


def ring(support, **sizes):
    sizes = {"raceway_diameter": 75e-3, "thickness": 3.6e-3, "width": 10e-3, "elastic": STEEL} | sizes
    return OuterRing(**sizes, support=support)


def housed(elastic):
    return HousedRing(seat=ring(Housing(thickness=10e-3, width=12e-3, elastic=elastic)))


BORE = HousedRing(seat=ring(Housing(thickness=10e-3, width=10e-3, elastic=RIGID)))


@pytest.fixture(scope="module")
def bodies():
    return condense_fitted(housed(STEEL), replace(BAND, mesh_size=COARSE), SMALL)


def loose(clearance):
    return Fit(interference=-clearance, friction=0.0)


def loads(total, half=1.0, seed=0):
    """Rollers that press outwards on one side, with a bit of the other shapes."""
    F = np.zeros((ROLLERS.size, M))
    F[:, 0] = np.maximum(np.cos(ROLLERS) - np.cos(half), 0) ** 1.1
    F *= total / np.abs(F[:, 0] @ np.exp(1j * ROLLERS))
    F[:, 1:] = np.random.default_rng(seed).uniform(-0.2, 0.2, (ROLLERS.size, 2)) * F[:, :1]
    return F


@pytest.mark.slow
def test_ring_that_fills_its_bore_is_held_without_friction():
    """Springs that only hold radially, so stiff that they do not yield: another model, without contact.

    Beyond the harmonics of the fit the ring is on its own.
    """
    part = replace(BORE, seat=replace(BORE.seat, width=6e-3))
    fit = preloaded(condense_fitted(part, BAND, FitGrid(bore_points=6, harmonics=24)), loose(0.0))
    springs = Foundation(axial=0.0, radial=1e18, tangential=0.0)
    exact = by_harmonics(replace(part.seat, support=springs), L, M, FAIR)
    low = np.abs(exact.harmonics) <= 24
    found = fit.closed.response[low]
    assert found == approx(exact.response[low], rel=0, abs=3e-4 * np.abs(exact.response).max())


def test_contact_that_never_opens_is_linear(bodies):
    """A press fit under small loads answers as joined by pressure alone."""
    fit, F = preloaded(bodies, loose(-20e-6)), loads(100.0)
    found = loaded(fit, ROLLERS, F)
    assert found.opened == 0
    assert found.deviation == approx(np.tensordot(fit.closed.at(ROLLERS).absolute, F, 2), rel=1e-9, abs=1e-15)


@pytest.mark.slow
def test_ring_in_a_very_wide_bore_rests_on_one_line():
    """The rim of a planet gear under the same rollers and one force, at any place and of any tilt."""
    even = loads(200.0, half=1.2) * [1, 0, 0]
    push = even[:, 0] @ np.exp(1j * ROLLERS)
    foot = LineForce(azimuth=float(np.angle(push)), radial=-float(np.abs(push)), tangential=0.0)
    free = by_harmonics(ring(LineSupports(azimuths=(0.0, 2.0, 4.0))), L, M, FAIR).ring
    rim = PlanetRim(free, PlanetGear(forces=(foot,))).at(ROLLERS)
    exact = rim.initial_deviation + np.tensordot(rim.absolute, even, 2)
    bodies = condense_fitted(BORE, BAND, FitGrid(bore_points=4, harmonics=24))
    found = loaded(preloaded(bodies, loose(5e-3)), ROLLERS, even)
    shape = found.deviation[:, 0] - np.stack([np.sin(ROLLERS), np.cos(ROLLERS)], axis=1) @ found.translation
    assert found.touching_angle < np.radians(20)
    assert shape == approx(exact[:, 0], rel=0, abs=0.01 * np.abs(exact[:, 0]).max())


@pytest.mark.slow
def test_a_thin_ring_has_the_harmonics_that_its_bending_needs():
    """One of 2 % of its radius bends between the azimuths of the usual grid."""
    part = HousedRing(seat=replace(housed(STEEL).seat, thickness=0.75e-3))
    ready = fitted(part, replace(BAND, mesh_size=COARSE), loose(5e-6))
    assert ready.interface.azimuths.size > 2 * FitGrid().harmonics + 1
    assert ready.closed.truncation < TRUNCATED


def imbalance(found, forces):
    """Force along y, z and moment about them on the ring, over the sum of the roller forces."""
    interface = found.interface
    inward = found.contact.forces[..., 0] * 2 * np.pi / interface.azimuths.size
    turn, around = np.exp(1j * ROLLERS), np.exp(1j * interface.azimuths)
    force = forces[:, 0] @ turn - inward.sum(axis=1) @ around
    moment = L / 2 * forces[:, 1] @ turn - inward @ interface.points.x @ around
    size = np.abs(forces[:, 0]).sum()
    return abs(force) / size, abs(moment) / (size * L)


@settings(max_examples=10)
@given(st.just(0.0) | st.floats(1e-6, 2e-3), st.floats(100.0, 30e3), st.floats(0.3, 1.5), st.integers(0, 9))
def test_any_clearance_obeys_contact_in_balance(bodies, clearance, total, half, seed):
    forces = loads(total, half, seed)
    found = loaded(preloaded(bodies, loose(clearance)), ROLLERS, forces)
    p, gap = found.pressure, found.gap
    tiny, length = 1e-8 * p.max(), 1e-8 * np.abs(gap).max() + 1e-15
    assert p.min() >= -tiny
    assert gap.min() >= -length
    assert np.all((p <= tiny) | (gap <= length))
    assert imbalance(found, forces) == approx((0, 0), abs=1e-10)


def test_wider_bores_bend_the_ring_more(bodies):
    found = [loaded(preloaded(bodies, loose(c)), ROLLERS, loads(10e3)) for c in (0.0, 20e-6, 100e-6, 1e-3)]
    assert np.all(np.diff([f.touching_angle for f in found]) <= 0)
    work = [np.sum(f.deviation * loads(10e3)) for f in found]
    assert np.all(np.diff(work) > 0)
    assert np.all(np.diff([f.gap.max() for f in found]) > 0)


def test_loose_ring_without_a_resultant_has_no_place(bodies):
    balanced = np.zeros((ROLLERS.size, M))
    balanced[[0, 12], 0] = 1e3
    for forces in (0 * balanced, balanced):
        with pytest.raises(NotSolved, match="nothing holds"):
            loaded(preloaded(bodies, loose(10e-6)), ROLLERS, forces)


def test_hot_ring_fills_its_housing(bodies):
    """0.02 mm of clearance on 82.2 mm close at an expansion of 2.43e-4."""
    for expansion, presses in ((2.3e-4, False), (2.6e-4, True)):
        fit = preloaded(bodies, replace(loose(20e-6), thermal_strains=(expansion, 0.0)))
        assert fit.force.any() == presses


def test_housing_that_nothing_rigid_holds_is_refused():
    soft = Foundation(axial=1e9, radial=1e9, tangential=1e9)
    with pytest.raises(ImpossiblePart, match="ClampedFace or a RigidSeat"):
        HousedRing(seat=ring(Housing(thickness=10e-3, width=12e-3, elastic=STEEL, support=soft)))
    with pytest.raises(ImpossiblePart, match="Housing"):
        HousedRing(seat=ring(soft))
