"""Full sliding friction in a contact ellipse that slips in any direction."""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse, no_slip_positions, sagitta

CENTRE, ROLL, SPIN, ACROSS, PIVOT = range(5)  # components of the slip of a contact
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


class _Strips(NamedTuple):
    """Strips (..., n) of ellipses along the rolling direction, with points (..., n, m) on them."""

    basis: NDArray  # (..., 3, n) 1, sagitta [m] and place x [m]
    half: NDArray  # [m] half of the length
    along: NDArray  # [m/s] slip
    whole: NDArray  # [N s/m] friction over slip
    sideward: NDArray  # [N] friction across
    place: NDArray  # of the points, over the half length
    across: NDArray  # [m/s] slip of the points
    square: NDArray  # [m2/s2] of the whole slip of the points
    share: NDArray  # [N s/m] friction over slip of the points


class _Bends(NamedTuple):
    """Second derivatives (..., n) of the heat of strips by v_t, v_1 and v_1 over the place t on the strip."""

    along: NDArray
    along_across: NDArray
    along_turn: NDArray
    across: NDArray
    across_turn: NDArray
    turn: NDArray


@dataclass(frozen=True)
class GeneralSliding:
    """Friction of sliding contacts; the first derivative of the heat is minus the force on the ball."""

    slip: NDArray  # (..., 5)
    by_slip: NDArray  # (..., 5) [N, N m, N m, N, N m] derivative of the heat by the slip
    ellipse: Ellipse
    points: EllipsePoints
    strips: _Strips

    @property
    def power(self) -> NDArray:
        """Heat (...) [W]."""
        return (self.slip * self.by_slip).sum(-1)

    @cached_property
    def curvature(self) -> NDArray:
        """Second derivatives of the heat by the slip (..., 5, 5)."""
        (basis, half), bends = self.strips[:2], self._bends
        ones, rise, x = (basis[..., i, :] for i in range(3))
        turned, leaned = half * bends.along_turn, half * bends.across_turn
        right = [weight * bends.along for weight in (ones, rise, x)]
        right += [bends.along_across, rise * bends.along_across, bends.across, rise * bends.across]
        matrix = np.empty((*self.slip.shape, 5))
        sums = basis @ np.stack([*right, turned, leaned], -1)  # (..., 3, 9)
        matrix[..., :3, :3], matrix[..., :3, 3:], matrix[..., 3:, 3:] = (
            sums[..., :3],
            sums[..., 3:5],
            sums[..., :2, 5:7],
        )
        matrix[..., :3, SPIN] -= sums[..., 7]
        matrix[..., SPIN, :2] -= sums[..., :2, 7]
        matrix[..., SPIN, SPIN] += (half**2 * bends.turn).sum(-1) - sums[..., 2, 7]
        matrix[..., SPIN, 3:] -= sums[..., :2, 8]
        matrix[..., 3:, :3] = np.swapaxes(matrix[..., :3, 3:], -1, -2)
        return matrix

    @property
    def majorant(self) -> NDArray:
        """Curvatures (..., 5) of a parabola without mixed terms that touches the heat and lies above it."""
        (basis, half), whole = self.strips[:2], self.strips.whole
        squares = (basis**2 @ whole[..., None])[..., 0]
        spin = squares[..., 2] + (half**2 * whole).sum(-1)
        flat, steep = squares[..., 0], squares[..., 1]
        return np.stack([3 * flat, 3 * steep, 3 * spin, 2 * flat, 2 * steep], -1)

    @property
    def by_load(self) -> NDArray:
        r"""Derivative (..., 5) of `by_slip` by the logarithm of the load, the slip given.

        Friction grows with the load, the semi-axes with its cube root.
        """
        strips, bends = self.strips, self._bends
        x = strips.basis[..., 2, :]
        steep = -(x**2) / np.sqrt(self.ellipse.radius[..., None] ** 2 - x**2)  # x sigma'
        roll, spin, pivot = (self.slip[..., i, None] for i in (ROLL, SPIN, PIVOT))
        along, across, turn = roll * steep + spin * x, pivot * steep, -spin * strips.half
        forward = bends.along * along + bends.along_across * across + bends.along_turn * turn
        sideward = bends.along_across * along + bends.across * across + bends.across_turn * turn
        turning = bends.along_turn * along + bends.across_turn * across + bends.turn * turn
        sums = strips.basis @ np.stack([forward, sideward], -1)
        grown = np.concatenate([sums[..., 0], sums[..., :2, 1]], -1)
        grown[..., SPIN] += self.by_slip[..., SPIN] - (strips.half * turning).sum(-1)
        grown[..., ROLL] += (strips.along * strips.whole * steep).sum(-1)
        grown[..., PIVOT] += (strips.sideward * steep).sum(-1)
        return grown / 3 + self.by_slip

    @cached_property
    def _bends(self) -> _Bends:
        """Second derivatives of the heat of strips.

        Where the slip across nearly vanishes the heat has a kink along a line, which would fall between the
        points: the derivative by v_t is taken at a slip across that the points still resolve.
        """
        strips = self.strips
        cubed, along = strips.share / strips.square, strips.along
        turned, leaned = cubed * strips.across, cubed * strips.place
        bends = _Bends(
            along=np.einsum("...m,...m", turned, strips.across),
            along_across=-along * turned.sum(-1),
            along_turn=-along * np.einsum("...m,...m", turned, strips.place),
            across=along**2 * cubed.sum(-1),
            across_turn=along**2 * leaned.sum(-1),
            turn=along**2 * np.einsum("...m,...m", leaned, strips.place),
        )
        least, narrow = self._narrow
        if narrow.any():
            shares, squares = strips.share[narrow], strips.square[narrow]
            lateral = least[narrow][..., None, None] + np.abs(strips.across[narrow])
            wider = along[narrow][..., None] ** 2 + lateral**2
            bends.along[narrow] = (shares * np.sqrt(squares) * lateral**2 / wider**1.5).sum(-1)
        return bends

    @property
    def _narrow(self) -> tuple[NDArray, NDArray]:
        """Least slip across that the points resolve, and the contacts with less (...)."""
        ellipse, (_, roll, spin, across, _) = self.ellipse, np.moveaxis(self.slip, -1, 0)
        least = 2 * self.points.narrowest * np.abs(roll) * ellipse.across**2 / (2 * ellipse.radius)
        return least, (np.abs(across) + np.abs(spin) * ellipse.along < least) & (ellipse.traction > 0.0)


