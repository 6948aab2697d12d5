"""Limiting loads as catalogues draw them: axial load to the right, moment upwards."""

from __future__ import annotations

from typing import TYPE_CHECKING

from flexbearing.report.figure import COLOURS, Axis, Figure, Line
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

    from flexbearing.limits.curves import LimitCurves


def drawn(found: LimitCurves) -> Page:
    """A line for each radial load."""
    lines = []
    for number, curve in enumerate(found.points):
        axial, moment = [1e-3 * point.axial for point in curve], [1e-3 * point.moment for point in curve]
        name = f"radial load {1e-3 * curve[0].radial:,.4g} kN"
        lines.append(Line(axial, moment, name, colour=COLOURS[number % len(COLOURS)]))
    what = f"Limiting static loads, static safety {found.limits.safety:g}"
    axial, moment = Axis("axial load [kN]", from_zero=True), Axis("moment [kN m]", from_zero=True)
    figure = Figure("limiting_loads", what, axial, moment, tuple(lines))
    return picture(found.title, what, [figure], size=(6.5, 4.5))
