"""What a case file may not say silently, and how it is told."""

import re
import tomllib

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError, create_model
from pytest import approx

from flexbearing import explain
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.case.declarations import declarations
from flexbearing.case.quantity import Angle, Force, Length, Moment, PerTemperature, Speed, Temperature
from flexbearing.families import FAMILIES
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"


def refusal(*settings):
    with pytest.raises(BadCase) as problem:
        read_case(PAPER, settings)
    return str(problem.value)


@pytest.mark.parametrize(
    ("kind", "text", "why"),
    [
        (Speed, "600 Hz", "is not a rotational speed"),  # turns or radians a second? 2 pi between them
        (Speed, "600 1/s", "is not a rotational speed"),
        (Angle, "50 percent", "is not an angle"),
        (Moment, "3 N m/rad", "is not a moment"),  # a stiffness
        (Temperature, "220 delta_degC", "an unknown unit, delta_degC"),  # a difference
        (Length, "5 um^9^9^9", "a unit that cannot be read"),  # would take pages to write out
        (Length, "5 m^5/m^4", "a unit that cannot be read"),
        (Length, "5 (m", "a unit that cannot be read"),
        (Length, "5 furlong", "an unknown unit, furlong"),
        (Temperature, "1.075,5 degC", "a unit that cannot be read, ,5 degC"),
        (Force, "12,000 N", "a comma; did you mean 12.000 or 12000?"),
        (Force, "12 KN", "an unknown unit, KN; did you mean kN?"),
        (Length, "12 MM", "an unknown unit, MM; did you mean mm?"),
        (Temperature, "75.5 )(", "a unit that cannot be read, )("),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_unit_of_something_else_is_refused(kind, text, why):
    with pytest.raises(ValidationError, match="quantity") as problem:
        TypeAdapter(kind).validate_python(text)
    assert why in str(problem.value)


@pytest.mark.parametrize(
    "text", ["11.2e-6 1/K", "11.2e-6 / K", "11.2e-6 1/degC", "11.2 ppm/K", "11.2 um/m/K"]
)
def test_every_way_to_write_an_expansion_is_the_same(text):
    assert TypeAdapter(PerTemperature).validate_python(text) == approx(11.2e-6, rel=1e-12)


@pytest.mark.parametrize(
    "setting",
    [
        "operation.moment=1e999 N m",  # no limits of its own that would catch it
        "operation.moment=inf N m",
        "operation.moment=nan N m",
        "lubricant.oil_fraction=inf",
        "lubricant.oil_fraction=nan",
    ],
)
def test_nothing_infinite_or_undefined_is_a_value(setting):
    assert "it must be" in (message := refusal(setting))
    assert "cannot be" not in message


# A setting of the paper's case, and what its refusal says.
IMPOSSIBLE = {
    "outer ring narrower than a roller": (
        "outer.width=4 mm", "[outer] width", "at least bearing.roller.length",
    ),
    "track narrower than a roller": (
        "inner.track_width=4 mm", "[inner] track_width", "at least bearing.roller.length",
    ),
    "no ribs": ("inner.thickness=2 mm", "[inner] thickness", "more than 2.662 mm"),
    "track wider than the ring": ("inner.track_width=12.1 mm", "[inner] track_width", "at most inner.width"),
    "shaft shorter than the ring": (
        "inner.shaft_length=11 mm", "[inner] shaft_length", "inner.width and 0.3 mm at each end",
    ),
    "shaft thicker than its radius": (
        "inner.shaft_thickness=29.9 mm", "[inner] shaft_thickness", "at most 29.8 mm, half of inner.bore",
    ),
    "clearance in the wrong unit": (
        "bearing.clearance=50 mm", "[bearing] clearance",
        "below 2.5 mm, half of bearing.roller.diameter; is the unit right?",
    ),
    "rollers larger than the raceway": (
        "bearing.roller.diameter=40 mm", "[bearing] outer_raceway_diameter",
        "above 80 mm, twice bearing.roller.diameter.",
    ),
    "cage thicker than a roller": (
        "bearing.cage.thickness=5 mm", "[bearing.cage] thickness", "below 5 mm, bearing.roller.diameter.",
    ),
    "pockets that run into each other": (
        "bearing.cage.pocket_clearance=1.2 mm", "[bearing.cage] pocket_clearance",
        "below 1.165 mm, or no bar",
    ),
    "land clearance in the wrong unit": (
        "bearing.cage.land_clearance=40 mm", "[bearing.cage] land_clearance", "below 5 mm, bearing.roller.",
    ),
    "more shapes than slices": (
        "accuracy.slices=2", "[accuracy] axial_shapes",
        "at most 2, accuracy.slices.",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("setting", "place", "allowed"), IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys())
def test_impossible_geometry_is_refused(setting, place, allowed):
    message = refusal(setting)
    assert place in message
    assert "cannot be; it must be" in message
    assert allowed in message


@pytest.mark.parametrize(
    ("straight", "radius", "place"),
    [("6 mm", "600 mm", "straight_length"), ("4 mm", "2.5 mm", "crown_radius")],
    ids=["straight part longer than the roller", "crown sharper than a ball"],
)
def test_impossible_crown_is_refused(straight, radius, place):
    roller = {"profile": "crowned", "straight_length": straight, "crown_radius": radius}
    with pytest.raises(BadCase, match=rf"\[bearing.roller\] {place} = .* cannot be"):
        read_case(PAPER, {f"bearing.roller.{name}": value for name, value in roller.items()})


@pytest.mark.parametrize(
    ("setting", "limit"),
    [
        ("bearing.roller.diameter=-8 mm", "at least 0.1 mm and at most 10000 mm."),
        ("operation.misalignment=20 deg", "at least -300 arcmin and at most 300 arcmin."),
        ("materials.roller.youngs_modulus=0.1 MPa", "at least 0.001 GPa"),
        ("lubricant.inlet_temperature=0 K", "above -273.15 degC"),
        ("accuracy.slices=1", "at least 2 and at most 1000."),
    ],
)
def test_limits_are_told_in_the_unit_of_the_example(setting, limit):
    assert limit in refusal(setting)


def test_eyring_needs_its_limiting_ratio():
    assert '[lubricant] limiting_ratio is missing: traction = "eyring" needs it' in refusal(
        "lubricant.traction=eyring"
    )


@pytest.mark.parametrize(
    ("moment", "tilt", "free"),
    [("1e-6 N m", "free", True), ("5 N m", "free", True), ("0 N m", "free", True), ("0 N m", "fixed", False)],
)
def test_ring_tilts_where_the_case_says_so_and_by_no_size_of_a_moment(moment, tilt, free):
    case = read_case(PAPER, {"operation.moment": moment, "operation.tilt": tilt})
    assert case.operation.free_tilt is free


def test_tilt_by_the_size_of_the_moment_is_refused_naming_both_choices():
    assert '[operation] tilt = "auto" is not allowed; it must be "fixed" or "free"' in refusal(
        "operation.tilt=auto"
    )


@pytest.mark.parametrize(
    ("rigid", "flexible"),
    [("inner.kind", 'outer.kind = "squirrel_cage"'), ("outer.kind", 'inner.kind = "ring_on_shaft"')],
)
def test_tilt_must_be_given_where_a_ring_is_flexible(tmp_path, rigid, flexible):
    text = re.sub(r"\ntilt = .*", "", PAPER.read_text())
    case = tmp_path / "case.toml"
    case.write_text(text)
    with pytest.raises(
        BadCase, match=f'.operation. tilt is missing: {flexible} needs it; it is "fixed" or "free"'
    ):
        read_case(case, {rigid: "rigid"})
    assert read_case(case, {"inner.kind": "rigid", "outer.kind": "rigid"}).operation.tilt == "fixed"


def test_moment_on_a_held_ring_is_refused_naming_the_key_that_frees_it():
    with pytest.raises(BadCase, match=r'\[operation\] moment = "1 N m" cannot be; .*operation.tilt = "free"'):
        read_case(PAPER.with_name("nu209.toml"), {"operation.moment": "1 N m"})


def test_number_found_is_shown_as_it_stands():
    assert "[bearing] rollers = 30.0 is not allowed; it must be a whole number" in refusal(
        "bearing.rollers=30.0"
    )


def test_every_missing_key_of_a_choice_is_named():
    lines = refusal("bearing.roller.profile=crowned").splitlines()
    assert len(lines) == 2
    assert "[bearing.roller] straight_length is missing" in lines[0]
    assert "[bearing.roller] crown_radius is missing" in lines[1]


def test_shaft_material_is_needed_for_a_shaft(tmp_path):
    text = PAPER.read_text()
    begin, end = text.index("[materials.shaft]"), text.index("[lubricant]")
    file = tmp_path / "broken.toml"
    file.write_text(text[:begin] + text[end:])
    with pytest.raises(BadCase) as problem:
        read_case(file)
    assert '[materials] shaft is missing: inner.kind = "ring_on_shaft" needs it' in str(problem.value)
    assert read_case(file, ["inner.kind=rigid"]).materials.shaft is None


def test_entries_of_lists_and_tables_are_text():
    assert "assumed = [3] is not allowed; it must be a list of keys" in refusal("assumed=[3]")
    assert "calibrated" in (message := refusal("calibrated.lubricant.oil=3"))
    assert "a table of texts" in message


def test_value_has_no_keys_beneath_it():
    assert "title has no keys beneath it" in refusal("title.x=5")


def test_settings_may_be_a_mapping_of_values():
    case = read_case(
        PAPER, {"bearing.clearance": "50 um", "outer.bars": 18, "lubricant.inlet_heating": False}
    )
    assert case.bearing.clearance == approx(50e-6, rel=1e-12)
    assert case.outer.bars == 18
    assert case.lubricant.inlet_heating is False
    again = read_case(PAPER, case.source.overrides)
    assert again.to_json() == case.to_json()


def test_what_was_fitted_can_be_set():
    case = read_case(PAPER, ["calibrated.outer.bars=stiffness of a test", "outer.bars=18"])
    assert "outer.bars" not in case.calibrated
    case = read_case(PAPER, ["outer.bars=18", "calibrated.outer.bars=stiffness of a test"])
    assert case.calibrated["outer.bars"] == "stiffness of a test"


def test_example_of_every_key_is_a_value_it_takes():
    for item in (item for item in declarations(FAMILIES) if not item.section):
        name = item.path.rpartition(".")[2]
        model: type[BaseModel] = create_model("Model", **{name: (item.field.annotation, item.field)})
        assert f"{name} = {item.example}" in explain(item.path), item.path
        model.model_validate(tomllib.loads(f"{name} = {item.example}"))


OVAL = ("bearing.form_error.outer.waves=2", "bearing.form_error.outer.amplitude=10 um")
COLLAR = ("outer.collar_length=2 mm", "outer.collar_thickness=6 mm")


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ((*OVAL, "bearing.form_error.outer.waves=1"), "[bearing.form_error.outer] waves"),
        ((*OVAL, "bearing.form_error.outer.further_waves=[1]"), "whole numbers from 2"),
        ((*OVAL, "bearing.form_error.outer.further_waves=[3]"), "further_amplitudes"),
        (("bearing.form_error.roller_diameters=['1 um']",), "as many numbers as bearing.rollers"),
        ((*COLLAR, "outer.collar_thickness=3 mm"), "at least 3.6 mm, outer.thickness."),
        ((*COLLAR, "outer.collar_length=11 mm"), "at most outer.width"),
        ((*COLLAR, "outer.collar_length=6 mm", "outer.bar_ends=both"), "at most half of outer.width"),
        (COLLAR[:1], "collar_thickness is missing"),
        (("outer.raceway_offset=2.6 mm",), "-2.5 to 2.5 mm"),
        (
            ("outer.kind=ring", "outer.support=lines", 'outer.line_azimuths=["0 deg", "120 deg", "240 deg"]',
             "outer.raceway_offset=1 mm"),
            'it belongs to outer.kind = "ring" with outer.support = "side"',
        ),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)  # fmt: skip
def test_impossible_shape_of_a_raceway_is_named(settings, told):
    kept = {setting.partition("=")[0]: setting for setting in settings}
    assert told in refusal(*kept.values())


RING = ["outer.kind=ring", "inner.kind=rigid"]
PLANET = [
    *RING, "outer.support=planet", 'outer.tooth_azimuths=["0 deg", "180 deg"]',
    'outer.tooth_radial=["0 N", "0 N"]', 'outer.tooth_tangential=["-2 kN", "2 kN"]',
]  # fmt: skip
UNKNOWN_TO_STRUCTURE = {
    "seat below a beam": ([*RING, "outer.support=seat"], "beam", '"side" or "foundation"'),
    "planet gear as a beam": (PLANET, "beam", '"side" or "foundation"'),
    "planet gear as a solid": (PLANET, "solid", '"side" or "seat" or "housing"'),
    "solid shaft as a beam": (["outer.kind=rigid", "inner.shaft_thickness="], "beam", "a hollow shaft"),
    "shaft of half its bore": (
        ["outer.kind=rigid", "inner.shaft_thickness=29.8 mm"],
        "beam",
        "a hollow shaft",
    ),
}


@pytest.mark.parametrize(
    ("settings", "structure", "allowed"), UNKNOWN_TO_STRUCTURE.values(), ids=UNKNOWN_TO_STRUCTURE
)
def test_parts_that_a_structure_does_not_know_are_refused_on_reading(settings, structure, allowed):
    words = refusal(*settings, f"accuracy.structure={structure}")
    assert allowed in words
    assert f'accuracy.structure = "{structure}"' in words


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (["outer.fillet=20 mm"], "[outer] fillet = 20.044 mm is impossible; allowed is zero"),
        (["inner.fit=frictionless", "inner.shoulder_diameter=100 mm"], "[inner] shoulder_diameter = 100 mm"),
        (
            ["inner.fit=frictionless", "inner.clamping=5 kN"],
            "[inner] shoulder_diameter is missing: inner.clamping needs it",
        ),
        (
            [*RING, "outer.thickness=0.1 mm"],
            "[outer] thickness = 0.10022 mm is impossible; allowed is above 0.3 mm",
        ),
    ],
    ids=["fillet", "shoulder", "no shoulder", "thin ring"],
)
def test_impossible_parts_are_refused_by_check_in_the_words_of_the_case(settings, words):
    with pytest.raises(BadCase) as problem:
        check(PAPER, settings)
    assert words in str(problem.value)
