"""Lines and foundations of a case push only, unless it says that they pull; their forces are told."""

from functools import cache

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.case import BadCase
from flexbearing.findings import evaluate
from flexbearing.findings.running import LEAST_STIFFNESS
from flexbearing.report.html import METRIC, subjects
from flexbearing.report.html.reader import Reader
from flexbearing.report.output import text
from flexbearing.runs import judged
from tests.flexbearing.noted import codes
from tests.places import CONFIGS

CASE = CONFIGS / "nu209.toml"
RING = [
    "inner.kind=rigid", "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm",
    "accuracy.element_order=3", "accuracy.slices=8", "accuracy.axial_shapes=2", "operation.radial_load=2 kN",
]  # fmt: skip
LINES = ["outer.support=lines", 'outer.line_azimuths=["0 deg", "120 deg", "240 deg"]']
CROWDED = [*LINES, 'outer.line_azimuths=["-90 deg", "26 deg", "46 deg", "92.5 deg", "92.8 deg"]']
SPRINGS = ["outer.support=foundation", "outer.foundation_radial=10 N/mm^3"]
BEAM = [*SPRINGS, "accuracy.structure=beam"]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """The result of the case with some settings, computed once for all tests."""
    folder = tmp_path_factory.mktemp("supports")

    @cache
    def result(*settings):
        return flexbearing.run(CASE, [*RING, *settings], output=folder / "r.h5")

    return result


def carried(result):
    """What rollers press on the outer raceway along y and z [N], by the loads of the result."""
    azimuth, load = result.flexible["roller_azimuth"], result.flexible["outer_load"]
    return load @ np.sin(azimuth), load @ np.cos(azimuth)


def test_lines_push_only_and_balance_the_rollers(run):
    """The example of the documents: without `bilateral` lines at 120 and 240 degrees pulled 120 N each."""
    result = run(*LINES)
    assert result.attributes["status"] == "converged"
    lines = result.attributes["structure"]["outer"]["lines"]
    force, psi = np.array(lines["force_N"]), np.radians(lines["azimuth_deg"])
    assert lines["pull"] is False
    assert force.min() >= 0
    assert (force @ np.sin(psi), force @ np.cos(psi)) == approx(carried(result), rel=1e-6, abs=1e-3)
    assert lines["resultant_N"] == approx(lines["rollers_N"], rel=1e-9, abs=1e-6)
    assert np.sum(lines["end_forces_N"], axis=1) == approx(force, rel=1e-12, abs=1e-9)
    assert force[0] == approx(2000, rel=0.01)
    assert [c for c, f in zip(lines["carries"], force, strict=True) if f == 0] == [False]


def test_lines_pull_where_the_case_says_so(run):
    result = run(*LINES, "outer.bilateral=true")
    lines = result.attributes["structure"]["outer"]["lines"]
    assert lines["pull"] is True
    assert lines["force_N"][1:] == approx([-119.5, -113.4], rel=0.1)
    assert lines["resultant_N"] == approx(carried(result), rel=1e-6, abs=1e-3)
    assert "pulls" in text(result)


@pytest.mark.parametrize("springs", [SPRINGS, BEAM], ids=["section", "beam"])
def test_foundation_pushes_only_and_balances_the_rollers(springs, run):
    result = run(*springs)
    assert result.attributes["status"] == "converged"
    told = result.attributes["structure"]["outer"]["foundation"]
    pressure, azimuth = np.array(told["pressure_MPa"]), np.radians(told["azimuths_deg"])
    assert told["pull"] is False
    assert pressure.min() == told["least_pressure_MPa"] == 0
    assert pressure.max() == told["largest_pressure_MPa"] > 0
    assert told["resultant_N"] == approx(carried(result), rel=1e-6, abs=1e-2)
    assert np.degrees(azimuth[pressure.max(axis=1).argmax()]) == approx(told["azimuth_deg"])
    ((begin, end),) = told["touching_deg"]
    assert 250 < begin < 290
    assert 430 < end < 470
    assert 0.4 < told["open_share"] < 0.6
    assert "is lifted off" in " ".join(text(result).split())


