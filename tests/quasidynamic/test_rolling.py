"""Inlet shear: what its four laws of line contacts share, their numbers, and slopes of that of ellipses."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.contact.traction.inlet_shear import (
    ELASTIC,
    RIGID,
    ROLLING_LAWS,
    dowson_higginson,
    ellipse_shear,
    goksem_hargreaves,
)
from tests.quasidynamic.test_drag import OIL

# MIL-PRF-23699 at 220 degC and a 5 mm roller at 38 000 rpm, inner and outer raceway
ISOTHERMAL = replace(OIL, temperature_viscosity=0.0)
RADII = np.array([[2.3213e-3], [2.6786e-3]])
PAIR = (2.3213e-3, 2.2487e11, 5e-3, 0.12, 1.25)
UNIT = 2.3213e-3 * 2.2487e11 * 5e-3
SPEED = 69.26

every_law = pytest.mark.parametrize("law", ROLLING_LAWS.values(), ids=ROLLING_LAWS)
and_of_ellipses = pytest.mark.parametrize(
    "law", [*ROLLING_LAWS.values(), ellipse_shear], ids=[*ROLLING_LAWS, "ellipse"]
)
loads = st.floats(-3, 5).map(lambda power: 10.0**power)  # [N]
speeds = st.floats(-3, 2.5).map(lambda power: 10.0**power)  # [m/s]


def force(law, load, oil=OIL, speed=SPEED):
    return law(np.array(load), np.array(speed), PAIR, oil).force


@pytest.mark.parametrize(
    ("name", "oil", "heavy", "tolerance"),
    [
        ("biboulet-houpert", OIL, [0.278, 0.288], 3e-3),
        ("dowson-higginson", OIL, [0.329, 0.343], 3e-3),
        ("zhou-hoeprich", OIL, [0.449, 0.456], 3e-3),
        # printed from the power law, which the thermal form meets within 0.6 percent
        ("goksem-hargreaves", ISOTHERMAL, [0.267, 0.280], 6e-3),
    ],
)
def test_shear_of_a_loaded_roller(name, oil, heavy, tolerance):
    """F_t at 3537 N, inner and outer raceway: evaluation of the printed formulas, three digits."""
    shear = ROLLING_LAWS[name](np.full((2, 1), 3537.0), np.full((2, 1), SPEED), (RADII, 2.2487e11, 5e-3), oil)
    assert shear.force[:, 0] == approx(heavy, rel=tolerance)


@pytest.mark.parametrize(
    ("name", "oil", "light", "tolerance"),
    [
        ("biboulet-houpert", OIL, [0.277, 0.287], 3e-3),
        ("dowson-higginson", OIL, [0.329, 0.343], 30e-3),  # rounded towards the rigid limit at M = 2
        ("zhou-hoeprich", OIL, [0.183, 0.186], 3e-3),
        ("goksem-hargreaves", ISOTHERMAL, [0.255, 0.268], 10e-3),
    ],
)
def test_shear_of_an_unloaded_roller(name, oil, light, tolerance):
    """F_t at the 92 N of the centrifugal force, where M is 2."""
    shear = ROLLING_LAWS[name](np.full((2, 1), 92.0), np.full((2, 1), SPEED), (RADII, 2.2487e11, 5e-3), oil)
    assert shear.force[:, 0] == approx(light, rel=tolerance)


def test_inlet_heating_lowers_the_shear_of_goksem_and_hargreaves():
    """Thermal 0.220 against isothermal 0.267 N (L = 0.329)."""
    assert force(goksem_hargreaves, 3537.0) == approx(0.220, rel=3e-3)


def test_goksem_and_hargreaves_without_heating_is_their_power_law():
    """2.74 U2^0.658 W^0.0126 G^-0.342, half a percent apart in the published constants."""
    speed = 2 * OIL.viscosity * SPEED / (PAIR[0] * PAIR[1])
    material = OIL.pressure_viscosity * PAIR[1]
    printed = UNIT * 2.74 * speed**0.658 * (3537.0 / UNIT) ** 0.0126 * material**-0.342
    assert force(goksem_hargreaves, 3537.0, ISOTHERMAL) == approx(printed, rel=6e-3)
    almost = force(goksem_hargreaves, 3537.0, replace(OIL, temperature_viscosity=1e-12))
    assert almost == approx(force(goksem_hargreaves, 3537.0, ISOTHERMAL), rel=1e-3)


def test_half_of_the_pumping_force():
    """Pumping 18.4 (1 -/+ gamma) G^-0.3 U^0.7: 0.611 N at the inner, 0.736 N at the outer raceway."""
    shear = dowson_higginson(np.full((2, 1), 3537.0), np.full((2, 1), SPEED), (RADII, 2.2487e11, 5e-3), OIL)
    gamma = 0.07145
    assert 2 * shear.force[:, 0] * [1 - gamma, 1 + gamma] == approx([0.611, 0.736], rel=3e-3)


@every_law
def test_no_load_no_shear(law):
    shear = law(np.array(0.0), np.array(SPEED), PAIR, OIL)
    assert shear.force == 0.0
    assert shear.by_entrainment == approx(0.0, abs=1e-300)
    assert 0.0 < shear.by_load < 1.0


@every_law
def test_light_rollers_shear_as_a_rigid_contact_with_constant_viscosity(law):
    """F = 1.42 l E' R sqrt(U2 W) at M = 0.02, whatever the law."""
    speed = 2 * OIL.viscosity * SPEED / (PAIR[0] * PAIR[1])
    load = 0.02 * np.sqrt(speed)
    assert force(law, load * UNIT) == approx(UNIT * RIGID * np.sqrt(speed * load), rel=0.03)


