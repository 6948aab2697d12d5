"""Slip of a ball on the raceways of both rings.

Axes at a ball: x axial, r outwards, t towards growing azimuth. Turns are counted as the speeds of rings are,
positive by the right hand about -x, -r and -t (docs/reference/axes.md): x, r, t are left-handed, so that
products of vectors are the usual ones.
"""

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

INNER, OUTER = 0, 1  # place of a race on the last axis
SIDE = np.array([-1.0, 1.0])  # of the ball, towards the shaft and away from it
DIAGONAL = np.array([1.0, -1.0])  # axial direction of the outer contact
CARRYING = 1e-3  # of the largest load, from which a contact counts in the steepest angle
ORBIT, AXIAL, RADIAL, TURN = 0, 1, 2, 3  # components of the motion of a ball


@dataclass(frozen=True)
class BallContacts:
    """Places where balls touch the races: N balls, G diagonals (1 or 2), inner and outer race."""

    ball_radius: NDArray  # (N) [m]
    pitch_radius: NDArray  # (N) [m] of the ball centres
    angle: NDArray  # (N, G, 2) [rad] contact angle
    height: NDArray  # (N, G, 2) [m] of the middle of the contact over the ball centre

    @cached_property
    def normal(self) -> tuple[NDArray, NDArray]:
        """Axial and radial component of the direction from the ball centre to a contact (N, G, 2)."""
        axial = DIAGONAL[: self.angle.shape[1], None] * SIDE * np.sin(self.angle)
        return axial, SIDE * np.cos(self.angle)

    def taken(self, keep: NDArray) -> "BallContacts":
        """Return the contacts of some of the balls."""
        return BallContacts(*(getattr(self, field.name)[keep] for field in fields(self)))


def steepest(angles: NDArray, loads: NDArray) -> float:
    """Largest contact angle [rad] of contacts that carry; not of balls that only their inertia presses."""
    return float(np.abs(angles).max(where=loads > CARRYING * loads.max(), initial=0.0))


def pressed_height(ball_radius: NDArray, surface_radius: NDArray, across: NDArray) -> NDArray:
    r"""Distance of the middle of a contact from the ball centre.

    .. math:: h_0 = R - \sqrt{R^2 - a^2} + \sqrt{(D/2)^2 - a^2}

    Parameters
    ----------
    ball_radius : array (...)
        D/2 [m]
    surface_radius : array (...)
        R of the pressed surface [m], above D/2
    across : array (...)
        a, semi-axis across the rolling direction [m], below D/2

    Returns
    -------
    array (...)
        h_0 [m], below D/2

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12.
    """
    return (
        across**2 / (surface_radius + np.sqrt(surface_radius**2 - across**2))
        - across**2 / (ball_radius + np.sqrt(ball_radius**2 - across**2))
        + ball_radius
    )


def pressed_radius(ball_radius: NDArray, groove_radius: NDArray) -> NDArray:
    r"""Radius of the pressed surface between ball and groove, in the plane of the groove section.

    .. math:: R = \frac{2 r\, D/2}{r + D/2}

    Parameters
    ----------
    ball_radius, groove_radius : array (...)
        D/2 and r [m]

    Returns
    -------
    array (...)
        R [m]

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12.

    >>> round(float(pressed_radius(1.0, 1.05)), 6)
    1.02439
    """
    return 2 * groove_radius * ball_radius / (groove_radius + ball_radius)


def slip_by_motion(contacts: BallContacts) -> NDArray:
    r"""Slip of every contact for a unit of each component of the motion of its ball.

    .. math:: A = (\omega_x - \Omega) n_r - \omega_r n_x,\quad
              w = (\omega_x - \Omega) n_x + \omega_r n_r,\quad
              e = A h_0 - \Omega R_c

    Seen from the orbiting ball centre; x axial, r outwards. The slip is ball minus race.

    Parameters
    ----------
    contacts : BallContacts
        normals n, heights h_0 and pitch radius R_c

    Returns
    -------
    array (N, G, 2, 3, 3)
        centre slip e [m], roll A and spin w [-] for race speed Omega and ball speeds omega_x, omega_r of one

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12; Joshi et al. (2015), Lubricants 3, 181-196.
    """
    axial, radial = contacts.normal
    roll = np.stack([-radial, radial, -axial], -1)
    spin = np.stack([-axial, axial, radial], -1)
    centre = contacts.height[..., None] * roll
    centre[..., ORBIT] -= contacts.pitch_radius[:, None, None]
    return np.stack([centre, roll, spin], -2)


