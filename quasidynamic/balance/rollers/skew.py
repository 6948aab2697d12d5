"""Balance of skewed rollers about their radial axes."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.flange import (
    FlangeCorner,
    corner_couple,
    corner_sliding,
    flange_corner,
    touching_skew,
)
from quasidynamic.contact.raceways import Raceways
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing, Flange


class RunningRollers(NamedTuple):
    """What the rollers do at an equilibrium; inner raceway first, K slices as they are computed."""

    slice_load: NDArray  # (2, Z, K) [N/m]
    sliding: NDArray  # (2, Z) raceway over roller surface, positive along the motion [m/s]
    entrainment: NDArray  # (2, Z) [m/s]
    film: NDArray  # (2, Z) [m]
    rolling_shear: NDArray  # (2, Z) signed along the rolling [N]
    spin: NDArray  # (Z) relative to the cage [rad/s]
    ring_speed: float  # of the flanged ring against the cage [rad/s]


class AxialTraction(NamedTuple):
    """Axial traction of the raceways on skewed rollers."""

    force: NDArray  # (2, Z) [N]
    by_skew: NDArray  # (2, Z) [N/rad]

    @property
    def thrust(self) -> NDArray:
        """Sum of both raceways (Z) [N]."""
        return self.force.sum(axis=0)


class SkewMoments(NamedTuple):
    """Moments about the radial axis of a roller (Z), positive from +x towards the motion [N m]."""

    traction: NDArray  # of the raceways' forces along the motion
    restoring: NDArray  # of loads on the curved raceways
    corner: NDArray  # of the flanges' normal forces
    friction: NDArray  # of the flanges' friction along the motion

    @property
    def unbalanced(self) -> NDArray:
        """Sum of all (Z) [N m]."""
        return self.traction + self.restoring + self.corner + self.friction


@dataclass(frozen=True, kw_only=True)
class SkewBalance:
    r"""Balance of rollers about their radial axes, everything else as at the equilibrium.

    .. math:: M_T - k_R \psi - M_c \operatorname{sgn}\psi + \mu \frac{l}{2} F_x \frac{s_t}{|s|} = 0

    with the moment of the slices' tractions and inlet shears

    .. math:: M_T = \sum_k x_k [t_i + t_o + (1 - 2\gamma) f_i - (1 + 2\gamma) f_o]_k \Delta x

    the couple M_c of the corners, see `corner_couple`, and the stiffness k_R of cylinders that cross at a
    small angle. Skew is positive when the +x end leads. M_T does not depend on the skew: its tractions are
    those that balance the roller.

    Source
    ------
    Balance of moments about the radial axis through a roller's centre, derived here.

    Valid
    -----
    Small angles; loads, speeds along the motion and films as at the equilibrium without skew.
    """

    running: RunningRollers
    raceways: Raceways
    bearing: CylindricalRollerBearing
    flange: Flange

    @cached_property
    def corner(self) -> FlangeCorner:
        """Corner of the roller's end."""
        return flange_corner(self.flange, self.bearing)

    @cached_property
    def touching(self) -> float:
        """Skew at which two corners touch [rad]."""
        return touching_skew(self.flange, self.corner.lever)

    @cached_property
    def surface_speed(self) -> NDArray:
        """Speed of the rollers' surfaces (Z) in the cage's frame [m/s]."""
        return self.running.spin * self.bearing.roller.diameter / 2

    @cached_property
    def corner_sliding(self) -> NDArray:
        """Sliding of the flange over the corners (2, Z), along the motion and radially [m/s]."""
        pitch = self.bearing.pitch_diameter / 2
        return corner_sliding(self.corner, self.running.spin, self.running.ring_speed, pitch)

    @cached_property
    def forces_along(self) -> NDArray:
        """Forces of both raceways along the motion (Z, K) per length [N/m]."""
        ratio = self.bearing.diameter_ratio
        traction = self._traction(np.zeros_like(self.running.spin))[0].sum(axis=0)
        inner, outer = self._inlet_shears()
        return traction + (1 - 2 * ratio) * inner - (1 + 2 * ratio) * outer

    @cached_property
    def traction_moment(self) -> NDArray:
        """M_T (Z) [N m]; exactly zero under symmetric loads."""
        slices = self.raceways.slices
        along = slices.unfolded(self.forces_along)
        odd = 0.5 * (along - along[..., ::-1])
        return odd @ slices.all_centres * slices.width

    @cached_property
    def raceway_stiffness(self) -> NDArray:
        r"""Moment (Z) per skew that the loads on curved raceways give [N m/rad].

        .. math:: k_R = \frac{1}{r_m} \sum_k (q_o - q_i)_k x_k^2 \Delta x

        A skewed roller is further from the bearing axis by x^2 psi^2/(2 r_m): closer to the outer raceway,
        farther from the inner one. The first order of it is a moment, and the only one that holds a
        roller inside the clearance of its flanges; negative where the inner loads sit further out.
        """
        slices = self.raceways.slices
        inner, outer = self.running.slice_load
        return 2 / self.bearing.pitch_diameter * ((outer - inner) * slices.widths) @ slices.centres**2

    def axial_traction(self, skew: NDArray) -> AxialTraction:
        r"""Axial tractions of the raceways.

        .. math:: F_x = \sum_k t(|s|)_k \frac{s_x}{|s|} \Delta x,\quad s_x = \pm w r_w \psi,\;
                  |s| = \sqrt{u^2 + s_x^2}

        upper sign at the inner raceway. Sliding along the motion and film are those of the equilibrium.
        """
        across, by_skew = self._traction(skew)[1:]
        widths = self.raceways.slices.widths
        return AxialTraction(across @ widths, by_skew @ widths)

    def traction_along(self, skew: NDArray) -> NDArray:
        """Tractions (2, Z) along the motion that are left of the same sliding [N]."""
        return self._traction(skew)[0] @ self.raceways.slices.widths

    def moments(self, skew: NDArray, beyond: NDArray | None = None) -> SkewMoments:
        """Moments about the radial axes; `beyond` spares the digits of |skew| less the touching one."""
        beyond = np.abs(skew) - self.touching if beyond is None else beyond
        thrust = self.axial_traction(skew).thrust
        couple = corner_couple(np.abs(skew), beyond, thrust, self.flange, self.corner.lever)
        return SkewMoments(
            traction=self.traction_moment,
            restoring=-self.raceway_stiffness * skew,
            corner=-couple * np.sign(skew),
            friction=self._friction_lever * thrust,
        )

    @property
    def _friction_lever(self) -> NDArray:
        """Moment of the corners' friction (Z) per thrust [m]."""
        along, size = self.corner_sliding[0], np.hypot(*self.corner_sliding)
        direction = np.divide(along, size, out=np.zeros_like(size), where=size > 0)
        return self.flange.friction * self.bearing.roller.length / 2 * direction

    def residual(self, skew: NDArray, beyond: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Unbalanced moment (Z) towards more skew, its slope and the sum of the sizes of its parts."""
        axial, lever = self.axial_traction(skew), self.corner.lever
        thrust, by_skew = axial.thrust, axial.by_skew.sum(axis=0)
        couple = corner_couple(skew, beyond, thrust, self.flange, lever)
        stiff = 2 * self.flange.stiffness * lever**2
        free = couple == lever * np.abs(thrust)  # neither flat on one flange nor held by both
        couple_slope = np.where(free, lever * np.sign(thrust) * by_skew, stiff)
        driving, friction = np.abs(self.traction_moment), self._friction_lever * thrust
        parts = np.array([driving, -self.raceway_stiffness * skew, -couple, friction])
        slope = -self.raceway_stiffness - couple_slope + self._friction_lever * by_skew
        return parts.sum(axis=0), slope, np.abs(parts).sum(axis=0)

    def _traction(self, skew: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Tractions (2, Z, K) along and across the motion, the latter also by skew [N/m]."""
        running, speed = self.running, np.array([1.0, -1.0])[:, None] * self.surface_speed
        along, across = running.sliding, speed * skew
        size = np.hypot(along, across)
        sliding, entrainment, film = (each[:, None] for each in (size, running.entrainment, running.film))
        law = self.raceways.traction(self._slices_first, sliding, entrainment, film)
        total, steepness = (np.moveaxis(each[:, :, 0], 0, -1) for each in (law.force, law.by_sliding))
        # without any sliding there is no traction, and no direction is needed
        safe = np.where(size > 0, size, 1.0)
        cos, sin = (part / safe for part in (along, across))
        # at rest the law is a line through zero
        secant = np.where(size[..., None] > 0, total / safe[..., None], steepness)
        by_speed = steepness * sin[..., None] ** 2 + secant * (1 - sin[..., None] ** 2)
        return total * cos[..., None], total * sin[..., None], by_speed * speed[..., None]

    @property
    def _slices_first(self) -> NDArray:
        """Load per length (K, 2, 1, Z) [N/m], as the laws of the raceways take it."""
        return np.moveaxis(self.running.slice_load, -1, 0)[:, :, None]

    def _inlet_shears(self) -> NDArray:
        """Inlet shears (2, Z, K) per length [N/m]: the balance's own, spread as by the law."""
        running, raceways = self.running, self.raceways
        slice_load = self._slices_first * raceways.slices.length
        shear = raceways.rolling(slice_load, running.entrainment[:, None]).force
        shear = np.moveaxis(shear[:, :, 0], 0, -1)
        total = shear @ raceways.slices.widths
        scale = np.divide(running.rolling_shear, total, out=np.zeros_like(total), where=total > 0)
        return shear * scale[..., None]
