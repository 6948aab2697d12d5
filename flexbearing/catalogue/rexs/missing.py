"""Entries that a gearbox model lacks, by rules of thumb: nobody is there to give them."""

from collections.abc import Callable, Iterator, Mapping

from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.page import value

Given = Mapping[str, float]  # entries in SI units
Guess = tuple[str, str, str]  # name, text and reason of an entry

USUAL_LOAD = 0.1  # of C: a bearing of usual life
USUAL_ANGLE = {
    "angular_contact_ball": ("40 deg", "usual of angular contact bearings"),
    "spherical_roller": ("9.1 deg", "usual of series 222; e = 0.24"),
    "tapered_roller": ("14 deg", "usual of tapered roller bearings; e = 0.37"),
}


def filled(
    like: str, options: Mapping[str, str], ratings: Mapping[str, str]
) -> tuple[dict[str, str], dict[str, str]]:
    """Complete the entries of a page; all of them, and of the assumed ones the reasons.

    Load ratings of the model count for a load even where a page of this kind has none.

    Raises `BadCase` for a given entry that cannot be read.
    """
    numbers = (*LIKES[like].needed, "dynamic_rating", "static_rating", "axial", "load")
    texts = {**ratings, **options}
    given = {name: value(name, texts[name], like).si for name in numbers if name in texts}
    found, why = dict(options), dict[str, str]()
    for rule in _RULES:
        for name, text, reason in rule(like, given):
            found[name], why[name] = text, reason
            given[name] = value(name, text, like).si
    return found, why


def _angle(like: str, given: Given) -> Iterator[Guess]:
    if LIKES[like].must_be_given("angle", given):
        yield "angle", *USUAL_ANGLE[like]


def _induced(like: str, given: Given) -> Iterator[Guess]:
    if like == "tapered_roller" and given.get("load") and LIKES[like].must_be_given("axial", given):
        from quasidynamic.outcome.tapered_life import induced_thrust

        words = "the model has none; F_r/(2 Y) is what the radial load induces"
        yield "axial", f"{induced_thrust(given['load'], given['angle']):.4g} N", words


def _loads(like: str, given: Given) -> Iterator[Guess]:
    """A tenth of C, or of C_0 without it, along the direction that the kind needs."""
    ratings = [given[name] for name in ("dynamic_rating", "static_rating") if name in given]
    for name in ("axial", "load"):
        if ratings and LIKES[like].must_be_given(name, given):
            words = f"the model has none; {USUAL_LOAD:g} C gives a usual life"
            yield name, f"{USUAL_LOAD * ratings[0]:.4g} N", words


def _speed(like: str, given: Given) -> Iterator[Guess]:
    if LIKES[like].must_be_given("speed", given):
        yield "speed", "1000 rpm", "the model has none"


_RULES: tuple[Callable[[str, Given], Iterator[Guess]], ...] = (_angle, _induced, _loads, _speed)
