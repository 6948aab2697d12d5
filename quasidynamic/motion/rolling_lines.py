"""Lines of a ball contact on which the ball rolls without slip."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.errors import OutOfRange

PANEL_POINTS = (48, 48)  # across and along the rolling direction, on each panel
ROUNDS = 60  # of the friction of a ball, each a factor of about a/D closer


class RollingLines(NamedTuple):
    """Pure rolling lines, counted along the groove section, towards smaller contact angles."""

    first: NDArray  # (...) c1, over the semi-axis a; at or below -1 it lies outside the contact
    second: NDArray  # (...) c2 > c1, over the semi-axis a; at or above 1 it lies outside the contact
    count: NDArray  # (...) lines inside the contact, 1 or 2


def hertz_section_radius(ball_diameter: float, conformity: ArrayLike) -> NDArray:
    r"""Radius of the section of the deformed contact.

    .. math:: R = 2 f D / (2 f + 1)

    Parameters
    ----------
    ball_diameter : float
        D [m]
    conformity : array (...)
        f, groove radius over ball diameter [-]

    Returns
    -------
    array (...)
        R [m]

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8; Rivera, Tong and Hong (2021), Eq. (5).
    """
    return 2 * np.asarray(conformity) * ball_diameter / (2 * np.asarray(conformity) + 1)


def spin_parameter(spin_to_roll: NDArray, section_radius: ArrayLike, semi_axis: NDArray) -> NDArray:
    r"""Parameter E of the pure rolling lines.

    .. math:: E = 2 R S / a,\quad c_1 + c_2 = -E

    S = gamma sin(alpha) gives Eq. (15) of the source, which drops the angle between the contact and the
    spin axis; the S of the slip field is that of `ball_speeds.spin_to_roll`.

    Parameters
    ----------
    spin_to_roll : array (...)
        S, spin over rolling [-]
    section_radius : array (...)
        R of the deformed section [m]
    semi_axis : array (...)
        a across the rolling direction [m], > 0

    Returns
    -------
    array (...)
        E [-]

    Source
    ------
    Houpert (1999); Rivera, Tong and Hong (2021), Eqs (13) and (15). Their Eq. (14) must read c1 = -c2 - E.

    Valid
    -----
    Section of the contact a parabola: a far below R. Eq. (15): equal contact angles, low speed.
    """
    return 2 * np.asarray(section_radius) * spin_to_roll / semi_axis


def rolling_lines(parameter: ArrayLike, net_force: ArrayLike = 0.0) -> RollingLines:
    r"""Pure rolling lines for a given spin and a given net friction.

    .. math:: e = 1 - \tfrac32 \left[(c_2 - c_1) - \tfrac13 (c_2^3 - c_1^3)\right]\ \text{(two lines)},\quad
              e = -\tfrac32 \left(c_2 - \tfrac13 c_2^3\right)\ \text{(one line)}

    both with c1 + c2 = -E; closed forms of the two cubics.

    Parameters
    ----------
    parameter : array (...)
        E [-]; where it is negative, lines are those of -E in the mirrored section
    net_force : array (...)
        e, friction in the rolling direction over mu Q [-], in (-1, 1), positive where the outside of the
        lines prevails; zero for a ball that neither drives nor brakes

    Raises
    ------
    OutOfRange
        |e| not below one

    Source
    ------
    Houpert (1999); Rivera, Tong and Hong (2021), Eqs (13), (16) and (17).

    Valid
    -----
    Friction shear a constant part of the Hertz pressure; ellipse narrow in the rolling direction.

    >>> lines = rolling_lines(0.0)
    >>> round(float(lines.second), 4)  # Heathcote's lines
    0.3473
    """
    spin, force = np.broadcast_arrays(np.asarray(parameter, float), np.asarray(net_force, float))
    if not np.all(np.abs(force) < 1.0):
        raise OutOfRange("net friction e must lie in (-1, 1): beyond it the ball slides everywhere")
    alone = -2 * np.sin(np.arcsin(force) / 3)
    size = np.abs(spin)
    single = size >= 1 - alone
    inside = np.where(single, 0.0, size)
    slack = np.sqrt(np.maximum(4 - inside**2, 0.0))  # of d^3 - 3 slack^2 d + 8 (1 - e) = 0, d = c2 - c1
    turn = np.arccos(np.clip(-4 * (1 - force) / slack**3, -1.0, 1.0))
    apart = 2 * slack * np.cos((turn - 2 * np.pi) / 3)
    near = np.where(single, alone, (apart - inside) / 2)
    far, mirrored = -size - near, spin < 0
    return RollingLines(
        np.where(mirrored, -near, far), np.where(mirrored, -far, near), np.where(single, 1, 2)
    )


def slip_velocity(
    position: ArrayLike,
    lines: RollingLines,
    semi_axis: NDArray,
    section_radius: NDArray,
    rolling: NDArray,
    spin_to_roll: NDArray,
) -> NDArray:
    r"""Slip of the ball over the race along the section of the contact, in the rolling direction.

    .. math:: v(x) = \omega_{roll} [h(x) - h(c a) - S (x - c a)],\quad h(x) = \sqrt{R^2 - x^2}

    Parameters
    ----------
    position : array (...)
        x/a, from -1 to 1 [-], positive towards smaller contact angles
    lines : RollingLines
        c, the one closer to the middle of the contact, fixes where the ball rolls
    semi_axis, section_radius : array (...)
        a, R [m]
    rolling : array (...)
        omega_roll, the speed of the race against the cage over gamma [rad/s]
    spin_to_roll : array (...)
        S [-]; with E = 2 R S/a the second zero is the other line up to (a/R)^2

    Returns
    -------
    array (...)
        v [m/s], ball minus race

    Source
    ------
    Jones, J. Basic Eng. 81 (1959); Rivera, Tong and Hong (2021), Eqs (1) and (2), with their spin (7), (8).
    """
    x = np.asarray(position) * semi_axis
    line = np.where(np.abs(lines.first) < np.abs(lines.second), lines.first, lines.second) * semi_axis
    height = (line**2 - x**2) / (np.sqrt(section_radius**2 - x**2) + np.sqrt(section_radius**2 - line**2))
    return rolling * (height - spin_to_roll * (x - line))


def spin_torque_factor(lines: RollingLines) -> NDArray:
    r"""Friction torque about the normal of a narrow contact over mu Q a.

    .. math:: \tfrac38 [2 (c_1^2 - c_2^2) - (c_1^4 - c_2^4)]\ \text{(two lines)},\quad
              \tfrac38 (1 - c_2^2)^2\ \text{(one line)}

    with the sign of E.

    Parameters
    ----------
    lines : RollingLines
        c1, c2 [-]

    Returns
    -------
    array (...)
        M_s/(mu Q a) [-]

    Source
    ------
    Houpert (1999); Rivera, Tong and Hong (2021), Eqs (22) and (23).

    Valid
    -----
    The limit b/a -> 0 of `spin_torque_integral`.
    """
    first, second = np.maximum(lines.first, -1.0) ** 2, np.minimum(lines.second, 1.0) ** 2
    return 0.375 * (2 * (first - second) - (first**2 - second**2))


def spin_torque_integral(lines: RollingLines, axis_ratio: ArrayLike) -> NDArray:
    r"""Friction torque about the contact normal over mu Q a, integrated over the ellipse.

    .. math:: \frac{M_s}{\mu Q a} = \frac{3}{2\pi} \int_{x^2+y^2<1} \sqrt{1 - x^2 - y^2}\,
              \frac{x\, u + \kappa^2 E\, y^2}{\sqrt{u^2 + (\kappa E y)^2}}\, dx\, dy, \\
              u = (x - c_1)(x - c_2),\quad E = -(c_1 + c_2),\quad \kappa = b/a

    Gauss panels between the lines, closer towards their ends.

    Parameters
    ----------
    lines : RollingLines
        c1, c2 (...) [-]
    axis_ratio : array (...)
        kappa, semi-axis along over semi-axis across the rolling direction [-]

    Returns
    -------
    array (...)
        M_s/(mu Q a) [-]

    Source
    ------
    Rivera, Tong and Hong (2021), Eqs (19) to (21), the slip of the section taken as a parabola.

    Valid
    -----
    Shear mu p against the slip everywhere; no sliding along the section.
    """
    first, second, ratio = np.broadcast_arrays(lines.first, lines.second, np.asarray(axis_ratio, float))
    ends = np.stack([np.full(first.shape, -1.0), np.clip(first, -1, 1), np.clip(second, -1, 1)])
    ends = np.concatenate([ends, np.full((1, *first.shape), 1.0)])[..., None, None]
    node, weight = _clustered(PANEL_POINTS[0])
    angle, angle_weight = _clustered(PANEL_POINTS[1])
    y_unit, y_weight = np.sin(angle * np.pi / 2), angle_weight * np.pi * np.cos(angle * np.pi / 2) ** 2
    spin = -(first + second)[..., None, None]
    total = np.zeros(first.shape)
    for low, high in pairwise(ends):
        x = low + (high - low) * node[:, None]
        room = 1 - x**2
        slip = (x - first[..., None, None]) * (x - second[..., None, None])
        lateral = ratio[..., None, None] * spin * np.sqrt(room) * y_unit
        size = np.hypot(slip, lateral)
        turning = x * slip + ratio[..., None, None] * np.sqrt(room) * y_unit * lateral
        share = np.divide(turning, size, out=np.zeros_like(size), where=size > 0)
        total += ((high - low) * room * share * weight[:, None] * y_weight).sum((-2, -1))
    return 1.5 / np.pi * total


def _clustered(points: int) -> tuple[NDArray, NDArray]:
    """Gauss nodes and weights on (0, 1), drawn to both ends by a quintic."""
    node, weight = np.polynomial.legendre.leggauss(points)
    t = (node + 1) / 2
    return t**3 * (10 + t * (6 * t - 15)), weight / 2 * 30 * t**2 * (1 - t) ** 2


def ball_friction(
    parameters: NDArray, loads: NDArray, semi_axes: NDArray, angles: NDArray, ball_diameter: float
) -> NDArray:
    r"""Net friction e on both races of a ball whose friction moments about its spin axis balance.

    .. math:: Q_i e_i = Q_o e_o = \frac{m_i \sin(\alpha_i - \beta) - m_o \sin(\alpha_o - \beta)}
              {\tfrac12 D [\cos(\alpha_i - \beta) + \cos(\alpha_o - \beta)]},\quad
              m = Q a\, M_s/(\mu Q a)\,(E, e)

    Friction forces in the rolling direction are equal on both races; the coefficient of friction drops out.

    Parameters
    ----------
    parameters : array (2, ...)
        E, inner then outer race [-]
    loads, semi_axes : array (2, ...)
        Q [N], > 0, and a [m]
    angles : array (2, ...)
        alpha - beta, from the spin axis to each contact [rad]
    ball_diameter : float
        D [m]

    Returns
    -------
    array (2, ...)
        e, inner then outer race [-]; not a number for a ball whose moments do not balance with |e| below
        one: it slides on one race

    Source
    ------
    Moments of the tractions of `rolling_lines` about the spin axis; narrow contacts, `spin_torque_factor`.

    Valid
    -----
    The attitude of the ball is that of a raceway control: the moment across its spin axis is not balanced.
    """
    force = np.zeros(np.shape(loads)[1:])
    least, balanced = loads.min(0), np.zeros(force.shape, bool)
    lever = 0.5 * ball_diameter * np.cos(angles).sum(0)
    for _ in range(ROUNDS):
        rolling = np.abs(force) < least
        part = np.where(rolling, force, 0.0) / loads
        moments = loads * semi_axes * spin_torque_factor(rolling_lines(parameters, part))
        before, turning = force, (moments[0] * np.sin(angles[0]) - moments[1] * np.sin(angles[1])) / lever
        force = np.where(rolling, turning, before)
        balanced = rolling & (np.abs(force - before) <= 1e-13 * least)
        if (balanced | ~rolling).all():
            break
    return np.where(balanced, force, np.nan) / loads
