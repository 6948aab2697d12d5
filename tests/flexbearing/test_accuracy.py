"""The climb over ladders of levels, on ladders whose errors are known."""

from dataclasses import replace

import pytest
from hypothesis import given, strategies as st
from pytest import approx

from flexbearing.accuracy import Choice, Unusable, climb
from flexbearing.accuracy.estimates import attributes, unmet
from flexbearing.accuracy.ladder import Selection, Verdict, climb_together

LEVELS = 12
RATIO = 0.3
PART = Choice(
    name="part", levels=tuple(map(str, range(LEVELS))), weight=1, converging=1,
    above=1 / (1 - RATIO), below=RATIO / (1 - RATIO),
)  # fmt: skip
SLICES = Choice(name="slices", levels=tuple(map(str, range(LEVELS))), weight=1, above=1 / (1 - RATIO))


def series(first, *errors):
    """Errors of a ladder: `errors` of its first levels, then each RATIO of the one before."""
    errors = [first, *errors]
    return errors + [errors[-1] * RATIO ** (k + 1) for k in range(LEVELS - len(errors))]


class Answers:
    """An answer is the true one, and what the level of each choice leaves out; it counts what it is asked."""

    def __init__(self, *errors, broken=()):
        self.errors, self.broken, self.asked = errors, set(broken), set()

    def __call__(self, place):
        self.asked.add(place)
        for at in enumerate(place):
            if at in self.broken:
                raise Unusable(f"choice {at[0]} has no level {at[1]}")
        return 1.0 + sum(errors[level] for errors, level in zip(self.errors, place, strict=True))

    def climb(self, choices, target):
        return climb(choices, self, lambda a, b: {"load": abs(a - b)}, target, ("load",))


@given(
    st.floats(1e-6, 0.1),
    st.floats(-1, 1),
    st.floats(-RATIO, RATIO),
    st.floats(-0.5, 0.5),
)
def test_true_error_is_below_the_estimate_and_the_estimate_below_the_target(
    target, slices, part, flexibility
):
    answers = Answers(series(slices), series(flexibility, part * flexibility))
    found = answers.climb([SLICES, PART], target)
    true = abs(answers(found.place) - 1.0)
    assert true <= found.estimate["load"] * (1 + 1e-9) + 1e-12
    assert sum(verdict.allowed for verdict in found.verdicts) == approx(target)
    if found.met:
        assert found.estimate["load"] <= target


@given(st.floats(1e-5, 0.2), st.floats(1.0, 100.0), st.floats(0.01, 1), st.floats(0.01, RATIO))
def test_a_tighter_target_never_takes_a_coarser_level(target, tighter, slices, part):
    answers = Answers(series(slices), series(0.3, 0.3 * part))
    loose, tight = (answers.climb([SLICES, PART], t) for t in (target, target / tighter))
    assert all(a >= b for a, b in zip(tight.place, loose.place, strict=True))
    assert tight.estimate["load"] <= loose.estimate["load"] * (1 + 1e-12)


def test_estimate_of_a_known_series_is_its_error():
    found = Answers(series(0.1)).climb([SLICES], 1e-3)
    assert found.estimate["load"] == approx(series(0.1)[found.place[0]], rel=1e-9)
    below = Answers(series(0.5, 0.1)).climb([PART], 1e-3)
    assert below.estimate["load"] == approx(series(0.5, 0.1)[below.place[0]], rel=1e-9)


def test_of_two_levels_that_are_computed_the_finer_is_the_answer():
    answers = Answers(series(0.5, 1e-4))
    found = answers.climb([PART], 1e-2)
    assert found.place == (2,)
    assert max(answers.asked) == (2,)


def test_a_part_that_changes_nothing_stays_rigid():
    answers = Answers(series(1e-3, 1e-4))
    found = answers.climb([PART], 1e-2)
    assert found.place == (0,)
    assert max(answers.asked) == (1,)  # judged by its coarsest level


def test_a_fixed_choice_stays_and_is_estimated():
    fixed = replace(SLICES, levels=("20", "40"), last=0)
    found = Answers([0.1, 0.03]).climb([fixed], 1e-3)
    assert found.place == (0,)
    assert found.estimate["load"] == approx(0.1, rel=1e-9)
    assert not found.met


def test_the_top_of_a_ladder_is_judged_by_the_level_below():
    short = replace(SLICES, levels=("a", "b", "c"))
    found = Answers([0.5, 0.2, 0.1]).climb([short], 1e-3)
    assert found.place == (2,)
    assert found.estimate["load"] == approx(0.1 / (1 - RATIO))
    assert not found.met


def test_a_level_without_an_answer_is_passed_over_and_told():
    answers = Answers(series(0.5, 0.1), broken=[(0, 2)])
    found = answers.climb([PART], 1e-2)
    assert found.place[0] > 2
    assert found.verdicts[0].unusable == {"2": "choice 0 has no level 2"}
    assert abs(answers(found.place) - 1) <= found.estimate["load"]


