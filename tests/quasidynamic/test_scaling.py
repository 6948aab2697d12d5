"""No force or length of the model is absolute: a bearing of another size is the same bearing."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic import FourPointCurve, Logarithmic, RollerBearing, SolverOutcome, solve_many
from quasidynamic.contact.line import SMALLEST_LOAD
from quasidynamic.outcome.life import slice_life, turning_share
from quasidynamic.static import static_loads
from tests.bearings import RPM, paper_bearing

CURVE = FourPointCurve.through(at_rest=0.0, peak=0.05, peak_slip=0.02, far=0.03)
PROFILE = Logarithmic(amplitude=1.75e-6)
CASES = {
    "heavy": {},
    "light": {"load": 20.0},
    "slow": {"speed": 5.0},
    "tilted": {"moment": 20.0},
    "free cage": {"cage": {"free": True, "unbalance": 20e-6}},
    "churning": {"churning_gap": 0.5e-3},
    "curve": {"traction": lambda **pair: CURVE},
}


def scaled(model: RollerBearing, size: float) -> RollerBearing:
    """Lengths times size at the same stresses, speeds of surfaces, temperatures and Reynolds numbers."""
    bearing, operation, lubrication = model.bearing, model.operation, model.lubrication
    cage = bearing.cage
    lengths = ("thickness", "land_diameter", "land_width", "land_clearance", "unbalance")
    cage = replace(cage, mass=cage.mass * size**3, **{n: getattr(cage, n) * size for n in lengths})
    roller = bearing.roller
    roller = replace(
        roller,
        diameter=roller.diameter * size,
        length=roller.length * size,
        profile=Logarithmic(amplitude=PROFILE.amplitude * size),
    )
    oil = lubrication.oil
    gap = lubrication.churning_gap
    return replace(
        model,
        bearing=replace(
            bearing,
            outer_raceway_diameter=bearing.outer_raceway_diameter * size,
            clearance=bearing.clearance * size,
            roller=roller,
            cage=cage,
        ),
        operation=replace(
            operation,
            radial_load=operation.radial_load * size**2,
            moment=operation.moment * size**3,
            inner_speed=operation.inner_speed / size,
            gravity=operation.gravity / size,
        ),
        lubrication=replace(
            lubrication,
            oil=replace(oil, viscosity=oil.viscosity * size, conductivity=oil.conductivity * size),
            churning_gap=gap and gap * size,
        ),
    )


@pytest.mark.parametrize("size", [0.01, 20.0], ids=["a hundredth", "twenty times"])
@pytest.mark.parametrize("changes", CASES.values(), ids=CASES.keys())
def test_bearing_of_another_size_gives_the_same_answer(changes, size):
    model = paper_bearing(profile=PROFILE, **changes)
    here, there = model.solve(), scaled(model, size).solve()
    largest = here.loads.max()
    assert there.number == here.number
    assert there.loads / size**2 == approx(here.loads, rel=0, abs=1e-9 * largest)
    assert there.film / size == approx(here.film, rel=1e-6)
    assert there.cage_force / size**2 == approx(here.cage_force, rel=0, abs=1e-9 * largest)
    assert there.cage_slip == approx(here.cage_slip, rel=1e-7, abs=1e-12)
    assert there.losses.total / size**2 == approx(here.losses.total, rel=1e-7)
    assert there.minimum_film / size == approx(here.minimum_film, rel=1e-6)


def test_film_of_a_light_contact_is_that_of_its_formula():
    """Dowson's h ~ Q^-0.13 down to half a newton on a roller of 5 mm: it was 0.58 of that."""
    raceways = paper_bearing().solve().balance.roller.raceways
    load, still, speed = np.full((2, 1, 1), 0.5), np.zeros((2, 1, 1)), np.full((2, 1, 1), 20.0)
    heavy = raceways.film(1e4 * load, still, speed).thickness
    assert raceways.film(load, still, speed).thickness == approx(heavy * 1e4**0.13, rel=0.02)