def sliding_ellipse(slip: NDArray, ellipse: Ellipse, points: EllipsePoints = FINE) -> GeneralSliding:
    r"""Friction of full sliding under slip in both directions.

    .. math:: \Phi = \int \mu p\, |v|\, dA,\quad p = \frac{3 Q}{2 \pi a b} \sqrt{1 - x^2/a^2 - y^2/b^2},\\
              v_t = e + A\,\sigma(x) + w x,\quad v_1 = c + B\,\sigma(x) - w y

    Parameters
    ----------
    slip : array (..., 5)
        of the ball against the race: e slip at the centre of the contact along the rolling direction [m/s],
        A roll and w spin [rad/s], c slip at the centre across the rolling direction [m/s], B turn about the
        rolling direction [rad/s]
    ellipse : Ellipse
        a, b, R and mu Q
    points : EllipsePoints
        panels between the lines v_t = 0, see `strip_points` for those of a strip

    Returns
    -------
    GeneralSliding
        homogeneous of degree one in the slip and convex

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12, for slip and traction, here with that of a ball that turns about the
    rolling direction; c = B = 0 is `sliding_friction`.

    Valid
    -----
    Coulomb friction of one coefficient per contact, sliding everywhere: no stick. Where the slip vanishes all
    over a contact the heat has a kink.
    """
    x, width = _panels(slip, ellipse, points)
    part = np.maximum(1.0 - (x / ellipse.width[..., None]) ** 2, 0.0)  # rounding alone makes it negative
    half = ellipse.along[..., None] * np.sqrt(part)
    rise = sagitta(x, ellipse.radius[..., None])
    centre, roll, spin, across, pivot = (slip[..., i, None] for i in range(5))
    along, middle = centre + roll * rise + spin * x, across + pivot * rise
    place, share = strip_points(along, middle, spin * half, points.along)
    lateral = middle[..., None] - (spin * half)[..., None] * place
    square = (along**2 + SMALLEST)[..., None] + lateral * lateral
    share /= np.sqrt(square)
    share *= (width * part * (1.5 / pi * ellipse.traction / ellipse.width)[..., None])[..., None]
    pushed = share * lateral
    whole, sideward, turning = share.sum(-1), pushed.sum(-1), np.einsum("...m,...m", pushed, place)
    basis = np.stack([np.ones_like(x), rise, x], -2)
    sums = basis @ np.stack([along * whole, sideward], -1)
    by_slip = np.concatenate([sums[..., 0], sums[..., :2, 1]], -1)
    by_slip[..., SPIN] -= (turning * half).sum(-1)
    strips = _Strips(basis, half, along, whole, sideward, place, lateral, square, share)
    return GeneralSliding(slip, by_slip, ellipse, points, strips)


def strip_points(along: NDArray, middle: NDArray, turn: NDArray, points: int) -> tuple[NDArray, NDArray]:
    r"""Points and weights of a strip for integrands of the slip.

    .. math:: \int_{-1}^{1} \sqrt{1 - t^2}\, g(t)\, dt,\qquad s t - k = |v| \sinh q

    by Gauss-Chebyshev quadrature of the second kind in q: g may be any smooth function of v, of k - s t and
    of the size of both, however close to zero it comes.

    Parameters
    ----------
    along, middle, turn : array (...)
        v, k and s [m/s]
    points : int
        how many, even

    Returns
    -------
    pair of arrays (..., points)
        t and weights [-]

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
    centre, roll, spin, across, pivot = (slip[..., i, None] for i in range(5))
    radius, width = ellipse.radius[..., None], ellipse.width[..., None]
    rise, tilt = sagitta(x, radius), -x / np.sqrt(radius**2 - x**2)
    half = ellipse.along[..., None] * np.sqrt(np.maximum(1 - (x / width) ** 2, 0.0))
    lateral = np.abs(across + pivot * rise) + np.abs(spin) * half
    size = np.sqrt((centre + roll * rise + spin * x) ** 2 + lateral**2)
    slope, bend = np.abs(spin + roll * tilt), np.abs(roll) / radius
    return 2 * size / np.maximum(slope + np.sqrt(slope**2 + 2 * bend * size), SMALLEST)
