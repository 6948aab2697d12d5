"""Stresses below line and point contacts: against sums over point and line loads, limits, extremes."""

from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse import subsurface as ellipse
from quasidynamic.contact.ellipse.subsurface import ellipse_stress
from quasidynamic.contact.line import slices as line
from quasidynamic.contact.line.slices import line_contact_stress
from quasidynamic.contact.section_stress import SectionStress
from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.subsurface import below, largest_von_mises

NU = 0.3
PLACES = [(0.0, 0.5), (0.6, 0.4), (-1.3, 0.8), (1.7, 0.2)]


def flamant(x, z, friction):
    """Sum over line loads and line tractions below a strip, Johnson (1985), Eqs (2.16) and (2.22)."""
    angle = np.pi * (np.arange(20000) + 0.5) / 20000  # s = cos(angle): the pressure has no kink
    s, load = np.cos(angle), np.sin(angle) ** 2 * np.pi / 20000
    u = x - s
    pull = 2 / np.pi * load * (friction * u + z) / (u**2 + z**2) ** 2
    stresses = -(pull * u**2).sum(), -(pull * z**2).sum(), -(pull * u * z).sum()
    return np.array([stresses[0], NU * (stresses[0] + stresses[1]), stresses[1], stresses[2]])


def boussinesq(x, z, axis_ratio):
    """Sum over point loads below an ellipse in its middle plane, Johnson (1985), Eq. (3.19)."""
    cells = 400
    along, across = np.meshgrid(*[(2 * np.arange(cells) + 1) / cells - 1] * 2, indexing="ij")
    pressure = np.sqrt(np.maximum(1 - along**2 - across**2, 0.0))
    load = pressure * (2 / cells) ** 2 / axis_ratio / (2 * np.pi)
    u, v = x - along, across / axis_ratio
    flat, r = u**2 + v**2, np.sqrt(u**2 + v**2 + z**2)

    def direct(one, other):
        spread = (1 - 2 * NU) / flat * ((1 - z / r) * (one**2 - other**2) / flat + z * other**2 / r**3)
        return (load * (spread - 3 * z * one**2 / r**5)).sum()

    normal, shear = ((-3 * load * part * z**2 / r**5).sum() for part in (z, u))
    return np.array([direct(u, v), direct(v, u), normal, shear])


@pytest.mark.parametrize("friction", [0.0, 0.1, -0.3])
@pytest.mark.parametrize(("x", "z"), PLACES)
def test_stress_below_a_strip_is_the_sum_over_line_loads(x, z, friction):
    stress = np.array(line_contact_stress(x, z, NU, friction))
    assert stress == approx(flamant(x, z, friction), rel=0, abs=1e-9)


@pytest.mark.parametrize("axis_ratio", [1.0, 0.5, 0.1])
@pytest.mark.parametrize(("x", "z"), PLACES)
def test_stress_below_an_ellipse_is_the_sum_over_point_loads(x, z, axis_ratio):
    stress = np.array(ellipse_stress(x, z, axis_ratio, NU))
    assert stress == approx(boussinesq(x, z, axis_ratio), rel=0, abs=3e-5)


def test_long_ellipse_tends_to_a_line_in_proportion_to_its_ratio():
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 31), np.linspace(0.05, 1.5, 20))
    line_stress = np.array(line_contact_stress(x, z, NU))
    error = [np.abs(np.array(ellipse_stress(x, z, k, NU)) - line_stress).max() for k in (0.02, 0.01)]
    rate = np.log2(error[0] / error[1])
    assert rate == approx(1.0, rel=0, abs=0.05)
    assert error[1] < 5e-3


def test_nearly_round_ellipse_tends_to_the_circle():
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 31), np.linspace(0.05, 1.5, 20))
    circle = np.array(ellipse_stress(x, z, 1.0, NU))
    for gap in (1e-4, 1e-6, 1e-8):
        assert np.array(ellipse_stress(x, z, 1 - gap, NU)) == approx(circle, rel=0, abs=2 * gap)


def test_pressure_acts_at_the_surface_and_nothing_beside_it():
    x, z = np.array([0.0, 0.5, -0.9, 1.5, -2.0]), 1e-9
    pressure = np.sqrt(np.maximum(1 - x**2, 0.0))
    sliding = line_contact_stress(x, z, NU, 0.2)
    assert sliding.normal == approx(-pressure, rel=0, abs=1e-8)
    assert sliding.shear == approx(-0.2 * pressure, rel=0, abs=1e-8)  # traction on the body towards +x
    assert ellipse_stress(x, z, 0.4, NU).normal == approx(-pressure, rel=0, abs=1e-8)


def test_plane_stresses_under_a_load_balance_it():
    x = np.linspace(-400.0, 400.0, 400001)
    stress = line_contact_stress(x, 0.8, NU, 0.15)
    assert np.trapezoid(stress.normal, x) == approx(-np.pi / 2, rel=1e-5)
    assert np.trapezoid(stress.shear, x) == approx(-0.15 * np.pi / 2, rel=2e-2)


def fine(stress):
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 1201), np.linspace(0.01, 1.2, 600))
    shear = stress(x, z).shear
    place = np.unravel_index(shear.argmax(), shear.shape)
    return shear[place], z[place], x[place]


