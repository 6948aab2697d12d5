"""Full sliding on a grid: the limit of stiff bodies."""

from math import pi

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid
from quasidynamic.contact.rolling.rolling_contact import Rolled, RollingContacts, RollingLaw

POINTS = 8  # Gauss points across a cell
STANDING = 1e-300  # keeps the direction of a slip of zero defined


def hertz_pressure(grid: CellGrid, semi_axes: tuple[float, float], load: float) -> NDArray:
    r"""Mean pressure of every cell under an elliptic contact.

    .. math:: p = \frac{3 Q}{2 \pi a b} \sqrt{1 - x^2/a^2 - y^2/b^2}

    integrated along x in closed form: cells that the edge of the ellipse cuts carry their part.

    Parameters
    ----------
    grid : CellGrid
        cells [m]
    semi_axes : pair of float
        a along x and b along y [m]
    load : float
        Q [N]

    Returns
    -------
    array (nx, ny)
        [Pa], its sum over the cells of a grid that covers the ellipse is the load

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2.
    """
    (x, y), (a, b) = grid.centres, semi_axes
    half_x, half_y = grid.spacing[0] / 2, grid.spacing[1] / 2
    pressure = np.zeros(grid.shape)
    for place, weight in zip(*leggauss(POINTS), strict=True):
        chord = np.sqrt(np.maximum(1.0 - ((y + place * half_y) / b) ** 2, 0.0))
        width = np.maximum(a * chord, np.finfo(float).tiny)
        high, low = (np.clip((x + side) / width, -1.0, 1.0) for side in (half_x, -half_x))
        pressure += weight / 2 * chord**2 * (_disc(high) - _disc(low))
    return 1.5 * load / (pi * a * b) * pressure * a / (2 * half_x)


def _disc(place: NDArray) -> NDArray:
    """Integral of sqrt(1 - t^2) from zero."""
    return 0.5 * (place * np.sqrt(1.0 - place**2) + np.arcsin(place))


def full_sliding(contacts: RollingContacts, creep: NDArray, start: NDArray | None = None) -> Rolled:
    r"""Coulomb friction of rigid bodies.

    .. math:: p = -\mu p_n\, W/|W|

    It sticks nowhere; where nothing slips the traction is zero. Of the contacts mu p_n [Pa] alone counts,
    nothing is iterated, see `RollingLaw`.

    Source
    ------
    Coulomb's law.
    """
    size = np.maximum(np.hypot(creep[:, 0], creep[:, 1]), STANDING)[:, None]
    traction = -contacts.limit[:, None] * creep / size
    return Rolled(contacts, creep, traction, creep, np.zeros(contacts.limit.shape, bool))


def sliding_changes(rolled: Rolled, creep_changes: NDArray) -> NDArray:
    """Changes of the tractions [Pa] with the creep, see `RollingLaw`.

    Source
    ------
    Derivative of Coulomb's law.
    """
    size = np.maximum(np.hypot(rolled.creep[:, 0], rolled.creep[:, 1]), STANDING)[:, None]
    towards = (rolled.creep / size)[:, None]
    along = (towards * creep_changes).sum(2, keepdims=True)
    return -(rolled.contacts.limit[:, None] / size)[:, None] * (creep_changes - along * towards)


FULL_SLIDING = RollingLaw(full_sliding, sliding_changes)
