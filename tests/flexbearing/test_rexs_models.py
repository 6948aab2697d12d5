"""Gearbox models of REXS 1.0 to 1.7, as XML, JSON and archive: a case for each bearing."""

import io
import json
import tomllib
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import pytest

from flexbearing import BadCase, api, inputs
from flexbearing.__main__ import command
from flexbearing.catalogue import page as pages
from flexbearing.catalogue.rexs.bearings import bearing as bearing_of
from flexbearing.catalogue.rexs.file import ENDINGS, read
from flexbearing.catalogue.rexs.load_cases import Point, heaviest, points
from flexbearing.catalogue.rexs.parts import Model, Part, Value
from flexbearing.catalogue.rexs.unused import unused_around

HERE = Path(__file__).parent / "rexs"
OLD, NEW = (HERE / f"gearbox_{version}.rexs" for version in ("1.0", "1.4"))
VERSIONS = [f"1.{minor}" for minor in range(8)]
DETAILED, CATALOGUE = (f"rolling_bearing_with_{form}_geometry" for form in ("detailed", "catalog"))


@pytest.fixture
def written(tmp_path, monkeypatch, capsys):
    """What `new` writes of a model without computing it: exit code, cases by name, its messages."""

    def never(*_, **__):
        raise BadCase("not here")

    def of(*words):
        code = command(["new", *map(str, words)])
        cases = {path.name: tomllib.loads(path.read_text()) for path in tmp_path.glob("*.toml")}
        return code, cases, capsys.readouterr().err

    monkeypatch.setattr(api, "compute", never)
    monkeypatch.setattr("flexbearing.runs.run_case.effects", never)
    monkeypatch.chdir(tmp_path)
    return of


def test_catalogue_bearings_of_1_0_become_cases(written):
    code, cases, messages = written(OLD)
    assert (code, {*cases}) == (0, {"gearbox_1.0-3.toml", "gearbox_1.0-4.toml"})
    ball, roller = cases["gearbox_1.0-3.toml"], cases["gearbox_1.0-4.toml"]
    assert (ball["kind"], ball["title"]) == ("deep_groove_ball", "6308")
    assert ball["life"]["dynamic_rating"] == "42.5 kN"
    assert ball["life"]["static_rating"] == "25 kN"
    assert ball["life"]["fatigue_limit_load"] == "1.64 kN"
    assert ball["operation"]["inner_speed"] == "1450 rpm"
    assert ball["operation"]["load"]["radial_z"] == "4250 N"
    assert "operation.load.radial_z" in ball["assumed"]
    assert "operation.inner_speed" not in ball["assumed"]
    assert (roller["bearing"]["kind"], roller["life"]["dynamic_rating"]) == ("cylindrical_roller", "93 kN")
    assert {"bearing.roller.diameter", "bearing.outer_raceway_diameter"} <= {*roller["assumed"]}
    (of_ball,) = (line for line in messages.splitlines() if line.startswith("3 (6308): "))
    assert "assumed: load" in of_ball
    assert "not used: contamination_factor_according_to_din_26281" in of_ball
    assert "nominal_contact_angle" in of_ball
    assert "misalignment_in_v_direction" in of_ball


def test_load_cases_of_1_4_become_a_duty_cycle(written, tmp_path):
    code, cases, messages = written(NEW)
    assert (code, {*cases}) == (0, {"gearbox_1.4.toml", "gearbox_1.4_cycle.toml"})
    case = cases["gearbox_1.4.toml"]
    assert case["life"]["dynamic_rating"] == "37 kN"
    assert case["operation"]["load"] == {"radial_z": "4200 N"}
    assert case["lubricant"]["inlet_temperature"] == "70 degC"
    assert cases["gearbox_1.4_cycle.toml"]["case"] == "gearbox_1.4.toml"
    assert cases["gearbox_1.4_cycle.toml"]["duty"] == {"file": "gearbox_1.4_duty.csv"}
    head, *rows = (tmp_path / "gearbox_1.4_duty.csv").read_text().splitlines()
    assert head == (
        "time [%],operation.load.radial_z [N],operation.load.axial [N],operation.inner_speed [rpm],"
        "lubricant.inlet_temperature [degC]"
    )
    assert [[float(cell) for cell in row.split(",")] for row in rows] == [
        [20, 4200, 0, 1450, 70],
        [80, 0, 0, 0, 70],
    ]
    assert "load case 1 of 2" in messages


