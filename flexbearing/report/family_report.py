"""How results of one bearing family are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from flexbearing.report.plots import Plots
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import RenderableType

    from flexbearing.report.balls.contact_fields import DrawnBall
    from flexbearing.report.drawing import Drawing
    from flexbearing.report.drawing.words import Words


@dataclass(frozen=True)
class Elements:
    """Which quantities of rolling elements a report shows; those that a result lacks are left out."""

    word: str  # "roller"
    azimuth: str  # quantity of their places
    columns: tuple[str, ...]  # of the table with a row for each
    figures: dict[str, tuple[str, ...]]  # over the azimuth: title to quantities of one unit
    contact_figures: dict[str, tuple[str, ...]]  # the same, of films and pressures
    maps: dict[str, tuple[str, str]] = field(default_factory=dict)  # quantities of slices: title, unit


@dataclass(frozen=True)
class FamilyReport:
    """Page and pictures of a result, as an `Entry` each: the card of a result loads neither."""

    page: Callable[[], Callable[[dict[str, Any]], Iterator[RenderableType]]]  # of the summary
    # by names of files; or why one would be empty
    pictures: Callable[[], Callable[[Result], Mapping[str, Figure | str]]]
    elements: Elements | None = None  # rolling elements that a report shows one by one
    deformed: bool = False  # whether deformed rings can be drawn
    balls: Callable[[], Callable[[Result], tuple[DrawnBall, ...]]] | None = None  # whose cells a result holds
    short: Mapping[str, str] = field(default_factory=dict)  # names of pictures in notebooks to those of files
    drawings: Callable[[], Callable[[Words], Iterator[Drawing]]] | None = None  # to scale, of a case

    def plots(self, result: Result) -> Plots:
        """Pictures of a result as functions."""
        return Plots(lambda: self.pictures()(result), self.short)
