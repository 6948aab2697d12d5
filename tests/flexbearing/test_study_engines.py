"""Engines of studies: cores, worker processes that live and die, schedulers elsewhere."""

import os
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest

from flexbearing.case import BadCase
from flexbearing.program.threads import limited_to
from flexbearing.program.worker_processes import Processes
from flexbearing.studies.engine import Done, completed
from flexbearing.studies.engine.attempts import DIED
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.placement import RING, Placement, expected
from flexbearing.studies.plan import Ring
from flexbearing.studies.plan.task import Base, Variant, involves
from flexbearing.studies.prepare import prepare_source
from flexbearing.studies.run import Work, run
from tests.flexbearing import toy_studies
from tests.flexbearing.toy_studies import cubes, no_ring, toy
from tests.places import ROOT

pytestmark = pytest.mark.usefixtures("two_cores")

FORTY = '"operation.radial_load" = "2 kN .. 41 kN, 40"'


def computed(prepared, folder, engine, rows=cubes, **options):
    work = Work(partial(rows, texts=prepared.texts, **options), no_ring)
    return run(prepared, folder, work, lambda tasks: engine)


def test_one_job_and_short_studies_start_no_process(tmp_path):
    plan = toy(tmp_path).plan
    assert expected(plan) < 1
    for where in (Placement(jobs=1), Placement()):
        assert isinstance(where.engine(plan)(10), Serial)
    assert isinstance(Placement(jobs=4).engine(plan)(1), Serial)


def test_a_million_jobs_are_a_process_on_each_core(tmp_path, monkeypatch, caplog):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "3")
    with limited_to(1_000_000):
        assert Placement(jobs=1_000_000).engine(toy(tmp_path).plan)(5000).workers == 3
    assert caplog.messages == ["--jobs 1000000: only 3 compute, one on each core that this program may use"]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("first", "over"),
    [
        ('results = "final"', ""),
        ("", '"bearing.contact" = "half_space"'),
        ("", '"outputs.subsurface_stresses" = true'),
    ],
    ids=["result files", "half-spaces", "stresses below contacts"],
)
def test_variants_that_need_runs_of_their_own_are_expected_to_take_longer(first, over, tmp_path):
    loads = '"operation.radial_load" = "2 kN .. 41 kN, 400"'
    file = tmp_path / "alone.toml"
    file.write_text(f'case = "{toy_studies.CASE}"\n{first}\n[over]\n{loads}\n{over}\n')
    assert expected(prepare_source(file).plan) > 5 * expected(toy(tmp_path, loads).plan)


@pytest.mark.parametrize(
    ("case", "load", "plain", "divided"),
    [
        (
            "harris218_cage",
            "load.radial_z",
            '"operation.control" = "outer"',
            '"operation.control" = "coulomb"',
        ),
        ("harris218_cage", "load.radial_z", "", '"friction.model" = "fastsim"'),
        ("nu209", "radial_load", '"outputs.subsurface_stresses" = true', '"bearing.contact" = "half_space"'),
    ],
)
def test_contacts_in_cells_are_expected_to_take_five_times_as_long(case, load, plain, divided, tmp_path):
    """Measured: 0.05 and 0.45 s between elastic rings, 0.03 and 0.26 s between rigid ones."""
    of_rows = []
    for settings in (plain, divided):
        file = tmp_path / "study.toml"
        text = f'[set]\n{settings}\n[over]\n"operation.{load}" = "2 kN .. 5 kN, 40"'
        file.write_text(f'case = "{ROOT / "configs" / case}.toml"\n{text}')
        plan = prepare_source(file).plan
        of_rows.append(expected(plan) - RING * len(plan.rings()))
    assert of_rows[1] > 5 * of_rows[0]


def test_schedulers_and_queues_without_dask_say_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr("flexbearing.studies.placement.find_spec", lambda name: None)
    plan = toy(tmp_path).plan
    for where in (Placement(slurm=Path("site.toml")), Placement(scheduler="tcp://127.0.0.1:1")):
        with pytest.raises(BadCase, match=r'needs distributed.*: pip install "flexbearing\[studies\]"'):
            where.engine(plan)
    assert isinstance(Placement(jobs=2).engine(plan)(2), Processes)


