"""From a case file to a result file, and the promises of the command line."""

import json
import logging
from itertools import count
from types import SimpleNamespace

import h5py
import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.__main__ import command as in_this_process
from flexbearing.progress import Logged, line
from flexbearing.rings.raceways import CondensedRaceway
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
RIGID = ["outer.kind=rigid", "inner.kind=rigid"]
CAGE_ONLY = "inner.kind=rigid"
COARSE = ["accuracy.element_order=2"]


@pytest.fixture(scope="module")
def rigid(tmp_path_factory):
    return flexbearing.run(PAPER, RIGID, output=tmp_path_factory.mktemp("run") / "rigid.h5")


@pytest.fixture(scope="module")
def flexible(tmp_path_factory):
    return flexbearing.run(PAPER, COARSE, output=tmp_path_factory.mktemp("run") / "flexible.h5")


def test_rigid_parts_are_not_computed(rigid):
    assert rigid.attributes["status"] == "converged"
    assert rigid.attributes["iterations"] == 0
    assert rigid.attributes["structure"] == {}
    assert rigid.flexible["inner_load"] == approx(rigid.rigid["inner_load"], rel=0, abs=0)


def test_result_names_settings_and_what_the_case_assumes_or_fits(rigid):
    case = flexbearing.api.read_case(PAPER, RIGID)
    assert rigid.attributes["case_overrides"] == tuple(RIGID)
    assert rigid.attributes["assumed"] == tuple(case.assumed) != ()
    assert rigid.attributes["calibrated"] == dict(case.calibrated) != {}


@pytest.mark.parametrize(
    ("part", "other"), [pytest.param("outer", "inner", marks=pytest.mark.slow), ("inner", "outer")]
)
def test_only_the_part_that_is_flexible_is_meshed(part, other):
    result = flexbearing.run(PAPER, [f"{other}.kind=rigid", *COARSE])
    assert set(result.attributes["structure"]) == {part}
    assert np.abs(result.flexible[f"{other}_deviation"]).max() == 0.0
    assert np.abs(result.flexible[f"{part}_deviation"]).max() > 1e-6


def test_flexible_rings_spread_the_load(flexible):
    numbers = flexible.summary()
    rigid, flex = numbers["rigid"], numbers["flexible"]
    assert numbers["status"] == "converged"
    assert numbers["iterations"] <= 12
    assert flex["loaded_rollers"] > rigid["loaded_rollers"]
    assert flex["max_roller_load_N"] < rigid["max_roller_load_N"]
    assert flex["life_L10_Mrev"] > rigid["life_L10_Mrev"]
    assert flex["total_stiffness_N_per_m"] < flex["stiffness_N_per_m"] < rigid["stiffness_N_per_m"]


@pytest.mark.slow
def test_alternation_and_newton_end_at_the_same_loads(flexible):
    for method in ("relaxed", "aitken"):
        settings = [
            *COARSE,
            f"coupling.method={method}",
            "coupling.fallback=false",
        ]
        other = flexbearing.run(PAPER, settings)
        assert other.attributes["status"] == "converged"
        largest = flexible.flexible["inner_load"].max()
        assert other.flexible["inner_load"] == approx(flexible.flexible["inner_load"], abs=1e-7 * largest)


def test_method_that_fails_hands_over_to_one_that_can(flexible):
    settings = [*COARSE, "coupling.method=relaxed", "coupling.relaxation=0.5"]
    result = flexbearing.run(PAPER, settings)
    assert list(result.attributes["attempts"]) == ["relaxed", "newton"]
    first, second = result.attributes["attempts"].values()
    assert first["status"] in ("diverging", "not solved")
    assert second["status"] == result.attributes["status"] == "converged"
    assert second["iterations"] == result.attributes["iterations"] == len(result.iterations)
    assert result.flexible["inner_load"] == approx(flexible.flexible["inner_load"], rel=1e-9)


def test_method_that_fails_is_the_last_without_a_fallback():
    settings = [*COARSE, CAGE_ONLY, "coupling.method=relaxed", "coupling.fallback=false"]
    result = flexbearing.run(PAPER, [*settings, "coupling.max_iterations=1"])
    assert list(result.attributes["attempts"]) == ["relaxed"]
    assert result.attributes["status"] == "iteration limit"


