"""Cases of fast balls between elastic rings, from the file to the result."""

import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.case.read import written
from flexbearing.families import FAMILIES
from flexbearing.life.against_catalogue import against_catalogue
from flexbearing.life.ball_influences import CATALOGUE
from flexbearing.progress import Logged
from flexbearing.report.output import text
from flexbearing.rings import stored
from flexbearing.rings.stored import condense
from flexbearing.runs import angular_contact
from flexbearing.studies.placement import Placement
from flexbearing.studies.prepare import compute, prepare_source
from tests.flexbearing.noted import codes

CAGE = "configs/harris218_cage.toml"
COARSE = {"accuracy.element_order": 3, "accuracy.stations": 5}  # of 5 and 7
RING = COARSE | {
    "outer.kind": "ring", "outer.thickness": "3.65 mm", "outer.width": "19 mm",
    "bearing.outer.shoulder": "2.2 mm", "outer.support": "foundation",
    "outer.foundation_radial": "1000 N/mm^3", "outer.foundation_axial": "1000 N/mm^3",
    "outer.foundation_tangential": "1000 N/mm^3",
}  # fmt: skip


@pytest.fixture(scope="module")
def on_cage(tmp_path_factory):
    return flexbearing.run(CAGE, output=tmp_path_factory.mktemp("cage") / "cage.h5")


def test_both_states_are_stored_and_shown(on_cage):
    rigid, flexible = on_cage.rigid, on_cage.flexible
    assert on_cage.attributes["status"] == "converged"
    assert flexible["contact_load"][1].max() < 0.85 * rigid["contact_load"][1].max()
    assert flexible["stiffness_matrix"][2, 2] < 0.1 * rigid["stiffness_matrix"][2, 2]
    assert "groove_displacement" not in rigid
    assert not flexible["groove_displacement"][0].any()
    assert text(on_cage).count(" rigid  flexible ") >= 1


def test_balls_carry_the_load_of_the_case(on_cage):
    flexible = on_cage.flexible
    assert flexible["ring_load"] == approx([17800.0, 0.0, 5000.0, 0.0, 0.0], abs=1e-4)
    angle, load = flexible["contact_angle"][0], flexible["contact_load"][0]
    axial = load * np.sin(angle) + flexible["traction"][0] * np.cos(angle)
    assert axial.sum() == approx(17800.0, abs=1e-3)


def test_a_stiffer_cage_is_nearer_to_rigid_rings(on_cage):
    stiff = flexbearing.run(CAGE, COARSE | {"outer.bar_length": "20 mm"})  # of 60 mm
    assert on_cage.flexible["stiffness_matrix"][2, 2] < 0.5 * stiff.flexible["stiffness_matrix"][2, 2]


def test_a_symmetric_bearing_under_thrust_has_equal_balls():
    result = flexbearing.run(CAGE, {"operation.load.radial_z": "0 N"})
    loads = result.flexible["contact_load"]
    assert np.ptp(loads, axis=1) == approx(np.zeros(2), abs=1e-5 * loads.max())


def test_a_turned_load_turns_the_answer(on_cage):
    quarter = {"operation.load.radial_z": "0 N", "operation.load.radial_y": "5 kN"}
    across = flexbearing.run(CAGE, quarter).flexible["contact_load"]
    assert np.roll(on_cage.flexible["contact_load"], 4, axis=1) == approx(across, rel=1e-6)


def test_a_preload_force_is_that_between_elastic_rings():
    """The held place is where the force brings the ring at rest; at rest, it carries that force."""
    held = {
        "operation.load.axial": "0 N", "operation.load.radial_z": "0 N",
        "operation.preload.force": "2 kN", "operation.inner_speed": "1 rpm",
    }  # fmt: skip
    result = flexbearing.run(CAGE, held)
    assert result.rigid["ring_load"][0] == approx(2000.0, rel=1e-4)
    assert result.flexible["ring_load"][0] == approx(2000.0, rel=1e-4)
    assert result.flexible["ring_displacement"][0] > 1.02 * result.rigid["ring_displacement"][0]