def spectrum_of(shares=("30", "70"), forces=("2", "1"), version="1.7"):
    """A deep groove bearing with two load cases in the words of a version."""
    old, share = version == "1.0", "load_duration_fraction" if version < "1.3" else "operating_time_fraction"
    rating = "{}_capacity" if old else "radial_{}_load_rating"
    unit, force = ("kN", "radial_force_in_v") if old else ("N", "force_acting_on_inner_component_v")
    none, scale = "" if version == "1.4" else "none", 1 if old else 1000
    root = ElementTree.Element("model", version=version)
    relation = ElementTree.SubElement(ElementTree.SubElement(root, "relations"), "relation", type="side")
    for number, role in (("3", "assembly"), ("2", "inner_part"), ("5", "outer_part")):
        ElementTree.SubElement(relation, "ref", id=number, role=role)
    components = ElementTree.SubElement(root, "components")
    add(components, "1", "gear_unit")
    add(components, "2", "shaft", rotational_speed=("1000", "1 / min"))
    add(
        components, "3", CATALOGUE, bearing_type=("radial_grooved_ball_bearing", none),
        inner_diameter=("50", "mm"), outer_diameter=("90", "mm"), width=("20", "mm"),
        **{rating.format("dynamic"): ("37", "kN"), rating.format("static"): ("23", "kN")},
    )  # fmt: skip
    add(components, "5", "gear_casing", temperature_lubricant=("60", "C"))
    spectrum = ElementTree.SubElement(root, "load_spectrum", id="1")
    for part, load in zip(shares, forces, strict=True):
        case = ElementTree.SubElement(spectrum, "load_case")
        add(case, "1", "gear_unit", **{share: (part, "%")} if part else {})
        add(case, "3", CATALOGUE, **{force: (f"{scale * float(load):g}", unit)} if load else {})
    return root


def add(place, number, kind, **attributes):
    part = ElementTree.SubElement(place, "component", id=number, type=kind)
    for name, (text, unit) in attributes.items():
        ElementTree.SubElement(part, "attribute", id=name, unit=unit).text = text


def of_name(name, text, unit):
    attribute = ElementTree.Element("attribute", id=name, unit=unit)
    attribute.text = text
    return attribute


def as_json(root):
    """The JSON form of a model; numbers are numbers there."""

    def components(place):
        return [
            {
                "id": int(part.get("id")),
                "type": part.get("type"),
                "attributes": [value(each) for each in part.iterfind("attribute")],
            }
            for part in place.iterfind("component")
        ]

    def value(attribute):
        named = {name: text for name, text in attribute.attrib.items() if text}
        if (array := attribute.find("array")) is not None:
            return named | {"floating_point_array": [float(cell.text) for cell in array]}
        try:
            return named | {"floating_point": float(attribute.text)}
        except ValueError:
            return named | {"enum": attribute.text}

    relations = [
        {
            "id": number,
            "type": relation.get("type"),
            "refs": [{"id": int(ref.get("id")), "role": ref.get("role")} for ref in relation],
        }
        for number, relation in enumerate(root.iterfind("relations/relation"))
    ]
    cases = [
        {"id": place, "components": components(case)}
        for place, case in enumerate(root.iter("load_case"), 1)
    ]  # fmt: skip
    model = {"version": root.get("version"), "relations": relations}
    model["components"] = components(root.find("components"))
    model["load_spectrum"] = {"id": 1, "load_cases": cases}
    return json.dumps({"model": model}).encode()


def archive(**members):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in members.items():
            packed.writestr(name, content)
    return file.getvalue()


@pytest.mark.parametrize("form", ["rexs", "rexsj", "rexsz", "rexsjz"])
@pytest.mark.parametrize("version", VERSIONS)
def test_every_version_in_every_form_gives_the_same_bearing(version, form, tmp_path):
    root, member = spectrum_of(version=version), form.removesuffix("z")
    content = as_json(root) if member == "rexsj" else ElementTree.tostring(root)
    path = tmp_path / "m"
    path.write_bytes(archive(**{f"m.{member}": content}) if form.endswith("z") else content)
    model = read(path)
    found = bearing_of(model, model.parts["3"])
    assert found.like == "deep_groove_ball"
    assert found.options == {
        "bore": "50 mm", "outside": "90 mm", "width": "20 mm", "dynamic_rating": "37 kN",
        "static_rating": "23 kN", "load": "2000 N", "speed": "1000 rpm", "temperature": "60 degC",
    }  # fmt: skip
    assert [point.radial for point in found.points] == [2000, 1000]
    assert [point.shares for point in found.points] == [{"%": 30}, {"%": 70}]
    assert found.not_used == ()


@pytest.mark.parametrize("path", [OLD, NEW], ids=lambda path: path.stem)
def test_json_of_the_public_forms_is_read_as_their_xml(path, tmp_path):
    (tmp_path / "m.rexsj").write_bytes(as_json(ElementTree.parse(path).getroot()))
    xml, other = read(path), read(tmp_path / "m.rexsj")
    for number in (number for number, part in xml.parts.items() if part.kind == CATALOGUE):
        one, two = (bearing_of(model, model.parts[number]) for model in (xml, other))
        assert (one.like, one.options, one.points) == (two.like, two.options, two.points)
        assert {*one.not_used} == {*two.not_used}


