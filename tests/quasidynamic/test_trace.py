"""Branches of equilibria: folds, stability, several equilibria at one load, and how a branch ends."""

from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import pairwise
from math import log

import numpy as np
import pytest
from pytest import approx

import quasidynamic.trace
from quasidynamic import FourPointCurve, OutOfRange
from quasidynamic.balance.rollers.unknowns import CAGE
from quasidynamic.solve import arclength
from quasidynamic.solve.arclength import BranchEnd, LinearisedEquations, follow
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import bounded
from quasidynamic.trace import equilibria_at, trace
from tests.bearings import RPM, paper_bearing

SPAN = (1000.0, 10000.0)  # [N]
WITHIN = 3000.0  # [N] between both folds
FALLING = FourPointCurve.through(at_rest=0.0, peak=0.06, peak_slip=0.01, far=0.02)

# -- branches that are known ------------------------------------------------------------------------


@dataclass(frozen=True)
class Toy:
    """One equation R(x, p) with its derivatives."""

    value: object
    by_state: object
    by_parameter: object
    weight = np.ones(1)

    def at(self, state, parameter):
        with np.errstate(invalid="ignore"):
            value, slope, change = (
                np.array([part(state[0], parameter)], float)
                for part in (self.value, self.by_state, self.by_parameter)
            )
        return LinearisedEquations(value, change, partial(self.solved, slope), bool(abs(value[0]) < 1e-13))

    @staticmethod
    def solved(slope, right):
        with np.errstate(all="ignore"):
            return right / slope

    @staticmethod
    def bounded(before, after):
        return after


CUBIC = Toy(lambda x, p: x**3 - x - p, lambda x, p: 3 * x**2 - 1, lambda x, p: -1.0)
CIRCLE = Toy(lambda x, p: x**2 + p**2 - 1, lambda x, p: 2 * x, lambda x, p: 2 * p)
ROOT = Toy(lambda x, p: x - np.sqrt(-p), lambda x, p: 1.0, lambda x, p: 0.5 / np.sqrt(-p))


def test_folds_of_a_cubic():
    found = follow(CUBIC, np.array([-1.3]), -1.0, (-1.0, 1.0), upwards=True)
    assert found.end is BranchEnd.RANGE_LEFT
    folds = [step for step in found.points if step.fold]
    assert [step.parameter for step in folds] == approx(
        np.array([2, -2]) / (3 * np.sqrt(3)), rel=0, abs=1e-12
    )
    assert [step.state[0] for step in folds] == approx(np.array([-1, 1]) / np.sqrt(3), rel=0, abs=1e-7)
    assert found.points[0].parameter == -1.0
    assert found.points[-1].parameter == 1.0
    assert all(abs(CUBIC.value(step.state[0], step.parameter)) < 1e-12 for step in found.points)


def test_steps_go_on_along_the_branch_and_never_back():
    found = follow(CUBIC, np.array([-1.3]), -1.0, (-1.0, 1.0), upwards=True)
    assert (np.diff([step.state[0] for step in found.points]) > 0).all()


def test_branch_that_turns_back_ends_where_it_began():
    found = follow(CUBIC, np.array([1.2]), 0.5, (-1.0, 0.5), upwards=False)
    assert found.end is BranchEnd.RANGE_LEFT
    # Round the lower fold, up the middle, round the upper one, down to the other bound.
    assert found.points[-1].parameter == -1.0
    short = follow(CUBIC, np.array([1.2]), 0.2, (-0.5, 0.2), upwards=False)
    assert short.end is BranchEnd.RANGE_LEFT
    assert short.points[-1].parameter == 0.2
    assert short.points[-1].state[0] == approx(-0.20914, rel=0, abs=1e-5)
    assert sum(step.fold for step in short.points) == 1


