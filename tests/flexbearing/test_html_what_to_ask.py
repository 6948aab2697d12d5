"""What a report asks of others, and bounds of its own numbers: tilt, bars, heat, films, stiffness, lives."""

import json
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.report.html import (
    METRIC,
    against_limits,
    answers,
    beyond_range,
    headline,
    html,
    of_result,
    simplifications,
    stiffness,
    verdict,
)
from flexbearing.report.html.document import Items, Table
from flexbearing.report.html.reader import Reader
from flexbearing.runs.assumed_effects import measured
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import with_effects

CASES = {
    "rings": ("mao2016.toml", ("accuracy.structure=smeared", "accuracy.element_order=2")),
    "catalogue": ("catalogue/nu210.toml", ()),
    "effects": ("catalogue/nu210.toml", ("outputs.assumed_effects=true", "outputs.catalogue_life=true")),
}
FIRST, WET = "What limits it first, and what to change?", "Is the lubrication sufficient?"


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("asked")

    @cache
    def computed(name):
        file, settings = CASES[name]
        api.run(CONFIGS / file, settings, output=folder / f"{name}.h5")
        return Reader(api.read(folder / f"{name}.h5"), METRIC)

    return computed


def told(reader):
    (table,) = answers.blocks(reader)
    return {question: answer for question, answer, _ in table.rows}


def with_case(reader, **tables):
    case = {**reader.attributes["case_si"]}
    case |= {name: {**case[name], **keys} for name, keys in tables.items()}
    return Reader(replace(reader.result, attributes={**reader.result.attributes, "case_si": case}), METRIC)


def main_results(reader):
    (table,) = [each for each in verdict.blocks(reader) if getattr(each, "caption", "") == "Main results"]
    return {row[0]: row for row in table.rows}


def test_the_stiffness_of_the_bearing_alone_has_a_range_of_its_own(readers):
    reader = with_effects(readers("rings"))
    rows = main_results(reader)
    alone, whole = (rows[f"radial stiffness along the load, {of}"] for of in
                    ("of the bearing alone", "with supports"))  # fmt: skip
    assert [cell.text for cell in alone[4:6]] != [cell.text for cell in whole[4:6]]
    assert alone[8] == "outer.width"
    low, high = (cell.text for cell in alone[4:6])
    assumed = told(reader)["What was assumed, and what does it change?"]
    assert f"stiffness of the bearing alone {low} to {high} times, most by width of the outer ring" in assumed


def test_one_stiffness_is_weighed_once_where_nothing_gives_way(readers):
    rigid, rings = (measured(readers(name).result) for name in ("catalogue", "rings"))
    assert "total_stiffness" in rigid
    assert "stiffness" not in rigid
    assert rings["stiffness"] > rings["total_stiffness"]
    assert sum("stiffness" in label for label in main_results(readers("catalogue"))) == 1


def test_how_the_shaft_holds_the_ring_is_asked_for_before_what_matters_less(readers):
    reader = readers("rings")
    steps = against_limits.steps(reader)
    (tilt,) = [step for step in steps if "(operation.tilt)" in step]
    other = reader.attributes["tilt"]["otherwise"]["life_L10_Mrev"]
    ratio = float(re.search(r"the basic life is ([\d.]+) times", tilt)[1])
    assert ratio == approx(other / reader.summary["flexible"]["life_L10_Mrev"], rel=3e-3)
    slope = 60 * np.degrees(np.hypot(*reader.blocks["flexible"]["ring_tilt"]))
    assert f"free, it tilts by {slope:.0f} arcmin, which hardly any shaft allows" in tilt
    assert slope > 10
    assert steps.index(tilt) < next(n for n, step in enumerate(steps) if "viscous" in step)
    (check,) = [each for each in against_limits.ranked(reader) if each.what == "Tilt of the inner ring"]
    assert check.who.startswith("shaft or rotor designer")
    assert "The clamped ends hold that piece only in the finite elements" in check.verdict
    assert not any("operation.tilt" in step for step in against_limits.steps(readers("catalogue")))
    fixed = {"words": "fixed", "settings": [], "values": {"life_L10": 1.0}, "problem": ""}
    key = {"key": "operation.tilt", "source": "other choices of the key", "role": "choice", "others": [fixed]}
    weighed = {**reader.result.attributes, "assumed_effects": {"of": {"life_L10": 2.0}, "keys": [key]}}
    steps = against_limits.steps(Reader(replace(reader.result, attributes=weighed), METRIC))
    assert [step for step in steps if "operation.tilt" in step] == [tilt]


