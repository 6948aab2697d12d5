"""Two rows of cylindrical rollers on common rings, from the case to the result."""

from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import run
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.derivatives.rollers import sensitivities
from flexbearing.life.roller_lives import rated
from flexbearing.runs.rows import answers
from flexbearing.studies.rings import rings
from quasidynamic import solve_many

PLANET = Path("configs/planet_helical.toml")
UNTOOTHED = {f"outer.tooth_{each}": "" for each in ("azimuths", "tangential", "radial", "axial", "radius")}
CASE, LOAD = Path("configs/nu209.toml"), 4450.0  # [N]
ROWS = {"bearing.second_row.distance": "25 mm"}
DOUBLE = {**ROWS, "operation.radial_load": "8900 N"}
TILTED = {**ROWS, "operation.tilt": "free", "operation.moment": "50 N m"}
LAND = {
    "bearing.cage.guidance": "outer",
    "bearing.cage.land_diameter": "74 mm",
    "bearing.cage.land_width": "4 mm",
    "bearing.cage.land_clearance": "0.4 mm",
}
OF_RATINGS = {"life.dynamic_rating": "", "life.static_rating": "", "life.capacity": "iso281"}


def written(settings):
    return [f"{key}={value}" for key, value in settings.items()]


def case(**settings):
    return read_case(CASE, written(settings))


@cache
def result(*settings):
    return run(CASE, written(dict(settings)))


def solved(**settings):
    return result(*settings.items())


def test_two_equal_rows_are_two_bearings_under_half_the_load():
    one, two = solved().rigid, solved(**DOUBLE).rigid
    for name in ("inner_load", "outer_load", "cage_force", "roller_speed", "inner_film"):
        assert two[name] == approx(np.tile(one[name], 2), rel=1e-9, abs=1e-9 * np.abs(one[name]).max())
    assert two["cage_slip"] == approx(float(one["cage_slip"]), rel=1e-6)
    assert two["row_load"] == approx(np.array([[0, LOAD]] * 2), abs=1e-9 * LOAD)
    assert two["row_load_factor"] == approx(1.0, rel=1e-9)
    assert two["driving_torque"] == approx(2 * one["driving_torque"], rel=1e-9)
    assert two["row_loss"].sum() == approx(two["loss_sliding"] + two["loss_rolling"], rel=1e-9)
    assert two["row_loss"][0] == approx(two["row_loss"][1], rel=1e-9)
    assert two["roller_row"].tolist() == [0] * 14 + [1] * 14
    assert "row_load" not in one


def test_lives_and_ratings():
    """L_10 = L (1 + 1)^(-8/9) of two rows that carry a load each; C_r by 2^(7/9), C_0r by 2."""
    one, two = solved(**OF_RATINGS), solved(**DOUBLE, **OF_RATINGS)
    for name in ("life_L10", "raceway_life", "reference_life"):
        assert two.rigid[name] == approx(one.rigid[name] * 2 ** (-8 / 9), rel=1e-6)
    first, both = (
        rated(each, roller_bearing.parts(each)).rating
        for each in (case(**OF_RATINGS), case(**DOUBLE, **OF_RATINGS))
    )
    for name, factor in (("dynamic_rating", 2 ** (7 / 9)), ("static_rating", 2.0)):
        assert both(name).value == approx(factor * first(name).value, rel=1e-12)


@pytest.mark.parametrize("direction", [0.0, 90.0, 200.0])
def test_rows_share_load_and_couple(direction):
    """What rows carry is the load; their moments about the middle are the couple but for their own."""
    block = solved(**TILTED, **{"operation.tilt_direction": f"{direction} deg"}).rigid
    angle = np.radians(direction)
    assert block["row_load"].sum(0) == approx([0.0, LOAD], abs=1e-9 * LOAD)
    assert block["ring_moment"] == approx([50 * np.cos(angle), 50 * np.sin(angle)], abs=1e-7)
    by_rows = 0.0125 * (block["row_load"][1] - block["row_load"][0])[::-1]  # on dz/dx, dy/dx
    own = block["ring_moment"] - by_rows
    assert 0 < own @ [np.cos(angle), np.sin(angle)] < 0.25 * 50
    loads = np.hypot(*block["row_load"].T)
    assert block["row_load_factor"] == approx(loads.max() / (LOAD / 2), rel=1e-12)


def test_a_ring_that_is_free_tilts_between_unlike_rows():
    """Without a moment; the stiffer row carries more where the ring is held, and half where it is not."""
    unlike = {**ROWS, "bearing.second_row.clearance": "10 um"}
    free, held = (solved(**unlike, **{"operation.tilt": tilt}).rigid for tilt in ("free", "fixed"))
    assert free["ring_tilt"][0] > 1e-4
    assert free["ring_moment"] == approx([0.0, 0.0], abs=1e-7)
    assert held["ring_moment"][0] < -1.0
    assert held["row_load_factor"] > 1.2 > 1.05 > free["row_load_factor"] > 1


