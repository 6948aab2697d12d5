"""A case that starts from the end state of a neighbouring one."""

import shutil

import numpy as np
import pytest
from numpy.polynomial.legendre import legval
from pytest import approx
from typer.testing import CliRunner

import flexbearing
from flexbearing.case import BadCase
from flexbearing.case.read import read
from flexbearing.cli import application
from flexbearing.coupled.states import unknowns
from flexbearing.families import FAMILIES
from flexbearing.results import BadResult
from flexbearing.runs.run_case import compared
from quasidynamic import roller
from quasidynamic.solve.rollers import strategy
from tests.flexbearing.noted import texts
from tests.flexbearing.resealed import resealed
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
BALLS = PAPER.with_name("joshi2015_fag.toml")
PLANET = [
    "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]', 'outer.tooth_radial=["0 N", "0 N"]',
    'outer.tooth_tangential=["9800 N", "-9800 N"]',
]  # fmt: skip
RING = ["inner.kind=rigid", "outer.kind=ring", "accuracy.slices=8"]
NEAR = [*RING, "accuracy.structure=beam"]  # nothing is meshed
HOT_LENGTH = 5e-3 * (1 + 11.9e-6 * 206)  # [m] of a roller at 226 degC
HERE = [*NEAR, "operation.radial_load=18 kN"]


@pytest.fixture(scope="module")
def other(tmp_path_factory):
    return flexbearing.run(PAPER, NEAR, output=tmp_path_factory.mktemp("warm") / "other.h5")


@pytest.fixture(scope="module")
def cold(tmp_path_factory):
    return flexbearing.run(PAPER, HERE, output=tmp_path_factory.mktemp("warm") / "cold.h5")


def changed(result, path, change):
    """The same file with other unknowns."""
    shutil.copy(result.path, path)
    values = change(result.flexible["unknowns"])
    return resealed(path, lambda file: file["flexible/unknowns"].write_direct(values))


def test_warm_start_ends_where_a_cold_one_does_and_sooner(other, cold, tmp_path):
    warm = flexbearing.run(PAPER, HERE, output=tmp_path / "warm.h5", start=other.path)
    assert warm.attributes["status"] == "converged"
    assert warm.attributes["iterations"] < cold.attributes["iterations"]
    assert list(warm.attributes["attempts"]) == ["newton from an initial state"]
    assert warm.attributes["started_from"] == str(other.path)
    assert "started_from" not in cold.attributes
    for name in (
        "inner_load",
        "outer_load",
        "outer_deviation",
        "ring_displacement",
        "roller_speed",
        "unknowns",
    ):
        expected = cold.flexible[name]
        assert warm.flexible[name] == approx(expected, rel=0, abs=1e-9 * np.abs(expected).max()), name


@pytest.mark.parametrize("support", [["accuracy.structure=beam"], PLANET], ids=["beam", "planet"])
def test_case_that_starts_from_itself_is_there_at_once(support):
    """What bends a planet without any roller is not counted twice."""
    settings = [*RING, "accuracy.element_order=2", *support]
    first = flexbearing.run(PAPER, settings)
    again = flexbearing.run(PAPER, settings, start=first)
    assert again.attributes["iterations"] == 1
    assert again.history("residual")[0] < 1e-9


def test_alternated_state_is_a_start_too(other):
    alternated = flexbearing.run(PAPER, [*NEAR, "coupling.method=iqn-ils"])
    again = flexbearing.run(PAPER, NEAR, start=alternated)
    assert again.attributes["iterations"] <= 2
    largest = np.abs(other.flexible["unknowns"]).max()
    assert alternated.flexible["unknowns"] == approx(other.flexible["unknowns"], rel=0, abs=1e-6 * largest)


@pytest.mark.slow
def test_fit_starts_where_it_was(tmp_path):
    fit = ["outer.kind=rigid", "inner.fit=frictionless", "accuracy.element_order=3", "accuracy.slices=8"]
    fit += ["accuracy.axial_shapes=2"]
    first = flexbearing.run(PAPER, fit, output=tmp_path / "first.h5")
    again = flexbearing.run(PAPER, fit, output=tmp_path / "again.h5", start=first)
    assert again.attributes["iterations"] < first.attributes["iterations"]
    assert again.attributes["started_from"] == str(first.path)
    assert again.flexible["inner_load"] == approx(first.flexible["inner_load"], rel=1e-6)


def test_unknowns_are_stored_in_the_order_that_the_layout_tells(other):
    for block in (other.rigid, other.flexible):
        assert block["unknowns"][:2] == approx(block["ring_displacement"], rel=1e-15)
        assert block["unknowns"][95:125][block["outer_load"] > 1] == approx(
            block["outer_film"][block["outer_load"] > 1], rel=1e-15
        )
    coefficients = other.flexible["unknowns"][155:].reshape(2, 30, 3)
    along = 2 * other.flexible["slice_position"] / HOT_LENGTH
    assert legval(along, coefficients[1].T) == approx(other.flexible["outer_deviation"], rel=0, abs=1e-12)


def test_unknowns_come_back_as_they_were_stored(other):
    values = np.random.default_rng(1).random(other.flexible["unknowns"].size)
    x = unknowns(values, 30)
    assert x.ring.ravel() == approx(values[:4])
    assert x.cage_drift.ravel() == approx(values[4:5])
    assert np.concatenate([x.approach, x.tilt, *x.film, x.spin_drift], axis=1)[0] == approx(values[5:155])
    assert np.moveaxis(x.deviation[:, :, 0], 1, -1).ravel() == approx(values[155:])


