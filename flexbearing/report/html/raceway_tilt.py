"""Slope between the raceways along the most loaded roller."""

from math import pi

import numpy as np

from flexbearing.report.html.document import Number
from flexbearing.report.html.reader import Reader

USUAL_TILT = 4 / 60 * pi / 180  # [rad] range of the edge stress of ISO/TS 16281


def between_raceways(reader: Reader) -> tuple[Number, float] | None:
    """Size of the slope of the inner raceway against the outer one along the most loaded roller, also in rad.

    Raceways of elastic rings lean with their supports: straight lines are fitted through their deviations.
    None where the bearing has no rollers.
    """
    block = reader.blocks.get(reader.last, {})
    if "inner_load" not in block or "ring_tilt" not in block:
        return None
    roller = int(np.argmax(block["inner_load"]))
    azimuth, along = float(block["roller_azimuth"][roller]), np.asarray(block["slice_position"])
    slope = float(np.dot(block["ring_tilt"], (np.cos(azimuth), np.sin(azimuth))))
    for name, sign in (("inner_deviation", 1.0), ("outer_deviation", -1.0)):
        slope += sign * float(np.polyfit(along, block[name][roller], 1)[0])
    size = abs(slope)
    return reader.units.number(size, "rad", "mrad", ".3g", f"raceway_tilt/{reader.last}"), size
