"""A first guess: the static load distribution of rollers between rigid rings."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance, Unknowns
from quasidynamic.balance.roller import STILL
from quasidynamic.balance.settling import filmed, series_softness, settled
from quasidynamic.contact.land import land_torque
from quasidynamic.contact.load import EXPONENT, smooth_positive

FIRST_SLIP = 1e-3  # of the cage: friction must have a sign to begin with
SHIFT_STEPS = 40  # Newton on a convex law from above: never more than about ten
DRY_FILM = 1e-7  # [m] before any film is known


def static_start(balance: BearingBalance) -> NDArray:
    """Scaled unknowns (C, N) near equilibrium: both raceways of a roller in series, no tilt.

    The ring displacement along the load is one scalar root; the centrifugal force is added at the
    outer contact.
    """
    points, bearing = balance.points, balance.roller.bearing
    direction = np.arctan2(points.load_y, points.load_z)
    shift = ring_shift(balance, direction)
    cases, rollers, m = len(points), bearing.rollers, balance.roller.shapes
    spread = np.ones((cases, rollers))
    cage_speed = balance.cage_speed * (1 - FIRST_SLIP)
    ring = np.array([shift * np.sin(direction), shift * np.cos(direction), points.slope_z, points.slope_y])
    unknowns = Unknowns(
        ring=ring,
        cage_speed=cage_speed,
        approach=0.0 * spread,
        tilt=0.0 * spread,
        film=np.full((2, cases, rollers), DRY_FILM),
        spin=balance.roller_speed * spread,
        deviation=np.zeros((2, m, cases, rollers)),
    )
    return balance.pack(filmed(balance, settled(balance, unknowns)))


def ring_shift(balance: BearingBalance, direction: NDArray) -> NDArray:
    """Displacement of the ring (C, 1) [m] along the load at which the rollers carry it, without friction.

    Newton's method from a displacement that is too large: the load grows convexly with it.
    """
    bearing, load = balance.roller.bearing, balance.points.load
    softness = series_softness(balance)
    cos = np.cos(bearing.azimuths - direction)
    nearest = cos.max(axis=-1, keepdims=True)
    gap = balance.clearance / 2
    shift = (np.maximum(gap, 0.0) + softness * (load / nearest) ** (1 / EXPONENT)) / nearest
    for _ in range(SHIFT_STEPS):
        closed = np.maximum(shift * cos - gap, 0.0) / softness
        power = closed ** (EXPONENT - 1)
        excess = (power * closed * cos).sum(-1, keepdims=True) - load
        slope = EXPONENT / softness * (power * cos * cos).sum(-1, keepdims=True)
        change = np.where(slope > 0, excess / np.where(slope > 0, slope, 1.0), 0.0)
        shift = shift - change
        if np.abs(change).max() < 1e-12:
            break
    return np.where(load > 0, shift, 0.0)


SLIPS = np.array([0.003, 0.01, 0.03, 0.08, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.96, 0.99])
SPIN_HALVINGS = 20  # of the interval between rolling on either raceway
SLIP_HALVINGS = 6  # of the interval between two of `SLIPS`
RING_STEPS = 60
LONGEST_RING_STEP = 2e-5  # [m]
RING_FLOOR = 1e-4  # of the stiffness, where no roller resists a direction


def slipping_start(balance: BearingBalance) -> NDArray:
    """Scaled unknowns (C, N) with the cage slip at which lumped rollers drive the cage just enough.

    For light loads at high speed, where the slip is not small, and for a ring that friction pushes
    aside. Rollers have one slice; the spins follow from the tractions at each slip, the slip from
    the torque on the cage, the place of the ring from the loads with their friction.
    """
    cases, points = len(balance.points), balance.points
    static = balance.unpack(static_start(balance))
    every = np.tile(np.arange(cases), len(SLIPS))
    many, slips = LumpedRollers(balance.take(every), _taken(static, every)), np.repeat(SLIPS, cases)
    drives = (many.at(slips)[2] > 0).reshape(len(SLIPS), cases)
    # The least slip at which the rollers drive the cage, and the one before it, where it lags.
    first = np.where(drives.any(0), drives.argmax(0), len(SLIPS) - 1)
    low, high = SLIPS[np.maximum(first - 1, 0)] * (first > 0), SLIPS[first]
    lumped = LumpedRollers(balance, static)
    for _ in range(SLIP_HALVINGS):
        middle = (low + high) / 2
        drives = lumped.at(middle)[2] > 0
        low, high = np.where(drives, low, middle), np.where(drives, middle, high)
    spin, friction, _ = lumped.at((low + high) / 2)
    turned = np.arctan2(points.load_y, points.load_z) - friction[:, None]
    position = resting_ring(balance, points.load * np.sin(turned), points.load * np.cos(turned), static.ring)
    cage_speed = balance.cage_speed * (1 - (low + high)[:, None] / 2)
    ring = np.concatenate([position, static.ring[2:]])
    unknowns = settled(balance, static._replace(ring=ring, cage_speed=cage_speed, spin=spin))
    return balance.pack(filmed(balance, unknowns))


def _taken(unknowns: Unknowns, cases: NDArray) -> Unknowns:
    """Unknowns of some cases."""
    rows = (unknowns.cage_speed, unknowns.approach, unknowns.tilt, unknowns.spin)
    cage_speed, approach, tilt, spin = (row[cases] for row in rows)
    ring, film, deviation = unknowns.ring[:, cases], unknowns.film[:, cases], unknowns.deviation[:, :, cases]
    return Unknowns(ring, cage_speed, approach, tilt, film, spin, deviation)


@dataclass(frozen=True)
class LumpedRollers:
    """Rollers of one slice under static loads, at a given cage speed."""

    balance: BearingBalance
    static: Unknowns

    def at(self, slip: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Spins (C, Z), friction over load at the inner ring (C) and torque on the cage (C), forwards > 0."""
        balance = self.balance
        cage_speed = balance.cage_speed * (1 - slip[:, None])
        state = settled(balance, self.static._replace(cage_speed=cage_speed))
        raceways = balance.roller.raceways
        line_load, _ = raceways.law(balance.inputs(state).approach[:, 0][..., None])
        spin, (t_i, t_o, r_i, r_o) = self._spins(line_load, cage_speed)
        g = balance.roller.bearing.diameter_ratio
        tangential = (t_i + (1 - 2 * g) * r_i).sum(-1)
        driving = tangential + (t_o - (1 + 2 * g) * r_o).sum(-1)
        torque = driving * balance.roller.bearing.pitch_diameter / 2 + self._resistance(cage_speed)
        load = line_load[0, ..., 0].sum(-1) * raceways.slices.length
        return spin, tangential / load, torque * np.sign(balance.cage_speed[:, 0])

    def _spins(self, line_load: NDArray, cage_speed: NDArray) -> tuple[NDArray, NDArray]:
        """Spins at which the tractions balance, between rolling on the inner and on the outer raceway."""
        bearing, points = self.balance.roller.bearing, self.balance.points
        r_w = bearing.roller.diameter / 2
        rolling = np.array(
            [
                (points.inner_speed - cage_speed) * bearing.inner_radius / r_w,
                (cage_speed - points.outer_speed) * bearing.outer_radius / r_w,
            ]
        )
        shape = line_load.shape[1:3]
        low, high = (np.broadcast_to(ends, shape) for ends in (rolling.min(0), rolling.max(0)))
        for _ in range(SPIN_HALVINGS):
            spin = (low + high) / 2
            t_i, t_o, r_i, r_o = self._forces(line_load, rolling, spin)
            faster = t_i - t_o - r_i - r_o > 0
            low, high = np.where(faster, spin, low), np.where(faster, high, spin)
        spin = (low + high) / 2
        return spin, self._forces(line_load, rolling, spin)

    def _forces(self, line_load: NDArray, rolling: NDArray, spin: NDArray) -> NDArray:
        """Traction at both raceways and rolling shear at both (4, C, Z) [N]."""
        raceways, points, bearing = (
            self.balance.roller.raceways,
            self.balance.points,
            self.balance.roller.bearing,
        )
        length, r_w = raceways.slices.length, bearing.roller.diameter / 2
        nominal = np.abs(points.inner_speed - points.outer_speed) * bearing.inner_radius
        sliding = r_w * np.array([rolling[0] - spin, spin - rolling[1]])
        entrainment = np.hypot(r_w / 2 * (rolling + spin), STILL * nominal)
        load = line_load[..., 0] * length
        film = raceways.film(load, sliding, entrainment).thickness
        pull = raceways.traction(line_load, sliding[..., None], entrainment[..., None], film[..., None])
        shear = raceways.rolling(load, entrainment)
        return np.concatenate([pull.force[..., 0] * length, points.direction * shear.force])

    def _resistance(self, cage_speed: NDArray) -> NDArray:
        """Torque (C) of oil-air mixture and land on the cage [N m]."""
        bearing, points = self.balance.roller.bearing, self.balance.points
        drag, _ = self.balance.roller.drag(cage_speed)
        ring = points.outer_speed if bearing.cage.guidance == "outer" else points.inner_speed
        land = land_torque(ring - cage_speed, bearing.cage, self.balance.roller.lubrication.oil).torque
        return (land - drag * bearing.pitch_diameter / 2 * bearing.rollers)[:, 0]


