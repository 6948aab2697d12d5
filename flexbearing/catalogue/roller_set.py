"""How many rollers of what length a bearing has: no catalogue says, but its static rating bounds them.

C_0 of ISO 76 holds the product Z l, so one follows from the other; C of ISO 281 holds Z^(3/4) l^(7/9), nearly
the same product, so both ratings together cannot tell them apart.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from math import asin, floor, pi
from typing import Any

import quasidynamic as qd
from flexbearing.case import BadCase
from flexbearing.catalogue.element_set import ElementSet, Ratings, chosen, near, span
from flexbearing.catalogue.page import Page
from flexbearing.runs.roller_counts import SPACING, plausible_numbers
from quasidynamic.outcome.capacity import dynamic_rating, fatigue_load_limit, static_rating

# Rule of thumb, assumed: Harris' 209 has 0.51, the bearing of Mao, Wang and Zhang 0.5.
SHARE = (0.4, 0.7)  # roller length over the width of the bearing, with ribs and chamfers beside it
MM = 1e-3


@dataclass(frozen=True)
class RollerSet(ElementSet):
    """The rollers of a bearing; their size is the effective length."""

    pitch: float  # [m] diameter of the circle of the roller centres
    diameter: float  # [m] of a roller

    @property
    def outer_raceway(self) -> float:
        """Diameter of the outer raceway of cylindrical rollers [m]."""
        return self.pitch + self.diameter


def roller_set(page: Page) -> RollerSet:
    """Cylindrical rollers of a page.

    Raises `BadCase` where they do not fit in, or none that is plausible has the static rating.
    """
    outer, diameter = _raceway_and_diameter(page)
    pitch = outer - diameter
    return fitting(page, pitch, diameter, partial(_ratings, outer, diameter), SPACING, SHARE)


def fitting(  # noqa: PLR0913  # what the kinds of rollers differ in
    page: Page,
    pitch: float,
    diameter: float,
    rated: Callable[[int, float], Ratings],
    spacing: tuple[float, float],
    share: tuple[float, float],
    room: float | None = None,
) -> RollerSet:
    """Rollers of a diameter on a pitch circle [m], with a usual spacing over it and share of the width.

    Of thrust bearings the `room` [m] is another one.

    Of the plausible pairs of number and length that have the static rating, that of most rollers is taken, as
    makers fill bearings; without a static rating the middle of both ranges.
    """
    room = page["width"].si if room is None else room
    _require_room(page, pitch, diameter, room)
    numbers = plausible_numbers(diameter / pitch, spacing)
    if "elements" in page:
        numbers = [int(page["elements"].si)]
    shortest, longest = (page["length"].si,) * 2 if "length" in page else (part * room for part in share)
    if "static_rating" in page and not ("elements" in page and "length" in page):
        pairs = _of_rating(page, diameter, rated, numbers, (shortest, longest))
    else:
        pairs = [(number, (shortest + longest) / 2) for number in numbers]
    return RollerSet(
        chosen=chosen(pairs, "static_rating" in page),
        pairs=tuple(pairs),
        plausible=((numbers[0], shortest), (numbers[-1], longest)),
        rated=rated,
        pitch=pitch,
        diameter=diameter,
    )


def _raceway_and_diameter(page: Page) -> tuple[float, float]:
    """Diameter of the outer raceway and of the rollers [m], from two of the three that a page may give."""
    inner, outer, diameter = (
        page[name].si if name in page else None for name in ("inner_raceway", "outer_raceway", "diameter")
    )
    if outer is None:
        assert inner is not None
        assert diameter is not None
        outer = inner + 2 * diameter
    if inner is None:
        assert diameter is not None
        inner = outer - 2 * diameter
    unit = page["bore"].with_unit_of_this
    order = {"the bore": page["bore"].si, "F": inner, "E": outer, "the outside diameter": page["outside"].si}
    for (low, least), (high, most) in pairwise(order.items()):
        if least >= most:
            raise BadCase(f"{low} = {unit(least)} must be below {high} = {unit(most)}.")
    half = (outer - inner) / 2
    if diameter is not None and abs(diameter - half) > 0.02 * half:
        raise BadCase(
            f"{page.option('diameter')}: E - F is {unit(outer)} - {unit(inner)}, and half of it {unit(half)}."
        )
    return outer, half if diameter is None else diameter


def _require_room(page: Page, pitch: float, diameter: float, room: float) -> None:
    """Raise unless the rollers go round the pitch circle and into their room."""
    unit = page["bore"].with_unit_of_this
    if diameter >= pitch / 2:
        raise BadCase(f"rollers of {unit(diameter)} do not fit round the circle of {unit(pitch)}.")
    most = floor(pi / asin(diameter / pitch))
    if "elements" in page and not 3 <= page["elements"].si <= most:
        raise BadCase(
            f"{page.option('elements')}: 3 to {most} rollers of {unit(diameter)} fit round the circle of "
            f"{unit(pitch)}."
        )
    if "length" in page and page["length"].si >= room:
        raise BadCase(f"{page.option('length')}: rollers are shorter than the room for them, {unit(room)}.")


def _of_rating(
    page: Page,
    diameter: float,
    rated: Callable[[int, float], Ratings],
    numbers: list[int],
    lengths: tuple[float, float],
) -> list[tuple[int, float]]:
    """Pairs that have the maker's static rating; its formula is linear in the length."""
    shortest, longest = lengths
    rating = page["static_rating"].si
    if "length" in page:
        nearest = min(numbers, key=lambda number: abs(rated(number, longest).static - rating))
        return [(nearest, longest)]
    pairs = [(number, rating / rated(number, MM).static * MM) for number in numbers]
    if plausible := [(number, length) for number, length in pairs if shortest <= length <= longest]:
        return plausible
    corners = [(numbers[0], shortest), (numbers[-1], longest)]
    if found := near(corners, rated, rating):
        return found
    unit, force = page["bore"].with_unit_of_this, page["static_rating"].with_unit_of_this
    low, high = (rated(*corner).static for corner in corners)
    raise BadCase(
        f"{page.option('static_rating')}: {span(numbers[0], numbers[-1])} rollers of {unit(diameter)}, "
        f"{unit(shortest)} to {unit(longest)} long, have {force(low)} to {force(high)} by ISO 76; "
        "where it is right all the same, give --elements and --length."
    )


def _ratings(outer: float, diameter: float, rollers: int, length: float) -> Ratings:
    steel: Any = qd.Material(youngs_modulus=2.1e11, poisson_ratio=0.3, density=7810.0)
    bearing = qd.CylindricalRollerBearing(
        rollers=rollers,
        outer_raceway_diameter=outer,
        clearance=0.0,
        roller=qd.Roller(diameter=diameter, length=length, material=steel, profile=qd.Straight()),
        cage=qd.Cage(guidance="rollers", pocket_friction=0.0, thickness=0.0),
        inner_ring=steel,
        outer_ring=steel,
    )
    return Ratings(dynamic_rating(bearing), static_rating(bearing), fatigue_load_limit(bearing))
