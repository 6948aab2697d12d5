"""Balance of balls in a cage, found by the speed of the cage."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.solve.balls.coulomb_control import CoulombControl
from quasidynamic.solve.balls.inertia_homotopy import BudgetSpent
from quasidynamic.solve.balls.ring_newton import ANSWERED, BUDGET, RingSolution, newton, solution_at

FIRST_STEP = 0.01  # of the speed of the rings: first step of a cage from rolling; the next are longer
STARTS = (1.0, 0.995, 0.95, 0.7)  # of the speed of rolling, of which the first with a balance is taken
LEAST_STEP = 1e-4  # the same of shorter ones, where balls have no balance
SLOW = 1e-3  # of the same: speed from which a cage may turn round
CLOSE = 0.1  # of the speed of a cage: step by which its balls move as by closed forms
STRAIGHT = 0.3  # of the same: how far two balances may be from each other that a third is extrapolated from
FURTHEST = 1.5  # of that distance: how far beyond
SPEEDS = 24  # of a cage at least that four times the budget of other searches is for; the first takes two
NEARLY = 1e-8  # of the torques around a cage: what is left where all may be in balance
SPEED_ERROR = 1e-13  # of the speed of the rings
TRIED = (0.02, 1.1, 16)  # of the speed of rolling: first, last and number of those tried for several motions

Solve = Callable[[AngularBalance], RingSolution]
Places = tuple[NDArray, Vectors]  # of ring (1, 5) and balls (1, Z)


def by_cage_speed(balance: AngularBalance, solve: Solve) -> tuple[RingSolution | None, int]:
    r"""Balance of one case by the speed of its only cage, else None, and evaluations.

    .. math:: M(\omega_c) = \sum_j M_{pj} + M_{land} = 0

    At a given speed of the cage balls have the centrifugal force of that speed and are in balance one by one:
    from rolling down to rest the place of the ring is a smooth function of it, also where that place turns
    back, as balls that become faster push the ring away. M drives a cage at rest and brakes one that rolls,
    but where a land does more: with one sign on either side there is a balance between.

    `solve` gives the balance by closed forms, which Newton's method at a speed of the cage begins with.

    Source
    ------
    A fold passed by a parameter that it does not turn back in, as in Allgower and Georg, Introduction to
    Numerical Continuation Methods (2003), ch. 6; the zero by Brent's method.
    """
    held = HeldCage(balance, solve)
    try:
        speed, torque = held.begin()
        step, growth = FIRST_STEP, 5.0
        while step > LEAST_STEP:
            upward = max(CLOSE * abs(speed), FIRST_STEP)  # where a cage that rolls is not far
            further = speed + (min(step, upward) if torque > 0 else -step)
            if further * speed < 0 and abs(speed) > SLOW:
                further = speed / 5
            there = held.torque(further)
            if there * torque < 0:
                return held.balanced_between(*sorted((speed, further))), held.evaluations
            if np.isfinite(there):
                speed, torque, step = further, there, growth * step
            else:
                step, growth = abs(further - speed) / 4, 2.0
    except _Balanced as balanced:
        return balanced.solution, held.evaluations
    except (_Lost, BudgetSpent):
        pass
    return None, held.evaluations


def motions_by_cage_speed(balance: AngularBalance, solve: Solve) -> list[RingSolution]:
    """Stable balances of one case at speeds of its only cage, the slowest first.

    They are those where M, see `by_cage_speed`, drives a slower cage and brakes a faster one; two that are
    closer than the speeds that are tried are missed.
    """
    held = HeldCage(balance, solve)
    found, slower = list[RingSolution](), (0.0, np.nan)
    try:
        for speed in np.sort(held.rolling * np.linspace(*TRIED)):
            try:
                torque = held.torque(float(speed))
            except _Balanced as balanced:
                found.append(balanced.solution)
                continue
            if torque < 0 < slower[1]:
                solution = held.balanced_between(slower[0], speed)
                found += [] if solution is None else [solution]
            slower = speed, torque
    except BudgetSpent:
        pass
    return found


class _Lost(Exception):
    """Ring and balls have no known balance at a speed of the cage."""

    def __init__(self, speed: float):
        self.speed = speed


class _Balanced(Exception):
    """A cage of the speed that was tried is in balance, too."""

    def __init__(self, solution: RingSolution):
        self.solution = solution


class HeldCage:
    """One case at speeds of its cage that are given, over that of the inner against the outer ring."""

    def __init__(self, balance: AngularBalance, solve: Solve):
        assert isinstance(balance.control, CoulombControl)
        self.balance, self.control, self.solve = balance, balance.control, solve
        self.evaluations = 0
        self.ahead = (balance.speeds[0] - balance.speeds[1]).item()
        self.known: dict[float, tuple[RingSolution, RingSolution]] = {}  # balances, the same of closed forms
        self.torques: dict[float, float] = {}
        self.simpler = replace(balance, control=self.control.simpler)
        balls, _ = self._closed(1.0).forces(self.simpler)
        load, orbit = balls.loads.min(0), balls.kinematics.orbit
        self.rolling = float(np.average(orbit, weights=load if load.any() else None)) / self.ahead

    def torque(self, speed: float) -> float:
        """M over the sum of the torques on rings and pockets; not a number without a balance of the balls.

        Raises `_Balanced` where M vanishes, `BudgetSpent`.
        """
        if speed not in self.torques:
            solution = self._solved(speed)
            if solution is None:
                return np.nan
            self.torques[speed] = self._left(solution, speed)
        return self.torques[speed]

    def balanced_between(self, low: float, high: float) -> RingSolution | None:
        """Balance between two speeds of opposite M; None where ring and balls have none on the way.

        A balance that is not found is approached from the nearest one, which may bring the zero closer, too.
        """
        from scipy.optimize import brentq  # takes long to load, for a search that few bearings need

        while True:
            speeds = [speed for speed in sorted(self.torques) if low <= speed <= high]
            turns = np.flatnonzero(np.diff(np.sign([self.torques[speed] for speed in speeds])))
            first = int(turns[0])
            try:
                brentq(self._known_torque, speeds[first], speeds[first + 1], xtol=SPEED_ERROR)
                return None  # what is left there is no balance of all
            except _Balanced as balanced:
                return balanced.solution
            except _Lost as lost:
                if not self._approached(lost.speed):
                    return None

    def _approached(self, speed: float) -> bool:
        """Whether another balance is found on the way to a speed; equal steps go on up to a zero of M."""
        at = self._nearest(speed)[0]
        step, before = (speed - at) / 4, self.torques[at]
        while not np.isfinite(torque := self.torque(at + step)):
            step /= 4
            if abs(step) < LEAST_STEP:
                return False
        at += step
        while torque * before > 0 and abs(speed - at) > abs(step):
            at += step
            torque = self.torque(at)
        return True

    def _known_torque(self, speed: float) -> float:
        if not np.isfinite(torque := self.torque(speed)):
            raise _Lost(speed)
        return torque

    def begin(self) -> tuple[float, float]:
        """A speed near that of rolling, and M; raises `_Lost` without a balance of the balls there."""
        for part in STARTS:
            if np.isfinite(torque := self.torque(part * self.rolling)):
                return part * self.rolling, torque
        raise _Lost(self.rolling)

    def _left(self, solution: RingSolution, speed: float) -> float:
        control = replace(self.control, cage_speed=speed)
        balance = replace(self.balance, control=control)
        balls, _ = solution.forces(balance)
        oil = control.oiled(balls.contacts, balance.speeds, balance.free_centrifugal, solution.near)
        pitch = balance.bearing.pitch_diameter / 2
        size = np.abs(oil.ring_torque).sum() + pitch * np.abs(oil.pocket_force).sum()
        left = float((oil.land_torque - oil.pocket_torque).sum() / size)
        if abs(left) <= NEARLY:
            self.evaluations += 1
            free = solution_at(
                self.balance, (solution.ring, solution.centres), self.evaluations, solution.near
            )
            if free.outcomes[0] in ANSWERED:
                raise _Balanced(free)
        return np.sign(self.ahead) * left

    def _solved(self, speed: float) -> RingSolution | None:
        """Balance at a speed."""
        closed = self._closed(abs(speed / self.rolling))
        balance, near = replace(self.balance, control=replace(self.control, cage_speed=speed)), None
        if self.known:
            near = self.known[self._nearest(speed)[0]][0].near
        for start in self._starts(speed, closed):
            if self.evaluations >= (budget := 4 * BUDGET // balance.control.cost):
                raise BudgetSpent
            share = SPEEDS if self.known else SPEEDS // 2
            solution = newton(balance, *start, near, budget=budget // share)
            self.evaluations += int(solution.evaluations[0])
            if solution.outcomes[0] in ANSWERED:
                self.known[speed] = solution, closed
                return solution
        return None

    def _starts(self, speed: float, closed: RingSolution) -> list[Places]:
        """Places from known balances, or from that by closed forms for slower rings."""
        at_rest = (closed.ring, closed.centres)
        if not self.known:
            return [at_rest]
        first, *others = self._nearest(speed)
        near, like = self.known[first]
        starts = [at_rest, (near.ring, near.centres)]
        if abs(first - speed) <= CLOSE * abs(speed):
            moved = closed.ring - like.ring, closed.centres - like.centres
            starts.insert(0, (near.ring + moved[0], near.centres + moved[1]))
        if others and abs(first - others[0]) <= STRAIGHT * abs(speed):
            steps, other = (speed - first) / (first - others[0]), self.known[others[0]][0]
            if abs(steps) <= FURTHEST:
                moved = near.ring - other.ring, near.centres - other.centres
                starts.insert(0, (near.ring + steps * moved[0], near.centres + steps * moved[1]))
        return starts

    def _nearest(self, speed: float) -> list[float]:
        """Speeds of known balances, the nearest first."""
        return sorted(self.known, key=lambda known: abs(known - speed))

    def _closed(self, part: float) -> RingSolution:
        """Balance of rings at a part of their speed, of balls by closed forms."""
        return self.solve(replace(self.simpler, speeds=part * self.balance.speeds))
