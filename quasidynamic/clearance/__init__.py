"""From the cold clearance to that in operation: fits, temperatures and speeds of round bodies.

Plane stress in closed form; fits that vary around or along the ring are finite elements.
"""

from quasidynamic.clearance.annulus import Annulus
from quasidynamic.clearance.operating_clearance import (
    ClearanceStep,
    Mounting,
    OperatingClearance,
    OperatingConditions,
    RacewayExpansion,
    operating_clearance,
)
from quasidynamic.clearance.press_fit import FitConditions, PressFit, Seat, seat

__all__ = [
    "Annulus",
    "ClearanceStep",
    "FitConditions",
    "Mounting",
    "OperatingClearance",
    "OperatingConditions",
    "PressFit",
    "RacewayExpansion",
    "Seat",
    "operating_clearance",
    "seat",
]
