"""Orbit and spin of a ball that rolls on two races."""

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Control = Literal["outer", "inner", "equal"]  # race on which the ball does not spin, or as much on both


class WithSlopes(NamedTuple):
    """A quantity with its derivatives by the inner and by the outer contact angle."""

    value: NDArray  # (...)
    slopes: NDArray  # (2, ...) per radian


class BallMotion(NamedTuple):
    """Orbit, spin and attitude of a ball."""

    orbit: WithSlopes  # [rad/s] positive like the rings
    spin: (
        WithSlopes  # [rad/s] in the orbiting frame; positive where the inner ring runs ahead of the outer one
    )
    attitude: WithSlopes  # [rad] of the spin axis to the shaft, positive like the contact angles


def ball_attitude(angles: NDArray, ratio: float, control: Control) -> WithSlopes:
    r"""Angle between spin axis and shaft under raceway control.

    .. math:: \tan\beta = \frac{\sin\alpha_o}{\cos\alpha_o + \gamma}\ \text{(outer)},\quad
              \tan\beta = \frac{\sin\alpha_i}{\cos\alpha_i - \gamma}\ \text{(inner)},\quad
              \beta = \tfrac12 (\alpha_i + \alpha_o)\ \text{(equal)}

    Parameters
    ----------
    angles : array (2, ...)
        alpha_i, alpha_o, contact angles [rad]
    ratio : float
        gamma, ball over pitch diameter [-]
    control : {"outer", "inner", "equal"}
        race on which the ball does not spin; "equal": the axis halves the angle between the contacts

    Returns
    -------
    WithSlopes
        beta [rad]

    Source
    ------
    Jones, J. Basic Eng. 81 (1959); Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8;
    equal: Rivera, Tong and Hong (2021), Eq. (6).

    Valid
    -----
    An assumption about friction, not a balance: good for loaded balls in thin films.
    """
    if control == "equal":
        return WithSlopes(0.5 * (angles[0] + angles[1]), np.full(np.shape(angles), 0.5))
    race, side = (1, ratio) if control == "outer" else (0, -ratio)
    cosine, slopes = np.cos(angles[race]), np.zeros(np.shape(angles))
    slopes[race] = (1 + side * cosine) / ((1 + ratio**2) + 2 * side * cosine)
    return WithSlopes(np.arctan2(np.sin(angles[race]), cosine + side), slopes)


def ball_motion(
    angles: NDArray, ratio: float, speeds: tuple[NDArray | float, NDArray | float], control: Control
) -> BallMotion:
    r"""Orbital speed and spin of a ball that does not slip at the centres of its contacts.

    .. math:: \omega_m - \omega_o &= \gamma\, \omega_R\, p_o,\quad
              \omega_i - \omega_m = \gamma\, \omega_R\, p_i, \\
              p_o &= \frac{\cos(\alpha_o - \beta)}{1 + \gamma \cos\alpha_o},\quad
              p_i = \frac{\cos(\alpha_i - \beta)}{1 - \gamma \cos\alpha_i}

    the closed form is Harris' pair of equations for omega_m and omega_R. The ball turns by
    omega_R (-cos beta, sin beta) in the axial and the radial direction, counted as the speeds of rings are.

    Parameters
    ----------
    angles : array (2, ...)
        alpha_i, alpha_o, contact angles [rad]
    ratio : float
        gamma, ball over pitch diameter [-]
    speeds : pair of arrays (...)
        omega_i, omega_o of the inner and the outer ring [rad/s]
    control : {"outer", "inner", "equal"}
        what sets the attitude beta, see `ball_attitude`

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8, with gamma on the pitch circle.

    Valid
    -----
    No gross sliding; p_i + p_o > 0, as for contact angles less than a right angle apart.

    >>> motion = ball_motion(np.array([0.7, 0.7]), 0.1, (100.0, 0.0), "equal")
    >>> round(float(motion.orbit.value), 6)  # half of 1 - gamma cos(alpha)
    46.175789
    """
    inner_speed, outer_speed = speeds
    attitude = ball_attitude(angles, ratio, control)
    side = np.array([-ratio, ratio]).reshape(2, *[1] * (np.ndim(angles) - 1))
    reach, ahead = 1 + side * np.cos(angles), angles - attitude.value
    share, turn = np.cos(ahead) / reach, np.sin(ahead) / reach  # p and its slope by beta
    by_angle = side * np.sin(angles) / reach * share - turn  # slope of p by its own angle
    inner, outer = share
    apart, total = inner_speed - outer_speed, inner + outer
    spin, lead = apart / (ratio * total), apart / total**2
    orbit_by_angle = by_angle * share[::-1]
    orbit_by_angle[0] *= -1
    orbit = WithSlopes(
        outer_speed + apart * outer / total,
        lead * ((turn[1] * inner - turn[0] * outer) * attitude.slopes + orbit_by_angle),
    )
    slower = -spin / total
    spin_slopes = slower * ((turn[0] + turn[1]) * attitude.slopes + by_angle)
    return BallMotion(orbit, WithSlopes(spin, spin_slopes), attitude)


