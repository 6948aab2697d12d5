"""Studies with a target: levels chosen once between the same rings, a column with each estimated error."""

from itertools import product

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.studies import messages, worker
from flexbearing.studies.plan.corners import extremes
from flexbearing.studies.prepare import prepare_source
from flexbearing.studies.table import journal
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")

RING = """
"outer.kind" = "ring"
"outer.width" = "19 mm"
"outer.support" = "seat"
"""
THIN = RING + '"outer.thickness" = ["3 mm", "5 mm"]\n'
LOADS = '"operation.radial_load" = ["1 kN", "2 kN", "4 kN", "8 kN"]\n'
TARGET = '"accuracy.target" = "2 %"\n'
FINE = '"accuracy.slices" = 320\n"accuracy.axial_shapes" = 5\n"accuracy.element_order" = 6\n'
COLLECT = """
life = "life_L10 [h]"
load = "max_roller_load [kN]"
slip = "cage_slip [%]"
stiffness = "stiffness [kN/mm]"
rigid_life = "rigid.life_L10 [h]"
loaded = "loaded_rollers"
"""


def study(folder, over, name="target", collect=COLLECT, case="nu209.toml"):
    file = folder / f"{name}.toml"
    file.write_text(f'case = "{CONFIGS / case}"\n[over]\n{over}[collect]\n{collect}')
    return file


def numbers(table):
    """Rows without the time that they took."""
    return [{key: value for key, value in row.items() if key != "seconds"} for row in table.rows]


@pytest.fixture
def chosen(monkeypatch):
    """Numbers of variants at which levels were chosen, for each choice."""
    found = []

    def counted(cases, family, report):
        found.append(len(cases))
        return choose(cases, family, report)

    choose = worker.shared_levels
    monkeypatch.setattr(worker, "shared_levels", counted)
    monkeypatch.setattr("flexbearing.accuracy.adaptive.adaptive_resolution", None)  # of a case alone
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("targets")


@pytest.fixture(scope="module")
def table(folder):
    return flexbearing.study(study(folder, THIN + LOADS + TARGET), folder, jobs=1)


@pytest.mark.slow
def test_rows_keep_the_target_and_errors_are_below_their_estimates(table, tmp_path):
    fine = flexbearing.study(study(tmp_path, THIN + LOADS + FINE), tmp_path, jobs=1)
    for name in ("life", "load"):
        true = np.abs(np.array(table[name].values) / fine[name].values - 1) * 100
        estimate = np.array(table[f"{name} error [%]"].values)
        assert (true <= estimate).all()
        assert (estimate <= 2).all()
    true = np.abs(np.array(table["slip [%]"].values) - fine["slip [%]"].values)
    assert (true <= np.array(table["slip error [%]"].values)).all()


@pytest.mark.slow
def test_outputs_with_an_estimate_have_a_column_with_their_error(table):
    errors = [column.heading for column in table.columns if "error" in column.name]
    assert errors == ["life error [%]", "load error [%]", "slip error [%]", "stiffness error [%]"]
    headings = [column.heading for column in table.columns]
    assert headings.index("life error [%]") == headings.index("life [h]") + 1
    for thickness in (slice(0, 4), slice(4, 8)):
        assert len({table["life error"].values[row] for row in range(8)[thickness]}) == 1


def test_the_error_of_the_life_is_the_estimate_of_the_target_alone(tmp_path):
    file = study(tmp_path, LOADS + TARGET, collect='life = "life_L10"\nother = "life_error"\n')
    table = flexbearing.study(file, tmp_path, jobs=1)
    assert np.isnan(table["other"].values).all()
    assert np.isfinite(table["life error"].values).all()


def test_without_a_target_there_are_no_columns_of_errors(tmp_path):
    assert not any(column.error for column in prepare_source(study(tmp_path, THIN + LOADS)).columns)


@pytest.mark.slow
def test_levels_are_chosen_once_for_each_ring(chosen, table, tmp_path):
    again = flexbearing.study(study(tmp_path, THIN + LOADS + TARGET), tmp_path, jobs=1)
    assert chosen == [4, 4]
    assert numbers(again) == numbers(table)


