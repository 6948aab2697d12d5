"""Profiles of rollers and raceways, from the keys of a case to the bearing."""

from math import pi

import numpy as np
import pytest
from pytest import approx

from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.runs.validate import require_possible
from flexbearing.studies.plan.task import identity
from quasidynamic import LogarithmicCrown, PointsProfile
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
DIAMETER, LENGTH = 10e-3, 9.601e-3
MODULUS = 207e9 / (1 - 0.3**2)  # E' of steel on steel
PARTS = ("roller", "inner_raceway", "outer_raceway")
DESIGNED = {"profile": "fujiwara_kawase", "design_load": "4 kN", "load_factor": "1.5", "crowned_share": "0.6",
            "end_drop": "20 um"}  # fmt: skip


def settings(part="roller", **keys):
    return [f"bearing.{part}.{name}={value}" for name, value in keys.items()]


def profile(part="roller", **keys):
    bearing = roller_bearing.parts(read_case(PLAIN, settings(part, **keys)))
    return (
        bearing.roller.profile if part == "roller" else getattr(bearing, part.replace("raceway", "profile"))
    )


@pytest.mark.parametrize("part", PARTS)
def test_profile_of_the_standard_follows_from_the_diameter(part):
    x = np.array([-0.4, 0.0, 0.45]) * LENGTH
    drop = profile(part, profile="iso16281").drop(x, LENGTH)
    assert drop == approx(0.00035 * DIAMETER * np.log(1 / (1 - (2 * x / LENGTH) ** 2)), rel=1e-12, abs=1e-20)


@pytest.mark.parametrize("part", PARTS)
def test_design_load_becomes_the_amplitude(part):
    amplitude = 2 * 4e3 / (pi * LENGTH * MODULUS)
    assert profile(part, profile="lundberg", design_load="4 kN").amplitude == approx(amplitude, rel=1e-12)
    ends = profile(part, profile="johns_gohar", design_load="4 kN")
    assert ends.amplitude == approx(amplitude, rel=1e-12)
    three = profile(part, **DESIGNED)
    assert isinstance(three, LogarithmicCrown)
    assert (three.amplitude, three.end_drop, three.crowned_share) == approx(
        (1.5 * amplitude, 20e-6, 0.6), rel=1e-12
    )


def test_width_of_the_contact_is_that_of_the_raceway_and_of_rollers_the_inner_one():
    inner, outer = (27.516e-3, -37.516e-3)
    of = {part: profile(part, profile="johns_gohar", design_load="4 kN") for part in PARTS}
    assert of["roller"] == of["inner_raceway"]
    wider = (1 / 5e-3 + 1 / inner) / (1 / 5e-3 + 1 / outer)  # squared widths are as the reduced radii
    shallower = of["roller"].amplitude * np.log(wider) / 2
    assert of["outer_raceway"].end_drop == approx(of["roller"].end_drop - shallower, rel=1e-9)


