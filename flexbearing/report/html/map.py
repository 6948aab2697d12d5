"""The report of a map: outputs over its axes, regions of several equilibria."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.printable import printable
from flexbearing.report.figure import ORANGE, Axis, Contour, Figure, Line, Map, is_wide
from flexbearing.report.html.document import Document
from flexbearing.report.html.reader import listed


@dataclass(frozen=True)
class Contours:
    """Values of an output that are drawn as lines."""

    limits: tuple[float, ...] = ()  # from where, or below which, the bearing is in danger
    levels: tuple[float, ...] = ()  # of what has no limit

    def within(self, values: NDArray) -> "Contours":
        """Those that lie between the smallest and the largest value."""
        finite = values[np.isfinite(values)]
        if not finite.size:
            return Contours()
        low, high = finite.min(), finite.max()
        limits, levels = (
            tuple(value for value in each if low < value < high) for each in (self.limits, self.levels)
        )
        return Contours(limits, levels)


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
    unsolved: NDArray  # (n, 2) points without a state


def of_map(
    title: str, words: Sequence[str], planes: Sequence[MapPlane], danger: bool, table: tuple[str, str]
) -> Document:
    """Collect the report of a map."""
    shown = [
        (printable(plane.name), [*figures(plane, number)], *_lines(plane))
        for number, plane in enumerate(planes)
    ]
    parts = {"words": words, "danger": danger, "planes": shown}
    return Document("map.html.j2", f"Map: {printable(title)}", parts, table)


def figures(plane: MapPlane, number: int = 0) -> Iterator[Figure]:
    """Draw every output of a plane."""
    x, y = (
        Axis(label, "log" if log else "linear")
        for label, log in zip(plane.labels, plane.logarithmic, strict=True)
    )
    for place, (heading, values) in enumerate(plane.fields.items()):
        within = plane.contours.get(heading, Contours()).within(values)
        contours = (*(Contour(value, "#fff", 1.0) for value in within.levels),
                    *(Contour(value, ORANGE, 2.0) for value in within.limits))  # fmt: skip
        drawn = Map(
            plane.x, plane.y, listed(values.T), heading, logarithmic=is_wide(values), contours=contours,
            hover=f"%{{x}}, %{{y}}: %{{z}}<extra>{heading}</extra>", of=heading,
        )  # fmt: skip
        yield Figure(f"map-{number}-{place}", heading, x, y, (drawn, *_folds(plane)))


def _lines(plane: MapPlane) -> tuple[bool, bool, bool]:
    """Whether there are folds, limits and levels."""
    drawn = [
        plane.contours.get(heading, Contours()).within(values) for heading, values in plane.fields.items()
    ]
    return bool(len(plane.folds)), any(each.limits for each in drawn), any(each.levels for each in drawn)


def _folds(plane: MapPlane) -> Iterator[Line]:
    """Fold curves, and points without a state."""
    if len(plane.folds):
        x, y = (
            [value for piece in plane.folds[..., axis].tolist() for value in (*piece, None)]
            for axis in (0, 1)
        )
        yield Line(x, y, "fold", "#000", mark="", width=1.0, of="fold")
    if len(plane.unsolved):
        x, y = plane.unsolved.T.tolist()
        yield Line(x, y, "not converged", "#c00000", "", "x")
