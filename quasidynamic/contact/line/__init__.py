"""The dry line contact of a roller: Hertz pressure and width, load laws, slices along the roller.

No film and no friction; the profile of a roller is data and stands in `parts`.
"""

from quasidynamic.contact.line.hertz import SMALLEST_LOAD, half_width, peak_pressure, reduced_radius
from quasidynamic.contact.line.load_law import (
    EXPONENT,
    LoadLaw,
    gap_rounding,
    iso16281,
    palmgren,
    raceway_coefficients,
)
from quasidynamic.contact.line.slices import Slices

__all__ = [
    "EXPONENT",
    "SMALLEST_LOAD",
    "LoadLaw",
    "Slices",
    "gap_rounding",
    "half_width",
    "iso16281",
    "palmgren",
    "peak_pressure",
    "raceway_coefficients",
    "reduced_radius",
]
