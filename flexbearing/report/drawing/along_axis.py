"""A bearing seen along its axis: rolling elements with their numbers, azimuth, load, what holds the ring."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import (
    AXES,
    ELEMENT,
    HOUSING,
    INNER,
    LOAD,
    OUTER,
    SCHEMATIC,
    SHAFT,
    TURNING,
    Words,
)

MOST_NUMBERS = 30  # of rolling elements that are written
NOTES = (
    "Seen along +x, which points away from the reader: z down, y to the right.",
    "Azimuth φ runs from z, 0°, to y, 90°: left-handed about +x. Speeds and angles are positive this way.",
)
TIP = 0.76  # of a radius: where the arrow of the load ends
NUMBERS = "Numbers of rolling elements as in tables of results."


def rollers(words: Words) -> Drawing:
    """Draw a cylindrical roller bearing along its axis."""
    sheet, case = Sheet("along-axis", words), words.case
    _rings_of_rollers(sheet, case)
    bearing: Any = case.bearing
    pitch = (bearing.outer_raceway_diameter - bearing.roller.diameter) / 2
    azimuths = bearing.first_roller_azimuth + 2 * np.pi * np.arange(bearing.rollers) / bearing.rollers
    _elements(sheet, pitch, bearing.roller.diameter / 2, azimuths)
    sheet.label("bearing.outer_raceway_diameter", place(bearing.outer_raceway_diameter / 2, 2.6), "Ø ")
    _count(
        sheet, azimuths, ("bearing.rollers", "bearing.first_roller_azimuth", "bearing.roller.diameter"), pitch
    )
    _held_at(sheet, case)
    operation, outside = case.operation, sheet.box[1][1]
    _arrow(
        sheet, operation.load_direction, 0.9 * outside, "operation.radial_load", "operation.load_direction"
    )
    for name in ("moment", "misalignment"):
        if getattr(operation, name):
            sheet.label(f"operation.{name}", place(0.45 * outside, operation.load_direction))
    _turning(sheet, "operation.inner_speed", 0.55 * pitch)
    _turning(sheet, "operation.outer_speed", (bearing.outer_raceway_diameter / 2 + outside) / 2)
    _unbalance(sheet, bearing.cage, pitch)
    return _finished(sheet, case, "roller")


def balls(words: Words) -> Drawing:
    """Draw a ball bearing along its axis."""
    sheet, case = Sheet("along-axis", words), words.case
    bearing: Any = case.bearing
    pitch, size = bearing.pitch_diameter / 2, bearing.ball.diameter
    for radius, style in _contours_of_balls(case, pitch, size):
        sheet.circle(radius, **style)
    azimuths = bearing.first_ball_azimuth + 2 * np.pi * np.arange(bearing.balls) / bearing.balls
    _elements(sheet, pitch, size / 2, azimuths)
    sheet.circle(pitch, ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    sheet.label("bearing.pitch_diameter", place(pitch, 1.9), "Ø ")
    _count(sheet, azimuths, ("bearing.balls", "bearing.first_ball_azimuth", "bearing.ball.diameter"), pitch)
    _load_at_rolling_elements(sheet, case.operation.load, pitch, pitch - 0.55 * size)
    _turning(
        sheet, f"operation.{'speed' if hasattr(case.operation, 'speed') else 'inner_speed'}", 0.55 * pitch
    )
    _turning(sheet, "operation.outer_speed", (pitch + 0.5 * size + sheet.box[1][1]) / 2)
    return _finished(sheet, case, "ball")


def tapered_rollers(words: Words) -> Drawing:
    """Draw a tapered roller bearing along its axis, rollers as circles of their diameter in the middle."""
    return _inclined_rollers(words, words.case.bearing.roller.diameter, _elements)


def thrust_rollers(words: Words) -> Drawing:
    """Draw a roller thrust bearing along its axis, rollers along the radii of their washers."""
    roller = words.case.bearing.roller
    size = (roller.length + 0.3 * roller.diameter) / 2
    return _inclined_rollers(words, size, partial(_lying, length=roller.length))


def _inclined_rollers(words: Words, size: float, draw: Callable[..., None]) -> Drawing:
    """Rings that reach a size in- and outwards of the pitch circle [m], with rollers as `draw` has them."""
    sheet, case = Sheet("along-axis", words), words.case
    bearing: Any = case.bearing
    pitch = bearing.pitch_diameter / 2
    for reach, colour in ((1.0, OUTER), (0.5, "white"), (-0.5, INNER), (-1.0, "white")):
        sheet.circle(pitch + reach * size, fc=colour, **SCHEMATIC)
    azimuths = bearing.first_roller_azimuth + 2 * np.pi * np.arange(bearing.rollers) / bearing.rollers
    if bearing.on_circle > bearing.rollers:  # crossed: those of the other direction between them
        azimuths = np.append(azimuths, azimuths + np.pi / bearing.rollers)
    draw(sheet, pitch, bearing.roller.diameter / 2, azimuths)
    sheet.label("bearing.pitch_diameter", place(pitch, 1.9), "Ø ")
    _count(
        sheet, azimuths, ("bearing.rollers", "bearing.first_roller_azimuth", "bearing.roller.diameter"), pitch
    )
    _load_at_rolling_elements(sheet, case.operation.load, pitch, pitch - 0.55 * size)
    _turning(sheet, "operation.inner_speed", 0.55 * pitch)
    _turning(sheet, "operation.outer_speed", pitch + 0.75 * size)
    return _finished(sheet, case, "roller")


def _load_at_rolling_elements(sheet: Sheet, load: Any, pitch: float, inside: float) -> None:
    """Radial load as an arrow inside the balls, moments at their axes; the section shows the thrust."""
    if load is None:
        return
    if load.radial_y or load.radial_z:  # None of a place that is given instead
        azimuth = np.arctan2(load.radial_y or 0.0, load.radial_z or 0.0)
        _arrow(sheet, azimuth, inside / TIP, "operation.load.radial_y", "operation.load.radial_z")
    for name, azimuth in (("moment_y", np.pi / 2), ("moment_z", 0.0)):
        if getattr(load, name):
            sheet.label(f"operation.load.{name}", place(0.36 * pitch, azimuth))
    if load.moment_y or load.moment_z:
        sheet.notes.append("Moments on the inner ring: by the right hand about y and z.")


def _turning(sheet: Sheet, path: str, radius: float) -> None:
    """Sense in which a ring turns, an arrow about the axis; nothing where it is at rest."""
    speed = sheet.words.value(path)
    if not speed:
        return
    arc = np.linspace(1.75, 2.5, 41)[:: 1 if speed > 0 else -1]
    points = [place(radius, angle) for angle in arc]
    sheet.line(points[:-2], path.rpartition(".")[2], ec=TURNING, lw=1.0)
    sheet.line(points[-3:], ec=TURNING, arrowstyle="-|>", lw=1.0)
    sheet.label(path, place(radius, 2.1))


def _unbalance(sheet: Sheet, cage: Any, pitch: float) -> None:
    """Where the mass centre of a free cage is, its distance from the axis magnified."""
    if not cage.unbalance:
        return
    centre = place(0.15 * pitch, cage.unbalance_azimuth)
    sheet.circle(0.02 * pitch, centre, fc="0.1")
    for name in ("unbalance", "unbalance_azimuth"):
        sheet.label(f"bearing.cage.{name}", centre)
    sheet.notes.append("Black point: mass centre of the cage, its distance from the axis not to scale.")


def _rings_of_rollers(sheet: Sheet, case: Any) -> None:
    """Rings, shaft and housing: their circles from the outside inwards."""
    bearing, outer, inner, fits = case.bearing, case.outer, case.inner, case.bearing.fits
    raceway = bearing.outer_raceway_diameter / 2
    inside = raceway - bearing.roller.diameter - case.stated_clearance / 2
    if outer.thickness:
        if outer.support == "housing" and outer.kind == "ring":
            sheet.circle(raceway + outer.thickness + outer.housing_thickness, fc="#e3e3e3")
        sheet.circle(raceway + outer.thickness, fc=OUTER)
    elif fits and fits.outer_diameter:
        sheet.circle(fits.outer_diameter / 2, fc=OUTER)
    else:
        sheet.circle(raceway + bearing.roller.diameter / 2, fc=OUTER, **SCHEMATIC)
    sheet.circle(raceway, name="outer-raceway", fc="white")
    sheet.circle(inside, name="inner-raceway", fc=INNER)
    bore = inner.bore or (fits.bore if fits and fits.bore else None)
    if bore is None:
        sheet.circle(inside - bearing.roller.diameter / 2, fc="white", **SCHEMATIC)
        return
    sheet.circle(bore / 2, fc=SHAFT)
    hollow = inner.shaft_bore if inner.bore else (fits.shaft_bore or 0.0)
    if hollow:
        sheet.circle(hollow / 2, fc="white")


def _contours_of_balls(case: Any, pitch: float, size: float) -> Iterator[tuple[float, dict[str, Any]]]:
    """Circles of the rings from the outside inwards, with what fills them; unknown ones dashed."""
    rings, bearing = getattr(case, "rings", None), case.bearing
    fits = getattr(bearing, "fits", None)
    outside = (rings.outer.outside_diameter if rings else fits and fits.outer_diameter) or 0.0
    bore = (rings.inner.bore if rings else fits and fits.bore) or 0.0
    lands, shaft, hollow = [0.0, 0.0], "white", 0.0
    if not rings and case.outer.kind not in ("rigid", "step"):
        outer, bottom = case.outer, bearing.groove_bottom("outer")
        outside, lands[0] = 2 * (bottom + outer.thickness), bottom - bearing.outer.shoulder
        if outer.kind == "ring" and outer.support == "housing":
            yield outside / 2 + outer.housing_thickness, {"fc": HOUSING}
    if not rings and case.inner.kind == "ring_on_shaft":
        lands[1] = bearing.groove_bottom("inner") + bearing.inner.shoulder
        bore, shaft, hollow = case.inner.bore, SHAFT, case.inner.shaft_bore / 2
    for radius, usual, colour in (
        (outside / 2, pitch + size, OUTER),
        (lands[0], pitch + 0.25 * size, "white"),
        (lands[1], pitch - 0.25 * size, INNER),
        (bore / 2, pitch - size, shaft),
    ):
        yield radius or usual, {"fc": colour} | ({"ec": "0.1", "lw": 0.8} if radius else SCHEMATIC)
    if hollow:
        yield hollow, {"fc": "white"}


def _lying(sheet: Sheet, pitch: float, radius: float, azimuths: np.ndarray, length: float) -> None:
    """Rollers along the radii, numbered as circles are."""
    for azimuth in azimuths:
        outline = _bar(pitch - length / 2, pitch + length / 2, 2 * radius, azimuth)
        sheet.area(outline, fc=ELEMENT, lw=0.6)
    _elements(sheet, pitch, 0.2 * radius, azimuths)


def _elements(sheet: Sheet, pitch: float, radius: float, azimuths: np.ndarray) -> None:
    """Rolling elements at their places, with numbers from 1, every few where there are many."""
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100) if len(azimuths) <= MOST_NUMBERS * s)
    small = 7.0 if len(azimuths) <= 20 else 5.5
    for number, azimuth in enumerate(azimuths, 1):
        sheet.circle(radius, place(pitch, azimuth), name=f"element-{number}", fc=ELEMENT, lw=0.6)
        if number == 1 or number % step == 0:
            beside = radius > 0.055 * pitch
            at = place(pitch if beside else pitch - 1.2 * radius - 0.05 * pitch, azimuth)
            sheet.word(str(number), at, fontsize=small, bbox=None)


def _count(sheet: Sheet, azimuths: np.ndarray, paths: tuple[str, str, str], pitch: float) -> None:
    """Number of rolling elements, azimuth of the first, and diameter; the axes."""
    radius = sheet.words.value(paths[2]) / 2
    for path, azimuth, sign in zip(paths, (1.4, azimuths[0], 2.2), ("", "", "Ø "), strict=True):
        nearest = azimuths[np.argmax(np.cos(azimuths - azimuth))]
        sheet.label(path, tuple(np.add(place(pitch, nearest), (radius, 0.0))), sign)
    axes_of_azimuth(sheet, pitch)


def axes_of_azimuth(sheet: Sheet, pitch: float) -> None:
    """Axes y and z, the sense of azimuth, and x away from the reader, about the axis of the bearing."""
    reach = 0.42 * pitch
    down = {"va": "top"}, (0.0, -0.02 * pitch)
    right = {"ha": "left"}, (0.02 * pitch, 0.0)
    for text, angle, (style, aside) in (("z, azimuth 0", 0.0, down), ("y", np.pi / 2, right)):
        tip = place(reach, angle)
        sheet.line([(0, 0), tip], ec=AXES, arrowstyle="->", lw=0.8)
        sheet.word(text, (tip[0] + aside[0], tip[1] + aside[1]), color=AXES, bbox=None, **style)
    sheet.line([place(0.3 * pitch, angle) for angle in np.linspace(0.15, 1.3, 30)], ec=AXES, lw=0.6)
    sheet.line([place(0.3 * pitch, 1.3), place(0.3 * pitch, 1.42)], ec=AXES, arrowstyle="->", lw=0.6)
    sheet.word("φ", place(0.23 * pitch, np.pi / 4), color=AXES, bbox=None)
    sheet.circle(0.04 * pitch, ec=AXES, fc="white")
    for angle in (np.pi / 4, 3 * np.pi / 4):
        sheet.line([place(0.04 * pitch, angle), place(0.04 * pitch, angle + np.pi)], ec=AXES, lw=0.6)
    sheet.word("x", place(0.11 * pitch, -2.3), color=AXES, bbox=None)


def _arrow(sheet: Sheet, azimuth: float, radius: float, *paths: str) -> None:
    """The load on the inner ring, from the axis of the bearing outwards."""
    start, tip = place(0.5 * radius, azimuth), place(TIP * radius, azimuth)
    sheet.line([start, tip], ec=LOAD, arrowstyle="-|>", lw=2.0)
    for path in paths:
        sheet.label(path, start)


def _held_at(sheet: Sheet, case: Any) -> None:
    """Lines that support the ring, or the tooth forces of a planet gear."""
    outer = case.outer
    if outer.kind != "ring" or outer.support not in ("lines", "planet"):
        return
    radius = case.bearing.outer_raceway_diameter / 2 + outer.thickness
    if outer.support == "lines":
        for azimuth in outer.line_azimuths:
            foot = [place(1.1 * radius, azimuth + turn) for turn in (-0.05, 0.05)]
            sheet.area([place(radius, azimuth), *foot], fc="0.8")
        for name in ("support", "line_azimuths"):
            sheet.label(f"outer.{name}", place(1.05 * radius, outer.line_azimuths[0]))
        return
    acting = outer.tooth_radius or radius
    sheet.circle(acting, ec=AXES, lw=0.6, ls="-.")
    sheet.label("outer.tooth_radius", place(acting, 2.6), "r ")
    for name in ("support", "tooth_azimuths", "tooth_radial", "tooth_tangential", "tooth_axial"):
        sheet.label(f"outer.{name}", place(acting, outer.tooth_azimuths[0]))
    largest = max(map(abs, (*outer.tooth_radial, *outer.tooth_tangential))) or 1.0
    for azimuth, radial, tangential in zip(
        outer.tooth_azimuths, outer.tooth_radial, outer.tooth_tangential, strict=True
    ):
        tip = np.array(place(acting, azimuth))
        along = [np.array(place(1.0, azimuth)), np.array(place(1.0, azimuth + np.pi / 2))]
        force = (radial * along[0] + tangential * along[1]) / largest
        sheet.line([tip - 0.35 * radius * force, tip], ec=LOAD, arrowstyle="-|>", lw=1.2)


def _finished(sheet: Sheet, case: Any, element: str) -> Drawing:
    sheet.notes.extend(NOTES)
    teeth = ", tooth forces" if sheet.words.value("outer.tooth_azimuths") else ""
    sheet.notes.append(f"Red: load on the inner ring{teeth}. Green: rotation. {NUMBERS}")
    if sheet.is_schematic:
        sheet.notes.append("Dashed: schematic, the case has no dimensions of it.")
    bearing = case.bearing
    number = getattr(bearing, "on_circle", bearing.rollers) if element == "roller" else bearing.balls
    return sheet.drawn(
        f"The bearing along its axis, to scale: {number} {element}s, azimuth 0 along z.",
        f"Bearing seen along its axis with {number} {element}s, numbered, axes y and z, azimuth and load.",
    )


def place(radius: float, azimuth: float) -> tuple[float, float]:
    """Where an azimuth is drawn: 0 down, 90 degrees to the right [m]."""
    return float(radius * np.sin(azimuth)), float(-radius * np.cos(azimuth))


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
