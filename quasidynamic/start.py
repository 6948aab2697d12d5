"""A first guess: the static load distribution of rollers between rigid rings."""

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance, Unknowns
from quasidynamic.balance.roller import RollerInputs
from quasidynamic.balance.settling import (
    centrifugal_force,
    film_at,
    outer_approach,
    resting_loads,
    series_stiffness,
    settled,
    softness,
)
from quasidynamic.contact.land import land_torque
from quasidynamic.contact.load import EXPONENT

LITTLE = 0.1  # slip up to which the centrifugal force keeps its value
GUESSES = np.geomspace(1e-5, 0.98, 9)  # slips that are looked at for a start
STRIBECK = 5.0  # largest roller load times their number over the load, about
SHIFT_STEPS = 40  # Newton on a convex law from above: never more than about ten
SHIFT_DIGITS = 1e-8  # [m]


def static_start(balance: BearingBalance) -> NDArray:
    """Scaled unknowns (C, N) near equilibrium: both raceways of a roller in series, no tilt.

    The ring displacement along the load is one scalar root; films are those of pure rolling.
    """
    static = static_unknowns(balance, np.zeros_like(balance.rolling_cage))
    cage_drift, spin_drift = guessed_drifts(balance, static)
    if (np.abs(cage_drift) > LITTLE * np.abs(balance.rolling_cage)).any():
        static = static_unknowns(balance, cage_drift)
    return balance.pack(static._replace(cage_drift=cage_drift, spin_drift=spin_drift))


def static_unknowns(balance: BearingBalance, cage_drift: NDArray) -> Unknowns:
    """Unknowns of `static_start` at a cage speed, all spins still those of pure rolling."""
    points, m = balance.points, balance.roller.shapes
    shape = (len(points), balance.rollers)
    nothing = np.zeros(shape)
    unknowns = Unknowns(
        ring=np.array([nothing[:, :1], nothing[:, :1], points.slope_z, points.slope_y]),
        cage_drift=cage_drift,
        approach=nothing,
        tilt=nothing,
        film=np.zeros((2, *shape)),
        spin_drift=nothing,
        deviation=np.zeros((2, m, *shape)),
    )
    cage_speed = balance.rolling_cage + cage_drift
    usual = 4 * points.load / balance.rollers + centrifugal_force(balance, cage_speed)
    film = film_at(balance, unknowns, np.broadcast_to(usual, (2, *shape)))
    direction = np.arctan2(points.load_y, points.load_z)
    gap = balance.clearance / 2 - film.sum(0).mean(-1, keepdims=True) + outer_approach(balance, cage_speed)
    shift = ring_shift(balance, direction, gap)
    unknowns.ring[:2] = shift * np.sin(direction), shift * np.cos(direction)
    return settled(balance, unknowns._replace(film=film))


def guessed_drifts(balance: BearingBalance, static: Unknowns) -> tuple[NDArray, NDArray]:
    """Drifts of cage (C, 1) and spins (C, Z) at a slip where tractions about drive the cage.

    Each roller shares the sliding between its raceways as if friction grew with load and sliding;
    between the slips that are looked at, the torque on the cage is interpolated over their logarithm.
    """
    cases, bearing = len(balance.points), balance.roller.bearing
    load = resting_loads(balance, static)
    inner_share = load[1] / load.sum(0)
    r_i, r_o = bearing.inner_radius, bearing.outer_radius
    spin_per_cage = (inner_share * (r_i + r_o) - r_i) / (bearing.roller.diameter / 2)
    every = np.tile(np.arange(cases), len(GUESSES))
    many = LumpedRollers(balance.take(every))
    cage_drift = -np.repeat(GUESSES, cases)[:, None] * many.balance.rolling_cage
    line_load = load[:, every, :, None] / bearing.roller.length
    forces = many.forces(line_load, cage_drift, cage_drift * spin_per_cage[every])
    torque = many.driving_torque(forces, cage_drift).reshape(len(GUESSES), cases)
    slip = _sign_change(np.log(GUESSES), torque)
    cage_drift = -np.exp(slip)[:, None] * balance.rolling_cage
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


def ring_shift(balance: BearingBalance, direction: NDArray, gap: NDArray) -> NDArray:
    """Displacement of the ring (C, 1) [m] along the load at which the rollers carry it, without friction.

    Newton's method from the usual share of the most loaded roller. The load grows convexly with the
    displacement: after one step at most it is approached from above.
    """
    raceways, load = balance.roller.raceways, balance.points.load
    soft = softness(balance)
    share, coefficient = soft[0] / soft.sum(), np.ravel(raceways.law.coefficient)[0]
    cos = np.cos(balance.roller.bearing.azimuths - direction)
    nearest = cos.max(axis=-1, keepdims=True)
    usual = np.minimum(1.0, STRIBECK / balance.rollers) * load / nearest
    room = soft.sum() * usual ** (1 / EXPONENT) + raceways.drop.min() / share
    shift = (np.maximum(gap, 0.0) + room) / nearest
    for _ in range(SHIFT_STEPS):
        # Of the room between the raceways, the inner one takes its share and has the profile to itself.
        closed = np.maximum(share * (shift * cos - gap)[..., None] - raceways.drop, 0.0)
        power = coefficient * closed ** (EXPONENT - 1)
        carried = ((power * closed) @ raceways.slices.widths * cos).sum(-1, keepdims=True)
        slope = EXPONENT * share * (power @ raceways.slices.widths * cos * cos).sum(-1, keepdims=True)
        change = np.where(slope > 0, (carried - load) / np.where(slope > 0, slope, 1.0), 0.0)
        shift = shift - change
        if np.abs(change).max() < SHIFT_DIGITS:
            break
    return np.where(load > 0, shift, 0.0)


