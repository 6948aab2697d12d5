"""Axial half section of a tapered roller bearing; rings schematic, but for the raceways and the rib."""

from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import ELEMENT, INNER, LOAD, OUTER, SCHEMATIC, Words

BEYOND = 0.12  # of the length of the rollers: what raceways go on beyond them
WALL = 0.45  # of the diameter of the rollers: least thickness of the rings


def section(words: Words) -> Drawing:
    """Draw the upper half of the section through rollers and rings, the apex to the left."""
    sheet, case = Sheet("section", words, cross=True), words.case
    bearing, (axis, cone) = case.bearing, case.bearing.angles
    centre, along = np.array([0.0, bearing.pitch_diameter / 2]), _direction(axis)
    half, radius = bearing.roller.length / 2, bearing.roller.diameter / 2 / cos(bearing.cup_angle - axis)

    def raceway(angle: float, outwards: int, beyond: float = 0.0) -> NDArray:
        """Ends of a contact line, small one first."""
        normal = outwards * np.array([-sin(angle), cos(angle)])
        ends = np.array([-half - beyond, half + beyond])
        return centre + radius * normal + ends[:, None] * _direction(angle)

    outer, inner, wall = raceway(bearing.cup_angle, 1), raceway(cone, -1), WALL * bearing.roller.diameter
    _cup(sheet, raceway(bearing.cup_angle, 1, 2 * BEYOND * half), wall)
    _cone(sheet, raceway(cone, -1, 2 * BEYOND * half), wall, (axis, inner[1], centre + half * along))
    sheet.area([*outer, *inner[::-1]], "roller", fc=ELEMENT)
    line = np.array([-1.25, 1.25])[:, None] * half * along + centre
    sheet.line(line, ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    sheet.label("bearing.cup_angle", tuple(outer[1]))
    sheet.label("bearing.cone_angle", tuple(inner[0]))
    sheet.label("bearing.pitch_diameter", tuple(centre), "Ø ")
    sheet.label("bearing.roller.diameter", tuple((outer[0] + outer[1]) / 2), "Ø ")
    sheet.label("bearing.roller.length", tuple((inner[0] + inner[1]) / 2))
    if case.operation.load.axial:
        start = np.array([-1.9 * half, inner[0][1] - wall / 2])
        sheet.line([start, start + np.array([0.8 * half, 0.0])], ec=LOAD, arrowstyle="-|>", lw=2.0)
        sheet.label("operation.load.axial", tuple(start))
    sheet.notes.extend(_notes(bearing))
    return sheet.drawn(
        "Axial half section, rollers and raceways to scale, dimensions as the case gives them.",
        "Axial half section of a tapered roller bearing with its dimensions, the rib on the right.",
    )


def _notes(bearing: Any) -> list[str]:
    """What the drawing does not show."""
    notes = ["Dashed: schematic, the case has no dimensions of it."]
    if pair := bearing.pair:
        arrangement = pair.arrangement.replace("_", " ")
        apart = "on one circle, rollers crossed"
        if pair.distance:
            apart = f"{arrangement}, {1e3 * pair.distance:.4g} mm apart"
        notes.append(f"One row of two, {apart}.")
    of_rib = "; the rib's is that of its normal" if bearing.rib else ""
    return [*notes, f"Angles from the axis of the bearing{of_rib}."]


def _direction(angle: float) -> NDArray:
    return np.array([cos(angle), sin(angle)])


def _cup(sheet: Sheet, raceway: NDArray, wall: float) -> None:
    """The outer ring above its raceway."""
    (left, _), (right, high) = raceway
    top = high + wall
    sheet.area([*raceway, (right, top), (left, top)], "outer-ring", fc=OUTER, **SCHEMATIC)
    sheet.line(raceway, "outer-raceway")


def _cone(sheet: Sheet, raceway: NDArray, wall: float, end: tuple[float, NDArray, NDArray]) -> None:
    """The inner ring below its raceway, with a rib that meets the roller's end.

    Of that the angle of its axis, the corner at the raceway and the middle are given.
    """
    (left, low), far = raceway
    bottom, rib, (axis, corner, middle) = low - wall, sheet.words.case.bearing.rib, end
    if rib is None:
        outline = [raceway[0], far, (far[0], bottom), (left, bottom)]
        sheet.area(outline, "inner-ring", fc=INNER, **SCHEMATIC)
        sheet.line(raceway, "inner-raceway")
        return
    depth = rib.end_radius * sin(axis - rib.angle)
    contact = middle - depth * np.array([-sin(axis), cos(axis)])
    across = np.array([-sin(rib.angle), cos(rib.angle)])  # along the face of the rib, outwards
    foot, tip = contact + across * ((corner - contact) @ across), contact + 0.25 * wall * across
    right = tip[0] + 1.2 * wall
    outline = [raceway[0], corner, foot, tip, (right, tip[1]), (right, bottom), (left, bottom)]
    sheet.area(outline, "inner-ring", fc=INNER, **SCHEMATIC)
    sheet.line([raceway[0], corner], "inner-raceway")
    sheet.line([foot, tip], "rib")
    for key in ("angle", "end_radius", "friction"):
        sheet.label(f"bearing.rib.{key}", tuple(contact), "R " if key == "end_radius" else "")
