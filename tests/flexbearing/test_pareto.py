"""The command `pareto`: levels of a case, what is best among them, table and picture."""

import csv
import os
from dataclasses import replace
from math import inf
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

import fem.errors
import quasidynamic as qd
from flexbearing import __main__ as program
from flexbearing.api import read_case
from flexbearing.cache.key import digest
from flexbearing.case import BadCase
from flexbearing.coupling import PartnerFailed
from flexbearing.files import NotStored
from flexbearing.progress import Logged
from flexbearing.report.studies.pareto_table import Measured, Study, cheapest, draw_pareto, front, table, text
from flexbearing.rings import condensed, stored
from flexbearing.studies import pareto, pareto_levels
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.pareto import Timed
from flexbearing.studies.pareto_levels import Level, ladder, left_out, richest
from tests.flexbearing.toy_studies import deadly_level
from tests.places import CONFIGS

THIN = {"outer.kind": "ring", "outer.thickness": "1 mm", "outer.width": "10 mm"}
points = st.lists(st.tuples(st.floats(0, 10), st.floats(0, 1)), min_size=1, max_size=12)


def measured(name, cold, cached, *errors, message=""):
    names = ("load", "slip", "life", "stiffness", "torque")
    return Measured(
        name=name, settings=(), times={"cold": cold, "cached": cached},
        errors=dict(zip(names, errors, strict=False)), message=message,
    )  # fmt: skip


STUDY = Study(
    title="Three levels",
    reference=measured("reference", 9.0, 1.0, 0, 0, 0, 0),
    levels=(
        measured("quick", 0.1, 0.1, 0.05, 0.08, 0.04, 0.02),
        measured("middle", 1.0, 0.3, 0.005, 0.008, 0.09, 0.002),
        measured("slow", 5.0, 0.2, 0.0005, 0.0008, 0.0, 0.0002),
        measured("broken", 0.5, 0.5, message="the iteration diverges"),
    ),
    left_out=("smeared: there are no bars",),
)


@given(points)
def test_nothing_beats_the_front_and_the_front_beats_all_else(points):
    kept = front(points)
    for number, point in enumerate(points):
        better = [p for p in points if p[0] <= point[0] and p[1] <= point[1] and p != point]
        assert (number in kept and not better) or better or points.index(point) in kept
    assert [points[n] for n in kept] == sorted(points[n] for n in kept)
    assert [points[n][1] for n in kept] == sorted((points[n][1] for n in kept), reverse=True)


def test_levels_that_are_no_better_do_not_widen_the_front():
    assert front([(3.0, 0.1), (1.0, 0.5), (2.0, 0.5), (1.0, 0.5)]) == [1, 0]


def test_cheapest_level_within_a_target_is_the_fastest_that_keeps_it():
    assert cheapest(STUDY, "cold", 0.1, ("load", "life")).name == "quick"
    assert cheapest(STUDY, "cold", 0.01, ("load",)).name == "middle"
    assert cheapest(STUDY, "cached", 0.01, ("load",)).name == "slow"
    assert cheapest(STUDY, "cold", 0.01, ("load", "life")).name == "slow"
    assert cheapest(STUDY, "cold", 1e-4, ("load",)) is None


def test_failed_level_is_told_and_drawn_nowhere():
    words = text(STUDY)
    assert "- broken: the iteration diverges" in words
    assert "| broken" not in words
    assert "- smeared: there are no bars" in words
    assert "| 0.1 % in all | slow, 5 s | slow, 0.2 s |" in words
    assert "not computed: broken" in draw_pareto(STUDY).get_suptitle()


def test_table_holds_times_and_errors_under_their_names(tmp_path):
    (tmp_path / "study.csv").write_text(table(STUDY), newline="")
    with (tmp_path / "study.csv").open(encoding="utf-8") as file:
        rows = {row["level"]: row for row in csv.DictReader(file)}
    for level in STUDY.solved:
        row = rows[level.name]
        assert {name: float(row[f"{name}_s"]) for name in ("cold", "cached")} == level.times
        assert {name: float(row[f"error_{name}"]) for name in level.errors} == level.errors


def test_stars_stand_on_the_cheapest_level_for_the_output_of_their_panel():
    stars = {}
    for axes, output in zip(draw_pareto(STUDY).axes, ("load", "slip", "life", "stiffness"), strict=True):
        lines = [line for line in axes.lines if line.get_marker() == "*"]
        stars[output] = {(float(x), float(y)) for line in lines for x, y in line.get_xydata()}
    quick, middle, slow = STUDY.solved
    assert stars["load"] == {
        (0.1, quick.errors["load"]),  # cold and cached, within 5 %
        (1.0, middle.errors["load"]), (0.2, slow.errors["load"]),  # 1 %
        (5.0, slow.errors["load"]),  # 0.1 %
    }  # fmt: skip
    assert {time for time, _ in stars["life"]} == {0.1, 5.0, 0.2}  # the middle one has a wrong life


