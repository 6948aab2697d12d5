"""Answers that an engineer looks for on the page of a case with elastic rings and fitted inputs."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.report.html import (
    against_limits,
    assumptions,
    exactness,
    life,
    numbers,
    origin,
    stiffness,
    verdict,
)
from flexbearing.report.html.document import Items, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from tests.flexbearing.html_pages import Numbers, require_equal

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


def test_every_main_result_has_an_error_and_the_page_says_what_it_leaves_out(paper):
    (main,) = [block for block in verdict.blocks(paper) if getattr(block, "caption", "") == "Main results"]
    assert all(number(row[3]) > 0 for row in main.rows)
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
    first = paragraphs(list(against_limits.summary(paper)))
    assert "Compare with limits of your own before use: Nominal stress of the bars: " in first
    assert "Tilt of the inner ring: " not in first  # an outer ring on its support leans along
    assert "No assumed input changes this life 1.25 times or more" in paragraphs(verdict.blocks(paper))
    (fitted,) = [block for block in verdict.blocks(paper)
                 if isinstance(block, Items) and block.title.startswith("Fitted inputs")]  # fmt: skip
    assert fitted.items[0].startswith(
        "bearing clearance (bearing.clearance) = 75.5 µm, fitted to the paper's"
    )


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


@pytest.mark.slow
@pytest.mark.parametrize("key", ["bearing.roller.drop", "bearing.cage.thickness", "lubricant.oil_fraction",
                                 "outer.bar_width"])  # fmt: skip
def test_effects_that_the_case_tells_are_those_of_the_program(key):
    """Of every output beside each key, with every other value."""
    comment = assumptions.comments(PAPER.read_text("utf-8"))[key]
    base = api.run(PAPER)
    outputs = {"life": "life_L10"} | {word: name for name, word in base.family.layout().weighed}
    told = {word: re.findall(r'([\d.]+) times with "?([^",;]+)"?', assumptions.changes(comment, word))
            for word in outputs}  # fmt: skip
    values = {value for changes in told.values() for _, value in changes}
    others = {value: api.run(PAPER, [f"{key}={value}"]) for value in values}
    for word, changes in told.items():
        for factor, value in changes:
            ratio = others[value][outputs[word]].number / base[outputs[word]].number
            assert ratio == approx(float(factor), rel=6e-3), word
    assert any(told.values())