@pytest.mark.parametrize("support", ["side", "seat", "foundation", "housing"])
def test_a_deep_groove_bearing_on_every_support(support):
    steel = {"youngs_modulus": "70 GPa", "poisson_ratio": 0.3, "density": "2700 kg/m^3"}
    housing = {"outer.housing_thickness": "10 mm", "outer.housing_width": "25 mm", "materials.housing": steel}
    ring = {key: value for key, value in RING.items() if "foundation" not in f"{key}{value}"}
    given = RING if support == "foundation" else ring | {"outer.support": support}
    result = flexbearing.run("configs/6209.toml", given | (housing if support == "housing" else {}))
    stiffness = result.flexible["stiffness_matrix"][2, 2]
    rigid = result.rigid["stiffness_matrix"][2, 2]
    assert 0.2 * rigid < stiffness < (1.1 if support == "seat" else 1.0) * rigid  # stiffer than half-spaces


def test_rows_of_a_table_are_those_of_runs():
    """Two of the same rings, one of softer rings between them, one of rigid rings before all."""
    rows = FAMILIES["deep_groove_ball"].rows()
    names = [
        "contact_load_range.outer.largest",
        "rigid.contact_load_range.outer.largest",
        "groove_displacement.outer",
    ]
    loads = [{"operation.load.radial_z": f"{load} kN"} for load in (4, 5, 6)]
    elastic = [RING | loads[0], RING | loads[1] | {"outer.foundation_radial": "300 N/mm^3"}, RING | loads[2]]
    of_rigid, *found = rows([read_case("configs/6209.toml", each) for each in (loads[1], *elastic)], names)
    for row, each in zip(found, elastic, strict=True):
        result = flexbearing.run("configs/6209.toml", each)
        assert row.numbers[names[0]] == approx(result.flexible["contact_load"][1].max(), rel=1e-9)
        assert row.numbers[names[1]] == approx(result.rigid["contact_load"][1].max(), rel=1e-9)
        moved = 1e6 * np.abs(result.flexible["groove_displacement"][1]).max()
        assert row.numbers[names[2]] == approx(moved, rel=1e-6)
    assert of_rigid.numbers[names[0]] == approx(found[1].numbers[names[1]], rel=1e-9)


def test_a_ring_under_balls_at_other_azimuths_is_another(monkeypatch):
    monkeypatch.setattr("flexbearing.rings.grooves.groove_pair", lambda *_: object())
    settings = [{"bearing.first_ball_azimuth": f"{azimuth} deg"} for azimuth in (0, 10, 0)]
    cases = [read_case(CAGE, each) for each in settings]
    built = [angular_contact.build(case) for case in cases]
    first, other, again = angular_contact._grooves(cases, built, Logged(), {})
    assert first is again
    assert other is not first


def test_a_study_condenses_each_ring_once_before_its_rows(tmp_path, monkeypatch):
    ring = "\n".join(
        f'"{key}" = {json.dumps(value)}'
        for key, value in (RING | {"accuracy.stations": 3, "accuracy.patch_width": "2 mm"}).items()
        if key != "outer.thickness"
    )
    over = '"outer.thickness" = ["3.65 mm", "5 mm"]\n"operation.load.radial_z" = ["4 kN", "6 kN"]'
    file = tmp_path / "study.toml"
    file.write_text(f'case = "{Path("configs/6209.toml").resolve()}"\n[set]\n{ring}\n[over]\n{over}')
    monkeypatch.setenv("FLEXBEARING_CACHE", "off")
    condensed, steps = [], []

    def counted(part, *others):
        condensed.append(part.thickness)
        return condense(part, *others)

    monkeypatch.setattr(stored, "condense", counted)
    prepared = prepare_source(file)
    table = compute(
        prepared, tmp_path, Placement(jobs=1), tell=lambda now: steps.append((now.done, len(condensed)))
    )
    assert table["status"].values == ("converged",) * 4
    assert len(set(condensed)) == 2
    assert {count for done, count in steps if done} == {2}


def test_notes_say_where_patches_and_stations_do_not_suit():
    result = flexbearing.run(CAGE, COARSE | {"accuracy.patch_width": "3 mm"})
    assert "patch-width" in codes(result)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"accuracy.stations": 4}, "odd"),
        ({"outer.thickness": "0.3 mm"}, r"\[outer\] thickness = .0.3 mm. cannot be; it must be above 0.3 mm"),
        ({"outer.bars": 200}, r"\[outer\] bar_width = .5 mm. cannot be; .* leaves 200 slots"),
        ({"bearing.outer.radius": None, "bearing.outer.conformity": 4.2}, r"\[bearing.outer\] conformity"),
    ],
)
def test_what_cannot_be_is_refused_by_check(changes, words):
    with pytest.raises(BadCase, match=words):
        check(CAGE, changes)


