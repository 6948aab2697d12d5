"""Contacts of two results beside each other: what one friction model says, and what another."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from flexbearing.case.differing import differing
from flexbearing.report.balls.contact_fields import DrawnBall, friction_of
from flexbearing.report.balls.contact_sheet import (
    PRESSURE,
    SHEAR,
    STICKING,
    Column,
    Group,
    headed,
    sheet,
    titles,
)
from flexbearing.results import BadResult, Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TOLD = ("friction.model", "friction.cells", "fields", "title", "assumed", "calibrated")  # or no matter
SPIN = "friction.spin"
_MOST = 6  # differences that are reported one by one


def compared(one: Result, other: Result) -> dict[int, Figure]:
    """Draw the contacts of two results side by side.

    Raises `BadResult` if they have no cells of the same ball to compare.
    """
    if one.kind != other.kind:
        raise BadResult(
            f"{one.place} is of a {one.kind}, {other.place} of a {other.kind}: there is nothing to compare."
        )
    left, right = (_balls(each) for each in (one, other))
    both = [ball for ball in left if ball in right]
    if not both:
        raise BadResult(
            f"{one.place} holds cells of ball {_listed(left)}, {other.place} of ball {_listed(right)}: "
            "none of the same ball."
        )
    return {ball: _figure(one, other, (left[ball], right[ball])) for ball in both}


def notes(one: Result, other: Result) -> list[str]:
    """Say by what the cases of two results differ besides their friction model and its cells."""
    settings = differing(*(each.attributes["case_si"] for each in (one, other)))
    told_of = {
        key: values
        for key, values in settings.items()
        if not f"{key}.".startswith(tuple(f"{shown}." for shown in _TOLD))
    }
    if not told_of:
        return []
    shown = [f"{key} ({_shown(a)} and {_shown(b)})" for key, (a, b) in list(told_of.items())[:_MOST]]
    more = len(told_of) - len(shown)
    words = ", ".join(shown) + (f" and {more} more" if more else "")
    lines = [f"The cases differ not by their friction model alone, but (in SI units) in {words}."]
    if SPIN in told_of:
        lines.append(
            "Part of the change is that of the spin: one friction.spin for both leaves that of the model."
        )
    return lines


def _figure(one: Result, other: Result, balls: tuple[DrawnBall, DrawnBall]) -> Figure:
    """Contacts of a ball in the columns of both results, below each other."""
    columns = [
        Column(friction_of(result), f"{ball.torque}, {ball.cells}")
        for result, ball in zip((one, other), balls, strict=True)
    ]
    names = dict.fromkeys(name for ball in balls for name in ball.contacts)
    groups: list[Group] = [[titles(name, ball.contacts.get(name)) for ball in balls] for name in names]
    both = dict.fromkeys(result.attributes["title"] for result in (one, other))
    heading = headed(" | ".join(both), f"Contacts of ball {balls[0].number}, two results side by side")
    return sheet(heading, columns, groups, [PRESSURE, SHEAR, STICKING], notes(one, other))


def _balls(result: Result) -> dict[int, DrawnBall]:
    """Balls whose cells a result holds, by their numbers."""
    cells = result.family.report().balls
    if cells is None:
        raise BadResult(f"{result.place}: contacts are compared of ball bearings; it is of a {result.kind}.")
    return {ball.number: ball for ball in cells()(result)}


def _shown(value: Any) -> str:
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_shown, value)) + "]"
    return f"{value:.5g}" if isinstance(value, float) else "none" if value is None else str(value)


def _listed(balls: Mapping[int, Any]) -> str:
    return ", ".join(map(str, balls))