SLIPS = np.array([0.003, 0.01, 0.03, 0.08, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.96, 0.99])
SMALLEST_SLIP = 1e-10
NEAREST = np.log(1e-13)  # to rolling on one raceway, over the distance to rolling on the other
SPIN_HALVINGS = 20  # of the logarithm of that distance
SLIP_HALVINGS = 12  # of the logarithm between two of `SLIPS`
RING_STEPS = 60
LONGEST_RING_STEP = 2e-5  # [m]
RING_FLOOR = 1e-4  # of the stiffness, where no roller resists a direction


def slipping_start(balance: BearingBalance, astray: float = 0.0) -> NDArray:
    """Scaled unknowns (C, N) with the cage slip at which lumped rollers drive the cage just enough.

    For light loads at high speed, where the slip is not small, and for a ring that friction pushes
    aside. Rollers have one slice; the spins follow from the tractions at each slip, the slip from
    the torque on the cage, the place of the ring from the loads with their friction.

    `astray` moves the slip away from that, by so much on the scale of ln(slip / (1 - slip)).
    """
    slip = driven_slip(balance)
    return _start_at(balance, slip / (slip + (1 - slip) * np.exp(-astray)))


RESTARTS = tuple(partial(slipping_start, astray=astray) for astray in (1.5, -1.5, 4.0))


def driven_slip(balance: BearingBalance) -> NDArray:
    """Least slip (C) at which lumped rollers drive the cage against its resistance."""
    cases = len(balance.points)
    every = np.tile(np.arange(cases), len(SLIPS))
    many, slips = LumpedRollers(balance.take(every)), np.repeat(SLIPS, cases)
    drives = (many.at(slips)[2] > 0).reshape(len(SLIPS), cases)
    # The least slip at which the rollers drive the cage, and the one before it, where it lags.
    first = np.where(drives.any(0), drives.argmax(0), len(SLIPS) - 1)
    low, high = np.where(first > 0, SLIPS[first - 1], SMALLEST_SLIP), SLIPS[first]
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
    unknowns = unknowns._replace(film=film_at(balance, unknowns, resting_loads(balance, unknowns)))
    load = points.load * np.sin(turned), points.load * np.cos(turned)
    return balance.pack(settled(balance, resting_ring(balance, unknowns, np.array(load)[..., 0])))


