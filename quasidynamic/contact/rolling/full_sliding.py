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
    contacts, creep, start
        see `RollingLaw`; of the contacts mu p_n [Pa] alone counts, nothing is iterated

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
    rolled, creep_changes
        see `RollingLaw`

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
