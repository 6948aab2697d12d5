"""What holds the rings, from the case file to the loads."""

import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import clearance, ring_parts
from flexbearing.case import BadCase
from flexbearing.case.read import understood
from flexbearing.coupling import RacewayPair
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.rings.condensed import raceway
from flexbearing.rings.fits import (
    _shaft_fit_figures,
    expansions_along,
    inner_ring_in_fit,
    outer_ring_in_housing,
)
from flexbearing.rings.raceways import RigidRaceway
from flexbearing.runs import stored_fields
from flexbearing.runs.part_fields import NoFields
from tests.flexbearing.noted import codes
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
RING = [
    "inner.kind=rigid",
    "outer.kind=ring",
    "accuracy.element_order=3",
    "accuracy.slices=8",
    "accuracy.axial_shapes=2",
]
HOUSED = [
    *RING, "outer.support=housing", "outer.housing_thickness=10 mm", "outer.housing_width=12 mm",
    "operation.temperatures.housing=218 degC", "accuracy.slices=8", "accuracy.axial_shapes=2",
]  # fmt: skip
FITTED = [
    "outer.kind=rigid", "inner.fit=frictionless", "accuracy.element_order=3", "accuracy.slices=8",
    "accuracy.axial_shapes=2",
]  # fmt: skip
HOUSING_STEEL = {
    "youngs_modulus": "203 GPa", "poisson_ratio": "0.28", "density": "7850 kg/m^3",
    "expansion": "13.8e-6 1/K",
}  # fmt: skip
SUPPORTS = {
    "seat": [],
    "foundation": ["outer.foundation_radial=100 N/mm^3"],
    "housing": ["outer.housing_thickness=10 mm", "outer.housing_width=12 mm"],
    "lines": ['outer.line_azimuths=["60 deg", "180 deg", "300 deg"]'],
    "planet": [
        'outer.tooth_azimuths=["90 deg", "270 deg"]',
        'outer.tooth_radial=["0 N", "0 N"]',
        'outer.tooth_tangential=["9800 N", "-9800 N"]',
    ],
}


def with_support(name):
    return [*RING, f"outer.support={name}", *SUPPORTS[name]]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", SUPPORTS)
def test_every_support_is_computed(name):
    result = flexbearing.run(PAPER, with_support(name))
    assert result.attributes["status"] == "converged"
    assert np.abs(result.flexible["outer_deviation"]).max() > 1e-7
    carried = result.flexible["inner_load"] @ np.cos(result.flexible["roller_azimuth"])
    assert carried == approx(result.rigid["inner_load"] @ np.cos(result.rigid["roller_azimuth"]), rel=0.01)


def test_tooth_forces_bend_a_planet_before_rollers_do():
    """The rim ovalises: it opens between the teeth, which spreads the load over more rollers."""
    result = flexbearing.run(PAPER, with_support("planet"))
    assert (result.flexible["inner_load"] > 1).sum() > (result.rigid["inner_load"] > 1).sum()
    assert result.attributes["structure"]["outer"]["support_stiffness_N_per_m"] is None


def test_teeth_act_at_the_pitch_circle_or_the_result_says_that_they_do_not():
    """At 60 mm, 18.9 mm outside of the rim, their couples open the load zone further."""
    on_rim, at_pitch = (
        flexbearing.run(PAPER, [*with_support("planet"), *radius])
        for radius in ([], ["outer.tooth_radius=60 mm"])
    )
    assert "tooth-forces-at-rim" in codes(on_rim)
    assert "tooth-forces-at-rim" not in codes(at_pitch)
    change = np.abs(at_pitch.flexible["inner_load"] - on_rim.flexible["inner_load"]).max()
    assert change > 0.02 * on_rim.flexible["inner_load"].max()


def test_pitch_circle_inside_of_the_rim_is_refused():
    with pytest.raises(BadCase, match=r"tooth_radius .*at least 41.1 mm"):
        read_case(PAPER, [*with_support("planet"), "outer.tooth_radius=40 mm"])


