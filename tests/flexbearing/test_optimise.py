"""The best design of a problem whose optimum is known, through files, journal and optimiser."""

import tomllib
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from math import exp
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import flexbearing
from flexbearing import __main__ as program
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput
from flexbearing.findings.row import INFORMATION, RowFinding
from flexbearing.life import roller_lives
from flexbearing.optimise import evaluations, messages, run
from flexbearing.optimise.answer import Optimum
from flexbearing.optimise.case_file import case_text
from flexbearing.optimise.evaluations import Workers, designs_of
from flexbearing.optimise.file import read as read_problem
from flexbearing.optimise.goals import DesignProblem, Terms
from flexbearing.optimise.gradients import CENTRAL, EXACT
from flexbearing.optimise.optimality import optimality
from flexbearing.optimise.run import optimise
from flexbearing.optimise.schema import Search
from flexbearing.optimise.search import End, ScaledProblem, search
from flexbearing.optimise.variables import Variable
from flexbearing.optimise.worker import BY, NO_SLOPE_BY, slope_name
from flexbearing.outputs import requested
from flexbearing.quantities.roller import LAYOUT
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.plan import Row
from flexbearing.studies.prepared_study import variants_of
from flexbearing.studies.run import Work
from tests.flexbearing.toy_studies import CASE, no_ring

LIFE, SLIP, STIFFNESS = "life_L10 [Mrev]", "cage_slip [%]", "stiffness_zz [N/um]"
FILE = """
case = "{case}"
[vary]
"bearing.clearance" = "0 um .. 60 um"
"bearing.roller.drop" = "log 1 um .. 20 um"
[maximise]
output = "life_L10 [Mrev]"
{more}
"""
STARTS = "\n[search]\nstarts = 2"
MORE = '[constrain]\ncage_slip = "<= 6 %"'


def hill(task, keys=None):
    """Life exp(-(x - 30)^2 / 400 - (y - 5)^2 / 9), slip x / 10 + y; exact slopes by the clearance x alone."""
    found = []
    for variant in task.variants:
        values = dict(zip(task.base.keys, variant.in_si, strict=True))
        x, y = 1e6 * values["bearing.clearance"], 1e6 * values["bearing.roller.drop"]
        shift = values.get("operation.misalignment", 0.0) * 1e5
        life = 1000 * exp(-((x - 30 - shift) ** 2) / 400 - (y - 5) ** 2 / 9)
        numbers = {LIFE: life, SLIP: x / 10 + y, STIFFNESS: 100 / y}
        if keys is not None:
            numbers[slope_name(LIFE, "bearing.clearance")] = -life * (x - 30 - shift) / 200 * 1e6
            numbers |= {
                slope_name(SLIP, "bearing.clearance"): 1e5,
                slope_name(STIFFNESS, "bearing.clearance"): 0.0,
            }
        failed = variant.identity and y > 15 and keys is None
        found.append(
            Row(
                variant.identity,
                "iteration limit" if failed else "converged",
                "",
                0.1,
                {} if failed else numbers,
            )
        )
    return found


def counting(asked):
    """The same work; how many variants it was asked for stands in a list."""

    def counted(task, keys=None):
        asked.append(len(task.variants))
        return hill(task, keys)

    return counted


def found(folder, more=MORE, work=hill) -> Optimum:
    """The optimum of the hill."""
    file = folder / "hill.toml"
    file.write_text(FILE.format(case=CASE, more=more if "[search]" in more else more + STARTS))
    workers = Workers(Work(work, no_ring), lambda keys: Work(partial(work, keys=keys), no_ring))
    return optimise(file, folder / "out", work=lambda problem, folder: workers)


def test_optimum_on_a_constraint_with_its_multiplier(tmp_path):
    """Of f = -(x-30)^2/400 - (y-5)^2/9 on x/10 + y = 6: grad f = lambda (1/10, 1)."""
    optimum = found(tmp_path)
    rate = (30 / 10 + 5 - 6) / (200 / 10**2 + 4.5)  # lambda per percent of slip
    assert optimum.best.point == pytest.approx((30 - 20 * rate, 5 - 4.5 * rate), rel=1e-3)
    assert optimum.converged
    (active,) = optimum.active
    assert active.words.startswith("cage_slip <= 6 %")
    assert active.gain == pytest.approx(rate, rel=1e-3)
    assert optimum.how == {"bearing.clearance": EXACT, "bearing.roller.drop": CENTRAL}
    assert len(optimum.agreeing) == 2


