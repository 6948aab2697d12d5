"""Tapered roller bearings as cases: what a run, a study and a report of them have."""

import numpy as np
import pytest
from pytest import approx

from flexbearing import BadCase, api
from flexbearing.build.tapered_bearing import bearing
from flexbearing.families import FAMILIES
from flexbearing.life import tapered_lives
from flexbearing.report.html import html, of_result
from flexbearing.runs.validate import require_possible
from quasidynamic.outcome.life_factors import modification_factor
from quasidynamic.outcome.tapered_life import InclinedRow, axial_factor, load_limit, tapered_dynamic_load
from tests.places import CONFIGS
from tests.reference.modified_slices import modification

CASE = CONFIGS / "32207.toml"
CHECKED = {  # the bearing of the independent program of tests/quasidynamic/test_tapered.py
    "bearing.rollers": "19", "bearing.pitch_diameter": "71 mm", "bearing.cup_angle": "15.6422 deg",
    "bearing.cone_angle": "11.6462 deg", "bearing.roller.diameter": "10.5 mm",
    "bearing.roller.length": "15.5 mm", "bearing.rib.angle": "12.2434 deg",
    "bearing.rib.end_radius": "150.33 mm",
}  # fmt: skip
LIFE = ["life.lubrication=a_ISO", "life.cleanliness=grease, normal cleanliness", "lubricant.oil=ISO VG 100",
        "lubricant.inlet_temperature=60 degC"]  # fmt: skip


def read(settings=()):
    return api.read_case(CASE, list(settings))


@pytest.fixture(scope="module")
def result():
    return api.run(CASE, LIFE)


def require_balance(values, model):
    """Rollers are in balance, and the ring under its load of 4 kN along x and 8 kN along z."""
    cone, cup, rib = model.cone_angle, model.cup_angle, model.rib
    inner, outer, axial = values["inner_load"], values["outer_load"], values["rib_load"]
    size = 1e-9 * outer.max()
    assert inner * np.sin(cone) + axial * np.cos(rib.angle) == approx(outer * np.sin(cup), abs=size)
    across = outer * np.cos(cup) - inner * np.cos(cone) + axial * np.sin(rib.angle)
    assert across - values["centrifugal_force"] == approx(0.0, abs=size)
    assert (outer * np.sin(cup)).sum() == approx(4000.0, rel=1e-9)
    assert outer * np.cos(cup) @ np.cos(values["roller_azimuth"]) == approx(8000.0, rel=1e-9)


def test_balances_hold_for_the_stored_loads(result):
    values, case = result.rigid, read()
    require_balance(values, bearing(case))
    outer = values["outer_load"]
    width = case.bearing.roller.length / case.accuracy.slices
    assert values["outer_slice_load"].sum(1) * width == approx(outer, rel=1e-12)
    levers = (values["outer_slice_load"] - values["inner_slice_load"]) @ values["slice_position"] * width
    levers += values["rib_load"] * bearing(case).rib.lever
    assert levers - values["gyroscopic_moment"] == approx(0.0, abs=1e-11 * outer.max())
    assert values["ring_load"][:3] == approx([4000.0, 0.0, 8000.0], abs=1e-6)


def test_heat_of_the_ribs_is_friction_times_sliding(result):
    values = result.rigid
    assert values["rib_heat"] == approx(0.05 * values["rib_load"] * abs(values["rib_sliding"]), rel=1e-12)
    assert float(result["rib_heat"].to("W")) == approx(values["rib_heat"].sum(), rel=1e-12)


def test_pressure_of_a_slice_is_that_of_its_cones(result):
    """On a plane through the middle of the contact, normal to it, both are circles."""
    model, values = bearing(read()), result.rigid
    middle = values["inner_slice_load"][0, 19:21].mean()
    roller = model.roller.diameter / 2 / np.cos(model.taper)
    cone = (model.pitch_diameter / 2 - roller * np.cos(model.cone_angle)) / np.cos(model.cone_angle)
    modulus = 210e9 / (1 - 0.3**2)
    pressure = np.sqrt(middle * modulus / (2 * np.pi) * (1 / roller + 1 / cone))
    assert values["inner_pressure"][0, 19:21].mean() == approx(pressure, rel=1e-4)


