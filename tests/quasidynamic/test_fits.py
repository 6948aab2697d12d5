"""Rings pressed, heated, spun: identities that hold whatever the numbers are."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.clearance import (
    Annulus,
    FitConditions,
    Mounting,
    OperatingConditions,
    PressFit,
    operating_clearance,
    seat,
)
from quasidynamic.clearance.annulus import heat_displacement, pressure_displacement, rotation_displacement
from quasidynamic.clearance.press_fit import inside_displacement, outside_displacement
from quasidynamic.errors import ImpossiblePart, OutOfRange

STEEL = {"youngs_modulus": 203e9, "poisson_ratio": 0.28, "density": 7850.0, "expansion": 11.2e-6}
ALUMINIUM = {"youngs_modulus": 71e9, "poisson_ratio": 0.33, "density": 2770.0, "expansion": 23e-6}
REFERENCE = 293.15  # [K]


def steel(inner, outer):
    return Annulus(inner_radius=inner, outer_radius=outer, **STEEL)


RING = steel(30e-3, 33e-3)
THIN = steel(50e-3 - 1e-6, 50e-3 + 1e-6)
OUTER_RING = steel(38e-3, 41e-3)
HOUSING = Annulus(inner_radius=41e-3, outer_radius=55e-3, **ALUMINIUM)
ROLLER = steel(0.0, 2.5e-3)
SHAFT_FIT = PressFit(inside=steel(20e-3, 30e-3), outside=RING, interference=20e-6)
HOUSING_FIT = PressFit(inside=OUTER_RING, outside=HOUSING, interference=10e-6)
COLD = OperatingConditions(
    reference=REFERENCE,
    shaft=REFERENCE,
    inner_ring=REFERENCE,
    rolling_elements=REFERENCE,
    outer_ring=REFERENCE,
)


def mounting(outer=OUTER_RING, clearance=60e-6, shaft_fit=SHAFT_FIT):
    return Mounting(cold_clearance=clearance, shaft_fit=shaft_fit, outer=outer, rolling_element=ROLLER)


rises = st.floats(-100.0, 300.0)
speeds = st.floats(-4000.0, 4000.0)
interferences = st.floats(-60e-6, 100e-6)
materials = st.fixed_dictionaries(
    {
        "youngs_modulus": st.floats(60e9, 400e9),
        "poisson_ratio": st.floats(0.0, 0.4),
        "density": st.floats(2000.0, 9000.0),
        "expansion": st.floats(0.0, 25e-6),
    }
)
states = st.builds(FitConditions, inside_rise=rises, outside_rise=rises, speed=speeds)


@st.composite
def fits(draw):
    radius = draw(st.floats(10e-3, 100e-3))
    bore = draw(st.one_of(st.just(0.0), st.floats(0.1, 0.95))) * radius
    rim = draw(st.floats(1.05, 2.0)) * radius
    inside = Annulus(inner_radius=bore, outer_radius=radius, **draw(materials))
    outside = Annulus(inner_radius=radius, outer_radius=rim, **draw(materials))
    return PressFit(inside=inside, outside=outside, interference=draw(interferences))


runs = st.builds(
    OperatingConditions,
    reference=st.just(REFERENCE),
    shaft=st.floats(200.0, 600.0),
    inner_ring=st.floats(200.0, 600.0),
    rolling_elements=st.floats(200.0, 600.0),
    outer_ring=st.floats(200.0, 600.0),
    inner_speed=speeds,
    outer_speed=speeds,
)


def test_thin_ring_grows_by_its_hoop_strain():
    pressure, speed, mean = 1e5, 3000.0, 50e-3
    hoop = pressure * mean**2 / (THIN.youngs_modulus * 2e-6)
    assert pressure_displacement(THIN, mean, pressure, 0.0) == approx(hoop, rel=1e-4, abs=0.0)
    centrifugal = THIN.density * speed**2 * mean**3 / THIN.youngs_modulus
    assert rotation_displacement(THIN, mean, speed) == approx(centrifugal, rel=1e-4, abs=0.0)


def test_solid_shaft_is_squeezed_evenly():
    shaft = steel(0.0, 30e-3)
    radii = np.array([0.0, 10e-3, 30e-3])
    squeezed = pressure_displacement(shaft, radii, 0.0, 50e6)
    assert squeezed == approx(-(1 - 0.28) * 50e6 / 203e9 * radii, rel=1e-12, abs=0.0)


def test_solid_disc_is_the_limit_of_a_small_hole():
    solid, pierced = steel(0.0, 30e-3), steel(1e-6, 30e-3)
    expected = rotation_displacement(solid, 30e-3, 2000.0)
    assert rotation_displacement(pierced, 30e-3, 2000.0) == approx(expected, rel=1e-8, abs=0.0)
    assert rotation_displacement(solid, 0.0, 2000.0) == 0.0


def test_even_pressure_all_round_squeezes_like_a_solid():
    assert pressure_displacement(RING, 31e-3, 1e8, 1e8) == approx(
        pressure_displacement(steel(0.0, 33e-3), 31e-3, 0.0, 1e8), rel=1e-12, abs=0.0
    )


def test_work_of_two_pressures_is_mutual():
    """Betti: pressure in the bore on the displacement of the other state, against the reverse."""
    bore, rim = 70e6, 20e6
    from_rim = bore * RING.inner_radius * pressure_displacement(RING, RING.inner_radius, 0.0, rim)
    from_bore = -rim * RING.outer_radius * pressure_displacement(RING, RING.outer_radius, bore, 0.0)
    assert from_rim == approx(from_bore, rel=1e-12, abs=0.0)


def test_work_of_pressure_with_rotation_is_mutual():
    """Betti: bore pressure on the centrifugal growth, against centrifugal force on the pressure's."""
    pressure, speed = 70e6, 3000.0
    nodes, weights = np.polynomial.legendre.leggauss(12)
    half = (RING.outer_radius - RING.inner_radius) / 2
    radii = RING.inner_radius + half * (1 + nodes)
    force = RING.density * speed**2 * radii
    by_force = half * weights @ (force * pressure_displacement(RING, radii, pressure, 0.0) * radii)
    growth = rotation_displacement(RING, RING.inner_radius, speed)
    assert pressure * RING.inner_radius * growth == approx(by_force, rel=1e-12, abs=0.0)


