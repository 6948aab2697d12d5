"""The coupling loop on toy partners with a known answer."""

from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import get_args

import numpy as np
import pytest
from pytest import approx

from flexbearing.coupling import (
    RULES,
    PartnerFailed,
    StoppingCriterion,
    fixed_point,
    newton,
    relaxed as relaxation_rule,
)
from flexbearing.coupling.acceleration import change_per_residual, springs_between_raceways
from flexbearing.coupling.history import CouplingHistory
from flexbearing.coupling.loop import STAGNATION_LIMIT, Status
from flexbearing.quantities.attributes import ENDS


@dataclass(frozen=True)
class ToyState:
    forces: np.ndarray
    residual: float = 0.0
    status: str = ""
    deviation: np.ndarray | None = None

    @property
    def loads(self):
        return self.forces[..., 0]

    def failure(self):
        return f"the toy {self.status}"

    def refined(self):
        return replace(self, residual=self.residual / 1e4)


@dataclass(frozen=True)
class Springs:
    """Every roller is a spring: force = 100 - stiffness times outer deviation; fails beyond a limit."""

    stiffness: float
    limit: float = np.inf

    def solve(self, start=None, deviation=None):
        if np.abs(deviation).max() > self.limit:
            raise PartnerFailed("too much", "stalled")
        return ToyState(np.full((2, 3, 1), 100.0) - self.stiffness * deviation)

    def force_by_deviation(self, state):
        return springs_between_raceways(np.full(3, self.stiffness), 1)

    def iterate(self, compliance, start=None, deviation=None):
        yield start
        if self.limit < 1e-9:
            raise PartnerFailed("no film", "not finite")
        softness = compliance[1][0, 0, 0, 0]
        force = np.full((2, 3, 1), 100.0)
        force[1] = 100.0 / (1 + self.stiffness * softness)
        yield ToyState(force + 1e-3, 1e-5)
        yield ToyState(force, 1e-15, "converged")


class Linear:
    """A structure whose answer is linear in the loads."""

    initial_deviation = None

    def linearised(self, forces):
        return self

    def answer(self, forces):
        return self.deviation(forces), self.compliance


@dataclass(frozen=True)
class Plate(Linear):
    """Each roller bends its own place of the outer raceway."""

    softness: float

    @property
    def compliance(self):
        return None, self.softness * np.eye(3)[:, None, :, None]

    def deviation(self, forces):
        return np.array([np.zeros((3, 1)), self.softness * forces[1]])


def relaxed(bearing, structure, start, criterion, relaxation):
    return fixed_point(bearing, structure, start, criterion, partial(relaxation_rule, relaxation=relaxation))


START = ToyState(np.full((2, 3, 1), 100.0))
CRITERION = StoppingCriterion(tolerance=1e-8, limit=200)


@pytest.mark.parametrize(("product", "relaxation"), [(0.5, 1.0), (0.5, 0.3), (9.0, 0.1)])
def test_relaxation_ends_at_the_known_loads(product, relaxation):
    *_, last = relaxed(Springs(1e6), Plate(product * 1e-6), START, CRITERION, relaxation)
    assert last.status == "converged"
    assert last.state.forces[1] == approx(100 / (1 + product), rel=1e-7)


def test_relaxation_takes_the_steps_that_theory_says():
    """The change shrinks by 1 - relaxation (1 + product) each time: here by a half."""
    steps = list(relaxed(Springs(1e6), Plate(4e-6), START, CRITERION, 0.1))
    changes = np.array([step.mismatch for step in steps])
    assert changes[11:] / changes[10:-1] == approx(0.5, rel=1e-3)


def test_diverging_iteration_never_calls_itself_converged():
    *_, last = relaxed(Springs(1e6), Plate(3e-6), START, CRITERION, 1.0)
    assert last.status == "diverging"
    assert last.number < 20
    assert "newton solves both" in last.message


