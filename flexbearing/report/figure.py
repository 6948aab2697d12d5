"""A figure as data, in units of its axes: a page draws it by Plotly, a picture by Matplotlib."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

# Okabe and Ito (2008): distinguished by colour-blind readers; dashes and marks distinguish lines in grey
BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#D55E00", "#007a5a", "#8a3f7c"
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, "#56B4E9", "#E69F00", "#4a535d")
DARK, GREY, PALE, LIGHT = "#4a535d", "#8a939d", "#c0c4cc", "#66aad1"

WIDE = 100  # highest over lowest value of a logarithmic scale
BAND = 0.18  # opacity of a band
ROUNDING = 1e-9  # in units of an axis: where nothing is larger it ends at one, and not at digits of rounding

Value = float | str | None  # a number, a category, or nothing, which leaves a gap
Values = Sequence[Value]


@dataclass(frozen=True)
class Axis:
    """An axis with its label and unit."""

    label: str = ""
    scale: str = "linear"  # "log", "category"
    ends: tuple[float, float] | None = None
    step: float | None = None  # between ticks
    ticks: tuple[float, ...] = ()
    from_zero: bool = False
    decades: bool = False  # numbers that a page writes as powers of ten
    falling: bool = False  # the least value is at the far end


@dataclass(frozen=True)
class Line:
    """Points in their order."""

    x: Values
    y: Values
    name: str = ""  # in the legend
    colour: str = BLUE
    dash: str = "solid"  # "dash", "dot"; empty: points alone
    mark: str = "circle"  # form of the points; empty: none
    size: float = 5.0
    width: float = 1.5
    group: str = ""  # lines that a click on one of their names hides
    places: tuple[int, ...] = ()  # of the points in the array or table that they come from
    words: tuple[str, ...] = ()  # of each point
    hover: str = ""  # Plotly's template
    of: str = ""  # place of the numbers in the file


@dataclass(frozen=True)
class Bars:
    """Bars from zero, level ones where y has the categories."""

    x: Values
    y: Values
    name: str = ""
    colour: str = BLUE
    level: bool = False
    thickness: float = 0.8  # in units of the axis
    errors: tuple[Sequence[float], Sequence[float]] | None = None  # below and above the ends
    places: tuple[int, ...] = ()
    hover: str = ""
    of: str = ""


@dataclass(frozen=True)
class Contour:
    """Where a map has a value."""

    value: float
    colour: str
    width: float


@dataclass(frozen=True)
class Map:
    """Values over x and y in colours."""

    x: Sequence[float]
    y: Sequence[float]
    z: Sequence[Sequence[float | None]]  # row by row of y
    label: str = ""  # of the colours
    ends: tuple[float, float] | None = None
    colours: str = "viridis"
    logarithmic: bool = False  # colours of a picture
    contours: tuple[Contour, ...] = ()
    places: tuple[int, ...] = ()
    hover: str = ""
    of: str = ""


@dataclass(frozen=True)
class Rule:
    """A line or a band across a figure at a place of x, or at a level of y."""

    at: float
    word: str = ""  # beside it
    to: float | None = None  # end of a band
    name: str = ""
    level: bool = False
    colour: str = DARK
    dash: str = "solid"
    width: float = 1.0


Item = Line | Bars | Map | Rule


@dataclass(frozen=True)
class Figure:
    """What is drawn over two axes."""

    kind: ClassVar = "figure"
    name: str  # of its element in a page
    title: str  # what is drawn
    x: Axis
    y: Axis
    items: tuple[Item, ...]
    equal: bool = False  # one scale for both axes
    tall: bool = False  # room for a long legend

    def __post_init__(self):
        values = [y for line in self.lines for y in line.y if isinstance(y, float)]
        only_lines = len(self.lines) == sum(not isinstance(item, Rule) for item in self.items)
        if only_lines and self.y == Axis(self.y.label) and max(map(abs, values), default=1.0) < ROUNDING:
            object.__setattr__(self, "y", Axis(self.y.label, ends=(-1.0, 1.0)))

    @property
    def lines(self) -> tuple[Line, ...]:
        """Its lines."""
        return tuple(item for item in self.items if isinstance(item, Line))


def stairs(edges: Iterable[float], values: Iterable[float]) -> tuple[list[float], list[float]]:
    """Points of a line that is level between edges.

    >>> stairs([0.0, 1.0, 2.0], [5.0, 7.0])
    ([0.0, 1.0, 1.0, 2.0], [5.0, 5.0, 7.0, 7.0])
    """
    x = [place for pair in pairwise(edges) for place in pair]
    return list(map(float, x)), [float(value) for value in values for _ in range(2)]


def is_wide(values: NDArray) -> bool:
    """Whether values above zero span more than two decades, so that a logarithmic scale shows them."""
    known = values[np.isfinite(values)]
    return bool(known.size and known.min() > 0 and known.max() > WIDE * known.min())
