"""How many balls of what size a bearing has: no catalogue says, but its static rating bounds them.

C_0 of ISO 76 holds the product Z D_w^2, so one follows from the other.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import asin, floor, pi, sin
from typing import cast

from flexbearing.case import BadCase
from flexbearing.case.balls.mounting import MountedMaterials
from flexbearing.catalogue.element_set import ElementSet, Pair, Ratings, chosen, near, span
from flexbearing.catalogue.page import Page
from flexbearing.life.ball_lives import rated_material
from quasidynamic.outcome.ball_capacity import (
    RATED_STEEL,
    ball_dynamic_rating,
    ball_fatigue_load_limit,
    ball_static_rating,
)
from quasidynamic.parts.ball import BallRow
from quasidynamic.parts.material import Material

# Rules of thumb, assumed. Balls over half the difference of the diameters: Harris' 209 and 218 have 0.64, the
# 6205 of the Case Western Reserve University 0.61, the QJ309 of Joshi et al. (2015) 0.66, the 7008 of Rivera
# et al. (2021) 0.57. Filling: 180 deg of the 209, 188 deg of the 6205. Distance over diameter: 1.10 of the
# 218, 1.23 of the QJ309, 1.18 of the 7008; C_0 of a 7208 BE of SKF needs less than 1.09.
SHARE = (0.56, 0.67)  # ball diameter over (D - d)/2
FILLING = (178.0, 197.0)  # [deg] arc that touching balls of a deep groove bearing fill, first to last centre
SPACING = (1.04, 1.25)  # distance of ball centres over the ball diameter, of the other kinds
Rated = Callable[[int, float], Ratings]  # of a number and a size
MOST = 200  # balls that are thought of
USUAL_CONFORMITY = (0.52, 0.53)  # of the inner and the outer groove, ISO 281 and ISO 76


@dataclass(frozen=True, kw_only=True)
class BallSet(ElementSet):
    """The balls of a bearing; their size is the diameter."""

    pitch: float  # [m] diameter of the circle of the ball centres


def ball_set(page: Page, angle: float) -> BallSet:
    """Balls of a page.

    Of the plausible pairs of number and diameter that have the static rating, that of most balls is taken, as
    makers fill bearings; without a static rating the middle of all.

    Raises `BadCase` where the balls do not fit in, or none that is plausible has the static rating.
    """
    pitch, half = (page["bore"].si + page["outside"].si) / 2, (page["outside"].si - page["bore"].si) / 2
    _require_room(page, pitch, half)
    ends, own = _ends(page, pitch, half), rated_material(_materials(page))
    rated = _as_the_maker(page, [partial(_ratings, pitch, angle, ball) for ball in (own, RATED_STEEL)], ends)
    pairs = _pairs(page, rated, ends)
    chosen_pair = chosen(pairs, "static_rating" in page)
    return BallSet(
        chosen=chosen_pair,
        pairs=tuple(pairs),
        plausible=tuple((number, size) for number, sizes in ends.items() for size in sizes),
        rated=rated,
        about="" if own is RATED_STEEL else _about(rated, partial(_ratings, pitch, angle, own), chosen_pair),
        pitch=pitch,
    )


def _as_the_maker(page: Page, each: list[Rated], ends: dict[int, tuple[float, float]]) -> Rated:
    """Ratings by the balls of the case or by steel ones, whichever C_0 of the page is closer to.

    Some makers print the C_0 of hybrids for the pressure of ISO 76, others that of steel balls.
    """
    if "static_rating" not in page:
        return each[0]

    def apart(rated: Rated) -> float:
        static = [rated(number, size).static for number, sizes in ends.items() for size in sizes]
        return max(min(static) / page["static_rating"].si, page["static_rating"].si / max(static), 1.0)

    return min(each, key=apart)


def _about(rated: Rated, own: Rated, pair: Pair) -> str:
    """What the static rating of hybrids is of."""
    ratio = own(*pair).static / rated(*pair).static
    if ratio == 1:
        return "C_0 and C_u by formula: for the pressure of ISO 76 at these balls."
    return (
        "C_0 and C_u by formula: with steel balls, to which the maker's C_0 is closer; the pressure of ISO 76"
        f" at these balls gives {ratio:.2f} times that."
    )


def plausible_ratios(number: int, like: str) -> tuple[float, float]:
    """Diameters over that of the pitch circle with which so many balls fill a bearing."""
    if like == "deep_groove_ball":
        least, most = (sin(arc * pi / 180 / (2 * (number - 1))) for arc in FILLING)
    else:
        most, least = (sin(pi / number) / distance for distance in SPACING)
    return least, most


def _ends(page: Page, pitch: float, half: float) -> dict[int, tuple[float, float]]:
    """Plausible numbers of balls, each with the smallest and the largest plausible diameter [m]."""
    least, most = (page["diameter"].si,) * 2 if "diameter" in page else (part * half for part in SHARE)
    if "elements" in page:
        number = int(page["elements"].si)
        return {number: (least, min(most, pitch * sin(pi / number)))}
    every = {number: plausible_ratios(number, page.like) for number in range(3, MOST)}
    ends = {
        number: (max(least, low * pitch), min(most, high * pitch)) for number, (low, high) in every.items()
    }
    if plausible := {number: (low, high) for number, (low, high) in ends.items() if low <= high}:
        return plausible
    fullest = max(number for number, (_, high) in every.items() if most <= high * pitch)
    return {fullest: (least, most)}


def _pairs(page: Page, rated: Rated, ends: dict[int, tuple[float, float]]) -> list[Pair]:
    """Pairs that have the maker's static rating; without one, or where both are known, every number."""
    if "static_rating" not in page or ("elements" in page and "diameter" in page):
        return [(number, (low + high) / 2) for number, (low, high) in ends.items()]
    wanted = page["static_rating"].si
    if "diameter" in page:
        nearest = min(ends, key=lambda number: abs(rated(number, page["diameter"].si).static - wanted))
        return [(nearest, page["diameter"].si)]
    from scipy.optimize import brentq  # takes longer to load than what is refused before

    spans = {number: [rated(number, size).static for size in sizes] for number, sizes in ends.items()}
    pairs = [
        (number, cast(float, brentq(partial(_beyond, rated, number, wanted), *ends[number])))
        for number, (low, high) in spans.items()
        if low <= wanted <= high
    ]
    if pairs:
        return pairs
    if found := near([(number, size) for number, of in ends.items() for size in of], rated, wanted):
        return found
    unit, force = page["bore"].with_unit_of_this, page["static_rating"].with_unit_of_this
    static, sizes = [each for span in spans.values() for each in span], [*ends.values()]
    raise BadCase(
        f"{page.option('static_rating')}: {span(min(ends), max(ends))} balls of {unit(min(sizes)[0])} to "
        f"{unit(max(high for _, high in sizes))} have {force(min(static))} to {force(max(static))} by "
        "ISO 76; where it is right all the same, give --elements and --diameter."
    )


