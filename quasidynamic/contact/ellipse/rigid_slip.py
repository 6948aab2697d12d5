"""Slip of a rigid ball over a race at the points of their contact, linear in the motion of the ball."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

Spin = Literal["centre", "local"]  # what makes slip across: the spin of the centre, or that of each point

CENTRE, ROLL, SPIN, ACROSS, PIVOT = range(5)  # components of the slip of a contact


def sagitta(position: NDArray, radius: NDArray) -> NDArray:
    r"""Height of the pressed surface over its middle, towards the ball's outside.

    .. math:: \sigma(x) = \sqrt{R^2 - x^2} - R

    Parameters
    ----------
    position : array (...)
        x across the rolling direction [m], |x| < R
    radius : array (...)
        R [m]

    Returns
    -------
    array (...)
        sigma [m], <= 0

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12.
    """
    return -(position**2) / (radius + np.sqrt(radius**2 - position**2))


def turn_by_slip(position: NDArray, radius: NDArray, spin: Spin) -> tuple[NDArray, NDArray]:
    r"""Spin about the normal of the surface at a point, for roll and spin of one.

    .. math:: w_l = w\ \text{(centre)},\quad w_l = w \cos\psi - A \sin\psi,\quad
              \sin\psi = x/R\ \text{(local)}

    Parameters
    ----------
    position : array (...)
        x across the rolling direction [m], |x| < R
    radius : array (...)
        R of the pressed surface [m]
    spin : {"centre", "local"}
        which normal: of the middle of the contact, or of the surface at x

    Returns
    -------
    array (...), array (...)
        factors of the roll A and of the spin w [-]; without dimensions with "centre"

    Source
    ------
    Rigid bodies: the relative angular velocity along the normal of the pressed arc; centre: Jones (1959), J.
    Basic Eng. 81, 1-12.
    """
    if spin == "centre":
        return np.zeros(()), np.ones(())
    sine = position / radius
    return -sine, np.sqrt(1.0 - sine**2)


def strip_slip(position: NDArray, radius: NDArray, spin: Spin) -> NDArray:
    r"""Slip on strips along the rolling direction by the slip of the contact.

    .. math:: v_t = e + A\,\sigma(x) + w x,\quad v_1 = k - w_l y,\\
              k = c + B\,\sigma(x)\ \text{(centre)},\quad k = c \cos\psi - B\,\sigma(x)\ \text{(local)}

    v_t is along the rolling direction. v_1 is across it, along the tangent of the surface in the middle of
    the contact (centre) or at x (local); w_l see `turn_by_slip`.

    Parameters
    ----------
    position : array (..., n)
        x of the strips, across the rolling direction [m], |x| < R
    radius : array (..., 1) or (..., n)
        R of the pressed surface [m]
    spin : {"centre", "local"}
        reading of the slip across

    Returns
    -------
    array (..., 3, 5, n)
        v_t, k and -w_l for a unit of e [m/s], A, w [rad/s], c [m/s] and B [rad/s]

    Source
    ------
    Rigid bodies: (omega - Omega e_x) x p on an arc of radius R; centre: Jones (1959), J. Basic Eng. 81, 1-12.

    Valid
    -----
    Ellipse narrow in the rolling direction: the surface is not curved along it.
    """
    rise = sagitta(position, radius)
    by_roll, by_spin = turn_by_slip(position, radius, spin)
    slip = np.zeros((*position.shape[:-1], 3, 5, position.shape[-1]))
    slip[..., 0, CENTRE, :], slip[..., 0, ROLL, :], slip[..., 0, SPIN, :] = 1.0, rise, position
    slip[..., 1, ACROSS, :] = by_spin
    slip[..., 1, PIVOT, :] = rise if spin == "centre" else -rise
    slip[..., 2, ROLL, :], slip[..., 2, SPIN, :] = -by_roll, -by_spin
    return slip


def rigid_slip(x: NDArray, y: NDArray, radius: NDArray, spin: Spin) -> NDArray:
    r"""Slip at points of a contact by the slip of the contact, ball minus race.

    .. math:: v = (v_t,\; k - w_l y)

    see `strip_slip`. The slip of the contact is s_0 + M u with the motion u of ball and rings, M that of
    `ball_slip.turning_slip_by_motion` and s_0 its column of the inner ring's turn: so is v, linear in u.

    An array (..., n, 2, 5) along and across the rolling direction for a unit of e [m/s], A, w [rad/s], c
    [m/s] and B [rad/s], at places x, y [m] across and along it. With "centre" the spin in the middle of the
    contact counts everywhere, as Jones has it; with "local" at each point that about the normal of the
    surface there, as rigid bodies have it.

    Source
    ------
    Rigid bodies: (omega - Omega e_x) x p on an arc of radius R; centre: Jones (1959), J. Basic Eng. 81, 1-12.

    Valid
    -----
    Ellipse narrow in the rolling direction: the surface is not curved along it.
    """
    along, across, turning = np.moveaxis(strip_slip(x, radius, spin), (-3, -1), (0, -2))
    return np.stack([along, across + y[..., None] * turning], -2)
