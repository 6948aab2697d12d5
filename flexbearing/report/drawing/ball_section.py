"""Axial section of a ball between its grooves, with contact angle, shoulders and rings."""

from math import acos, cos, degrees, sin
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.rings import elastic_ring, ring_on_shaft
from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import ELEMENT, HOUSING, INNER, LOAD, OUTER, SCHEMATIC, SHAFT, Words

WIDTH, WALL = 0.62, 0.2  # over the ball's diameter: half width, wall under the groove of undescribed rings
DEPTH = 0.75  # of the groove over the ball's radius where no shoulder is given
CONTACT = "#a61c00"
THRUST = ("operation.load.axial", "operation.preload.force", "operation.preload.displacement")


def one_groove(words: Words) -> Drawing:
    """Draw a ball of an angular-contact or deep groove bearing, which touches under thrust."""
    sheet, case = Sheet("section", words, cross=True), words.case
    bearing: Any = case.bearing
    diameter, clearance = bearing.ball.diameter, bearing.stated_clearance
    angle = acos(1 - clearance / (2 * bearing.centre_distance)) if clearance > 0 else 0.0
    lines = {
        side: _groove(getattr(bearing, side).over(diameter) * diameter, diameter, (angle,), sign)
        for side, sign in (("outer", 1), ("inner", -1))
    }
    _outer(sheet, case, lines["outer"])
    _inner(sheet, case, lines["inner"])
    _ball(sheet, case, ((1, angle),))
    stated = "bearing.contact_angle"
    if words.value(stated) is None:
        stated = "bearing.clearance"
        sheet.notes.append(
            f"Contact angle under light thrust, from the clearance: {degrees(angle):.4g}°, as drawn."
        )
    _label(sheet, case, angle, stated)
    for path in ("bearing.clearance_class", "bearing.fits.cold_clearance"):
        sheet.label(path, _at(bearing, 0.5, 0.5 * angle))
    if pair := bearing.second_row:
        arrangement = pair.arrangement.replace("_", " ")
        sheet.notes.append(
            f"One row of two, {arrangement}, {1e3 * pair.distance:.4g} mm apart: that which +x presses."
        )
        if case.one_ring("outer") or case.inner.kind != "rigid":
            sheet.notes.append("Of a ring that has both grooves one is drawn.")
    _thrust(sheet, bearing)
    return _finished(sheet, "two points under thrust")


def two_arches(words: Words) -> Drawing:
    """Draw a ball of a four-point bearing, between bolted rings where they are described."""
    sheet, case = Sheet("section", words, cross=True), words.case
    bearing: Any = case.bearing
    diameter, angle = bearing.ball.diameter, bearing.contact_angle
    lines = {
        side: _groove(
            getattr(bearing, side).over(diameter) * diameter,
            diameter + bearing.clearance,
            (angle, -angle),
            sign,
        )
        for side, sign in (("outer", 1), ("inner", -1))
    }
    _bolted_rings(sheet, case, lines)
    _ball(sheet, case, ((1, angle), (1, -angle)))
    _label(sheet, case, angle, "bearing.contact_angle")
    sheet.label("bearing.clearance", _at(bearing, -0.5, angle))
    _thrust(sheet, bearing)
    return _finished(sheet, "four points")


def _groove(radius: float, diameter: float, angles: tuple[float, ...], outward: int) -> NDArray:
    """Points (n, 2) of a groove from -x to +x, up to the equator of the ball, from the ball centre [m].

    Each arch touches a ball of a diameter at its contact angle; of two arches the inner envelope is kept.
    """
    x = np.linspace(-0.999 * radius, 0.999 * radius, 1201)
    depth = np.full(x.size, np.inf)
    for angle in angles:
        offset = radius - diameter / 2
        centre = -offset * sin(angle) * outward, -offset * cos(angle)
        inside = np.maximum(radius**2 - (x - centre[0]) ** 2, 0.0)
        depth = np.minimum(depth, centre[1] + np.sqrt(inside))
    return np.stack([x, outward * depth], axis=1)


def _cut(groove: NDArray, height: float) -> NDArray:
    """The part of a groove below its shoulders [m]."""
    depth = np.abs(groove[:, 1])
    return groove[depth >= depth.max() - height]


