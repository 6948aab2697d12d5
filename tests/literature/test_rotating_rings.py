"""Rotating rings, Lame, hot press fit: numbers of an aero-engine main bearing.

Source of every number: computed independently, plane stress; finite differences agree to 1e-8.
The clearance change is 2 (outer raceway growth - inner raceway growth - roller diameter growth):
no outer rotation, no centrifugal growth of the rollers, no interference when cold.
"""

from dataclasses import replace
from math import pi

import pytest
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
from quasidynamic.clearance.press_fit import outside_displacement, running_interference

SPEED = 38000 * 2 * pi / 60  # [rad/s]
UM, MPA = 1e-6, 1e6

STEEL = {"youngs_modulus": 203e9, "poisson_ratio": 0.28, "density": 7850.0, "expansion": 11.2e-6}
RING = Annulus(inner_radius=29.8e-3, outer_radius=32.5e-3, **STEEL)
SHAFT = Annulus(
    inner_radius=25.8e-3,
    outer_radius=29.8e-3,
    youngs_modulus=179e9,
    poisson_ratio=0.281,
    density=8240.0,
    expansion=13.8e-6,
)
OUTER = Annulus(inner_radius=37.5e-3, outer_radius=40e-3, **STEEL)  # free: its thickness does not matter
# The source prints the growth, 12.257 um from 20 to 226 C, not the expansion: 11.9e-6 gives it for 5 mm.
ROLLER = Annulus(inner_radius=0.0, outer_radius=2.5e-3, **STEEL | {"expansion": 11.9e-6})

FIT = PressFit(inside=SHAFT, outside=RING, interference=0.0)
HOT = FitConditions(inside_rise=210.0, outside_rise=200.0)
HOT_TURNING = replace(HOT, speed=SPEED)

MOUNTING = Mounting(cold_clearance=0.0, shaft_fit=FIT, outer=OUTER, rolling_element=ROLLER)
STANDING = OperatingConditions(
    reference=293.15, shaft=503.15, inner_ring=493.15, rolling_elements=499.15, outer_ring=491.15
)
RUNNING = replace(STANDING, inner_speed=SPEED)


@pytest.mark.parametrize(
    ("body", "radius", "growth"),
    [
        pytest.param(RING, 29.8e-3, 18.72190, id="ring bore"),
        pytest.param(RING, 32.5e-3, 18.27572, id="raceway"),
        pytest.param(SHAFT, 29.8e-3, 15.3279, id="shaft"),
    ],
)
def test_centrifugal_growth(body, radius, growth):
    assert rotation_displacement(body, radius, SPEED) / UM == approx(growth, rel=1e-5, abs=0.0)


@pytest.mark.parametrize(("radius", "growth"), [(29.8e-3, 173.7899), (32.5e-3, 169.0433)])
def test_growth_under_100_mpa_in_the_bore(radius, growth):
    assert pressure_displacement(RING, radius, 100 * MPA, 0.0) / UM == approx(growth, rel=1e-5, abs=0.0)


def test_cold_ring_lifts_off_the_turning_shaft():
    lifted = seat(FIT, FitConditions(speed=SPEED))
    assert lifted.is_open
    assert lifted.pressure == 0.0
    assert lifted.gap / UM == approx(3.394, rel=0.0, abs=5e-4)


@pytest.mark.parametrize(
    ("state", "interference", "pressure", "growth"),
    [
        pytest.param(HOT, 19.6084, 6.8701, 84.4135, id="standing"),
        pytest.param(HOT_TURNING, 16.2144, 5.6810, 100.6791, id="turning"),
    ],
)
def test_hot_shaft_in_ring(state, interference, pressure, growth):
    assert running_interference(FIT, state) / UM == approx(interference, rel=1e-5, abs=0.0)
    assert seat(FIT, state).pressure / MPA == approx(pressure, rel=1e-5, abs=0.0)
    assert outside_displacement(FIT, state, 32.5e-3) / UM == approx(growth, rel=1e-5, abs=0.0)


@pytest.mark.parametrize(
    ("body", "radius", "rise", "growth"),
    [
        pytest.param(RING, 32.5e-3, 200.0, 72.8, id="inner raceway"),
        pytest.param(OUTER, 37.5e-3, 198.0, 83.160, id="outer raceway"),
        pytest.param(ROLLER, 2.5e-3, 206.0, 12.257 / 2, id="roller radius"),
    ],
)
def test_free_thermal_growth(body, radius, rise, growth):
    assert heat_displacement(body, radius, rise) / UM == approx(growth, rel=1e-5, abs=0.0)


@pytest.mark.parametrize(
    ("running", "change"),
    [pytest.param(STANDING, -27.021, id="heat"), pytest.param(RUNNING, -59.552, id="heat with speed")],
)
def test_change_of_the_diametral_clearance(running, change):
    assert operating_clearance(MOUNTING, running).clearance / UM == approx(change, rel=0.0, abs=5e-4)
