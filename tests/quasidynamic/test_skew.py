"""Rollers that skew between guide flanges: symmetry, balances, limits."""

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic import ImpossiblePart, NotSolved
from quasidynamic.balance.rollers.skew import RunningRollers, SkewBalance
from quasidynamic.contact.flange import (
    corner_couple,
    corner_sliding,
    flange_corner,
    flange_forces,
    flange_push,
    touching_skew,
)
from quasidynamic.outcome.skew import skewed
from quasidynamic.parts.roller_bearing import Flange
from tests.bearings import paper_bearing

FLANGE = Flange(
    ring="inner", clearance=20e-6, height=1.2e-3, roller_chamfer=0.3e-3, stiffness=1e8, friction=0.08
)
EYRING = {"traction": "eyring", "load": 8e3, "speed": 1000.0}


@cache
def equilibrium(tilt=0.0, **changes):
    return paper_bearing(**EYRING, misalignment=tilt, **changes).solve()


def running(state, ring="inner"):
    points = state.balance.points
    speed = points.inner_speed if ring == "inner" else points.outer_speed
    return RunningRollers(
        slice_load=state.rollers.contact.slice_load[:, 0],
        sliding=state.sliding,
        entrainment=state.entrainment,
        film=state.film,
        rolling_shear=state.rolling_shear,
        spin=state.roller_speed,
        ring_speed=float(speed[0, 0]) - state.cage_speed,
    )


def skew(state, flange=FLANGE, **changes):
    roller = state.balance.roller
    return skewed(running(state, flange.ring)._replace(**changes), roller.raceways, roller.bearing, flange)


def test_aligned_rollers_do_not_skew():
    found = skew(equilibrium())
    assert np.all(found.angle == 0.0)
    assert np.all(found.flange_forces == 0.0)
    assert found.flange_power.sum() == found.axial_sliding_power.sum() == 0.0
    assert found.end_gap == found.load_shift == found.traction_change == 0.0


def test_rollers_that_can_tilt_but_do_not_barely_skew():
    bearing = paper_bearing(**EYRING, free_tilt=True)
    found = skew(bearing.solve(deviation=np.zeros((2, bearing.bearing.rollers, bearing.axial_modes))))
    assert np.abs(found.moments.traction).max() < 1e-12
    assert np.abs(found.angle).max() < 1e-8


def test_skew_is_odd_in_the_tilt():
    one, other = (skew(equilibrium(tilt)) for tilt in (8e-4, -8e-4))
    largest = np.abs(one.angle).max()
    assert largest > 1e-4
    assert other.angle == approx(-one.angle, rel=1e-6, abs=1e-7 * largest)
    assert other.flange_forces == approx(one.flange_forces[::-1], rel=1e-6, abs=1e-8)


@settings(max_examples=25)
@given(
    tilt=st.sampled_from([-8e-4, 2e-4, 8e-4]),
    ring=st.sampled_from(["inner", "outer"]),
    clearance=st.floats(1e-7, 2e-4),
    stiffness=st.floats(4, 11).map(lambda power: 10.0**power),
    friction=st.floats(0.0, 0.3),
    height=st.floats(0.5e-3, 2.4e-3),
)
def test_moments_and_axial_forces_of_every_roller_balance(tilt, ring, clearance, stiffness, friction, height):
    flange = replace(
        FLANGE, ring=ring, clearance=clearance, stiffness=stiffness, friction=friction, height=height
    )
    found = skew(equilibrium(tilt), flange)
    moments = found.moments
    scale = np.abs(np.array(moments)).max(axis=0)
    assert np.all(np.abs(moments.unbalanced) <= 1e-10 * scale)
    assert np.all(moments.traction * found.angle >= 0.0)
    minus, plus = found.flange_forces
    assert np.all(found.flange_forces >= 0.0)
    thrust = found.axial_traction.thrust
    assert plus - minus == approx(thrust, rel=1e-12, abs=1e-12 * np.abs(found.flange_forces).max())
    # corners that touch yield in proportion to their forces
    beyond = flange.stiffness * 2 * found.balance.corner.lever * found.beyond
    held = (minus > 0) & (plus > 0)
    assert (minus + plus)[held] == approx(beyond[held], rel=1e-12)


@pytest.mark.parametrize("tilt", [0.0, 8e-4])
def test_forces_of_the_slices_are_those_that_pocket_drag_and_weight_balance(tilt):
    state = equilibrium(tilt)
    balance, widths = skew(state).balance, state.balance.roller.raceways.slices.widths
    drag, weight = state.rollers.drag[0], state.rollers.weight[1, 0]
    whole = balance.forces_along @ widths
    assert whole == approx(
        drag - weight - state.cage_force, rel=1e-9, abs=1e-9 * np.abs(state.cage_force).max()
    )


