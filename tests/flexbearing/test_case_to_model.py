"""Every key of a case reaches the model that it is about."""

from typing import Any, get_args

import numpy as np
import pytest
from pytest import approx

import quasidynamic as qd
from flexbearing.api import check, read_case
from flexbearing.build import lubrication, roller_bearing, rough_surfaces
from flexbearing.case import BadCase
from flexbearing.case.film_oil import AdoreOilName, RollingName, ShareName, TractionName
from flexbearing.case.materials import OilName
from flexbearing.case.ratings import CleanlinessName
from flexbearing.case.roller.lubricant import FilmName
from flexbearing.coupling import LinearPair
from flexbearing.runs import notes
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.contact.traction import ROLLING_LAWS
from quasidynamic.contact.traction.adore import ADORE_OILS
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import FILM_SHARE_1_8, ZHOU_HOEPRICH
from quasidynamic.outcome.life_factors import CLEANLINESS
from quasidynamic.parts.oil_properties import OILS
from tests.places import CONFIGS

PLAIN, FITS, PAPER = (CONFIGS / f"{name}.toml" for name in ("nu209", "nu209_fits", "mao2016"))
ROUGH = {
    "bearing.roughness.roller": "0.3 um",
    "bearing.roughness.inner_raceway": "0.4 um",
    "bearing.roughness.outer_raceway": "0.4 um",
}


def model(file, **settings):
    return roller_bearing.bearing(
        read_case(file, {name.replace("__", "."): value for name, value in settings.items()})
    )


def built(file, settings):
    return roller_bearing.bearing(read_case(file, settings))


def law(settings, file=PLAIN) -> Any:
    """Traction law of the bearing, built for its contacts."""
    return built(file, settings)._aligned_rollers.raceways.traction


# -- lists of the case are those of the physics ----------------------------------------------------


@pytest.mark.parametrize(
    ("names", "known"),
    [
        (OilName, OILS),
        (AdoreOilName, ADORE_OILS),
        (FilmName, qd.FORMULAS),
        (RollingName, ROLLING_LAWS),
        (CleanlinessName, CLEANLINESS),
        (TractionName, lubrication._FLUIDS),
        (ShareName, rough_surfaces.SHARES),
    ],
    ids=["oils", "adore oils", "films", "rolling", "cleanliness", "tractions", "shares"],
)
def test_everything_the_physics_knows_can_be_chosen(names, known):
    assert set(get_args(names)) == set(known)


# -- the oil ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("oil", ["4 cSt aviation", "ISO VG 32", "ISO VG 100"])
def test_named_oil_reaches_the_model_with_its_notes(oil):
    settings = {"lubricant.oil": oil}
    assert built(FITS, settings).lubrication.oil == qd.oil_at(oil, 343.15)
    assert any(note.text.startswith(oil) for note in notes.of_case(read_case(FITS, settings)))


SHEET = {
    "lubricant.data_sheet.name": "oil 46",
    "lubricant.data_sheet.cold_temperature": "40 degC",
    "lubricant.data_sheet.cold_viscosity": "46 cSt",
    "lubricant.data_sheet.hot_temperature": "100 degC",
    "lubricant.data_sheet.hot_viscosity": "6.8 mm^2/s",
    "lubricant.data_sheet.density": "870 kg/m^3",
    "lubricant.data_sheet.cold_pressure_viscosity": "20 1/GPa",
    "lubricant.data_sheet.conductivity": "0.137 W/(m K)",
}


@pytest.fixture
def sheet_case(tmp_path):
    """A case without an oil of its own."""
    file = tmp_path / "sheet.toml"
    text = FITS.read_text().replace('oil = "ISO VG 68"\n', "").replace('"lubricant.oil", ', "")
    file.write_text(text)
    return file