@pytest.mark.parametrize("name", ["mao2016", "step_ring"])
def test_every_level_of_a_case_can_be_read_and_has_a_name(name):
    path = CONFIGS / f"{name}.toml"
    levels = [richest(read_case(path)), *ladder(read_case(path), solid=True)]
    assert len({level.name for level in levels}) == len(levels)
    for level in levels:
        read_case(path, level.settings)


def names(case, *, solid=False):
    return {level.name for level in ladder(case, solid=solid)}


def test_levels_that_a_case_does_not_have_are_left_out_with_a_word():
    cage, rigid = read_case(CONFIGS / "mao2016.toml"), read_case(CONFIGS / "nu209.toml")
    ring = read_case(CONFIGS / "nu209.toml", {**THIN, "outer.support": "seat"})
    assert {"rigid", "beam", "smeared", "harmonics, order 2", "relaxed"} <= names(cage)
    assert not {"rigid", "beam", "smeared", "2 axial shapes", "aitken"} & names(rigid)
    assert not {"beam", "smeared", "20 slices", "newton"} & names(ring)
    assert "full solid" in names(cage, solid=True) - names(cage)
    assert any("bars" in words for words in left_out(ring, solid=False))
    assert any("seat" in words for words in left_out(ring, solid=False))
    assert any("rigid" in words for words in left_out(rigid, solid=False))


@pytest.mark.parametrize(("structure", "most"), [("beam", 6), ("smeared", 2000)])
def test_cheap_structures_have_few_unknowns_and_hold_alike(structure, most):
    case = read_case(CONFIGS / "mao2016.toml", {"accuracy.structure": structure, "accuracy.element_order": 2})
    found = condensed.raceway(case, "outer", np.linspace(0, 6, 5), Logged()).compliance
    assert found.unknowns <= most
    assert found.support_stiffness == approx(1.5e8, rel=0.1)


def test_smeared_bars_are_kept_apart_from_true_ones(monkeypatch):
    """On one mesh both are made from the same data."""
    asked = []
    keeper = SimpleNamespace(cached=lambda kind, parts, *_: asked.append(digest(parts)))
    monkeypatch.setattr(stored, "configured", lambda: keeper)
    same = {"accuracy.element_order": 3, "accuracy.mesh_size": "3 mm", "accuracy.raceway_mesh_size": "2 mm"}
    for structure in ("smeared", "harmonics"):
        case = read_case(CONFIGS / "mao2016.toml", {**same, "accuracy.structure": structure})
        with pytest.raises(AttributeError):  # nothing is computed
            condensed.raceway(case, "outer", np.zeros(1), Logged())
    assert len(set(asked)) == 2


def result(**changes):
    values = {"inner_load": [0.0, 100.0], "outer_load": [1.0, 110.0], "cage_slip": 0.05, "life_L10": 2e6,
              "total_stiffness": 1e8, **changes}  # fmt: skip
    return {name: np.asarray(value) for name, value in values.items()}


def test_errors_are_those_of_their_outputs():
    off = pareto.errors(
        result(outer_load=[2.1, 110.0], cage_slip=0.04, life_L10=1e6, total_stiffness=1.1e8), result()
    )
    assert off == {
        "load": approx(0.01), "slip": approx(0.2), "life": approx(0.5), "stiffness": approx(0.1)
    }  # fmt: skip
    assert pareto.errors(result(cage_slip=1e-5), result(cage_slip=-1e-5))["slip"] == approx(2e-3)
    assert pareto.errors(result(life_L10=inf), result(life_L10=inf))["life"] == 0


@pytest.fixture
def command(capsys):
    """The command line in this process: exit code, what it prints, what it complains about."""

    def run(*words):
        code = program.command(["pareto", *map(str, words)])
        return code, *capsys.readouterr()

    return run


@pytest.fixture
def in_this_process(monkeypatch):
    """Levels see what a test puts in the place of functions."""
    monkeypatch.setattr(pareto, "Processes", lambda workers: Serial())


