"""Frictionless rollers that carry a load between rigid rings."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.contact.line import EXPONENT
from quasidynamic.solve.rollers.static_equilibrium import (
    film_at,
    frictionless_loads,
    outward_force,
    series_stiffness,
    static_equilibrium,
)

STRIBECK = 5.0  # largest roller load times their number over the load, about
SHIFT_STEPS = 40  # Newton on a convex law from above: never more than about ten
SHIFT_DIGITS = 0.1  # lengths of the scales, of the last step; what is left after it is a thousandth of that
RING_STEPS = 60
RING_DIGITS = 1e-2  # lengths of the scales
LONGEST_RING_STEP = 20.0  # lengths of the scales
RING_FLOOR = 1e-4  # of the stiffness, where no roller resists a direction
SMALLEST_STIFFNESS = 1.0  # [N/m] where no roller touches at all


def static_unknowns(balance: BearingBalance, cage_drift: NDArray) -> Unknowns:
    """Unknowns of `static_start` at a cage speed, all spins still those of pure rolling."""
    points, m = balance.points, balance.roller.axial_modes
    shape = (len(points), balance.layout.rollers)
    nothing = np.zeros(shape)
    unknowns = Unknowns(
        ring=np.array([nothing[:, :1], nothing[:, :1], points.slope_z, points.slope_y]),
        cage_drift=cage_drift,
        approach=nothing,
        tilt=nothing,
        film=np.zeros((2, *shape)),
        spin_drift=nothing,
        deviation=np.zeros((2, m, *shape)),
        shift=balance.even_shift,
    )
    force = outward_force(balance, unknowns)
    outward = np.abs(force)
    usual = 4 * points.load / balance.layout.rollers + outward
    film = film_at(balance, unknowns, usual)
    direction = np.arctan2(points.load_y, points.load_z)
    pressed = balance.roller.raceways.softness[1] * outward.mean(-1, keepdims=True) ** (1 / EXPONENT)
    gap = balance.roller.bearing.clearances / 2 - film.sum(0).mean(-1, keepdims=True) + pressed
    shift = ring_shift(balance, direction, gap)
    unknowns.ring[:2] = shift * np.sin(direction), shift * np.cos(direction)
    return static_equilibrium(balance, unknowns._replace(film=film), outward=force)


def ring_shift(balance: BearingBalance, direction: NDArray, gap: NDArray) -> NDArray:
    """Displacement of the ring (C, 1) [m] along the load at which rollers of a gap (C, 1 or Z) [m] carry it.

    Newton's method from the usual share of the most loaded roller. The load grows convexly with the
    displacement: after one step at most it is approached from above.
    """
    raceways, load = balance.roller.raceways, balance.points.load
    soft = raceways.softness
    both = soft.sum(0)
    share, coefficient = soft[0] / both, np.asarray(raceways.law.coefficient)[0]
    cos = np.cos(balance.roller.bearing.azimuths - direction)
    nearest = cos.max(axis=-1, keepdims=True)
    usual = np.minimum(1.0, STRIBECK / balance.layout.rollers) * load / nearest
    drop = raceways.drop.mean(1)
    room = both * usual ** (1 / EXPONENT) + drop.min(0) / share
    widest = gap.max(axis=-1, keepdims=True)
    shift = (np.maximum(widest, 0.0) + room) / nearest
    steepness, running = EXPONENT * share * cos * cos, np.ones(load.shape, bool)
    for _ in range(SHIFT_STEPS):
        # Of the room between the raceways, the inner one takes its share, and half of both profiles.
        closed = np.maximum(share * (shift * cos - gap) - drop, 0.0)
        power = coefficient * closed ** (EXPONENT - 1)
        carried = np.vecdot(raceways.slices.total(power * closed), cos)[:, None]
        slope = np.vecdot(raceways.slices.total(power), steepness)[:, None]
        change = np.divide(carried - load, slope, out=np.zeros(slope.shape), where=slope > 0)
        shift = np.where(running, shift - change, shift)
        running &= ~(np.abs(change) < SHIFT_DIGITS * balance.scales.length)
        if not running.any():
            break
    return np.where(load > 0, shift, 0.0)


def frictionless_ring(balance: BearingBalance, unknowns: Unknowns, load: NDArray) -> Unknowns:
    """Put the ring where frictionless rollers hold a load (2, C) [N] in any direction.

    Newton's method on a convex energy, in limited steps; a direction in which nothing resists, such
    as sideways on a single roller, is given a small stiffness so that the ring moves until something does.
    """
    normal = balance.kinematics.outwards
    position, unit = unknowns.ring[:2], np.ravel(balance.scales.length)
    running = np.ones(len(balance.points), bool)
    for _ in range(RING_STEPS):
        unknowns = static_equilibrium(
            balance, unknowns._replace(ring=np.concatenate([position, unknowns.ring[2:]]))
        )
        force, stiffness = frictionless_loads(balance, unknowns)[0], series_stiffness(balance, unknowns)
        excess = load - (normal * force).sum(-1)
        matrix = np.einsum("icz,kcz->cik", normal * stiffness, normal + 0 * stiffness)
        floor = RING_FLOOR * np.trace(matrix, axis1=1, axis2=2) + SMALLEST_STIFFNESS
        change = np.linalg.solve(matrix + floor[:, None, None] * np.eye(2), excess.T[..., None])[..., 0].T
        length = np.hypot(*change)
        step = running * change * np.minimum(1.0, LONGEST_RING_STEP * unit / (length + 1e-30))
        position = position + step[..., None]
        running &= ~(length < RING_DIGITS * unit)
        if not running.any():
            break
    return unknowns._replace(ring=np.concatenate([position, unknowns.ring[2:]]))
