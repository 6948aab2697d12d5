"""Thickness of the lubricant film in a line contact: flooded, starved, warmed in its inlet, over roughness.

What the film does to the sliding surfaces is traction and stands next door.
"""

from quasidynamic.contact.film.roughness import composite_roughness, lambda_ratio, regime
from quasidynamic.contact.film.thickness import FORMULAS, Film, FilmFormula, FilmLaw, starved_film

__all__ = [
    "FORMULAS",
    "Film",
    "FilmFormula",
    "FilmLaw",
    "composite_roughness",
    "lambda_ratio",
    "regime",
    "starved_film",
]
