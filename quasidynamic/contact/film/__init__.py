"""Thickness of lubricant films, of line and elliptic contacts: flooded, starved, warmed, over roughness.

What the film does to the sliding surfaces is traction and stands next door.
"""

from quasidynamic.contact.film.elliptic import ELLIPTIC_FORMULAS, EllipticFormula
from quasidynamic.contact.film.roughness import composite_roughness, lambda_ratio, regime
from quasidynamic.contact.film.thickness import FORMULAS, Film, FilmFormula, FilmLaw, starved_film

__all__ = [
    "ELLIPTIC_FORMULAS",
    "FORMULAS",
    "EllipticFormula",
    "Film",
    "FilmFormula",
    "FilmLaw",
    "composite_roughness",
    "lambda_ratio",
    "regime",
    "starved_film",
]