def test_bearing_of_one_newton_has_loaded_rollers_as_its_static_load_distribution():
    """Nothing but the load: slow, without weights; films are thin beside the approaches of 3 nm."""
    model = paper_bearing(load=1.0, clearance=0.0, speed=1e-9 * RPM, gravity=0.0)
    state = model.solve()
    static = static_loads(model.bearing, 1.0, slices=model.slices)
    assert state.loads[0] == approx(static.loads, rel=0, abs=0.02 * static.loads.max())
    assert state.loaded[0].sum() > 5


def test_pocket_friction_of_a_light_bearing_is_that_of_coulomb():
    """mu |F_c| for forces of millinewtons: they were lost in a rounding of half a newton."""
    state = paper_bearing(load=20.0, speed=1000 * RPM).solve()
    brake, force = np.abs(state.rollers.pocket_brake[0]), np.abs(state.cage_force)
    felt = force > 2e-3
    assert felt.sum() > 10
    assert force.max() < 1.0
    still = 1e-3 * np.abs(state.balance.rolling_spin[0, 0])
    sense = np.abs(state.roller_speed) / np.hypot(state.roller_speed, still)
    assert brake[felt] == approx(0.05 * (sense * force)[felt], rel=0.02)


def test_smallest_load_is_a_pressure_below_any_of_interest():
    """28 MPa between steel: p0 = sqrt(q E'/(2 pi R)) with q/(E' R) = 1e-7."""
    assert 2.2e11 * np.sqrt(SMALLEST_LOAD / (2 * np.pi)) == approx(27.8e6, rel=0.01)


# -- weights -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("direction", [0.0, 1.0, np.pi])
def test_both_rings_and_the_cage_carry_the_weight_of_all_rollers(direction):
    """One vector: with the load, all that acts on rollers from rings and pockets is minus their weight."""
    model = paper_bearing(load=50.0, speed=20 * RPM)
    model = replace(model, operation=replace(model.operation, gravity_direction=direction))
    state = model.solve()
    bearing, g = model.bearing, model.bearing.diameter_ratio
    sin, cos = np.sin(bearing.azimuths), np.cos(bearing.azimuths)
    radial = state.loads[0] - state.loads[1] + state.rollers.pocket[1, 0]
    shear = (1 - 2 * g) * state.rolling_shear[0] - (1 + 2 * g) * state.rolling_shear[1]
    along = state.traction.sum(0) + shear - state.rollers.drag[0] + state.cage_force
    outward = state.rollers.centrifugal[0]
    force = [(outward + radial) @ sin + along @ cos, (outward + radial) @ cos - along @ sin]
    weight = 9.81 * bearing.rollers * bearing.roller.mass
    assert force == approx([-weight * np.sin(direction), -weight * np.cos(direction)], abs=1e-9 * 50.0)


def test_rollers_above_a_slow_inner_ring_rest_on_it():
    state = paper_bearing(load=50.0, speed=20 * RPM).solve()
    above = np.cos(state.balance.roller.bearing.azimuths) < -0.3
    weight = 9.81 * state.balance.roller.bearing.roller.mass
    assert (state.loads[1, above] < 1e-3 * weight).all()
    assert (state.loads[0, above] > 0.2 * weight).all()


def test_weights_lean_on_the_pockets_and_turn_no_cage():
    """Rollers beside the axis hang in their pockets; around the bearing these moments cancel."""
    state = paper_bearing(load=50.0, speed=20 * RPM).solve()
    _, along = state.rollers.weight[:, 0]
    assert along.sum() == approx(0.0, abs=1e-12)
    side = int(np.abs(along).argmax())
    assert state.cage_force[side] == approx(-along[side], rel=0.1)


def test_upright_shaft_has_no_weights():
    state = paper_bearing(gravity=0.0).solve()
    assert not state.rollers.weight.any()


