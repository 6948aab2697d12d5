"""Axial half section of an inner ring with its shaft."""

from typing import Any

from flexbearing.report.drawing.sheet import Sheet
from flexbearing.report.drawing.words import INNER, LOAD, RIGID_WALL, RIGID_WIDTH, SCHEMATIC, SHAFT


def inner_ring(sheet: Sheet, case: Any, raceway: float) -> None:
    """Draw what carries the inner raceway of a roller bearing, of a radius [m]."""
    if case.inner.kind == "rigid":
        _rigid(sheet, case, raceway)
    else:
        _on_shaft(sheet, case, raceway)


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


def _on_shaft(sheet: Sheet, case: Any, raceway: float) -> None:
    """Ring with its ribs on a shaft that is clamped at both ends."""
    inner = case.inner
    side, track, end = inner.width / 2, inner.track_width / 2, inner.shaft_length / 2
    bore, rib = (
        inner.bore / 2,
        inner.bore / 2 + (inner.thickness if inner.ribbed else raceway - inner.bore / 2),
    )
    hollow = inner.shaft_bore / 2
    solid = inner.shaft_thickness is None or hollow == 0
    inside = max(bore - 1.5 * case.bearing.roller.diameter, 0.0) if solid else hollow
    shoulder = (
        []
        if inner.shoulder_diameter is None
        else [(end, inner.shoulder_diameter / 2), (side, inner.shoulder_diameter / 2)]
    )
    top = shoulder or [(end, bore)]
    sheet.area([(-end, inside), (end, inside), *top, (side, bore), (-end, bore)], "shaft", fc=SHAFT)
    ribs = [(side, rib), (track, rib), (track, raceway), (-track, raceway), (-track, rib), (-side, rib)]
    sheet.area([(-side, bore), (side, bore), *ribs], "inner-ring", fc=INNER)
    sheet.line([(-track, raceway), (track, raceway)], "inner-raceway")
    sheet.held(top[0], (end, inside))
    sheet.held((-end, inside), (-end, bore))
    sheet.label("inner.bore", (end, bore), "Ø ")
    if inner.ribbed:
        sheet.height("inner.thickness", bore, rib, -side)
        sheet.length("inner.track_width", -track, track, raceway)
    if not solid:
        sheet.height("inner.shaft_thickness", inside, bore, -end)
    sheet.length("inner.width", -side, side, bore)
    sheet.length("inner.shaft_length", -end, end, inside)
    sheet.label("inner.shoulder_diameter", (end, (inner.shoulder_diameter or 0) / 2), "Ø ")
    sheet.label("inner.fit", (side, bore))
    if inner.fit == "friction":
        sheet.label("inner.fit_friction", (side, bore))
    _clamped(sheet, inner, (bore + rib) / 2)
    for path in ("shaft_interference", "shaft"):
        sheet.label(f"bearing.fits.{path}", (side, bore))


def _clamped(sheet: Sheet, inner: Any, radius: float) -> None:
    """Force of the nut that presses the ring on the shoulder; nothing without."""
    if not inner.clamping:
        return
    tip = (-inner.width / 2, radius)
    sheet.line([(-0.75 * inner.width, radius), tip], ec=LOAD, arrowstyle="-|>", lw=1.6)
    sheet.label("inner.clamping", tip)
    sheet.notes.append("Red arrow: force of the nut, which presses the ring on the shoulder.")