def test_bars_for_which_no_width_is_narrow_enough_are_too_many():
    small = {
        "bearing.pitch_diameter": "12 mm", "bearing.ball.diameter": "2 mm", "bearing.balls": 9,
        "bearing.outer.radius": "1.05 mm", "bearing.inner.radius": "1.05 mm",
        "bearing.outer.shoulder": "0.4 mm", "outer.bars": 180, "outer.bar_width": "0.3 mm",
    }  # fmt: skip
    with pytest.raises(BadCase, match=r"\[outer\] bars = 180 cannot be; it must be at most \d+, with slots"):
        check(CAGE, small)


STEEL = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7800 kg/m^3"}
ON_SHAFT = {
    "inner.kind": "ring_on_shaft", "inner.bore": "90 mm", "inner.width": "30 mm",
    "inner.shaft_length": "80 mm",
    "inner.shaft_thickness": "10 mm", "bearing.inner.shoulder": "5 mm", "materials.shaft": STEEL,
}  # fmt: skip


@pytest.mark.parametrize(
    ("key", "beyond", "allowed", "because"),
    [
        ("outer.width", "19.7 mm", "at least 19.72 mm", "a land at each side"),
        ("outer.groove_offset", "5.15 mm", "at most 5.144 mm", "the groove leaves outer.width"),
        ("outer.groove_offset", "-16 mm", "at most 5.144 mm", "to either side"),
        (
            "outer.bar_thickness",
            "10.41 mm",
            "at most 10.4 mm",
            "the 10.6 mm of bearing.outer.shoulder and outer.th",
        ),
        ("outer.bar_width", "13.85 mm", "at most 13.84 mm", "32 slots of 0.3 mm"),
        ("bearing.outer.radius", "92.5 mm", "at most 92.48 mm", "around the axis"),
        ("bearing.outer.shoulder", "0.47 mm", "at least 0.4748 mm", "accuracy.patch_width"),
        (
            "accuracy.patch_width",
            "4.5 mm",
            "at most 4.485 mm",
            "of half an arc that ends by bearing.inner.shoulder",
        ),
        ("accuracy.patch_width", "0.0265 mm", "at least 0.0266 mm", "an outer groove of so large a radius"),
        ("inner.width", "19.7 mm", "at least 19.72 mm", "a land at each side"),
        ("inner.bore", "102.2 mm", "at most 102.1 mm", "under the bottom of the groove"),
        ("inner.bore", "0.59 mm", "at least 0.6 mm", ""),
        ("inner.shaft_thickness", "0.29 mm", "at least 0.3 mm", "at most 45 mm, half of inner.bore"),
        ("inner.shaft_thickness", "45.1 mm", "at most 45 mm", "half of inner.bore"),
        ("inner.shaft_length", "30.59 mm", "at least 30.6 mm", "inner.width and 0.3 mm at each end"),
    ],
)
def test_a_refusal_names_the_key_and_a_limit_that_is_allowed(key, beyond, allowed, because):
    given = ON_SHAFT | ({"outer.width": "70 mm"} if key == "bearing.outer.radius" else {})
    if key == "inner.bore":
        del given["inner.shaft_thickness"]
    with pytest.raises(BadCase) as refusal:
        check(CAGE, given | {key: beyond})
    message, (table, _, name) = str(refusal.value), key.rpartition(".")
    assert f'[{table}] {name} = "{beyond}" cannot be; it must be' in message
    assert allowed in message
    assert because in message
    check(CAGE, given | {key: allowed.removeprefix("at least ").removeprefix("at most ")})


def test_a_ring_on_springs_that_hardly_hold_it_is_not_solved_and_named():
    springs = {f"outer.foundation_{way}": "1e-5 N/mm^3" for way in ("radial", "axial", "tangential")}
    result = flexbearing.run("configs/strain_wave.toml", COARSE | springs)
    assert result.attributes["status"] == "not solved"
    assert "outer ring: so flexible a part" in result.attributes["message"]


def test_a_ring_without_its_shoulder_is_refused_in_words_of_the_case():
    given = {key: value for key, value in RING.items() if "shoulder" not in key}
    with pytest.raises(BadCase, match=r"\[bearing.outer\] shoulder is missing"):
        check("configs/harris218.toml", given)


