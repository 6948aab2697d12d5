"""The command `map` along one load or speed: table, picture, words, and what it refuses."""

import csv
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing import __main__ as program
from flexbearing.case import BadCase
from flexbearing.progress import Logged
from flexbearing.report.studies.branch_figure import draw_branch
from flexbearing.studies.maps.map import MapRequest, map_case
from tests.flexbearing.toy_studies import deadly_branch
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
TEXTBOOK = ROOT / "configs" / "nu209.toml"
FALLING = [
    "lubricant.traction=four-point",
    "lubricant.traction_curve.peak=0.06",
    "lubricant.traction_curve.peak_slip=0.01",
    "lubricant.traction_curve.far=0.02",
]
LOAD = "operation.radial_load=1.5 kN..8000 N"
RIGID = ["inner.kind=rigid", "outer.kind=rigid", "operation.tilt=fixed"]


@pytest.fixture
def command(capsys):
    """The command line in this process: exit code, what it prints, what it complains about."""

    def run(over, *words, settings=()):
        sets = [word for setting in settings for word in ("--set", setting)]
        code = program.command([str(word) for word in ("map", PAPER, "--over", over, *words, *sets)])
        return code, *capsys.readouterr()

    return run


def rows(path):
    with path.open(newline="", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


@pytest.mark.slow
def test_branch_has_a_table_and_a_picture(command, tmp_path):
    code, said, complained = command(LOAD, "-o", tmp_path / "there" / "s.csv", settings=[*FALLING, *RIGID])
    assert (code, complained) == (0, "")
    table = rows(tmp_path / "there" / "s.csv")
    assert list(table[0]) == [
        "radial_load_N", "cage_slip", "largest_roller_load_N", "stable", "fold", "growth_rate_1_per_s"
    ]  # fmt: skip
    assert (table[0]["radial_load_N"], table[-1]["radial_load_N"]) == (1500.0, 8000.0)
    folds = [row for row in table if row["fold"]]
    assert len(folds) == 2
    for fold in folds:
        assert f"fold at {fold['radial_load_N']:.6g} N, cage slip {100 * fold['cage_slip']:.4g} %" in said
    assert "end: range left at 8000 N" in said
    assert "between rigid raceways" in said
    assert {row["stable"] for row in table} == {0.0, 1.0}
    assert all((row["growth_rate_1_per_s"] < 0) == row["stable"] for row in table)
    assert (tmp_path / "there" / "s.png").read_bytes().startswith(b"\x89PNG")
    assert sorted(path.name for path in (tmp_path / "there").iterdir()) == ["s.csv", "s.png"]


@pytest.mark.parametrize(("complete", "code"), [(True, 0), (False, 1)])
def test_branch_that_stops_before_the_end_of_the_range_ends_with_one(complete, code, command, monkeypatch):
    files = {"table": "s.csv", "picture": "s.png"}
    found = SimpleNamespace(complete=complete, files=files, text="the branch")
    monkeypatch.setattr("flexbearing.studies.maps.map.map_case", lambda *_: found)
    assert command(LOAD) == (code, "the branch\ntable: s.csv\npicture: s.png\n", "")


def test_speed_is_written_in_the_unit_people_use(command, tmp_path):
    over = "operation.inner_speed = 500 rad/s .. 12000 rpm"
    code, said, _ = command(over, "-o", tmp_path / "s.csv", settings=RIGID)
    assert code == 0
    table = rows(tmp_path / "s.csv")
    assert table[0]["inner_speed_rpm"] == approx(500 * 30 / np.pi, rel=1e-12, abs=0)
    assert table[-1]["inner_speed_rpm"] == approx(12000, rel=1e-12, abs=0)
    assert "end: range left at 12000 rpm" in said
    assert "fold" not in said


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("over", "words"),
    [
        ("operation.radial_load", "KEY=FROM..TO"),
        ("operation.radial_load=..500 N", "KEY=FROM..TO"),
        ("operation.radial_load=500 N", "KEY=FROM..TO"),
        ("bearing.clearance=10 um..20 um", "KEY=FROM..TO,N"),
        ("operation.radial_load=500 mm..20 kN", "is not a force"),
        ("operation.radial_load=500..20 kN", "has no unit"),
        ("operation.radial_load=0 N..20 kN", "of one sign"),
        ("operation.radial_load=20 kN..20000 N", "not the same"),
        ("operation.inner_speed=-100 rpm..100 rpm", "of one sign"),
    ],
)
def test_key_or_range_without_sense_is_refused(command, tmp_path, over, words):
    code, said, complained = command(over, "-o", tmp_path / "s.csv")
    assert (code, said) == (2, "")
    assert words in complained
    assert not list(tmp_path.iterdir())