def test_lives_are_those_of_the_ratings(result):
    values, case = result.rigid, read()
    row = InclinedRow.of(bearing(case))
    assert values["dynamic_rating"] == approx(row.dynamic_rating, rel=1e-12)
    assert values["equivalent_load"] == approx(0.4 * 8000 + axial_factor(row.contact_angle) * 4000, rel=1e-9)
    inner, outer = values["raceway_life"]
    assert values["life_L10"] ** (-9 / 8) == approx(inner ** (-9 / 8) + outer ** (-9 / 8), rel=1e-12)
    a_iso = result.attributes["life"]["rigid"]["factors"][-1]["value"]
    assert values["modified_life"] == approx(a_iso * values["life_L10"], rel=1e-12)


def test_life_by_rating_is_that_of_a_catalogue():
    found = api.run(CASE, ["life.loads=rating"])
    expected = (found.rigid["dynamic_rating"] / found.rigid["equivalent_load"]) ** (10 / 3)
    assert float(found["modified_life"].to("Mrev")) == approx(expected, rel=1e-9)


def test_ratings_of_the_independent_program():
    row = InclinedRow.of(bearing(read(f"{key}={value}" for key, value in CHECKED.items())))
    assert row.diameter_ratio == approx(0.14241, abs=5e-6)
    assert row.dynamic_rating == approx(89.99e3, rel=1e-3)  # whose f_c has 207.9 for 207.78
    assert row.static_rating == approx(112.36e3, rel=1e-4)


def test_a_iso_of_slices():
    settings = [*LIFE, "life.modification=slices"]
    values, case = api.run(CASE, settings).rigid, read(settings)
    own, row = tapered_lives.rated(case), InclinedRow.of(bearing(case))
    width = case.bearing.roller.length / case.accuracy.slices
    expected = modification(
        values["inner_slice_load"] * width,
        values["outer_slice_load"] * width,
        row.raceway_capacity(own.dynamic),
        lambda load: modification_factor(own.kappa, own.fatigue_share / load).value,
        np.cos(row.contact_angle),
    )
    assert values["modified_life"] == approx(expected * values["life_L10"], rel=1e-9)


# e and Y as makers print them and the angles of ISO 355, from memory: no catalogue was at hand
@pytest.mark.parametrize(
    ("angle", "limit", "factor"),
    [
        pytest.param(14 + 2 / 60 + 10 / 3600, 0.37, 1.6, id="32207"),
        pytest.param(11 + 51 / 60 + 35 / 3600, 0.31, 1.9, id="30307"),
        pytest.param(28 + 48 / 60 + 39 / 3600, 0.83, 0.72, id="31307"),
        pytest.param(12 + 57 / 60 + 10 / 3600, 0.35, 1.7, id="32310"),
        pytest.param(15 + 38 / 60 + 32 / 3600, 0.43, 1.4, id="30210"),
    ],
)
def test_factors_of_a_catalogue_follow_from_the_angle(angle, limit, factor):
    cup = np.radians(angle)
    assert load_limit(cup) == approx(limit, abs=0.011)
    assert axial_factor(cup) == approx(factor, rel=0.035)
    at_limit = tapered_dynamic_load(1.0, load_limit(cup) * (1 + 1e-9), cup)
    assert at_limit.value == approx(1.0, rel=1e-8)  # nothing jumps at e


def test_rows_of_a_table_are_those_of_runs(result):
    (answer,) = FAMILIES["tapered_roller"].rows()([read(LIFE)], ["max_rib_load", "life_L10", "stiffness_zz"])
    for name, number in answer.numbers.items():
        assert number == approx(float(result[name]), rel=1e-12), name
    assert answer.status == "converged"


def test_free_tilt_turns_the_ring_and_shortens_the_life(result):
    free = api.run(CASE, [*LIFE, "operation.tilt=free"])
    assert free.rigid["ring_load"][3:] == approx([0.0, 0.0], abs=1e-6)
    assert abs(free.rigid["ring_displacement"][3]) > 1e-3
    assert free.rigid["life_L10"] < 0.3 * result.rigid["life_L10"]


