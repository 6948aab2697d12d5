"""Steady rolling of elastic half-spaces with stick and slip."""

from functools import lru_cache

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
from quasidynamic.errors import NotSolved, OutOfRange

RATIOS = (0.02, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0, 2.0, 4.0)  # a/b of the table
POISSON = (0.0, 0.25, 0.5)  # of the table
DEGREE = 6  # of polynomials in ln(a/b): within 0.15 % of the table
_TABLE = np.array(  # (Poisson's ratio, a/b, coefficient)
    [
        [
            [2.464, 2.464, 0.1475],
            [2.476, 2.476, 0.2339],
            [2.506, 2.506, 0.3334],
            [2.585, 2.585, 0.4815],
            [2.725, 2.725, 0.6616],
            [2.977, 2.977, 0.9270],
            [3.388, 3.388, 1.3291],
            [4.370, 4.370, 2.3436],
            [6.158, 6.158, 4.5363],
        ],
        [
            [3.282, 2.465, 0.2814],
            [3.288, 2.481, 0.3758],
            [3.308, 2.520, 0.4693],
            [3.366, 2.626, 0.6003],
            [3.482, 2.810, 0.7660],
            [3.710, 3.137, 1.0305],
            [4.103, 3.660, 1.4617],
            [5.089, 4.901, 2.6185],
            [6.935, 7.143, 5.2188],
        ],
        [
            [4.911, 2.464, 0.5463],
            [4.887, 2.480, 0.6491],
            [4.851, 2.527, 0.7206],
            [4.807, 2.657, 0.8038],
            [4.805, 2.889, 0.9276],
            [4.907, 3.305, 1.1715],
            [5.192, 3.974, 1.6266],
            [6.087, 5.572, 2.9619],
            [7.934, 8.499, 6.1374],
        ],
    ]
)


def creep_coefficients(ratio: float, poisson: float) -> NDArray:
    r"""Coefficients of the linear theory.

    .. math:: F_x = -a b\, G\, C_{11}\, \xi,\quad
              F_y = -a b\, G\, (C_{22}\, \eta + C_{23} \sqrt{a b}\, \varphi)

    Parameters
    ----------
    ratio : float
        a/b of the semi-axes along and across the rolling direction [-], 0.02 to 4
    poisson : float
        nu of the pair [-], 0 to 0.5

    Returns
    -------
    array (3)
        C11, C22, C23 [-]

    Raises
    ------
    OutOfRange
        outside the table

    Source
    ------
    The coefficients of Kalker (1967), On the Rolling Contact of Two Elastic Bodies in the Presence of Dry
    Friction, computed here as `kalker` without limit, from grids of 32 and 64 cells extrapolated; within
    0.6 % of his table.

    >>> creep_coefficients(1.0, 0.25).round(2)
    array([4.1 , 3.66, 1.46])
    """
    if not (RATIOS[0] <= ratio <= RATIOS[-1] and POISSON[0] <= poisson <= POISSON[-1]):
        raise OutOfRange(
            f"creep coefficients are tabulated for a/b of {RATIOS[0]} to {RATIOS[-1]} and Poisson's ratios "
            f"of {POISSON[0]} to {POISSON[-1]}: a/b = {ratio:.4g} and {poisson:.4g} lie outside"
        )
    by_poisson = np.exp(np.vander([np.log(ratio)], DEGREE + 1)[0] @ _fitted()).reshape(3, 3)
    return np.vander([poisson], 3)[0] @ np.linalg.solve(np.vander(POISSON, 3), by_poisson)


@lru_cache
def _fitted() -> NDArray:
    """Polynomials (DEGREE + 1, 9) of the logarithms of the coefficients over that of a/b."""
    logarithms = np.log(_TABLE).transpose(1, 0, 2).reshape(len(RATIOS), -1)
    return np.polyfit(np.log(RATIOS), logarithms, DEGREE)


def kalker(contacts: RollingContacts, creep: NDArray, start: NDArray | None = None) -> Rolled:
    r"""Steady rolling with Coulomb friction.

    .. math:: S = W\, \Delta x + u(x) - u(x + \Delta x),\quad u = A p,\quad |p| \le \mu p_n,\\
              S = 0 \ \text{(stick)} \quad\text{or}\quad p = -\mu p_n\, S/|S| \ \text{(slip)}

    Material comes from x + dx, one cell ahead, with the displacement u there.

    Arguments as of `RollingLaw`; the creep [-] is best taken `MID_STEP` ahead of the cell centres.
    Raises `NotSolved` when Newton's method finds no solution from any start.

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
    """Changes of the tractions [Pa] with the creep, see `RollingLaw`; stick and slip stay where they are.

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