@pytest.mark.parametrize(
    ("file", "told"), [("mao2016", "its flange is clamped"), ("step_ring", "outer.clamps do not move")]
)
def test_outer_ring_that_is_clamped_cannot_turn(file, told):
    with pytest.raises(BadCase, match=f"outer_speed .*{told}"):
        read_case(PAPER.with_name(f"{file}.toml"), ["operation.outer_speed=100 rpm"])
    turning = ["outer.kind=ring", "outer.support=seat", "outer.thickness=3 mm", "outer.width=10 mm"]
    assert read_case(PAPER, [*turning, "operation.outer_speed=100 rpm"]).operation.outer_speed > 0


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["outer.support=housing"], "housing_thickness"),
        (["outer.support=lines"], "line_azimuths"),
        (["outer.support=planet"], "tooth_azimuths"),
        (["outer.support=planet", 'outer.tooth_azimuths=["90 deg"]'], "as many"),
        (["outer.support=foundation"], "or nothing holds the ring"),
        (["outer.kind=step"], "file"),
        (["outer.kind=step", "outer.file=x.step"], "can move freely"),
    ],
)
def test_supports_that_hold_nothing_are_refused(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, [*RING, *settings])


def test_ring_that_can_roll_between_two_lines_is_refused_before_it_is_solved(tmp_path):
    lines = ["outer.support=lines", 'outer.line_azimuths=["0 deg", "180 deg"]']
    with pytest.raises(BadCase, match="can still move along"):
        flexbearing.run(PAPER, [*RING, *lines], output=tmp_path / "r.h5")


@pytest.mark.slow
def test_ring_with_clearance_in_its_housing_touches_it_below_the_load(tmp_path):
    result = flexbearing.run(
        PAPER, [*HOUSED, "bearing.fits.housing.interference=-60 um"], output=tmp_path / "r.h5"
    )
    assert result.attributes["status"] == "converged"
    told = result.attributes["structure"]["outer"]["housing"]
    assert 60 < told["touching_angle_deg"] < 120
    assert 0.6 < told["open_share"] < 0.9
    assert told["largest_pressure_MPa"] > told["mean_pressure_MPa"] > 0
    assert told["largest_gap_um"] > told["mean_gap_unloaded_um"] == approx(30, abs=1)
    carried = result.flexible["inner_load"] @ np.cos(result.flexible["roller_azimuth"])
    assert carried == approx(result.rigid["inner_load"] @ np.cos(result.rigid["roller_azimuth"]), rel=0.01)
    with pytest.raises(NoFields, match=r"fits\.housing has no solid"):
        stored_fields.of_result(result)


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["outer.housing_clearance=60 um", "operation.radial_load=0 N"], "nothing holds the ring"),
        (["bearing.fits.housing.interference=-60 um", "operation.radial_load=0 N"], "nothing holds the ring"),
    ],
)
def test_ring_that_no_load_holds_in_its_housing_is_refused(settings, told, tmp_path):
    with pytest.raises(BadCase, match=told):
        flexbearing.run(PAPER, [*HOUSED, *settings], output=tmp_path / "r.h5")


def test_a_fit_in_the_housing_is_given_once():
    both = ["outer.housing_clearance=10 um", "bearing.fits.housing.interference=-60 um"]
    with pytest.raises(BadCase, match=r"housing_clearance = .10 um. cannot be; .* with the opposite sign"):
        read_case(PAPER, [*HOUSED, *both])


def test_clearance_is_a_negative_interference():
    ways = ["outer.housing_clearance=60 um", "bearing.fits.housing.interference=-60 um"]
    one, other = (read_case(PAPER, [*HOUSED, way]).housing_interference for way in ways)
    assert one == other == approx(-60e-6, rel=1e-12)


