"""Stresses and displacements of the rings of a stored run."""

import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import ngsolve as ngs
import numpy as np
import pytest
from pytest import approx
from typer.testing import CliRunner

import flexbearing
from fem.errors import NotSolved
from fem.parts.surroundings import Surroundings
from fem.solid.extremes import BodyExtremes, Largest
from fem.solid.support_stiffness import support_stiffness
from flexbearing.api import read_case
from flexbearing.build.expansion import roller_length
from flexbearing.case import BadCase
from flexbearing.cli import application
from flexbearing.report.output import text
from flexbearing.report.roller.deformed import pictures
from flexbearing.results import BadResult
from flexbearing.runs import fields, stored_fields
from flexbearing.runs.part_fields import NoFields, PartFields
from tests.fem.bars_of_a_solid import bars_of
from tests.places import CONFIGS

LENGTH_OF_BARS = 10.25e-3 * (1 + 11.2e-6 * 198)  # [m] hot
PAPER = CONFIGS / "mao2016.toml"
COARSE = [
    "inner.kind=rigid", "outer.bars=8", "outer.bar_width=10 mm", "accuracy.element_order=2",
    "accuracy.mesh_size=8 mm", "accuracy.raceway_mesh_size=3.5 mm", "accuracy.patch_width=1.5 mm",
    "accuracy.slices=8", "accuracy.axial_shapes=2", "accuracy.threads=1", "outputs.stresses=true",
]  # fmt: skip


@pytest.fixture(scope="module")
def run_with_fields(tmp_path_factory):
    """A result, and the fields that the run solved for it."""
    solved, record = [], PartFields.record

    def recorded(fields):
        solved.append(fields)
        return record(fields)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(PartFields, "record", recorded)
        result = flexbearing.run(PAPER, COARSE, output=tmp_path_factory.mktemp("run") / "cage.h5")
    (fields_of_run,) = solved
    return result, fields_of_run


@pytest.fixture(scope="module")
def result(run_with_fields):
    return run_with_fields[0]


@pytest.fixture(scope="module")
def beamed(tmp_path_factory):
    """A result whose ring was no solid."""
    settings = [*COARSE[:3], "accuracy.structure=beam", "accuracy.slices=8", "accuracy.axial_shapes=2"]
    return flexbearing.run(PAPER, settings, output=tmp_path_factory.mktemp("run") / "beams.h5")


@pytest.fixture(scope="module")
def rigid(tmp_path_factory):
    settings = ["inner.kind=rigid", "outer.kind=rigid"]
    return flexbearing.run(PAPER, settings, output=tmp_path_factory.mktemp("run") / "rigid.h5")


@pytest.fixture(scope="module")
def outer(run_with_fields):
    return run_with_fields[1]


@pytest.mark.slow
def test_largest_stresses_are_stored_and_shown(result):
    stored = result.attributes["stresses"]
    assert list(stored) == ["outer"]
    assert set(stored["outer"]["bodies"]) == {"ring", "bars", "flange"}
    assert result.summary()["stresses"] == json.loads(json.dumps(stored))
    bars = stored["outer"]["bodies"]["bars"]
    shown = " ".join(text(result).split())
    assert f"{bars['von_mises_MPa']:,.0f} {bars['von_mises_error_MPa']:,.0f}" in shown
    assert stored["outer"]["seconds"] > 0
    assert f" {stored['outer']['seconds']:.1f} " in shown


@pytest.mark.slow
def test_fields_of_a_stored_state_are_of_what_the_run_solved(result, outer):
    (stored,) = stored_fields.of_result(result)
    assert stored.forces == approx(outer.forces, rel=1e-9, abs=1e-9)
    for name in ("race", "state", "part", "patches", "sizes", "surroundings", "left_out"):
        assert getattr(stored, name) == getattr(outer, name), name


@pytest.mark.slow
def test_nominal_bar_stresses_come_from_the_condensed_state(result):
    """In every run, without a solve; the shears of all bars hold what the rollers press on the ring."""
    block = result.flexible
    azimuth = block["bar_azimuth"]
    radial, sideways = (
        (block[f"bar_{name}_moment"] @ [1.0, -1.0]) / LENGTH_OF_BARS for name in ("radial", "tangential")
    )
    up = radial @ np.cos(azimuth) - sideways @ np.sin(azimuth)
    assert up == approx(block["outer_load"] @ np.cos(block["roller_azimuth"]), rel=0.02)
    numbers = result.summary()["flexible"]
    assert numbers["nominal_bar_stress_MPa"] == approx(1e-6 * block["nominal_bar_stress"].max())
    assert 0 < numbers["nominal_bar_stress_error_MPa"] < 0.2 * numbers["nominal_bar_stress_MPa"]
    assert "largest nominal bar stress" in text(result)
    assert result.summary()["rigid"].get("nominal_bar_stress_MPa") is None


