"""Steady rolling of elastic half-spaces with stick and slip."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid, ElasticPair, X, Y, influence_number
from quasidynamic.contact.rolling.rolling_contact import Rolled, RollingContacts, RollingLaw
from quasidynamic.contact.rolling.stick_slip import (
    StickSlip,
    StickSlipLaw,
    at_traction,
    stick_slip,
    traction_changes,
)
from quasidynamic.errors import NotSolved


def kalker(contacts: RollingContacts, creep: NDArray, start: NDArray | None = None) -> Rolled:
    r"""Steady rolling with Coulomb friction.

    .. math:: S = W\, \Delta x + u(x) - u(x + \Delta x),\quad u = A p,\quad |p| \le \mu p_n,\\
              S = 0 \ \text{(stick)} \quad\text{or}\quad p = -\mu p_n\, S/|S| \ \text{(slip)}

    Material comes from x + dx, one cell ahead, with the displacement u there.

    Parameters
    ----------
    contacts, creep, start
        see `RollingLaw`; the creep [-] is best taken `MID_STEP` ahead of the cell centres

    Returns
    -------
    Rolled

    Raises
    ------
    NotSolved
        when Newton's method finds no solution from any start

    Source
    ------
    Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), ch. 4, solved as a semi-smooth system.

    Valid
    -----
    Quasi-static, contact far smaller than the bodies; pressure given; equal coefficients of stick and slip.
    The discretisation is of first order.
    """
    first = np.zeros_like(creep) if start is None else start
    laws = [_law(contacts, creep, number) for number in range(len(creep))]
    states = [_settled(law, traction) for law, traction in zip(laws, first, strict=True)]

    traction, stick = (np.stack([getattr(state, name) for state in states]) for name in ("traction", "stick"))
    grown = np.stack([law.displacement(each) for law, each in zip(laws, traction, strict=True)])
    slip = creep + (grown + contacts.pressed_slip) / contacts.step[:, None, None, None]
    return Rolled(contacts, creep, traction, slip, stick)


def kalker_changes(rolled: Rolled, creep_changes: NDArray) -> NDArray:
    """Changes of the tractions with the creep, the regions of stick and slip as they are.

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
    Derivative of the projection, see `traction_changes`.
    """
    offsets = creep_changes * rolled.contacts.step[:, None, None, None, None]
    changes = np.empty_like(offsets)
    for number, traction in enumerate(rolled.traction):
        law = _law(rolled.contacts, rolled.creep, number)
        changes[number] = traction_changes(law, at_traction(law, traction), offsets[number])
    return changes


def _law(contacts: RollingContacts, creep: NDArray, number: int) -> StickSlipLaw:
    """Law of one contact."""
    step, grown = contacts.step[number], contacts.step_displacements[number]
    self_influence = _self_influence(contacts.pairs[number], contacts.grids[number])
    offset, limit = creep[number] * step + contacts.pressed_slip[number], contacts.limit[number]
    if contacts.compliance is None:
        return StickSlipLaw(grown, offset, limit, 1 / self_influence)
    layer = contacts.compliance[number]

    def with_layer(traction: NDArray) -> NDArray:
        """Displacement of half-spaces and layer over a step."""
        displacement, sheared = grown(traction), layer * traction
        displacement += sheared
        displacement[:, :-1] -= sheared[:, 1:]
        return displacement

    return StickSlipLaw(with_layer, offset, limit, 1 / (self_influence + layer))


def _self_influence(pair: ElasticPair, grid: CellGrid) -> float:
    """Displacement of a step by the traction of the cell itself, the mean of both directions [m/Pa]."""
    places = np.array([0.0, grid.spacing[0]]), np.zeros(2)
    numbers = [influence_number(pair, direction, direction, places, grid.spacing) for direction in (X, Y)]
    return float(np.mean([here - ahead for here, ahead in numbers]))


def _settled(law: StickSlipLaw, start: NDArray) -> StickSlip:
    """Solution from a start, else from no traction at all."""
    try:
        return stick_slip(law, start)
    except NotSolved:
        return stick_slip(law, np.zeros_like(start))


KALKER = RollingLaw(kalker, kalker_changes)