@pytest.mark.slow
def test_command_writes_table_and_picture(command, monkeypatch, tmp_path):
    few = Level("5 slices", ("accuracy.slices=5",)), Level("no roller", ("bearing.rollers=-1",))
    monkeypatch.setattr(pareto, "ladder", lambda case, solid: few)
    monkeypatch.setattr(pareto, "richest", lambda case: Level("reference", ("accuracy.slices=40",)))
    cache = os.environ["FLEXBEARING_CACHE"]
    code, words, progress = command(CONFIGS / "nu209.toml", "-o", tmp_path, "--name", "few")
    assert code == 0
    assert os.environ["FLEXBEARING_CACHE"] == cache
    assert (tmp_path / "pareto_few.png").stat().st_size > 20_000
    with (tmp_path / "pareto_few.csv").open(encoding="utf-8") as file:
        rows = {row["level"]: row for row in csv.DictReader(file)}
    assert list(rows) == ["5 slices", "no roller", "reference"]
    assert 0 < float(rows["5 slices"]["error_load"]) < 0.02
    assert float(rows["reference"]["error_load"]) == 0
    assert rows["no roller"]["error_load"] == ""
    assert "rollers = -1 is not allowed" in rows["no roller"]["message"]
    assert "| 5 slices |" in words
    assert "- no roller:" in words
    assert "5 slices: " in progress


def test_levels_of_a_ball_bearing_differ_in_torque_and_full_sliding_is_other_physics():
    for name in ("heras2017_b1", "rivera2021_7008", "6209"):
        path = CONFIGS / f"{name}.toml"
        case = read_case(path)
        best, levels, _ = pareto.levels_of(case, solid=False)
        for level in (best, *levels):
            read_case(path, level.settings)
        assert {level.name for level in levels if level.physics} >= {"full sliding"}
        assert not any(level.physics for level in levels if "kalker" in level.name or "fastsim" in level.name)


def test_other_physics_is_never_the_cheapest_and_on_no_front(tmp_path):
    quick = replace(STUDY.levels[0], name="cold oil", errors=dict.fromkeys(STUDY.outputs, 0.0), physics=True)
    study = replace(STUDY, levels=(*STUDY.levels, quick))
    for when in ("cold", "cached"):
        for target in (0.1, 0.01, 0.001):
            assert cheapest(study, when, target, study.outputs) is cheapest(
                STUDY, when, target, STUDY.outputs
            )
    fronts = [
        {line.get_label(): line.get_xydata().tolist() for line in axes.lines if "best" in line.get_label()}
        for axes in (draw_pareto(study).axes[0], draw_pareto(STUDY).axes[0])
    ]
    assert fronts[0] == fronts[1]
    (tmp_path / "study.csv").write_text(table(study), newline="")
    with (tmp_path / "study.csv").open(encoding="utf-8") as file:
        kinds = {row["level"]: row["kind"] for row in csv.DictReader(file)}
    assert [kinds[name] for name in ("quick", "cold oil", "reference")] == [
        "numerical",
        "physics",
        "reference",
    ]


def test_laws_of_another_physics_are_marked():
    levels = ladder(read_case(CONFIGS / "mao2016.toml"), solid=True)
    assert {level.name for level in levels if level.physics} == {"inlets not heated", "half-space contact"}


def test_target_may_choose_what_the_case_gives():
    path = CONFIGS / "mao2016.toml"  # 20 slices, 3 shapes
    (level,) = (level for level in ladder(read_case(path), solid=False) if level.name == "target 1 %")
    accuracy = read_case(path, level.settings).accuracy
    assert accuracy.target == approx(0.01)
    assert not {"slices", "axial_shapes"} & accuracy.model_fields_set


def test_errors_of_balls_have_no_slip():
    state = {"contact_load": np.array([[3.0, 4.0]]), "friction_torque": np.array(2.0),
             "stiffness_matrix": np.diag([1.0, 5.0, 8.0, 1.0, 1.0])}  # fmt: skip
    off = pareto.errors(
        {**state, "friction_torque": np.array(2.2), "contact_load": np.array([[3.0, 4.4]])}, state
    )
    assert off == {"load": approx(0.1), "stiffness": 0, "torque": approx(0.1)}


def test_target_is_refused(command):
    code, _, complaint = command(CONFIGS / "nu209.toml", "--set", "accuracy.target=1 %")
    assert code == 2
    assert "accuracy.target" in complaint


@pytest.mark.usefixtures("in_this_process")
def test_reference_without_an_answer_is_no_reference(command, monkeypatch):
    broken = Timed({"cold": 1.0, "cached": 1.0}, {}, "no equilibrium")
    monkeypatch.setattr(pareto, "timed", lambda run: broken)
    code, _, complaint = command(CONFIGS / "nu209.toml")
    assert code == 1
    assert "no equilibrium" in complaint


FAILURES = [PartnerFailed, fem.errors.NotSolved, fem.ImpossiblePart, qd.NotSolved, qd.OutOfRange, BadCase]


def failing(problem, exact):
    """The level of 5 slices ends like that, all others alike."""

    def timed(run):
        if "accuracy.slices=5" in run.level.settings:
            raise problem
        return exact

    return timed


