"""Newton's method for a ring on balls that find their own balance."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.angular import AngularBalance, BallBalance, RingBalance
from quasidynamic.contact.point import in_series
from quasidynamic.solve.endings import Ending

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
BALL_TOLERANCE = 1e-12  # the same for a ball, whose balance the ring relies on
ROUNDING = 16 * np.finfo(float).eps  # of lengths: a force below stiffness times this is noise
LIMIT = 60  # Newton steps of the ring, rarely more than ten
BALL_LIMIT = 60  # evaluations of the balls at one place of the ring, rarely more than four
LOOSE = 0.1  # of the imbalance before a step: what the balls may leave to the next one
SHORTEST = 2.0**-12  # part of a Newton step
LONGEST = 0.3  # of the smaller reach: step of a ball or of the ring
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no ball resists a direction
TOUCHING = 10 * TOLERANCE  # of the largest force: least load that counts as contact of the ring
SINGULAR = 1e-12  # of the whole stiffness: a direction that nothing holds
FLOATING = 1e-12  # of the largest stiffness, given to balls that touch nothing
LEAST_STIFFNESS = 1e-9  # [N/m] the same where no ball touches anything
FIRST_INERTIA, LEAST_INERTIA = 0.25, 1e-3  # steps of the inertia from rest, where a cold start fails


@dataclass(frozen=True)
class Solved:
    """Places of ring and balls, and how the search ended; C cases, Z balls."""

    ring: NDArray  # (C, 5) [m] rotations times R_i
    centres: NDArray  # (C, Z, 2) [m] from the outer groove centres
    endings: list[Ending]
    imbalance: NDArray  # (C) largest unbalanced force over the largest force
    evaluations: NDArray  # (C) of all balls


@dataclass
class _State:
    """One place of the ring with balls in balance."""

    ring: NDArray
    centres: NDArray
    late: NDArray  # (C, Z, 2) [m] what the balls still have to move
    balls: BallBalance
    follow: NDArray  # (C, Z, 2, 2)
    balance: RingBalance
    settled: NDArray  # (C) bool
    imbalance: NDArray  # (C)
    pressing: NDArray  # (C) largest load on the inner race over the largest force
    evaluations: int


def solve(balance: AngularBalance) -> Solved:
    """Balance of all cases: from rest in one go, else with inertia that grows step by step."""
    with np.errstate(all="ignore"):  # places tried on the way may overflow: such a step is not taken
        return _solve(balance)


def _solve(balance: AngularBalance) -> Solved:
    found = newton(balance, first_place(balance))
    failed = np.flatnonzero(
        [ending not in (Ending.CONVERGED, Ending.UNDETERMINED) for ending in found.endings]
    )
    if not len(failed):
        return found
    endings, pieces = list(found.endings), {}
    for case in failed:
        pieces[case] = from_rest(balance.take(np.array([case])))
        endings[case] = pieces[case].endings[0]
    arrays = [found.ring, found.centres, found.imbalance, found.evaluations]
    for case, piece in pieces.items():
        new = [piece.ring, piece.centres, piece.imbalance, found.evaluations[case] + piece.evaluations]
        for array, value in zip(arrays, new, strict=True):
            array[case] = value[0]
    return Solved(found.ring, found.centres, endings, found.imbalance, found.evaluations)


def from_rest(balance: AngularBalance) -> Solved:
    """One case, followed from the static balance while inertia grows to its full size."""
    here = newton(replace(balance, inertia=0.0), first_place(balance))
    inertia, step, count = 0.0, FIRST_INERTIA, here.evaluations
    if here.endings[0] is not Ending.CONVERGED:
        return here
    while inertia < 1.0:
        trial = min(inertia + step, 1.0)
        there = newton(replace(balance, inertia=trial), here.ring, here.centres)
        count = count + there.evaluations
        if there.endings[0] is Ending.CONVERGED:
            here, inertia, step = there, trial, 2 * step
        elif step > LEAST_INERTIA:
            step /= 4
        else:
            return replace(there, evaluations=count)
    return replace(here, evaluations=count)


def first_place(balance: AngularBalance) -> NDArray:
    """Ring displacements (C, 5) near the static ones: each load acts alone on the nearest balls."""
    own = balance.bearing
    apart, sine = own.inner_reach + own.outer_reach, max(np.sin(own.contact_angle), 0.3)
    cosine = np.cos(own.contact_angle)

    def approach(load: NDArray) -> NDArray:
        return (np.abs(load) / own.balls / in_series(*balance.contacts)) ** (2 / 3)

    load, place = balance.load, np.zeros_like(balance.load)
    radial = np.sqrt((load[:, :2] ** 2).sum(1, keepdims=True))
    place[:, :2] = approach(4.4 * radial / cosine) / cosine * load[:, :2] / np.maximum(radial, 1e-300)
    axial = apart + approach(load[:, 2] / sine)
    stretch = np.sqrt(axial**2 - (apart * cosine) ** 2) - apart * np.sin(own.contact_angle)
    place[:, 2] = np.sign(load[:, 2]) * stretch
    place[:, 3:] = np.sign(load[:, 3:]) * approach(4.4 * load[:, 3:] / sine) / sine
    return np.where(balance.held, balance.place, place)


def newton(balance: AngularBalance, ring: NDArray, centres: NDArray | None = None) -> Solved:
    """Damped Newton on the ring, all cases side by side; a case leaves as soon as it ends."""
    if centres is None:
        centres = balance.resting(balance.grooves(ring))
    size = len(ring)
    out_ring, out_centres = ring.copy(), centres.copy()
    endings, imbalance, evaluations = [Ending.NONE] * size, np.full(size, np.inf), np.zeros(size, int)
    cases, here = np.arange(size), _state(balance, ring, centres, LOOSE)
    evaluations += here.evaluations
    damping = np.ones(size)
    for number in range(LIMIT + 1):
        ended = [_ending(balance, here, k, damping[k], number == LIMIT) for k in range(len(cases))]
        for k, case in enumerate(cases):
            out_ring[case], out_centres[case] = here.ring[k], here.centres[k]
            endings[case], imbalance[case] = ended[k], here.imbalance[k]
        running = np.array([ending is Ending.NONE for ending in ended])
        if not running.any():
            break
        if not running.all():
            cases, balance, damping = cases[running], balance.take(running), damping[running]
            here = _taken(here, running)
        here, damping, count = _moved(balance, here)
        evaluations[cases] += count
    return Solved(out_ring, out_centres, endings, imbalance, evaluations)


def _ending(balance: AngularBalance, here: _State, case: int, damping: float, last: bool) -> Ending:
    if not np.isfinite(here.imbalance[case]):
        return Ending.NOT_FINITE
    if here.settled[case] and here.imbalance[case] <= TOLERANCE:
        return Ending.CONVERGED if _held(balance, here, case) else Ending.UNDETERMINED
    if damping < SHORTEST or not here.settled[case]:
        return Ending.STALLED
    return Ending.LIMIT if last else Ending.NONE


def _held(balance: AngularBalance, here: _State, case: int) -> bool:
    """Whether balls hold the ring in every direction in which it is free."""
    free = ~balance.held[case]
    if not free.any():
        return True
    sizes = np.linalg.svd(here.balance.stiffness[case][np.ix_(free, free)], compute_uv=False)
    touching = here.pressing[case] > TOUCHING
    return bool(touching and sizes.min() > SINGULAR * sizes.max())


def _ring_step(balance: AngularBalance, here: _State) -> NDArray:
    """Newton step (C, 5), stiffer where nothing resists as long as forces are out of balance."""
    matrix = here.balance.stiffness.copy()
    whole = np.abs(np.trace(matrix, axis1=1, axis2=2))
    stiffer = STIFFENING * np.minimum(here.imbalance, 1.0) * whole + np.finfo(float).tiny
    matrix = np.where(balance.held[:, :, None] | balance.held[:, None, :], 0.0, matrix)
    diagonal = np.where(balance.held, np.maximum(whole, 1.0)[:, None], stiffer[:, None])
    matrix = matrix + diagonal[:, :, None] * np.eye(5)
    step = np.linalg.solve(matrix, here.balance.excess[..., None])[..., 0]
    longest = LONGEST * min(balance.bearing.inner_reach, balance.bearing.outer_reach)
    return step / np.maximum(np.abs(step).max(1, keepdims=True) / longest, 1.0)


def _moved(balance: AngularBalance, here: _State) -> tuple[_State, NDArray, int]:
    """State after a Newton step; where it fails, balls are brought into balance and the step is halved."""
    step, damping = _ring_step(balance, here), np.ones(len(here.ring))
    there, good = _tried(balance, here, step, damping, LOOSE * here.imbalance)
    count = there.evaluations
    if not good.all():
        here = _state(balance, here.ring, here.centres, 0.0)
        step, count = _ring_step(balance, here), count + here.evaluations
    while not good.all() and (damping[~good] >= SHORTEST).any():
        there, good = _tried(balance, here, step, damping, 0.0)
        count += there.evaluations
        damping = np.where(good, damping, damping / 2)
    return there, damping, count


def _tried(
    balance: AngularBalance, here: _State, step: NDArray, damping: NDArray, share: NDArray | float
) -> tuple[_State, NDArray]:
    """State after a damped step, and the cases in which it does not run far past the balance on its way."""
    ring = here.ring + damping[:, None] * step
    shift = (balance.grooves(ring) - balance.grooves(here.ring))[..., None]
    moved = damping[:, None, None] * here.late + (here.follow @ shift)[..., 0]
    there = _state(balance, ring, _along_arc(here.centres, moved), share)
    ahead, left = (here.balance.excess * step).sum(1), (there.balance.excess * step).sum(1)
    good = (left >= -0.5 * np.abs(ahead)) | (there.imbalance < 0.5 * here.imbalance)
    return there, good & there.settled


def _taken(state: _State, cases: NDArray) -> _State:
    """Part of the cases; of the forces only what the next step needs."""
    ring = RingBalance(*(array[cases] for array in state.balance))
    return replace(
        state,
        ring=state.ring[cases],
        centres=state.centres[cases],
        late=state.late[cases],
        follow=state.follow[cases],
        balance=ring,
        settled=state.settled[cases],
        imbalance=state.imbalance[cases],
        pressing=state.pressing[cases],
    )


def _state(balance: AngularBalance, ring: NDArray, centres: NDArray, share: NDArray | float) -> _State:
    """Ring at a place, balls in balance up to a share of the largest force."""
    grooves = balance.grooves(ring)
    centres, balls, settled, count = settle(balance, grooves, centres, share)
    inverse = _inverse(balls.by_ball)
    forces = balance.ring(balls, -inverse @ balls.by_groove)
    off = -(inverse @ balls.excess[..., None])[..., 0]
    missed = (balance.ball_to_ring @ balls.ring_by_ball @ off[..., None])[..., 0].sum(1)
    excess = np.where(balance.held, 0.0, forces.excess - missed)
    largest = np.maximum(_largest_force(balance, balls), _noise(balls, grooves) / TOLERANCE)
    largest = np.maximum(largest, np.finfo(float).tiny)
    pressing = balls.loads[0].max(1) / largest
    worst = np.maximum(np.abs(excess).max(1), np.abs(balls.excess).max((1, 2)))
    forces = forces._replace(excess=excess)
    follow = -inverse @ balls.by_groove
    return _State(ring, centres, off, balls, follow, forces, settled, worst / largest, pressing, count)


def followed(balls: BallBalance) -> NDArray:
    """Place of a ball per place of its inner groove (C, Z, 2, 2) [-], by implicit differentiation."""
    return -_inverse(balls.by_ball) @ balls.by_groove


def settle(
    balance: AngularBalance, grooves: NDArray, centres: NDArray, share: NDArray | float = 0.0
) -> tuple[NDArray, BallBalance, NDArray, int]:
    """Balance of every ball for itself, the groove centres given.

    Balls may stay out of balance by a `share` (C) of the largest force. Returns their places, forces,
    which cases are balanced (C) and the number of evaluations.
    """
    centres = _start(balance, grooves, centres)
    here, count = balance.balls(grooves, centres), 1
    far = (np.abs(here.excess).max(-1) > balance.free_centrifugal) & (balance.free_centrifugal > 0)
    if far.any():  # where they were is no better than a closed form
        centres = np.where(far[..., None], balance.resting(grooves), centres)
        here, count = balance.balls(grooves, centres), 2
    step, damping = _ball_step(balance, here), np.ones(centres.shape[:2])
    ahead, size = (here.excess * step).sum(-1), np.abs(here.excess).max(-1)
    moving, complete = size > _allowed(balance, here, grooves, share), True
    while moving.any() and count < BALL_LIMIT and not (damping < SHORTEST).any():
        trial = _along_arc(centres, np.where(moving, damping, 0.0)[..., None] * step)
        there, count = balance.balls(grooves, trial), count + 1
        left, new_size = (there.excess * step).sum(-1), np.abs(there.excess).max(-1)
        good = (left >= -0.5 * np.abs(ahead)) | (new_size < 0.5 * size)
        complete, here = bool(good.all()), there
        centres = np.where(good[..., None], trial, centres)
        step = np.where(good[..., None], _ball_step(balance, there), step)
        ahead = np.where(good, (there.excess * step).sum(-1), ahead)
        size = np.where(good, new_size, size)
        damping = np.where(good, 1.0, damping / 2)
        moving = ~good | ~(size <= _allowed(balance, there, grooves, share))
    if not complete:
        here, count = balance.balls(grooves, centres), count + 1
    return centres, here, ~moving.any(1), count


def _start(balance: AngularBalance, grooves: NDArray, centres: NDArray) -> NDArray:
    """Balance of balls where it has a closed form, elsewhere where they were."""
    at_rest = balance.free_centrifugal == 0
    if at_rest.any():
        centres = np.where(at_rest[..., None], balance.resting(grooves), centres)
    lying, free = balance.lying(grooves)
    return np.where(free[..., None], lying, centres)


def _along_arc(centres: NDArray, step: NDArray) -> NDArray:
    """Centres moved by a step whose part along the outer groove follows its arc."""
    length = np.sqrt((centres**2).sum(-1))
    out = centres / length[..., None]
    along = np.stack([out[..., 1], -out[..., 0]], axis=-1)
    angle = ((step * along).sum(-1) / length)[..., None]
    longer = (length + (step * out).sum(-1))[..., None]
    return longer * (np.cos(angle) * out + np.sin(angle) * along)


def _ball_step(balance: AngularBalance, here: BallBalance) -> NDArray:
    step = -(_inverse(here.by_ball) @ here.excess[..., None])[..., 0]
    longest = LONGEST * min(balance.bearing.inner_reach, balance.bearing.outer_reach)
    return step / np.maximum(np.abs(step).max(-1, keepdims=True) / longest, 1.0)


def _inverse(matrix: NDArray) -> NDArray:
    """Inverse (..., 2, 2) of matrices that are negative where a ball is held, lightly held elsewhere."""
    floating = FLOATING * np.abs(matrix).max() + LEAST_STIFFNESS
    a, b = matrix[..., 0, 0] - floating, matrix[..., 0, 1]
    c, d = matrix[..., 1, 0], matrix[..., 1, 1] - floating
    inverse = np.stack([d, -b, -c, a], axis=-1) / (a * d - b * c)[..., None]
    return inverse.reshape(matrix.shape)


def _largest_force(balance: AngularBalance, balls: BallBalance) -> NDArray:
    return np.maximum(np.abs(balance.load).max(1), balls.loads.max((0, 2)))


def _allowed(
    balance: AngularBalance, balls: BallBalance, grooves: NDArray, share: NDArray | float
) -> NDArray:
    """Force (C, 1) on a ball that counts as balance."""
    largest = np.maximum(BALL_TOLERANCE, share) * _largest_force(balance, balls)
    return np.maximum(largest, _noise(balls, grooves))[:, None]


def _noise(balls: BallBalance, grooves: NDArray) -> NDArray:
    """Force (C) by which rounding of lengths unbalances a ball."""
    return ROUNDING * np.abs(balls.by_ball).max((1, 2, 3)) * np.abs(grooves).max((1, 2))
