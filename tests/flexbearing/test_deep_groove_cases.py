"""Deep groove ball bearings from case file to summary, pictures and studies."""

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq

import flexbearing
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.report.output import text
from tests.flexbearing.noted import texts
from tests.literature.test_sjovall import radial_integral
from tests.places import CONFIGS

CONFIG = CONFIGS / "6209.toml"
STEEL = 11.7205e9  # [N/m^1.5] both contacts of the 209 bearing, 206 GPa


@pytest.fixture(scope="module")
def radial():
    return flexbearing.run(CONFIG, ["operation.inner_speed=0 rpm"])


def test_largest_load_is_near_that_of_the_radial_integral(radial):
    """8.9 kN, P_d 15 um: the integral gives eps = 0.438; nine balls are no integral."""

    def off(shift):
        eps = 0.5 * (1 - 7.5e-6 / shift)
        return 9 * STEEL * (shift - 7.5e-6) ** 1.5 * radial_integral(eps, 1.5) - 8900

    shift = brentq(off, 8e-6, 1e-3)
    assert 0.5 * (1 - 7.5e-6 / shift) == approx(0.438, abs=5e-4)
    assert radial.rigid["contact_load"].max() == approx(STEEL * (shift - 7.5e-6) ** 1.5, rel=3e-3)
    assert radial.rigid["ring_displacement"][2] == approx(shift, rel=3e-3)


def test_summary_has_the_free_contact_angle(radial):
    assert radial.summary()["rigid"]["free_contact_angle_deg"] == approx(9.936, abs=1e-3)
    assert "free contact angle" in text(radial)
    assert radial.summary()["rigid"]["balls_on_both_races"] == 5
    assert any("4 of 9 balls do not touch the inner race" in note for note in texts(radial))


def test_end_play_is_an_output_of_bearings_that_have_one(radial):
    """2 A sin(alpha_0) of A = 0.5 mm and 9.936 deg; shoulders on one side leave none."""
    assert radial.summary()["rigid"]["end_play_um"] == approx(2 * 500 * np.sin(np.radians(9.936)), rel=1e-3)
    angular = flexbearing.run(CONFIG.with_name("harris218.toml"), ["operation.inner_speed=0 rpm"])
    assert "end_play" not in angular.rigid
    assert angular.summary()["rigid"]["end_play_um"] is None


@pytest.mark.slow
@pytest.mark.parametrize("control", ["outer", "inner", "equal", "coulomb"])
@pytest.mark.parametrize("model", ["full_sliding", "fastsim"])
def test_every_control_and_friction_model_works(control, model):
    """Radial balls roll with little slip: a few hundredths of mu F D/2 of the bearing."""
    result = flexbearing.run(
        CONFIG,
        [
            f"operation.control={control}", f"friction.model={model}", "operation.load.axial=1 kN",
            *(["friction.cells=[12, 24]"] if model == "fastsim" else []),
        ],
    )  # fmt: skip
    assert result.summary()["status"] == "converged"
    assert 0.02 < result.rigid["friction_torque"] / (0.1 * 8900 * 6.35e-3) < 0.3
    assert result.rigid["ring_load"] == approx([1000, 0, 8900, 0, 0], abs=1e-4)


@pytest.mark.slow
def test_pictures_are_drawn(radial):
    at_rest = set(FAMILIES["deep_groove_ball"].report().pictures()(radial))
    assert at_rest == {"ball_loads", "rolling_lines", "slip_profiles"}
    turning = flexbearing.run(CONFIG, ["friction.model=fastsim", "friction.cells=[12, 24]"])
    assert set(FAMILIES["deep_groove_ball"].report().pictures()(turning)) == at_rest | {"contacts_of_ball_0"}


def test_clearance_moves_the_contact_angle_under_thrust():
    angles = []
    for clearance in ("0 um", "15 um", "40 um"):
        result = flexbearing.run(
            CONFIG,
            [f"bearing.clearance={clearance}", "operation.load.radial_z=0 N", "operation.load.axial=200 N"],
        )
        angles.append(np.degrees(result.rigid["contact_angle"][0]))
    assert np.ptp(angles, axis=1) == approx(np.zeros(3), abs=1e-6)
    assert np.all(np.diff([angle[0] for angle in angles]) > 2.0)


def test_tilt_that_nothing_holds_is_told():
    result = flexbearing.run(
        CONFIG,
        ["operation.load.radial_z=5 N", "bearing.clearance=60 um", "bearing.first_ball_azimuth=20 deg",
         "operation.inner_speed=0 rpm"],
    )  # fmt: skip
    assert result.summary()["status"] == "not solved"
    assert "nothing holds the inner ring" in text(result)


def test_contacts_that_a_thrust_at_speed_turns_upright_name_the_angle():
    """Inertia takes the inner contacts of a 7008 with 80 degrees to 90, where they carry no radial load."""
    steep = ["bearing.contact_angle=80 deg"]
    result = flexbearing.run(CONFIG.with_name("rivera2021_7008.toml"), steep)
    assert "carry no radial load: give a smaller bearing.contact_angle" in result.attributes["message"]


def test_preload_by_force_and_by_displacement_are_one(tmp_path):
    """100 N at rest hold the ring where the same displacement beyond touching does."""
    unloaded = ["operation.load.radial_z=0 N", "operation.inner_speed=0 rpm"]
    by_force = flexbearing.run(CONFIG, [*unloaded, "operation.preload.force=100 N"])
    place = by_force.rigid["ring_displacement"][0]
    beyond = place - np.sqrt(0.5e-3**2 - (0.5e-3 - 7.5e-6) ** 2)
    same = flexbearing.run(CONFIG, [*unloaded, f"operation.preload.displacement={beyond * 1e6:.9g} um"])
    assert same.rigid["ring_load"] == approx(by_force.rigid["ring_load"], rel=1e-6, abs=1e-6)
    assert by_force.rigid["ring_load"][0] == approx(100.0, rel=1e-8)
    assert any("where 100 N hold it at rest" in note for note in texts(by_force))


def test_rigid_preload_grows_with_speed_where_that_of_springs_stays():
    preloaded = ["operation.load.radial_z=0 N", "operation.preload.force=100 N"]
    forces = [
        flexbearing.run(CONFIG, [*preloaded, f"operation.inner_speed={speed} rpm"]).rigid["ring_load"][0]
        for speed in (0, 6000, 12000)
    ]
    assert forces[0] == approx(100.0, rel=1e-8)
    assert np.all(np.diff(forces) > 1.0)


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        (["operation.preload.force=9 N", "operation.preload.displacement=1 um"], "left out beside force"),
        (["operation.preload.force=9 N", "operation.load.axial=1 N"], '"0 N" beside operation.preload'),
        (
            ["operation.preload.force=9 N", "operation.displacement.axial=1 um"],
            "left out beside operation.pre",
        ),
        (["operation.preload.force=0 N"], "above 0 N"),
        (["bearing.preload=10 um"], "operation.preload"),
        (["bearing.interference=10 um"], "negative bearing.clearance"),
    ],
    ids=["twice", "with a load", "with a displacement", "none", "in the bearing", "as interference"],
)
def test_preload_stands_alone_and_in_its_place(settings, said):
    with pytest.raises(BadCase) as problem:
        read_case(CONFIG, settings)
    assert said in str(problem.value)
