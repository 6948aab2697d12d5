"""How results of one bearing family are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import RenderableType

    from flexbearing.report.balls.contact_fields import DrawnBall


@dataclass(frozen=True)
class FamilyReport:
    """Page and pictures of a result; its summary follows from the quantities of its family."""

    page: Callable[[dict[str, Any]], Iterator[RenderableType]]  # of the summary
    pictures: Callable[[Result], dict[str, Figure]]  # by the names of their files
    deformed: bool = False  # whether deformed rings can be drawn
    balls: Callable[[Result], tuple[DrawnBall, ...]] | None = None  # whose cells a result holds
