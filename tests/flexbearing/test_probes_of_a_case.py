"""Probes of a case: one number each by name in runs, studies, maps, sensitivities and passages."""

from typing import Any

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing import AbsentOutput, BadCase, Case
from flexbearing.build.probes import probes
from flexbearing.progress import Logged
from flexbearing.report.html import html, of_result
from flexbearing.report.output import text
from flexbearing.runs import stored_fields
from flexbearing.runs.part_fields import NoFields, PartFields
from flexbearing.studies.maps.axes import axes
from flexbearing.studies.maps.solution import solved_map
from tests.flexbearing.noted import codes
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
RING = {
    "inner.kind": "rigid", "outer.kind": "ring", "outer.support": "side", "outer.width": "12 mm",
    "outer.thickness": "5 mm", "accuracy.element_order": 3, "accuracy.mesh_size": "4 mm",
    "accuracy.raceway_mesh_size": "3 mm", "accuracy.patch_width": "1.4 mm", "accuracy.slices": 8,
    "accuracy.axial_shapes": 2,
}  # fmt: skip
PROBES = {
    "outputs.probes.azimuths": ["0 deg", "90 deg", "20 deg"],
    "outputs.probes.places": ["0 mm", "0 mm", "2 mm"],
    "outputs.probes.gauge_lengths": ["2 mm"],
    "outputs.probes.gauge_angles": ["0 deg", "0 deg", "90 deg"],
}
CASE = Case(PAPER, RING | PROBES)
HEAD: Any = CASE.head
GAUGE, OUTWARD = "probe_gauge_strain.1", "probe_radial_displacement.1"


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    return CASE.run(output=tmp_path_factory.mktemp("run") / "ring.h5")


def test_every_probe_has_its_numbers_by_name(result):
    stored = flexbearing.read(result.path)
    for number, strain in enumerate(stored.flexible["probe_gauge_strain"], 1):
        assert stored[f"probe_gauge_strain.{number}"].number == approx(1e6 * strain, rel=1e-12)
    assert stored[f"{GAUGE} [%]"].number == approx(1e-4 * stored[GAUGE].number, rel=1e-12)
    hoop, axial = (stored.flexible[f"probe_{name}_strain"] for name in ("hoop", "axial"))
    assert stored.flexible["probe_gauge_strain"] == approx([hoop[0], hoop[1], axial[2]], rel=1e-12)
    assert np.degrees(stored.flexible["probe_azimuth"]) == approx([0, 90, 20])
    assert stored.rigid.get("probe_gauge_strain") is None
    with pytest.raises(AbsentOutput, match=r"probe_gauge_strain.4: the case has fewer"):
        stored["probe_gauge_strain.4"]


def test_readings_are_those_of_the_stored_fields(result):
    (outer,) = stored_fields.of_result(result)
    again = outer.readings(list(probes(HEAD, "outer").values()))
    assert again.gauge_strain == approx(result.flexible["probe_gauge_strain"], rel=1e-9)


def test_a_study_has_a_column_for_a_probe(result):
    """Side by side as alone."""
    loads = ["15 kN", "19.6211 kN"]
    table = CASE.sweep({"operation.radial_load": loads}, {"strain": GAUGE, "outward": f"{OUTWARD} [mm]"})
    strain, outward = (table[name].values for name in ("strain", "outward"))
    assert strain[1] == approx(result[GAUGE].number, rel=1e-6)
    assert outward[1] == approx(1e-3 * result[OUTWARD].number, rel=1e-6)
    assert strain[0] == approx(CASE.with_({"operation.radial_load": loads[0]}).run()[GAUGE].number, rel=1e-6)


def test_a_map_has_probes(result):
    case = HEAD
    found = solved_map(
        case, axes(["operation.radial_load=15 kN..19.6211 kN,2"], type(case)), [GAUGE], Logged()
    )
    (strains,) = found.outputs.values()
    assert max(strains) == approx(result[GAUGE].number, rel=1e-6)


@pytest.mark.parametrize(
    ("key", "step", "unit"),
    [("operation.radial_load", 100.0, "N"), ("outer.thickness", 0.02, "mm"), ("outer.width", 0.02, "mm")],
)
def test_derivatives_are_those_of_runs(key, step, unit):
    """A key that moves faces of the ring, too, where the probe stays on its surface."""
    found = CASE.sensitivity([GAUGE, OUTWARD], [key])
    value = found.keys[0].stated
    low, high = (CASE.with_({key: f"{value + side * step} {unit}"}).run() for side in (-1, 1))
    for name, slope in zip((GAUGE, OUTWARD), found.slopes[:, 0], strict=True):
        assert slope == approx((high[name].number - low[name].number) / (2 * step), rel=0.02)


