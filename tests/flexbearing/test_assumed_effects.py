"""Effects of assumed and calibrated inputs: each is that of the case run with the settings it names."""

from dataclasses import replace
from itertools import pairwise
from math import inf

import pytest
from pytest import approx

from flexbearing import api
from flexbearing.case.read import written
from flexbearing.quantities.effects import about
from flexbearing.report.html import IMPERIAL, METRIC, effects, html, of_result
from flexbearing.report.html.reader import Reader
from flexbearing.runs.plausible import plausible
from quasidynamic.outcome import life_factors
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
    keys = [each["key"] for each in found["keys"] if each["role"] == "input"]
    assert keys == [*FEW["calibrated"], *FEW["assumed"]]
    assert found["of"]["life_L10"] == approx(
        api.run(CASE, FEW)["rigid.life_L10"].to("Mrev").number, rel=1e-12
    )
    for key in found["keys"]:
        for other in key["others"]:
            again = api.run(CASE, (*written(FEW), *other["settings"]))
            lives = "modified_life" if key["key"].startswith("life.") else "life_L10"  # rules with factors
            life = again[f"rigid.{lives}"].to("Mrev").number
            assert other["values"]["life_L10"] == approx(life, rel=1e-12)
            assert other["values"]["max_roller_load"] == approx(again.rigid["inner_load"].max(), rel=1e-12)


@pytest.mark.slow
def test_tolerance_classes_are_tried_at_both_ends():
    case = CONFIGS / "catalogue" / "nu210.toml"
    settings = {"assumed": [], "outputs.assumed_effects": True}
    result = api.run(case, settings)
    (key,) = [each for each in result.attributes["assumed_effects"]["keys"] if each["role"] == "input"]
    tight, loose = key["others"]
    assert (tight["words"], loose["words"]) == ("tightest, clearance 8.9 um", "loosest, clearance 58.3 um")
    loosest = api.run(case, {"bearing.fits.at": "loosest"})
    assert loose["values"]["modified_life"] == approx(
        loosest["rigid.modified_life"].to("Mrev").number, rel=1e-12
    )
    assert tight["values"]["modified_life"] > result.attributes["assumed_effects"]["of"]["modified_life"]
    assert "tightest, clearance 8.9 µm" in html(of_result(result)).partition('id="full"')[2]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("units", [METRIC, IMPERIAL], ids=lambda units: units.name)
def test_numbers_of_the_page_are_those_of_the_file_and_the_largest_effect_is_first(weighed, units):
    document = of_result(api.read(weighed), units)
    require_equal(Page(html(document)).cells, Numbers(weighed))
    rows = [row for row in document.parts["effects_table"].rows if not isinstance(row[3], str)]
    largest = {}
    for row, ratio in zip(rows, (row[3].size for row in rows), strict=True):
        largest[row[0]] = max(largest.get(row[0], 1), ratio, 1 / ratio)
    asked = [key for key in largest if key in (*FEW["assumed"], *FEW["calibrated"])]
    assert asked == ["bearing.clearance", "lubricant.traction", "bearing.cage.pocket_friction"]
    assert all(first >= second for first, second in pairwise(largest.values()))
    assert "assumed-effects" in {figure.name for figure in document.figures}


@pytest.mark.slow
def test_all_changes_at_once_are_solved_together(weighed):
    found = api.read(weighed).attributes["assumed_effects"]
    shorter, longer = found["together"]
    for each in (shorter, longer):
        again = api.run(CASE, (*written(FEW), *each["settings"]))
        name = "modified_life" if "life.capacity=iso281" in each["settings"] else "life_L10"
        assert each["values"]["life_L10"] == approx(again[f"rigid.{name}"].to("Mrev").number, rel=1e-12)
    assert not set(shorter["settings"]) & set(longer["settings"])
    assert not any("radial_load" in text for each in (shorter, longer) for text in each["settings"])
    singles = [other["values"]["life_L10"] for key in found["keys"] if key["role"] != "comparison"
               for other in key["others"] if other["values"]]  # fmt: skip
    assert shorter["values"]["life_L10"] <= min(singles)
    assert longer["values"]["life_L10"] >= max(singles)


def test_loads_are_compared_and_in_no_range(weighed):
    reader = Reader(api.read(weighed), METRIC)
    keys = reader.attributes["assumed_effects"]["keys"]
    assert [each["key"] for each in keys if each["role"] == "comparison"] == ["operation.radial_load"]
    assert "operation.radial_load" not in effects.changes(reader)


@pytest.mark.slow
def test_the_range_of_a_modified_life_keeps_a_iso_within_its_limits(tmp_path):
    settings = {
        "assumed": ["lubricant.inlet_temperature", "life.cleanliness"],
        "outputs.assumed_effects": True,
        "life.modification": "bearing",
    }
    api.run(CONFIGS / "catalogue" / "nu210.toml", settings, output=tmp_path / "oil.h5")
    reader = Reader(api.read(tmp_path / "oil.h5"), METRIC)
    (factor,) = [
        each["value"] for each in reader.attributes["life"]["rigid"]["factors"] if each["name"] == "a_ISO"
    ]
    of_oil = {key: changes for key, changes in effects.changes(reader).items()
              if key in settings["assumed"]}  # fmt: skip
    unbound, bound = (effects.span_of(of_oil, room) for room in ((inf, inf), effects._room(reader)))
    assert unbound.squares[1] * factor > 50
    assert bound.squares[1] * factor == approx(50, rel=0.03)  # the basic life grows by 2 % in colder oil
    assert bound.squares[0] == unbound.squares[0]
    of_all = effects.span(reader)
    solved = reader.attributes["assumed_effects"]["together"][1]["values"]["modified_life"]
    assert of_all.worst[1] == approx(solved / reader.attributes["assumed_effects"]["of"]["modified_life"])


def test_drop_and_profile_of_rollers_count_once():
    assert about("bearing.roller.drop") == about("bearing.roller.profile")
    both = {"bearing.roller.drop", "bearing.roller.profile"}
    assert both <= set(api.read_case(CONFIGS / "mao2016.toml").assumed)


def test_limits_of_factors_are_those_of_their_rules():
    assert effects._LIMITS["a_ISO"][1] == life_factors.LARGEST_MODIFICATION
    least = life_factors.modification_factor(1.0, 0.0).value
    assert effects._LIMITS["a_ISO"][0] == approx(float(least))
    assert effects._LIMITS["film"] == (min(life_factors.FILM_FACTORS), max(life_factors.FILM_FACTORS))


def test_what_cannot_be_computed_is_told_on_the_page(weighed):
    result = api.read(weighed)
    found = result.attributes["assumed_effects"]
    row = {"words": "mirror", "settings": [], "values": {}, "problem": "not converged: 40 iterations"}
    keys = [{**found["keys"][0], "others": [row]}]
    attributes = {**result.attributes, "assumed_effects": {**found, "keys": keys}}
    (row,) = of_result(replace(result, attributes=attributes)).parts["effects_table"].rows
    assert (row[0], row[1], row[-1]) == ("bearing.clearance", "mirror", "not converged: 40 iterations")


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