@given(thrust=st.floats(-1e3, 1e3), stiffness=st.floats(4, 11).map(lambda power: 10.0**power))
def test_restoring_couple_rises_with_the_skew(thrust, stiffness):
    flange = replace(FLANGE, stiffness=stiffness)
    at = flange_corner(flange, paper_bearing().bearing)
    touching = touching_skew(flange, at.lever)
    angle = np.linspace(0.0, 2 * touching, 201)
    couple = corner_couple(angle, angle - touching, np.array(thrust), flange, at.lever)
    assert couple[0] == 0.0
    assert np.all(np.diff(couple) >= 0.0)
    held = couple > at.lever * abs(thrust) * (1 + 1e-12)
    assert couple[held] == approx(2 * stiffness * at.lever**2 * (angle - touching)[held], rel=1e-9)


def test_more_clearance_is_more_skew():
    state = equilibrium(8e-4)
    angles = [np.abs(skew(state, replace(FLANGE, clearance=c)).angle) for c in np.geomspace(1e-8, 1e-4, 9)]
    assert np.all(np.diff(angles, axis=0) >= -1e-10 * np.array(angles[:-1]))
    assert angles[-1].max() > 10 * angles[0].max()


def test_raceway_stiffness_is_the_work_of_crossing_cylinders():
    state = equilibrium(8e-4)
    roller, run = state.balance.roller, running(state)
    balance = SkewBalance(running=run, raceways=roller.raceways, bearing=roller.bearing, flange=FLANGE)
    slices, pitch, step = roller.raceways.slices, roller.bearing.pitch_diameter / 2, 1e-2
    # distance of a skewed roller's axis from that of the bearing, exactly
    rise = np.sqrt(pitch**2 + (slices.centres * np.sin(step)) ** 2) - pitch
    inner, outer = run.slice_load
    work = ((outer - inner) * slices.widths) @ rise
    assert balance.raceway_stiffness == approx(2 * work / step**2, rel=1e-4)
    only_outside = inner.max(axis=-1) < 1.0
    assert only_outside.any()
    assert np.all(balance.raceway_stiffness[only_outside] > 0.0)  # centrifugal force presses outwards


def test_axial_traction_opposes_sideways_sliding_and_grows_like_its_derivative():
    state = equilibrium(8e-4)
    roller = state.balance.roller
    balance = SkewBalance(
        running=running(state), raceways=roller.raceways, bearing=roller.bearing, flange=FLANGE
    )
    angle = np.full(30, 3e-4)
    here, up, down = (balance.axial_traction(angle + change) for change in (0.0, 1e-8, -1e-8))
    assert np.all(here.force[0] >= 0.0)
    assert np.all(here.force[1] <= 0.0)
    difference = (up.force - down.force) / 2e-8
    assert here.by_skew == approx(difference, rel=1e-4, abs=1e-6 * np.abs(difference).max())
    assert balance.axial_traction(-angle).force == approx(-here.force, rel=1e-14)


def test_traction_of_a_slice_points_along_its_sliding():
    state = equilibrium(8e-4)
    roller, run = state.balance.roller, running(state)
    balance = SkewBalance(running=run, raceways=roller.raceways, bearing=roller.bearing, flange=FLANGE)
    angle = np.full(30, 2e-4)
    along, across = balance.traction_along(angle), balance.axial_traction(angle).force
    sliding = np.array([1.0, -1.0])[:, None] * run.spin * roller.bearing.roller.diameter / 2 * angle
    assert along * sliding == approx(across * run.sliding, rel=1e-12, abs=1e-15)
    assert balance.traction_along(0 * angle) == approx(state.traction, rel=1e-12, abs=1e-18)


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_flange_heat_is_the_power_that_ring_and_roller_leave_there(ring):
    flange = replace(FLANGE, ring=ring)
    state = equilibrium(8e-4)
    run, found = running(state, ring), skew(state, flange)
    bearing, at = state.balance.roller.bearing, found.balance.corner
    pitch = bearing.pitch_diameter / 2
    along, radial = corner_sliding(at, run.spin, run.ring_speed, pitch)
    force = flange.friction * found.flange_forces.sum(axis=0)
    f_t, f_n = force * along / np.hypot(along, radial), force * radial / np.hypot(along, radial)
    by_ring = run.ring_speed * (f_t * (pitch + at.level) - f_n * at.lever)
    to_roller = run.spin * (f_n * at.lever - f_t * at.level)
    assert found.flange_power == approx(by_ring - to_roller, rel=1e-10)
    assert found.flange_power.max() > 0.0


def test_heat_of_sideways_sliding_is_taken_from_the_spin():
    state = equilibrium(8e-4)
    found, radius = skew(state), state.balance.roller.bearing.roller.diameter / 2
    inner, outer = found.axial_traction.force
    brake = radius * found.angle * (inner - outer)  # axial forces about an axis turned by the skew
    assert found.axial_sliding_power == approx(brake * state.roller_speed, rel=1e-12)
    assert np.all(found.axial_sliding_power >= 0.0)


