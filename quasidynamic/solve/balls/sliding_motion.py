"""Motion of slow balls that slide on all their contacts."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.sliding_balls import (
    FrictionHeat,
    SlidingBallBalance,
    guided_ball_balance,
    motion_scale,
    sliding_ball_balance,
    stronger_diagonal,
)
from quasidynamic.contact.ellipse.full_sliding import Ellipse, sliding_friction
from quasidynamic.contact.ellipse.rigid_slip import CENTRE, ROLL, SPIN
from quasidynamic.errors import NotSolved
from quasidynamic.motion.ball_slip import (
    ORBIT,
    BallContacts,
    rolling_motion,
    slip_by_motion,
    slip_of,
    spinning_motion,
)
from quasidynamic.solve.step_length import shortened

TOLERANCE = 1e-10  # unbalanced power over the power of friction
ROUNDED = 1e-7  # the same, where rounding keeps a step from lowering it any more
LIMIT = 300  # evaluations; half of all balls need six, one in a hundred fifty
SLOPE_LEFT = 0.5  # of the slope at the start of a step that may be left at its end
ROUNDING = 1e-13  # of the power: too small to tell two powers apart
LINES = 0.347**2 / 2  # of A a^2/R: slip of the centre of a contact that rolls on two lines, without spin
CAUTION = np.array([0.0, 0.0, 0.0, 0.0, 0.01, 0.1, 1.0])  # share of the majorant in one try after the other
RIDGE = 1e-13  # added to the diagonal of the curvature, scaled to one


@dataclass(frozen=True)
class SlidingMotion:
    """How balls move when the inner ring turns by one rad/s against the outer ring. N balls, G diagonals.

    Balls that are not pressed on both rings take part in nothing: their motion is not a number.
    """

    motion: NDArray  # (N, 3) [rad/s] outer ring, ball axial, ball radial, from the orbiting ball centre
    slip: NDArray  # (N, G, 2, 3) centre slip [m/s], roll and spin [rad/s], ball minus race
    power: NDArray  # (N) [W] heat of friction, the torque of the ball [N m]
    driven: NDArray  # (N) whether the ball is pressed on both rings
    imbalance: NDArray  # (N) [-] unbalanced power over the power of friction
    evaluations: int


def pressed_on_both(ellipse: Ellipse) -> NDArray:
    """Whether each ball has friction on both races (N)."""
    return np.all(ellipse.traction.max(axis=1) > 0.0, axis=1)


def rolling_heat(contacts: BallContacts, ellipse: Ellipse) -> tuple[NDArray, NDArray]:
    """Slip (N, G, 2, 3) and heat (N) [W] of balls that roll on their stronger diagonal.

    At an inner ring that turns by one rad/s: an upper bound of the heat of `sliding_motion`, the least of
    all motions. Balls that are not pressed on both rings have none.

    Source
    ------
    The convexity of the heat, see `sliding_motion`.

    Valid
    -----
    As `sliding_motion`.
    """
    driven = pressed_on_both(ellipse)
    slip = slip_of(_rolling(contacts, ellipse), slip_by_motion(contacts))
    heat = np.zeros(len(driven))
    heat[driven] = sliding_friction(slip[driven], ellipse.taken(driven)).power.sum((1, 2))
    return slip, heat


def _rolling(contacts: BallContacts, ellipse: Ellipse) -> NDArray:
    """Motion (N, 3) of balls that roll on their stronger diagonal [rad/s]."""
    motions = [rolling_motion(contacts, diagonal) for diagonal in range(contacts.angle.shape[1])]
    return np.array(motions)[stronger_diagonal(ellipse), np.arange(len(contacts.angle))]


def sliding_motion(contacts: BallContacts, ellipse: Ellipse) -> SlidingMotion:
    r"""Motion in which the friction of slow balls is in balance, without inertia.

    .. math:: \min_{\Omega_o, \omega_x, \omega_r} \Phi,\quad
              \Phi = \sum_{contacts} \int \mu p\, |v|\, dA,\quad \Omega_i - \Omega_o = 1

    The heat Phi is convex in the motion: its stationarity is the balance of forces along the orbit and of
    both moments, its minimum is the torque, and there is no other balance. Newton's method for all balls side
    by side from the best of these motions: rolling on either diagonal, spinning on both, or rolling on two
    lines of each contact of the stronger diagonal, without spin on one race or with as much on both.

    N balls with G diagonals; semi-axes and friction forces of the ellipses are (N, G, 2).
    Raises `NotSolved` when a ball is not in balance; the message names the first one.

    Source
    ------
    Joshi et al. (2015), Lubricants 3, 181-196, Eqs (1) to (3); their last terms must read -M_ril sin(a_il)
    and +M_ril cos(a_il). Starts: Heras et al. (2017), Eqs (1) to (3).

    Valid
    -----
    Slow: no inertia, no oil film, no cage; sliding everywhere in the contacts.
    """
    driven, rolling = pressed_on_both(ellipse), _rolling(contacts, ellipse)
    balls = sliding_ball_balance(contacts, ellipse, rolling)
    unknowns = np.full_like(rolling, np.nan)
    (power, imbalance), evaluations = np.zeros((2, len(rolling))), 0
    if driven.any():
        motions = [rolling_motion(contacts, diagonal) for diagonal in range(contacts.angle.shape[1])]
        if len(motions) == 2:
            motions.append(spinning_motion(contacts))
        moving, starts = balls.taken(driven), _starts(balls, np.array(motions) - rolling)[:, driven]
        slip = moving.base + np.einsum("ngsij,tnj->tngsi", moving.by_unknown, starts)
        best = sliding_friction(slip, moving.ellipse).power.sum((2, 3)).argmin(axis=0)
        minimum = _least_power(moving, starts[best, np.arange(len(best))])
        unknowns[driven], power[driven], imbalance[driven], evaluations = minimum
    _require_balance(imbalance, evaluations)
    return _of_slow_balls(balls, rolling, unknowns, (power, driven, imbalance), evaluations)


def sliding_motion_near(contacts: BallContacts, ellipse: Ellipse, motion: NDArray) -> SlidingMotion:
    """`sliding_motion` of balls that differ little from those of a known motion (N, 3) [rad/s].

    Whole steps of Newton's method, as long as each leaves less than half of what is unbalanced: to rounding,
    so that differences of motions that hardly differ keep their digits.

    Raises `NotSolved` when a ball comes to be pressed on both rings or ceases to be, or finds no balance near
    by.
    """
    driven = pressed_on_both(ellipse)
    if not np.array_equal(driven, np.isfinite(motion).all(axis=1)):
        raise NotSolved("a ball begins or ceases to be pressed on both rings", "not the same balls")
    rolling = _rolling(contacts, ellipse)
    balls = sliding_ball_balance(contacts, ellipse, rolling)
    unknowns = np.full_like(rolling, np.nan)
    (power, imbalance), moving = np.zeros((2, len(rolling))), balls.taken(driven)
    here, evaluations = np.einsum("nij,nj->ni", moving.by_motion, (motion - rolling)[driven]), 1
    heat, falling = moving.at(here), driven.any()
    while falling:
        there = here + _step(heat, np.zeros(len(here)))
        new_heat, evaluations = moving.at(there), evaluations + 1
        better = moving.imbalance(new_heat) < moving.imbalance(heat)
        falling = bool((moving.imbalance(new_heat) < moving.imbalance(heat) / 2).any())
        here, heat = np.where(better[:, None], there, here), new_heat.or_else(heat, better)
    unknowns[driven], power[driven], imbalance[driven] = here, heat.power, moving.imbalance(heat)
    _require_balance(imbalance, evaluations)
    return _of_slow_balls(balls, rolling, unknowns, (power, driven, imbalance), evaluations)


def _of_slow_balls(
    balls: SlidingBallBalance,
    rolling: NDArray,
    unknowns: NDArray,
    found: tuple[NDArray, NDArray, NDArray],
    evaluations: int,
) -> SlidingMotion:
    """Motion and slip at unknowns (N, 3), with power, which balls are driven, and imbalance as they are."""
    change = np.linalg.solve(balls.scale, unknowns[..., None])[..., 0]
    motion = rolling + motion_scale(rolling) * change
    return SlidingMotion(motion, balls.slip(unknowns), *found, evaluations)


def guided_motion(contacts: BallContacts, ellipse: Ellipse, attitude: NDArray) -> SlidingMotion:
    r"""Motion and heat of balls that roll on two races about an axis that is given.

    .. math:: \min_{\Omega_o, \omega} \Phi,\quad (\omega_x, \omega_r) = \omega (-\cos\beta, \sin\beta)

    What holds the axis does no work, so the heat is the power of the rings.

    N balls with one diagonal, all of them driven; semi-axes and friction forces (N, 1, 2) are above zero, and
    beta (N) [rad] is the angle of the axis to the shaft.
    Raises `NotSolved` when a ball is not in balance.

    Source
    ------
    The heat of `sliding_motion`; Jones (1959), J. Basic Eng. 81, 1-12, for race control.

    Valid
    -----
    Friction across the rolling direction, which holds gyroscopic moments, takes nothing from that along it.
    """
    driven = np.ones(len(attitude), bool)
    if not len(attitude):
        return SlidingMotion(np.zeros((0, 3)), np.zeros((0, 1, 2, 3)), np.zeros(0), driven, np.zeros(0), 0)
    balls = guided_ball_balance(contacts, ellipse, attitude)
    centre_slip, power, imbalance, evaluations = _least_power(balls, _on_two_lines(balls)[:, 0])
    _require_balance(imbalance, evaluations)
    by_ring = slip_by_motion(contacts)[:, 0, :, CENTRE, ORBIT] * np.array([1.0, 0.0])
    outer, speed = np.linalg.solve(balls.by_motion, (centre_slip - by_ring)[..., None])[..., 0].T
    motion = np.stack([outer, -speed * np.cos(attitude), speed * np.sin(attitude)], -1)
    return SlidingMotion(motion, balls.slip(centre_slip), power, driven, imbalance, evaluations)


def _require_balance(imbalance: NDArray, evaluations: int) -> None:
    bad = np.flatnonzero(~(imbalance <= ROUNDED))
    if len(bad):
        share = imbalance[bad[0]]
        left = f"{share:.1e} of its power is unbalanced, allowed {ROUNDED:.0e}"
        raise NotSolved(
            f"{len(bad)} of {len(imbalance)} balls found no balance of friction in {evaluations} "
            f"evaluations, the first is ball {bad[0]}: "
            + (left if np.isfinite(share) else "its load is too small for numbers"),
            "iteration limit" if evaluations >= LIMIT else "stalled",
        )


def _starts(balls: SlidingBallBalance, changes: NDArray) -> NDArray:
    """Unknowns (S, N, 3) of motions that differ from rolling by `changes`, then of three kinds of spin."""
    ellipse = balls.ellipse
    ball, strong = np.arange(len(balls.base)), stronger_diagonal(ellipse)
    control = np.zeros((3, len(ball), 3))  # no spin on the inner, on the outer race, as much on both
    control[:2, :, 2] = (-balls.base[ball, strong, :, SPIN] / balls.by_unknown[ball, strong, :, SPIN, 2]).T
    control[2, :, 2] = control[:2, :, 2].mean(0)
    control[:, :, :2] = _on_two_lines(balls)[ball, strong]
    return np.concatenate([np.einsum("nij,snj->sni", balls.by_motion, changes), control])


def _on_two_lines(balls: SlidingBallBalance) -> NDArray:
    """Slip (N, G, 2) of the centres of contacts that roll on two lines, without spin."""
    return LINES * balls.base[..., ROLL] * balls.ellipse.across**2 / balls.ellipse.radius


def _least_power(balls: SlidingBallBalance, start: NDArray) -> tuple[NDArray, NDArray, NDArray, int]:
    """Unknowns (n, k) with the least power, that power, what is unbalanced there (n), and evaluations.

    Newton steps, shortened when they go too far; where that does not help, steps towards the minimum of the
    majorant, which always lower the power but creep along its valleys.
    """
    unknowns, least, imbalance = start.copy(), np.empty(len(start)), np.empty(len(start))
    running, moving, heat = np.arange(len(start)), balls, balls.at(start)
    tries, part = np.zeros(len(start), int), np.ones(len(start))
    evaluations = 1
    while True:
        least[running], imbalance[running] = heat.power, moving.imbalance(heat)
        going = (imbalance[running] > TOLERANCE) & (tries < len(CAUTION))
        if not going.any() or evaluations >= LIMIT:
            return unknowns, least, imbalance, evaluations
        if not going.all():
            running, moving, heat = running[going], moving.taken(going), heat.taken(going)
            tries, part = tries[going], part[going]
        step = part[:, None] * _step(heat, CAUTION[tries])
        trial = unknowns[running] + step
        new_heat, evaluations = moving.at(trial), evaluations + 1
        before, after = (heat.slope * step).sum(axis=1), (new_heat.slope * step).sum(axis=1)
        better = (after <= -SLOPE_LEFT * before) | (CAUTION[tries] == 1.0)
        better &= new_heat.power <= heat.power * (1 + ROUNDING)
        unknowns[running[better]] = trial[better]
        if better.all():  # all that follows would change nothing
            heat, tries, part = new_heat, np.zeros_like(tries), np.ones_like(part)
            continue
        heat = new_heat.or_else(heat, better)
        tries = np.where(better, 0, tries + 1)
        whole = better | (CAUTION.take(tries, mode="clip") > 0.0)
        part = np.where(whole, 1.0, part * shortened(before, after))


def _step(heat: FrictionHeat, caution: NDArray) -> NDArray:
    """Step (n, k) to the minimum of a parabola between the tangent one and the majorant."""
    share = caution[:, None, None]
    matrix = (1 - share) * heat.curvature + share * heat.majorant
    size = np.sqrt(np.einsum("nii->ni", heat.majorant))
    scaled = matrix / (size[:, :, None] * size[:, None, :]) + RIDGE * np.eye(size.shape[1])
    return -np.linalg.solve(scaled, (heat.slope / size)[..., None])[..., 0] / size
