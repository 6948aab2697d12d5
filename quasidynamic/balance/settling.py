"""Rollers put at rest between given raceways, before any friction is known."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance, Unknowns
from quasidynamic.contact.load import EXPONENT

SETTLING_STEPS = 6  # Newton on a nearly linear law inside a bracket
NEAR_ENOUGH = 1e-9  # [m]


def centrifugal_force(balance: BearingBalance, cage_speed: NDArray) -> NDArray:
    """What presses an unloaded roller on the outer raceway (C, 1) [N]."""
    force, _ = balance.roller.centrifugal(cage_speed)
    return force


def outer_approach(balance: BearingBalance, cage_speed: NDArray) -> NDArray:
    """Approach of an unloaded roller at the outer raceway (C, 1) [m]."""
    line_load = centrifugal_force(balance, cage_speed) / balance.roller.bearing.roller.length
    return balance.roller.raceways.law.approach(np.array([line_load, line_load])[..., None])[1, ..., 0]


def series_softness(balance: BearingBalance) -> float:
    """Approach of both raceways together per load^0.9 [m/N^0.9]."""
    coefficients = np.broadcast_to(balance.roller.raceways.law.coefficient, (2, 1, 1, 1)).ravel()
    return float(np.sum((coefficients * balance.roller.bearing.roller.length) ** (-1 / EXPONENT)))


def lumped_loads(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Loads (2, C, Z) [N] of rollers of one slice."""
    return _lumped(balance, balance.inputs(unknowns).approach[:, 0])[0]


def series_stiffness(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Stiffness (C, Z) [N/m] of both raceways of a roller in series, one slice."""
    inner, outer = _lumped(balance, balance.inputs(unknowns).approach[:, 0])[1]
    return inner * outer / (inner + outer)


def _lumped(balance: BearingBalance, approach: NDArray) -> tuple[NDArray, NDArray]:
    """Loads [N] and stiffnesses [N/m] (2, C, Z) at approaches of rollers of one slice."""
    line_load, slope = balance.roller.raceways.law(approach[..., None])
    length = balance.roller.bearing.roller.length
    return line_load[..., 0] * length, slope[..., 0] * length


def settled(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Put every roller at rest between its raceways, untilted and without friction.

    A step that linearises contact may throw a roller off its outer raceway, from where the load law
    has no slope to bring it back; this puts it on again.
    """
    room = balance.inputs(unknowns).approach[:, 0].sum(0)  # both approaches, wherever the roller is
    _, cage_speed = balance.speeds(unknowns)
    centrifugal, lowest = centrifugal_force(balance, cage_speed), outer_approach(balance, cage_speed)
    outer, highest = np.maximum(room / 2, lowest), np.maximum(room, lowest)
    for _ in range(SETTLING_STEPS):
        (load_i, load_o), (slope_i, slope_o) = _lumped(balance, np.array([room - outer, outer]))
        change = (load_o - load_i - centrifugal) / (slope_o + slope_i)
        outer = np.clip(outer - change, lowest, highest)
        if np.abs(change).max() < NEAR_ENOUGH:
            break
    return unknowns._replace(approach=outer)


def film_at(balance: BearingBalance, unknowns: Unknowns, load: NDArray) -> NDArray:
    """Films (2, C, Z) [m] at roller loads (2, C, Z) [N] and the speeds of the unknowns."""
    sliding, entrainment = balance.roller.surfaces(balance.inputs(unknowns), balance.points)
    return balance.roller.raceways.film(load, sliding, entrainment).thickness
