"""Scalar outputs by name: every one that the summary shows, in every unit of its kind."""

import json
import math

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.families import FAMILIES
from flexbearing.outputs import AbsentOutput, UnknownOutput, Value, WrongUnit, outputs, requested
from flexbearing.units import unit
from tests.places import CONFIGS

ROLLERS = FAMILIES["cylindrical_roller"].layout()
BEAM = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam"}  # nothing is meshed
PROBES = {
    "probes.azimuth_deg",
    *(f"probes.{along}_displacement_um" for along in ("axial", "radial", "tangential")),
    *(f"probes.{name}_um_per_m" for name in (
        "gauge_strain", "hoop_strain", "axial_strain", "radial_strain", "largest_strain", "smallest_strain",
        "strain_error")),
}  # fmt: skip
LISTS = {  # what the summary holds one by one for rollers, balls or directions
    "cylindrical_roller": {
        "roller_loads_N", "outer_loads_N", "roller_azimuths_deg", "stiffness_matrix_SI",
        "compliance_matrix_SI",
        "lambda_ratios", "skew.roller_skew_mrad", "skew.skew_moments_Nm", "skew.roller_thrusts_N",
        "skew.flange_forces_N", "ribs.rib_thrusts_N", *PROBES,
    },
    "four_point_ball": {
        "max_contact_loads_N", "contact_loads_N", "ball_azimuths_deg", "contact_angles_deg",
        "ball_speed_ratios", "ball_attitudes_deg", "ball_torques_Nm", "stiffness_matrix_SI",
        "arc_lives_Mrev", *PROBES,
    },
    "angular_contact_ball": {
        "contact_loads_N", "ball_azimuths_deg", "contact_angles_deg", "stiffness_matrix_SI", "first_lines",
        "second_lines", "line_counts", *PROBES,
    },
    "tapered_roller": {
        "roller_loads_N", "outer_loads_N", "rib_loads_N", "roller_azimuths_deg", "stiffness_matrix_SI",
    },
}  # fmt: skip
LISTS["thrust_roller"] = LISTS["tapered_roller"] - {"rib_loads_N"}
LISTS["spherical_roller"] = LISTS["thrust_roller"]
LISTS["deep_groove_ball"] = LISTS["angular_contact_ball"]


@pytest.fixture(scope="module")
def rollers():
    return flexbearing.run(CONFIGS / "mao2016.toml", BEAM)


@pytest.fixture(scope="module", params=["mao2016", "joshi2015_fourpoint", "rivera2021_7008", "6209"])
def result(request):
    return flexbearing.run(CONFIGS / f"{request.param}.toml", BEAM if request.param == "mao2016" else {})


def numbers(summary):
    """Scalars of a block of the summary by their keys, lists of named entries too."""
    for key, value in summary.items():
        if isinstance(value, dict):
            yield from ((f"{key}.{name}", number) for name, number in numbers(value))
        elif isinstance(value, int | float) or (isinstance(value, list) and len(value) in (2, 3)):
            yield key, value


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_output_says_whether_a_number_of_it_is_printed_as_zero(kind):
    for output in outputs(FAMILIES[kind].layout()):
        assert output.rounds_to_zero(0.0)
        assert not output.rounds_to_zero(3.0)


@pytest.mark.parametrize("kind", FAMILIES)
def test_names_are_those_of_the_summary_without_units(kind):
    layout = FAMILIES[kind].layout()
    declared = {output.declared.key for output in outputs(layout)}
    names = [output.name for output in outputs(layout)]
    assert len(set(names)) == len(names)
    assert {entry.key for entry in layout.summary} - declared == LISTS[kind]
    for output in outputs(layout):
        assert unit(output.unit).factor > 0
        assert output.meaning
        assert not output.name.endswith(("_N", "_Nm", "_um", "_mm", "_W", "_deg", "_MPa", "_percent", "_rpm"))


def test_every_scalar_of_the_summary_has_its_name(result):
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    layout = result.family.layout()
    compared = 0
    for block in ("rigid", "flexible"):
        by_key = dict(numbers(result.summary()[block] or {}))
        for output in outputs(layout):
            key = output.declared.key
            words = output.name.split(".")[-len(output.place) :] if output.place else []
            expected = by_key.get(".".join([key, *words]), by_key.get(".".join([key, *words[:-1]])))
            if isinstance(expected, list):
                expected = expected[output.place[-1]]
            if expected is not None:
                compared += 1
                found = requested(layout, f"{block}.{output.name}").number(blocks)
                assert found == approx(expected, rel=1e-14, abs=0), output.name
    assert compared > 25