def test_every_ring_is_condensed_once_whatever_becomes_of_its_worker():
    base = Base(Path("case.toml"), "", ())
    rings = [Ring(base, Variant((), ""), f"outer {number}") for number in range(6)]
    calls = []

    class Mortal(Serial):
        workers = 2

        def as_completed(self):
            for done in super().as_completed():
                yield Done(done.argument, died=done.problem == "ValueError: dead")

    def condense(ring):
        calls.append(ring.name)
        if ring.name == "outer 3" or calls == ["outer 0"]:
            raise ValueError("dead")

    assert len(list(completed(rings, condense, Mortal()))) == 6
    assert {name: calls.count(name) for name in set(calls)} == {
        f"outer {number}": {0: 2, 3: 3}.get(number, 1) for number in range(6)
    }


@pytest.mark.slow
def test_a_ring_that_ended_its_worker_is_condensed_by_the_careful_function():
    rings = [Ring(Base(Path("case.toml"), "", ()), Variant((), ""), name) for name in ("inner", "outer")]
    engine = Processes(1)
    ends = [*completed(rings, toy_studies.deadly_ring, engine, again=toy_studies.no_ring)]
    engine.close()
    assert [(done.argument.name, done.answer) for done in ends] == [("inner", "condensed"), ("outer", None)]
    assert not any(done.died for done in ends)


@pytest.mark.slow
def test_two_jobs_give_the_table_of_one(tmp_path):
    prepared = toy(tmp_path, FORTY)
    one, two = (
        computed(prepared, tmp_path / str(n), engine) for n, engine in enumerate((Serial(), Processes(2)))
    )
    assert str(one.rows) == str(two.rows)
    assert (tmp_path / "0" / "toy.csv").read_text() == (tmp_path / "1" / "toy.csv").read_text()


@pytest.mark.slow
def test_a_variant_that_kills_its_process_is_found_and_the_others_are_computed(tmp_path):
    place = tmp_path / "attempts"
    table = computed(toy(tmp_path, FORTY), tmp_path, Processes(2), toy_studies.deadly, place=place)
    (died,) = [row for row in table.rows if row["status"] == "worker died"]
    assert (died["operation.radial_load [N]"], died["message"], died["findings"]) == (7e3, DIED, "")
    assert table.failed == 1
    dangers = [
        row["operation.radial_load [N]"] for row in table.rows if "contact-pressure" in row["findings"]
    ]
    assert dangers == [1e3 * load for load in range(10, 42)]
    assert place.read_text().split() == ["5", "3", "2", "1"]


@pytest.mark.parametrize("load", [7.0, 12.0, 17.0, 18.0])
def test_what_waits_behind_a_deadly_variant_is_not_taken_for_it(load, tmp_path):
    """With one worker left of two, as while a new one starts."""
    prepared = toy(tmp_path, FORTY)

    class OneLeft(Serial):
        workers = 2

        def as_completed(self):
            while self._waiting:
                done, *others = list(super().as_completed())  # all that is submitted
                deadly = [each.problem == "ValueError: dead" for each in (done, *others)]
                for number, each in enumerate((done, *others)):
                    yield Done(each.argument, died=True) if any(deadly[: number + 1]) else each

    def deadly(task):
        if load in [toy_studies.load(variant.values[0]) for variant in task.variants]:
            raise ValueError("dead")
        return cubes(task, prepared.texts)

    table = run(prepared, tmp_path, Work(deadly, no_ring), lambda tasks: OneLeft())
    died = [row["operation.radial_load [N]"] for row in table.rows if row["status"] == "worker died"]
    assert died == [1e3 * load]


@pytest.mark.slow
def test_a_worker_that_somebody_kills_loses_nothing(tmp_path):
    place = tmp_path / "processes"
    place.mkdir()
    prepared, killed = toy(tmp_path, FORTY), []
    work = Work(partial(toy_studies.replaced_cubes, texts=prepared.texts, place=tmp_path), no_ring)

    def kill(progress):
        if progress.done > 10 and not killed:
            killed.append(int(next(place.iterdir()).name))
            os.kill(killed[0], signal.SIGKILL)
            (tmp_path / "killed").touch()

    table = run(prepared, tmp_path, work, lambda tasks: Processes(2), tell=kill)
    assert len(killed) == 1
    assert table.failed == 0
    assert len(list(place.iterdir())) == 3
    assert str(table.rows) == str(computed(prepared, tmp_path / "undisturbed", Serial()).rows)


