"""The operating clearance: stated in the case, or computed from its fits."""

import re
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

import flexbearing
from flexbearing.api import check, read_case
from flexbearing.build import clearance, expansion, fits, ring_parts, roller_bearing
from flexbearing.build.growth import expansions, mean_growth
from flexbearing.case import BadCase
from flexbearing.case.read import understood
from flexbearing.case.tolerances import ClearanceClass, HousingClass, ShaftClass
from flexbearing.families import FAMILIES
from flexbearing.report.output import text
from flexbearing.rings.fits import inner_ring_in_fit, outer_ring_in_housing
from flexbearing.runs import notes
from quasidynamic.clearance import Annulus, FitConditions, PressFit, operating_clearance
from tests.places import CONFIGS

PLAIN, FITS, PAPER = (CONFIGS / f"{name}.toml" for name in ("nu209", "nu209_fits", "mao2016"))
PRELOAD = {"bearing.fits.shaft_interference": "80 um"}


def test_stated_clearance_is_the_operating_one():
    case = read_case(PLAIN)
    assert roller_bearing.bearing(case).bearing.clearance == approx(41e-6, rel=1e-12)
    assert clearance.record(case) == {"operating_m": approx(41e-6, rel=1e-12), "steps": []}


def test_computed_clearance_reaches_the_model():
    case = read_case(FITS)
    chain = clearance.computed(case)
    assert chain is not None
    assert roller_bearing.bearing(case).bearing.clearance == chain.clearance
    assert chain.clearance == approx(chain.cold + sum(step.change for step in chain.steps), abs=1e-15)


