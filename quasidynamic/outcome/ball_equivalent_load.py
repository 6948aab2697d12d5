"""Radial loads that rate a ball bearing as radial and axial loads together do."""

import numpy as np

from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.rating_life import EquivalentLoad

# ISO 281 (2007), table 3, single row: f_0 F_a/C_0r with e and Y above e, by contact angle [deg], and X
DEEP_GROOVE = 5.0  # [deg] angle up to which the values of deep groove bearings are used
_BY_LOAD = {  # X, then relative loads with e and Y of each
    5.0: (
        0.56,
        (0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89),
        (0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44),
        (2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00),
    ),
    10.0: (
        0.46,
        (0.175, 0.350, 0.700, 1.05, 1.40, 2.10, 3.50, 5.25, 7.00),
        (0.29, 0.32, 0.36, 0.38, 0.40, 0.44, 0.49, 0.54, 0.54),
        (1.88, 1.71, 1.52, 1.41, 1.34, 1.23, 1.10, 1.01, 1.00),
    ),
    15.0: (
        0.44,
        (0.178, 0.357, 0.714, 1.07, 1.43, 2.14, 3.57, 5.35, 7.14),
        (0.38, 0.40, 0.43, 0.46, 0.47, 0.50, 0.55, 0.56, 0.56),
        (1.47, 1.40, 1.30, 1.23, 1.19, 1.12, 1.02, 1.00, 1.00),
    ),
}
LOADS = (0.172, 7.14)  # relative loads of the table, widest columns
_BY_ANGLE = {  # X, e, Y at any load
    20.0: (0.43, 0.57, 1.00),
    25.0: (0.41, 0.68, 0.87),
    30.0: (0.39, 0.80, 0.76),
    35.0: (0.37, 0.95, 0.66),
    40.0: (0.35, 1.14, 0.57),
    45.0: (0.33, 1.34, 0.50),
}
# ISO 76 (2006), table 2, single row: Y_0 by contact angle [deg]; X_0 = 0.5
_STATIC_DEEP_GROOVE = (0.6, 0.5)  # X_0, Y_0
_STATIC_X = 0.5
_STATIC_Y = {
    5.0: 0.52,
    10.0: 0.50,
    15.0: 0.46,
    20.0: 0.42,
    25.0: 0.38,
    30.0: 0.33,
    35.0: 0.29,
    40.0: 0.26,
    45.0: 0.22,
}


def ball_dynamic_load(
    radial: float, axial: float, contact_angle: float, relative_load: float
) -> EquivalentLoad:
    r"""Dynamic equivalent radial load of a single-row radial or angular-contact ball bearing.

    .. math:: P_r = F_r \;(F_a/F_r \le e),\quad P_r = X F_r + Y F_a \;(F_a/F_r > e)

    X, Y and e by contact angle and, up to 15 deg, by the relative axial load, straight lines between the
    printed values.

    Parameters
    ----------
    radial, axial : float
        F_r, F_a [N], >= 0
    contact_angle : float
        nominal alpha [rad]; 0 to 5 deg as a deep groove bearing
    relative_load : float
        f_0 F_a/C_0r [-], >= 0

    Returns
    -------
    EquivalentLoad
        with a note where the relative load is outside the table, whose end value is then held

    Raises
    ------
    OutOfRange
        for a contact angle above 45 deg

    Source
    ------
    ISO 281 (2007), section 5.2 and table 3.

    Valid
    -----
    Groove radii of ISO 281, section 5.1; ordinary clearance.
    """
    angle = _degrees(contact_angle)
    x, e, y = _factors(angle, relative_load)
    low, high = LOADS
    held = axial > 0 and angle < min(_BY_ANGLE) and not low <= relative_load <= high
    note = f"f_0 F_a/C_0r = {relative_load:.3g} is outside the table, whose end is held" * held
    if axial <= e * radial:
        return EquivalentLoad(radial, 1.0, 0.0, e, note)
    return EquivalentLoad(x * radial + y * axial, x, y, e, note)


def ball_static_load(radial: float, axial: float, contact_angle: float) -> EquivalentLoad:
    r"""Static equivalent radial load of a single-row radial or angular-contact ball bearing.

    .. math:: P_{0r} = \max(X_0 F_r + Y_0 F_a,\; F_r)

    Parameters
    ----------
    radial, axial : float
        F_r, F_a [N], >= 0
    contact_angle : float
        nominal alpha [rad]; below 5 deg as a deep groove bearing

    Returns
    -------
    EquivalentLoad
        without a limit e

    Raises
    ------
    OutOfRange
        for a contact angle above 45 deg

    Source
    ------
    ISO 76 (2006), section 5.2 and table 2.

    Valid
    -----
    Groove radii of ISO 76, section 5.1.
    """
    angle = _degrees(contact_angle)
    x, y = _STATIC_DEEP_GROOVE
    if angle >= DEEP_GROOVE:
        x, y = _STATIC_X, float(np.interp(angle, list(_STATIC_Y), list(_STATIC_Y.values())))
    together = x * radial + y * axial
    return EquivalentLoad(together, x, y) if together > radial else EquivalentLoad(radial, 1.0, 0.0)


def _degrees(contact_angle: float) -> float:
    angle = round(float(np.degrees(contact_angle)), 9)  # as the table has it
    if not 0.0 <= angle <= 45.0:
        raise OutOfRange(f"contact angle {angle:.4g} deg is outside 0 to 45 deg of ISO 281, table 3")
    return angle


def _factors(angle: float, relative_load: float) -> tuple[float, float, float]:
    """X, e, Y at an angle [deg], straight lines between those printed."""
    by_load = {
        at: (x, *(float(np.interp(relative_load, loads, column)) for column in (limits, factors)))
        for at, (x, loads, limits, factors) in _BY_LOAD.items()
    }
    printed = by_load | _BY_ANGLE
    x, e, y = (
        float(np.interp(angle, list(printed), column)) for column in zip(*printed.values(), strict=True)
    )
    return x, e, y
