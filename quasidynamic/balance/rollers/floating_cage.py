"""A cage that finds its own centre in its land."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.columns import stacked
from quasidynamic.contact.cage import land_offset, land_torque
from quasidynamic.parts.oil_properties import Lubricant
from quasidynamic.parts.roller_bearing import Cage

CREEP = 1e-3  # of the speed difference of the rings: below it the land is taken to turn that fast


class FloatingCage(NamedTuple):
    """Where the cage floats, what its land does, with derivatives."""

    offset: NDArray  # (C, 2) from the centre of the guiding ring, y and z [m]
    force: NDArray  # (C, 2) of the land on the cage [N]
    torque: NDArray  # (C) of the land on the cage [N m]
    by_push: NDArray  # (C, 2) torque by the force of the pockets [m]
    by_speed: NDArray  # (C) torque by the cage speed, the pockets' force kept [N m s]
    body_force: NDArray  # (C, 2) weight and force of the unbalance [N]
    body_force_by_speed: NDArray  # (C, 2) [N s]


def floating_cage(
    push: NDArray, cage_speed: NDArray, points: OperatingPoints, cage: Cage, oil: Lubricant
) -> FloatingCage:
    r"""Cage that its land carries against the pockets' push, its weight and its unbalance.

    .. math:: \vec F_{land}(\vec e) + \sum \vec F_{pocket} + m_c \vec g + m_c\, u\, \omega_c^2\, \vec n_u = 0

    The place of the cage acts on the rollers through the torque of its land alone: the offset is not an
    unknown of the bearing, it follows from the pockets' push.

    Parameters
    ----------
    push : array (C, 2)
        sum of the forces of all rollers on the cage, y and z [N]
    cage_speed : array (C, 1)
        omega_c [rad/s]
    points : OperatingPoints
        speeds of the rings, gravity
    cage : Cage
        land, mass m_c, unbalance u towards n_u
    oil : Lubricant
        oil in the land

    Source
    ------
    `land_offset`, `land_torque`.

    Valid
    -----
    One moment with the centre at rest: no squeeze of the film. Rollers run at cage speed, wherever
    the pockets are.
    """
    ring_speed, clearance = points.guiding_speed(cage.guidance), cage.land_clearance / 2
    towards = stacked(np.sin(cage.unbalance_azimuth), np.cos(cage.unbalance_azimuth))[..., 0].T
    unit = cage.mass * cage.unbalance * towards
    weight = cage.mass * np.concatenate([points.gravity_y, points.gravity_z], axis=1)
    body_force, by_speed = weight + unit * cage_speed**2, 2 * unit * cage_speed
    speed_sum, smallest_sum = ring_speed + cage_speed, CREEP * np.abs(points.relative_speed)
    turning = np.abs(speed_sum) > smallest_sum
    force = -push - body_force
    place = land_offset(force[:, None], np.where(turning, speed_sum, smallest_sum), cage, oil)
    offset, offset_by_force, offset_by_speed = (each[:, 0] for each in place)
    size = np.hypot(*offset.T)[:, None]
    land = land_torque(ring_speed - cage_speed, cage, oil, size / clearance)
    by_offset = land.by_eccentricity * offset / (size * clearance)
    by_push = -np.einsum("ci,cij->cj", by_offset, offset_by_force)
    turned = (turning * by_offset * offset_by_speed).sum(1) + (by_push * by_speed).sum(1)
    return FloatingCage(
        offset, force, land.torque[:, 0], by_push, turned - land.by_speed[:, 0], body_force, by_speed
    )
