"""Numbers of the summary of many cases at once are those of each case."""

import numpy as np
import pytest
from pytest import approx

from flexbearing.outputs import outputs
from flexbearing.quantities.layout import FIXED
from flexbearing.quantities.reductions import across, along, loaded_arc, loaded_rollers
from flexbearing.quantities.roller import LAYOUT

CASES = 5
SIZES = {"Z": 9, "K": 6, "B": 7, "P": 3, "J": 5, "N": 20, "X": 5, "Y": 8, "S1": 4, "S2": 3} | {
    axis: len(fixed.entries) for axis, fixed in FIXED.items()
}
OF_ONE_CASE = ("skew.", "life.")  # parts of the solution that are computed case by case
NAMES = [
    output.name
    for output in outputs(LAYOUT)
    if not any(LAYOUT[name].source.startswith(OF_ONE_CASE) for name in output.declared.of)
]


@pytest.fixture(scope="module")
def block():
    """Arrays of any numbers (C, ...); contacts without load among them."""
    rng = np.random.default_rng(5)
    arrays = {}
    for name, entry in LAYOUT.datasets("block").items():
        arrays[name] = rng.uniform(-1.0, 1.0, (CASES, *(SIZES[axis] for axis in entry.shape)))
    for name in ("inner_load", "outer_load", "inner_film_ratio", "outer_film_ratio"):
        arrays[name] = np.maximum(arrays[name], 0.0)
    arrays["inner_load"][0] = 0.0
    arrays["inner_load"][1] += 1.0
    return arrays


@pytest.mark.parametrize("name", NAMES)
def test_an_output_of_many_cases_is_that_of_each(block, name):
    output = next(output for output in outputs(LAYOUT) if output.name == name)
    of_each = [output.numbers({key: array[case] for key, array in block.items()}) for case in range(CASES)]
    assert output.numbers(block) == approx(np.array(of_each), rel=1e-14, abs=0, nan_ok=True)


def test_every_scalar_but_those_of_skew_and_modified_life_has_many_cases():
    assert len(NAMES) > 35
    assert {"max_roller_load", "loaded_arc", "life_L10", "peak_pressure.inner", "stiffness_zz"} < set(NAMES)


def test_a_displacement_has_a_part_along_a_load_and_one_a_quarter_turn_ahead():
    azimuth, moved = np.array([0.3, 2.0]), np.array([[1.0, 2.0], [-0.5, 0.7]])
    sine, cosine = np.sin(azimuth), np.cos(azimuth)
    whole = along(moved, azimuth) * [sine, cosine] + across(moved, azimuth) * [cosine, -sine]
    assert whole.T == approx(moved)


def test_a_load_that_is_no_number_spoils_its_own_case_alone():
    azimuth, load = np.arange(4.0), np.array([[1.0, 2.0, 0.0, 0.0], [1.0, np.nan, 0.0, 0.0]])
    assert loaded_rollers(load) == approx([2.0, np.nan], nan_ok=True)
    assert loaded_arc(azimuth, load) == approx([1.0, np.nan], rel=1e-14, nan_ok=True)


@pytest.mark.parametrize(
    ("slices", "expected"), [(4, 2.5), (5, 3.0)], ids=["between two slices", "at a slice"]
)
def test_mid_roller_is_between_equal_slices(slices, expected):
    values = np.arange(1.0, slices + 1) * np.ones((3, 1))
    output = next(output for output in outputs(LAYOUT) if output.name == "mid_roller_deviation")
    block = {"inner_deviation": values, "outer_deviation": -0.1 * values}
    assert output.numbers(block) == approx(1e6 * expected, rel=1e-14)


def test_stiffness_along_z_is_an_entry_of_the_matrix_with_supports():
    output = next(output for output in outputs(LAYOUT) if output.name == "stiffness_zz")
    matrix = np.diag([0.0, 3e8, 7e8, 2e3, 5e2])
    assert (output.numbers({"stiffness_matrix": matrix}), output.unit) == (7e8, "N/m")
