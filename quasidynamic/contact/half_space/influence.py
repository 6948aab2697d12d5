"""Elastic half-spaces on a grid of cells: displacements at the cells by tractions that are even over one."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.material import Material

X, Y, Z = 0, 1, 2  # directions; z normal, into the body on which tractions are counted


@dataclass(frozen=True)
class CellGrid:
    """Rectangular cells of one size, symmetric about the origin."""

    spacing: tuple[float, float]  # [m] sides of a cell along x and y
    shape: tuple[int, int]  # cells along x and y

    def __post_init__(self):
        for side in self.spacing:
            require_positive("grid.spacing", side)
        if min(self.shape) < 1:
            raise ImpossiblePart(f"grid.shape = {self.shape} must be at least one cell in each direction")

    @property
    def cell_area(self) -> float:
        """Area of one cell [m2]."""
        return self.spacing[0] * self.spacing[1]

    @property
    def centres(self) -> tuple[NDArray, NDArray]:
        """Centres of the cells, x (nx, 1) and y (1, ny) [m]."""
        x, y = (
            side * (np.arange(cells) - (cells - 1) / 2)
            for side, cells in zip(self.spacing, self.shape, strict=True)
        )
        return x[:, None], y[None, :]


def grid_over(half_lengths: tuple[float, float], shape: tuple[int, int]) -> CellGrid:
    """Grid whose cells cover a rectangle of two half lengths [m] about the origin exactly."""
    spacing = (2 * half_lengths[0] / shape[0], 2 * half_lengths[1] / shape[1])
    return CellGrid(spacing, shape)


@dataclass(frozen=True)
class ElasticPair:
    r"""Constants of the relative displacement of two half-spaces under opposite tractions.

    .. math:: \frac{1}{G} = \frac12\left(\frac{1}{G_1} + \frac{1}{G_2}\right),\quad
              \frac{\nu}{G} = \frac12\left(\frac{\nu_1}{G_1} + \frac{\nu_2}{G_2}\right),\quad
              \frac{K}{G} = \frac14\left(\frac{1-2\nu_1}{G_1} - \frac{1-2\nu_2}{G_2}\right)

    Source
    ------
    Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), Eq. (1.44).
    """

    shear: float  # [1/Pa] 1/G
    poisson: float  # [1/Pa] nu/G
    coupling: float = 0.0  # [1/Pa] K/G between pressure and tangential displacement, zero for equal bodies

    def __post_init__(self):
        require_positive("elastic_pair.shear", self.shear)

    @property
    def plane_compliance(self) -> float:
        """1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [1/Pa]."""
        return self.shear - self.poisson


def elastic_pair(first: Material, second: Material) -> ElasticPair:
    r"""Constants [1/Pa] of two materials; tractions are counted on the first.

    .. math:: G = E / [2 (1 + \nu)]

    Source
    ------
    Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), sec. 1.6.
    """
    one, two = (2 * (1 + body.poisson_ratio) / body.youngs_modulus for body in (first, second))
    return ElasticPair(
        shear=(one + two) / 2,
        poisson=(first.poisson_ratio * one + second.poisson_ratio * two) / 2,
        coupling=((1 - 2 * first.poisson_ratio) * one - (1 - 2 * second.poisson_ratio) * two) / 4,
    )


def influence_number(
    pair: ElasticPair, displacement: int, traction: int, place: tuple[ArrayLike, ArrayLike], cell: ArrayLike
) -> NDArray:
    r"""Relative displacement of two half-spaces by an even traction of one on a rectangle.

    .. math:: \pi u_x &= \int \left[\frac{1-\nu}{G r} + \frac{\nu x^2}{G r^3}\right] p_x
                         + \frac{\nu x y}{G r^3}\, p_y - \frac{K x}{G r^2}\, p_z\, dA, \\
              \pi u_z &= \int \frac{K x}{G r^2}\, p_x + \frac{K y}{G r^2}\, p_y
                         + \frac{1-\nu}{G r}\, p_z\, dA

    and u_y as u_x, over the rectangle in closed form; (x, y) leads from there to the place, r is its length.

    Parameters
    ----------
    pair : ElasticPair
        1/G, nu/G and K/G [1/Pa]
    displacement : int
        direction `X`, `Y` or `Z` of u, of the first body against the second
    traction : int
        direction of p on the first body (on the second one acts -p); z points into the first body, so that
        a pressure counts positive
    place : pair of arrays (...)
        x and y from the centre of the rectangle [m]
    cell : array (2)
        sides of the rectangle along x and y [m]

    Returns
    -------
    array (...)
        u/p [m/Pa]

    Source
    ------
    Love, Phil. Trans. R. Soc. A 228 (1929), 377-420, for pressure; Johnson, Contact Mechanics (1985), Eqs
    (3.18), (3.19) and sec. 3.6, for the point forces of Boussinesq and Cerruti, integrated here.

    >>> steel = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
    >>> round(float(influence_number(steel, Z, Z, (0.0, 0.0), (1e-3, 1e-3))) * 80e9 * np.pi / 0.7e-3, 6)
    3.525494
    """
    (x, y), (width, length) = (np.asarray(value, dtype=float) for value in place), np.asarray(cell) / 2
    corner = _primitive(pair, displacement, traction)
    left, right, low, high = x - width, x + width, y - length, y + length
    return corner(right, high) - corner(right, low) - corner(left, high) + corner(left, low)


def influence_lattice(pair: ElasticPair, displacement: int, traction: int, x: NDArray, y: NDArray) -> NDArray:
    """Influence numbers [m/Pa] at places that are whole cells apart, where cells share their corners.

    They are (nx - 1, ny - 1), in the middle between neighbours of x (nx) and y (ny): places from the centre
    of the cell [m], half a cell to their left and right.

    Source
    ------
    Differences of the primitive of `influence_number`.
    """
    corners = _primitive(pair, displacement, traction)(x[:, None], y)
    return np.diff(np.diff(corners, axis=0), axis=1)


def _primitive(pair: ElasticPair, displacement: int, traction: int) -> Callable[[NDArray, NDArray], NDArray]:
    """Integral over a rectangle as a function of its corners."""
    by_radius, along = pair.plane_compliance / np.pi, pair.shear / np.pi
    if displacement == traction == Z:
        return lambda x, y: by_radius * (_reach(x, y) + _reach(y, x))
    if Z in (displacement, traction):
        direction, sign = (traction, 1.0) if displacement == Z else (displacement, -1.0)
        coupling = sign * pair.coupling / np.pi
        return lambda x, y: coupling * (_lateral(x, y) if direction == X else _lateral(y, x))
    if displacement != traction:
        return lambda x, y: -pair.poisson / np.pi * np.hypot(x, y)
    if displacement == X:
        return lambda x, y: along * _reach(x, y) + by_radius * _reach(y, x)
    return lambda x, y: by_radius * _reach(x, y) + along * _reach(y, x)


def _reach(x: NDArray, y: NDArray) -> NDArray:
    """Primitive y arsinh(x/|y|) of x^2/r^3; that of 1/r is the sum of both directions."""
    y = np.broadcast_arrays(x, y)[1]
    apart = y != 0.0
    return np.where(apart, y * np.arcsinh(x / np.where(apart, np.abs(y), 1.0)), 0.0)


def _lateral(x: NDArray, y: NDArray) -> NDArray:
    """Primitive of x/r^2, without the part y that cancels."""
    radius = np.hypot(x, y)
    apart = x != 0.0
    turned = np.where(apart, x * np.arctan(y / np.where(apart, x, 1.0)), 0.0)
    return y * np.log(np.where(radius > 0.0, radius, 1.0)) + turned
