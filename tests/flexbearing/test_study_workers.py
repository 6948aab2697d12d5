"""What a worker does with rings: where it meshes them, and how many of them it holds."""

import gc
from functools import partial

import pytest

import flexbearing
from fem import condense as finite_elements
from fem.raceway.harmonics import HarmonicCompliance
from flexbearing.cache import configured, recent
from flexbearing.case.declarations import toml
from flexbearing.findings.row import words as in_words
from flexbearing.program.threads import cores
from flexbearing.program.worker_processes import Processes
from flexbearing.studies import worker
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.prepare import prepare_source
from flexbearing.studies.run import Work, run
from tests.cold_oil import RIGID, cold_case, settings
from tests.flexbearing import toy_studies
from tests.flexbearing.toy_studies import CASE
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")

PAPER = CONFIGS / "mao2016.toml"
CAGES = """
[over]
"outer.thickness" = ["4 mm", "5 mm"]
"accuracy.element_order" = 2
"""
PLAIN_RINGS = """
[over]
"outer.kind" = "ring"
"outer.width" = "19 mm"
"outer.thickness" = "3 mm .. 6 mm, 5"
"operation.tilt" = "fixed"
"accuracy.element_order" = 2
[collect]
load = "flexible.max_roller_load [N]"
"""


@pytest.fixture
def rings(monkeypatch, tmp_path):
    """Folder of an empty cache, none of whose rings is in memory."""
    folder = tmp_path / "rings"
    monkeypatch.setenv("FLEXBEARING_CACHE", str(folder))
    monkeypatch.setattr(recent, "_rings", type(recent._rings)())
    return folder


def study(folder, case, text):
    file = folder / "study.toml"
    file.write_text(f'case = "{case}"\n{text}')
    return prepare_source(file)


def held():
    gc.collect()
    return sum(isinstance(each, HarmonicCompliance) for each in gc.get_objects())


@pytest.mark.slow
def test_a_worker_meshes_in_its_own_process_and_a_driver_does_not(rings, monkeypatch, tmp_path):
    """Both keep the same ring."""
    begun, beside = [], finite_elements.in_subprocess

    def told(function, *arguments, **options):
        begun.append(function)
        return beside(function, *arguments, **options)

    monkeypatch.setattr(finite_elements, "in_subprocess", told)
    ring = next(each for each in study(tmp_path, PAPER, CAGES).plan.rings() if each.race == "outer")
    kept = []
    for here in (True, False):
        worker.condense(ring, str(tmp_path / str(here)), here=here)
        kept.append({path.name for path in (tmp_path / str(here)).iterdir()})
        assert len(begun) == (0 if here else 1)
    assert kept[0] == kept[1]
    assert len(kept[0]) == 1


@pytest.mark.slow
def test_a_worker_that_meshing_ended_hands_the_ring_to_a_process_of_its_own(tmp_path):
    """Rings of a driver are never meshed in its own process."""
    prepared = study(
        tmp_path, PAPER, '[over]\n"operation.radial_load" = "5 kN"\n[collect]\nlife = "life_L10"'
    )
    for engine in (Processes(1), Serial()):
        folder = tmp_path / type(engine).__name__
        folder.mkdir()
        condense = partial(toy_studies.deadly_here, place=folder / "meshed")
        work = Work(partial(toy_studies.lives, texts=prepared.texts), condense)
        assert run(prepared, folder, work, lambda tasks, engine=engine: engine).failed == 0
        assert (folder / "meshed").read_text().split() == ["inner", "outer"]


@pytest.mark.slow
def test_a_worker_holds_the_rings_of_few_bearings_however_many_it_meets(rings, monkeypatch, tmp_path):
    monkeypatch.setattr(recent, "MOST", 2)
    prepared, before = study(tmp_path, CASE, PLAIN_RINGS), held()
    assert len(prepared.plan.rings()) == 5
    for ring in prepared.plan.rings():
        worker.condense(ring, here=True)
        assert held() - before <= 2
    for task in prepared.plan.tasks(lambda variant: True):
        (row,) = worker.rows(task, worker.RowRequest(prepared.outputs))
        assert row.converged
        assert held() - before <= 2
    assert len(configured().entries()) >= 5


@pytest.mark.slow
def test_one_job_is_one_core_however_many_there_are(rings, monkeypatch, tmp_path):
    """What is given explicitly limits; with nothing given a study in one process may use all cores."""
    monkeypatch.setenv("FLEXBEARING_THREADS", "4")
    monkeypatch.delenv("SLURM_CPUS_PER_TASK", raising=False)
    seen = []

    def rows(task, request, cache):
        seen.append(cores())
        return toy_studies.lives(task, request.texts)

    monkeypatch.setattr(worker, "rows", rows)
    file = tmp_path / "one.toml"
    file.write_text(f'case = "{CASE}"\n[over]\n"operation.radial_load" = "5 kN"\n')
    for jobs in (1, None):
        flexbearing.study(file, tmp_path / str(jobs), jobs=jobs)
    assert seen == [1, 4]


@pytest.mark.parametrize("alone", [False, True], ids=["side by side", "result files"])
def test_a_row_alone_says_what_it_says_in_a_batch(alone, tmp_path):
    """Several equilibria, which are not searched without `search_equilibria`, and pressed ends."""
    pairs = (each.split("=", 1) for each in (*RIGID, *settings(13)))
    keys = "\n".join(f'"{key}" = {value if value[0] == "0" else toml(value)}' for key, value in pairs)
    loads = '"operation.radial_load" = ["7 kN", "9 kN"]\n"bearing.roller.drop" = "0.5 um"\n'
    several = study(tmp_path, cold_case(tmp_path), f"[over]\n{keys}\n")
    pressed = study(tmp_path, CASE, f'[over]\n{loads}"operation.misalignment" = "3 arcmin"\n')
    words = []
    for prepared in (several, pressed):
        request = worker.RowRequest(("life_L10 [h]",), files=tmp_path if alone else None, final=alone)
        tasks = prepared.plan.tasks(lambda variant: True)
        words += [in_words(row.findings) for task in tasks for row in worker.rows(task, request)]
    assert words[0] == "danger: several equilibria are likely; others than the computed one were not searched"
    assert all(each.startswith("outside validity: error of the peak pressure") for each in words[1:])
