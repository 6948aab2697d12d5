"""Values with units are read by a grammar of bounded length and powers."""

from contextlib import suppress
from fractions import Fraction
from math import isfinite, pi

import pytest
from hypothesis import assume, given, settings as examples, strategies as st
from pydantic import TypeAdapter, ValidationError
from pytest import approx

from flexbearing import units
from flexbearing.api import check, read_case
from flexbearing.case import BadCase, quantity
from flexbearing.case.quantity import (
    Angle,
    Force,
    Fraction as Share,
    Length,
    Mass,
    Moment,
    Pressure,
    Speed,
    Stiffness,
    Temperature,
    Viscosity,
)
from tests.flexbearing.hostile_cases import CONFIGS

PAPER = CONFIGS / "mao2016.toml"


def si(kind, text):
    return TypeAdapter(kind).validate_python(text)


def refusal(kind, text):
    with pytest.raises(ValidationError) as problem:
        si(kind, text)
    return problem.value.errors()[0]["msg"]


@pytest.mark.parametrize(
    "text",
    [
        "3000 1/min", "3000/min", "3000 / min", "3000 1/minute", "3000 min^-1", "3000 min⁻¹", "3000 min**-1",
        "3000 r/min", "3000 rev/min", "3000 r min^-1", "3000 turn/min", "3 krpm", "50 r/s", "50 rev/s",
        "18000 deg/s", "3000 RPM", "3000 U/min", "3000 min-1", "3000,0 rpm", "3e3 rpm",
    ],
)  # fmt: skip
def test_turns_a_minute_are_a_speed_however_they_are_written(text):
    assert si(Speed, text) == approx(100 * pi, rel=1e-12)
    assert check(PAPER, [f"operation.inner_speed={text}"]).operation.inner_speed == approx(
        100 * pi, rel=1e-12
    )


POUND = 0.45359237 * 9.80665  # [N], exact


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (Moment, "5 Nm", 5), (Moment, "5 N-m", 5), (Moment, "5 N.m", 5), (Moment, "5000 Nmm", 5),
        (Moment, "0,005 kNm", 5), (Moment, "5 in-lbf", 5 * 0.0254 * POUND),
        (Moment, "5 ft-lb", 5 * 0.3048 * POUND), (Force, "5 daN", 50), (Force, "5 lb", 5 * POUND),
        (Mass, "5 lb", 5 * 0.45359237), (Stiffness, "5 lb/in", 5 * POUND / 0.0254),
        (Pressure, "5 N/mm2", 5e6), (Pressure, "5 lb/in2", 5 * POUND / 0.0254**2),
        (Viscosity, "5 mPa.s", 5e-3),
        (Viscosity, "5 mPas", 5e-3), (Length, "2 mil", 5.08e-5), (Length, "2 thou", 5.08e-5),
        (Length, "3,5 mm", 3.5e-3), (Length, "-0,125 mm", -1.25e-4), (Temperature, "158 °F", 343.15),
        (Angle, "2'", pi / 5400), (Angle, "2''", pi / 324000), (Angle, '2"', pi / 324000),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)  # fmt: skip
def test_units_and_commas_as_people_write_them(kind, text, value):
    assert si(kind, text) == approx(value, rel=1e-14)
    declared = kind.__metadata__[0]
    again = declared.written(si(kind, text), text)  # in the same unit, as reports do
    assert si(kind, again) == approx(value, rel=1e-5)


@pytest.mark.parametrize("text", ["50 1/s", "50 Hz", "50 s^-1", "3000 1/h", "0.05 kHz", "50/s"])
def test_what_may_be_turns_or_radians_is_no_speed(text):
    assert "turns or radians? Write rpm or rad/s" in refusal(Speed, text)
    with pytest.raises(
        BadCase, match=r"\[operation\] inner_speed = .* turns or radians\? Write rpm or rad/s"
    ):
        read_case(PAPER, [f"operation.inner_speed={text}"])


def test_per_minute_is_a_speed_of_rotations_only():
    assert "is not an angle" in refusal(Angle, "3 1/min")


