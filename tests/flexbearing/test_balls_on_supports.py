"""Cases of fast balls whose outer ring is on lines, in a planet gear, or on a matrix of another program."""

from math import cos, radians, sin
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.case.read import written
from flexbearing.coupled.balls import BallState, equilibrium
from flexbearing.derivatives.balls import sensitivities
from flexbearing.families import FAMILIES
from flexbearing.progress import Silent
from flexbearing.report.output import text
from flexbearing.rings.grooves import elastic_grooves, groove_pair, parts
from flexbearing.runs.angular_contact import bearing, operation
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves
from tests.fem import test_ring_on_matrix as matrices, written_matrices as write
from tests.flexbearing.noted import codes

CASE = "configs/6209.toml"
RING = {
    "outer.kind": "ring", "outer.thickness": "3.65 mm", "outer.width": "19 mm",
    "bearing.outer.shoulder": "2.2 mm", "accuracy.stations": 5, "accuracy.element_order": 4,
    "accuracy.patch_width": "1.2 mm",
}  # fmt: skip
LINES = RING | {"outer.support": "lines", "outer.line_azimuths": ["-30 deg", "30 deg", "180 deg"]}
TEETH = RING | {
    "outer.support": "planet", "outer.tooth_azimuths": ["90 deg", "270 deg"],
    "outer.tooth_radial": ["-1.5 kN", "-1.5 kN"], "outer.tooth_tangential": ["4.45 kN", "-4.45 kN"],
}  # fmt: skip
SPRINGS = RING | {
    "outer.support": "foundation", "outer.bilateral": False,
    **{f"outer.foundation_{way}": "1000 N/mm^3" for way in ("radial", "axial", "tangential")},
}  # fmt: skip
FITTED = {
    "bearing.fits": {
        "bore": "45 mm", "outer_diameter": "85 mm", "shaft_interference": "5 um", "cold_clearance": "25 um",
        "housing": {"interference": "-20 um", "diameter": "105 mm"},
    },
    "bearing.clearance": None, "materials.shaft": "structural steel",
    "materials.inner_ring": "100Cr6", "materials.outer_ring": "100Cr6",
}  # fmt: skip
BARE = {name: value for name, value in FITTED["bearing.fits"].items() if name != "housing"}
ALL_ROUND = [f"{20 * k} deg" for k in range(18)]


def built(changes):
    case = read_case(CASE, changes)
    model = bearing(case)
    return case, model, operation(case), model.bearing.azimuths


@pytest.mark.parametrize("support", [LINES | {"outer.bilateral": True}, TEETH], ids=["lines", "teeth"])
def test_stiffer_rings_tend_to_rigid_ones(support):
    """Loads and place; a rim is rigid where both its compliance and its bending by teeth are gone."""
    case, model, load, azimuths = built(support)
    grooves = elastic_grooves(case, azimuths, Silent())
    assert grooves
    rigid = model.solve(load)
    errors = [
        np.abs(model.solve(load, grooves.softened(part)).loads - rigid.loads).max() / rigid.loads.max()
        for part in (1e-4, 1e-6, 1e-8)
    ]
    assert errors[0] > 1e-5
    assert errors[1] == approx(1e-2 * errors[0], rel=0.05)
    assert errors[2] < 1e-6


def test_a_ring_lifts_off_springs_that_would_pull():
    case, model, load, azimuths = built(SPRINGS | {"outer.foundation_tangential": "1 N/mm^3"})
    grooves = groove_pair(case, azimuths, Silent())
    state = equilibrium(case.coupling, model, load, grooves)
    springs = grooves.raceways.outer.figures()["foundation"]
    assert springs["least_pressure_MPa"] == 0.0
    assert 0.1 < springs["open_share"] < 0.9
    assert springs["rollers_N"] == approx([0.0, 8900.0], abs=0.2)
    assert springs["resultant_N"] == approx([0.0, 8900.0], abs=90.0)
    pulling = flexbearing.run(CASE, SPRINGS | {"outer.bilateral": None})
    assert np.abs(state.loads - pulling.flexible["contact_load"]).max() > 1e-4 * state.loads.max()