def test_a_bare_name_means_the_flexible_block_where_there_is_one(rollers):
    assert rollers["max_roller_load"] == rollers["flexible.max_roller_load"]
    assert rollers["max_roller_load"] != rollers["rigid.max_roller_load"]
    balls = flexbearing.run(CONFIGS / "rivera2021_7008.toml")
    assert balls["peak_pressure.inner"] == balls["rigid.peak_pressure.inner"]


def test_units_of_the_same_kind_are_converted(rollers):
    load = rollers.flexible["inner_load"].max()
    assert rollers["flexible.max_roller_load [kN]"].number == approx(load / 1e3, rel=1e-15)
    assert rollers["max_roller_load"].to("lbf").number == approx(load / 4.4482216152605, rel=1e-15)
    slip = float(rollers.rigid["cage_slip"])
    assert rollers["rigid.cage_slip [1]"].number == approx(slip, rel=1e-15)
    assert rollers["rigid.cage_slip [%]"].number == approx(100 * slip, rel=1e-15)
    assert rollers["stiffness [kN/mm]"].number == approx(rollers.flexible["stiffness"] / 1e6, rel=1e-15)
    assert rollers["cage_speed"].to("rad/s").number == approx(rollers.flexible["cage_speed"], rel=1e-15)


def test_lives_are_revolutions_and_hours_at_the_speed_of_the_case(rollers):
    revolutions = float(rollers.flexible["life_L10"])
    hours = revolutions / 38000 / 60  # [rpm] of mao2016.toml
    assert rollers["life_L10"].to("h").number == approx(hours, rel=1e-14)
    assert rollers["life_L10 [h]"].number == approx(hours, rel=1e-14)
    assert rollers["life_L10 [Mrev]"].number == approx(revolutions / 1e6, rel=1e-15)
    assert rollers["life_L10 [rev]"].number == approx(revolutions, rel=1e-15)
    with pytest.raises(WrongUnit, match="another kind"):
        rollers["life_L10 [h]"].to("Mrev")


def test_a_bearing_at_rest_lives_for_ever():
    blocks = {"flexible": {"life_L10": np.array(1e6), "relative_speed": np.array(0.0)}}
    assert requested(ROLLERS, "life_L10 [h]").number(blocks) == math.inf


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("max_roler_load", "Did you mean max_roller_load"),
        ("flexible.life", "Did you mean life_L10"),
        ("rigid.max_roller_load_N", "Did you mean max_roller_load"),
        ("stiff.max_roller_load", "no output has this name"),
        ("max_roller_load kN", "The main ones are max_roller_load, life_L10,.* the documents list all"),
        ("", "no output has this name"),
    ],
)
def test_unknown_names_are_told_with_the_nearest(text, words):
    with pytest.raises(UnknownOutput, match=words):
        requested(ROLLERS, text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "max_roller_load [mm]",
            "'mm' is a unit of another kind than 'N'; allowed is N, lbf, kgf or an",
        ),
        ("max_roller_load [Newton]", r"'Newton' is no unit; allowed is N"),
        ("cage_slip [h]", "another kind"),
        ("cage_speed [h]", "another kind"),
        ("life_L10 [N]", "allowed is Mrev, .*, h, min, s or another"),
        ("max_roller_load []", "is no unit"),
    ],
)
def test_wrong_units_are_told_with_those_that_are_allowed(text, words):
    with pytest.raises(WrongUnit, match=words):
        requested(ROLLERS, text)


def test_absent_outputs_are_no_numbers_and_told_why(rollers):
    assert math.isnan(requested(ROLLERS, "skew.max_skew").number({"rigid": rollers.rigid}))
    assert math.isnan(requested(ROLLERS, "flexible.life_L10 [h]").number({"rigid": rollers.rigid}))
    with pytest.raises(AbsentOutput, match=r"skew\.max_skew: the case does not give roller_skew"):
        rollers["skew.max_skew"]
    balls = flexbearing.run(CONFIGS / "rivera2021_7008.toml")
    with pytest.raises(AbsentOutput, match="there is no flexible block"):
        balls["flexible.balls"]


def test_values_convert_arrays_and_show_their_unit():
    loads = Value(np.array([1000.0, 2500.0]), "N").to("kN")
    assert loads == Value(np.array([1.0, 2.5]), "kN")
    assert repr(loads) == "[1.  2.5] kN"
    assert repr(Value(0.25, "1")) == "0.25"
    assert float(Value(0.25, "1").to("%")) == 25
    assert json.dumps(float(Value(20e3, "N").to("kN"))) == "20.0"
    assert Value(np.nan, "N") == Value(np.nan, "N") != Value(np.nan, "kN")
