"""A file given to the command of another kind of file is named for what it is, in one line."""

import pytest

from flexbearing.api import read, read_case
from flexbearing.case.problems import BadCase
from flexbearing.families import FAMILIES
from flexbearing.optimise.file import read as optimisation_of
from flexbearing.results import BadResult
from flexbearing.studies.file.read import read as study_of
from tests.places import CONFIGS

FILES = {
    "case": (CONFIGS / "mao2016.toml", "is a case file; flexbearing run computes it"),
    "study": (CONFIGS / "studies/mao2016_tolerances.toml", "is a study file; flexbearing study computes it"),
    "optimisation": (
        CONFIGS / "studies/optimum_planet.toml",
        "is an optimisation file; flexbearing optimise computes it",
    ),
}
READERS = {
    "case": read_case,
    "study": lambda file: study_of(file, FAMILIES),
    "optimisation": lambda file: optimisation_of(file, FAMILIES),
}


@pytest.mark.parametrize(("kind", "by"), [("case", "run"), ("study", "study"), ("optimisation", "optimise")])
def test_what_is_no_result_is_to_be_run_first(kind, by):
    file, _ = FILES[kind]
    with pytest.raises(BadResult) as problem:
        read(file)
    assert str(problem.value) == f"{file}: is no result; run it first: flexbearing {by} {file}"


@pytest.mark.parametrize("given", FILES)
@pytest.mark.parametrize("wanted", READERS)
def test_one_line_says_which_command_takes_the_file(given, wanted):
    file, said = FILES[given]
    if given == wanted:
        READERS[wanted](file)
        return
    with pytest.raises(BadCase) as problem:
        READERS[wanted](file)
    assert str(problem.value) == f"{file.name}: {said}"