def test_degree_sign_of_1_0_is_a_degree(tmp_path):
    root = spectrum_of(version="1.0")
    (part,) = root.iterfind("components/component[@id='3']")
    part[0].text = "angular_contact_ball_bearing"
    ElementTree.SubElement(part, "attribute", id="nominal_contact_angle", unit="\N{DEGREE SIGN}").text = "25"
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    model = read(tmp_path / "m.rexs")
    assert bearing_of(model, model.parts["3"]).options["angle"] == "25 deg"


def of_attributes(tmp_path, kind="radial_grooved_ball_bearing", **attributes):
    """The bearing of a model with these attributes beside its kind, without load cases."""
    root = spectrum_of()
    root.remove(root.find("load_spectrum"))
    components = root.find("components")
    components.remove(components.find("component[@id='3']"))
    add(components, "3", CATALOGUE, bearing_type=(kind, "none"), **attributes)
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    model = read(tmp_path / "m.rexs")
    return bearing_of(model, model.parts["3"])


FORCES = {
    "on the inner side": ("N", 1, -2, [f"force_acting_on_inner_component_{axis}" for axis in "uvw"]),
    "on the outer side": ("N", 1, 2, [f"force_acting_on_outer_component_{axis}" for axis in "uvw"]),
    "of 1.0": ("kN", 1000, -2, ["axial_force", "radial_force_in_v", "radial_force_in_w"]),
}


@pytest.mark.parametrize(("unit", "scale", "axial", "names"), FORCES.values(), ids=FORCES)
def test_forces_along_the_shaft_and_across_it(unit, scale, axial, names, tmp_path):
    """The axial force on the inner ring has its sign, positive along u."""
    forces = {name: (text, unit) for name, text in zip(names, ("-2", "3", "-4"), strict=True)}
    found = of_attributes(tmp_path, **forces)
    assert (found.options["axial"], found.options["load"]) == (f"{axial * scale} N", f"{5 * scale} N")
    assert found.not_used == ()
    assert "on the inner ring, positive along u" in found.side


def test_a_force_as_a_vector_lies_along_the_shaft_and_across_it():
    part = Part("3", CATALOGUE, "", {"reaction_force": Value("N", "", ("-2", "3", "-4"))})
    (point,) = points(Model("1.4", {"3": part}, {}, ()), part)
    assert (point.axial, point.radial) == (-2.0, 5.0)


def test_a_case_is_of_the_most_load_among_those_that_turn():
    turning = [
        Point({}, radial=load, speeds=(speed, 0.0)) for load, speed in ((9.0, 0.0), (3.0, 5.0), (4.0, -5.0))
    ]
    assert heaviest(turning) == 2
    assert heaviest(turning[:1]) == 0


@pytest.fixture
def reversing(tmp_path):
    """An angular contact bearing with axial forces of -1250 N and 300 N; its rings turn, too."""
    root = spectrum_of()
    (part,) = root.iterfind("components/component[@id='3']")
    part[0].text = "angular_contact_ball_bearing"
    for case, (force, inner, outer) in zip(
        root.iter("load_case"), (("-1250", "0", "500"), ("300", "-20", "0")), strict=True
    ):
        speeds = {"speed_inner_ring": (inner, "1 / min"), "speed_outer_ring": (outer, "1 / min")}
        add(case, "3", CATALOGUE, force_acting_on_inner_component_u=(force, "N"), **speeds)
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    return tmp_path / "m.rexs"


def test_largest_axial_force_presses_the_balls_on_their_shoulders(reversing, written, tmp_path):
    code, cases, messages = written("m.rexs")
    assert (code, cases["m.toml"]["operation"]["load"]["axial"]) == (0, "1250 N")
    heading, *rows = (tmp_path / "m_duty.csv").read_text().splitlines()
    place = heading.split(",").index("operation.load.axial [N]")
    assert [float(row.split(",")[place]) for row in rows] == [1250, -300]
    assert (
        "positive along -u, assumed to press the balls on their shoulders, as that of load case 1" in messages
    )


