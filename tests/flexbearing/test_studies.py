"""A study from its variants to its table: resumed, interrupted, with variants that fail or kill."""

import csv
import json
from dataclasses import replace
from functools import partial
from math import isnan

import pytest

from flexbearing.files import BadOutput, NotStored
from flexbearing.pages.make import report
from flexbearing.studies.engine import Done, finished
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.plan.task import NOT_STORED
from flexbearing.studies.prepare import compute
from flexbearing.studies.run import Work, run
from flexbearing.studies.table import journal
from flexbearing.studies.table.journal import SUFFIX
from tests.flexbearing.toy_studies import CASE, cubes, load, no_ring, toy


def computed(settled, folder, work=cubes, engine=None, **options):
    done = Work(partial(work, texts=settled.texts), no_ring)
    return run(settled, folder, done, lambda tasks: engine or Serial(), **options)


def counting(work=cubes):
    """The same work, and the loads of the variants that it was asked for."""
    loads = []

    def counted(task, texts):
        loads.extend(load(variant.values[0]) for variant in task.variants)
        return work(task, texts)

    return counted, loads


def read_csv(path):
    with path.open(newline="") as file:
        return list(csv.reader(file))


def test_the_table_has_keys_outputs_and_ends_with_units(tmp_path):
    table = computed(toy(tmp_path), tmp_path)
    header, *rows = read_csv(tmp_path / "toy.csv")
    ends = ["status", "message", "findings", "seconds"]
    assert header == ["operation.radial_load [N]", "life [Mrev]", "slip [%]", *ends]
    assert rows[0] == ["1000.0", "", "", "iteration limit", "after 200 iterations", "", "0.25"]
    assert rows[3] == ["4000.0", str(1000 / 64), "0.4", "converged", "", "", "0.5"]
    words = "danger: peak contact pressure, inner raceway: 4,500 MPa, at most 4,000 MPa (ISO 76): "
    assert rows[9][4].startswith(words)
    assert json.loads(rows[9][5]) == [
        {"code": "contact-pressure", "grade": "danger", "value": 4.5e9, "limit": 4e9,
         "places": ["inner raceway"]}
    ]  # fmt: skip
    assert len(rows) == len(table) == 10
    assert table.failed == 1
    assert table["slip"].values[9] == table.rows[9]["slip [%]"] == 1.0
    assert isnan(table["life [Mrev]"].values[0])


UNITS = {
    '"operation.inner_speed" = ["3000 rpm", "400 rad/s"]': ("operation.inner_speed [rpm]", "3000.0"),
    '"bearing.clearance" = "30 um"': ("bearing.clearance [um]", "30.0"),
    '"bearing.roller.length" = "10 mm"': ("bearing.roller.length [mm]", "10.0"),
    '"operation.moment" = "0 N mm"': ("operation.moment [N m]", "0.0"),
    '"operation.tilt" = "fixed"': ("operation.tilt", "fixed"),
    '"lubricant.oil_fraction" = 0.25': ("lubricant.oil_fraction", "0.25"),
    '"lubricant.density" = "0.85 kg/dm^3"': ("lubricant.density [kg/m^3]", "850.0"),
    '"lubricant.inlet_heating" = false': ("lubricant.inlet_heating", "False"),
}


@pytest.mark.parametrize(("text", "expected"), UNITS.items(), ids=list(UNITS))
def test_key_columns_have_the_units_of_engineers(tmp_path, text, expected):
    settled = toy(tmp_path, f'"operation.radial_load" = "5 kN"\n{text}')
    computed(settled, tmp_path)
    header, row, *_ = read_csv(tmp_path / "toy.csv")
    assert (header[1], row[1]) == expected


def test_a_second_start_computes_nothing_again(tmp_path):
    settled = toy(tmp_path)
    first = computed(settled, tmp_path)
    work, loads = counting()
    again = computed(settled, tmp_path, work)
    assert loads == []
    assert str(again.rows) == str(first.rows)


def test_failed_rows_are_computed_again_where_it_is_asked_for(tmp_path):
    settled = toy(tmp_path)
    computed(settled, tmp_path)
    work, loads = counting()
    computed(settled, tmp_path, work, retry_failed=True)
    assert loads == [1.0, 2.0]  # a task is computed whole


def test_another_axis_takes_the_rows_that_it_shares(tmp_path):
    computed(toy(tmp_path), tmp_path)
    work, loads = counting()
    computed(toy(tmp_path, '"operation.radial_load" = ["4000 N", "4.5 kN"]'), tmp_path, work)
    assert loads == [4.5]