def test_foundation_that_pulls_says_how_much(run):
    both, one = run(*BEAM, "outer.bilateral=true"), None
    told = both.attributes["structure"]["outer"]["foundation"]
    assert told["pull"] is True
    assert told["least_pressure_MPa"] < -0.1
    assert told["resultant_N"] == approx(carried(both), rel=1e-6, abs=1e-2)
    assert "largest pull " in text(both)
    one = run(*BEAM)
    pressure = one.attributes["structure"]["outer"]["foundation"]["largest_pressure_MPa"]
    assert pressure > 1.2 * told["largest_pressure_MPa"]
    assert one.flexible["total_stiffness"] < both.flexible["total_stiffness"]


def test_shear_springs_take_what_pressure_does_not(run):
    """They hold the ring all around; the summary shows what is left to the radial ones."""
    result = run(*BEAM, "outer.foundation_tangential=3 N/mm^3")
    told = result.attributes["structure"]["outer"]["foundation"]
    assert 0.5 * told["rollers_N"][1] < told["resultant_N"][1] < 0.95 * told["rollers_N"][1]
    assert "by tangential springs" in " ".join(text(result).split())
    assert "by tangential springs" not in " ".join(text(run(*BEAM)).split())


def test_summary_names_line_forces_and_what_lifts_off(run):
    result = run(*LINES)
    printed = text(result)
    assert "lines that hold the outer ring" in printed
    assert "push only" in printed
    assert "lifted off" in printed
    assert "pushes" in printed
    assert result.summary()["structure"]["outer"]["lines"]["force_N"][0] == approx(2000, rel=0.01)


@pytest.mark.slow
def test_ring_that_rests_on_one_line_is_noted(run):
    assert "ring-on-one-line" in codes(run(*LINES))
    spread = run("outer.support=lines", 'outer.line_azimuths=["60 deg", "180 deg", "300 deg"]')
    assert "ring-on-one-line" not in codes(spread)
    assert spread.attributes["structure"]["outer"]["lines"]["force_N"][1] == 0


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (
            [*LINES, 'outer.line_azimuths=["40 deg", "120 deg", "200 deg"]'],
            "do not hold a load towards 0 deg",
        ),
        ([*LINES, 'outer.line_azimuths=["120 deg", "240 deg"]'], "outer.bilateral = true"),
        ([*CROWDED, "outer.thickness=2.4 mm"], "supports 0.3 deg apart"),
        ([*LINES, "operation.load_direction=60 deg", 'outer.line_azimuths=["0 deg", "30 deg"]'], "60 deg"),
    ],
)
def test_lines_that_leave_the_ring_unheld_are_refused(settings, told, run):
    with pytest.raises(BadCase, match=told):
        run(*settings)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "settings",
    [
        [*LINES, 'outer.line_azimuths=["120 deg", "240 deg"]', "outer.bilateral=true"],
        [*LINES, "operation.radial_load=0 N", "bearing.clearance=-20 um"],
        [*LINES, "operation.load_direction=120 deg"],
        [*LINES, "operation.load_direction=60 deg"],
    ],
    ids=["pulled", "preloaded alone", "straight at a line", "between lines"],
)
def test_lines_hold_what_they_can(settings, run):
    result = run(*settings)
    assert result.attributes["status"] == "converged"
    lines = result.attributes["structure"]["outer"]["lines"]
    assert lines["resultant_N"] == approx(carried(result), rel=1e-6, abs=1e-3)
    assert lines["pull"] or min(lines["force_N"]) >= 0