def test_closed_branch_ends_at_the_step_limit():
    found = follow(CIRCLE, np.array([1.0]), 0.0, (-2.0, 2.0), upwards=True)
    assert found.end is BranchEnd.LIMIT
    folds = np.array([step.parameter for step in found.points if step.fold])
    assert folds[:4] == approx([1.0, -1.0, 1.0, -1.0], rel=0, abs=1e-12)


def test_branch_that_stops_is_said_to_stop():
    found = follow(ROOT, np.array([1.0]), -1.0, (-1.0, 1.0), upwards=True)
    assert found.end is BranchEnd.STEP_TOO_SHORT
    assert found.points[-1].parameter == approx(0.0, rel=0, abs=1e-4)


def test_nothing_to_begin_with():
    found = follow(ROOT, np.array([1.0]), 1.0, (0.5, 1.0), upwards=False)
    assert found == type(found)((), BranchEnd.NO_START)


@pytest.mark.parametrize("steepness", [1.0, -1.0, 50.0, -50.0])
def test_a_corner_is_passed(steepness):
    """Where a contact opens, a branch changes its direction within the rounding of the gap."""
    rounding = 1e-7
    corner = Toy(
        lambda x, p: x - steepness * (p + np.hypot(p, rounding)) / 2,
        lambda x, p: 1.0,
        lambda x, p: -steepness * (1 + p / np.hypot(p, rounding)) / 2,
    )
    found = follow(corner, np.array([0.0]), -1.0, (-1.0, 0.3), upwards=True)
    assert found.end is BranchEnd.RANGE_LEFT
    assert not any(step.fold for step in found.points)
    assert found.points[-1].state[0] == approx(0.3 * steepness, rel=1e-9, abs=0)


def test_a_gap_too_small_to_matter_is_leaped_over(monkeypatch):
    """Where rounding spoils a contact that opens, short steps end inside it and longer ones do not."""
    monkeypatch.setattr(arclength, "FIRST_STEP", 1e-6)
    gap = Toy(lambda x, p: x - p if not 0 < p < 1e-5 else np.nan, lambda x, p: 1.0, lambda x, p: -1.0)
    found = follow(gap, np.array([0.0]), 0.0, (0.0, 1.0), upwards=True)
    assert found.end is BranchEnd.RANGE_LEFT
    assert (np.diff([step.parameter for step in found.points]) > 0).all()


def test_steps_are_short_where_the_branch_bends():
    small = Toy(lambda x, p: x**2 + p**2 - 0.01, lambda x, p: 2 * x, lambda x, p: 2 * p)
    found = follow(small, np.array([0.1]), 0.0, (-2.0, 2.0), upwards=True)
    ways = [step.tangent for step in found.points if not step.fold]
    bends = [one.along(1.0, other.state, other.parameter) for one, other in pairwise(ways)]
    assert min(bends) == approx(0.95, rel=0, abs=0.05)


# -- a bearing whose traction falls with slip -------------------------------------------------------


def falling(load, **changes):
    return paper_bearing(traction=lambda **pair: FALLING, oil_fraction=0.3, load=load, **changes)


@cache
def branch():
    return trace(falling(SPAN[0]), span=SPAN)


@cache
def three():
    return equilibria_at(falling(WITHIN))


def jump(loads):
    """The two loads between which warm-started solves jump to another slip."""
    slips, found = [], None
    for load in loads:
        found = falling(load).solve(found)
        slips.append(found.cage_slip)
    place = np.abs(np.diff(np.log(slips))).argmax()
    assert abs(log(slips[place + 1] / slips[place])) > 2
    return sorted(loads[place : place + 2])


@pytest.mark.slow
def test_slip_follows_an_s_over_load_through_two_folds():
    found = branch()
    assert found.end is BranchEnd.RANGE_LEFT
    assert (found.values[0], found.values[-1]) == SPAN
    upper, lower = found.folds
    assert upper.slip > lower.slip
    assert upper.value > 2 * lower.value
    assert (np.diff(found.slip) < 0).all()
    assert max(point.equilibrium.residual for point in found.points) < 1e-9