def test_springs_that_are_pressed_everywhere_need_not_pull():
    """Under a clearance below zero, on springs that leave the axial place to the groove, too."""
    tight = SPRINGS | {
        "bearing.clearance": "-20 um", "operation.load.radial_z": "10 N", "operation.load.axial": "500 N",
        "outer.foundation_axial": "0 N/mm^3",
    }  # fmt: skip
    pushing, pulling = (
        flexbearing.run(CASE, tight | {"outer.bilateral": each}).flexible for each in (False, True)
    )
    assert pushing["contact_load"] == approx(pulling["contact_load"], rel=1e-8)
    assert pushing["ring_displacement"] == approx(pulling["ring_displacement"], rel=1e-8, abs=1e-14)
    with pytest.raises(BadCase, match=r"outer\.bilateral = false has no solid"):
        check(CASE, tight | {"outputs.probes.azimuths": ["0 deg"]})


def test_a_ring_lifts_off_lines_that_would_pull():
    case, model, load, azimuths = built(LINES | {"outer.line_azimuths": ALL_ROUND})
    grooves = groove_pair(case, azimuths, Silent())
    state = equilibrium(case.coupling, model, load, grooves)
    lines = grooves.raceways.outer.figures()["lines"]
    force = np.array(lines["force_N"])
    assert force.min() > -1e-6 * force.max()
    assert not all(lines["carries"])
    assert lines["resultant_N"] == approx([0.0, 8900.0], abs=0.2)
    pulling = flexbearing.run(CASE, LINES | {"outer.line_azimuths": ALL_ROUND, "outer.bilateral": True})
    difference = state.loads - pulling.flexible["contact_load"]
    assert np.abs(difference).max() > 1e-4 * state.loads.max()
    run = flexbearing.run(CASE, LINES | {"outer.line_azimuths": ALL_ROUND})
    assert run.flexible["contact_load"] == approx(state.loads, rel=1e-9)
    stored = run.attributes["structure"]["outer"]
    assert stored["lines"]["force_N"] == approx(force, abs=1e-6)
    assert stored["support_stiffness_N_per_m"] is None  # places count from the ground
    printed = text(run)
    assert printed.count("lifted off") == lines["carries"].count(False)
    assert pulling.attributes["structure"]["outer"]["lines"]["pull"]


def test_a_load_turned_with_its_lines_turns_the_answer():
    pitch = radians(40.0)
    turned = {
        "outer.line_azimuths": ["10 deg", "70 deg", "220 deg"],
        "operation.load.radial_z": f"{8900 * cos(pitch)!r} N",
        "operation.load.radial_y": f"{8900 * sin(pitch)!r} N",
    }  # fmt: skip
    here, there = (flexbearing.run(CASE, LINES | each).flexible["contact_load"] for each in ({}, turned))
    assert np.roll(here, 1, axis=1) == approx(there, rel=1e-6)


def test_derivatives_by_the_azimuth_of_balls_know_where_the_lines_are():
    """They were those of a ring that turns with its balls."""
    lines = LINES | {"outer.bilateral": True}
    key, output = "bearing.first_ball_azimuth", "contact_load_range.inner.largest"
    table, *near = (
        sensitivities(read_case(CASE, lines | {key: f"{azimuth} deg"}), [output], [key])
        for azimuth in (10.0, 9.99, 10.01)
    )
    values = [each.outputs[0].value for each in near]
    assert table.slopes[0, 0] == approx((values[1] - values[0]) / 0.02, rel=1e-4)


