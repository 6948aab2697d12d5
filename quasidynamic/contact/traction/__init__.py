"""Shear of the lubricant in a line contact and in its inlet: traction laws, rheology, inlet shear.

The film thickness is an input; a new traction law is one module here and one name in the case.
"""

from quasidynamic.contact.traction.adore import ADORE_OILS, AdoreType
from quasidynamic.contact.traction.inlet_shear import ROLLING_LAWS, RollingShear, biboulet_houpert
from quasidynamic.contact.traction.measured_curve import FourPointCurve
from quasidynamic.contact.traction.mixed import (
    FILM_SHARE_1_8,
    ZHOU_HOEPRICH,
    AsperityShare,
    ErrorFunctionShare,
    Mixed,
    StretchedExponential,
)
from quasidynamic.contact.traction.rheology import BairWiner, Eyring
from quasidynamic.contact.traction.traction_law import Regression4109, Traction, TractionLaw

__all__ = [
    "ADORE_OILS",
    "FILM_SHARE_1_8",
    "ROLLING_LAWS",
    "ZHOU_HOEPRICH",
    "AdoreType",
    "AsperityShare",
    "BairWiner",
    "ErrorFunctionShare",
    "Eyring",
    "FourPointCurve",
    "Mixed",
    "Regression4109",
    "RollingShear",
    "StretchedExponential",
    "Traction",
    "TractionLaw",
    "biboulet_houpert",
]
