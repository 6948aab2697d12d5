"""Roller bearings as REXS: valid by its published schema, in its axes, and back as a case."""

import tomllib
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pytest import approx

import flexbearing
from flexbearing import BadCase
from flexbearing.__main__ import command
from flexbearing.api import check
from flexbearing.catalogue.rexs.bearings import bearing as bearing_of
from flexbearing.catalogue.rexs.file import read
from flexbearing.exports import rexs
from flexbearing.runs import run_case

ROOT, HERE = Path(__file__).parents[2], Path(__file__).parent / "rexs"
CASE, PLAIN = ROOT / "configs" / "catalogue" / "nu1012.toml", ROOT / "configs" / "nu209.toml"
BEARING = "rolling_bearing_with_detailed_geometry"


def exported(case, settings, folder):
    result = flexbearing.run(case, settings, output=folder / "r.h5")
    (path,) = rexs.export(result, folder)
    return result, path


@pytest.fixture(scope="module")
def catalogue(tmp_path_factory):
    return exported(CASE, {}, tmp_path_factory.mktemp("rexs"))


@pytest.fixture(scope="module", params=["3000 rpm", "-3000 rpm"])
def turning(request, tmp_path_factory):
    settings = {"operation.inner_speed": request.param, "operation.load_direction": "30 deg"}
    return exported(PLAIN, settings, tmp_path_factory.mktemp("rexs"))


@cache
def schema():
    return ElementTree.parse(HERE / "rexs_schema_1.7_bearings.xml").getroot()


def by(tag, name, value=None):
    return {each.get(name): each if value is None else each.get(value) for each in schema().iter(tag)}


def of_case(path, kind, place="load_spectrum/load_case/component"):
    """Attributes of the components of a kind, arrays as arrays."""
    found = []
    for component in ElementTree.parse(path).getroot().iterfind(place):
        if component.get("type") == kind:
            found.append({each.get("id"): number(each) for each in component.iterfind("attribute")})
    return found


def number(attribute):
    if (array := attribute.find("array")) is not None:
        return np.array([float(each.text) for each in array.iterfind("c")])
    try:
        return float(attribute.text)
    except ValueError:
        return attribute.text


def test_file_is_valid_by_the_published_xsd(catalogue):
    etree = pytest.importorskip("lxml.etree")
    valid = etree.XMLSchema(etree.parse(HERE / "rexs-file.xsd"))
    valid.assertValid(etree.parse(catalogue[1]))


def test_attributes_belong_to_their_components_in_their_units_and_ranges(catalogue):
    units, types = by("unit", "id", "name"), by("valueType", "id", "name")
    attributes, kinds = by("attribute", "attributeId"), by("component", "componentId")
    allowed = {
        (each.get("componentId"), each.get("attributeId"))
        for each in schema().iter("componentAttributeMapping")
    }
    components = [*ElementTree.parse(catalogue[1]).getroot().iter("component")]
    assert len(components) > 100
    for component in components:
        assert component.get("type") in kinds
        for given in component.iterfind("attribute"):
            name = given.get("id")
            declared = attributes[name]
            assert (component.get("type"), name) in allowed
            assert given.get("unit") == units[declared.get("unit")]
            require_type(given, declared, types[declared.get("valueType")])


def require_type(given, declared, kind):
    assert (given.find("array") is not None) == (kind == "floating_point_array")
    if kind == "enum":
        assert given.text in [each.get("value") for each in declared.iter("enumValue")]
    elif kind == "integer":
        int(given.text)
    elif kind in ("floating_point", "floating_point_array"):
        value = np.atleast_1d(number(given))
        assert value.dtype == float
        assert np.isfinite(value).all()
        if (least := declared.get("rangeMin")) is not None:
            above = np.greater if declared.get("rangeMinIntervalOpen") == "true" else np.greater_equal
            assert above(value, float(least)).all(), declared.get("attributeId")
    else:
        assert kind == "string"


def test_relations_are_combinations_that_the_schema_allows(catalogue):
    root = ElementTree.parse(catalogue[1]).getroot()
    kinds = {each.get("id"): each.get("type") for each in root.iterfind("components/component")}
    known = by("relation", "relationId")
    relations = [*root.iterfind("relations/relation")]
    assert len({each.get("id") for each in relations}) == len(relations)
    for relation in relations:
        declared = known[relation.get("type")]
        parts = {ref.get("role"): kinds[ref.get("id")] for ref in relation.iterfind("ref")}
        combinations = [
            {role.get("roleId"): role.get("componentId") for role in each}
            for each in declared.iter("allowedCombination")
        ]
        assert parts in combinations
        assert ("order" in relation.attrib) == (declared.get("orderRequired") == "true")


