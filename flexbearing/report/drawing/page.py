"""A page in millimetres: shapes, dimensions, leaders and texts of a drawing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.printable import printable
from flexbearing.report.picture import boxes_for_glyphs

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INCH, POINT = 25.4, 25.4 / 72  # [mm]
TEXT, DPI = 7.0, 200  # [pt], of pictures
LINE, ROW, TRACK, MARGIN, LEADER, CROSS = 3.8, 6.0, 3.5, 4.0, 7.0, 9.0  # [mm] of the page
ENGRAVED, THIN = "0.1", "0.45"  # colours of outlines and of dimensions
HEAD_ROOM = 2.5  # [mm] shorter dimensions have points at their ends in place of arrows


@dataclass(frozen=True)
class Page:
    """Where a part lies on the page, and how marks are put there."""

    axes: Axes
    scale: float  # [mm/m]
    origin: NDArray  # [mm] of the part

    def at(self, point: Any) -> NDArray:
        """Place on the page [mm]."""
        return self.origin + self.scale * np.asarray(point)

    def shape(self, name: str | None, points: NDArray, style: dict[str, Any]) -> None:
        """Draw an outline, lines, or the ground along an edge."""
        from matplotlib.patches import FancyArrowPatch, Polygon

        if style.get("ground"):
            self.ground(*self.at(points))
        elif "arrowstyle" in style:
            ends = [tuple(point) for point in self.at(points[[0, -1]])]
            rest = {key: value for key, value in style.items() if key not in ("closed", "ec", "fc")}
            self.axes.add_patch(
                FancyArrowPatch(*ends, color=style["ec"], shrinkA=0, shrinkB=0, mutation_scale=8, **rest)
            )
        else:
            self.axes.add_patch(Polygon(self.at(points), gid=name, joinstyle="miter", **style))

    def ground(self, start: NDArray, end: NDArray) -> None:
        """A line with short strokes on its left-hand side."""
        along = (end - start) / np.hypot(*(end - start))
        stroke = 1.6 * np.array([-along[1], along[0]]) - 1.2 * along
        self.leader([start, end], color=ENGRAVED, lw=1.4)
        for step in np.arange(1.2, np.hypot(*(end - start)), 1.4):
            foot = start + step * along
            self.leader([foot, foot + stroke], color=ENGRAVED)

    def dim(self, start: Any, end: Any) -> None:
        """The line of a dimension, with arrows or, where it is short, with points at its ends."""
        start, end = np.asarray(start), np.asarray(end)
        (x, y), size = np.transpose([start, end]), np.hypot(*(end - start))
        if size < HEAD_ROOM:
            self.axes.plot(x, y, color=ENGRAVED, lw=0.6, marker="o", ms=1.6)
            return
        style = {"arrowstyle": "<|-|>,head_length=0.35,head_width=0.12", "shrinkA": 0, "shrinkB": 0}
        self.axes.annotate("", end, start, arrowprops=style | {"color": ENGRAVED, "lw": 0.5})

    def length(self, text: str, ends: tuple[float, float], seen: float, y: float, edge: float) -> None:
        """A dimension in its row below the part, its text left of an edge that no extension line crosses."""
        places = [self.at((x, seen)) for x in ends]
        for place in places:
            self.leader([place, (place[0], y - 1)])
        self.dim(*((place[0], y) for place in places))
        self.leader([(edge - 1, y), (places[0][0], y)])
        self.word(text, (edge - 2, y), ha="right")

    def leader(self, points: Any, *, dot: bool = False, **style: Any) -> None:
        """A thin line, with a point at its beginning on wish."""
        x, y = np.transpose(points)
        given = {"color": THIN, "lw": 0.4, "marker": "o", "ms": 1.6, "markevery": [0]} if dot else {}
        self.axes.plot(x, y, **({"color": THIN, "lw": 0.4} | given | style))

    def word(self, text: str, place: Any, **style: Any) -> None:
        """A text on a white ground."""
        given = {"fontsize": TEXT, "ha": "center", "va": "center", "parse_math": False, "zorder": 9}
        x, y = np.asarray(place)
        paper = {"fc": "white", "ec": "none", "pad": 0.4}
        self.axes.text(x, y, printable(text), **(given | {"bbox": paper} | style))

    def cross(self, foot: NDArray) -> None:
        """Arrows along x and r."""
        for text, tip in (
            ("+x", np.array([CROSS, 0.0])),
            ("r, from the axis of the bearing", np.array([0.0, CROSS])),
        ):
            self.axes.annotate(
                "",
                tuple(foot + tip),
                tuple(foot),
                arrowprops={"arrowstyle": "->", "color": "#0b5394", "lw": 0.8, "shrinkA": 0, "shrinkB": 0},
            )
            self.word(text, foot + tip + [1.4, 0], ha="left", color="#0b5394")

    def bar(self, wide: float, y: float) -> None:
        """A bar that shows a round length, for screens that change the scale."""
        size = max(
            s * 10.0**e for e in range(-3, 4) for s in (1, 2, 5) if s * 10.0**e * self.scale / 1e3 <= 25
        )
        start = wide - MARGIN - size * self.scale / 1e3
        self.leader([(start, y), (wide - MARGIN, y)], color=ENGRAVED, lw=1.6)
        self.word(f"{size:g} mm", ((start + wide - MARGIN) / 2, y - 0.6), va="top")


def width_of(text: str) -> float:
    """Width of a text [mm]."""
    from matplotlib.font_manager import findfont, get_font

    font = get_font(findfont("DejaVu Sans"))
    font.set_size(TEXT, 72)
    with boxes_for_glyphs():
        font.set_text(printable(text))
    return font.get_width_height()[0] / 64 * POINT  # in 64ths of a point
