"""How ring and raceways change the approaches of the rollers; by the same levers the rollers load them."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.roller import CAGE_SPEED, FILM_I, RIB, SPIN, VALUE
from quasidynamic.balance.rollers.unknowns import (
    CAGE,
    INNER,
    OUTER,
    SHIFT,
    TILT_Y,
    TILT_Z,
    UnknownLayout,
    Unknowns,
    Y,
    Z,
)

CREEP = 1e-4  # of the spin in pure rolling: cage speed below which it hardly moves


@dataclass(frozen=True, kw_only=True)
class RibLevers:
    """Where thrust acts on rollers and rings [m]."""

    radius: NDArray | float  # of the contact on the rib of the inner ring, from the axis of the bearing
    distance: NDArray | float  # h, radially between both contacts of a roller


@dataclass(frozen=True, kw_only=True)
class ApproachKinematics:
    """Approaches by the displacements of ring and raceways, and its transpose: loads by contact forces."""

    layout: UnknownLayout
    azimuths: NDArray  # (Z) or (C, Z) [rad] from axis z towards axis y
    half_length: NDArray | float  # (C, 1) [m] of the rollers
    stations: NDArray | None = None  # (Z) or (C, Z) [m] places of their middles along the axis; None: zero
    ribs: RibLevers | None = None

    @cached_property
    def outwards(self) -> NDArray:
        """Components y and z (2, 1 or C, Z) of what points outwards: sine and cosine of the azimuths."""
        return np.array([np.sin(self.azimuths), np.cos(self.azimuths)]).reshape(2, -1, self.layout.rollers)

    def approach(self, x: Unknowns, clearance: NDArray | float) -> NDArray:
        """Coefficients (2, M, C, Z) of the axial modes of the approaches between even raceways [m].

        `clearance` is diametral, one or that at every roller (Z) [m].
        """
        m, (y, z) = self.layout.axial_modes, x.ring[:TILT_Z]
        sin, cos = self.outwards
        approach = np.zeros((2, m, *x.spin_drift.shape))
        approach[INNER, 0] = y * sin + z * cos - x.approach + (x.film[0] + x.film[1] - clearance / 2)
        approach[OUTER, 0] = x.approach
        if m > 1:
            slope_z, slope_y = x.ring[TILT_Z:]
            slope = slope_z * cos + slope_y * sin
            if self.stations is not None:
                approach[INNER, 0] += self.stations * slope
            approach[INNER, 1] = self.half_length * slope - x.tilt
            approach[OUTER, 1] = x.tilt
        return approach

    def closing(self, x: Unknowns, deviation: NDArray | None) -> NDArray:
        r"""How far both ribs close on the rollers (C, Z) [m], along x and without sign of the thrust.

        .. math:: e_j = x - r_f \vartheta_j - h \theta_j

        with the shift x of the inner ring, its slope at the roller, the radius r_f of the contact on its rib,
        and the tilt of the roller between contacts that are h apart. Play at the ends is part of x;
        `deviation` (2, M, C, Z) [m] is that of `deviate`, None of even raceways.

        Source
        ------
        Geometry, small angles; the axial place of the roller, which both contacts share, is eliminated.

        Valid
        -----
        Ribs stay where rigid rings would have them: elastic rings move raceways alone.
        """
        levers, (sin, cos), (slope_z, slope_y) = self.ribs, self.outwards, x.ring[TILT_Z:]
        assert levers is not None  # or nothing would be pressed on ribs
        tilt = x.tilt if deviation is None else x.tilt + deviation[OUTER, 1]
        turned = levers.radius * (slope_z * cos + slope_y * sin)
        return x.shift - turned - levers.distance / self.half_length * tilt

    @staticmethod
    def deviate(approach: NDArray, deviation: NDArray) -> None:
        """Add outward deviations of the raceways to the approaches, both (2, M, C, Z), in place.

        The roller follows the outer raceway's height and tilt but not its waviness: those two
        change the inner approach, the rest the outer one.
        """
        inner, outer = deviation
        approach[INNER] += inner
        approach[INNER, :2] -= outer[:2]
        approach[OUTER, 2:] -= outer[2:]

    @cached_property
    def felt(self) -> NDArray:
        """Combinations of a roller's deviations (felt, deviations) that change its approaches [-].

        Those of `deviate`; between two elastic raceways height and tilt of the outer one only count against
        those of the inner one.
        """
        layout, m = self.layout, self.layout.axial_modes
        combinations = np.eye(m * len(layout.elastic_raceways))
        if len(layout.elastic_raceways) < 2:
            return combinations
        against = np.arange(layout.relative_modes)
        combinations[against, m + against] = -1.0
        return np.delete(combinations, m + against, axis=0)

    def columns(self, gradient: NDArray) -> NDArray:
        """Derivatives by the unknowns (rows, columns, C, Z) from those by a roller's inputs."""
        m, ring = self.layout.axial_modes, self.layout.per_roller  # where ring and cage begin in the table
        columns = ring + self.layout.border + self.layout.felt
        table = np.zeros((len(gradient), columns, *gradient.shape[2:]))
        inner, outer = gradient[:, :m], gradient[:, m : 2 * m]
        spin, cage, film = gradient[:, SPIN], gradient[:, CAGE_SPEED], gradient[:, FILM_I:VALUE]
        np.subtract(outer[:, 0], inner[:, 0], out=table[:, 0])
        np.add(film, inner[:, :1], out=table[:, ring - 3 : ring - 1])
        table[:, ring - 1] = spin
        np.multiply(self.outwards, inner[:, :1], out=table[:, ring + Y : ring + Z + 1])
        table[:, ring + CAGE] = cage
        if m > 1:
            sin, cos = self.outwards
            table[:, 1] = outer[:, 1] - inner[:, 1]
            table[:, ring + TILT_Z] = self.half_length * cos * inner[:, 1]
            table[:, ring + TILT_Y] = self.half_length * sin * inner[:, 1]
            if self.stations is not None:
                table[:, ring + TILT_Z] += self.stations * cos * inner[:, 0]
                table[:, ring + TILT_Y] += self.stations * sin * inner[:, 0]
        if self.ribs is not None:
            closing, (sin, cos) = gradient[:, RIB], self.outwards
            table[:, 1] -= self.ribs.distance / self.half_length * closing
            table[:, ring + TILT_Z] -= self.ribs.radius * cos * closing
            table[:, ring + TILT_Y] -= self.ribs.radius * sin * closing
            table[:, ring + SHIFT] = closing
        if self.layout.elastic_raceways:
            table[:, ring + self.layout.border :] = self._by_felt(inner, outer, gradient[:, RIB])
        return table

    def _by_felt(self, inner: NDArray, outer: NDArray, closing: NDArray) -> NDArray:
        """Derivatives (rows, felt, C, Z) by felt deviations.

        From those by the approaches (rows, M, C, Z), and by how far ribs close (rows, C, Z) if there are any.
        """
        by_outer = np.concatenate([-inner[:, :2], -outer[:, 2:]], axis=1)
        if self.ribs is not None:
            by_outer[:, 1] -= self.ribs.distance / self.half_length * closing
        if INNER not in self.layout.elastic_raceways:
            return by_outer
        if OUTER not in self.layout.elastic_raceways:
            return inner
        return np.concatenate([inner, by_outer[:, self.layout.relative_modes :]], axis=1)

    def rows(self, response: NDArray, free_tilt: NDArray) -> NDArray:
        """Rows of the table from those of a roller's response (rows, inputs + 1, C, Z).

        `free_tilt` (C, 1) says whether a ring may tilt: no moment reaches one that may not.
        """
        m, ring = self.layout.axial_modes, self.layout.per_roller  # where ring and cage begin in the table
        cage, tangential = response[ring], response[ring + 1]
        first = len(response) - 2 * m  # row of the forces conjugate to the axial modes
        inner = response[first : first + m]
        border = self.layout.border
        rows = np.zeros((ring + border + m * len(self.layout.elastic_raceways), *response.shape[1:]))
        rows[:ring] = response[:ring]
        rows[ring + Y : ring + Z + 1] = self.pushed(tangential, inner[0])
        if m > 1:
            moment_z, moment_y = self.tilted(tangential, inner)
            if self.ribs is not None:
                thrust, (sin, cos) = response[first - 1], self.outwards
                moment_z = moment_z + self.ribs.radius * cos * thrust
                moment_y = moment_y + self.ribs.radius * sin * thrust
                rows[ring + SHIFT] = -thrust
            rows[ring + TILT_Z], rows[ring + TILT_Y] = free_tilt * moment_z, free_tilt * moment_y
        rows[ring + CAGE] = cage
        for place, race in enumerate(self.layout.elastic_raceways):
            start = first + race * m
            rows[ring + border + place * m : ring + border + (place + 1) * m] = response[start : start + m]
        return rows

    def pushed(self, along: NDArray, outward: NDArray) -> NDArray:
        """Force (2, n, C, Z) [N], y and z, on what pushes rollers (n, C, Z) along the motion and outwards."""
        sin, cos = self.outwards
        against_motion, inwards = np.array([[-cos, sin], [-sin, -cos]])[:, :, None]
        return against_motion * along + inwards * outward

    def tilted(self, along: NDArray, inner: NDArray) -> tuple[NDArray, NDArray]:
        """Moments (n, C, Z) [N m] on slopes dz/dx and dy/dx of the inner ring, about the middle of the rings.

        By forces on rollers along the motion (n, C, Z) and those of the inner contacts (M, n, C, Z), M > 1.
        """
        sin, cos = self.outwards
        moment = -self.half_length * inner[1]
        about_z, about_y = moment * cos, moment * sin
        if self.stations is None:
            return about_z, about_y
        push_y, push_z = self.pushed(along, inner[0])
        return about_z + self.stations * push_z, about_y + self.stations * push_y