def test_rims_of_planet_gears_load_more_balls_than_lines():
    """Teeth across the load bend the rim around the balls; both are in balance with the load."""
    rim, rigid = (flexbearing.run(CASE, each) for each in (TEETH, {}))
    assert rim.flexible["ring_load"] == approx([0, 0, 8900, 0, 0], abs=1e-4)
    assert "tooth-forces-at-rim" in codes(rim)
    assert "unbalanced-teeth" not in codes(rim)
    loaded = (rim.flexible["contact_load"][0] > 0).sum(), (rigid.rigid["contact_load"][0] > 0).sum()
    assert loaded[0] >= loaded[1]
    loads = rim.flexible["contact_load"][0]
    assert loads[0] < loads[1]  # the teeth draw the rim off the balls below the pin, as that of rollers
    halved = flexbearing.run(CASE, TEETH | {"outer.tooth_tangential": ["2 kN", "-2 kN"]})
    assert "unbalanced-teeth" in codes(halved)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"outer.line_azimuths": ["60 deg", "120 deg", "180 deg"]},
            "lines that only push do not hold a load",
        ),
        ({"outer.line_azimuths": []}, "three or more azimuths"),
        ({"outer.groove_offset": "1 mm"}, "groove_offset"),
        ({"outer.support": "planet", "outer.line_azimuths": None}, "one or more azimuths"),
    ],
)
def test_supports_that_hold_no_ring_are_refused(changes, words):
    with pytest.raises(BadCase, match=words):
        check(CASE, LINES | changes)


@pytest.mark.slow
def test_springs_written_as_a_matrix_are_a_foundation(tmp_path, monkeypatch):
    """Up to what lies beyond its harmonics and polynomials."""
    for name, value in {"RADIUS": 42.5e-3, "WIDTH": 19e-3, "OFFSET": 0.0}.items():
        monkeypatch.setattr(matrices, name, value)
    body = matrices.springs((2e11, 5e11, 1e11))
    numbers = range(1, len(body.places) + 1)
    write.nodes_inp(tmp_path / "seat.inp", 1e3 * body.places, numbers)
    unknowns = [(node, motion) for node in numbers for motion in (1, 2, 3)]
    write.abaqus(tmp_path / "seat.mtx", unknowns, 1e-3 * body.stiffness)
    (tmp_path / "case.toml").write_text(Path(CASE).read_text())
    springs = {"axial": "200 N/mm^3", "radial": "500 N/mm^3", "tangential": "100 N/mm^3"}
    known = flexbearing.run(
        CASE,
        RING | {"outer.support": "foundation"} | {f"outer.foundation_{way}": k for way, k in springs.items()},
    ).flexible
    files = {"outer.kind": "matrix", "outer.matrix": "seat.mtx", "outer.nodes": "seat.inp"}
    result = flexbearing.run(tmp_path / "case.toml", RING | files)
    assert "matrix" in codes(result)
    one, other = (parts(read_case(tmp_path / "case.toml", written(RING | files)))[1] for _ in range(2))
    assert one == other  # rows of a study have one ring
    loads = result.flexible["contact_load"]
    assert loads == approx(known["contact_load"], rel=0, abs=2e-3 * loads.max())
    assert np.abs(loads - result.rigid["contact_load"]).max() > 2e-2 * loads.max()


def test_balls_beyond_the_stations_press_supports_as_they_press_their_groove():
    """Their shares grew without end there."""
    stations, at = np.radians([-25.0, 0.0, 25.0]), np.radians([[60.0, 5.0], [-50.0, 20.0]])
    state = SimpleNamespace(
        contact_angles=at, loads=np.full((2, 2), 1000.0), section_forces=np.array([[3.0, -5.0], [7.0, 2.0]])
    )
    forces = BallState.of(state, np.array([stations, stations])).forces
    groove = ElasticGroove(stations, np.zeros((2, 3, 2, 3)))
    for race in range(2):
        vectors = (state.loads[race] - 1j * state.section_forces[race]) * (
            np.sin(at[race]) + 1j * np.cos(at[race])
        )
        pairs = np.stack([vectors.real, vectors.imag], -1)
        assert forces[race] == approx((groove.shares(at[race]).by_vector @ pairs[..., None])[..., 0])


