"""Skew of rollers between guide flanges, at an equilibrium of the bearing."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.flange import flange_forces, flange_push
from quasidynamic.contact.raceways import Raceways
from quasidynamic.errors import NotSolved
from quasidynamic.outcome.skew_balance import AxialTraction, RunningRollers, SkewBalance, SkewMoments
from quasidynamic.parts.flange import Flange
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

LARGEST = 0.5  # [rad] a roller that skews further is not held
BALANCED = 1e-12  # of the moments that balance
STEPS = 200


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

    # -- what the equilibrium does not know ----------------------------------------------------

    @property
    def end_gap(self) -> float:
        """Largest change of the gap at a roller's end, l^2 psi^2/(8 r_m) [m]."""
        length, pitch = self.balance.bearing.roller.length, self.balance.bearing.pitch_diameter
        return float((length**2 * self.angle**2).max() / (4 * pitch))

    @property
    def load_shift(self) -> float:
        r"""Largest shift along a loaded roller from outer to inner load that axial forces ask for [m].

        .. math:: |r_w (F_{xi} - F_{xo}) + \rho (F_{xi} + F_{xo})| / Q_i
        """
        inner, outer = self.axial_traction.force
        couple = self.balance.bearing.roller.diameter / 2 * (inner - outer)
        couple = np.abs(couple + self.balance.corner.level * (inner + outer))
        load = self.balance.running.slice_load[0] @ self.balance.raceways.slices.widths
        return float((couple[self._loaded] / load[self._loaded]).max(initial=0.0))

    @property
    def traction_change(self) -> float:
        """Largest change of a traction along the motion at the same sliding, over the largest [-]."""
        before = self.balance.traction_along(np.zeros_like(self.angle))
        change = np.abs(self.balance.traction_along(self.angle) - before).max()
        return float(change / np.abs(before).max()) if change else 0.0

    @property
    def _loaded(self) -> NDArray:
        """Whether the inner raceway presses a roller by a hundredth of the largest load (Z)."""
        load = self.balance.running.slice_load[0] @ self.balance.raceways.slices.widths
        return load > 0.01 * load.max()


def skewed(
    running: RunningRollers, raceways: Raceways, bearing: CylindricalRollerBearing, flange: Flange
) -> Skew:
    """Skew of all rollers, each for itself, at an equilibrium that does not know of it.

    Parameters
    ----------
    running : RunningRollers
        loads [N/m], speeds [m/s, rad/s] and films [m] of the equilibrium
    raceways : Raceways
        laws of the contacts
    bearing : CylindricalRollerBearing
        dimensions
    flange : Flange
        of one ring

    Returns
    -------
    Skew
        zero for rollers under symmetric loads

    Raises
    ------
    NotSolved
        when nothing holds a roller below half a radian

    Source
    ------
    Balance about the radial axis and along the bearing axis, derived here.

    Valid
    -----
    Small angles; cage pockets leave the rollers free to skew. What the skew would change in the equilibrium
    is not fed back: `end_gap`, `load_shift`, `traction_change` and the two powers say how much it is.
    """
    balance = SkewBalance(running=running, raceways=raceways, bearing=bearing, flange=flange)
    return Skew(balance, *_balanced(balance))


def _balanced(balance: SkewBalance) -> tuple[NDArray, NDArray]:
    """Skew (Z) in balance [rad], and what of it is beyond the touching one."""
    wanted, sense = np.abs(balance.traction_moment), np.sign(balance.traction_moment)
    touching, lever = balance.touching, balance.corner.lever
    first = np.full_like(wanted, touching)
    # Beyond the clearance the unknown is counted from the touching: a stiff corner needs its digits.
    outside = (wanted > 0) & (balance.left(first, np.zeros_like(first))[0] >= 0)
    base = np.where(outside, touching, 0.0)

    def beyond(z: NDArray) -> NDArray:
        return np.where(outside, z, z - touching)

    stiff = wanted / (2 * balance.flange.stiffness * lever**2)
    size = np.where(outside, stiff, touching) * (wanted > 0)
    z = _falling_root(lambda z: balance.left(base + z, beyond(z)), size)
    return sense * (base + z), beyond(z)


def _falling_root(left: Callable[[NDArray], tuple[NDArray, NDArray, NDArray]], size: NDArray) -> NDArray:
    """Roots z >= 0 where a function that is not negative at zero falls through zero.

    Newton steps that leave the bracket, or that have not halved what is left, are replaced by halving.
    """
    low, high = np.zeros_like(size), _beyond_root(left, size)
    z, before = high, np.full_like(size, np.inf)
    for _ in range(STEPS):
        residual, slope, scale = left(z)
        done = np.abs(residual) <= BALANCED * scale
        if done.all():
            return z
        low, high = np.where(residual > 0, z, low), np.where(residual > 0, high, z)
        newton = z - np.divide(residual, slope, out=np.full_like(z, np.inf), where=slope < 0)
        wild = (newton <= low) | (newton >= high) | (np.abs(residual) > 0.5 * before)
        before = np.abs(residual)
        z = np.where(done, z, np.where(wild, 0.5 * (low + high), newton))
    worst = float((np.abs(residual) / scale).max())
    raise NotSolved(f"skew: {worst:.1e} of the moments on a roller are unbalanced after {STEPS} steps")


def _beyond_root(left: Callable[[NDArray], tuple[NDArray, NDArray, NDArray]], size: NDArray) -> NDArray:
    """Some z past each root: the size, doubled until the function is no longer positive."""
    high = size.copy()
    while True:
        residual = left(high)[0]
        if not np.isfinite(residual).all():
            raise NotSolved("skew: a moment on a roller is not finite")
        open_ = residual > 0
        if not open_.any():
            return high
        if (high[open_] > LARGEST).any():
            raise NotSolved(
                f"skew: nothing holds {np.count_nonzero(open_)} rollers below {LARGEST:g} rad; "
                "is the stiffness of the flange right?"
            )
        high = np.where(open_, 2 * high, high)