def test_a_longer_life_by_straight_rollers_is_not_to_be_relied_on_without_edge_stress(readers):
    reader = with_effects(readers("rings"))
    (line,) = [item for block in headline.blocks(reader) if isinstance(block, Items)
               for item in block.items if " of this case: " in item]  # fmt: skip
    assert re.search(r"at once leave [\d.]+ h. Do not rely on its upper end: straight rollers", line)
    assert beyond_range.of_upper_end(with_case(readers("rings"), life={"edge_stress": True})) == ""


def test_edge_stress_of_straight_rollers_is_not_promised(readers):
    roller = {**readers("rings").bearing["roller"], "profile": "straight"}
    straight = with_case(readers("rings"), bearing={"roller": roller})
    edges = [[each for each in beyond_range.left_out(reader) if each.startswith("edge stress")]
             for reader in (readers("rings"), straight)]  # fmt: skip
    assert ["computes its effect" in each[0] for each in edges] == [True, False]


def test_bounds_of_validity_stand_behind_physical_limits_and_bars_have_a_change_of_design(readers):
    lines = told(with_effects(readers("rings")))[FIRST].splitlines()
    kinds = ("Possibly first: Largest stress", "Lower by a change of design: number of bars",
             "Below the usual minimum: Viscosity", "Nearest of the limits that are kept: Static safety",
             "Nearest limit of damage: Peak contact pressure",
             "Outside the range of a law", "Next: ")  # fmt: skip
    assert all(line.startswith(kind) for line, kind in zip(lines, kinds, strict=False))
    assert "number of bars (outer.bars) 36, 0.721 times (stiffness with supports 1.19 times)" in lines[1]
    assert "bar width (outer.bar_width) 5 mm, 0.733 times" in lines[1]


def test_cool_oil_beside_hot_rings_is_remarked_and_what_improves_it_stands_in_the_answer(readers):
    hot, warm = (told(readers(name))[WET] for name in ("rings", "catalogue"))
    assert "κ is 1 with this oil at 137 °C, but the rings, given at 218 to 220 °C, heat it" in hot
    assert "To improve it: take an oil 2.3 times as viscous, or cool it; else use EP/AW" in hot
    assert "but the rings" not in warm
    assert "fully flooded" in warm


def test_temperatures_beside_a_stated_clearance_say_what_they_do(readers):
    said = told(readers("rings"))["Which clearance?"]
    assert "[operation.temperatures] change the sizes of rollers, raceways and supports, not this" in said
    assert "[operation.temperatures]" not in told(readers("catalogue"))["Which clearance?"]


def test_heat_hoop_stress_and_temperatures_are_those_of_rigid_rings_without_temperatures(readers):
    checks = {each.what: each for each in against_limits.ranked(readers("catalogue"))}
    assert "given" not in checks["Heat balance: driving power"].verdict
    assert "upper bound: 97% is rolling friction of the oil film in fully flooded inlets" in (
        checks["Heat balance: driving power"].verdict
    )
    assert checks["Temperature"].who.startswith("thermal analyst or a test: temperatures of shaft")
    hoop = "Hoop stress of the rings by fit and speed"
    assert checks[hoop].verdict == "not checked: rigid rings have no stress"
    of_rings = {each.what: each for each in against_limits.ranked(readers("rings"))}
    assert of_rings[hoop].verdict == "not checked: not in the stress of a flexible ring"


