"""The summary of a fast angular-contact ball bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType

from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.report.balls.sections import ending, of_races, ring, single_values
from flexbearing.report.sections import closing, opening


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, loads, motion, rolling lines, ring, assumed keys, notes, and how the run ended."""
    yield from opening(numbers)
    if block := numbers["rigid"]:
        yield single_values(block, LAYOUT)
        yield of_races(block, LAYOUT)
        yield from ring(block, LAYOUT)
    yield from closing(numbers, ending(numbers))
