"""How far a lightly pressed ball follows the races."""

import numpy as np
from numpy.typing import NDArray

FULL_HOLD = 2.5  # widths of tanh from which it is one but for a hundredth
RELEASE = 0.2  # of the nominal centrifugal force: inner load over which a ball is let go by the inner race
FULL_GRIP = FULL_HOLD * RELEASE  # of the centrifugal force: inner load that holds a ball
CAGED = 1e-3  # assumed; of centrifugal force and outer load: the same in the pocket of a cage
FULL_CAGED = FULL_HOLD * 2 * CAGED  # of the outer load, which is at least the centrifugal force
LEAST_RELEASE = 1e-100  # [N] the same at rest, where it no longer matters
FULL_ANGLE, LARGEST_ANGLE = (
    np.radians(60.0),
    np.radians(75.0),
)  # angle between the contacts: up to which, bound beyond
FULL_TRACTION, LARGEST_TRACTION = (
    0.4,
    0.6,
)  # of the load: traction up to which a contact holds all, bound beyond
LEAST_LOAD, LARGEST_RATIO = 1e-200, 1e3  # [N], over the load: no traction without a load


def grip(load: NDArray, stiffness: NDArray, centrifugal: NDArray) -> tuple[NDArray, NDArray]:
    r"""Hold of the inner race on the motion of a ball.

    .. math:: h = \tanh\frac{Q_i}{\epsilon F_c}

    Parameters
    ----------
    load, stiffness : array (...)
        Q_i [N] of the inner contact, >= 0, and its slope by the distance of the centres [N/m]
    centrifugal : array (...)
        F_c of a ball on the outer race alone [N], >= 0

    Returns
    -------
    pair of arrays (...)
        h [-], 0 on a ball that is let go, and its slope by the distance [1/m]

    Source
    ------
    An assumption: epsilon = `RELEASE`.

    Valid
    -----
    One, but for a hundredth, from Q_i = `FULL_GRIP` F_c on; below, orbit and spin of the ball are estimates.
    """
    width = np.maximum(RELEASE * centrifugal, LEAST_RELEASE)
    hold = np.tanh(load / width)
    return hold, (1 - hold**2) / width * stiffness


def limited_angle(apart: NDArray) -> tuple[NDArray, NDArray | float]:
    r"""Angle between the contacts that the kinematics see, and its slope.

    .. math:: s(\Delta) = \Delta\ \text{up to}\ \Delta_1,\quad
              \pm\left(\Delta_1 + w \tanh\frac{|\Delta| - \Delta_1}{w}\right)\ \text{beyond}

    Parameters
    ----------
    apart : array (...)
        Delta = alpha_i - alpha_o [rad]

    Returns
    -------
    pair of arrays (...), the second may be one number
        s [rad], below `LARGEST_ANGLE` = Delta_1 + w in size, and ds/dDelta [-], both without a kink

    Source
    ------
    An assumption: near the pole of a ball no race rolls on it, and friction decides what it does.

    Valid
    -----
    Exact up to Delta_1 = `FULL_ANGLE`; beyond, orbit and spin of the ball are estimates.
    """
    beyond = np.abs(apart) - FULL_ANGLE
    if beyond.max() <= 0:
        return apart, 1.0
    part = np.tanh(beyond / (LARGEST_ANGLE - FULL_ANGLE))
    bent = np.sign(apart) * (FULL_ANGLE + (LARGEST_ANGLE - FULL_ANGLE) * part)
    return np.where(beyond > 0, bent, apart), np.where(beyond > 0, 1 - part**2, 1.0)


def held_traction(needed: NDArray, load: NDArray) -> tuple[NDArray, NDArray | float, NDArray | float]:
    r"""Traction that a contact provides where another one is needed.

    .. math:: T = P\ \text{up to}\ |P| = \kappa Q,\quad
              \pm Q \left(\kappa + w \tanh\frac{|P|/Q - \kappa}{w}\right)\ \text{beyond}

    Parameters
    ----------
    needed : array (...)
        P [N], of either sign
    load : array (...)
        Q [N], >= 0

    Returns
    -------
    three arrays (...), the second and the third may be one number
        T [N], below `LARGEST_TRACTION` = kappa + w of Q, its slopes by P and by Q [-], without a kink

    Source
    ------
    An assumption: no contact pulls along the race much harder than it presses. What is missing of the
    gyroscopic moment turns the ball about the rolling direction.

    Valid
    -----
    Exact up to kappa = `FULL_TRACTION`, far above friction of lubricated contacts.
    """
    if (np.abs(needed) < FULL_TRACTION * load).all():
        return needed, 1.0, 0.0
    ratio = np.minimum(np.abs(needed) / np.maximum(load, LEAST_LOAD), LARGEST_RATIO)
    ratio = np.where(load > 0, ratio, LARGEST_RATIO)  # without load none, nor a slope
    beyond = ratio - FULL_TRACTION
    part = np.tanh(beyond / (LARGEST_TRACTION - FULL_TRACTION))
    share, growth = FULL_TRACTION + (LARGEST_TRACTION - FULL_TRACTION) * part, 1 - part**2
    traction = np.where(beyond > 0, np.sign(needed) * load * share, needed)
    by_load = np.where(beyond > 0, np.sign(needed) * (share - ratio * growth), 0.0)
    return traction, np.where(beyond > 0, growth, 1.0), by_load
