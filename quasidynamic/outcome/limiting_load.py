"""Static loads that a four-point bearing just bears, by the pressure, the hardened case and the shoulders."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from quasidynamic.contact.ellipse.point_contact import INNER, OUTER, point_contact, race_curvatures
from quasidynamic.contact.ellipse.subsurface import ellipse_stress
from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.ball_capacity import PERMANENT
from quasidynamic.outcome.rating_life import POINT
from quasidynamic.parts.ball import FourPointBearing

LIMITS = ("contact pressure", "core below the hardened case", "shoulder")
SIDES = np.array([INNER, OUTER])
FARTHEST = 1e3  # scale of the load, up and down from the first, within which a limit is sought
EXACT = 1e-8  # of the scale


@dataclass(frozen=True, kw_only=True)
class StaticLimits:
    """What a contact bears at standstill."""

    safety: float = 1.0  # [-] of the load of the contact against that of the static rating
    case_depth: float | None = None  # [m] of the hardened case; None: the core is not looked into
    core_yield: float = np.inf  # [Pa] yield stress below the case

    @property
    def pressure(self) -> float:
        """Largest peak pressure [Pa]."""
        return PERMANENT / self.safety ** (1 / POINT)


def limit_shares(bearing: FourPointBearing, loads: NDArray, angles: NDArray, limits: StaticLimits) -> NDArray:
    r"""How far the contacts of a bearing come to what they bear.

    .. math:: \Big[ \max \frac{p_0}{p_{lim}},\; \max \frac{\sigma_{vM}(h)}{\sigma_y},\;
              \max \frac{\alpha + a/r}{\alpha_{end}} \Big]

    with the peak pressure p_0 of each contact, the von Mises stress below the middle of the most loaded one
    of each raceway in the depth h of the case, and the contact angle alpha at the edge of each ellipse, of
    semi-axis a on a groove of radius r that ends on its shoulder at alpha_end.

    Parameters
    ----------
    bearing : FourPointBearing
        grooves, moduli, ends of the grooves
    loads, angles : arrays (..., 2)
        of all contacts [N], [rad], inner race first
    limits : StaticLimits
        p_lim, h, sigma_y

    Returns
    -------
    array (3)
        in the order of `LIMITS` [-]; zero of what is not given

    Source
    ------
    ISO 76 (2006) for 4200 MPa; core crushing as the yield of the core below the case by von Mises, without
    residual stress; `edge_angle`.

    Valid
    -----
    Hertz contacts; a truncated contact is beyond the third limit.
    """
    curvatures = race_curvatures(
        bearing.ball.diameter, bearing.groove_radii, bearing.pitch_diameter, angles, SIDES
    )
    contacts = point_contact(curvatures, bearing.moduli)
    pressure, (across, along) = contacts.peak_pressure(loads), contacts.semi_axes(loads)
    edges = angles + across / bearing.groove_radii  # see `edge_angle`
    shoulder = np.where(loads > 0, edges / np.array(bearing.groove_ends), 0.0).max()
    core = 0.0 if limits.case_depth is None else _core(bearing, loads, (pressure, along, across), limits)
    return np.array([pressure.max() / limits.pressure, core, shoulder])


def limiting_scale(share: Callable[[float], float], first: float = 1.0) -> float:
    r"""Scale of a load at which a share of a limit becomes one.

    .. math:: s(\lambda) = 1

    Parameters
    ----------
    share : callable
        s of a scale, growing [-]
    first : float
        lambda where the search begins [-], > 0

    Returns
    -------
    float
        lambda [-]

    Raises
    ------
    OutOfRange
        when the limit is not reached at a scale, or passed at every one

    Source
    ------
    Brent (1973), Algorithms for minimization without derivatives, within factors of two that hold the limit.
    """
    low = high = first
    while share(high) < 1.0:
        low, high = high, 2.0 * high
        if high > FARTHEST * first:
            raise OutOfRange("no load in this direction reaches the limit")
    while low == high or share(low) > 1.0:
        low /= 2.0
        if low * FARTHEST < first:
            raise OutOfRange("the limit is passed without a load in this direction")
    return float(brentq(lambda scale: share(scale) - 1.0, low, high, rtol=EXACT))  # type: ignore[arg-type]


def _core(
    bearing: FourPointBearing, loads: NDArray, contacts: tuple[NDArray, ...], limits: StaticLimits
) -> float:
    """Stress below the case of the most loaded contact of each raceway over the yield stress [-]."""
    if not loads.any():
        return 0.0
    assert limits.case_depth is not None  # known to whom calls it
    most, races = loads.reshape(-1, 2).argmax(axis=0), np.arange(2)
    found = []
    of_most = (values.reshape(-1, 2)[most, races] for values in contacts)
    for ring, *each in zip((bearing.inner, bearing.outer), *of_most, strict=True):
        pressure, along, across = map(float, each)
        below = ellipse_stress(0.0, limits.case_depth / along, along / across, ring.material.poisson_ratio)
        found.append(pressure * float(below.von_mises))
    return max(found) / limits.core_yield
