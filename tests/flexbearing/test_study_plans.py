"""The plan of a study: identities of variants, bundles of them, what is wrong before anything is computed."""

import json
from dataclasses import replace
from hashlib import sha256
from importlib import import_module
from pathlib import Path

import pytest

from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.quantities.attributes import FORMAT
from flexbearing.studies.placement import RING, expected
from flexbearing.studies.plan import plan
from flexbearing.studies.plan.plan import MOST_PROBLEMS
from flexbearing.studies.plan.task import Base, Variant, identity
from flexbearing.studies.prepare import prepare_source
from tests.flexbearing.toy_studies import CASE, toy
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")


def test_the_identity_is_the_digest_of_the_complete_case_and_the_format():
    case = read_case(CASE, {"operation.radial_load": "5 kN"})
    text = f"{FORMAT} {case.model_dump_json(exclude={'report'})} "
    assert json.loads(case.model_dump_json()) == json.loads(json.dumps(case.to_json()))
    assert identity(case) == sha256(text.encode()).hexdigest()[:32]


def test_the_same_case_in_other_words_has_the_same_identity():
    by_unit = [read_case(CASE, {"operation.radial_load": load}) for load in ("5 kN", "5000 N")]
    assert identity(by_unit[0]) == identity(by_unit[1])
    assert identity(by_unit[0]) != identity(read_case(CASE, {"operation.radial_load": "5.000001 kN"}))


def test_a_drawing_enters_the_identity_with_its_content(tmp_path):
    identities = set()
    for number in range(2):
        folder = tmp_path / str(number)
        folder.mkdir()
        for name in ("step_ring.toml", "step_ring.step"):
            content = (CONFIGS / name).read_bytes()
            (folder / name).write_bytes(content + b"\n" * (number if name.endswith("step") else 0))
        identities.add(identity(read_case(folder / "step_ring.toml")))
    assert len(identities) == 2


def test_variants_are_those_of_single_runs_in_the_order_of_the_axes(tmp_path):
    settled = toy(
        tmp_path, '"operation.radial_load" = ["1 kN", "2 kN"]\n"bearing.clearance" = ["20 um", "30 um"]'
    )
    expected = [
        identity(read_case(CASE, {"operation.radial_load": load, "bearing.clearance": clearance}))
        for load in ("1 kN", "2 kN")
        for clearance in ("20 um", "30 um")
    ]
    assert [variant.identity for variant in settled.plan.variants] == expected


def test_all_bad_variants_are_told_before_anything_is_computed(tmp_path):
    loads = [f"{number} kN" for number in range(1, 98)] + ["-1 N", "5 mm", "-2 N"]
    settled = toy(tmp_path, f'"operation.radial_load" = {json.dumps(loads)}')
    assert [problem.number for problem in settled.plan.problems] == [97, 98, 99]
    with pytest.raises(BadCase) as told:
        settled.plan.require_sound()
    lines = str(told.value).splitlines()
    assert len(lines) == 4
    assert lines[1] == (
        'toy: variant 99 (operation.radial_load = 5 mm): nu209.toml: [operation] radial_load = "5 mm" is '
        'not a force; it must be a force as text with its unit, such as "20 kN", at least 0 kN.'
    )
    assert lines[3] == "toy: 3 of 100 variants cannot be computed; none was."


def test_of_many_bad_variants_twenty_are_told_and_all_counted(tmp_path):
    settled = toy(tmp_path, '"operation.radial_load" = "-30 N .. -1 N, 30"')
    with pytest.raises(BadCase) as told:
        settled.plan.require_sound()
    assert len(str(told.value).splitlines()) == 21
    assert "30 of 30 variants cannot be computed" in str(told.value)


@pytest.mark.slow
def test_after_many_bad_variants_the_others_are_not_checked(tmp_path):
    """A variant that is refused takes ten times as long to check as one that is not."""
    settled = toy(tmp_path, '"operation.radial_load" = "-4000 N .. -1 N, 4000"')
    checked = len(settled.plan.variants)
    assert MOST_PROBLEMS <= checked < 1000
    assert checked + settled.plan.unchecked == 4000
    with pytest.raises(
        BadCase, match=f"{checked} of {checked} variants cannot be computed, {4000 - checked} more"
    ):
        settled.plan.require_sound()
    assert len([*settled.plan.variants]) == checked


def test_what_physics_forbids_is_told_as_well(tmp_path):
    """A raceway larger than the ring that carries it is no ring, which reading the file does not see."""
    file = tmp_path / "thin.toml"
    file.write_text(
        f'case = "{CONFIGS / "mao2016.toml"}"\n[over]\n"inner.shaft_thickness" = ["4 mm", "29.9 mm"]'
    )
    assert [problem.number for problem in prepare_source(file).plan.problems] == [1]


def planned(variants):
    settled = Base(CASE, "", ("operation.radial_load",))
    from flexbearing.studies.plan import Plan

    return Plan("toy", settled, (), tuple(variants), ())