def test_clearance_needs_the_temperature_of_the_housing():
    settings = [
        *(item for item in HOUSED if "temperatures" not in item),
        "bearing.fits.housing.interference=-60 um",
    ]
    with pytest.raises(BadCase, match=r"housing is missing: \[bearing.fits.housing\] needs it"):
        read_case(PAPER, settings)


def along(part, *temperatures):
    names = ", ".join(f'"{t} degC"' for t in temperatures)
    return [
        f'operation.temperatures.{part}_along.at=["-30 mm", "30 mm"]',
        f"operation.temperatures.{part}_along.temperatures=[{names}]",
    ]


def test_figures_of_a_shaft_fit_hold_each_number_under_its_name():
    fit = SimpleNamespace(
        mean_pressure=5e6, growth=3e-6, fit=SimpleNamespace(thermal_strains=(0.0, 0.0)),
        bodies=SimpleNamespace(part=SimpleNamespace(seat=SimpleNamespace(raceway_diameter=65e-3))),
    )  # fmt: skip
    loaded = SimpleNamespace(mean_pressure=6e6, pressure=np.array([0.0, 9e6]), opened=0.25, slipping=0.5)
    assert _shaft_fit_figures(fit, loaded)["fit"] == {  # pyright: ignore[reportArgumentType]
        "mean_pressure_unloaded_MPa": approx(5.0),
        "raceway_growth_um": approx(3.0),
        "mean_pressure_MPa": approx(6.0),
        "largest_pressure_MPa": approx(9.0),
        "open_share": 0.25,
        "slipping_share": 0.5,
    }


def test_temperatures_along_the_axis_are_free_expansions_beyond_the_middle():
    case = read_case(PAPER, [*FITTED, *along("shaft", 210, 250)])
    ((name, growth),) = expansions_along(case, ring="inner_ring", shaft="shaft").items()
    assert name == "shaft"
    assert growth.values == approx((-13.8e-6 * 20, 13.8e-6 * 20), rel=1e-9)
    assert growth.at == approx((-30e-3, 30e-3), rel=3e-3)  # as warm as the ring


AZIMUTHS = 2 * np.pi * np.arange(30) / 30
COARSE = ["accuracy.element_order=3", "accuracy.raceway_mesh_size=1.5 mm"]


def inner_in_fit(*settings):
    case = read_case(PAPER, [*FITTED, *COARSE, *settings])
    return inner_ring_in_fit(case, ring_parts.inner_part(case), AZIMUTHS)


@pytest.fixture(scope="module")
def tapered():
    """An inner ring on a shaft that is as warm everywhere, and on one that is warmer at larger x."""
    return inner_in_fit(), inner_in_fit(*along("shaft", 210, 250))


@pytest.mark.slow
def test_shaft_that_is_warmer_at_one_end_tapers_the_raceway(tapered):
    """A raceway of larger radius at larger x stands further outward there, unloaded and loaded."""
    even, warm = tapered
    change, x = warm.fit.pressure - even.fit.pressure, warm.fit.bodies.ring.points.x
    assert change[x > 1e-6].min() > 0 > change[x < -1e-6].max()
    taper = warm.fit.expansion[1] - even.fit.expansion[1]
    assert 0 < taper < 13.8e-6 * 40 / 60e-3 * 33e-3 * 2.5e-3  # that of a shaft with this temperature
    forces = np.zeros((2, 30, 2))
    forces[:, :, 0] = 1e3 * np.maximum(np.cos(AZIMUTHS), 0)
    first, second = (
        RacewayPair(fit, RigidRaceway(AZIMUTHS)).answer(forces)[0][0, :, 1] for fit in (even, warm)
    )
    assert second - first == approx(taper, rel=0.05)


@pytest.mark.slow
def test_mean_expansion_is_no_deviation(tapered):
    """It belongs to the operating clearance."""
    even, _ = tapered
    assert even.fit.expansion[0] > 1e-6
    deviation, _ = even.answer(np.zeros((30, 2)))
    assert np.abs(deviation[:, 0]).max() < 1e-3 * even.fit.expansion[0]