def test_reaching_the_iteration_limit_is_not_convergence():
    *_, last = relaxed(Springs(1e6), Plate(0.5e-6), START, StoppingCriterion(tolerance=1e-8, limit=5), 0.3)
    assert last.status == "iteration limit"
    assert last.number == 5


def test_small_steps_are_not_taken_for_small_residuals():
    """A tiny relaxation hardly moves the loads, while the answer is still wrong by half."""
    *_, last = relaxed(Springs(1e6), Plate(1e-6), START, StoppingCriterion(tolerance=1e-3, limit=5), 1e-4)
    assert last.status == "iteration limit"
    assert last.mismatch > 0.5


def test_failure_of_a_partner_ends_the_loop_with_its_message():
    *_, last = relaxed(Springs(1e6, limit=1e-6), Plate(1e-6), START, CRITERION, 0.5)
    assert last.status == "not solved"
    assert (last.message, last.ending) == ("too much", "stalled")


def test_failure_of_the_bearing_ends_newton_with_its_message():
    (last,) = newton(Springs(1e6, limit=0.0), Plate(3e-6), START, CRITERION)
    assert (last.number, last.status) == (1, "not solved")
    assert (last.message, last.ending) == ("no film", "not finite")


def test_bearing_that_stalls_under_newton_says_how_far_it_came():
    class Stalls(Springs):
        def iterate(self, compliance, start=None, deviation=None):
            yield start
            yield ToyState(np.full((2, 3, 1), 90.0), 1e-3)
            yield ToyState(np.full((2, 3, 1), 80.0), 1e-3, "stalled")

    *_, last = newton(Stalls(1e6), Plate(3e-6), START, CRITERION)
    assert (last.number, last.status, last.ending) == (2, "not solved", "stalled")
    assert last.message == "the toy stalled"


def test_newton_counts_steps_not_the_start():
    steps = list(newton(Springs(1e6), Plate(3e-6), START, CRITERION))
    assert [step.number for step in steps] == [1, 2]
    assert steps[-1].status == "converged"
    assert steps[-1].state.forces[1] == approx(25.0)


@pytest.mark.parametrize("rule", RULES.values(), ids=RULES.keys())
@pytest.mark.parametrize("product", [0.5, 3.0, 25.0])
def test_accelerated_iterations_end_at_the_known_loads(rule, product):
    *_, last = fixed_point(Springs(1e6), Plate(product * 1e-6), START, CRITERION, rule)
    assert last.status == "converged"
    assert last.state.forces[1] == approx(100 / (1 + product), rel=1e-7)
    assert last.number <= 12  # one number is looked for: two residuals tell it


@dataclass(frozen=True)
class Uneven(Linear):
    """Places of the raceway that deflect differently, and a little together."""

    softness: float

    @property
    def matrix(self):
        return self.softness * (np.diag([1.0, 0.3, 0.1]) + 0.05)

    @property
    def compliance(self):
        return None, self.matrix[:, None, :, None]

    def deviation(self, forces):
        return np.array([np.zeros((3, 1)), self.matrix @ forces[1]])


@pytest.mark.parametrize("rule", [RULES["iqn-ils"], RULES["anderson"]], ids=["iqn-ils", "anderson"])
def test_least_squares_knows_a_linear_partner_after_as_many_steps_as_it_has_numbers(rule):
    plate = Uneven(20e-6)
    *_, last = fixed_point(Springs(1e6), plate, START, CRITERION, rule)
    exact = np.linalg.solve(np.eye(3) + 1e6 * plate.matrix, np.full(3, 100.0))
    assert last.status == "converged"
    assert last.state.forces[1, :, 0] == approx(exact, rel=1e-7)
    assert last.number <= 7


@dataclass(frozen=True)
class Stiffening:
    """A raceway that deflects like the root of the load: newton needs its tangent again and again."""

    softness: float

    def deviation(self, forces):
        return np.array([np.zeros((3, 1)), self.softness * np.sqrt(np.abs(forces[1]))])

    def linearised(self, forces):
        slope = self.softness / 2 / np.sqrt(np.abs(forces[1]))
        return Tangent(slope, self.deviation(forces) - np.array([np.zeros((3, 1)), slope * forces[1]]))


