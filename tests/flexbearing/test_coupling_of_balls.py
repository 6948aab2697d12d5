"""Fast balls and their rings, by every method of the coupling, with the iterations of each."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.coupled.attempts import Attempt, nearest, summary
from flexbearing.coupled.balls import BallPartner
from flexbearing.coupling import PartnerFailed
from flexbearing.progress import Silent
from flexbearing.rings.grooves import groove_pair
from tests.flexbearing.test_balls_on_supports import CASE, LINES, RING, TEETH, built

CAGE = "configs/harris218_cage.toml"
BY_THRUST = RING | {"operation.load.axial": "3 kN"}
CASES = {"cage": (CAGE, {}), "thrust": (CASE, BY_THRUST), "lines": (CASE, LINES), "teeth": (CASE, TEETH)}


@pytest.mark.parametrize("name", CASES)
def test_methods_agree_and_each_stores_its_iterations(name):
    case, changes = CASES[name]
    methods = ("newton", "iqn-ils", "anderson")
    runs = [flexbearing.run(case, changes | {"coupling.method": each}) for each in methods]
    loads = runs[0].flexible["contact_load"]
    for method, result in zip(methods, runs, strict=True):
        assert result.flexible["contact_load"] == approx(loads, rel=0, abs=1e-6 * loads.max())
        about = result.attributes
        assert about["attempts"][method]["status"] == about["status"] == "converged"
        assert len(result.iterations) == about["iterations"] == about["attempts"][method]["iterations"]
        assert result.iterations[-1]["contact_load"] == approx(result.flexible["contact_load"], rel=1e-12)
        assert result.history("load_change")[-1] < 1e-7 < result.history("load_change")[0]
        assert "convergence" in dir(result.plot)
    assert runs[0].history("mismatch").max() < 1e-8 < runs[1].history("mismatch").max()


def test_a_file_holds_the_iterations_of_balls(tmp_path):
    result = flexbearing.run(CASE, BY_THRUST, output=tmp_path / "balls.h5")
    assert flexbearing.read(tmp_path / "balls.h5") == result
    assert result.iterations[0]["contact_load"].shape == result.flexible["contact_load"].shape


def test_iterations_that_end_early_are_no_answer(tmp_path):
    """The state that came nearest is stored, and rows end as runs."""
    changes = BY_THRUST | {"coupling.method": "aitken", "coupling.max_iterations": 3}
    result = flexbearing.run(CASE, changes | {"coupling.fallback": False}, output=tmp_path / "balls.h5")
    assert result.attributes["status"] == "iteration limit"
    assert "stopped after 3 iterations" in result.attributes["message"]
    assert result.flexible["contact_load"] == approx(result.iterations[-1]["contact_load"])
    helped = flexbearing.run(CASE, changes | {"coupling.max_iterations": 40})
    assert helped.attributes["status"] == "converged"
    assert [*helped.attributes["attempts"]] == ["aitken"]
    other = flexbearing.run(CASE, changes | {"coupling.max_iterations": 6})
    assert [*other.attributes["attempts"]] == ["aitken", "newton"]
    assert other.attributes["status"] == "converged"


def test_loads_change_by_deviations_about_as_estimated():
    """Of a held ring; a free one follows a displacement of its groove, and no load changes."""
    case, model, load, azimuths = built(BY_THRUST)
    angles = groove_pair(case, azimuths, Silent()).angles
    free = BallPartner(model, load, angles)
    rigid = free.solve()
    held = replace(load, load=(0.0,) * 5, displacement=tuple(rigid.between.ring_displacement))
    partner = BallPartner(model, held, angles)
    change = np.zeros_like(rigid.forces)
    change[:] = 1e-8 * np.random.default_rng(1).normal(size=(2, len(azimuths), 1))
    moved = [partner.solve(deviation=sign * change).loads for sign in (1, -1)]
    by_deviation = partner.force_by_deviation(rigid) @ change.ravel()
    expected, measured = by_deviation.reshape(change.shape).sum(2), (moved[0] - moved[1]) / 2
    assert np.abs(expected - measured).max() < 0.05 * np.abs(measured).max()
    axially = np.zeros_like(change)
    axially[0] = 1e-8 * np.sin(angles[0])
    by_ring = free.force_by_deviation(rigid) @ axially.ravel()
    assert np.abs(by_ring).max() < 1e-9 * np.abs(partner.force_by_deviation(rigid) @ axially.ravel()).max()


def test_a_method_that_fails_where_it_begins_is_stored_before_the_next(monkeypatch):
    def failing(self, grooves):
        raise PartnerFailed("no balance", "stalled")

    monkeypatch.setattr(BallPartner, "_iterates", failing)
    result = flexbearing.run(CASE, BY_THRUST)
    ends = {name: each["status"] for name, each in result.attributes["attempts"].items()}
    assert ends == {"newton": "not solved", "iqn-ils": "converged"}
    moved = result.history("groove_displacement")
    assert not moved[0].any()
    assert moved[-1] == approx(result.flexible["groove_displacement"], rel=1e-9)


def test_the_message_is_that_of_the_nearest_attempt_and_names_the_others():
    first, second = (
        Attempt(name, 3, "not solved", f"why {name} failed", "not solved", None, True, error)
        for name, error in (("newton", 1.0), ("relaxed", 0.1))
    )
    words = summary([first, second], nearest([first, second]))
    assert "why relaxed failed" in words
    assert "neither did newton" in words
    assert "why newton failed" not in words