def test_bearing_load_case_and_lives_are_those_of_the_result(catalogue):
    result, path = catalogue
    (bearing,) = of_case(path, BEARING, "components/component")
    assert bearing["inner_diameter"] == approx(60, rel=1e-12)
    assert bearing["radial_clearance_class"] == "C0"
    assert bearing["radial_bearing_clearance"] == approx(55, rel=1e-12)  # mean of CN, ISO 5753, 50 to 65 mm
    assert bearing["radial_dynamic_load_rating"] == approx(37.4, rel=1e-12)
    (row,) = of_case(path, "rolling_bearing_row", "components/component")
    assert (row["number_of_rolling_elements"], row["reference_diameter"]) == (19, approx(77.5, rel=1e-12))
    (steel, *_) = of_case(path, "material", "components/component")
    assert (steel["elastic_modulus"], steel["density"]) == (approx(210e3, rel=1e-12), approx(7.81, rel=1e-12))
    (loaded,) = of_case(path, BEARING)
    assert loaded["speed_inner_ring"] == approx(3000, rel=1e-12)
    assert loaded["temperature_lubricant"] == approx(70, rel=1e-12)
    assert loaded["force_acting_on_inner_component_w"] == approx(-3000, rel=1e-12)
    for name, output in (("nominal", "life_L10"), ("modified", "modified_life")):
        stem = f"{name}_reference_rating_life"
        for unit, given in (("Mrev", "rotations"), ("h", "time")):
            assert loaded[f"{stem}_{given}_iso_16281_2008"] == approx(
                float(result[output].to(unit)), rel=1e-12
            )


@pytest.mark.sampled(2)
def test_lives_by_another_capacity_are_left_out(turning):
    (loaded,) = of_case(turning[1], BEARING)
    assert not [name for name in loaded if "life" in name]


def test_forces_of_the_rollers_hold_the_load_in_the_axes_of_the_file(turning):
    """Of both directions of rotation: the ring turns positively about u, angles count from v towards w."""
    result, path = turning
    (loaded,) = of_case(path, BEARING)
    assert loaded["speed_inner_ring"] == approx(3000, rel=1e-12)
    assert loaded["speed_rolling_element_set"] > 0
    angles = np.radians(
        [
            each["angular_position_around_u"]
            for each in of_case(path, "rolling_element", "components/component")
        ]
    )
    forces = np.array([each["rolling_element_force"] for each in of_case(path, "rolling_element_contact")])[
        ::2
    ]
    held = 1e3 * forces @ np.column_stack([np.cos(angles), np.sin(angles)])
    applied = [loaded[f"force_acting_on_inner_component_{axis}"] for axis in "vw"]
    assert np.hypot(*applied) == approx(4450, rel=1e-12)
    assert_allclose(held, applied, rtol=0, atol=2e-2 * 4450)  # tractions hold the rest
    sense = np.sign(result.attributes["case_si"]["operation"]["inner_speed"])
    y, z = result.flexible["applied_load"]
    assert_allclose(applied, [sense * y, -z], rtol=1e-12)


def test_laminae_add_up_to_the_force_of_the_roller(turning):
    for contact in of_case(turning[1], "rolling_element_contact"):
        total = contact["rolling_element_lamina_load"].sum()
        assert_allclose(total, 1e3 * contact["rolling_element_force"], rtol=1e-9, atol=1e-9)
        assert (np.diff(contact["rolling_element_coordinate"]) > 0).all()


def test_bearing_comes_back_as_a_case(catalogue, tmp_path, monkeypatch):
    def never(*_, **__):
        raise BadCase("not here")

    before = tomllib.loads(CASE.read_text())
    monkeypatch.setattr(run_case, "effects", never)
    back = tmp_path / "back.toml"
    assert command(["new", str(back), "--from-rexs", str(catalogue[1]), "--width", "18 mm"]) == 0
    after = tomllib.loads(back.read_text())
    one, other = (flexbearing.api.check(path) for path in (CASE, back))
    assert other.bearing.rollers == one.bearing.rollers
    assert other.bearing.outer_raceway_diameter == approx(one.bearing.outer_raceway_diameter, rel=1e-12)
    for name in ("diameter", "length", "profile"):
        assert getattr(other.bearing.roller, name) == getattr(one.bearing.roller, name)
    assert after["bearing"]["clearance_class"] == before["bearing"]["clearance_class"]
    assert after["materials"]["roller"] == before["materials"]["roller"]
    assert after["lubricant"]["oil"] == before["lubricant"]["oil"]
    assert other.lubricant.inlet_temperature == approx(one.lubricant.inlet_temperature, rel=1e-12)
    for name in ("radial_load", "inner_speed"):
        assert getattr(other.operation, name) == approx(getattr(one.operation, name), rel=1e-9)
    for name in ("dynamic_rating", "static_rating", "fatigue_limit_load"):
        assert getattr(other.life, name) == approx(getattr(one.life, name), rel=1e-12)


