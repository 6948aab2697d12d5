"""A run from Python that asks for no file: the same answer, nothing written."""

import numpy as np
import pytest

import flexbearing
from flexbearing.results import hdf5_write
from tests.places import CONFIGS

BEAM = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam"}  # nothing is meshed
CASES = {"mao2016": BEAM, "joshi2015_fag": {}, "rivera2021_7008": {}}
TIMES = ("created", "wall_time_s", "structure")
FOR_FILES = "slice_error"  # estimated where a file is written


@pytest.fixture
def empty(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", CASES)
def test_the_answer_is_that_of_the_file(name, empty):
    case = CONFIGS / f"{name}.toml"
    in_memory = flexbearing.run(case, CASES[name])
    assert list(empty.iterdir()) == []
    assert in_memory.path is None
    stored = flexbearing.read(flexbearing.run(case, CASES[name], output="out.h5").path)
    assert in_memory.attributes.keys() == stored.attributes.keys() - {FOR_FILES}
    for key in in_memory.attributes.keys() - set(TIMES):
        assert in_memory.attributes[key] == stored.attributes[key], key
    for block in ("rigid", "flexible"):
        ours, theirs = getattr(in_memory, block), getattr(stored, block)
        assert list(ours) == list(theirs)
        for key in ours:
            np.testing.assert_array_equal(ours[key], theirs[key], strict=True)
    assert len(in_memory.iterations) == len(stored.iterations)


def test_nothing_is_serialised(empty, monkeypatch):
    monkeypatch.setattr(hdf5_write, "image", None)
    monkeypatch.setattr(hdf5_write.h5py, "File", None)
    assert flexbearing.run(CONFIGS / "mao2016.toml", BEAM).attributes["status"] == "converged"


def test_its_arrays_cannot_change(empty):
    result = flexbearing.run(CONFIGS / "rivera2021_7008.toml")
    with pytest.raises(ValueError, match="read-only"):
        result.rigid["contact_load"][0] = 0.0


def test_another_run_starts_from_it_and_names_its_title(empty):
    first = flexbearing.run(CONFIGS / "mao2016.toml", BEAM)
    again = flexbearing.run(CONFIGS / "mao2016.toml", BEAM, start=first)
    assert again.attributes["started_from"] == f"result of {first.attributes['title']!r}"
    assert again.flexible["inner_load"] == pytest.approx(first.flexible["inner_load"], rel=1e-9, abs=1e-6)
