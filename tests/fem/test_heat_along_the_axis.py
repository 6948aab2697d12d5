"""Temperatures that vary along the axis.

A temperature linear in x leaves a free body without stress: u_r = e(x) r, whatever its section.
"""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Elastic, ImpossiblePart, MeshSize, OuterRing, PlanetGear, Resolution
from fem.joint.fitted_ring import FitGrid, FittedRing, condense_fitted
from fem.joint.preloaded_fit import Fit, preloaded
from fem.section.expansion import Along
from tests.fem.condensed import AxisymmetricLoad, expansion_of
from tests.fem.test_parts import SHAFT, STEEL

L, M = 5e-3, 3
COARSE = MeshSize(order=3, size=8e-3, raceway_size=2e-3)
SMALL = FitGrid(bore_points=5, harmonics=8)
TUBE = OuterRing(
    raceway_diameter=75e-3, thickness=3.6e-3, width=60e-3, elastic=STEEL, support=PlanetGear(forces=())
)
RISE = Along(at=(-40e-3, 40e-3), values=(0.0, 4e-3))  # 2e-3 in the middle, 0.05 per metre


def grown(part, expansion, mesh=COARSE):
    return expansion_of(part, L, M, mesh, AxisymmetricLoad(thermal_strains={"ring": expansion}))


def test_tube_with_a_linear_temperature_becomes_a_cone():
    mean, slope, _ = grown(TUBE, RISE)
    assert mean == approx(37.5e-3 * 2e-3, rel=1e-9)
    assert slope == approx(37.5e-3 * 0.05 * L / 2, rel=1e-8)


def test_long_tube_follows_a_kinked_temperature_away_from_the_kink():
    """Bending fades over sqrt(R t) = 12 mm; nothing is felt of a kink five times as far away."""
    long = replace(TUBE, width=240e-3)
    kinked = Along(at=(-120e-3, -60e-3, 120e-3), values=(2e-3, 2e-3 - 0.05 * 60e-3, 2e-3 + 0.05 * 120e-3))
    mean, slope, _ = grown(long, kinked)
    assert (mean, slope) == approx((37.5e-3 * 2e-3, 37.5e-3 * 0.05 * L / 2), rel=2e-3)


def test_even_temperature_is_one_of_those_along_the_axis():
    clamped = replace(TUBE, support=ClampedFace())
    even = Along(at=(-40e-3, 10e-3, 40e-3), values=(1e-3, 1e-3, 1e-3))
    assert grown(clamped, even) == approx(grown(clamped, 1e-3), rel=1e-9, abs=1e-15)


def test_temperature_that_ends_inside_the_body_is_refused():
    with pytest.raises(ImpossiblePart, match="covers the body"):
        grown(TUBE, Along(at=(-40e-3, 20e-3), values=(0.0, 1e-3)))
    for at, values in (((0.0,), (1.0,)), ((0.0, 0.0), (1.0, 1.0)), ((0.0, 1.0), (1.0,))):
        with pytest.raises(ImpossiblePart, match=r"at|values"):
            Along(at=at, values=values)


def fit_with(**variations):
    seat = replace(SHAFT, shaft=Elastic(youngs_modulus=179e9, poisson_ratio=0.281))
    band = Resolution(length=L, axial_modes=M, mesh_size=COARSE)
    bodies = condense_fitted(FittedRing(seat=seat), band, SMALL, variations)
    return preloaded(bodies, Fit(interference=40e-6, friction=0.1))


@pytest.fixture(scope="module")
def even():
    return fit_with()


@pytest.mark.slow
def test_cones_that_go_together_press_as_cylinders_do(even):
    """Ring and shaft with the same temperatures stay in touch; the raceway becomes a cone."""
    cone = Along(at=(-20e-3, 20e-3), values=(-1e-3, 1e-3))
    both = fit_with(ring=cone, shaft=cone)
    assert both.pressure == approx(even.pressure, rel=1e-6)
    assert both.expansion - even.expansion == approx([0, 65e-3 / 2 * 0.05 * L / 2, 0], rel=1e-6, abs=1e-12)


def test_shaft_that_is_warmer_at_one_end_presses_there(even):
    warm = fit_with(shaft=Along(at=(-20e-3, 20e-3), values=(-0.5e-3, 0.5e-3)))
    change = warm.pressure - even.pressure
    x = warm.bodies.ring.points.x
    assert change[x > 1e-6].min() > 0
    assert change[x < -1e-6].max() < 0
    assert change == approx(-change[::-1], rel=0, abs=0.005 * np.abs(change).max())  # of a coarse mesh
