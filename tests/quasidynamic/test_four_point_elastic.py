"""Load distribution of four-point contact ball bearings with elastic rings."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves
from quasidynamic.balance.balls.elastic_rings import ElasticRings, RigidRings
from quasidynamic.balance.balls.four_contacts import FourContacts
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.four_point import RingLoad
from quasidynamic.solve.balls.balls_on_arches import balls_in_balance
from quasidynamic.solve.balls.elastic_load_distribution import elastic_ball_loads
from quasidynamic.solve.balls.load_distribution import ball_loads
from tests.ball_bearings import slow_bearing
from tests.reference import plain_elastic_rings as plain

BALLS = 24
TIGHT = slow_bearing(clearance=-10e-6, balls=BALLS, ball=30e-3, pitch=0.5)
LOOSE = slow_bearing(clearance=10e-6, balls=BALLS, ball=30e-3, pitch=0.5)
LOAD = np.array([2e4, 1e4, 3e4, 1e3, -2e3])
part = st.floats(-1.0, 1.0)
cases = st.tuples(part, part, part, part, part, st.floats(2.0, 5.5)).map(
    lambda c: np.array([*c[:3], 0.25 * c[3], 0.25 * c[4]]) * 10 ** c[5]
).filter(lambda load: np.abs(load).max() > 1.0)  # fmt: skip
bearings = st.sampled_from([TIGHT.bearing, LOOSE.bearing])


def soft(balls=BALLS, size=4e-10, reach=2.0, seed=1):
    """Random rings: positive, falling away from the ball, arcs coupled; an arc moves and, less, bends."""
    angles, draw = np.radians([20.0, 32.0, 45.0, 58.0, 70.0]), np.random.default_rng(seed)
    n = np.minimum(np.arange(balls), balls - np.arange(balls))
    waves = np.exp(-0.5 * (reach * 2 * np.pi * n / balls) ** 2)
    apart = np.fft.fft(waves).real / waves.sum()
    around = apart[np.subtract.outer(np.arange(balls), np.arange(balls)) % balls]
    moves = np.kron(np.eye(2), np.stack([np.sin(angles), np.cos(angles)], axis=1))
    bends = np.kron(np.eye(2), np.exp(-0.5 * (np.subtract.outer(angles, angles) / 0.4) ** 2))

    def groove():
        mixed = moves @ draw.normal(size=(4, 4))
        own = mixed @ mixed.T / np.square(mixed).sum(1).max() + 0.2 * bends
        return ElasticGroove(angles, size * np.kron(around, own).reshape((2 * balls, len(angles)) * 2))

    return ElasticGrooves(groove(), groove())


def forces(found):
    """On the races (Z, 2, 2) [N]: axial to the side of the diagonal, plus i radial."""
    return 1j * found.loads * np.exp(-1j * found.angles) * [-1, 1]


@settings(max_examples=20)
@given(bearings, cases)
def test_balls_carry_the_load_and_shape_the_rings(bearing, load):
    grooves = soft()
    found = elastic_ball_loads(bearing, load, grooves)
    largest = max(np.abs(load).max(), found.loads.max())
    cosine, sine = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
    along, outward = -forces(found)[..., 0].real @ [1.0, -1.0], -forces(found)[..., 0].imag.sum(1)
    carried = [along.sum(), outward @ sine, outward @ cosine, 0.25 * along @ cosine, -0.25 * along @ sine]
    assert carried == approx(load, abs=1e-9 * largest)
    for race, groove in enumerate(grooves):
        angles, loads = found.angles[..., race].ravel(), found.loads[..., race].reshape(-1, 1)
        share, slope = (plain.shares(groove.angles, angles, order) for order in (0, 1))
        u = (2 * race - 1) * np.tensordot(groove.compliance, loads * share, axes=2)
        made = ((1j * share + slope) * u).sum(1) * np.exp(-1j * angles)
        shape = found.groove_shape[..., race, :] @ [1, 1j]
        assert shape == approx(made.reshape(-1, 2), abs=1e-9 * np.abs(made).max())
    place = found.displacement * [1, 1, 1, 0.25, 0.25]
    contacts = FourContacts.of(bearing)
    again = contacts.at(contacts.arms(place, found.centres, found.groove_shape))
    assert again.forces.loads == approx(found.loads, abs=1e-9 * largest)
    assert again.angles == approx(found.angles, abs=1e-12)
    assert again.excess == approx(np.zeros((BALLS, 2)), abs=1e-9 * largest)


@settings(max_examples=15)
@given(bearings, cases)
def test_rings_without_compliance_are_rigid(bearing, load):
    found, rigid = elastic_ball_loads(bearing, load, soft().softened(0.0)), ball_loads(bearing, load)
    assert found.loads == approx(rigid.loads, rel=1e-13, abs=1e-13 * rigid.loads.max())
    assert found.displacement == approx(rigid.displacement, rel=1e-13)
    assert found.stiffness == approx(rigid.stiffness, rel=1e-12, abs=1e-12 * np.abs(rigid.stiffness).max())


def test_nearly_rigid_rings_change_loads_in_proportion_to_their_compliance():
    rigid, *elastic = (elastic_ball_loads(TIGHT.bearing, LOAD, soft(size=C)).loads for C in (0, 1e-13, 1e-14))
    small, smaller = elastic - rigid
    assert smaller == approx(small / 10, rel=1e-2, abs=1e-4 * np.abs(smaller).max())
    assert np.abs(small).max() > 1e-6 * rigid.max()


def test_work_of_the_load_is_kept_in_contacts_and_rings():
    """Clapeyron along a path: the energy that a little more load brings is its work."""
    more, K = 1e-4, FourContacts.of(LOOSE.bearing).coefficient
    states = [elastic_ball_loads(LOOSE.bearing, LOAD * (1 + k * more), soft()) for k in (-1, 1)]
    contacts = [(0.4 * K * (state.loads / K) ** (5 / 3)).sum() for state in states]
    rings = [(forces(state) * (state.groove_shape @ [1, -1j])).real.sum() / 2 for state in states]
    moved = states[1].displacement - states[0].displacement
    stored = np.add(contacts, rings)
    assert stored[1] - stored[0] == approx(LOAD @ moved, rel=1e-6)
    assert rings[1] > 0.1 * contacts[1]


@pytest.mark.parametrize("speed", [0.0, 300.0])
@pytest.mark.parametrize("seed", range(2))
def test_softness_is_that_of_differences_of_the_shape(seed, speed):
    draw = np.random.default_rng(seed)
    rings = ElasticRings(RigidRings.of(TIGHT.bearing, LOAD, speed), soft(seed=seed), 1.0)
    place, shape = 2e-5 * draw.normal(size=5), 1e-5 * draw.normal(size=8 * BALLS)

    def at(shape):
        balls = balls_in_balance(rings.rigid.contacts, place, shape.reshape(-1, 2, 2, 2), None, 1.0)
        return rings.at(place, shape, *balls, np.zeros((BALLS, 2)))

    state = at(shape)
    assert 0.5 < (state.balls.forces.loads > 0).mean() < 1
    loaded = np.repeat(state.balls.forces.loads.ravel() > 0, 2)
    pressed = np.repeat(state.balls.forces.loads.sum((1, 2)) > 1.0, 8)  # others lie at the edge, or anywhere
    change = draw.normal(size=(10, 8 * BALLS)) * (loaded & pressed)
    closing = state.shapes[:, 5] / np.abs(state.shapes[:, 5]).max()
    misfits = [[at(shape + step * each).misfit for each in (*change, closing)] for step in (1e-9, -1e-9)]
    *by_difference, left = np.subtract(*misfits) / 2e-9
    by_softness = change + change[:, loaded] @ state.softness.T
    assert by_softness == approx(np.array(by_difference), abs=1e-6 * np.abs(by_softness).max())
    largest = np.abs(state.misfit).max()  # also of contacts without load
    left *= np.abs(state.shapes[:, 5]).max()
    assert left[pressed] == approx(-state.misfit[pressed], abs=1e-5 * largest)
    eigenvalues = np.linalg.eigvals(np.eye(loaded.sum()) + state.softness[loaded])
    assert rings.is_stable(state) == bool(eigenvalues.real.min() > 0)


@settings(max_examples=4)
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
    turned = LOAD.copy()
    turned[[2, 1]], turned[[4, 3]] = turn @ LOAD[[2, 1]], turn @ LOAD[[4, 3]]  # azimuths grow from z to y
    before, after = (elastic_ball_loads(LOOSE.bearing, given, soft()) for given in (LOAD, turned))
    assert after.loads == approx(np.roll(before.loads, 5, axis=0), abs=1e-8 * before.loads.max())


@pytest.mark.parametrize(("clearance", "rigid"), [(-10e-6, None), (10e-6, "inner"), (0.0, "outer")])
def test_distribution_is_that_of_the_plain_model(clearance, rigid):
    """A bearing of six balls on one page, its potential lowered by SciPy."""
    bearing = slow_bearing(clearance=clearance, balls=6, ball=30e-3, pitch=0.2).bearing
    load, grooves = np.array([1e4, 5e3, 2e4, 400.0, -300.0]), soft(6, 4e-9)
    grooves = grooves._replace(**({rigid: None} if rigid else {}))
    found = elastic_ball_loads(bearing, load, grooves)
    loads, place = plain.solve(
        balls=6, pitch=0.2, angle=np.radians(45), touching=1.5e-3, clearance=clearance,
        coefficient=FourContacts.of(bearing).coefficient, stations=soft(6).inner.angles,
        compliances=[groove and groove.compliance for groove in grooves], load=load,
    )  # fmt: skip
    assert found.loads == approx(loads, abs=1e-6 * loads.max())
    assert found.displacement == approx(place, rel=1e-5)
    assert np.abs(ball_loads(bearing, load).loads - loads).max() > 0.01 * loads.max()


@pytest.mark.parametrize("load", [[0, 0, 100.0, 0, 0], [0, 0, 1e4, 0, 0]])
def test_ring_that_a_single_ball_carries_is_not_pushed_aside(load):
    """Nothing resists along y and about some axes, and nothing pushes there."""
    bearing = slow_bearing(clearance=200e-6, balls=6, ball=30e-3, pitch=0.5).bearing
    found, rigid = elastic_ball_loads(bearing, np.array(load), soft(6)), ball_loads(bearing, np.array(load))
    assert (found.loads > 0).sum(axis=(1, 2)).tolist() == [4, 0, 0, 0, 0, 0]
    assert found.loads == approx(rigid.loads, rel=0.02)
    assert found.displacement[1] == approx(0.0, abs=1e-9)
    assert found.displacement[2] > rigid.displacement[2]


def test_torque_follows_the_loads_of_elastic_rings():
    load = RingLoad(radial_z=2e4, axial=1e4, moment_y=-1e3)
    state = TIGHT.solve(load, soft())
    loads = elastic_ball_loads(TIGHT.bearing, load.vector(), soft()).loads
    assert state.distribution.loads == approx(loads, rel=1e-12)
    assert state.balls.load == approx(loads, rel=1e-12)
    assert state.torque < TIGHT.solve(load).torque


def test_grooves_that_cannot_be_are_refused():
    load = np.array([1e4, 0, 0, 0, 0])
    for name, broken in (("inner", soft(12)), ("outer", ElasticGrooves(None, soft(12).outer))):
        with pytest.raises(ImpossiblePart, match=f"the {name} groove has 24 contacts, 48 are needed"):
            elastic_ball_loads(TIGHT.bearing, load, broken)
    few = slow_bearing(clearance=-10e-6, balls=6, ball=30e-3, pitch=0.5).bearing
    for part in (-3.0, -8.0):
        with pytest.raises(NotSolved, match="lose their balance") as ended:
            elastic_ball_loads(few, load, soft(6).softened(part))
        assert ended.value.outcome == "too soft"


@pytest.mark.parametrize("number", [30, pytest.param(600, marks=pytest.mark.slow)])
def test_random_bearings_find_their_balance(number):
    """Three balls to a full ring, clearance to interference, loads and rings over several decades."""
    rng = np.random.default_rng(number)
    for seed in range(number):
        ball = 10 ** rng.uniform(-3, -1)
        pitch = ball * 10 ** rng.uniform(0.6, 1.4)
        balls = int(rng.integers(3, int(0.95 * np.pi * pitch / ball)))
        conformity, outer = rng.uniform(0.505, 0.6, 2)
        bearing = slow_bearing(
            ball, pitch, balls=balls, angle=rng.uniform(5, 75), conformity=conformity, outer_conformity=outer,
            clearance=ball * rng.uniform(-1, 1) * 10 ** rng.uniform(-5, -2.5),
        ).bearing  # fmt: skip
        load = rng.normal(size=5) * (rng.random(5) < 0.7) + 1e-3
        load *= 8e6 * ball**2 * balls * 10 ** rng.uniform(-5, 0)
        load[3:] *= pitch / 2
        size = 10 ** rng.uniform(-1.5, 1.5) / (210e9 * ball)
        found = elastic_ball_loads(bearing, load, soft(balls, size, 10 ** rng.uniform(-1, 1), seed))
        assert found.imbalance < 1e-9
