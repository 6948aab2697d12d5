"""Rings under axial forces alone, at rest: where a preload holds them, and what takes it off."""

from typing import cast

import numpy as np
from scipy.optimize import brentq

from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.errors import require_positive
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing


def preloaded_place(bearing: AngularContactBearing, force: float) -> float:
    """Axial displacement [m] at which the inner ring of one row carries a force [N] by `axial_force`.

    Raises `ImpossiblePart` for a force that is not positive.
    """
    require_positive("preload.force", force)
    distance, (offset, radial) = bearing.centre_distance, bearing.groove_offset
    touching, stiffness = bearing.touching_place, _stiffness(bearing)
    beyond = distance + radial + 2 * (force / stiffness) ** (2 / 3) - offset  # carries twice the force
    return cast(
        float,
        brentq(lambda axial: axial_force(bearing, axial) - force, touching, beyond, xtol=1e-16),
    )


def axial_force(bearing: AngularContactBearing, displacement: float) -> float:
    r"""Axial force on one row of balls at rest, the inner ring displaced along the axis alone.

    .. math:: F = Z K \max(L - A, 0)^{3/2} x / L, \quad L = \sqrt{x^2 + r^2}

    Parameters
    ----------
    bearing : AngularContactBearing
        Z balls of a row, K of both contacts in series [N/m^1.5], A the distance of the groove centres at
        which balls just touch, r their radial distance [m]
    displacement : float
        x less the axial distance of the groove centres at zero displacement [m]

    Returns
    -------
    float
        F [N]

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 7, thrust load on a ball bearing.

    Valid
    -----
    At rest; rings concentric, without tilt; K of the contact angle without load.
    """
    offset, radial = bearing.groove_offset
    axial = offset + displacement
    length = np.hypot(axial, radial)
    pressed = max(length - bearing.centre_distance, 0.0)
    return float(_stiffness(bearing) * pressed**1.5 * axial / length)


def unloading_force(bearing: AngularContactBearing) -> float | None:
    """Least axial load that takes the load off a row which others press, at rest and by it alone [N].

    Zero with play between the rows; None without rows against each other.
    """
    sides = [[row.closer for row in bearing.rows if row.mirrored is side] for side in (False, True)]
    if not all(sides):
        return None
    return min(
        sum(axial_force(bearing, min(there) - bearing.touching_place + closer) for closer in here)
        for here, there in (sides, sides[::-1])
    )


def _stiffness(bearing: AngularContactBearing) -> float:
    """Of all contacts of a row [N/m^1.5]."""
    return bearing.balls * float(in_series(*race_contacts(bearing)))