def test_another_output_is_computed_anew(tmp_path):
    computed(toy(tmp_path, collect='[collect]\nlife = "life_L10"'), tmp_path)
    work, loads = counting()
    table = computed(toy(tmp_path), tmp_path, work)
    assert len(loads) == 10
    assert table["slip"].values[9] == 1.0


def test_what_an_interruption_finished_stays_and_is_told(tmp_path):
    settled = toy(tmp_path)

    def interrupted(task, texts):
        if load(task.variants[0].values[0]) > 5:
            raise KeyboardInterrupt
        return cubes(task, texts)

    with pytest.raises(KeyboardInterrupt) as problem:
        computed(settled, tmp_path, interrupted)
    assert problem.value.__notes__ == ["6 of 10 variants are kept, the same study goes on from there"]
    assert [row[3] for row in read_csv(tmp_path / "toy.csv")[1:]] == (
        ["iteration limit"] + ["converged"] * 5 + ["not computed"] * 4
    )
    for form in ("csv", "parquet"):
        (page,) = report(tmp_path / f"toy.{form}")
        assert "The table is partial: 4 are not computed" in page.read_text("utf-8")
        assert "row 1: iteration limit" in page.read_text("utf-8")  # of those without an answer, alone
    work, loads = counting()
    table = computed(settled, tmp_path, work)
    assert sorted(loads) == [7.0, 8.0, 9.0, 10.0]
    assert str(table.rows) == str(computed(settled, tmp_path / "at once").rows)


@pytest.mark.slow
def test_a_torn_journal_gives_the_same_table(tmp_path):
    settled = toy(tmp_path)
    at_once = computed(settled, tmp_path / "at once")
    path = settled.journal(tmp_path / "at once")
    for size in range(0, path.stat().st_size, 97):
        folder = tmp_path / str(size)
        folder.mkdir()
        settled.journal(folder).write_bytes(path.read_bytes()[:size])
        assert str(computed(settled, folder).rows) == str(at_once.rows)


def test_three_failures_of_a_hundred_are_rows_of_their_own(tmp_path):
    settled = toy(tmp_path, '"operation.radial_load" = "1 kN .. 100 kN, 100"')
    bad = {5.0: MemoryError("out of memory"), 50.0: ValueError("odd"), 77.0: RuntimeError("worse")}

    def failing(task, texts):
        for variant in task.variants:
            if problem := bad.get(load(variant.values[0])):
                raise problem
        return cubes(task, texts)

    table = computed(replaced_by_single(settled), tmp_path, failing)
    failed = {
        row["operation.radial_load [N]"]: row["message"] for row in table.rows if row["status"] == "error"
    }
    assert failed == {5e3: "MemoryError: out of memory", 50e3: "ValueError: odd", 77e3: "RuntimeError: worse"}
    assert table.failed == 3 + 1


def test_a_result_file_that_finds_no_place_ends_the_study_and_is_no_row(tmp_path):
    """Also where variants of the same task were finished before."""
    settled = toy(tmp_path)

    def full(task, texts):
        rows = cubes(task, texts)
        lost = [
            replace(row, status=NOT_STORED, message="x.h5: not written: the disk is full") for row in rows
        ]
        return [row if load(each.values[0]) < 6 else other
                for row, other, each in zip(rows, lost, task.variants, strict=True)]  # fmt: skip

    with pytest.raises(NotStored, match=r"x\.h5: not written: the disk is full") as problem:
        computed(settled, tmp_path, full)
    assert problem.value.__notes__ == ["5 of 10 variants are kept, the same study goes on from there"]
    work, loads = counting()
    table = computed(settled, tmp_path, work)
    assert sorted(loads) == [5.0, 6.0, 7.0, 8.0, 9.0, 10.0]  # tasks of two, computed whole
    assert str(table.rows) == str(computed(settled, tmp_path / "at once").rows)


def replaced_by_single(settled):
    """The same study, each variant in a task of its own."""
    variants = tuple(replace(each, rings=(each.identity,)) for each in settled.plan.variants)
    return replace(settled, plan=replace(settled.plan, variants=variants))


class Mortal(Serial):
    """An engine whose worker dies where the function says so."""

    workers = 2

    def as_completed(self):
        for done in super().as_completed():
            yield Done(done.argument, died=True) if done.problem.startswith("Death") else done


class Death(Exception):
    pass


def test_the_variant_that_kills_its_worker_is_found_and_the_others_are_computed(tmp_path):
    settled = toy(tmp_path, '"operation.radial_load" = "2 kN .. 41 kN, 40"')
    attempts = []

    def deadly(task, texts):
        loads = [load(variant.values[0]) for variant in task.variants]
        if 7.0 in loads:
            attempts.append(loads)
            raise Death
        return cubes(task, texts)

    table = computed(settled, tmp_path, deadly, Mortal())
    assert [row["operation.radial_load [N]"] for row in table.rows if row["status"] == "worker died"] == [7e3]
    assert table.failed == 1
    assert [len(loads) for loads in attempts] == [5, 3, 2, 1]


