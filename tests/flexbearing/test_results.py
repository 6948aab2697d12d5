import json
import os
import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from time import monotonic, sleep
from typing import Any

import h5py
import numpy as np
import pytest

from flexbearing import read
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput, NotStored
from flexbearing.files.atomic import host
from flexbearing.quantities.attributes import FORMAT
from flexbearing.quantities.layout import FIXED
from flexbearing.quantities.roller import LAYOUT
from flexbearing.results import BadResult, NotInLayout, ResultFile, hdf5_read, write
from flexbearing.results.hdf5_write import image
from tests.flexbearing.resealed import digest, resealed

ROLLERS = FAMILIES["cylindrical_roller"]
SIZE = {
    "Z": 5,
    "K": 3,
    "B": 4,
    "P": 2,
    "J": 2,
    "N": 7,
    "X": 6,
    "Y": 8,
    "S1": 9,
    "S2": 11,
    **{name: len(axis.entries) for name, axis in FIXED.items()},
}
BEGINNING = {
    "title": "Rollenlager, Außenring weich",
    "method": "newton",
    "case_text": 'title = "weich"\n' * 10_000,  # larger than an HDF5 attribute may be inside its header
    "case_file": "/home/user/cases/weich.toml",
    "case_overrides": ["bearing.clearance=50 um"],
    "case_si": {"bearing": {"clearance": 5e-5, "rollers": np.int64(5)}},
    "assumed": [],
    "calibrated": {"lubricant.oil_fraction": "cage slip of 6.28 %"},
}
STATE = {
    "largest_inner_load_N": 533.2,
    "loaded_rollers": 7,
    "life_L10_Mrev": 2534.0,
    "driving_torque_Nm": 1.88,
    "power_loss_W": 590.0,
    "slip_percent": None,
    "inner_loads_N": [533.2, 0.0],
}
ENDING = {
    "status": "converged",
    "ending": "converged",
    "message": "loads settled",
    "iterations": 2,
    "started_from": "results/nachbar.h5",
    "attempts": {"newton": {"iterations": 2, "status": "converged", "message": "loads settled"}},
    "wall_time_s": 1.5,
    "notes": [
        {"grade": "danger", "code": "film", "text": "film outside its range"},
        {"grade": "information", "code": "other", "text": "second"},
    ],
    "clearance": {"operating_m": -4e-6, "steps": []},
    "life": {"rigid": {"basic_Mrev": 10.0, "factors": [], "modified_Mrev": 12.0}},
    "life_rule": "Lundberg and Palmgren (1952)",
    "tilt": {"inner_ring": "free"},
    "regimes": {"rigid": {"inner": "mixed", "outer": "full film"}},
    "equilibria": {
        "rigid": {
            "raceways": "rigid raceways",
            "computed": STATE,
            "computed_is_stable": True,
            "others": [STATE],
            "after_passing_pitches": STATE | {"pitches": 2, "settled": True},
        }
    },
    "structure": {
        "inner": {
            "unknowns": 12_000,
            "elements": 99,
            "support_stiffness_N_per_m": None,
            "seconds": {"mesh": 0.5},
        }
    },
    "stresses": {
        "outer": {
            "bodies": {},
            "loads": "rollers",
            "left_out": "",
            "support": {
                "tilting_Nm_per_rad": 1e5,
                "tilting_error_Nm_per_rad": 1e3,
                "axial_N_per_m": 1e7,
                "axial_error_N_per_m": 1e5,
            },
            "seconds": 9.0,
        }
    },
    "choices": {
        "slices": {
            "level": "40",
            "fixed": False,
            "compared_with": ["20"],
            "changes": {"roller_load": 0.001},
            "factor": 2.0,
            "allowed": 0.004,
            "unusable": {},
        }
    },
    "passage": {
        "azimuth_deg": [0.0, 6.0],
        "status": ["converged", "not solved"],
        "values": {"max_roller_load_N": [100.0, None]},
        "mean_life_Mrev": 5.0,
    },
    "error_estimate": {"target": 0.01, "met": True, "roller_load": 0.002},
    "slice_error": {"slices": [40, 80], "roller_load": 0.002},
}