@dataclass(frozen=True)
class Tangent:
    slope: np.ndarray
    initial_deviation: np.ndarray

    @property
    def compliance(self):
        return None, np.diag(self.slope[:, 0])[:, None, :, None]

    def deviation(self, forces):
        return self.initial_deviation + np.array([np.zeros((3, 1)), self.slope * forces[1]])


class LinearSprings(Springs):
    def iterate(self, compliance, start=None, deviation=None):
        yield start
        softness = compliance[1][0, 0, 0, 0]
        force = (100.0 - self.stiffness * deviation) / (
            1 + self.stiffness * np.array([0.0, softness])[:, None, None]
        )
        yield ToyState(force, 1e-15, "converged")


def test_newton_follows_a_structure_that_is_not_linear():
    structure = Stiffening(3e-6)
    *steps, last = newton(LinearSprings(1e6), structure, START, CRITERION)
    assert last.status == "converged"
    force = last.state.forces[1, 0, 0]
    assert force == approx(100 - 1e6 * structure.deviation(last.state.forces)[1, 0, 0], rel=1e-7)
    assert [step.status for step in steps] == [""] * len(steps)
    assert last.number <= 7  # a step for each linearisation of 100 - x = 3 sqrt(x)


# -- what the quasi-Newton rule expects ------------------------------------------------------------


def test_estimate_is_exact_for_springs_between_two_raceways():
    """Loads 100 - k (w_outer - w_inner) of springs over their length: the estimate leads to the root."""
    rng, shape = np.random.default_rng(3), (2, 4, 3)
    half = rng.normal(size=(2, 12, 12))
    compliance = 1e-9 * (half @ half.transpose(0, 2, 1)).reshape(2, 4, 3, 4, 3)
    stiffness = np.array([1e8, 2e8, 0.0, 5e7])
    spring = stiffness[:, None] / np.array([1.0, 3.0, 5.0])

    def answer(deviation):
        load = rng_loads - spring * (deviation[1] - deviation[0])
        return np.array([-np.tensordot(compliance[0], load, 2), np.tensordot(compliance[1], load, 2)])

    rng_loads, deviation = rng.normal(size=(4, 3)) * 1e3, 1e-6 * rng.normal(size=shape)
    residual = answer(deviation) - deviation
    by_deviation = springs_between_raceways(stiffness, 3)
    step = change_per_residual((compliance[0], compliance[1]), by_deviation) @ residual.ravel()
    root = deviation + step.reshape(shape)
    assert answer(root) == approx(root, rel=1e-9, abs=1e-12 * np.abs(root).max())


def test_rigid_raceway_is_not_moved_by_the_estimate():
    compliance = None, 1e-8 * np.eye(3)[:, None, :, None]
    expected = change_per_residual(compliance, springs_between_raceways(np.full(3, 1e8), 1))
    assert expected[:3] == approx(np.eye(6)[:3], rel=0, abs=1e-15)
    assert np.diag(expected)[3:] == approx(0.5)


def test_iterations_with_other_contacts_are_left_out_while_residuals_fall():
    history, contacts, zero = CouplingHistory(), [[1, 1, 1], [1, 1, 0], [1, 1, 0]], np.zeros((2, 3, 1))
    for number, stiffness in enumerate(contacts):
        answer = np.full((2, 3, 1), 1 / (1 + number))
        by_deviation = springs_between_raceways(np.array(stiffness, float), 1)
        history = history.extended(zero, answer, by_deviation, None)
    assert history.same_contacts == 2
    by_deviation = springs_between_raceways(np.array([1.0, 1.0, 0.0]), 1)
    history = history.extended(zero, np.ones((2, 3, 1)), by_deviation, None)
    assert history.same_contacts == 4  # the last residual is not the smallest