def test_even_heat_of_one_material_keeps_the_pressure():
    """Both sides of the fit grow alike, so the interference stays."""
    cold, hot = (
        seat(SHAFT_FIT, FitConditions()),
        seat(SHAFT_FIT, FitConditions(inside_rise=100.0, outside_rise=100.0)),
    )
    assert hot.pressure == approx(cold.pressure, rel=1e-10, abs=0.0)


def test_like_solid_and_ring_press_as_printed_in_handbooks():
    """p = E Delta (b^2 - R^2) / (4 R b^2), solid shaft in a hub of the same material."""
    radius, rim, interference = 30e-3, 45e-3, 20e-6
    fit = PressFit(inside=steel(0.0, radius), outside=steel(radius, rim), interference=interference)
    expected = 203e9 * interference * (rim**2 - radius**2) / (4 * radius * rim**2)
    assert seat(fit, FitConditions()).pressure == approx(expected, rel=1e-12, abs=0.0)


@given(fits(), states)
def test_bodies_meet_with_pressure_or_part_with_a_gap(fit, state):
    contact = seat(fit, state)
    shaft = fit.interference / 2 + inside_displacement(fit, state, fit.inside.outer_radius)
    bore = outside_displacement(fit, state, fit.outside.inner_radius)
    assert bore - shaft == approx(contact.gap, rel=0.0, abs=1e-16)
    assert contact.pressure >= 0.0
    assert contact.gap >= 0.0
    assert contact.pressure * contact.gap == 0.0


@given(fits(), states, st.floats(1e-7, 50e-6))
def test_more_interference_never_presses_less(fit, state, more):
    tighter = replace(fit, interference=fit.interference + more)
    before, after = seat(fit, state), seat(tighter, state)
    assert after.pressure >= before.pressure
    assert after.gap <= before.gap
    assert after.pressure > before.pressure or after.gap < before.gap


