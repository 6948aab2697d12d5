"""Materials by name stand for the values that makers and handbooks print."""

from typing import Any

import pytest
from pytest import approx

from flexbearing import api
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.case.explain import explain
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.findings.load_limits import BARS
from tests.places import CONFIGS

PAPER, FITS, FAST, SLOW = (
    CONFIGS / f"{name}.toml" for name in ("mao2016", "nu209_fits", "harris218", "slewing_bolted")
)

# E [Pa], nu, density [kg/m^3], expansion [1/K], yield stress [Pa], copied from what is named beside them
PRINTED = {
    # SNFA, "A New Material for Spindle Bearings": bearing steel 210 kN/mm2, 0.30; SAE 52100: 7.81 g/cm3, 11.9
    # um/(m K) from 23 to 280 degC; AISI 52100 chrome steel balls: 295 000 psi
    "100Cr6": (210e9, 0.30, 7810.0, 11.9e-6, 295e3 * 6894.757),
    # BTI Metals, AISI M50 VIM-VAR: 214 GPa, 7.87 g/cm3, 11.84 um/(m K) from 21 to 204 degC; MakeItFrom: 0.29
    "M50": (214e9, 0.29, 7870.0, 11.84e-6, None),
    # SNFA, as above: silicon nitride 315 kN/mm2, 0.26, 3.19 g/cm3, 3.2e-6/K
    "Si3N4": (315e9, 0.26, 3190.0, 3.2e-6, None),
    # EN 1993-1-1, 3.2.6 and table 3.1 (S235, t <= 40 mm), density of EN 1991-1-1
    "structural steel": (210e9, 0.30, 7850.0, 12e-6, 235e6),
    # SN-Castiron, EN-GJL-250: 103 to 118 GPa, 0.26, 7.20 g/cm3, Rp0.1 165 to 228 MPa; MakeItFrom: 11 um/(m K)
    "grey cast iron": (110e9, 0.26, 7200.0, 11e-6, 165e6),
}


@pytest.mark.parametrize(("name", "printed"), PRINTED.items(), ids=PRINTED.keys())
def test_named_material_has_the_printed_values(name, printed):
    ring = read_case(FITS, {"materials.outer_ring": name}).materials.outer_ring
    found = (ring.youngs_modulus, ring.poisson_ratio, ring.density, ring.expansion, ring.yield_stress)
    assert found[:4] == approx(printed[:4], rel=1e-12)
    assert found[4] == (None if printed[4] is None else approx(printed[4], rel=2e-4))
    assert ring.name == name


def test_every_named_material_is_tested():
    assert tuple(PRINTED) == type(read_case(FITS).materials.outer_ring).by_name


@pytest.mark.parametrize(
    ("file", "part", "values"),
    [
        (FITS, "roller", {"youngs_modulus", "poisson_ratio", "density", "expansion"}),
        (FAST, "ball", {"youngs_modulus", "poisson_ratio", "density", "expansion"}),
        (FAST, "inner_ring", {"youngs_modulus", "poisson_ratio", "density", "expansion", "yield_stress"}),
        (SLOW, "ball", {"youngs_modulus", "poisson_ratio"}),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_result_stores_name_and_values(file, part, values):
    stored = read_case(file, {f"materials.{part}": "Si3N4"}).to_json()["materials"][part]
    assert stored.pop("name") == "Si3N4"
    assert set(stored) == values
    assert stored["youngs_modulus"] == 315e9


def test_a_setting_changes_one_value_of_a_named_material():
    shaft = read_case(FITS, {"materials.shaft.density": "7000 kg/m^3"}).materials.shaft
    assert (shaft.density, shaft.youngs_modulus, shaft.name) == (7000.0, 210e9, None)


def test_a_name_takes_the_place_of_a_table_and_of_what_was_assumed_of_it():
    case = read_case(FAST, {"materials.ball": "Si3N4"})
    before = read_case(FAST)
    assert any(key.startswith("materials.ball.") for key in before.assumed)
    assert not any(key.startswith("materials.ball") for key in case.assumed)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("steel", 'roller = "steel" is no material of the list; it must be "100Cr6" or "M50" or'),
        ({"name": "M50"}, 'name = "M50" cannot be; it must be another name: M50 is written as text in place'),
        (7, "[materials] roller = 7 is not allowed"),
        ({"name": ["M50"]}, "[materials.roller] name"),
    ],
    ids=["unknown name", "known name in a table", "number", "list"],
)
def test_what_is_no_material_is_refused(given, said):
    with pytest.raises(BadCase) as problem:
        check(PAPER, {"materials.roller": given})
    assert said in str(problem.value)


def test_an_unknown_name_is_the_only_problem_that_is_told():
    with pytest.raises(BadCase) as problem:
        check(PAPER, {"materials.roller": "steel"})
    assert len(str(problem.value).splitlines()) == 1


def test_explain_lists_the_names_with_values_and_sources():
    text = explain("materials.roller", FAMILIES)
    assert all(f'materials.roller = "{name}": ' in text for name in PRINTED)
    assert "EN 1993-1-1" in text


def test_yield_stress_of_a_named_material_limits_the_bars():
    result = api.run(PAPER, {"materials.outer_ring": "structural steel", "accuracy.structure": "beam"})
    (found,) = [each for each in result.attributes["findings"] if each["code"] == "yield-stress"]
    assert (found["limit"], found["place"], found["verdict"]) == (235e6, BARS, "not met")


def test_variants_by_name_and_by_value_are_the_cases_that_are_read():
    keys = ("materials.shaft", "materials.roller.density", "operation.radial_load")
    variants = Variants(FITS, FITS.read_text(), keys, FAMILIES)
    for values in (
        ("M50", "7000 kg/m^3", "4 kN"),
        ("100Cr6", "7100 kg/m^3", "5 kN"),
        ("100Cr6", "7200 kg/m^3", "6 kN"),
        (None, None, "6 kN"),
    ):
        given = {key: value for key, value in zip(keys, values, strict=True) if value is not None}
        assert variants.case(values) == read_case(FITS, given)


def test_a_variant_cannot_take_the_name_of_another_material():
    variants = Variants(PAPER, PAPER.read_text(), ("materials.roller.name",), FAMILIES)
    case: Any = variants.case(("my steel",))
    assert case.materials.roller.name == "my steel"
    with pytest.raises(BadCase, match="another name: M50"):
        variants.case(("M50",))


@pytest.mark.parametrize("file", [FAST, CONFIGS / "joshi2015_qj309.toml"], ids=lambda file: file.stem)
def test_rings_beside_ceramic_balls_are_of_steel(file):
    """The modulus of the balls was that of the rings, too: 725 in place of 668 MPa."""

    def pressure(**materials):
        settings = {f"materials.{name}": material for name, material in materials.items()}
        result = api.run(file, settings)
        return result.rigid["peak_pressure"].max(), {note["code"] for note in result.attributes["notes"]}

    steel = {"inner_ring": "100Cr6", "outer_ring": "100Cr6"}
    (hybrid, notes), (stated, _) = pressure(ball="Si3N4"), pressure(ball="Si3N4", **steel)
    ceramic, _ = pressure(ball="Si3N4", **dict.fromkeys(steel, "Si3N4"))
    assert hybrid == approx(stated, rel=1e-12)
    assert ceramic > 1.05 * hybrid
    assert "hybrid" in notes
    assert "hybrid" not in pressure(ball="M50")[1]
