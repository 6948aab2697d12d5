"""Accuracy on order, from the case file to the summary."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.__main__ import command
from flexbearing.accuracy.case_levels import with_accuracy
from flexbearing.accuracy.levels import ladders
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.progress import Logged
from flexbearing.report.output import text
from flexbearing.rings import condensed
from flexbearing.rings.raceways import CondensedRaceway
from tests.flexbearing.noted import keys, texts
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
RING = ["outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm", "outer.support=seat"]
FINE = ["accuracy.slices=320", "accuracy.axial_shapes=5", "accuracy.element_order=5"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("accuracy")


@pytest.fixture(scope="module")
def ordered(folder):
    return flexbearing.run(PLAIN, [*RING, "accuracy.target=1 %"], output=folder / "ordered.h5")


def test_a_target_is_a_fraction_or_percent():
    assert read_case(PLAIN, ["accuracy.target=0.5 %"]).accuracy.target == approx(0.005)
    assert read_case(PLAIN).accuracy.target is None
    for wrong in ("0 %", "100 %", "1 mm", "0.01"):
        with pytest.raises(BadCase, match=r"accuracy.*target"):
            read_case(PLAIN, [f"accuracy.target={wrong}"])


@pytest.mark.parametrize(("given", "least"), [((), 8), (("accuracy.axial_shapes=6",), 10)])
def test_too_few_slices_for_the_axial_shapes_of_a_target_are_refused(given, least):
    target = [*given, "accuracy.target=1 %"]
    assert read_case(PLAIN, [*target, f"accuracy.slices={least}"]).accuracy.slices == least
    with pytest.raises(BadCase, match=rf"accuracy.*slices.*at least {least} .*leave accuracy.slices out"):
        read_case(PLAIN, [*target, f"accuracy.slices={least - 1}"])


def test_without_a_target_nothing_is_chosen_or_estimated(folder):
    result = flexbearing.run(PLAIN, ["outer.kind=rigid"], output=folder / "plain.h5")
    assert "choices" not in result.attributes
    assert "error_estimate" not in result.attributes
    assert result.flexible["slice_position"].size == 20
    assert result.summary()["error_estimate"] is None
    assert "accuracy of" not in text(result)


@pytest.mark.slow
def test_true_errors_are_below_the_estimates(ordered, folder):
    fine = flexbearing.run(PLAIN, [*RING, *FINE], output=folder / "fine.h5")
    estimate = ordered.attributes["error_estimate"]
    found, better = ordered.flexible, fine.flexible
    load = np.abs(found["inner_load"] - better["inner_load"]).max() / better["inner_load"].max()
    life = abs(float(found["life_L10"]) / float(better["life_L10"]) - 1)
    assert estimate["met"]
    assert load <= estimate["roller_load"] <= 0.01
    assert life <= estimate["life"] <= 0.01


def test_choices_say_level_change_and_share(ordered):
    choices = ordered.attributes["choices"]
    assert list(choices) == ["slices", "axial shapes", "outer ring"]
    assert int(choices["slices"]["level"]) == ordered.flexible["slice_position"].size
    allowed = sum(choice["allowed"] for choice in choices.values())
    assert allowed == approx(0.01)
    for output in ("roller_load", "life", "cage_slip", "stiffness", "total_stiffness"):
        parts = [choice["factor"] * choice["changes"][output] for choice in choices.values()]
        assert ordered.attributes["error_estimate"][output] == approx(sum(parts))
    assert not any(choice["fixed"] for choice in choices.values())


def test_summary_shows_values_with_their_errors(ordered):
    numbers = json.loads(json.dumps(ordered.summary(), allow_nan=False))
    assert numbers["error_estimate"]["life"] == ordered.attributes["error_estimate"]["life"]
    page = text(ordered)
    assert "accuracy of 1 % of loads and life: estimated to be kept" in page
    row = next(line for line in page.splitlines() if line.strip().startswith("basic life L10"))
    assert f"{100 * numbers['error_estimate']['life']:.2g}" in row.split()


@pytest.mark.slow
def test_what_the_case_gives_stays_and_is_estimated(folder):
    given = ["accuracy.slices=12", "accuracy.axial_shapes=3", "accuracy.element_order=3"]
    result = flexbearing.run(PLAIN, [*RING, *given, "accuracy.target=0.01 %"], output=folder / "fixed.h5")
    choices = result.attributes["choices"]
    assert result.flexible["slice_position"].size == 12
    assert choices["slices"]["level"] == "12"
    assert choices["axial shapes"]["level"] == "3"
    assert choices["outer ring"]["level"] == "as given"
    assert choices["outer ring"]["compared_with"] == ["harmonics, order 4"]
    assert all(choice["fixed"] for choice in choices.values())
    assert not result.attributes["error_estimate"]["met"]
    held = ["accuracy.target", "accuracy.slices", "accuracy.axial_shapes", "accuracy.element_order"]
    assert list(keys(result, "unmet-target")) == held


@pytest.mark.slow
def test_the_answer_is_that_of_the_same_levels_by_hand(folder):
    given = ["accuracy.slices=12", "accuracy.axial_shapes=3", "accuracy.element_order=3"]
    by_hand = flexbearing.run(PLAIN, [*RING, *given], output=folder / "hand.h5")
    result = flexbearing.run(PLAIN, [*RING, *given, "accuracy.target=1 %"], output=folder / "again.h5")
    assert result.attributes["choices"]["outer ring"]["level"] == "as given"
    assert result.flexible["inner_load"] == approx(by_hand.flexible["inner_load"], rel=1e-6)


@pytest.mark.slow
def test_a_tighter_target_is_never_resolved_coarser(ordered, folder):
    tight = flexbearing.run(PLAIN, [*RING, "accuracy.target=0.2 %"], output=folder / "tight.h5")
    loose, fine = (
        max(result.attributes["error_estimate"][output] for output in ("roller_load", "life"))
        for result in (ordered, tight)
    )
    assert fine <= 0.002
    assert fine < loose
    assert tight.flexible["slice_position"].size >= ordered.flexible["slice_position"].size


@pytest.mark.slow
def test_a_part_that_changes_nothing_is_left_rigid_and_told(folder):
    hard = "materials.outer_ring.youngs_modulus=2070e6 GPa"
    result = flexbearing.run(PLAIN, [*RING, hard, "accuracy.target=1 %"], output=folder / "rock.h5")
    assert result.attributes["choices"]["outer ring"]["level"] == "rigid"
    assert result.attributes["structure"] == {}
    assert any(note.startswith("outer ring: left rigid") for note in texts(result))


def test_fewer_axial_shapes_are_a_part_of_more():
    case, azimuths = read_case(PLAIN, [*RING, "accuracy.element_order=3"]), np.arange(5) * 2 * np.pi / 5
    many, few = (
        condensed.raceway(with_accuracy(case, axial_shapes=n), "outer", azimuths, Logged()) for n in (6, 3)
    )
    assert isinstance(many, CondensedRaceway)
    assert isinstance(few, CondensedRaceway)
    part, few = many.with_axial_modes(3).compliance, few.compliance
    assert part.absolute == approx(few.absolute, abs=1e-7 * np.abs(few.absolute).max())
    assert part.translation == approx(few.translation, abs=1e-7 * np.abs(few.translation).max())
    assert part.initial_deviation.shape == (5, 3)


def test_edge_stress_keeps_its_thirty_slices():
    slices = ladders(read_case(PLAIN, ["life.edge_stress=true", "accuracy.slices=30"]))[0]
    assert slices.choice.levels == ("30", "60", "120")
    chosen = ladders(read_case(PLAIN, ["life.edge_stress=true", "accuracy.target=1 %"]))[0]
    assert chosen.choice.levels[0] == "40"


def test_a_case_without_an_answer_is_told_and_solved_as_usual(folder):
    broken = ["accuracy.harmonics=900", "accuracy.target=1 %"]
    result = flexbearing.run(PLAIN, [*RING, *broken], output=folder / "broken.h5")
    assert result.attributes["status"] == "not solved"
    assert any("nothing could be chosen or estimated" in note for note in texts(result))
    assert result.attributes["error_estimate"] == {}


ON_LINES = [
    "outer.kind=ring", "outer.thickness=4 mm", "outer.width=19 mm", "outer.support=lines",
    'outer.line_azimuths=["-40 deg", "40 deg"]', "operation.tilt=fixed", "accuracy.target=1 %",
]  # fmt: skip


@pytest.mark.slow
def test_a_part_whose_levels_cannot_be_computed_is_not_left_rigid(folder, capsys):
    """Its harmonics are too few: the answer was rigid beside an error of 200 %."""
    path = folder / "coarse.h5"
    settings = [*ON_LINES, "accuracy.harmonics=8"]
    words = ["run", str(PLAIN), "-o", str(path), *(word for key in settings for word in ("--set", key))]
    assert command(words) == 1
    result = flexbearing.read(path)
    assert result.attributes["status"] == "not solved"
    assert not result.flexible
    codes = [note["code"] for note in result.attributes["notes"]]
    assert codes[0] == "unmet-target"
    assert "rigid-part" not in codes
    card = capsys.readouterr().out.partition("\n\n")[2]
    assert card.startswith("Not converged (")
    assert "danger     required accuracy" in card
    assert "take more harmonics" in result.attributes["message"]
