"""Contact pressure of a case: along its rollers, where it is largest, what it does below, how safe it is."""

import itertools

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.report.balls import figures
from flexbearing.report.output import text, write_figures
from flexbearing.report.roller.figures import pictures
from flexbearing.runs.rows import answers
from quasidynamic.contact.line import reduced_radius
from quasidynamic.outcome.life import edge_stress_factor
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
TILTED = {"operation.misalignment": "3 arcmin"}
BELOW = {"outputs.subsurface_stresses": True}
BALLS = {"angular": "harris218.toml", "four_point": "joshi2015_ed20.toml"}


@pytest.fixture(scope="module")
def tilted():
    return flexbearing.run(PLAIN, TILTED | BELOW)


def test_strip_has_the_width_of_hertz(tilted):
    case = tilted.attributes["case_si"]
    roller, bearing, steel = case["bearing"]["roller"], case["bearing"], case["materials"]["roller"]
    outer = bearing["outer_raceway_diameter"] / 2
    inner = outer - roller["diameter"] - bearing["clearance"] / 2
    radii = [reduced_radius(roller["diameter"] / 2, radius) for radius in (inner, -outer)]
    modulus = steel["youngs_modulus"] / (1 - steel["poisson_ratio"] ** 2)
    width = 4 * np.array(radii) * tilted.rigid["peak_pressure"] / modulus
    assert tilted.rigid["contact_half_width"] == approx(
        width, rel=2e-4
    )  # radii without half of the clearance


def test_pressure_carries_the_load_of_every_roller(tilted):
    block = tilted.rigid
    slice_width = np.diff(block["slice_position"])[0]
    for race, name in enumerate(("inner", "outer")):
        pressure = block[f"{name}_pressure"]
        half_width = block["contact_half_width"][race] / block["peak_pressure"][race] * pressure
        load = (np.pi / 2 * pressure * half_width).sum(axis=1) * slice_width
        assert load == approx(block[f"{name}_load"], rel=1e-9, abs=1e-9 * block[f"{name}_load"].max())


def test_largest_of_the_pressures_is_the_peak_and_its_strip_carries_its_load(tilted):
    block = tilted.rigid
    for race, name in enumerate(("inner", "outer")):
        assert block[f"{name}_pressure"].max() == approx(block["peak_pressure"][race], rel=1e-13)
        load = np.pi / 2 * block["peak_pressure"][race] * block["contact_half_width"][race]
        assert load == approx(block[f"{name}_slice_load"].max(), rel=1e-12)


def test_summary_of_a_tilted_roller_says_where_it_is_pressed_and_how_far(tilted):
    numbers, straight = tilted.summary()["rigid"], flexbearing.run(PLAIN).summary()["rigid"]
    for race in ("inner", "outer"):
        assert numbers["peak_pressure_azimuth_deg"][race] == approx(0.0, rel=0, abs=1e-9)
        assert numbers["peak_pressure_position_mm"][race] > 1.0
        assert abs(straight["peak_pressure_position_mm"][race]) < 0.3
        loads = tilted.rigid[f"{race}_slice_load"]
        carrying = loads[loads.max(axis=1).argmax()] > 3e-4 * loads.max()
        assert numbers["loaded_length_percent"][race] == approx(100 * carrying.mean(), rel=1e-12)
        assert numbers["peak_pressure_MPa"][race] > straight["peak_pressure_MPa"][race]
    page = text(tilted)
    assert "most pressed contacts, with stresses below the surface" in page
    assert "axial place of peak, inner " in page
    assert "static safety C_0/P_0" in page


def test_edge_stress_factor_of_the_life_raises_the_pressure_of_the_ends():
    settings = TILTED | {"accuracy.slices": 30}
    plain, raised = (
        flexbearing.run(PLAIN, settings | {"life.edge_stress": on}).rigid for on in (False, True)
    )
    factor = np.sqrt(edge_stress_factor(30))
    assert raised["inner_pressure"] == approx(plain["inner_pressure"] * factor, rel=1e-12)
    assert raised["peak_pressure"][1] == approx((plain["outer_pressure"] * factor).max(), rel=1e-12)
    assert raised["inner_load"] == approx(plain["inner_load"], rel=1e-12)