def test_a_deep_groove_bearing_under_thrust_has_no_radial_load(written, tmp_path):
    root = spectrum_of(forces=(None, None))
    for case, force in zip(root.iter("load_case"), ("1250", "300"), strict=True):
        add(case, "3", CATALOGUE, force_acting_on_inner_component_u=(force, "N"))
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    _, cases, messages = written("m.rexs")
    case = cases["m.toml"]
    assert case["operation"]["load"] == {"axial": "1250 N"}
    assert not any("load" in key for key in case["assumed"])
    assert "assumed: load" not in messages
    heading, *rows = (tmp_path / "m_duty.csv").read_text().splitlines()
    place = heading.split(",").index("operation.load.axial [N]")
    assert [float(row.split(",")[place]) for row in rows] == [1250, 300]
    assert command(["study", "m_cycle.toml", "--check"]) == 0


def test_rings_turn_as_in_the_model(reversing, written, tmp_path):
    _, cases, _ = written("m.rexs")
    operation = cases["m.toml"]["operation"]
    assert (operation["inner_speed"], operation["outer_speed"]) == ("0 rpm", "500 rpm")
    heading, *rows = (tmp_path / "m_duty.csv").read_text().splitlines()
    places = [heading.split(",").index(f"operation.{ring}_speed [rpm]") for ring in ("inner", "outer")]
    assert [[float(row.split(",")[place]) for place in places] for row in rows] == [[0, 500], [-20, 0]]
    assert command(["study", "m_cycle.toml", "--check"]) == 0


CONE = {
    "inner_diameter": ("35", "mm"), "outer_diameter": ("72", "mm"), "width": ("23", "mm"),
    "static_load_rating": ("78", "kN"), "catalogue_value_e": ("0.37", "none"),
}  # fmt: skip


def cones(
    tmp_path, axial=(None, None), radial=("8", "1"), kind="radial_tapered_roller_bearing", **attributes
):
    """A tapered bearing, or one of another kind, under two load cases."""
    root = spectrum_of()
    components = root.find("components")
    components.remove(components.find("component[@id='3']"))
    add(components, "3", CATALOGUE, bearing_type=(kind, "none"), **attributes)
    for case, *forces in zip(root.iter("load_case"), axial, radial, strict=True):
        given = zip(("axial_force", "radial_force_in_v"), forces, strict=True)
        case.remove(case.find("component[@id='3']"))
        add(case, "3", CATALOGUE, **{name: (force, "kN") for name, force in given if force})
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))


def test_a_tapered_bearing_has_the_angle_of_its_e_and_is_pressed_by_its_largest_thrust(written, tmp_path):
    cones(tmp_path, ("-4", "0"), ("8", None), **CONE)
    code, cases, messages = written("m.rexs")
    case = cases["m.toml"]
    assert (code, case["kind"], case["operation"]["inner_speed"]) == (0, "tapered_roller", "1000 rpm")
    assert case["operation"]["load"] == {"axial": "4000 N", "radial_z": "8000 N"}
    assert float(case["bearing"]["cup_angle"].removesuffix(" deg")) == pytest.approx(13.8564, abs=1e-4)
    assert "positive along -u, assumed to press the cone into the cup, as that of load case 1" in messages
    assert {"bearing.rollers", "bearing.pitch_diameter", "bearing.rib.angle"} <= {*case["assumed"]}
    assert "bearing.cup_angle" not in case["assumed"]
    assert command(["study", "m_cycle.toml", "--check"]) == 0  # nothing presses it in the second load case


@pytest.mark.parametrize("kind", ["axial_roller_bearing", "axial_needle_roller_bearing"])
def test_thrust_bearings_are_cases_under_their_thrust_alone(written, tmp_path, kind):
    given = {"inner_diameter": ("50", "mm"), "outer_diameter": ("70", "mm"), "width": ("14", "mm"),
             "axial_static_load_rating": ("166", "kN")}  # fmt: skip
    cones(tmp_path, ("-4", "0"), (None, None), kind, **given)
    code, cases, messages = written("m.rexs")
    case = cases["m.toml"]
    assert (code, case["kind"], case["operation"]["load"]) == (0, "thrust_roller", {"axial": "4000 N"})
    assert case["life"]["static_rating"] == "166 kN"
    assert "assumed to press the shaft washer on the rollers, as that of load case 1" in messages
    assert "not all loads press the shaft washer on the rollers" in messages


def test_spherical_bearings_are_cases_with_both_rows(written, tmp_path):
    given = {"inner_diameter": ("50", "mm"), "outer_diameter": ("90", "mm"), "width": ("23", "mm"),
             "radial_static_load_rating": ("108", "kN"), "number_of_bearing_rows": ("2", "none"),
             "catalogue_value_e": ("0.24", "none")}  # fmt: skip
    cones(tmp_path, ("-4", "0"), ("8", "3"), "radial_self_aligning_roller_bearing", **given)
    code, cases, _ = written("m.rexs")
    case = cases["m.toml"]
    load = {"axial": "-4000 N", "radial_z": "8000 N"}
    assert (code, case["kind"], case["operation"]["load"]) == (0, "spherical_roller", load)
    assert float(case["bearing"]["contact_angle"].removesuffix(" deg")) == pytest.approx(9.0903, abs=1e-4)