def test_quasi_newton_step_is_no_longer_than_the_residual():
    """Of a structure that pushes back, the estimate would step fifty times as far."""
    compliance = None, -0.98 * np.eye(3)[:, None, :, None]
    residual = np.concatenate([np.zeros((1, 3, 1)), np.ones((1, 3, 1))])
    by_deviation = springs_between_raceways(np.ones(3), 1)
    history = CouplingHistory().extended(np.zeros((2, 3, 1)), residual, by_deviation, compliance)
    assert change_per_residual(compliance, by_deviation) @ residual.ravel() == approx(50 * residual.ravel())
    assert RULES["iqn-ils"](history) == approx(residual.ravel())


def test_every_end_has_a_word_in_the_result_file():
    assert {*get_args(Status), "work limit"} - {""} == set(ENDS)  # the limit of a solve of the bearing


# -- diverging and stagnating iterations -------------------------------------------------------------------


@pytest.mark.parametrize("product", [3.0, 30.0])
def test_growth_is_seen_within_a_few_iterations(product):
    *_, last = relaxed(Springs(1e6), Plate(product * 1e-6), START, CRITERION, 1.0)
    assert (last.status, last.number <= 6) == ("diverging", True)


def test_slow_growth_after_a_fall_is_seen():
    """One place diverges slowly, the others converge at first."""
    steps = list(relaxed(Springs(1e6), Uneven(2.2e-6), START, CRITERION, 0.9))
    assert steps[-1].status == "diverging"
    assert min(step.mismatch for step in steps) < steps[0].mismatch


def test_bearing_that_fails_after_growth_is_a_divergence_of_the_coupling():
    *_, last = relaxed(Springs(1e6, limit=1.0), Plate(100e-6), START, CRITERION, 1.0)
    assert (last.status, last.ending) == ("diverging", "stalled")
    assert "newton solves both" in last.message
    assert "too much" in last.message


def test_stagnating_iteration_is_stopped():
    def rule(history):
        return history.deviations[-1]

    *_, last = fixed_point(Springs(1e6), Plate(3e-6), START, CRITERION, rule)
    assert last.status == "stagnating"
    assert last.number == STAGNATION_LIMIT + 1
    assert "newton solves both" in last.message


def test_structure_that_fails_at_once_is_named():
    class Torn(Plate):
        def answer(self, forces):
            raise PartnerFailed("the ring is torn", "not solved")

    (last,) = fixed_point(Springs(1e6), Torn(3e-6), START, CRITERION, RULES["iqn-ils"])
    assert (last.number, last.status, last.message) == (1, "not solved", "the ring is torn")


def test_newton_ends_with_the_force_that_is_left_not_with_the_last_step():
    class Slow(Springs):
        def iterate(self, compliance, start=None, deviation=None):
            for residual in (1.0, 1e-6, 0.9e-10, 1e-16):
                yield ToyState(np.full((2, 3, 1), 100 * (1 + residual**0.5)), residual)

    steps = list(newton(Slow(1e6), Plate(3e-6), START, CRITERION))
    assert [step.status for step in steps] == ["", "converged"]


class Steps(Linear):
    """Each place of the outer raceway is stiff but for forces of 45 to 55 N, between which it moves 80 um."""

    def linearised(self, forces):
        slope = ((forces[1] > 45) & (forces[1] < 55)) * 8e-6
        moved = np.clip((forces[1] - 45) * 8e-6, 0.0, 80e-6)
        return Tangent(slope, np.array([np.zeros((3, 1)), moved - slope * forces[1]]))


def test_newton_is_not_led_in_circles_by_the_tangents_of_a_structure():
    """The stiff tangent at 100 N leads to 20 N and the one there back: the root is on the soft part."""
    steps = list(newton(LinearSprings(1e6), Steps(), START, CRITERION))
    assert steps[-1].status == "converged"
    assert steps[-1].number <= 10
    assert steps[-1].state.forces[1] == approx((100 + 8 * 45) / 9, rel=1e-7)


