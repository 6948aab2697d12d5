"""Raceways that yield: which rollers touch is found in a few steps, also where loads are light or tilted."""

from itertools import pairwise

import numpy as np
import pytest

from quasidynamic.solve.rollers.newton import SPIN_CHANGE
from quasidynamic.solve.step_length import SolverOutcome
from tests.bearings import RPM, paper_bearing

RADIUS, WIDTH, MODULUS = 39.3e-3, 5e-3, 203e9


def ring(azimuth, thickness, foundation, shapes):
    """Compliance (Z, M, Z, M) [m/N]: bending harmonics on springs, higher shapes at their own place only."""
    bending, area = MODULUS * WIDTH * thickness**3 / 12, WIDTH * thickness
    apart = azimuth[:, None] - azimuth
    radial = np.full(apart.shape, 1 / (2 * np.pi * RADIUS * (MODULUS * area / RADIUS**2 + foundation)))
    for n in range(2, 60):
        stiff = np.pi * RADIUS * (bending * (n**2 - 1) ** 2 / RADIUS**4 + foundation)
        radial += np.cos(n * apart) / stiff
    found, each = np.zeros((len(azimuth), shapes, len(azimuth), shapes)), np.arange(len(azimuth))
    found[:, 0, :, 0] = radial
    for shape in range(1, shapes):
        found[each, shape, each, shape] = 3e-9
    # A ring held at one side tilts as it yields, and bends along the roller.
    found[:, 1, :, 0] = found[:, 0, :, 1] = 0.3 * radial
    found[:, 2, :, 0] = found[:, 0, :, 2] = -0.05 * radial
    return found


CASES = {
    "heavy": ({}, 1e8),
    "light": ({"load": 500.0}, 1e8),
    "moment": ({"moment": 60.0}, 1e8),
    "slow": ({"speed": 5.0}, 1e8),
    "preload": ({"clearance": -40e-6}, 1e8),
    "very soft": ({}, 1e7),
}


@pytest.mark.parametrize(("changes", "foundation"), CASES.values(), ids=CASES.keys())
def test_bearing_and_ring_agree_in_a_few_steps(changes, foundation):
    model = paper_bearing(axial_modes=3, slices=10, **changes)
    matrix = ring(model.bearing.azimuths, 3.6e-3, foundation, 3)
    *_, last = model.iterate((None, matrix), model.solve())
    assert last.status is SolverOutcome.CONVERGED
    assert last.number <= 16  # 5 to 16
    assert last.deviation[1] == pytest.approx(np.tensordot(matrix, last.forces[1], 2), rel=1e-7, abs=1e-13)


def test_a_state_stays_where_other_equations_hold_it_as_well():
    """Half as soft a raceway of a shape that makes up for it: which rollers touch was searched anew."""
    model = paper_bearing(axial_modes=3, slices=10)
    matrix = ring(model.bearing.azimuths, 3.6e-3, 1e8, 3)
    *_, known = model.iterate((None, matrix), model.solve())
    shape = np.zeros((2, *known.forces.shape[1:]))
    shape[1] = np.tensordot(matrix / 2, known.forces[1], 2)
    first, *_, last = model.iterate((None, matrix / 2), known, shape)
    assert first.residual < 1e-9
    assert last.number <= 2
    assert last.loads == pytest.approx(known.loads, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("before", "after"), [(3, 4), (4, 3)])
def test_a_state_of_other_axial_modes_is_a_start(before, after):
    """As levels of accuracy differ by; the raceways are given a shape, too."""

    def solved(modes, start=None):
        model = paper_bearing(axial_modes=modes, slices=10)
        matrix, shape = ring(model.bearing.azimuths, 3.6e-3, 1e8, modes), np.zeros((2, 30, modes))
        shape[1, :, 1] = 1e-6
        *_, last = model.iterate((None, matrix), start or model.solve(), shape)
        return last

    assert solved(after, solved(before)).loads == pytest.approx(solved(after).loads, rel=1e-9, abs=1e-6)


@pytest.mark.slow
def test_slow_heavy_bearing_is_solved_though_not_in_a_few_steps():
    """At 10 rad/s it takes 350 evaluations; at 5 rad/s a few steps."""
    model = paper_bearing(axial_modes=3, slices=10, speed=10.0)
    matrix = ring(model.bearing.azimuths, 3.6e-3, 1e8, 3)
    *_, last = model.iterate((None, matrix), model.solve())
    assert last.status is SolverOutcome.CONVERGED
    assert last.deviation[1] == pytest.approx(np.tensordot(matrix, last.forces[1], 2), rel=1e-7, abs=1e-13)


@pytest.mark.parametrize("speed", [2.0, 5.0, 20.0])
def test_rollers_that_lie_on_the_inner_raceway_do_not_rock(speed):
    """A slow bearing: weight lays unloaded rollers on a wavy raceway, on one end and the other in turns."""
    model = paper_bearing(axial_modes=3, slices=10, speed=speed)
    matrix = ring(model.bearing.azimuths, 3.6e-3, 1e9, 3)
    *_, last = model.iterate((None, matrix), model.solve())
    assert last.status is SolverOutcome.CONVERGED
    assert last.number <= 14  # 7 to 12; it was 29 to 31


@pytest.mark.parametrize("speed", [1000 * RPM, 3000 * RPM], ids=["1000 rpm", "3000 rpm"])
@pytest.mark.parametrize("load", [3000.0, 10000.0])
def test_spins_are_held_while_contacts_are_searched(load, speed):
    """Traction at its limit has no slope: undamped steps sent spins to many times that of pure rolling."""
    model = paper_bearing(axial_modes=3, slices=10, load=load, speed=speed, traction="eyring")
    matrix = ring(model.bearing.azimuths, 2e-3, 1e9, 3)
    states = list(model.iterate((None, matrix), model.solve()))
    assert states[-1].status is SolverOutcome.CONVERGED
    assert states[-1].number <= 15  # 8 to 13; without it none in 45
    rolling = states[-1].balance.rolling_spin[0, 0]
    for before, after in pairwise(states):
        assert np.abs(after.roller_speed - before.roller_speed).max() <= (SPIN_CHANGE + 1e-12) * rolling


def test_cage_keeps_its_speed_while_contacts_are_searched():
    """The first steps look for contacts alone: rollers that become loaded turn like those that were."""
    model = paper_bearing(axial_modes=3, slices=10)
    matrix = ring(model.bearing.azimuths, 3.6e-3, 1e8, 3)
    start = model.solve()
    first, searched, *_ = model.iterate((None, matrix), start)
    assert (searched.loads[0] > 1.0).sum() > (first.loads[0] > 1.0).sum()
    assert searched.cage_speed == first.cage_speed == pytest.approx(start.cage_speed, rel=1e-12)
    loaded = searched.roller_speed[searched.loads[0] > 1e-3 * searched.loads[0].max()]
    assert loaded == pytest.approx(start.roller_speed[start.loads[0].argmax()], rel=1e-12)


def test_rollers_that_touch_at_their_ends_only_are_not_held_back():
    """A raceway that bulges inwards: mid-roller is off it, and no step may take that for no contact."""
    model = paper_bearing(axial_modes=3, slices=10)
    shape = np.zeros((2, 30, 3))
    shape[1, :, 2] = -20e-6
    found = model.solve(deviation=shape)
    approach = found.unknowns.approach[0]
    assert approach.min() < 0 < found.loads[1].min()
    assert found.number <= 15