def test_a_worker_that_dies_once_leaves_no_trace(tmp_path):
    settled = toy(tmp_path, '"operation.radial_load" = "2 kN .. 41 kN, 40"')
    deaths = []

    def dying_once(task, texts):
        if not deaths:
            deaths.append(task)
            raise Death
        return cubes(task, texts)

    assert computed(settled, tmp_path, dying_once, Mortal()).failed == 0


def test_an_engine_is_never_given_more_than_twice_its_workers(tmp_path):
    tasks = toy(tmp_path, '"operation.radial_load" = "2 kN .. 81 kN, 80"').plan.tasks(lambda variant: True)

    class Counted(Mortal):
        largest = 0

        def submit(self, function, argument):
            super().submit(function, argument)
            self.largest = max(self.largest, len(self._waiting))

    engine = Counted()
    rows = [row for end in finished(tasks, lambda task: cubes(task, ()), engine) for row in end.rows]
    assert len(rows) == 80
    assert engine.largest == 4


def test_two_studies_of_one_name_do_not_write_one_folder(tmp_path):
    settled = toy(tmp_path)
    with (
        journal.opened(settled.journal(tmp_path), settled.texts),
        pytest.raises(BadOutput, match=r"toy\.journal\.jsonl is being written by process"),
    ):
        computed(settled, tmp_path)


def test_two_studies_of_other_names_share_a_folder(tmp_path):
    settled = toy(tmp_path)
    with journal.opened(settled.journal(tmp_path), settled.texts):
        assert computed(toy(tmp_path, name="other"), tmp_path).name == "other"


def test_files_of_others_in_the_folder_of_rings_are_kept(tmp_path, monkeypatch):
    monkeypatch.setenv("FLEXBEARING_CACHE", "off")
    names = "thin.rings/notes.txt", "thin.rings/sub/mine.csv"
    for name in names:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("mine")
    ring = tmp_path / "thin.rings" / f"{'0' * 64}.ring"
    ring.touch()
    compute(toy(tmp_path, '"operation.radial_load" = "5 kN"', name="thin"), tmp_path)
    assert [(tmp_path / name).read_text() for name in names] == ["mine", "mine"]
    assert not ring.exists()


def test_a_folder_that_cannot_be_written_is_told_before_anything_is_computed(tmp_path):
    (tmp_path / "file").write_text("")
    work, loads = counting()
    with pytest.raises(BadOutput, match="no folder to write to"):
        computed(toy(tmp_path), tmp_path / "file" / "results", work)
    assert loads == []


def test_progress_counts_rows_failures_and_the_time_left(tmp_path):
    heard = []
    table = computed(toy(tmp_path), tmp_path, tell=heard.append)
    assert [progress.done for progress in heard] == [0, 2, 4, 6, 8, 10]
    assert {progress.failed for progress in heard[1:]} == {1}
    assert heard[0].left is None
    assert heard[-1].left == 0.0
    resumed = []
    again = computed(toy(tmp_path), tmp_path, tell=resumed.append)
    assert str(again.rows) == str(table.rows)  # with messages and findings
    assert [(progress.done, progress.begun) for progress in resumed] == [(10, 10)]


def test_equal_variants_are_computed_once_and_stand_in_every_row(tmp_path):
    work, loads = counting()
    table = computed(toy(tmp_path, '"operation.radial_load" = ["5 kN", "5000 N", "5 kN"]'), tmp_path, work)
    assert len(loads) == 1
    assert table["life"].values == (8.0, 8.0, 8.0)


def test_a_study_that_goes_on_has_the_numbers_of_one_that_was_not_interrupted(tmp_path):
    """To the last digit: tasks are cut alike, whatever rows are there already."""
    from flexbearing.studies.study import study

    file = tmp_path / "s.toml"
    file.write_text(
        f'case = "{CASE}"\n[over]\n"operation.radial_load" = "1 kN .. 20 kN, 12"\n'
        '"bearing.clearance" = ["5 um", "20 um", "40 um"]\n'
    )
    whole = study(file, tmp_path / "whole", jobs=1)
    lines = (tmp_path / "whole" / f"s{SUFFIX}").read_bytes().splitlines(keepends=True)
    folder = tmp_path / "again"
    folder.mkdir()
    (folder / f"s{SUFFIX}").write_bytes(b"".join(lines[:17]))  # in the midst of a task
    again = study(file, folder, jobs=1)
    for one, other in zip(again.columns, whole.columns, strict=True):
        if one.name != "seconds":
            assert str(one.values) == str(other.values)