# -- starts that fail ------------------------------------------------------------------------------


@pytest.mark.slow
def test_damaged_start_falls_back_to_rigid_raceways(other, cold, tmp_path):
    damaged = changed(other, tmp_path / "damaged.h5", lambda x: x * 1e6)
    found = flexbearing.run(
        PAPER, [*HERE, "coupling.fallback=false"], output=tmp_path / "out.h5", start=damaged
    )
    assert found.attributes["status"] == "converged"
    first, second = found.attributes["attempts"].items()
    assert (first[0], second[0]) == ("newton from an initial state", "newton")
    assert first[1]["status"] != "converged"
    assert found.attributes["started_from"] == "rigid raceways"
    assert any("damaged.h5: not used: " in note for note in texts(found))
    assert found.flexible["inner_load"] == approx(cold.flexible["inner_load"], rel=1e-9)


def test_start_that_is_not_finite_is_refused(other, tmp_path):
    lost = changed(other, tmp_path / "lost.h5", lambda x: x * np.nan)
    with pytest.raises(BadResult, match=r"lost.h5: flexible: unknowns holds \d+ of \d+ numbers that are not"):
        flexbearing.run(PAPER, HERE, output=tmp_path / "out.h5", start=lost)


DIFFERING = {
    "rollers": (["bearing.rollers=28"], "bearing.rollers = 30 there, 28 here"),
    "slices": (["accuracy.slices=10"], "accuracy.slices = 8 there, 10 here"),
    "shapes": (["accuracy.axial_shapes=2"], "accuracy.axial_shapes = 3 there, 2 here"),
    "guidance": (["bearing.cage.guidance=rollers"], 'bearing.cage.guidance = "outer" there, "rollers" here'),
    "cage": (["bearing.cage.centre=free"], 'bearing.cage.centre = "held" there, "free" here'),
    "film": (["lubricant.film=pan_hamrock"], 'lubricant.film = "dowson" there, "pan_hamrock" here'),
    "method": (["coupling.method=aitken"], 'coupling.method = "aitken" begins between rigid raceways'),
    "target": (["accuracy.target=1 %"], "accuracy.target chooses its own"),
    "rigid": (["outer.kind=rigid"], "every part of this case is rigid"),
}


@pytest.mark.parametrize(("settings", "told"), DIFFERING.values(), ids=DIFFERING.keys())
def test_start_that_is_no_neighbour_is_refused_with_what_differs(other, settings, told, tmp_path):
    with pytest.raises(BadCase, match=told):
        flexbearing.run(PAPER, [*HERE, *settings], output=tmp_path / "out.h5", start=other)
    assert not list(tmp_path.iterdir())  # refused before anything is written


def test_only_converged_runs_of_rollers_are_starts(other, tmp_path):
    stopped = flexbearing.run(PAPER, [*NEAR, "coupling.max_iterations=1"], output=tmp_path / "stopped.h5")
    with pytest.raises(BadCase, match=r"stopped.h5: it did not converge \(iteration limit\)"):
        flexbearing.run(PAPER, HERE, output=tmp_path / "out.h5", start=stopped)
    with pytest.raises(BadCase, match="starts from no other result"):
        flexbearing.run(BALLS, output=tmp_path / "out.h5", start=other)
    with pytest.raises(BadResult, match="no such file"):
        flexbearing.run(PAPER, HERE, output=tmp_path / "out.h5", start=tmp_path / "none.h5")


def test_command_line_takes_a_start(other, tmp_path):
    words = ["run", str(PAPER), "-o", str(tmp_path / "out.h5"), "--start", str(other.path), "--quiet"]
    settings = [word for setting in HERE for word in ("--set", setting)]
    assert CliRunner().invoke(application(), [*words, *settings]).exit_code == 0
    assert flexbearing.read(tmp_path / "out.h5").attributes["started_from"] == str(other.path)


def test_hard_case_takes_little_work_beside_one_that_is_solved(monkeypatch):
    """In oil at 0 degC: the same number of evaluations is not enough from its own start."""
    family, path = FAMILIES["cylindrical_roller"], PAPER.parent / "catalogue" / "nu210.toml"
    cold_oil = [
        "lubricant.inlet_temperature=0 degC", "operation.inner_speed=3000 rpm",
        "operation.radial_load=8 kN", "assumed=[]",
    ]  # fmt: skip
    hard = read(path, [*cold_oil, "lubricant.traction=bair-winer"], FAMILIES)
    beside = compared(read(path, cold_oil, FAMILIES), family)
    for module in (roller, strategy):
        monkeypatch.setattr(module, "MOST_WORK", 100)
    assert compared(hard, family).attributes["status"] == "work limit"
    found = compared(hard, family, beside)
    assert found.attributes["status"] == "converged"
    assert found.attributes["started_from"] == beside.place
    for module in (roller, strategy):
        monkeypatch.setattr(module, "MOST_WORK", 0)
    unsolved = compared(hard, family, beside)
    assert unsolved.attributes["status"] == "work limit"
    assert "started_from" not in unsolved.attributes


def test_neighbours_of_other_unknowns_are_no_start():
    case = read(PAPER.with_name("nu209.toml"), ["assumed=[]"], FAMILIES)
    fewer = read(PAPER.with_name("nu209.toml"), ["assumed=[]", "bearing.rollers=13"], FAMILIES)
    beside = compared(fewer, FAMILIES[case.kind])
    found = compared(case, FAMILIES[case.kind], beside)
    assert "started_from" not in found.attributes
    assert found.attributes["status"] == "converged"
