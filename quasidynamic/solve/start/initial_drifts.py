"""Drifts of cage and spins from pure rolling at which friction about balances, under static loads."""

from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.rigid_rings import RigidRings
from quasidynamic.balance.rollers.unknowns import OUTER, Unknowns
from quasidynamic.contact.line import EXPONENT
from quasidynamic.errors import NotSolved
from quasidynamic.solve.rollers.static_equilibrium import (
    balanced,
    film_at,
    frictionless_loads,
    outward_force,
    static_equilibrium,
)
from quasidynamic.solve.start.friction import balanced_drifts
from quasidynamic.solve.start.frictionless import frictionless_ring, static_unknowns
from quasidynamic.solve.start.lumped import LumpedRollers, held_back

SMALL_SLIP = 0.1  # slip up to which the centrifugal force and the spins of unloaded rollers change little
TRIAL_SLIPS = np.geomspace(1e-5, 0.98, 9)  # slips that are looked at for a start
MOSTLY = 10.0  # moment over load and length of rollers: below it the load says which rollers touch
SLIPS = np.array([0.003, 0.01, 0.03, 0.08, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.96, 0.99])
SMALLEST_SLIP = 1e-10
SLIP_HALVINGS = 12  # of the logarithm between two of `SLIPS`


def static_start(balance: BearingBalance) -> NDArray:
    """Scaled unknowns (C, N) near equilibrium: both raceways of a roller in series, no tilt.

    The ring displacement along the load is one scalar root; films are those of pure rolling.
    """
    start = tilted_by_moments(balance, static_unknowns(balance, np.zeros_like(balance.rolling_cage)))
    cage_drift, spin_drift = guessed_drifts(balance, start)
    guess = start._replace(cage_drift=cage_drift, spin_drift=spin_drift)
    scaled = balance.pack(held_back(balance, guess))
    slipping = np.flatnonzero(np.abs(cage_drift) > SMALL_SLIP * np.abs(balance.rolling_cage))
    if len(slipping):  # less centrifugal force, and spins that follow from each other
        slow = balance.take(slipping)
        static = tilted_by_moments(slow, static_unknowns(slow, cage_drift[slipping]))
        drifts = balanced_drifts(slow, static, cage_drift[slipping], spin_drift[slipping])
        scaled[slipping] = slow.pack(static._replace(cage_drift=drifts[0], spin_drift=drifts[1]))
    return scaled


def guessed_drifts(balance: BearingBalance, static: Unknowns) -> tuple[NDArray, NDArray]:
    """Drifts of cage (C, 1) and spins (C, Z) at a slip where tractions about drive the cage.

    Each roller shares the sliding between its raceways as if friction grew with load and sliding;
    between the slips that are looked at, the torque on the cage is interpolated over their logarithm. A cage
    that is driven at the least of them rolls: traction of a stiff oil reaches its limit far below.
    """
    cases, bearing = len(balance.points), balance.roller.bearing
    load = frictionless_loads(
        balance, static, uneven=bool(static.tilt.any())
    )  # of rollers tilted by a moment
    inner_share = load[1] / load.sum(0)
    r_i, r_o = bearing.inner_radius, bearing.outer_radius
    spin_per_cage = (inner_share * (r_i + r_o) - r_i) / (bearing.roller.diameter / 2)
    case = np.arange(len(TRIAL_SLIPS) * cases) % cases  # all cases at each slip
    lumped = LumpedRollers(balance.take(case))
    cage_drift = -np.repeat(TRIAL_SLIPS, cases)[:, None] * lumped.balance.rolling_cage
    line_load = load[:, case] / lumped.balance.roller.bearing.roller.length
    forces = lumped.forces(line_load, cage_drift, cage_drift * spin_per_cage[case])
    torque = lumped.driving_torque(forces, cage_drift).reshape(len(TRIAL_SLIPS), cases)
    slip = np.where(torque[0] > 0, 0.0, np.exp(_sign_change(np.log(TRIAL_SLIPS), torque)))
    cage_drift = -slip[:, None] * balance.rolling_cage
    return cage_drift, cage_drift * spin_per_cage


