"""Rolling contact against closed solutions and Kalker's table."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.half_space import CellGrid, ElasticPair, grid_over
from quasidynamic.contact.rolling.full_sliding import hertz_pressure
from quasidynamic.contact.rolling.kalker import creep_coefficients, kalker
from quasidynamic.contact.rolling.rolling_contact import MID_STEP, RollingContacts
from tests.reference.rolling_steps import RollingSteps

# Kalker (1990), Three-Dimensional Elastic Bodies in Rolling Contact, App. E: a/b, then C11, C22, C23
TABLE = {
    0.0: [
        (0.1, 2.51, 2.51, 0.334),
        (0.3, 2.68, 2.68, 0.607),
        (0.5, 2.88, 2.88, 0.827),
        (1.0, 3.40, 3.40, 1.33),
    ],
    0.25: [
        (0.1, 3.31, 2.52, 0.473),
        (0.2, 3.37, 2.63, 0.603),
        (0.5, 3.62, 3.01, 0.929),
        (1.0, 4.12, 3.67, 1.47),
    ],
    0.5: [
        (0.1, 4.85, 2.53, 0.731),
        (0.3, 4.80, 2.81, 0.889),
        (0.5, 4.83, 3.14, 1.07),
        (1.0, 5.20, 3.98, 1.63),
    ],
}
ROWS = [(poisson, *row) for poisson, rows in TABLE.items() for row in rows]
STICKING = 1e15  # [Pa] friction limit above any traction


def pair(poisson):
    return ElasticPair(shear=1 / 80e9, poisson=poisson / 80e9)


def ellipse(semi_axes, shape, poisson, limit):
    """Contact of the cells whose centres lie in the ellipse, with a limit on each."""
    grid = grid_over(semi_axes, shape)
    x, y = grid.centres
    inside = (x / semi_axes[0]) ** 2 + (y / semi_axes[1]) ** 2 < 1
    return RollingContacts((grid,), (pair(poisson),), np.where(inside, limit, 0.0)[None])


@pytest.mark.parametrize(("poisson", "ratio", *("c11", "c22", "c23")), ROWS)
def test_tabulated_coefficients_are_those_of_kalker(poisson, ratio, c11, c22, c23):
    assert creep_coefficients(ratio, poisson) == approx([c11, c22, c23], rel=0.015)
    assert creep_coefficients(ratio, poisson)[:2] == approx([c11, c22], rel=0.006)


@pytest.mark.parametrize("row", [row for row in ROWS if row[0] == 0.25 and row[1] < 0.5], ids=str)
def test_small_creep_gives_the_coefficients_of_kalker(row):
    check_creep_forces(*row)


@pytest.mark.slow
@pytest.mark.parametrize("row", [row for row in ROWS if row[0] == 0.25 and row[1] >= 0.5], ids=str)
def test_small_creep_on_wide_contacts_gives_the_coefficients_of_kalker(row):
    check_creep_forces(*row)


def small_creep(poisson, ratio, cells=80):
    """Coefficients C11, C22, C23 found on cells that all stick."""
    b, size = 1e-3, 1e-6
    a = ratio * b
    contacts = ellipse((a, b), (cells, cells), poisson, STICKING)
    x, y = contacts.places(MID_STEP)
    fields = np.zeros((3, 1, 2, cells, cells))
    fields[0, :, 0], fields[1, :, 1] = 1.0, 1.0
    fields[2, :, 0], fields[2, :, 1] = -y / b, x / b
    forces = [-kalker(contacts, size * field).force[0] for field in fields]
    unit = a * b * 80e9 * size
    return forces[0][0] / unit, forces[1][1] / unit, forces[2][1] / (unit * np.sqrt(a / b))


def check_creep_forces(poisson, ratio, *coefficients):
    found = small_creep(poisson, ratio)
    assert found[:2] == approx(coefficients[:2], rel=0.006)
    assert found[2] == approx(coefficients[2], rel=0.015)


CARTER = (0.4375, 0.75, 0.96)  # tangential force over its limit
CATTANEO = (0.2, 0.5, 0.9)


def carter(share, cells=200):
    """A cylinder under the creep of that share: force over its limit, and what sticks of which cells."""
    a, friction, peak, poisson = 1e-3, 0.3, 1e9, 0.25
    grid = CellGrid((2 * a / cells, 1000 * a), (cells, 1))  # a strip so wide that it is a line contact
    edges = np.linspace(-1, 1, cells + 1)
    area = (edges * np.sqrt(1 - edges**2) + np.arcsin(edges)) / 2
    limit = friction * peak * np.diff(area) * cells / 2
    contacts = RollingContacts((grid,), (pair(poisson),), limit[None, :, None])
    creep = np.zeros((1, 2, cells, 1))
    creep[0, 0] = friction * 2 * peak * (1 - poisson) / 80e9 * (1 - np.sqrt(1 - share))
    rolled = kalker(contacts, creep)
    return -rolled.force[0, 0] / (limit.sum() * grid.cell_area), rolled.stick_share[0], rolled.stick[0]


@pytest.mark.parametrize("share", CARTER)
def test_long_cylinders_roll_as_carter_found(share):
    """Johnson (1985), sec. 8.3: creep of a force of that share of the limit, and the length that sticks."""
    force, sticking, stick = carter(share)
    assert force == approx(share, rel=0.005)
    assert sticking == approx(np.sqrt(1 - share), abs=1e-9)
    assert np.flatnonzero(stick)[-1] == stick.size - 1  # at the leading edge


def cattaneo(share, cells=64):
    """Spheres shifted by what that share of the limit takes: force over it, radius that sticks over a."""
    a, load, friction, poisson = 1e-3, 100.0, 0.3, 0.25
    grid = grid_over((a, a), (cells, cells))
    pressure = hertz_pressure(grid, (a, a), load)
    shift = np.zeros((2, cells, cells))
    shift[0] = -3 * friction * load * (2 - poisson) / (8 * 80e9 * a) * (1 - (1 - share) ** (2 / 3))
    state = RollingSteps(grid, pair(poisson), cells=0).after(np.zeros_like(shift), shift, friction * pressure)
    radius = np.sqrt((state.stick & (pressure > 0)).sum() * grid.cell_area / np.pi)
    return state.traction[0].sum() * grid.cell_area / (friction * load), radius / a


@pytest.mark.parametrize("share", CATTANEO)
def test_spheres_under_a_side_force_slip_in_a_ring(share):
    """Cattaneo and Mindlin; Johnson (1985), Eqs (7.41) and (7.42)."""
    force, radius = cattaneo(share)
    assert force == approx(share, rel=0.002)
    assert radius == approx((1 - share) ** (1 / 3), abs=2 / 64)
