"""Two rows of angular-contact balls on common rings, from the case to the result."""

import itertools
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import run
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.life import ball_lives
from quasidynamic.outcome.ball_life import ball_reference_life
from quasidynamic.outcome.life_factors import BALLS, modification_factor

CASE = Path("configs/rivera2021_7008.toml")
RATING = {"life.dynamic_rating": "18 kN", "life.static_rating": "15 kN"}
DISTANCE = {"bearing.pair.distance": "15 mm"}
TANDEM = {"bearing.pair.arrangement": "tandem", **DISTANCE}
PRESSED = {"bearing.pair.arrangement": "back_to_back", "bearing.pair.preload": "200 N", **DISTANCE}


def case(**settings):
    return read_case(CASE, settings)


@cache
def result(*settings):
    return run(CASE, dict(settings))


def solved(**settings):
    return result(*settings.items())


def test_rows_carry_the_load_together():
    load = {
        "operation.load.axial": "300 N",
        "operation.load.radial_y": "-100 N",
        "operation.load.radial_z": "400 N",
    }
    block = solved(**PRESSED, **load).rigid
    assert block["row_load"].sum(0) == approx(block["ring_load"][:3], abs=1e-9 * 400)
    assert block["row_load"][0, 0] > 300  # the other presses back
    assert block["row_load"][1, 0] < 0
    balls = len(block["ball_azimuth"]) // 2
    assert block["ball_row"].tolist() == [0] * balls + [1] * balls


def test_tandem_rows_have_the_life_of_two_bearings():
    """L_10 = L (1 + 1)^(-9/10); the load that has this life by 2^0.7 C_r is twice that of one row."""
    one = solved(**RATING, **{"operation.load.axial": "500 N"})
    two = solved(**RATING, **TANDEM, **{"operation.load.axial": "1000 N"})
    assert two.rigid["life_L10"] == approx(one.rigid["life_L10"] * 2**-0.9, rel=1e-9)
    assert two.rigid["raceway_life"] == approx(one.rigid["raceway_life"] * 2**-0.9, rel=1e-9)
    assert two.rigid["stiffness_matrix"][0, 0] == approx(2 * one.rigid["stiffness_matrix"][0, 0], rel=1e-9)
    loads = []
    for found, settings in ((one, RATING), (two, {**RATING, **TANDEM})):
        lives = ball_lives.ReferenceLives(float(found.rigid["life_L10"]), found.rigid["raceway_life"], None)
        loads.append(ball_lives.rated(case(**settings)).reference_load(lives.basic / 1e6))
    assert loads[1] == approx(2 * loads[0], rel=1e-9)
    assert "unloading_force" not in two.rigid


OIL = {
    "life.lubrication": "a_ISO", "life.cleanliness": "oil, in-line filter, -/19/16",
    "lubricant.oil": "ISO VG 32", "lubricant.inlet_temperature": "50 degC",
}  # fmt: skip


def a_iso(way, **settings):
    found = solved(**RATING, **OIL, **settings, **{"life.modification": way})
    (factor,) = found.attributes["life"]["rigid"]["factors"]
    return factor["value"]


@pytest.mark.parametrize("settings", [{}, TANDEM], ids=["one", "tandem"])
def test_rows_that_carry_the_same_have_the_a_iso_of_the_bearing(settings):
    load = {"operation.load.radial_z": "3 kN", "operation.load.axial": "3 kN"}
    once = a_iso("bearing", **settings, **load)
    assert 0.2 < once < 20
    assert a_iso("rows", **settings, **load) == approx(once, rel=1e-9)


def test_rows_that_do_not_have_each_their_own():
    ratios = []
    for axial in (0, 250, 500, 1000):
        settings = {**PRESSED, "bearing.pair.preload": "1 kN", "operation.load.axial": f"{axial} N"}
        ratios.append(a_iso("rows", **settings) / a_iso("bearing", **settings))
    assert ratios[0] == approx(1.0, rel=1e-9)
    assert all(after < before for before, after in itertools.pairwise(ratios))
    found, own = solved(**RATING, **settings), ball_lives.rated(case(**RATING, **OIL, **settings))
    rows = np.split(found.rigid["contact_load"], 2, axis=1)
    lives = [ball_reference_life(row, ball_lives.row(case()), (1.0, 0.0), 18e3) for row in rows]
    shares = [own.fatigue_share / 2 / (18e3 * life ** (-1 / 3)) for life in lives]
    each = [
        modification_factor(own.kappa, share, BALLS).value * life
        for share, life in zip(shares, lives, strict=True)
    ]
    basic, modified = (sum(life ** (-10 / 9) for life in all_of) ** -0.9 for all_of in (lives, each))
    assert a_iso("rows", **settings) == approx(modified / basic, rel=1e-9)


def test_rows_far_apart_share_a_couple():
    """Held straight, each carries half the radial force; a couple is a pair of forces over their distance."""
    far = {**PRESSED, "bearing.pair.distance": "2000 mm", "operation.load.axial": "0 N"}
    free = {"operation.displacement.tilt_y": ""}
    both = solved(**far, **free, **{"operation.load.moment_y": "-400 N m"})
    assert both.rigid["row_load"][:, 2] == approx([-200, 200], rel=0.03)


def test_play_between_rows():
    """Rows that do not press each other have an end play, and the axial load unloads one at once."""
    play = {**TANDEM, "bearing.pair.arrangement": "face_to_face", "bearing.pair.offset": "-4 um"}
    block = solved(**play).rigid
    assert block["end_play"] == approx(8e-6, rel=1e-9)
    assert block["unloading_force"] == 0.0
    assert (block["contact_load"][0].reshape(2, -1) > 0).any(axis=1).tolist() == [False, True]


def test_contact_angles_are_towards_the_shoulder_of_the_row():
    block = solved(**PRESSED, **{"operation.load.axial": "0 N"}).rigid
    angles = block["contact_angle"].reshape(2, 2, -1)
    assert angles[:, 1] == approx(angles[:, 0], rel=1e-9)
    assert (angles > 0).all()
    assert np.abs(block["ring_displacement"]).max() < 1e-12


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        ({"bearing.pair.arrangement": "back_to_back", **DISTANCE}, "preload"),
        ({**PRESSED, "bearing.pair.offset": "1 um"}, "offset"),
        ({**PRESSED, "bearing.pair.distance": "5 mm"}, "distance"),
        ({**TANDEM, "operation.load.axial": "0 N", "operation.preload.force": "100 N"}, "operation"),
    ],
)
def test_impossible_pairs(settings, named):
    with pytest.raises(BadCase, match=named):
        case(**settings)
