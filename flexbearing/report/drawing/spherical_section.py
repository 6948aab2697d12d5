"""Axial half section of a spherical roller bearing; rings schematic, but for the raceways."""

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import ELEMENT, INNER, LOAD, OUTER, SCHEMATIC, Words

WALL, BEYOND = (
    0.35,
    1.1,
)  # least thickness of the rings over the rollers' diameter, outer raceway over rollers


def section(words: Words) -> Drawing:
    """Draw the upper half of the section through both rows."""
    sheet, bearing = Sheet("section", words, cross=True), words.case.bearing
    angle, radius, half = bearing.contact_angle, bearing.roller.diameter / 2, bearing.roller.length / 2
    barrel, sphere, groove = bearing.profile_radius, *map(bearing.raceway_profile_radius, ("outer", "inner"))
    places, wall = half * np.linspace(-1.0, 1.0, 41), WALL * bearing.roller.diameter

    def along(side: int, outwards: int, curve: float) -> NDArray:
        """Points of a row along its rollers, towards +x, on an arc that touches them in their middle."""
        normal = outwards * (radius - places**2 / (curve + np.sqrt(curve**2 - places**2)))
        rows = (side * sin(angle), cos(angle)), (cos(angle), -side * sin(angle))
        return np.stack([bearing.pitch_diameter / 2 / cos(angle) + normal, places], axis=1) @ np.array(rows)

    wide = (BEYOND * half / sphere + angle) * np.linspace(-1.0, 1.0, 81)
    raceway = sphere * np.stack([np.sin(wide), np.cos(wide)], axis=1)
    (left, _), (right, _) = raceway[[0, -1]]
    sheet.area([*raceway, (right, sphere + wall), (left, sphere + wall)], "outer-ring", fc=OUTER, **SCHEMATIC)
    sheet.line(raceway, "outer-raceway")
    lower = [along(side, -1, groove) for side in (-1, 1)]
    bottom = min(each[:, 1].min() for each in lower) - wall
    corners = [(lower[1][-1, 0], bottom), (lower[0][0, 0], bottom)]
    sheet.area([*lower[0], *lower[1], *corners], "inner-ring", fc=INNER, **SCHEMATIC)
    for side, each in zip((-1, 1), lower, strict=True):
        sheet.line(each, "inner-raceway")
        sheet.area([*along(side, 1, barrel), *along(side, -1, barrel)[::-1]], "roller", fc=ELEMENT)
    _along_normal(sheet, sphere)
    sheet.label("bearing.roller.length", tuple((along(1, 1, barrel)[-1] + along(1, -1, barrel)[-1]) / 2))
    sheet.label("bearing.outer_osculation", tuple(raceway[20]))
    sheet.label("bearing.inner_osculation", tuple(lower[0][10]))
    if words.case.operation.load.axial:
        start = np.array([left - 0.8 * half, bottom + wall / 2])
        sheet.line([start, start + np.array([0.7 * half, 0.0])], ec=LOAD, arrowstyle="-|>", lw=2.0)
        sheet.label("operation.load.axial", tuple(start))
    sheet.notes.append("Dashed: schematic. Normals of all contacts meet in the centre of the bearing.")
    return sheet.drawn(
        "Axial half section, rollers and raceways to scale, dimensions as the case gives them.",
        "Axial half section of a spherical roller bearing: two rows of barrels in a sphere.",
    )


def _along_normal(sheet: Sheet, sphere: float) -> None:
    """The contact normal of the row on the right, that meets the sphere [m], with what lies on it."""
    bearing = sheet.words.case.bearing
    normal = np.array([sin(bearing.contact_angle), cos(bearing.contact_angle)])
    centre = sphere - bearing.roller.diameter / 2
    sheet.line([0.55 * centre * normal, sphere * normal], ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    sheet.label("bearing.contact_angle", tuple(0.6 * centre * normal))
    sheet.label("bearing.pitch_diameter", tuple(centre * normal), "Ø ")
    sheet.label("bearing.roller.diameter", tuple(sphere * normal), "Ø ")