# -- churning ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("outer", [-60000.0, 0.0, 37000.0], ids=["against", "at rest", "with"])
def test_churning_brakes_the_spin_and_is_felt_by_the_cage(outer):
    """Torque times its own speed: the walls around a roller turn with the cage."""
    still = {"spin_inertia": False, "outer_speed": outer * RPM, "churning_gap": 0.5e-3}
    state = paper_bearing(**still).solve()
    torque = state.rollers.churning[0]
    assert (torque * state.roller_speed > 0).all()
    assert state.losses.churning == approx(float(torque @ state.roller_speed), rel=1e-12)
    assert state.losses.total == approx(state.driving_power, rel=1e-9)
    bearing, force, brake = state.balance.roller.bearing, state.cage_force, state.rollers.pocket_brake[0]
    friction = bearing.pitch_diameter / 2 * force.sum() + bearing.roller.diameter / 2 * brake.sum()
    assert state.land_torque - friction == approx(torque.sum(), rel=1e-7)


# -- a free cage without load ------------------------------------------------------------------------


@pytest.mark.parametrize("gravity", [0.0, 9.81], ids=["upright", "horizontal"])
@pytest.mark.parametrize("guidance", ["outer", "inner"])
@pytest.mark.parametrize("changes", [{"clearance": -40e-6}, {"moment": 20.0}], ids=["preload", "moment"])
def test_free_cage_without_radial_load_has_an_equilibrium(guidance, gravity, changes):
    land = {"outer": 74.6e-3, "inner": 65.4e-3}[guidance]
    cage = {"free": True, "guidance": guidance, "land_diameter": land}
    model = paper_bearing(load=0.0, cage=cage, gravity=gravity, **changes)
    state = solve_many([model])[0]
    assert state.status is SolverOutcome.CONVERGED
    assert np.isfinite(state.cage_offset).all()


# -- life --------------------------------------------------------------------------------------------


def test_life_does_not_jump_where_a_ring_begins_to_turn():
    """It lost 6.7 % between 0 and 1e-6 rpm of the outer ring."""
    lives = [paper_bearing(outer_speed=speed * RPM, speed=3000 * RPM).solve().life for speed in (0.0, 1e-6)]
    assert lives[1] == approx(lives[0], rel=1e-5)


def test_life_between_a_standing_and_a_turning_ring_rises_steadily():
    loads = np.array([[1000.0], [400.0], [0.0]])
    life = partial(slice_life, loads, loads, (2e3, 2e3))
    shares = [turning_share(1e-6 * turns, 1.0) for turns in (0.0, 0.3, 1.0, 3.0, 1e3)]
    lives = np.array([life((1.0, share)) for share in shares])
    assert shares[0] == 0.0
    assert shares[2] == approx(0.5)
    assert shares[-1] == approx(1.0, rel=2e-6)
    assert (np.diff(lives) > 0).all()
    assert lives[0] == approx(life((True, False)), rel=1e-12)
    assert lives[-1] == approx(life((True, True)), rel=1e-6)


# -- a moment alone ----------------------------------------------------------------------------------


@pytest.mark.parametrize("axial_modes", [2, 3])
@pytest.mark.parametrize("speed", [20.0, 38000.0], ids=["slow", "fast"])
def test_ring_under_a_moment_alone_is_held_by_rollers_on_both_sides(axial_modes, speed):
    """Whatever the clearance: at the start no roller touches, and the ring has to tilt until some do."""
    state = paper_bearing(load=0.0, moment=20.0, speed=speed * RPM, axial_modes=axial_modes).solve()
    assert state.ring_moment == approx([20.0, 0.0], rel=0, abs=1e-6)
    loads, half = state.loads[0], len(state.loads[0]) // 2
    assert loads[0] > 100.0
    assert loads[half] == approx(loads[0], rel=0.05)
