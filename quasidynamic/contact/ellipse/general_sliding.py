"""Friction in a contact ellipse that slips in any direction: full sliding, or by a law of the slip."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse, no_slip_positions
from quasidynamic.contact.ellipse.rigid_slip import (
    ACROSS,
    PIVOT,
    ROLL,
    SPIN,
    Spin,
    strip_slip,
)

FLATTEST = 1e-3  # of the slip of a strip: least change along the strip that its points follow
NEAREST = 1e-9  # of the slip of a strip: least slip along the rolling direction that its points follow
SMALLEST = 1e-200  # stands for the square of a slip of zero: a kink of |v|, met by rounding alone


class EllipsePoints(NamedTuple):
    """How many points an ellipse is resolved with."""

    across: int  # in each of four panels
    along: int  # in each strip
    narrowest: float  # of the semi-axis across: width next to a line without slip that they resolve


FINE = EllipsePoints(
    24, 16, 5e-4
)  # error of 1e-9 of the heat, of 1e-7 of the forces at worst, mostly far less
COARSE = EllipsePoints(8, 10, 0.1)  # of 1e-3
_FAN = np.array([-1.0, 1.0, -1.0, 1.0])


class SlipFriction(NamedTuple):
    """Coefficient of friction at points, of the load there, with its derivatives."""

    coefficient: NDArray  # [-] >= 0
    by_slip: NDArray  # [s/m] by the size of the slip
    by_entrainment: NDArray  # [s/m] by the mean surface speed
    by_film: NDArray  # [1/m]


# From 1 - x^2/a^2 of strips (..., n) and the size of the slip at points (..., n, m).
FrictionLaw = Callable[[NDArray, NDArray], SlipFriction]


class _Strips(NamedTuple):
    """Strips (..., n) of ellipses along the rolling direction, with points (..., n, m) on them.

    The slip of a strip is v_t, and v_1 = k - s t at the place t over its half length.
    """

    x: NDArray  # [m]
    by_slip: NDArray  # (..., 3, 5, n) v_t, k and -s by the slip of the contact
    friction: NDArray  # (..., 3, n) [N] derivative of the heat by v_t, k and -s
    along: NDArray  # [m/s] v_t
    whole: NDArray  # [N s/m] friction over slip
    place: NDArray  # of the points, over the half length
    across: NDArray  # [m/s] slip of the points
    square: NDArray  # [m2/s2] of the whole slip of the points
    share: NDArray  # [N s/m] friction over slip of the points
    steep: NDArray | float  # [N s/m] derivative of the friction by the size of the slip; zero of Coulomb's


@dataclass(frozen=True)
class GeneralSliding:
    """Friction of sliding contacts; the first derivative of the heat is minus the force on the ball."""

    slip: NDArray  # (..., 5)
    by_slip: NDArray  # (..., 5) [N, N m, N m, N, N m] derivative of the heat by the slip
    ellipse: Ellipse
    points: EllipsePoints
    strips: _Strips
    by_entrainment: NDArray | None = None  # (..., 5) derivative of `by_slip` by the mean surface speed
    by_film: NDArray | None = None  # (..., 5) the same by the film; neither of Coulomb friction

    @property
    def power(self) -> NDArray:
        """Heat (...) [W]."""
        return (self.slip * self.by_slip).sum(-1)

    @cached_property
    def curvature(self) -> NDArray:
        """Second derivatives of the heat by the slip (..., 5, 5)."""
        bends, by_slip = self._bends, self.strips.by_slip
        bent = sum(bends[..., i, None, :] * by_slip[..., None, i, :, :] for i in range(3))
        return (by_slip @ np.swapaxes(bent, -1, -2)).sum(-3)

    @property
    def majorant(self) -> NDArray:
        """Curvatures (..., 5) of a parabola without mixed terms that touches the heat and lies above it."""
        squares = (self.strips.by_slip**2).sum(-3) @ self.strips.whole[..., None]
        return squares[..., 0] * [3.0, 3.0, 3.0, 2.0, 2.0]

    @property
    def by_load(self) -> NDArray:
        r"""Derivative (..., 5) of `by_slip` by the logarithm of the load, the slip given.

        Friction grows with the load, the semi-axes with its cube root.
        """
        strips = self.strips
        grown = _grown(strips, self.ellipse.radius[..., None], self.ellipse.spin)
        change = (grown * self.slip[..., None, :, None]).sum(-2)
        bent = (self._bends * change[..., None, :, :]).sum(-2)
        parts = strips.by_slip * bent[..., None, :] + grown * strips.friction[..., None, :]
        return parts.sum((-3, -1)) / 3 + self.by_slip

    @cached_property
    def _bends(self) -> NDArray:
        """Second derivatives (..., 3, 3, n) of the heat of strips by v_t, k and -s.

        Where the slip across nearly vanishes the heat has a kink along a line, which would fall between the
        points: the derivative by v_t is taken at a slip across that the points still resolve.
        """
        strips = self.strips
        cubed, along = (strips.share - strips.steep) / strips.square, strips.along
        turned, leaned = cubed * strips.across, cubed * strips.place
        bends = np.empty((*along.shape[:-1], 3, 3, along.shape[-1]))
        bends[..., 0, 0, :] = np.einsum("...m,...m", turned, strips.across)
        bends[..., 0, 1, :] = bends[..., 1, 0, :] = -along * turned.sum(-1)
        bends[..., 0, 2, :] = bends[..., 2, 0, :] = -along * np.einsum("...m,...m", turned, strips.place)
        bends[..., 1, 1, :] = along**2 * cubed.sum(-1)
        bends[..., 1, 2, :] = bends[..., 2, 1, :] = along**2 * leaned.sum(-1)
        bends[..., 2, 2, :] = along**2 * np.einsum("...m,...m", leaned, strips.place)
        least, narrow = self._narrow
        if narrow.any():
            shares, squares = (strips.share - strips.steep)[narrow], strips.square[narrow]
            lateral = least[narrow][..., None, None] + np.abs(strips.across[narrow])
            wider = along[narrow][..., None] ** 2 + lateral**2
            bends[narrow, 0, 0, :] = (shares * np.sqrt(squares) * lateral**2 / wider**1.5).sum(-1)
        if isinstance(strips.steep, np.ndarray):
            bends[..., 0, 0, :] += strips.steep.sum(-1)
            bends[..., 1, 1, :] += strips.steep.sum(-1)
            moment = np.einsum("...m,...m", strips.steep, strips.place)
            bends[..., 1, 2, :] += moment
            bends[..., 2, 1, :] += moment
            bends[..., 2, 2, :] += np.einsum("...m,...m", strips.steep, strips.place**2)
        return bends

    @property
    def _narrow(self) -> tuple[NDArray, NDArray]:
        """Least slip across that the points resolve, and the contacts with less (...)."""
        ellipse, (_, roll, spin, across, _) = self.ellipse, np.moveaxis(self.slip, -1, 0)
        least = 2 * self.points.narrowest * np.abs(roll) * ellipse.across**2 / (2 * ellipse.radius)
        turn = np.abs(spin)
        if ellipse.spin == "local":
            turn = turn + np.abs(roll) * ellipse.across / ellipse.radius
        return least, (np.abs(across) + turn * ellipse.along < least) & (ellipse.traction > 0.0)


def sliding_ellipse(
    slip: NDArray, ellipse: Ellipse, points: EllipsePoints = FINE, law: FrictionLaw | None = None
) -> GeneralSliding:
    r"""Friction under slip in both directions, of full sliding or by a law of the slip.

    .. math:: \Phi = \int \mu p\, |v|\, dA,\quad p = \frac{3 Q}{2 \pi a b} \sqrt{1 - x^2/a^2 - y^2/b^2},\\
              v_t = e + A\,\sigma(x) + w x,\quad v_1 = k(x) - w_l(x)\, y

    with v_1 by the spin of the centre or of each point, as the ellipse says, see `strip_slip`.

    Parameters
    ----------
    slip : array (..., 5)
        of the ball against the race: e slip at the centre of the contact along the rolling direction [m/s],
        A roll and w spin [rad/s], c slip at the centre across the rolling direction [m/s], B turn about the
        rolling direction [rad/s]
    ellipse : Ellipse
        a, b, R, mu Q and the spin that makes slip across
    points : EllipsePoints
        panels between the lines v_t = 0, see `strip_points` for those of a strip
    law : FrictionLaw
        coefficient by place and size of the slip, of the load that the ellipse has for its friction; None:
        one everywhere, the friction is that of the ellipse

    Returns
    -------
    GeneralSliding
        without a law homogeneous of degree one in the slip and convex; with one, `by_slip` are the
        derivatives of a potential, int p int_0^|v| mu dv dA, convex where no traction falls with the slip,
        and `power` stays the heat

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12, for slip and traction, here with that of a ball that turns about the
    rolling direction; c = B = 0 is `sliding_friction`.

    Valid
    -----
    Sliding everywhere: no stick. Without a law Coulomb friction of one coefficient per contact: where the
    slip vanishes all over a contact the heat has a kink.
    """
    x, width = _panels(slip, ellipse, points)
    part = np.maximum(1.0 - (x / ellipse.width[..., None]) ** 2, 0.0)  # rounding alone makes it negative
    by_slip = strip_slip(x, ellipse.radius[..., None], ellipse.spin)
    by_slip[..., 2, :, :] *= (ellipse.along[..., None] * np.sqrt(part))[..., None, :]
    along, middle, turn = _slip_of_strips(slip, by_slip)
    place, share = strip_points(along, middle, -turn, points.along)
    lateral = middle[..., None] + turn[..., None] * place
    square = (along**2 + SMALLEST)[..., None] + lateral * lateral
    share /= np.sqrt(square)
    share *= (width * part * (1.5 / pi * ellipse.traction / ellipse.width)[..., None])[..., None]

    def summed(share: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Friction of strips, over slip and by slip; the latter of the contact, from that of points."""
        pushed, whole = share * lateral, share.sum(-1)
        friction = np.stack([along * whole, pushed.sum(-1), np.einsum("...m,...m", pushed, place)], -2)
        return whole, friction, (by_slip @ friction[..., None])[..., 0].sum(-2)

    steep, by_entrainment, by_film = 0.0, None, None
    if law is not None:
        pressed, size = share, np.sqrt(square)
        found = law(part, size)
        share, steep = pressed * found.coefficient, pressed * size * found.by_slip
        _, _, by_entrainment = summed(pressed * found.by_entrainment)
        _, _, by_film = summed(pressed * found.by_film)
    whole, friction, by_all = summed(share)
    strips = _Strips(x, by_slip, friction, along, whole, place, lateral, square, share, steep)
    return GeneralSliding(slip, by_all, ellipse, points, strips, by_entrainment, by_film)