@pytest.mark.slow
def test_rings_as_stiff_as_rock_are_rigid_ones(rigid):
    """Loads tend to the rigid ones as 1/E, linearly: ten times stiffer, ten times closer.

    Shaft and inner ring grow alike: what a hotter shaft adds along the raceway does not depend on E.
    """
    alike = ["operation.temperatures.shaft=220 degC", "materials.shaft.expansion=11.2e-6 1/K"]
    gaps = []
    for modulus in ("203e6 GPa", "2030e6 GPa"):
        rings = [f"materials.{part}.youngs_modulus={modulus}" for part in ("outer_ring", "inner_ring")]
        shaft = f"materials.shaft.youngs_modulus={modulus}"
        stiff_rigid_contact = flexbearing.run(PAPER, [*RIGID, *rings])
        stiff = flexbearing.run(PAPER, [*COARSE, *rings, shaft, *alike])
        gaps.append(np.abs(stiff.flexible["inner_load"] - stiff_rigid_contact.rigid["inner_load"]).max())
    assert gaps[0] < 1.0  # [N]
    assert gaps[1] == approx(gaps[0] / 10, rel=0.02)


@pytest.mark.slow
def test_largest_load_hardly_changes_with_the_mesh():
    """One level of refinement moves the flexible maximum of the paper's bearing by less than 0.1 %."""
    levels = ([], ["accuracy.mesh_size=2 mm"], ["accuracy.element_order=4"], ["accuracy.axial_shapes=4"])
    loads = [flexbearing.run(PAPER, settings).flexible["inner_load"].max() for settings in levels]
    assert loads[1:] == approx([loads[0]] * 3, rel=1e-3)


@pytest.mark.long
def test_full_solids_carry_the_load_alike():
    """Whole solids of moderate fineness and narrow patches, against half a pitch and axial sections."""
    solid = [
        "accuracy.structure=solid", "accuracy.element_order=3", "accuracy.mesh_size=2.4 mm",
        "accuracy.raceway_mesh_size=1.7 mm",
    ]  # fmt: skip
    loads = [flexbearing.run(PAPER, settings).flexible["inner_load"].max() for settings in ([], solid)]
    assert loads[1] == approx(loads[0], rel=3e-3)


def test_stiffness_from_base_to_shaft_is_that_of_a_state_in_balance(flexible):
    """Friction alone keeps the matrix from being symmetric."""
    stiffness = flexible.flexible["stiffness_matrix"][1:, 1:]
    size = np.sqrt(np.outer(np.diag(stiffness), np.diag(stiffness)))
    assert stiffness / size == approx(stiffness.T / size, abs=0.01)
    rigid = flexible.rigid["stiffness_matrix"][1:, 1:]
    assert (np.diag(stiffness)[:2] < np.diag(rigid)[:2]).all()  # radially; more loaded rollers may tilt less


def test_summary_has_the_stiffness_along_z_and_that_of_the_support_over_the_bearing(flexible):
    numbers, support = flexible.summary()["flexible"], flexible.attributes["structure"]["outer"]
    assert numbers["stiffness_zz_N_per_m"] == numbers["stiffness_matrix_SI"][2][2]
    ratio = support["support_stiffness_N_per_m"] / numbers["stiffness_N_per_m"]
    assert numbers["support_stiffness_ratio"] == approx(ratio, rel=1e-12)
    assert numbers["support_stiffness_N_per_m"] == support["support_stiffness_N_per_m"]
    for name in ("support_stiffness_ratio", "support_stiffness_N_per_m"):
        assert flexible.summary()["rigid"][name] is None


def test_every_iteration_is_in_the_file(flexible):
    with h5py.File(flexible.path) as file:
        count, first = file.attrs["iterations"], file["iterations"]
        assert first["inner_load"].shape == (count, 30)
        assert first["inner_slice_load"].shape == (count, 30, 20)
        assert first["inner_load"].attrs["units"] == "N"
        assert "title" in file.attrs["case_text"]
    assert flexible.history("residual")[-1] < 1e-10