def test_a_torque_with_flooded_inlets_is_an_upper_bound_where_it_is_a_main_result(readers):
    labels = [next(label for label in main_results(readers(name)) if label.startswith("driving torque"))
              for name in ("catalogue", "rings")]  # fmt: skip
    assert (
        labels[0]
        == "driving torque (upper bound: 97% is rolling friction of the oil film in fully flooded inlets)"
    )
    assert labels[1] == "driving torque"


@pytest.mark.parametrize("name", ["catalogue", "rings"])
def test_every_life_names_its_method_and_every_simplification_who_checks_it(readers, name):
    document = of_result(readers(name).result)
    rows = [row for section in document.sections for block in section.blocks if isinstance(block, Table)
            for row in block.rows]  # fmt: skip
    assert not any(isinstance(row[0], str) and row[0].strip() in ("life L10", "L10") for row in rows)
    for text, who in simplifications.simplifications(readers(name)):
        assert (text, who) in rows
        assert who


def test_a_drawing_that_a_page_resizes_has_the_bar_of_a_length_and_no_ratio(readers):
    page = html(of_result(readers("catalogue").result))
    assert "10 mm" in page
    assert not re.search(r"scale [\d.]+ : [\d.]+", page)


def test_the_stiffness_free_to_move_across_says_why_it_is_not_that_along_z(readers):
    (table,) = [block for section in of_result(readers("rings").result).sections for block in section.blocks
                if getattr(block, "caption", "").startswith("Radial tangent stiffness")]  # fmt: skip
    rows = {row[0]: row for row in table.rows}
    free, along = rows["bearing alone, along the load"], rows["bearing alone, along z"]
    assert float(free[2].text) <= float(along[2].text)
    assert "free to move across the load, which the rows over y and z hold" in free[4]


ASSUMED = "What was assumed, and what does it change?"


def test_a_cage_slip_of_zero_says_which_key_computes_its_range(readers):
    words = (
        "cage slip: zero to the printed digit; outputs.assumed_effects = true computes a range in percent."
    )
    result = readers("catalogue").result
    without = {key: each for key, each in result.attributes.items() if key != "assumed_effects"}
    assert words in told(Reader(replace(result, attributes=without), METRIC))[ASSUMED]
    assert words not in told(readers("catalogue"))[ASSUMED]


@pytest.mark.slow
def test_effects_of_inputs_give_a_range_of_zero_slip_and_of_the_stiffness_across(readers):
    found = told(readers("effects"))[ASSUMED]
    low, high = re.search(r"cage slip: ([\d.]+) to ([\d.]+) % with other values", found).groups()
    assert float(low) == 0 < float(high)
    effects = readers("effects").attributes["assumed_effects"]
    across = [
        other["values"]["total_stiffness_yy"] / effects["of"]["total_stiffness_yy"]
        for key in effects["keys"] if key["key"] == "bearing.fits.at" for other in key["others"]
    ]  # fmt: skip
    least, most = map(float, re.search(r"stiffness along y ([\d.]+) to ([\d.]+) times", found).groups())
    assert least <= min(across) * 1.001
    assert most >= max(across) * 0.999


def test_ranges_have_their_shortest_life_in_hours(readers):
    reader = readers("effects")
    effects = reader.attributes["assumed_effects"]
    shortest = min(each["values"]["modified_life"] for each in effects["together"])
    hours = float(shortest) * 1e6 / (3000 * 60)
    words = " ".join(
        line for block in headline.blocks(reader) if isinstance(block, Items) for line in block.items
    )
    (found,) = re.findall(r"all changes that shorten it at once leave ([\d,]+) h", words)
    assert float(found.replace(",", "")) == approx(hours, rel=6e-3)