def test_table_of_another_kind_is_refused(command, tmp_path):
    code, _, complained = command(LOAD, "-o", tmp_path / "s.h5")
    assert code == 2
    assert "its name ends in .csv" in complained


def test_unstable_part_is_dashed_and_joined_at_the_folds():
    table = {
        "load": np.array([1.0, 2.0, 3.0, 2.0, 1.5, 2.0, 4.0]),
        "cage_slip": np.array([0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.01]),
        "stable": np.array([1, 1, 0, 0, 0, 1, 1]),
        "fold": np.array([0, 0, 1, 0, 1, 0, 0]),
    }
    (axes,) = draw_branch("a case", "load", table).axes
    stable, unstable, folds = axes.lines
    assert (stable.get_linestyle(), unstable.get_linestyle()) == ("-", "--")
    assert np.isfinite(stable.get_ydata()).tolist() == [True, True, True, False, True, True, True]
    assert np.isfinite(unstable.get_ydata()).tolist() == [False, False, True, True, True, False, False]
    assert folds.get_ydata() == approx([30.0, 10.0], rel=1e-12, abs=0)
    assert axes.get_yscale() == "log"


# -- flexible rings --------------------------------------------------------------------------------

CAGE = ["operation.tilt=fixed", "inner.kind=rigid", "accuracy.structure=beam", "accuracy.slices=5"]
RING = [
    "operation.tilt=fixed", "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm",
    "accuracy.element_order=3", "accuracy.slices=5",
]  # fmt: skip
LINES = [*RING, "outer.support=lines", 'outer.line_azimuths=["20 deg", "100 deg", "180 deg", "260 deg"]']


def followed(case, over, table, settings) -> Any:
    """The branch of a map along one load."""
    return map_case(MapRequest(case, (over,), (), table, tuple(settings)), Logged()).found


def largest_difference(point, case, settings, path):
    """Of a roller load of a point of the branch from those of a run, over the largest."""
    result = flexbearing.run(case, [*settings, f"operation.radial_load={point.value!r} N"], output=path)
    assert result.attributes["status"] == "converged"
    load = result.flexible["inner_load"]
    return np.abs(point.equilibrium.loads[0] - load).max() / load.max()


@pytest.mark.slow
def test_branch_between_flexible_rings_is_that_of_the_coupled_system(command, tmp_path):
    """The branch was that between rigid raceways, which a note said."""
    traced = followed(PAPER, "operation.radial_load=7 kN..7.5 kN", tmp_path / "s.csv", CAGE)
    assert traced.complete
    points = traced.branch.points
    for point in (points[0], points[len(points) // 2], points[-1]):
        assert largest_difference(point, PAPER, CAGE, tmp_path / "s.h5") < 1e-9
    assert "equilibria between flexible rings" in traced.text()
    assert "rigid" not in traced.text()


@pytest.mark.slow
def test_branch_follows_rings_that_lift_off_their_lines(tmp_path):
    traced = followed(TEXTBOOK, "operation.radial_load=2 kN..6 kN", tmp_path / "s.csv", LINES)
    assert traced.complete
    points = traced.branch.points
    for point in (points[len(points) // 2], points[-1]):
        assert largest_difference(point, TEXTBOOK, LINES, tmp_path / "s.h5") < 1e-9


@pytest.mark.slow
def test_flexible_rings_move_the_folds(tmp_path):
    """Rings that deflect spread the load, and more rollers drive the cage: it catches up under less load."""
    folds = [
        [
            fold.value
            for fold in followed(PAPER, LOAD, tmp_path / "s.csv", [*FALLING, *CAGE, *rigid]).branch.folds
        ]
        for rigid in ([], ["outer.kind=rigid"])
    ]
    assert [len(each) for each in folds] == [2, 2]
    flexible, rigid = folds
    assert all(0.7 * there < here < 0.95 * there for here, there in zip(flexible, rigid, strict=True))


def test_planet_gear_is_not_followed_over_a_load_that_its_teeth_do_not_follow(tmp_path):
    teeth = [
        *RING, "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]',
        'outer.tooth_radial=["0 N", "0 N"]', 'outer.tooth_tangential=["2225 N", "-2225 N"]',
    ]  # fmt: skip
    with pytest.raises(BadCase, match="tooth forces stay as they are"):
        followed(TEXTBOOK, "operation.radial_load=4450 N..6 kN", tmp_path / "s.csv", teeth)


@pytest.mark.slow
def test_branch_whose_process_dies_has_no_table(command, monkeypatch, tmp_path):
    monkeypatch.setattr("flexbearing.studies.maps.branch.branch", deadly_branch)
    code, said, complained = command(LOAD, "-o", tmp_path / "s.csv", settings=CAGE)
    assert (code, said) == (1, "")
    assert complained.startswith(f"{PAPER}: not converged: its worker process died 3 times")
    assert not list(tmp_path.iterdir())
