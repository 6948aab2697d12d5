"""An accuracy that a case of balls between elastic rings requests, from the case file to its rows."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.accuracy.groove_levels import ladders
from flexbearing.api import read_case
from flexbearing.cache.store import VARIABLE
from flexbearing.case import BadCase
from flexbearing.derivatives.balls import sensitivities
from flexbearing.report.output import text
from flexbearing.studies.placement import Placement
from flexbearing.studies.prepare import compute, prepare_source
from tests.flexbearing.noted import codes, keys, texts

PLAIN = "configs/6209.toml"
WIDE = {  # patches, so that few harmonics matter
    "outer.kind": "ring", "outer.thickness": "3.65 mm", "outer.width": "19 mm", "outer.support": "side",
    "bearing.outer.shoulder": "2.2 mm", "accuracy.patch_width": "2 mm", "operation.load.axial": "2 kN",
}  # fmt: skip
TARGET = {"accuracy.target": "0.2 %"}
FINE = {"accuracy.stations": 13, "accuracy.element_order": 3}
ROUGH = {"accuracy.stations": 5, "accuracy.element_order": 2, "accuracy.target": "0.001 %"}


@pytest.fixture(scope="module", autouse=True)
def rings(tmp_path_factory):
    """Rings that the tests share."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(tmp_path_factory.mktemp("rings")))
        yield


@pytest.fixture(scope="module")
def requested(rings, tmp_path_factory):
    return flexbearing.run(PLAIN, WIDE | TARGET, output=tmp_path_factory.mktemp("balls") / "target.h5")


def test_true_errors_are_below_the_estimates(requested):
    fine, estimate = flexbearing.run(PLAIN, WIDE | FINE).flexible, requested.attributes["error_estimate"]
    block = requested.flexible
    load, better = block["contact_load"], fine["contact_load"]
    assert estimate["met"]
    assert 0 < np.abs(load / better.max() - better / better.max()).max() <= estimate["ball_load"] <= 0.002
    assert abs(float(block["life_L10"] / fine["life_L10"]) - 1) <= estimate["life"] <= 0.002
    for place, name in enumerate(("stiffness_xx", "stiffness_yy", "stiffness_zz")):
        found, true = (each["stiffness_matrix"][place, place] for each in (block, fine))
        assert abs(found / true - 1) <= estimate[name]


def test_the_estimate_is_the_sum_of_the_choices_and_is_shown(requested):
    choices, estimate = requested.attributes["choices"], requested.attributes["error_estimate"]
    assert list(choices) == ["stations", "elements"]
    for output in ("ball_load", "life", "stiffness_zz"):
        parts = [choice["factor"] * choice["changes"][output] for choice in choices.values()]
        assert estimate[output] == approx(sum(parts))
    assert requested.summary()["error_estimate"]["life"] == estimate["life"]
    assert "accuracy of 0.2 % of loads and life: estimated to be kept" in text(requested)


def test_the_answer_is_that_of_the_same_levels_by_hand(requested):
    stations, elements = (choice["level"] for choice in requested.attributes["choices"].values())
    levels = {"accuracy.stations": int(stations), "accuracy.element_order": int(elements.split()[-1])}
    by_hand = flexbearing.run(PLAIN, WIDE | levels)
    assert requested.flexible["contact_load"] == approx(by_hand.flexible["contact_load"], rel=1e-9)
    assert by_hand.summary()["error_estimate"] is None


def test_what_the_case_gives_stays_and_is_estimated():
    result = flexbearing.run(PLAIN, WIDE | ROUGH)
    choices = result.attributes["choices"]
    assert [choice["level"] for choice in choices.values()] == ["5", "order 2"]
    assert [choice["compared_with"] for choice in choices.values()] == [["7", "9"], ["order 3"]]
    assert "unmet-target" in codes(result, "danger")
    assert list(keys(result, "unmet-target")) == [
        "accuracy.target", "accuracy.stations", "accuracy.element_order"
    ]  # fmt: skip
    (unmet,) = (note for note in texts(result) if "is not met" in note)
    assert "for the load of any ball and" in unmet


@pytest.mark.slow
def test_a_tighter_target_takes_finer_levels(requested):
    tight = flexbearing.run(PLAIN, WIDE | {"accuracy.target": "0.005 %"})
    finer, coarse = (result.attributes["error_estimate"] for result in (tight, requested))
    assert max(finer["ball_load"], finer["life"]) < max(coarse["ball_load"], coarse["life"])
    assert tight.attributes["choices"]["elements"]["level"] > "order 2"


def test_without_a_solution_at_the_coarsest_levels_the_usual_ones_are_used(monkeypatch):
    def unusable(*_):
        raise flexbearing.accuracy.Unusable("no equilibrium")

    monkeypatch.setattr("flexbearing.accuracy.shared.climb_together", unusable)
    result = flexbearing.run(PLAIN, WIDE | ROUGH)
    assert result.attributes["error_estimate"] == {}
    assert result.attributes["status"] == "converged"
    assert any("nothing could be chosen or estimated" in note for note in texts(result))


def test_variants_between_the_same_rings_share_levels_and_have_columns_of_errors(tmp_path, requested):
    outer = "contact_load_range.outer"
    study = {"case": PLAIN, "set": WIDE | TARGET, "over": {"operation.load.radial_z": ["8.9 kN", "4 kN"]}}
    study["collect"] = {"load": f"{outer}.largest", "least": f"{outer}.smallest"}
    prepared = prepare_source(study)
    assert [len(corners.variants) for corners in prepared.plan.corners] == [2]
    table = compute(prepared, tmp_path, Placement(jobs=1))
    assert table["load"].values[0] == approx(requested.flexible["contact_load"][1].max(), rel=1e-3)
    assert 0 < table["load error"].values[0] <= 0.2
    assert "least error" not in [column.name for column in table.columns]  # the error is of the largest load


def test_rigid_rings_have_nothing_to_choose():
    with pytest.raises(BadCase, match=r"target = .* is not used"):
        read_case(PLAIN, TARGET)


def test_stations_start_with_five_and_the_finest_only_measure():
    stations, elements = ladders(read_case(PLAIN, WIDE | TARGET))
    assert stations.choice.levels == ("5", "7", "9", "11", "13", "15")
    assert stations.choice.highest == 4
    assert elements.choice.levels[0] == "order 2"


def test_levels_that_are_chosen_anew_have_no_derivatives():
    with pytest.raises(BadCase, match=r"accuracy\.target chooses levels anew"):
        sensitivities(read_case(PLAIN, WIDE | TARGET))
