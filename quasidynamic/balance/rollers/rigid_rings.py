"""Two rigid rings on rollers without friction, film or centrifugal force: forces and their derivatives."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line.load_law import EXPONENT, LoadLaw, gap_rounding, raceway_coefficients
from quasidynamic.contact.line.slices import Slices
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing


class Stations(NamedTuple):
    """Rollers beside the middle of the rings: a tilt moves them along the radius, and so they tilt the ring.

    M is 1 or 2, with tilt.
    """

    ratio: NDArray | None  # (Z) place along the axis over half the length [-]; None: all in the middle

    @classmethod
    def of(cls, bearing: CylindricalRollerBearing, half_length: NDArray | float) -> "Stations":
        """Stations of the rollers of a bearing."""
        return cls(None if bearing.stations is None else bearing.stations / half_length)

    def at_rollers(self, place: NDArray) -> NDArray:
        """Displacement at mid-roller and half the length times slope (Z, M) [m] from those at the middle."""
        if self.ratio is None or place.shape[1] == 1:
            return place
        return place + np.array([self.ratio * place[:, 1], np.zeros_like(self.ratio)]).T

    def about_middle(self, force: NDArray) -> NDArray:
        """Forces conjugate to displacements at the middle (Z, M) [N] from those at the rollers."""
        if self.ratio is None or force.shape[1] == 1:
            return force
        return force + np.array([np.zeros_like(self.ratio), self.ratio * force[:, 0]]).T

    def stiffness_about_middle(self, stiffness: NDArray) -> NDArray:
        """The same of stiffnesses (Z, M, M) [N/m]."""
        if self.ratio is None or stiffness.shape[1] == 1:
            return stiffness
        lever = np.eye(2) + np.multiply.outer(self.ratio, np.array([[0.0, 1.0], [0.0, 0.0]]))
        return lever.swapaxes(1, 2) @ stiffness @ lever


class RigidRingState(NamedTuple):
    """Forces on the ring at one place of it; M is 1 or 2, with tilt."""

    place: NDArray  # (2, M) y, z and half the length times dy/dx, dz/dx [m]
    slice_load: NDArray  # (Z, K) [N/m]
    excess: NDArray  # (2, M) load less what the rollers carry [N]
    stiffness: NDArray  # (2, M, 2, M) [N/m]


@dataclass(frozen=True)
class RigidRings:
    """Two rigid rings with rollers between them."""

    law: LoadLaw  # of both raceways together
    slices: Slices
    normal: NDArray  # (Z, 2) y, z of the outward radius at each roller
    gap: NDArray  # (K), or (Z, K) with form errors, that has to close before a slice carries [m]
    load: NDArray  # (2, M) [N] force along y, z and moment over half the length
    stations: Stations

    @classmethod
    def of(cls, bearing: CylindricalRollerBearing, slices: Slices, load: NDArray) -> "RigidRings":
        """Build from a bearing; approaches of both raceways add up under the same load."""
        softness = sum(coefficient ** (-1 / EXPONENT) for coefficient in raceway_coefficients(bearing))
        drops = (bearing.drop(race, slices.centres, slices.length) for race in (0, 1))
        return cls(
            law=LoadLaw(softness**-EXPONENT, gap_rounding(bearing)),
            slices=slices,
            normal=np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)]).T,
            gap=np.asarray(bearing.clearances)[..., None] / 2 + sum(drops),
            load=load,
            stations=Stations.of(bearing, slices.length / 2),
        )

    def with_gap(self, further: float) -> "RigidRings":
        """The same rings with a further gap [m] at every roller."""
        return replace(self, gap=self.gap + further)

    def at(self, place: NDArray) -> RigidRingState:
        """Evaluate every slice."""
        slices, m = self.slices, self.slices.axial_modes
        at_rollers = self.stations.at_rollers(self.normal @ place)
        load, slope = self.law(at_rollers @ slices.modes.T - self.gap)
        of_rollers = self.stations.stiffness_about_middle((slope @ slices.products).reshape(-1, m, m))
        squares = self._squares @ of_rollers.reshape(-1, m * m)
        stiffness = squares.reshape(2, 2, m, m).transpose(0, 2, 1, 3)
        carried = self.normal.T @ self.stations.about_middle(load @ slices.weights)
        return RigidRingState(place, load, self.load - carried, stiffness)

    @cached_property
    def _squares(self) -> NDArray:
        """Products of two components of the normals (4, Z) [-]."""
        return (self.normal[:, :, None] * self.normal[:, None, :]).reshape(-1, 4).T

    def imbalance(self, state: RigidRingState) -> float:
        """Largest unbalanced force over the largest force [-]."""
        largest = max(np.abs(self.load).max(), (state.slice_load @ self.slices.widths).max())
        return float(np.abs(state.excess).max() / largest)

    def first_place(self) -> NDArray:
        """Ring (2, M) where the nearest roller alone would carry the load: too far, but on the safe side."""
        load, place = self.load[:, 0], np.zeros_like(self.load)
        size = float(np.hypot(*load))
        if size == 0.0:
            return place
        nearest = (self.normal @ load).max() / size
        approach = self.gap.min(axis=-1).max() + self.law.approach(
            np.asarray(size / nearest / self.slices.length)
        )
        place[:, 0] = load / size * max(approach, 0.0) / nearest
        return place
