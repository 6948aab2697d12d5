"""How many tapered rollers of what size a bearing has: no catalogue says, but its static rating bounds them.

Makers fill the pitch circle, so that Z D is known: C_0 of ISO 76, with Z l D, gives the length. C of ISO 281
holds the diameter to a third of a power, less than makers' ratings differ from the standard's.
"""

from functools import partial
from math import cos
from typing import Any

import quasidynamic as qd
from flexbearing.case import BadCase
from flexbearing.catalogue.element_set import Ratings
from flexbearing.catalogue.page import Page
from flexbearing.catalogue.roller_set import RollerSet, fitting
from flexbearing.runs.roller_counts import TAPERED_SPACING
from quasidynamic.outcome.tapered_life import InclinedRow

# Rules of thumb, assumed.
DIAMETER = 0.48  # of a roller at its middle, over (D - d)/2
SHARE = (0.5, 0.8)  # roller length over the width of the inner ring


def tapered_set(page: Page) -> RollerSet:
    """Tapered rollers of a page.

    Raises `BadCase` where they do not fit in, or none that is plausible has the static rating.
    """
    bore, outside = page["bore"].si, page["outside"].si
    half, pitch = (outside - bore) / 2, (outside + bore) / 2
    if "pitch_diameter" in page:
        pitch = page["pitch_diameter"].si
        if not bore < pitch < outside:
            raise BadCase(f"{page.option('pitch_diameter')}: it must be between bore and outside diameter.")
    diameter = page["diameter"].si if "diameter" in page else DIAMETER * half
    return fitting(
        page, pitch, diameter, partial(_ratings, pitch, page["angle"].si, diameter), TAPERED_SPACING, SHARE
    )


def _ratings(pitch: float, angle: float, diameter: float, rollers: int, length: float) -> Ratings:
    steel: Any = qd.Material(youngs_modulus=2.1e11, poisson_ratio=0.3, density=7810.0)
    roller = qd.Roller(diameter=diameter, length=length * cos(angle), material=steel, profile=qd.Straight())
    row = InclinedRow(rollers, roller, pitch, angle)
    return Ratings(row.dynamic_rating, row.static_rating, row.fatigue_load_limit(row.static_rating))