@pytest.mark.slow
def test_nominal_bar_stresses_are_those_of_the_whole_solid(result, outer):
    found, solid = result.flexible["nominal_bar_stress"], bars_of(outer.loaded).stress
    assert found == approx(solid, rel=0, abs=0.1 * found.max())


def test_record_holds_every_number_under_its_name_in_its_unit(monkeypatch):
    von_mises, tension, compression = (
        Largest(value=value * 1e6, error=error * 1e6, x=1e-3, radius=40e-3, azimuth=np.pi / 2)
        for value, error in ((5, 0.5), (4, 0.4), (-3, 0.3))
    )
    most = BodyExtremes(displacement=2e-6, von_mises=von_mises, tension=tension, compression=compression)
    part = PartFields(
        race="outer", state="flexible", part=SimpleNamespace(), patches=SimpleNamespace(), forces=np.zeros(1),
        sizes=SimpleNamespace(), surroundings=Surroundings(speed=1.0), left_out="",
    )  # pyright: ignore[reportArgumentType]  # fmt: skip
    part.__dict__["extremes"] = {"ring": most}
    monkeypatch.setattr(PartFields, "support", lambda self: {"axial_N_per_m": 3e7})
    record = part.record()
    assert record.pop("seconds") >= 0
    assert record == {
        "bodies": {
            "ring": {
                "von_mises_MPa": approx(5.0), "von_mises_error_MPa": approx(0.5),
                "tension_MPa": approx(4.0), "tension_error_MPa": approx(0.4),
                "compression_MPa": approx(-3.0), "compression_error_MPa": approx(0.3),
                "displacement_um": approx(2.0), "x_mm": approx(1.0), "radius_mm": approx(40.0),
                "azimuth_deg": approx(90.0),
            }
        },
        "loads": "rollers, heat and rotation",
        "left_out": "",
        "support": {"axial_N_per_m": 3e7},
    }  # fmt: skip


@pytest.mark.slow
def test_solid_moves_as_the_condensed_ring_did(result, outer):
    """Mean translation of the raceway, on two meshes and by two ways."""
    mesh, (_, u, v) = outer.loaded.mesh, outer.loaded.displacement
    outward = (u * ngs.y + v * ngs.z) / ngs.sqrt(ngs.y**2 + ngs.z**2) ** 2
    raceway = mesh.Boundaries("raceway")
    area = ngs.Integrate(ngs.CF(1), mesh, definedon=raceway)
    found = [2 / area * ngs.Integrate(outward * e, mesh, definedon=raceway) for e in (ngs.y, ngs.z)]
    expected = result.flexible["support_translation"][1]
    assert found == approx(expected, abs=0.06 * np.abs(expected).max())


@pytest.mark.slow
def test_support_has_one_radial_stiffness_with_its_error(result, outer):
    """That of the condensed state; the whole solid on its coarser mesh is within both errors."""
    figures = result.attributes["structure"]["outer"]
    stiffness, error = figures["support_stiffness_N_per_m"], figures["support_stiffness_error_N_per_m"]
    coarse = support_stiffness(outer.solid).radial
    assert 0 < error < 0.2 * stiffness
    assert abs(coarse - stiffness) < error + 0.06 * stiffness
    assert f"outer {1e-6 * stiffness:,.4g} {1e-6 * error:,.4g} " in " ".join(text(result).split())
    assert "radial_N_per_m" not in result.attributes["stresses"]["outer"]["support"]


@pytest.mark.slow
def test_forces_of_a_state_are_those_of_its_rollers(result, outer):
    values = stored_fields.state_of(result, "flexible")
    assert outer.forces[:, 0] == approx(values["outer_load"], rel=1e-9, abs=1e-9)
    inwards = fields.forces(values["inner_slice_load"], "inner", 5e-3, 2)
    assert inwards[:, 0] == approx(-values["inner_load"], rel=0.01)


def test_each_ring_is_loaded_by_its_own_contacts():
    case = read_case(PAPER, [item for item in COARSE if "inner.kind" not in item])
    line_loads = {"inner_slice_load": np.full((30, 8), 1e3), "outer_slice_load": np.full((30, 8), 2e3)}
    inner, outer = (fields.fields(case, race, "flexible", line_loads).forces for race in ("inner", "outer"))
    length = roller_length(case)
    assert inner[:, 0] == approx(-1e3 * length, rel=1e-12)
    assert outer[:, 0] == approx(2e3 * length, rel=1e-12)


@pytest.mark.slow
def test_solid_that_cannot_be_solved_is_said(monkeypatch, outer):
    def refused(*_):
        raise NotSolved("nothing is solved here")

    monkeypatch.setattr("fem.solid.factored_solid.factored", refused)
    fresh = replace(outer)
    with pytest.raises(NoFields, match="outer ring: nothing is solved"):
        fresh.support()


