"""The lightest bearing of a table that keeps all limits: `flexbearing select`."""

import csv
import json

import pytest
from pytest import approx

import flexbearing
from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.catalogue.new import case_text
from flexbearing.findings.load_limits import LIGHT_LOAD_OF_BALLS
from flexbearing.select import candidates as of_table
from flexbearing.select.application import read
from flexbearing.select.candidates import candidates
from flexbearing.select.selection import selection

HEAD = "designation,like,bore,outside,width,angle,dynamic_rating,static_rating,mass,limiting_speed"
TABLE = f"""{HEAD}
6210,deep_groove_ball,50 mm,90 mm,20 mm,,35 kN,23.2 kN,0.46 kg,8000 rpm
6010,deep_groove_ball,50 mm,80 mm,16 mm,,21.6 kN,16 kN,0.26 kg,9000 rpm
6310,deep_groove_ball,50 mm,110 mm,27 mm,,62 kN,38.5 kN,1.07 kg,6000 rpm
NU210,cylindrical_roller,50 mm,90 mm,20 mm,,73.5 kN,69.5 kN,0.48 kg,9000 rpm
7210,angular_contact_ball,50 mm,90 mm,20 mm,40 deg,,,,
QJ210,four_point_ball,50 mm,90 mm,20 mm,,,,,
"""
LOADS = {"load": "3 kN", "speed": "1900 rpm"}
LIFE = "10000 h"


@pytest.fixture
def table(tmp_path):
    file = tmp_path / "bearings.csv"
    file.write_text(TABLE)
    return file


def selected(table, options=LOADS, life=LIFE, *, rows=None, factor=1.0, reliability=None):
    return selection(read(options, rows, life, factor, reliability), candidates([table]))


def cards(found):
    return {card.candidate.designation: card for card in found.cards}


def test_the_lightest_that_keeps_all_limits_is_chosen(table):
    """3000 (10^4 60 1900/10^6)^(1/3) = 31 341 N; 6010 has less, 6210 more, others are heavier."""
    found = selected(table)
    each = cards(found)
    assert found.chosen is each["6210"]
    assert each["6210"].rated.required_rating == approx(3000 * 1140 ** (1 / 3), rel=1e-12)
    assert each["6210"].rated.life == approx((35e3 / 3e3) ** 3 * 1e6 / 1900 * 60, rel=1e-12)
    assert each["6210"].rated.static_safety == approx(23.2 / 3, rel=1e-12)
    assert each["6010"].verdict == "required-life"
    assert each["6310"].fits
    assert each["7210"].why_not == "needs a load: axial load"
    assert "no ratings in ISO 281" in each["QJ210"].why_not
    masses = [card.candidate.mass for card in found.cards]
    assert masses == sorted(masses)


def test_rollers_take_no_axial_load_and_steep_balls_do(table):
    each = cards(selected(table, LOADS | {"axial": "3 kN"}))
    assert each["NU210"].why_not == "takes no axial load"
    assert each["7210"].rated.by_maker == ()
    assert each["7210"].rated.dynamic_rating == approx(36e3, rel=0.01)


def test_tapered_rollers_are_judged_as_rollers(table):
    """C_0/P_0 of 1.3 is enough for balls; the least load is 0.02 C."""
    table.write_text(f"{HEAD}\n32207,tapered_roller,35 mm,72 mm,24.25 mm,14 deg,70 kN,80 kN,,\n")
    (card,) = selected(table, {"load": "60 kN", "axial": "20 kN", "speed": "1 rpm"}, "1 h").cards
    assert 1 < card.rated.static_safety < 1.5
    assert "static-safety" in card.verdict
    (card,) = selected(table, {"load": "1 kN", "axial": "0.2 kN", "speed": "1 rpm"}, "1 h").cards
    assert card.verdict == "light-load"


def test_reliability_and_factor_raise_the_required_rating(table):
    """a_1 of 99 % is 0.25: C goes with 4^(1/3); the factor counts for life and static safety."""
    plain, strict = (
        cards(selected(table, reliability=of, factor=factor))["6310"].rated
        for of, factor in ((None, 1.0), (0.99, 1.5))
    )
    assert strict.required_rating / plain.required_rating == approx(1.5 * (1 / 0.25) ** (1 / 3), rel=5e-3)
    assert strict.static_safety == approx(plain.static_safety / 1.5, rel=1e-12)
    assert strict.mean_load == plain.mean_load


