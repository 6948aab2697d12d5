"""Fast balls in oil as cases: what a result file has of them, and what a case must give."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check
from flexbearing.case import BadCase
from tests.places import CONFIGS

IN_OIL = {
    "operation.control": "oil", "lubricant.oil": "ISO VG 32", "lubricant.inlet_temperature": "70 degC",
    "lubricant.oil_fraction": 0.02, "lubricant.traction": "eyring", "lubricant.limiting_ratio": 0.05,
    "lubricant.mixed.boundary_friction": 0.1, "bearing.roughness": {
        "ball": "0.02 um", "inner_raceway": "0.05 um", "outer_raceway": "0.05 um"},
}  # fmt: skip


CASE = CONFIGS / "rivera2021_7008.toml"


def settings(changes):
    """Settings of a case; None leaves a key out."""
    merged = {**IN_OIL, "bearing.balls": 6, **changes}
    return {key: value for key, value in merged.items() if value is not None}


@pytest.fixture(scope="module")
def block(tmp_path_factory):
    """Quantities of a stored result, read again."""
    file = tmp_path_factory.mktemp("oil") / "7008.h5"
    flexbearing.run(CASE, settings({"lubricant.churning_gap": "1 mm"}), output=file)
    return flexbearing.read(file).rigid


def test_power_of_the_rings_is_the_heat_by_cause_in_the_file(block):
    power = block["ring_torque"][0] * 15000 * np.pi / 30
    causes = sum(block[f"loss_{cause}"] for cause in ("sliding", "rolling", "drag", "churning"))
    assert causes == approx(power, rel=1e-9)
    assert block["friction_heat"].sum() == approx(causes, rel=1e-12)
    assert block["sliding_heat"].sum() == approx(block["loss_sliding"], rel=1e-12)
    assert block["friction_torque"] == approx(block["ring_torque"][0], rel=1e-9)


def test_films_and_slip_are_in_the_file(block):
    rough = np.hypot(0.02e-6, 0.05e-6)
    assert block["film_ratio"] == approx(block["film"] / rough, rel=1e-12)
    assert block["mean_ball_slip"] == approx(block["ball_slip"].mean(), rel=1e-12)
    assert (block["sliding_power"] > 0).all()
    area = np.pi * block["semi_axis_across"] * block["semi_axis_along"]  # at the loaded contact angles
    assert block["friction_intensity"] == approx(block["sliding_heat"] / area, rel=5e-3)


CAGE = {
    "bearing.cage": {
        "guidance": "outer", "pocket_clearance": "0.15 mm", "pocket_friction": 0.05, "land_diameter": "60 mm",
        "land_width": "4 mm", "land_clearance": "0.4 mm"},
    "operation.load.radial_z": "300 N",
}  # fmt: skip


def test_sums_over_a_cage_in_the_file(tmp_path):
    file = tmp_path / "7008.h5"
    flexbearing.run(CASE, settings(CAGE), output=file)
    block = flexbearing.read(file).rigid
    power = block["ring_torque"][0] * 15000 * np.pi / 30
    causes = ("sliding", "rolling", "drag", "churning", "pocket", "land")
    assert sum(block[f"loss_{cause}"] for cause in causes) == approx(power, rel=1e-9)
    assert block["land_torque"] == approx(block["pocket_torque"].sum(), rel=1e-9)
    friction = block["pocket_torque"] - 54e-3 / 2 * block["cage_force"]
    assert (np.abs(friction) < 0.05 * 7.938e-3 / 2 * np.abs(block["cage_force"])).all()
    drag = block["loss_drag"] / block["cage_speed"]
    assert block["ring_torque"].sum() == approx(drag, rel=1e-3)  # balls orbit nearly as fast as the cage
    assert block["pocket_share"] == approx(block["pocket_displacement"] / 0.15e-3, rel=1e-12)
    assert 0 < block["cage_slip"] < 0.01


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"operation.control": "coulomb"}, "roughness is not used"),
        ({"operation.control": "outer", "bearing.roughness": None, "lubricant.mixed.boundary_friction": None},
         "left out but with operation.control"),
        ({"friction.model": "fastsim"}, "model"),
        ({"bearing.cage": {**CAGE["bearing.cage"], "land_diameter": "40 mm"}}, "cage. land_diameter"),
        ({"bearing.cage": {**CAGE["bearing.cage"], "pocket_clearance": "12 mm"}}, "cage. pocket_clearance"),
        ({"lubricant.oil_fraction": None}, "lubricant. oil_fraction is missing"),
        ({"bearing.roughness": None}, "roughness is missing"),
        ({"lubricant.oil": None, "lubricant.viscosity": "10 mPa s", "lubricant.density": "870 kg/m^3"},
         "pressure_viscosity"),
        ({"lubricant.oil": None, "lubricant.data_sheet": {
            "cold_temperature": "40 degC", "cold_viscosity": "46 cSt", "hot_temperature": "100 degC",
            "hot_viscosity": "6.8 mm^2/s"}}, "data_sheet. density is missing"),
    ],
)  # fmt: skip
def test_a_case_in_oil_names_what_is_missing_or_not_used(changes, words):
    with pytest.raises(BadCase, match=words):
        check(CASE, settings(changes))