def _sign_change(places: NDArray, values: NDArray) -> NDArray:
    """Where values (places, C) become positive first, interpolated; an end where there is no such place."""
    each = np.arange(values.shape[1])
    positive = values > 0
    last = np.where(positive.any(0), positive.argmax(0), len(places) - 1)
    first = np.maximum(last - 1, 0)
    before, after = values[first, each], values[last, each]
    rise = after - before
    weight = np.where((before < 0) & (after > 0), -before / np.where(rise > 0, rise, 1.0), 1.0)
    return places[first] + weight * (places[last] - places[first])


def tilted_by_moments(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Put rings that a moment alone tilts, or mostly, or on ribs, where frictionless rollers carry it.

    Newton's method would have to find out first which rollers touch, from where none does.
    """
    points, length = balance.points, balance.roller.bearing.roller.length
    if balance.layout.ribs and not balance.layout.elastic_raceways and balance.deviation is None:
        # tapered rollers are loaded for thrust alone
        from quasidynamic.solve.start.on_ribs import pressed_on_ribs

        return pressed_on_ribs(balance, unknowns)
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


def slipping_start(balance: BearingBalance, logit_offset: float = 0.0) -> NDArray:
    """Scaled unknowns (C, N) with the cage slip at which lumped rollers drive the cage just enough.

    For light loads at high speed, where the slip is not small, and for a ring that friction pushes
    aside. Rollers have one slice; the spins follow from the tractions at each slip, the slip from
    the torque on the cage, the place of the ring from the loads with their friction.

    `logit_offset` moves the slip away from that, by so much on the scale of ln(slip / (1 - slip)).
    """
    slip = driven_slip(balance)
    return _start_at(balance, slip / (slip + (1 - slip) * np.exp(-logit_offset)))


RESTARTS = tuple(partial(slipping_start, logit_offset=logit_offset) for logit_offset in (1.5, -1.5, 4.0))


def driven_slip(balance: BearingBalance) -> NDArray:
    """Least slip (C) at which lumped rollers drive the cage against its resistance."""
    cases = len(balance.points)
    case = np.tile(np.arange(cases), len(SLIPS))
    lumped, slips = LumpedRollers(balance.take(case)), np.repeat(SLIPS, cases)
    drives = (lumped.at(slips)[2] > 0).reshape(len(SLIPS), cases)
    # The least slip at which the rollers drive the cage, and the one before it, where it lags.
    least = np.where(drives.any(0), drives.argmax(0), len(SLIPS) - 1)
    low, high = np.where(least > 0, SLIPS[least - 1], SMALLEST_SLIP), SLIPS[least]
    lumped = LumpedRollers(balance)
    for _ in range(SLIP_HALVINGS):
        middle = np.sqrt(low * high)
        drives = lumped.at(middle)[2] > 0
        low, high = np.where(drives, low, middle), np.where(drives, middle, high)
    return np.sqrt(low * high)


def _start_at(balance: BearingBalance, slip: NDArray) -> NDArray:
    """Scaled unknowns (C, N) of lumped rollers at a slip (C), the ring where they hold the load."""
    points = balance.points
    drift, friction, _ = LumpedRollers(balance).at(slip)
    turned = np.arctan2(points.load_y, points.load_z) - friction[:, None]
    cage_drift = -balance.rolling_cage * slip[:, None]
    unknowns = static_unknowns(balance, cage_drift)._replace(spin_drift=drift)
    unknowns = unknowns._replace(film=film_at(balance, unknowns, frictionless_loads(balance, unknowns)))
    load = points.load * np.sin(turned), points.load * np.cos(turned)
    resting = static_equilibrium(balance, frictionless_ring(balance, unknowns, np.array(load)[..., 0]))
    return balance.pack(held_back(balance, tilted_by_moments(balance, resting)))