@pytest.mark.parametrize(
    "text",
    [
        "41 um^9^9^9^9", "41 um^5", "41 um^-5", "41 um^999999999999999999999999999", "41 m^1.5", "41 um^",
        "1 ((((((((mm^4)^4)^4)^4)^4)^4)^4)^4", "1 (((%^-4)^4)^4)^4 m", "1 ((((deg/rad)^4)^4)^3) m", "41 ()m",
        "41 m)", "41 " + "(" * 39 + "m", "41 " + "m*" * 30 + "m", "41 m//m", "41 m^^2", "41 ^2", "41 2 m",
    ],
)  # fmt: skip
def test_units_that_no_engineer_writes_are_refused(text):
    assert "has a unit that cannot be read" in refusal(Length, text)


def test_a_value_is_bounded_before_any_pattern_is_tried(monkeypatch):
    monkeypatch.setattr(quantity, "_NUMBER_UNIT", None)
    assert "is longer than 100 characters" in refusal(Length, "5" + " " * 100 + "mm")


def test_the_longest_value_is_read():
    assert si(Length, "5" + " " * 97 + "mm") == approx(5e-3, rel=1e-15)


@pytest.mark.parametrize("number", ["1e999", "-1e999", "1e308", "9" * 60 + "e300"])
def test_numbers_beyond_all_floats_are_refused(number):
    assert "is beyond what numbers can hold" in refusal(Length, f"{number} km")


SPELT = {**units._PLAIN, **{name: found for name, (found, _) in units._PREFIXED.items()}}
NAMES = st.sampled_from(sorted(SPELT))
POWERS = st.integers(-units.HIGHEST, units.HIGHEST)


@st.composite
def products(draw):
    """A product of powers as text, with its factor without pi, powers of the dimensions and power of pi."""
    text, factor, powers, turns = "", Fraction(1), [0] * len(units.DIMENSIONS), 0
    for number in range(draw(st.integers(1, 4))):
        name, power = draw(NAMES), draw(POWERS)
        joint = draw(st.sampled_from(["*", " ", "/", "·", " * ", " / "])) if number else ""
        written = draw(st.sampled_from(["{}^{}", "{}**{}", "({}^{})", "({})^{}"])).format(name, power)
        text += joint + written
        power = -power if "/" in joint else power
        factor *= SPELT[name].factor ** power
        powers = [a + power * b for a, b in zip(powers, SPELT[name].powers, strict=True)]
        turns += power * SPELT[name].pi_power
    assume(len(text) <= units.LONGEST)
    return text, factor, tuple(powers), turns


@examples(max_examples=300)
@given(products())
def test_every_product_of_powers_means_what_is_written(product):
    text, factor, powers, turns = product
    found = units.unit(text)
    assert (found.factor, found.powers, found.pi_power) == (factor, powers, turns)


TOKENS = [
    "m",
    "mm",
    "N",
    "rad",
    "deg",
    "%",
    "1",
    "(",
    ")",
    "^",
    "**",
    "*",
    "/",
    "²",
    "⁻¹",
    "4",
    "-4",
    " ",
    "9",
    "x",
]


@pytest.mark.slow
@examples(max_examples=1000)
@given(
    st.lists(st.sampled_from(TOKENS), max_size=units.LONGEST).map("".join) | st.text(max_size=units.LONGEST)
)
def test_any_text_is_a_unit_of_bounded_size_or_refused(text):
    try:
        found = units.unit(text)
    except (units.UnknownUnit, units.BadUnit):
        return
    assert max(found.factor.numerator, found.factor.denominator) <= units.LARGEST_FACTOR
    assert isfinite(found.to_si(1.0))


@examples(max_examples=500)
@given(
    st.sampled_from([Length, Speed, Temperature, Share, Pressure]),
    st.text(max_size=120)
    | st.tuples(st.floats(), st.lists(st.sampled_from(TOKENS), max_size=20).map("".join)).map(
        lambda parts: f"{parts[0]!r} {parts[1]}"
    ),
)
def test_any_text_is_a_finite_value_or_refused(kind, text):
    with suppress(ValidationError):
        assert isfinite(si(kind, text))
