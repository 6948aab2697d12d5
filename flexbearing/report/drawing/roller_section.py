"""Axial half section of a cylindrical roller bearing with what carries its raceways."""

from typing import Any

from flexbearing.report.drawing.rings import inner_ring, outer_ring
from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import CAGE, ELEMENT, SCHEMATIC, Words


def section(words: Words) -> Drawing:
    """Draw the upper half of the section through rollers, cage, rings, shaft and housing."""
    sheet = Sheet("section", words, cross=True)
    case: Any = words.case
    bearing = case.bearing
    outer, size = bearing.outer_raceway_diameter / 2, bearing.roller.diameter
    inner, half = outer - size - case.stated_clearance / 2, bearing.rows_width / 2
    length, middle = bearing.roller.length, outer - size / 2
    outer_ring(sheet, case)
    inner_ring(sheet, case, inner)
    for begin in sorted({-half, half - length}):
        sheet.rectangle((begin, begin + length), (outer - size, outer), "roller", fc=ELEMENT)
    sheet.line([(-half, middle), (half, middle)], ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    _cage(sheet, case)
    _flanges(sheet, case, inner)
    sheet.label("bearing.outer_raceway_diameter", (half, outer), "Ø ")
    sheet.label("bearing.roller.diameter", (half, outer - 0.3 * size), "Ø ")
    clearance = ("bearing.clearance", "bearing.clearance_class", "bearing.fits.cold_clearance")
    for path in clearance:
        sheet.label(path, (half, inner))
    sheet.length("bearing.roller.length", half - length, half, outer - size)
    sheet.length("bearing.second_row.distance", length / 2 - half, half - length / 2, middle)
    sheet.notes.append("Dashed: schematic, the case has no dimensions of it.")
    sheet.notes.append("Rollers touch the outer raceway; the clearance is below them.")
    operating = "" if bearing.clearance is None else ", bearing.clearance is that in operation"
    what = f"outer.kind = {case.outer.kind}, inner.kind = {case.inner.kind}"
    return sheet.drawn(
        f"Axial half section to scale, dimensions as the case gives them{operating}; {what}.",
        f"Axial half section of a cylindrical roller bearing with its dimensions; {what}.",
    )


def _cage(sheet: Sheet, case: Any) -> None:
    """Sides of the cage, thickness to scale, between the rollers' ends and the edge of the raceways."""
    bearing: Any = case.bearing
    cage: Any = bearing.cage
    half, (low, high) = bearing.rows_width / 2, bearing.cage_radii
    reach = 0.25 * bearing.roller.length
    if cage.land_width:
        reach = max(reach, cage.land_width / 2)
    if cage.thickness:
        for side in (-1, 1):
            sheet.rectangle((side * half, side * (half + reach)), (low, high), **SCHEMATIC, fc=CAGE)
        sheet.height("bearing.cage.thickness", low, high, -half - reach)
        if message := case.cage_within_ribs:
            sheet.notes.append(f"Dimensions overlap: {message}.")
    if cage.land_diameter is not None:
        land = cage.land_diameter / 2
        for side in (-1, 1):
            sheet.line(
                [(side * half, land), (side * (half + cage.land_width / 2), land)],
                "land",
                ec="#a61c00",
                lw=1.4,
            )
        sheet.notes.append("Red: guiding land of the cage.")
        end = half + cage.land_width / 2
        sheet.label("bearing.cage.land_diameter", (end, land), "Ø ")
        sheet.label("bearing.cage.land_clearance", (end, high if cage.guidance == "outer" else low))
        sheet.label("bearing.cage.land_width", (half + cage.land_width / 4, land), "2 sides, sum ")
    sheet.label("bearing.cage.guidance", (half + 0.7 * reach, (low + high) / 2))


def _flanges(sheet: Sheet, case: Any, inner: float) -> None:
    """Guide flanges at both ends of the rollers, their height and clearance to scale."""
    flange, bearing = case.bearing.flange, case.bearing
    if flange is None:
        return
    start = bearing.rows_width / 2 + flange.clearance / 2
    foot, out = (inner, 1) if flange.ring == "inner" else (bearing.outer_raceway_diameter / 2, -1)
    ends = sorted((foot, foot + out * flange.height))
    for side in (-1, 1):
        wide = side * (start + 0.15 * bearing.roller.length)
        sheet.rectangle(
            (side * start, wide), (ends[0], ends[1]), "guide-flange", fc="#d9d2e9", ls=(0, (4, 2)), lw=0.6
        )
    sheet.height("bearing.flange.height", ends[0], ends[1], -start)
    for path in ("bearing.flange.clearance", "bearing.flange.roller_chamfer"):
        sheet.label(path, (start, (ends[0] + ends[1]) / 2))