def _outer(sheet: Sheet, case: Any, groove: NDArray) -> None:
    """Outer ring with what holds it, or its housing by the fits; what has no dimensions is schematic."""
    bearing, outer = case.bearing, case.outer
    groove, half = _shouldered(bearing, "outer", groove), WIDTH * bearing.ball.diameter
    outside = bearing.fits and bearing.fits.outer_diameter / 2
    if outer.kind in ("rigid", "step"):
        edge = outside or bearing.pitch_diameter / 2 + (0.5 + WALL) * bearing.ball.diameter
        _ring(sheet, "outer", groove, (-half, half), edge, fc=OUTER, **SCHEMATIC)
        sheet.label("outer.file", (half, edge))
    else:
        middle = _between_rows(case, "outer", groove)
        left, right = (middle - outer.groove_offset + side * outer.width / 2 for side in (-1, 1))
        ends = (left, groove[0, 1]), (right, groove[-1, 1])
        elastic_ring(sheet, outer, np.concatenate([ends[:1], groove, ends[1:]]), "groove")
        if outer.groove_offset:
            sheet.length("outer.groove_offset", middle, middle - outer.groove_offset, groove[0, 1])
    _shoulder(sheet, "outer", groove, 1)
    if outside:
        sheet.line([(-half, outside), (half, outside)], "outer-surface")
        sheet.label("bearing.fits.outer_diameter", (half, outside), "Ø ")
    if bearing.fits and (housing := bearing.fits.housing):
        edges = outside, housing.diameter / 2
        sheet.rectangle((-1.2 * half, 1.2 * half), edges, fc=HOUSING, **SCHEMATIC)
        sheet.label("bearing.fits.housing.diameter", (1.2 * half, housing.diameter / 2), "Ø ")
        for name in ("tolerance_class", "interference"):
            sheet.label(f"bearing.fits.housing.{name}", (half, outside))


def _inner(sheet: Sheet, case: Any, groove: NDArray) -> None:
    """Inner ring on its shaft; what has no dimensions is schematic."""
    bearing, inner, fits = case.bearing, case.inner, case.bearing.fits
    groove, half = _shouldered(bearing, "inner", groove), WIDTH * bearing.ball.diameter
    if inner.kind != "ring_on_shaft":
        bore = fits and fits.bore / 2
        edge = bore or bearing.pitch_diameter / 2 - (0.5 + WALL) * bearing.ball.diameter
        _ring(sheet, "inner", groove, (-half, half), edge, fc=INNER, **SCHEMATIC)
        if bore:
            inside = fits.shaft_bore / 2 if fits.shaft_bore else bore - 0.3 * half
            sheet.rectangle((-1.2 * half, 1.2 * half), (inside, bore), fc=SHAFT, **SCHEMATIC)
            sheet.line([(-half, bore), (half, bore)], "inner-surface")
            sheet.label("bearing.fits.shaft_bore", (half, inside), "Ø ")
            for name in ("shaft", "shaft_interference"):
                sheet.label(f"bearing.fits.{name}", (half, bore))
    else:
        middle = _between_rows(case, "inner", groove)
        left, right = (middle + side * inner.width / 2 for side in (-1, 1))
        ends = (left, groove[0, 1]), (right, groove[-1, 1])
        outside = np.concatenate([ends[:1], groove, ends[1:]])
        ring_on_shaft(sheet, inner, outside, bearing.ball.diameter)
        sheet.line(groove, "inner-groove")
        sheet.label("bearing.fits.shaft_bore", (right, inner.shaft_bore / 2), "Ø ")
    sheet.label("bearing.fits.bore", (half, fits.bore / 2 if fits else 0.0), "Ø ")
    _shoulder(sheet, "inner", groove, -1)


def _between_rows(case: Any, race: Literal["inner", "outer"], groove: NDArray) -> float:
    """Middle between all grooves of a ring, of which one is drawn [m]."""
    return _bottom(groove) - (case.bearing.row_place(race) if case.one_ring(race) else 0.0)


def _shouldered(bearing: Any, side: str, groove: NDArray) -> NDArray:
    """A groove up to its shoulders, from the axis of the bearing [m]."""
    height = getattr(bearing, side).shoulder or DEPTH * bearing.ball.diameter / 2
    return _cut(groove, height) + np.array([0.0, bearing.pitch_diameter / 2])


def _bottom(groove: NDArray) -> float:
    """Axial place of the bottom of a groove between two shoulders of one height [m]."""
    return float(groove[0, 0] + groove[-1, 0]) / 2


def _bolted_rings(sheet: Sheet, case: Any, grooves: dict[str, NDArray]) -> None:
    """Rings of rectangular section on their bolted faces; rigid ones schematic."""
    bearing = case.bearing
    diameter, pitch = bearing.ball.diameter, bearing.pitch_diameter / 2
    for side, sign, colour in (("outer", 1, OUTER), ("inner", -1, INNER)):
        ring, given = getattr(case.rings, side), getattr(bearing, side).shoulder
        if ring.kind == "rigid":
            groove = _cut(grooves[side], given or DEPTH * diameter / 2) + np.array([0.0, pitch])
            edge, half = pitch + sign * (0.5 + WALL) * diameter, WIDTH * diameter
            _ring(sheet, side, groove, (-half, half), edge, fc=colour, **SCHEMATIC)
            _shoulder(sheet, side, groove, sign)
            continue
        radius = getattr(bearing, side).over(diameter) * diameter
        half = radius * sin(ring.groove_end) - (radius - diameter / 2) * sin(bearing.contact_angle)
        groove = grooves[side][np.abs(grooves[side][:, 0]) <= half] + np.array([0.0, pitch])
        face = ring.face_distance if ring.face == "+x" else -ring.face_distance
        other = face - ring.width if ring.face == "+x" else face + ring.width
        far = getattr(ring, ring.far) / 2
        _ring(sheet, side, groove, (min(face, other), max(face, other)), far, fc=colour)
        shoulder = groove[0, 1]
        ends = sorted((far, shoulder), reverse=face > 0)
        sheet.held((face, ends[0]), (face, ends[1]))
        edge = max(face, other)
        sheet.label(f"rings.{side}.{ring.far}", (edge, far), "Ø ")
        sheet.label(f"rings.{side}.groove_end", tuple(groove[-1]))
        sheet.label(f"rings.{side}.face", (face, 0.5 * (far + shoulder)))
        for name in ("face_stiffness", "face_shear_stiffness"):
            sheet.label(f"rings.{side}.{name}", (face, 0.5 * (far + shoulder)))
        sheet.length(f"rings.{side}.width", face, other, far)
        sheet.length(f"rings.{side}.face_distance", face, 0.0, far)
        _shoulder(sheet, side, groove, sign)


