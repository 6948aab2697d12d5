"""Combinations of oil, laws and operation that a case may not ask for."""

import pytest

from flexbearing.api import read_case
from flexbearing.case import BadCase
from tests.places import CONFIGS

PLAIN, FITS = CONFIGS / "nu209.toml", CONFIGS / "nu209_fits.toml"
SHEET = {
    "lubricant.data_sheet.cold_temperature": "40 degC",
    "lubricant.data_sheet.cold_viscosity": "46 mm^2/s",
    "lubricant.data_sheet.hot_temperature": "100 degC",
    "lubricant.data_sheet.hot_viscosity": "6.8 mm^2/s",
    "lubricant.data_sheet.density": "870 kg/m^3",
    "lubricant.data_sheet.cold_pressure_viscosity": "20 1/GPa",
    "lubricant.data_sheet.conductivity": "0.137 W/(m K)",
}
CURVE = {"peak": 0.05, "peak_slip": 0.02, "far": 0.03}

REFUSED = {
    "oil by name and by data sheet": (
        FITS, SHEET, ['[lubricant] oil = "ISO VG 68" cannot be', "[lubricant.data_sheet]", "not both"],
    ),
    "oil by data sheet and by data": (
        PLAIN, SHEET, ["[lubricant] viscosity", "either [lubricant.data_sheet] or its data, not both"],
    ),
    "oil that no one knows": (
        PLAIN, {"lubricant.oil": "ISO VG 67"}, ['[lubricant] oil = "ISO VG 67" is not', '"ISO VG 68"'],
    ),
    "oil that thickens with heat": (
        FITS, {**SHEET, "lubricant.data_sheet.hot_viscosity": "47 mm^2/s"},
        ["[lubricant.data_sheet] hot_viscosity", "below lubricant.data_sheet.cold_viscosity"],
    ),
    "hot below cold": (
        FITS, {**SHEET, "lubricant.data_sheet.hot_temperature": "40 degC"},
        ["[lubricant.data_sheet] hot_temperature", "above lubricant.data_sheet.cold_temperature"],
    ),
    "dynamic viscosity for a kinematic one": (
        FITS, {**SHEET, "lubricant.data_sheet.cold_viscosity": "46 mPa s"},
        ["[lubricant.data_sheet] cold_viscosity", "is not a kinematic viscosity", '"46 mm^2/s"'],
    ),
    "data sheet without density": (
        FITS, {name: value for name, value in SHEET.items() if not name.endswith("density")},
        ["[lubricant.data_sheet] density is missing; it is a density"],
    ),
    "film": (PLAIN, {"lubricant.film": "hamrock"}, ['[lubricant] film = "hamrock"', '"pan_hamrock"']),
    "rolling": (PLAIN, {"lubricant.rolling": "houpert"}, ["[lubricant] rolling", '"biboulet-houpert"']),
    "adore without its oil": (
        PLAIN, {"lubricant.traction": "adore"},
        ['[lubricant] adore_oil is missing: traction = "adore" needs it', '"Santotrac 50"'],
    ),
    "curve without its points": (
        PLAIN, {"lubricant.traction": "four-point"},
        ['[lubricant] traction_curve is missing: traction = "four-point" needs it; it is a table'],
    ),
    "curve without a peak": (
        PLAIN,
        {"lubricant.traction": "four-point"}
        | {f"lubricant.traction_curve.{name}": value for name, value in {**CURVE, "far": 0.05}.items()},
        ["[lubricant.traction_curve] far = 0.05 cannot be", "below lubricant.traction_curve.peak"],
    ),
    "heating of a law that knows none": (
        FITS, {"lubricant.traction": "4109", "lubricant.film_heating": True},
        ["[lubricant] film_heating = true is not used", 'lubricant.traction = "eyring" or "bair'],
    ),
    "asperities of smooth surfaces": (
        PLAIN, {"lubricant.mixed.boundary_friction": 0.1},
        ["[bearing] roughness is missing: [lubricant.mixed] needs it; it is a table"],
    ),
    "roughness of one surface": (
        PLAIN, {"bearing.roughness.roller": "0.1 um"},
        ["[bearing.roughness] inner_raceway is missing", "[bearing.roughness] outer_raceway is missing"],
    ),
    "mixed lubrication without friction": (
        FITS, {"lubricant.mixed": {}}, ["[lubricant.mixed] boundary_friction is missing"],
    ),
    "no gap": (PLAIN, {"lubricant.churning_gap": "0 mm"}, ["[lubricant] churning_gap", "above 0 m"]),
    "no inlet": (PLAIN, {"lubricant.inlet_length": 0}, ["[lubricant] inlet_length = 0", "at least 0.001"]),
    "no drag": (PLAIN, {"lubricant.drag_coefficient": -1.0}, ["[lubricant] drag_coefficient", "at least"]),
    "flow of another kind": (
        CONFIGS / "mao2016.toml", {"bearing.cage.land_flow": "turbulent"},
        ["[bearing.cage] land_flow", '"vortices"'],
    ),
    "misalignment of a free ring": (
        PLAIN, {"operation.misalignment": "1 arcmin", "operation.tilt": "free"},
        ['[operation] misalignment = "1 arcmin" cannot be', '"0 deg" for operation.tilt = "free"'],
    ),
    "load towards a force": (
        PLAIN, {"operation.load_direction": "3 N"}, ["[operation] load_direction", "is not an angle"],
    ),
}  # fmt: skip


@pytest.mark.parametrize(("file", "settings", "expected"), REFUSED.values(), ids=REFUSED.keys())
def test_message_of_a_case_that_contradicts_itself(file, settings, expected):
    with pytest.raises(BadCase) as problem:
        read_case(file, settings)
    for part in expected:
        assert part in str(problem.value)


def test_laws_can_be_exchanged_one_against_the_other():
    assert read_case(PLAIN, {"lubricant.traction": "4109"}).lubricant.limiting_ratio is None
    assert read_case(PLAIN, {"lubricant.traction": "bair-winer"}).lubricant.limiting_ratio == 0.05


def test_choice_that_looks_like_a_number_needs_no_quotes():
    assert read_case(PLAIN, ["lubricant.traction=4109"]).lubricant.traction == "4109"