def test_limits_of_the_source():
    """1.42 sqrt(U2 W) rigid, 1.47 U2^0.75 elastic, and the blend between them at M = 1."""
    assert approx(1.42, abs=5e-3) == RIGID
    assert approx(1.47, abs=5e-3) == ELASTIC
    speed = 2 * OIL.viscosity * SPEED / (PAIR[0] * PAIR[1])
    blend = 1.4 / 0.985 / (1 + (1.4 / 1.45) ** 10) ** 0.1
    load = np.sqrt(speed) * UNIT
    assert force(ROLLING_LAWS["biboulet-houpert"], load) == approx(UNIT * speed**0.75 * blend, rel=1e-3)


@and_of_ellipses
@given(load=loads, speed=speeds)
def test_derivatives_of_the_shear(law, load, speed):
    load, speed, step = np.array(load), np.array(speed), 1e-5
    shear = law(load, speed, PAIR, OIL)
    heavier, lighter = (law(load * (1 + s), speed, PAIR, OIL).force for s in (step, -step))
    faster, slower = (law(load, speed * (1 + s), PAIR, OIL).force for s in (step, -step))
    # in units of the force: a logarithmic slope, exact to step^2 and to rounding over step
    assert shear.by_load * load / shear.force == approx(
        (heavier - lighter) / (2 * step * shear.force), abs=1e-7, rel=1e-7
    )
    assert shear.by_entrainment * speed / shear.force == approx(
        (faster - slower) / (2 * step * shear.force), abs=1e-7, rel=1e-7
    )


@every_law
@given(load=loads, speed=speeds)
def test_shear_stays_positive_and_below_the_rigid_limit(law, load, speed):
    group = 2 * OIL.viscosity * speed / (PAIR[0] * PAIR[1])
    assert 0.0 < force(law, load, speed=speed) <= UNIT * RIGID * np.sqrt(group * load / UNIT)


@every_law
def test_constants_of_the_raceways_broadcast(law):
    load = np.geomspace(1.0, 3000.0, 4 * 2 * 3).reshape(4, 2, 3)
    speed = np.linspace(10.0, 80.0, 4 * 2 * 3).reshape(4, 2, 3)
    modulus = np.array([[2.2e11], [2.0e11]])
    together = law(load, speed, (RADII, modulus, 5e-3), OIL)
    for race in (0, 1):
        pair = (float(RADII[race, 0]), float(modulus[race, 0]), 5e-3)
        alone = law(load[:, race], speed[:, race], pair, OIL)
        for joint, single in zip(together, alone, strict=True):
            assert joint[:, race] == approx(single, rel=1e-13)