def test_a_changed_bearing_is_exported_with_its_changed_rating(tmp_path):
    _, path = exported(CASE, {"bearing.roller.length": "6 mm"}, tmp_path)
    (attributes,) = of_case(path, BEARING, "components/component")
    length = check(CASE).bearing.roller.length
    assert attributes["radial_dynamic_load_rating"] == approx(37.4 * (6e-3 / length) ** (7 / 9), rel=1e-6)


def test_options_count_more_than_the_model(catalogue, tmp_path, monkeypatch):
    monkeypatch.setattr(run_case, "effects", lambda *_, **__: (_ for _ in ()).throw(BadCase("not here")))
    words = ["--from-rexs", str(catalogue[1]), "--width", "18 mm", "--load", "7 kN"]
    assert command(["new", str(tmp_path / "c.toml"), *words]) == 0
    assert tomllib.loads((tmp_path / "c.toml").read_text())["operation"]["radial_load"] == "7 kN"


WRONG = {
    "no XML": ("<model", "is no XML"),
    "a DOCTYPE": ('<!DOCTYPE m [<!ENTITY a "b">]><model version="1.7"/>', "has a DOCTYPE"),
    "another format": ("<html/>", "no model of REXS 1.x"),
    "version 2": ('<model version="2.0"/>', "no model of REXS 1.x"),
    "no bearing": ('<model version="1.7"/>', f"no {BEARING}"),
    "a unit of another kind": (
        f'<model version="1.7"><components><component id="4" type="{BEARING}">'
        '<attribute id="bearing_type" unit="none">radial_roller_bearing</attribute>'
        '<attribute id="width" unit="m">0.018</attribute></component></components></model>',
        "no case for 4: component 4: width is 0.018 m, no number in mm",
    ),
    "a bearing of another kind": (
        f'<model version="1.7"><components><component id="4" type="{BEARING}">'
        '<attribute id="bearing_type" unit="none">axial_self_aligning_roller_bearing</attribute>'
        "</component></components></model>",
        "no case for axial_self_aligning_roller_bearing: 4",
    ),
}  # fmt: skip


def bearing(attributes="", order="1", row="16", more=""):
    """A bearing with its row, with whatever another program may write."""
    return (
        f'<model version="1.4"><relations><relation id="7" type="ordered_assembly" order="{order}">'
        '<ref id="4" role="assembly"/><ref id="5" role="part"/></relation></relations><components>'
        f'<component id="4" type="{BEARING}"><attribute id="bearing_type" unit="none">radial_roller_bearing'
        f'</attribute>{attributes}</component><component id="5" type="rolling_bearing_row"><attribute '
        f'id="number_of_rolling_elements" unit="none">{row}</attribute></component>{more}</components>'
        "</model>"
    )


def entries(path, number="4"):
    """Kind and entries of a bearing."""
    model = read(path)
    found = bearing_of(model, model.parts[number])
    return found.like, found.options


NUMBERS = (
    "nan",
    "inf",
    "1e400",
    "1" * 5000,
    "\N{FULLWIDTH DIGIT ONE}\N{FULLWIDTH DIGIT SIX}",
    "",
    "0x10",
    "1_6",
)


@pytest.mark.parametrize("number", NUMBERS, ids=lambda number: number[:5])
@pytest.mark.parametrize("key", ["row", "order", "bore"])
def test_what_is_no_number_is_refused_in_a_short_line(key, number, tmp_path):
    bore = f'<attribute id="inner_diameter" unit="mm">{number}</attribute>'
    model = bearing(bore) if key == "bore" else bearing(**{key: number})
    (tmp_path / "m.rexs").write_text(model, encoding="utf-8")
    with pytest.raises(BadCase, match=r"no number|no whole number|above|longer than a number") as problem:
        entries(tmp_path / "m.rexs")
    assert len(str(problem.value)) < 300


@pytest.mark.parametrize("number", ["2", "1001", "1e9", "14.5", "-16"])
def test_elements_of_a_row_are_a_whole_number_that_a_bearing_can_have(number, tmp_path, capsys):
    (tmp_path / "m.rexs").write_text(bearing(row=number))
    words = ["--from-rexs", str(tmp_path / "m.rexs"), "-d", "50 mm", "-D", "90 mm", "-B", "20 mm"]
    assert command(["new", str(tmp_path / "c.toml"), *words]) == 2
    assert "a whole number from 3 to 1000" in capsys.readouterr().err