TIGHT = ["bearing.fits.shaft_interference=60 um"]
TURNING = ["operation.outer_speed=20000 rpm"]


@pytest.mark.slow
def test_each_body_of_a_fit_has_its_own_density():
    """A heavier body expands more as it turns: a ring opens the fit, a shaft closes it."""
    light, ring, shaft = (
        inner_in_fit(*TIGHT, *heavier).fit.mean_pressure
        for heavier in ([], ["materials.inner_ring.density=16 g/cm^3"], ["materials.shaft.density=16 g/cm^3"])
    )
    assert ring < light < shaft


@pytest.mark.slow
def test_each_body_of_a_housing_fit_has_its_own_density():
    """Outside is the housing: where it is heavier it opens the fit, a heavier ring closes it."""
    gaps = []
    housing = [f"materials.housing.{name}={value}" for name, value in HOUSING_STEEL.items()]
    for heavier in ([], ["materials.outer_ring.density=16 g/cm^3"], ["materials.housing.density=16 g/cm^3"]):
        case = read_case(
            PAPER,
            [*HOUSED, *COARSE, "bearing.fits.housing.interference=-60 um", *TURNING, *housing, *heavier],
        )
        raceway = outer_ring_in_housing(case, ring_parts.outer_part(case), AZIMUTHS)
        gaps.append(raceway.fit.gap.mean())
    light, ring, around = gaps
    assert ring < light < around


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (along("shaft", 210, 250), "shaft_along is not used"),
        (["inner.fit=friction", *along("shaft", 210, 240)], r"shaft .*498.15 K"),
        (["inner.fit=friction", *along("shaft", 210, 230, 250)], "one temperature for each"),
        (along("outer_ring", 208, 228), "outer_ring_along is not used"),
    ],
)
def test_temperatures_along_the_axis_that_nothing_follows_are_refused(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, settings)


@pytest.mark.parametrize(
    ("settings", "ends"),
    [
        (['operation.temperatures.shaft_along.at=["-10 mm", "10 mm"]'], "-20 mm or below to 20 mm"),
        (["inner.shaft_length=49.118 mm"], "-24.56 mm or below to 24.56 mm"),
    ],
    ids=["places", "longer shaft"],
)
def test_temperatures_that_end_inside_the_shaft_are_refused(settings, ends):
    """By `check` as by `run`: the fuzz found a longer shaft that only a run refused."""
    warm = ['operation.temperatures.shaft_along.at=["-20 mm", "20 mm"]', along("shaft", 225, 235)[1]]
    with pytest.raises(BadCase, match=rf"shaft_along\] at = .*{ends}"):
        read_case(PAPER, [*FITTED, *warm, *settings])


@pytest.mark.slow
def test_inner_ring_in_its_fit_deflects_more_than_a_bonded_one():
    loads = {}
    for fit in ("bonded", "friction", "frictionless"):
        result = flexbearing.run(PAPER, ["outer.kind=rigid", f"inner.fit={fit}"])
        assert result.attributes["status"] == "converged"
        loads[fit] = result.flexible
    stiffness = {fit: float(block["total_stiffness"]) for fit, block in loads.items()}
    assert stiffness["bonded"] > stiffness["friction"] > stiffness["frictionless"]
    stuck = flexbearing.run(
        PAPER, ["outer.kind=rigid", "inner.fit=friction", "inner.fit_friction=10",
         "bearing.fits.shaft_interference=40 um"],
    )  # fmt: skip
    assert stuck.flexible["total_stiffness"] == approx(stiffness["bonded"], rel=0.02)
    told = stuck.attributes["structure"]["inner"]["fit"]
    assert told["open_share"] == 0.0
    assert told["slipping_share"] < 0.01


COLD_SEAT = ["operation.temperatures.outer_seat=168 degC"]  # 50 K below the ring


