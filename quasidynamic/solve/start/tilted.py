"""Start of a ring that a moment tilts: where frictionless rollers carry load and moment."""

from dataclasses import replace

import numpy as np

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.rigid_rings import RigidRings
from quasidynamic.balance.rollers.unknowns import OUTER, Unknowns
from quasidynamic.contact.line import EXPONENT
from quasidynamic.errors import NotSolved
from quasidynamic.solve.rollers.load_distribution import balanced
from quasidynamic.solve.rollers.static_equilibrium import (
    frictionless_loads,
    outward_force,
    static_equilibrium,
)

MOSTLY = 10.0  # moment over load and length of rollers: below it the load says which rollers touch


def tilted_by_moments(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Put rings that a moment alone tilts, or mostly, where frictionless rollers carry it.

    Newton's method would have to find out first which rollers touch, from where none does.
    """
    points, length = balance.points, balance.roller.bearing.roller.length
    by_moment = (points.free_tilt & (points.moment > MOSTLY * points.load * length))[:, 0]
    if not by_moment.any() or balance.layout.elastic_raceways or balance.deviation is not None:
        return unknowns
    cases = np.flatnonzero(by_moment)
    return unknowns.with_cases(cases, _tilted(balance.take(cases), unknowns.take(cases)))


def _tilted(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Rings of all cases where frictionless rollers carry load and moment, rollers pressed by both askew."""
    ring = unknowns.ring.copy()
    for case in range(len(balance.points)):
        one = np.array([case])
        ring[:, case, 0] = _ring(balance.take(one), unknowns.take(one))
    placed = unknowns._replace(ring=ring)
    straight = static_equilibrium(balance, placed, uneven=True)
    load = frictionless_loads(balance, straight, uneven=True).min(0)
    half = balance.approach(placed)[:, 1].sum(0) / 2
    tilt = np.where(load > np.abs(outward_force(balance, placed)), half, placed.tilt)
    return static_equilibrium(balance, placed._replace(tilt=tilt), uneven=True)


def _ring(balance: BearingBalance, unknowns: Unknowns) -> np.ndarray:
    """Displacement y, z and slopes dz/dx, dy/dx of the ring (4) of one case, or as they were."""
    points, raceways, half = balance.points, balance.roller.raceways, balance.kinematics.half_length
    pressed = raceways.softness[OUTER, 0, 0] * np.abs(outward_force(balance, unknowns)).mean() ** (
        1 / EXPONENT
    )
    forces = [points.load_y, points.load_z], [points.moment_y / half, points.moment_z / half]
    load = np.array(forces)[:, :, 0, 0].T
    slices = replace(raceways.slices, axial_modes=2)
    rings = RigidRings.of(balance.roller.bearing, slices, load)
    try:
        state, _ = balanced(rings.with_gap(pressed - unknowns.film.sum(0).mean()))
    except NotSolved:
        return unknowns.ring[:, 0, 0]
    place, slope = state.place.T
    return np.concatenate([place, slope[::-1] / half])