@pytest.mark.parametrize(
    ("options", "name", "verdict"),
    [
        ({"load": "3 kN", "speed": "8500 rpm"}, "6210", "limiting-speed"),
        ({"load": "18 kN", "speed": "1 rpm"}, "6210", "heavy-load"),
        ({"load": "24 kN", "speed": "1 rpm"}, "6210", "static-safety"),
        ({"load": "50 kN", "speed": "1 rpm"}, "NU210", "static-safety"),  # 1.39, rollers need 1.5
        ({"load": "300 N", "speed": "100 rpm"}, "6210", "light-load"),
    ],
)
def test_every_limit_decides(table, options, name, verdict):
    card = cards(selected(table, options, "1 h"))[name]
    assert verdict in card.verdict
    assert not card.fits


def test_a_reference_speed_is_judged_where_the_table_has_one(table):
    text = TABLE.replace("limiting_speed", "reference_speed")
    table.write_text(text)
    card = cards(selected(table, {"load": "3 kN", "speed": "8500 rpm"}, "1 h"))["6210"]
    assert card.verdict == "reference-speed"
    assert cards(selected(table, {"load": "3 kN", "speed": "7900 rpm"}, "1 h"))["6210"].fits


def test_minimum_load_is_the_declared_one(table, tmp_path):
    """Of the row with the least load, which no application factor raises; a row without load has none."""
    limit = LIGHT_LOAD_OF_BALLS.limit
    for share, fits in ((1.001, True), (0.999, False)):
        options = {"load": f"{limit * 35e3 * share} N", "speed": "100 rpm"}
        assert cards(selected(table, options, "1 h"))["6210"].fits == fits
    rows = tmp_path / "rows.csv"
    for least, fits in ((300, False), (0, True)):
        rows.write_text(f"time [%],operation.radial_load [N]\n50,3000\n50,{least}\n")
        found = cards(selected(table, {"speed": "100 rpm"}, "1 h", rows=rows, factor=2.0))
        assert found["6210"].verdict == "light-load" * (not fits)


def test_a_spectrum_is_that_of_a_duty_cycle(table, tmp_path):
    """Required C and mean load of the case that `new` makes, as `flexbearing study` prints them."""
    rows = "time [%],operation.radial_load [kN],operation.inner_speed [rpm]\n10,8,500\n60,5,3000\n30,2,1000\n"
    (tmp_path / "rows.csv").write_text(rows)
    found = cards(selected(table, {}, "5000 h", rows=tmp_path / "rows.csv", factor=1.2))["NU210"].rated
    page = {
        "bore": "50 mm", "outside": "90 mm", "width": "20 mm", "dynamic_rating": "73.5 kN",
        "static_rating": "69.5 kN", "load": "5 kN", "speed": "3000 rpm",
    }  # fmt: skip
    case = tmp_path / "nu210.toml"
    case.write_text(case_text("cylindrical_roller", page, case)[0])
    study = tmp_path / "duty.toml"
    study.write_text(
        'case = "nu210.toml"\n[set]\n"life.loads" = "rating"\n[duty]\nfile = "rows.csv"\n'
        'required_life = "5000 h"\napplication_factor = 1.2\n[collect]\nlife = "life_L10 [Mrev]"\n'
    )
    cycle = flexbearing.study(study, tmp_path, jobs=1).cycles
    assert found.required_rating == approx(cycle["required_rating"].values[0], rel=1e-12)
    assert found.mean_load == approx(cycle["mean_load"].values[0], rel=1e-12)
    assert found.row == 1  # 0.6 x 3000 x 5^(10/3) is the most damage


