"""A first guess: the static load distribution of rollers between rigid rings."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root_scalar

from quasidynamic.balance.bearing import CAGE, BearingBalance, Z
from quasidynamic.contact.load import EXPONENT
from quasidynamic.errors import NotSolved

FIRST_SLIP = 1e-3  # of the cage: friction must have a sign to begin with
SETTLING_STEPS = 6  # Newton on a nearly linear law inside a bracket
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
    unknowns = np.zeros(balance.size)
    unknowns[Z] = shift
    unknowns[CAGE] = balance.cage_speed * (1 - FIRST_SLIP)
    unknowns[balance.roller_unknown(2)] = balance.roller_speed
    dry = np.full((2, bearing.rollers), DRY_FILM)
    scaled = settled(balance, unknowns / balance.unknown_scale, dry)
    return scaled, balance.film(balance.evaluate(scaled, dry).rollers)


def settled(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> NDArray:
    """Unknowns with every roller at rest between its raceways, untilted and without friction.

    A step that linearises contact may throw a roller off its outer raceway, from where the load law
    has no slope to bring it back; this puts it on again.
    """
    bearing, m = balance.roller.bearing, balance.roller.shapes
    inputs = balance.inputs(unknowns, film)
    room = inputs[:, 0] + inputs[:, m]  # both approaches together, wherever the roller is
    inner, outer = balance.roller.inner.law, balance.roller.outer.law
    cage_speed = inputs[0, -1]
    centrifugal = bearing.roller.mass * bearing.pitch_diameter / 2 * cage_speed**2 / bearing.roller.length
    lowest = outer.approach(np.array(centrifugal))
    approach = np.maximum(room / 2, lowest)
    for _ in range(SETTLING_STEPS):
        (load_i, slope_i), (load_o, slope_o) = inner(room - approach), outer(approach)
        approach = approach - (load_o - load_i - centrifugal) / (slope_o + slope_i)
        approach = np.clip(approach, lowest, np.maximum(room, lowest))
    moved = unknowns.copy()
    place = balance.roller_unknown(0)
    moved[place] = approach / balance.unknown_scale[place]
    return moved


def _ring_shift(load_at: Callable[[float], float], load: float) -> float:
    """Displacement [m] at which the rollers carry the load."""
    if load == 0.0:
        return 0.0
    high = 1e-6
    while load_at(high) < load:
        high *= 2
    return root_scalar(lambda z: load_at(z) - load, bracket=(0.0, high), xtol=1e-12).root