def test_needle_bearings_are_cases_of_cylinders(written, tmp_path):
    given = {"inner_diameter": ("50", "mm"), "outer_diameter": ("72", "mm"), "width": ("22", "mm")}
    cones(tmp_path, kind="radial_needle_roller_bearing", **given)
    _, cases, _ = written("m.rexs")
    assert cases["m.toml"]["bearing"]["roller"]["diameter"] == "4.4 mm"


def test_a_tapered_bearing_without_thrust_has_that_of_its_radial_load(written, tmp_path):
    """F_r/(2 Y) = 1.25 tan(alpha) F_r, assumed as the angle is."""
    given = {"catalogue_value_e": ("0", "none"), "shaft_tolerance_class": ("m5", "none")}
    cones(tmp_path, **(CONE | given))
    _, cases, messages = written("m.rexs")
    assert cases["m.toml"]["bearing"]["cup_angle"] == "14 deg"
    assert cases["m.toml"]["operation"]["load"]["axial"] == "2493 N"
    assert {"operation.load.axial", "bearing.cup_angle"} <= {*cases["m.toml"]["assumed"]}
    assert cases["m.toml"]["bearing"]["fits"]["shaft"] == "m5"
    assert "assumed: angle, axial" in messages
    assert "no duty cycle of its 2 load cases: not all loads press the cone into the cup" in messages


def test_pitch_circle_and_angle_of_a_detailed_tapered_bearing_are_its_own(written, tmp_path):
    root = ElementTree.parse(HERE / "surroundings_1.4.rexs").getroot()
    (kind,) = root.iterfind("components/component[@id='3']/attribute[@id='bearing_type']")
    kind.text = "radial_tapered_roller_bearing"
    (row,) = root.iterfind("components/component[@id='12']")
    row.append(of_name("reference_diameter", "61", "mm"))
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    model = read(tmp_path / "m.rexs")
    found = bearing_of(model, model.parts["3"])
    assert (found.options["pitch_diameter"], found.options["angle"]) == ("61 mm", "40 deg")
    _, cases, _ = written("m.rexs", "--contact-angle", "14 deg")
    case = cases["m-3.toml"]
    assert (case["bearing"]["pitch_diameter"], case["bearing"]["cup_angle"]) == ("61 mm", "14 deg")
    assert "bearing.pitch_diameter" not in case["assumed"]


def test_sizes_that_a_model_lacks_are_those_of_its_designation(written, tmp_path):
    """As in the public model of an industrial gearbox, which has designations of its bearings alone."""
    table = "designation,like,bore,outside,width\n33014,{},70 mm,110 mm,31 mm\n"
    (tmp_path / "designations.csv").write_text(table.format("tapered_roller"))
    cones(tmp_path, catalogue_designation=("33014", "none"), width=("25", "mm"))
    code, cases, messages = written("m.rexs")
    assert (code, cases["m.toml"]["bearing"]["pitch_diameter"]) == (0, "90 mm")
    assert "from designations.csv: bore, outside; assumed: angle, axial" in messages
    assert '--width "25 mm"' in (tmp_path / "m.toml").read_text()
    (tmp_path / "designations.csv").write_text(table.format("cylindrical_roller"))
    assert "has no bore, outside diameter" in written("m.rexs", "--force")[2]


def test_axial_force_of_a_cylindrical_roller_bearing_is_reported(tmp_path):
    force = {"force_acting_on_inner_component_u": ("300", "N")}
    found = of_attributes(tmp_path, "radial_roller_bearing", **force)
    assert found.not_used == ("axial force",)


def test_what_is_not_used_is_listed_by_name_with_zeros_last(tmp_path):
    given = {name: (text, "none") for name, text in zip("edcba", ("1", "0.0", "3", "", "x"), strict=True)}
    assert of_attributes(tmp_path, **given).not_used == ("a", "c", "e", "b", "d")


def test_speed_of_a_four_point_bearing_is_that_of_one_ring_over_the_other(tmp_path):
    kind = "four_point_contact_ball_bearing"
    found = of_attributes(tmp_path, kind, speed_outer_ring=("1200", "1 / min"))
    assert (found.options["speed"], found.options.get("outer_speed")) == ("200 rpm", None)


NOT_USED = {
    "lubricant": {
        "density_at_15_degree_celsius", "oil_cleanliness", "viscosity_at_100_degree_celsius",
        "viscosity_at_40_degree_celsius",  # 95 mm^2/s of an oil that is called ISO VG 100
    },
    "bearing_ring": {"inner_diameter", "raceway_radius"},
    "rolling_bearing_cage": {"cage_mass"},
    "material": {"elastic_modulus", "poisson_ratio"},
}  # fmt: skip