def values(place, seed=1, *, optional=False):
    draw = np.random.default_rng(seed).random
    return {
        name: draw([SIZE[axis] for axis in entry.shape])
        for name, entry in LAYOUT.datasets(place).items()
        if optional or not entry.optional
    }


def written(path, ending=ENDING, *, optional=False, **blocks):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        for number in range(1, ending["iterations"] + 1):
            file.iteration(number, values("iteration", seed=number, optional=optional))
        for name in ("rigid", "flexible"):
            file.block(name, blocks.get(name, values("block", seed=len(name), optional=optional)))
        file.finish(**ending)
    return path


@pytest.fixture
def path(tmp_path):
    return tmp_path / "case.h5"


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A whole result; tests change copies of it."""
    return written(tmp_path_factory.mktemp("good") / "case.h5", optional=True)


@pytest.fixture(scope="module")
def result(good):
    return read(good)


# -- what is written comes back ------------------------------------------------------------------


def test_every_dataset_comes_back_as_it_was_written(result):
    for block, seed in ((result.rigid, 5), (result.flexible, 8)):
        expected = values("block", seed, optional=True)
        assert block.keys() == expected.keys()
        for name, array in expected.items():
            np.testing.assert_array_equal(block[name], array, err_msg=name)


def test_history_stacks_a_dataset_over_the_iterations(result):
    for name in LAYOUT.datasets("iteration"):
        stacked = np.stack([values("iteration", seed, optional=True)[name] for seed in (1, 2)])
        np.testing.assert_array_equal(result.history(name), stacked, err_msg=name)


def test_attributes_come_back_as_the_program_uses_them(result):
    attributes = result.attributes
    not_asked_for = {"left_out", "catalogue_life", "assumed_effects", "effects_left_out", "findings"}
    assert attributes.keys() == LAYOUT.attributes.keys() - not_asked_for
    assert attributes["title"] == "Rollenlager, Außenring weich"
    assert attributes["case_text"] == BEGINNING["case_text"]
    assert attributes["assumed"] == ()
    assert [note["text"] for note in attributes["notes"]] == ["film outside its range", "second"]
    assert [note["code"] for note in result.dangers] == ["film"]
    assert attributes["case_si"] == {"bearing": {"clearance": 5e-5, "rollers": 5}}
    for name in ("structure", "clearance", "life", "regimes"):
        assert attributes[name] == ENDING[name]
    assert (attributes["iterations"], attributes["wall_time_s"]) == (2, 1.5)
    assert attributes["versions"]["numpy"] == np.__version__
    assert attributes["versions"]["h5py"] == h5py.__version__


def test_what_was_read_cannot_be_changed(result):
    with pytest.raises(ValueError, match="read-only"):
        result.rigid["inner_load"][0] = 0.0
    with pytest.raises(TypeError):
        result.attributes["status"] = "converged"  # pyright: ignore[reportIndexIssue]


def test_a_run_without_flexible_parts_has_no_history(path):
    result = read(written(path, ENDING | {"iterations": 0}))
    assert result.iterations == ()
    assert result.history("load_change").size == 0


def test_a_misspelt_history_names_the_nearest_dataset(result):
    with pytest.raises(NotInLayout, match="Did you mean 'load_change'"):
        result.history("load_chagne")


# -- readable without the project ----------------------------------------------------------------


def opened(path: Path) -> Any:
    """A result file as `h5py` alone opens it."""
    return h5py.File(path, "r")


def test_plain_h5py_finds_unit_axes_and_meaning_of_every_dataset(good):
    table = {entry.name: entry for entry in LAYOUT.quantities}
    with opened(good) as file:
        meanings = json.loads(file.attrs["meanings"])
        found = {group: file[group] for group in ("rigid", "flexible", "iterations")}
        for group, inside in found.items():
            for name, item in inside.items():
                entry = table[name]
                assert item.attrs["units"] == entry.unit
                assert meanings[name] == entry.meaning
                assert item.dtype == np.float64
                axes = ["iteration"] if group == "iterations" else []
                axes += [LAYOUT.axis[axis].name for axis in entry.shape]
                assert [axis[0].name for axis in item.dims] == [f"/{axis}" for axis in axes]
                assert [axis[0].size for axis in item.dims] == list(item.shape)
        assert {len(rows) for rows in file["iterations"].values()} == {2}
        assert file["flexible/inner_slice_load"].shape == (5, 3)
        assert {name for inside in found.values() for name in inside} == table.keys()


def test_plain_h5py_reads_the_root_attributes_as_texts_and_numbers(good):
    with opened(good) as file:
        assert file.attrs["format"] == FORMAT
        assert file.attrs["status"] == "converged"
        assert list(file.attrs["case_overrides"]) == ["bearing.clearance=50 um"]
        assert list(file.attrs["assumed"]) == []
        assert json.loads(file.attrs["calibrated"]) == {"lubricant.oil_fraction": "cage slip of 6.28 %"}


# -- a name without .part is a promise -----------------------------------------------------------


def test_interrupted_run_leaves_what_it_reached_in_a_part_file(path):
    file = ResultFile(path, BEGINNING, ROLLERS)

    def interrupted():
        with file:
            file.iteration(1, values("iteration"))
            file.block("rigid", values("block"))
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt) as problem:
        interrupted()
    kept = f"the state with rigid raceways and 1 iteration kept in {file.part}"
    assert problem.value.__notes__ == [kept]
    with pytest.raises(NotInLayout, match="not open"):
        file.iteration(2, values("iteration"))
    assert {entry.name for entry in path.parent.iterdir()} == {file.part.name}
    part = read(file.part)
    assert (part.attributes["status"], len(part.iterations)) == ("unfinished", 1)
    assert part.attributes["title"] == BEGINNING["title"]
    np.testing.assert_array_equal(part.rigid["inner_load"], values("block")["inner_load"])


def test_bad_input_found_late_leaves_nothing(path):
    """As a drawing that is read after the state with rigid raceways."""

    def refused():
        with ResultFile(path, BEGINNING, ROLLERS) as file:
            file.block("rigid", values("block"))
            file._store_part()
            raise BadCase("the drawing is no drawing")

    with pytest.raises(BadCase) as problem:
        refused()
    assert not hasattr(problem.value, "__notes__")
    assert list(path.parent.iterdir()) == []


def test_run_that_breaks_off_before_anything_is_finished_leaves_nothing(path):
    def broken():
        with ResultFile(path, BEGINNING, ROLLERS):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt) as problem:
        broken()
    assert not hasattr(problem.value, "__notes__")
    assert list(path.parent.iterdir()) == []


def test_forgotten_finish_leaves_the_part_file(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
    assert [entry for entry in path.parent.iterdir()] == [file.part]


def test_finished_run_leaves_only_the_final_file(path):
    written(path)
    assert [file.name for file in path.parent.iterdir()] == ["case.h5"]


def test_earlier_result_stays_until_the_new_one_is_complete(path):
    path.write_text("earlier")
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
        file.block("rigid", values("block"))
        assert path.read_text() == "earlier"
        file.finish(**ENDING | {"iterations": 1, "status": "not solved"})
    assert read(path).attributes["status"] == "not solved"


def test_iterations_reach_the_disk_while_the_run_goes_on(path, monkeypatch):
    monkeypatch.setattr("flexbearing.results.write.LATEST", 0.01)
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        for number in (1, 2):
            file.iteration(number, values("iteration", seed=number))
            assert waited(
                lambda number=number: file.part.exists() and len(read(file.part).iterations) == number
            )
        file.block("rigid", values("block"))
        assert waited(lambda: read(file.part).rigid)
        assert not path.exists()


def test_nothing_stays_in_memory_for_more_than_a_second():
    assert write.LATEST <= 1.0


def waited(until, seconds=120.0):
    end = monotonic() + seconds
    while not until():
        if monotonic() > end:
            return False
        sleep(0.005)
    return True


def test_disk_that_is_full_in_between_ends_the_run_with_a_reason(path, monkeypatch):
    def full(*_, **__):
        raise NotStored("no space")

    path.write_text("earlier")
    monkeypatch.setattr("flexbearing.results.write.LATEST", 0.01)
    monkeypatch.setattr("flexbearing.results.write.write", full)

    def run():
        with ResultFile(path, BEGINNING, ROLLERS) as file:
            for number in range(1, 4000):
                file.iteration(number, values("iteration"))
                sleep(0.005)

    with pytest.raises(NotStored, match="no space") as problem:
        run()
    assert not hasattr(problem.value, "__notes__")  # it says all there is to say
    assert [(entry.name, entry.read_text()) for entry in path.parent.iterdir()] == [("case.h5", "earlier")]


def test_interrupted_run_says_what_it_could_not_keep(path, monkeypatch):
    def full(*_, **__):
        raise NotStored("no space")

    def run():
        with ResultFile(path, BEGINNING, ROLLERS) as file:
            file.iteration(1, values("iteration"))
            monkeypatch.setattr("flexbearing.results.write.write", full)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt) as problem:
        run()
    assert problem.value.__notes__ == ["what was finished could not be kept: no space"]


def test_second_writer_is_refused_before_it_computes(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
        words = f"is being written by process {os.getpid()} on"
        with pytest.raises(BadOutput, match=words), ResultFile(path, BEGINNING, ROLLERS):
            pytest.fail("two writers")
        file.finish(**ENDING | {"iterations": 1, "status": "not solved"})
    assert len(read(path).iterations) == 1


def test_parts_of_dead_runs_go_when_a_result_is_there_and_others_are_named(path, caplog):
    dead, elsewhere = (path.with_name(f"case.h5.{who}-99999-0123abcd.part") for who in (host(), "node17"))
    for part in (dead, elsewhere):
        part.touch()
    with caplog.at_level("INFO"):
        written(path)
    assert {entry.name for entry in path.parent.iterdir()} == {"case.h5", elsewhere.name}
    assert "left of process 99999 on node17" in caplog.text


def test_stored_whole_what_a_killed_process_left_of_it_is_gone(path):
    whole = read(written(path))
    path.with_name(f"case.h5.{host()}-99999-0123abcd.tmp").write_bytes(b"torn")
    write.store(whole, path)
    assert [entry.name for entry in path.parent.iterdir()] == ["case.h5"]


@pytest.mark.slow
def test_reader_of_a_part_file_never_sees_it_torn(path, monkeypatch):
    monkeypatch.setattr("flexbearing.results.write.LATEST", 0.001)
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
        assert waited(file.part.exists)
        for number in range(2, 40):
            file.iteration(number, values("iteration", seed=number))
            sleep(0.002)
            assert 1 <= len(read(file.part).iterations) <= number


def test_directory_of_the_result_is_made(path):
    deep = path.parent / "a" / "b" / "case.h5"
    assert written(deep).is_file()


@pytest.mark.parametrize("name", ["case.h5.part", ""], ids=["part", "directory"])
def test_impossible_names_are_refused_before_the_run(tmp_path, name):
    with pytest.raises(BadOutput, match=r"unfinished files|is a folder"):
        ResultFile(tmp_path / name, BEGINNING, ROLLERS)


# -- only what stands in the table ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"inner_laod": np.zeros(5)}, "'inner_laod' is not in the layout.*Did you mean 'inner_load'"),
        ({"load_change": 0.1}, "'load_change' is not in the layout"),
        ({"outer_load": np.zeros(4)}, r"outer_load has shape \(4,\).*\(Z\) with Z = 5"),
        ({"outer_slice_load": np.zeros((3, 5))}, r"outer_slice_load has shape \(3, 5\).*\(Z, K\)"),
        ({"ring_tilt": np.zeros(3)}, r"ring_tilt has shape \(3,\).*slope = 2"),
        ({"life_L10": np.zeros(1)}, r"life_L10 has shape \(1,\).*\(\)"),
        ({"inner_load": 1.0}, r"inner_load has shape \(\).*\(Z\)"),
        ({"outer_film": np.full(5, np.nan)}, "outer_film holds 5 of 5 numbers that are not finite"),
        ({"stiffness": np.inf}, "stiffness holds 1 of 1 numbers"),
    ],
    ids=["misspelt", "of iterations", "rollers", "transposed", "pair", "scalar", "lost axis", "nan", "inf"],
)
def test_block_refuses_what_the_table_does_not_hold(path, change, words):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        with pytest.raises(NotInLayout, match=words):
            file.block("rigid", values("block") | change)
        file.block("rigid", values("block"))  # nothing was written by halves


def test_missing_datasets_are_named(path):
    incomplete = values("block")
    del incomplete["roller_tilt"], incomplete["life_L10"]
    with (
        ResultFile(path, BEGINNING, ROLLERS) as file,
        pytest.raises(NotInLayout, match="life_L10, roller_tilt missing"),
    ):
        file.block("flexible", incomplete)


OPTIONAL = [name for name, entry in LAYOUT.datasets("block").items() if entry.optional]


def test_optional_datasets_may_be_absent_and_then_are_absent_again(path):
    assert {"inner_film_ratio", "modified_life", "cage_offset", "roller_skew"} <= set(OPTIONAL)
    block = {name: array for name, array in values("block").items() if name not in OPTIONAL}
    result = read(written(path, optional=True, rigid=block))
    assert not set(OPTIONAL) & result.rigid.keys()
    assert set(OPTIONAL) <= result.flexible.keys()


def test_only_the_compliance_may_be_infinite_in_a_solution(path):
    compliance = values("block")["compliance_matrix"].copy()
    compliance[0, 0] = np.inf
    result = read(written(path, rigid=values("block") | {"compliance_matrix": compliance}))
    assert result.rigid["compliance_matrix"][0, 0] == np.inf
    with (
        ResultFile(path, BEGINNING, ROLLERS) as file,
        pytest.raises(NotInLayout, match="compliance_matrix holds 1 of 25"),
    ):
        file.block("rigid", values("block") | {"compliance_matrix": np.where(compliance > 1, np.nan, 0.0)})


def test_sizes_hold_for_the_whole_file(path):
    one_more = {
        name: np.zeros([SIZE[axis] + (axis == "K") for axis in entry.shape])
        for name, entry in LAYOUT.datasets("block").items()
    }
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
        with pytest.raises(NotInLayout, match="with Z = 5, K = 3"):
            file.block("rigid", one_more)


def test_iterations_come_without_gaps(path):
    with (
        ResultFile(path, BEGINNING, ROLLERS) as file,
        pytest.raises(NotInLayout, match="iteration 2 after iteration 0"),
    ):
        file.iteration(2, values("iteration"))


def test_a_block_is_written_once(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.block("rigid", values("block"))
        with pytest.raises(NotInLayout, match="rigid was added before"):
            file.block("rigid", values("block"))


def test_diverged_iterations_and_blocks_are_kept_as_they_are(path):
    lost = values("block") | {"inner_load": np.full(5, np.nan)}
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration") | {"residual": np.inf})
        file.block("rigid", values("block"))
        file.block("flexible", lost, converged=False)
        with pytest.raises(NotInLayout, match="no converged block flexible"):
            file.finish(**ENDING | {"iterations": 1})
        file.finish(**ENDING | {"iterations": 1, "status": "not finite"})
    assert np.isnan(read(path).flexible["inner_load"]).all()


def test_a_run_that_never_solved_has_empty_blocks(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.finish(**ENDING | {"iterations": 0, "status": "not solved"})
    assert dict(read(path).rigid) == dict(read(path).flexible) == {}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"statusx": "converged"}, "Did you mean 'status'"),
        ({"status": "Converged"}, "'Converged' does not exist; it is one of: converged"),
        ({"iterations": 3}, "iterations = 3, but 0 were written"),
        ({"iterations": 0, "notes": "one text"}, "a list of records is wanted"),
        ({"iterations": 0, "wall_time_s": np.nan}, "a finite number is wanted"),
        ({"iterations": 0, "structure": "{}"}, "a mapping is wanted"),
        ({"iterations": 0, "structure": {"mesh": np.nan}}, "structure"),
    ],
    ids=["misspelt", "status", "count", "list", "nan", "json text", "nan in json"],
)
def test_ending_refuses_untrue_and_unknown_attributes(path, change, words):
    with ResultFile(path, BEGINNING, ROLLERS) as file, pytest.raises(NotInLayout, match=words):
        file.finish(**ENDING | {"status": "not solved", "iterations": 0} | change)
    assert not path.exists()


def test_missing_attributes_are_named(path):
    with (
        ResultFile(path, {"title": "x"}, ROLLERS) as file,
        pytest.raises(NotInLayout, match=r"case_text.*missing"),
    ):
        file.finish(**ENDING)


def test_a_finished_file_takes_nothing_more(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.finish(**ENDING | {"iterations": 0, "status": "not solved"})
        with pytest.raises(NotInLayout, match="not open"):
            file.block("rigid", values("block"))


# -- files that are no results -------------------------------------------------------------------


def test_missing_result_names_its_part_file(path):
    with ResultFile(path, BEGINNING, ROLLERS) as file:
        file.iteration(1, values("iteration"))
    with pytest.raises(BadResult, match=f"not there yet, only {file.part.name}"):
        read(path)


def test_missing_file_names_the_command_that_writes_it(path):
    with pytest.raises(BadResult, match=r"case\.h5: no such file. `flexbearing run"):
        read(path)


def test_other_files_are_refused(path):
    path.write_text("not HDF5")
    with pytest.raises(BadResult, match=r"case\.h5: not an HDF5 file"):
        read(path)


def test_truncated_result_is_refused(path):
    complete = written(path).read_bytes()
    path.write_bytes(complete[: len(complete) // 2])
    with pytest.raises(BadResult, match="damaged"):
        read(path)


def test_numbers_leave_a_list_of_texts_its_room(path, monkeypatch):
    """Results above 40 MB could not be read again, as their list of assumed keys might have been as long."""
    stored = hdf5_read.content(written(path).read_bytes())[0]
    monkeypatch.setattr(hdf5_read, "_TEXT_MEMORY", 2_000_000)
    name = next(name for name, array in stored.arrays.items() if array.ndim)
    arrays = {**stored.arrays, name: np.ones(400_000)}
    large = replace(stored, attributes={**stored.attributes, "assumed": ["outer.bars"] * 5}, arrays=arrays)
    assert hdf5_read.content(image(large))[0].attributes["assumed"] == ["outer.bars"] * 5


def test_hdf5_of_another_program_is_refused(path):
    with h5py.File(path, "w") as file:
        file["x"] = 1.0
    with pytest.raises(BadResult, match="not a result of flexbearing"):
        read(path)


def test_other_format_names_both_numbers(path):
    with h5py.File(written(path), "a") as file:
        file.attrs["format"] = FORMAT - 1
    with pytest.raises(
        BadResult, match=rf"format {FORMAT - 1}, written by flexbearing \d.*reads format {FORMAT}"
    ):
        read(path)


def test_file_from_before_the_change_of_axes_is_told_what_it_is(path):
    with h5py.File(written(path), "a") as file:
        file.attrs["format"] = 4
    with pytest.raises(BadResult, match=r'its axes are older: of balls z axial.*see "Axes and signs"'):
        read(path)


@pytest.mark.parametrize("lost", ["rigid/inner_load", "iterations/seconds"], ids=["block", "iteration"])
def test_result_with_a_lost_dataset_is_refused(good, path, lost):
    with h5py.File(shutil.copy(good, path), "a") as file:
        del file[lost]
    resealed(path)
    with pytest.raises(BadResult, match=f"{lost.rpartition('/')[2]} missing"):
        read(path)


def test_digest_is_the_one_that_the_reference_page_describes(path):
    with h5py.File(written(path)) as file:
        assert file.attrs["digest"] == digest(path)


def exchanged_axes(file):
    """Another scale along an array, also of another length."""
    dataset = file["rigid/inner_load"]
    dataset.dims[0].detach_scale(file["roller"])
    dataset.dims[0].attach_scale(file["slice"])


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "change",
    [
        lambda file: file["rigid/inner_load"].__setitem__(0, 1.0),
        lambda file: file["rigid/life_L10"].__setitem__((), 1.0),
        lambda file: file.attrs.__setitem__("title", "another"),
        lambda file: file.attrs.__setitem__("wall_time_s", 1.25),
        lambda file: file["rigid/inner_load"].attrs.__setitem__("units", "kN"),
        lambda file: file["roller"].__setitem__(0, 1.0),
        exchanged_axes,
        lambda file: file.attrs.__delitem__("started_from"),
        lambda file: file.move("rigid", "flexiblee"),
    ],
    ids=["array", "scalar", "text", "number", "unit", "place", "axes", "attribute gone", "group renamed"],
)
def test_whatever_is_changed_in_a_file_is_seen(good, path, change):
    with h5py.File(shutil.copy(good, path), "a") as file:
        change(file)
    with pytest.raises(BadResult, match="changed after it was written"):
        read(path)


@pytest.mark.slow
def test_files_in_memory_are_not_taken_for_each_other(path):
    """The HDF5 library identifies files by name, also those that are in memory alone."""
    stored = hdf5_read.content(written(path).read_bytes())[0]
    titles = [f"bearing {number}" for number in range(12)]
    images = [image(replace(stored, attributes={**stored.attributes, "title": title})) for title in titles]
    with ThreadPoolExecutor(4) as pool:
        contents = list(pool.map(hdf5_read.content, images))
        again = list(pool.map(image, [content for content, _ in contents]))
    assert [content.attributes["title"] for content, _ in contents] == titles
    assert [hdf5_read.content(image)[0].attributes["title"] for image in again] == titles


def test_every_array_with_an_axis_carries_a_checksum(path):
    with opened(written(path)) as file:
        everything = [
            *file.values(),
            *(item for group in ("rigid", "iterations") for item in file[group].values()),
        ]
        arrays = [item for item in everything if isinstance(item, h5py.Dataset) and item.ndim]
        assert len(arrays) > 50
        assert all(array.fletcher32 for array in arrays)


def lose(*names):
    def change(file):
        for name in names:
            del file[name]

    return change


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lose("rigid"), "no converged block rigid"),
        (lose("flexible"), "no converged block flexible"),
        (lose("rigid", "flexible", "iterations"), "iterations = 2, but 0 were written"),
        (lambda file: file["flexible/inner_load"].__setitem__(2, np.nan), "inner_load holds 1 of 5 numbers"),
        (lambda file: file["rigid/life_L10"].__setitem__((), np.inf), "life_L10 holds 1 of 1"),
        (lambda file: file.attrs.__setitem__("iterations", 3), "iterations = 3, but 2"),
        (lambda file: file.attrs.__setitem__("status", "fine"), "status 'fine' does not exist"),
        (lambda file: file.attrs.__setitem__("kind", "plain"), "kind 'plain' is none of"),
    ],
    ids=["no rigid", "no flexible", "nothing", "nan", "inf", "count", "status", "kind"],
)
def test_converged_file_holds_its_solutions(good, path, change, words):
    resealed(shutil.copy(good, path), change)
    with pytest.raises(BadResult, match=words):
        read(path)


def flipped(data, bit):
    changed = bytearray(data)
    changed[bit // 8] ^= 1 << bit % 8
    return bytes(changed)


@pytest.mark.slow
def test_no_flipped_bit_changes_an_answer(path):
    """Where a bit means nothing the same content is read, everywhere else the file is refused."""
    data = written(path).read_bytes()
    good = hdf5_read.content(data)[0]
    places = np.random.default_rng(7).integers(8 * len(data), size=60)
    refused = 0
    for bit in places:
        path.write_bytes(flipped(data, int(bit)))
        try:
            result = read(path)
        except BadResult:
            refused += 1
            continue
        assert dict(result.attributes).keys() == good.attributes.keys() - {"meanings"}
        again = hdf5_read.content(path.read_bytes())[0]
        assert again.attributes == good.attributes
        assert all(np.array_equal(again.arrays[name], array) for name, array in good.arrays.items())
    assert refused > 20


# -- the reference page --------------------------------------------------------------------------


def test_a_heap_in_which_the_library_would_search_without_end_is_refused(path):
    """Its free space, the last object, takes no bytes: the library would look at it for ever."""
    whole = bytearray(written(path).read_bytes())
    free = [place for heap in re.finditer(rb"GCOL\x01", whole) if (place := free_space(whole, heap.start()))]
    whole[free[0] + 8 : free[0] + 16] = bytes(8)
    path.write_bytes(whole)
    with pytest.raises(BadResult, match="an object in a heap of texts has an impossible size"):
        read(path)


def free_space(data, heap):
    """Where the object of a global heap begins that is free space; None where it is full."""
    place, end = heap + 16, heap + int.from_bytes(data[heap + 8 : heap + 16], "little")
    while place + 16 <= end:
        if not int.from_bytes(data[place : place + 2], "little"):
            return place
        place += 16 + -(-int.from_bytes(data[place + 8 : place + 16], "little") // 8) * 8
    return None
