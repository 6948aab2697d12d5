"""Derivatives of slow balls by keys: against cases solved again, identities, both sides, refusals."""

from functools import cache

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb
from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.derivatives.slow_balls import sensitivities
from flexbearing.runs import four_point
from tests.places import CONFIGS

LOADED, SLEWING, BOLTED = (
    CONFIGS / f"{name}.toml" for name in ("joshi2015_qj309", "joshi2015_fourpoint", "slewing_bolted")
)
GIVEN = CONFIGS / "heras2017_nominal.toml"
OUTPUTS = ["torque.outer", "peak_pressure.inner", "ball_speed_ratio_range.largest"]
KEYS = [
    "bearing.pitch_diameter", "bearing.ball.diameter", "bearing.inner.conformity", "bearing.contact_angle",
    "materials.ball.youngs_modulus", "friction.coefficient",
]  # fmt: skip
OWN = {  # outputs and keys of either case
    LOADED: (["max_contact_load", "stiffness_zz"], ["bearing.clearance", "operation.load.axial"]),
    GIVEN: (["power_loss"], ["operation.speed"]),
}
STEP = 1e-5  # of a value


def assert_are_those_of_cases_solved_again(path, found):
    values = np.array([output.value for output in found.outputs])
    for key in found.keys:
        size = abs(key.stated) or 10.0  # um of a clearance of zero
        texts = [f"{key.path}={key.stated + sign * STEP * size!r} {key.unit}".strip() for sign in (-1, 1)]
        ends = [fb.run(path, [text]) for text in texts]
        numbers = np.array([[end[output.name].number for output in found.outputs] for end in ends])
        again = (numbers[1] - numbers[0]) / (2 * STEP * size)
        slopes = np.array([found[output.name, key.path].slope for output in found.outputs])
        floor = 1e-2 * np.abs(values) / size  # elasticities below are rounding of the runs
        assert np.abs(slopes - again) / np.maximum(np.abs(again), floor) == approx(0.0, abs=1e-5), key.path


@pytest.mark.sampled(2)
@pytest.mark.parametrize("path", OWN, ids=lambda path: path.stem)
def test_derivatives_are_those_of_cases_solved_again(path):
    outputs, keys = OWN[path]
    found = sensitivities(api.read_case(path), [*OUTPUTS, *outputs], [*KEYS, *keys])
    assert not found.left_out
    assert_are_those_of_cases_solved_again(path, found)


@pytest.mark.slow
def test_elastic_rings_move_with_the_balls():
    outputs = [*OUTPUTS, "max_contact_load", "stiffness_zz", "largest_ring_yield"]
    keys = ["operation.load.moment_y", "bearing.clearance", "rings.outer.width"]
    found = sensitivities(api.read_case(BOLTED), outputs, keys)
    assert [key.path for key in found.keys] == keys[:2]
    assert found.left_out == (("rings.outer.width", "it changes an elastic ring, which is meshed anew; "
                               "vary it in a study"),)  # fmt: skip
    assert_are_those_of_cases_solved_again(BOLTED, found)


def test_displacement_by_load_is_the_compliance():
    case = api.read_case(SLEWING)
    key = "operation.load.radial_z"
    found = sensitivities(case, ["ring_displacement.z [m]"], [key])
    stiffness = fb.run(SLEWING).rigid["stiffness_matrix"]
    slope = found["ring_displacement.z", key].slope
    assert slope == approx(np.linalg.inv(stiffness)[2, 2], rel=1e-6)


@pytest.mark.slow
def test_where_a_diagonal_opens_both_sides_are_given():
    key, moment = "operation.load.moment_y", 378833.0  # [N m]

    def case(value):
        return api.read_case(SLEWING, [f"{key}={value!r} N m"])

    @cache
    def approach(value):
        distribution = four_point.solved(case(value)).distribution
        assert distribution is not None
        return distribution.approach

    nearest = np.unravel_index(np.abs(approach(moment)).argmin(), approach(moment).shape)
    at = moment
    for _ in range(4):  # the moment at which this diagonal opens
        slope = (approach(at + 10.0)[nearest] - approach(at)[nearest]) / 10.0
        at -= float(approach(at)[nearest] / slope)
    here = sensitivities(case(at), ["stiffness_zz"], [key])["stiffness_zz", key]
    assert here.one_sided
    assert here.below != here.above
    away = sensitivities(case(moment), ["stiffness_zz"], [key])["stiffness_zz", key]
    assert not away.one_sided


def test_contacts_that_stick_are_refused():
    with pytest.raises(BadCase, match=r"friction\.model is found by separate iterations"):
        sensitivities(api.read_case(LOADED, ["friction.model=fastsim"]), ["torque.inner"])
