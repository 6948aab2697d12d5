"""Newton's method for balls in oil and the speed of the cage that they share."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.caged_ball import Cages
from quasidynamic.balance.balls.free_ball import OILED, FreeBallBalance, FreeBalls
from quasidynamic.contact.ellipse.general_sliding import COARSE
from quasidynamic.motion.ball_slip import ORBIT
from quasidynamic.solve.balls.free_ball_search import (
    COARSE_TOLERANCE,
    ONE_STEP_AWAY,
    FreeBallMotion,
    Nearby,
    free_ball_motion,
    least_heat,
    motion_at,
    searched,
    searched_again,
)

LIMIT = 40  # speeds of a cage that are tried, rarely more than four
LONGEST = 0.05  # of the speed of the rings: step of the cage
NEAR = 1e-4  # of the speed of the rings: step of the cage from which steps of all together follow
LAST_STEPS = 4  # rarely more than one
STEPS = 12  # of all together, rarely more than three
TWO_STEPS_AWAY = 1e-4  # of the largest friction, of the speed: what is left before the last but one step
TINY = 1e-300  # [N m] slope of the balance of a cage that nothing moves


class _CageStep(NamedTuple):
    """Newton step of cages and balls together."""

    unbalanced: NDArray  # (G) [N m] torque on the cages
    left: NDArray  # (G) [-] the same over the torque of pockets and of the largest friction
    cage: NDArray  # (G) [-]
    balls: NDArray  # (N, 4) what balls move then
    follow: NDArray  # (N, 4) what they move with the cage


def caged_ball_motion(
    balls: FreeBalls,
    cages: Cages,
    nearby: Nearby | None,
    near: NDArray | None = None,
    held: float | None = None,
) -> FreeBallMotion:
    r"""Balance of balls and of their cages, see `Pockets`.

    .. math:: \sum_j \left(\frac{d_m}{2} F_j + M_{pj} \cdot e_x\right)(\omega_c) + M_{land}(\omega_c) = 0

    Both parts fall as the cage becomes faster: it has one speed, which lies between those that are too fast
    and too slow. Balls that are balanced at every speed on the way, with few points in their contacts, lead
    near it, though one that was lost at a speed is not sought as widely at the next; then all are balanced
    together. Unknowns and speeds of the cage that are `near` (N, 5) are tried
    first, see `free_ball_motion`. A ball that finds no balance does not push its cage.
    At a speed of the cage that is `held` [-] balls are in balance one by one, and the cage need not be.

    Slopes are those at a speed of the cage that is given: what one ball does to the others by way of the
    cage is left out.

    Where traction falls with the slip the torque on a cage may grow with its speed: a cage that is not near
    its balance then goes on towards it, and has none where that does not end.

    Source
    ------
    Balance of the moments on a cage as in `land_torque` and `Pockets`; balls eliminated one by one.
    """
    balls, base = on_base(balls, cages)
    if held is not None:
        speed = (held - base)[cages.of_ball]
        balls = balls.in_cage(speed)
        starts = [_with_cage(balls)] if near is None else [near[:, :4], _with_cage(balls)]
        return free_ball_motion(balls, nearby, *starts)._replace(cage=speed)
    cages = replace(cages, base=base)
    count, anew = len(cages.ring_speed), np.full(len(cages.of_ball), True)
    speed, unknowns = np.zeros(count), np.zeros((len(anew), 4))
    if near is not None:
        first = np.unique(cages.of_ball, return_index=True)[1]
        speed, unknowns, lost = _together(balls, cages, near[first, 4], near[:, :4])
        anew = np.isin(cages.of_ball, cages.of_ball[lost])
    if anew.any():
        numbers = np.unique(cages.of_ball[anew])
        speed[numbers], unknowns[anew] = _searched(balls.taken(anew), cages.taken(anew))

    cage_left, balanced = np.zeros(count), np.full(len(anew), False)

    def with_cage(some: FreeBalls, state: FreeBallBalance, unknowns: NDArray) -> NDArray:
        nonlocal speed, cage_left
        step = _step(some, state, cages, speed, unknowns)
        speed, cage_left = speed + step.cage, step.left
        return step.balls

    for _ in range(LAST_STEPS):
        some = balls.in_cage(speed[cages.of_ball])
        solution, left, unknowns = motion_at(some, unknowns, nearby, with_cage)
        balanced = (left <= ONE_STEP_AWAY) & (cage_left <= ONE_STEP_AWAY)[cages.of_ball]
        if balanced.all():
            break
    solution = solution._replace(cage=speed[cages.of_ball])
    for array in solution:
        array[~balanced] = np.nan
    return solution


def _with_cage(balls: FreeBalls) -> NDArray:
    """Unknowns (N, 4) of balls that orbit with their cage, and slip on the race that presses them less."""
    pockets = balls.oil and balls.oil.pockets
    assert pockets is not None
    start, by_slip = least_heat(balls), balls.unknowns[:, ORBIT]
    one, light = np.arange(len(start)), balls.ellipse.traction.argmin(1)
    lead = pockets.lead(balls.rolling[:, ORBIT], np.einsum("nj,nj->n", by_slip, start))
    start[one, light] += lead / by_slip[one, light]
    return start


def on_base(balls: FreeBalls, cages: Cages) -> tuple[FreeBalls, NDArray]:
    """Balls with speeds of cages counted from a base, and the base (G) [-]: their mean by load in rolling."""
    load = balls.ellipse.traction.min(1)
    rolling = balls.outer_speed - balls.rolling[:, ORBIT]
    base = cages.summed(load * rolling) / cages.summed(load)
    return balls.from_base(base[cages.of_ball]), base


def _searched(balls: FreeBalls, cages: Cages) -> tuple[NDArray, NDArray]:
    """Speeds of the cages (G) and unknowns of the balls (N, 4) most often near a balance."""
    speed, unknowns = _coarse(balls, cages)
    speed, unknowns, lost = _together(balls, cages, speed, unknowns)
    if lost.any():
        some = balls.in_cage(speed[cages.of_ball]).taken(lost)
        unknowns[lost] = searched_again(some, _with_cage(some))
        speed, unknowns, _ = _together(balls, cages, speed, unknowns)
    return speed, unknowns


def _coarse(balls: FreeBalls, cages: Cages) -> tuple[NDArray, NDArray]:
    """Speeds of the cages (G) and unknowns of the balls (N, 4) near the balance, by few points."""
    speed = np.zeros_like(cages.ring_speed)
    slow, fast = np.full_like(speed, -np.inf), np.full_like(speed, np.inf)
    unknowns, found = least_heat(balls), np.full(len(cages.of_ball), True)
    for _ in range(LIMIT):
        some = balls.in_cage(speed[cages.of_ball])
        unknowns, left = searched(some, unknowns, 1.0, (COARSE, COARSE_TOLERANCE))
        lost = found & ~(left <= COARSE_TOLERANCE)
        if lost.any():
            again = some.taken(lost)
            unknowns[lost] = searched_again(again, _with_cage(again), (COARSE, COARSE_TOLERANCE))
        state = some.balance(unknowns, some.friction(unknowns, COARSE))
        found = (np.abs(state.left) / some.scale).max(1) <= COARSE_TOLERANCE
        step = _step(some, state._replace(left=0.0 * state.left), cages, speed, unknowns)
        slow, fast = (
            np.where(step.unbalanced > 0, speed, slow),
            np.where(step.unbalanced < 0, speed, fast),
        )
        move = np.clip(step.cage, -LONGEST, LONGEST)
        beyond = (speed + move <= slow) | (speed + move >= fast)
        move = np.where(beyond & np.isfinite(fast - slow), (slow + fast) / 2 - speed, move)
        speed = speed + move
        unknowns = unknowns + step.follow * move[cages.of_ball, None]
        if (np.abs(move) <= NEAR).all():
            break
    return speed, unknowns


def _together(
    balls: FreeBalls, cages: Cages, speed: NDArray, unknowns: NDArray
) -> tuple[NDArray, NDArray, NDArray]:
    """Speeds (G) and unknowns (N, 4) after Newton steps of all, and balls (N) that are not near a balance."""
    left = np.full(len(unknowns), np.inf)
    for _ in range(STEPS):
        some = balls.in_cage(speed[cages.of_ball])
        state = some.balance(unknowns, some.friction(unknowns))
        step = _step(some, state, cages, speed, unknowns)
        speed, unknowns = speed + step.cage, unknowns + step.balls
        left = (np.abs(state.left) / some.scale).max(1)
        left = np.maximum(left, np.maximum(step.left, np.abs(step.cage))[cages.of_ball])
        if (left <= TWO_STEPS_AWAY).all():
            break
    return speed, unknowns, ~(left <= TWO_STEPS_AWAY)


def _step(
    balls: FreeBalls, state: FreeBallBalance, cages: Cages, speed: NDArray, unknowns: NDArray
) -> _CageStep:
    """Newton step at speeds of the cages (G) and unknowns (N, 4): balls are eliminated one by one."""
    pocket, land = balls.pocket(unknowns), cages.land(cages.base + speed)
    assert pocket is not None  # of balls in cages
    by_cage = np.swapaxes(balls.unknowns, -1, -2) @ pocket.slopes[:, :, [ORBIT]]
    alone, follow = np.moveaxis(-state.resolved(np.concatenate([state.left[..., None], by_cage], -1)), -1, 0)
    by_motion = pocket.slopes[:, [ORBIT]] @ balls.unknowns  # (N, 1, 4) less torque on the cage
    moved, follows = (-(by_motion @ each[..., None])[:, 0, 0] for each in (alone, follow))
    unbalanced = cages.summed(pocket.torque) + land.torque
    slope = cages.summed(follows - pocket.slopes[:, ORBIT, ORBIT]) + land.by_speed
    expected = unbalanced + cages.summed(moved)
    falling = slope < -TINY
    cage = np.where(falling, -expected / np.where(falling, slope, 1.0), LONGEST * np.sign(unbalanced))
    largest = OILED * balls.ellipse.traction.max(1) * balls.contacts.pitch_radius
    size = cages.summed(np.abs(pocket.torque) + largest)
    return _CageStep(
        unbalanced, np.abs(unbalanced) / size, cage, alone + follow * cage[cages.of_ball, None], follow
    )