def test_what_is_not_used_of_parts_and_surroundings_is_named_by_kind(written):
    code, _, messages = written(HERE / "surroundings_1.4.rexs")
    lines = messages.splitlines()
    assert code == 0
    for kind, attributes in NOT_USED.items():
        (line, *_) = [line for line in lines if line.startswith(f"  not used of {kind}: ")]
        assert {*line.partition(": ")[2].split(", ")} == attributes
    assert "not used of gear_unit: application_factor, reliability, required_lifetime" in lines


def test_shafts_with_sections_and_materials_and_whole_components_are_named(written, tmp_path):
    """What bearings sit on, by attributes; gears, load cases' own components and relations by their kinds."""
    root = ElementTree.parse(HERE / "surroundings_1.4.rexs").getroot()
    components, relations = root.find("components"), root.find("relations")
    add(components, "20", "shaft_section", shaft_bore=("20", "mm"))
    add(components, "21", "material", material_designation=("42CrMo4", "none"))
    add(components, "22", "cylindrical_gear", number_of_teeth=("31", "none"))
    components.find("component[@id='2']").extend(
        [of_name("shaft_bore", "12", "mm"), of_name("speed", "7", "1 / min")]
    )
    for kind, roles in (
        ("ordered_assembly", {"2": "assembly", "20": "part"}),
        ("reference", {"20": "origin", "21": "referenced"}),
        ("assembly", {"2": "assembly", "22": "part"}),
        ("stage", {"22": "gear_1"}),
    ):
        relation = ElementTree.SubElement(relations, "relation", type=kind, id="99")
        for number, role in roles.items():
            ElementTree.SubElement(relation, "ref", id=number, role=role)
    add(ElementTree.SubElement(ElementTree.SubElement(root, "load_spectrum"), "load_case"), "77", "motor")
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    lines = written("m.rexs")[2].splitlines()
    assert "not used of shaft: shaft_bore, speed" in lines
    assert "not used of shaft_section: shaft_bore" in lines
    assert "not used of material: material_designation" in lines
    assert "not used: cylindrical_gear (1), motor (1), relation stage" in lines


def test_attributes_of_rows_are_not_used_by_their_namesakes_of_the_bearing(tmp_path):
    root = ElementTree.parse(HERE / "surroundings_1.4.rexs").getroot()
    root.find("components/component[@id='12']").append(of_name("inner_diameter", "41", "mm"))
    root.find("components/component[@id='3']").append(of_name("speed_inner_ring", "9", "1 / min"))
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    model = read(tmp_path / "m.rexs")
    found = bearing_of(model, model.parts["3"])
    assert {*found.not_used} == {"inner_diameter", "nominal_contact_angle"}
    left = unused_around(model, [model.parts["3"]], [model.parts["2"]])
    assert left == {"shaft": ("rotational_speed",)}  # the ring has its own speed


def test_a_second_measure_of_time_and_a_casing_that_no_bearing_asks_are_named(tmp_path):
    root = spectrum_of()
    for case, hours in zip(root.iter("load_case"), ("300", "700"), strict=True):
        unit, bearing, *_ = case.findall("component")
        unit.append(of_name("operating_time", hours, "h"))
        bearing.append(of_name("temperature_lubricant", "80", "C"))
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    model = read(tmp_path / "m.rexs")
    bearing, parts = model.parts["3"], [model.parts[number] for number in "15"]
    left = unused_around(model, [bearing], parts)
    assert left == {"gear_unit": ("operating_time",), "gear_casing": ("temperature_lubricant",)}
    assert [point.shares["%"] for point in bearing_of(model, bearing).points] == [30, 70]


def test_an_oil_of_the_gear_unit_alone_is_named_with_the_unit(written, tmp_path):
    text = (HERE / "surroundings_1.4.rexs").read_text()
    (tmp_path / "m.rexs").write_text(
        text.replace('<ref id="5" role="origin"/>', '<ref id="1" role="origin"/>')
    )
    lines = written("m.rexs")[2].splitlines()
    (line,) = [line for line in lines if line.strip().startswith("not used of lubricant: ")]
    assert {*line.partition(": ")[2].split(", ")} == NOT_USED["lubricant"]


def test_of_two_contact_angles_the_one_that_is_not_used_is_named():
    model = read(HERE / "surroundings_1.4.rexs")
    found = bearing_of(model, model.parts["3"])
    assert (found.options["angle"], found.not_used) == ("40 deg", ("nominal_contact_angle",))