def centrifugal_force(orbit: WithSlopes, mass: float, pitch_diameter: float) -> WithSlopes:
    r"""Force that a ball on its orbit exerts outwards.

    .. math:: F_c = \tfrac12 m d_m \omega_m^2

    Parameters
    ----------
    orbit : WithSlopes
        omega_m, orbital speed (...) [rad/s]
    mass : float
        m of the ball [kg]
    pitch_diameter : float
        d_m [m]

    Returns
    -------
    WithSlopes
        F_c [N]

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 5.

    Valid
    -----
    Ball centres on the pitch circle; their displacement under load is left out.
    """
    inertia = mass * pitch_diameter
    return WithSlopes(0.5 * inertia * orbit.value**2, inertia * orbit.value * orbit.slopes)


def gyroscopic_moment(motion: BallMotion, inertia: float) -> WithSlopes:
    r"""Moment that turns the spin axis of a ball once per orbit.

    .. math:: M_g = J\, \omega_m\, \omega_R \sin\beta

    The races must provide it by friction along the sections of the grooves.

    Parameters
    ----------
    motion : BallMotion
        omega_m, omega_R [rad/s], beta [rad] (...)
    inertia : float
        J of the ball [kg m2]

    Returns
    -------
    WithSlopes
        M_g [N m], positive where the inner ring alone turns and beta is positive

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 5; there omega_R is negative, hence other signs
    in the balance of the ball.
    """
    (orbit, orbit_slopes), (spin, spin_slopes), (attitude, attitude_slopes) = motion
    sine, momentum = np.sin(attitude), inertia * orbit * spin
    slopes = inertia * sine * (orbit_slopes * spin + orbit * spin_slopes)
    return WithSlopes(momentum * sine, slopes + momentum * np.cos(attitude) * attitude_slopes)


def spin_to_roll(
    angle: NDArray | float, attitude: NDArray | float, ratio: float, side: NDArray | float
) -> NDArray:
    r"""Spin of a ball against a race over its rolling on it.

    .. math:: S = \gamma \sin\alpha \mp (1 \pm \gamma \cos\alpha) \tan(\alpha - \beta)

    with the upper signs on the outer race.

    Parameters
    ----------
    angle : array (...)
        alpha, contact angle on this race [rad]
    attitude : array (...)
        beta [rad], see `ball_attitude`
    ratio : float
        gamma, ball over pitch diameter [-]
    side : float or array (...)
        +1 on the outer, -1 on the inner race

    Returns
    -------
    array (...)
        S [-], positive where spin by the contact angle alone prevails; zero on a controlling race

    Source
    ------
    Jones, J. Basic Eng. 81 (1959): relative speed about the normal over that about the groove section.

    Valid
    -----
    No slip at the centre of the contact.
    """
    lever = 1 + side * ratio * np.cos(angle)
    return ratio * np.sin(angle) - side * lever * np.tan(angle - attitude)