def test_rows_far_apart_carry_half_the_load_and_a_couple_over_their_distance():
    far = {**TILTED, "bearing.second_row.distance": "2500 mm", "operation.moment": "2500 N m"}
    block = solved(**far).rigid
    assert block["row_load"][:, 1] == approx([LOAD / 2 - 1000, LOAD / 2 + 1000], rel=1e-3)


def test_a_row_with_room_carries_nothing_and_leaves_the_other_its_loads():
    """At a speed so low that the idle rollers hardly hold back the cage of both rows."""
    slow = {"operation.inner_speed": "1 rpm", "operation.gravity": "0 m/s^2"}
    loose = solved(**ROWS, **slow, **{"bearing.second_row.clearance": "300 um"}).rigid
    one = solved(**slow).rigid
    assert loose["inner_load"][:14] == approx(one["inner_load"], rel=1e-9, abs=1e-9 * LOAD)
    assert loose["inner_load"][14:] == approx(0.0, abs=1e-5)
    assert loose["row_load_factor"] == approx(2.0, rel=1e-9)


def test_studies_solve_rows_side_by_side_as_one_by_one():
    settings = [
        {**TILTED, "operation.moment": f"{moment} N m", "bearing.second_row.clearance": f"{room} um"}
        for moment, room in ((50, 0), (0, 0), (20, 5), (0, 5))
    ]
    models = [roller_bearing.bearing(case(**each)) for each in settings]
    together = solve_many(models)
    for model, state in zip(models, together, strict=True):
        assert state.loads == approx(model.solve().loads, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        ({"bearing.second_row.distance": "5 mm"}, "distance"),
        ({**ROWS, "bearing.second_row.clearance": "60 mm"}, "clearance"),
        ({**ROWS, **LAND, "bearing.cage.centre": "free"}, "second_row"),
        ({**ROWS, "bearing.form_error.roller_diameters": '["1 um", "0 um"]'}, "roller_diameters"),
    ],
)
def test_impossible_rows(settings, named):
    with pytest.raises(BadCase, match=named):
        case(**settings)


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        ({"outer.kind": "squirrel_cage"}, "outer"),
        ({"outer.support": "foundation", "outer.foundation_radial": "100 N/mm^3", **UNTOOTHED}, "outer"),
        ({"accuracy.structure": "solid"}, "structure"),
        ({"coupling.structure": "full", "coupling.method": "anderson"}, "structure"),
        ({"outer.width": "60 mm"}, "width"),
        ({"outer.tooth_axial": '["1 kN"]'}, "tooth_axial"),
    ],
)
def test_impossible_rings_of_two_rows(settings, named):
    """Those that are known under one row only are refused by name."""
    with pytest.raises(BadCase, match=named):
        read_case(PLANET, written(settings))


def test_axial_tooth_forces_must_balance():
    with pytest.raises(BadCase, match="move along its axis"):
        run(PLANET, written({"outer.tooth_axial": '["1 kN", "-2 kN"]'}))


# two rows Z 14, D 16, L 17, d_m 83 mm at +-11 mm on a rim 99/115 x 42 mm, 40 um, teeth at 62 mm; see below
RIM = {
    "bearing.rollers": "14",
    "bearing.outer_raceway_diameter": "99 mm",
    "bearing.clearance": "40 um",
    "bearing.roller.diameter": "16 mm",
    "bearing.roller.length": "17 mm",
    "bearing.roller.profile": "crowned",
    "bearing.roller.drop": "",
    "bearing.roller.straight_length": "0 mm",
    "bearing.roller.crown_radius": "6020.83 mm",
    "bearing.cage.thickness": "5 mm",
    "bearing.second_row.distance": "22 mm",
    "outer.thickness": "8 mm",
    "outer.width": "42 mm",
    "outer.tooth_tangential": '["12 kN", "-12 kN"]',
    "outer.tooth_radial": '["-4.37 kN", "-4.37 kN"]',
    "outer.tooth_radius": "62 mm",
    "operation.radial_load": "24 kN",
    "operation.outer_speed": "5 rpm",
    "accuracy.slices": "40",
}
SPUR = {
    "operation.tilt": "fixed",
    "operation.moment": "0 N m",
    "operation.tilt_direction": "0 deg",
    "outer.tooth_axial": "",
}
HELICAL = {"operation.moment": "316.2 N m", "outer.tooth_axial": '["2.55 kN", "-2.55 kN"]'}