def test_heat_and_rotation_load_the_inner_ring_as_its_shaft_grows():
    """The paper's shaft is 10 K warmer and expands more; clearance takes the same expansions."""
    case = read_case(PAPER)
    around = fields.surroundings(case, "inner")
    materials, hot = case.materials, case.operation.temperatures
    shaft, ring = (
        1 + getattr(materials, name).expansion * (getattr(hot, name) - hot.reference)
        for name in ("shaft", "inner_ring")
    )
    assert around.thermal_strains == {"ring": 0.0, "shaft": approx(shaft / ring - 1, rel=1e-12)}
    assert around.densities == {"ring": materials.inner_ring.density, "shaft": materials.shaft.density}
    assert around.speed == case.operation.inner_speed


@pytest.mark.slow
def test_every_iteration_can_be_asked_for(beamed):
    count = len(beamed.iterations)
    assert count > 1
    assert stored_fields.state_of(beamed, f"iteration {count}") is beamed.iterations[-1]
    assert stored_fields.state_of(beamed, "iteration 1") is beamed.iterations[0]
    for name in (f"iteration {count + 1}", "iteration 0", "iteration", "soft"):
        with pytest.raises(BadResult, match=f"iteration 1 to iteration {count}"):
            stored_fields.state_of(beamed, name)


@pytest.mark.slow
def test_rigid_parts_have_no_fields(beamed, rigid):
    with pytest.raises(BadCase, match="inner ring and shaft is rigid"):
        stored_fields.of_result(beamed, race="inner")
    with pytest.raises(BadCase, match="every part is rigid"):
        stored_fields.of_result(rigid)
    assert "stresses" not in rigid.attributes
    assert rigid.summary()["stresses"] is None
    assert list(pictures(rigid, Path())) == []


@pytest.mark.slow
def test_export_to_vtu_writes_what_paraview_opens(result, outer, tmp_path, monkeypatch):
    stored = result.attributes["stresses"]["outer"]
    monkeypatch.setattr(fields, "fields", lambda case, race, state, values: outer)  # solved before
    monkeypatch.setattr(PartFields, "record", lambda self: stored)
    done = CliRunner().invoke(
        application(), ["export", str(result.path), "--to", "vtu", "--part", "outer", "-o", str(tmp_path)]
    )
    assert done.exit_code == 0, done.output
    assert "outer: bars" in done.output
    assert "tilting" in done.output
    assert (tmp_path / "cage_outer_flexible.vtu").stat().st_size > 10_000


@pytest.mark.slow
def test_picture_shows_the_deformed_part(result, outer, tmp_path, monkeypatch):
    monkeypatch.setattr(fields, "fields", lambda case, race, state, values: outer)  # solved before
    (picture,) = pictures(result, tmp_path)
    assert picture == tmp_path / "cage_outer_deformed.png"
    assert picture.stat().st_size > 10_000


def test_part_without_a_solid_is_said(beamed, monkeypatch, tmp_path):
    case = stored_fields.case_of(beamed)
    outer = case.outer.model_copy(update={"kind": "ring", "support": "foundation", "foundation_radial": 1e12})
    monkeypatch.setattr(stored_fields, "case_of", lambda result: case.model_copy(update={"outer": outer}))
    with pytest.raises(NoFields, match=r'outer ring: outer.support = "foundation" has no solid'):
        stored_fields.of_result(beamed)
    assert "has no solid" in str(next(pictures(beamed, tmp_path)))
    failed = CliRunner().invoke(application(), ["export", str(beamed.path), "--to", "vtu"])
    assert failed.exit_code == 1


def test_ring_in_a_fit_is_not_taken_as_bonded(beamed):
    case = stored_fields.case_of(beamed)
    loose = case.model_copy(update={"inner": case.inner.model_copy(update={"fit": "frictionless"})})
    with pytest.raises(NoFields, match="has no solid"):
        fields.fields(loose, "inner", "flexible", beamed.flexible)


def test_drawing_is_found_beside_the_case_wherever_the_result_is(beamed, tmp_path):
    """A result that holds the case of a drawn part, far from it; then carried elsewhere with the drawing."""
    drawn = PAPER.with_name("step_ring.toml")
    kept = {
        "case_text": drawn.read_text(), "case_file": str(drawn), "case_overrides": ["inner.kind=rigid"]
    }  # fmt: skip
    far = replace(beamed, path=tmp_path / "r.h5", attributes={**beamed.attributes, **kept})
    assert fields.parts(stored_fields.case_of(far))["outer"].source == "step_ring.step"
    gone = replace(far, attributes={**far.attributes, "case_file": str(tmp_path / "away" / "case.toml")})
    with pytest.raises(NoFields, match=r"step_ring.step: there is no such file"):
        fields.parts(stored_fields.case_of(gone))
    (tmp_path / "step_ring.step").write_bytes(drawn.with_suffix(".step").read_bytes())
    assert fields.parts(stored_fields.case_of(gone))["outer"].source == "step_ring.step"


def test_result_knows_where_its_case_was(beamed):
    assert beamed.attributes["case_file"] == str(PAPER.resolve())