@pytest.mark.parametrize(
    ("setting", "step"),
    [
        ({"bearing.fits.shaft_interference": "20 um"}, "inner fit"),
        ({"bearing.fits.shaft_bore": "20 mm"}, "inner fit"),
        ({"bearing.fits.bore": "50 mm"}, "inner fit"),
        ({"materials.shaft.youngs_modulus": "70 GPa"}, "inner fit"),
        ({"bearing.fits.housing.interference": "20 um"}, "outer fit"),
        ({"operation.temperatures.inner_ring": "90 degC"}, "inner heat"),
        ({"operation.temperatures.shaft": "90 degC"}, "inner heat"),
        ({"operation.temperatures.outer_ring": "90 degC"}, "outer heat"),
        ({"operation.temperatures.roller": "90 degC"}, "roller heat"),
        ({"operation.inner_speed": "20000 rpm"}, "inner rotation"),
        ({"operation.outer_speed": "20000 rpm"}, "outer rotation"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else value,
)
def test_every_key_of_the_mounting_changes_the_step_it_is_about(setting, step):
    before, after = (
        {found["name"]: found["change_m"] for found in clearance.record(read_case(FITS, settings))["steps"]}
        for settings in ({}, setting)
    )
    assert after[step] != approx(before[step], rel=1e-6, abs=1e-12)
    earlier = list(before)[: list(before).index(step)]
    assert [after[name] for name in earlier] == approx([before[name] for name in earlier], rel=1e-12, abs=0.0)


def test_speeds_of_the_steps_are_in_the_unit_of_cases():
    steps = clearance.record(read_case(FITS))["steps"]
    (words,) = (found["explanation"] for found in steps if found["name"] == "inner rotation")
    assert words.startswith("3000 rpm; ")


@pytest.mark.parametrize(
    "setting",
    [
        {"bearing.fits.housing.diameter": "90 mm"},
        {"materials.housing.youngs_modulus": "70 GPa"},
        {"bearing.fits.outer_diameter": "80 mm"},
    ],
    ids=lambda setting: next(iter(setting)),
)
def test_dimensions_of_the_housing_matter_once_it_is_tight(setting):
    tight = {"bearing.fits.housing.interference": "20 um"}
    one, other = (
        clearance.operating(read_case(FITS, settings)) for settings in (tight, {**tight, **setting})
    )
    assert abs(one - other) > 1e-8


def test_without_temperatures_only_fits_and_speed_change_the_clearance(tmp_path):
    whole = FITS.read_text()
    begin, end = whole.index("[operation.temperatures]"), whole.index("[life]")
    file = tmp_path / "cold.toml"
    file.write_text((whole[:begin] + whole[end:]).replace('"operation.temperatures",', ""))
    steps = {found["name"]: found["change_m"] for found in clearance.record(read_case(file))["steps"]}
    assert steps["inner fit"] < -1e-6
    assert [steps[name] for name in ("inner heat", "outer heat", "roller heat")] == [0.0, 0.0, 0.0]


def test_flexible_parts_give_the_dimensions_of_the_fits(tmp_path):
    """Squirrel cage and hollow shaft: [inner] and [outer] are their only source."""
    table = '[bearing.fits]\ncold_clearance = "100 um"\nshaft_interference = "40 um"\n\n[bearing.roller]'
    whole = PAPER.read_text()
    whole = whole.replace("[bearing.roller]", table, 1).replace('clearance = "75.5 um"', "", 1)
    file = tmp_path / "case.toml"
    file.write_text("\n".join(line for line in whole.splitlines() if '"bearing.clearance" =' not in line))
    case = read_case(file)
    mounting = fits._mounting(case)
    assert isinstance(mounting.outer, Annulus)
    assert (2 * mounting.outer.inner_radius, 2 * mounting.outer.outer_radius) == approx((75e-3, 82.2e-3))
    shaft = mounting.shaft_fit.inside
    assert (2 * shaft.inner_radius, 2 * shaft.outer_radius) == approx((51.6e-3, 59.6e-3))
    part = ring_parts.inner_part(case)
    assert part is not None
    cold = 75e-3 - 2 * 5e-3 - 100e-6  # the fit has not widened it yet
    hot = cold * expansion.hot_over_cold(case, "inner_ring")
    assert ring_parts._inner_raceway_diameter(case) == approx(hot, rel=1e-12)
    step = 1e-4 * 75e-3
    assert part.raceway_diameter == approx(step * round(hot / step), rel=1e-12)


def test_record_tells_the_cold_clearance_and_each_fit():
    case = read_case(FITS)
    chain, record = clearance.computed(case), clearance.record(case)
    assert chain is not None
    assert record["cold_m"] == case.bearing.fits.cold_clearance != chain.clearance
    assert record["operating_m"] == chain.clearance
    assert chain.housing_seat is not None
    assert record["shaft_fit"] == chain.shaft_seat.words != chain.housing_seat.words
    assert record["housing_fit"] == chain.housing_seat.words


def test_cold_rings_and_rollers_leave_the_cold_clearance():
    mounting = fits._mounting(read_case(FITS))
    assert isinstance(mounting.outer, PressFit)
    raceways = [2 * mounting.outer.inside.inner_radius, 2 * mounting.shaft_fit.outside.outer_radius]
    gap = raceways[0] - raceways[1] - 4 * mounting.rolling_element.outer_radius
    assert gap == approx(mounting.cold_clearance, rel=1e-9)


def test_housing_without_a_temperature_follows_the_outer_ring():
    hot = {
        "operation.temperatures.reference": "20 degC",
        **{
            f"operation.temperatures.{part}": "120 degC"
            for part in ("shaft", "inner_ring", "roller", "outer_ring")
        },
    }
    case = read_case(PLAIN, hot)
    assert expansion.hot_over_cold(case, "outer_ring") > 1.0
    assert expansion.hot_over_cold(case, "housing") == expansion.hot_over_cold(case, "outer_ring")


def test_housing_is_part_of_the_fit():
    outer = fits._mounting(read_case(FITS)).outer
    assert isinstance(outer, PressFit)
    assert 2 * outer.outside.outer_radius == approx(0.12)
    assert outer.interference == approx(-10e-6)


def test_preload_is_a_result_and_said_so():
    case = read_case(FITS, PRELOAD)
    assert clearance.operating(case) < 0.0
    (note,) = clearance.notes(case)
    assert "the bearing is preloaded" in note.text
    assert note in notes.of_case(case)
    result = flexbearing.run(FITS, [f"{key}={value}" for key, value in PRELOAD.items()])
    assert result.attributes["status"] == "converged"
    assert "preloaded" in result.attributes["clearance"]["verdict"]
    assert "inner fit" in text(result)
    assert result.rigid["inner_load"].min() > 0.0  # every roller is loaded


def test_stated_preload_is_noted_as_well():
    assert clearance.notes(read_case(PLAIN)) == ()
    (note,) = clearance.notes(read_case(PLAIN, {"bearing.clearance": "-5 um"}))
    assert "by 5.0 um diametral" in note.text


# -- refusals --------------------------------------------------------------------------------------


def refusal(file, settings):
    with pytest.raises(BadCase) as problem:
        check(file, settings)
    return str(problem.value)


def cut(tmp_path, *lines):
    """The case with fits without some of its lines."""
    text = FITS.read_text()
    for line in lines:
        assert line in text
        text = text.replace(line, "")
    file = tmp_path / "broken.toml"
    file.write_text(text)
    return file


def test_two_clearances_are_one_too_many():
    message = refusal(FITS, {"bearing.clearance": "41 um"})
    assert '[bearing] clearance = "41 um" cannot be; it must be left out where [bearing.fits] cold' in message
    assert "give one of the two" in message


def test_no_clearance_is_one_too_few(tmp_path):
    file = tmp_path / "broken.toml"
    file.write_text(PLAIN.read_text().replace('clearance = "41 um"', ""))
    message = refusal(file, {})
    assert (
        "[bearing] clearance is missing: a bearing without [bearing.fits] cold_clearance or clearance_class "
        "needs it" in message
    )


MISSING = {
    "bore": ('bore = "45 mm"', "[bearing.fits] bore is missing", 'inner.kind = "rigid" with [bearing.fits]'),
    "outer diameter": (
        'outer_diameter = "85 mm"', "[bearing.fits] outer_diameter is missing", 'outer.kind = "rigid"',
    ),
    "housing temperature": (
        'housing = "60 degC"', "[operation.temperatures] housing is missing", "[bearing.fits.housing] needs",
    ),
    "interference": (
        'shaft_interference = "15 um"', "[bearing.fits] shaft_interference is missing", "it is a length",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("line", "place", "why"), MISSING.values(), ids=MISSING.keys())
def test_missing_companion_of_the_fits_is_named(line, place, why, tmp_path):
    message = refusal(cut(tmp_path, line), {})
    assert place in message
    assert why in message


@pytest.mark.parametrize("part", ["shaft", "housing"])
def test_materials_of_shaft_and_housing_are_needed(part, tmp_path):
    named = {"shaft": "structural steel", "housing": "grey cast iron"}[part]
    message = refusal(cut(tmp_path, f'{part} = "{named}"', f'"materials.{part}",'), {})
    assert f"[materials] {part} is missing: [bearing.fits" in message


IMPOSSIBLE = {
    "bore outside the raceway": ("bearing.fits.bore=60 mm", "[bearing.fits] bore", "54.97 mm"),
    "shaft without wall": (
        "bearing.fits.shaft_bore=45 mm", "[bearing.fits] shaft_bore", "below 45 mm, bearing.fits.bore",
    ),
    "outer ring without wall": (
        "bearing.fits.outer_diameter=75 mm", "[bearing.fits] outer_diameter", ", bearing.outer_raceway",
    ),
    "housing without wall": (
        "bearing.fits.housing.diameter=85 mm", "[bearing.fits.housing] diameter",
        "above 85 mm, bearing.fits.outer",
    ),
    "cold clearance in the wrong unit": (
        "bearing.fits.cold_clearance=60 mm", "[bearing.fits] cold_clearance", "is the unit right?",
    ),
    "interference in the wrong unit": (
        "bearing.fits.shaft_interference=15 mm", "fit = 15000 um", "below 1 % of the diameter",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("setting", "place", "allowed"), IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys())
def test_impossible_mounting_is_refused(setting, place, allowed):
    message = refusal(FITS, [setting])
    assert place in message
    assert allowed in message


RING = {"outer.kind": "ring", "outer.thickness": "5 mm", "outer.width": "20 mm"}


def test_dimension_that_a_flexible_part_gives_is_not_given_again(tmp_path):
    message = refusal(FITS, RING)
    assert "[bearing.fits] outer_diameter" in message
    assert "left out: outer.thickness gives it" in message
    message = refusal(cut(tmp_path, 'outer_diameter = "85 mm"'), RING)
    assert (
        '[bearing.fits] housing cannot be; it must be left out: outer.kind = "ring" sits in no housing'
        in message
    )
    shaft = {"inner.kind": "ring_on_shaft", "inner.bore": "45 mm", "inner.thickness": "6 mm"}
    shaft |= {"inner.width": "20 mm", "inner.track_width": "11 mm", "inner.shaft_length": "60 mm"}
    message = refusal(FITS, {**shaft, "inner.shaft_thickness": "10 mm"})
    assert '[bearing.fits] bore = "45 mm" cannot be; it must be left out: inner.bore gives it' in message


def test_temperature_of_a_housing_that_is_not_there_is_refused():
    message = refusal(PAPER, {"operation.temperatures.housing": "60 degC"})
    assert "[operation.temperatures] housing" in message
    assert "belongs to a given bearing.fits.housing" in message


# -- classes of clearance and fits ---------------------------------------------------------------


CLASSES = {  # a bearing 45 x 85 mm: C3 50 to 80 um, k5 2 to 25 um, N7 -5 to 45 um
    "bearing.clearance_class": "C3", "bearing.fits.shaft": "k5",
    "bearing.fits.housing.tolerance_class": "N7",
}  # fmt: skip
NUMBERS = ("cold_clearance", "shaft_interference", "interference")


def by_class(settings=None) -> Any:
    """The case with fits, by classes instead of numbers."""
    lines = FITS.read_text().splitlines()
    text = "\n".join(line for line in lines if not line.strip().startswith(NUMBERS))
    for name in ("cold_clearance", "shaft_interference", "housing.interference"):
        text = text.replace(f'"bearing.fits.{name}",', "")
    return understood(text, FITS, {**CLASSES, **(settings or {})}, FAMILIES)


@pytest.mark.parametrize(
    ("place", "cold", "shaft", "housing"),
    [("loosest", 80, 2, -5), ("mean", 65, 13.5, 20), ("tightest", 50, 25, 45)],
)
def test_classes_are_the_numbers_that_they_stand_for(place, cold, shaft, housing):
    numbers = {
        "bearing.fits.cold_clearance": f"{cold} um",
        "bearing.fits.shaft_interference": f"{shaft} um",
        "bearing.fits.housing.interference": f"{housing} um",
    }
    named, stated = by_class({"bearing.fits.at": place}), read_case(FITS, numbers)
    assert clearance.operating(named) == approx(clearance.operating(stated), rel=1e-9, abs=0.0)
    assert named.stated_clearance == approx(cold * 1e-6, rel=1e-12)


def test_result_tells_the_tolerances_and_the_clearance_at_both_ends():
    case = by_class()
    record = clearance.record(case)["tolerances"]
    found = {row["name"]: [1e6 * row[f"{end}_m"] for end in ("least", "used", "greatest")]
             for row in record["classes"]}  # fmt: skip
    assert found["clearance"] == approx([50, 65, 80])
    assert found["shaft"] == approx([2, 13.5, 25])
    assert found["housing"] == approx([-5, 20, 45])
    assert [row["class"] for row in record["classes"]] == ["C3", "k5", "N7"]
    ends = {end: clearance.operating(by_class({"bearing.fits.at": end})) for end in ("loosest", "tightest")}
    assert record["ends"] == {f"{end}_m": value for end, value in ends.items()}
    assert ends["tightest"] < clearance.operating(case) < ends["loosest"]
    (note,) = (each for each in clearance.notes(case) if each.code == "fit-tolerances")
    assert f"{ends['tightest'] * 1e6:.1f} to {ends['loosest'] * 1e6:.1f} um" in note.text


def test_a_class_of_the_shaft_alone_presses_a_fit_beside_a_stated_clearance():
    case = read_case(PAPER, {"inner.fit": "friction", "bearing.fits.shaft": "k5"})
    assert case.shaft_interference == approx((2 + 15 + 15) / 2 * 1e-6)  # 59.6 mm: k5 +2 to +15, bore 0 to -15
    assert "ends" not in clearance.record(case)["tolerances"]
    assert clearance.notes(case) == ()


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ({"bearing.fits.bore": "5 mm"}, "bearing.fits.bore = 5 mm: C3 is tabulated over 6 mm up to 250 mm"),
        ({"bearing.fits.shaft": "r7"}, "r7 is tabulated over 80 mm up to 250 mm; give the value"),
        ({"bearing.fits.housing.tolerance_class": "R7"}, '"F7" or "G6" or "G7"'),
        ({"bearing.fits.shaft": "H7"}, '"f5" or "f6" or "g5"'),
        ({"bearing.clearance_class": "C9"}, '"C2" or "CN" or "C3" or "C4"'),
        ({"bearing.fits.shaft_interference": "9 um"}, "left out beside shaft_interference; give one of"),
        ({"bearing.fits.housing.interference": "9 um"}, "left out beside interference; give one of the two"),
        ({"bearing.fits.cold_clearance": "60 um"}, "left out where [bearing.fits] cold_clearance is given"),
        ({"bearing.clearance": "60 um"}, "left out where clearance_class is given; give one of the two"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_classes_without_a_printed_value_or_beside_a_number_are_refused(setting, said):
    with pytest.raises(BadCase) as problem:
        by_class(setting)
    assert said in str(problem.value)


def test_a_class_of_clearance_needs_the_fit_of_the_shaft(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(PLAIN.read_text().replace('clearance = "41 um"', 'clearance_class = "C3"'))
    assert "[bearing.fits] shaft is missing: bearing.clearance_class needs it" in refusal(file, {})


def test_a_place_within_tolerances_needs_a_class():
    assert "[bearing.fits] at" in refusal(FITS, {"bearing.fits.at": "loosest"})


@given(
    st.sampled_from(get_args(ShaftClass)),
    st.sampled_from(get_args(HousingClass)),
    st.sampled_from(get_args(ClearanceClass)),
)
@settings(max_examples=30)
def test_tighter_classes_never_open_a_bearing(shaft, housing, clearance_class):
    if shaft in ("p7", "r7"):
        return
    found = {
        "bearing.fits.shaft": shaft,
        "bearing.fits.housing.tolerance_class": housing,
        "bearing.clearance_class": clearance_class,
    }
    case = by_class(found)
    tight, mean, loose = (
        clearance.operating(case.within_tolerances(place)) for place in ("tightest", "mean", "loosest")
    )
    assert tight < mean < loose


# -- one fit, one interference, one pressure -------------------------------------------------------


MOUNTED = {
    "outer.kind": "rigid", "bearing.fits.outer_diameter": "82.2 mm", "bearing.fits.cold_clearance": "100 um",
    "bearing.fits.shaft_interference": "30 um", "accuracy.element_order": 4,
}  # fmt: skip


def mounted(**changes) -> Any:
    """The paper's case, its operating clearance from fits; None leaves out a setting."""
    settings = {key: value for key, value in {**MOUNTED, **changes}.items() if value is not None}
    whole = re.sub(r'\nclearance = .*|\n"bearing.clearance" = .*', "", PAPER.read_text())
    return understood(whole, PAPER, settings, FAMILIES)


def in_fit(case):
    part = ring_parts.inner_part(case)
    assert part
    return inner_ring_in_fit(case, part, np.zeros(1)).fit


@pytest.mark.slow
def test_chain_and_finite_elements_have_one_pressure_and_one_growth():
    """30 um: 16.0 MPa in operation; a closed form for bodies of one length has 10.8 MPa, and 4.2 um more."""
    case = mounted(**{"inner.fit": "frictionless"})
    chain, fit = clearance.computed(case), in_fit(case)
    assert chain is not None
    assert chain.shaft_seat.pressure == approx(fit.mean_pressure, rel=1e-9) == approx(16.0e6, rel=2e-3)
    growth = mean_growth(fit, expansion.hot_over_cold(case, "inner_ring"))
    of_inner = sum(step.change for step in chain.steps if step.name.startswith("inner"))
    assert of_inner == approx(-2 * growth, rel=1e-9)
    plain = operating_clearance(fits._mounting(case), fits._running(case))
    assert plain.shaft_seat.pressure == approx(10.8e6, rel=1e-2)
    assert plain.clearance - chain.clearance == approx(4.22e-6, abs=0.05e-6)


@pytest.mark.slow
def test_pressure_of_a_short_ring_is_that_of_a_shell_under_a_band_of_pressure():
    """Shaft: long shell (Timoshenko, Plates and Shells, art. 115); ring: Lame, its ribs in parallel."""
    case = mounted(**{"inner.fit": "frictionless"})
    inner, _ = expansions(case)
    assert inner
    seat = inner(FitConditions()).seat
    assert seat
    a, b, r, rib = 25.8e-3, 29.8e-3, 32.45e-3, 34.8e-3
    shaft, ring = case.materials.shaft, case.materials.inner_ring
    radius, wall = (a + b) / 2, b - a
    decay = (3 * (1 - shaft.poisson_ratio**2)) ** 0.25 / np.sqrt(radius * wall)
    width = 2 * decay * 6e-3
    share = 1 - (1 + np.exp(-width) * (np.sin(width) - np.cos(width))) / (2 * width)
    tube = b / shaft.youngs_modulus * ((b**2 + a**2) / (b**2 - a**2) - shaft.poisson_ratio)

    def lame(outside):
        ratio = (outside**2 + b**2) / (outside**2 - b**2) + ring.poisson_ratio
        return b / ring.youngs_modulus * ratio

    stretched = 2 / (1 / lame(r) + 1 / lame(rib))
    assert seat.pressure == approx(15e-6 / (stretched + share * tube), rel=0.05)


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (
            {"inner.interference": "10 um"},
            r"inner.interference is now bearing.fits.shaft_interference, .*fits.housing.interference",
        ),
        ({"bearing.fits.shaft_interference": "10 um"}, r"shaft_interference = .* is not used: it belongs to"),
        ({"bearing.fits.housing.interference": "10 um"}, r"housing is not used: it belongs to"),
    ],
    ids=["second key", "beside a bonded ring", "beside a cage"],
)
def test_interference_that_changes_nothing_is_refused(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, settings)


def test_interference_presses_a_fit_beside_a_stated_clearance():
    case = read_case(PAPER, {"inner.fit": "friction", "bearing.fits.shaft_interference": "10 um"})
    assert clearance.operating(case) == approx(75.5e-6, rel=1e-12)
    assert case.shaft_interference == approx(10e-6, rel=1e-12)


@pytest.mark.slow
def test_ring_pressed_into_a_flexible_housing_loses_its_clearance_as_the_finite_elements_say():
    housed = {
        "outer.kind": "ring", "outer.support": "housing", "outer.housing_thickness": "8 mm",
        "outer.housing_width": "12 mm", "inner.kind": "rigid", "bearing.fits.bore": "59.6 mm",
        "bearing.fits.shaft_bore": "51.6 mm", "bearing.fits.housing.interference": "40 um",
        "operation.temperatures.housing": "218 degC", "bearing.fits.outer_diameter": None,
    }  # fmt: skip
    case = mounted(**housed)
    chain = clearance.computed(case)
    assert chain is not None
    assert chain.housing_seat is not None
    part: Any = ring_parts.outer_part(case)
    fit = outer_ring_in_housing(case, part, np.zeros(1)).fit
    assert chain.housing_seat.pressure == approx(fit.mean_pressure, rel=1e-9)
    steps = {step.name: step.change for step in chain.steps}
    assert steps["outer fit"] < -10e-6