@pytest.mark.parametrize(
    ("teeth", "loads", "across"),
    [
        (SPUR, [2905.6, 2880.4, 2681.1, 2942.5, 1682.3, *[0] * 5, 1682.3, 2942.5, 2681.1, 2880.4], 0.0),
        (HELICAL, [2993.8, 2471.1, 1500.4, 12.4, *[0] * 6, 4744.5, 5051.8, 4113.4, 3561.1], 12053.7),
    ],
)
def test_elastic_rim_under_two_rows(teeth, loads, across):
    """Loads within 2 % of the largest of those of an independent program, a frame of 364 straight beams.

    Its rows are in one potential with the rim; helical teeth load them askew, each on its side.
    """
    block = run(PLANET, written({**RIM, **teeth})).flexible
    found = block["inner_load"].reshape(2, 14)
    assert found[0] == approx(loads, abs=0.02 * max(loads))
    assert found[1] == approx(np.take(found[0], -np.arange(14)), abs=1e-3 * max(loads))
    assert block["row_load"][1] == approx([across, 12e3], abs=0.02 * 12e3)
    assert block["row_load_factor"] == approx(np.hypot(across, 12e3) / 12e3, rel=5e-3)


def test_a_planet_with_helical_teeth():
    """The couple of the teeth over the distance of the rows makes 1.126; the rows hold 15 % of it alone."""
    result = run(PLANET)
    assert result.attributes["status"] == "converged"
    assert 1.126 > result.rigid["row_load_factor"] > 1.10
    assert result.flexible["row_load_factor"] == approx(1.109, abs=2e-3)
    assert "unbalanced-teeth" not in {note["code"] for note in result.attributes["notes"]}


GUIDED = {"operation.tilt": "fixed", "operation.moment": "0 N m", "operation.tilt_direction": "0 deg"}
CARRIER = GUIDED | {f"operation.carrier.{name}": value for name, value in {
    "twist": "0.2 mrad", "radius": "302.6 mm", "pin_length": "242.08 mm"}.items()}  # fmt: skip


@pytest.mark.parametrize(("settings", "slope"), [
    ({}, 0.25), ({"operation.carrier.load": "717.2 kN"}, 0.125),
    ({"operation.carrier.load": "358.6 kN", "operation.misalignment": "-0.05 mrad"}, 0.2),
])  # fmt: skip
def test_torsion_of_the_carrier_tilts_the_pin(settings, slope):
    """Ends of the pin part by twist times radius, under half of the stated load by half as much."""
    turned = run(PLANET, written(CARRIER | settings))
    tilted = run(PLANET, written(GUIDED | {"operation.misalignment": f"{slope} mrad"}))
    for block in ("rigid", "flexible"):
        rows, same = (np.asarray(getattr(each, block)["row_load"]) for each in (turned, tilted))
        assert rows == approx(same, rel=1e-9, abs=1e-3)
    assert turned.flexible["row_load_factor"] > 1.1


def test_a_carrier_tilts_no_planet_that_is_free_and_none_across_its_load():
    for change in ({"operation.tilt": "free"}, {"operation.tilt_direction": "90 deg"}):
        with pytest.raises(BadCase, match="carrier"):
            read_case(PLANET, written(CARRIER | change))


@pytest.mark.slow
def test_rows_of_another_distance_press_another_rim():
    """Side by side they shared the rim of the first one: the largest load was 3 % off."""
    text, keys = "flexible.max_roller_load [N]", ("bearing.second_row.distance", "bearing.clearance")
    places = product(("100 mm", "130 mm"), ("120 um", "130 um"))
    settings = [written(dict(zip(keys, each, strict=True))) for each in places]
    cases = [read_case(PLANET, each) for each in settings]
    found = answers(cases, [text], lambda place: pytest.fail("has a run of its own"))
    for alone, answer in zip(settings, found, strict=True):
        assert answer.numbers[text] == approx(run(PLANET, alone).flexible["outer_load"].max(), rel=1e-4)
    assert rings(cases[0]) == rings(cases[1])
    assert rings(cases[0]) != rings(cases[2])


@pytest.mark.parametrize(
    ("key", "value", "unit"),
    [
        pytest.param("bearing.second_row.distance", 100.0, "mm", marks=pytest.mark.slow),
        ("operation.tilt_direction", 80.0, "deg"),
    ],
)
def test_derivatives_are_those_of_planets_solved_again(key, value, unit):
    """The distance moves the bands on the rim, whose nodes follow."""
    aside = ["operation.tilt_direction=80 deg"]
    found = sensitivities(read_case(PLANET, aside), ["row_load_factor"], [key])["row_load_factor", key]
    ends = [
        float(run(PLANET, [*aside, f"{key}={value * share} {unit}"]).flexible["row_load_factor"])
        for share in (0.999, 1.001)
    ]
    assert found.slope == approx((ends[1] - ends[0]) / (2e-3 * value), rel=2e-3)
