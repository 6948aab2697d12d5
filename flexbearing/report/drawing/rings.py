"""Axial half section of an outer ring with what holds it."""

from typing import Any

import numpy as np

from flexbearing.report.drawing.sheet import Sheet
from flexbearing.report.drawing.words import (
    HOUSING,
    INNER,
    LOAD,
    OUTER,
    RIGID_WALL,
    RIGID_WIDTH,
    SCHEMATIC,
    SHAFT,
)


def outer_ring(sheet: Sheet, case: Any) -> None:
    """Draw what carries the outer raceway of a roller bearing."""
    outer, raceway = case.outer, case.bearing.outer_raceway_diameter / 2
    if outer.kind in ("rigid", "step"):
        _rigid(sheet, case)
        return
    left, right = (side * outer.width / 2 - outer.raceway_offset for side in (-1, 1))
    elastic_ring(sheet, outer, [(left, raceway), (right, raceway)], "raceway")
    if outer.raceway_offset:
        sheet.length("outer.raceway_offset", 0.0, -outer.raceway_offset, raceway)


def elastic_ring(sheet: Sheet, outer: Any, inside: Any, surface: str) -> None:
    """Draw an elastic ring by its inner surface from -x to +x (n, 2) [m], and its bars or what holds it."""
    inside = np.array(inside)
    (left, land), (right, _) = inside[0], inside[-1]
    bottom = inside[np.argmax(inside[:, 1])]  # of a groove; of rollers the raceway
    top = bottom[1] + outer.thickness
    sheet.height("outer.thickness", bottom[1], top, bottom[0])
    sheet.area([(left, top), *inside, (right, top)], "outer-ring", fc=OUTER)
    sheet.line(inside, f"outer-{surface}")
    if outer.kind == "squirrel_cage":
        _bars(sheet, outer, (land, top), (left, right))
    sheet.length("outer.width", left, right, land)
    if outer.kind == "matrix":  # its file has a stiffness, no shape
        sheet.rectangle((left, right), (top, top + outer.thickness), fc=HOUSING, **SCHEMATIC)
        sheet.label("outer.matrix", (right, top + outer.thickness / 2))
    elif outer.kind == "ring":
        _support(sheet, outer, (left, right), (land, top))


def _support(sheet: Sheet, outer: Any, sides: tuple[float, float], radii: tuple[float, float]) -> None:
    """What holds a plain ring: side, outer surface, housing, springs, lines or teeth."""
    (left, right), (land, top) = sides, radii
    if outer.support == "side":
        sheet.held((right, top), (right, land))
    elif outer.support == "seat":
        sheet.held((left, top), (right, top))
    elif outer.support == "housing":
        _housing(sheet, outer, (left + right) / 2, top)
    elif outer.support == "foundation":
        _springs(sheet, left, right, top)
        for path in ("radial", "axial", "tangential"):
            if getattr(outer, f"foundation_{path}"):
                sheet.label(f"outer.foundation_{path}", (right, top))
    else:  # lines, or the teeth of a planet gear: the view along the axis shows where
        sheet.line([(left, top), (right, top)], ec="#0b5394", lw=2)
        sheet.label("outer.support", (right, top))
    if sheet.words.value("outer.tooth_radius") is not None:
        sheet.line([(left, outer.tooth_radius), (right, outer.tooth_radius)], ec="#0b5394", ls="-.")
        sheet.label("outer.tooth_radius", (right, outer.tooth_radius), "r ")


def _bars(sheet: Sheet, outer: Any, radii: tuple[float, float], sides: tuple[float, float]) -> None:
    """Collars of a ring, bars and clamped flanges."""
    (left, right), (land, top), middle = sides, radii, sum(radii) / 2
    ends = (1, -1) if outer.bar_ends == "both" else (1,)
    for end in ends:
        start = right if end > 0 else left
        foot = start + end * outer.bar_length
        face = foot + end * outer.flange_length
        half = outer.bar_thickness / 2
        sheet.rectangle((start, foot), (middle - half, middle + half), "bar", fc="#dde8f3")
        sheet.rectangle((foot, face), (land, top), "flange", fc=OUTER)
        sheet.held(*((face, r) for r in ((top, land) if end > 0 else (land, top))))
    foot, face = right + outer.bar_length, right + outer.bar_length + outer.flange_length
    if length := sheet.words.value("outer.collar_length"):
        collar = land + (outer.collar_thickness or outer.thickness)
        for end in ends:
            start = right if end > 0 else left
            sheet.rectangle((start - end * length, start), (top, collar), "collar", fc=OUTER)
        sheet.length("outer.collar_length", right - length, right, collar)
        sheet.height("outer.collar_thickness", land, collar, right)
    sheet.length("outer.bar_length", right, foot, middle)
    sheet.length("outer.flange_length", foot, face, land)
    sheet.label("outer.bar_thickness", (foot - outer.bar_length / 3, middle))
    sheet.label("outer.bars", (foot - outer.bar_length / 2, middle + outer.bar_thickness / 2))
    if sheet.words.value("outer.fillet"):
        sheet.label("outer.fillet", (foot, middle - outer.bar_thickness / 2), "R ")


