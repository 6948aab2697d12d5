"""Grooves that give way: shares of stations, derivatives, and balance of balls between them."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves, extrapolated, shape_of
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.solve.balls import ring_in_elastic_grooves
from quasidynamic.solve.step_length import SolverOutcome
from tests.deep_groove import deep_groove
from tests.random_balls import drawn, unbalanced

ANGLES = np.radians([-45.0, -30.0, -15.0, 0.0, 15.0, 30.0, 45.0])


def random_groove(seed, balls, softness=1e-9):
    """A compliance of waves around the ring that move its section and, less, bend its arc."""
    draw = np.random.default_rng([seed, 7])
    azimuth = 2 * np.pi * np.arange(balls) / balls
    moves = np.stack([np.cos(ANGLES), np.sin(ANGLES)])  # radial, axial, and bent arcs
    bends = np.stack([np.ones_like(ANGLES), np.cos(2 * ANGLES), np.sin(2 * ANGLES)])
    matrix = np.zeros((balls, len(ANGLES)) * 2)
    for wave in range(balls // 2 + 1):
        around = np.cos(wave * (azimuth[:, None] - azimuth)) / (1 + wave**2)
        arc = draw.normal(size=(2, 2)) @ moves + 0.1 * draw.normal(size=(2, 3)) @ bends
        matrix += np.einsum("zy,kl->zkyl", around, arc.T @ arc)
    own = 0.1 * np.eye(balls)[:, None, :, None] * np.exp(-(np.subtract.outer(ANGLES, ANGLES)[:, None] ** 2))
    return ElasticGroove(ANGLES, softness * (matrix + own))


def rigid_motions(balls):
    """Displacements (Z, K, 3) of stations by motions of the groove along x, y, z."""
    azimuth = 2 * np.pi * np.arange(balls)[:, None] / balls
    outward = np.cos(ANGLES)
    along = np.broadcast_to(np.sin(ANGLES), (balls, len(ANGLES)))
    return np.stack([along, np.sin(azimuth) * outward, np.cos(azimuth) * outward], axis=-1)


def test_a_station_has_all_of_its_own_share():
    shares = random_groove(1, 3).shares(ANGLES[None])
    assert shares.share[0] == approx(np.eye(len(ANGLES)), abs=1e-10)


@pytest.mark.parametrize("angle", [-0.9, -0.3, 0.0, 0.11, 0.7])
def test_a_rigid_motion_of_the_groove_is_read_exactly(angle):
    balls = 5
    motions = rigid_motions(balls)
    vectors = random_groove(1, balls).shares(np.full((1, balls), angle)).by_vector[0]
    azimuth = 2 * np.pi * np.arange(balls) / balls
    radial = np.stack([0 * azimuth, np.sin(azimuth), np.cos(azimuth)], axis=-1)
    read = np.einsum("zka,zkm->zam", vectors, motions)
    assert read[:, 0] == approx(np.tile([1.0, 0.0, 0.0], (balls, 1)), abs=1e-12)
    assert read[:, 1] == approx(radial, abs=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_derivatives_are_those_of_differences(seed):
    random, balls, step = np.random.default_rng(seed), 4, 1e-6
    groove, angles = random_groove(seed, balls, 1.0), random.uniform(-0.7, 0.7, balls)
    force, more = (random.normal(size=balls) + 1j * random.normal(size=balls) for _ in range(2))
    turn, idle = random.normal(size=balls), 1
    force[idle] = more[idle] = 0.0
    ahead, behind = (
        shape_of(groove, angles + side * step * turn, force + side * step * more).moved for side in (1, -1)
    )
    shape = shape_of(groove, angles, force)
    assert list(shape.loaded) == [0, 2, 3]
    change = np.stack([more.real, more.imag, turn], axis=-1)[shape.loaded]
    found = np.einsum("yaxc,ya->xc", shape.by_contact, change) + shape.by_reading * turn[:, None]
    assert found == approx((ahead - behind) / (2 * step), rel=1e-5, abs=1e-5)


def test_beyond_its_stations_a_groove_is_as_stiff_as_there():
    groove, force = random_groove(2, 3), np.full(3, 1000.0 + 500j)
    _, last = extrapolated(ANGLES)
    at, beyond = (shape_of(groove, np.full(3, angle), force) for angle in (last, last + 0.2))
    assert beyond.moved == approx(at.moved, rel=1e-12)
    assert not beyond.by_contact[:, 2].any()
    assert not beyond.by_reading.any()


@pytest.mark.parametrize("count", [3, 5, 7, 9, 15])
def test_many_stations_are_not_extrapolated_as_far_as_few(count):
    """Shares of 9 stations would be 19 as far out as those of 3 are 1.3; a thin ring found no balance."""
    angles = np.radians(43 * np.sin(np.pi / 2 * np.linspace(-1, 1, count)))
    groove = ElasticGroove(angles, np.zeros((1, count, 1, count)))
    assert np.abs(groove.shares(np.array([[1.4]])).share).max() < 4


@pytest.mark.parametrize(
    ("angles", "shape", "match"),
    [
        (ANGLES[:4], (3, 4, 3, 4), "odd"),
        (ANGLES[:5], (3, 7, 3, 7), "does not fit"),
        (ANGLES, (3, 7, 3, 7), "symmetric"),
    ],
)
def test_a_compliance_that_is_none_is_refused(angles, shape, match):
    with pytest.raises(ImpossiblePart, match=match):
        ElasticGroove(angles, np.arange(np.prod(shape), dtype=float).reshape(shape))


@pytest.mark.parametrize("seed", range(16))
def test_random_bearings_are_in_balance_between_random_grooves(seed):
    """Forces are added up anew, and shapes are those of the forces that were found."""
    model, operation = drawn(seed)
    balls, reach = model.bearing.balls, model.bearing.outer_reach
    load = max(np.abs(operation.load).max(), 1.0)
    inner, outer = (random_groove(seed + k, balls, 0.02 * reach / load) for k in (0, 100))
    state = model.solve(operation, ElasticGrooves(inner, outer))
    assert unbalanced(state) < 1e-10
    for race, groove in enumerate((inner, outer)):
        normals = np.exp(-1j * state.contact_angles[race])
        force = (1j * state.loads[race] + state.tractions[race]) * normals
        moved = shape_of(groove, state.contact_angles[race], (-force, force)[race]).moved
        largest = np.abs(state.groove_displacement).max()
        assert state.groove_displacement[race] == approx(moved, abs=1e-6 * largest)


def test_a_search_that_ends_between_soft_grooves_does_not_show_that_there_is_no_balance(monkeypatch):
    """Without a limit point; nor does an overflow between them come from a wrong unit."""
    model, operation = drawn(5)
    load, balls = np.abs(operation.load).max(), model.bearing.balls
    grooves = [random_groove(5 + k, balls, 0.02 * model.bearing.outer_reach / load) for k in (0, 100)]
    solved = ring_in_elastic_grooves._newton

    def stiff_only(balance, softened, start):
        state, outcomes = yield from solved(balance, softened, start)
        too_soft = np.abs(softened.inner.compliance).max() > 0.4 * np.abs(grooves[0].compliance).max()
        return state, [SolverOutcome.NOT_FINITE] if too_soft else outcomes

    monkeypatch.setattr(ring_in_elastic_grooves, "_newton", stiff_only)
    with pytest.raises(NotSolved) as caught:
        model.solve(operation, ElasticGrooves(*grooves))
    assert caught.value.outcome is SolverOutcome.STALLED


def test_a_ring_that_nothing_holds_between_elastic_grooves_is_refused_by_name():
    bearing = deep_groove(60e-6, azimuth=np.pi / 9)
    grooves = [random_groove(k, bearing.balls, 1e-10) for k in (1, 2)]
    with pytest.raises(NotSolved, match="nothing holds the inner ring along x, about y") as caught:
        AngularContactBallBearing(bearing=bearing).solve(
            RingOperation(load=(0.0, 0.0, 5.0, 0.0, 0.0)), ElasticGrooves(*grooves)
        )
    assert caught.value.outcome is SolverOutcome.UNDETERMINED