def test_a_four_point_bearing_without_load_has_an_assumed_one(written):
    """It has no ratings in its case, but one in the model."""
    _, cases, messages = written(HERE / "surroundings_1.4.rexs")
    case = cases["surroundings_1.4-6.toml"]
    assert case["operation"]["load"]["axial"] == "5600 N"
    assert "operation.load.axial" in case["assumed"]
    assert "6 (QJ208): assumed: axial" in messages


def test_a_class_counts_more_than_a_clearance_in_operation(tmp_path):
    clearance = {"operating_radial_bearing_clearance": ("12", "mum")}
    assert of_attributes(tmp_path, **clearance).options["clearance"] == "12 um"
    both = of_attributes(tmp_path, radial_clearance_class=("C3", "none"), **clearance)
    assert (both.options["clearance_class"], both.options.get("clearance")) == ("C3", None)
    assert both.not_used == ("operating_radial_bearing_clearance",)


UNUSABLE = {
    "shares": ((("30", ""), ("2", "1")), "not all have a share of the time"),
    "forces": ((("30", "70"), ("2", "")), "not all have a force on the bearing"),
    "time": ((("-30", "130"), ("2", "1")), "their shares of the time are below zero"),
    "any time": ((("0", "0"), ("2", "1")), "their shares of the time are below zero, or none is above it"),
}


@pytest.mark.slow
@pytest.mark.parametrize(("given", "why"), UNUSABLE.values(), ids=UNUSABLE)
def test_load_cases_that_make_no_duty_cycle_are_reported(given, why, written, tmp_path):
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(spectrum_of(*given)))
    code, cases, messages = written("m.rexs")
    assert (code, {*cases}) == (0, {"m.toml"})
    assert f"no duty cycle of its 2 load cases: {why}" in messages


@pytest.mark.slow
def test_shares_that_do_not_add_up_are_scaled_with_a_message(written, tmp_path):
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(spectrum_of(("30", "60"))))
    _, _, messages = written("m.rexs")
    assert "add up to 90 %" in messages
    assert (tmp_path / "m_duty.csv").read_text().startswith("time,operation")


def test_a_study_takes_the_duty_cycle(written, tmp_path):
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(spectrum_of()))
    assert written("m.rexs", "--source", "of\nours", "--temperature", "70 degC")[0] == 0
    assert "temperature" not in (tmp_path / "m_duty.csv").read_text()
    assert command(["study", "m_cycle.toml", "--check"]) == 0


def test_bearings_without_a_case_are_named_beside_those_that_have_one(written, tmp_path):
    root = spectrum_of()
    components = root.find("components")
    add(components, "7", CATALOGUE, bearing_type=("axial_tapered_roller_bearing", ""))
    add(components, "8", "slide_bearing")
    rows = {"bearing_type": ("radial_roller_bearing", ""), "number_of_bearing_rows": ("2", "")}
    add(components, "9", DETAILED, **rows)
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    code, cases, messages = written("m.rexs")
    assert (code, {*cases}) == (0, {"m-3.toml", "m-3_cycle.toml"})
    assert "no case for axial_tapered_roller_bearing: 7" in messages
    assert "no case for slide_bearing: 8" in messages
    assert "no case for 9: has 2 rows" in messages


@pytest.mark.slow
def test_a_bearing_without_dimensions_takes_them_from_options(written, tmp_path):
    root = spectrum_of()
    (part,) = root.iterfind("components/component[@id='3']")
    for each in [each for each in part if each.get("unit") == "mm"]:
        part.remove(each)
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    code, cases, messages = written("m.rexs")
    assert (code, cases) == (2, {})
    assert "has no bore, outside diameter, width; give --bore, --outside, --width" in messages
    assert written("m.rexs", "-d", "50 mm", "-D", "90 mm", "-B", "20 mm")[0] == 0


def test_a_clearance_of_the_user_replaces_the_class_of_the_model(written, tmp_path):
    root = spectrum_of()
    (part,) = root.iterfind("components/component[@id='3']")
    ElementTree.SubElement(part, "attribute", id="radial_clearance_class", unit="none").text = "C3"
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(root))
    code, cases, _ = written("m.rexs", "--clearance", "10 um")
    assert (code, cases["m.toml"]["bearing"]["clearance"]) == (0, "10 um")
    assert "clearance_class" not in cases["m.toml"]["bearing"]


def test_too_many_load_cases_are_refused(tmp_path):
    spectrum = f"<load_spectrum>{'<load_case/>' * 10_001}</load_spectrum>"
    (tmp_path / "m.rexs").write_text(f'<model version="1.4"><components/>{spectrum}</model>')
    with pytest.raises(BadCase, match="has 10001 load cases; at most 10000"):
        read(tmp_path / "m.rexs")


