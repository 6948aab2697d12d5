"""One run that uses most of what a case can ask for, between rigid rings."""

import json
import subprocess
import sys

import h5py
import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.report.output import text
from tests.places import ROOT

FITS = ROOT / "configs" / "nu209_fits.toml"
SETTINGS = [
    "operation.load_direction=30 deg",
    "operation.misalignment=1 arcmin",
    "operation.outer_speed=-200 rpm",
    "bearing.cage.guidance=outer",
    "bearing.cage.land_diameter=74.6 mm",
    "bearing.cage.land_width=3 mm",
    "bearing.cage.land_clearance=0.4 mm",
    "bearing.cage.land_flow=vortices",
    "bearing.roughness.outer_raceway=0.15 um",
    "lubricant.oil=ISO VG 32",
    "lubricant.traction=bair-winer",
    "lubricant.film=pan_hamrock",
    "lubricant.rolling=goksem-hargreaves",
    "lubricant.inlet_length=3.0",
    "lubricant.drag_coefficient=1.1",
]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return flexbearing.run(FITS, SETTINGS, output=tmp_path_factory.mktemp("run") / "many.h5")


def test_losses_by_cause_are_the_driving_power(run):
    with h5py.File(run.path) as file:
        losses = {name: file[f"rigid/{name}"][()] for name in file["rigid"] if name.startswith("loss_")}
        assert sum(losses.values()) == approx(file["rigid/driving_power"][()], rel=1e-8)
    for cause in ("sliding", "rolling", "drag", "pocket", "land", "churning"):
        assert losses[f"loss_{cause}"] > 0.0
    assert abs(losses["loss_transport"]) < 0.05 * sum(losses.values())
    numbers = run.summary()["rigid"]
    assert numbers["power_loss_W"]["total"] == approx(numbers["driving_power_W"], rel=1e-8)


def test_stiffness_and_compliance_are_inverse_but_for_the_axial_direction(run):
    stiffness, compliance = run.rigid["stiffness_matrix"], run.rigid["compliance_matrix"]
    assert compliance[0, 0] == np.inf
    assert stiffness[0] == approx(np.zeros(5), rel=0.0, abs=0.0)
    scale = np.sqrt(np.diag(stiffness)[1:])
    product = (stiffness[1:, 1:] / scale[:, None]) @ (compliance[1:, 1:] * scale)
    assert product == approx(np.eye(4), rel=1e-9, abs=1e-9)
    assert run.summary()["rigid"]["compliance_matrix_SI"][0][0] is None


def test_load_and_ring_point_the_same_way(run):
    load, azimuth = run.rigid["inner_load"], run.rigid["roller_azimuth"]
    resultant = np.array([load @ np.sin(azimuth), load @ np.cos(azimuth)])
    assert np.degrees(np.arctan2(*resultant)) == approx(30.0, abs=1.0)
    numbers = run.summary()["rigid"]
    assert numbers["displacement_along_load_um"] > 20 * abs(numbers["displacement_across_load_um"])


def test_radial_stiffness_is_that_along_the_load(run):
    direction = np.array([np.sin(np.radians(30)), np.cos(np.radians(30))])
    radial, angles = run.rigid["compliance_matrix"][1:3, 1:3], run.rigid["compliance_matrix"][3:, 3:]
    across, back = run.rigid["compliance_matrix"][1:3, 3:], run.rigid["compliance_matrix"][3:, 1:3]
    held = radial - across @ np.linalg.solve(angles, back)  # the guide holds the tilts
    assert run.rigid["stiffness"] == approx(1 / (direction @ held @ direction), rel=1e-9)
    assert run.rigid["total_stiffness"] == approx(run.rigid["stiffness"], rel=1e-12)


def test_film_ratios_are_films_over_the_roughness_of_each_contact(run):
    smallest = run.summary()["rigid"]["minimum_lambda"]
    for place, (side, raceway) in enumerate((("inner", 0.1e-6), ("outer", 0.15e-6))):
        sigma = np.hypot(0.05e-6, raceway)
        assert run.rigid[f"{side}_film_ratio"] == approx(run.rigid[f"{side}_film"] / sigma, rel=1e-12)
        assert smallest[side] == approx(run.rigid["minimum_film"][place] / sigma, rel=1e-12)
    for side, ratio in smallest.items():
        words = "boundary" if ratio < 1 else "mixed" if ratio < 3 else "full film"
        assert run.summary()["regimes"]["rigid"][side] == words


def test_modified_life_is_in_the_file_as_revolutions(run):
    assert run.rigid["modified_life"] == approx(
        1e6 * run.attributes["life"]["rigid"]["modified_Mrev"], rel=1e-12
    )
    assert run.rigid["life_L10"] == approx(1e6 * run.attributes["life"]["rigid"]["basic_Mrev"], rel=1e-12)


def test_everything_is_in_the_text(run):
    page = " ".join(text(run).split())
    for words in (
        "operating clearance, diametral, step by step",
        "inner rotation",
        "modified life, rigid",
        " a_1 ",
        "modified life",
        "smallest film ratio, outer",
        "lubrication regime",
        "tangent stiffness",
        "discretisation residual",
        "largest pocket force",
        "ISO VG 32: all but the grade are typical of mineral oils, recalled",
    ):
        assert words in page
    assert max(map(len, text(run).splitlines())) <= 80


def test_case_without_these_options_has_none_of_their_results():
    plain = flexbearing.run(ROOT / "configs" / "nu209.toml")
    assert not {"inner_film_ratio", "outer_film_ratio", "modified_life"} & plain.rigid.keys()
    assert plain.attributes["life"] == plain.attributes["regimes"] == {}
    assert plain.summary()["rigid"]["lambda_ratios"] is None
    for words in ("step by step", "modified life", "film ratio", "regime"):
        assert words not in text(plain)


@pytest.mark.slow
def test_bearing_that_is_not_solved_says_how_it_ended_and_exits_with_one(tmp_path):
    program = [sys.executable, "-m", "flexbearing"]
    words = ["run", FITS, "-o", tmp_path / "out.h5", "--set", "operation.radial_load=0 N"]
    found = subprocess.run([*program, *map(str, words)], capture_output=True, text=True, check=False)
    assert found.returncode == 1
    assert "Not converged (not solved" in found.stdout
    shown = subprocess.run(
        [*program, "summary", str(tmp_path / "out.h5"), "--json"], capture_output=True, text=True, check=True
    )
    numbers = json.loads(shown.stdout)
    assert (numbers["status"], numbers["ending"], numbers["rigid"]) == ("not solved", "undetermined", None)
    assert "no roller touches the inner ring" in numbers["message"]
    assert numbers["clearance"]["steps"]  # how it came to that
