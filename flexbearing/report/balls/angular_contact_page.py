"""The summary of a fast angular-contact ball bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType

from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.report.balls.sections import ending, of_races, ring, single_values
from flexbearing.report.catalogue_life import against_catalogue
from flexbearing.report.sections import clearance_steps, closing, life_factors, opening, tolerances


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, loads, motion, rolling lines, ring, life, assumed keys, notes, and how the run ended."""
    yield from opening(numbers)
    if block := numbers["rigid"]:
        yield single_values(block, LAYOUT)
        yield of_races(block, LAYOUT)
        yield from ring(block, LAYOUT)
    if clearance := numbers["clearance"]:
        yield from clearance_steps(clearance)
        yield from tolerances(clearance)
    yield from life_factors(numbers["life"] or {})
    yield from against_catalogue(numbers["catalogue_life"])
    yield from closing(numbers, ending(numbers))