def test_two_levels_that_agree_by_accident_do_not_pass_when_more_are_looked_at():
    passing = [0.4, 0.1, 0.1, 0.03, *series(0.01)[:8]]  # levels 1 and 2 agree
    assert Answers(passing).climb([SLICES], 0.02).place == (1,)
    found = Answers(passing).climb([replace(SLICES, compared=2)], 0.02)
    assert found.place[0] > 2
    assert passing[found.place[0]] <= found.estimate["load"] <= 0.02


def test_nothing_to_compare_with_is_no_accuracy():
    answers = Answers(series(0.5, 0.1), broken=[(0, level) for level in range(1, LEVELS)])
    found = answers.climb([PART], 1e-2)
    assert found.place == (0,)
    assert not found.met


def test_no_answer_at_all_is_raised():
    with pytest.raises(Unusable, match="no level 0"):
        Answers(series(0.5), broken=[(0, 0)]).climb([SLICES], 1e-2)


def test_a_choice_that_matters_more_when_another_has_moved_is_looked_at_again():
    def answer(place):
        slices, part = place
        return 1.0 + series(0.5, 1e-3)[part] + (0.2 * RATIO**slices if part else 0.0)

    found = climb([SLICES, PART], answer, lambda a, b: {"load": abs(a - b)}, 0.02, ("load",))
    assert found.place[1] > 0
    assert abs(answer(found.place) - 1.0) <= 0.02


def test_errors_that_the_target_is_not_of_are_estimated_but_not_pursued():
    found = climb(
        [SLICES], lambda place: place[0], lambda a, b: {"slip": abs(a - b), "load": 0.0}, 0.1, ("load",)
    )
    assert found.place == (0,)
    assert found.met
    assert found.estimate["slip"] > 0.1


def test_verdict_is_judged_by_the_largest_of_its_outputs():
    verdict = Verdict(SLICES, 0, (1,), {"load": 0.01, "life": 0.2}, 0.1, ("load", "life"))
    assert verdict.excess
    assert not replace(verdict, judged=("load",)).excess


def test_problems_that_climb_together_take_the_finest_level_that_one_asks_for():
    """The first needs fine slices, the second a fine part; both orders end at the same levels."""
    target, load = 1e-3, lambda a, b: {"load": abs(a - b)}
    problems = [Answers(series(0.5), series(0.0)), Answers(series(0.0), series(0.5, 0.2))]
    alone = [problem.climb([SLICES, PART], target).place for problem in problems]
    assert alone[0][0] > alone[1][0]
    assert alone[0][1] < alone[1][1]
    finest = tuple(map(max, *alone))
    for order in (problems, problems[::-1]):
        selections = climb_together([SLICES, PART], order, load, target, ("load",))
        assert [selection.place for selection in selections] == [finest] * 2
        assert all(selection.met for selection in selections)


def test_a_problem_without_an_answer_where_others_are_ends_the_climb():
    problems = [Answers(series(0.5), series(0.0)), Answers(series(0.0), series(0.0), broken=[(0, 0)])]
    with pytest.raises(Unusable, match="choice 0 has no level 0"):
        climb_together(
            [replace(SLICES, last=0), PART], problems, lambda a, b: {"load": abs(a - b)}, 1e-3, ("load",)
        )


FIXED = replace(SLICES, last=0, fixed_by=("slices",))
MESH = replace(FIXED, name="outer ring", fixed_by=("element_order", "mesh_size"))


def told(*verdicts):
    """The note on a target that these do not meet."""
    (note,) = unmet([Selection(tuple(verdict.level for verdict in verdicts), verdicts, 0.01)])
    return note


def with_change(choice, life, level=0):
    return Verdict(choice, level, (level + 1,), {"life": life}, 0.005, ("roller_load", "life"))


def test_an_unmet_target_names_the_keys_that_hold_it_back_and_no_others():
    note = told(with_change(replace(FIXED, fixed_by=("axial_shapes",)), 1e-4), with_change(FIXED, 0.04))
    assert list(dict(note.keys)) == [
        "accuracy.target",
        "accuracy.slices",
    ]  # axial shapes keep their part of the target
    _, *held = dict(told(with_change(FIXED, 0.006), with_change(MESH, 0.04)).keys)
    assert held == ["accuracy.slices", "accuracy.element_order", "accuracy.mesh_size"]


def test_an_unmet_target_gives_every_error_with_what_it_is_a_share_of():
    changes = {"roller_load": 0.03, "life": 0.04, "stiffness": 0.5}
    text = told(Verdict(FIXED, 0, (1,), changes, 0.005, ("roller_load", "life"))).text
    assert "4.3 % of the largest load for the load of any roller and 5.7 % for the life, most of it" in text
    (note,) = unmet([Selection((0,), (with_change(FIXED, 0.04),), 0.01)])
    assert "are 5.7 % for the life, most" in note.text  # a load that has no estimate is left out


def test_the_finest_level_of_an_open_choice_is_not_called_fixed():
    """It was, and no key could be left out."""
    finest = with_change(replace(SLICES, last=LEVELS - 2), 0.04, level=LEVELS - 2)
    assert "the case fixes" not in told(finest).text
    (record,) = attributes([Selection((LEVELS - 2,), (finest,), 0.01)])["choices"].values()
    assert not record["fixed"]
    (record,) = attributes([Selection((0,), (with_change(FIXED, 0.04),), 0.01)])["choices"].values()
    assert record["fixed"]