DRIVER = """
import sys
from functools import partial
from pathlib import Path
from flexbearing.program.worker_processes import Processes
from flexbearing.studies.run import Work, run
from tests.flexbearing.toy_studies import no_ring, slow_cubes, toy
folder = Path(sys.argv[1])
prepared = toy(folder, sys.argv[2])
work = Work(partial(slow_cubes, texts=prepared.texts, place=folder / "processes"), no_ring)
engine = Processes(2)
run(prepared, folder, work, lambda tasks: engine, tell=lambda progress: print(progress.done, flush=True))
"""


@pytest.mark.slow
def test_a_killed_driver_leaves_no_process_and_the_study_goes_on(tmp_path):
    """Without a guard around the script: workers do not import it."""
    place = tmp_path / "processes"
    place.mkdir()
    driver = subprocess.Popen(
        [sys.executable, "-c", DRIVER, tmp_path, FORTY], stdout=subprocess.PIPE, text=True, cwd=ROOT
    )
    assert driver.stdout
    while int(driver.stdout.readline()) < 10:
        pass
    driver.kill()
    driver.wait()
    driver.stdout.close()
    gone_by = time.monotonic() + 120
    while any(Path(f"/proc/{process.name}").exists() for process in place.iterdir()):
        assert time.monotonic() < gone_by
        time.sleep(0.1)
    prepared = toy(tmp_path, FORTY)
    assert 10 <= prepared.progress(prepared.rows(tmp_path)).done < 40
    table = computed(prepared, tmp_path, Serial())
    assert str(table.rows) == str(computed(prepared, tmp_path / "at once", Serial()).rows)


@pytest.mark.slow
def test_elastic_rings_are_shared_also_without_a_cache(tmp_path, monkeypatch):
    """Two thicknesses and two loads: the rows of one job and two, and no ring is left behind."""
    import flexbearing

    monkeypatch.setenv("FLEXBEARING_CACHE", "off")
    file = tmp_path / "thin.toml"
    file.write_text(
        f'case = "{ROOT / "configs" / "nu209.toml"}"\n[over]\n"outer.kind" = "ring"\n"outer.width" = "19 mm"'
        '\n"operation.tilt" = "fixed"\n"outer.thickness" = ["3 mm", "4 mm"]\n'
        '"operation.radial_load" = ["5 kN", "10 kN"]\n[collect]\nload = "flexible.max_roller_load [N]"\n'
    )
    tables = [flexbearing.study(file, tmp_path / str(jobs), jobs=jobs) for jobs in (1, 2)]
    for rows in zip(*(table.rows for table in tables), strict=True):
        one, two = ({**row, "seconds": None} for row in rows)
        assert one == two
    assert tables[0].failed == 0
    assert not list((tmp_path / "2").glob("*.rings"))


DRIVER_OF_ONE = """
import sys
from functools import partial
from pathlib import Path
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.run import Work, run
from tests.flexbearing.toy_studies import deadly, no_ring, toy
folder = Path(sys.argv[1])
prepared = toy(folder, sys.argv[2])
work = Work(partial(deadly, texts=prepared.texts, place=folder / "attempts"), no_ring)
table = run(prepared, folder, work, lambda tasks: Serial())
print([row["operation.radial_load [N]"] for row in table.rows if row["status"] == "worker died"])
"""


@pytest.mark.slow
def test_a_variant_that_kills_the_only_process_does_so_once(tmp_path):
    """The same study again finds it in a process beside, with the others of its task."""
    words = [sys.executable, "-c", DRIVER_OF_ONE, tmp_path, FORTY]
    first, second = (subprocess.run(words, capture_output=True, text=True, cwd=ROOT) for _ in range(2))
    assert (first.returncode, first.stdout) == (-signal.SIGKILL, "")
    assert (second.returncode, second.stdout) == (0, "[7000.0]\n")
    assert (tmp_path / "attempts").read_text().split() == ["5", "5", "3", "2", "1"]


@pytest.mark.slow
def test_a_ring_that_kills_the_only_process_is_condensed_beside_it(tmp_path):
    base = Base(Path("case.toml"), "", ())
    place, rings = tmp_path / "processes", [Ring(base, Variant((), ""), name) for name in ("inner", "outer")]
    engine, noted = Serial(), []
    engine.guard(lambda ring: noted.append(ring.name), lambda ring: involves(ring, {"outer"}))
    ends = [*completed(rings, partial(toy_studies.deadly_outer, place=place), engine)]
    engine.close()
    assert [(done.argument.name, done.died) for done in ends] == [("inner", False), ("outer", True)]
    assert noted == ["inner"]
    assert place.read_text().split().count(str(os.getpid())) == 1
    assert len(place.read_text().split()) == 4
