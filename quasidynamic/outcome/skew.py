"""Skew of rollers between guide flanges, at an equilibrium of the bearing."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.skew import AxialTraction, RunningRollers, SkewBalance, SkewMoments
from quasidynamic.contact.flange import flange_forces, flange_push
from quasidynamic.contact.raceways import Raceways
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing, Flange
from quasidynamic.solve.rollers.skew_equilibrium import skew_equilibrium


@dataclass(frozen=True)
class Skew:
    """Rollers in balance between their flanges."""

    balance: SkewBalance
    angle: NDArray  # (Z) [rad] positive when the +x end leads
    beyond: NDArray  # (Z) |angle| less the touching one [rad]

    @cached_property
    def moments(self) -> SkewMoments:
        """Moments about the radial axes."""
        return self.balance.moments(self.angle, self.beyond)

    @cached_property
    def axial_traction(self) -> AxialTraction:
        """Axial tractions of the raceways."""
        return self.balance.axial_traction(self.angle)

    @property
    def flange_forces(self) -> NDArray:
        """Force of the flange at the -x and at the +x end (2, Z) [N], >= 0."""
        thrust, lever = self.axial_traction.thrust, self.balance.corner.lever
        return flange_forces(flange_push(self.beyond, thrust, self.balance.flange, lever), thrust)

    @property
    def flange_power(self) -> NDArray:
        """Power (Z) that friction at the flanges turns into heat [W]."""
        friction = self.balance.flange.friction * self.flange_forces.sum(axis=0)
        return friction * np.hypot(*self.balance.corner_sliding)

    @property
    def axial_sliding_power(self) -> NDArray:
        """Power (Z) that axial sliding on the raceways turns into heat [W]."""
        inner, outer = self.axial_traction.force
        return self.balance.surface_speed * self.angle * (inner - outer)

    # -- what the equilibrium does not contain -------------------------------------------------

    @property
    def end_gap(self) -> float:
        """Largest change of the gap at a roller's end, l^2 psi^2/(8 r_m) [m]."""
        length, pitch = self.balance.bearing.roller.length, self.balance.bearing.pitch_diameter
        return float((length**2 * self.angle**2).max() / (4 * pitch))

    @property
    def load_shift(self) -> float:
        r"""Largest shift along a loaded roller from outer to inner load that axial forces require [m].

        .. math:: |r_w (F_{xi} - F_{xo}) + \rho (F_{xi} + F_{xo})| / Q_i

        Source
        ------
        Moment of the axial forces about the motion, over the inner load; derived here.
        """
        inner, outer = self.axial_traction.force
        couple = self.balance.bearing.roller.diameter / 2 * (inner - outer)
        couple = np.abs(couple + self.balance.corner.level * (inner + outer))
        load = self.balance.running.slice_load[0] @ self.balance.raceways.slices.widths
        loaded = load > 0.01 * load.max()
        return float((couple[loaded] / load[loaded]).max(initial=0.0))

    @property
    def traction_change(self) -> float:
        """Largest change of a traction along the motion at the same sliding, over the largest [-]."""
        before = self.balance.traction_along(np.zeros_like(self.angle))
        change = np.abs(self.balance.traction_along(self.angle) - before).max()
        return float(change / np.abs(before).max()) if change else 0.0


def skewed(
    running: RunningRollers, raceways: Raceways, bearing: CylindricalRollerBearing, flange: Flange
) -> Skew:
    """Skew of every roller at an equilibrium that was found without skew; zero under symmetric loads.

    Raises `NotSolved` when nothing holds a roller below half a radian.

    Source
    ------
    Balance about the radial axis and along the bearing axis, derived here.

    Valid
    -----
    Small angles; cage pockets leave the rollers free to skew. What the skew would change in the equilibrium
    is outside the balance: `end_gap`, `load_shift`, `traction_change` and the two powers say how much it is.
    """
    balance = SkewBalance(running=running, raceways=raceways, bearing=bearing, flange=flange)
    return Skew(balance, *skew_equilibrium(balance))