def test_slices_add_up_to_the_roller_loads(flexible):
    width = np.diff(flexible.flexible["slice_position"])[0]
    assert flexible.flexible["inner_slice_load"].sum(1) * width == approx(flexible.flexible["inner_load"])


def test_rings_of_the_end_state_are_those_under_its_loads(monkeypatch):
    """A ring in a fit has another stiffness and another place under other loads."""
    asked, tangent = [], CondensedRaceway.linearised

    def linearised(self, outward):
        asked.append(outward)
        return tangent(self, outward)

    monkeypatch.setattr(CondensedRaceway, "linearised", linearised)
    settings = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8"]
    result = flexbearing.run(PAPER, settings)
    assert asked[-1][:, 0] == approx(result.flexible["outer_load"], rel=1e-12)
    assert asked[-1][:, 0] != approx(result.rigid["outer_load"], rel=1e-3)


def test_time_of_an_iteration_is_its_own(tmp_path, monkeypatch):
    monkeypatch.setattr("flexbearing.coupled.attempts.perf_counter", count().__next__)
    settings = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8"]
    result = flexbearing.run(PAPER, settings, output=tmp_path / "out.h5")
    assert len(result.iterations) > 2
    assert (result.history("seconds") == 1.0).all()  # the clock is looked at twice in each


def test_film_ratio_of_each_raceway_is_over_its_own_roughness():
    rough = {"roller": "0.1 um", "inner_raceway": "0.05 um", "outer_raceway": "0.4 um"}
    settings = {f"bearing.roughness.{surface}": value for surface, value in rough.items()}
    result = flexbearing.run(PAPER.with_name("nu209.toml"), settings)
    for race, raceway in (("inner", 0.05e-6), ("outer", 0.4e-6)):
        ratio = result.rigid[f"{race}_film"] / np.hypot(0.1e-6, raceway)
        assert result.rigid[f"{race}_film_ratio"] == approx(ratio, rel=1e-12)
    assert result.attributes["regimes"]["rigid"] == {"inner": "mixed", "outer": "boundary"}


def test_limit_of_iterations_is_not_convergence():
    result = flexbearing.run(PAPER, [*COARSE, CAGE_ONLY, "coupling.max_iterations=2"])
    assert result.attributes["status"] == "iteration limit"
    assert "2 iterations" in result.attributes["message"]


def test_only_a_solution_has_a_modified_life_and_a_regime():
    settings = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8",
                "life.reliability=0.95", "coupling.max_iterations=1", "coupling.fallback=false"]  # fmt: skip
    settings += [f"bearing.roughness.{name}=0.1 um" for name in ("roller", "inner_raceway", "outer_raceway")]
    result = flexbearing.run(PAPER, settings)
    assert result.attributes["status"] == "iteration limit"
    assert set(result.attributes["life"]) == set(result.attributes["regimes"]) == {"rigid"}
    assert "modified_life" in result.rigid
    assert "modified_life" not in result.flexible


def test_stage_is_logged_once_however_often_it_advances(caplog):
    report = Logged()
    with caplog.at_level(logging.INFO, logger="flexbearing"):
        for text, fraction in (
            ("mesh", None),
            ("mesh", 0.5),
            ("factor", 0.1),
            ("factor", 1.0),
            ("mesh", None),
        ):
            report.stage(text, fraction)
    assert [record.getMessage() for record in caplog.records] == ["mesh", "factor", "mesh"]


def test_line_of_an_iteration_tells_the_largest_load():
    loads = np.array([[10.0, 70.0, 20.0], [80.0, 0.0, 0.0]])
    iteration = SimpleNamespace(number=4, load_change=2e-3, state=SimpleNamespace(loads=loads))
    told = line(iteration)  # pyright: ignore[reportArgumentType]
    assert told == "iteration   4: largest load change 2.00e-03, largest load     70.0 N"


def test_progress_is_logged_with_units(tmp_path, caplog):
    with caplog.at_level(logging.DEBUG, logger="flexbearing"):
        flexbearing.run(PAPER, [*COARSE, CAGE_ONLY], output=tmp_path / "out.h5")
    lines = [record.getMessage() for record in caplog.records]
    assert any("outer ring: " in line and "unknowns" in line for line in lines)
    assert any("iteration   1: largest load change" in line and " N" in line for line in lines)


