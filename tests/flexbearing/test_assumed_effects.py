"""Effects of assumed and calibrated inputs: each is that of the case run with the settings it names."""

from dataclasses import replace
from itertools import pairwise

import pytest
from pytest import approx

from flexbearing import api
from flexbearing.case.read import written
from flexbearing.pages.make import report
from flexbearing.report.html import IMPERIAL, METRIC, html, of_result
from flexbearing.runs.plausible import plausible
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Numbers, Page, require_equal

CASE = CONFIGS / "nu209.toml"
FEW = {
    "assumed": ["bearing.cage.pocket_friction", "lubricant.traction"],
    "calibrated": {"bearing.clearance": "nothing, for a test"},
}
ASKED = {**FEW, "outputs.assumed_effects": True}
CASES = sorted(CONFIGS.rglob("*.toml"))


@pytest.fixture(scope="module")
def weighed(tmp_path_factory):
    path = tmp_path_factory.mktemp("effects") / "weighed.h5"
    api.run(CASE, ASKED, output=path)
    return path


def test_each_value_is_that_of_the_case_with_its_settings(weighed):
    found = api.read(weighed).attributes["assumed_effects"]
    assert [each["key"] for each in found["keys"]] == [*FEW["calibrated"], *FEW["assumed"]]
    assert found["of"]["life_L10"] == approx(
        api.run(CASE, FEW)["rigid.life_L10"].to("Mrev").number, rel=1e-12
    )
    for key in found["keys"]:
        for other in key["others"]:
            again = api.run(CASE, (*written(FEW), *other["settings"]))
            assert other["values"]["life_L10"] == approx(again["rigid.life_L10"].to("Mrev").number, rel=1e-12)
            assert other["values"]["max_roller_load"] == approx(again.rigid["inner_load"].max(), rel=1e-12)


def test_tolerance_classes_are_tried_at_both_ends():
    case = CONFIGS / "catalogue" / "nu210.toml"
    settings = {"assumed": [], "outputs.assumed_effects": True}
    result = api.run(case, settings)
    (key,) = result.attributes["assumed_effects"]["keys"]
    tight, loose = key["others"]
    assert (tight["words"], loose["words"]) == ("tightest, clearance 8.9 um", "loosest, clearance 58.3 um")
    loosest = api.run(case, {"bearing.fits.at": "loosest"})
    assert loose["values"]["modified_life"] == approx(
        loosest["rigid.modified_life"].to("Mrev").number, rel=1e-12
    )
    assert tight["values"]["modified_life"] > result.attributes["assumed_effects"]["of"]["modified_life"]
    assert "tightest, clearance 8.9 µm" in html(of_result(result)).partition('id="clearance"')[2]


@pytest.mark.parametrize("units", [METRIC, IMPERIAL], ids=lambda units: units.name)
def test_numbers_of_the_page_are_those_of_the_file_and_the_largest_effect_is_first(weighed, units):
    document = of_result(api.read(weighed), units)
    require_equal(Page(html(document)).cells, Numbers(weighed))
    (inputs,) = [section for section in document.sections if section.name == "inputs"]
    (table,) = [block for block in inputs.blocks if block.kind == "table" and "toleranced" in block.caption]
    ratios = [float(row[3].text) for row in table.rows[1:]]
    effects = {}
    for row, ratio in zip(table.rows[1:], ratios, strict=True):
        effects[row[0]] = max(effects.get(row[0], 1), ratio, 1 / ratio)
    assert list(effects) == ["bearing.clearance", "lubricant.traction", "bearing.cage.pocket_friction"]
    assert all(first >= second for first, second in pairwise(effects.values()))
    assert "assumed-effects" in {figure.name for figure in document.figures}


def test_a_page_without_effects_names_the_command_that_computes_them(tmp_path):
    api.run(CASE, FEW, output=tmp_path / "plain.h5")
    (page,) = report(tmp_path / "plain.h5")
    said = "flexbearing run nu209.toml --set outputs.assumed_effects=true"
    assert said in "".join(Page(page.read_text("utf-8")).text)


def test_what_cannot_be_computed_is_told_on_the_page(weighed):
    result = api.read(weighed)
    found = result.attributes["assumed_effects"]
    row = {"words": "mirror", "settings": [], "values": {}, "problem": "not converged: 40 iterations"}
    keys = [{**found["keys"][0], "others": [row]}]
    attributes = {**result.attributes, "assumed_effects": {**found, "keys": keys}}
    told = "bearing.clearance = mirror: not converged: 40 iterations"
    assert told in html(of_result(replace(result, attributes=attributes)))


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_every_assumed_key_of_every_case_has_other_values(path):
    if "studies" in path.parts:
        pytest.skip("a study, no case")
    case = api.read_case(path)
    tried = list(plausible(case))
    for key in (*case.assumed, *case.calibrated):
        covering = [each for each in tried if f"{each.key}.".startswith(f"{key}.")]
        assert covering, key
        assert all(each.others and each.source for each in covering), key
    assert all(other.words for each in tried for other in each.others)
