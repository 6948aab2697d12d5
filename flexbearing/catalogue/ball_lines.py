"""The lines of a case of a ball bearing: deep groove, angular contact or four points."""

from collections.abc import Iterator
from math import pi

from flexbearing.catalogue.ball_set import USUAL_CONFORMITY, BallSet
from flexbearing.catalogue.lines import (
    CHOSEN,
    RATED,
    THUMB,
    Line,
    assumed,
    entry,
    from_rating,
    life,
    mm,
    mounting,
    oil,
    speeds,
    surroundings,
    usual_number,
)
from flexbearing.catalogue.page import Page

DEGREE = pi / 180
FOUR_POINTS = 35 * DEGREE  # usual contact angle


def angle(page: Page) -> float:
    """Nominal contact angle of a page [rad]."""
    if page.like == "deep_groove_ball":
        return 0.0
    return page["angle"].si if "angle" in page else FOUR_POINTS


def lines(page: Page, balls: BallSet) -> list[Line]:
    """Lines of a case."""
    slow = page.like == "four_point_ball"
    parts = (
        _bearing(page, balls),
        _contact_angle(page),
        () if slow else mounting(page),
        _material(page),
        () if slow else [*surroundings(page), *oil(page)],
        _slow(page) if slow else _fast(page),
        _load(page),
        () if slow else _held(),
        [assumed("friction.coefficient", 0.1, THUMB)],
        () if slow else life(page),
    )
    return [Line("kind", page.like), *(line for part in parts for line in part)]


def _bearing(page: Page, balls: BallSet) -> Iterator[Line]:
    yield from _balls(page, balls)
    yield assumed("bearing.pitch_diameter", mm(balls.pitch), "(d + D)/2")
    for race, conformity in zip(("inner", "outer"), USUAL_CONFORMITY, strict=True):
        why = "the widest groove whose ratings ISO 281 and ISO 76 do not reduce"
        yield assumed(f"bearing.{race}.conformity", conformity, why)


def _balls(page: Page, balls: BallSet) -> Iterator[Line]:
    """Number and diameter of the balls; where assumed, a pair that has C_0 of the maker."""
    rated, counted, measured = (name in page for name in ("static_rating", "elements", "diameter"))
    number, diameter = balls.chosen
    if counted:
        yield Line("bearing.balls", number)
    else:
        usual = "in a usual arc of filling" if page.like == "deep_groove_ball" else "at a usual spacing"
        why = f"nearest to {RATED}" if rated and measured else usual_number(balls, usual, "diameter", rated)
        yield assumed("bearing.balls", number, why)
    if measured:
        yield Line("bearing.ball.diameter", page["diameter"].text)
    else:
        why = from_rating(page, balls) if rated else f"{THUMB}, the middle of 0.56 to 0.67 (D - d)/2"
        yield assumed("bearing.ball.diameter", mm(diameter), why)


def _contact_angle(page: Page) -> Iterator[Line]:
    if "angle" in page:
        yield entry(page, "angle", "bearing.contact_angle")
    elif page.like == "four_point_ball":
        why = "usual of four-point bearings"
        yield assumed("bearing.contact_angle", "35 deg", why)


def _material(page: Page) -> Iterator[Line]:
    usual = "the usual bearing steel"
    if not {"balls", "material"} & {*page.values}:
        yield assumed("materials.ball", "100Cr6", f"{usual}, of balls and rings")
        return
    yield Line("materials.ball", page["balls" if "balls" in page else "material"].text)
    for ring in ("inner_ring", "outer_ring"):
        if "material" in page:
            yield Line(f"materials.{ring}", page["material"].text)
        else:
            yield assumed(f"materials.{ring}", "100Cr6", usual)


def _load(page: Page) -> Iterator[Line]:
    for key, name in (("axial", "axial"), ("radial_z", "load")):
        if name in page:
            yield entry(page, name, f"operation.load.{key}", CHOSEN)


def _fast(page: Page) -> Iterator[Line]:
    yield from speeds(page)
    yield assumed("operation.control", "outer", "usual of fast bearings")


def _held() -> Iterator[Line]:
    """A ring that the shaft keeps straight."""
    tilts = [f"operation.displacement.tilt_{axis}" for axis in "yz"]
    for key in tilts:
        yield assumed(key, "0 deg", "a stiff shaft keeps the inner ring straight")


def _slow(page: Page) -> Iterator[Line]:
    why = "torque does not depend on it, power is in proportion"
    yield entry(page, "speed", "operation.speed", why)
    yield assumed("bearing.clearance", "0 um", f"{THUMB}, along a diagonal")