def test_inner_optimum_has_nothing_active(tmp_path):
    optimum = found(tmp_path, "")
    assert optimum.best.point == pytest.approx((30, 5), rel=2e-3)
    assert (optimum.converged, optimum.active) == (True, ())


def test_bound_of_a_key_has_a_multiplier_by_its_unit(tmp_path):
    """At y = 8 with stiffness 100/y <= 100/8: the clearance is free, a micrometre of drop costs 2/3."""
    optimum = found(tmp_path, '[constrain]\nstiffness_zz = "<= 12.5 N/um"')
    (active,) = optimum.active
    assert optimum.best.point[1] == pytest.approx(8, rel=1e-4)
    assert active.gain == pytest.approx(2 / 9 * 3 * 8**2 / 100, rel=1e-3)


def test_worst_of_a_band_lies_in_its_middle(tmp_path):
    """Hills at 30 um and 30 + 29.09 um: the worst is best between them."""
    band = '[over]\n"operation.misalignment" = ["0 arcmin", "1 arcmin"]'
    optimum = found(tmp_path, band)
    assert optimum.best.point[0] == pytest.approx(30 + 1e5 * np.radians(1 / 60) / 2, rel=1e-3)
    assert optimum.best.optimality is not None
    assert optimum.best.optimality.terms == pytest.approx([0.5, 0.5], abs=1e-3)


def test_duty_life_is_cumulated_with_its_slopes(tmp_path):
    """Two rows with hills d apart: 1 / sum(phi / L) is largest where phi_i (x - x_i) / L_i add up to zero."""
    duty = '[duty]\ntime = ["30 %", "70 %"]\n"operation.misalignment" = ["0 arcmin", "0.5 arcmin"]'
    file = FILE.replace("life_L10 [Mrev]", "duty_life [Mrev]")
    (tmp_path / "hill.toml").write_text(file.format(case=CASE, more=duty + STARTS))
    workers = Workers(Work(hill, no_ring), lambda keys: Work(partial(hill, keys=keys), no_ring))
    optimum = optimise(tmp_path / "hill.toml", tmp_path, work=lambda problem, folder: workers)
    x, d = optimum.best.point[0] - 30, 1e5 * np.radians(0.5 / 60)
    assert 0.3 * x * exp(x**2 / 400) + 0.7 * (x - d) * exp((x - d) ** 2 / 400) == pytest.approx(
        0, abs=0.02 * d
    )


def test_second_start_computes_nothing_again(tmp_path):
    first, asked = found(tmp_path), []
    second = found(tmp_path, work=counting(asked))
    assert (asked, second.rows) == ([], 0)
    assert second.best.point == first.best.point
    assert first.rows > 0


@pytest.mark.slow
def test_torn_journal_is_completed(tmp_path):
    first = found(tmp_path)
    journal = tmp_path / "out" / "hill.journal.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    journal.write_bytes(b"".join(lines[:20]) + lines[20][:9])
    second = found(tmp_path)
    assert 0 < second.rows < first.rows
    assert second.best.point == first.best.point


def test_later_start_that_leads_to_no_better_optimum_is_not_refined(tmp_path):
    more = MORE + "\n[search]\nstarts = 4"
    optimum = found(tmp_path, more)
    ended = [start for start in optimum.starts if "no better than that of a former start" in start.message]
    assert ended
    assert all(start.end is End.CONVERGED for start in optimum.starts)
    assert all(optimum.best.merit - 1e-3 < start.merit < optimum.best.merit for start in ended)
    assert optimum.best not in ended


def test_point_that_meets_all_constraints_is_searched_near_the_end_of_a_search():
    """Not where margins are largest, at 0: that would throw away what was found."""
    nearest = search(ScaledProblem(Plane(), nearest=True), np.array([0.8, 0.5]))
    assert nearest.point == pytest.approx((0.55, 0.25), abs=1e-6)


