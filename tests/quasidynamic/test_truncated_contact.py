"""Contacts that a shoulder cuts off carry what half-spaces do whose pressure ends there."""

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq

from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.ellipse.truncated import ERROR, carried_share
from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.pressure import NormalCompliance, RigidMotions, contact_pressure

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
FORCE = 2000.0  # [N]


def hertz(curvature):
    return point_contact(Curvatures(np.array(curvature), np.array(100.0)), 2 / STEEL.plane_compliance)


def by_half_spaces(cut, ratio, cells=(48, 96)):
    """Share on a grid whose border is the cut, the approach given."""

    def off(curvature):
        contact = hertz(curvature)
        return float(contact.across / contact.along) - ratio

    curvature = brentq(off, 1e-3, 100.0)
    contact = hertz(curvature)
    across, along = contact.semi_axes(FORCE)
    low, high = -1.7 * across, cut * across
    grid = grid_over((1.5 * along, (high - low) / 2), cells)
    x, y = grid.centres
    gap = (curvature * (y + (low + high) / 2) ** 2 + 100.0 * x**2) / 2 - contact.approach(FORCE)
    held = RigidMotions(np.zeros((0, *grid.shape)), np.zeros(0))
    return contact_pressure(NormalCompliance.of(STEEL, grid), gap, held).force / FORCE


@pytest.mark.parametrize("ratio", [3.1, 9.0, 24.0])
@pytest.mark.parametrize("cut", [-0.9, -0.37, 0.1, 0.5, 0.87])
def test_table_is_what_half_spaces_carry(cut, ratio):
    assert float(carried_share(cut, ratio)) == approx(by_half_spaces(cut, ratio), abs=ERROR)


def test_a_cut_contact_carries_more_than_the_part_of_its_pressure_and_less_than_the_whole():
    cut = np.linspace(-0.99, 0.9, 50)
    share = carried_share(cut, 8.0)
    assert np.all(share > 0.5 + 0.75 * cut - 0.25 * cut**3)
    assert np.all(np.diff(share) > 0)
    assert carried_share([1.0, 2.0], 8.0).tolist() == [1.0, 1.0]


def test_outside_the_table_no_share_is_known():
    assert np.isnan(carried_share([-1.01, 0.5, 0.5], [8.0, 1.4, 31.0])).all()
