"""Pressure of elastic half-spaces on a grid against closed solutions, and its own conditions."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.contact.ellipse.point_contact import INNER, Curvatures, point_contact, race_curvatures
from quasidynamic.contact.half_space import CellGrid, ElasticPair
from quasidynamic.contact.pressure import (
    BallInGroove,
    NormalCompliance,
    RigidMotions,
    contact_pressure,
    normal_contact,
)
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)
MODULUS = 2 / STEEL.plane_compliance  # E' [Pa]
FORCE = 2000.0  # [N]


def approaching(grid, force):
    return RigidMotions(np.ones((1, *grid.shape)), np.array([force]))


def ellipse(across, along, cells, reach=1.2):
    """Contact of relative curvatures [1/m] on a grid that reaches beyond the axes, and Hertz's."""
    hertz = point_contact(Curvatures(np.array(across), np.array(along)), MODULUS)
    grid = CellGrid(tuple(2 * reach * axis / cells for axis in hertz.semi_axes(FORCE)), (cells, cells))
    x, y = grid.centres
    gap = across * x**2 / 2 + along * y**2 / 2
    return contact_pressure(NormalCompliance.of(STEEL, grid), gap, approaching(grid, FORCE)), gap, hertz


@pytest.mark.parametrize("curvatures", [(100.0, 100.0), (4.0, 100.0), (100.0, 4.0)])
def test_ellipse_of_hertz(curvatures):
    contact, _, hertz = ellipse(*curvatures, 64)
    (x, y), (a, b) = contact.grid.centres, hertz.semi_axes(FORCE)
    assert contact.motions[0] == approx(hertz.approach(FORCE), rel=1e-4)
    assert contact.peak_pressure == approx(hertz.peak_pressure(FORCE), rel=5e-4)
    exact = hertz.peak_pressure(FORCE) * np.sqrt(np.maximum(1 - (x / a) ** 2 - (y / b) ** 2, 0))
    assert np.abs(contact.pressure - exact).sum() / exact.sum() < 2e-3
    wide, long = (
        np.abs(x[contact.touching.any(axis=1)]).max(),
        np.abs(y[:, contact.touching.any(axis=0)]).max(),
    )
    assert (wide, long) == approx((a, b), rel=1.2 / 64)  # half a cell


def test_pressure_of_hertz_is_approached_with_the_power_three_halves_of_the_cells():
    """The pressure starts like a square root at the border of the contact."""
    errors = []
    for cells in (16, 32, 64, 128):
        contact, _, hertz = ellipse(100.0, 100.0, cells)
        (x, y), (a, b) = contact.grid.centres, hertz.semi_axes(FORCE)
        exact = hertz.peak_pressure(FORCE) * np.sqrt(np.maximum(1 - (x / a) ** 2 - (y / b) ** 2, 0))
        errors.append(np.abs(contact.pressure - exact).sum() / exact.sum())
    rate = -np.polyfit(np.log([16, 32, 64, 128]), np.log(errors), 1)[0]
    assert rate == approx(1.5, abs=0.25)


def test_inverted_spectrum_keeps_iterations_few():
    """Influence numbers at all lags of the transform; zeros at those without a pair would double them."""
    assert ellipse(4.0, 100.0, 64)[0].iterations < 45


def test_pressure_carries_the_force_and_nothing_overlaps():
    contact, gap, _ = ellipse(4.0, 100.0, 48)
    separation = (
        gap - contact.motions[0] + NormalCompliance.of(STEEL, contact.grid).displaced(contact.pressure)
    )
    overlap = (contact.motions[0] - gap).max()
    assert contact.force == approx(FORCE, rel=1e-7)
    assert contact.pressure.min() >= 0
    assert separation.min() >= -1e-8 * overlap
    assert np.abs(separation[contact.touching]).max() <= 1e-8 * overlap
    assert separation == approx(contact.separation, abs=1e-8 * overlap)


def test_bodies_held_at_the_approach_found_carry_the_same_pressure():
    contact, gap, _ = ellipse(4.0, 100.0, 32)
    held = RigidMotions(np.zeros((0, *contact.grid.shape)), np.zeros(0))
    again = contact_pressure(NormalCompliance.of(STEEL, contact.grid), gap - contact.motions[0], held)
    assert again.pressure == approx(contact.pressure, abs=1e-5 * contact.peak_pressure)
    assert len(again.motions) == 0


