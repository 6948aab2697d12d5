"""Newton's method for the motion of balls that friction and inertia alone move."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.free_ball import FreeBallBalance, FreeBalls, gyroscopic
from quasidynamic.contact.ellipse.general_sliding import (
    COARSE,
    FINE,
    ROLL,
    SPIN,
    EllipsePoints,
    sliding_ellipse,
)
from quasidynamic.motion.ball_slip import TURN
from quasidynamic.solve.step_length import shortened

NEAR = 1e-7  # of the largest friction: moments left from which one more Newton step ends in rounding
ROUGH = 1e-4  # the same for the search with few points
LIMIT = 60  # evaluations in one search, rarely more than six
PARTS = (0.0, 0.5, 1.0)  # of the gyroscopic moments, where one search with all of them fails
CAUTION = np.array([0.0, 0.0, 1e-3, 1e-2, 0.1, 1.0, 10.0])  # share of the majorant in one try after the other
LESS = 0.5  # of the work on a step or of the size of what is left: enough gained by a step
NEUTRAL = 0.347**2  # of the fall of the surface to the edge of a contact: lines of rolling without spin
SHARES = (0.01, 0.9)  # of the friction, across
FLAT = 1e-6  # spin by the third unknown below which a race does not see it
LONGEST = 2.0  # of the speeds of the rolling ball: step


def nearly_balanced(balls: FreeBalls) -> NDArray:
    """Unknowns (N, 4) of balls that most often leave less than `NEAR` of the largest friction.

    From whichever control makes the least heat, with few points in the contacts; then one step with all.
    """
    unknowns, _ = _searched(balls, _least_heat(balls), 1.0, (COARSE, ROUGH))
    here = balls.balance(unknowns, balls.friction(unknowns))
    return unknowns - here.resolved(here.left[..., None])[..., 0]


def searched_again(balls: FreeBalls, start: NDArray) -> NDArray:
    """Unknowns (N, 4) with all points; balls that find no balance follow the moments from none to all."""
    found, left = _searched(balls, start, 1.0, (FINE, NEAR))
    lost = ~(left <= NEAR)
    if lost.any():
        some = balls.taken(lost)
        path = _least_heat(some)
        for part in PARTS:
            path, _ = _searched(some, path, part, (FINE, NEAR))
        found[lost] = path
    return found


def _least_heat(balls: FreeBalls) -> NDArray:
    """Unknowns (N, 4) of the start with the least heat."""
    starts = _starts(balls)
    slips = np.array([balls.slip(start) for start in starts])
    heat = sliding_ellipse(slips, balls.ellipse, COARSE).power.sum(-1)
    return starts[heat.argmin(0), np.arange(starts.shape[1])]


def _starts(balls: FreeBalls) -> NDArray:
    """Unknowns (3, N, 4) near rolling without spin on the inner race, on the outer one, with equal ones.

    In both contacts the ball rolls on two lines; across it slips as friction would hold its gyroscopic
    moment were the slip along even: nowhere does the slip vanish all over a contact.
    """
    own, spin, by_unknown = balls.ellipse, balls.base[..., SPIN], balls.by_unknown[..., SPIN, 2]
    by_unknown = np.where(np.abs(by_unknown) > FLAT, by_unknown, np.inf)
    found = np.zeros((3, len(spin), 4))
    found[:2, :, 2] = -(spin / by_unknown).T
    found[2, :, 2] = found[:2, :, 2].mean(0)
    fall = balls.base[..., ROLL] * own.across**2 / (2 * own.radius)
    found[..., :2] = NEUTRAL * fall
    for start in found:
        moment = gyroscopic(balls.motion(start), balls.gyration, balls.outer_speed)[0][:, TURN]
        wanted = moment / (balls.contacts.ball_radius * own.traction.sum(1))
        share = np.clip(np.abs(wanted), *SHARES)
        along = np.abs(fall) + np.abs(balls.slip(start)[..., SPIN]) * own.across
        start[:, 3] = np.sign(wanted) * share / np.sqrt(1 - share**2) * along.min(1) / 2
    return found


def _searched(
    balls: FreeBalls, start: NDArray, part: float, wanted: tuple[EllipsePoints, float]
) -> tuple[NDArray, NDArray]:
    """Unknowns (N, 4) and what is left (N) with a part of the gyroscopic moments.

    Newton steps, shortened where they go too far; where that does not help, steps that a share of the
    majorant of the heat holds back.
    """
    points, tolerance = wanted

    def at(some: FreeBalls, unknowns: NDArray) -> tuple[FreeBallBalance, NDArray]:
        here = some.balance(unknowns, some.friction(unknowns, points), part)
        return here, np.abs(here.left) / some.scale

    found, left, running = start.copy(), np.full(len(start), np.inf), np.arange(len(start))
    tries, shorter, evaluations = np.zeros(len(start), int), np.ones(len(start)), 1
    here, size = at(balls, start)
    while True:
        left[running] = size.max(1)
        going = (left[running] > tolerance) & (tries < len(CAUTION))
        if not going.any() or evaluations >= LIMIT:
            return found, left
        if not going.all():
            running, balls, here, size = running[going], balls.taken(going), here.taken(going), size[going]
            tries, shorter = tries[going], shorter[going]
        step = shorter[:, None] * _step(balls, here, CAUTION[tries])
        trial = found[running] + step
        (there, new), evaluations = at(balls, trial), evaluations + 1
        ahead, past = (here.left * step).sum(1), (there.left * step).sum(1)
        most, before = new.max(1), size.max(1)
        nearer = (ahead < 0) & (past <= -LESS * ahead) & (most > NEAR) & (most <= 2 * np.maximum(before, 1.0))
        better = nearer | (most < LESS * before)
        found[running[better]] = trial[better]
        here, size = there.or_else(here, better), np.where(better[:, None], new, size)
        tries = np.where(better, np.maximum(tries - 2, 0), tries + 1)
        shorter = np.where(better | (tries != 1), 1.0, shortened(ahead, past))


def _step(balls: FreeBalls, here: FreeBallBalance, caution: NDArray) -> NDArray:
    """Newton step (n, 4), held back by a share of the majorant."""
    step = -here.resolved(here.left[..., None], caution)[..., 0]
    speed = np.linalg.norm(balls.rolling, axis=1)
    long = np.linalg.norm((balls.unknowns @ step[..., None])[..., 0], axis=1) / (LONGEST * speed)
    return step / np.maximum(long, 1.0)[:, None]
