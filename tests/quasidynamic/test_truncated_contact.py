"""Contacts that a shoulder cuts off carry what half-spaces do whose pressure ends there."""

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq

from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.ellipse.truncated import ERROR, carried_share, energy_share
from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.pressure import NormalCompliance, RigidMotions, contact_pressure

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
FORCE = 2000.0  # [N]


def hertz(curvature):
    return point_contact(Curvatures(np.array(curvature), np.array(100.0)), 2 / STEEL.plane_compliance)


def by_half_spaces(cut, ratio, cells=(48, 96)):
    """Shares of load and energy, and moment as derivative of the latter, at a cut, the approach given."""

    def off(curvature):
        contact = hertz(curvature)
        return float(contact.across / contact.along) - ratio

    curvature = brentq(off, 1e-3, 100.0)
    contact = hertz(curvature)
    across, along = contact.semi_axes(FORCE)
    low, high = -1.7 * across, cut * across
    grid = grid_over((1.5 * along, (high - low) / 2), cells)
    x, y = grid.centres
    place, approach = y + (low + high) / 2, float(contact.approach(FORCE))
    gap = (curvature * place**2 + 100.0 * x**2) / 2 - approach
    held = RigidMotions(np.zeros((0, *grid.shape)), np.zeros(0))
    pressed = contact_pressure(NormalCompliance.of(STEEL, grid), gap, held)
    force = pressed.pressure * grid.cell_area
    whole = 0.4 * FORCE * approach
    return (
        pressed.force / FORCE,
        (force * -gap).sum() / 2 / whole,
        -curvature * across * (force * place).sum() / whole,
    )


CUTS = pytest.mark.parametrize("cut", [-0.9, -0.37, 0.1, 0.5, 0.87])
RATIOS = pytest.mark.parametrize("ratio", [3.1, 9.0, 24.0])


@RATIOS
@CUTS
def test_fit_is_what_half_spaces_carry(cut, ratio):
    """At cuts and ratios that are none of those it was fitted to."""
    load, energy, slope = by_half_spaces(cut, ratio)
    fit = energy_share(cut, ratio)
    assert float(carried_share(cut, ratio)) == approx(load, abs=ERROR)
    assert float(fit.value) == approx(energy, abs=ERROR)
    assert float(fit.slope) == approx(slope, abs=3 * ERROR)


def test_a_cut_contact_carries_more_than_the_part_of_its_pressure_and_less_than_the_whole():
    cut = np.linspace(-0.99, 0.9, 50)
    share = carried_share(cut, 8.0)
    assert np.all(share > 0.5 + 0.75 * cut - 0.25 * cut**3)
    assert np.all(np.diff(share) > 0)


def test_nothing_is_cut_off_beyond_the_ellipse_and_nothing_left_where_surfaces_do_not_overlap():
    """Undeformed surfaces overlap up to sqrt(2) semi-axes of a circle."""
    assert energy_share([1.0, 2.0], 8.0) == (
        approx(np.ones(2), abs=0),
        approx(np.zeros(2), abs=0),
        approx(np.zeros(2), abs=0),
    )
    assert carried_share([-1.42, -3.0], 1.0).tolist() == [0.0, 0.0]
    assert 0.0 < float(carried_share(-1.38, 1.0)) < 1e-2


@pytest.mark.parametrize("ratio", [1.0, 5.0, 60.0])
def test_derivatives_of_the_energy_are_its_differences(ratio):
    cut, step = np.linspace(-1.05, 0.99, 23), 1e-6
    fit, ahead, behind = (energy_share(cut + move, ratio) for move in (0.0, step, -step))
    assert (ahead.value - behind.value) / (2 * step) == approx(fit.slope, abs=1e-8)
    assert (ahead.slope - behind.slope) / (2 * step) == approx(fit.curvature, abs=1e-6)