@pytest.mark.slow
def test_a_resumed_study_has_the_same_table(table, folder, tmp_path):
    file, kept = study(tmp_path, THIN + LOADS + TARGET), f"target{journal.SUFFIX}"
    lines = (folder / kept).read_text().splitlines(keepends=True)
    (tmp_path / kept).write_text("".join(lines[:4]))
    resumed = flexbearing.study(file, tmp_path, jobs=1)
    assert numbers(resumed) == numbers(table)


@pytest.mark.slow
def test_two_jobs_give_the_same_table(table, tmp_path):
    parallel = flexbearing.study(study(tmp_path, THIN + LOADS + TARGET), tmp_path, jobs=2)
    assert numbers(parallel) == numbers(table)


@pytest.mark.slow
def test_a_row_alone_has_the_numbers_of_the_row_beside_others(table, tmp_path):
    """Result files are those of runs alone, at the levels of the study."""
    file = study(tmp_path, THIN + LOADS + TARGET)
    file.write_text(f'results = "full"\n{file.read_text()}')
    alone = flexbearing.study(file, tmp_path, jobs=1)
    for name in ("life", "load", "stiffness", "life error", "load error"):
        assert alone[name].values == approx(table[name].values, rel=1e-9)
    results = [flexbearing.read(path) for path in tmp_path.rglob("*.h5")]
    estimates = {result.attributes["error_estimate"]["life"] * 100 for result in results}
    assert sorted(estimates) == approx(sorted({*table["life error"].values}), rel=1e-12)


def test_a_target_that_is_not_met_is_told_in_every_row_that_shares_the_levels(tmp_path):
    coarse = '"accuracy.slices" = 12\n"accuracy.target" = "0.01 %"\n'
    table = flexbearing.study(study(tmp_path, coarse + LOADS), tmp_path, jobs=1)
    assert all("the target of 0.01 % is not met" in words for words in table["message"].values)
    assert min(table["life error"].values) > 0.01


@pytest.mark.slow
def test_the_life_under_a_duty_cycle_has_an_error_below_its_estimate(tmp_path):
    duty = '[duty]\ntime = [1, 2, 1]\n"operation.radial_load" = ["2 kN", "5 kN", "12 kN"]\n'

    def lives(name, over):
        file = tmp_path / f"{name}.toml"
        clearances = '"bearing.clearance" = ["20 um", "40 um"]\n'
        file.write_text(f'case = "{CONFIGS / "nu209.toml"}"\n[over]\n{clearances}{over}{duty}')
        return flexbearing.study(file, tmp_path, jobs=1).cycles

    coarse, fine = lives("coarse", '"accuracy.target" = "5 %"\n'), lives("fine", '"accuracy.slices" = 320\n')
    true = np.abs(np.array(coarse["life [h]"].values) / fine["life [h]"].values - 1) * 100
    estimate = np.array(coarse["life error [%]"].values)
    assert (true <= estimate).all()
    assert (estimate <= 5).all()
    assert "life error [%]" not in [column.heading for column in fine.columns]
    assert (
        f"h (error {estimate[1]:.2g} %); basic L10 life of each raceway: inner" in messages.cycles(coarse)[1]
    )


def test_levels_between_rigid_rings_are_chosen_too(chosen, tmp_path):
    table = flexbearing.study(study(tmp_path, LOADS + TARGET), tmp_path, jobs=1)
    assert chosen == [4]
    assert set(table["status"].values) == {"converged"}
    assert 0 < table["life error"].values[0] <= 2


@pytest.mark.slow
def test_without_an_answer_the_usual_levels_are_used_and_told(tmp_path, monkeypatch):
    from flexbearing.accuracy import Unusable, shared

    def unusable(*_):
        raise Unusable("no equilibrium")

    usual = flexbearing.study(study(tmp_path, THIN + LOADS, "usual"), tmp_path, jobs=1)
    monkeypatch.setattr(shared, "climb_together", unusable)
    table = flexbearing.study(study(tmp_path, THIN + LOADS + TARGET), tmp_path, jobs=1)
    assert table["life"].values == approx(usual["life"].values, rel=1e-9)
    assert np.isnan(table["life error"].values).all()
    assert all("nothing could be chosen or estimated" in words for words in table["message"].values)


