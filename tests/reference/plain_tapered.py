"""A tapered roller bearing between elastic rings on one page: what is out of balance at given places.

One roller, one slice at a time, in N and m; nothing is solved here. x' points to the rib, r outwards.
"""

from math import cos, radians, sin
from typing import NamedTuple

from numpy.polynomial.legendre import legval

from quasidynamic.contact.line.load_law import raceway_coefficients

SLICES = 40


class Contact(NamedTuple):
    """Force on one body of a roller, along x' and r [N], moment that lifts the large end [N m], modes [N]."""

    along: float
    out: float
    moment: float
    modes: list


def out_of_balance(bearing, ring, rollers, shapes, compliances, loads, inertia):
    """Unbalanced forces [N] on the inner ring (3) and on rollers (Z, 3: x', r, moment [N m]), and what shapes
    (2 races, Z, M) [m] differ from those that forces make; the last is along the inner raceway.

    `ring` is (x, y, z, turn about y, about z), `rollers` (Z) of (x', r, turn); `compliances` are of the inner
    and outer raceway (Z, M, Z, M) [m/N]; `inertia` is (F_c, M_g) of a roller.
    """
    x, y, z, about_y, about_z = ring
    half = bearing.pitch_diameter / 2
    on_ring, on_rollers, forces = list(loads[:3]), [], ([], [])
    for number, roller in enumerate(rollers):
        azimuth = bearing.first_roller_azimuth + radians(360 * number / bearing.rollers)
        s, c = sin(azimuth), cos(azimuth)
        turn = about_y * c - about_z * s
        section = -bearing.side * (x + half * turn), y * s + z * c, bearing.side * turn
        against = [mine - its for mine, its in zip(roller, section, strict=True)]
        inner = raceway(bearing, 0, against, shapes[0][number][:-1])
        outer = raceway(bearing, 1, roller, shapes[1][number][:-1])
        on_rib = rib(bearing, against, shapes[0][number])
        on_ring[0] -= bearing.side * (inner.along + on_rib.along)
        on_ring[1] += (inner.out + on_rib.out) * s
        on_ring[2] += (inner.out + on_rib.out) * c
        sums = [sum(parts) for parts in zip(inner[:3], outer[:3], on_rib[:3], strict=True)]
        on_rollers.append([-sums[0], inertia[0] - sums[1], inertia[1] - sums[2]])
        on_section = [force + more for force, more in zip([*inner.modes, 0.0], on_rib.modes, strict=True)]
        forces[0].append(on_section)
        forces[1].append(outer.modes)
    shapes = shapes[0], shapes[1][:, :-1]
    return on_ring, on_rollers, [misfit(*each) for each in zip(shapes, compliances, forces, strict=True)]


def raceway(bearing, race, moved, shape):
    """What a roller presses with on a raceway that gives way by modes of a shape, moved against it."""
    angle, sign = (bearing.cone_angle, -1) if race == 0 else (bearing.cup_angle, 1)
    normal, length = (-sign * sin(angle), sign * cos(angle)), bearing.roller.length
    total, moment, modes = 0.0, 0.0, [0.0] * len(shape)
    for k in range(SLICES):
        xi = (2 * k + 1) / SLICES - 1
        place = xi * length / 2
        approach = normal[0] * moved[0] + normal[1] * moved[1] + sign * moved[2] * place
        approach -= legval(xi, shape) + bearing.drop(race, place, length)
        approach -= bearing.clearance / 2 * cos(angle) if race == 0 else 0.0
        load = raceway_coefficients(bearing)[race] * max(approach, 0.0) ** (10 / 9) * length / SLICES
        total, moment = total + load, moment + sign * load * place
        modes = [force + load * legval(xi, [0] * m + [1]) for m, force in enumerate(modes)]
    return Contact(total * normal[0], total * normal[1], moment, modes)


def rib(bearing, moved, shape):
    """What the end of a roller presses with on the rib, which the section of the raceway carries along.

    The section turns about mid-contact, a radius of the roller below its centre.
    """
    part = cos(bearing.rib.angle), sin(bearing.rib.angle), bearing.rib.lever
    s, c, half = sin(bearing.cone_angle), cos(bearing.cone_angle), bearing.roller.length / 2
    radius = bearing.roller.diameter / 2 / cos((bearing.cup_angle - bearing.cone_angle) / 2)
    turn = -shape[1] / half
    along = shape[-1] - turn * radius
    section = shape[0] * s + along * c, -shape[0] * c + along * s, turn
    approach = sum(each * (way - its) for each, way, its in zip(part, moved, section, strict=True))
    load = bearing.rib.stiffness * max(approach, 0.0) ** 1.5
    by_turn = part[0] * c * radius + part[1] * s * radius - part[2]
    modes = [load * (part[0] * s - part[1] * c), load * by_turn / half, *[0.0] * (len(shape) - 3)]
    return Contact(*(load * each for each in part), [*modes, load * (part[0] * c + part[1] * s)])


def misfit(shape, compliance, forces):
    """Shape (Z, M) [m] less what forces (Z, M) [N] make of a raceway, one at a time."""
    left = [list(own) for own in shape]
    for j in range(len(shape)):
        for m in range(len(shape[j])):
            for k, of_roller in enumerate(forces):
                left[j][m] -= sum(compliance[j, m, k, n] * force for n, force in enumerate(of_roller))
    return left
