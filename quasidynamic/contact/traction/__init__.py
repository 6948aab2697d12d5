"""Shear of the lubricant in a line contact and in its inlet: traction laws, rheology, inlet shear.

The film thickness is an input; a new traction law is one module here and one name in the case. What every
law has is exported; a law itself is imported from its module, by who chooses it.
"""

from quasidynamic.contact.traction.inlet_shear import (
    BALL_ROLLING_LAWS,
    ROLLING_LAWS,
    RollingShear,
    biboulet_houpert,
    ellipse_shear,
)
from quasidynamic.contact.traction.traction_law import Regression4109, Traction, TractionLaw, in_any_contact

__all__ = [
    "BALL_ROLLING_LAWS",
    "ROLLING_LAWS",
    "Regression4109",
    "RollingShear",
    "Traction",
    "TractionLaw",
    "biboulet_houpert",
    "ellipse_shear",
    "in_any_contact",
]
