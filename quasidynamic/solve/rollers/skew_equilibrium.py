"""Skew at which the moments on rollers between guide flanges balance."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.skew import SkewBalance
from quasidynamic.errors import NotSolved

LARGEST_SKEW = 0.5  # [rad] a roller that skews further is not held
TOLERANCE = 1e-12  # of the moments that balance
ITERATION_LIMIT = 200

Residual = Callable[[NDArray], tuple[NDArray, NDArray, NDArray]]  # value, slope and scale at an unknown


def skew_equilibrium(balance: SkewBalance) -> tuple[NDArray, NDArray]:
    """Skew (Z) [rad] of every roller in balance, and what of it is beyond the touching one.

    It is positive when the +x end leads.
    Raises `NotSolved` when nothing holds a roller below half a radian.

    Source
    ------
    Newton's method within a bracket, on `SkewBalance.residual`.
    """
    driving, sense = np.abs(balance.traction_moment), np.sign(balance.traction_moment)
    touching, lever = balance.touching, balance.corner.lever
    at_touching = balance.residual(np.full_like(driving, touching), np.zeros_like(driving))[0]
    # Beyond the clearance the unknown is counted from the touching: a stiff corner needs its digits.
    outside = (driving > 0) & (at_touching >= 0)
    base = np.where(outside, touching, 0.0)

    def beyond(unknown: NDArray) -> NDArray:
        return np.where(outside, unknown, unknown - touching)

    expected = np.where(outside, driving / (2 * balance.flange.stiffness * lever**2), touching)
    unknown = _falling_root(lambda z: balance.residual(base + z, beyond(z)), expected * (driving > 0))
    return sense * (base + unknown), beyond(unknown)


def _falling_root(residual: Residual, expected: NDArray) -> NDArray:
    """Roots z >= 0 where a function that is not negative at zero falls through zero.

    Newton steps that leave the bracket, or that have not halved the residual, are replaced by halving.
    """
    low, high = np.zeros_like(expected), _beyond_root(residual, expected)
    z, last_size = high, np.full_like(expected, np.inf)
    for _ in range(ITERATION_LIMIT):
        value, slope, scale = residual(z)
        done = np.abs(value) <= TOLERANCE * scale
        if done.all():
            return z
        low, high = np.where(value > 0, z, low), np.where(value > 0, high, z)
        newton = z - np.divide(value, slope, out=np.full_like(z, np.inf), where=slope < 0)
        refused = (newton <= low) | (newton >= high) | (np.abs(value) > 0.5 * last_size)
        last_size = np.abs(value)
        z = np.where(done, z, np.where(refused, 0.5 * (low + high), newton))
    worst = float((np.abs(value) / scale).max())
    raise NotSolved(
        f"skew: {worst:.1e} of the moments on a roller are unbalanced after {ITERATION_LIMIT} steps"
    )


def _beyond_root(residual: Residual, expected: NDArray) -> NDArray:
    """Some z past each root: the expected one, doubled until the function is no longer positive."""
    high = expected.copy()
    while True:
        value = residual(high)[0]
        if not np.isfinite(value).all():
            raise NotSolved("skew: a moment on a roller is not finite")
        too_low = value > 0
        if not too_low.any():
            return high
        if (high[too_low] > LARGEST_SKEW).any():
            raise NotSolved(
                f"skew: nothing holds {np.count_nonzero(too_low)} rollers below {LARGEST_SKEW:g} rad; "
                "is the stiffness of the flange right?"
            )
        high = np.where(too_low, 2 * high, high)
