"""Rollers put at rest between given raceways, before any friction is known."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance, Unknowns
from quasidynamic.contact.load import EXPONENT

SETTLING_STEPS = 8  # Newton on a nearly linear law inside a bracket
NEAR_ENOUGH = 1e-9  # [m]


def centrifugal_force(balance: BearingBalance, cage_speed: NDArray) -> NDArray:
    """What presses an unloaded roller on the outer raceway (C, 1) [N]."""
    force, _ = balance.roller.centrifugal(cage_speed)
    return force


def outer_approach(balance: BearingBalance, cage_speed: NDArray) -> NDArray:
    """Approach of an unloaded straight roller at the outer raceway (C, 1) [m]; a crowned one goes further."""
    return softness(balance)[1] * centrifugal_force(balance, cage_speed) ** (1 / EXPONENT)


def softness(balance: BearingBalance) -> NDArray:
    """Approach of a straight roller at either raceway per load^0.9 (2) [m/N^0.9]."""
    coefficients = np.broadcast_to(balance.roller.raceways.law.coefficient, (2, 1, 1, 1)).ravel()
    return (coefficients * balance.roller.bearing.roller.length) ** (-1 / EXPONENT)


def resting_loads(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Loads (2, C, Z) [N] of untilted rollers."""
    return _pressed(balance, balance.inputs(unknowns).approach[:, 0])[0]


def series_stiffness(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Stiffness (C, Z) [N/m] of both raceways of an untilted roller in series."""
    inner, outer = _pressed(balance, balance.inputs(unknowns).approach[:, 0])[1]
    return inner * outer / (inner + outer)


def _pressed(balance: BearingBalance, approach: NDArray) -> tuple[NDArray, NDArray]:
    """Loads [N] and stiffnesses [N/m] (2, C, Z) of untilted rollers at their approaches (2, C, Z) [m]."""
    raceways = balance.roller.raceways
    line_load, slope = raceways.law(approach[..., None] - raceways.drop)
    return line_load @ raceways.slices.widths, slope @ raceways.slices.widths


def settled(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Put every roller at rest between its raceways, untilted and without friction.

    A step that linearises contact may throw a roller off its outer raceway, from where the load law
    has no slope to bring it back; this puts it on again.
    """
    room = balance.inputs(unknowns).approach[:, 0].sum(0)  # both approaches, wherever the roller is
    _, cage_speed = balance.speeds(unknowns)
    drop, pressed = balance.roller.raceways.drop, outer_approach(balance, cage_speed)
    centrifugal, lowest = centrifugal_force(balance, cage_speed), pressed + drop.min()
    highest = np.maximum(room, pressed + drop.max())
    outer = np.maximum(room / 2, lowest)
    for _ in range(SETTLING_STEPS):
        (load_i, load_o), (slope_i, slope_o) = _pressed(balance, np.array([room - outer, outer]))
        change = (load_o - load_i - centrifugal) / (slope_o + slope_i)
        outer = np.minimum(np.maximum(outer - change, lowest), highest)
        if np.abs(change).max() < NEAR_ENOUGH:
            break
    return unknowns._replace(approach=outer)


def film_at(balance: BearingBalance, unknowns: Unknowns, load: NDArray) -> NDArray:
    """Films (2, C, Z) [m] at roller loads (2, C, Z) [N] and the speeds of the unknowns."""
    motion = balance.motion(unknowns.cage_drift, unknowns.spin_drift)
    sliding, entrainment, _ = balance.roller.surfaces(motion, balance.points)
    return balance.roller.raceways.film(load, sliding, entrainment).thickness
