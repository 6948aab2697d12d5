"""A ring with a groove that its housing holds with clearance, in other ways than by the joint."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx
from scipy.linalg import cholesky, solve_triangular
from scipy.optimize import nnls

from fem import Elastic, Foundation, Housing, LineForce, PlanetGear, RigidSeat
from fem.errors import NotSolved
from fem.joint.fitted_ring import FitGrid, HousedRing, condense_fitted
from fem.joint.loaded_fit import loaded
from fem.joint.preloaded_fit import BELOW, Fit, fitted, preloaded
from fem.section.planet_rim import PlanetRim
from tests.fem.test_grooves_on_supports import (
    ANGLES,
    BALLS,
    GROOVE,
    OUTSIDE,
    condensed,
    resolved,
    ring,
)
from tests.fem.test_parts import STEEL

SMALL = FitGrid(bore_points=4, harmonics=24)
COUNT = len(BALLS) * len(ANGLES)


def housed(elastic):
    return HousedRing(seat=ring(Housing(thickness=10e-3, width=19e-3, elastic=elastic, support=RigidSeat())))


def loose(clearance):
    return Fit(interference=-clearance, friction=0.0)


@pytest.fixture(scope="module")
def bodies():
    return condense_fitted(housed(STEEL), resolved(), SMALL)


def balls(total, away=0.3):
    """Balls that press outwards on one side, and more on the stations towards +x."""
    at = np.maximum(np.cos(BALLS - away) - 0.3, 0.0) ** 1.5
    shares = np.array([0.1, 0.6, 0.3])
    return total / at.sum() * at[:, None] * shares


def around(waves, to, of):
    """From answers of harmonics per force per radian those to forces at azimuths, as a matrix."""
    n = np.arange(len(waves))
    turns = np.where(n > 0, 2, 1) * np.cos((to[:, None] - of)[..., None] * n) / (2 * np.pi)
    return np.einsum("pqn,nij->piqj", turns, waves).reshape(len(to) * waves.shape[1], -1)


def motions(reading, azimuths):
    towards = np.stack([np.sin(azimuths), np.cos(azimuths)], axis=-1)
    return (reading[None, :, :, None] * towards[:, None, None, :]).reshape(-1, 4)


def least_energy(compliance, free, rigid, push):
    """Forces p >= 0 with the least complementary energy of all that R^T p = push, by non-negative squares."""
    size = np.linalg.norm(rigid, axis=0)
    balance, push, stiff = rigid / size, push / size, np.trace(compliance) / len(compliance)
    root = cholesky(compliance + stiff * balance @ balance.T, lower=True)
    weight, missing = 1e3 * np.sqrt(stiff), np.zeros(4)
    goal = solve_triangular(root, stiff * balance @ push - free, lower=True)
    for _ in range(9):
        forces = nnls(
            np.vstack([root.T, weight * balance.T]), np.concatenate([goal, weight * (push + missing)])
        )[0]
        missing += push - balance.T @ forces
    assert balance.T @ forces == approx(push, rel=0, abs=1e-9 * np.abs(push).max())
    return forces


@pytest.mark.parametrize(("clearance", "total"), [(20e-6, 10e3), (20e-6, 100.0), (-2e-6, 10e3)])
def test_forces_in_a_fit_have_the_least_energy(bodies, clearance, total):
    """The same condensed bodies by compliance instead of stiffness, as one quadratic program."""
    fit, forces = preloaded(bodies, loose(clearance)), balls(total)
    found = loaded(fit, BALLS, forces)
    body, mate, L = bodies.ring, bodies.mate, 3 * bodies.ring.points.x.size
    azimuths, seat = found.interface.azimuths, slice(0, L, 3)
    fade = fit.closed.fade[: len(body.compliance)]
    yielding = around((body.compliance + np.pad(mate.compliance, ((0, 0), (0, 3), (0, 3))))[:, seat, seat],
                      azimuths, azimuths)  # fmt: skip
    through = around(body.compliance[:, seat, L:] * fade[:, None], azimuths, BALLS)
    of_seat, of_balls = motions(body.motions[1, seat], azimuths), motions(body.motions[1, L:], BALLS)
    free = clearance / 2 + through @ forces.ravel()
    pushes = least_energy(yielding, free, of_seat, -of_balls.T @ forces.ravel())
    pressed = found.contact.forces[..., 0].ravel() * 2 * np.pi / azimuths.size
    assert pressed == approx(pushes, rel=0, abs=1e-7 * pushes.max())
    place = np.linalg.lstsq(of_seat[pushes > 0], -(free + yielding @ pushes)[pushes > 0])[0]
    gap = free + yielding @ pushes + of_seat @ place
    assert found.gap.ravel() == approx(gap, rel=0, abs=1e-7 * np.abs(gap).max())
    beyond = replace(
        fit.closed,
        response=fit.closed.response * (np.arange(len(fit.closed.fade)) >= len(fade))[:, None, None],
    )
    own = around(body.compliance[:, L:, L:] * fade[:, :, None] * fade[:, None], BALLS, BALLS)
    own += beyond.absolute(BALLS).reshape(COUNT, COUNT)
    unloaded = around(body.compliance[:, seat, L:] * fade[:, None], azimuths, BALLS).T
    preload = unloaded @ np.tile(fit.force, azimuths.size) * 2 * np.pi / azimuths.size
    moved = unloaded @ pushes - preload + own @ forces.ravel() + of_balls @ place
    assert found.deviation.ravel() == approx(moved, rel=0, abs=1e-6 * np.abs(moved).max())


def test_pressure_balances_the_balls(bodies):
    """Across the axis, and in moments about it: along it the ring rests evenly on its groove."""
    reading = bodies.ring.motions[1, -3:]
    # shoulders cut the outer patches: 1.3 % of their moment
    assert reading[:, 0] == approx(np.cos(ANGLES), rel=3e-3)
    assert reading[:, 1] == approx(-np.sin(ANGLES) * GROOVE.centre_radius, rel=0.015, abs=1e-12)
    for clearance in (-20e-6, 0.0, 5e-6, 200e-6):
        for total in (30.0, 20e3):
            forces = balls(total)
            found = loaded(preloaded(bodies, loose(clearance)), BALLS, forces)
            inward = found.contact.forces[..., 0] * 2 * np.pi / found.interface.azimuths.size
            at, turn = np.exp(1j * found.interface.azimuths), np.exp(1j * BALLS)
            assert inward.sum(axis=1) @ at == approx(forces @ reading[:, 0] @ turn, rel=1e-9)
            moment = inward @ found.interface.points.x @ at
            assert moment == approx(forces @ reading[:, 1] @ turn, rel=0, abs=1e-9 * total * OUTSIDE)


def test_a_turned_and_a_mirrored_load_turn_and_mirror_the_answer(bodies):
    """By two azimuths of the grid of the fit; mirrored along the axis, too."""
    fit, forces = preloaded(bodies, loose(15e-6)), balls(5e3)
    here = loaded(fit, BALLS, forces)
    pitch = 2 * np.pi * 2 / here.interface.azimuths.size
    assert loaded(fit, BALLS + pitch, forces).deviation == approx(here.deviation, rel=0, abs=1e-15)
    assert loaded(fit, -BALLS, forces).deviation == approx(here.deviation, rel=0, abs=1e-15)
    flipped = loaded(fit, BALLS, forces[:, ::-1]).deviation[:, ::-1]
    assert flipped == approx(here.deviation, rel=0, abs=1e-6 * np.abs(here.deviation).max())


def test_the_tangent_is_the_slope(bodies):
    fit, forces = preloaded(bodies, loose(15e-6)), balls(5e3)
    found, more = loaded(fit, BALLS, forces), 1e-4 * balls(5e3, away=1.0)
    above, below = (loaded(fit, BALLS, forces + sign * more).deviation for sign in (1, -1))
    slope = np.tensordot(found.tangent.absolute, more, 2)
    assert (above - below) / 2 == approx(slope, rel=0, abs=1e-4 * np.abs(slope).max())
    matrix = found.tangent.absolute.reshape(COUNT, COUNT)
    assert matrix == approx(matrix.T, rel=0, abs=1e-9 * np.abs(matrix).max())
    assert not found.tangent.translation.any()


def test_a_rigid_bore_that_is_filled_is_a_foundation():
    """Springs that only hold radially, so stiff that they do not yield: without contact."""
    rigid = Elastic(youngs_modulus=1e17, poisson_ratio=0.3)
    fit = preloaded(condense_fitted(housed(rigid), resolved(), SMALL), loose(0.0))
    springs = condensed(Foundation(axial=0.0, radial=1e18, tangential=0.0))
    exact = springs.response[: SMALL.harmonics + 1]
    found = fit.closed.response[: SMALL.harmonics + 1]
    assert found == approx(exact, rel=0, abs=2e-3 * np.abs(exact).max())


def test_a_ring_in_a_very_wide_bore_rests_on_one_line(bodies):
    """The rim of a planet gear under the same balls and one force; at any place."""
    forces = balls(200.0, away=BALLS[2]) * [0, 1, 0]
    push = forces.sum(axis=1) @ np.exp(1j * BALLS)
    foot = LineForce(azimuth=float(np.angle(push)), radial=-float(np.abs(push)), tangential=0.0)
    rim = PlanetRim(condensed(PlanetGear(forces=())).ring, PlanetGear(forces=(foot,))).at(BALLS)
    exact = rim.initial_deviation + np.tensordot(rim.absolute, forces, 2)
    found = loaded(preloaded(bodies, loose(5e-3)), BALLS, forces)
    rigid = motions(bodies.ring.motions[1, -3:], BALLS)
    shapes = [
        each.ravel() - rigid @ np.linalg.lstsq(rigid, each.ravel())[0] for each in (found.deviation, exact)
    ]
    assert found.touching_angle < np.radians(20)
    assert shapes[0] == approx(shapes[1], rel=0, abs=0.02 * np.ptp(shapes[1]))


def test_thrust_alone_does_not_hold_a_loose_ring(bodies):
    with pytest.raises(NotSolved, match="nothing holds the ring in its fit"):
        loaded(preloaded(bodies, loose(50e-6)), BALLS, np.tile([0.0, 10.0, 30.0], (9, 1)))


def test_a_thin_ring_has_the_harmonics_of_what_is_below_its_groove():
    below = 2e-3
    outside = GROOVE.bottom(1) + below
    part = housed(STEEL)
    seat = replace(part.seat, thickness=outside - part.seat.raceway_diameter / 2)
    ready = fitted(replace(part, seat=seat), resolved(), loose(0.0))
    assert ready.interface.azimuths.size // 2 == int(np.ceil(BELOW * outside / below))
