"""Short answers of a report: every question, links that lead somewhere, numbers of the tables they name."""

import re
from functools import cache

import numpy as np
import pytest
from flexbearing.report.html.check import Check
from pytest import approx

from flexbearing import api
from flexbearing.findings import USUAL
from flexbearing.findings.finding import AT_LEAST
from flexbearing.report.html import (
    METRIC,
    against_limits,
    answers,
    html,
    life,
    lives,
    lubrication,
    of_result,
    oil,
    ratings,
)
from flexbearing.report.html.document import Number
from flexbearing.report.html.reader import Reader
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Numbers, Page, require_equal

CASES = {
    "catalogue": ("catalogue/nu210.toml", ()),
    "rings": ("mao2016.toml", ("accuracy.structure=beam",)),
    "ball": ("6209.toml", ()),
    "four-point": ("joshi2015_qj309.toml", ()),
    "warm": ("nu209_fits.toml", ()),
}


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("answers")

    @cache
    def computed(name):
        file, settings = CASES[name]
        api.run(CONFIGS / file, settings, output=folder / f"{name}.h5")
        return Reader(api.read(folder / f"{name}.h5"), METRIC)

    return computed


def told(reader):
    (table,) = answers.blocks(reader)
    return {question: answer for question, answer, _ in table.rows}


@pytest.mark.parametrize(
    ("name", "missing"), [("catalogue", 0), ("rings", 0), ("warm", 0), ("ball", 1), ("four-point", 2)]
)
def test_the_ten_questions_are_answered_and_every_link_leads_somewhere(readers, name, missing):
    """Balls have no film, slow ones no life either."""
    assert len(told(readers(name))) == 10 - missing
    page = Page(html(of_result(readers(name).result)))
    places = {given["id"] for _, given in page.tags if "id" in given}
    links = {given["href"] for tag, given in page.tags if tag == "a" and given["href"].startswith("#")}
    assert {link.removeprefix("#") for link in links} <= places
    assert len(links) > 12


def test_each_clearance_has_its_number_in_a_line(readers):
    answer = told(readers("catalogue"))["Which clearance?"]
    assert "Before mounting, as in a catalogue: 45.0 µm, class CN.\nMounted at rest" in answer
    assert "not known, as the case gives no temperatures" in answer
    found = readers("warm").attributes["clearance"]
    warm = told(readers("warm"))["Which clearance?"]
    assert f"In operation, warm and turning: {1e6 * found['operating_m']:.1f} µm." in warm
    given = told(readers("rings"))["Which clearance?"]
    assert "In operation, warm and turning: 75.5 µm (fitted, see Inputs)." in given


def test_the_most_loaded_element_is_that_of_the_inner_raceway(readers):
    for name, dataset in (("catalogue", "inner_load"), ("rings", "inner_load")):
        reader = readers(name)
        loads = np.asarray(reader.blocks[reader.last][dataset])
        words = told(reader)["Where does the load act, and which signs are used?"]
        place, load, carry = re.match(
            r"Roller (\d+) of .* carries most: ([\d,]+) N .* (\d+) carry", words
        ).groups()
        assert int(place) == np.argmax(loads) + 1
        assert float(load.replace(",", "")) == approx(loads.max(), rel=1e-3)
        assert int(carry) == reader.summary[reader.last]["loaded_rollers"] < loads.size
    assert (
        "Ball 1 of 9, at azimuth 0.0 °, carries most: 4,527 N"
        in told(readers("ball"))["Where does the load act, and which signs are used?"]
    )


def test_assumed_and_fitted_inputs_are_named(readers):
    words = told(readers("rings"))["What was assumed, and what does it change?"]
    assert words.startswith("22 inputs are assumed, 2 fitted")
    assert "Fitted: clearance, oil fraction." in words
    assert "shaft length" in words.partition("Fitted")[0]


def test_an_exceeded_limit_stands_before_a_missed_aim(readers):
    safe, first = (
        told(readers("rings"))[key] for key in ("Is it safe?", "What limits it first, and what to change?")
    )
    assert safe.startswith(
        "Not assured: a law is used outside its range.\nEquivalent load P 19.62 kN, at most 11.04 kN"
    )
    assert safe.index("OUTSIDE VALIDITY") < safe.index("BELOW THE USUAL MINIMUM")
    assert "take a bearing with a rating 1.78 times as large" in first


