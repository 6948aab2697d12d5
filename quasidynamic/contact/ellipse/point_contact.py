"""Hertz contact of a ball and a raceway groove."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ellipe, ellipkm1, elliprd

from quasidynamic.errors import NotSolved, OutOfRange

INNER, OUTER = -1.0, 1.0  # side of the ball a race lies on: towards the shaft, away from it

TOLERANCE = 4e-15  # of ln(a/b), absolute below 1
LIMIT = 30  # evaluations, rarely more than five
ROUND = 1e-4  # ln(a/b) below which the slope is that of the circle


def require_narrow(across: NDArray, radius: NDArray) -> None:
    """Refuse contacts that are as wide as the surface they press: semi-axis and radius across [m].

    Raises `OutOfRange` with the largest semi-axis.

    Source
    ------
    Geometry: a contact on a sphere of radius R is narrower than the sphere.
    """
    if not np.all(across < radius):
        raise OutOfRange(
            f"contact ellipse: semi-axis {1e3 * np.max(across):.4g} mm is not below the radius "
            f"{1e3 * np.min(radius):.4g} mm of the pressed surface: the load is far too high"
        )


class Curvatures(NamedTuple):
    """Relative curvatures of two bodies, sums over both, convex positive [1/m]."""

    across: NDArray  # in the plane of the groove section: 2/D - 1/r
    along: NDArray  # in the rolling direction


@dataclass(frozen=True)
class PointContact:
    """Hertz contact of one geometry at any load; arrays of the shape of the curvatures."""

    coefficient: NDArray  # [N/m^1.5] K in Q = K delta^1.5
    across: NDArray  # [m/N^(1/3)] semi-axis across the rolling direction over the cube root of the load
    along: NDArray  # [m/N^(1/3)] the same along the rolling direction

    def load(self, approach: ArrayLike) -> NDArray:
        """Q [N] at an approach [m]; zero with zero slope where the bodies are apart (approach <= 0)."""
        return self.coefficient * np.maximum(approach, 0.0) ** 1.5

    def stiffness(self, approach: ArrayLike) -> NDArray:
        """dQ/d(approach) [N/m] at an approach [m]."""
        return 1.5 * self.coefficient * np.sqrt(np.maximum(approach, 0.0))

    def approach(self, load: ArrayLike) -> NDArray:
        """Approach of distant points [m] under a load [N], >= 0."""
        return (np.asarray(load) / self.coefficient) ** (2 / 3)

    def semi_axes(self, load: ArrayLike) -> tuple[NDArray, NDArray]:
        """Semi-axes a across and b along the rolling direction [m] under a load [N], >= 0."""
        root = np.cbrt(load)
        return self.across * root, self.along * root

    def peak_pressure(self, load: ArrayLike) -> NDArray:
        """p0 = 3 Q/(2 pi a b) [Pa] under a load [N], >= 0."""
        return 1.5 * np.cbrt(load) / (np.pi * self.across * self.along)


def race_curvatures(
    ball_diameter: ArrayLike,
    groove_radius: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike,
    side: ArrayLike,
) -> Curvatures:
    r"""Relative curvatures of a ball in a groove.

    .. math:: \rho_a = 2/D - 1/r,\quad \rho_b = \frac{2/D}{1 \pm \gamma},\quad \gamma = D \cos\alpha / d_m

    with + on the outer and - on the inner race.

    Parameters
    ----------
    ball_diameter : array (...)
        D [m]
    groove_radius : array (...)
        r [m], above D/2
    pitch_diameter : array (...)
        d_m of the ball centres [m], > D
    contact_angle : array (...)
        alpha from the radial plane [rad]
    side : array (...)
        `OUTER` (+1) or `INNER` (-1)

    Returns
    -------
    Curvatures
        across (rho_a) and along (rho_b) the rolling direction [1/m]

    Raises
    ------
    OutOfRange
        where the groove is not wider than the ball

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 2.

    >>> curvatures = race_curvatures(22.23e-3, 11.63e-3, 125.26e-3, 0.6981, INNER)
    >>> [round(float(value), 2) for value in curvatures]
    [3.98, 104.12]
    """
    ball = 2.0 / np.asarray(ball_diameter, dtype=float)
    across = ball - 1.0 / np.asarray(groove_radius)
    if not np.all(across > 0.0):
        raise OutOfRange(
            f"groove radius {1e3 * np.min(groove_radius):.6g} mm must be above the ball radius: the contact "
            "of a ball in a groove as narrow as itself is no ellipse"
        )
    along = ball / (
        1.0 + np.asarray(side) * np.asarray(ball_diameter) * np.cos(contact_angle) / pitch_diameter
    )
    return Curvatures(*np.broadcast_arrays(across, along))


def point_contact(curvatures: Curvatures, modulus: ArrayLike) -> PointContact:
    r"""Elliptic Hertz contact.

    .. math:: Q = K \delta^{3/2},\quad
              c = \left(\frac{3 Q}{E' S}\right)^{1/3},\quad S = \rho_a + \rho_b,\quad k = a/b, \\
              a = c \left(\frac{2 k^2 \mathcal{E}}{\pi}\right)^{1/3},\quad
              b = a / k,\quad
              \delta = \frac{c^2 S}{2} \frac{2 \mathcal{K}}{\pi}
              \left(\frac{\pi}{2 k^2 \mathcal{E}}\right)^{1/3}

    with the complete elliptic integrals K and E of the parameter 1 - 1/k^2; a may be the shorter axis.

    Parameters
    ----------
    curvatures : Curvatures
        rho_a, rho_b [1/m], both > 0
    modulus : array (...)
        E' = 2/[(1-nu1^2)/E1 + (1-nu2^2)/E2] [Pa], see `contact_modulus`

    Raises
    ------
    OutOfRange
        for relative curvatures that are not above zero

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2 (there E* = E'/2).

    Valid
    -----
    Elastic, frictionless, semi-axes far below the radii: closely fitting grooves under heavy load
    (a near D/4) are beyond it.
    """
    across, along = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in curvatures))
    if not (np.all(across > 0.0) and np.all(along > 0.0)):
        raise OutOfRange("relative curvatures of an elliptic contact must be above zero")
    ratio = np.exp(log_axis_ratio(across / along))
    first, second = ellipkm1(ratio**-2.0), ellipe(1.0 - ratio**-2.0)
    unit = np.cbrt(3.0 / (np.asarray(modulus) * (across + along)))
    wide = np.cbrt(2.0 * ratio**2 * second / np.pi)
    approach = unit**2 * (across + along) * first / (np.pi * wide)
    return PointContact(coefficient=approach**-1.5, across=unit * wide, along=unit * wide / ratio)


def in_series(*contacts: PointContact) -> NDArray:
    r"""Coefficient of contacts under one load whose approaches add up, such as both ends of a diagonal.

    .. math:: K = \left(\sum_i K_i^{-2/3}\right)^{-3/2}

    Parameters
    ----------
    contacts : PointContact
        one after the other, coefficients K_i [N/m^1.5]

    Returns
    -------
    array (...)
        K [N/m^1.5]

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 5.
    """
    return sum(contact.coefficient ** (-2 / 3) for contact in contacts) ** -1.5


def log_axis_ratio(curvature_ratio: ArrayLike) -> NDArray:
    r"""Logarithm of the ratio of the semi-axes of a Hertz ellipse.

    .. math:: \frac{\rho_a}{\rho_b} = \frac{R_D(0, k^{-2}, 1)}{R_D(0, 1, k^{-2})},\quad k = a/b

    the usual F(rho) = [(k^2+1)E - 2K]/[(k^2-1)E] in Carlson's integrals, where nothing cancels near the
    circle. The logarithms of both sides are nearly proportional: Newton's method on ln k.

    Parameters
    ----------
    curvature_ratio : array (...)
        rho_a/rho_b [-], > 0

    Returns
    -------
    array (...)
        ln(a/b) [-], positive where rho_a < rho_b

    Raises
    ------
    NotSolved
        when the iteration does not settle

    Source
    ------
    Johnson, Contact Mechanics (1985), Eqs (4.25) and (4.26); DLMF sec. 19.25 for Carlson's form.

    >>> round(float(log_axis_ratio(0.3)), 6)
    0.797565
    """
    target = np.log(curvature_ratio)
    size = np.abs(target)  # odd in ln(rho_a/rho_b): the circle is the middle
    low, high = size / 2, size * 2 / 3  # slopes of ln ratio between 3/2 at the circle and 2 far away
    log_ratio = 0.5 * (low + high)
    for _ in range(LIMIT):
        value, slope = _log_curvature_ratio(log_ratio)
        step = (size - value) / slope
        low, high = np.where(step > 0, log_ratio, low), np.where(step < 0, log_ratio, high)
        trial = log_ratio + step
        outside = (trial < low) | (trial > high)
        trial = np.where(outside, 0.5 * (low + high), trial)
        done = np.abs(trial - log_ratio) <= TOLERANCE * np.maximum(1.0, log_ratio)
        log_ratio = trial
        if np.all(done):
            return -np.sign(target) * log_ratio
    raise NotSolved(f"ratio of the semi-axes not settled in {LIMIT} steps: {np.max(np.abs(step)):.1e} left")


def _log_curvature_ratio(log_ratio: NDArray) -> tuple[NDArray, NDArray]:
    """Return -ln(rho_a/rho_b) at ln k >= 0 and its slope."""
    q = np.exp(-2.0 * log_ratio)
    third = elliprd(0.0, q, 1.0) / 3  # D = (K - E)/m
    other = q * elliprd(0.0, 1.0, q) / 3  # B = (E - q K)/m, with m = 1 - q
    near = log_ratio < ROUND
    m = np.where(near, 1.0, -np.expm1(-2.0 * log_ratio))
    by_m = (other - q * third) / (2 * m * q * third) - 1 / q - (third - other) / (2 * m * other)
    return np.log(other / (q * third)), np.where(near, 1.5, -2.0 * q * by_m)