@pytest.mark.parametrize(
    "encoding", ["foo-bar", "big5", "utf-7", "idna", "shift_jis", "punycode", "x" * 5000, "utf-32"]
)
def test_an_encoding_that_is_not_allowed_is_refused_in_a_line(encoding, tmp_path):
    (tmp_path / "m.rexs").write_text(f'<?xml version="1.0" encoding="{encoding}"?>{bearing()}')
    with pytest.raises(BadCase, match=r"is in the encoding .*; allowed are utf-8") as problem:
        entries(tmp_path / "m.rexs")
    assert len(str(problem.value)) < 300


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "us-ascii", "iso-8859-1", "windows-1252"])
def test_encodings_that_are_allowed_are_read(encoding, tmp_path):
    text = f'<?xml version="1.0" encoding="{encoding}"?>{bearing()}'
    (tmp_path / "m.rexs").write_text(text, encoding=encoding)
    assert entries(tmp_path / "m.rexs") == ("cylindrical_roller", {"elements": "16"})


def test_only_the_first_of_many_bearings_are_listed(tmp_path, capsys):
    of_kind = '<attribute id="bearing_type" unit="none">radial_roller_bearing</attribute>'
    more = "".join(
        f'<component id="x{k}" type="{BEARING}" name="{"n" * 60}">{of_kind}</component>' for k in range(2000)
    )
    (tmp_path / "m.rexs").write_text(bearing(more=more))
    for choice in ([], ["--rexs-bearing", "none"]):
        words = ["new", str(tmp_path / "c.toml"), "--from-rexs", str(tmp_path / "m.rexs"), *choice]
        assert command(words) == 2
        problem = capsys.readouterr().err
        assert "and 1993 more" in problem
        assert len(problem) < 1000


def test_two_components_of_one_id_are_refused(tmp_path):
    (tmp_path / "m.rexs").write_text(bearing(more=f'<component id="4" type="{BEARING}"/>'))
    with pytest.raises(BadCase, match="two components with the id 4"):
        read(tmp_path / "m.rexs")


@pytest.mark.parametrize(("text", "complaint"), WRONG.values(), ids=WRONG)
def test_models_without_such_a_bearing_are_refused(text, complaint, tmp_path, capsys):
    (tmp_path / "m.rexs").write_text(text)
    assert command(["new", str(tmp_path / "c.toml"), "--from-rexs", str(tmp_path / "m.rexs")]) == 2
    assert complaint in capsys.readouterr().err


def test_one_of_several_bearings_is_chosen(tmp_path, capsys):
    bearings = "".join(
        f'<component id="{number}" type="{BEARING}">'
        f'<attribute id="bearing_type" unit="none">{kind}</attribute>'
        f'<attribute id="inner_diameter" unit="mm">{bore}</attribute></component>'
        for number, kind, bore in ((4, "radial_roller_bearing", 50), (9, "radial_grooved_ball_bearing", 40))
    )
    path = tmp_path / "m.rexs"
    path.write_text(f'<model version="1.4"><components>{bearings}</components></model>')
    assert entries(path, "9") == ("deep_groove_ball", {"bore": "40 mm"})
    assert entries(path, "4") == ("cylindrical_roller", {"bore": "50 mm"})
    assert command(["new", str(tmp_path / "c.toml"), "--from-rexs", str(path), "--rexs-bearing", "5"]) == 2
    assert "no bearing 5; there are 4, 9" in capsys.readouterr().err


def test_two_rows_have_their_rollers_each_and_come_back_as_none(tmp_path):
    """A case that is made from a model has one row."""
    _, path = exported(PLAIN, {"bearing.second_row.distance": "25 mm"}, tmp_path)
    model = ElementTree.parse(path).getroot()
    rows = [each.get("id") for each in model.iter("component") if each.get("type") == "rolling_bearing_row"]
    assemblies = [each for each in model.iter("relation") if each.get("type") == "ordered_assembly"]
    parts = [{ref.get("role"): ref.get("id") for ref in each.iter("ref")} for each in assemblies]
    assert [sum(part["assembly"] == row for part in parts) for row in rows] == [14, 14]
    with pytest.raises(BadCase, match="2 rows"):
        bearing_of(*_only_bearing(path))


def _only_bearing(path):
    model = read(path)
    return model, next(each for each in model.parts.values() if each.kind == BEARING)


def test_ball_bearings_have_no_export_yet(tmp_path):
    result = flexbearing.run(ROOT / "configs" / "harris218.toml", output=tmp_path / "b.h5")
    with pytest.raises(BadCase, match="takes roller bearings"):
        next(rexs.export(result, tmp_path))
