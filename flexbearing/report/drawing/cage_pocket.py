"""A roller in its pocket, and the land of the cage, with clearances that can be seen."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.along_axis import place
from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import AXES, CAGE, ELEMENT, INNER, OUTER, Words

POCKET, LAND = 0.09, 0.09  # clearances as drawn, over the roller's diameter
WALL, SEEN = 0.4, 0.85  # of rings over the roller's diameter; pitches to either side
GUIDING = "#a61c00"


def cage(words: Words) -> Drawing:
    """Draw a roller between its raceways and the walls of its pocket, seen along the axis."""
    sheet, bearing = Sheet("cage", words, to_scale=False), words.case.bearing
    outer, size = bearing.outer_raceway_diameter / 2, bearing.roller.diameter
    pitch, half = outer - size / 2, SEEN * 2 * np.pi / bearing.rollers
    inner = outer - size
    sheet.area(_band(outer, outer + WALL * size, half), "outer-ring", fc=OUTER)
    sheet.area(_band(inner - WALL * size, inner, half), "inner-ring", fc=INNER)
    low, high = _levels(bearing, pitch)
    _land(sheet, bearing, half, (inner, outer))
    _bars(sheet, bearing, (low, high))
    sheet.circle(size / 2, place(pitch, 0.0), "roller", points=181, fc=ELEMENT)
    sheet.line([place(inner - 0.2 * size, 0.0), place(outer + 0.2 * size, 0.0)], ec="0.4", lw=0.4,
               ls=(0, (8, 2, 1, 2)))  # fmt: skip
    _azimuth(sheet, outer + 0.72 * WALL * size, half, size)
    _label(sheet, bearing, (low, high))
    sheet.notes.extend(
        (
            "Seen along +x, at azimuth 0. Clearances are magnified.",
            "Pocket clearance: from a centred roller to either wall.",
            "A roller that runs ahead touches the wall at growing azimuth.",
        )
    )
    if bearing.cage.guidance != "rollers":
        sheet.notes.append(
            "Red: guiding land, beside the rollers. land_clearance is diametral: the gap is half of it."
        )
    return sheet.drawn(
        f"A roller in its pocket, not to scale: clearances magnified; cage guided by {_guide(bearing)}.",
        f"Roller, pocket walls and raceways beside a cage guided by {_guide(bearing)}; not to scale.",
    )


def _guide(bearing: Any) -> str:
    return (
        "the rollers" if bearing.cage.guidance == "rollers" else f"a land of the {bearing.cage.guidance} ring"
    )


def _levels(bearing: Any, pitch: float) -> tuple[float, float]:
    """Inside and outside radius of the cage, its clearance at the land as drawn [m]."""
    cage, gap = bearing.cage, LAND * bearing.roller.diameter
    if cage.guidance == "outer":
        high = cage.land_diameter / 2 - gap
        return high - cage.thickness, high
    if cage.guidance == "inner":
        low = cage.land_diameter / 2 + gap
        return low, low + cage.thickness
    return pitch - cage.thickness / 2, pitch + cage.thickness / 2


def _land(sheet: Sheet, bearing: Any, half: float, raceways: tuple[float, float]) -> None:
    """Land of the ring that guides, with the rib it belongs to."""
    cage, (inner, outer) = bearing.cage, raceways
    if cage.guidance == "rollers":
        return
    land = cage.land_diameter / 2
    rib = (land, outer) if cage.guidance == "outer" else (inner, land)
    colour = OUTER if cage.guidance == "outer" else INNER
    sheet.area(_band(rib[0], rib[1], half), "rib", fc=colour, lw=0, alpha=0.5)
    arc = np.array([place(land, angle) for angle in np.linspace(-half, half, 61)])
    sheet.line(arc, "guiding-land", ec=GUIDING, lw=1.4)


def _bars(sheet: Sheet, bearing: Any, levels: tuple[float, float]) -> None:
    """Bars of the cage on both sides of the roller, their walls parallel to its radius."""
    wall, half = _wall(bearing), np.pi / bearing.rollers
    low, high = max(levels[0], wall / np.sin(half)), levels[1]
    if low >= high:
        return
    radii = np.linspace(low, high, 15)
    begin = np.arcsin(wall / radii)
    first = [place(r, a) for r, a in zip(radii, begin, strict=True)]
    second = [place(r, 2 * half - a) for r, a in zip(radii, begin, strict=True)]
    arcs = [
        [place(r, a) for a in np.linspace(b, 2 * half - b, 21)]
        for r, b in ((low, begin[0]), (high, begin[-1]))
    ]
    right = np.array([*first, *arcs[1], *second[::-1], *arcs[0][::-1]])
    for side, name in ((1, "ahead"), (-1, "behind")):
        sheet.area(right * [side, 1], f"bar-{name}", fc=CAGE)


def _wall(bearing: Any) -> float:
    """Distance of a pocket's wall from the middle of the roller, as drawn [m]."""
    return (0.5 + POCKET) * bearing.roller.diameter


def _azimuth(sheet: Sheet, radius: float, half: float, size: float) -> None:
    """Sense of growing azimuth."""
    arc = [place(radius, angle) for angle in np.linspace(-0.75 * half, 0.0, 21)]
    sheet.line(arc, ec=AXES, lw=0.8)
    sheet.line([arc[-1], place(radius, 0.06 * half)], ec=AXES, arrowstyle="->", lw=0.8)
    sheet.word("growing azimuth φ", place(radius - 0.1 * size, -0.36 * half), color=AXES, bbox=None)


def _label(sheet: Sheet, bearing: Any, levels: tuple[float, float]) -> None:
    """Keys of the cage."""
    size, wall = bearing.roller.diameter, _wall(bearing)
    low, high = levels
    middle, pitch = 0.5 * (low + high), (bearing.outer_raceway_diameter - size) / 2
    sheet.length("bearing.cage.pocket_clearance", size / 2, wall, -pitch)
    bar = np.pi / bearing.rollers
    for name in ("thickness", "guidance", "centre", "mass"):
        sheet.label(f"bearing.cage.{name}", place(middle, bar))
    sheet.label("bearing.cage.pocket_friction", (wall, -pitch))
    sheet.label(
        "bearing.roller.diameter",
        place(pitch + 0.5 * size * np.cos(2.4), -0.5 * size * np.sin(2.4) / pitch),
        "Ø ",
    )
    land = bearing.cage.land_diameter
    if land is None:
        return
    edge = high if bearing.cage.guidance == "outer" else low
    sheet.label("bearing.cage.land_diameter", place(land / 2, 1.4 * bar), "Ø ")
    sheet.label("bearing.cage.land_clearance", place(0.5 * (land / 2 + edge), 1.15 * bar), "diametral ")
    sheet.label("bearing.cage.land_flow", place(0.5 * (land / 2 + edge), 1.15 * bar))


def _band(inside: float, outside: float, half: float) -> NDArray:
    """Outline of a part of a ring about azimuth 0 [m]."""
    angles = np.linspace(-half, half, 61)
    return np.array(
        [*(place(outside, angle) for angle in angles), *(place(inside, angle) for angle in angles[::-1])]
    )
