"""Rollers that really move: each carries its own spin from place to place, in the time domain.

An equilibrium sees rollers at fixed places and takes the spin that a roller brings along from the place of
the roller before, a whole pitch behind. Here azimuths advance with the cage, every roller has its inertia,
and its spin is what its own torques made of it: implicit Euler, a small part of a pitch at a time. Cage,
ring, rollers across the raceways and films follow at once. The forces are those of production; what is
checked is the transport of spin, and with it which of several equilibria rollers run in.
"""

from dataclasses import replace

import numpy as np

from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import bounded
from quasidynamic.solve.rollers.pseudo_time import scaled_inertia

EVALUATIONS = 60  # of Newton's method in a step
BALANCED = 1e-9  # residual
SHORTEST = 2**-6  # part of a step


def moved(state, pitches, steps):
    """Balance and scaled unknowns (N) after each step of a motion that begins at an equilibrium.

    Rollers keep their number while they move on by some pitches, each in so many steps.
    """
    balance = replace(state.balance, spin_inertia=False)  # nothing comes from the roller before
    bearing, scaled, azimuth = (
        balance.roller.bearing,
        state.scaled,
        state.balance.roller.bearing.first_roller_azimuth,
    )
    pitch = 2 * np.pi / bearing.rollers
    for _ in range(pitches * steps):
        azimuth, scaled = _advanced(balance, azimuth, scaled, np.sign(state.cage_speed) * pitch / steps)
        yield turned(balance, azimuth), scaled


def turned(balance, azimuth):
    """The same bearing with its first roller at another azimuth [rad]."""
    bearing = replace(balance.roller.bearing, first_roller_azimuth=azimuth)
    return replace(balance, roller=replace(balance.roller, bearing=bearing))


def _advanced(balance, azimuth, scaled, angle, part=1.0):
    """Azimuth and unknowns after a part of an angle, in shorter parts where Newton's method fails."""
    try:
        after = _euler(turned(balance, azimuth + part * angle), scaled, part * angle)
    except ArithmeticError:
        if part <= SHORTEST:
            raise
        azimuth, scaled = _advanced(balance, azimuth, scaled, part * angle, 0.5)
        return _advanced(balance, azimuth, scaled, part * angle, 0.5)
    return azimuth + part * angle, after


def _euler(balance, before, angle):
    """Unknowns at the end of the time in which the cage turns by an angle [rad]."""
    spins = balance.layout.field(-1)
    cage_speed = balance.speeds(balance.unpack(before[None]))[1][0, 0]
    inertia = np.zeros(len(before))
    inertia[spins] = scaled_inertia(balance)[0, spins] / (angle / cage_speed)
    scaled, shift = before.copy(), bordered_system.Shift(spin=inertia[None, spins])
    system, unbalanced = _unbalanced(balance, scaled, before, inertia)
    for _ in range(EVALUATIONS):
        if np.abs(unbalanced).max() < BALANCED:
            return scaled
        change = bordered_system.solve(balance, system, -unbalanced[None, :, None], shift)[0, :, 0]
        for damping in 2.0 ** -np.arange(10):
            trial = bounded(balance, scaled[None], (scaled + damping * change)[None])[0]
            system, remaining = _unbalanced(balance, trial, before, inertia)
            if np.linalg.norm(remaining) < np.linalg.norm(unbalanced):
                break
        scaled, unbalanced = trial, remaining
    raise ArithmeticError("a step of the motion is not solved")


def _unbalanced(balance, scaled, before, inertia):
    """Linearised forces, and what is unbalanced with the torque that changes the spins."""
    system = balance.evaluate(scaled[None])
    return system, system.residual[0] - inertia * (scaled - before)
