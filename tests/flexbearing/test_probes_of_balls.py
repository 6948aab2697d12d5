"""Probes on the rings of ball bearings: balance with what holds the rings, studies, derivatives, refusals."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing import BadCase, Case
from flexbearing.api import read_case
from flexbearing.case.balls.ring_room import elastic_groove
from flexbearing.report.html import html, of_result
from flexbearing.report.output import text
from flexbearing.runs import groove_fields
from flexbearing.runs.ball import angular_answers
from flexbearing.runs.part_fields import NoFields
from tests.flexbearing.noted import codes
from tests.flexbearing.test_findings import remembered

CASE = "configs/6209.toml"
SPRINGS = 1e12  # [N/m^3] in every direction
RING = {
    "outer.kind": "ring", "outer.thickness": "3.65 mm", "outer.width": "19 mm",
    "bearing.outer.shoulder": "2.2 mm", "accuracy.stations": 5, "accuracy.element_order": 4,
    "accuracy.patch_width": "1.5 mm", "operation.load.axial": "3 kN",
}  # fmt: skip
SOFT = RING | {
    "outer.support": "foundation",
    **{f"outer.foundation_{way}": "1000 N/mm^3" for way in ("radial", "axial", "tangential")},
}
AROUND = 24
ALONG, WEIGHTS = np.polynomial.legendre.leggauss(6)
EVERYWHERE = {
    "outputs.probes.azimuths": [f"{360 / AROUND * k} deg" for k in range(AROUND) for _ in ALONG],
    "outputs.probes.places": [f"{9.5 * x} mm" for _ in range(AROUND) for x in ALONG],
}
TWO = {"outputs.probes.azimuths": ["0 deg", "100 deg"], "outputs.probes.gauge_lengths": ["2 mm"]}
GAUGE, OUTWARD = "probe_gauge_strain.1", "probe_radial_displacement.2"


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    return flexbearing.run(CASE, SOFT | TWO, output=tmp_path_factory.mktemp("run") / "ring.h5")


def test_springs_that_move_as_probes_read_carry_the_load():
    found = flexbearing.run(CASE, SOFT | EVERYWHERE | {"accuracy.patch_width": "1 mm"})
    outward, sideways, along = (
        found.flexible[f"probe_{way}_displacement"] for way in ("radial", "tangential", "axial")
    )
    groove, _ = elastic_groove(read_case(CASE, SOFT), "outer")
    area = 2 * np.pi / AROUND * (groove.bottom(1) + 3.65e-3) * 9.5e-3 * np.tile(WEIGHTS, AROUND)
    phi = found.flexible["probe_azimuth"]
    lifted = SPRINGS * area @ (outward * np.cos(phi) - sideways * np.sin(phi))
    assert (SPRINGS * area @ along, lifted) == approx((3000.0, 8900.0), rel=3e-3)


def test_every_probe_has_its_numbers_on_pages_and_by_name(result):
    stored = flexbearing.read(result.path)
    assert stored[GAUGE].number == approx(1e6 * stored.flexible["probe_gauge_strain"][0], rel=1e-12)
    assert stored.flexible["probe_gauge_strain"] == approx(stored.flexible["probe_hoop_strain"])
    assert stored.rigid.get("probe_gauge_strain") is None
    assert f" {result[GAUGE].number:.4g} " in text(result)
    assert "Probes: strains and displacement of the rings" in html(of_result(result))


def test_rows_of_a_study_are_runs(result):
    lighter = SOFT | TWO | {"operation.load.radial_z": "6 kN"}
    cases = [read_case(CASE, each) for each in (SOFT | TWO, lighter)]
    found = angular_answers(cases, [GAUGE])
    expected = [result[GAUGE].number, flexbearing.run(CASE, lighter)[GAUGE].number]
    assert [row.numbers[GAUGE] for row in found] == approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("key", "step", "unit"),
    [
        ("operation.load.radial_z", 1e-4, "kN"),
        pytest.param("outer.thickness", 5e-3, "mm", marks=pytest.mark.slow),
    ],
)
def test_derivatives_are_those_of_runs(key, step, unit):
    case = Case(CASE, SOFT | TWO)
    found = case.sensitivity([GAUGE, OUTWARD], [key])
    value = found.keys[0].stated
    low, high = (case.with_({key: f"{value * (1 + side * step)} {unit}"}).run() for side in (-1, 1))
    for name, slope in zip((GAUGE, OUTWARD), found.slopes[:, 0], strict=True):
        expected = (high[name].number - low[name].number) / (2 * step * value)
        assert slope == approx(expected, rel=0.01 if "thickness" in key else 1e-3)


def test_a_turning_shaft_stretches_its_bore():
    """By Timoshenko for a hollow disc, of ring and shaft together."""
    on_shaft = {
        "inner.kind": "ring_on_shaft", "inner.bore": "45 mm", "inner.width": "19 mm",
        "inner.shaft_length": "60 mm", "inner.shaft_thickness": "6 mm", "bearing.inner.shoulder": "2.2 mm",
        "materials.shaft": {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7800 kg/m^3"},
        "accuracy.stations": 3, "accuracy.element_order": 3, "accuracy.patch_width": "2 mm",
        "operation.load.radial_z": "500 N",
        "outputs.probes.azimuths": ["0 deg"], "outputs.probes.parts": ["inner"],
        "outputs.probes.surfaces": ["inside"],
    }  # fmt: skip
    fast, slow = (
        flexbearing.run(CASE, on_shaft | {"operation.inner_speed": f"{speed} rpm"})[GAUGE].number
        for speed in (20000, 1)
    )

    def hollow(outside):
        inside, wave = 16.5e-3, 7800.0 * (20000 * np.pi / 30) ** 2 / (4 * 206e9)
        return 1e6 * wave * (3.3 * outside**2 + 0.7 * inside**2)

    groove, shoulder = elastic_groove(read_case(CASE, on_shaft), "inner")
    assert hollow(groove.bottom(-1)) < fast - slow < hollow(shoulder)
    assert slow > 1.0  # inside of a wall that a ball bends inward


STRESSES = {"outputs.stresses": True}


def test_largest_stress_of_a_ring_is_stored_judged_and_on_the_page(monkeypatch):
    """A note where it is above the yield stress, as in a row."""
    monkeypatch.setattr(groove_fields, "stresses", remembered(groove_fields.stresses))
    steel = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "yield_stress": "1 MPa"}
    coarse = {"accuracy.stations": 3, "accuracy.element_order": 3, "accuracy.patch_width": "2 mm"}
    settings = SOFT | STRESSES | coarse | {"materials.outer_ring": steel}
    found = flexbearing.run(CASE, settings)
    ring = found.attributes["stresses"]["outer"]
    largest = ring["bodies"]["ring"]
    assert (ring["loads"], ring["left_out"]) == ("balls", "")
    assert largest["von_mises_MPa"] > largest["tension_MPa"] / 2 > 1.0
    (record,) = [each for each in found.attributes["findings"] if each["code"] == "yield-stress"]
    assert (record["value"], record["limit"]) == (approx(1e6 * largest["von_mises_MPa"]), 1e6)
    assert record["verdict"] == "not met"
    assert f" {largest['von_mises_MPa']:.0f} " in text(found)
    assert "Largest stresses, away from contacts" in html(of_result(found))
    (row,) = angular_answers([read_case(CASE, settings)], [])
    assert "yield-stress" in [each.code for each in row.findings]


@pytest.mark.slow
def test_stress_of_a_cage_is_that_of_its_ring_and_of_lines_there_is_none():
    found = flexbearing.run("configs/harris218_cage.toml", STRESSES)
    cage = found.attributes["stresses"]["outer"]
    assert ([*cage["bodies"]], cage["left_out"]) == (["ring"], "where bars begin")
    lines = {
        "outer.support": "lines",
        "outer.bilateral": True,
        "outer.line_azimuths": ["0 deg", "120 deg", "240 deg"],
    }
    found = flexbearing.run(CASE, RING | lines | STRESSES)
    assert found.attributes["stresses"] == {}
    assert "no-stresses" in codes(found)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({}, r'probe 1: outer.kind = "rigid" does not deflect'),
        (RING | {"outer.support": "lines", "outer.line_azimuths": ["0 deg", "120 deg", "240 deg"]},
         r'probe 1: outer.support = "lines" has no solid'),
        (SOFT | {"outputs.probes.places": ["10 mm"]}, "probe 1: x = 10 mm is beside the part"),
        (SOFT | {"operation.outer_speed": "10 rpm", "materials.outer_ring": {
            "youngs_modulus": "206 GPa", "poisson_ratio": 0.3}}, "needs materials.outer_ring.density"),
    ],
)  # fmt: skip
def test_a_probe_without_a_known_strain_is_refused_before_anything_is_solved(settings, words):
    with pytest.raises(BadCase, match=words):
        flexbearing.api.check(CASE, settings | TWO)


def test_a_probe_on_bars_below_balls_is_refused():
    with pytest.raises(BadCase, match="where bars below balls are spread evenly"):
        flexbearing.api.check("configs/harris218_cage.toml", TWO | {"outputs.probes.places": ["40 mm"]})


def test_a_ring_that_is_not_solved_leaves_the_solution_and_says_why(monkeypatch):
    def unsolved(*arguments):
        raise NoFields("outer ring: its elements are inside out")

    monkeypatch.setattr(groove_fields, "readings_of_shape", unsolved)
    found = flexbearing.run(CASE, SOFT | TWO)
    assert found.attributes["status"] == "converged"
    assert "no-probes" in codes(found)
