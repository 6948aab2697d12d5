"""Which drawings a case has, by the family of its bearing."""

from collections.abc import Iterator
from typing import Any

from flexbearing.report.drawing import along_axis, ball_section, roller_section, squirrel_cage
from flexbearing.report.drawing.sheet import Drawing
from flexbearing.report.drawing.words import Words


def of_rollers(case: Any) -> Iterator[Drawing]:
    """Section, view along the axis, and the bars of a squirrel cage."""
    words = Words(case)
    yield roller_section.section(words)
    yield along_axis.rollers(words)
    if case.outer.kind == "squirrel_cage":
        yield squirrel_cage.bars(words)


def of_fast_balls(case: Any) -> Iterator[Drawing]:
    """Section and view along the axis of an angular-contact or deep groove bearing."""
    words = Words(case)
    yield ball_section.one_groove(words)
    yield along_axis.balls(words)


def of_slow_balls(case: Any) -> Iterator[Drawing]:
    """Section of a four-point bearing; the view along the axis where the number of balls is given."""
    words = Words(case)
    yield ball_section.two_arches(words)
    if case.bearing.balls is not None:
        yield along_axis.balls(words)
