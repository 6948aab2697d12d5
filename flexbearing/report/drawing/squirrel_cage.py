"""Bars of a squirrel cage seen along its axis."""

import numpy as np

from flexbearing.report.drawing.along_axis import NOTES, axes_of_azimuth, place
from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import Words


def bars(words: Words, bottom: float, shoulder: float = 0.0) -> Drawing:
    """Draw the section across the bars, with the ring behind them.

    Its thickness counts from the radius of its raceway, or of the bottom of its groove, above which its
    shoulder has a height [m].
    """
    sheet, outer = Sheet("bars", words), words.case.outer
    inside, outside = bottom - shoulder, bottom + outer.thickness
    middle, half = (inside + outside) / 2, outer.bar_thickness / 2
    sheet.circle(outside, fc="#e8eff6", lw=0.6)
    sheet.circle(inside, name="outer-raceway", fc="white", lw=0.6)
    for number in range(outer.bars):
        sheet.area(_bar(middle - half, middle + half, outer.bar_width, 2 * np.pi * number / outer.bars),
                   f"bar-{number + 1}", fc="#9dbbd8")  # fmt: skip
    axes_of_azimuth(sheet, inside)
    pitch = 2 * np.pi / outer.bars
    sheet.label("bearing.outer_raceway_diameter", place(inside, 2.6), "Ø ")
    sheet.label("bearing.outer.shoulder", place(inside, 2.6))
    sheet.label("outer.thickness", place(outside, 2.2))
    for path, number in (("bars", 0.25), ("bar_width", 0.2), ("bar_thickness", 0.3)):
        nearest = pitch * round(number * outer.bars)
        sheet.label(f"outer.{path}", place(middle + half, nearest))
    if words.value("outer.fillet"):
        sheet.label("outer.fillet", place(middle - half, pitch * round(0.12 * outer.bars)), "R ")
    sheet.notes.extend(
        (*NOTES, "Dark: bars, with parallel sides, the first at azimuth 0. Light: the ring behind them.")
    )
    return sheet.drawn(
        f"Section across the {outer.bars} bars of the squirrel cage, to scale, seen along the axis.",
        f"Squirrel cage seen along its axis with {outer.bars} bars, their width and thickness, axes y and z.",
    )


def _bar(inside: float, outside: float, width: float, azimuth: float) -> np.ndarray:
    """Outline of a bar between two radii with parallel sides, as slots milled from a tube leave it [m]."""
    across = np.linspace(-width / 2, width / 2, 15)
    points = [
        (t, np.sqrt(radius**2 - t**2))
        for radius, side in ((outside, across), (inside, across[::-1]))
        for t in side
    ]
    t, r = np.transpose(points)
    turned = t * np.cos(azimuth) + r * np.sin(azimuth), t * np.sin(azimuth) - r * np.cos(azimuth)
    return np.stack(turned, axis=1)
