"""Displacements of half-spaces on a grid against closed formulas."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.half_space import (
    CellGrid,
    X,
    Y,
    Z,
    convolution,
    elastic_pair,
    grid_over,
    influence_number,
)
from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.material import Material

STEEL = Material(youngs_modulus=210e9, poisson_ratio=0.3, density=7850)
CERAMIC = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200)
PAIR = elastic_pair(STEEL, CERAMIC)
DIRECTIONS = [(i, j) for i in (X, Y, Z) for j in (X, Y, Z)]


def hertzian(grid, semi_axes):
    """sqrt(1 - x^2/a^2 - y^2/b^2) at the centres of cells."""
    x, y = grid.centres
    return np.sqrt(np.maximum(1 - (x / semi_axes[0]) ** 2 - (y / semi_axes[1]) ** 2, 0.0))


def on_circle(number, cells=96):
    """Displacements (3, n, n) on a circle of radius 1 under sqrt(1 - r^2) of one traction, with its grid."""
    grid = grid_over((1.0, 1.0), (cells, cells))
    displacement = convolution(PAIR, grid, (X, Y, Z), (number,))
    return grid, displacement(hertzian(grid, (1.0, 1.0))[None])


def test_equal_bodies_have_the_constants_of_one_and_no_coupling():
    pair = elastic_pair(STEEL, STEEL)
    modulus = 210e9 / 2.6
    assert pair.shear == approx(1 / modulus, rel=1e-15)
    assert pair.poisson == approx(0.3 / modulus, rel=1e-15)
    assert pair.coupling == 0.0
    assert pair.plane_compliance == approx(2 * STEEL.plane_compliance, rel=1e-15)


def test_plane_compliance_of_two_materials_is_that_of_line_contacts():
    assert PAIR.plane_compliance == approx(STEEL.plane_compliance + CERAMIC.plane_compliance, rel=1e-14)


def test_even_pressure_on_a_square_displaces_its_centre_and_corner():
    """Timoshenko and Goodier (1970), sec. 139: 1.122 and 0.561 times p (1 - nu^2)/E times the side."""
    place = np.array([0.0, 0.5]), np.array([0.0, 0.5])
    centre, corner = influence_number(PAIR, Z, Z, place, (1.0, 1.0)) / PAIR.plane_compliance
    assert centre == approx(1.122, abs=5e-4)
    assert corner == approx(centre / 2, rel=1e-14)


@pytest.mark.parametrize(("displacement", "traction"), DIRECTIONS)
def test_a_small_cell_far_away_is_a_point_force(displacement, traction):
    place, cell = np.array([0.3, -0.4]), (1e-3, 2e-3)
    radius, towards = 0.5, np.append(place, 0.0) / 0.5
    point = (PAIR.poisson * np.outer(towards, towards) + PAIR.plane_compliance * np.eye(3)) / radius
    point[:Z, Z], point[Z, :Z] = -PAIR.coupling * place / radius**2, PAIR.coupling * place / radius**2
    number = influence_number(PAIR, displacement, traction, tuple(place), cell)
    assert number / 2e-6 * np.pi == approx(point[displacement, traction], rel=1e-4)


@pytest.mark.parametrize(("displacement", "traction"), DIRECTIONS)
def test_four_quarters_of_a_cell_act_as_the_whole(displacement, traction):
    """Also where a corner or an edge of a quarter meets the place."""
    for x, y in ((0.0, 0.0), (0.7, 0.0), (0.0, -0.3), (1.0, 1.0), (3.0, -2.0)):
        parts = [(x + dx, y + dy) for dx in (-0.5, 0.5) for dy in (-0.5, 0.5)]
        quarters = sum(influence_number(PAIR, displacement, traction, part, (1.0, 1.0)) for part in parts)
        whole = influence_number(PAIR, displacement, traction, (x, y), (2.0, 2.0))
        assert quarters == approx(float(whole), abs=1e-12 * PAIR.shear)


def test_hertz_pressure_presses_a_paraboloid():
    """Displacement inside the ellipse: the approach less the relative curvature."""
    curvatures = Curvatures(np.asarray(8.0), np.asarray(70.0))
    contact = point_contact(curvatures, 2 / PAIR.plane_compliance)
    load = 2000.0
    across, along = (float(value) for value in contact.semi_axes(load))
    grid = grid_over((along, across), (64, 128))
    pressure = float(contact.peak_pressure(load)) * hertzian(grid, (along, across))
    deflection = convolution(PAIR, grid, (Z,), (Z,))(pressure[None])[0]
    x, y = grid.centres
    pressed = deflection + 35.0 * x**2 + 4.0 * y**2
    inside = (x / along) ** 2 + (y / across) ** 2 < 0.9
    assert pressed[inside] == approx(float(contact.approach(load)), rel=2e-3)


def test_a_hertzian_shear_traction_shears_a_circle_by_a_quadratic():
    """Johnson (1985), Eq. (3.91), for both bodies together."""
    grid, displacements = on_circle(X)
    x, y = grid.centres
    flat, nu = PAIR.shear, PAIR.poisson
    expected = np.pi / 16 * (4 * (2 * flat - nu) - (4 * flat - 3 * nu) * x**2 - (4 * flat - nu) * y**2)
    inside = x**2 + y**2 < 0.95
    assert displacements[X][inside] == approx(expected[inside], rel=3e-3)
    assert displacements[Y][inside] == approx((np.pi / 8 * nu * x * y)[inside], abs=2e-3 * flat)


def test_pressure_on_unequal_bodies_draws_the_surfaces_inwards():
    """Johnson (1985), Eq. (3.41b), for the difference of both bodies."""
    grid, displacements = on_circle(Z)
    x, y = grid.centres
    square = x**2 + y**2
    inside = (square < 0.95) & (square > 0.05)
    drawn = (1 - np.maximum(1 - square, 0.0) ** 1.5) / square
    assert displacements[X][inside] == approx((-2 / 3 * PAIR.coupling * drawn * x)[inside], rel=5e-3)


def test_work_of_two_tractions_is_mutual():
    """Betti: pressure on the displacement by shear as shear on the displacement by pressure."""
    grid = CellGrid((1.0, 0.7), (5, 8))
    rng = np.random.default_rng(1)
    first, second = rng.normal(size=(2, 3, 5, 8))
    displacement = convolution(PAIR, grid, (X, Y, Z), (X, Y, Z))
    assert (displacement(first) * second).sum() == approx((displacement(second) * first).sum(), rel=1e-11)


@pytest.mark.parametrize("shape", [(1, 1), (1, 6), (5, 8), (7, 11)])
def test_transform_sums_the_influence_of_every_cell_at_shifted_places(shape):
    grid, shift = CellGrid((1e-5, 3e-5), shape), (4e-6, -2e-5)
    tractions = np.random.default_rng(2).normal(size=(2, 2, *shape))
    x, y = (np.ravel(part) for part in np.broadcast_arrays(*grid.centres))
    place = x[:, None] + shift[0] - x, y[:, None] + shift[1] - y
    matrix = np.array(
        [[influence_number(PAIR, i, j, place, grid.spacing) for j in (X, Z)] for i in (X, Y, Z)]
    )
    expected = np.einsum("ijkl,njl->nik", matrix, tractions.reshape(2, 2, -1)).reshape(2, 3, *shape)
    result = convolution(PAIR, grid, (X, Y, Z), (X, Z), shift)(tractions)
    assert result == approx(expected, rel=1e-11, abs=1e-12 * np.abs(expected).max())


def test_single_precision_displaces_as_double_to_its_rounding():
    grid = CellGrid((1e-5, 2e-5), (12, 9))
    moved = convolution(PAIR, grid, (X, Y), (X, Y))
    tractions = np.random.default_rng(3).uniform(-1e9, 1e9, (2, *grid.shape))
    double, single = moved(tractions), moved(tractions.astype(np.float32))
    assert single.dtype == np.float32
    assert single == approx(double, rel=0.0, abs=1e-6 * np.abs(double).max())


@pytest.mark.parametrize(
    ("spacing", "shape"), [((0.0, 1.0), (2, 2)), ((1.0, -1.0), (2, 2)), ((1.0, 1.0), (0, 2))]
)
def test_impossible_grid_is_refused(spacing, shape):
    with pytest.raises(ImpossiblePart, match="grid"):
        CellGrid(spacing, shape)
