"""Fits, classes of clearance and temperatures of ball bearings, and what they make of the clearance."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import clearance
from flexbearing.case import BadCase
from flexbearing.case.read import written
from flexbearing.report.output import text
from flexbearing.runs import angular_contact, four_point
from tests.flexbearing.noted import texts
from tests.places import CONFIGS

DEEP, ANGULAR = CONFIGS / "6209.toml", CONFIGS / "rivera2021_7008.toml"
STEEL = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7800 kg/m^3"}
FITS = {
    "bearing.clearance": None,
    "bearing.fits.cold_clearance": "14.5 um", "bearing.fits.shaft_interference": "13.5 um",
    "bearing.fits.bore": "45 mm", "bearing.fits.outer_diameter": "85 mm", "materials.shaft": STEEL,
}  # fmt: skip
HOUSED = {
    "bearing.fits.housing": {"diameter": "120 mm", "interference": "-25 um"},
    "materials.housing": "grey cast iron",
}
CLASSES = FITS | {
    "bearing.fits.cold_clearance": None, "bearing.fits.shaft_interference": None,
    "bearing.clearance_class": "CN", "bearing.fits.shaft": "k5",
    "bearing.fits.housing": {"diameter": "120 mm", "tolerance_class": "H7"},
    "materials.housing": "grey cast iron",
}  # fmt: skip
OPEN = {
    "bearing.fits.shaft_interference": "20 um", "bearing.fits.bore": "40 mm", "materials.shaft": STEEL,
    "bearing.fits.outer_diameter": "68 mm", "operation.inner_speed": "0 rpm",
}  # fmt: skip
FOUR_POINT = CONFIGS / "joshi2015_qj309.toml"
QJ = {
    "bearing.fits.bore": "45 mm", "bearing.fits.outer_diameter": "100 mm",
    "bearing.fits.shaft_interference": "20 um",
    "materials.shaft": {"youngs_modulus": "210 GPa", "poisson_ratio": 0.3},
}  # fmt: skip
WARM = {f"operation.temperatures.{part}": "20 degC" for part in ("shaft", "inner_ring", "ball", "outer_ring")}
WARM |= {"operation.temperatures.reference": "20 degC"}
EXPANDING = STEEL | {"expansion": "12e-6 1/K"}


def given(settings):
    """Settings as texts; None takes out a key of the file."""
    return [f"{key}=" if value is None else written({key: value})[0] for key, value in settings.items()]


def case_of(settings, file=DEEP):
    return read_case(file, given(settings))


def test_a_solid_shaft_of_the_same_steel_widens_the_groove_as_one_body():
    """Shaft and ring are one cylinder: the groove bottom grows by the interference times d/F (Lame)."""
    case = case_of(FITS | {"operation.inner_speed": "0 rpm"})
    bottom = 65e-3 - 12.7e-3 - 14.5e-6 / 2
    assert clearance.operating(case) == approx(14.5e-6 - 13.5e-6 * 45e-3 / bottom, rel=1e-9)


def test_a_housing_that_presses_narrows_the_outer_groove():
    settings = {"bearing.fits.housing": {"diameter": "120 mm", "interference": "10 um"}}
    loose, pressed = (clearance.operating(case_of(FITS | HOUSED | more)) for more in ({}, settings))
    assert loose == approx(clearance.operating(case_of(FITS)), rel=1e-12)
    assert 1e-6 < loose - pressed < 10e-6


def test_an_outer_ring_that_turns_widens_its_groove_with_the_square_of_the_speed():
    speeds = [
        {"operation.inner_speed": "0 rpm", "operation.outer_speed": f"{n} rpm"} for n in (0, 5000, 10000)
    ]
    still, *turning = (clearance.operating(case_of(FITS | each)) for each in speeds)
    grown = [each - still for each in turning]
    assert grown[0] > 0.5e-6
    assert grown[1] == approx(4 * grown[0], rel=1e-9)


def test_a_run_with_fits_is_that_of_the_operating_clearance():
    settings = FITS | {"operation.load.axial": "1 kN"}
    fitted = flexbearing.run(DEEP, given(settings))
    stated = clearance.operating(case_of(settings))
    same = flexbearing.run(DEEP, [f"bearing.clearance={stated * 1e6:.12g} um", "operation.load.axial=1 kN"])
    assert fitted.rigid["radial_clearance"] == approx(stated, rel=1e-9)
    assert fitted.rigid["contact_load"] == approx(same.rigid["contact_load"], rel=1e-8, abs=1e-6)
    assert "operating clearance, diametral, step by step" in text(fitted)
    assert "ball heat" in text(fitted)
    assert fitted.summary()["clearance"]["cold_m"] == approx(14.5e-6, rel=1e-12)
    assert "step by step" not in text(same)


def test_interference_lowers_the_contact_angle_of_an_angular_contact_bearing():
    """7008: cos(alpha_0) = cos(15 deg) + change/(2 A); the ring counts from its place before mounting."""
    case = case_of(OPEN, ANGULAR)
    own, change = angular_contact.bearing(case).bearing, clearance.operating(case) - case.stated_clearance
    distance = 0.04 * 7.938e-3
    assert case.stated_clearance == approx(2 * distance * (1 - np.cos(np.radians(15.0))), rel=1e-12)
    assert own.clearance == approx(change, rel=1e-12)
    assert own.radial_clearance == approx(clearance.operating(case), rel=1e-9)
    assert np.cos(own.free_contact_angle) == approx(
        np.cos(np.radians(15.0)) - change / 2 / distance, rel=1e-12
    )
    assert np.degrees(own.free_contact_angle) < 10.0


def test_interference_raises_a_preload_by_displacement_from_before_mounting():
    held = {"operation.load.axial": "0 N", "operation.displacement.axial": "10 um"}
    slack = OPEN | {"bearing.fits.shaft_interference": "0 um"}
    before, after = (flexbearing.run(ANGULAR, fits | held) for fits in (slack, OPEN))
    assert after.rigid["ring_load"][0] > 2 * before.rigid["ring_load"][0]
    beyond = {"operation.load.axial": "0 N", "operation.preload.displacement": "10 um"}
    mounted = flexbearing.run(ANGULAR, OPEN | beyond)
    assert mounted.rigid["ring_load"][0] < after.rigid["ring_load"][0]


def test_even_heat_scales_the_cold_clearance_of_a_bearing_of_one_steel():
    steel = {f"materials.{part}": EXPANDING for part in ("ball", "shaft")}
    warm = {key: "120 degC" for key in WARM} | {"operation.temperatures.reference": "20 degC"}
    still = FITS | steel | WARM | {"operation.inner_speed": "0 rpm"}
    cold, hot = (clearance.operating(case_of(still | more)) for more in ({}, warm))
    assert hot - cold == approx(14.5e-6 * 12e-6 * 100, rel=1e-6)


def test_a_warm_inner_ring_takes_clearance_and_a_cold_ball_gives_some():
    steel = {f"materials.{part}": EXPANDING for part in ("ball", "shaft")}
    still = FITS | steel | WARM
    cold = clearance.operating(case_of(still))
    warm = {"operation.temperatures.inner_ring": "30 degC", "operation.temperatures.shaft": "30 degC"}
    bottom = 65e-3 - 12.7e-3
    assert clearance.operating(case_of(still | warm)) - cold == approx(-bottom * 12e-5, rel=2e-3)
    cooler = {"operation.temperatures.ball": "10 degC"}
    assert clearance.operating(case_of(still | cooler)) - cold == approx(2 * 12.7e-3 * 12e-5, rel=2e-3)


def test_interference_presses_both_diagonals_of_a_four_point_bearing():
    """Opposite groove centres part radially by half the change; their axial distance stays."""
    case = case_of(QJ, FOUR_POINT)
    own, change = four_point.bearing(case).bearing, clearance.operating(case) - case.stated_clearance
    distance, angle = 0.047 * 18.25e-3, np.radians(35.0)
    assert change == approx(-20e-6 * 45e-3 / (72.38e-3 - 18.25e-3 - case.stated_clearance * 0.0165 / 0.047))
    centres = np.array([distance * np.cos(angle) - change / 2, distance * np.sin(angle)])
    assert own.centre_distance - own.clearance == approx(np.hypot(*centres), rel=1e-12)
    assert own.clearance == approx(change / 2 * np.cos(angle), rel=0.01)
    assert own.contact_angle == approx(np.arctan2(*centres[::-1]), rel=1e-12)


def test_fits_of_a_four_point_bearing_are_shown():
    result = flexbearing.run(FOUR_POINT, given(QJ))
    assert "operating clearance, diametral, step by step" in text(result)
    assert result.summary()["rigid"]["diagonal_clearance_um"] == approx(-6.8, abs=0.3)
    plain = flexbearing.run(FOUR_POINT)
    assert plain.summary()["rigid"]["diagonal_clearance_um"] == 0.0
    assert plain.summary()["rigid"]["free_contact_angle_deg"] == approx(35.0, rel=1e-12)
    assert result.rigid["contact_load"].max() > plain.rigid["contact_load"].max()


def test_bolted_rings_have_no_fits():
    with pytest.raises(BadCase, match="left out beside elastic rings"):
        read_case(CONFIGS / "slewing_bolted.toml", given({
            "bearing.fits.bore": "800 mm", "bearing.fits.outer_diameter": "2200 mm",
            "bearing.fits.shaft_interference": "0 um", "materials.shaft": "100Cr6"}))  # fmt: skip


# -- classes --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("place", "cold", "shaft", "housing"),
    [("loosest", 23, 2, -50), ("mean", 14.5, 13.5, -25), ("tightest", 6, 25, 0)],
)
def test_classes_are_the_numbers_that_they_stand_for(place, cold, shaft, housing):
    """45 x 85 mm: CN 6 to 23 um, k5 2 to 25 um, H7 -50 to 0 um."""
    numbers = FITS | HOUSED | {
        "bearing.fits.cold_clearance": f"{cold} um", "bearing.fits.shaft_interference": f"{shaft} um",
        "bearing.fits.housing": {"diameter": "120 mm", "interference": f"{housing} um"},
    }  # fmt: skip
    named = case_of(CLASSES | {"bearing.fits.at": place})
    assert clearance.operating(named) == approx(clearance.operating(case_of(numbers)), rel=1e-9)


def test_result_tells_the_tolerances_and_the_clearance_at_both_ends():
    result = flexbearing.run(DEEP, given(CLASSES))
    shown = text(result)
    assert "clearance before mounting, CN" in " ".join(shown.split())
    assert "operating clearance" in shown
    (note,) = (note for note in texts(result) if "the tolerances of the fits leave" in note)
    assert "and preload at the tight end" in note
    ends = result.summary()["clearance"]["tolerances"]["ends"]
    assert ends["tightest_m"] < 0.0 < ends["loosest_m"]


def test_an_interference_of_balls_and_races_is_told():
    result = flexbearing.run(DEEP, {"bearing.clearance": "-5 um", "operation.load.radial_z": "100 N"})
    assert any("its balls interfere by 5.0 um" in note for note in texts(result))
    assert (result.rigid["contact_load"] > 0).all()


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"bearing.clearance": "15 um"}, "left out where fits.cold_clearance is given"),
        ({"bearing.clearance_class": "C3"}, "left out where fits.cold_clearance is given"),
        ({"bearing.fits.shaft": "k5"}, "left out beside shaft_interference"),
        ({"bearing.fits.bore": "53 mm"}, "below the bottom of the inner groove, 52.3 mm"),
        ({"bearing.fits.outer_diameter": "77 mm"}, "above the bottom of the outer groove, 77.7 mm"),
        ({"bearing.fits.shaft_bore": "45 mm"}, "mm, bearing.fits.bore"),
        ({"bearing.fits.housing": {"diameter": "80 mm", "interference": "0 um"}}, "mm, bearing.fits.outer"),
        (
            {"bearing.fits.housing": {"diameter": "99 mm", "interference": "0 um"}},
            "[materials] housing is missing",
        ),
        ({"bearing.fits.cold_clearance": "15 mm"}, "of a size below 1000 um"),
        ({"materials.shaft": {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3}}, "density is missing"),
        (WARM, "expansion is missing"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_fits_that_cannot_be_are_refused(settings, said):
    with pytest.raises(BadCase) as problem:
        case_of(FITS | settings)
    assert said in str(problem.value)


def test_all_that_fits_lack_is_told_at_once(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text('kind = "deep_groove_ball"\n[bearing]\nballs = 9\n[bearing.fits]\nshaft = "k5"\n')
    with pytest.raises(BadCase) as problem:
        read_case(file)
    for said in (
        "[bearing.fits] bore is missing",
        "[bearing.fits] cold_clearance is missing",
        "[bearing] pitch_diameter is missing",
        "[materials] shaft is missing",
        "it is a table; a groove without radius needs conformity",
    ):
        assert said in str(problem.value)


@pytest.mark.parametrize("file", [CONFIGS / "harris218.toml", CONFIGS / "joshi2015_fourpoint.toml"])
def test_classes_of_clearance_are_those_of_deep_groove_bearings(file):
    with pytest.raises(BadCase, match="there is no printed table here"):
        read_case(file, {"bearing.clearance_class": "C3"})