def test_rows_at_standstill_count_for_static_safety_alone(table, tmp_path):
    rows = tmp_path / "rows.csv"
    keys = "operation.load.radial_z [kN],operation.inner_speed [rpm]"
    rows.write_text(f"time [%],{keys}\n50,3,1900\n50,20,0\n")
    found = cards(selected(table, {}, LIFE, rows=rows))["6210"].rated
    assert found.static_safety == approx(23.2 / 20, rel=1e-12)
    assert found.required_rating == approx(3000 * 570 ** (1 / 3), rel=1e-12)  # half of the time at rest


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("X,deep_groove_ball,50 mn,90 mm,20 mm,,,,,", "line 2, column bore: --bore 50 mn"),
        ("X,deep_groove_ball,50 mm,,20 mm,,,,,", "line 2, column outside: it is empty"),
        ("X,ball,50 mm,90 mm,20 mm,,,,,", "line 2, column like: 'ball'"),
        (",deep_groove_ball,50 mm,90 mm,20 mm,,,,,", "line 2, column designation"),
        ("X,deep_groove_ball,50 mm,90 mm,20 mm,,,,1 km,", "line 2, column mass: '1 km'"),
        ("X,deep_groove_ball,50 mm,90 mm,20 mm,,,,,-1 rpm", "line 2, column limiting_speed"),
        ("X,deep_groove_ball,50 mm,90 mm,20 mm,40 deg,,,,", "line 2, column angle: a deep_groove_ball"),
        ("X,deep_groove_ball,90 mm,50 mm,20 mm,,,,,", "line 2, column outside: 50 mm is not above"),
        ("X,deep_groove_ball", "line 2 has 2 cells"),
    ],
)
def test_a_cell_that_cannot_be_read_is_named(table, text, words):
    table.write_text(f"{HEAD}\n{text}\n")
    with pytest.raises(BadCase, match=f"bearings.csv: {words}"):
        list(candidates([table]))


def test_a_column_that_there_is_not_is_named(table):
    table.write_text(TABLE.replace("mass", "weight", 1))
    with pytest.raises(BadCase, match="'weight' is no column; they are designation, like"):
        list(candidates([table]))


@pytest.mark.parametrize(
    ("options", "rows", "words"),
    [
        ({"speed": "10 rpm"}, "", "no row has a load"),
        ({"load": "1 kN"}, "", "no row has a load"),
        ({}, "time [%],operation.moment [N m]\n100,1\n", "operation.moment is not read by select"),
        ({"speed": "1 rpm"}, "time [%],operation.radial_load [kN]\n90,1\n", "adds up to 90 %"),
        (
            {"speed": "1 rpm"},
            "time [%],operation.radial_load [kN],operation.load.radial_z [kN]\n100,1,1\n",
            "is given twice",
        ),
    ],
)
def test_an_application_that_gives_no_life_is_refused(tmp_path, options, rows, words):
    file = tmp_path / "rows.csv"
    file.write_text(rows)
    with pytest.raises(BadCase, match=words):
        read(options, file if rows else None, LIFE, 1.0, None)


def test_an_estimated_mass_is_marked_and_near_those_of_makers(table):
    each = cards(selected(table))
    for name in ("6210", "6010", "6310", "NU210"):
        card = each[name].candidate
        estimate = of_table.Candidate(designation="", like=card.like, entries={}, source="", sizes=card.sizes)
        assert estimate.mass == approx(card.mass, rel=0.15)


def test_the_command_prints_a_line_for_each_and_writes_a_table(table, tmp_path, capsys):
    words = ["select", str(table), "--load", "3 kN", "--speed", "1900 rpm", "--required-life", LIFE]
    output = tmp_path / "all.csv"
    assert command([*words, "--bore", "50 mm", "--max-outside", "90 mm", "-o", str(output)]) == 0
    printed = capsys.readouterr().out
    assert "chosen: 6210, the lightest that keeps all limits" in printed
    assert "the next lighter one, 6010: life against the required one: 3,274 h" in printed
    rows = list(csv.DictReader(output.read_text().splitlines()))
    assert [row["designation"] for row in rows if row["fits"] == "yes"] == ["6210", "NU210"]
    assert {row["mass is"] for row in rows} == {"given", "estimated"}
    assert command([*words, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["chosen"], len(found["candidates"])) == ("6210", 6)
    assert command([*words, "--application-factor", "10"]) == 1
    assert "no bearing of the table keeps all limits" in capsys.readouterr().err
    assert command([*words, "--bore", "51 mm"]) == 2
    assert command([*words, "--like", "ball"]) == 2


def test_only_run_computes_the_chosen_one(table, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("flexbearing.catalogue.new._effects", lambda *_: "not here")
    words = ["select", str(table), "--load", "3 kN", "--speed", "1900 rpm", "--required-life", LIFE, "--run"]
    assert command(words) == 0
    assert "results: results/6210.h5" in capsys.readouterr().out
    case = api.check("6210.toml")
    assert case.operation.forces == (3000.0, 0.0)
    assert case.life.dynamic_rating == 35e3
    assert command(words) == 2  # the case is there already
