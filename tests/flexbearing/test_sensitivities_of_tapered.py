"""Derivatives of tapered roller bearings by keys: against cases that are solved again further away."""

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.derivatives.tapered import sensitivities
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.test_sensitivities_of_balls import errors_over_runs

CASE = CONFIGS / "32207.toml"
KEYS = (
    "bearing.roller.diameter", "bearing.roller.length", "bearing.pitch_diameter", "bearing.cup_angle",
    "bearing.rib.end_radius", "materials.roller.youngs_modulus", "operation.load.axial",
    "operation.load.radial_z", "operation.inner_speed",
)  # fmt: skip
OUTPUTS = ("life_L10", "peak_pressure.inner", "max_rib_load")
# Under tilt slices open all the time, where the stiffness has an unbounded slope.
CASES = {"fixed": ((), (*OUTPUTS, "stiffness_zz")), "free": (("operation.tilt=free",), OUTPUTS)}


@pytest.mark.parametrize(("settings", "outputs"), CASES.values(), ids=CASES)
def test_derivatives_are_those_of_runs(settings, outputs):
    found = sensitivities(api.read_case(CASE, list(settings)), outputs, KEYS)
    assert not found.left_out
    errors = errors_over_runs(found, CASE, settings, 1e-4)
    assert np.max(errors) < 2e-3


def test_life_falls_by_the_power_of_all_loads():
    """Without inertia all slices of straight rollers grow in one proportion; the rib nearly so."""
    case = api.read_case(CASE, ["materials.roller.density=0.001 kg/m^3", "bearing.roller.profile=straight"])
    found = sensitivities(case, ["life_L10"], ["operation.load.axial", "operation.load.radial_z"])
    elasticity = sum(
        found["life_L10", key.path].slope * key.stated / found.outputs[0].value for key in found.keys
    )
    assert elasticity == approx(-4.0, rel=1e-4)


def test_wrong_keys_are_refused():
    with pytest.raises(BadCase):
        sensitivities(api.read_case(CASE), (), ["bearing.rolers"])


@pytest.mark.parametrize(
    ("case", "settings", "key"),
    [
        ("32207", (), "operation.load.axial"),
        ("6209", (), "operation.load.radial_z"),
        ("nu209", (), "operation.radial_load"),
        ("joshi2015_fag", ("operation.mode=ring_load", "operation.load.axial=400 N"), "operation.load.axial"),
    ],
)
def test_life_is_an_output_of_every_family(case, settings, key):
    found = api.sensitivities(api.read_case(CONFIGS / f"{case}.toml", list(settings)), ["life"], [key])
    assert [each.name for each in found.outputs] == ["life_L10"]
    assert found.slopes.item() < 0
