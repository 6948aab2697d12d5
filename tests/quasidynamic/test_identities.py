"""Identities that hold whatever the numbers are."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Crowned
from quasidynamic.contact.drag import land_drag
from quasidynamic.contact.rolling import RollingShear
from tests.bearings import RPM, paper_bearing

CASES = {
    "paper": {},
    "eyring": {"traction": "eyring"},
    "preloaded": {"clearance": -40e-6, "load": 1000.0},
    "tilted": {"moment": 20.0},
    "crowned": {"profile": Crowned(straight_length=3e-3, crown_radius=0.5)},
    "light": {"load": 200.0},
    "both rings turn": {"outer_speed": 5000 * RPM},
    "backwards": {"speed": -38000 * RPM},
    "inner guided": {"cage": {"guidance": "inner", "land_diameter": 65.4e-3}},
}


@pytest.fixture(params=CASES.values(), ids=CASES.keys())
def state(request):
    return paper_bearing(**request.param, spin_inertia=False).solve()


def forces(state):
    """Traction and rolling shear at inner and outer raceway, signed along the motion [N]."""
    s = state.balance.roller.operation.direction
    inner, outer = state.rollers.inner, state.rollers.outer
    return inner.traction, outer.traction, s * inner.rolling.force, s * outer.rolling.force


def land_torque(state):
    operation, cage = state.balance.roller.operation, state.balance.roller.bearing.cage
    ring = operation.outer_speed if cage.guidance == "outer" else operation.inner_speed
    return land_drag(cage, state.balance.roller.inner.oil) * (ring - state.cage_speed)


def test_angular_momentum_of_rollers_and_cage_is_kept(state):
    bearing = state.balance.roller.bearing
    t_i, t_o, r_i, r_o = forces(state)
    torques = [
        bearing.inner_radius * (t_i + r_i).sum(),
        bearing.outer_radius * (t_o - r_o).sum(),
        -bearing.rollers * state.rollers.drag * bearing.pitch_diameter / 2,
        land_torque(state),
    ]
    # What the solver left over, measured against the loads that cause the friction.
    assert sum(torques) == approx(0.0, abs=1e-12 * state.forces[1, :, 0].sum() * bearing.outer_radius)


def test_power_put_in_is_the_power_lost(state):
    bearing, operation = state.balance.roller.bearing, state.balance.roller.operation
    t_i, t_o, r_i, r_o = forces(state)
    t = np.array([t_i, t_o])
    shear = np.array([r_i, r_o]) * operation.direction
    pocket = np.abs(state.rollers.cage_force)
    pocket = bearing.cage.pocket_friction * (np.hypot(pocket, 0.5) - 0.5)
    land_ring = operation.outer_speed if bearing.cage.guidance == "outer" else operation.inner_speed
    lost = [
        (t * state.rollers.sliding).sum(),
        (2 * shear * state.rollers.entrainment).sum(),
        bearing.rollers * state.rollers.drag * state.cage_speed * bearing.pitch_diameter / 2,
        (pocket * bearing.roller.diameter / 2 * np.abs(state.roller_speed)).sum(),
        land_torque(state) * (land_ring - state.cage_speed),
    ]
    inner = operation.inner_speed * bearing.inner_radius * (t_i + r_i).sum()
    outer = operation.outer_speed * bearing.outer_radius * (t_o - r_o).sum()
    land = land_torque(state) * land_ring
    assert inner + outer + land == approx(sum(lost), rel=1e-10)


def test_rollers_hold_the_load_and_each_other(state):
    operation, bearing = state.balance.roller.operation, state.balance.roller.bearing
    t_i, _, r_i, _ = forces(state)
    tangential = t_i + (1 - 2 * bearing.diameter_ratio) * r_i
    cos, sin = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
    load = state.forces[0, :, 0]
    assert load @ cos - tangential @ sin == approx(operation.radial_load, rel=1e-9)
    assert load @ sin + tangential @ cos == approx(0.0, abs=1e-9 * state.balance.reference_force)
    assert state.forces[0, :, 1] == approx(state.forces[1, :, 1], abs=1e-9 * state.balance.reference_force)


@pytest.mark.parametrize("changes", [{}, {"moment": 20.0}], ids=["aligned", "tilted"])
def test_load_turned_by_one_pitch_shifts_the_roller_loads(changes):
    here = paper_bearing(**changes).solve()
    turned = paper_bearing(**changes, azimuth=2 * np.pi / 30).solve()
    assert turned.forces[0, :, 0] == approx(np.roll(here.forces[0, :, 0], -1), rel=0, abs=1e-11)


def test_nothing_slips_when_nothing_resists(monkeypatch):
    """No inertia, no pocket friction, no drag, no rolling shear, no land."""

    def no_rolling_shear(load, *_):
        return RollingShear(*np.zeros((3, len(load))))

    monkeypatch.setattr("quasidynamic.contact.raceway.biboulet_houpert", no_rolling_shear)
    bare = {"pocket_friction": 0.0, "guidance": "rollers", "thickness": 5e-3}
    state = paper_bearing(cage=bare, spin_inertia=False).solve()
    assert state.cage_slip == approx(0.0, abs=1e-12)
    assert state.rollers.sliding == approx(np.zeros((2, 30)), abs=1e-9)


def test_turning_the_other_way_mirrors_everything():
    forwards, backwards = paper_bearing().solve(), paper_bearing(speed=-38000 * RPM).solve()
    assert backwards.forces[0, 1:, 0] == approx(forwards.forces[0, :0:-1, 0], abs=1e-7)
    assert backwards.cage_speed == approx(-forwards.cage_speed, rel=1e-12)
    assert backwards.driving_torque == approx(-forwards.driving_torque, rel=1e-9)


def test_slow_bearing_is_a_static_one():
    """As the speed falls, the loads tend to those without centrifugal force and film."""
    loads = [paper_bearing(speed=n * RPM).solve().forces[0, :, 0].max() for n in (100.0, 10.0, 1.0)]
    film_free = 3529.05  # each step of ten in speed brings the film, ~ speed^0.7, closer to nothing
    assert abs(loads[2] - loads[1]) < abs(loads[1] - loads[0])
    assert loads[2] == approx(film_free, rel=1e-4)


def test_both_rings_turning_together_leave_the_loads_of_their_difference_at_rest():
    """Seen from the cage only the speed difference matters, but for centrifugal force and drag."""
    still = paper_bearing(speed=100 * RPM, oil_fraction=0.0).solve()
    turning = paper_bearing(speed=150 * RPM, outer_speed=50 * RPM, oil_fraction=0.0).solve()
    assert turning.forces[0, :, 0] == approx(still.forces[0, :, 0], abs=0.05)
    relative = turning.cage_speed - 50 * RPM
    assert relative == approx(still.cage_speed, rel=1e-4)


def test_stiffness_is_the_slope_of_load_over_displacement():
    here = paper_bearing()
    state = here.solve()
    step = 1.0
    more, less = (
        replace(here, operation=replace(here.operation, radial_load=here.operation.radial_load + d)).solve()
        for d in (step, -step)
    )
    slope = 2 * step / (more.ring_displacement[1] - less.ring_displacement[1])
    # The tangent holds the film, which thins under load and gives 1e-3 of the displacement.
    assert state.stiffness == approx(slope, rel=2e-3)
