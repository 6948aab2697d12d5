"""Rings pressed, heated, spun: the clearance they leave."""

from quasidynamic.clearance.annulus import Annulus
from quasidynamic.clearance.operating_clearance import (
    ClearanceStep,
    Mounting,
    OperatingClearance,
    OperatingConditions,
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
    "Seat",
    "operating_clearance",
    "seat",
]