def slip_of(motion: NDArray, by_motion: NDArray) -> NDArray:
    r"""Slip of every contact when the inner ring turns by one against the outer ring.

    .. math:: s = M (\Omega_c, \omega_x, \omega_r),\quad \Omega_i = \Omega_o + 1

    Parameters
    ----------
    motion : array (N, 3)
        outer ring speed Omega_o, ball speeds omega_x and omega_r, seen from the orbiting ball centre, over
        the speed of the inner against the outer ring [-]
    by_motion : array (N, G, 2, 3, 3)
        M from `slip_by_motion`

    Returns
    -------
    array (N, G, 2, 3)
        e [m], A and w [-]

    Source
    ------
    Joshi et al. (2015), Lubricants 3, 181-196.
    """
    slip = np.einsum("ngsij,nj->ngsi", by_motion, motion)
    slip[:, :, INNER] += by_motion[:, :, INNER, :, ORBIT]
    return slip


def rolling_motion(contacts: BallContacts, diagonal: int) -> NDArray:
    r"""Motion of balls that roll on one diagonal without slip in the middle of both contacts.

    .. math:: \omega_B = \Omega_i \frac{R_c/h_i - \cos\alpha_i}{\cos(\alpha_i - \nu)},\quad
              \Omega_o = -\omega_B \frac{h_o \cos(\alpha_o - \nu)}{R_c + h_o \cos\alpha_o},\quad
              \nu = \frac{\alpha_i + \alpha_o}{2}

    Printed for h = D/2 and equal angles.

    Parameters
    ----------
    contacts : BallContacts
        angles alpha, heights h, pitch radius R_c [m]
    diagonal : int
        0 or 1

    Returns
    -------
    array (N, 3)
        Omega_o, omega_x, omega_r over the speed of the inner against the outer ring [-]

    Source
    ------
    Heras et al. (2017), Eqs (1) to (3) with the first two lines of Table 1.
    """
    angle, height = contacts.angle[:, diagonal], contacts.height[:, diagonal]
    mean = angle.mean(axis=-1)
    tilt = np.cos(angle - mean[:, None])
    pitch = contacts.pitch_radius
    ball = (pitch / height[:, INNER] - np.cos(angle[:, INNER])) / tilt[:, INNER]
    outer = height[:, OUTER] * tilt[:, OUTER] / (pitch + height[:, OUTER] * np.cos(angle[:, OUTER]))
    inner_speed = 1.0 / (1.0 + ball * outer)
    return _motion(inner_speed, ball * inner_speed, DIAGONAL[diagonal] * mean)


def spinning_motion(contacts: BallContacts) -> NDArray:
    r"""Motion of balls that slip as much on one diagonal as on the other.

    .. math:: \frac{\Omega_o}{\Omega_i} = -\frac{d_m/D - \cos\alpha}{d_m/D + \cos\alpha},\quad
              \frac{\omega_B}{\Omega_i} = \frac{d_m/D - \cos\alpha}{\cos\alpha},\quad
              \alpha = \frac{\alpha_1 + \alpha_2}{2},\quad \nu = \frac{\alpha_1 - \alpha_2}{2}

    with the axis of the ball turned by nu from the bearing axis.

    Parameters
    ----------
    contacts : BallContacts
        both diagonals, angles alpha_1 and alpha_2

    Returns
    -------
    array (N, 3)
        Omega_o, omega_x, omega_r over the speed of the inner against the outer ring [-]

    Source
    ------
    Heras et al. (2017), Eqs (1) to (3) with the third line of Table 1.
    """
    first, second = (contacts.angle[:, i].mean(axis=-1) for i in (0, 1))
    cosine, ratio = np.cos((first + second) / 2), contacts.pitch_radius / contacts.ball_radius
    inner_speed = (ratio + cosine) / (2 * ratio)
    return _motion(inner_speed, inner_speed * (ratio - cosine) / cosine, (first - second) / 2)


def _motion(inner_speed: NDArray, ball_speed: NDArray, axis: NDArray) -> NDArray:
    """Motion (N, 3) from the size of the ball speed and the angle of its axis to the bearing axis."""
    return np.stack([inner_speed - 1.0, -ball_speed * np.cos(axis), ball_speed * np.sin(axis)], -1)


def turning_slip_by_motion(contacts: BallContacts) -> NDArray:
    r"""Slip of every contact for a unit of each component of the motion of a ball that also turns about the
    rolling direction.

    .. math:: c = \omega_t h_0,\quad B = \omega_t

    beside e, A and w of `slip_by_motion`; slip across is positive along (-n_r, n_x).

    Parameters
    ----------
    contacts : BallContacts
        normals n, heights h_0 and pitch radius R_c

    Returns
    -------
    array (N, G, 2, 5, 4)
        e [m], A and w [-], c slip of the centre across the rolling direction [m] and turn B [-] for race
        speed Omega and ball speeds omega_x, omega_r, omega_t of one

    Source
    ------
    Rigid bodies: (omega - Omega e_x) x p across the rolling direction.
    """
    slip = np.zeros((*contacts.angle.shape, 5, 4))
    slip[..., :3, :TURN] = slip_by_motion(contacts)
    slip[..., 3, TURN], slip[..., 4, TURN] = contacts.height, 1.0
    return slip
