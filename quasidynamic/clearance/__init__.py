"""Rings pressed, heated, spun: the clearance they leave."""

from quasidynamic.clearance.annulus import Annulus
from quasidynamic.clearance.operating_clearance import (
    Mounting,
    OperatingClearance,
    RunningState,
    Step,
    operating_clearance,
)
from quasidynamic.clearance.press_fit import FitState, PressFit, Seat, seat

__all__ = [
    "Annulus",
    "FitState",
    "Mounting",
    "OperatingClearance",
    "PressFit",
    "RunningState",
    "Seat",
    "Step",
    "operating_clearance",
    "seat",
]
