"""Cylinders between washers or crossed, on one page: slices as springs, and the integrals of short rollers.

A roller at rest shares the approach of its raceways evenly between both of its contacts, slice by slice, so
that no roller has an unknown of its own. In N and m.
"""

from math import acos, cos, pi

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, fsolve

EXPONENT = 10 / 9


def loads(rollers, pitch, length, coefficient, slices, thrust, moment):
    """Loads of the rollers (Z) [N] from azimuth 0 on under a thrust and a moment about y [N m].

    `coefficient` [N/m^(19/9)] is that of one contact.
    """

    def of_slices(place):
        approach, tilt = place
        load = np.zeros((rollers, slices))
        for number in range(rollers):
            for k in range(slices):
                radius = pitch / 2 + ((k + 0.5) / slices - 0.5) * length
                closed = (approach + tilt * radius * cos(2 * pi * number / rollers)) / 2
                load[number, k] = coefficient * max(closed, 0.0) ** EXPONENT * length / slices
        return load

    def left(scaled):
        load = of_slices([scaled[0] * 1e-6, scaled[1] * 1e-6 / pitch])
        radii = pitch / 2 + ((np.arange(slices) + 0.5) / slices - 0.5) * length
        turning = (load @ radii) @ np.cos(2 * np.pi * np.arange(rollers) / rollers)
        return [load.sum() / thrust - 1, (turning - moment) / (thrust * pitch)]

    even = 2e6 * (thrust / rollers / length / coefficient) ** (1 / EXPONENT)
    found = fsolve(left, [even, 0.0 if not moment else even * moment / (thrust * pitch) * 4], xtol=1e-13)
    assert np.abs(left(found)).max() < 1e-11
    return of_slices([found[0] * 1e-6, found[1] * 1e-6 / pitch]).sum(1)


def sjovall(eccentricity):
    """F/(Z Q_max) of many short rollers whose load acts off the axis, over the pitch radius."""

    def integral(share, lever):
        """Mean of (1 - (1 - cos phi)/(2 eps))^n cos^lever."""
        reach = pi if share >= 1 else acos(1 - 2 * share)
        return quad(
            lambda phi: max(1 - (1 - cos(phi)) / (2 * share), 0.0) ** EXPONENT * cos(phi) ** lever,
            0, reach, epsabs=1e-13, epsrel=1e-12,
        )[0] / pi  # fmt: skip

    share = brentq(lambda eps: integral(eps, 1) - eccentricity * integral(eps, 0), 0.02, 1e3, xtol=1e-14)
    return integral(share, 0)


def crossed(rollers, pitch, length, coefficient, slices, angle, closer, load):
    """Loads (2, Z) [N] of two directions of crossed rollers under forces and moments (5) on the inner ring.

    The first presses along +x, the second, half a pitch on, along -x; each is `closer` by so much [m].
    """
    places = ((np.arange(slices) + 0.5) / slices - 0.5) * length

    def forces(ring):
        x, y, z, about_y, about_z = ring
        load, sums = np.zeros((2, rollers)), np.zeros(5)
        for row, side in enumerate((1, -1)):
            for number in range(rollers):
                azimuth = 2 * pi * (number + row / 2) / rollers
                s, c = np.sin(azimuth), cos(azimuth)
                turn = about_y * c - about_z * s  # lifts the section along x with the radius
                along = side * (x + turn * pitch / 2) + closer
                approach = along * np.sin(angle) + (y * s + z * c) * cos(angle) + side * turn * places
                each = coefficient * np.maximum(approach / 2, 0.0) ** EXPONENT * length / slices
                load[row, number] = each.sum()
                axial, lever = side * each.sum() * np.sin(angle), side * (each @ places)
                arm = axial * pitch / 2 + lever
                outwards = each.sum() * cos(angle)
                sums += [axial, outwards * s, outwards * c, arm * c, -arm * s]
        return load, sums

    scale = np.array([1e-6, 1e-6, 1e-6, 1e-6 / pitch, 1e-6 / pitch])
    weights = np.array([1, 1, 1, 1 / pitch, 1 / pitch]) / np.abs(load).max()
    found = fsolve(
        lambda place: (forces(place * scale)[1] - load) * weights, [5.0, 0.0, 1.0, 0.0, 0.0], xtol=1e-13
    )
    assert np.abs((forces(found * scale)[1] - load) * weights).max() < 1e-10
    return forces(found * scale)[0]
