"""Fits and temperatures of tapered roller bearings, which bring cone and cup closer."""

from math import cos, radians, tan

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build.tapered_fits import closer
from flexbearing.case import BadCase
from flexbearing.case.read import written
from flexbearing.report.output import text
from tests.flexbearing.noted import texts
from tests.places import CONFIGS

CASE = CONFIGS / "32207.toml"
ANGLE, CONE = radians(14.036), 0.17616014552345755  # sin(ANGLE - CONE) = 2 D/d_m sin((ANGLE + CONE)/2)
CHORD = 8.8e-3 / cos((ANGLE - CONE) / 2)
LOOSE = {
    "bearing.fits.bore": "35 mm", "bearing.fits.outer_diameter": "72 mm",
    "bearing.fits.shaft_interference": "0 um", "materials.shaft": "100Cr6",
}  # fmt: skip
TIGHT = LOOSE | {"bearing.fits.shaft_interference": "20 um"}
AT_REST = {"operation.inner_speed": "0 rpm"}
HELD = {f"operation.load.{name}": "0 N" for name in ("axial", "radial_z")}
HOUSED = {
    "bearing.fits.housing": {"diameter": "110 mm", "interference": "10 um"},
    "materials.housing": "100Cr6",
}
PLAIN = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3}
PARTS = ("shaft", "inner_ring", "roller", "outer_ring")


def temperatures(**degrees):
    even = dict.fromkeys(PARTS, 20) | {"reference": 20} | degrees
    return {f"operation.temperatures.{part}": f"{each} degC" for part, each in even.items()}


def case_of(settings):
    return read_case(CASE, [each for key, value in settings.items() for each in written({key: value})])


def result(settings):
    return flexbearing.run(CASE, settings).rigid


def test_a_solid_shaft_of_the_same_steel_widens_the_cone_as_one_body():
    """The cone grows by I d/F (Lame) at the roller centres, F = d_m - D/(cos eps cos alpha_i)."""
    raceway = 53.5e-3 - CHORD / cos(CONE)
    grown = 20e-6 * 35e-3 / raceway
    assert closer(case_of(TIGHT | AT_REST)) == approx(grown / 2 / tan(ANGLE), rel=1e-9)


def test_without_interference_numbers_are_those_without_fits():
    plain, fitted = (result(AT_REST | more) for more in ({}, LOOSE))
    assert closer(case_of(LOOSE | AT_REST)) == 0.0
    assert {*plain} == {*fitted}
    for name, values in plain.items():
        np.testing.assert_array_equal(fitted[name], values)


def test_a_free_cone_moves_out_and_carries_the_same():
    plain, fitted = result(LOOSE), result(TIGHT)
    moved = closer(case_of(TIGHT)) - closer(case_of(LOOSE))
    assert plain["ring_displacement"][0] - fitted["ring_displacement"][0] == approx(moved, rel=1e-9)
    assert fitted["inner_load"] == approx(plain["inner_load"], rel=1e-9)
    assert fitted["rib_load"] == approx(plain["rib_load"], rel=1e-9)


def test_a_held_cone_is_pressed_as_far_as_it_is_closer():
    extra = 1e6 * closer(case_of(TIGHT))
    fitted = result(TIGHT | HELD | {"operation.displacement.axial": "5 um"})
    further = result(HELD | {"operation.displacement.axial": f"{5 + extra:.12g} um"})
    assert fitted["inner_load"] == approx(further["inner_load"], rel=1e-9)


@pytest.mark.parametrize("preload", [{"offset": "5 um"}, {"preload": "1 kN"}])
def test_rows_of_a_pair_press_each_other_further(preload):
    pair = {f"bearing.pair.{key}": value for key, value in (
        {"arrangement": "back_to_back", "distance": "40 mm"} | preload).items()}  # fmt: skip
    idle = {"operation.load.axial": "0 N", "operation.load.radial_z": "0 N"}
    before, after = (result(pair | idle | more) for more in ({}, TIGHT))
    assert after["row_load"][0, 0] > 2 * before["row_load"][0, 0] > 0
    if "offset" in preload:
        offset = {"bearing.pair.offset": f"{5 + 1e6 * closer(case_of(TIGHT)):.12g} um"}
        assert after["row_load"] == approx(result(pair | idle | offset)["row_load"], rel=1e-9, abs=1e-6)


def test_even_heat_of_one_steel_changes_no_place():
    warm = temperatures(**dict.fromkeys(PARTS, 120))
    assert closer(case_of(LOOSE | AT_REST | warm)) == approx(0.0, abs=1e-15)


def test_parts_that_are_warmer_alone():
    """A loose ring grows by alpha T of its raceway, a roller between both; a cold shaft does nothing."""
    warm, slope = 11.9e-6 * 10, 2 * tan(ANGLE)
    cup, cone, rollers, shaft = (
        closer(case_of(LOOSE | AT_REST | temperatures(**{part: degrees})))
        for part, degrees in (("outer_ring", 30), ("inner_ring", 30), ("roller", 30), ("shaft", 10))
    )
    inner, outer = 53.5e-3 - CHORD / cos(CONE), 53.5e-3 + CHORD / cos(ANGLE)
    assert cup == approx(-outer * warm / slope, rel=1e-9)
    assert cone == approx(inner * warm / slope, rel=1e-9)
    assert rollers == approx((outer - inner) * warm / slope, rel=1e-9)
    assert shaft == 0.0


def test_a_housing_that_presses_brings_the_cup_closer():
    pressed = closer(case_of(LOOSE | AT_REST | HOUSED))
    assert 5e-6 < pressed < 10e-6 / 2 / tan(ANGLE)


CLASSES = LOOSE | {"bearing.fits.shaft_interference": None, "bearing.fits.shaft": "k5"}


def test_result_says_by_how_much_within_the_tolerances():
    """k5 of 35 mm is +2 to +13 um, the bore 0 to -12 um."""
    fitted = flexbearing.run(CASE, {key: value for key, value in CLASSES.items() if value})
    ends = [closer(case_of(TIGHT | {"bearing.fits.shaft_interference": f"{um} um"})) for um in (2, 25)]
    (note,) = (note for note in texts(fitted) if note.startswith("fits, heat and speed"))
    assert f"{1e6 * ends[0]:.1f} to {1e6 * ends[1]:.1f} um within the tolerances" in note
    shown = text(fitted)
    assert "operating clearance, diametral, step by step" in shown
    assert "cone and cup are closer by" in shown
    assert fitted.attributes["clearance"]["cold_m"] == 0.0


@pytest.mark.parametrize(("settings", "complaint"), [
    ({"materials.shaft": None}, "[materials] shaft is missing"),
    ({"bearing.fits.bore": "43 mm"}, "below the narrow end of the inner raceway, 42."),
    ({"bearing.fits.outer_diameter": "65 mm"}, "above the wide end of the outer raceway, 65."),
    (HOUSED | {"materials.housing": None}, "[materials] housing is missing"),
    ({"materials.shaft": PLAIN}, "density is missing"),
    (temperatures() | HOUSED, "[operation.temperatures] housing is missing"),
    (temperatures() | {"materials.roller": PLAIN | {"density": "7800 kg/m^3"}}, "expansion is missing"),
])  # fmt: skip
def test_fits_that_cannot_be_are_refused(settings, complaint):
    given = {key: value for key, value in (TIGHT | settings).items() if value is not None}
    with pytest.raises(BadCase) as problem:
        case_of(given)
    assert complaint in str(problem.value)
