"""Orbit and spin of a ball on up to four contacts, by an assumption."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.light_ball import grip
from quasidynamic.motion.ball_slip import INNER, OUTER

HOLD = 0.1  # of the centrifugal force: what a ball that is let go weighs; assumed
SPIN_LEVER = 0.1  # of D/2: distance at which spin counts as slip, about that of a contact; assumed
FIRMER = np.array([1.0, 5.0])  # grip of the inner and of the outer race, which always carries F_c at least


class ArchMotion(NamedTuple):
    """Motion of balls, with slopes by the loads of their four contacts, then by the contact angles."""

    motion: NDArray  # (Z, 3) [rad/s] Omega_o, omega_x, omega_r, seen from the orbiting ball centre
    slopes: NDArray  # (Z, 3, 8)


def arch_motion(
    loads: NDArray, normals: NDArray, turned: NDArray, ratio: float, speed: float, centrifugal: float
) -> ArchMotion:
    r"""Motion with the least slip of contact centres, and spin on the outer race, weighed by the loads.

    .. math:: \min_u\ \sum_k Q_k \left(\frac{2 e_k}{D}\right)^2
              + \lambda^2 \sum_{outer} Q_k w_k^2 + \eta (1 - h_i h_o) F_c |u - u_0|^2,\quad
              u = (\Omega_o, \omega_x, \omega_r),\quad \Omega_i = \Omega_o + \omega

    with the slip e of the centre of a contact at D/2 from that of the ball, and the spin w against the race,
    which counts as slip at lambda D/2 = `SPIN_LEVER` D/2.
    A ball on one diagonal slips nowhere and does not spin on the outer race: outer race control.
    One that is let go by a race, h_i = tanh(Q_i/(`RELEASE` F_c)), h_o = tanh(5 Q_o/(`RELEASE` F_c)), moves as
    on races without load, in the middle of the grooves: u_0, which counts by eta = `HOLD`.

    Parameters
    ----------
    loads : array (Z, 2, 2)
        Q of both diagonals on the inner and the outer race [N], >= 0
    normals, turned : array (Z, 2, 2, 2)
        from the ball to its contacts, axial and radial [-], and their change by the contact angles [1/rad]
    ratio : float
        d_m/D [-]
    speed : float
        omega of the inner ring, the outer one at rest [rad/s], above zero
    centrifugal : float
        F_c of a ball on the outer race alone [N]

    Returns
    -------
    ArchMotion
        u [rad/s]

    Source
    ------
    Jones, J. Basic Eng. 81 (1959), for one diagonal; an assumption for three and four contacts. lambda is
    assumed: a third contact decides from about lambda^2 of the load of the others on.

    Valid
    -----
    Rolling balls; friction that slides everywhere decides otherwise where spin is strong.
    """
    slip, spin = _slip(normals, ratio), SPIN_LEVER * _spin(normals)
    by_ring = np.where(np.arange(2) == INNER, speed * slip[..., 0], 0.0)
    held, growth = grip(loads.sum(1) * FIRMER, FIRMER, np.asarray(centrifugal))
    hold = HOLD * (1.0 - held.prod(1)) * centrifugal
    orbit, ball = 0.5 * (1.0 - 1.0 / ratio), 0.5 * (ratio - 1.0 / ratio)
    free = speed * np.array([-orbit, -ball, 0.0])
    matrix = _squares(loads, slip) + _squares(loads[..., OUTER], spin) + hold[:, None, None] * np.eye(3)
    right = hold[:, None] * free - ((loads * by_ring)[..., None] * slip).sum((1, 2))
    u = np.linalg.solve(matrix, right[..., None])[..., 0]

    slipping, spinning = slip @ u[:, None, :, None] + by_ring[..., None], spin @ u[:, :, None]
    further = _slip(turned, 0.0)
    more = (further @ u[:, None, :, None]) + np.where(np.arange(2) == INNER, speed, 0.0)[:, None] * further[
        ..., :1
    ]
    by_load = slipping * slip  # slopes of the gradient (Z, 2, 2, 3)
    by_angle = loads[..., None] * (slipping * further + slip * more)
    turning = SPIN_LEVER * _spin(turned)
    by_load[:, :, OUTER] += spinning * spin
    by_angle[:, :, OUTER] += loads[..., OUTER, None] * (spinning * turning + spin * (turning @ u[:, :, None]))
    by_load -= ((growth * held[:, ::-1] * HOLD * centrifugal)[..., None] * (u - free)[:, None])[:, None]
    gradient = np.concatenate([by_load.reshape(-1, 4, 3), by_angle.reshape(-1, 4, 3)], 1)
    return ArchMotion(u, -np.linalg.solve(matrix, gradient.swapaxes(1, 2)))


def _slip(normals: NDArray, ratio: float) -> NDArray:
    """Slip of contacts (..., 3) over D/2 by a unit of each component of the motion."""
    axial, radial = normals[..., 0], normals[..., 1]
    return np.stack([-radial - ratio, radial, -axial], -1)


def _spin(normals: NDArray) -> NDArray:
    """Spin on the outer race (Z, 2, 3) by a unit of each component."""
    axial, radial = normals[:, :, OUTER, 0], normals[:, :, OUTER, 1]
    return np.stack([-axial, axial, radial], -1)


def _squares(weights: NDArray, rows: NDArray) -> NDArray:
    """Sum of weighed squares (Z, 3, 3) of rows (Z, ..., 3)."""
    flat = rows.reshape(len(rows), -1, 3)
    return flat.swapaxes(1, 2) @ (weights.reshape(len(rows), -1, 1) * flat)