def test_oil_of_a_data_sheet_goes_through_its_points(sheet_case):
    oil = built(sheet_case, {**SHEET, "lubricant.inlet_temperature": "100 degC"}).lubrication.oil
    assert oil.viscosity == approx(6.8e-6 * (870 - 0.65 * 85), rel=1e-12)
    assert oil.pressure_viscosity == approx(20e-9, rel=1e-12)
    more = {**SHEET, "lubricant.data_sheet.hot_pressure_viscosity": "15 1/GPa"}
    oil = built(sheet_case, {**more, "lubricant.inlet_temperature": "100 degC"}).lubrication.oil
    assert oil.pressure_viscosity == approx(15e-9, rel=1e-12)
    assert oil.conductivity == 0.137


def test_notes_call_the_oil_of_a_data_sheet_by_its_name(sheet_case):
    settings = {**SHEET, "lubricant.traction": "4109"}
    found = [note.text for note in notes.of_case(read_case(sheet_case, settings))]
    assert "oil 46: pressure-viscosity is that of 313 K at any temperature" in found
    assert "traction: the 4109 regression is used with oil 46" in found


def test_oil_of_a_data_sheet_too_hot_is_bad_input(sheet_case):
    with pytest.raises(BadCase, match=r"oil 46 at 300\.0 degC is outside 0 to 200 degC"):
        check(sheet_case, {**SHEET, "lubricant.inlet_temperature": "300 degC"})


# -- the laws --------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", get_args(FilmName))
def test_film_formula_reaches_the_model(name):
    assert built(PLAIN, {"lubricant.film": name}).lubrication.film is qd.FORMULAS[name]


@pytest.mark.parametrize("name", get_args(RollingName))
def test_rolling_law_reaches_the_model(name):
    assert built(PLAIN, {"lubricant.rolling": name}).lubrication.rolling is ROLLING_LAWS[name]


def test_defaults_are_those_of_the_model():
    found = built(PLAIN, {}).lubrication
    plain = qd.Lubrication(oil=found.oil, oil_fraction=found.oil_fraction)
    for name in ("film", "rolling", "inlet_heating", "inlet_length", "drag_coefficient", "churning_gap"):
        assert getattr(found, name) is getattr(plain, name)


@pytest.mark.parametrize(
    ("key", "value", "si"),
    [("inlet_length", 1.5, 1.5), ("drag_coefficient", 0.8, 0.8), ("churning_gap", "0.5 mm", 0.5e-3)],
)
def test_starvation_drag_and_churning_reach_the_model(key, value, si):
    assert getattr(built(PLAIN, {f"lubricant.{key}": value}).lubrication, key) == approx(si, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "kind"), [("eyring", qd.Eyring), ("bair-winer", qd.BairWiner)], ids=["eyring", "bair-winer"]
)
@pytest.mark.parametrize("heated", [False, True], ids=["isothermal", "heated"])
def test_film_with_a_limiting_stress(name, kind, heated):
    found = law(
        {
            "lubricant.traction": name,
            "lubricant.limiting_ratio": 0.04,
            "lubricant.film_heating": heated,
        }
    )
    assert isinstance(found, kind)
    assert (found.limiting_ratio, found.film_heating) == (0.04, heated)


def test_eyring_stress_is_given_or_follows_from_the_limit():
    assert law({}).eyring_stress == approx(2 * 0.05 / 18e-9, rel=1e-12)
    assert law({"lubricant.eyring_stress": "9 MPa"}).eyring_stress == approx(9e6, rel=1e-12)


def test_adore_oil_brings_its_own_viscosity():
    found = law({"lubricant.traction": "adore", "lubricant.adore_oil": "Santotrac 50"})
    assert isinstance(found, qd.AdoreType)
    assert found.rheology is ADORE_OILS["Santotrac 50"]
    assert found.limiting_ratio == 0.05


def test_four_points_make_a_curve():
    points = {"at_rest": 0.01, "peak": 0.06, "peak_slip": 0.03, "far": 0.04}
    found = law(
        {
            "lubricant.traction": "four-point",
            **{f"lubricant.traction_curve.{name}": value for name, value in points.items()},
        }
    )
    assert found == qd.FourPointCurve.through(**points)