@dataclass(frozen=True)
class LumpedRollers:
    """Rollers of one slice under static loads, at a given cage speed."""

    balance: BearingBalance

    def at(self, slip: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Drifts of the spins (C, Z), friction over load at the inner ring (C), torque on the cage (C).

        The torque [N m] is positive when it drives the cage the way it turns.
        """
        balance = self.balance
        cage_drift = -slip[:, None] * balance.rolling_cage
        state = static_unknowns(balance, cage_drift)
        line_load = resting_loads(balance, state)[..., None] / balance.roller.raceways.slices.length
        drift, forces = self._drifts(line_load, cage_drift)
        t_i, _, r_i, _ = forces
        tangential = (t_i + (1 - 2 * balance.roller.bearing.diameter_ratio) * r_i).sum(-1)
        load = line_load[0, ..., 0].sum(-1) * balance.roller.raceways.slices.length
        friction = tangential / np.maximum(load, SMALLEST_LOAD)
        return drift, friction, self.driving_torque(forces, cage_drift)

    def driving_torque(self, forces: NDArray, cage_drift: NDArray) -> NDArray:
        """Torque (C) [N m] of tractions and shears (4, C, Z), drag and land, along the way the cage turns."""
        balance = self.balance
        (t_i, t_o, r_i, r_o), g = forces, balance.roller.bearing.diameter_ratio
        driving = (t_i + t_o + (1 - 2 * g) * r_i - (1 + 2 * g) * r_o).sum(-1)
        torque = driving * balance.roller.bearing.pitch_diameter / 2
        torque = torque + self._resistance(balance.rolling_cage + cage_drift)
        return torque * np.sign(balance.rolling_cage[:, 0])

    def _drifts(self, line_load: NDArray, cage_drift: NDArray) -> tuple[NDArray, NDArray]:
        """Drifts at which the tractions balance, and the forces there.

        They lie between rolling on the inner and on the outer raceway, mostly so close to one of them
        that the logarithm of the distance has to be halved.
        """
        bearing = self.balance.roller.bearing
        r_w = bearing.roller.diameter / 2
        inner = -cage_drift * bearing.inner_radius / r_w + np.zeros(line_load.shape[1:3])
        outer = cage_drift * bearing.outer_radius / r_w + np.zeros(line_load.shape[1:3])
        # Rolling on the inner raceway is the faster spin when the cage lags behind forwards.
        up = np.sign(inner - outer)

        def speeds_up(drift: NDArray) -> NDArray:
            t_i, t_o, r_i, r_o = self.forces(line_load, cage_drift, drift)
            return (t_i - t_o - r_i - r_o) * up > 0

        nearer_inner = speeds_up((inner + outer) / 2)
        end, way = np.where(nearer_inner, inner, outer), np.where(nearer_inner, outer - inner, inner - outer)
        low, high = np.full(end.shape, NEAREST), np.full(end.shape, np.log(0.5))
        for _ in range(SPIN_HALVINGS):
            middle = (low + high) / 2
            further = speeds_up(end + way * np.exp(middle)) != nearer_inner
            low, high = np.where(further, middle, low), np.where(further, high, middle)
        drift = end + way * np.exp((low + high) / 2)
        return drift, self._balanced(*self.forces(line_load, cage_drift, drift))

    @staticmethod
    def _balanced(t_i: NDArray, t_o: NDArray, r_i: NDArray, r_o: NDArray) -> NDArray:
        """Let the larger traction follow from the smaller one: halving does not find it on a steep slope."""
        inner_is_small = np.abs(t_i) < np.abs(t_o)
        return np.array(
            [
                np.where(inner_is_small, t_i, t_o + r_i + r_o),
                np.where(inner_is_small, t_i - r_i - r_o, t_o),
                r_i,
                r_o,
            ]
        )

    def forces(self, line_load: NDArray, cage_drift: NDArray, drift: NDArray) -> NDArray:
        """Traction at both raceways and rolling shear at both (4, C, Z) [N]."""
        roller, points, raceways = self.balance.roller, self.balance.points, self.balance.roller.raceways
        speeds = self.balance.rolling_spin + drift, self.balance.rolling_cage + cage_drift
        nothing = np.zeros((2, *drift.shape))
        sliding, entrainment, sense = roller.surfaces(
            RollerInputs(nothing, nothing, drift, cage_drift, *speeds), points
        )
        length = raceways.slices.length
        load = line_load[..., 0] * length
        film = raceways.film(load, sliding, entrainment).thickness
        pull = raceways.traction(line_load, sliding[..., None], entrainment[..., None], film[..., None])
        shear = raceways.rolling(load, entrainment)
        return np.concatenate([pull.force[..., 0] * length, sense * shear.force])

    def _resistance(self, cage_speed: NDArray) -> NDArray:
        """Torque (C) of oil-air mixture and land on the cage [N m]."""
        bearing, points = self.balance.roller.bearing, self.balance.points
        drag, _ = self.balance.roller.drag(cage_speed)
        ring = points.outer_speed if bearing.cage.guidance == "outer" else points.inner_speed
        land = land_torque(ring - cage_speed, bearing.cage, self.balance.roller.lubrication.oil).torque
        return (land - drag * bearing.pitch_diameter / 2 * bearing.rollers)[:, 0]


def resting_ring(balance: BearingBalance, unknowns: Unknowns, load: NDArray) -> Unknowns:
    """Put the ring where frictionless rollers hold a load (2, C) [N] in any direction.

    Newton's method on a convex energy, in limited steps; a direction in which nothing resists, such
    as sideways on a single roller, is given a small stiffness so that the ring moves until something does.
    """
    azimuth = balance.roller.bearing.azimuths
    normal = np.array([np.sin(azimuth), np.cos(azimuth)])
    position = unknowns.ring[:2]
    for _ in range(RING_STEPS):
        unknowns = settled(balance, unknowns._replace(ring=np.concatenate([position, unknowns.ring[2:]])))
        force, stiffness = resting_loads(balance, unknowns)[0], series_stiffness(balance, unknowns)
        excess = load - np.einsum("iz,cz->ic", normal, force)
        matrix = np.einsum("iz,cz,kz->cik", normal, stiffness, normal)
        floor = RING_FLOOR * np.trace(matrix, axis1=1, axis2=2) + SMALLEST_STIFFNESS
        change = np.linalg.solve(matrix + floor[:, None, None] * np.eye(2), excess.T[..., None])[..., 0].T
        length = np.hypot(*change)
        position = position + (change * np.minimum(1.0, LONGEST_RING_STEP / (length + 1e-30)))[..., None]
        if length.max() < SHIFT_DIGITS:
            break
    return unknowns._replace(ring=np.concatenate([position, unknowns.ring[2:]]))


SMALLEST_LOAD = 1e-9  # [N]
SMALLEST_STIFFNESS = 1.0  # [N/m] where no roller touches at all
