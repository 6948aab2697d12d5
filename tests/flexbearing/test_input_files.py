"""A case knows the files it was read from, so that no output replaces them."""

from pathlib import Path

import pytest

from flexbearing.api import read_case
from flexbearing.case.declarations import declared
from flexbearing.families import FAMILIES

CONFIGS = Path(__file__).parents[2] / "configs"


@pytest.mark.parametrize("name", ["mao2016", "joshi2015_qj309", "rivera2021_7008"])
def test_the_case_file_is_an_input(name):
    file = CONFIGS / f"{name}.toml"
    assert read_case(file).input_files == (file,)


def test_the_drawing_is_an_input_as_long_as_it_is_used():
    file = CONFIGS / "step_ring.toml"
    assert read_case(file).input_files == (file, CONFIGS / "step_ring.step")
    assert read_case(file, ["outer.kind=rigid"]).input_files == (file,)


@pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)
def test_keys_that_name_files_are_known(family):
    model = family.case()
    stated = {each.path for each in declared(model) if "to the case file" in each.meaning}
    assert stated == {*model.file_keys}