def plan_of(folder, over):
    return prepare_source(study(folder, over)).plan


def test_the_choice_depends_on_the_variants_and_not_on_their_order(tmp_path):
    loads = ["1 kN", "2 kN", "3 kN", "5 kN", "6 kN", "7 kN", "8 kN"]
    plans = [
        plan_of(tmp_path, THIN + TARGET + f'"operation.radial_load" = {order}\n'.replace("'", '"'))
        for order in (loads, loads[::-1])
    ]
    names = [{corners.name for corners in plan.corners} for plan in plans]
    assert len(names[0]) == 2
    assert names[0] == names[1]
    identities = [{variant.identity for variant in plan.variants} for plan in plans]
    assert identities[0] == identities[1]


def test_other_corners_are_other_rows(tmp_path):
    """Rows of a former study with another highest load may have other levels."""
    few, more = (
        plan_of(tmp_path, f'{RING}"outer.thickness" = "3 mm"\n{TARGET}"operation.radial_load" = {loads}\n')
        for loads in ('["1 kN", "2 kN"]', '["1 kN", "2 kN", "9 kN"]')
    )
    assert not {each.identity for each in few.variants} & {each.identity for each in more.variants}


def test_other_words_and_targets_have_choices_of_their_own(tmp_path):
    tilt = '"operation.tilt" = ["free", "fixed"]\n"accuracy.target" = ["1 %", "2 %"]\n'
    plan = plan_of(tmp_path, THIN + LOADS + tilt)
    assert len(plan.corners) == 2 * 2 * 2
    for task in plan.tasks(lambda variant: True):
        assert len({(variant.levels, variant.rings) for variant in task.variants}) == 1


def test_crossed_keys_are_looked_at_in_their_corners():
    points = np.array(list(product(np.linspace(1, 3, 5), np.linspace(10, 20, 7))))
    rng = np.random.default_rng(5)
    for order in (np.arange(len(points)), rng.permutation(len(points))):
        shuffled = points[order]
        taken = extremes(shuffled)
        assert len(taken) == 6
        assert {*map(tuple, shuffled[taken][:4])} == {(1, 10), (1, 20), (3, 10), (3, 20)}


def test_samples_are_looked_at_where_each_of_the_first_three_keys_is_extreme():
    points = np.random.default_rng(7).normal(size=(500, 5))
    taken = extremes(points)
    assert len(taken) == 6
    for key in range(3):
        assert {points[:, key].argmin(), points[:, key].argmax()} <= {*taken}


def test_what_does_not_vary_is_looked_at_once():
    assert extremes(np.ones((4, 2))) == [0]
    assert extremes(np.ones((4, 0))) == [0]


@pytest.mark.slow
def test_a_study_of_the_paper_keeps_its_errors_below_the_estimates(chosen, tmp_path):
    """The case fixes 20 slices: life errors are largest at middle loads, where they are looked at too."""
    over = '"outer.thickness" = "3 mm"\n"operation.radial_load" = "5 kN .. 25 kN, 7"\n'
    collect = 'life = "life_L10 [h]"\nload = "max_roller_load [kN]"\n'
    table = flexbearing.study(
        study(tmp_path, over + '"accuracy.target" = "1 %"\n', "paper", collect, "mao2016.toml"),
        tmp_path,
        jobs=1,
    )
    assert chosen == [6]
    fine = '"accuracy.slices" = 320\n"accuracy.axial_shapes" = 5\n"accuracy.element_order" = 5\n'
    better = flexbearing.study(
        study(tmp_path, over + fine, "fine", collect, "mao2016.toml"), tmp_path, jobs=1
    )
    for name in ("life", "load"):
        true = np.abs(np.array(table[name].values) / better[name].values - 1) * 100
        assert (true <= np.array(table[f"{name} error"].values)).all()
