"""Normal contact beyond Hertz: the pressure on true profiles with their ends, on a grid.

The elastic half-spaces are those of `half_space`; friction and motion belong elsewhere.
"""

from quasidynamic.contact.pressure.groove import Approach, BallInGroove, GroovePress, PressedGroove
from quasidynamic.contact.pressure.normal_contact import (
    NormalCompliance,
    NormalContact,
    RigidMotions,
    contact_pressure,
)
from quasidynamic.contact.pressure.roller import CELLS, RollerOnRaceway, RollerPressure

__all__ = [
    "CELLS",
    "Approach",
    "BallInGroove",
    "GroovePress",
    "NormalCompliance",
    "NormalContact",
    "PressedGroove",
    "RigidMotions",
    "RollerOnRaceway",
    "RollerPressure",
    "contact_pressure",
]