@pytest.mark.slow
def test_cold_flange_seat_cones_the_raceway_and_takes_an_eighth_of_the_life():
    held = ["operation.tilt=fixed"]
    usual = flexbearing.run(PAPER, held).flexible
    cold = flexbearing.run(PAPER, [*held, *COLD_SEAT]).flexible
    assert cold["life_L10"] / usual["life_L10"] == approx(0.878, abs=0.01)
    away = np.argmin(cold["inner_load"])  # where no load bends the ring
    coned = (cold["outer_deviation"] - usual["outer_deviation"])[away]
    assert coned[-1] - coned[0] == approx(-4.7e-6, abs=0.4e-6)  # between the outer slices


def test_seat_as_warm_as_the_ring_changes_nothing():
    beam = ["accuracy.structure=beam", "inner.kind=rigid", "outer.kind=ring", "accuracy.slices=8"]
    seats = ["218 degC", "168 degC"]
    plain = flexbearing.run(PAPER, beam).flexible
    even, cold = (
        flexbearing.run(PAPER, [*beam, f"operation.temperatures.outer_seat={seat}"]) for seat in seats
    )
    assert (even.flexible["inner_load"] == plain["inner_load"]).all()
    moved = cold.flexible["outer_deviation"] - plain["outer_deviation"]
    assert np.ptp(moved, axis=1).min() > 4e-6  # coned at every roller
    seat = cold.attributes["structure"]["outer"]["seat"]
    assert seat["coned_um"] == approx(-6.4, rel=0.03)
    assert seat["mean_growth_um"] == approx(-17.5, rel=0.03)


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["outer.kind=rigid", *COLD_SEAT], "outer_seat = .* is not used: it belongs to"),
        (["outer.kind=ring", "outer.support=housing", *COLD_SEAT], "outer_seat = .* is not used"),
        (
            ["coupling.structure=full", "coupling.method=iqn-ils", *COLD_SEAT],
            "outer_seat = .* left out for coupling.structure",
        ),
    ],
)
def test_temperature_of_a_seat_that_is_not_there_is_refused(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, settings)


def test_cold_seat_narrows_a_computed_clearance():
    text = re.sub(r'\nclearance = .*|\n"bearing.clearance" = .*', "", PAPER.read_text())
    mounted = {
        "inner.kind": "rigid", "bearing.fits.bore": "59.6 mm", "bearing.fits.cold_clearance": "100 um",
        "bearing.fits.shaft_interference": "0 um", "outer.kind": "ring",
    }  # fmt: skip
    even, cold = (
        clearance.operating(understood(text, PAPER, {**mounted, **further}, FAMILIES))  # pyright: ignore[reportArgumentType]
        for further in ({}, {"operation.temperatures.outer_seat": "168 degC"})
    )
    assert cold - even == approx(-2 * 17.5e-6, rel=0.03)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("fitted", [False, True], ids=["stated clearance", "from fits"])
def test_bonded_ring_has_its_growth_along_the_roller_and_no_mean(fitted):
    """The mean belongs to the operating clearance, the shape to the raceway, as in a fit that may open."""
    text, settings = PAPER.read_text(), {"outer.kind": "rigid", "accuracy.element_order": 3}
    if fitted:
        text = re.sub(r'\nclearance = .*|\n"bearing.clearance" = .*', "", text)
        settings |= {
            "bearing.fits.outer_diameter": "82.2 mm", "bearing.fits.cold_clearance": "100 um",
            "bearing.fits.shaft_interference": "30 um",
        }  # fmt: skip
    case: Any = understood(text, PAPER, settings, FAMILIES)
    deviation, _ = raceway(case, "inner", AZIMUTHS, Logged()).answer(np.zeros((30, 3)))
    assert np.abs(deviation[:, 0]).max() < 1e-12
    assert deviation[:, 2] == approx(0.25e-6 if fitted else 0.33e-6, rel=0.3)
    assert np.ptp(deviation, axis=0).max() < 1e-12