class SpinTransport(NamedTuple):
    """Torque taken by the change of spin, with its derivatives."""

    torque: NDArray  # (C, Z) [N m]
    by_spin: NDArray  # (C, 1) [N m s]
    by_before: NDArray  # (C, 1) by the spin of the roller before, counted positive [N m s]
    by_after: NDArray  # (C, 1) by that of the roller after, counted positive [N m s]
    by_cage: NDArray  # (C, Z) [N m s]


def spin_transport(
    spin_drift: NDArray, cage_speed: NDArray, rolling_spin: NDArray, inertia: float, rows: int = 1
) -> SpinTransport:
    r"""Torque by which the spin of rollers changes while they travel from place to place.

    .. math:: M_j = J \omega_c \frac{d\omega}{d\varphi} \approx
              \frac{J Z}{2\pi} [\omega_c^+ (\omega_j - \omega_{j-1}) + \omega_c^- (\omega_j - \omega_{j+1})]

    with omega_c^(+/-) = (sqrt(omega_c^2 + s^2) +/- omega_c)/2, s = `CREEP` times the spin in pure rolling.
    Upwind, from the roller that was here before; where the cage hardly moves both neighbours count, so that
    nothing jumps when it turns back.

    Parameters
    ----------
    spin_drift : array (C, Z)
        spins less that of pure rolling [rad/s]
    cage_speed : array (C, 1)
        omega_c [rad/s]
    rolling_spin : array (C, 1)
        spin in pure rolling [rad/s]
    inertia : float
        J of a roller about its axis [kg m2]
    rows : int
        rows of rollers, one after the other; each has Z rollers of its own

    Source
    ------
    Change of angular momentum along the path of the rollers, upwind differences; derived here.

    Valid
    -----
    First order in the pitch: spins are smeared over about a pitch at the ends of the loaded zone.
    """
    half = inertia * spin_drift.shape[1] / rows / (4 * np.pi)
    size = np.sqrt(cage_speed**2 + (CREEP * rolling_spin) ** 2)
    before, after = half * (size + cage_speed), half * (size - cage_speed)
    of_rows = spin_drift.reshape(len(spin_drift), rows, -1)
    around = np.concatenate([of_rows[..., -1:], of_rows, of_rows[..., :1]], axis=-1)
    change = around[..., 1:] - around[..., :-1]  # from each one's neighbour before to that after the last
    gained = before * change[..., :-1].reshape(spin_drift.shape)
    lost = after * change[..., 1:].reshape(spin_drift.shape)
    return SpinTransport(
        torque=gained - lost,
        by_spin=2 * half * size,
        by_before=before,
        by_after=after,
        by_cage=(gained + lost) / size,
    )


def next_in_row(values: NDArray, places: int, rows: int) -> NDArray:
    """Values (..., Z) of the rollers so many places further along the motion, each in its row.

    >>> next_in_row(np.arange(6), 1, 2).tolist()
    [1, 2, 0, 4, 5, 3]
    """
    of_rows = values.reshape(*values.shape[:-1], rows, -1)
    return np.concatenate([of_rows[..., places:], of_rows[..., :places]], axis=-1).reshape(values.shape)
