"""Where a ring stands that is held axially under a preload."""

from typing import cast

import numpy as np
from scipy.optimize import brentq

from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.errors import require_positive
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing


def preloaded_place(bearing: AngularContactBearing, force: float) -> float:
    r"""Axial displacement at which an inner ring at rest carries an axial force alone.

    .. math:: Z K (L - A)^{3/2} x / L = F, \quad L = \sqrt{x^2 + r^2}

    Parameters
    ----------
    bearing : AngularContactBearing
        Z balls, K of both contacts in series [N/m^1.5], A the distance of the groove centres at which balls
        just touch, r their radial distance [m]
    force : float
        F [N], > 0

    Returns
    -------
    float
        displacement [m], x less the axial distance of the groove centres at zero displacement

    Raises
    ------
    ImpossiblePart
        for a force that is not positive

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 7, thrust load on a ball bearing.

    Valid
    -----
    At rest; rings concentric, without tilt; K of the contact angle without load.
    """
    require_positive("preload.force", force)
    distance, (offset, radial) = bearing.centre_distance, bearing.groove_offset
    stiffness = bearing.balls * float(in_series(*race_contacts(bearing)))

    def excess(axial: float) -> float:
        length = np.hypot(axial, radial)
        return stiffness * max(length - distance, 0.0) ** 1.5 * axial / length - force

    touching = offset + bearing.touching_place
    beyond = distance + radial + 2 * (force / stiffness) ** (2 / 3)  # carries twice the force
    return cast(float, brentq(excess, touching, beyond, xtol=1e-16)) - offset
