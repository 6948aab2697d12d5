"""Pictures of quantities of the balls around the ring."""

from __future__ import annotations

from typing import TYPE_CHECKING

from flexbearing.report.html.figures import around
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import picture
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WHAT = "Contact loads and angles"
LOADS = {"contact load": ("contact_load",), "contact angle": ("contact_angle",)}


def stacked(result: Result, what: str, wanted: dict[str, tuple[str, ...]]) -> Figure:
    """A titled figure with panels above each other, by the titles of their quantities."""
    reader = Reader(result, METRIC)
    found = (around(reader, title, names, "ball_azimuth") for title, names in wanted.items())
    drawn = [figure for figure in found if figure]
    return picture(reader.attributes["title"], what, drawn, size=(7.0, 2.5))