@pytest.mark.parametrize(
    ("name", "share"),
    [("zhou-hoeprich", ZHOU_HOEPRICH), ("film-1.8", FILM_SHARE_1_8), ("error-function", None)],
)
def test_mixed_lubrication_wraps_the_chosen_law(name, share):
    settings = {
        **ROUGH,
        "lubricant.mixed.boundary_friction": 0.12,
        "lubricant.mixed.share": name,
        "lubricant.mixed.sign_speed": "2 mm/s",
    }
    found = law(settings)
    assert isinstance(found, qd.Mixed)
    assert isinstance(found.fluid, qd.Eyring)
    assert found.roughness == approx(np.full((2, 1, 1), 0.5e-6), rel=1e-12)
    assert found.asperities == RoundedCoulomb(coefficient=0.12, sign_speed=2e-3)
    assert share is None or found.share is share


def test_creeping_asperities_are_those_of_the_contacts():
    settings = {"lubricant.mixed.boundary_friction": 0.12, "lubricant.mixed.asperity_friction": "carter"}
    found = law({**ROUGH, **settings})
    assert isinstance(found.asperities, Carter)
    assert found.asperities.coefficient == 0.12
    assert found.asperities.radius == approx(found.fluid.radius, rel=1e-12)
    assert found.asperities.modulus == approx(found.fluid.modulus, rel=1e-12)


def test_each_raceway_has_asperities_of_its_own_roughness():
    """Outer contact five times as rough as the inner one: the law must be that of each roughness alone."""
    settings = {**ROUGH, "lubricant.mixed.boundary_friction": 0.12}
    outer = {"bearing.roughness.outer_raceway": "2.4820 um"}  # with the roller 2.5 um
    both, smooth, rough = (
        law({**settings, **more})
        for more in ({**outer}, {}, {**outer, "bearing.roughness.inner_raceway": "2.4820 um"})
    )
    load, sliding, speed, film = (np.full((2, 1, 1), x) for x in (1e5, 0.01, 8.0, 0.5e-6))
    for place, alone in ((0, smooth), (1, rough)):
        for found, expected in zip(
            both(load, sliding, speed, film), alone(load, sliding, speed, film), strict=True
        ):
            assert found[place] == approx(expected[place], rel=1e-12)


# -- cage and operation ----------------------------------------------------------------------------


def test_flow_in_the_land_reaches_the_cage():
    assert model(PAPER).bearing.cage.land_flow == "laminar"
    assert model(PAPER, bearing__cage__land_flow="vortices").bearing.cage.land_flow == "vortices"


def test_load_direction_and_misalignment_reach_the_operation():
    found = built(
        PLAIN, {"operation.load_direction": "90 deg", "operation.misalignment": "2 arcmin"}
    ).operation
    assert found.load_direction == approx(np.pi / 2, rel=1e-12)
    assert found.misalignment == approx(np.pi / 5400, rel=1e-12)


# -- notes of a solved state -----------------------------------------------------------------------


def of_code(code, case):
    model = roller_bearing.bearing(case)
    found = notes.of_solution(SolvedRows.of(case, model, model.solve(), LinearPair(None, None)))
    return [note.text for note in found if note.code == code]


def test_traction_oil_outside_its_fit_is_noted_at_the_pressures_of_the_state():
    settings = {"lubricant.traction": "adore", "lubricant.adore_oil": "Mobil DTE SAE 30"}
    (note,) = of_code("traction-data", read_case(PLAIN, {**settings, "operation.radial_load": "40 kN"}))
    assert note.startswith("Mobil DTE SAE 30: pressure")
    assert "extrapolated" in note
    assert of_code("traction-data", read_case(PLAIN, settings)) == []


def test_reynolds_number_outside_the_drag_table_is_noted_at_the_solved_cage_speed():
    settings = {"lubricant.viscosity": "0.01 mPa s", "lubricant.limiting_ratio": 0.02}
    case = {**settings, "lubricant.inlet_heating": False, "operation.inner_speed": "9000 rpm"}
    (note,) = of_code("drag-table", read_case(PLAIN, case))
    assert note.startswith("drag of the rollers: Re")
    assert of_code("drag-table", read_case(PLAIN, {**case, "lubricant.drag_coefficient": 1.0})) == []
