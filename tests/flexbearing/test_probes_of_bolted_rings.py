"""Probes on bolted rings of four-point bearings: balance with their springs, symmetry, rows, derivatives."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing import BadCase, Case
from flexbearing.api import read_case
from flexbearing.build.groove_parts import groove_part
from flexbearing.report.html import html, of_result
from flexbearing.report.output import text
from flexbearing.runs.ball import four_point_answers
from tests.flexbearing.test_bolted_rings import SLEWING, SMALL

NORMAL, SHEAR = 2e11, 8e10  # [N/m^3]
AROUND = 32
ALONG, WEIGHTS = np.polynomial.legendre.leggauss(6)
GAUGE, OUTWARD = "probe_gauge_strain.1", "probe_radial_displacement.2"
THRUST = ("operation.load.radial_z=0 N", "operation.load.moment_y=0 N m")


def probes(**lists):
    """Settings of the lists of probes."""
    return tuple(f"outputs.probes.{name}={json.dumps(values)}" for name, values in lists.items())


def without(race):
    """Settings without those of an elastic ring."""
    return tuple(setting for setting in SMALL if not setting.startswith(f"rings.{race}."))


TWO = probes(
    azimuths=["0 deg", "100 deg"],
    parts=["inner", "outer"],
    surfaces=["inside", "outside"],
    gauge_lengths=["2 mm"],
)


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    return flexbearing.run(SLEWING, (*SMALL, *TWO), output=tmp_path_factory.mktemp("run") / "ring.h5")


def test_springs_below_the_bolted_face_carry_the_load():
    """Force along x and z and moment about y, from displacements that probes read all over the face."""
    springs = (
        f"rings.outer.face_stiffness={NORMAL} N/m^3",
        f"rings.outer.face_shear_stiffness={SHEAR} N/m^3",
    )
    settings = (*SMALL, *springs, "rings.patch_width=1 mm", *probes(places=["-27 mm"]))
    ring = groove_part(read_case(SLEWING, (*settings, *probes(azimuths=["0 deg"]))), "outer")
    land, outside = ring.raceway_diameter / 2, ring.far_diameter / 2
    depths = (outside - land) * (1 - ALONG) / 2
    everywhere = probes(
        azimuths=[f"{360 / AROUND * k} deg" for k in range(AROUND) for _ in ALONG],
        depths=[f"{1e3 * depth} mm" for _ in range(AROUND) for depth in depths],
    )
    found = flexbearing.run(SLEWING, (*settings, *everywhere)).flexible
    outward, sideways, along = (
        found[f"probe_{way}_displacement"] for way in ("radial", "tangential", "axial")
    )
    radius, phi = outside - np.tile(depths, AROUND), found["probe_azimuth"]
    area = 2 * np.pi / AROUND * radius * (outside - land) / 2 * np.tile(WEIGHTS, AROUND)
    lifted = SHEAR * area @ (outward * np.cos(phi) - sideways * np.sin(phi))
    tilting = NORMAL * area @ (along * radius * np.cos(phi)) + 27e-3 * lifted
    assert (NORMAL * area @ along, lifted, tilting) == approx((60e3, 20e3, -2e3), rel=3e-3)


def test_every_probe_has_its_numbers_on_pages_and_by_name(result):
    stored = flexbearing.read(result.path)
    assert stored[GAUGE].number == approx(1e6 * stored.flexible["probe_gauge_strain"][0], rel=1e-12)
    assert stored.rigid.get("probe_gauge_strain") is None
    assert f" {result[GAUGE].number:.4g} " in text(result)
    assert "Probes: strains and displacement of the rings" in html(of_result(result))


def test_rings_under_thrust_alone_are_strained_alike_at_every_ball():
    """At a ball and half a pitch further, on both rings; readings move on with the balls."""
    moved, pitch = 3.0, 360 / 24
    places = [k * pitch for k in (0, 5, 0.5, 5.5)] * 2
    parts = ["inner"] * 4 + ["outer"] * 4
    usual, further = (
        flexbearing.run(SLEWING, (
            *SMALL, *THRUST, f"bearing.first_ball_azimuth={first} deg", *probes(
                azimuths=[f"{first + place} deg" for place in places], parts=parts, gauge_angles=["45 deg"]
            ),
        )).flexible["probe_gauge_strain"].reshape(2, 2, 2)
        for first in (0.0, moved)
    )  # fmt: skip
    assert usual[:, :, 1] == approx(usual[:, :, 0], rel=1e-9)
    assert np.abs(usual[:, 0] / usual[:, 1] - 1).min() > 1e-3
    assert further == approx(usual, rel=1e-8)


def test_balls_pass_a_gauge_once_in_a_pitch():
    """Rows of a study over their azimuth: the first and the last are the same, between them others."""
    rows = [f"bearing.first_ball_azimuth={360 / 24 * part!r} deg" for part in (0.0, 0.25, 0.5, 1.0)]
    answers = four_point_answers([read_case(SLEWING, (*SMALL, *TWO, row)) for row in rows], [GAUGE])
    first, *between, last = (answer.numbers[GAUGE] for answer in answers)
    assert last == approx(first, rel=1e-7)
    assert np.abs(np.array(between) / first - 1).min() > 1e-4


@pytest.mark.slow
def test_bearing_turned_over_has_the_strains_of_its_mirror_image():
    """Faces, axial load and places mirrored at the plane of the balls."""
    there = ["-20 mm", "5 mm", "-3 mm", "20 mm"]
    turned_over = [place[1:] if place[0] == "-" else f"-{place}" for place in there]
    where = {"azimuths": ["10 deg", "40 deg", "130 deg", "200 deg"], "parts": ["inner", "outer"] * 2}
    turned = (
        *SMALL, "rings.outer.face=+x", "rings.inner.face=-x", "operation.load.axial=-60 kN",
        "operation.load.moment_y=2 kN m",
    )  # fmt: skip
    usual, seen = (
        flexbearing.run(SLEWING, (*settings, *probes(**where, places=places))).flexible
        for settings, places in ((SMALL, there), (turned, turned_over))
    )
    for name, sign in (("hoop_strain", 1), ("axial_strain", 1), ("axial_displacement", -1)):
        size = np.abs(usual[f"probe_{name}"]).max()
        assert sign * seen[f"probe_{name}"] == approx(usual[f"probe_{name}"], rel=0, abs=3e-3 * size), name


def test_rows_of_a_study_are_runs(result):
    lighter = (*SMALL, *TWO, "operation.load.radial_z=6 kN")
    cases = [read_case(SLEWING, each) for each in ((*SMALL, *TWO), lighter)]
    found = four_point_answers(cases, [GAUGE])
    expected = [result[GAUGE].number, flexbearing.run(SLEWING, lighter)[GAUGE].number]
    assert [row.numbers[GAUGE] for row in found] == approx(expected, rel=1e-6)
    assert expected[0] != approx(expected[1], rel=0.01)


def test_derivatives_are_those_of_runs():
    case, key, step = Case(SLEWING, (*SMALL, *TWO)), "operation.load.radial_z", 1e-4
    found = case.sensitivity([GAUGE, OUTWARD], [key])
    value = found.keys[0].stated
    low, high = (case.with_({key: f"{value * (1 + side * step)} kN"}).run() for side in (-1, 1))
    for name, slope in zip((GAUGE, OUTWARD), found.slopes[:, 0], strict=True):
        assert slope == approx((high[name].number - low[name].number) / (2 * step * value), rel=1e-3)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (("rings.inner.kind=rigid",), r'probe 1: rings.inner.kind = "rigid" does not deflect'),
        (probes(places=["24 mm"]), "probe 2: x = 24 mm is beside the part"),
    ],
)
def test_a_probe_without_a_known_strain_is_refused_before_anything_is_solved(settings, words):
    usual = without("inner") if settings[0].startswith("rings.inner") else SMALL
    with pytest.raises(BadCase, match=words):
        flexbearing.api.check(SLEWING, (*usual, *TWO, *settings))


@pytest.mark.slow
def test_largest_stress_of_a_bolted_ring_is_stored_judged_and_on_the_page():
    """Where the arcs meet, between two balls, by bending of the ring along its circumference."""
    steel = (
        f"materials.inner_ring.{value}"
        for value in ("youngs_modulus=210 GPa", "poisson_ratio=0.3", "yield_stress=1 MPa")
    )
    rigid = (*without("outer"), "rings.outer.kind=rigid")
    found = flexbearing.run(SLEWING, (*rigid, *steel, "outputs.stresses=true"))
    rings = found.attributes["stresses"]
    assert [(race, ring["left_out"]) for race, ring in rings.items()] == [("inner", "rotation")]
    largest = rings["inner"]["bodies"]["ring"]
    (record,) = [each for each in found.attributes["findings"] if each["code"] == "yield-stress"]
    assert (record["value"], record["limit"]) == (approx(1e6 * largest["von_mises_MPa"]), 1e6)
    assert f" {largest['von_mises_MPa']:.0f} " in text(found)
    assert 0 < largest["von_mises_error_MPa"] < 0.1 * largest["von_mises_MPa"]