def test_what_is_left_out_is_noted(result):
    assert "rollers-in-pure-rolling" in [note["code"] for note in result.attributes["notes"]]
    page = html(of_result(result))
    assert "friction of the raceways, oil film and cage are left out" in page
    assert "rib load" in page


OILED = ["outputs.friction=true", "lubricant.oil=ISO VG 100", "lubricant.inlet_temperature=60 degC",
         "lubricant.oil_fraction=0.05"]  # fmt: skip
_CAGE = {"guidance": "outer", "pocket_friction": 0.05, "thickness": "2 mm",
         "land_diameter": "60 mm", "land_width": "3 mm", "land_clearance": "0.4 mm"}  # fmt: skip
CAGE = [f"bearing.cage.{name}={value}" for name, value in _CAGE.items()]
ROUGH = [f"bearing.roughness.{name}=0.2 um" for name in ("roller", "inner_raceway", "outer_raceway")]


def test_losses_of_all_causes_are_the_power_of_the_rings():
    found = api.run(CASE, [*OILED, *ROUGH, *CAGE])
    values, case = found.rigid, read()
    names = ("sliding", "rolling", "rib", "drag", "pocket", "land", "churning", "transport")
    causes = [float(values[f"loss_{cause}"]) for cause in names]
    assert min(causes[:6]) > 0
    assert causes[6] == 0.0  # without lubricant.churning_gap
    assert abs(causes[7]) < 1e-6 * sum(causes)
    assert float(found["driving_power"]) == approx(sum(causes), rel=1e-9)
    assert causes[2] == approx(values["rib_heat"].sum(), rel=1e-12)
    assert values["ring_torque"][0] * case.operation.inner_speed == approx(sum(causes), rel=1e-9)
    film = values["outer_film"]
    least = film[film > 0].min() / (0.2e-6 * np.sqrt(2))
    assert values["film_ratio"][1].min() == approx(least, rel=1e-12)
    (answer,) = FAMILIES["tapered_roller"].rows()(
        [read([*OILED, *ROUGH, *CAGE])], ["power_loss.total", "minimum_film.inner"]
    )
    assert answer.numbers["power_loss.total"] == approx(sum(causes), rel=1e-12)
    assert "driving_power" not in api.run(CASE).rigid


def test_slip_of_rollers_and_cage_is_that_of_their_balance():
    free, guided = (api.run(CASE, [*OILED, *cage]) for cage in ([], CAGE))
    slip = float(free["cage_slip"].to("%"))
    assert -1.0 < slip < 0.0  # the rib drives the rollers ahead
    assert float(guided["cage_slip"].to("%")) > slip  # a land at rest brakes them
    assert np.abs(free.rigid["roller_slip"]).max() < 0.02
    pockets = free.rigid["cage_force"]
    assert float(free["max_pocket_force"].to("N")) == approx(np.abs(pockets).max(), rel=1e-12)
    assert pockets.min() < 0 < pockets.max()  # some rollers push the cage, it pushes the others
    page = html(of_result(free))
    assert "have no part of the slip" in page
    assert "cage slip" in page


PAIR = ["bearing.pair.arrangement=back_to_back", "bearing.pair.distance=40 mm"]


def test_pairs_carry_loads_of_any_sign_and_name_what_unloads_a_row():
    pair = [*PAIR, "bearing.pair.preload=2 kN"]
    found = api.run(CASE, [*pair, "operation.load.axial=-1 kN"])
    values, case = found.rigid, read(pair)
    assert values["row_load"].sum(0) == approx([-1000.0, 0.0, 8000.0], abs=1e-6)
    assert values["roller_row"].tolist() == [0] * 17 + [1] * 17
    unloads = float(found["unloading_force"].to("N"))
    pure = [*pair, "operation.load.radial_z=0 N", "operation.inner_speed=0 rpm"]
    touching = api.run(CASE, [*pure, f"operation.load.axial={unloads} N"]).rigid["row_load"]
    assert touching[:, 0] == approx([unloads, 0.0], abs=1e-6 * unloads)
    alone = InclinedRow.of(bearing(read()))
    both = InclinedRow.of(bearing(case))
    assert both.dynamic_rating == approx(2 ** (7 / 9) * alone.dynamic_rating, rel=1e-12)
    assert both.static_rating == approx(2 * alone.static_rating, rel=1e-12)
    assert "induced_thrust" not in values


