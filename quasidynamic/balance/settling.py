"""Rollers put at rest between given raceways, before any friction is known."""

import numpy as np

from quasidynamic.balance.bearing import BearingBalance, Unknowns
from quasidynamic.contact.load import EXPONENT

SETTLING_STEPS = 6  # Newton on a nearly linear law inside a bracket


def series_softness(balance: BearingBalance) -> float:
    """Approach of both raceways together per load^0.9 [m/N^0.9]."""
    coefficients = np.broadcast_to(balance.roller.raceways.law.coefficient, (2, 1, 1, 1)).ravel()
    return float(np.sum((coefficients * balance.roller.bearing.roller.length) ** (-1 / EXPONENT)))


def settled(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Put every roller at rest between its raceways, untilted and without friction.

    A step that linearises contact may throw a roller off its outer raceway, from where the load law
    has no slope to bring it back; this puts it on again.
    """
    bearing, law = balance.roller.bearing, balance.roller.raceways.law
    approach = balance.inputs(unknowns).approach[:, 0]
    room = approach.sum(0)  # both approaches together, wherever the roller is
    centrifugal = (
        bearing.roller.mass * bearing.pitch_diameter / 2 * unknowns.cage_speed**2 / bearing.roller.length
    )
    line = np.array([np.zeros_like(centrifugal), centrifugal])
    lowest = law.approach(line[..., None])[1, ..., 0]
    outer = np.maximum(room / 2, lowest)
    for _ in range(SETTLING_STEPS):
        load, slope = law(np.array([room - outer, outer])[..., None])
        (load_i, load_o), (slope_i, slope_o) = load[..., 0], slope[..., 0]
        outer = outer - (load_o - load_i - centrifugal) / (slope_o + slope_i)
        outer = np.clip(outer, lowest, np.maximum(room, lowest))
    return unknowns._replace(approach=outer)


def filmed(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Renew the films from loads and speeds."""
    response = balance.roller.respond(balance.inputs(unknowns), balance.points)
    return unknowns._replace(film=response.state.contact.film.thickness)
