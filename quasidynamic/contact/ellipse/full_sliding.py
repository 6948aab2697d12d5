"""Full sliding friction in the contact ellipse of a ball and a raceway."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray
from scipy.special import ellipe, ellipkm1

from quasidynamic.contact.ellipse.point_contact import require_narrow
from quasidynamic.contact.ellipse.rigid_slip import (
    CENTRE,
    ROLL,
    SPIN,
    Spin,
    rigid_slip,
    sagitta,
    turn_by_slip,
)

SERIES = 0.02  # parameter of the elliptic integrals below which their series is used
TERMS = 9  # of that series
SMALLEST = 1e-200  # stands for the square of a slip of zero: a kink of |v|, met by rounding alone
POINTS = 32  # Gauss points in each panel
NARROWEST = 1e-3  # lateral over longitudinal slip below which the curvature is that of this ratio


class SlidingStrip(NamedTuple):
    """Derivatives of the heat of a strip."""

    by_along: NDArray  # F_v
    by_across: NDArray  # F_s
    secant_along: NDArray  # F_v / v
    secant_across: NDArray  # F_s / s
    bend: NDArray  # F_vv / s^2 = F_ss / v^2


def sliding_strip(along: NDArray, across: NDArray) -> SlidingStrip:
    r"""Heat of a strip across which the slip grows from its middle.

    .. math:: F(v, s) = \int_{-1}^{1} \sqrt{1 - t^2} \sqrt{v^2 + s^2 t^2}\, dt
              = \tfrac{2}{3} \rho\, [\mathcal{B} + 2 (1-m) \mathcal{D}],\quad
              \rho^2 = v^2 + s^2,\quad m = s^2/\rho^2, \\
              F_v = 2 \frac{v}{\rho} \mathcal{D},\quad
              F_s = \frac{2 s}{3 \rho} (\mathcal{D} - \mathcal{U}),\quad
              F_{vv} = \frac{2 s^2}{\rho^3} \mathcal{U}

    with the complete elliptic integrals D = (K - E)/m, B = K - D and U = (D - B)/m of the parameter m.

    Parameters
    ----------
    along : array (...), of one dimension at least
        v, slip of the whole strip [m/s]
    across : array (...)
        s, slip at right angles at the end of the strip [m/s]

    Returns
    -------
    SlidingStrip
        [-], [-], [s/m], [s/m], [s3/m3]; at v = s = 0, where the heat has a kink, the first two are zero

    Source
    ------
    The integral over t = cos(theta); Jahnke, Emde and Loesch (1960), Tables of Higher Functions, ch. V, for B
    and D.

    >>> strip = sliding_strip(np.array([3.0]), np.array([0.0]))  # F = pi/2 |v|
    >>> round(float(strip.by_along[0]), 6), float(strip.by_across[0])
    (1.570796, 0.0)
    """
    square = np.maximum(along**2 + across**2, SMALLEST)
    size = np.sqrt(square)
    third, bend = _elliptic(across**2 / square, np.maximum(along**2 / square, SMALLEST))
    secant_along, secant_across = 2 * third / size, 2 * (third - bend) / (3 * size)
    return SlidingStrip(
        secant_along * along, secant_across * across, secant_along, secant_across, 2 * bend / (square * size)
    )


def _elliptic(m: NDArray, q: NDArray) -> tuple[NDArray, NDArray]:
    """D = (K - E)/m and U = (2 D - K)/m of the parameter m = 1 - q."""
    first = ellipkm1(q)
    safe = np.maximum(m, SERIES)
    third = (first - ellipe(m)) / safe
    bend = (2 * third - first) / safe
    small = m < SERIES
    if small.any():
        third[small], bend[small] = _SERIES @ np.vander(m[small], TERMS, increasing=True).T
    return third, bend


def _series() -> NDArray:
    """Coefficients (2, TERMS) of D and U in powers of m, from the integrals of sin^2n."""
    n = np.arange(1, TERMS + 3)
    wallis = pi / 2 * np.cumprod(np.concatenate([[1.0], (2 * n - 1) / (2 * n)]))
    binomial = wallis[: TERMS + 1] * 2 / pi
    third = binomial * wallis[1 : TERMS + 2]
    other = binomial * (wallis[: TERMS + 1] - wallis[1 : TERMS + 2])
    return np.stack([third[:TERMS], (third - other)[1:]])


_SERIES = _series()


@dataclass(frozen=True)
class Ellipse:
    """Contact ellipses with Coulomb friction; arrays of one shape."""

    across: NDArray  # [m] a, semi-axis across the rolling direction
    along: NDArray  # [m] b, semi-axis along the rolling direction
    radius: NDArray  # [m] R of the pressed surface in the plane across, above a
    traction: NDArray  # [N] friction coefficient times load, zero where unloaded
    spin: Spin = "centre"  # that makes slip across, see `strip_slip`

    def __post_init__(self):
        require_narrow(self.across, self.radius)

    @cached_property
    def width(self) -> NDArray:
        """Semi-axis a, with a stand-in where the contact is unloaded [m]."""
        return np.where(self.traction > 0.0, self.across, 1e-3 * self.radius)

    def taken(self, keep: NDArray | tuple[int | NDArray, ...]) -> "Ellipse":
        """Return the same contacts of some of the balls (leading axis), or some of their contacts."""
        return Ellipse(self.across[keep], self.along[keep], self.radius[keep], self.traction[keep], self.spin)


@dataclass(frozen=True)
class SlidingFriction:
    """Friction of sliding contacts; the first derivative is minus the force on the ball."""

    power: NDArray  # (...) [W] heat
    by_slip: NDArray  # (..., 3) [N, N m, N m] derivative by centre slip, roll and spin
    lateral: NDArray  # (..., 3) part of `by_slip` that slip across makes
    curvatures: Callable[[], tuple[NDArray, NDArray]]  # see `_curvatures`


def no_slip_positions(slip: NDArray, radius: NDArray) -> tuple[NDArray, NDArray]:
    r"""Where the slip along the rolling direction vanishes, or comes closest to it.

    .. math:: e + A\,\sigma(x) + w x = 0 \;\Rightarrow\;
              (A^2 + w^2) x^2 - 2 w (R A - e) x - e (2 R A - e) = 0

    Parameters
    ----------
    slip : array (..., 3)
        e slip at the centre [m/s], A roll and w spin [rad/s]
    radius : array (...)
        R of the pressed surface [m]

    Returns
    -------
    array (...), array (...)
        both positions [m], the lower first; twice the real part where they are complex. They may lie
        outside the ellipse or, for x beyond the quarter circle, on the far side of the surface.

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12, for the slip; solved here.
    """
    centre, roll, spin = slip[..., CENTRE], slip[..., ROLL], slip[..., SPIN]
    square = np.maximum(roll**2 + spin**2, SMALLEST)
    middle = spin * (radius * roll - centre)
    fall = centre * (2 * radius * roll - centre)
    half = np.abs(roll) * np.sqrt(np.maximum((spin * radius) ** 2 + fall, 0.0))
    far = middle + np.copysign(half, middle)
    apart = half > 0.0
    near = np.where(apart, -fall * square / np.where(apart, far, 1.0), middle)
    return np.minimum(far, near) / square, np.maximum(far, near) / square


def sliding_friction(slip: NDArray, ellipse: Ellipse) -> SlidingFriction:
    r"""Heat of full sliding with its first two derivatives by the slip.

    .. math:: \Phi = \int \mu p\, |v|\, dA,\quad p = \frac{3 Q}{2 \pi a b} \sqrt{1 - x^2/a^2 - y^2/b^2},\\
              v_t = e + A\,\sigma(x) + w x,\quad v_1 = -w_l y

    with w_l = w or the spin of each point, as the ellipse says, see `turn_by_slip`. The integral over y is
    that of `sliding_strip`, in closed form; the integral over x is taken by Gauss panels between the
    positions without slip, with points crowded at their ends.

    Parameters
    ----------
    slip : array (..., 3)
        e slip at the centre of the contact along the rolling direction [m/s], A roll and w spin of the ball
        against the race [rad/s]
    ellipse : Ellipse
        a, b, R, mu Q and the spin that makes slip across

    Returns
    -------
    SlidingFriction
        homogeneous of degree one in the slip and convex

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12; Leblanc and Nelias (2007), J. Tribol. 129, 801-808, for slip and
    traction.

    Valid
    -----
    Coulomb friction of one coefficient per contact, sliding everywhere: no stick. Where the slip vanishes
    all over a contact the heat has a kink.
    """
    x, weight = _panels(slip, ellipse)
    share = np.maximum(1.0 - (x / ellipse.width[..., None]) ** 2, 0.0)  # rounding alone makes it negative
    half = ellipse.along[..., None] * np.sqrt(share)  # of the strip at x
    rise = sagitta(x, ellipse.radius[..., None])
    centre, roll, spin = (slip[..., i, None] for i in (CENTRE, ROLL, SPIN))
    by_roll, by_spin = turn_by_slip(x, ellipse.radius[..., None], ellipse.spin)
    along, turn = centre + roll * rise + spin * x, roll * by_roll + spin * by_spin
    strip = sliding_strip(along, turn * half)
    weight = weight * share * (1.5 / pi * ellipse.traction / ellipse.width)[..., None]
    cross, across = weight * strip.by_along, weight * strip.by_across * half
    moments, lateral = np.empty(slip.shape), np.zeros(slip.shape)
    lateral[..., ROLL], lateral[..., SPIN] = (across * by_roll).sum(-1), (across * by_spin).sum(-1)
    moments[..., CENTRE] = cross.sum(-1)
    moments[..., ROLL] = (cross * rise).sum(-1)
    moments[..., SPIN] = (cross * x).sum(-1)
    moments += lateral
    points = _StripPoints(x, rise, half, along, turn, (by_roll, by_spin), weight)
    return SlidingFriction(
        power=(slip * moments).sum(-1),
        by_slip=moments,
        lateral=lateral,
        curvatures=lambda: _curvatures(slip, ellipse, points, strip),
    )


class _StripPoints(NamedTuple):
    """Strips of the ellipse (..., n)."""

    x: NDArray  # [m]
    rise: NDArray  # [m] of the surface
    half: NDArray  # [m] half of the length
    along: NDArray  # [m/s] slip
    turn: NDArray  # [rad/s] spin, one for all or each its own
    turn_by_slip: tuple[NDArray, NDArray]  # [-] by roll and spin
    weight: NDArray


def _panels(slip: NDArray, ellipse: Ellipse) -> tuple[NDArray, NDArray]:
    """Points (..., n) and weights [m] of panels that meet where there is no slip.

    Between both positions without slip along, the spin of each point is zero: a kink where they are close.
    """
    width = ellipse.width
    low, high = no_slip_positions(slip, ellipse.radius)
    middle = [(low + high) / 2] if ellipse.spin == "local" else []
    edges = np.stack(np.broadcast_arrays(-width, low, *middle, high, width), -1)
    edges = np.minimum(np.maximum(edges, -width[..., None]), width[..., None])
    length = (edges[..., 1:] - edges[..., :-1])[..., None]
    shape = (*low.shape, length.shape[-2] * POINTS)
    points = edges[..., :-1, None] + length * _GRADED_POINTS
    return points.reshape(shape), (length * _GRADED_WEIGHTS).reshape(shape)


def _graded() -> tuple[NDArray, NDArray]:
    """Gauss points on (0, 1) crowded at both ends by t = s^3 (10 - 15 s + 6 s^2), for logarithms there."""
    s, weight = leggauss(POINTS)
    s, weight = (s + 1) / 2, weight / 2
    return s**3 * (10 - 15 * s + 6 * s**2), weight * 30 * (s * (1 - s)) ** 2


_GRADED_POINTS, _GRADED_WEIGHTS = _graded()


def _curvatures(
    slip: NDArray, ellipse: Ellipse, points: _StripPoints, strip: SlidingStrip
) -> tuple[NDArray, NDArray]:
    """Second derivatives of the heat (..., 3, 3), and those of the parabola that touches it and lies above.

    Where the lateral slip nearly vanishes the heat has a kink along a line, which would fall between the
    points: its second derivatives are taken at the ratio `NARROWEST`.
    """
    turn, (by_roll, by_spin) = points.turn, points.turn_by_slip
    least = NARROWEST * np.abs(slip[..., ROLL, None]) * (ellipse.width**2 / (2 * ellipse.radius))[..., None]
    narrow = (np.abs(turn) * ellipse.along[..., None] < least) & (ellipse.traction > 0.0)[..., None]
    bend = strip.bend
    if narrow.any():
        short = np.maximum(ellipse.along[..., None], SMALLEST)
        turn = np.where(narrow, np.copysign(least / short, turn), turn)
        bend = sliding_strip(points.along, turn * points.half).bend
    functions = np.empty((2, *slip.shape, points.x.shape[-1]))
    functions[1, ..., CENTRE, :] = 1.0
    functions[1, ..., ROLL, :] = points.rise
    functions[1, ..., SPIN, :] = points.x
    functions[0] = turn[..., None, :] * functions[1]
    functions[0, ..., ROLL, :] -= by_roll * points.along
    functions[0, ..., SPIN, :] -= by_spin * points.along
    square = points.weight * points.half**2
    weighted = functions.copy()
    weighted[0] *= (square * bend)[..., None, :]
    weighted[1] *= (points.weight * strip.secant_along)[..., None, :]
    curvature, majorant = weighted @ np.swapaxes(functions, -1, -2)
    lateral = square * strip.secant_across
    majorant[..., ROLL, ROLL] += (lateral * by_roll**2).sum(-1)
    majorant[..., SPIN, SPIN] += (lateral * by_spin**2).sum(-1)
    mixed = (lateral * (by_roll * by_spin)).sum(-1)
    majorant[..., ROLL, SPIN] += mixed
    majorant[..., SPIN, ROLL] += mixed
    return curvature, majorant


def slip_field(slip: NDArray, ellipse: Ellipse, x: NDArray, y: NDArray) -> NDArray:
    r"""Slip at points of the ellipse, for pictures.

    .. math:: v_t = e + A\,\sigma(x) + w x,\quad v_1 = -w_l y

    An array (2, ...) [m/s], ball against race, of e [m/s], A and w [rad/s]; x and y [m] are across and along
    the rolling direction, and ellipses broadcast with x.

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12; see `rigid_slip` for the slip.
    """
    width = ellipse.width
    by_slip = rigid_slip(np.clip(x, -width, width), y, ellipse.radius, ellipse.spin)[..., :3]
    return np.einsum("...ji,...i->j...", by_slip, slip)
