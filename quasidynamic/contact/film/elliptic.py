"""Thickness of the lubricant film in an elliptic contact: formulas of line contact by another name."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.film.thickness import Film, FilmFormula


@dataclass(frozen=True, kw_only=True)
class EllipticFormula:
    r"""A regression of film thickness in the groups of point contact.

    .. math:: h/R = c\, G^{g} U^{s} W^{-w} (1 - m\, e^{-n k}),\quad
              U = \eta_0 u/(E' R),\; G = \alpha E',\; W = Q/(E' R^2),\; k = a/b

    with R along the rolling direction. With a load per length Q/R its groups are those of line contact, and
    the last factor, which the oil that leaves sideways takes, is one of the geometry: see `of_axes`.

    Source
    ------
    Each formula names its own in `ELLIPTIC_FORMULAS`.

    Valid
    -----
    Flooded, isothermal, elastic and piezoviscous contacts, k from 1 to 8.
    """

    formula: FilmFormula  # c and the exponents
    leaking: float  # m
    narrowing: float  # n
    inlet: tuple[float, float]  # factor and exponent of the inlet length that floods the contact
    starved: float  # exponent of the film in a shorter inlet

    def of_axes(self, ratio: NDArray | float) -> FilmFormula:
        """Formula of contacts of a ratio k = a/b of their semi-axes [-], across over along the rolling."""
        f = self.formula
        factor = f.factor * (1.0 - self.leaking * np.exp(-self.narrowing * np.asarray(ratio)))
        return FilmFormula(source=f.source, factor=factor, material=f.material, speed=f.speed, load=f.load)

    def starved_film(self, flooded: Film, half_width: NDArray, radius: NDArray, inlet_length: float) -> Film:
        r"""Film of a contact whose inlet is filled up to a meniscus.

        .. math:: \frac{h_s}{h} = \left(\frac{c_s}{c^*}\right)^{s} \le 1,\quad
                  c^* = f \left(\frac{h R}{b^2}\right)^{e}

        Parameters
        ----------
        flooded : Film of array (...)
            h [m] > 0 and its derivatives
        half_width, radius : array (...)
            b, semi-axis along the rolling direction, and R along it [m], > 0
        inlet_length : float
            c_s, distance of the meniscus before the edge of the contact over b [-], > 0

        Returns
        -------
        Film of array (...)
            h_s [m] and its derivatives; that by load not, as b changes with it

        Source
        ------
        Hamrock and Dowson, J. Lubrication Technology 99 (1977), 15-23, part IV, as coded in a public program;
        the exponent 0.56 of the minimum is recalled.

        Valid
        -----
        A kink where the inlet just floods the contact.
        """
        factor, exponent = self.inlet
        full = factor * (flooded.thickness * radius / half_width**2) ** exponent
        starves = inlet_length < full
        share = np.where(starves, (inlet_length / full) ** self.starved, 1.0)
        slope = share * np.where(starves, 1.0 - exponent * self.starved, 1.0)
        return Film(share * flooded.thickness, *(slope * each for each in flooded[1:]))


ELLIPTIC_FORMULAS = {
    "hamrock_dowson": EllipticFormula(
        formula=FilmFormula(
            source="central; Hamrock and Dowson (1977)", factor=2.69, material=0.53, speed=0.67, load=0.067
        ),
        leaking=0.61,
        narrowing=0.73,
        inlet=(3.06, 0.58),
        starved=0.29,
    ),
    "hamrock_dowson_minimum": EllipticFormula(
        formula=FilmFormula(
            source="minimum; Hamrock and Dowson (1977)", factor=3.63, material=0.49, speed=0.68, load=0.073
        ),
        leaking=1.0,
        narrowing=0.68,
        inlet=(3.34, 0.56),
        starved=0.25,
    ),
}
