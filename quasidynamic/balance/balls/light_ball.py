"""How far a lightly pressed ball follows the races."""

import numpy as np
from numpy.typing import NDArray

RELEASE = 0.2  # of the nominal centrifugal force: inner load over which a ball is let go by the inner race
GRIP = 0.5  # of the centrifugal force: inner load above which h is one but for a hundredth
LEAST_RELEASE = 1e-100  # [N] the same at rest, where it no longer matters
SEEN_WHOLE, WIDEST = (
    np.radians(60.0),
    np.radians(75.0),
)  # angle between the contacts: up to which, bound beyond
STEADY, STRONGEST = 0.4, 0.6  # of the load: traction up to which a contact holds all, bound beyond
LEAST_LOAD, MOST_WANTED = 1e-200, 1e3  # [N], over the load: no traction without a load


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
    One, but for a hundredth, from Q_i = `GRIP` F_c on; below, orbit and spin of the ball are estimates.
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
        s [rad], below `WIDEST` = Delta_1 + w in size, and ds/dDelta [-], both without a kink

    Source
    ------
    An assumption: near the pole of a ball no race rolls on it, and friction decides what it does.

    Valid
    -----
    Exact up to Delta_1 = `SEEN_WHOLE`; beyond, orbit and spin of the ball are estimates.
    """
    beyond = np.abs(apart) - SEEN_WHOLE
    if beyond.max() <= 0:
        return apart, 1.0
    part = np.tanh(beyond / (WIDEST - SEEN_WHOLE))
    bent = np.sign(apart) * (SEEN_WHOLE + (WIDEST - SEEN_WHOLE) * part)
    return np.where(beyond > 0, bent, apart), np.where(beyond > 0, 1 - part**2, 1.0)


def held_traction(wanted: NDArray, load: NDArray) -> tuple[NDArray, NDArray | float, NDArray | float]:
    r"""Traction that a contact provides where another one is wanted.

    .. math:: T = P\ \text{up to}\ |P| = \kappa Q,\quad
              \pm Q \left(\kappa + w \tanh\frac{|P|/Q - \kappa}{w}\right)\ \text{beyond}

    Parameters
    ----------
    wanted : array (...)
        P [N], of either sign
    load : array (...)
        Q [N], >= 0

    Returns
    -------
    three arrays (...), the second and the third may be one number
        T [N], below `STRONGEST` = kappa + w of Q, its slope by P and its slope by Q [-], without a kink

    Source
    ------
    An assumption: no contact pulls along the race much harder than it presses. What is missing of the
    gyroscopic moment turns the ball about the rolling direction.

    Valid
    -----
    Exact up to kappa = `STEADY`, far above friction of lubricated contacts.
    """
    if (np.abs(wanted) <= STEADY * load).all():
        return wanted, 1.0, 0.0
    ratio = np.minimum(np.abs(wanted) / np.maximum(load, LEAST_LOAD), MOST_WANTED)
    beyond = ratio - STEADY
    part = np.tanh(beyond / (STRONGEST - STEADY))
    share, growth = STEADY + (STRONGEST - STEADY) * part, 1 - part**2
    traction = np.where(beyond > 0, np.sign(wanted) * load * share, wanted)
    by_load = np.where(beyond > 0, np.sign(wanted) * (share - ratio * growth), 0.0)
    return traction, np.where(beyond > 0, growth, 1.0), by_load
