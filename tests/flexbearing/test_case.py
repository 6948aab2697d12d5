"""Case files mean what they say."""

import subprocess
import sys
from math import pi

import pytest
from hypothesis import given, strategies as st
from pydantic import TypeAdapter
from pytest import approx

from flexbearing import explain
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.case.declarations import declarations
from flexbearing.case.quantity import Length, Speed, Temperature
from flexbearing.families import FAMILIES
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
CASES = sorted((ROOT / "configs").glob("*.toml"))


@pytest.mark.parametrize("file", CASES, ids=lambda file: file.stem)
def test_every_case_that_comes_along_can_be_read(file):
    assert read_case(file).title


def test_paper_case_in_si():
    case = read_case(PAPER)
    assert case.bearing.outer_raceway_diameter == approx(75e-3, rel=1e-12)
    assert case.operation.inner_speed == approx(38000 * 2 * pi / 60, rel=1e-12)
    assert case.operation.temperatures.shaft == approx(503.15, rel=1e-12)
    assert case.materials.roller.expansion == approx(11.9e-6, rel=1e-12)
    assert case.bearing.first_roller_azimuth == 0.0


METRES = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "inch": 0.0254, "nm": 1e-9}


SIZES = st.just(0.0) | st.floats(1e-3, 1e3) | st.floats(-1e3, -1e-3)


@given(SIZES, st.sampled_from(sorted(METRES)))
def test_any_unit_of_length_gives_the_same_length(value, unit):
    assert TypeAdapter(Length).validate_python(f"{value!r} {unit}") == approx(value * METRES[unit], rel=1e-12)


@pytest.mark.parametrize(
    ("kind", "text", "si"),
    [
        (Temperature, "0 degC", 273.15),
        (Temperature, "300 K", 300.0),
        (Temperature, "212 degF", 373.15),
        (Speed, "60 rpm", 2 * pi),
        (Speed, "2 rad/s", 2.0),
    ],
    ids=lambda value: str(value) if isinstance(value, str) else "",
)
def test_temperatures_and_speeds(kind, text, si):
    assert TypeAdapter(kind).validate_python(text) == approx(si, rel=1e-12)


def test_settings_replace_keys_and_are_no_longer_assumed():
    case = read_case(PAPER, ["bearing.clearance=50 um", "outer.bars = 18", 'lubricant.oil="MIL-L-7808"'])
    assert case.bearing.clearance == approx(50e-6)
    assert case.outer.bars == 18
    assert "outer.bars" not in case.assumed
    assert "bearing.clearance" not in case.calibrated
    assert "lubricant.oil_fraction" in case.calibrated
    assert case.source.overrides == (
        "bearing.clearance=50 um",
        "outer.bars = 18",
        'lubricant.oil="MIL-L-7808"',
    )


@pytest.mark.parametrize("setting", ["bearing.clearance", "=5 um", "bearing.clearence=5 um", "nothing=1"])
def test_bad_setting(setting):
    with pytest.raises(BadCase):
        read_case(PAPER, [setting])


def test_keys_of_the_file_that_a_setting_makes_strangers_are_left_out(caplog):
    with caplog.at_level("DEBUG", logger="flexbearing.case"):
        case = read_case(PAPER, ["outer.kind=rigid", "inner.kind=rigid"])
    assert case.outer.bars is None
    assert case.materials.shaft is None
    assert not [key for key in case.assumed if key.startswith(("outer.", "inner."))]
    assert '[outer] bars of the file is left out: it belongs to outer.kind = "squirrel_cage"' in caplog.text
    assert read_case(PAPER, ["outer.kind=ring"]).outer.thickness == approx(3.6e-3, rel=1e-12)


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["outer.kind=ring", "outer.bar_width=900 mm"],
         '[outer] bar_width = "900 mm" is not used: it belongs to '
         'outer.kind = "squirrel_cage"; this case has outer.kind = "ring"'),
        (["outer.support=seat"], '[outer] support = "seat" is not used'),
        (["outer.kind=ring", "outer.housing_width=9 mm"], 'this case has outer.support = "side"'),
        (["bearing.fits.shaft_interference=5 um"], 'inner.fit = "frictionless" or "friction"'),
        (["inner.fit_friction=0.2"], 'inner.fit = "friction"; this case has inner.fit = "bonded"'),
        (["lubricant.eyring_stress=5 MPa"], 'this case has lubricant.traction = "4109"'),
        (["bearing.roller.crown_radius=1 m"], 'it belongs to bearing.roller.profile = "crowned"'),
        (["coupling.fallback=false", "coupling.relaxation=0.2"], "[coupling] relaxation = 0.2 is not used"),
        (["materials.housing.density=1 g/mm^3"], "[materials] housing is not used"),
    ],
)  # fmt: skip
def test_key_of_another_kind_is_refused(settings, told):
    with pytest.raises(BadCase) as problem:
        read_case(PAPER, settings)
    assert told in str(problem.value)


def test_key_of_another_kind_in_the_file_itself_is_refused(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(PAPER.read_text().replace('kind = "squirrel_cage"', 'kind = "ring"'))
    with pytest.raises(BadCase, match="bars = 24 is not used"):
        read_case(file)


def test_explain_says_to_which_choice_a_key_belongs():
    assert 'only     with outer.kind = "ring" with outer.support = "housing"' in explain(
        "outer.housing_width"
    )


def test_explain_puts_choices_in_one_sentence():
    rings, kinds = explain("accuracy.patch_width"), explain("outer.thickness")
    outer = 'with outer.kind = "ring", "squirrel_cage" or "matrix"'
    elastic = 'with outer.kind = "ring", "squirrel_cage", "step" or "matrix"'
    assert f'{elastic}, or with inner.kind = "ring_on_shaft"\n' in rings
    assert f"{outer}\n" in kinds


@pytest.mark.slow
def test_every_key_is_explained():
    everything = explain()
    for item in declarations(FAMILIES):
        assert item.meaning, item.path
        assert item.path in explain(item.path)
        if not item.section:
            assert item.allowed, item.path
            assert item.path in everything


def test_key_of_a_table_that_may_be_left_out_is_needed_with_it():
    assert "none: needed with [operation.temperatures]" in explain("operation.temperatures.shaft")
    assert "none: every case must give it" in explain("bearing.rollers")


def test_explain_names_the_nearest_key():
    with pytest.raises(BadCase, match=r"Did you mean bearing\.clearance"):
        explain("bearing.clearence")


def test_checking_a_case_loads_nothing_heavy():
    code = (
        "import sys; from flexbearing.api import read_case; "
        f"read_case({str(PAPER)!r}); "
        "print([m for m in ('ngsolve', 'netgen', 'h5py', 'matplotlib') if m in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert found.stdout.strip() == "[]"
