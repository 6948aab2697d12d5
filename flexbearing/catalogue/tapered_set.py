"""How many tapered rollers or barrels of what size a bearing has: C_0 of a catalogue bounds them.

Makers fill the pitch circle, so that Z D is known: C_0 of ISO 76, with Z l D, gives the length. C of ISO 281
holds the diameter to a third of a power, less than makers' ratings differ from the standard's.
"""

from functools import partial
from math import pi
from typing import Any

import quasidynamic as qd
from flexbearing.case import BadCase
from flexbearing.catalogue.element_set import Ratings
from flexbearing.catalogue.page import Page
from flexbearing.catalogue.roller_set import RollerSet, fitting
from flexbearing.runs.roller_counts import SPACING, TAPERED_SPACING
from quasidynamic.outcome.capacity import fatigue_load_limit
from quasidynamic.outcome.tapered_life import InclinedRow, SphericalRow
from quasidynamic.outcome.thrust_roller_capacity import ThrustRow

SHARE = (0.5, 0.8)  # length of the rollers over the room for it; rule of thumb, assumed


# Diameter of a roller over (D - d)/2, and over B, by series 320 and 811; of barrels over (D - d)/2; assumed.
CONES, WASHERS, BARRELS = 0.48, 0.43, 0.55


def tapered_set(page: Page) -> RollerSet:
    """Tapered rollers of a page, or those between washers where it has no contact angle.

    Raises `BadCase` where they do not fit in, or none that is plausible has the static rating.
    """
    bore, outside = page["bore"].si, page["outside"].si
    half, pitch = (outside - bore) / 2, (outside + bore) / 2
    if "pitch_diameter" in page:
        pitch = page["pitch_diameter"].si
        if not bore < pitch < outside:
            raise BadCase(f"{page.option('pitch_diameter')}: it must be between bore and outside diameter.")
    angle, width, spacing = pi / 2, page["width"].si, SPACING
    diameter, room = WASHERS * width, half
    if "angle" in page:
        angle, spacing, diameter, room = page["angle"].si, TAPERED_SPACING, CONES * half, width
    rows = 2 if page.like == "spherical_roller" else 1
    if rows > 1:
        diameter, room = BARRELS * half, width / 2
    diameter = page["diameter"].si if "diameter" in page else diameter
    rated = partial(_ratings, pitch, angle, diameter, rows)
    return fitting(page, pitch, diameter, rated, spacing, SHARE, room)


def _ratings(pitch: float, angle: float, diameter: float, rows: int, rollers: int, length: float) -> Ratings:
    steel: Any = qd.Material(youngs_modulus=2.1e11, poisson_ratio=0.3, density=7810.0)
    kind = ThrustRow if angle == pi / 2 else SphericalRow if rows > 1 else InclinedRow
    length *= kind.projection(angle)
    roller = qd.Roller(diameter=diameter, length=length, material=steel, profile=qd.Straight())
    row = kind(rollers, roller, pitch, angle, rows)
    return Ratings(row.dynamic_rating, row.static_rating, fatigue_load_limit(row, row.static_rating))