@pytest.mark.slow
def test_line_pressure_balances_a_tilting_moment(run):
    """It grows linearly along the line, 19 mm wide; 5 N m come with a slope that the rollers share."""
    result = run(*LINES, "operation.moment=5 N m", "operation.tilt=free")
    ends = np.array(result.attributes["structure"]["outer"]["lines"]["end_forces_N"])
    assert ends.min() >= 0
    assert 19e-3 / 6 * abs(ends[0, 1] - ends[0, 0]) == approx(5.0, rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("supports", [LINES, BEAM], ids=["lines", "springs"])
def test_methods_agree_on_rings_that_lift_off(supports, run):
    alone = ["coupling.fallback=false", "coupling.tolerance=1e-8"]
    found = [run(*supports, *alone, f"coupling.method={method}") for method in ("newton", "iqn-ils")]
    assert [result.attributes["status"] for result in found] == ["converged", "converged"]
    newton, secant = (result.flexible["outer_load"] for result in found)
    assert newton == approx(secant, rel=0, abs=1e-7 * secant.max())


@pytest.mark.slow
@pytest.mark.parametrize("supports", [LINES, BEAM], ids=["lines", "springs"])
def test_stiffness_of_a_ring_that_lifts_off_is_that_of_differences(supports, run):
    """Bearing, ring and supports in one tangent: the shaft moves by it from 1990 to 2010 N."""
    exact = [*supports, "coupling.tolerance=1e-9"]
    places, blocks = [], []
    for load in (1990, 2000, 2010):
        blocks.append(run(*exact, f"operation.radial_load={load} N").flexible)
        inner, outer = blocks[-1]["support_translation"]
        places.append(blocks[-1]["ring_displacement"] - inner + outer)
    across_and_along = np.linalg.inv(blocks[1]["stiffness_matrix"][1:, 1:])[:2, 1]
    assert (places[2] - places[0]) / 20 == approx(across_and_along, rel=1e-3, abs=1e-12)


PARTS = {"stiffness", "radial_stiffness", "support_stiffness", "support_stiffness_ratio"}


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("support", "springs"),
    [(LINES, False), (["outer.support=side"], True), (["outer.support=seat"], True)],
    ids=["lines", "side", "seat"],
)
def test_stiffness_of_parts_is_given_where_they_are_springs_in_series(support, springs, run):
    """Lines bend the ring by what the bearing carries: 545 and 329 kN/mm are together 349, not 205."""
    result = run(*support)
    block, figures = result.flexible, result.attributes["structure"]["outer"]
    assert PARTS & set(block) == (PARTS if springs else set())
    assert ("stiffness-not-in-series" in codes(result, "outside validity")) is not springs
    assert (figures["support_stiffness_N_per_m"] is None) is not springs
    assert block["total_stiffness"] > 0
    if springs:
        series = 1 / (1 / block["stiffness"] + 1 / block["support_stiffness"])
        assert series == approx(block["total_stiffness"], rel=2e-2)


def test_a_stiffness_that_is_none_in_series_stays_out_of_table_page_and_export(run, tmp_path):
    result = run(*LINES)
    (row,) = [line for line in text(result).splitlines() if line.startswith(" stiffness of the bearing")]
    assert row.split()[-2:] == ["-", "kN/mm"]
    rows = {row[0]: row for row in subjects.tables(Reader(result, METRIC))["stiffnesses"].rows}
    assert rows["stiffness with supports"][2].size > 0
    assert rows["stiffness of the bearing"][2].text == "–"
    (of_bearing,) = [line.words for line in result.card.lines if line.subject == "bearing"]
    assert f"; stiffness with supports {rows['stiffness with supports'][2].text} kN/mm" in of_bearing


def test_a_tangent_that_is_not_positive_is_a_finding():
    shear = np.array([[[2.0, 3.0], [3.0, 2.0]], [[2.0, 0.5], [-0.5, 2.0]], [[0.0, 0.0], [0.0, 5.0]]])
    least = judged.least_stiffness(shear)
    assert least == approx([-1.0, 2.0, 0.0], abs=1e-12)
    (found,) = evaluate([LEAST_STIFFNESS], {"least_stiffness": least})
    assert found.broken.tolist() == [True, False, False]
