"""Answers that an engineer looks for on the page of a case with elastic rings and fitted inputs."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from flexbearing.report.html.check import BUILD
from pytest import approx

from flexbearing import api
from flexbearing.findings import OUTSIDE, USUAL
from flexbearing.report.html import (
    against_limits,
    answers,
    beyond_range,
    combined,
    exactness,
    headline,
    life,
    lubrication,
    numbers,
    origin,
    stiffness,
    verdict,
)
from flexbearing.report.html.document import Items, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from tests.flexbearing.html_pages import Numbers, require_equal, with_effects

PAPER = Path(__file__).parents[2] / "configs" / "mao2016.toml"
SMEARED = ["accuracy.structure=smeared", "accuracy.element_order=2"]  # the cheapest rings with meshes


@pytest.fixture(scope="module")
def paper(tmp_path_factory):
    path = tmp_path_factory.mktemp("answers") / "paper.h5"
    return Reader(api.run(PAPER, SMEARED, output=path), METRIC)


def number(cell):
    assert isinstance(cell, Number)
    return float(cell.text.replace(",", ""))


def paragraphs(blocks):
    return " ".join(text for block in blocks if isinstance(block, Words) for text in block.paragraphs)


def told_by(blocks):
    for block in blocks:
        yield from block.items if isinstance(block, Items) else block.paragraphs


def test_every_main_result_has_an_error_and_the_page_says_what_it_leaves_out(paper):
    (main,) = [block for block in verdict.blocks(paper) if getattr(block, "caption", "") == "Main results"]
    assert all(number(row[3]) > 0 for row in main.rows if "bar stress" not in row[0])  # smeared: no mesh
    told = paragraphs(exactness.blocks(paper))
    assert "40 and 80 slices" in told
    assert "Not in the errors by slices alone: the meshes of the elastic rings" in told
    assert "flexbearing run mao2016.toml --set" in told


def test_error_of_the_stiffness_with_supports_counts_the_mesh_of_a_support_by_its_share(paper):
    outer = paper.attributes["structure"]["outer"]
    worse = {"outer": {**outer, "support_stiffness_error_N_per_m": 0.1 * outer["support_stiffness_N_per_m"]}}
    attributes = {**paper.result.attributes, "structure": paper.attributes["structure"] | worse}
    reader = Reader(replace(paper.result, attributes=attributes), METRIC)
    (table,) = [block for block in exactness.blocks(reader) if isinstance(block, Table)]
    (error,) = [row[1] for row in table.rows if row[0] == "stiffness with supports"]
    state = paper.blocks["flexible"]
    share = float(state["total_stiffness"]) / float(state["support_stiffness"])
    assert 0.4 < share < 1
    assert number(error) == approx(10 * share, rel=0.05)  # two digits; slices and the inner ring add little


def test_stiffness_over_y_and_z_of_the_bearing_alone_and_with_supports(paper):
    table = stiffness._radial(paper)
    rows = {row[0]: row[2] for row in table.rows}
    alone, whole, support = (
        number(rows[name]) for name in
        ("bearing alone, along y", "with supports, along y", "support of the outer ring alone")
    )  # fmt: skip
    inner = number(rows["support of the inner ring alone"])
    assert 1 / whole == approx(1 / alone + 1 / support + 1 / inner, rel=0.02)


def test_stress_without_yield_and_tilts_are_told_in_the_first_block(paper):
    first = "\n".join(told_by(headline.blocks(paper)))
    assert "Possibly the first limit, without a strength in the case: Largest stress" in first
    assert "Tilt of the inner ring: " not in first  # an outer ring on its support leans along
    weighed = paragraphs(verdict.blocks(with_effects(paper)))
    assert "No assumed input changes this life 1.25 times or more" not in weighed  # its choices do
    (fitted,) = [block for block in verdict.blocks(paper)
                 if isinstance(block, Items) and block.title.startswith("Fitted inputs")]  # fmt: skip
    assert fitted.items[0].startswith("clearance (bearing.clearance) = 75.5 µm, fitted to the paper's")


def test_the_headline_says_what_the_oil_that_the_life_leaves_out_makes_of_it(paper):
    """In the same sentence as the life, and as a number in a cell: a_ISO with the cleanest oil."""
    (line,) = [each for each in told_by(headline.blocks(with_effects(paper))) if " of this case: " in each]
    sentence = line.partition(". Range")[0]
    (row,) = [row for block in lubrication.blocks(paper) if isinstance(block, Table)
              for row in block.rows if row[0] == "largest a_ISO at this κ"]  # fmt: skip
    most, hours = number(row[1]), float(paper.result["flexible.life_L10 [h]"].number)
    assert 0.2 < most < 0.21
    assert (
        f"a_ISO is at most {row[1].text} at κ 0.428 and the load of this life, at any cleanliness" in sentence
    )
    assert float(
        re.search(r"without the influence of the oil; with it at most ([\d.]+) h", sentence)[1]
    ) == approx(hours * most, rel=5e-3)
    left_out = " ".join(beyond_range.left_out(paper))
    assert 'with operation.tilt = "fixed" the basic life is' in left_out
    assert "edge stress of the pressed roller ends" in left_out
    counted = {
        **paper.result.attributes,
        "case_si": {**paper.attributes["case_si"], "life": {"lubrication": "a_ISO"}},
    }
    assert beyond_range.of_oil(Reader(replace(paper.result, attributes=counted), METRIC)) == ""


def test_a_load_beyond_the_formula_is_no_damage_and_an_overlap_cannot_be_built(paper):
    grades = {check.what: check.grade for check in against_limits.ranked(paper) if check.broken}
    assert grades == {
        "Equivalent load P": OUTSIDE, "Dimensions of the cage": BUILD,
            "Error of the peak pressure of slices": OUTSIDE,
        "Viscosity ratio κ": USUAL,
    }  # fmt: skip
    first = " ".join(told_by(headline.blocks(paper)))
    parts = ("Not assured", "No limit of damage", "It cannot be built as assumed", "Below the usual")
    assert [part in first for part in parts] == [True] * len(parts)
    assert [first.index(part) for part in parts] == sorted(first.index(part) for part in parts)


def test_keys_that_count_as_one_input_are_told_where_the_range_stands(paper):
    assert "roller drop (bearing.roller.drop) and roller profile (bearing.roller.profile) describe one" in (
        combined.note(with_effects(paper))
    )


def test_speed_and_power_stand_beside_who_checks_them(paper):
    checks = {check.what: check for check in against_limits.ranked(paper)}
    assert number(checks["Speed: n·d_m [mm/min]"].value) == approx(38000 * 70, rel=1e-3)
    heat = checks["Heat balance: driving power"]
    assert number(heat.value) == approx(float(paper.blocks["flexible"]["driving_power"]), rel=1e-3)
    assert "81% of it are drag by the fitted lubricant.oil_fraction" in heat.verdict
    assert checks["Strength of the cage"].who.startswith("cage maker")


def test_each_rotor_model_has_its_stiffness_in_the_short_answers(paper):
    lines = list(answers._stiffness(paper))
    alone, support = (
        float(paper.blocks["flexible"]["radial_stiffness"][1, 1]),
        paper.attributes["structure"]["outer"]["support_stiffness_N_per_m"],
    )
    (shaft,) = [each for each in lines if each.startswith("Shaft only")]
    along = float(re.search(r"ring, ([\d.]+) kN/mm along z", shaft)[1])
    assert along == approx(alone * support / (alone + support) / 1e6, rel=1e-3)


def test_slope_between_the_raceways_has_the_limit_not_that_of_an_inner_ring_that_leans_with_the_outer(paper):
    checks = {check.what: check for check in against_limits.ranked(paper)}
    between = checks["Slope between the raceways at the most loaded roller"]
    leaning = float(paper.blocks["flexible"]["ring_tilt"][0]) * 1e3
    assert 0 < number(between.value) < 1.2 < abs(leaning)
    assert between.verdict == "met"
    cell = {"data-of": between.value.of, "data-stored": "rad", "data-unit": "mrad"}
    require_equal([(cell, between.value.text)], Numbers(paper.result.path))


def test_tilt_is_a_step_of_its_own_from_the_life_of_the_catalogue(paper):
    (table,) = [block for block in life._by_what_was_solved(paper)]
    lives = {row[0]: number(row[2]) for row in table.rows}
    held, free = lives["flexible rings, inner ring held straight"], lives["inner ring free to tilt"]
    assert held == approx(paper.attributes["tilt"]["otherwise"]["life_L10_Mrev"], rel=1e-3)
    steps = [number(row[1]) for row in table.rows if isinstance(row[1], Number)]
    assert np.prod(steps) == approx(free / lives["Catalogue's life L10, ISO 281"], rel=1e-2)


def test_no_row_with_supports_where_no_part_is_flexible(paper):
    rigid = replace(paper.result, attributes={**paper.result.attributes, "structure": {}})
    labels = [
        [row[0] for row in table.rows]
        for reader in (paper, Reader(rigid, METRIC))
        for table in numbers.blocks(reader) if isinstance(table, Table)
    ]  # fmt: skip
    assert ["stiffness with supports" in each for each in labels] == [True, False]


@pytest.mark.parametrize(
    ("revision", "told"),
    [("0123456789ab-dirty", "that no commit holds"), ("0123456789ab", ""), ("", "is not known")],
)
def test_origin_says_whether_the_program_can_be_had_again(paper, revision, told):
    machine = {**paper.attributes["machine"], "revision": revision}
    reader = Reader(replace(paper.result, attributes={**paper.result.attributes, "machine": machine}), METRIC)
    (table,) = [block for block in origin.blocks(reader) if isinstance(block, Table)]
    assert "flexbearing run mao2016.toml --set 'accuracy.structure=smeared'" in table.note
    assert [words in table.note for words in ("that no commit holds", "is not known")] == [
        words == told for words in ("that no commit holds", "is not known")
    ]