ON_A_SHAFT = {
    "inner.kind": "ring_on_shaft", "inner.bore": "45 mm", "inner.width": "19 mm",
    "inner.shaft_length": "60 mm", "bearing.inner.shoulder": "2.2 mm", "materials.shaft": "structural steel",
}  # fmt: skip
IN_HOUSING = {
    "outer.support": "housing", "outer.housing_thickness": "10 mm", "outer.housing_width": "19 mm",
    "materials.housing": "grey cast iron",
}  # fmt: skip
FITTED = {
    "bearing.fits": {"bore": "45 mm", "outer_diameter": "85 mm", "shaft": "k5", "cold_clearance": "15 um"},
    "bearing.clearance": None, "materials.shaft": "structural steel",
    "materials.inner_ring": "100Cr6", "materials.outer_ring": "100Cr6",
}  # fmt: skip
HOUSED = {
    "bearing.fits.housing": {"tolerance_class": "H7", "diameter": "120 mm"},
    "materials.housing": "grey cast iron",
}


@pytest.mark.parametrize("fits", [{}, FITTED, FITTED | HOUSED], ids=["no fits", "on a shaft", "in a housing"])
@pytest.mark.parametrize("rings", [{}, ON_A_SHAFT, IN_HOUSING, ON_A_SHAFT | IN_HOUSING])
def test_settings_that_leave_an_influence_out_are_those_of_a_case(rings, fits):
    """Alone, as the card prints them, and with all later ones left out, too."""
    bare = {key: value for key, value in RING.items() if "foundation" not in f"{key}{value}"}
    given = written(bare | rings | fits)
    stages = stages_of("configs/6209.toml", given)
    for stage in stages:
        for settings in (stage["settings"], stage["left_out_by"]):
            check("configs/6209.toml", [*given, *settings])
    assert sum("bearing.fits=" in stage["left_out_by"] for stage in stages) == bool(fits)
    without = read_case("configs/6209.toml", [*given, *stages[0]["settings"]]).materials
    assert (without.shaft, without.housing) == (None, None)


def test_a_material_that_rings_need_makes_no_stage_of_fits():
    given = {
        "inner.kind": "ring_on_shaft", "inner.bore": "90 mm", "inner.width": "30 mm",
        "inner.shaft_length": "60 mm", "bearing.inner.shoulder": "5 mm", "materials.shaft": "100Cr6",
    }  # fmt: skip
    names = [stage["name"] for stage in stages_of(CAGE, written(given))[2:]]
    assert names == ["tilt of the inner ring", "elastic rings", "inertia of the balls at speed"]


def stages_of(case, given):
    """The way from the life of a catalogue, all lives of it the same."""
    lived = {"status": "converged", "life": {"rigid": {"modified_Mrev": 1.0}}}
    alike = SimpleNamespace(flexible=None, attributes=lived)
    read = read_case(case, given)
    return against_catalogue(
        read, CATALOGUE, lambda settings: read_case(case, [*given, *settings]), lambda case: alike
    )["stages"]


def test_lives_against_a_catalogue_name_what_elastic_rings_do():
    result = flexbearing.run(CAGE, {"outputs.catalogue_life": True})
    stages = {stage["name"]: stage for stage in result.attributes["catalogue_life"]["stages"]}
    flexible = flexbearing.run(CAGE, {"materials.ball.density": "0.001 kg/m^3"})
    gained = flexible.flexible["life_L10"] / flexible.rigid["life_L10"]
    assert stages["elastic rings"]["factor"] == approx(float(gained), rel=1e-6)


@pytest.mark.parametrize(
    ("case", "changes"),
    [
        (CAGE, {"accuracy.mesh_size": "0.02 mm"}),
        (
            CAGE,
            {"accuracy.patch_width": "0.2 mm", "accuracy.mesh_size": "0.1 mm", "accuracy.element_order": 8},
        ),
        ("configs/slewing_bolted.toml", {"rings.mesh_size": "0.1 mm"}),
    ],
    ids=["cage", "patches", "bolted"],
)
def test_meshes_that_no_computer_solves_are_refused_by_check(case, changes):
    with pytest.raises(BadCase, match=r"(accuracy|rings)\].*mesh_size: .*unknowns on the axial section"):
        check(case, changes)
