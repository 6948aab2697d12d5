"""The table [bearing.flange]: from the case file to datasets, summary, notes and page."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.report.output import text
from flexbearing.runs import skew
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
FLANGE = {
    "bearing.flange.ring": "outer",
    "bearing.flange.clearance": "30 um",
    "bearing.flange.height": "2 mm",
    "bearing.flange.roller_chamfer": "0.4 mm",
    "bearing.flange.stiffness": "100 N/um",
    "bearing.flange.friction": 0.05,
}
TILTED = {"operation.misalignment": "2 arcmin"}


def settings(values):
    return [f"{name}={value}" for name, value in values.items()]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "skew.h5"
    return flexbearing.run(PLAIN, settings(FLANGE | TILTED), output=path)


def test_rollers_of_a_tilted_ring_skew(run):
    block = run.rigid
    loaded = block["inner_load"] > 1.0
    assert np.abs(block["roller_skew"][loaded]).min() > 1e-7
    assert np.abs(block["skew_moment"]).max() > 1e-4
    minus, plus = block["flange_force"]
    assert plus - minus == approx(block["roller_thrust"], rel=1e-12, abs=1e-15)
    assert block["flange_power"] > 0.0
    # a roller's end, by hand: two circles cross
    rim, edge, pitch = 4.6e-3, 35.516e-3, 32.516e-3
    lever = np.sqrt(edge**2 - ((edge**2 + pitch**2 - rim**2) / (2 * pitch)) ** 2)
    assert block["touching_skew"] == approx(30e-6 / (2 * lever), rel=1e-12)


def test_summary_and_page_tell_of_the_skew(run):
    numbers = json.loads(json.dumps(run.summary()))["rigid"]["skew"]
    assert numbers["max_skew_mrad"] == approx(1e3 * np.abs(run.rigid["roller_skew"]).max(), rel=1e-12)
    assert len(numbers["flange_forces_N"]) == 2
    assert numbers["rollers_on_both_flanges"] >= 1
    page = text(run)
    assert "roller skew between guide flanges; without effect" in page
    assert f"{numbers['touching_skew_mrad']:.4g}" in page


def test_aligned_rollers_do_not_skew():
    case = read_case(PLAIN, FLANGE)
    found = skew.at(case, roller_bearing.bearing(case).solve())
    assert found is not None
    assert np.all(found.angle == 0.0)
    assert skew.notes(found, roller_bearing.bearing(case).solve(), [1e-7, 1e-7]) == ()


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_flanges_turn_with_their_own_ring_past_the_cage(ring, monkeypatch):
    seen = []
    monkeypatch.setattr(skew, "skewed", lambda running, *_: seen.append(running))
    speeds = {"operation.inner_speed": "3000 rpm", "operation.outer_speed": "-1000 rpm"}
    case = read_case(PLAIN, FLANGE | TILTED | speeds | {"bearing.flange.ring": ring})
    state = roller_bearing.bearing(case).solve()
    turns = {"inner": 100 * np.pi, "outer": -100 / 3 * np.pi}
    skew.at(case, state)
    (running,) = seen
    assert running.ring_speed == approx(turns[ring] - state.cage_speed, rel=1e-12)
    assert running.spin == approx(state.roller_speed, rel=1e-12)  # told in the frame of the cage, too


def test_case_without_flanges_has_no_skew():
    result = flexbearing.run(PLAIN)
    assert "roller_skew" not in result.rigid
    assert result.summary()["rigid"]["skew"] is None
    assert "skew" not in text(result)


def test_what_the_equilibrium_does_not_know_is_noted():
    case = read_case(
        PLAIN, FLANGE | TILTED | {"bearing.flange.friction": 1.0, "operation.misalignment": "6 arcmin"}
    )
    state = roller_bearing.bearing(case).solve()
    found = skew.at(case, state)
    assert found is not None
    costs, *others = reversed(skew.notes(found, state, [3e-7, 3e-7]))
    assert not others
    assert f"W at flanges and raceways in addition to {state.driving_power:.4g} W" in costs.text
    thin = skew.notes(found, state, [0.5 * found.end_gap, 0.0])
    assert f"changes the gap at the ends of the rollers by up to {found.end_gap * 1e6:.3f} um" in thin[0].text


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"bearing.flange.height": "6 mm"}, ", half of bearing.roller.diameter."),
        ({"bearing.flange.roller_chamfer": "3 mm"}, "above bearing.flange.roller_chamfer"),
        ({"bearing.flange.clearance": "0 um"}, "above 0 um"),
        ({"bearing.flange.stiffness": "100 N"}, "is not a stiffness"),
        ({"bearing.flange.ring": "both"}, "inner"),
    ],
)
def test_flange_that_cannot_be_is_refused(change, words):
    with pytest.raises(BadCase, match=words):
        read_case(PLAIN, FLANGE | change)


def test_heat_makes_the_flange_grow_but_not_its_clearance():
    hot = {
        f"operation.temperatures.{part}": "120 degC"
        for part in ("shaft", "inner_ring", "roller", "outer_ring")
    }
    case = read_case(PLAIN, FLANGE | hot | {"operation.temperatures.reference": "20 degC"})
    flange = roller_bearing.flange(case)
    assert flange is not None
    assert flange.height == approx(2e-3 * (1 + 11.5e-4), rel=1e-12)
    assert flange.clearance == approx(30e-6, rel=1e-12)