def _housing(sheet: Sheet, outer: Any, middle: float, bottom: float) -> None:
    """Housing around the ring, centred on the ring, and what holds it."""
    left, right = (middle + side * outer.housing_width / 2 for side in (-1, 1))
    top = bottom + outer.housing_thickness
    sheet.rectangle((left, right), (bottom, top), "housing", fc=HOUSING)
    sheet.held(
        *(((left, top), (right, top)) if outer.housing_support == "seat" else ((right, top), (right, bottom)))
    )
    sheet.height("outer.housing_thickness", bottom, top, left)
    sheet.length("outer.housing_width", left, right, bottom)
    for path in (
        "outer.housing_clearance",
        "bearing.fits.housing.interference",
        "bearing.fits.housing.tolerance_class",
    ):
        sheet.label(path, (right, bottom))


def _springs(sheet: Sheet, left: float, right: float, y: float) -> None:
    """Springs to the ground above a surface, as a symbol."""
    height, count = 0.16 * (right - left), 5
    pitch = (right - left) / count
    for number in range(count):
        x, across = left + (number + 0.5) * pitch, 0.15 * pitch
        turns = [
            (x + (across if turn % 2 else -across), y + height * (0.2 + 0.1 * turn)) for turn in range(7)
        ]
        sheet.line([(x, y), (x, y + 0.15 * height), *turns, (x, y + 0.85 * height), (x, y + height)], lw=0.5)
    sheet.held((left, y + height), (right, y + height))


def _rigid(sheet: Sheet, case: Any) -> None:
    """Ring of which the case gives the raceway, and perhaps the outside and a housing around it."""
    bearing: Any = case.bearing
    fits: Any = bearing.fits
    raceway = bearing.outer_raceway_diameter / 2
    width = (bearing.rows_width + (RIGID_WIDTH - 1) * bearing.roller.length) / 2
    diameter = getattr(fits, "outer_diameter", None)
    outside = diameter / 2 if diameter else raceway + RIGID_WALL * bearing.roller.diameter
    sheet.rectangle((-width, width), (raceway, outside), **SCHEMATIC, fc=OUTER, alpha=0.8)
    sheet.line([(-width, raceway), (width, raceway)], "outer-raceway")
    if diameter:
        sheet.line([(-width, outside), (width, outside)], "outside")
        sheet.label("bearing.fits.outer_diameter", (width, outside), "Ø ")
    if fits is not None and fits.housing is not None and fits.housing.diameter is not None:
        top = fits.housing.diameter / 2
        sheet.rectangle((-width, width), (outside, top), **SCHEMATIC, fc=HOUSING, alpha=0.8)
        sheet.line([(-width, top), (width, top)], "housing")
        sheet.label("bearing.fits.housing.diameter", (width, top), "Ø ")
        for path in ("interference", "tolerance_class"):
            sheet.label(f"bearing.fits.housing.{path}", (width, outside))
    if case.outer.kind == "step":
        sheet.label("outer.file", (width, outside))


def inner_ring(sheet: Sheet, case: Any, raceway: float) -> None:
    """Draw what carries the inner raceway of a roller bearing, of a radius [m]."""
    inner = case.inner
    if inner.kind == "rigid":
        _rigid_inner(sheet, case, raceway)
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


def _rigid_inner(sheet: Sheet, case: Any, raceway: float) -> None:
    """Ring of which the case gives the raceway, and perhaps the bore and a shaft."""
    bearing: Any = case.bearing
    fits: Any = bearing.fits
    width = (bearing.rows_width + (RIGID_WIDTH - 1) * bearing.roller.length) / 2
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