class Plane:
    """x + y of two variables from 0 to 1, at most 0.8."""

    @property
    def wanted(self):
        variables = tuple(Variable(name, name, None, 0.0, 1.0, "") for name in "xy")
        return DesignProblem(variables, Search(), self, (self,))

    def merits(self, numbers):
        return Terms(-numbers.values, -numbers.slopes)

    def margins(self, numbers):
        return Terms(0.8 + numbers.values, numbers.slopes)

    def values(self, points):
        return [self.at(point) for point in points]

    def at(self, point):
        return Terms(np.array([-sum(point)]), np.array([[-1.0, -1.0]]))


def test_infeasible_problem_is_told(tmp_path):
    optimum = found(tmp_path, '[constrain]\ncage_slip = "<= 0.5 %"')
    assert optimum.best.end is End.INFEASIBLE
    page = messages.page(optimum, tmp_path)
    assert "missed: cage_slip <= 0.5 %: 1" in page
    assert "no case of the best is written" in page
    assert "more room" not in page
    assert "%)" not in page.split("case -> best")[1].splitlines()[1]
    assert not [*tmp_path.rglob("*_optimum.toml")]
    assert not optimum.converged
    assert optimum.best.missed == pytest.approx(1.0, rel=1e-3)  # slip is 1 % at least


def test_margin_beyond_the_spare_one_promises_its_multiplier_times_itself():
    merit = Terms(np.array([0.0]), np.array([[2.0, 0.0]]))

    def gain(margin):
        margins = Terms(np.array([margin]), np.array([[-0.5, 0.0]]))  # all of the slope, by a multiplier of 4
        return optimality(merit, margins, np.full(2, 0.5), spare=5e-4).gain

    assert gain(5e-4) == pytest.approx(0.0, abs=1e-9)
    assert gain(1.5e-3) == pytest.approx(4e-3, rel=1e-6)


def test_multipliers_have_the_sign_of_their_end_and_the_size_of_the_slope():
    """f = -3 x + 2 y + 5 z at x = 0, y = 1 and a used-up margin of 1 - z: each end holds the whole slope."""
    merit = Terms(np.array([0.0]), np.array([[-3.0, 2.0, 5.0]]))
    margin = Terms(np.array([0.0]), np.array([[0.0, 0.0, -1.0]]))
    found = optimality(merit, margin, np.array([0.0, 1.0, 0.5]))
    assert found.ends == pytest.approx([-3.0, 2.0, 0.0], abs=1e-9)
    assert found.bounds == pytest.approx([5.0])
    assert found.gain == pytest.approx(0.0, abs=1e-9)
    inwards = Terms(np.array([0.0]), np.array([[3.0, -2.0, 5.0]]))  # no end holds what leads away from it
    assert optimality(inwards, margin, np.array([0.0, 1.0, 0.5])).ends == pytest.approx([0.0, 0.0, 0.0])


def test_iteration_limit_is_not_convergence(tmp_path):
    optimum = found(tmp_path, MORE + "\n[search]\niterations = 1\nstarts = 1")
    assert optimum.best.end is End.LIMIT
    assert not optimum.converged


def test_models_without_derivatives_find_it_too(tmp_path):
    optimum = found(tmp_path, MORE + '\n[search]\nmethod = "cobyqa"\nstarts = 1')
    rate = 2 / 6.5
    assert optimum.best.point == pytest.approx((30 - 20 * rate, 5 - 4.5 * rate), rel=0.02)


def test_best_case_is_read_as_it_was_searched(tmp_path):
    from flexbearing.api import read_case

    optimum = found(tmp_path)
    case = read_case(tmp_path / "out" / "hill_optimum.toml")
    assert case.bearing.clearance == pytest.approx(1e-6 * optimum.best.point[0])
    assert case.bearing.roller.drop == pytest.approx(1e-6 * optimum.best.point[1])


def test_an_empty_text_takes_a_key_out_of_every_design(tmp_path):
    case, file = CASE.parent / "catalogue" / "nu210.toml", tmp_path / "drop.toml"
    out = {
        "set": ("life.lubrication", "life.cleanliness"),
        "surrogate": ("life.fatigue_limit_load",),
        "[verify]": ("life.static_rating",),
    }
    tables = (f"[{name}]\n" + "\n".join(f'"{key}" = ""' for key in keys) for name, keys in out.items())
    vary = '[vary]\n"bearing.cage.thickness" = "4 mm .. 6 mm"\n[maximise]\noutput = "life_L10 [h]"\n'
    file.write_text(f'case = "{case}"\n{vary}' + "\n".join(tables))
    problem = read_problem(file, FAMILIES)
    prepared = designs_of(
        problem, [problem.fixed | more for more in ({}, problem.surrogate, *problem.verify)]
    )
    prepared.plan.require_sound()
    read = variants_of(prepared.plan.base)
    for variant, more in zip(prepared.plan.variants, ((), out["surrogate"], out["[verify]"]), strict=True):
        life = read_case(case, [f"{key}=" for key in (*out["set"], *more)]).life
        assert read.case(variant.values).life == read.known(variant.values, variant.in_si).life == life