def _ring(sheet: Sheet, side: str, groove: NDArray, x: tuple[float, float], far: float, **style: Any) -> None:
    """A ring between two end faces, from its groove to the far surface; the groove as a full line."""
    level = [float(groove[0, 1]), float(groove[-1, 1])]
    outline = [(x[0], far), (x[0], level[0]), *groove, (x[1], level[1]), (x[1], far)]
    sheet.area(outline, f"{side}-ring", **style)
    sheet.line(np.concatenate([groove, groove[::-1]]), f"{side}-groove")


def _shoulder(sheet: Sheet, side: str, groove: NDArray, outward: int) -> None:
    """Height of a shoulder above the bottom of the groove, where it is given."""
    bottom = outward * np.max(outward * groove[:, 1])
    sheet.height(f"bearing.{side}.shoulder", bottom, float(groove[0, 1]), float(groove[0, 0]))


def _ball(sheet: Sheet, case: Any, lines: tuple[tuple[int, float], ...]) -> None:
    """The ball with its lines of contact."""
    pitch, radius = case.bearing.pitch_diameter / 2, case.bearing.ball.diameter / 2
    sheet.circle(radius, (0.0, pitch), "ball", points=361, fc=ELEMENT)
    sheet.line(
        [(0.0, pitch - 1.1 * radius), (0.0, pitch + 1.1 * radius)], ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2))
    )
    sheet.line([(-1.3 * radius, pitch), (1.3 * radius, pitch)], ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))
    for _, angle in lines:
        ends = [(sign * radius * sin(angle), pitch + sign * radius * cos(angle)) for sign in (-1, 1)]
        sheet.line(ends, "contact-line", ec=CONTACT, lw=0.8)
    steps = np.linspace(0.0, lines[0][1], 20)
    if lines[0][1]:
        curve = 0.6 * radius * np.stack([np.sin(steps), np.cos(steps)], axis=1) + np.array([0.0, pitch])
        sheet.line(np.concatenate([curve, curve[::-1]]), ec=CONTACT, lw=0.6)


def _label(sheet: Sheet, case: Any, angle: float, stated: str) -> None:
    """Sizes of ball and grooves, pitch circle, contact angle."""
    bearing, radius = case.bearing, case.bearing.ball.diameter / 2
    sheet.label(stated, _at(bearing, 0.6, 0.5 * angle))
    sheet.label("bearing.pitch_diameter", (1.3 * radius, bearing.pitch_diameter / 2), "Ø ")
    sheet.label("bearing.ball.diameter", _at(bearing, 1.0, 1.9), "Ø ")
    for side, turn in (("outer", 0.5), ("inner", 2.65)):
        for path in (f"bearing.{side}.conformity", f"bearing.{side}.radius"):
            sheet.label(path, _at(bearing, 1.02, turn), "R " if path.endswith("radius") else "")


def _thrust(sheet: Sheet, bearing: Any) -> None:
    """Axial load or preload on the inner ring; nothing where there is none."""
    given = {path: sheet.words.value(path) for path in THRUST}
    acting = [path for path in THRUST if given[path]]
    if not acting:
        return
    size, sense = bearing.ball.diameter, float(np.sign(given[acting[0]]))
    y = bearing.pitch_diameter / 2 - 0.62 * size
    sheet.line([(-0.3 * sense * size, y), (0.3 * sense * size, y)], ec=LOAD, arrowstyle="-|>", lw=1.6)
    for path in acting:
        sheet.label(path, (0.1 * size, y))
    sheet.notes.append("Red arrow: axial load on the inner ring.")


def _at(bearing: Any, part: float, angle: float) -> tuple[float, float]:
    """A place in the section, a part of the ball's radius from its centre [m]."""
    reach = part * bearing.ball.diameter / 2
    return reach * sin(angle), bearing.pitch_diameter / 2 + reach * cos(angle)


def _finished(sheet: Sheet, what: str) -> Drawing:
    schematic = "Dashed: schematic, the case has no dimensions of it. " if sheet.is_schematic else ""
    sheet.notes.append(f"{schematic}Red: lines of contact without load.")
    sheet.notes.append("Conformity: groove radius over ball diameter.")
    return sheet.drawn(
        f"Axial section of a ball and its grooves to scale, touching at {what}.",
        f"Axial section of a ball between its grooves, touching at {what}, with dimensions.",
    )
