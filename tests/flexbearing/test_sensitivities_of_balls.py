"""Derivatives of fast balls by keys: against cases that are solved again, identities, refusals."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb
from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.derivatives.balls import sensitivities

CONFIGS = Path(__file__).parents[2] / "configs"
RADIAL, HARRIS = CONFIGS / "6209.toml", CONFIGS / "harris218.toml"
OUTPUTS = ["life_L10", "contact_load_range.inner.largest", "peak_pressure.outer", "stiffness_zz"]
KEYS = {
    "bearing.ball.diameter": "mm",
    "bearing.inner.radius": "mm",
    "bearing.outer.radius": "mm",
    "bearing.pitch_diameter": "mm",
    "materials.ball.youngs_modulus": "GPa",
    "materials.ball.density": "kg/m^3",
    "operation.inner_speed": "rpm",
}
OWN = {  # keys of either case
    RADIAL: {"bearing.clearance": "um", "operation.load.radial_z": "kN"},
    HARRIS: {"bearing.contact_angle": "deg", "operation.load.axial": "kN"},
}
STEP = 2e-6  # of a value


def solved_again(path, key, value, unit, settings=()):
    """Central differences of runs by a key, per its unit."""
    ends = [fb.run(path, [*settings, f"{key}={value * (1 + sign * STEP)!r} {unit}"]) for sign in (-1, 1)]
    numbers = np.array([[end[name].number for name in OUTPUTS] for end in ends])
    return (numbers[1] - numbers[0]) / (2 * STEP * value)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("path", OWN, ids=lambda path: path.stem)
def test_derivatives_are_those_of_cases_solved_again(path):
    keys = KEYS | OWN[path]
    found = sensitivities(api.read_case(path), OUTPUTS, list(keys))
    assert [key.unit for key in found.keys] == list(keys.values())
    values = np.array([output.value for output in found.outputs])
    for key in found.keys:
        again = solved_again(path, key.path, key.stated, key.unit)
        slopes = np.array([found[name, key.path].slope for name in OUTPUTS])
        floor = 1e-2 * np.abs(values) / abs(key.stated)  # elasticities below are rounding of the runs
        assert np.abs(slopes - again) / np.maximum(np.abs(again), floor) == approx(0.0, abs=1e-5), key.path


def test_held_ring_moves_with_the_key_that_holds_it():
    settings = ["operation.displacement.axial=10 um", "operation.load.axial="]
    case = api.read_case(HARRIS, settings)
    key = "operation.displacement.axial"
    found = sensitivities(case, OUTPUTS, [key])
    again = solved_again(HARRIS, key, 10.0, "um", settings[1:])
    slopes = [found[name, key].slope for name in OUTPUTS]
    assert slopes == approx(again, rel=1e-5, abs=0.0)


def test_displacement_by_load_is_the_compliance():
    case = api.read_case(HARRIS)
    found = sensitivities(case, ["ring_displacement.x [m]"], ["operation.load.axial"])
    slope = found["ring_displacement.x", "operation.load.axial"].slope * 1e-3  # [m/N]
    stiffness = fb.run(HARRIS).rigid["stiffness_matrix"]
    assert slope == approx(np.linalg.inv(stiffness)[0, 0], rel=1e-6)


def test_largest_load_of_balls_alike_has_a_corner_where_the_ring_tilts():
    found = sensitivities(api.read_case(HARRIS), OUTPUTS[1:2], ["operation.displacement.tilt_y"])
    slope = found[OUTPUTS[1], "operation.displacement.tilt_y"]
    assert slope.one_sided
    assert slope.below == approx(-slope.above, rel=1e-3)
    assert slope.above > 0


def test_class_boundary_is_a_jump_without_warnings():
    case = api.read_case(CONFIGS / "catalogue" / "6208.toml")
    found = sensitivities(case, ["life_L10"], ["bearing.fits.bore"])  # 40 mm, the end of a class
    assert found.left_out == (("bearing.fits.bore", "there is a jump of life_L10"),)


@pytest.mark.parametrize(
    ("setting", "words"),
    [
        ("operation.control=coulomb", "operation.control is found by separate iterations"),
        ("friction.model=fastsim", "friction.model is found by separate iterations"),
    ],
)
def test_friction_that_is_iterated_is_refused(setting, words):
    with pytest.raises(BadCase, match=words):
        sensitivities(api.read_case(HARRIS, [setting]), ["life"], ["operation.load.axial"])
