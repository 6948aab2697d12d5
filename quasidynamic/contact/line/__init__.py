"""The dry line contact of a roller: Hertz pressure and width, load laws, slices, profiles for a design load.

No film and no friction; a profile itself is data, in `parts`.
"""

from quasidynamic.contact.line.design_profile import fujiwara_kawase, johns_gohar, lundberg
from quasidynamic.contact.line.load_law import (
    EXPONENT,
    SMALLEST_LOAD,
    LoadLaw,
    gap_rounding,
    half_width,
    iso16281,
    palmgren,
    peak_pressure,
    raceway_coefficients,
    reduced_radius,
)
from quasidynamic.contact.line.slices import Slices

__all__ = [
    "EXPONENT",
    "SMALLEST_LOAD",
    "LoadLaw",
    "Slices",
    "fujiwara_kawase",
    "gap_rounding",
    "half_width",
    "iso16281",
    "johns_gohar",
    "lundberg",
    "palmgren",
    "peak_pressure",
    "raceway_coefficients",
    "reduced_radius",
]