@pytest.mark.slow
@pytest.mark.parametrize("axis_ratio", [0.05, 0.3, 0.7, 1.0])
def test_amplitude_of_lundberg_and_palmgren_is_the_extreme_of_the_field(axis_ratio):
    amplitude, depth = ellipse.orthogonal_shear(1.0, 1.0, axis_ratio)
    found = fine(partial(ellipse_stress, axis_ratio=axis_ratio, poisson_ratio=NU))
    assert found[:2] == approx((amplitude, depth), rel=0, abs=1e-3)
    assert found[0] == approx(amplitude, rel=2e-5)


def test_line_contact_has_a_quarter_of_the_pressure_at_half_of_the_half_width():
    shear, depth, place = fine(partial(line_contact_stress, poisson_ratio=NU))
    assert line.orthogonal_shear(2.0, 3.0) == approx((0.5, 1.5), rel=1e-15)
    assert shear == approx(0.25, rel=2e-5)
    assert (depth, place) == approx((0.5, -np.sqrt(3) / 2), rel=0, abs=2e-3)
    assert ellipse.orthogonal_shear(1.0, 1.0, 0.0) == approx((0.25, 0.5), rel=1e-14)


def test_amplitude_falls_as_an_ellipse_becomes_round():
    amplitude, depth = ellipse.orthogonal_shear(1.0, 1.0, np.linspace(0.0, 1.0, 11))
    assert np.all(np.diff(amplitude) < 0)
    assert np.all(np.diff(depth) < 0)


def test_friction_of_a_line_brings_the_largest_stress_to_the_surface():
    smooth, rough = (
        largest_von_mises(partial(line_contact_stress, poisson_ratio=NU, friction=mu)) for mu in (0.0, 0.4)
    )
    assert rough[0] > smooth[0]
    assert rough[1] < 1e-3 < smooth[1]
    assert largest_von_mises(partial(line_contact_stress, poisson_ratio=NU, friction=-0.4)) == approx(
        rough, rel=1e-12
    )


def test_field_scales_with_pressure_and_width():
    stresses = [partial(line_contact_stress, poisson_ratio=nu) for nu in (0.25, 0.3)]
    field = below(stresses, np.array([1e9, 2e9]), np.array([1e-4, 2e-4]))
    assert field.von_mises.max(axis=(1, 2)) == approx(field.largest, rel=1e-3)
    assert field.largest[1] / 2e9 == approx(0.5575, rel=0, abs=1e-4)
    assert field.shear.max(axis=(1, 2)) == approx([0.25e9, 0.5e9], rel=2e-4)
    assert field.positions[1] == approx(2 * field.positions[0], rel=1e-14)
    row, _ = np.unravel_index(field.von_mises[1].argmax(), field.von_mises[1].shape)
    assert field.depths[1, row] == approx(field.largest_depth[1], rel=0, abs=2e-4 * 2.4 / 96)


def test_largest_shear_stress_may_act_out_of_the_plane():
    pulled = SectionStress(np.array(3.0), np.array(-4.0), np.array(1.0), np.array(0.0))
    assert pulled.principal_shear == approx(3.5, rel=1e-15)
    assert pulled.von_mises == approx(np.sqrt((49 + 25 + 4) / 2), rel=1e-15)


@pytest.mark.parametrize("ratio", [0.0, 1.5, -1.0, np.nan])
def test_ellipse_along_the_rolling_direction_is_refused(ratio):
    with pytest.raises(OutOfRange, match="b/a"):
        ellipse_stress(0.0, 0.5, ratio, NU)


def test_equivalent_stress_and_largest_shear_do_not_depend_on_the_axes():
    x, y, z, shear = 1.0, -2.0, 0.5, 0.7
    turn = np.radians(np.linspace(0.0, 180.0, 7))
    middle, half, double = (x + z) / 2, (x - z) / 2, 2 * turn
    turned = SectionStress(
        middle + half * np.cos(double) + shear * np.sin(double),
        np.full(turn.shape, y),
        middle - half * np.cos(double) - shear * np.sin(double),
        shear * np.cos(double) - half * np.sin(double),
    )
    assert np.ptp(turned.von_mises) < 1e-14
    assert np.ptp(turned.principal_shear) < 1e-14
    pure = SectionStress(*map(np.array, (0.0, 0.0, 0.0, 2.0)))
    assert pure.von_mises == approx(2 * np.sqrt(3), rel=1e-15)


@pytest.mark.parametrize("friction", [0.0, 0.1, 0.26, 0.27, 0.28, 0.3, -0.3, 0.5])
def test_largest_stress_is_found_below_and_at_the_surface(friction):
    depth = np.concatenate([[1e-7], np.linspace(0.005, 1.0, 200)])
    stress = partial(line_contact_stress, poisson_ratio=NU, friction=friction)
    dense = stress(*np.meshgrid(np.linspace(-1.5, 1.5, 601), depth)).von_mises
    size, found = largest_von_mises(stress)
    assert size == approx(dense.max(), rel=1e-4)
    assert found == approx(depth[dense.argmax() // 601], rel=0, abs=6e-3)