def test_two_rows_that_share_a_load_live_as_long_as_the_ratings_say():
    """L = (2^(7/9)/2)^4 = 2^(-8/9) of one row with half of the load."""
    loads = ["operation.load.radial_z=0 N", "operation.load.axial=8 kN", "operation.inner_speed=1 rpm"]
    both = api.run(CASE, ["bearing.pair.arrangement=tandem", "bearing.pair.distance=40 mm", *loads])
    alone = api.run(CASE, [*loads, "operation.load.axial=4 kN"])
    assert float(both["life_L10"]) == approx(2 ** (-8 / 9) * float(alone["life_L10"]), rel=1e-9)


def test_equivalent_loads_of_rows_against_each_other():
    cup = np.radians(14.0)
    small, large = (tapered_dynamic_load(1.0, axial, cup, opposed=True) for axial in (0.1, 2.0))
    assert small.value == approx(1 + 0.45 / np.tan(cup) * 0.1, rel=1e-12)
    assert large.value == approx(0.67 + 0.67 / np.tan(cup) * 2.0, rel=1e-12)


REFUSED = {
    "rows that overlap": (
        [*PAIR[:1], "bearing.pair.distance=10 mm", "bearing.pair.preload=1 kN"],
        "at least the",
    ),
    "tandem without thrust": (
        ["bearing.pair.arrangement=tandem", "bearing.pair.distance=40 mm", "operation.load.axial=0 N"],
        "the cone leaves the cup",
    ),
    "pair without preload": (PAIR, "preload is missing"),
    "friction without oil": (["outputs.friction=true"], "lubricant is missing"),
    "film law without friction": (
        [*OILED[1:3], "lubricant.film=dowson_toyoda"],
        "left out but with outputs.friction",
    ),
    "oil beyond its data": ([*OILED, "lubricant.inlet_temperature=338 degC"], "outside 0 to 200 degC"),
    "oil without a fraction": (OILED[:3], "oil_fraction"),
    "friction of rings at rest": ([*OILED, "operation.inner_speed=0 rpm"], "another one than"),
    "cage without friction": (["bearing.cage.guidance=rollers", *CAGE[1:3]], "outputs.friction = true"),
    "cage as thick as rollers": ([*OILED, *CAGE, "bearing.cage.thickness=9 mm"], "below 8.8 mm"),
    "land beyond the rollers": ([*OILED, *CAGE, "bearing.cage.land_diameter=80 mm"], "beside the rollers"),
    "asperities without roughness": ([*OILED, "lubricant.mixed.boundary_friction=0.1"], "roughness"),
    "cone that leaves its cup": (["operation.load.axial=0 N"], "the cone leaves the cup"),
    "moment on a held ring": (["operation.load.moment_y=1 N m"], 'it belongs to operation.tilt = "free"'),
    "rib beside the end": (["bearing.rib.angle=5 deg"], "must be within the end of the roller"),
    "rollers that touch": (["bearing.rollers=20"], "or they touch"),
    "taper the wrong way": (["bearing.cone_angle=15 deg"], "rollers taper towards the apex"),
    "load and place": (["operation.displacement.axial=1 um"], "give one of the two"),
}


@pytest.mark.parametrize(("settings", "why"), REFUSED.values(), ids=REFUSED)
def test_impossible_cases_are_refused(settings, why):
    with pytest.raises(BadCase, match=why):
        require_possible(read(settings), FAMILIES["tapered_roller"])


def test_too_small_a_thrust_is_no_solution():
    found = api.run(CASE, ["operation.load.axial=1.9 kN"])
    assert found.attributes["status"] == "not solved"
    assert "above 2006 N are needed" in found.attributes["message"]
