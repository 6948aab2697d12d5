"""Rings pressed, heated, spun: the clearance they leave."""

from quasidynamic.fits.chain import Mounting, OperatingClearance, RunningState, Step, operating_clearance
from quasidynamic.fits.fit import FitState, PressFit, Seat, seat
from quasidynamic.fits.ring import Annulus

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
