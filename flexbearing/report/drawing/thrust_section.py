"""Axial half section of a roller thrust bearing; washers schematic, but for the raceways."""

from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import ELEMENT, INNER, LOAD, OUTER, SCHEMATIC, Words

BEYOND, WALL = 0.15, 0.65  # washers beyond the rollers over their length, thickness over their diameter


def section(words: Words) -> Drawing:
    """Draw the upper half of the section through rollers and washers, the load from the left."""
    sheet, bearing = Sheet("section", words, cross=True), words.case.bearing
    pitch, radius, half = bearing.pitch_diameter / 2, bearing.roller.diameter / 2, bearing.roller.length / 2
    back, beyond = (1 + 2 * WALL) * radius, (1 + 2 * BEYOND) * half
    for name, side, colour in (("inner", -1, INNER), ("outer", 1, OUTER)):
        outline = _box(side * radius, side * back, pitch, beyond)
        sheet.area(outline, f"{name}-ring", fc=colour, **SCHEMATIC)
        sheet.line(outline[:2], f"{name}-raceway")
    sheet.area(_box(-radius, radius, pitch, half), "roller", fc=ELEMENT)
    axis = [(0.0, pitch - 1.25 * half), (0.0, pitch + 1.25 * half)]
    sheet.line(axis, ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    sheet.label("bearing.pitch_diameter", (0.0, pitch), "Ø ")
    sheet.label("bearing.roller.diameter", (0.0, pitch - half), "Ø ")
    sheet.label("bearing.roller.length", (radius, pitch + half / 2))
    if words.case.operation.load.axial:
        start = -back - 1.2 * radius, pitch
        sheet.line([start, (-back, pitch)], ec=LOAD, arrowstyle="-|>", lw=2.0)
        sheet.label("operation.load.axial", start)
    sheet.notes.append("Dashed: schematic. Left: shaft washer, the inner ring.")
    return sheet.drawn(
        "Axial half section, rollers and raceways to scale, dimensions as the case gives them.",
        "Axial half section of a roller thrust bearing: a roller between shaft washer and housing washer.",
    )


def _box(left: float, right: float, middle: float, half: float) -> list[tuple[float, float]]:
    """Corners of a rectangle, those on the left first."""
    return [(left, middle - half), (left, middle + half), (right, middle + half), (right, middle - half)]