def test_stiff_flanges_hold_the_roller_at_the_touching_skew():
    state = equilibrium(8e-4)
    beyond = []
    for stiffness in (1e8, 1e9, 1e10):
        found = skew(state, replace(FLANGE, clearance=1e-9, stiffness=stiffness))
        held = (found.flange_forces > 0).all(axis=0)
        assert held.any()
        beyond.append(np.abs(found.beyond[held]).max())
    assert beyond[1] / beyond[0] == approx(0.1, rel=0.05)
    assert beyond[2] / beyond[1] == approx(0.1, rel=0.05)


@given(
    lever=st.floats(1e-4, 1e-1),
    clearance=st.floats(1e-7, 1e-3),
    beyond=st.floats(-1e-2, 1e-2),
    thrust=st.floats(-1e4, 1e4),
)
def test_flanges_carry_the_thrust_and_never_pull(lever, clearance, beyond, thrust):
    flange = replace(FLANGE, clearance=clearance)
    push = flange_push(np.array(beyond), np.array(thrust), flange, lever)
    minus, plus = flange_forces(push, np.array(thrust))
    assert minus >= 0.0
    assert plus >= 0.0
    assert plus - minus == approx(thrust, rel=1e-12, abs=1e-12 * push)
    assert touching_skew(flange, lever) * 2 * lever == approx(clearance, rel=1e-12)


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_corner_lies_on_the_rim_and_on_the_edge_of_the_flange(ring):
    bearing = paper_bearing().bearing
    flange = replace(FLANGE, ring=ring)
    lever, level = flange_corner(flange, bearing)
    assert np.hypot(lever, level) == approx(bearing.roller.diameter / 2 - flange.roller_chamfer, rel=1e-12)
    edge = np.hypot(lever, bearing.pitch_diameter / 2 + level)
    radius = bearing.inner_radius + flange.height if ring == "inner" else bearing.outer_radius - flange.height
    assert edge == approx(radius, rel=1e-12)


def test_pure_rolling_slides_at_the_raceway_not_at_all_and_at_the_corner_by_its_height():
    at = flange_corner(FLANGE, paper_bearing().bearing)
    spin, pitch, radius = 700.0, 35e-3, 2.5e-3
    ring = spin * radius / (pitch - radius)
    along, radial = corner_sliding(at, np.array(spin), ring, pitch)
    # the flange turns about the contact line, at the sum of both speeds
    assert along == approx((ring + spin) * (at.level + radius), rel=1e-12)
    assert radial == approx(-(ring + spin) * at.lever, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"height": 0.2e-3}, "chamfer"),
        ({"clearance": 0.0}, "clearance"),
        ({"stiffness": -1.0}, "stiffness"),
        ({"friction": -0.1}, "friction"),
    ],
)
def test_impossible_flange_is_named(change, words):
    with pytest.raises(ImpossiblePart, match=words):
        replace(FLANGE, **change)


def test_flange_that_reaches_the_middle_of_the_roller_is_refused():
    with pytest.raises(ImpossiblePart, match="half a roller diameter"):
        flange_corner(replace(FLANGE, height=2.5e-3), paper_bearing().bearing)


def test_roller_that_nothing_holds_is_no_result():
    state = equilibrium(8e-4)
    soft = replace(FLANGE, stiffness=1e-6, clearance=2e-6, friction=0.0)
    loads = running(state).slice_load
    heavy_inside = loads * np.array([2.0, 1.0])[:, None, None]  # inner loads unbalanced: unstable
    with pytest.raises(NotSolved, match="nothing holds"):
        skew(state, soft, slice_load=heavy_inside)


def test_not_finite_state_is_no_result():
    state = equilibrium(8e-4)
    with pytest.raises(NotSolved, match="not finite"):
        skew(state, film=np.full((2, 30), np.nan), spin=np.full(30, np.nan))


def test_end_gap_is_that_of_crossing_cylinders():
    found = skew(equilibrium(8e-4))
    length, pitch = 5e-3, 35e-3
    largest = np.abs(found.angle).max()
    assert found.end_gap == approx(np.hypot(pitch, length / 2 * largest) - pitch, rel=1e-4)
    assert largest < pi / 2


def test_load_shift_balances_the_axial_forces_about_the_motion():
    """Axial forces at the raceways and the corner, with their levers, against the shifted load."""
    state = equilibrium(8e-4)
    found = skew(state)
    radius, level = state.balance.roller.bearing.roller.diameter / 2, found.balance.corner.level
    assert abs(level) > 0.1 * radius
    inner, outer = found.axial_traction.force
    levers = np.array([-radius, radius, level])[:, None]  # outwards from the middle of the roller
    moment = (levers * np.array([inner, outer, -(inner + outer)])).sum(axis=0)
    loaded = state.loads[0] > 0.01 * state.loads[0].max()
    assert found.load_shift == approx(np.abs(moment / state.loads[0])[loaded].max(), rel=1e-9)
