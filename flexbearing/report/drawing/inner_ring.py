"""Axial half section of an inner ring with its shaft."""

from typing import Any

from flexbearing.report.drawing.sheet import Sheet
from flexbearing.report.drawing.words import INNER, LOAD, RIGID_WALL, RIGID_WIDTH, SCHEMATIC, SHAFT


def inner_ring(sheet: Sheet, case: Any, raceway: float) -> None:
    """Draw what carries the inner raceway of a roller bearing, of a radius [m]."""
    inner = case.inner
    if inner.kind == "rigid":
        _rigid(sheet, case, raceway)
        return
    side, track, bore = inner.width / 2, inner.track_width / 2, inner.bore / 2
    rib = bore + inner.thickness if inner.ribbed else raceway
    outside = [(-side, rib), (-track, rib), (-track, raceway), (track, raceway), (track, rib), (side, rib)]
    ring_on_shaft(sheet, inner, outside, 1.5 * case.bearing.roller.diameter)
    sheet.line([(-track, raceway), (track, raceway)], "inner-raceway")
    if inner.ribbed:
        sheet.height("inner.thickness", bore, rib, -side)
        sheet.length("inner.track_width", -track, track, raceway)
    sheet.label("inner.fit", (side, bore))
    if inner.fit == "friction":
        sheet.label("inner.fit_friction", (side, bore))
    _clamped(sheet, inner, (bore + rib) / 2)


def ring_on_shaft(sheet: Sheet, inner: Any, outside: Any, depth: float) -> None:
    """Draw a ring by its outer surface from -x to +x (n, 2) [m] on a shaft with both ends clamped.

    A solid shaft is drawn down to a depth [m].
    """
    left, right = outside[0][0], outside[-1][0]
    middle, bore, hollow = (left + right) / 2, inner.bore / 2, inner.shaft_bore / 2
    start, end = (middle + side * inner.shaft_length / 2 for side in (-1, 1))
    inside = hollow or max(bore - depth, 0.0)
    shoulder = sheet.words.value("inner.shoulder_diameter")
    top = [(end, bore)] if shoulder is None else [(end, shoulder / 2), (right, shoulder / 2)]
    sheet.area([(start, inside), (end, inside), *top, (right, bore), (start, bore)], "shaft", fc=SHAFT)
    sheet.area([(right, bore), (left, bore), *outside], "inner-ring", fc=INNER)
    sheet.held(top[0], (end, inside))
    sheet.held((start, inside), (start, bore))
    sheet.label("inner.bore", (end, bore), "Ø ")
    if hollow:
        sheet.height("inner.shaft_thickness", inside, bore, start)
    sheet.length("inner.width", left, right, bore)
    sheet.length("inner.shaft_length", start, end, inside)
    sheet.label("inner.shoulder_diameter", (end, (shoulder or 0) / 2), "Ø ")
    for path in ("shaft_interference", "shaft"):
        sheet.label(f"bearing.fits.{path}", (right, bore))


def _clamped(sheet: Sheet, inner: Any, radius: float) -> None:
    """Force of the nut that presses the ring on the shoulder; nothing without."""
    if not inner.clamping:
        return
    tip = (-inner.width / 2, radius)
    sheet.line([(-0.75 * inner.width, radius), tip], ec=LOAD, arrowstyle="-|>", lw=1.6)
    sheet.label("inner.clamping", tip)
    sheet.notes.append("Red arrow: force of the nut, which presses the ring on the shoulder.")


def _rigid(sheet: Sheet, case: Any, raceway: float) -> None:
    """Ring of which the case gives the raceway, and perhaps the bore and a shaft."""
    bearing: Any = case.bearing
    fits: Any = bearing.fits
    width = RIGID_WIDTH * bearing.roller.length / 2
    diameter = getattr(fits, "bore", None)
    bore = diameter / 2 if diameter else raceway - RIGID_WALL * bearing.roller.diameter
    sheet.rectangle((-width, width), (bore, raceway), **SCHEMATIC, fc=INNER, alpha=0.8)
    sheet.line([(-width, raceway), (width, raceway)], "inner-raceway")
    if diameter is None:
        return
    hollow = getattr(fits, "shaft_bore", None)
    inside = bore - 0.6 * bearing.roller.diameter if hollow is None else hollow / 2
    sheet.rectangle((-1.3 * width, 1.3 * width), (inside, bore), **SCHEMATIC, fc=SHAFT, alpha=0.8)
    sheet.line([(-1.3 * width, bore), (1.3 * width, bore)], "bore")
    sheet.label("bearing.fits.bore", (1.3 * width, bore), "Ø ")
    for path in ("shaft_interference", "shaft"):
        sheet.label(f"bearing.fits.{path}", (width, bore))
    sheet.label("bearing.fits.shaft_bore", (1.3 * width, inside), "Ø ")