def _beyond(rated: Rated, number: int, wanted: float, size: float) -> float:
    """Static rating of balls of a size over the one that is wanted [N]."""
    return rated(number, size).static - wanted


def _require_room(page: Page, pitch: float, half: float) -> None:
    """Raise unless the balls go between the rings and round the pitch circle."""
    unit = page["bore"].with_unit_of_this
    if half <= 0:
        raise BadCase(f"{page.option('bore')} must be below {page.option('outside')}.")
    diameter = page["diameter"].si if "diameter" in page else SHARE[0] * half
    if diameter >= min(half, page["width"].si):
        raise BadCase(
            f"{_size(page)}: balls must be smaller than half of D - d, {unit(half)}, and than B, "
            f"{page['width'].text}."
        )
    most = floor(pi / asin(diameter / pitch))
    if "elements" in page and not 3 <= page["elements"].si <= most:
        small = "" if "diameter" in page else ", which is small for this bearing,"
        raise BadCase(
            f"{page.option('elements')}: 3 to {most} balls of {unit(diameter)}{small} fit round the circle "
            f"of {unit(pitch)}."
        )


def _size(page: Page) -> str:
    """Option that says how large balls must be."""
    return page.option("diameter" if "diameter" in page else "width")


def _materials(page: Page) -> MountedMaterials:
    """Materials of balls and rings, 100Cr6 where they are not given."""
    rings = page["material"].text if "material" in page else "100Cr6"
    ball = page["balls"].text if "balls" in page else rings
    return MountedMaterials.model_validate({"ball": ball, "inner_ring": rings, "outer_ring": rings})


def _ratings(pitch: float, angle: float, material: Material, balls: int, diameter: float) -> Ratings:
    inner, outer = USUAL_CONFORMITY
    row = BallRow(
        balls=balls,
        ball_diameter=diameter,
        pitch_diameter=pitch,
        contact_angle=angle,
        inner_conformity=inner,
        outer_conformity=outer,
    )
    static = ball_static_rating(row, material)
    return Ratings(ball_dynamic_rating(row), static, ball_fatigue_load_limit(row, static))
