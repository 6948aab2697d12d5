"""Fatigue of raceways between which rolling elements go to and fro."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.outcome.raceway_damage import POINT, ContactFatigue

TURN = 2 * np.pi


def critical_oscillation(elements: int, diameter_ratio: float) -> NDArray:
    r"""Angle of oscillation below which neighbouring elements no longer roll over each other's places.

    .. math:: \theta_{crit} = \frac{720^\circ}{Z (1 \pm \gamma)}

    with + at the inner and - at the outer raceway.

    Parameters
    ----------
    elements : int
        Z, rolling elements of a row
    diameter_ratio : float
        gamma, D cos(alpha) over the pitch diameter [-]

    Returns
    -------
    array (2)
        theta_crit of the inner and the outer raceway [rad], from one end to the other

    Source
    ------
    Harris, Rumbarger and Butterfield, NREL DG03 (2009): an element goes (1 +- gamma)/2 of the angle along the
    raceway, and the next one begins 360 deg/Z further.

    Valid
    -----
    Rolling without slip; elements evenly spaced.

    >>> np.degrees(critical_oscillation(60, 0.02)).round(3)
    array([11.765, 12.245])
    """
    return 2 * TURN / (elements * (1 + np.array([1.0, -1.0]) * diameter_ratio))


def rolled_way(angle: float, pitch_diameter: float, diameter_ratio: float) -> float:
    r"""Length of a raceway, inner or outer, that each element rolls over.

    .. math:: x = \theta\, \frac{d_m}{4} (1 - \gamma^2)

    x [m] of an oscillation by theta from one end to the other [rad], a pitch diameter d_m [m] and gamma [-].

    Source
    ------
    Rolling: an element goes (1 +- gamma)/2 of the angle along a raceway of radius (1 -+ gamma) d_m/2.

    Valid
    -----
    Rolling without slip.

    >>> float(round(1e3 * rolled_way(np.radians(1.0), 1.9, 0.013), 3))
    8.289
    """
    return angle * pitch_diameter / 4 * (1 - diameter_ratio**2)


def guideline_factor(angle: float, elements: int, diameter_ratio: float) -> float:
    r"""Rating of an oscillating ball bearing over that of a turning one, for lives in oscillations.

    .. math:: \frac{C_{a,osc}}{C_a} = \Big(\frac{180^\circ}{\theta}\Big)^{1/3} (\theta \ge \theta_{crit}),
              \quad \Big(\frac{180^\circ}{\theta}\Big)^{3/10} Z^{0.033} (\theta < \theta_{crit})

    Parameters
    ----------
    angle : float
        theta, from one end to the other [rad], > 0
    elements : int
        Z, balls of a row
    diameter_ratio : float
        gamma [-], for theta_crit

    Returns
    -------
    float
        [-]; an oscillation goes there and back, so that 180 deg are as far as a revolution

    Source
    ------
    Harris, Rumbarger and Butterfield, NREL DG03 (2009), for balls; its text was not available, the formula of
    small angles is that of a public program which follows it (frasere/ISO-281). Of both theta_crit the larger
    one counts, of the outer raceway: assumed.

    Valid
    -----
    It jumps up by 4.7 % of C (15 % of the life) at theta_crit, as the printed form leaves a factor of 4 out;
    `oscillating_damage` does not.

    >>> round(guideline_factor(np.pi / 2, 60, 0.02), 6), round(guideline_factor(np.radians(5), 60, 0.02), 6)
    (1.259921, 3.354052)
    """
    if angle >= critical_oscillation(elements, diameter_ratio)[1]:
        return float((np.pi / angle) ** (1 / 3))
    return float((np.pi / angle) ** (3 / 10) * elements**0.033)


def spread_by_oscillation(damage: NDArray, angle: float) -> NDArray:
    r"""Mean damage that places of a ring meet which goes to and fro under a load at rest.

    .. math:: \bar d(\psi) = \frac{1}{\theta} \int_{\psi - \theta/2}^{\psi + \theta/2} d(\varphi)\, d\varphi

    with d straight between the elements.

    Parameters
    ----------
    damage : array (..., Z, K)
        d, damage that each element does where it is, such as the cube of its load; K slices
    angle : float
        theta, from one end to the other [rad], > 0

    Returns
    -------
    array (..., Z, K)
        mean of the places that are at the elements in the middle of the way; that of all elements for whole
        turns, the damage itself for an angle of zero

    Source
    ------
    Derived here: it is what Houpert (1999) and Breslau and Schlecht (2020) integrate for a given load zone.

    Valid
    -----
    Constant speed between the ends; a load that is at rest against the other ring.
    """
    elements = damage.shape[-2]
    width = angle * elements / TURN
    reach = int(np.ceil(width / 2)) + 1
    steps = np.arange(-reach, reach + 1)
    weights = (_under_hat(steps + width / 2) - _under_hat(steps - width / 2)) / width
    around = np.bincount(steps % elements, weights, minlength=elements)
    places = np.arange(elements)
    return np.einsum("ij,...jk->...ik", around[(places - places[:, None]) % elements], damage)


def oscillating_damage(
    loads: NDArray, capacity: Any, angle: float, critical: float, moves: bool, fatigue: ContactFatigue = POINT
) -> Any:
    r"""Damage of a raceway while the rings turn against each other to and fro.

    .. math:: \Big(\max\Big\{1, \frac{\theta_{crit}}{\theta}\Big\}\Big)^{e - 1}
              \sum_k \frac1Z \sum_j \bar q_{j,k}^{\,p e} \big/ q_c^{p e}

    where :math:`\bar q^p` is :math:`q^p` itself on a ring that is at rest under the load, and its mean by
    `spread_by_oscillation` on the one that moves. Below theta_crit only a part theta/theta_crit of the
    raceway is rolled over, that many times as often.

    Parameters
    ----------
    loads : array (..., Z, K)
        q of each of K slices [N], >= 0; one for balls
    capacity : float or array (...)
        Q_c of the whole raceway [N]
    angle : float
        theta, from one end to the other [rad], > 0
    critical : float
        theta_crit of this raceway [rad], see `critical_oscillation`
    moves : bool
        whether the ring moves against the load
    fatigue : ContactFatigue
        p, e, and c

    Returns
    -------
    float or array (...)
        damage [10^6 revolutions to the power -e], in revolutions that are gone to and fro together; that of
        `raceway_damage` for whole turns

    Source
    ------
    Lundberg and Palmgren (1947): damage goes with N^e V, by N of the loads that a place meets and V of the
    volume below the raceway that is loaded; Rumbarger and Jones (1968) for small angles. Derived here; NREL
    DG03 (2009) rounds it, see `guideline_factor`.

    Valid
    -----
    Fatigue from below the surface, full film: not where contacts move by less than their width, which wears
    raceways by fretting (false brinelling).
    """
    damage = loads**fatigue.load_exponent
    met = spread_by_oscillation(damage, angle) if moves else damage
    slice_capacity = capacity * loads.shape[-1] ** -fatigue.capacity_by_length
    by_slices = (met**fatigue.weibull).mean(axis=-2).sum(axis=-1)
    often = max(1.0, critical / angle) ** (fatigue.weibull - 1)
    return often * by_slices / slice_capacity ** (fatigue.load_exponent * fatigue.weibull)


def _under_hat(place: NDArray) -> NDArray:
    """Integral of the straight lines that are 1 at zero and 0 from one step away on."""
    inside = np.clip(place, -1.0, 1.0)
    return np.where(inside < 0, (1 + inside) ** 2 / 2, 1 - (1 - inside) ** 2 / 2)
