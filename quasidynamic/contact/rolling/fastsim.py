"""Steady rolling on an elastic foundation: FASTSIM."""

from math import pi

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.rolling.kalker import creep_coefficients
from quasidynamic.contact.rolling.rolling_contact import ACROSS, ALONG, Rolled, RollingContacts, RollingLaw

TORQUE_EXCESS = 0.01, 0.2  # of the torque of `kalker`, without and over the share that sticks; calibrated
SLIPPING = 1e-300  # [Pa] keeps the direction of a traction of zero defined


def fastsim(contacts: RollingContacts, creep: NDArray, start: NDArray | None = None) -> Rolled:
    r"""Steady rolling with Coulomb friction where each point of the surface is a spring of its own.

    .. math:: z = p(x + \Delta x) - W\, \Delta x / L,\quad p = z \min(1, \mu p_n/|z|)

    from the leading edge, with one flexibility L for both directions, so that the tractions of full sliding
    oppose the slip.

    Arguments as of `RollingLaw`; a layer between the bodies adds to L [m/Pa], nothing is iterated.

    Source
    ------
    Kalker, Vehicle System Dynamics 11 (1982), 1-13.

    Valid
    -----
    Forces within a few per cent of `kalker` in one kind of creep; areas of stick come out too large. The
    friction torque of balls is above that of `kalker` by up to 1 % and 0.2 times the share that sticks.
    """
    flexible, step = _flexible(contacts, creep), contacts.step[:, None, None]
    traction, slip, size = np.zeros_like(creep), creep.copy(), np.zeros_like(contacts.limit)
    behind = np.zeros((*creep.shape[:2], creep.shape[-1]))  # displacement of the cells passed last
    for column in reversed(range(creep.shape[2])):
        spring, limit = flexible[:, None, column], contacts.limit[:, None, column]
        trial = (behind - creep[:, :, column] * step) / spring
        size[:, column] = np.hypot(trial[:, ALONG], trial[:, ACROSS])
        traction[:, :, column] = trial * np.minimum(1.0, limit / np.maximum(size[:, None, column], SLIPPING))
        grown = spring * traction[:, :, column] - behind
        slip[:, :, column] += grown / step
        behind = behind + grown
    return Rolled(contacts, creep, traction, slip, size <= contacts.limit)


def fastsim_changes(rolled: Rolled, creep_changes: NDArray) -> NDArray:
    """Changes of the tractions [Pa] with the creep, the flexibility as it is, see `RollingLaw`.

    Source
    ------
    Derivative of the sweep of `fastsim`.
    """
    flexible = _flexible(rolled.contacts, rolled.creep)
    displaced, step = flexible[:, None] * rolled.traction, rolled.contacts.step[:, None, None, None]
    before = np.concatenate([displaced[:, :, 1:], np.zeros_like(displaced[:, :, :1])], 2)
    trial = (before - rolled.creep * step) / flexible[:, None]
    size = np.maximum(np.hypot(trial[:, ALONG], trial[:, ACROSS]), SLIPPING)
    direction = np.where(rolled.stick[:, None], 0.0, trial / size[:, None])
    reduced = np.where(rolled.stick, 1.0, rolled.contacts.limit / size)
    changes, behind = np.empty_like(creep_changes), np.zeros_like(creep_changes[:, :, :, 0])
    for column in reversed(range(creep_changes.shape[3])):
        spring, towards = flexible[:, None, None, column], direction[:, None, :, column]
        pushed = (behind - creep_changes[:, :, :, column] * step) / spring
        along = (towards * pushed).sum(2, keepdims=True)
        changes[:, :, :, column] = reduced[:, None, None, column] * (pushed - along * towards)
        behind = spring * changes[:, :, :, column]
    return changes


FASTSIM = RollingLaw(fastsim, fastsim_changes)


def _flexible(contacts: RollingContacts, creep: NDArray) -> NDArray:
    """Flexibility of every cell (C, nx, ny) [m/Pa], with that of a layer."""
    flexible = flexibility(contacts, creep)[:, None, None] + np.zeros_like(contacts.limit)
    return flexible if contacts.compliance is None else flexible + contacts.compliance


def flexibility(contacts: RollingContacts, creep: NDArray) -> NDArray:
    r"""Flexibility of the surface that meets the linear theory of each kind of creep, averaged.

    .. math:: L_1 = \frac{8 a}{3 C_{11} G},\quad L_2 = \frac{8 a}{3 C_{22} G},\quad
              L_3 = \frac{\pi a \sqrt{a/b}}{4 C_{23} G}

    for longitudinal creep, lateral creep and spin: the parts of W along, even in y; across, even in x; and
    the rest. They count by their mean size under the pressure.

    Parameters
    ----------
    contacts : RollingContacts
        a and b are half the lengths of the touching cells along and across [m]
    creep : array (C, 2, nx, ny)
        W [-]

    Returns
    -------
    array (C)
        L [m/Pa]

    Raises
    ------
    OutOfRange
        for patches that are too slender, see `creep_coefficients`

    Source
    ------
    Kalker, Vehicle System Dynamics 11 (1982), 1-13, there for ellipses and constant creep and spin.
    """
    along, across = creep[:, ALONG], creep[:, ACROSS]
    kinds = np.stack([along + along[..., ::-1], across + across[:, ::-1], along - along[..., ::-1]], 1) / 2
    spin = np.stack([kinds[:, 2], (across - across[:, ::-1]) / 2], 1)
    weight = contacts.limit
    sizes = np.stack(
        [
            (weight * np.abs(kinds[:, 0])).sum((1, 2)),
            (weight * np.abs(kinds[:, 1])).sum((1, 2)),
            (weight * np.hypot(spin[:, 0], spin[:, 1])).sum((1, 2)),
        ],
        -1,
    )
    springs = np.array([_springs(contacts, number) for number in range(len(creep))])
    return (sizes * springs).sum(-1) / np.maximum(sizes.sum(-1), np.finfo(float).tiny)


def _springs(contacts: RollingContacts, number: int) -> NDArray:
    """L1, L2 and L3 of one contact [m/Pa]."""
    grid, pair, touching = contacts.grids[number], contacts.pairs[number], contacts.limit[number] > 0.0
    a = touching.any(1).sum() * grid.spacing[0] / 2
    b = touching.any(0).sum() * grid.spacing[1] / 2
    first, second, third = creep_coefficients(a / b, pair.poisson / pair.shear)
    return a * pair.shear * np.array([8 / (3 * first), 8 / (3 * second), pi * np.sqrt(a / b) / (4 * third)])