def test_bodies_held_apart_do_not_touch():
    grid = CellGrid((1e-5, 1e-5), (8, 8))
    held = RigidMotions(np.zeros((0, *grid.shape)), np.zeros(0))
    contact = contact_pressure(NormalCompliance.of(STEEL, grid), np.full(grid.shape, 1e-6), held)
    assert not contact.touching.any()


def punch(cells):
    """Flat round punch of 1 mm radius."""
    grid = CellGrid((2e-3 / cells, 2e-3 / cells), (cells, cells))
    x, y = grid.centres
    gap = np.where(x**2 + y**2 < 1e-6, 0.0, 1e-3)
    return contact_pressure(NormalCompliance.of(STEEL, grid), gap, approaching(grid, FORCE))


def test_round_flat_punch():
    """Approach F/(2 a E*), pressure F/(2 pi a^2)/sqrt(1 - (r/a)^2): Johnson (1985), Eqs (3.34), (3.36)."""
    contact = punch(96)
    assert contact.motions[0] == approx(FORCE / (2 * 1e-3 * MODULUS / 2), rel=0.01)
    x, y = contact.grid.centres
    distance = np.hypot(x, y) / 1e-3
    exact = FORCE / (2 * np.pi * 1e-6) / np.sqrt(1 - np.minimum(distance, 0.99) ** 2)
    assert contact.pressure[distance < 0.9] == approx(exact[distance < 0.9], rel=0.03)


def test_pressure_at_the_edge_of_a_punch_grows_with_the_root_of_the_cells():
    assert punch(96).peak_pressure / punch(24).peak_pressure == approx(2.0, rel=0.2)


def test_mirrored_pressure_displaces_like_its_images_on_a_longer_grid():
    grid, longer = CellGrid((1e-5, 3e-5), (6, 10)), CellGrid((1e-5, 3e-5), (6, 30))
    pressure = np.random.default_rng(1).uniform(0, 1e9, grid.shape)
    image = 0.5 * pressure[:, ::-1]
    extended = np.concatenate([image, pressure, image], axis=1)
    expected = NormalCompliance.of(STEEL, longer).displaced(extended)[:, 10:20]
    assert NormalCompliance.of(STEEL, grid, 0.5).displaced(pressure) == approx(expected, rel=1e-12)


def test_moment_tilts_a_punch():
    """A square block under an eccentric force: more pressure on that side, tilt and its moment agree."""
    grid = CellGrid((1e-4, 1e-4), (20, 20))
    y = np.broadcast_to(grid.centres[1], grid.shape)
    motions = RigidMotions(np.stack([np.ones(grid.shape), y]), np.array([FORCE, FORCE * 1e-4]))
    compliance = NormalCompliance.of(STEEL, grid)
    contact = contact_pressure(compliance, np.zeros(grid.shape), motions)
    assert (contact.pressure * y).sum() * grid.cell_area == approx(FORCE * 1e-4, rel=1e-6)
    tilted = contact_pressure(compliance, -contact.motions[1] * y, approaching(grid, FORCE))
    assert tilted.motions[0] == approx(contact.motions[0], rel=1e-6)
    assert tilted.pressure == approx(contact.pressure, rel=1e-4)


def test_contact_that_reaches_the_end_of_the_grid_is_cut_there():
    contact, *_ = ellipse(4.0, 100.0, 32, reach=1.2)
    assert contact.cut == ((False, False), (False, False))
    grid = CellGrid((contact.grid.spacing[0], contact.grid.spacing[1] / 2), contact.grid.shape)
    x, y = grid.centres
    gap = 4.0 * x**2 / 2 + 100.0 * (y - 5 * grid.spacing[1]) ** 2 / 2
    shifted = contact_pressure(NormalCompliance.of(STEEL, grid), gap, approaching(grid, FORCE / 8))
    assert shifted.cut[1] == (False, True)


def test_loads_that_no_pressure_on_the_grid_carries_are_refused():
    grid = CellGrid((1e-4, 1e-4), (10, 10))
    y = np.broadcast_to(grid.centres[1], grid.shape)
    motions = RigidMotions(np.stack([np.ones(grid.shape), y]), np.array([FORCE, FORCE * 6e-4]))
    with pytest.raises(NotSolved):
        contact_pressure(NormalCompliance.of(STEEL, grid), np.zeros(grid.shape), motions)


def test_limit_of_iterations_is_no_solution(monkeypatch):
    monkeypatch.setattr(normal_contact, "LIMIT", 2)
    with pytest.raises(NotSolved) as refused:
        ellipse(4.0, 100.0, 32)
    assert refused.value.outcome == "iteration limit"


