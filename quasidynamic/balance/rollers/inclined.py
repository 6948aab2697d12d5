"""Rollers between inclined raceways, on the rib of the inner ring: forces and their derivatives."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line.load_law import LoadLaw, gap_rounding, raceway_coefficients, smooth_positive
from quasidynamic.contact.line.slices import Slices
from quasidynamic.contact.rib import EXPONENT as RIB_EXPONENT

if TYPE_CHECKING:
    from quasidynamic.parts.tapered_bearing import TaperedRollerBearing

INNER, OUTER, RIB = 0, 1, 2
HELD = 5  # displacements of a ring: x, y, z, and turns about y and z times the pitch radius
SECTION = 3  # those of a section: along the axis, outwards, turn times half of the roller's length


class InclinedState(NamedTuple):
    """Forces at one place of ring and rollers; Z rollers, K slices."""

    ring: NDArray  # (5) [m]
    rollers: NDArray  # (Z, 3) [m]
    slice_load: NDArray  # (2, Z, K) [N/m] inner, outer
    slice_slope: NDArray  # (2, Z, K) [N/m2] of these by the approach
    rib_load: NDArray  # (Z) [N]
    rib_slope: NDArray  # (Z) [N/m] of these by the approach
    excess: NDArray  # (Z, 3) [N] of forces on rollers: minus the gradient of the energy
    on_ring: NDArray  # (Z, 3) [N] of the rollers on a section of the inner ring
    stiffness: NDArray  # (Z, 3, 3) [N/m] of a roller against both rings
    by_ring: NDArray  # (Z, 3, 3) [N/m] of the forces on a roller by the section of the inner ring


@dataclass(frozen=True)
class InclinedRollers:
    r"""Rollers whose radial direction is turned by alpha_o at the outer and alpha_i at the inner contact.

    .. math:: \delta_o = N_o \cdot u_w + \vartheta_w s - C_o,\quad
              \delta_i = N_i \cdot (u_w - u) - (\vartheta_w - \vartheta) s - G/2 \cos\alpha_i - C_i,

    .. math:: \delta_f = N_f \cdot (u_w - u) + h (\vartheta_w - \vartheta),

    with N_o = (-sin, cos) alpha_o, N_i = (sin, -cos) alpha_i, N_f = (cos, sin) alpha_f, places s along the
    contact, u and theta of the section of the inner ring, u_w and theta_w of the roller, which lift the end
    at the rib; x towards the rib. All forces derive from one convex energy.

    Source
    ------
    Geometry, small displacements; derived here. Angles zero: the cylindrical roller of `Kinematics`.
    """

    law: LoadLaw  # of both raceways, inner first
    slices: Slices
    drops: NDArray  # (2, 1 or Z, K) [m] with the shape of elastic raceways
    normals: NDArray  # (3, 3) of inner and outer raceway and rib: unit displacements to their approaches [-]
    gap: float | NDArray  # [m] at the inner raceway, one or that of every roller (Z, 1)
    rib_stiffness: float  # [N/m^1.5]
    radius: float  # [-] of the rollers, normal to their raceways, over half of their length
    sections: NDArray  # (Z, 3, 5) displacements of a section of the inner ring by those of the ring [-]
    shifts: NDArray  # (Z, 3) [m] of the sections where the ring is at zero: rows that are closer
    dead: NDArray  # (3) or (Z, 3) [N] on every roller: axial, outwards, moment over half the length
    rib_drop: NDArray | float = 0.0  # (Z) [m] by which an elastic ring takes its rib away
    opposite: NDArray | None = None  # (3) of a rib of the outer ring at the other end, as of `normals` [-]
    opposite_stiffness: float = 0.0  # [N/m^1.5] of that rib
    hollows: tuple[float, float] = (0.0, 0.0)  # [-] half length of the rollers over the radius of raceways

    @classmethod
    def of(cls, bearing: "TaperedRollerBearing", slices: Slices, dead: NDArray) -> "InclinedRollers":
        """Build from a bearing and the centrifugal force and gyroscopic moment on its rollers."""
        half = bearing.roller.length / 2
        cone, cup, rib = bearing.cone_angle, bearing.cup_angle, bearing.rib
        law = LoadLaw(np.reshape(raceway_coefficients(bearing), (2, 1, 1)), gap_rounding(bearing))
        drops = np.array([bearing.drop(race, slices.centres, slices.length) for race in (INNER, OUTER)])
        return cls(
            law=law,
            slices=slices,
            drops=drops[:, None],
            normals=np.array(
                [
                    [np.sin(cone), -np.cos(cone), -1.0],
                    [-np.sin(cup), np.cos(cup), 1.0],
                    [np.cos(rib.angle), np.sin(rib.angle), rib.lever / half],
                ]
            ),
            gap=bearing.clearance / 2 * np.cos(cone),
            rib_stiffness=rib.stiffness,
            radius=bearing.roller.diameter / np.cos(bearing.taper) / bearing.roller.length,
            sections=np.concatenate(
                [
                    sections_of_row(
                        azimuths,
                        bearing.pitch_diameter / 2,
                        half,
                        -side,
                        row.axial,
                    )
                    for side, row, azimuths in zip(
                        bearing.sides,
                        bearing.rows,
                        np.split(bearing.azimuths, len(bearing.rows)),
                        strict=True,
                    )
                ]
            ),
            shifts=_shifts(bearing),
            dead=dead,
            hollows=(bearing.hollows[INNER] * half, bearing.hollows[OUTER] * half),
        )

    @cached_property
    def _modes(self) -> NDArray:
        """Approaches of slices by mean and turn: (K, 2) [-]."""
        return self.slices.modes

    @cached_property
    def levers(self) -> NDArray:
        r"""Unit displacements of a section to the mean and the turn of its approach (2, 2, 3) [-].

        .. math:: \delta = N \cdot u \pm s\, \vartheta (1 - D/2r) + s\, T \cdot u/r

        (upper sign outer) with T along the roller's axis to its large end: a barrel that moves along its axis
        comes closer to a hollow raceway of radius r at one end.

        Source
        ------
        Geometry of circles that nearly osculate, to first order; derived here. Straight raceways: 1/r = 0.
        """
        mean = self.normals[:2] * [1.0, 1.0, 0.0]
        turn = self.normals[:2] * [0.0, 0.0, 1.0]
        for race, hollow in enumerate(self.hollows):
            if hollow:
                along = np.array([mean[OUTER, 1], -mean[OUTER, 0], 0.0])
                turn[race] = turn[race] * (1.0 - self.radius * hollow) + hollow * along
        return np.stack([mean, turn], axis=1)

    @cached_property
    def _pairs(self) -> NDArray:
        """Products of two of these (2, 4, 9) [-]."""
        return np.einsum("rmd,rne->rmnde", self.levers, self.levers).reshape(2, 4, 9)

    def section(self, ring: NDArray) -> NDArray:
        """Displacement of the sections of the inner ring (Z, 3) [m]."""
        return self.sections @ ring + self.shifts

    def slid(self, ring: NDArray, rollers: NDArray) -> NDArray:
        """Rollers (Z, 3) [m] slid on cup and rib from where they were with the ring at zero.

        What cup and rib carry is the same: without the inner raceway they stay in balance.
        """
        cup, rib = self.normals[OUTER], self.normals[RIB]
        along = np.array([cup[1], -cup[0], 0.0])
        return rollers + np.outer((self.section(ring) @ rib + self.rib_drop) / (along @ rib), along)

    def rib_readings(self, modes: int) -> NDArray:
        r"""Displacement of the rib along its normal by those of an elastic inner raceway (M + 1) [-].

        .. math:: u = w_0 N_i + \Big( t + \frac{w_1 D}{l \cos\varepsilon} \Big) T_i,\quad
                  \vartheta = -2 w_1/l,\quad w_f = N_f \cdot u + h \vartheta

        for the modes w along its normal N_i, into the ring, and the mean displacement t along the raceway T_i
        towards the rib; by virtual work they also say what a load on the rib is for the raceway.

        Source
        ------
        Rigid motion of a section that has these mean displacements and this turn; derived here.

        Valid
        -----
        Ribs that move with the section under the raceway, not bent against it.
        """
        normal = self.normals[INNER] * [1.0, 1.0, 0.0]
        along = np.array([-normal[1], normal[0], 0.0])
        moved = np.zeros((SECTION, modes + 1))
        moved[:, 0], moved[:, 1], moved[:, -1] = normal, self.radius * along, along
        moved[2, 1] = -1.0
        return self.normals[RIB] @ moved

    def closed(self, ring: NDArray, rollers: NDArray) -> NDArray:
        """Largest approach of each roller to the inner raceway (Z) [m], negative in a gap."""
        mean_and_turn = (rollers - self.section(ring)) @ self.levers[INNER].T
        return (mean_and_turn @ self._modes.T - self.drops[INNER]).max(1) - np.ravel(self.gap)

    def at(self, ring: NDArray, rollers: NDArray) -> InclinedState:
        """Evaluate every slice and the rib."""
        moved = np.stack([rollers - self.section(ring), rollers])  # against inner and outer ring
        approach = moved @ self.levers.swapaxes(1, 2) @ self._modes.T - self.drops
        approach[INNER] -= self.gap
        load, slope = self.law(approach)
        on = load @ self.slices.weights @ self.levers
        by = (slope @ self.slices.products @ self._pairs).reshape(2, len(rollers), SECTION, SECTION)
        closed = moved[INNER] @ self.normals[RIB] - self.rib_drop
        rib, rib_slope = self._rib(closed, self.rib_stiffness)
        inner, inner_by = _with_rib(on[INNER], by[INNER], rib, rib_slope, self.normals[RIB])
        outer, outer_by = on[OUTER], by[OUTER]
        if self.opposite is not None:
            other = self._rib(moved[OUTER] @ self.opposite, self.opposite_stiffness)
            outer, outer_by = _with_rib(outer, outer_by, *other, self.opposite)
        return InclinedState(
            ring=ring,
            rollers=rollers,
            slice_load=load,
            slice_slope=slope,
            rib_load=rib,
            rib_slope=rib_slope,
            excess=self.dead - inner - outer,
            on_ring=inner,
            stiffness=inner_by + outer_by,
            by_ring=inner_by,
        )

    def _rib(self, closed: NDArray, stiffness: float) -> tuple[NDArray, NDArray]:
        """Load (Z) [N] of a rib and its slope [N/m] at an approach (Z) [m]."""
        positive, root = smooth_positive(closed, self.law.rounding)
        load = stiffness * positive**RIB_EXPONENT
        return load, RIB_EXPONENT * load / root


def _with_rib(
    on: NDArray, by: NDArray, load: NDArray, slope: NDArray, towards: NDArray
) -> tuple[NDArray, NDArray]:
    """Forces on a ring (Z, 3) and their slopes (Z, 3, 3) with those of its rib."""
    return on + load[:, None] * towards, by + slope[:, None, None] * np.outer(towards, towards)


def sections_of_row(azimuths: NDArray, pitch: float, half: float, rib: float, place: float = 0.0) -> NDArray:
    """Displacements of the sections of a row (Z, 3, 5) to the rib, outwards, turned times `half`, by a ring.

    Those of the ring are x, y, z and the turns about y and z times the pitch radius; `rib` is the side (+1 or
    -1) of the inner ring's, `place` [m] that of the row along the axis.
    """
    sin, cos, zero, place = np.sin(azimuths), np.cos(azimuths), np.zeros(len(azimuths)), place / pitch
    along = rib * np.array([zero + 1, zero, zero, cos, -sin])
    outwards = np.array([zero, sin, cos, -place * cos, place * sin])
    turned = rib * half / pitch * np.array([zero, zero, zero, -cos, sin])
    return np.stack([along, outwards, turned]).transpose(2, 0, 1)


def _shifts(bearing: "TaperedRollerBearing") -> NDArray:
    """Displacement of the sections of all rollers (Z, 3) [m] by which rows are closer, away from the rib."""
    closer = np.repeat([row.closer for row in bearing.rows], bearing.rollers)
    return np.stack([-closer, 0 * closer, 0 * closer], axis=1)