def test_an_edited_case_of_the_best_is_kept(tmp_path):
    for _ in range(2):  # the second replaces what the first wrote
        found(tmp_path)
    best = tmp_path / "out" / "hill_optimum.toml"
    edited = best.read_text().replace("[bearing]", "# mine\n[bearing]")
    best.write_text(edited)
    asked = []
    with pytest.raises(BadOutput, match=r"hill_optimum\.toml: was edited, .* rename it"):
        found(tmp_path, work=counting(asked))
    assert (best.read_text(), asked) == (edited, [])


def test_best_case_has_the_rating_of_its_bearing():
    """A rating in a file is that of the bearing in the file."""
    place = CASE.parent / "catalogue" / "nj2210.toml"
    study = SimpleNamespace(case=place, path=place, text=place.read_text(), settings=())
    settings = {"bearing.roller.length": "8 mm"}
    text = case_text(study, settings, place.parent).decode()
    best = tomllib.loads(text)
    drawn = roller_bearing.bearing(case := read_case(place, settings)).bearing
    assert roller_lives.rated(case, drawn).dynamic < 70e3
    assert best["life"]["dynamic_rating"] == f"{roller_lives.rated(case, drawn).dynamic / 1e3:.6g} kN"
    assert best["life"]["static_rating"] == f"{roller_lives.rated(case, drawn).static / 1e3:.6g} kN"


VARY, GOAL = '[vary]\n"bearing.clearance" = "0 um .. 1 um"\n', '[maximise]\noutput = "life_L10"\n'
WRONG = {
    VARY.replace("clearance", "clearence") + GOAL: "Did you mean clearance",
    VARY.replace("0 um", "9 um") + GOAL: "second is not above the first",
    VARY.replace("0 um .. 1 um", "5 um") + GOAL: "is no pair of bounds",
    VARY.replace("0 um .. 1 um", "9 .. 12").replace("clearance", "rollers") + GOAL: "cannot be varied",
    VARY + GOAL.replace("life_L10", "live_L10"): "[maximise] 'live_L10'",
    VARY: "[maximise] or [minimise] is needed",
    VARY + GOAL.replace("life_L10", "duty_life"): "needs [duty]",
    VARY + GOAL + "[constrain]\ncage_slip = 5": "is no bound",
    '[vary]\n"bearing.roller.length" = "4 mm .. 5 mm"\n[set]\n"life.static_rating" = "9 kN"\n'
    + GOAL: "varies; write",
    VARY + GOAL + "[searching]\nstarts = 2": "searching",
}


@pytest.mark.parametrize(("text", "words"), WRONG.items())
def test_mistakes_are_told_with_their_place(tmp_path, text, words):
    file = tmp_path / "wrong.toml"
    file.write_text(f'case = "{CASE}"\n{text}\n')
    with pytest.raises(BadCase) as told:
        optimise(file, tmp_path)
    assert words in str(told.value)
    assert str(told.value).startswith("wrong.toml: ")


def test_command_tells_the_answer(tmp_path, capsys):
    file = Path(tmp_path / "best.toml")
    file.write_text(f'case = "{CASE}"\n{VARY.replace("1 um", "60 um")}{GOAL}[search]\nstarts = 1\n')
    assert program.command(["optimise", str(file), "-o", str(tmp_path)]) == 0
    told = capsys.readouterr().out
    assert "bearing.clearance = " in told
    assert "best_optimum.toml" in told


