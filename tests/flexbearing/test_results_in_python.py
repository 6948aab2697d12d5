"""A result as a Python object: shown, compared, carried to other processes, handed to xarray."""

import pickle
import subprocess
import sys
from dataclasses import replace
from html import escape
from pathlib import Path

import numpy as np
import pytest

import flexbearing
from tests.places import CONFIGS

BEAM = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam"}  # nothing is meshed
CASES = {"mao2016": BEAM, "joshi2015_fourpoint": {}, "rivera2021_7008": {}}


@pytest.fixture(scope="module", params=CASES, ids=str)
def result(request):
    return flexbearing.run(CONFIGS / f"{request.param}.toml", CASES[request.param])


def test_a_few_lines_tell_its_answer(result):
    lines = repr(result).splitlines()
    assert all(len(line) <= 100 for line in lines)
    assert "nan" not in repr(result)
    assert lines[0] == result.attributes["title"]
    assert any(line.startswith("rigid") for line in lines) == bool(result.flexible)


def test_a_notebook_shows_the_same_with_foreign_text_escaped(result):
    foreign = replace(result, attributes={**result.attributes, "title": "<b>A & B"})
    table = foreign._repr_html_()
    assert "&lt;b&gt;A &amp; B" in table
    assert all(escape(line.words) in table for line in result.card.lines)


def test_a_run_that_was_not_solved_is_shown_too():
    stopped = {"coupling.max_iterations": 1, "coupling.fallback": False}
    unsolved = flexbearing.run(CONFIGS / "mao2016.toml", BEAM | stopped)
    assert repr(unsolved).startswith("Not converged (iteration limit)")
    empty = replace(unsolved, rigid={}, flexible={})
    for each in (unsolved, empty):
        assert [line.subject for line in each.card.lines] == ["", "notes"]  # no number of no solution


def test_a_result_comes_back_from_another_process_as_it_was(result):
    again = pickle.loads(pickle.dumps(result))
    assert again == result
    assert again.family is not None
    assert repr(again) == repr(result)
    assert again.summary() == result.summary()
    with pytest.raises(ValueError, match="read-only"):
        next(array for array in again.rigid.values() if array.ndim)[0] = 0.0


def test_results_of_one_case_are_equal_and_of_another_differ(tmp_path):
    case = CONFIGS / "mao2016.toml"
    one, again = flexbearing.run(case, BEAM), flexbearing.run(case, BEAM, output=tmp_path / "r.h5")
    assert one == again == flexbearing.read(tmp_path / "r.h5")
    assert one.attributes["created"] is not None
    assert one != flexbearing.run(case, BEAM | {"operation.radial_load": "15 kN"})
    changed = {**one.flexible, "cage_slip": np.nextafter(one.flexible["cage_slip"], 1)}
    assert one != replace(one, flexible=changed)
    assert one != replace(one, iterations=one.iterations[:-1])
    assert one != "result"
    with pytest.raises(TypeError, match="unhashable"):
        hash(one)


def test_xarray_has_names_places_words_and_units(result):
    layout, tree = result.family.layout(), result.to_xarray()
    for block in ("rigid", "flexible"):
        for name, array in getattr(result, block).items():
            np.testing.assert_array_equal(tree[block][name].values, array)
            assert tree[block][name].attrs["units"] == layout[name].unit
            assert tree[block][name].attrs["long_name"] == layout[name].meaning
    assert tree.attrs["status"] == "converged"


def test_xarray_selects_by_race_and_iteration():
    result = flexbearing.run(CONFIGS / "mao2016.toml", BEAM)
    tree = result.to_xarray()
    assert float(tree["flexible"]["peak_pressure"].sel(race="outer")) == result.flexible["peak_pressure"][1]
    last = tree["iterations"]["inner_load"].sel(iteration=len(result.iterations))
    np.testing.assert_array_equal(last, result.iterations[-1]["inner_load"])


def test_the_package_offers_little_and_loads_nothing():
    offered = {"Case", "new", "run", "read", "study", "explain", "__version__"}
    exceptions = set(dir(flexbearing)) - offered
    assert offered <= set(dir(flexbearing))
    assert all(issubclass(getattr(flexbearing, name), Exception) for name in exceptions)
    code = "import sys, flexbearing; print(*(name for name in sys.modules if name[:4] in ('flex', 'nump')))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "flexbearing"


def test_types_of_all_packages_are_told_to_checkers():
    packages = Path(flexbearing.__file__).parents[1]
    assert all((packages / name / "py.typed").is_file() for name in ("flexbearing", "fem", "quasidynamic"))
