"""First place of a ring on balls: that of a ring on springs, without inertia."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.ball_position import groove_arm, turning
from quasidynamic.solve.balls.ball_equilibrium import LEAST_STIFFNESS

TOLERANCE = 1e-3  # of the largest load: what a first place may leave
LIMIT = 300  # Newton steps, rarely more than ten; a first place far off costs time, not the answer
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no spring resists a direction
LONGEST = 0.3  # of the smaller reach: step of the ring
SHORTEST = 2.0**-40  # part of a Newton step
_EACH = np.arange(5)


def first_place(balance: AngularBalance) -> NDArray:
    """Ring displacements (C, 5) near the balance of the ring with balls at rest.

    Every ball is a spring between the groove centres that only pulls. The energy of such springs is convex
    in the displacements: Newton's method, each step halved until it does not run past the minimum.
    """
    ring = single_loads(balance)
    excess, stiffness = _forces(balance, ring)
    size = np.maximum(balance.largest_load, np.finfo(float).tiny)
    for _ in range(LIMIT):
        left = np.abs(excess).max(1) / size
        if (left <= TOLERANCE).all():
            break
        step = newton_step(balance, excess, stiffness, left)
        damping = np.ones(len(ring))
        ahead = np.abs((excess * step).sum(1))
        while True:
            trial = ring + damping[:, None] * step
            new_excess, new_stiffness = _forces(balance, trial)
            past = ~((new_excess * step).sum(1) >= -0.5 * ahead)  # also not a number
            past &= damping > SHORTEST
            if not past.any():
                break
            damping = np.where(past, damping / 2, damping)
        ring, excess, stiffness = trial, new_excess, new_stiffness
    return ring


def newton_step(balance: AngularBalance, excess: NDArray, stiffness: NDArray, imbalance: NDArray) -> NDArray:
    """Newton step (C, 5), stiffer where nothing resists as long as forces are out of balance."""
    step = stiffened_step(balance, excess, stiffness, STIFFENING * np.minimum(imbalance, 1.0))
    longest = LONGEST * min(balance.bearing.inner_reach, balance.bearing.outer_reach)
    return step / np.maximum(np.abs(step).max(1, keepdims=True) / longest, 1.0)


def stiffened_step(
    balance: AngularBalance, excess: NDArray, stiffness: NDArray, share: NDArray | float
) -> NDArray:
    """Newton step (C, 5) of a ring, each direction of which resists by a share (C) of the whole stiffness."""
    whole = np.abs(stiffness.trace(axis1=1, axis2=2))
    stiffer = (share * whole)[:, None] + LEAST_STIFFNESS
    matrix = np.where(balance.both_free, stiffness, 0.0)
    matrix[:, _EACH, _EACH] += np.where(balance.held, np.maximum(whole, 1.0)[:, None], stiffer)
    return np.linalg.solve(matrix, excess[..., None])[..., 0]


def _forces(balance: AngularBalance, ring: NDArray) -> tuple[NDArray, NDArray]:
    """What the springs do not carry of the load (C, 5) [N], and their stiffness (C, 5, 5) [N/m]."""
    bearing, matrix = balance.bearing, balance.ring_to_groove
    arm = groove_arm(balance.grooves(ring))
    apart = np.abs(arm)
    normal, coefficient = arm / apart, balance.places.in_series
    approach = np.maximum(apart - bearing.inner_reach - bearing.outer_reach, 0.0)
    root = coefficient * np.sqrt(approach)
    load = root * approach
    along = normal.conj()[..., None] * matrix  # (C, Z, 5) along the spring + i across it
    weighted = (1.5 * root)[..., None] * along.real + 1j * (turning(arm) * load / apart)[
        ..., None
    ] * along.imag
    stiffness = (along.conj().swapaxes(1, 2) @ weighted).real
    carried = ((load * normal) @ balance.groove_to_ring).real
    return np.where(balance.held, 0.0, balance.load - carried), stiffness


def single_loads(balance: AngularBalance) -> NDArray:
    """Ring displacements (C, 5) at which each load acts alone on the nearest balls."""
    bearing, (axial_offset, radial_offset) = balance.bearing, balance.bearing.groove_offset
    apart, angle, play = bearing.centre_distance, bearing.free_contact_angle, bearing.touching_place
    cosine, sine = np.cos(angle), max(np.sin(angle), 0.3)
    gap = max(bearing.clearance, 0.0) / 2

    def approach(load: NDArray) -> NDArray:
        return (np.abs(load) / bearing.balls / balance.places.in_series) ** (2 / 3)

    load, place = balance.load, np.zeros_like(balance.load)
    radial = np.sqrt((load[:, 1:3] ** 2).sum(1, keepdims=True))
    shift = gap + approach(4.4 * radial / cosine) / cosine
    place[:, 1:3] = shift * load[:, 1:3] / np.maximum(radial, 1e-300)
    axial = apart + approach(load[:, 0] / sine)
    stretch = np.sqrt(np.maximum(axial**2 - radial_offset**2, 0.0)) - axial_offset
    place[:, 0] = np.sign(load[:, 0]) * stretch
    place[:, 3:] = np.sign(load[:, 3:]) * (play + approach(4.4 * load[:, 3:] / sine) / sine)
    return np.where(balance.held, balance.place, place)