def answer(**changes):
    return Timed({"cold": 1.0, "cached": 1.0}, result(**changes))


@pytest.mark.slow
def test_level_whose_process_dies_is_a_row_and_the_study_goes_on(monkeypatch):
    few = tuple(Level(f"{count} slices", (f"accuracy.slices={count}",)) for count in (5, 10))
    monkeypatch.setattr(pareto, "ladder", lambda case, solid: few)
    monkeypatch.setattr(pareto, "timed", deadly_level)
    told = []
    study = pareto.pareto(CONFIGS / "nu209.toml", tell=told.append)
    assert [level.name for level in study.levels] == ["5 slices", "10 slices"]
    assert study.levels[0].message.startswith("its worker process died 3 times")
    assert study.levels[1].errors == dict.fromkeys(study.reference.errors, 0.0)
    assert [level.name for level in told] == ["reference", "10 slices", "5 slices"]


@pytest.mark.slow
def test_reference_whose_process_dies_is_no_reference(command, monkeypatch):
    monkeypatch.setattr(pareto, "timed", deadly_level)
    monkeypatch.setattr(pareto, "richest", lambda case: Level("5 slices"))
    code, _, complaint = command(CONFIGS / "nu209.toml")
    assert code == 1
    assert "the reference was not computed: its worker process died" in complaint


@pytest.mark.usefixtures("in_this_process")
@pytest.mark.parametrize("kind", FAILURES, ids=lambda kind: f"{kind.__module__}.{kind.__name__}")
def test_level_that_fails_is_a_row_and_the_study_goes_on(monkeypatch, kind):
    monkeypatch.setattr(pareto, "timed", failing(kind("the ring lifts off"), answer()))
    study = pareto.pareto(CONFIGS / "nu209.toml")
    found = {level.name: level for level in study.levels}
    assert found["5 slices"].message == "the ring lifts off"
    assert not found["5 slices"].errors
    assert [level.name for level in study.levels if not level.errors] == ["5 slices"]
    assert list(found)[-1] == "target 0.1 %"  # levels after it are measured
    assert "- 5 slices: the ring lifts off" in text(study)


@pytest.mark.usefixtures("in_this_process")
def test_interrupted_study_promises_nothing_of_its_temporary_results(monkeypatch):
    def interrupted(*_, **__):
        problem = KeyboardInterrupt()
        problem.add_note("3 iterations kept in level.h5.part")
        raise problem

    monkeypatch.setattr(pareto, "run", interrupted)
    with pytest.raises(KeyboardInterrupt) as ending:
        pareto.pareto(CONFIGS / "nu209.toml")
    assert ending.value.__notes__ == []


@pytest.mark.usefixtures("in_this_process")
def test_study_without_room_for_temporary_results_says_so(command, monkeypatch, tmp_path):
    def full(*_, **__):
        raise NotStored("level.h5: not written: choose another place with -o.")

    monkeypatch.setattr(pareto, "run", full)
    code, _, complaint = command(CONFIGS / "nu209.toml", "-o", tmp_path)
    assert code == 3
    assert "no room for the results of the levels" in complaint
    assert "TMPDIR" in complaint


@pytest.mark.usefixtures("in_this_process")
@pytest.mark.parametrize("mistake", [TypeError, KeyError, ValueError, RuntimeError, AssertionError])
def test_mistake_in_the_program_ends_the_study(monkeypatch, mistake):
    monkeypatch.setattr(pareto, "timed", failing(mistake("a mistake"), answer()))
    with pytest.raises(mistake, match="a mistake"):
        pareto.pareto(CONFIGS / "nu209.toml")


@pytest.mark.usefixtures("in_this_process")
def test_reference_that_fails_is_no_reference(command, monkeypatch):
    def lost(run):
        raise fem.errors.NotSolved("the residual stayed at 0.1")

    monkeypatch.setattr(pareto, "timed", lost)
    code, _, complaint = command(CONFIGS / "nu209.toml")
    assert code == 1
    assert "the residual stayed at 0.1" in complaint


@pytest.mark.slow
def test_cheap_structures_of_a_cage_are_nearly_right(tmp_path, monkeypatch):
    """Loads within 1 %, as measured; the life asks for tilts that they know less well."""
    path, found = CONFIGS / "mao2016.toml", {}
    for level in (Level("usual"), *pareto_levels.ladder(read_case(path), solid=False)):
        if level.name in ("usual", "beam", "smeared"):
            found[level.name] = pareto.run(path, level.settings, output=tmp_path / "one.h5")
    for name in ("beam", "smeared"):
        off = pareto.errors(found[name].flexible, found["usual"].flexible)
        assert off["load"] < 0.01
        assert off["slip"] < 0.03
        assert off["stiffness"] < 0.03
