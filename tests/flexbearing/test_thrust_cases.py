"""Roller thrust bearings as cases: what a run and a report of them have."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import BadCase, api
from flexbearing.families import FAMILIES
from flexbearing.report.html import html, of_result

CASE = Path(__file__).parents[2] / "configs" / "81110.toml"
OILED = ["outputs.friction=true", "lubricant.oil=ISO VG 100", "lubricant.inlet_temperature=60 degC",
         "lubricant.oil_fraction=0.02", "life.lubrication=a_ISO",
         "life.cleanliness=grease, normal cleanliness"]  # fmt: skip


@pytest.fixture(scope="module")
def result():
    return api.run(CASE, OILED)


def test_balances_hold_for_the_stored_loads(result):
    values = result.rigid
    width = 6e-3 / values["slice_position"].size
    radii, azimuths = 30e-3 + values["slice_position"], values["roller_azimuth"]
    for race in ("inner", "outer"):
        slices = values[f"{race}_slice_load"] * width
        assert slices.sum() == approx(8000.0, rel=1e-9)
        assert slices.sum(1) == approx(values[f"{race}_load"], rel=1e-12)
    on_ring = values["inner_slice_load"] @ radii * width
    assert on_ring @ np.cos(azimuths) == approx(40.0, abs=1e-9 * 8000)
    assert on_ring @ np.sin(azimuths) == approx(0.0, abs=1e-9 * 8000)
    levers = (values["outer_slice_load"] - values["inner_slice_load"]) @ values["slice_position"] * width
    assert levers == approx(float(values["gyroscopic_moment"]), abs=1e-9 * 8000 * 6e-3)


def test_even_thrust_has_the_life_of_its_rating():
    """Under slices loaded alike the exponent is 4, without the factor 0.73 of the rating."""
    settings = ["operation.load.moment_y=", "bearing.roller.profile=straight", "operation.tilt=fixed",
                "materials.roller.youngs_modulus=206 GPa", "materials.roller.poisson_ratio=0.3",
                "materials.roller.density=0.001 kg/m^3"]  # fmt: skip
    values = api.run(CASE, settings).rigid
    assert values["inner_load"] == approx(8000.0 / 21, rel=1e-9)
    rating = float(values["dynamic_rating"])
    assert values["life_L10"] == approx((rating / 0.73 / 8000.0) ** 4 * 1e6, rel=1e-9)
    assert (values["equivalent_load"], values["static_safety"]) == approx(
        (8000.0, 166320.0 / 8000), rel=1e-12
    )
    assert values["effective_static_safety"] == approx(values["static_safety"], rel=1e-9)


def test_losses_are_what_the_rings_put_in_and_nothing_is_of_a_rib(result):
    values = result.rigid
    losses = sum(values[name].sum() for name in values if name.startswith("loss_"))
    assert losses == approx(values["driving_power"], rel=1e-9)
    assert not [name for name in values if "rib" in name]
    assert values["loss_sliding"] > values["loss_drag"]


def test_report_has_the_washers(result):
    page = html(of_result(result))
    assert "equivalent load P" in page
    assert "rib" not in page.split("<h2")[1].lower()


def test_rows_are_those_of_a_run(result):
    texts = ["max_roller_load", "life_L10", "stiffness_xx", "stiffness_tilt"]
    rows = FAMILIES["thrust_roller"].rows
    assert rows
    (answer,) = rows()([api.read_case(CASE, OILED)], texts)
    assert answer.numbers["max_roller_load"] == approx(result.rigid["inner_load"].max(), rel=1e-9)
    assert answer.numbers["stiffness_xx"] == approx(result.rigid["stiffness_matrix"][0, 0], rel=1e-9)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (["bearing.rollerss=3"], "Did you mean rollers"),
        (["bearing.rollers=30"], "at most 28, or they touch"),
        (["operation.load.axial=0 kN"], "without either the washers part"),
        (["operation.load.radial_z=3 kN"], 'belongs to kind = "four_point_ball"'),
        (["bearing.rib.angle=3 deg"], 'belongs to kind = "tapered_roller"'),
        (["bearing.roller.length=61 mm", "bearing.roller.profile=straight"], "half the circle"),
    ],
)
def test_what_cannot_be_is_refused(settings, words):
    with pytest.raises(BadCase, match=words):
        api.check(CASE, settings)