def test_viscosity_ratio_and_films_are_told_where_the_life_does_not_use_them(readers):
    reader = readers("rings")
    (table,) = [block for block in lubrication.blocks(reader) if block.kind == "table"]
    rows = {row[0]: row[1] for row in table.rows}
    assert 0.1 < float(rows["viscosity ratio κ = ν/ν₁"].text) < 1
    assert float(rows["smallest film, inner raceway"].text) > 0
    cells = [
        ({"data-of": cell.of, "data-stored": cell.stored, "data-unit": cell.unit}, cell.text)
        for cell in rows.values()
    ]
    require_equal(cells, Numbers(reader.result.path))


def test_life_of_the_case_at_other_oil_temperatures_ends_at_its_own(readers):
    reader = readers("catalogue")
    (table,) = ratings.at_other_temperatures(reader)
    lives = [float(row[-1].text.replace(",", "")) for row in table.rows]
    assert lives == sorted(lives, reverse=True)
    assert lives[2] == approx(float(reader.result["modified_life [h]"].number), rel=1e-3)


def test_a_temperature_has_one_life_that_of_the_comments_where_they_tell_it(readers):
    reader = readers("catalogue")
    (table,) = ratings.at_other_temperatures(reader)
    lives = {row[0].partition(" °C")[0]: float(row[-1].text.replace(",", "")) for row in table.rows}
    assert lives["50"] / lives["70"] == approx(7.41, rel=1e-3)
    assert lives["90"] / lives["70"] == approx(0.305, rel=1e-3)
    cells = [
        ({"data-of": cell.of, "data-stored": cell.stored, "data-unit": cell.unit}, cell.text)
        for row in table.rows for cell in row[1:]
    ]  # fmt: skip
    require_equal(cells, Numbers(reader.result.path))


@pytest.mark.parametrize("name", ["catalogue", "rings", "ball"])
def test_factors_of_the_chain_lead_from_the_catalogue_s_life_to_that_of_the_case(readers, name):
    reader = readers(name)
    factors = [factor for _, factor in life.chain(reader)]
    sizes = [abs(np.log(factor)) for factor in factors]
    assert sizes == sorted(sizes, reverse=True)
    chosen, *_ = lives.lives(reader)
    (catalogue,) = [each for each in lives.lives(reader) if each.key == "catalogue"]
    pair = [float(each.turns.text.replace(",", "")) for each in (catalogue, chosen)]
    assert np.prod(factors) == approx(pair[1] / pair[0], rel=2e-3)


@pytest.mark.parametrize(
    ("name", "tilt", "which"),
    [("rings", "free", "with supports"), ("catalogue", "fixed", "of the bearing alone"),
     ("ball", "", "of the bearing alone")],
)  # fmt: skip
def test_stiffnesses_say_how_the_tilt_is_held_and_which_one_the_matrix_is(readers, name, tilt, which):
    answer = told(readers(name))["Which stiffness for a rotor program?"]
    assert f"is that {which}; its entries hold the tilt." in answer
    assert (f'All numbers above are with operation.tilt = "{tilt}"' in answer) == bool(tilt)


def test_lives_by_the_same_rating_have_one_factor_of_the_loads(readers):
    """The capacity of Lundberg and Palmgren lies between neither of them."""
    reader = readers("catalogue")
    steps = dict(life.chain(reader))
    assert set(steps) == {"loads of all slices by the same C_r", "edge stress", "a_ISO"}
    reference = float(reader.result["reference_life [Mrev]"].number)
    catalogue = ratings.found(reader)[0]["life_Mrev"]
    loads = steps["loads of all slices by the same C_r"]
    assert loads * steps["edge stress"] == approx(reference / catalogue, rel=1e-9)
    assert loads == approx(2.26, abs=0.005)
    answer = told(reader)["Why not the catalogue's life?"]
    assert "by the same C_r × 2.2" in answer
    assert "capacity" not in answer
    assert "`flexbearing life nu210.toml` splits it" in answer
    (table,) = [block for block in life.blocks(reader) if getattr(block, "caption", "").startswith("Why")]
    assert [row[0] for row in table.rows[1:4]] == [
        "loads of all slices by the same C_r", "edge stress", "Reference life L10r, ISO/TS 16281"
    ]  # fmt: skip
    cells = [
        ({"data-of": cell.of, "data-stored": cell.stored, "data-unit": cell.unit}, cell.text)
        for row in table.rows for cell in row if isinstance(cell, Number)
    ]  # fmt: skip
    require_equal(cells, Numbers(reader.result.path))
    assert len(cells) == 7