def test_summary_as_json_holds_the_contract(rigid, capsys):
    assert in_this_process(["summary", str(rigid.path), "--json"]) == 0
    numbers = json.loads(capsys.readouterr().out)
    assert {"status", "iterations", "wall_time_s", "rigid", "flexible"} <= set(numbers)
    for block in ("rigid", "flexible"):
        assert {
            "max_roller_load_N", "max_outer_load_N", "loaded_rollers", "loaded_arc_deg",
            "roller_azimuths_deg", "roller_loads_N", "outer_loads_N", "cage_slip_percent", "cage_speed_rpm",
            "ring_displacement_um", "mid_roller_deviation_um", "roller_end_deviation_um",
            "life_L10_Mrev", "stiffness_N_per_m",
        } <= set(numbers[block])  # fmt: skip


def test_run_prints_and_ends_with_zero(tmp_path, capsys):
    settings = [word for setting in RIGID for word in ("--set", setting)]
    assert in_this_process(["run", str(PAPER), "-o", str(tmp_path / "out.h5"), *settings]) == 0
    told = capsys.readouterr().out
    assert "largest roller " in told
    assert len(told.split()) < 120
    assert str(tmp_path / "out.h5") in told
    plot = ["plot", str(tmp_path / "out.h5"), "-o", str(tmp_path), "--format", "svg", "--no-titles"]
    assert in_this_process(plot) == 0
    assert len(list(tmp_path.glob("*.svg"))) == 3
    words = "no picture out_convergence: no part is flexible, so no iterations\n"
    assert words in capsys.readouterr().out


def test_quiet_run_says_nothing(tmp_path, capfd):
    settings = [word for setting in RIGID for word in ("--set", setting)]
    assert in_this_process(["run", str(PAPER), "-o", str(tmp_path / "out.h5"), "--quiet", *settings]) == 0
    assert capfd.readouterr() == ("", "")


BAD_CALLS = {
    "unknown key": (["check", PAPER, "--set", "bearing.clearence=1 um"], "Did you mean clearance?"),
    "no such case": (["run", "nowhere.toml"], "no such file"),
    "no such result": (["summary", "nowhere.h5"], "no such file"),
    "explain what is none": (["explain", "bearing.clearence"], "Did you mean bearing.clearance?"),
    "oil too hot": (
        ["check", PAPER, "--set", "lubricant.inlet_temperature=400 degC"],
        "outside 0 to 250 degC",
    ),
    "bars nearly as thick as the ring": (
        ["run", PAPER, "--set", "outer.bar_thickness=3.5 mm"],
        "mao2016.toml: [outer] bar_thickness",
    ),
    "no such format of pictures": (["plot", "nowhere.h5", "--format", "gif"], "it is one of png, svg, pdf"),
    "no such option": (["run", PAPER, "--fast"], "--fast"),
}


@pytest.mark.parametrize(("words", "message"), BAD_CALLS.values(), ids=BAD_CALLS.keys())
def test_bad_input_ends_with_two_and_a_message(words, message, capsys):
    assert in_this_process([str(word) for word in words]) == 2
    errors = capsys.readouterr().err
    assert message in errors
    assert "Traceback" not in errors


def test_run_that_does_not_converge_ends_with_one_and_a_complete_file(tmp_path, capsys):
    words = [
        word for setting in [*COARSE, CAGE_ONLY, "coupling.max_iterations=1"] for word in ("--set", setting)
    ]
    assert in_this_process(["run", str(PAPER), "-o", str(tmp_path / "out.h5"), "--quiet", *words]) == 1
    assert "not converged" in capsys.readouterr().err
    assert (tmp_path / "out.h5").exists()


def test_unloaded_bearing_with_clearance_is_reported_not_solved():
    result = flexbearing.run(PAPER, [*RIGID, "operation.radial_load=0 N"])
    assert result.attributes["status"] == "not solved"
    assert "undetermined" in result.attributes["message"]


@pytest.mark.parametrize("words", [["explain"], ["explain", "bearing.clearance"], ["explain", "outer"]])
def test_explain(words, capsys):
    assert in_this_process(words) == 0
    told = capsys.readouterr().out
    assert "clearance" in told or "outer" in told