HOUSED = RING | {
    "outer.thickness": "6 mm", "outer.support": "housing", "outer.housing_thickness": "10 mm",
    "outer.housing_width": "19 mm",
    "materials.housing": "grey cast iron", "outer.housing_clearance": "20 um",
}  # fmt: skip


def test_a_ring_touches_its_housing_where_balls_press_it():
    """The same loads follow from the deviations of the groove alone; a tight ring is pressed all around."""
    case, model, load, azimuths = built(HOUSED | {"operation.load.axial": "1 kN"})
    grooves = groove_pair(case, azimuths, Silent())
    state = equilibrium(case.coupling, model, load, grooves)
    found = BallState.of(state, grooves.angles)
    moved = grooves.raceways.linearised(found.forces).deviation(found.forces)[1]
    as_moved = ElasticGroove(grooves.angles[1], np.zeros(moved.shape * 2), moved)
    assert model.solve(load, ElasticGrooves(None, as_moved)).loads == approx(state.loads, rel=1e-9, abs=1e-6)
    figures = grooves.raceways.outer.figures()["housing"]
    assert figures["mean_gap_unloaded_um"] == approx(10.0)
    assert 30 < figures["touching_angle_deg"] < 180
    tight = flexbearing.run(CASE, HOUSED | {"outer.housing_clearance": "-40 um"})
    assert tight.attributes["structure"]["outer"]["housing"]["open_share"] == 0.0
    bonded = flexbearing.run(CASE, HOUSED | {"outer.housing_clearance": None}).flexible["contact_load"]
    tight, loose = tight.flexible["contact_load"].max(), state.loads.max()
    assert abs(tight / bonded.max() - 1) < 0.01 < loose / bonded.max() - 1


@pytest.mark.slow
@pytest.mark.parametrize("case", [CASE, "configs/harris218.toml"], ids=["deep groove", "angular contact"])
@pytest.mark.parametrize("seed", range(10))
def test_random_fits_are_solved_by_newton(case, seed):
    """Loads over two decades, clearances of -20 to 50 um; forces are summed again."""
    draw = np.random.default_rng(seed)
    scale, thick = 10 ** draw.uniform(-2, 0), draw.uniform(0.6, 1.6)
    along, across, up = 20e3 * scale * np.array([draw.choice([0.0, 0.3]), draw.uniform(-0.5, 0.5), 1.0])
    changes = HOUSED | {"outer.thickness": f"{3.65 * thick:.3f} mm"}
    if case != CASE:
        along, up = along + 15e3 * scale, draw.uniform(0.2, 1.0) * up
        changes |= {
            "outer.thickness": f"{8 * thick:.3f} mm", "outer.width": "30 mm", "outer.housing_width": "30 mm",
            "bearing.outer.shoulder": "5 mm", "operation.inner_speed": f"{draw.choice([500, 5000])} rpm",
        }  # fmt: skip
    result = flexbearing.run(
        case,
        changes
        | {"outer.housing_clearance": f"{draw.uniform(-20, 50):.2f} um", "operation.load.axial": f"{along} N",
           "operation.load.radial_y": f"{across} N", "operation.load.radial_z": f"{up} N"},
    )  # fmt: skip
    assert result.attributes["attempts"]["newton"]["status"] == "converged"
    loads, angles = (result.flexible[name][0] for name in ("contact_load", "contact_angle"))
    phi = bearing(read_case(case)).bearing.azimuths
    sums = loads @ np.stack(
        [np.sin(angles), np.cos(angles) * np.sin(phi), np.cos(angles) * np.cos(phi)], axis=1
    )
    assert np.abs(sums) == approx(np.abs([along, across, up]), rel=0, abs=1e-9 * loads.max())