def test_factors_from_the_catalogue_multiply_to_the_ratio_of_the_lives(readers):
    found = told(readers("effects"))["Why not the catalogue's life?"]
    line = next(line for line in found.splitlines() if line.startswith("Factors between them"))
    *factors, whole = map(float, re.findall(r"× (\d+\.\d+|\d+)", line))
    assert np.prod(factors) == approx(whole, rel=2e-3)
    first, last = re.search(r"gives ([\d,]+) h, this case ([\d,]+) h", found).groups()
    assert whole == approx(float(last.replace(",", "")) / float(first.replace(",", "")), rel=1e-2)


def _evidence(page):
    return (CONFIGS.parent / "docs" / "evidence" / f"{page}.md").read_text("utf-8")


@pytest.mark.parametrize(
    ("balls", "pages"),
    [
        (False, {"sjovall-rollers": 1.0, "harris-209": 1.0, "iso16281-rollers": 0.5, "ring-clamped": 1.5,
                 "curved-beams": 1.5, "ring-calculix": 1.5}),
        (True, {"sjovall-balls": 0.3, "harris-218": 0.3, "iso16281-balls": 1.0, "joshi-measured": 24.0}),
    ],
)  # fmt: skip
def test_misfits_that_a_report_quotes_are_those_of_the_evidence_pages(balls, pages):
    quoted = {float(number) for number in re.findall(r"([\d.]+) %", answers.MISFITS[balls])}
    lower = {18.0: "largest load, inner raceway", 16.0: "cage slip"} if not balls else {}
    assert {*pages.values(), *lower} == quoted
    stored = json.loads((CONFIGS.parent / "docs/evidence/numbers/mao-flexible.json").read_text("utf-8"))
    found = {each["name"]: round(100 * (1 - each["ours"] / each["known"])) for each in stored["numbers"]}
    assert {found[quantity] for quantity in lower.values()} == set(lower)
    for page, most in pages.items():
        misfit = float(re.search(r"Largest misfit[^:]*: [+-]?([\d.]+) %", _evidence(page))[1])
        assert misfit <= most


def test_films_of_little_oil_are_those_of_runs_with_short_inlets(readers):
    reader = readers("catalogue")
    words = told(reader)[WET]
    shares = re.search(
        r"begins ([\d., ]+) half-widths before the contact the smallest film keeps ([\d., %]+)", words
    )
    inlets, left = ([float(each.strip(" %")) for each in text.split(",")] for text in shares.groups())
    flooded = reader.result.rigid["inner_film"]
    thinnest = int(np.argmin(np.where(reader.result.rigid["inner_load"] > 100.0, flooded, np.inf)))
    for inlet, share in zip(inlets, left, strict=True):
        short = api.run(CONFIGS / CASES["catalogue"][0], [f"lubricant.inlet_length={inlet}"])
        assert short.rigid["inner_film"][thinnest] / flooded[thinnest] == approx(share / 100, abs=0.01)


def test_a_stiffness_with_one_support_has_the_range_of_what_is_in_series(readers):
    """Of that with supports, less the stiffer support; or of the bearing alone, with the stiffer one."""
    reader = readers("rings")
    block = reader.result.flexible
    supports = {
        part: figures["support_stiffness_N_per_m"] for part, figures in reader.attributes["structure"].items()
    }
    softer, stiffer = sorted(supports, key=supports.get)
    spans = {"total_stiffness": (0.5, 1.2), "stiffness": (0.8, 1.1)}
    alone, total = (block[name][1, 1] for name in ("radial_stiffness", "total_radial_stiffness"))
    for part, of, left_out in (
        (softer, total, -1 / supports[stiffer]),
        (stiffer, alone, 1 / supports[stiffer]),
    ):
        now = 1 / (1 / alone + 1 / supports[part])
        ends = [
            1 / (1 / (factor * of) + left_out) / now
            for factor in spans[{total: "total_stiffness", alone: "stiffness"}[of]]
        ]
        assert stiffness.ends_in_series(reader, part, spans) == approx(ends, rel=1e-9)
    assert stiffness.ends_in_series(readers("catalogue"), "outer", spans) is None