def resting_ring(balance: BearingBalance, load_y: NDArray, load_z: NDArray, ring: NDArray) -> NDArray:
    """Position (2, C, 1) [m] at which frictionless rollers hold a load in any direction.

    Newton's method on a convex energy, in limited steps; a direction in which nothing resists, such
    as sideways on a single roller, is given a small stiffness so that the ring moves until something does.
    """
    bearing = balance.roller.bearing
    softness = series_softness(balance)
    normal = np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)])
    load = np.array([load_y, load_z])
    position = ring[:2]
    for _ in range(RING_STEPS):
        closed, slope = smooth_positive((position * normal[:, None]).sum(0) - balance.clearance / 2)
        power = (closed / softness) ** (EXPONENT - 1)
        force, stiffness = power * closed / softness, EXPONENT * power / softness * slope
        excess = load[..., 0] - (normal[:, None] * force).sum(-1)
        matrix = np.einsum("icz,kcz->cik", normal[:, None] * stiffness, normal[:, None] * np.ones_like(force))
        floor = RING_FLOOR * np.trace(matrix, axis1=1, axis2=2) + SMALLEST_STIFFNESS
        change = np.linalg.solve(matrix + floor[:, None, None] * np.eye(2), excess.T[..., None])[..., 0].T
        length = np.hypot(*change)
        position = (
            position + (change * np.minimum(1.0, LONGEST_RING_STEP / np.maximum(length, 1e-30)))[..., None]
        )
        if length.max() < 1e-9:
            break
    return position


SMALLEST_STIFFNESS = 1.0  # [N/m] where no roller touches at all
