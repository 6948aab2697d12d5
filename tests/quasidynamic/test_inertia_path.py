"""Lightly loaded free rings, whose balls jump as they move: balance at the end of growing inertia."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import AngularBalance, race_contacts
from quasidynamic.balance.balls.race_control import PrescribedControl
from quasidynamic.errors import NotSolved
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material
from quasidynamic.solve.arclength import LinearisedEquations, follow
from quasidynamic.solve.balls import ring_newton, ring_on_balls
from quasidynamic.solve.balls.ball_equilibrium import balanced, force_scales, resolved
from quasidynamic.solve.balls.frozen_solve import BorderedMatrix, frozen_solve
from quasidynamic.solve.balls.inertia_homotopy import InertiaFamily, inertia_homotopy
from quasidynamic.solve.balls.ring_newton import BUDGET, RingSolution, newton
from quasidynamic.solve.balls.ring_on_balls import solve, start
from quasidynamic.solve.balls.ring_on_springs import LONGEST, newton_step
from quasidynamic.solve.corners import followed_through
from quasidynamic.solve.step_length import SolverOutcome
from tests.ball_bearings import fast_bearing
from tests.random_balls import unbalanced

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
BEARING = fast_bearing(10e-3, 50e-3, 7, np.radians(36.0), 0.53, 0.545)
SPEED = 500.0  # [rad/s]
LOADS = {  # over the centrifugal force of a ball, moments over the groove radius too
    "tilted": (0.1, -0.1, -0.5, -0.2, 0.1),
    "axial and tilted": (0.9, 0.15, 0.0, 0.12, -0.13),
    "heavier": (7.4, -1.5, 4.0, -3.0, 4.0),
}

PRESSED = (60.0, 2.0, 5.0, 2.0, -1.0)


def balance(load, control, speed=SPEED):
    own = AngularBalance(
        bearing=BEARING,
        contacts=race_contacts(BEARING),
        control=PrescribedControl(BEARING, control),
        load=np.array([load]),
        held=np.zeros((1, 5), bool),
        place=np.zeros((1, 5)),
        speeds=np.array([speed, 0.0]).reshape(2, 1, 1),
    )
    own.load[:] *= own.free_centrifugal[0]
    return own


def on_path(own):
    """Ring and balls at the end of the path."""
    places, _ = inertia_homotopy(own, BUDGET)
    assert places is not None
    return places


@pytest.mark.sampled(2)
@pytest.mark.parametrize("control", ["outer", "inner"])
@pytest.mark.parametrize("load", LOADS.values(), ids=LOADS.keys())
def test_path_of_growing_inertia_ends_in_balance(load, control):
    own = balance(load, control)
    ring, centres = on_path(own)
    balls = own.balls(own.grooves(ring), centres)
    _, force, traction = balls.forces
    largest = max(balls.loads.max(), np.abs(own.load).max())
    assert np.abs(balls.excess).max() < 1e-11 * largest
    assert np.abs(own.load - own.on_ring(force, traction)).max() < 1e-11 * largest


def test_path_ends_where_newtons_method_does_when_all_balls_are_pressed():
    own = balance(PRESSED, "outer")
    ring, centres = on_path(own)
    direct = newton(own, *start(own))
    assert direct.outcomes == [SolverOutcome.CONVERGED]
    assert ring == approx(direct.ring, rel=1e-7, abs=1e-13)
    assert centres == approx(direct.centres, rel=1e-7)


def test_derivatives_of_the_path():
    own = balance(LOADS["heavier"], "inner")
    ring, centres = on_path(own)
    family = InertiaFamily(own, 1j * own.free_centrifugal + np.zeros_like(centres), BUDGET)
    state, step = family.packed(ring, centres) * (1 + 1e-4 * np.cos(np.arange(19))), 1e-7
    for parameter in (0.3, 1.0):
        columns = [
            (family.at(state + way, parameter).residual - family.at(state - way, parameter).residual)
            for way in step * np.eye(len(state))
        ]
        matrix = np.array(columns).T / (2 * step)
        solved = family.at(state, parameter).solve(matrix)  # the largest force hardly moves: nearly one
        assert solved == approx(np.eye(len(state)), abs=2e-3)
        sign, _ = np.linalg.slogdet(matrix)
        assert family.orientation(state, parameter) == sign


def test_cases_beside_each_other_end_on_their_own_paths(monkeypatch):
    monkeypatch.setattr(ring_newton, "LIMIT", 1)  # of Newton's method, so that each needs a path
    cases = (LOADS["heavier"], 400.0, 0.0), (PRESSED, SPEED, 2e-6)
    held = np.arange(5)[None] > 2  # against tilting, at a tilt of its own
    each = [
        replace(balance(load, "outer", speed), held=held, place=np.where(held, tilt, 0.0))
        for load, speed, tilt in cases
    ]
    whole = replace(
        each[0],
        load=np.concatenate([own.load for own in each]),
        held=np.concatenate([own.held for own in each]),
        place=np.concatenate([own.place for own in each]),
        speeds=np.concatenate([own.speeds for own in each], axis=1),
    )
    together = solve(whole)
    for case, own in enumerate(each):
        alone = solve(own)
        assert together.outcomes[case] is alone.outcomes[0] is SolverOutcome.CONVERGED
        assert together.ring[case] == approx(alone.ring[0], rel=1e-9)
        assert together.centres[case] == approx(alone.centres[0], rel=1e-9)


@pytest.mark.slow
def test_case_that_stalls_newtons_method_is_solved_along_the_path():
    """Bearing drawn at random: balls jump between lying on the outer race and being wedged."""
    own = replace(
        balance((0.152, 0.061, 0.304, 0.001, -0.061), "inner"),
        speeds=np.array([1111.6, 0.0]).reshape(2, 1, 1),
    )
    with np.errstate(all="ignore"):
        assert newton(own, *start(own)).outcomes != [SolverOutcome.CONVERGED]
    assert solve(own).outcomes == [SolverOutcome.CONVERGED]


def test_ring_on_200_balls_under_35_newton_is_solved_from_slower_rings():
    """A bearing drawn at random, its balls hardly pressed by the inner race."""
    groove = Groove(conformity=0.5397677357672424, material=STEEL)
    bearing = replace(
        BEARING,
        ball=Ball(diameter=19.875562585599946e-3, material=STEEL),
        inner=groove,
        outer=groove,
        balls=200,
        pitch_diameter=1.4241253168364139,
        contact_angle=np.radians(14.837084423299562),
    )
    load = (8.38653720127054, 25.720931939692452, 22.205847291319774, -8.120795133139508, -0.12317355166917)
    operation = RingOperation(load=load, inner_speed=6.848912898783027)
    state = AngularContactBallBearing(bearing=bearing, control="inner").solve(operation)
    assert unbalanced(state) < 1e-9
    assert state.evaluations < 2 * BUDGET


def test_search_along_a_path_ends_with_its_budget():
    places, count = inertia_homotopy(balance(LOADS["heavier"], "outer"), 20)
    assert places is None
    assert 20 <= count <= 22


@pytest.mark.slow
def test_searches_that_end_with_their_budgets_are_told_with_what_they_cost(monkeypatch):
    for module in (ring_newton, ring_on_balls):
        monkeypatch.setattr(module, "BUDGET", 0)
    model = AngularContactBallBearing(bearing=BEARING, control="inner")
    force = float(balance(LOADS["heavier"], "inner", 1111.6).free_centrifugal[0, 0])
    lever = np.array([1.0, 1.0, 1.0, *[BEARING.inner_groove_radius] * 2])
    force *= (SPEED / 1111.6) ** 2  # the load is counted in forces at the lower speed
    load = tuple(np.array([0.152, 0.061, 0.304, 0.001, -0.061]) * force * lever)
    with pytest.raises(NotSolved, match=r"in \d+ evaluations by Newton's method and the searches") as refused:
        model.solve(RingOperation(load=load, inner_speed=1111.6))
    assert refused.value.outcome is SolverOutcome.LIMIT


def test_bordered_equations_have_the_solution_of_the_whole_matrix():
    random = np.random.default_rng(0)
    parts = random.normal(size=(5, 5)), random.normal(size=(5, 12)), random.normal(size=(12, 5))
    matrix = BorderedMatrix(*parts, balls=random.normal(size=(6, 2, 2)))
    whole, right = matrix.times(np.eye(17)), random.normal(size=(17, 2))
    assert whole[5:7, 7:] == approx(np.zeros((2, 10)), abs=0)
    assert matrix.solved(right) == approx(np.linalg.solve(whole, right), rel=1e-10)
    assert matrix.sign() == np.linalg.slogdet(whole)[0]
    singular = matrix._replace(balls=np.zeros((6, 2, 2)))
    assert np.isnan(singular.solved(right)).all()
    assert singular.sign() == 0.0


def test_path_and_balls_call_the_same_forces_balance():
    own = balance((0.05, -8e-3, 2e-3, 0.0, 0.0), "outer")
    ring, centres = on_path(own)
    family = InertiaFamily(own, 1j * own.free_centrifugal + np.zeros_like(centres), BUDGET)
    balls = own.balls(own.grooves(ring), centres)
    limit = force_scales(own, balls, own.grooves(ring)).noise[0]
    for share, holds in (
        (0.5, True),
        (0.85, False),
    ):  # of the limit, in both directions: 0.7 and 1.2 as a vector
        force = np.zeros_like(centres)
        force[0, 2] = share * limit * (1 + 1j)
        place = centres + resolved(balls, force - balls.excess)
        assert balanced(own, own.balls(own.grooves(ring), place), own.grooves(ring)).all() == holds
        assert family.at(family.packed(ring, place), 1.0).converged == holds


def test_case_that_ended_not_finite_has_no_forces():
    own, nothing = balance(LOADS["heavier"], "outer"), np.full((1, 1), np.nan)
    places = nothing * np.ones(5), nothing * np.ones(BEARING.balls, complex)
    lost = RingSolution(*places, [SolverOutcome.NOT_FINITE], nothing[0], np.array([1]))
    balls, ring = lost.forces(own)  # without a warning
    assert np.isnan(balls.excess).all()
    assert np.isnan(ring.excess).all()


def test_ring_that_nothing_resists_makes_the_longest_step():
    own, force = balance((0.1, 0.0, 0.0, 0.0, 0.0), "outer"), np.array([[-40.0, -1.0, 3.0, 0.0, 0.0]])
    step = newton_step(own, force, np.zeros((1, 5, 5)), np.array([7.0]))
    longest = LONGEST * min(BEARING.inner_reach, BEARING.outer_reach)
    assert step == approx(longest * force / 40.0, rel=1e-12)


def test_balls_off_both_races_fall_back_on_them():
    own = balance((3.0, -0.1, 0.2, 0.0, 0.0), "outer")
    ring = np.zeros((1, 5))
    inside = np.full((1, BEARING.balls), 0.9j * BEARING.outer_reach)
    ring[0, 0] = -own.unloaded_groove[0].real
    assert (np.abs(own.grooves(ring) - inside) < BEARING.inner_reach).all()
    pull = 1j * own.free_centrifugal + np.zeros_like(inside)
    found, centres = frozen_solve(own, (ring, inside), (pull, np.zeros((1, 5))), 1e-9, 400)
    expected, _ = frozen_solve(own, start(own), (pull, np.zeros((1, 5))), 1e-9, 400)
    assert found == approx(expected, rel=1e-6, abs=1e-12)
    assert (np.abs(centres) >= BEARING.outer_reach).all()


class Zigzag:
    """x for x up to 0.3, back to 0.06 at 0.38, then up again: two corners sharper than a right angle."""

    weight = np.ones(1)

    def bounded(self, before, after):
        return after

    def _slope(self, x):
        return np.where((x > 0.3) & (x < 0.38), -3.0, 1.0)

    def orientation(self, state, parameter):
        return float(np.sign(self._slope(state[0])))

    def at(self, state, parameter):
        x = state[0]
        value = min(x, 0.3) - 3 * np.clip(x - 0.3, 0.0, 0.08) + max(x - 0.38, 0.0)
        residual, slope = np.array([value - parameter]), self._slope(x)
        return LinearisedEquations(
            residual, np.array([-1.0]), lambda right: right / slope, abs(residual[0]) < 1e-12
        )


def test_branch_is_followed_around_sharp_corners():
    end = followed_through(Zigzag(), np.zeros(1))
    assert end is not None
    assert end.state[0] == approx(1.32, abs=1e-10)


def test_branch_that_comes_back_is_no_answer():
    class Returning(Zigzag):
        def at(self, state, parameter):
            x = state[0]
            residual = np.array([x - x**2 - parameter])
            return LinearisedEquations(
                residual, np.array([-1.0]), lambda right: right / (1 - 2 * x), abs(residual[0]) < 1e-12
            )

    assert followed_through(Returning(), np.zeros(1)) is None


def test_step_that_leaps_to_another_branch_is_taken_back():
    class Hyperbola:
        """x = p, y^2 = (x - 1/2)^2 + 1e-6: two branches that nearly touch, each turning sharply there."""

        weight = np.ones(2)

        def bounded(self, before, after):
            return after

        def orientation(self, state, parameter):
            return float(np.sign(state[1]))

        def at(self, state, parameter):
            x, y = state
            residual = np.array([x - parameter, y**2 - (x - 0.5) ** 2 - 1e-6])
            matrix = np.array([[1.0, 0.0], [1.0 - 2 * x, 2 * y]])
            done = bool(np.abs(residual).max() < 1e-13)
            return LinearisedEquations(
                residual, np.array([-1.0, 0.0]), lambda right: np.linalg.solve(matrix, right), done
            )

    family, begin = Hyperbola(), np.array([0.0, np.sqrt(0.25 + 1e-6)])
    assert follow(family, begin, 0.0, (0.0, 1.0), upwards=True).points[-1].state[1] < 0
    end = followed_through(family, begin)
    assert end is not None
    assert end.state == approx([1.0, begin[1]], rel=1e-10)
