"""The command `map` over one to three keys: tables, picture, page, and what it refuses."""

import csv
from typing import Any

import numpy as np
import pytest
from matplotlib.contour import ContourSet
from pytest import approx

from flexbearing import __main__ as program, run
from flexbearing.api import check
from flexbearing.build import roller_bearing
from flexbearing.progress import Logged
from flexbearing.report.figure import ORANGE
from flexbearing.report.html.map import MapPlane, of_map
from flexbearing.report.html.plotly import traces
from flexbearing.report.panels import picture
from flexbearing.studies.maps import pages
from flexbearing.studies.maps.axes import axes
from flexbearing.studies.maps.grid import grid
from flexbearing.studies.maps.map import MapRequest, map_case
from quasidynamic.columns import kind_and_numbers
from tests.places import CONFIGS

PAPER, TEXTBOOK = CONFIGS / "mao2016.toml", CONFIGS / "nu209.toml"
LOADS, SPEEDS = "operation.radial_load=log 4 kN..16 kN,3", "operation.inner_speed=1000 rpm..2000 rpm,2"
FEW = ("accuracy.slices=5", "bearing.rollers=9")


def mapped(case, folder, *over, settings=FEW):
    return map_case(MapRequest(case, over, (), folder / "m.csv", settings), Logged())


def rows(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def plane(tmp_path_factory):
    return mapped(TEXTBOOK, tmp_path_factory.mktemp("map"), LOADS, SPEEDS)


def test_every_point_has_a_row_that_is_the_answer_of_its_run(plane, tmp_path):
    table = rows(plane.files["table"])
    assert [float(row["operation.radial_load [N]"]) for row in table] == approx(
        [4e3, 4e3, 8e3, 8e3, 16e3, 16e3], rel=1e-12, abs=0
    )
    settings = (*FEW, "operation.radial_load=8 kN", "operation.inner_speed=2000 rpm")
    alone = run(TEXTBOOK, settings, output=tmp_path / "r.h5")
    for name in ("cage_slip [%]", "max_roller_load [N]", "life_L10 [h]"):
        assert float(table[3][name]) == approx(float(alone[name]), rel=1e-9, abs=0)
    assert {row["stable"] for row in table} == {"1"}


def test_map_has_tables_picture_and_page(plane):
    assert plane.complete
    assert "every point converged" in plane.text
    assert "no point with several stable equilibria was found" in plane.text
    assert plane.files["picture"].read_bytes().startswith(b"\x89PNG")
    page = plane.files["page"].read_text("utf-8")
    assert "heatmap" in page
    assert "every point converged" in page
    assert rows(plane.files["folds"]) == rows(plane.files["fold curves"]) == []


def test_arrays_are_those_of_the_table(plane):
    arrays = pages.arrays(plane.found).to_xarray()
    assert dict(arrays.sizes) == {"operation.radial_load": 3, "operation.inner_speed": 2, "state": 1}
    assert arrays["cage_slip"].values.ravel() == approx(plane.found.outputs["cage_slip [%]"], rel=0, abs=0)
    assert arrays["cage_slip"].attrs["units"] == "%"


LIFE = np.array([[0.5, 2.0], [20.0, 50.0], [np.nan, 300.0]])
PLANE = MapPlane(
    "", ("a", "b"), (1.0, 2.0, 3.0), (10.0, 20.0), {"life_L10 [h]": LIFE}, np.zeros((0, 2, 2)),
    (False, False), {"life_L10 [h]": pages.contours("life_L10 [h]")}, np.zeros((0, 2)),
)  # fmt: skip


def test_page_and_picture_have_the_limit_and_the_decades_of_the_life_as_contours():
    ((_, (figure, *_), _, limits, _),) = of_map("t", (), [PLANE], False, ("m.csv", "")).parts["planes"]
    lines = {t["contours"]["start"]: t["line"] for t in traces(figure) if t["type"] == "contour"}
    assert sorted(lines) == [1.0, 10.0, 100.0]
    assert lines[1.0]["color"] == ORANGE != lines[10.0]["color"]
    assert limits
    (axes, _) = picture("t", "w", [figure]).axes
    sets = [each for each in axes.collections if isinstance(each, ContourSet)]
    assert sorted(level for each in sets for level in each.levels) == [1.0, 10.0, 100.0]


def test_picture_has_plain_numbers_below_the_lowest_panels_and_no_count_that_is_always_one(plane):
    drawn = pages.picture(plane.found)
    drawn.draw_without_rendering()
    panels = [axes for axes in drawn.axes if axes.get_xlabel() == "radial load [N]"]
    below = {axes.get_title(): axes.xaxis.label.get_visible() for axes in panels}
    assert [*below.values()] == [*[False] * (len(panels) - 2), True, True]
    assert "stable equilibria" not in below
    assert {"5,000", "10,000"} <= {text.get_text() for text in panels[-1].get_xticklabels()}


def test_points_that_failed_are_marked_and_counted(plane, monkeypatch):
    monkeypatch.setattr(type(plane.found), "unsolved", np.array([6, 7]))
    assert "2 points not converged" in pages.text(plane.found)


@pytest.mark.slow
def test_three_axes_have_a_point_for_each_combination(tmp_path):
    found: Any = mapped(TEXTBOOK, tmp_path, LOADS, SPEEDS, "bearing.clearance=20 um..30 um,2").found
    assert found.shape == (3, 2, 2)
    assert found.solved.point.tolist() == list(range(12))
    assert len(rows(tmp_path / "m.csv")) == 12


def test_points_that_share_their_parts_are_the_bearings_of_their_cases():
    case = check(TEXTBOOK, list(FEW))
    whole = grid(case, axes([LOADS, "bearing.clearance=20 um..30 um,2", SPEEDS], type(case)), Logged())
    each_alone = [kind_and_numbers(roller_bearing.bearing(each))[1] for each in whole.cases]
    assert (whole.points.numbers == each_alone).all()
    assert len({id(bearing.bearing) for bearing in whole.points.bearings}) == 4


@pytest.mark.parametrize(
    ("over", "words"),
    [
        (["life.static_rating=1 kN..2 kN,2", "bearing.roller.length=4 mm..5 mm,2"], "is set while"),
        (["operation.radial_laod=1 N..2 N,3"], "Did you mean radial_load"),
        (["bearing.roller.profile=straight..crowned,3"], "keys that are numbers"),
        (["operation.radial_load=1 N..2 mm,3"], "is not a force"),
        (["operation.radial_load=1 kN..2 kN,1"], "a range has 2 to"),
        ([LOADS, LOADS], "varied twice"),
        (
            [LOADS, SPEEDS, "bearing.clearance=1 um..2 um,2", "operation.moment=0 N m..1 N m,2"],
            "one to three axes",
        ),
        ([LOADS, "outer.thickness=3 mm..4 mm,2"], "same elastic rings"),
    ],
)
def test_axes_without_sense_are_refused(over, words, tmp_path, capsys):
    options = [word for each in over for word in ("--over", each)]
    code = program.command(["map", str(PAPER), *options, "-o", str(tmp_path / "m.csv")])
    assert code == 2
    assert words in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