@pytest.mark.slow
def test_folds_are_where_sweeps_over_the_load_jump():
    upper, lower = branch().folds
    close = np.array([0.98, 0.99, 0.995, 1.005, 1.01, 1.02])
    low, high = jump([1500, 2500, 3500, 4500, *close * upper.value])
    assert low < upper.value < high
    low, high = jump([2200, *close[::-1] * lower.value])
    assert low < lower.value < high


@pytest.mark.slow
def test_branch_is_the_same_both_ways():
    back = trace(falling(SPAN[1]), span=SPAN[::-1])
    there = [fold.value for fold in branch().folds]
    assert [fold.value for fold in back.folds[::-1]] == approx(there, rel=1e-10, abs=0)


@pytest.mark.slow
def test_only_the_middle_of_the_s_is_unstable():
    found = branch()
    place = [index for index, point in enumerate(found.points) if point.fold]
    expected = np.ones(len(found.points), bool)
    expected[place[0] : place[1] + 1] = False
    assert (found.stable == expected).all()


@pytest.mark.slow
def test_three_equilibria_between_the_folds():
    slips = [one.cage_slip for one in three()]
    assert slips == approx([0.00264, 0.0159, 0.341], rel=0.01, abs=0)
    for one in three():
        assert one.residual < 1e-10
        assert falling(WITHIN).solve(one).cage_slip == approx(one.cage_slip, rel=1e-8, abs=0)
    along = np.log(branch().values)
    crossings = np.flatnonzero(np.diff(along > log(WITHIN)))
    assert len(crossings) == 3
    for place, slip in zip(crossings, slips[::-1], strict=True):
        assert branch().slip[place + 1] < slip < branch().slip[place]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "without"),
    [("LOAD_RANGE", 1.001), ("_lumped_starts", lambda balance: [])],
    ids=["by lumped rollers", "along the branch"],
)
def test_either_way_of_searching_finds_all_three(monkeypatch, name, without):
    monkeypatch.setattr(quasidynamic.trace, name, without)
    slips = [one.cage_slip for one in equilibria_at(falling(WITHIN))]
    assert slips == approx([one.cage_slip for one in three()], rel=1e-7, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("load", [1500.0, 8000.0], ids=["below", "above"])
def test_one_equilibrium_outside_the_folds(load):
    (only,) = equilibria_at(falling(load))
    assert only.residual < 1e-10


def after_a_while(one, slip_change, time_steps):
    """Cage slips of linearly implicit Euler steps from a state whose cage was slowed."""
    balance, bearing = one.balance, one.balance.roller.bearing
    orbiting = bearing.cage.mass + bearing.rollers * bearing.roller.mass
    inertias = bearing.roller.inertia, orbiting * (bearing.pitch_diameter / 2) ** 2
    scale = (balance.scales.unknown / balance.scales.residual)[0, [balance.layout.field(-1).start, CAGE]]
    state, slips = one.scaled[None].copy(), []
    state[0, CAGE] -= slip_change
    for time_step in time_steps:
        system, shift = balance.evaluate(state), bordered_system.Shift(*(inertias * scale / time_step))
        change = -bordered_system.solve(balance, system, system.residual[..., None], shift)[..., 0]
        state = bounded(balance, state, state + change)
        slips.append(-state[0, CAGE])
    return np.array(slips)


def growth(one):
    nearest = min(branch().points, key=lambda point: abs(point.slip - one.cage_slip))
    return replace(nearest, equilibrium=one).growth


@pytest.mark.slow
@pytest.mark.parametrize("which", range(3), ids=["rolling", "middle", "slipping"])
def test_disturbance_grows_or_decays_at_the_rate_of_the_eigenvalue(which):
    one = three()[which]
    rate = growth(one)
    time_step = 0.1 / abs(rate)
    slips = after_a_while(one, 1e-6 * one.cage_slip, [time_step] * 30)
    apart = slips - one.cage_slip
    # What a step of the implicit Euler method makes of exp(rate t), once all else has decayed.
    assert apart[20:] / apart[19:-1] == approx(1 / (1 - rate * time_step), rel=2e-3, abs=0)
    assert (rate < 0) == (which != 1)


@pytest.mark.slow
@pytest.mark.parametrize(("slowed", "where"), [(-1e-4, 0), (1e-4, 2)], ids=["faster", "slower"])
def test_bearing_leaves_the_unstable_equilibrium_for_a_stable_one(slowed, where):
    slips = after_a_while(three()[1], slowed, [5e-5] * 80 + [1e-3] * 80)
    assert slips[-1] == approx(three()[where].cage_slip, rel=1e-2, abs=0)


@pytest.mark.slow
def test_branch_comes_back_to_the_load_where_it_began():
    found = trace(falling(WITHIN), span=(WITHIN, 6000.0), start=three()[2])
    assert found.end is BranchEnd.RANGE_LEFT
    assert found.values[-1] == WITHIN
    assert len(found.folds) == 1
    assert found.points[0].slip == approx(three()[2].cage_slip, rel=1e-8, abs=0)
    assert found.points[-1].slip == approx(three()[1].cage_slip, rel=1e-8, abs=0)


@pytest.mark.slow
def test_speed_has_folds_too():
    found = trace(falling(WITHIN), over="inner_speed", span=(-20000 * RPM, -95000 * RPM))
    assert found.end is BranchEnd.RANGE_LEFT
    (upper, lower), here = found.folds, -38000 * RPM
    assert upper.value < here < lower.value < 0
    assert found.values[-1] == -95000 * RPM
    speeds = [point.equilibrium.balance.points.inner_speed[0, 0] for point in found.points]
    assert speeds == approx(found.values, rel=1e-12, abs=0)


# -- a bearing whose traction does not --------------------------------------------------------------


@pytest.mark.slow
def test_without_falling_traction_there_is_one_stable_branch():
    found = trace(paper_bearing(), span=(100.0, 20000.0))
    assert found.end is BranchEnd.RANGE_LEFT
    assert (found.values[0], found.values[-1]) == (100.0, 20000.0)
    assert found.folds == ()
    assert found.stable.all()
    assert (np.diff(found.values) > 0).all()
    assert (np.diff(found.largest_load) > 0).all()
    middle = found.points[len(found.points) // 2]
    plain = paper_bearing(load=middle.value).solve()
    assert middle.slip == approx(plain.cage_slip, rel=1e-7, abs=0)
    assert middle.largest_load == approx(plain.loads[0].max(), rel=1e-9, abs=0)


@pytest.mark.slow
def test_corners_of_a_tilted_bearing_are_passed():
    """Edge by edge, tilted rollers come into contact; the ring turns off at each."""
    found = trace(falling(WITHIN, moment=5.0), over="inner_speed", span=(55000 * RPM, 75000 * RPM))
    assert found.end is BranchEnd.RANGE_LEFT
    assert found.values[-1] == 75000 * RPM


@pytest.mark.parametrize(
    ("over", "span", "words"),
    [
        ("radial_load", (0.0, 100.0), "of one sign"),
        ("radial_load", (100.0, 100.0), "not the same"),
        ("radial_load", (-100.0, -10.0), "positive"),
        ("radial_load", (10.0, float("inf")), "of one sign"),
        ("inner_speed", (-100.0, 100.0), "of one sign"),
        ("inner_speed", (50.0, 200.0), "outer speed"),
        ("moment", (1.0, 2.0), "radial_load or inner_speed"),
    ],
)
def test_span_without_sense_is_refused(over, span, words):
    with pytest.raises(OutOfRange, match=words):
        trace(paper_bearing(outer_speed=100.0), over=over, span=span)


def test_bearing_without_load_is_refused():
    with pytest.raises(OutOfRange, match="0 to 0"):
        equilibria_at(falling(0.0))
