"""Effects of assumed inputs next to a case: used for its inputs alone, and read from no comment."""

import json
import re
import shutil
from dataclasses import replace

import pytest
from pytest import approx

from flexbearing import BadCase, api
from flexbearing.__main__ import command
from flexbearing.report.html import METRIC, effects, of_result
from flexbearing.report.html.reader import Reader
from flexbearing.runs import effects_file
from tests.flexbearing.hostile_cases import CONFIGS

NU210 = CONFIGS / "catalogue" / "nu210.toml"
SHIPPED = sorted(CONFIGS.rglob(f"*{effects_file.ENDING}"))
BARE = {"case": {}, "files": ""}
HEAVY = "operation.radial_load=30 kN"


def life(result):
    """Span of the life by inputs; None where it is not known."""
    span = effects.span(Reader(result, METRIC))
    return None if span is None else span.squares


@pytest.fixture
def case(tmp_path):
    """A copy of a case with its effects."""
    for name in (NU210, effects_file.name(NU210)):
        shutil.copy(name, tmp_path)
    return tmp_path / NU210.name


def test_an_edited_comment_changes_no_range(case):
    before = life(api.run(case))
    text = case.read_text()
    edited = re.sub(r"# assumed: rule of thumb", "# assumed: rule of thumb; life 50 times with 0.1", text)
    assert edited != text
    case.write_text(edited)
    assert life(api.run(case)) == before


def test_ranges_of_other_loads_are_left_out_and_the_page_says_so():
    result = api.run(NU210, [HEAVY])
    assert result.attributes["effects_left_out"] == effects_file.LEFT_OUT
    assert "assumed_effects" not in result.attributes
    assert life(result) is None
    assert of_result(result).parts["stale"] == effects_file.LEFT_OUT


@pytest.mark.slow
def test_ranges_computed_at_another_load_are_those_of_that_load():
    fresh = api.run(NU210, [HEAVY, "outputs.assumed_effects=true"])
    assert life(fresh) == approx((0.493, 2.59), rel=0.01)
    assert life(api.run(NU210)) == approx((0.252, 8.98), rel=0.01)


def test_outputs_and_title_of_a_case_are_no_inputs_but_what_is_assumed_is():
    for setting in ("outputs.catalogue_life=true", "title=another"):
        assert "assumed_effects" in api.run(NU210, [setting]).attributes
    for setting in (
        "accuracy.slices=31",
        "lubricant.inlet_temperature=71 degC",
        'assumed=["life.cleanliness"]',
    ):
        assert "assumed_effects" not in api.run(NU210, [setting]).attributes


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.name)
def test_shipped_effects_are_of_their_case(path):
    case = api.read_case(path.with_name(path.name.replace(effects_file.ENDING, ".toml")))
    assert set(effects_file.attributes(case)) == {"assumed_effects"}


def test_fourteen_cases_have_effects():
    assert len(SHIPPED) == 14


@pytest.mark.parametrize("name", ["6209", "joshi2015_fourpoint"])
def test_card_names_what_moves_another_output_where_nothing_moves_the_first(name):
    card = repr(api.run(CONFIGS / f"{name}.toml"))
    assert re.search(r"uncertain +friction torque\W.*x0\.5\.\.1\.5 by friction coefficient", card)
    assert "Young's modulus" not in card  # which moves it by 2 %


def test_exported_effects_are_found_by_later_runs(tmp_path):
    case, settings = tmp_path / "case.toml", {"assumed": ["lubricant.traction"]}
    shutil.copy(CONFIGS / "nu209.toml", case)
    computed = api.run(case, settings | {"outputs.assumed_effects": True}, output=tmp_path / "out.h5")
    assert "assumed_effects" not in api.run(case, settings).attributes
    assert command(["export", str(tmp_path / "out.h5"), "--to", "effects", "-o", str(tmp_path)]) == 0
    found = api.run(case, settings).attributes["assumed_effects"]
    assert found["of"] == approx(computed.attributes["assumed_effects"]["of"], rel=1e-5)
    api.run(case, settings, output=tmp_path / "plain.h5")
    (tmp_path / "case.effects.json").unlink()
    assert "assumed_effects" in api.read(tmp_path / "plain.h5").attributes  # the result has them itself
    api.run(case, output=tmp_path / "without.h5")
    assert command(["export", str(tmp_path / "without.h5"), "--to", "effects"]) == 2


@pytest.mark.parametrize(
    "text",
    ["", "{", "[" * 100_000, json.dumps(BARE), json.dumps(BARE | {"effects": {"of": 1}})],
    ids=["empty", "cut off", "nested", "without effects", "other form"],
)
def test_a_file_that_is_none_of_effects_is_refused_in_one_line(case, text):
    effects_file.name(case).write_text(text)
    with pytest.raises(BadCase) as problem:
        api.run(case)
    assert "nu210.effects.json" in str(problem.value)
    assert len(str(problem.value).replace(str(case.parent), "")) < 300
    assert "\n" not in str(problem.value)


def test_effects_of_a_drawing_depend_on_its_content(tmp_path):
    (drawing,) = api.read_case(CONFIGS / "step_ring.toml").named_files
    case = tmp_path / "step_ring.toml"
    shutil.copy(CONFIGS / case.name, case)
    (copy,) = api.read_case(case).named_files
    copy.parent.mkdir(exist_ok=True)
    shutil.copy(drawing, copy)
    effects = json.loads(effects_file.name(NU210).read_text())["effects"]
    effects_file.name(case).write_bytes(effects_file.content(api.read_case(case), effects))
    assert "assumed_effects" in effects_file.attributes(api.read_case(case))
    copy.write_bytes(copy.read_bytes() + b"\n")
    assert "assumed_effects" not in effects_file.attributes(api.read_case(case))


def tables(values):
    """The tables of stored inputs, and those within them."""
    yield values
    for value in values.values():
        if isinstance(value, dict):
            yield from tables(value)


def test_effects_stored_before_a_key_was_declared_are_of_the_case_that_does_not_give_it(case):
    content, place = json.loads(effects_file.name(case).read_text()), effects_file.name(case)
    for key in ["coupling", "film_heating", "fillet"]:
        (table,) = [table for table in tables(content["case"]) if key in table]
        table.pop(key)
    place.write_text(json.dumps(content))
    assert "assumed_effects" in effects_file.attributes(api.read_case(case))
    for given in ["coupling.fallback=false", "lubricant.film_heating=true"]:
        assert "assumed_effects" not in effects_file.attributes(api.read_case(case, [given]))


def test_results_read_no_comment():
    result = api.run(NU210)
    bare = re.sub(r"(?m)\s*#.*$", "", result.attributes["case_text"])
    stripped = replace(result, attributes={**result.attributes, "case_text": bare})
    assert life(stripped) == life(result)


@pytest.mark.slow
@pytest.mark.parametrize("key", ["bearing.roller.drop", "lubricant.oil_fraction", "outer.bar_width"])
def test_effects_of_the_paper_bearing_are_those_of_its_runs(key):
    path = CONFIGS / "mao2016.toml"
    effects = api.run(path).attributes["assumed_effects"]
    (found,) = [each for each in effects["keys"] if each["key"] == key]
    for other in found["others"]:
        again = api.run(path, other["settings"])
        for name, value in other["values"].items():
            assert value == approx(again[name].number, rel=1e-3, abs=1e-6), name