def test_the_nearest_limit_is_that_of_the_largest_share_of_both_kinds(readers):
    """A static safety near its usual minimum stands before a pressure at a smaller share of its limit."""
    first = told(readers("rings"))["What limits it first, and what to change?"].splitlines()
    kept = [check for check in against_limits.ranked(readers("rings")) if check.used and not check.broken]
    assert kept[0].what == "Static safety C_0/P_0"
    assert kept[0].used > kept[1].used > kept[0].damage
    (near,) = [line for line in first if line.startswith("Nearest of the limits that are kept: ")]
    assert "Static safety C_0/P_0: 1.562, at least 1.5 (SKF" in near
    assert near.endswith(": 1.04 times the usual minimum.")
    (damage,) = [line for line in first if line.startswith("Nearest limit of damage: ")]
    assert damage == f"Nearest limit of damage: {kept[1].what}: {kept[1].share.text} % of the limit."


def test_a_usual_minimum_that_is_not_kept_counts_with_its_limit_of_damage(readers):
    used = Check("κ", used=2.0, verdict="BELOW THE USUAL MINIMUM", grade=USUAL, side=AT_LEAST)
    static = Check(
        "C_0/P_0", used=1.25, verdict="BELOW THE USUAL MINIMUM", grade=USUAL, side=AT_LEAST, damaging=0.83
    )
    lines = list(answers._nearest([used, static, Check("pressure", used=0.7, verdict="met")], unknown=False))
    assert lines[-1] == "Nearest limit of damage: C_0/P_0: 83% of the limit of damage."


def test_the_largest_factor_and_the_like_for_like_life_stand_in_the_answer(readers):
    answer = told(readers("catalogue"))["Why not the catalogue's life?"]
    assert "Like for like, with a_ISO at P, the catalogue's L10m is 146,000 h." in answer
    assert answer.startswith("ISO 281 gives 43,200 h, this case 490,000 h (Modified")
    assert "the largest first: a_ISO × 5.188, " in answer
    assert (
        "the largest first: inner ring free to tilt × "
        in told(readers("rings"))["Why not the catalogue's life?"]
    )


def test_a_minimum_is_told_as_a_multiple_and_nothing_limits_at_a_light_load(readers):
    answers_of = told(readers("catalogue"))
    first = answers_of["What limits it first, and what to change?"]
    assert first.startswith(
        "Nothing limits at this load; nearest: Viscosity ratio κ: 2.06 times the usual minimum.\n"
        "The case gives no temperatures: at the tight end of the tolerances an inner ring 10 K warmer"
    )
    assert "Minimum load 5 kN" in answers_of["Is it safe?"]
    assert "3.4 times the usual minimum" in answers_of["Is it safe?"]


def test_lubrication_names_both_viscosities_and_the_temperature_that_suffices(readers):
    cool, thin = (told(readers(name))["Is the lubrication sufficient?"] for name in ("catalogue", "rings"))
    assert "2.06 = 20.1 mm²/s over 9.78 mm²/s needed" in cool
    assert "κ is 1 with this oil at 95 °C." in cool
    assert "κ is 1 with this oil at 137 °C, but the rings" in thin


def test_an_oil_that_cannot_be_cooled_enough_is_said_to_be_too_thin(readers, monkeypatch):
    monkeypatch.setattr(oil, "sufficient_at", lambda _: (None, 40))
    answer = told(readers("rings"))["Is the lubrication sufficient?"]
    assert "Cooling this oil to 40 °C is not enough: it needs a thicker one." in answer


def test_error_of_the_torque_has_the_power_that_no_cause_explains(readers):
    assert "driving torque 0.86 %" in told(readers("catalogue"))["How exact are the numbers?"]