@given(fits(), states)
def test_sense_of_rotation_does_not_matter(fit, state):
    assert seat(fit, state) == seat(fit, replace(state, speed=-state.speed))


@given(runs, interferences, interferences, st.floats(200.0, 600.0))
def test_steps_add_up_to_the_complete_evaluation(run, shaft_interference, housing_interference, housing):
    shaft_fit = replace(SHAFT_FIT, interference=shaft_interference)
    housing_fit = replace(HOUSING_FIT, interference=housing_interference)
    case = mounting(outer=housing_fit, shaft_fit=shaft_fit)
    run = replace(run, housing=housing)
    result = operating_clearance(case, run)

    changes = [step.change for step in result.steps]
    assert result.cold + sum(changes) == approx(result.clearance, rel=0.0, abs=1e-15)
    running = result.cold
    for step in result.steps:
        running += step.change
        assert step.clearance == approx(running, rel=0.0, abs=1e-15)

    inner = FitConditions(
        inside_rise=run.shaft - REFERENCE, outside_rise=run.inner_ring - REFERENCE, speed=run.inner_speed
    )
    outer = FitConditions(
        inside_rise=run.outer_ring - REFERENCE, outside_rise=housing - REFERENCE, speed=run.outer_speed
    )
    room = inside_displacement(housing_fit, outer, 38e-3) - outside_displacement(shaft_fit, inner, 33e-3)
    rollers = 2 * heat_displacement(ROLLER, 2.5e-3, run.rolling_elements - REFERENCE)
    assert result.clearance == approx(60e-6 + 2 * room - 2 * rollers, rel=0.0, abs=1e-15)


@given(runs, st.floats(0.0, 50e-6))
def test_tighter_shaft_fit_never_opens_the_bearing(run, more):
    tighter = replace(SHAFT_FIT, interference=SHAFT_FIT.interference + more)
    loose = operating_clearance(mounting(), run).clearance
    assert operating_clearance(mounting(shaft_fit=tighter), run).clearance <= loose + 1e-18


@given(st.floats(200.0, 600.0))
def test_even_heat_keeps_the_clearance_of_a_steel_bearing(temperature):
    """Everything grows by alpha Delta T, the zero room between raceways and rollers too."""
    hot = replace(
        COLD, shaft=temperature, inner_ring=temperature, rolling_elements=temperature, outer_ring=temperature
    )
    case = mounting(clearance=0.0)
    mounted = operating_clearance(case, COLD).clearance
    assert operating_clearance(case, hot).clearance == approx(mounted, rel=0.0, abs=1e-15)


def test_mounting_takes_clearance_away_on_both_sides():
    case = mounting(outer=HOUSING_FIT)
    steps = {step.name: step for step in operating_clearance(case, replace(COLD, housing=REFERENCE)).steps}
    assert steps["inner fit"].change < 0.0
    assert steps["outer fit"].change < 0.0
    assert all(step.change == 0.0 for step in list(steps.values())[2:])


def test_effects_come_in_the_stated_order():
    names = [step.name for step in operating_clearance(mounting(), COLD).steps]
    assert names == [
        "inner fit",
        "outer fit",
        "inner heat",
        "outer heat",
        "roller heat",
        "inner rotation",
        "outer rotation",
    ]


def test_each_effect_moves_the_clearance_its_way():
    run = replace(
        COLD,
        shaft=400.0,
        inner_ring=390.0,
        rolling_elements=395.0,
        outer_ring=380.0,
        inner_speed=3000.0,
        outer_speed=500.0,
    )
    steps = {step.name: step.change for step in operating_clearance(mounting(), run).steps}
    closing = ("inner fit", "inner heat", "roller heat", "inner rotation")
    assert all(steps[name] < 0.0 for name in closing)
    assert all(steps[name] > 0.0 for name in ("outer heat", "outer rotation"))