def test_clearance_in_a_housing_moves_the_inner_ring_and_stays_in_the_tangent():
    """By half of it and by what the ring bends into it; stiffness is that of differences of the load."""
    place, stiffness = {}, 0.0
    for load in (7999.0, 8000.0, 8001.0):
        state = flexbearing.run(CASE, HOUSED | {"operation.load.radial_z": f"{load} N"}).flexible
        place[load] = state["ring_displacement"][2]
        if load == 8000.0:
            stiffness = state["stiffness_matrix"][2, 2]
    assert 2.0 / (place[8001.0] - place[7999.0]) == approx(stiffness, rel=1e-3)
    filled = flexbearing.run(CASE, HOUSED | {"outer.housing_clearance": "0 um"}).flexible
    loose = flexbearing.run(CASE, HOUSED).flexible
    assert 10e-6 < loose["ring_displacement"][2] - filled["ring_displacement"][2] < 13e-6


@pytest.mark.parametrize("clearance", ["-5 um", "20 um"])
def test_a_load_turned_in_a_housing_turns_the_answer(clearance):
    """As far as the grid of the fit is round."""
    pitch = radians(40.0)
    turned = {
        "operation.load.radial_z": f"{8900 * cos(pitch)!r} N",
        "operation.load.radial_y": f"{8900 * sin(pitch)!r} N",
    }  # fmt: skip
    given = HOUSED | {"outer.housing_clearance": clearance}
    here, there = (flexbearing.run(CASE, given | each).flexible["contact_load"] for each in ({}, turned))
    assert here[:, 1:] == approx(here[:, :0:-1], rel=1e-8, abs=1e-6)
    assert np.roll(here, 1, axis=1) == approx(there, rel=0, abs=1e-3 * here.max())


def test_rows_with_other_clearances_in_their_housing_are_those_of_runs():
    """Bodies are condensed once; a fit is that of its row."""
    name = "contact_load_range.outer.largest"
    given = [HOUSED | {"outer.housing_clearance": f"{clearance} um"} for clearance in (20, 50, 20)]
    found = FAMILIES["deep_groove_ball"].rows()([read_case(CASE, each) for each in given], [name])
    for row, each in zip(found, given, strict=True):
        load = flexbearing.run(CASE, each).flexible["contact_load"][1].max()
        assert row.numbers[name] == approx(load, rel=1e-8)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"outputs.probes.azimuths": ["0 deg"]}, "outer.housing_clearance has no solid, only a bonded ring"),
        ({"outer.support": "seat"}, "housing_clearance"),
        (FITTED, "bearing.fits.housing.interference says the same with the opposite sign"),
        (
            FITTED | {"bearing.fits": BARE, "outer.housing_clearance": "-5 um"},
            "zero or more: beside .bearing.fits. bearing.fits.housing.interference is needed",
        ),
        ({"materials.ball": {"youngs_modulus": "320 GPa", "poisson_ratio": 0.26, "density": "3200 kg/m^3"},
          "operation.outer_speed": "100 rpm",
          "materials.outer_ring": {"youngs_modulus": "208 GPa", "poisson_ratio": 0.3}},
         "density is missing: an outer ring that turns in its housing needs it"),
    ],
)  # fmt: skip
def test_fits_in_housings_that_cannot_be_are_refused(changes, words):
    with pytest.raises(BadCase, match=words):
        check(CASE, HOUSED | changes)


def test_derivatives_in_a_fit_are_refused():
    with pytest.raises(BadCase, match=r"outer\.housing_clearance is found by separate iterations"):
        sensitivities(read_case(CASE, HOUSED))


def test_a_fit_of_the_case_is_that_of_the_housing():
    """The interference by [bearing.fits] and by outer.housing_clearance is one."""
    fitted = HOUSED | {"outer.housing_clearance": None} | FITTED
    loose, clear = (read_case(CASE, each) for each in (fitted, HOUSED))
    assert (loose.in_fit, loose.housing_interference) == (clear.in_fit, clear.housing_interference)
    assert not read_case(CASE, HOUSED | {"outer.housing_clearance": None}).in_fit
