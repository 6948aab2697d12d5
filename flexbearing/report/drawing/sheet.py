"""A sheet with a drawing to scale: the part in metres, the page in millimetres."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.page import (
    CROSS,
    DPI,
    ENGRAVED,
    INCH,
    LEADER,
    LINE,
    MARGIN,
    ROW,
    TRACK,
    Page,
    width_of,
)
from flexbearing.report.drawing.words import MARKS, SCHEMATIC, Words

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEPS = (10, 8, 6, 5, 4, 3, 2.5, 2, 1.5)
SCALES = (
    *(step * ten for ten in (10, 1) for step in STEPS),
    1,
    *(1 / (step * ten) for ten in (1, 10, 100) for step in STEPS[::-1]),
)
ROOM = (95.0, 95.0)  # [mm] of the part on the page, at most
FONT: Any = {"svg.fonttype": "none", "font.family": "DejaVu Sans", "path.simplify": False}


@dataclass(frozen=True)
class Drawing:
    """A drawing as a report or a file takes it."""

    name: str  # of its file, "section"
    caption: str
    alternative: str  # text for those who cannot see it
    figure: Figure  # of the size of the paper

    @cached_property
    def svg(self) -> str:
        """SVG that begins with "<svg", in the size of the paper."""
        return svg_text(self.figure, self.name, self.alternative)

    def content(self, form: str) -> bytes:
        """Content of a file: "svg", "png" or "pdf"; the same bytes on every run."""
        if form == "svg":
            return self.svg.encode()
        from io import BytesIO

        from matplotlib import rc_context

        file = BytesIO()
        with rc_context(FONT):
            self.figure.savefig(
                file, format=form, dpi=DPI, metadata={"CreationDate": None} if form == "pdf" else None
            )
        return file.getvalue()


@dataclass
class Sheet:
    """Shapes of a part in metres, and the labels of its dimensions; the page follows from both."""

    name: str
    words: Words
    shapes: list[tuple[str, NDArray, dict[str, Any]]] = field(default_factory=list)
    beside: list[tuple[str, tuple[float, float]]] = field(default_factory=list)  # labels on the right
    radial: list[tuple[str, float, float, float]] = field(default_factory=list)  # on the left
    axial: list[tuple[str, float, float, float]] = field(default_factory=list)  # below
    placed: list[tuple[str, tuple[float, float], dict[str, Any]]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    cross: bool = False  # whether a cross says that x is to the right and r upwards
    to_scale: bool = True

    def area(self, points: Any, name: str = "", **style: Any) -> None:
        """Draw a closed outline through points (n, 2) [m]."""
        given = {"fc": "none", "ec": ENGRAVED, "lw": 0.8} | style
        self.shapes.append((name, np.array(points, dtype=float), given | {"closed": True}))

    def rectangle(self, x: tuple[float, float], y: tuple[float, float], name: str = "", **style: Any) -> None:
        """Draw a rectangle between two places each [m]."""
        self.area([(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])], name, **style)

    def line(self, points: Any, name: str = "", **style: Any) -> None:
        """Draw lines from point to point (n, 2) [m]; of other ends with `arrowstyle`."""
        given = {"fc": "none", "ec": ENGRAVED, "lw": 0.8} | style
        self.shapes.append((name, np.array(points, dtype=float), given | {"closed": False}))

    def circle(self, radius: float, centre: tuple[float, float] = (0.0, 0.0), name: str = "", *,
               points: int = 0, **style: Any):  # fmt: skip
        """Draw a circle [m]."""
        points = points or (181 if centre == (0.0, 0.0) else 61)
        self.area(np.array(centre) + arc(radius, 0, 2 * np.pi, points), name, **style)

    def held(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Mark an edge between two places [m] that does not move; the ground is on its left-hand side."""
        self.shapes.append(("", np.array([start, end]), {"ground": True}))

    def label(self, path: str, point: tuple[float, float], sign: str = "") -> None:
        """Write a key and its value on the right, with a leader to a point [m]; nothing if not given."""
        if self.words.value(path) not in (None, ()):
            self.beside.append((self.words(path, sign), point))

    def height(self, path: str, low: float, high: float, x: float) -> None:
        """Dimension a key between two radii [m] that are seen at x; nothing if it is not given."""
        if self.words.value(path) is not None:
            self.radial.append((self.words(path), min(low, high), max(low, high), x))

    def length(self, path: str, left: float, right: float, y: float) -> None:
        """Dimension a key between two axial places [m] that are seen at y; nothing if it is not given."""
        if self.words.value(path) is not None:
            self.axial.append((self.words(path), min(left, right), max(left, right), y))

    def word(self, text: str, point: tuple[float, float], **style: Any) -> None:
        """Write a text at a point [m]."""
        self.placed.append((text, point, style))

    @property
    def is_schematic(self) -> bool:
        """Whether there are shapes without dimensions."""
        return any(style.get("ls") == SCHEMATIC["ls"] for _, _, style in self.shapes)

    @property
    def box(self) -> tuple[NDArray, NDArray]:
        """Smallest and largest coordinates of the shapes [m]."""
        points = np.concatenate([points for _, points, _ in self.shapes])
        return points.min(axis=0), points.max(axis=0)

    @property
    def scale(self) -> float:
        """Length on the page over that of the part: the largest usual one for which there is room."""
        size = 1e3 * (self.box[1] - self.box[0])
        return next(s for s in (*SCALES, ROOM[0] / size.max()) if (s * size <= ROOM).all())

    def drawn(self, caption: str, alternative: str) -> Drawing:
        """The sheet, laid out."""
        return Drawing(self.name, caption, alternative, self.figure())

    @property
    def _legend(self) -> str:
        """What the marks mean that labels of this sheet have."""
        texts = [text for text, *_ in (*self.beside, *self.radial, *self.axial)]
        return ", ".join(
            f"{mark} {word}" for mark, word in MARKS.items() if any(text.endswith(mark) for text in texts)
        )

    def _identifiers(self) -> Iterator[str | None]:
        """Names of the shapes in the drawing, each once: a part may be on both sides."""
        drawn: Counter[str] = Counter()
        for name, _, _ in self.shapes:
            drawn[name] += 1
            number = f"-{drawn[name]}" if drawn[name] > 1 else ""
            yield f"{self.name}-{name}{number}" if name else None

    def figure(self) -> Figure:
        """Lay the page out: labels left and right, rows of lengths below, then notes."""
        from matplotlib.figure import Figure

        low, high = self.box
        scale, size = 1e3 * self.scale, 1e3 * self.scale * (high - low)
        beside = max((width_of(text) for text, *_ in self.axial), default=0.0)  # of lengths, left of the part
        left = max(self._left_width(), 2 * MARGIN + beside)
        right = LEADER + MARGIN + max((width_of(text) for text, _ in self.beside), default=0.0)
        scaled = "" if self.words.names else f"scale {_ratio(self.scale)}"
        scaled = scaled if self.to_scale else "not to scale"
        notes = [*self.notes, *filter(None, ["; ".join(filter(None, (scaled, self._legend)))])]
        wide = max(left + size[0] + right, MARGIN + max(map(width_of, notes)))
        above, under = self._overhang(scale, low[1], size[1])
        rows = max(under, ROW * (len(self.axial) + 0.5)) + (CROSS + MARGIN if self.cross else 0.0)
        below = rows + LINE * len(notes) + MARGIN
        tall = size[1] + above + below + 2 * MARGIN
        figure = Figure(figsize=(wide / INCH, tall / INCH))
        axes = figure.add_axes((0, 0, 1, 1), xlim=(0, wide), ylim=(0, tall))
        axes.set_axis_off()
        page = Page(axes, scale, np.array([left, below + MARGIN]) - scale * low)
        for (_, points, style), name in zip(self.shapes, self._identifiers(), strict=True):
            page.shape(name, points, style)
        base = page.at(low)[1]
        self._label_beside(page, page.at(high)[0])
        self._label_heights(page, left)
        for row, (text, start, end, y) in enumerate(sorted(self.axial, key=lambda item: item[2] - item[1])):
            page.length(text, (start, end), y, base - (MARGIN + ROW * (row + 0.7)), page.at(low)[0])
        for text, point, style in self.placed:
            page.word(text, page.at(point), **style)
        for row, text in enumerate(reversed(notes)):
            page.word(text, (MARGIN, MARGIN / 2 + row * LINE), ha="left", va="bottom", color=ENGRAVED)
        if self.to_scale:
            page.bar(wide, MARGIN)
        if self.cross:
            page.cross(np.array([2 * MARGIN, LINE * len(notes) + 2 * MARGIN]))
        return figure

    def _overhang(self, scale: float, low: float, tall: float) -> tuple[float, float]:
        """How far columns of labels reach above and below the part [mm]."""
        columns = [y for _, (_, y) in self.beside], [(a + b) / 2 for _, a, b, _ in self.radial]
        places = [y for each in columns for y in spread([scale * (y - low) for y in sorted(each)[::-1]])]
        above = max((y - tall for y in places), default=0.0)
        below = max((-y for y in places), default=0.0)
        return max(above, 0.0), max(below, 0.0)

    def _left_width(self) -> float:
        """Width of labels and tracks on the left [mm]."""
        if not self.radial:
            return 3 * MARGIN
        return (
            2 * MARGIN + LEADER + max(width_of(text) for text, *_ in self.radial) + TRACK * len(self.radial)
        )

    def _label_beside(self, page: Page, edge: float) -> None:
        """Write the labels on the right, so that no leaders cross: in sum they are shortest."""
        from scipy.optimize import linear_sum_assignment

        texts, points = [text for text, _ in self.beside], [page.at(point) for _, point in self.beside]
        lines = np.array(spread(sorted((point[1] for point in points), reverse=True)))
        apart = [np.hypot(edge + 2 - point[0], lines - point[1]) for point in points]
        chosen = linear_sum_assignment(apart)[1] if points else []
        for text, point, y in zip(texts, points, lines[chosen] if points else [], strict=True):
            page.leader([point, (edge + 2, y), (edge + LEADER - 1, y)], dot=True)
            page.word(text, (edge + LEADER, y), ha="left")

    def _label_heights(self, page: Page, edge: float) -> None:
        """Dimension radial distances on the left, the shortest next to the part."""
        order = sorted(self.radial, key=lambda item: item[2] - item[1])
        tracks = {id(item): edge - MARGIN - TRACK * number for number, item in enumerate(order)}
        column = edge - MARGIN - TRACK * len(order) - LEADER + 2
        downwards = sorted(order, key=lambda item: -(item[1] + item[2]))
        middles = [page.at((0, (item[1] + item[2]) / 2))[1] for item in downwards]
        for item, middle, y in zip(downwards, middles, spread(middles), strict=True):
            text, low, high, x = item
            track = tracks[id(item)]
            ends = [(track, page.at((0, r))[1]) for r in (low, high)]
            for r, end in zip((low, high), ends, strict=True):
                page.leader([page.at((x, r)), (track - 1, end[1])])
            page.dim(*ends)
            page.leader([(track, middle), (column + 1, y)])
            page.word(text, (column, y), ha="right")


