"""Load distribution of four-point contact ball bearings with elastic rings."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.balance.balls.diagonals import Diagonals, diagonal_coefficient
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.four_point import RingLoad
from quasidynamic.solve.balls.elastic_load_distribution import elastic_ball_loads
from quasidynamic.solve.balls.load_distribution import ball_loads
from tests.ball_bearings import slow_bearing
from tests.reference import plain_elastic_rings as plain

BALLS = 24
TIGHT = slow_bearing(clearance=-10e-6, balls=BALLS, ball=30e-3, pitch=0.5)
LOOSE = slow_bearing(clearance=10e-6, balls=BALLS, ball=30e-3, pitch=0.5)
part = st.floats(-1.0, 1.0)
cases = st.tuples(part, part, part, part, part, st.floats(2.0, 5.5)).map(
    lambda c: np.array([*c[:3], 0.25 * c[3], 0.25 * c[4]]) * 10 ** c[5]
).filter(lambda load: np.abs(load).max() > 1.0)  # fmt: skip
bearings = st.sampled_from([TIGHT.bearing, LOOSE.bearing])


def soft(balls=BALLS, size=4e-10, reach=2.0):
    """Some compliance: positive, falling away from the ball, arches and components coupled."""
    n = np.minimum(np.arange(balls), balls - np.arange(balls))
    waves = np.exp(-0.5 * (reach * 2 * np.pi * n / balls) ** 2)
    apart = np.fft.fft(waves).real / waves.sum()
    own = np.array([[3, 1, 1, 0.5], [1, 2, 0.2, 0.6], [1, 0.2, 2, -0.5], [0.5, 0.6, -0.5, 1.5]]) / 3
    return size * (apart[:, None, None] * own).reshape(balls, 2, 2, 2, 2)


@settings(max_examples=20)
@given(bearings, cases)
def test_balls_carry_the_load_and_shape_the_rings(bearing, load):
    found = elastic_ball_loads(bearing, load, soft())
    lever = np.array([1, 1, 1, 0.25, 0.25])
    pressed = Diagonals.of(bearing).at(found.displacement * lever, found.deflection)
    largest = max(np.abs(load).max(), found.loads.max())
    cosine, sine = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
    outward, along = (
        (found.loads[..., None] * pressed.force / np.where(found.loads > 0, found.loads, 1)[..., None])
        .sum(1)
        .T
    )
    carried = [along.sum(), outward @ sine, outward @ cosine, 0.25 * along @ cosine, -0.25 * along @ sine]
    assert carried == approx(load, abs=1e-9 * largest)
    apart = np.arange(BALLS)[:, None] - np.arange(BALLS)
    made = np.einsum("jkacbd,kbd->jac", soft()[apart % BALLS], pressed.force)
    assert found.deflection == approx(made, abs=1e-9 * np.abs(made).max())
    assert pressed.loads == approx(found.loads, abs=1e-9 * largest)


@settings(max_examples=15)
@given(bearings, cases)
def test_rings_without_compliance_are_rigid(bearing, load):
    found, rigid = elastic_ball_loads(bearing, load, 0 * soft()), ball_loads(bearing, load)
    assert found.loads == approx(rigid.loads, rel=1e-13, abs=1e-13 * rigid.loads.max())
    assert found.displacement == approx(rigid.displacement, rel=1e-13)
    assert found.stiffness == approx(rigid.stiffness, rel=1e-12, abs=1e-12 * np.abs(rigid.stiffness).max())


def test_nearly_rigid_rings_change_loads_in_proportion_to_their_compliance():
    load = np.array([2e4, 1e4, 3e4, 1e3, -2e3])
    rigid = ball_loads(TIGHT.bearing, load).loads
    small, smaller = (
        elastic_ball_loads(TIGHT.bearing, load, soft(size=size)).loads - rigid for size in (1e-13, 1e-14)
    )
    assert smaller == approx(small / 10, rel=1e-2, abs=1e-4 * np.abs(smaller).max())
    assert np.abs(small).max() > 1e-6 * rigid.max()


def test_work_of_the_load_is_kept_in_contacts_and_rings():
    """Clapeyron along a path: the energy that a little more load brings is its work."""
    load, more = np.array([2e4, 1e4, 3e4, 1e3, -2e3]), 1e-4
    states = [elastic_ball_loads(LOOSE.bearing, load * (1 + k * more), soft()) for k in (-1, 1)]
    stored = [energy(LOOSE.bearing, state) for state in states]
    moved = states[1].displacement - states[0].displacement
    assert stored[1] - stored[0] == approx(load @ moved, rel=1e-6)


def energy(bearing, state):
    """2/5 K delta^(5/2) of every diagonal, and half the work of the forces on the rings [J]."""
    K = diagonal_coefficient(bearing)
    sign = np.array([1.0, -1.0])
    force = np.stack([state.loads * np.cos(state.angles), state.loads * np.sin(state.angles) * sign], -1)
    return 0.4 * K * ((state.loads / K) ** (5 / 3)).sum() + 0.5 * (force * state.deflection).sum()


@settings(max_examples=8)
@given(cases)
def test_stiffness_is_that_of_small_further_loads(load):
    bearing = TIGHT.bearing
    found = elastic_ball_loads(bearing, load, soft())
    lever = np.array([1, 1, 1, 0.25, 0.25])
    further = 1e-4 * max(np.abs(load).max(), found.loads.max()) * lever
    for direction in np.diag(further):
        up, down = (elastic_ball_loads(bearing, load + sign * direction, soft()) for sign in (1, -1))
        change = (up.displacement - down.displacement) / 2
        assert found.stiffness @ change / further == approx(direction / further, abs=1e-4)


def test_elastic_rings_are_softer_and_lose_interference():
    load = np.zeros(5)
    rigid, found = ball_loads(TIGHT.bearing, load), elastic_ball_loads(TIGHT.bearing, load, soft())
    assert (found.loads < 0.95 * rigid.loads).all()
    assert (np.linalg.eigvalsh(rigid.stiffness - found.stiffness) > 0).all()


def test_load_turned_by_some_balls_turns_the_distribution():
    angle = 2 * np.pi * 5 / BALLS
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    load = np.array([2e4, 1e4, 3e4, 1e3, -2e3])
    turned = load.copy()
    turned[[2, 1]], turned[[4, 3]] = turn @ load[[2, 1]], turn @ load[[4, 3]]  # azimuths grow from z to y
    before, after = (elastic_ball_loads(LOOSE.bearing, given, soft()) for given in (load, turned))
    assert after.loads == approx(np.roll(before.loads, 5, axis=0), abs=1e-8 * before.loads.max())


@pytest.mark.parametrize("clearance", [-10e-6, 10e-6], ids=["tight", "loose"])
def test_distribution_is_that_of_the_plain_model(clearance):
    """A bearing of six balls on one page, its energy lowered by SciPy."""
    bearing = slow_bearing(clearance=clearance, balls=6, ball=30e-3, pitch=0.2).bearing
    load = np.array([1e4, 5e3, 2e4, 400.0, -300.0])
    found = elastic_ball_loads(bearing, load, soft(6, 4e-9))
    loads, place = plain.solve(
        balls=6, pitch=0.2, angle=np.radians(45), touching=1.5e-3, clearance=clearance,
        coefficient=diagonal_coefficient(bearing), compliance=soft(6, 4e-9), load=load,
    )  # fmt: skip
    assert found.loads == approx(loads, abs=1e-5 * loads.max())
    assert found.displacement == approx(place, rel=1e-4, abs=1e-9)
    assert np.abs(ball_loads(bearing, load).loads - loads).max() > 0.02 * loads.max()


@pytest.mark.parametrize("load", [[0, 0, 100.0, 0, 0], [0, 0, 1e4, 0, 0]])
def test_ring_that_a_single_ball_carries_is_not_pushed_aside(load):
    """Nothing resists along y and about some axes, and nothing pushes there."""
    bearing = slow_bearing(clearance=200e-6, balls=6, ball=30e-3, pitch=0.5).bearing
    found, rigid = elastic_ball_loads(bearing, np.array(load), soft(6)), ball_loads(bearing, np.array(load))
    assert (found.loads > 0).sum(axis=1).tolist() == [2, 0, 0, 0, 0, 0]
    assert found.loads == approx(rigid.loads, rel=0.02)
    assert found.displacement[1] == approx(0.0, abs=1e-9)
    assert found.displacement[2] > rigid.displacement[2]


def test_torque_follows_the_loads_of_elastic_rings():
    load = RingLoad(radial_z=2e4, axial=1e4, moment_y=-1e3)
    state = TIGHT.solve(load, soft())
    assert state.distribution.loads == approx(
        elastic_ball_loads(TIGHT.bearing, load.vector(), soft()).loads, rel=1e-12
    )
    assert state.balls.load[:, :, 0] == approx(state.distribution.loads, rel=1e-12)
    assert state.torque < TIGHT.solve(load).torque


def test_compliance_that_cannot_be_is_refused():
    load = np.array([1e4, 0, 0, 0, 0])
    for broken in (soft(12), soft() * np.nan):
        with pytest.raises(ImpossiblePart, match="must be finite, of shape"):
            elastic_ball_loads(TIGHT.bearing, load, broken)
    with pytest.raises(ImpossiblePart, match="not symmetric"):
        elastic_ball_loads(TIGHT.bearing, load, soft() + np.arange(16.0).reshape(2, 2, 2, 2) * 1e-11)
    with pytest.raises(NotSolved):
        elastic_ball_loads(TIGHT.bearing, load, -20 * soft())


@pytest.mark.parametrize("number", [30, pytest.param(600, marks=pytest.mark.slow)])
def test_random_bearings_find_their_balance(number):
    """Three balls to a full ring, clearance to interference, loads and rings over several decades."""
    rng = np.random.default_rng(number)
    for _ in range(number):
        ball = 10 ** rng.uniform(-3, -1)
        pitch = ball * 10 ** rng.uniform(0.6, 1.4)
        balls = int(rng.integers(3, int(0.95 * np.pi * pitch / ball)))
        bearing = slow_bearing(
            ball,
            pitch,
            balls=balls,
            angle=rng.uniform(5, 75),
            conformity=rng.uniform(0.505, 0.6),
            outer_conformity=rng.uniform(0.505, 0.6),
            clearance=ball * rng.uniform(-1, 1) * 10 ** rng.uniform(-5, -2.5),
        ).bearing
        load = rng.normal(size=5) * (rng.random(5) < 0.7) + 1e-3
        load *= 8e6 * ball**2 * balls * 10 ** rng.uniform(-5, 0)
        load[3:] *= pitch / 2
        size = 10 ** rng.uniform(-1.5, 1.5) / (210e9 * ball)
        found = elastic_ball_loads(bearing, load, soft(balls, size, 10 ** rng.uniform(-1, 1)))
        assert found.imbalance < 1e-9
