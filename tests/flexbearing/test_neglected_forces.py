"""What each kind of bearing neglects is a share of its load, and a danger where it is none to neglect."""

import re
from functools import cache

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.report.output import text
from flexbearing.runs.shoulders import reached_over
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.noted import codes

FAST = {"operation.speed": "10000 rpm", "operation.load.axial": "2 kN"}


@cache
def _solved(case, *settings):
    return flexbearing.run(CONFIGS / case, dict(settings))


def solved(case, settings):
    return _solved(case, *settings.items())


def shares(result):
    return {
        each["place"]: each["value"]
        for each in result.attributes["findings"]
        if each["code"] == "neglected-force"
    }


def test_a_four_point_bearing_that_turns_fast_counts_inertia():
    """342 N at rest; at 10 000 rpm 160 N press each ball outwards, and on the second outer arch."""
    result = solved("joshi2015_qj309.toml", FAST)
    assert result.rigid["contact_load"][0].ravel() == approx([329.5, 430.9, 0.0, 86.8], rel=1e-2)
    assert set(shares(result)) == {"orbit of the balls by friction", "weight of the balls", "friction"}
    assert shares(result)["orbit of the balls by friction"] < 0.01
    assert "neglected-force" not in codes(result)


def test_friction_that_cannot_hold_the_gyroscopic_moments_is_a_finding():
    arc = {"bearing.outer_arches": 1, "bearing.contact_angle": "8.34 deg", "bearing.clearance": "147.5 um"}
    fast = FAST | arc | {"friction.coefficient": 0.01}
    assert "gyroscopic-slip" in codes(solved("joshi2015_qj309.toml", fast), "outside validity")
    assert "gyroscopic-slip" not in codes(solved("joshi2015_qj309.toml", FAST))


def test_inertia_of_given_contact_loads_grows_with_the_square_of_the_speed():
    found = [
        shares(solved("joshi2015_ed20.toml", {"operation.speed": speed}))
        for speed in ("1000 rpm", "3000 rpm")
    ]
    for part in ("inertia of the balls", "gyroscopic moment of the balls"):
        assert found[1][part] == approx(9 * found[0][part], rel=1e-6)
        assert found[0][part] > 0


@pytest.mark.parametrize(
    ("case", "places"),
    [
        ("harris218.toml", {"weight of the balls", "friction"}),
        ("nu209.toml", {"gyroscopic moment of the rollers"}),
    ],
)
def test_every_family_prints_what_it_neglects(case, places):
    result = solved(case, {})
    assert set(shares(result)) == places
    assert "neglected-force" not in codes(result)


@pytest.mark.parametrize(
    ("case", "settings", "torque"),
    [("joshi2015_qj309.toml", FAST, "torque.inner"), ("harris218.toml", {}, "friction_torque")],
)
def test_friction_is_a_force_on_the_pitch_circle_over_the_loads_of_a_ring(case, settings, torque):
    result = solved(case, settings)
    of_a_ring = result.rigid["contact_load"].sum() / 2  # both rings carry the same
    radius = result.attributes["case_si"]["bearing"]["pitch_diameter"] / 2
    expected = abs(result[f"{torque} [N m]"].number) / radius / of_a_ring
    assert shares(result)["friction"] == approx(expected, rel=1e-6)


@pytest.mark.parametrize("case", ["joshi2015_qj309.toml", "harris218.toml"])
def test_weight_of_a_ball_is_taken_over_the_largest_load(case):
    result = solved(case, FAST if "qj" in case else {})
    given = result.attributes["case_si"]
    density = given["materials"]["ball"].get("density") or 7850.0
    weight = density * np.pi / 6 * given["bearing"]["ball"]["diameter"] ** 3 * 9.81
    expected = weight / result.rigid["contact_load"].max()
    assert shares(result)["weight of the balls"] == approx(expected, rel=1e-3)


def test_gyroscopic_moment_of_tilted_rollers_is_a_couple_over_the_largest_load():
    result = solved("nu209.toml", {"operation.misalignment": "4 arcmin"})
    given, rigid = result.attributes["case_si"], result.rigid
    diameter, length = (given["bearing"]["roller"][name] for name in ("diameter", "length"))
    mass = given["materials"]["roller"]["density"] * np.pi / 4 * diameter**2 * length
    loaded = rigid["inner_load"] > 0
    spin, tilt = (np.abs(rigid[name][loaded]).max() for name in ("roller_speed", "roller_tilt"))
    moment = mass * diameter**2 / 8 * abs(rigid["cage_speed"]) * spin * tilt
    expected = moment / length / rigid["inner_load"].max()
    assert shares(result)["gyroscopic moment of the rollers"] == approx(float(expected), rel=1e-6)


def test_balls_whose_friction_is_balanced_neglect_none():
    settings = {"operation.control": "coulomb", "friction.coefficient": 0.08}
    assert set(shares(solved("harris218.toml", settings))) == {"weight of the balls"}


@pytest.mark.parametrize("case", ["harris218.toml", "rivera2021_7008.toml"])
def test_reversed_thrust_is_a_danger(case):
    load = "-500 N"
    assert "reversed-thrust" in codes(solved(case, {"operation.load.axial": load}), "danger")
    assert "reversed-thrust" not in codes(solved(case, {}))


def test_contacts_where_no_race_is_are_a_danger():
    heavy = solved("joshi2015_qj309.toml", {"operation.load.axial": "300 kN"})
    assert "contact-height" in codes(heavy, "danger")
    limited = {"bearing.inner.shoulder": "4 mm", "bearing.outer.shoulder": "4 mm"}
    given = solved("joshi2015_qj309.toml", {"operation.load.axial": "300 kN"} | limited)
    assert "contact-height" not in codes(given)
    assert "truncated-contact" in codes(given, "danger")


def test_contacts_above_a_shoulder_are_counted_with_their_largest_angle():
    heights, angles = np.array([1e-3, 5e-3, 6e-3]), np.radians([80.0, -50.0, 40.0])
    (note,) = reached_over("inner", heights, angles, 20e-3, 4e-3, 0.8)
    assert note.text.startswith("2 contacts")
    assert "up to 6 mm, at contact angles of up to 50.0 deg" in note.text
    assert reached_over("inner", heights, angles, 20e-3, 7e-3, 1.0) == ()


def test_friction_torque_of_fast_balls_is_that_of_dry_contacts():
    assert "friction torque (dry, no cage, unless in the case) " in text(solved("rivera2021_7008.toml", {}))


@pytest.mark.parametrize(
    ("friction", "least"), [(0.1, 0.0), (1.0, 0.08)], ids=["little sticks", "much sticks"]
)
def test_fastsim_says_its_error_by_the_share_that_sticks(friction, least):
    """Its torque is above that of half-spaces by less than the note says, and by much where much sticks."""
    torque, words = {}, ""
    for model in ("fastsim", "kalker"):
        settings = {"friction.model": model, "friction.coefficient": friction, "friction.cells": (12, 24)}
        result = solved("rivera2021_7008.toml", settings)
        torque[model] = float(result.rigid["friction_torque"])
        if model == "fastsim":
            (words,) = [
                each["text"] for each in result.attributes["notes"] if each["code"] == "stick-and-slip"
            ]
    found = re.search(r"fastsim is up to ([0-9.]+)% above kalker", words)
    assert found
    assert least < torque["fastsim"] / torque["kalker"] - 1 < float(found[1]) / 100
