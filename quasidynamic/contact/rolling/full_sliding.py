"""Full sliding on a grid: the limit of stiff bodies."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.rolling.rolling_contact import Rolled, RollingContacts, RollingLaw

STANDING = 1e-300  # keeps the direction of a slip of zero defined


def full_sliding(contacts: RollingContacts, creep: NDArray, start: NDArray | None = None) -> Rolled:
    r"""Coulomb friction of rigid bodies.

    .. math:: p = -\mu p_n\, W/|W|

    Parameters
    ----------
    contacts : RollingContacts
        mu p_n [Pa]
    creep : array (C, 2, nx, ny)
        W, rigid slip of the first body against the second over the rolling speed [-]
    start : array (C, 2, nx, ny), optional
        not needed: there is nothing to iterate [Pa]

    Returns
    -------
    Rolled
        sticking nowhere; where nothing slips the traction is zero

    Source
    ------
    Coulomb's law.
    """
    size = np.maximum(np.hypot(creep[:, 0], creep[:, 1]), STANDING)[:, None]
    traction = -contacts.limit[:, None] * creep / size
    return Rolled(contacts, creep, traction, creep, np.zeros(contacts.limit.shape, bool))


def sliding_changes(rolled: Rolled, creep_changes: NDArray) -> NDArray:
    """Changes of the tractions with the creep.

    Parameters
    ----------
    rolled : Rolled
        of `full_sliding`
    creep_changes : array (C, k, 2, nx, ny)
        [-]

    Returns
    -------
    array (C, k, 2, nx, ny)
        [Pa]

    Source
    ------
    Derivative of Coulomb's law.
    """
    size = np.maximum(np.hypot(rolled.creep[:, 0], rolled.creep[:, 1]), STANDING)[:, None]
    towards = (rolled.creep / size)[:, None]
    along = (towards * creep_changes).sum(2, keepdims=True)
    return -(rolled.contacts.limit[:, None] / size)[:, None] * (creep_changes - along * towards)


FULL_SLIDING = RollingLaw(full_sliding, sliding_changes)