def arc(radius: float, start: float, end: float, points: int = 181) -> NDArray:
    """Points (n, 2) of an arc about the origin; angles from the second coordinate towards the first [rad]."""
    angle = np.linspace(start, end, points)
    return radius * np.stack([np.sin(angle), np.cos(angle)], axis=1)


def spread(wanted: list[float]) -> list[float]:
    """Places nearest to those wanted, falling, that leave room for a line of text each [mm]."""
    from scipy.optimize import isotonic_regression

    if not wanted:
        return []
    steps = -LINE * np.arange(len(wanted))
    return list(isotonic_regression(np.array(wanted) - steps, increasing=False).x + steps)


def svg_text(figure: Figure, name: str, alternative: str) -> str:
    """Write a figure as SVG that is the same on every run, and that a page can hold beside others."""
    from html import escape
    from io import StringIO

    from matplotlib import rc_context

    file = StringIO()
    with rc_context(FONT | {"svg.hashsalt": name}):
        figure.savefig(
            file, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None}
        )
    text = file.getvalue()
    text = re.sub(
        r"\s*<style.*?</style>|\s*<metadata>.*?</metadata>|<!--.*?-->",
        "",
        text[text.index("<svg") :],
        flags=re.S,
    )
    text = re.sub(r' id="[a-z0-9]+_\d+"', "", text)  # which other drawings on the page would have, too
    role = f'<svg role="img" aria-label="{escape(alternative)}" stroke-linejoin="round"'
    return text.replace("<svg", role, 1)


def _ratio(scale: float) -> str:
    return f"{scale:g} : 1" if scale >= 1 else f"1 : {1 / scale:.4g}"
