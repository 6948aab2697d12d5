"""A first guess: the static load distribution of rollers between rigid rings."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root_scalar

from quasidynamic.balance.bearing import CAGE, BearingBalance, Z
from quasidynamic.contact.load import EXPONENT
from quasidynamic.errors import NotSolved

FIRST_SLIP = 1e-3  # of the cage: friction must have a sign to begin with
DRY_FILM = 1e-7  # [m] before any film is known


def static_start(balance: BearingBalance) -> tuple[NDArray, NDArray]:
    """Unknowns and films near equilibrium: both raceways of a roller in series, no tilt.

    The ring displacement is one scalar root; the centrifugal force is added at the outer contact.

    Returns
    -------
    tuple of array
        scaled unknowns (N); films (2, Z) [m]

    Raises
    ------
    NotSolved
        without load and with clearance: no roller touches the inner ring
    """
    bearing, operation = balance.roller.bearing, balance.roller.operation
    if bearing.clearance > 0 and operation.radial_load == 0 and operation.moment == 0:
        raise NotSolved("no load and clearance: the cage stands still and the ring position is undetermined")
    laws = balance.roller.inner.law, balance.roller.outer.law
    softness = sum((law.coefficient * bearing.roller.length) ** (-1 / EXPONENT) for law in laws)
    cos = np.cos(bearing.azimuths)

    def loads(shift: float) -> NDArray:
        return (np.maximum(shift * cos - bearing.clearance / 2, 0.0) / softness) ** EXPONENT

    shift = _ring_shift(lambda z: float(loads(z) @ cos), operation.radial_load)
    centrifugal = bearing.roller.mass * bearing.pitch_diameter / 2 * balance.cage_speed**2
    outer = (loads(shift) + centrifugal) / bearing.roller.length
    unknowns = np.zeros(balance.size)
    unknowns[Z] = shift
    unknowns[CAGE] = balance.cage_speed * (1 - FIRST_SLIP)
    unknowns[balance.roller_unknown(0)] = laws[1].approach(outer)
    unknowns[balance.roller_unknown(2)] = balance.roller_speed
    scaled = unknowns / balance.unknown_scale
    dry = np.full((2, bearing.rollers), DRY_FILM)
    return scaled, balance.film(balance.evaluate(scaled, dry).rollers)


def _ring_shift(load_at: Callable[[float], float], load: float) -> float:
    """Displacement [m] at which the rollers carry the load."""
    if load == 0.0:
        return 0.0
    high = 1e-6
    while load_at(high) < load:
        high *= 2
    return root_scalar(lambda z: load_at(z) - load, bracket=(0.0, high), xtol=1e-12).root
