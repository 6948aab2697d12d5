"""Errors by slices, beside the same case with many more slices."""

import pytest

import flexbearing
from flexbearing.coupled.states import EndStates
from flexbearing.runs import life_error
from tests.places import CONFIGS

BEAM = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam"]  # nothing is meshed
CASES = {"rigid": ("nu209", []), "flexible": ("mao2016", BEAM)}


@pytest.mark.parametrize("name", CASES)
def test_true_errors_of_few_slices_are_below_the_estimates_and_no_tenth_of_them(name, tmp_path):
    case, settings = CASES[name]
    coarse, fine = (
        flexbearing.run(
            CONFIGS / f"{case}.toml", [*settings, f"accuracy.slices={n}"], output=tmp_path / f"{n}.h5"
        )
        for n in (10, 320)
    )
    estimate, value, true = coarse.attributes["slice_error"], coarse.flexible, fine.flexible
    assert estimate["slices"] == [20, 40]
    largest = max(value["inner_load"].max(), value["outer_load"].max())
    loads = max(abs(true[f"{race}_load"] - value[f"{race}_load"]).max() for race in ("inner", "outer"))
    assert 0.1 * estimate["roller_load"] <= loads / largest <= estimate["roller_load"]
    for output in ("total_stiffness", "driving_torque"):
        assert abs(true[output] / value[output] - 1) <= estimate[output]
    assert abs(true["peak_pressure"] / value["peak_pressure"] - 1).max() <= estimate["peak_pressure"]


def test_a_target_estimates_instead(tmp_path):
    result = flexbearing.run(CONFIGS / "nu209.toml", ["accuracy.target=5 %"], output=tmp_path / "out.h5")
    assert "slice_error" not in result.attributes


def test_runs_in_memory_spend_no_time_on_estimates(tmp_path):
    assert "slice_error" not in flexbearing.run(CONFIGS / "nu209.toml").attributes
    assert "slice_error" in flexbearing.run(CONFIGS / "nu209.toml", output=tmp_path / "out.h5").attributes


def test_an_output_that_finer_slices_do_not_have_has_no_error(monkeypatch, tmp_path):
    """Bearing and supports may be springs in series at some slices only."""
    seen = []

    class InSeriesAtFirst(EndStates):
        @property
        def stiffness(self):
            seen.append(self)
            return None if len(seen) > 1 else super().stiffness

    monkeypatch.setattr(life_error, "EndStates", InSeriesAtFirst)
    result = flexbearing.run(CONFIGS / "nu209.toml", output=tmp_path / "out.h5")
    assert len(seen) == 3
    assert "stiffness" not in result.attributes["slice_error"]
    assert "total_stiffness" in result.attributes["slice_error"]