TABLES = {
    "commas": "drop [um],position [mm]\n0,0\n1.5,3\n12,4.8005\n\n",
    "semicolons, decimal commas": "drop [um]; position [mm]\n0; 0\n1,5; 3\n12; 4,8005\n",
    "tabs, decimal commas": "drop [um]\tposition [mm]\n0\t0\n1,5\t3\n12\t4,8005\n",
    "of a spreadsheet": "sep=;\n\ndrop [um];position [mm]\n0;0\n1.5;3\n12;4.8005\n",
}


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
@pytest.mark.parametrize("part", PARTS)
def test_points_come_from_a_file_beside_the_case_or_from_lists(part, table, tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(PLAIN.read_text())
    (tmp_path / "measured.csv").write_text(table)
    read = read_case(case, settings(part, profile="points", points_file="measured.csv"))
    assert read.named_files == (tmp_path / "measured.csv",)
    bearing = roller_bearing.parts(read)
    of_file = (
        bearing.roller.profile if part == "roller" else getattr(bearing, part.replace("raceway", "profile"))
    )
    of_lists = profile(
        part, profile="points", point_positions='["0 mm", "3 mm", "4.8005 mm"]',
        point_drops='["0 um", "1.5 um", "12 um"]',
    )  # fmt: skip
    assert isinstance(of_file, PointsProfile)
    x = np.linspace(-1, 1, 21) * LENGTH / 2
    assert of_file.drop(x, LENGTH) == approx(of_lists.drop(x, LENGTH), rel=1e-12)
    assert of_file.drop(np.array([3e-3]), LENGTH) == approx(1.5e-6, rel=1e-12)


def test_content_of_the_file_belongs_to_the_case(tmp_path):
    names = []
    for number, last in enumerate((12, 13)):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "case.toml").write_text(PLAIN.read_text())
        (folder / "p.csv").write_text(f"position [mm],drop [um]\n0,0\n4.8005,{last}\n")
        names.append(
            identity(read_case(folder / "case.toml", settings(profile="points", points_file="p.csv")))
        )
    assert names[0] != names[1]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, r'bearing.roller: "p.csv": there is no such file'),
        ("", r'"p.csv": has 0 columns: a header holds "position'),
        ("position,drop\n0,0\n", r"""has a column 'position': a header holds "position \[mm\]" and"""),
        ("position [mm],drop [kg]\n0,0\n", r"has a column 'drop \[kg\]'"),
        ("position [mm],position [mm]\n0,0\n", r"has 2 columns"),
        ("position [mm],drop [um],drop [mm]\n0,0,0\n", r"has 3 columns"),
        ("position [mm],drop [um]\n0,0\n1,one\n", r"'one' is no number"),
        ("position [mm],drop [um]\n0,0\n1\n", r"has a row of 1 numbers, not 2"),
        ("position [mm],drop [um]\n0,0\n4.7,3\n", r"bearing.roller: profile: points reach from 0 to 4.7 mm"),
        ("position [mm],drop [um]\n0,1\n4.8005,3\n", r"the least drop is 1 um"),
    ],
)  # fmt: skip
def test_file_that_holds_no_profile_is_told(text, words, tmp_path):
    (tmp_path / "case.toml").write_text(PLAIN.read_text())
    if text is not None:
        (tmp_path / "p.csv").write_text(text)
    case = read_case(tmp_path / "case.toml", settings(profile="points", points_file="p.csv"))
    with pytest.raises(BadCase, match=words):
        require_possible(case, FAMILIES["cylindrical_roller"])


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize(
    ("shape", "keys"),
    [
        ("crowned", ("straight_length", "crown_radius")),
        ("tangent_crowned", ("straight_length", "crown_radius")),
        ("lundberg", ("design_load",)),
        ("johns_gohar", ("design_load",)),
        ("fujiwara_kawase", ("design_load", "load_factor", "crowned_share", "end_drop")),
        ("points", ("point_positions", "point_drops")),
    ],
)
def test_keys_that_a_profile_lacks_are_told_at_once(part, shape, keys):
    with pytest.raises(BadCase) as told:
        read_case(PLAIN, settings(part, profile=shape))
    for name in keys:
        assert f"[bearing.{part}] {name} is missing: profile = " in str(told.value)
    assert len(str(told.value).splitlines()) == len(keys)


@pytest.mark.parametrize(
    ("part", "keys", "words"),
    [
        ("roller", {"profile": "iso16281", "drop": "2 um"}, "it belongs to bearing.roller.profile"),
        ("inner_raceway", {"drop": "2 um"}, 'this case has bearing.inner_raceway.profile = "straight"'),
        ("roller", {"profile": "lundberg", "design_load": "4 mm"}, "is not a force"),
        ("roller", {**DESIGNED, "crowned_share": "1.2"}, "at most 1"),
        ("outer_raceway", {"profile": "crowned", "straight_length": "10 mm", "crown_radius": "1 m"},
         r"\[bearing.outer_raceway\] straight_length .* at most bearing.roller.length"),
        ("inner_raceway", {"profile": "crowned", "straight_length": "1 mm", "crown_radius": "4 mm"},
         "more than half of bearing.roller.length"),
        ("roller", {"profile": "tangent_crowned", "straight_length": "9 mm", "crown_radius": "0.3 mm"},
         "without the straight middle"),
        ("roller", {"profile": "points", "points_file": "a.csv", "point_drops": '["0 um", "1 um"]'},
         r"\[bearing.roller\] point_drops .* left out where points_file gives the points"),
    ],
)  # fmt: skip
def test_keys_that_do_not_fit_are_refused(part, keys, words):
    with pytest.raises(BadCase, match=words):
        read_case(PLAIN, settings(part, **keys))


def test_straight_rollers_between_profiled_raceways_have_an_edge_stress():
    edge = ["life.edge_stress=true", "accuracy.slices=30", "bearing.roller.profile=straight"]
    one, both = (
        [line for part in parts for line in settings(part, profile="iso16281")]
        for parts in (PARTS[1:2], PARTS[1:])
    )
    with pytest.raises(BadCase, match="a straight roller has no known edge"):
        read_case(PLAIN, [*edge, *one])
    assert read_case(PLAIN, [*edge, *both]).life.edge_stress


def test_raceways_carry_the_profile_of_the_rollers():
    straight = ["bearing.roller.profile=straight"]
    on_raceways = [line for part in PARTS[1:] for line in settings(part, profile="iso16281")]
    there = roller_bearing.bearing(read_case(PLAIN, [*straight, *on_raceways])).solve()
    here = roller_bearing.bearing(read_case(PLAIN, settings(profile="iso16281"))).solve()
    assert there.slice_loads == approx(here.slice_loads, rel=1e-9, abs=1e-6)