def test_every_position_of_a_passage_is_read_as_by_a_run():
    case = CASE.with_({"operation.roller_positions": 2})
    passed = case.run().attributes["passage"]
    key = "probes.gauge_strain_um_per_m.3"
    for azimuth, strain in zip(passed["azimuth_deg"], passed["values"][key], strict=True):
        there = CASE.with_({"bearing.first_roller_azimuth": f"{azimuth} deg"}).run()
        assert there["probe_gauge_strain.3"].number == approx(strain, rel=1e-5)
    assert passed["values"][key][0] != approx(passed["values"][key][1], rel=1e-4)


def test_probes_that_turn_with_load_and_rollers_read_the_same(result):
    turned = CASE.with_({
        "operation.load_direction": "50 deg", "bearing.first_roller_azimuth": "50 deg",
        "outputs.probes.azimuths": ["50 deg", "140 deg", "70 deg"],
    }).run()  # fmt: skip
    for name in ("gauge_strain", "radial_displacement", "smallest_strain"):
        expected = result.flexible[f"probe_{name}"]
        assert turned.flexible[f"probe_{name}"] == approx(
            expected, rel=0, abs=1e-5 * np.abs(expected).max()
        ), name


def test_pages_have_the_readings(result):
    assert f"{result[GAUGE].number:,.1f}" in text(result)
    assert "Probes: strains and displacement of the rings" in html(of_result(result))


def test_rings_are_read_in_the_order_of_their_probes():
    """Of both rings at once; the shaft's bore is the inside of the inner part."""
    both = Case(PAPER, {
        "outer.kind": "ring", "outer.support": "side", "outer.width": "12 mm", "outer.thickness": "5 mm",
        "accuracy.element_order": 3, "accuracy.patch_width": "2 mm", "accuracy.slices": 8,
        "accuracy.axial_shapes": 2,
        "outputs.probes.azimuths": ["0 deg", "180 deg", "180 deg"],
        "outputs.probes.parts": ["outer", "inner", "outer"],
        "outputs.probes.surfaces": ["outside", "inside", "outside"],
    })  # fmt: skip
    block = both.run().flexible
    outward = block["probe_radial_displacement"]
    assert outward[0] > 10e-6 > abs(outward[2])  # in the load and opposite to it
    assert np.degrees(block["probe_azimuth"]) == approx([0.0, 180.0, 180.0])
    head: Any = both.head
    assert not probes(head, "inner")[1].outside


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"outer.kind": "rigid"}, r'probe 1: outer.kind = "rigid" does not deflect'),
        ({"outer.support": "lines", "outer.line_azimuths": ["0 deg", "120 deg", "240 deg"]},
         r'probe 1: outer.support = "lines" has no solid'),
        ({"outputs.probes.places": ["0 mm", "0 mm", "7 mm"]}, "probe 3: x = 7.[0-9]+ mm is beside the part"),
        ({"outputs.probes.depths": ["6 mm"]}, "probe 1: depth = 6.[0-9]+ mm; allowed is up to the wall"),
        ({"outputs.probes.parts": ["inner"]}, r'probe 1: inner.kind = "rigid" does not deflect'),
    ],
)  # fmt: skip
def test_a_probe_without_a_known_strain_is_refused_before_anything_is_solved(settings, words):
    given = {key: value for key, value in (RING | PROBES).items() if settings.get("outer.kind") != "rigid"
             or not key.startswith("outer.")}  # fmt: skip
    with pytest.raises(BadCase, match=words):
        flexbearing.api.check(PAPER, given | settings)


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("depths", ["1 mm", "1 mm"], "1 entry, or 3 as azimuths has"),
        ("gauge_lengths", ["-1 mm"], "at least 0 mm each"),
        ("parts", ["middle"], '"outer" or "inner"'),
        ("azimuths", [], r"azimuths = \[\] is not allowed"),
    ],
)
def test_lists_that_make_no_probes_are_refused(key, value, words):
    with pytest.raises(BadCase, match=words):
        CASE.with_({f"outputs.probes.{key}": value})


def test_a_ring_that_is_not_solved_leaves_the_solution_and_says_why(monkeypatch):
    def unsolved(self, probes):
        raise NoFields("outer ring: its elements are inside out")

    monkeypatch.setattr(PartFields, "readings", unsolved)
    found = CASE.run()
    assert found.attributes["status"] == "converged"
    assert "no-probes" in codes(found)
    with pytest.raises(AbsentOutput, match="the case does not give probe_gauge_strain"):
        found[GAUGE]
