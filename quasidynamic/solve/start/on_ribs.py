"""Frictionless rollers between rigid rings that thrust presses on ribs."""

import numpy as np

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.inclined import HELD, InclinedRollers, sections_of_row
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.contact.line.slices import Slices
from quasidynamic.errors import NotSolved
from quasidynamic.solve.rollers.inclined_equilibrium import InclinedSolution, inclined_equilibrium
from quasidynamic.solve.rollers.static_equilibrium import film_at, frictionless_loads, outward_force


def pressed_on_ribs(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Rings and rollers of all cases where these carry load and thrust; as they were where none is found.

    The energy is convex: rollers that thrust tilts until they touch a raceway at one end are found from
    anywhere, which Newton's method with friction often does not.
    """
    for case in range(len(balance.points)):
        one = np.array([case])
        try:
            found = _placed(balance.take(one), unknowns.take(one))
        except NotSolved:
            continue
        unknowns = unknowns.with_cases(one, found)
    return unknowns


def _placed(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Ring and rollers of one case in balance under the films and speeds that they have."""
    side, pitch = _side(balance), balance.roller.bearing.pitch_diameter / 2
    state = frictionless(balance, unknowns).state
    x, y, z, turn_y, turn_z = state.ring
    placed = unknowns._replace(
        ring=np.array([y, z, -turn_y / pitch, turn_z / pitch])[:, None, None],
        approach=state.rollers[None, :, 1],
        tilt=-side * state.rollers[None, :, 2],
        shift=np.full((1, 1), x),
    )
    return placed._replace(film=film_at(balance, placed, frictionless_loads(balance, placed, uneven=True)))


def frictionless(balance: BearingBalance, unknowns: Unknowns) -> InclinedSolution:
    """Ring and rollers of one case in balance, films and speeds as they are: tapered rollers without taper.

    Raises `NotSolved` where nothing holds the ring.
    """
    points, pitch = balance.points, balance.roller.bearing.pitch_diameter / 2
    ring, moments = unknowns.ring[:, 0, 0], (-points.moment_z[0, 0], points.moment_y[0, 0])
    load = np.array([points.axial_load[0, 0], points.load_y[0, 0], points.load_z[0, 0], *moments])
    load[3:] /= pitch
    held = np.zeros(HELD, bool)
    held[3:] = not points.free_tilt[0, 0]
    start = np.array([unknowns.shift[0, 0], *ring[:2], -pitch * ring[2], pitch * ring[3]])
    return inclined_equilibrium(_cylinders(balance, unknowns), load * ~held, held, start)


def _cylinders(balance: BearingBalance, unknowns: Unknowns) -> InclinedRollers:
    """Rollers of one case with a rib at either end, that of the inner ring at their end `x`."""
    bearing, raceways, side = balance.roller.bearing, balance.roller.raceways, _side(balance)
    slices, (inner, outer) = raceways.slices, bearing.rib_levels
    half = float(np.max(slices.length)) / 2
    drops = np.broadcast_to(raceways.drop[:, :, 0], (slices.count, 2, bearing.all_rollers)).transpose(1, 2, 0)
    dead = np.zeros((bearing.all_rollers, 3))
    dead[:, 1] = outward_force(balance, unknowns)[0]
    gap = bearing.clearances / 2 - unknowns.film.sum(0)[0]
    return InclinedRollers(
        law=type(raceways.law)(np.reshape(raceways.law.coefficient, (2, 1, 1)), raceways.law.rounding),
        slices=Slices(slices.count, 2 * half),
        drops=drops[..., :: int(-side)],
        normals=np.array([[0.0, -1.0, -1.0], [0.0, 1.0, 1.0], [1.0, 0.0, -inner / half]]),
        opposite=np.array([-1.0, 0.0, outer / half]),
        gap=gap[:, None],
        rib_stiffness=balance.roller.rib_stiffnesses[0],
        radius=bearing.roller.diameter / (2 * half),
        opposite_stiffness=balance.roller.rib_stiffnesses[1],
        sections=sections_of_row(bearing.azimuths, bearing.pitch_diameter / 2, half, -side),
        shifts=np.zeros((bearing.all_rollers, 3)),
        dead=dead,
    )


def _side(balance: BearingBalance) -> float:
    """Sign of the thrust of one case."""
    return float(np.sign(balance.points.axial_load[0, 0]))
