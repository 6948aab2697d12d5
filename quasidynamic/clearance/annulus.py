"""Radial displacement of a round elastic body."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, OutOfRange, require_positive

Numbers = float | NDArray


@dataclass(frozen=True, kw_only=True)
class Annulus:
    """A ring, a hollow shaft, or a solid one."""

    inner_radius: float  # [m] zero is a solid body
    outer_radius: float  # [m]
    youngs_modulus: float  # [Pa]
    poisson_ratio: float  # [-] from 0 to below 0.5
    density: float  # [kg/m3]
    expansion: float  # [1/K] linear, mean from the reference to the operating temperature

    def __post_init__(self):
        for name in ("outer_radius", "youngs_modulus", "density"):
            require_positive(f"annulus.{name}", getattr(self, name))
        if not 0.0 <= self.inner_radius < self.outer_radius:
            raise ImpossiblePart(
                f"annulus.inner_radius = {self.inner_radius} not in [0, {self.outer_radius}) m; 0 is solid"
            )
        if not 0.0 <= self.poisson_ratio < 0.5:
            raise ImpossiblePart(f"annulus.poisson_ratio = {self.poisson_ratio} must be in [0, 0.5)")
        if not 0.0 <= self.expansion < 1e-3:
            raise ImpossiblePart(
                f"annulus.expansion = {self.expansion} 1/K must be in [0, 1e-3); steel has about 12e-6"
            )


def pressure_displacement(body: Annulus, radius: Numbers, inside: Numbers, outside: Numbers) -> Numbers:
    r"""Radial displacement of a thick ring under pressure.

    .. math::
        u = \frac{(1-\nu)(p_a a^2 - p_b b^2) r + (1+\nu)(p_a - p_b) a^2 b^2 / r}{E (b^2 - a^2)}

    Parameters
    ----------
    body : Annulus
        a inner, b outer radius [m]; E [Pa]; nu [-]
    radius : array (...)
        r [m], from a to b
    inside, outside : array (...)
        p_a in the bore, p_b on the outside [Pa], positive presses; a solid body has no bore

    Returns
    -------
    array (...)
        u [m], positive outwards

    Source
    ------
    Timoshenko and Goodier, Theory of Elasticity (1970), art. 28 (Lame), plane stress.

    Valid
    -----
    Linear elastic; free to move axially; pressure uniform around and along the ring.

    >>> steel = Annulus(inner_radius=29.8e-3, outer_radius=32.5e-3, youngs_modulus=203e9,
    ...                 poisson_ratio=0.28, density=7850.0, expansion=11.2e-6)
    >>> round(float(pressure_displacement(steel, 29.8e-3, 100e6, 0.0)) * 1e6, 4)
    173.7899
    """
    a, b, nu = body.inner_radius, body.outer_radius, body.poisson_ratio
    even = (1 - nu) * (inside * a**2 - outside * b**2) * radius
    hole = (1 + nu) * (inside - outside) * _hole_term(body, radius)
    return (even + hole) / (body.youngs_modulus * (b**2 - a**2))


def rotation_displacement(body: Annulus, radius: Numbers, speed: Numbers) -> Numbers:
    r"""Centrifugal expansion of a turning disc, with a hole or without.

    .. math::
        u = \frac{\rho \omega^2}{8 E} \left[ (3+\nu)(1-\nu)(a^2+b^2) r
            + (3+\nu)(1+\nu) \frac{a^2 b^2}{r} - (1-\nu^2) r^3 \right]

    Parameters
    ----------
    body : Annulus
        a inner, b outer radius [m]; E [Pa]; nu [-]; rho [kg/m3]
    radius : array (...)
        r [m], from a to b
    speed : array (...)
        omega [rad/s], either sense

    Returns
    -------
    array (...)
        u [m], positive outwards

    Source
    ------
    Timoshenko and Goodier, Theory of Elasticity (1970), art. 32, plane stress.

    Valid
    -----
    Linear elastic; steady speed; flat, axially short against the diameter; free on both rims.
    """
    a, b, nu = body.inner_radius, body.outer_radius, body.poisson_ratio
    even = (3 + nu) * (1 - nu) * (a**2 + b**2) * radius - (1 - nu**2) * radius**3
    hole = (3 + nu) * (1 + nu) * _hole_term(body, radius)
    return body.density * speed**2 / (8 * body.youngs_modulus) * (even + hole)


def heat_displacement(body: Annulus, radius: Numbers, rise: Numbers) -> Numbers:
    r"""Radial displacement of an evenly heated, free body.

    .. math:: u = \alpha \, \Delta T \, r

    Parameters
    ----------
    body : Annulus
        alpha, linear expansion [1/K]
    radius : array (...)
        r [m], from the inner to the outer radius
    rise : array (...)
        Delta T over the reference temperature [K], negative is cooling

    Returns
    -------
    array (...)
        u [m], positive outwards

    Source
    ------
    Timoshenko and Goodier, Theory of Elasticity (1970), ch. 13: an even temperature leaves no stress.

    Valid
    -----
    One temperature per body; alpha is the mean over the temperature range.
    """
    _require_within(body, radius)
    return body.expansion * rise * radius


def _hole_term(body: Annulus, radius: Numbers) -> Numbers:
    """a^2 b^2 / r [m3]; nothing in a solid body, its centre included."""
    _require_within(body, radius)
    if body.inner_radius == 0.0:
        return 0.0
    return (body.inner_radius * body.outer_radius) ** 2 / radius


def _require_within(body: Annulus, radius: Numbers) -> None:
    if not np.all((body.inner_radius <= radius) & (radius <= body.outer_radius)):
        raise OutOfRange(
            f"radius {radius} m lies outside the body, which reaches from {body.inner_radius} "
            f"to {body.outer_radius} m"
        )