def test_bundles_hold_every_wanted_identity_once_and_the_same_rings():
    rings = [(), ("a",), ("a", "b")]
    variants = [Variant((number,), str(number % 900), rings[number % 3]) for number in range(1200)]
    tasks = planned(variants).tasks(lambda variant: variant.identity != "5")
    identities = [variant.identity for task in tasks for variant in task.variants]
    assert sorted(identities) == sorted({variant.identity for variant in variants} - {"5"})
    for task in tasks:
        assert len({variant.rings for variant in task.variants}) == 1
        assert len(task.variants) <= (16 if task.variants[0].rings else 128)


def test_a_small_study_is_cut_for_several_workers():
    tasks = planned([Variant((number,), str(number)) for number in range(24)]).tasks(lambda variant: True)
    assert [len(task.variants) for task in tasks] == [3] * 8


@pytest.mark.parametrize(
    ("variants", "largest", "of_shares"), [(100, 100, 13), (3200, 128, 50), (20_000, 256, 256)]
)
def test_tasks_between_elastic_rings_grow_with_the_study(variants, largest, of_shares):
    """Most of a task start from solved neighbours; little is lost where one of them ends a worker."""
    alike = planned([Variant((number,), str(number), ("outer a",)) for number in range(variants)])
    for of, most in ((replace(alike, side_by_side=True), largest), (alike, of_shares)):
        assert max(len(task.variants) for task in of.tasks(lambda variant: True)) == most


def test_the_plan_names_the_rings_that_are_condensed(tmp_path):
    file = tmp_path / "thin.toml"
    file.write_text(
        f'case = "{CONFIGS / "mao2016.toml"}"\n[over]\n"outer.thickness" = ["3 mm", "4 mm"]\n'
        '"operation.radial_load" = ["1 kN", "2 kN", "3 kN"]'
    )
    settled = prepare_source(file)
    assert len(settled.plan.rings()) == 3  # two outer ones and an inner one
    assert [len(task.variants) for task in settled.plan.tasks(lambda variant: True)] == [3, 3]
    again = replace(settled.plan, variants=tuple(replace(each, rings=()) for each in settled.plan.variants))
    assert again.rings() == ()


ON_SHAFT = (
    '"inner.kind" = "ring_on_shaft"\n"inner.bore" = "80 mm"\n"inner.width" = "30 mm"\n'
    '"inner.shaft_length" = "60 mm"\n"bearing.inner.shoulder" = "5 mm"\n"materials.shaft" = "100Cr6"'
)


@pytest.mark.parametrize(("inner", "races"), [("", ["outer"] * 2), (ON_SHAFT, ["inner", "outer", "outer"])])
def test_elastic_rings_of_balls_are_rings_of_the_plan(inner, races, tmp_path):
    loads = '"operation.load.radial_z" = ["1 kN", "2 kN", "3 kN"]'

    def planned(settings):
        text = f'[set]\n{settings}\n[over]\n"outer.thickness" = ["4 mm", "5 mm"]\n{loads}'
        file = tmp_path / "thin.toml"
        file.write_text(f'case = "{CONFIGS / "harris218_cage.toml"}"\n{text}')
        return prepare_source(file)

    settled = planned(inner)
    assert sorted(ring.race for ring in settled.plan.rings()) == races
    assert [len(task.variants) for task in settled.plan.tasks(lambda variant: True)] == [1] * 6
    assert expected(settled.plan) > RING * len(races)
    columns = {column.column for column in settled.columns}
    assert {"rigid.life_L10", "flexible.life_L10"} <= columns
    finer = planned(f'{inner}\n"accuracy.mesh_size" = "4 mm"')
    names = [{ring.name for ring in each.plan.rings()} for each in (settled, finer)]
    assert not names[0] & names[1]


def test_a_plan_needs_no_bearing():
    from flexbearing.studies.file import Axis, Study

    load = "operation.radial_load"
    study = Study(
        path=Path("s.toml"), name="s", case=CASE, text=CASE.read_text(), kind="cylindrical_roller",
        inputs=(), axes=(Axis(load, (load,), (("1 kN",), ("2 kN",))),), collect=None,
    )  # fmt: skip

    def checked(base, rows):
        return [Variant(values, f"{int(values[0][0]):032x}", ("ring",)) for values in rows]

    settled = plan(study, checked)
    assert [(each.identity, each.rings) for each in settled.variants] == [
        (f"{1:032x}", ("ring",)),
        (f"{2:032x}", ("ring",)),
    ]


@pytest.mark.slow
def test_a_plan_by_several_processes_is_that_by_one(tmp_path, monkeypatch):
    file = tmp_path / "clearances.toml"
    file.write_text(
        f'case = "{CASE}"\n[over]\n"bearing.clearance" = "10 um .. 90 um, 30"\n'
        '"operation.radial_load" = ["1 kN", "0 kN", "-2 kN"]'
    )
    monkeypatch.setattr(import_module("flexbearing.studies.plan.plan"), "CHECKED_AT_ONCE", 4)
    plans = []
    for processes in ("1", "2"):
        monkeypatch.setenv("FLEXBEARING_THREADS", processes)
        plans.append(prepare_source(file).plan)
    assert plans[0].variants[:] == plans[1].variants[:]
    assert plans[0].problems == plans[1].problems
    assert [problem.number for problem in plans[1].problems] == list(range(2, 90, 3))