def test_workers_verify_a_design_while_others_find_its_slopes(tmp_path, monkeypatch, two_cores):
    """The same optimum and rows as with one process, each once; what may be the last is verified early."""
    monkeypatch.setattr(run, "_engine", lambda processes, base: nullcontext(lambda tasks: Serial()))
    more = '[search]\nstarts = 1\nverified = true\n[[verify]]\n"accuracy.slices" = 40'
    optima, computed = [], []
    for jobs in (1, 2):
        folder, asked = tmp_path / f"{jobs}", []
        folder.mkdir()
        (folder / "hill.toml").write_text(FILE.format(case=CASE, more=more))

        def noted(task, keys=None, asked=asked):
            asked.append([variant.identity for variant in task.variants])
            return hill(task, keys)

        workers = Workers(
            Work(noted, no_ring), lambda keys, noted=noted: Work(partial(noted, keys=keys), no_ring)
        )
        optima.append(
            optimise(folder / "hill.toml", folder, jobs=jobs, work=lambda problem, folder, w=workers: w)
        )
        computed.append(asked)
    one, two = optima
    assert one.converged
    assert two.best.point == pytest.approx(one.best.point, rel=1e-12)
    assert two.verified == one.verified
    alone, shared = ([name for task in asked for name in task] for asked in computed)
    assert set(alone) <= set(shared)
    assert len(set(shared)) == len(shared)
    first_finer, first_slope = alone[1], next(name for name in alone if BY in name)
    assert alone.index(first_finer) < alone.index(first_slope)
    assert shared.index(first_slope) + 1 == shared.index(first_finer)


MISALIGNED = """
case = "{case}"
[set]
"operation.misalignment" = "3 arcmin"
"operation.radial_load" = "9 kN"
[vary]
"bearing.roller.drop" = "log 0.5 um .. 20 um"
[maximise]
output = "life_L10 [h]"
[search]
starts = 1
"""


def found_of(tmp_path):
    file = tmp_path / "drop.toml"
    file.write_text(MISALIGNED.format(case=CASE))
    optimum = optimise(file, tmp_path)
    return optimum, messages.page(optimum, tmp_path)


def test_a_best_design_whose_peak_only_slices_have_is_none(tmp_path):
    """The life of slices is longest with pressed ends: no case of it is written, a former one is removed."""
    file = tmp_path / "drop.toml"
    file.write_text(MISALIGNED.format(case=CASE))
    former = tmp_path / "drop_optimum.toml"
    former.write_bytes(case_text(read_problem(file, FAMILIES).study, {}, tmp_path))
    optimum, page = found_of(tmp_path)
    assert optimum.best.end is End.CONVERGED
    assert optimum.best.point == (0.5,)
    assert not optimum.converged
    assert optimum.peaks.whole > 1.5 * optimum.peaks.sliced
    assert "no best design" in page
    assert [each.code for each in optimum.findings] == ["pressed-end"]
    assert "\n  outside validity: error of the peak pressure of slices: " in page
    assert "%)" not in page.split("case -> best")[1].splitlines()[1]
    assert not former.exists()


def test_a_design_that_converges_without_its_output_says_why(tmp_path):
    file = tmp_path / "thin.toml"
    file.write_text(
        f'case = "{CASE}"\n[set]\n"life.lubrication" = "a_ISO"\n"lubricant.viscosity" = "0.8 mPa s"\n'
        '"life.cleanliness" = "oil, in-line filter, -/17/14"\n[vary]\n'
        '"bearing.roller.drop" = "log 2 um .. 20 um"\n'
        '[maximise]\noutput = "modified_life [h]"\n[search]\nstarts = 1\n'
    )
    optimum = optimise(file, tmp_path)
    assert optimum.best.end is End.NO_ANSWER
    assert "no a_ISO holds there" in optimum.measured.message
    assert "no-modified-life" in {each.code for each in optimum.findings}


def test_of_keys_without_derivatives_each_has_its_reason():
    left_out = [RowFinding(NO_SLOPE_BY, INFORMATION, places=(key,), text=f"{key} jumps") for key in "ab"]
    row = Row("", "converged", "", 0.0, findings=tuple(left_out))
    assert [evaluations._why(row, key) for key in "abc"] == ["a: a jumps", "b: b jumps", ""]
    assert evaluations._why(replace(row, message="no balance"), "a") == "no balance"


def test_the_case_is_compared_under_the_operation_of_the_designs(tmp_path):
    optimum, _ = found_of(tmp_path)
    alike = flexbearing.run(CASE, ["operation.radial_load=9 kN", "operation.misalignment=3 arcmin"])
    assert optimum.case.objective == pytest.approx(
        requested(LAYOUT, "life_L10 [h]").number({"rigid": alike.rigid})
    )
