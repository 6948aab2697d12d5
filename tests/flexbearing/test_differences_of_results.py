"""Two results beside each other: keys first, then what their numerical errors do not explain."""

import json
from dataclasses import replace
from types import MappingProxyType

import pytest
from pytest import approx

import flexbearing
from flexbearing.__main__ import command
from flexbearing.differences.compared import Differing, compared
from flexbearing.results import BadResult
from tests.places import CONFIGS

CASE = CONFIGS / "nu209.toml"


@pytest.fixture(scope="module")
def loads(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    return [
        flexbearing.run(CASE, {"operation.radial_load": f"{load} kN"}, output=folder / f"{load}.h5")
        for load in (20, 21)
    ]


def test_keys_stand_in_the_units_of_tables(loads):
    (setting,) = compared(*loads).settings
    assert (setting.key, setting.unit, setting.one, setting.other) == (
        "operation.radial_load",
        "N",
        20e3,
        21e3,
    )


def test_keys_that_only_one_case_has_are_none_in_the_other(loads):
    one, other = loads
    less = {**other.attributes["case_si"]}
    less["operation"] = {key: value for key, value in less["operation"].items() if key != "inner_speed"}
    other = replace(other, attributes=MappingProxyType({**other.attributes, "case_si": less}))
    settings = {each.key: (each.one, each.other, each.unit) for each in compared(one, other).settings}
    assert settings["operation.inner_speed"] == (approx(3000, rel=1e-9), None, "rpm")


def test_the_same_result_twice_has_no_difference(loads):
    found = compared(loads[0], loads[0])
    assert (found.settings, found.outputs, found.within_error) == ((), (), ())
    assert "loaded_rollers" in found.without_estimate
    assert "life_L10" not in found.without_estimate


def test_outputs_in_the_units_of_the_summary_with_the_errors_of_both(loads):
    one, other = loads
    life = next(each for each in compared(one, other).outputs if each.name == "life_L10")
    assert (life.unit, life.one) == ("Mrev", approx(float(one["life_L10"]), rel=1e-12))
    errors = [float(each["life_L10"]) * float(each["life_error"]) / 100 for each in loads]
    assert life.error == approx(sum(errors), rel=1e-12)


@pytest.mark.parametrize(
    ("one", "other", "error", "explained"),
    [(1.0, 1.1, 0.2, True), (1.0, 1.3, 0.2, False), (1.0, 1.0 + 1e-11, float("nan"), True),
     (1.0, 1.0 + 1e-6, float("nan"), False), (float("inf"), float("inf"), float("nan"), True),
     (1.0, float("nan"), 0.2, False), (float("nan"), float("nan"), float("nan"), True)],
)  # fmt: skip
def test_a_difference_is_explained_by_its_error_or_by_rounding_alone(one, other, error, explained):
    assert Differing("x", "N", one, other, error).explained is explained


def test_errors_of_a_target_are_absolute_in_the_unit_of_the_output(loads):
    """Relative ones of the loads, in shares of 1 for the slip: 0.01 is 1 % of it."""
    estimate = {"target": 0.02, "met": True, "roller_load": 0.03, "cage_slip": 0.01}
    one, other = (
        replace(each, attributes=MappingProxyType({**each.attributes, "error_estimate": estimate}))
        for each in loads
    )
    found = compared(one, other)
    errors = {each.name: each.error for each in (*found.outputs, *found.within_error)}
    assert errors["max_roller_load"] == approx(
        0.03 * (float(one["max_roller_load"]) + float(other["max_roller_load"])), rel=1e-12
    )
    assert errors["cage_slip"] == approx(2.0, rel=1e-12)  # [%]
    assert "max_roller_load" in [each.name for each in found.within_error]


def test_results_of_two_kinds_are_not_compared(loads):
    ball = flexbearing.run(CONFIGS / "harris218.toml")
    with pytest.raises(BadResult, match="nothing to compare"):
        compared(loads[0], ball)


def test_command_as_text_and_as_json(loads, capsys):
    words = ["diff", *(str(each.path) for each in loads)]
    assert command(words) == 0
    said = capsys.readouterr().out
    assert "operation.radial_load: 20,000 N | 21,000 N" in said
    assert said.index("operation.radial_load") < said.index("max_roller_load")
    assert command([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [each["key"] for each in found["settings"]] == ["operation.radial_load"]
    errors = {each["name"]: each["error"] for each in found["outputs"]}
    assert 0 < errors["max_roller_load"] < 100  # [N] by finer slices
    assert command(["diff", words[1], "nothing.h5"]) == 2


def test_limits_that_one_result_keeps_and_the_other_does_not_are_named(loads):
    light, heavy = loads[0], flexbearing.run(CASE, {"operation.radial_load": "30 kN"})
    found = [(each.code, each.one, each.other) for each in compared(light, heavy).findings]
    assert found == [("heavy-load", "met", "not met"), ("pressed-end", "met", "not met")]
    assert compared(light, loads[1]).findings == ()