def test_free_outer_ring_says_so():
    result = operating_clearance(mounting(), COLD)
    assert result.housing_seat is None
    outer_fit = result.steps[1]
    assert outer_fit.change == 0.0
    assert "free ring" in outer_fit.explanation


def test_fit_that_opens_under_speed_says_so():
    loose = replace(SHAFT_FIT, interference=1e-6)
    result = operating_clearance(mounting(shaft_fit=loose), replace(COLD, inner_speed=4000.0))
    assert result.shaft_seat.is_open
    assert result.shaft_seat.pressure == 0.0
    explanations = {step.name: step.explanation for step in result.steps}
    assert "MPa" in explanations["inner fit"]
    assert "open by" in explanations["inner rotation"]
    assert "pressure zero" in explanations["inner rotation"]
    raceway = rotation_displacement(RING, RING.outer_radius, 4000.0)  # as if there were no shaft
    assert result.clearance == approx(60e-6 - 2 * raceway, rel=0.0, abs=1e-15)


def test_fit_that_opens_under_heat_says_so():
    result = operating_clearance(mounting(outer=HOUSING_FIT), replace(COLD, outer_ring=300.0, housing=400.0))
    assert result.housing_seat is not None
    assert result.housing_seat.is_open
    assert "open by" in result.steps[3].explanation


def test_preload_is_a_result_in_words():
    preloaded = operating_clearance(mounting(clearance=-5e-6), COLD)
    assert preloaded.preloaded
    assert preloaded.clearance < 0.0
    assert "preloaded" in preloaded.verdict
    assert f"{-preloaded.clearance * 1e6:.1f} um" in preloaded.verdict
    roomy = operating_clearance(mounting(), COLD)
    assert not roomy.preloaded
    assert "clearance of" in roomy.verdict


@pytest.mark.parametrize(
    "wrong",
    [
        {"inner_radius": 33e-3},
        {"inner_radius": -1e-3},
        {"outer_radius": 0.0},
        {"youngs_modulus": -1.0},
        {"density": float("nan")},
        {"poisson_ratio": 0.5},
        {"expansion": 11.2},
    ],
    ids=lambda wrong: next(iter(wrong)),
)
def test_impossible_ring_cannot_exist(wrong):
    with pytest.raises(ImpossiblePart, match=next(iter(wrong))):
        replace(RING, **wrong)


def test_fit_needs_one_nominal_radius():
    with pytest.raises(ImpossiblePart, match="nominal radius"):
        PressFit(inside=steel(20e-3, 29e-3), outside=RING, interference=0.0)


@pytest.mark.parametrize("interference", [20.0, float("nan")])
def test_interference_is_small(interference):
    with pytest.raises(ImpossiblePart, match="interference"):
        replace(SHAFT_FIT, interference=interference)


def test_rollers_fit_between_the_raceways():
    with pytest.raises(ImpossiblePart, match="raceways leave"):
        replace(mounting(), rolling_element=steel(0.0, 5e-3))  # a diameter given as the radius


def test_housing_comes_with_its_temperature():
    with pytest.raises(ImpossiblePart, match=r"operating.housing is missing"):
        operating_clearance(mounting(outer=HOUSING_FIT), COLD)
    with pytest.raises(ImpossiblePart, match="outer ring is free"):
        operating_clearance(mounting(), replace(COLD, housing=REFERENCE))


@pytest.mark.parametrize("wrong", [{"shaft": -20.0}, {"housing": 0.0}, {"inner_speed": float("inf")}])
def test_impossible_state_cannot_exist(wrong):
    with pytest.raises(ImpossiblePart, match=next(iter(wrong))):
        replace(COLD, **wrong)


@pytest.mark.parametrize("radius", [29e-3, 34e-3, float("nan")])
def test_displacement_outside_the_ring_is_refused(radius):
    with pytest.raises(OutOfRange, match="outside the body"):
        pressure_displacement(RING, radius, 1e6, 0.0)
    with pytest.raises(OutOfRange, match="outside the body"):
        heat_displacement(RING, radius, 1.0)