def test_gap_that_is_not_finite_is_refused():
    grid = CellGrid((1e-4, 1e-4), (4, 4))
    with pytest.raises(OutOfRange, match="finite"):
        contact_pressure(
            NormalCompliance.of(STEEL, grid), np.full(grid.shape, np.inf), approaching(grid, FORCE)
        )


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(40))
def test_random_ellipses_are_solved(seed):
    rng = np.random.default_rng(seed)
    curvatures = 10 ** rng.uniform(0, 3, 2)
    hertz = point_contact(Curvatures(*curvatures), MODULUS)
    shape = tuple(int(cells) for cells in rng.integers(8, 40, 2))
    axes = hertz.semi_axes(force := 10 ** rng.uniform(0, 5))
    grid = CellGrid(
        tuple(2 * rng.uniform(1.05, 4) * axis / cells for axis, cells in zip(axes, shape, strict=True)), shape
    )
    x, y = grid.centres
    gap = curvatures[0] * x**2 / 2 + curvatures[1] * y**2 / 2
    contact = contact_pressure(NormalCompliance.of(STEEL, grid), gap, approaching(grid, force))
    assert contact.force == approx(force, rel=2e-7)
    assert contact.motions[0] == approx(hertz.approach(force), rel=0.1)


# -- ball in a groove ----------------------------------------------------------------------


def in_groove(force, *, offset, conformity=0.5208333, cells=40, shoulder=np.inf):
    """Ball of 30 mm in the groove of an inner race; second moment of its pressure over Hertz's, groove."""
    radius = conformity * 30e-3
    hertz = point_contact(race_curvatures(30e-3, radius, 1.0, np.pi / 4, INNER), MODULUS)
    a, b = hertz.semi_axes(force)
    grid = CellGrid((2.4 * b / cells, 2.6 * a / (2 * cells)), (cells, 2 * cells))
    x, y = grid.centres
    groove = BallInGroove(
        ball_radius=15e-3,
        groove_radius=radius,
        pitch_diameter=1.0,
        contact_angle=np.pi / 4,
        side=INNER,
        shoulder=shoulder,
    )
    shape = np.ones(grid.shape) if offset else np.broadcast_to(groove.approach(y), grid.shape)
    motions = RigidMotions(shape[None], np.array([force]))
    contact = contact_pressure(NormalCompliance.of(STEEL, grid), groove.gap(x, y), motions)
    return contact, (contact.pressure * y**2).sum() / contact.pressure.sum() / (a**2 / 5), groove


def test_light_ball_in_a_groove_is_that_of_hertz():
    for offset in (True, False):
        contact, second_moment, _ = in_groove(100.0, offset=offset)
        assert second_moment == approx(1.0, abs=3e-3)
        assert contact.force == approx(100.0, rel=1e-3)


def test_uniform_offset_spreads_the_pressure_and_a_real_load_does_not():
    """Case A1 of Heras et al. (2017), 61.38 kN: an independent prototype gave torques of 67.6 N m with an
    offset and 58.3 under a force beside 66.5 with Hertz's pressure; a rolling ball's torque goes with y^2."""
    assert in_groove(61380.0, offset=True)[1] == approx(67.6 / 66.5, abs=0.005)
    assert in_groove(61380.0, offset=False)[1] == approx(58.3 / 66.5, abs=0.02)


def test_force_on_a_conforming_groove_is_the_part_of_the_pressure_along_it():
    contact, *_ = in_groove(61380.0, offset=False)
    assert contact.force > 1.02 * 61380.0


def test_shoulder_cuts_the_patch():
    whole, _, groove = in_groove(20000.0, offset=True)
    assert not groove.cut(whole)
    reach = np.abs(whole.grid.centres[1][:, whole.touching.any(axis=0)]).max()
    cut, _, groove = in_groove(20000.0, offset=True, shoulder=reach / 2)
    assert groove.cut(cut)
    assert not cut.touching[:, cut.grid.centres[1][0] > reach / 2].any()
    assert cut.force == approx(20000.0, rel=1e-7)
    assert cut.peak_pressure > 1.2 * whole.peak_pressure
    beyond, _, groove = in_groove(20000.0, offset=True, shoulder=1.05 * reach)
    assert not groove.cut(beyond)


def test_groove_must_be_wider_than_the_ball():
    with pytest.raises(ImpossiblePart, match="groove_radius"):
        BallInGroove(
            ball_radius=15e-3, groove_radius=15e-3, pitch_diameter=1.0, contact_angle=0.7, side=INNER
        )
