"""Diagonals of a four-point contact ball bearing: loads by the distance of opposite groove centres."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.point_contact import point_contact, race_curvatures
from quasidynamic.motion.ball_slip import SIDE
from quasidynamic.parts.ball import FourPointBearing

SIDE_OF_DIAGONAL = np.array([1.0, -1.0])  # sign of the axial direction in which it points outwards


class LoadedDiagonals(NamedTuple):
    """What diagonals do at one place of the inner ring; vectors are axial, to their own side, and radial."""

    approach: NDArray  # (Z, 2) [m] of ball and grooves, negative in a gap
    loads: NDArray  # (Z, 2) [N]
    angles: NDArray  # (Z, 2) [rad]
    force: NDArray  # (Z, 2, 2) of the balls on the outer ring [N]; the inner ring has the opposite
    stiffness: NDArray  # (Z, 2, 2, 2) of that force by the distance of the groove centres [N/m]
    turn: NDArray  # (Z, 2, 2) of the angle by that distance [rad/m]


@dataclass(frozen=True)
class Diagonals:
    """Balls between two rings; moments and tilts are taken over the pitch radius."""

    coefficient: float  # K [N/m^1.5]
    touching: float  # [m] distance of the groove centres at which a diagonal begins to carry
    start: NDArray  # (2) [m] distance of the groove centres of a diagonal, rings concentric
    moves: NDArray  # (Z, 2, 2, 5) [-] displacement of the inner ring along each diagonal by its place

    @classmethod
    def of(cls, bearing: FourPointBearing) -> "Diagonals":
        """Build from a bearing."""
        cosine, sine = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
        none, one = np.zeros_like(cosine), np.ones_like(cosine)
        angle, distance = bearing.contact_angle, bearing.centre_distance - bearing.clearance
        outward = np.stack([none, sine, cosine, none, none], 1)
        along = np.stack([one, none, none, cosine, -sine], 1)
        return cls(
            coefficient=diagonal_coefficient(bearing),
            touching=bearing.centre_distance,
            start=distance * np.array([np.sin(angle), np.cos(angle)]),
            moves=np.stack([np.stack([side * along, outward], 1) for side in SIDE_OF_DIAGONAL], 1),
        )

    def at(self, place: NDArray, deflection: NDArray | float = 0.0) -> LoadedDiagonals:
        r"""Evaluate every diagonal.

        .. math:: Q = K [L - A]_+^{3/2},\quad F = Q e,\quad
                  \frac{dF}{dv} = \tfrac32 K [L - A]_+^{1/2}\,e e^T + \frac{Q}{L}\,(1 - e e^T),\quad
                  e = v/L,\quad L = |v|

        The place (5) is x, y, z of the inner ring and its tilts about y and z, times the pitch radius [m].
        The deflection (Z, 2, 2) [m] is by how much elastic rings let the groove centres of each diagonal come
        closer: the part of v that is lost.

        Source
        ------
        Derivative of a spring force along its own direction; Hertz stiffness K of the two contacts in
        series.
        """
        v = self.start + self.moves @ place - deflection
        length = np.hypot(v[..., 0], v[..., 1])
        signed = length - self.touching
        approach = np.maximum(signed, 0.0)
        loads = self.coefficient * approach**1.5
        e = v / length[..., None]
        normal, turning = 1.5 * self.coefficient * np.sqrt(approach), loads / length
        along = e[..., :, None] * e[..., None, :]
        return LoadedDiagonals(
            approach=signed,
            loads=loads,
            angles=np.arctan2(v[..., 0], v[..., 1]),
            force=loads[..., None] * e,
            stiffness=normal[..., None, None] * along + turning[..., None, None] * (np.eye(2) - along),
            turn=np.stack([e[..., 1], -e[..., 0]], -1) / length[..., None],
        )

    def carried(self, force: NDArray) -> NDArray:
        """Load (5) [N] that forces (Z, 2, 2) of the diagonals carry."""
        return np.einsum("jdcp,jdc->p", self.moves, force)

    def stiffness(self, each: NDArray) -> NDArray:
        """Stiffness (5, 5) of the ring by those of the diagonals (Z, 2, 2, 2) [N/m]."""
        return np.einsum("jdcp,jdcb,jdbq->pq", self.moves, each, self.moves, optimize=True)


def diagonal_coefficient(bearing: FourPointBearing) -> float:
    """Coefficient K of a diagonal, both contacts in series, at the unloaded contact angle [N/m^1.5]."""
    curvatures = race_curvatures(
        bearing.ball.diameter, bearing.groove_radii, bearing.pitch_diameter, bearing.contact_angle, SIDE
    )
    both = point_contact(curvatures, bearing.moduli).coefficient
    return float((both ** (-2 / 3)).sum() ** -1.5)