def test_half_spaces_answer_for_the_most_loaded_roller():
    whole = flexbearing.run(PLAIN, TILTED | {"bearing.contact": "half_space"}).rigid
    sliced = flexbearing.run(PLAIN, TILTED).rigid
    number, others = int(whole["whole_roller"]), np.arange(len(whole["inner_load"])) != whole["whole_roller"]
    for race, name in enumerate(("inner_pressure", "outer_pressure")):
        assert whole[name][others] == approx(sliced[name][others], rel=1e-12)
        assert whole[name].max() == approx(whole["peak_pressure"][race], rel=1e-12)
        cells = whole["whole_roller_pressure"][race].max(axis=0)
        ends = np.linspace(0, len(cells), whole[name].shape[1] + 1)
        for slice_, (first, last) in enumerate(itertools.pairwise(ends)):
            shared = cells[int(np.floor(first)) : int(np.ceil(last))]
            assert whole[name][number, slice_] == approx(shared.max(), rel=1e-12)


def test_static_safety_falls_with_the_load_and_that_of_pressure_with_its_square(tilted):
    block = tilted.rigid
    assert block["pressure_safety"] == approx((4e9 / block["peak_pressure"]) ** 2, rel=1e-12)
    double = flexbearing.run(PLAIN, {"operation.radial_load": "17.8 kN", "life.static_rating": "35.6 kN"})
    assert float(double["static_safety"]) == approx(2.0, rel=1e-12)
    loads = [
        float(flexbearing.run(PLAIN, {"operation.radial_load": f"{kn} kN"})["static_safety"])
        for kn in (5, 10)
    ]
    assert loads[0] / loads[1] == approx(2.0, rel=1e-12)


def test_static_safety_of_balls_is_that_of_the_load_on_their_ring():
    settings = {
        "life.static_rating": "60 kN",
        "operation.load.axial": "10 kN",
        "operation.load.radial_z": "8 kN",
    }
    block = flexbearing.run(CONFIGS / "harris218.toml", settings).rigid
    equivalent = 0.5 * 8 + 0.26 * 10  # X_0 and Y_0 at 40 deg: below F_r
    assert equivalent < 8
    assert float(block["static_safety"]) == approx(60 / 8, rel=1e-6)
    ceramic = {"materials.ball.youngs_modulus": "400 GPa", "life.dynamic_rating": "100 kN"}
    assert "static_safety" not in flexbearing.run(CONFIGS / "harris218.toml", ceramic).rigid


@pytest.mark.parametrize(
    ("file", "settings"),
    [("nu209", {}), ("nu209", TILTED), ("32207", {}), ("6209", {"materials.ball.youngs_modulus": "207 GPa"})],
    ids=["rollers", "tilted", "tapered", "balls"],
)
def test_effective_static_safety_is_that_of_the_pressure_where_the_rating_is_that_of_the_formula(
    file, settings
):
    """Formulas of C_0 are those of Hertz for 4000 and 4200 MPa, rounded."""
    block = flexbearing.run(CONFIGS / f"{file}.toml", settings).rigid
    assert float(block["effective_static_safety"]) == approx(block["pressure_safety"].min(), rel=0.025)


def test_effective_static_safety_goes_with_the_rating_and_the_largest_load():
    settings = {
        "life.static_rating": "60 kN",
        "operation.load.axial": "10 kN",
        "operation.load.radial_z": "8 kN",
    }
    block = flexbearing.run(CONFIGS / "harris218.toml", settings).rigid
    allowed = 5 * 60e3 / (16 * np.cos(np.radians(40)))
    assert float(block["effective_static_safety"]) == approx(allowed / block["contact_load"].max(), rel=1e-12)
    pair = {f"bearing.pair.{key}": value for key, value in (
        ("arrangement", "tandem"), ("distance", "40 mm"))}  # fmt: skip
    two = flexbearing.run(CONFIGS / "harris218.toml", settings | pair).rigid
    assert "static_safety" not in two
    assert float(two["effective_static_safety"]) == approx(allowed / two["contact_load"].max(), rel=1e-12)