@dataclass(frozen=True)
class Shared(Springs):
    """Springs on places of the outer raceway that move each other."""

    def iterate(self, compliance, start=None, deviation=None):
        yield start
        force, matrix = np.full_like(start.forces, 100.0), compliance[1][:, 0, :, 0]
        free = 100.0 - self.stiffness * deviation[1]
        force[1] = np.linalg.solve(np.eye(len(matrix)) + self.stiffness * matrix, free)
        yield ToyState(force, 1e-15, "converged")


@dataclass(frozen=True)
class AtStops:
    """Places that move w = w_0 + C F while they touch some stops."""

    matrix: np.ndarray
    moved: np.ndarray

    @property
    def compliance(self):
        return None, self.matrix[:, None, :, None]

    @property
    def initial_deviation(self):
        return np.array([0 * self.moved, self.moved])[..., None]

    def deviation(self, forces):
        return self.initial_deviation + np.array([0 * forces[1], self.matrix @ forces[1]])


@dataclass(frozen=True)
class LooseRing:
    """Places of a raceway as soft as C that stops hold at gaps, and only push."""

    softness: np.ndarray
    gaps: np.ndarray

    @classmethod
    def drawn(cls, seed):
        rng = np.random.default_rng(seed)
        root = rng.normal(size=(3, 3))
        softness = (root @ root.T + 0.1 * np.eye(3)) * 10 ** rng.uniform(-6, -3)
        return cls(softness, rng.uniform(0, 1, 3) * 10 ** rng.uniform(-6, -3))

    def linearised(self, forces):
        free = self.softness @ forces[1, :, 0]
        return min(self._at(np.array(stops), free) for stops in product([False, True], repeat=3))[-1]

    def _at(self, stops, free):
        """How far stops that touch pull, or others are passed; which; the ring there."""
        held = np.zeros_like(self.softness)
        held[np.ix_(stops, stops)] = np.linalg.inv(self.softness[np.ix_(stops, stops)])
        pushes = held @ (free - self.gaps)
        passed = (free - self.softness @ pushes - self.gaps).max() / np.abs(free).max()
        ring = AtStops(self.softness - self.softness @ held @ self.softness, self.softness @ held @ self.gaps)
        return max(-pushes.min() / 100, passed), tuple(stops), ring


@pytest.mark.parametrize("seed", [4, 5, 10, 16])
def test_newton_finds_what_touches_a_loose_ring(seed):
    """Tangents of open and closed stops led back to each other, 40 times, at any share of the way."""
    ring, start = LooseRing.drawn(seed), ToyState(np.full((2, 3, 1), 100.0))
    *_, last = newton(Shared(1e6), ring, start, CRITERION)
    assert last.status == "converged"
    assert last.number <= 12
    deviation = ring.linearised(last.state.forces).deviation(last.state.forces)
    assert last.state.forces[1] == approx(100 - 1e6 * deviation[1], rel=1e-6, abs=1e-6)


def test_numbers_have_no_gap_where_a_structure_fails_at_a_balance():
    class TornAtBalance(Steps):
        def linearised(self, forces):
            if not (forces == START.forces).all():
                raise PartnerFailed("the ring is torn", "not solved")
            return super().linearised(forces)

    steps = list(newton(LinearSprings(1e6), TornAtBalance(), START, CRITERION))
    assert [step.number for step in steps] == list(range(1, len(steps) + 1))
    assert (steps[-1].status, steps[-1].message) == ("not solved", "the ring is torn")


@dataclass
class Torn(Linear):
    """A structure whose answers have nothing to do with each other."""

    asked: int = 0

    def linearised(self, forces):
        self.asked += 1
        return Tangent(np.zeros((3, 1)), np.full((2, 3, 1), 1e-6 * (self.asked % 7)))


def test_tangents_that_lead_nowhere_have_a_budget():
    *_, last = newton(LinearSprings(1e6), Torn(), START, StoppingCriterion(tolerance=1e-8, limit=10_000))
    assert last.status == "stagnating"
    assert last.number < 100
    assert "40 tangents" in last.message
