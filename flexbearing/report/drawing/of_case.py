"""Which drawings a case has, by the family of its bearing."""

from collections.abc import Callable, Iterator
from typing import Any

from flexbearing.case.family import Family
from flexbearing.report.drawing import (
    along_axis,
    ball_section,
    cage_pocket,
    profiles,
    roller_section,
    spherical_section,
    tapered_section,
    thrust_section,
)
from flexbearing.report.drawing.sheet import Drawing
from flexbearing.report.drawing.words import Words


def drawings(
    family: Family, case: Any, *, values: bool = True, names: Callable[[str], str] | None = None
) -> Iterator[Drawing]:
    """Drawings of a case to scale.

    Raises `BadCase` where points of a profile cannot be read or are none of its roller.
    """
    draw, profiles_of = family.report().drawings(), family.profiles
    yield from draw(Words(case, values, profiles_of() if profiles_of else None, names))


def of_rollers(words: Words) -> Iterator[Drawing]:
    """Section, view along the axis, bars of a squirrel cage, profiles, cage with pocket and land."""
    yield roller_section.section(words)
    yield along_axis.rollers(words)
    if words.case.outer.kind == "squirrel_cage":
        yield along_axis.bars(words, words.case.bearing.outer_raceway_diameter / 2)
    yield from _profiles(words)
    if words.case.bearing.cage.thickness:
        yield cage_pocket.cage(words)


def of_tapered_rollers(words: Words) -> Iterator[Drawing]:
    """Section, view along the axis, profiles."""
    yield tapered_section.section(words)
    yield along_axis.tapered_rollers(words)
    yield from _profiles(words)


def of_thrust_rollers(words: Words) -> Iterator[Drawing]:
    """The same of a thrust bearing."""
    yield thrust_section.section(words)
    yield along_axis.thrust_rollers(words)
    yield from _profiles(words)


def of_spherical_rollers(words: Words) -> Iterator[Drawing]:
    """Section and view along the axis."""
    yield spherical_section.section(words)
    yield along_axis.tapered_rollers(words)


def _profiles(words: Words) -> Iterator[Drawing]:
    """Profiles that are not straight."""
    if drops := words.profiles and words.profiles(words.case):
        yield profiles.profiles(words, drops)


def of_fast_balls(words: Words) -> Iterator[Drawing]:
    """Section, view along the axis, bars of a squirrel cage of an angular-contact or deep groove bearing."""
    yield ball_section.one_groove(words)
    yield along_axis.balls(words)
    if words.case.outer.kind == "squirrel_cage":
        bearing = words.case.bearing
        yield along_axis.bars(words, bearing.groove_bottom("outer"), bearing.outer.shoulder)


def of_slow_balls(words: Words) -> Iterator[Drawing]:
    """Section of a four-point bearing; the view along the axis where the number of balls is given."""
    yield ball_section.two_arches(words)
    if words.case.bearing.balls is not None:
        yield along_axis.balls(words)
