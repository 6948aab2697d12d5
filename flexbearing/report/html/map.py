"""The report of a map: outputs over its axes, regions of several equilibria."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.printable import printable
from flexbearing.report.figure import ORANGE, Axis, Contour, Figure, Line, Map, is_wide
from flexbearing.report.html.document import Document
from flexbearing.report.html.reader import listed

LEVEL, LIMIT = "#fff", ORANGE  # colours of contours


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
    contours: dict[str, tuple[Contour, ...]]  # by headings
    unsolved: NDArray  # (n, 2) points without a state

    def drawn_contours(self, heading: str) -> tuple[Contour, ...]:
        """Contours of an output between its smallest and its largest value."""
        finite = self.fields[heading][np.isfinite(self.fields[heading])]
        low, high = finite.min(initial=np.inf), finite.max(initial=-np.inf)
        return tuple(each for each in self.contours.get(heading, ()) if low < each.value < high)


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
        drawn = Map(
            plane.x, plane.y, listed(values.T), logarithmic=is_wide(values),
            contours=plane.drawn_contours(heading),
            hover=f"%{{x}}, %{{y}}: %{{z}}<extra>{heading}</extra>", of=heading,
        )  # fmt: skip
        yield Figure(f"map-{number}-{place}", heading, x, y, (drawn, *_folds(plane)))


def _lines(plane: MapPlane) -> tuple[bool, bool, bool]:
    """Whether there are folds, limits and levels."""
    colours = {each.colour for heading in plane.fields for each in plane.drawn_contours(heading)}
    return bool(len(plane.folds)), LIMIT in colours, LEVEL in colours


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
