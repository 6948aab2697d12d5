"""The report of a map: outputs over its axes, regions of several equilibria."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.printable import printable
from flexbearing.report.html.document import Document, Figure
from flexbearing.report.studies.map_figure import Contours

LEVEL = {"color": "#fff", "width": 1.0}
LIMIT = {"color": "#D55E00", "width": 2.0}


@dataclass(frozen=True)
class MapPlane:
    """Outputs over two keys, the others kept."""

    name: str  # of the plane; empty where there are no others
    labels: tuple[str, str]  # of both keys
    x: tuple[float, ...]
    y: tuple[float, ...]
    fields: dict[str, NDArray]  # (x, y) by headings
    folds: NDArray  # (n, 2, 2) both ends of each piece
    logarithmic: tuple[bool, bool]
    contours: dict[str, Contours]  # by headings


def of_map(
    title: str, words: Sequence[str], planes: Sequence[MapPlane], danger: bool, table: tuple[str, str]
) -> Document:
    """Collect the report of a map."""
    shown = [
        (printable(plane.name), [*_figures(plane, number)], *_lines(plane))
        for number, plane in enumerate(planes)
    ]
    parts = {"words": words, "danger": danger, "planes": shown}
    return Document("map.html.j2", f"Map: {printable(title)}", parts, table)


def _figures(plane: MapPlane, number: int) -> Iterator[Figure]:
    layout = {
        axis: {"title": {"text": label}, "type": "log" if log else "linear"}
        for axis, label, log in zip(("xaxis", "yaxis"), plane.labels, plane.logarithmic, strict=True)
    }
    for place, (heading, values) in enumerate(plane.fields.items()):
        traces = [{
            "type": "heatmap", "x": list(plane.x), "y": list(plane.y), "z": _rows(values),
            "colorbar": {"title": {"text": heading, "side": "right"}}, "colorscale": "Viridis",
            "hovertemplate": f"%{{x}}, %{{y}}: %{{z}}<extra>{heading}</extra>", "meta": heading,
        }, *_contours(plane, heading), *_folds(plane)]  # fmt: skip
        yield Figure(f"map-{number}-{place}", heading, tuple(traces), layout | {"showlegend": False})


def _rows(values: NDArray) -> list[list[float | None]]:
    """Numbers as a figure takes them, row by row of y."""
    return [[float(f"{value:.5g}") if np.isfinite(value) else None for value in row] for row in values.T]


def _contours(plane: MapPlane, heading: str) -> Iterator[dict]:
    contours = plane.contours.get(heading, Contours()).within(plane.fields[heading])
    for values, line in ((contours.levels, LEVEL), (contours.limits, LIMIT)):
        for value in values:
            yield {
                "type": "contour", "x": list(plane.x), "y": list(plane.y), "z": _rows(plane.fields[heading]),
                "contours": {
                    "start": value, "end": value, "size": 1.0, "coloring": "none", "showlabels": True,
                    "labelfont": {"color": line["color"]},
                },
                "autocontour": False, "showscale": False, "hoverinfo": "skip", "line": line,
                "name": f"{value:g}", "meta": heading,
            }  # fmt: skip


def _lines(plane: MapPlane) -> tuple[bool, bool, bool]:
    """Whether there are folds, limits and levels."""
    drawn = [
        plane.contours.get(heading, Contours()).within(values) for heading, values in plane.fields.items()
    ]
    return bool(len(plane.folds)), any(each.limits for each in drawn), any(each.levels for each in drawn)


def _folds(plane: MapPlane) -> Iterator[dict]:
    if len(plane.folds):
        x, y = (
            [value for piece in plane.folds[..., axis].tolist() for value in (*piece, None)]
            for axis in (0, 1)
        )
        yield {
            "type": "scatter", "mode": "lines", "x": x, "y": y,
            "line": {"color": "#000", "width": 1.5}, "hoverinfo": "skip", "name": "fold", "meta": "fold",
        }  # fmt: skip