@pytest.mark.parametrize(("text", "what"), [
    (f'<model version="1.4">{"<a/>" * 1_000_000}</model>', "tags"),
    ('{"model": {"x": [' + "1, " * 1_000_000 + "1]}}", "values"),
], ids=["XML", "JSON"])  # fmt: skip
def test_more_parts_than_memory_is_for_are_refused_before_they_are_read(text, what, tmp_path):
    (tmp_path / "m.rexs").write_text(text)
    with pytest.raises(BadCase, match=f"has more than 1000000 {what}"):
        read(tmp_path / "m.rexs")


def test_nothing_replaces_files_that_are_there(written, tmp_path):
    (tmp_path / "m.rexs").write_bytes(ElementTree.tostring(spectrum_of()))
    (tmp_path / "m_duty.csv").write_text("mine")
    code, _, messages = written("m.rexs")
    assert (code, (tmp_path / "m_duty.csv").read_text()) == (2, "mine")
    assert "--force replaces it" in messages


@pytest.mark.parametrize(("bore", "outside", "diameter", "raceway"), [(50, 90, 11, 81.5), (45, 85, 11, 76.5)])
def test_assumed_raceways_are_near_those_of_catalogues(bore, outside, diameter, raceway):
    """An NU 210 and an NU 209, by their catalogue pages."""
    given = {"bore": f"{bore} mm", "outside": f"{outside} mm", "load": "1 kN", "speed": "1 rpm"}
    found = pages.read("cylindrical_roller", given | {"width": "20 mm"})
    assert {*found.assumed} == {"diameter", "outer_raceway"}
    for name, length in (("diameter", diameter), ("outer_raceway", raceway)):
        assert 1e3 * found[name].si == pytest.approx(length, rel=0.02)


BOMB = archive(**{"m.rexs": b" " * (2**25 + 1)})
ARCHIVES = {
    "no model": (archive(a="1"), "with 0 files"),
    "two models": (archive(**{"a.rexs": "1", "b.rexsj": "2"}), "with 2 files"),
    "a way out": (archive(**{"../m.rexs": "1"}), "leads out of its folder"),
    "a root": (archive(**{"/m.rexs": "1"}), "leads out of its folder"),
    "many files": (archive(**{f"{k}.gde": "" for k in range(101)}), "at most 100"),
    "too large": (BOMB, "larger than 32 MiB when unpacked"),
    "cut off": (archive(**{"m.rexs": "1" * 100})[:-30], "damaged archive"),
    "packed too large": (b"PK\x03\x04" + b"\0" * 2**22, "archive larger than 4 MiB"),
}


@pytest.mark.parametrize(("content", "complaint"), ARCHIVES.values(), ids=ARCHIVES)
def test_archives_are_guarded(content, complaint, tmp_path):
    (tmp_path / "m.rexsz").write_bytes(content)
    with pytest.raises(BadCase, match=complaint) as problem:
        read(tmp_path / "m.rexsz")
    assert len(str(problem.value)) < 500


def test_a_damaged_member_is_refused():
    packed = bytearray(archive(**{"m.rexs": bytes(range(256)) * 20}))
    packed[60] ^= 0xFF
    with pytest.raises(inputs.Unreadable):
        inputs.unpacked(bytes(packed), ENDINGS, 2**20)


JSONS = {
    "cut off": '{"model": {',
    "no model": '{"version": "1.4"}',
    "components that are none": '{"model": {"version": "1.4", "components": [1]}}',
    "a deep one": '{"model": ' + "[" * 100_000 + "]" * 100_000 + "}",
    "version 2": '{"model": {"version": "2.0"}}',
    "no UTF-8": '{"model": "\xff"}',
}


@pytest.mark.parametrize("text", JSONS.values(), ids=JSONS)
def test_what_is_no_json_of_rexs_is_refused_in_a_line(text, tmp_path):
    (tmp_path / "m.rexsj").write_bytes(text.encode("latin-1"))
    with pytest.raises(BadCase, match=r"is no JSON|is no model of REXS") as problem:
        read(tmp_path / "m.rexsj")
    assert len(str(problem.value).splitlines()) == 1


@pytest.mark.parametrize("number", ["NaN", "1e400", "9" * 5000, "true", "null", '"0x10"'])
def test_numbers_of_json_are_guarded(number, tmp_path):
    text = as_json(spectrum_of()).decode().replace('"floating_point": 50.0', f'"floating_point": {number}')
    (tmp_path / "m.rexsj").write_text(text)
    model = read(tmp_path / "m.rexsj")
    with pytest.raises(BadCase, match="component 3: inner_diameter: ") as problem:
        bearing_of(model, model.parts["3"])
    assert len(str(problem.value)) < 300