def _grown(strips: _Strips, radius: NDArray, spin: Spin) -> NDArray:
    """Derivative (..., 3, 5, n) of the slip of strips by the logarithm of x and of their half length."""
    x, by_slip, grown = strips.x, strips.by_slip, np.zeros_like(strips.by_slip)
    steep = -(x**2) / np.sqrt(radius**2 - x**2)  # x sigma'
    grown[..., 0, ROLL, :], grown[..., 0, SPIN, :] = steep, x
    grown[..., 2, SPIN, :] = by_slip[..., 2, SPIN, :]
    if spin == "centre":
        grown[..., 1, PIVOT, :] = steep
        return grown
    grown[..., 1, ACROSS, :], grown[..., 1, PIVOT, :] = steep / radius, -steep
    grown[..., 2, ROLL, :] = 2 * by_slip[..., 2, ROLL, :]
    grown[..., 2, SPIN, :] *= 1 - x**2 / (radius**2 - x**2)
    return grown


def strip_points(along: NDArray, middle: NDArray, turn: NDArray, points: int) -> tuple[NDArray, NDArray]:
    r"""Points and weights of a strip for integrands of the slip.

    .. math:: \int_{-1}^{1} \sqrt{1 - t^2}\, g(t)\, dt,\qquad s t - k = |v| \sinh q

    by Gauss-Chebyshev quadrature of the second kind in q: g may be any smooth function of v, of k - s t and
    of the size of both, however close to zero it comes.

    v, k and s are in m/s; t and weights are (..., points) [-], of an even number of points.

    Source
    ------
    The substitution of Johnston and Elliott, Int. J. Numer. Meth. Eng. 62 (2005), 564-578.
    """
    node, weight = _chebyshev(points)
    least = np.abs(along) + NEAREST * (np.abs(middle) + np.abs(turn)) + SMALLEST
    width = np.maximum(np.abs(turn), FLATTEST * (least + np.abs(middle)))
    centre = np.where(turn < 0, -middle, middle)
    low, high = np.arcsinh((-width - centre) / least), np.arcsinh((width - centre) / least)
    reach, rise, scale = (high - low) / 2, np.exp((high + low) / 2), least / (2 * width)
    upper = np.exp(reach[..., None] * node[: points // 2])
    both = np.concatenate([upper, 1 / upper[..., ::-1]], -1)
    grown, shrunk = both * (scale * rise)[..., None], both[..., ::-1] * (scale / rise)[..., None]
    place = grown - shrunk
    place += (centre / width)[..., None]
    grown += shrunk
    grown *= np.sqrt(np.maximum(1.0 - place * place, 0.0))
    return place, grown * (reach[..., None] * weight)


@lru_cache
def _chebyshev(points: int) -> tuple[NDArray, NDArray]:
    """Nodes on (-1, 1) and weights of integrals whose integrand falls to zero like a root at both ends."""
    angle = pi * np.arange(1, points + 1) / (points + 1)
    return np.cos(angle), pi / (points + 1) * np.sin(angle)


@lru_cache
def _graded(points: int) -> tuple[NDArray, NDArray]:
    """Gauss points on (0, 1) and weights, crowded at zero by t = s^2, for a logarithm there."""
    s, weight = leggauss(points)
    s, weight = (s + 1) / 2, weight / 2
    return s**2, 2 * s * weight


def _panels(slip: NDArray, ellipse: Ellipse, points: EllipsePoints) -> tuple[NDArray, NDArray]:
    """Points (..., n) and weights [m] of four panels that fan out from where the slip along is least."""
    place, weight = _graded(points.across)
    half = ellipse.width[..., None]
    middle = np.stack(no_slip_positions(slip, ellipse.radius), -1)
    middle = np.minimum(np.maximum(middle, -half), half)
    near = np.maximum(_turning_width(slip, ellipse, middle), points.narrowest * half)
    near, between = np.minimum(near, half), middle.mean(-1)
    lower, upper = middle[..., 0], middle[..., 1]
    lengths = [lower + half[..., 0], between - lower, upper - between, half[..., 0] - upper]
    near, start = np.repeat(near, 2, -1), np.repeat(middle, 2, -1)
    reach = np.arcsinh(np.stack(lengths, -1) / near)
    ahead = np.exp(reach[..., None] * place)
    x = start[..., None] + (_FAN * near / 2)[..., None] * (ahead - 1 / ahead)
    width = (near * reach / 2)[..., None] * (ahead + 1 / ahead) * weight
    shape = (*slip.shape[:-1], 4 * points.across)
    return x.reshape(shape), width.reshape(shape)


def _turning_width(slip: NDArray, ellipse: Ellipse, x: NDArray) -> NDArray:
    """Length (..., 2) over which the direction of the slip turns next to x [m]."""
    roll, spin = slip[..., ROLL, None], slip[..., SPIN, None]
    radius, width = ellipse.radius[..., None], ellipse.width[..., None]
    along, middle, turn = _slip_of_strips(slip, strip_slip(x, radius, ellipse.spin))
    half = ellipse.along[..., None] * np.sqrt(np.maximum(1 - (x / width) ** 2, 0.0))
    size = np.hypot(along, np.abs(middle) + np.abs(turn) * half)
    slope, bend = np.abs(spin - roll * x / np.sqrt(radius**2 - x**2)), np.abs(roll) / radius
    return 2 * size / np.maximum(slope + np.sqrt(slope**2 + 2 * bend * size), SMALLEST)


def _slip_of_strips(slip: NDArray, by_slip: NDArray) -> NDArray:
    """Slip (3, ..., n) of strips by that of the contacts (..., 5), see `strip_slip`."""
    return np.moveaxis((slip[..., None, None, :] @ by_slip)[..., 0, :], -2, 0)
