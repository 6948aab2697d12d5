"""Normal contact beyond Hertz: the pressure on true profiles with their ends, on a grid.

The elastic half-spaces are those of `half_space`; friction and motion belong elsewhere. Rollers are imported
from `pressure.roller`, which balls need not load.
"""

from quasidynamic.contact.pressure.groove import Approach, BallInGroove, GroovePress, PressedGroove
from quasidynamic.contact.pressure.normal_contact import (
    NormalCompliance,
    NormalContact,
    RigidMotions,
    contact_pressure,
)

__all__ = [
    "Approach",
    "BallInGroove",
    "GroovePress",
    "NormalCompliance",
    "NormalContact",
    "PressedGroove",
    "RigidMotions",
    "contact_pressure",
]
