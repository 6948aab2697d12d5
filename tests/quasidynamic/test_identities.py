"""Identities that hold whatever the numbers are."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Crowned, NotSolved, SolverOutcome, solve_many
from quasidynamic.contact.traction import RollingShear
from quasidynamic.motion.roller_speeds import rolling_cage_speed, rolling_roller_speed
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
    "vortices in the land": {"cage": {"land_flow": "vortices"}},
    "churning": {"churning_gap": 0.5e-3},
    "load sideways": {"load_direction": 2.0},
    "misaligned": {"misalignment": 1e-3},
}


@pytest.fixture(params=CASES.values(), ids=CASES.keys())
def state(request):
    return paper_bearing(**request.param, spin_inertia=False).solve()


def torque_on_rollers_and_cage(state):
    """About the axis, where inner forces cancel, and the size of what causes the friction in it."""
    bearing = state.balance.roller.bearing
    torques = [
        bearing.inner_radius * (state.traction[0] + state.rolling_shear[0]).sum(),
        bearing.outer_radius * (state.traction[1] - state.rolling_shear[1]).sum(),
        -bearing.rollers * state.rollers.drag[0, 0] * bearing.pitch_diameter / 2,
        state.land_torque,
    ]
    return sum(torques), state.loads[1].sum() * bearing.outer_radius


def test_angular_momentum_of_rollers_and_cage_is_kept(state):
    torque, size = torque_on_rollers_and_cage(state)
    assert torque == approx(0.0, abs=1e-12 * size)


def test_power_put_in_is_the_power_lost(state):
    assert state.driving_power == approx(state.losses.total, rel=1e-10)
    assert state.losses.transport == 0.0


def test_power_is_lost_to_what_really_dissipates(state):
    losses = state.losses
    assert min(losses.sliding, losses.rolling, losses.drag, losses.pocket, losses.land, losses.churning) >= 0
    assert losses.sliding > 0


def test_rollers_hold_the_load_and_each_other(state):
    bearing, points = state.balance.roller.bearing, state.balance.points
    tangential = state.traction[0] + (1 - 2 * bearing.diameter_ratio) * state.rolling_shear[0]
    cos, sin = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
    load, size = state.loads[0], 1e-9 * state.balance.scales.force[0, 0]
    assert load @ cos - tangential @ sin == approx(points.load_z[0, 0], abs=size)
    assert load @ sin + tangential @ cos == approx(points.load_y[0, 0], abs=size)
    assert state.forces[0, :, 1] == approx(state.forces[1, :, 1], abs=size)


@pytest.mark.parametrize("changes", [{}, {"moment": 20.0}], ids=["aligned", "tilted"])
def test_load_turned_by_one_pitch_shifts_the_roller_loads(changes):
    here = paper_bearing(**changes).solve()
    turned = paper_bearing(**changes, azimuth=2 * np.pi / 30).solve()
    assert turned.loads[0] == approx(np.roll(here.loads[0], -1), rel=0, abs=1e-11)


def test_load_direction_turned_by_one_pitch_shifts_the_roller_loads():
    """Without weights, which keep their direction."""
    upright = {"gravity": 0.0}
    here, turned = (
        paper_bearing(**upright).solve(),
        paper_bearing(**upright, load_direction=2 * np.pi / 30).solve(),
    )
    assert turned.loads[0] == approx(np.roll(here.loads[0], 1), rel=0, abs=1e-9)
    assert turned.tangent.radial_stiffness == approx(here.tangent.radial_stiffness, rel=1e-9)


def test_nothing_slips_when_nothing_resists():
    """No inertia, no pocket friction, no drag, no rolling shear, no land."""

    def no_rolling_shear(load, *_):
        return RollingShear(*np.zeros((3, *load.shape)))

    bare = {"pocket_friction": 0.0, "guidance": "rollers", "thickness": 5e-3}
    state = paper_bearing(cage=bare, spin_inertia=False, rolling=no_rolling_shear).solve()
    assert state.cage_slip == approx(0.0, abs=1e-12)
    assert state.sliding == approx(np.zeros((2, 30)), abs=1e-9)


def test_slips_of_rollers_and_cage_are_the_sliding(state):
    """What a roller lacks in spin and the cage in speed, the raceways slide over its surface."""
    bearing, operation = state.balance.roller.bearing, state.balance.points
    speeds = operation.inner_speed.item(), operation.outer_speed.item()
    ratio, roller = bearing.diameter_ratio, bearing.roller.diameter / 2
    by_spin = state.roller_slip * rolling_roller_speed(*speeds, ratio) * roller
    by_cage = state.cage_slip * rolling_cage_speed(*speeds, ratio) * bearing.pitch_diameter / 2
    expected = (1 - ratio) * by_cage + by_spin, (1 + ratio) * by_cage - by_spin
    assert state.sliding == approx(np.array(expected), rel=1e-9, abs=1e-9)
    spin = (1 - state.roller_slip) * rolling_roller_speed(*speeds, ratio)
    assert state.roller_speed == approx(spin, rel=1e-12)


def test_turning_the_other_way_mirrors_everything():
    forwards, backwards = paper_bearing().solve(), paper_bearing(speed=-38000 * RPM).solve()
    assert backwards.loads[0, 1:] == approx(forwards.loads[0, :0:-1], abs=1e-7)
    assert backwards.cage_speed == approx(-forwards.cage_speed, rel=1e-12)
    assert backwards.driving_torque == approx(-forwards.driving_torque, rel=1e-9)


FILM_FREE = 3529.05  # [N] largest load without centrifugal force and film


def test_slow_bearing_is_a_static_one():
    """As the speed falls, the loads tend to those without centrifugal force and film."""
    loads = [paper_bearing(speed=n * RPM).solve().loads[0].max() for n in (100.0, 10.0, 1.0)]
    # each step of ten in speed brings the film, ~ speed^0.7, closer to nothing
    assert abs(loads[2] - loads[1]) < abs(loads[1] - loads[0])
    assert loads[2] == approx(FILM_FREE, rel=1e-4)


@pytest.mark.slow
def test_both_rings_turning_together_leave_the_loads_of_their_difference_at_rest():
    """Seen from the cage only the speed difference matters, but for centrifugal force and drag."""
    still = paper_bearing(speed=100 * RPM, oil_fraction=0.0).solve()
    turning = paper_bearing(speed=150 * RPM, outer_speed=50 * RPM, oil_fraction=0.0).solve()
    assert turning.loads[0] == approx(still.loads[0], abs=0.05)
    relative = turning.cage_speed - 50 * RPM
    assert relative == approx(still.cage_speed, rel=1e-4)


def free_between_even_raceways(**changes):
    """A ring free to tilt, and rollers that are not taken as aligned."""
    bearing = paper_bearing(free_tilt=True, **changes)
    return bearing.solve(deviation=np.zeros((2, bearing.bearing.rollers, bearing.axial_modes)))


def test_ring_free_to_tilt_under_no_moment_is_solved_as_an_aligned_one():
    held, free = paper_bearing(), paper_bearing(free_tilt=True)
    assert (free.solve().scaled == held.solve().scaled).all()


def test_one_half_of_an_aligned_roller_stands_for_both():
    """A ring that is held straight or only just free to tilt: two ways to compute the same bearing."""
    half, whole = paper_bearing().solve(), free_between_even_raceways()
    assert (half.balance.roller.axial_modes, whole.balance.roller.axial_modes) == (1, 2)
    assert half.loads == approx(whole.loads, rel=1e-9, abs=1e-7)
    assert half.slice_loads == approx(whole.slice_loads, rel=1e-9, abs=1e-4)
    assert half.cage_slip == approx(whole.cage_slip, rel=1e-9)


def test_odd_number_of_slices_is_halved_too():
    half = paper_bearing(slices=21).solve()
    whole = free_between_even_raceways(slices=21)
    assert half.slice_loads.shape == (2, 30, 21)
    assert half.loads == approx(whole.loads, rel=1e-9, abs=1e-7)


STEP = 0.03  # [N]
STIFFNESS_CASES = {
    "paper": {},
    "eyring": {"traction": "eyring"},
    "tilted": {"moment": 20.0},
    "load sideways": {"load_direction": 2.0, "clearance": 20e-6},
}


@pytest.mark.parametrize("changes", STIFFNESS_CASES.values(), ids=STIFFNESS_CASES.keys())
def test_compliance_is_the_slope_of_displacement_over_load(changes):
    """Loads changed either way, ring free to tilt: films, cage and rollers follow.

    The step stays below the half newton over which pocket forces change side.
    """
    here = paper_bearing(**changes, free_tilt=True)
    whole = here.solve().tangent.compliance
    load, angle = here.operation.radial_load, here.operation.load_direction
    place = np.array([load * np.sin(angle), load * np.cos(angle)])
    # A moment lies in the plane of the load: turning the load would turn it too.
    for column, along in ((1, np.array([1.0, 0.0])), (2, np.array([0.0, 1.0])))["moment" in changes :]:
        places = []
        for step in (STEP, -STEP):
            y, z = place + step * along
            operation = replace(here.operation, radial_load=np.hypot(y, z), load_direction=np.arctan2(y, z))
            state = replace(here, operation=operation).solve()
            places.append(np.concatenate([state.ring_displacement, state.ring_tilt * [-1.0, 1.0]]))
        slope = (places[0] - places[1]) / (2 * STEP)
        scale = np.abs(whole[1:, column])
        assert whole[1:, column] == approx(slope, rel=1e-6, abs=1e-6 * max(scale[:2]))


def test_tilting_compliance_is_the_slope_of_tilt_over_moment():
    here = paper_bearing(moment=20.0)
    slope = np.subtract(
        *(
            replace(here, operation=replace(here.operation, moment=20.0 + d)).solve().ring_tilt
            for d in (1e-3, -1e-3)
        )
    )
    assert here.solve().tangent.compliance[3, 3] == approx(slope[0] / 2e-3, rel=1e-6)


def test_stiffness_is_the_inverse_of_compliance_and_nothing_holds_the_ring_axially():
    state = paper_bearing().solve()
    assert state.tangent.stiffness[1:, 1:] @ state.tangent.compliance[1:, 1:] == approx(np.eye(4), abs=1e-9)
    assert not state.tangent.stiffness[0].any()
    assert np.isinf(state.tangent.compliance[0, 0])


@pytest.mark.slow
def test_many_operating_points_are_those_of_one_after_the_other():
    bearing = paper_bearing()
    points = [
        replace(bearing.operation, radial_load=load, inner_speed=speed * RPM)
        for load in (50.0, 1000.0, 2e4)
        for speed in (100.0, 8000.0, 38000.0)
    ]
    models = [replace(bearing, operation=point) for point in points]
    many = solve_many(models)
    assert many.unsolved == ()
    for model, state in zip(models, many, strict=True):
        alone = model.solve()
        assert state.loads == approx(alone.loads, rel=1e-9, abs=1e-9 * alone.loads.max())
        assert state.cage_slip == approx(alone.cage_slip, rel=1e-9, abs=1e-12)


def test_nothing_holds_a_ring_without_load():
    idle = paper_bearing(load=0.0)
    with pytest.raises(NotSolved, match="undetermined") as failure:
        idle.solve()
    assert failure.value.outcome == SolverOutcome.UNDETERMINED
    assert solve_many([idle])[0].status == SolverOutcome.UNDETERMINED