def test_below_the_surface_of_rollers(tilted):
    block = tilted.rigid
    assert block["orthogonal_shear_stress"] == approx(block["peak_pressure"] / 4, rel=1e-12)
    assert block["orthogonal_shear_depth"] == approx(block["contact_half_width"] / 2, rel=1e-12)
    assert block["von_mises_stress"] / block["peak_pressure"] == approx(
        0.558, rel=0, abs=0.02
    )  # and friction
    assert block["subsurface_von_mises"].max(axis=(1, 2)) == approx(block["von_mises_stress"], rel=2e-3)
    worst = block["inner_pressure"].max(axis=1).argmax()
    friction = -block["inner_traction"][worst] / block["inner_load"][worst]
    assert block["subsurface_friction"][0] == approx(friction, rel=1e-12)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_shear_just_below_the_surface_balances_the_traction_of_the_roller(tilted, race):
    """Its sign is that of the traction: the field lies as its axis says, not mirrored."""
    block, number = tilted.rigid, ("inner", "outer").index(race)
    worst = block[f"{race}_pressure"].max(axis=1).argmax()
    share = block[f"{race}_traction"][worst] / block[f"{race}_load"][worst]  # of the raceway on the roller
    assert abs(share) > 1e-4
    width = np.diff(block["subsurface_position"][number])[0]
    sheared = block["subsurface_shear"][number, 0].sum() * width
    load = np.pi / 2 * block["peak_pressure"][number] * block["contact_half_width"][number]
    assert sheared / load == approx(share, rel=0.02)


@pytest.mark.parametrize("name", BALLS.values(), ids=BALLS)
def test_below_the_surface_of_balls(name):
    result = flexbearing.run(CONFIGS / name, BELOW)
    block, pressure = (
        result.rigid,
        np.array(list(result.summary()["rigid"]["peak_pressure_MPa"].values())) * 1e6,
    )
    assert block["pressure_safety"] == approx((4.2e9 / pressure) ** 3, rel=1e-12)
    assert np.all(
        (0.214 < block["orthogonal_shear_stress"] / pressure)
        & (block["orthogonal_shear_stress"] / pressure < 0.25)
    )
    assert block["subsurface_shear"].max(axis=(1, 2)) == approx(block["orthogonal_shear_stress"], rel=1e-3)
    assert np.all(
        (block["von_mises_stress"] / pressure > 0.557) & (block["von_mises_stress"] / pressure < 0.621)
    )
    assert "subsurface" in figures.pictures(result)


def test_stresses_below_are_solved_beside_others_in_a_study():
    settings = BELOW | {"operation.radial_load": "5 kN"}
    cases = [read_case(PLAIN, each) for each in (BELOW, settings)]
    found = answers(cases, ["von_mises_stress.inner"], lambda place: pytest.fail("a run of its own"))
    largest = [answer.numbers["von_mises_stress.inner"] for answer in found]
    assert largest[1] == approx(flexbearing.run(PLAIN, settings).rigid["von_mises_stress"][0] / 1e6, rel=1e-9)
    assert largest[0] != largest[1]


def test_without_being_asked_for_nothing_below_is_stored():
    assert not [name for name in flexbearing.run(PLAIN).rigid if "subsurface" in name or "mises" in name]


def test_overload_is_a_danger_of_its_own():
    result = flexbearing.run(PLAIN, {"life.static_rating": "4 kN"})
    assert "static-safety" in [note["code"] for note in result.dangers]


@pytest.mark.slow
def test_pictures_show_the_stored_pressures(tilted, tmp_path):
    drawn, block = pictures(tilted), tilted.rigid
    assert {"pressure_map", "pressure_along", "subsurface"} <= set(drawn)
    meshes = [axes.collections[0] for axes in drawn["pressure_map"].axes[:2]]
    for mesh, name in zip(meshes, ("inner_pressure", "outer_pressure"), strict=True):
        shown = np.ma.asarray(mesh.get_array())
        assert shown.max() == approx(block[name].max() / 1e6, rel=6e-6)
        assert (shown > 0).sum() == (block[name] > 0).sum()
    stairs = drawn["pressure_along"].axes[0].get_lines()[0].get_xydata()
    worst = block["inner_pressure"].max(axis=1).argmax()
    assert stairs[::2, 1] == approx(block["inner_pressure"][worst] / 1e6, rel=1e-12)
    length = tilted.attributes["case_si"]["bearing"]["roller"]["length"]
    assert stairs[[0, -1], 0] == approx(np.array([-500, 500]) * length, rel=1e-9)
    assert all(path.stat().st_size > 1000 for path in write_figures(tilted, tmp_path))


@pytest.mark.slow
def test_curves_of_rigid_and_flexible_rings_stand_beside_each_other():
    settings = {"accuracy.structure": "smeared", "accuracy.slices": 10, "inner.kind": "rigid"} | BELOW
    result = flexbearing.run(CONFIGS / "mao2016.toml", settings)
    labels = [line.get_label() for line in pictures(result)["pressure_along"].axes[0].get_lines()[:2]]
    assert labels == ["rigid rings", "flexible rings"]
