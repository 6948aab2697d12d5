"""Film, friction and speeds of tapered rollers: power and heat, balances, the cylinder, rows, the cage."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from pytest import approx

from quasidynamic import (
    FORMULAS,
    Cage,
    ImpossiblePart,
    Lubrication,
    NotSolved,
    Rib,
    RingOperation,
    TaperedRollerBearing,
    oil_at,
    tapered_loads,
)
from quasidynamic.balance.rollers.inclined_motion import InclinedMotion
from quasidynamic.contact.film import FilmLaw
from quasidynamic.contact.line.slices import Slices
from quasidynamic.contact.traction import RollingShear
from quasidynamic.motion.tapered_speeds import tapered_speeds
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.roller_bearing import FREE_POCKETS
from quasidynamic.solve.rollers import inclined_speeds
from quasidynamic.solve.rollers.inclined_speeds import balanced_motion
from quasidynamic.tapered_friction import TaperedFriction
from tests.bearings import paper_bearing
from tests.quasidynamic.test_tapered import RPM, STRAIGHTENED, tapered

OIL = oil_at("ISO VG 100", 333.15)
LAWS = Lubrication(oil=OIL, oil_fraction=0.05, churning_gap=1e-3)
POCKETS = Cage(guidance="rollers", pocket_friction=0.05, thickness=1e-3)
LAND = replace(POCKETS, guidance="outer", land_diameter=76e-3, land_width=4e-3, land_clearance=0.3e-3)
LANDS = {"inner": replace(LAND, guidance="inner"), "outer": LAND}
SPEEDS = {"inner": (2000, 0), "both": (-3000, 500), "outer": (0, 1500), "same way": (300, 4000)}
ONE_ROW = (RowPlace(),)
ANGLES = {"one apex": radians(11.6462), "no apex": radians(9)}


def friction(
    cone=ANGLES["one apex"],
    speeds=SPEEDS["inner"],
    laws=LAWS,
    coefficient=0.05,
    cage=POCKETS,
    rows=ONE_ROW,
    **load,
):
    model = replace(tapered(), side=1, cone_angle=cone, rows=rows)
    force = load.get("axial", 10e3), 0.0, load.get("radial", 15e3), 0.0, 0.0
    inner, outer = speeds
    asked = RingOperation(
        load=force, displacement=STRAIGHTENED, inner_speed=inner * RPM, outer_speed=outer * RPM
    )
    return TaperedFriction(tapered_loads(model, asked), laws, coefficient, cage)


def heat(found):
    causes = ("sliding", "rolling", "rib", "drag", "churning", "pocket", "land")
    return [getattr(found, f"{cause}_heat").sum() for cause in causes]


def cage_slip(found):
    assert found.cage_slip is not None
    return found.cage_slip


@pytest.mark.parametrize("cage", [POCKETS, *LANDS.values()], ids=lambda cage: cage.guidance)
@pytest.mark.parametrize("speeds", SPEEDS.values(), ids=SPEEDS)
@pytest.mark.parametrize("cone", ANGLES.values(), ids=ANGLES)
def test_power_that_rings_put_in_is_heat_of_all_causes(cone, speeds, cage):
    found = friction(cone, speeds, cage=cage)
    causes = heat(found)
    assert min(causes[:6]) > 0
    assert (causes[6] > 0) == (cage is not POCKETS)
    assert found.power == approx(sum(causes) + found.transport.sum(), rel=1e-11)


@pytest.mark.parametrize("cage", [POCKETS, LANDS["outer"]], ids=["pockets", "land"])
@pytest.mark.parametrize("speeds", SPEEDS.values(), ids=SPEEDS)
def test_rollers_and_cage_are_in_balance(speeds, cage):
    """All forces of the raceways, the rib, the mixture and the cage, one slice at a time.

    On each roller along the orbit and about its axis; of all of them and the cage about that of the bearing.
    """
    found = friction(ANGLES["no apex"], speeds, cage=cage)
    loads, model, state = found.loads, found.loads.bearing, found.state
    middle, half = model.pitch_diameter / 2, model.roller.diameter / 2
    turning = found.state.land.sum()
    for j in range(model.rollers):
        along = state.rib_force[j] - state.drag[j] + state.pocket_force[j]
        about_roller = state.rib_force[j] * model.rib.depth - state.churning[j]
        about_roller -= np.sign(state.spin[j]) * 0.05 * abs(state.pocket_force[j]) * half
        gained = model.roller.inertia * model.rollers / (2 * np.pi) * state.orbit[j]
        neighbour = state.spin[(j - np.sign(state.orbit[j]).astype(int)) % model.rollers]
        about_roller -= abs(gained) * (state.spin[j] - neighbour)
        turning += state.rib_force[j] * model.rib_radius - state.drag[j] * middle
        for race, side, mean in ((0, 1, model.inner_radius), (1, -1, model.outer_radius)):
            angle = (model.cone_angle, model.cup_angle)[race]
            for k, s in enumerate(loads.slices.centres):
                raceway, roller = mean + s * np.sin(angle), half + s * np.sin(model.taper)
                pull, shear = state.traction[race, j, k], state.shear[race, j, k]
                pressure = 2 * shear * raceway / (raceway + side * roller * np.cos(angle))  # through its axis
                along += pull - shear + pressure
                about_roller += side * (pull - shear) * roller
                turning += (pull + shear) * raceway
        size = np.abs(state.traction[:, j]).sum() + np.abs(state.shear[:, j]).sum()
        assert along == approx(0.0, abs=1e-11 * size)
        assert about_roller == approx(
            0.0, abs=2e-6 * size * half
        )  # pocket and transport are smooth through rest
    assert turning == approx(0.0, abs=1e-9 * np.abs(found.torque).max())


def test_slopes_are_the_derivatives_of_the_balances():
    motion = friction(ANGLES["no apex"], cage=LANDS["outer"]).motion
    count, random = motion.bearing.rollers, np.random.default_rng(3)
    place, step = random.normal(size=count + 1) * motion.pure_rolling.orbit * 1e-2, 1e-5
    slopes = motion.state(place[:count], place[count:]).slopes
    for column in range(count + 1):
        change = step * np.eye(count + 1)[column]
        one, other = ((place + sign * change) for sign in (1, -1))
        difference = motion.state(one[:count], one[count:]).imbalance
        difference = (difference - motion.state(other[:count], other[count:]).imbalance) / (2 * step)
        assert slopes[:, column] == approx(difference, rel=1e-6, abs=1e-7 * np.abs(slopes[:, column]).max())


CYLINDERS = {
    "paper": {},
    "eyring": {"traction": "eyring"},
    "preloaded": {"clearance": -40e-6, "load": 1000.0},
    "light": {"load": 200.0},
    "both rings turn": {"outer_speed": 5000 * RPM},
    "backwards": {"speed": -38000 * RPM},
    "inner guided": {"cage": {"guidance": "inner", "land_diameter": 65.4e-3}},
    "churning": {"churning_gap": 0.5e-3},
}


@pytest.mark.parametrize("changes", CYLINDERS.values(), ids=CYLINDERS)
def test_angle_zero_under_the_loads_of_cylindrical_rollers_moves_as_they_do(changes):
    expected = paper_bearing(gravity=0.0, axial_modes=1, **changes).solve()
    equations = expected.balance.roller
    cylinder, raceways = equations.bearing, equations.raceways
    model = TaperedRollerBearing(
        rollers=cylinder.rollers, pitch_diameter=cylinder.pitch_diameter, cup_angle=0.0, cone_angle=0.0,
        roller=cylinder.roller, rib=Rib(angle=0.0, stiffness=1.0, lever=0.0, depth=0.0),
        inner_ring=cylinder.inner_ring, outer_ring=cylinder.outer_ring,
    )  # fmt: skip
    inner, outer = (float(speed[0, 0]) for speed in expected.balance.points.ring_speeds)
    even = expected.loads[:, :, None] / raceways.slices.length
    motion = InclinedMotion(
        bearing=model,
        slices=Slices(4, model.roller.length),
        ring_speeds=(inner, outer),
        pure_rolling=tapered_speeds(model, inner, outer),
        slice_loads=np.repeat(even, 4, axis=-1),
        rib_loads=np.zeros(model.rollers),
        radius=np.broadcast_to(raceways.radius, (2, 1, 4)),
        modulus=raceways.modulus,
        lubrication=equations.lubrication,
        rib_friction=0.0,
        cage=cylinder.cage,
    )
    found = balanced_motion(motion)
    assert found.orbit == approx(np.full(model.rollers, expected.cage_speed), rel=1e-12)
    assert found.spin == approx(expected.roller_speed, rel=1e-12)
    assert found.pocket_force == approx(expected.cage_force, rel=1e-9)
    assert found.traction.sum(-1) == approx(expected.traction, rel=1e-9)
    assert found.land[0] == approx(expected.land_torque, rel=1e-9)


def test_slices_slide_as_their_cones_do():
    model = tapered()
    for cone, largest in ((ANGLES["one apex"], 1e-3), (ANGLES["no apex"], 0.1)):
        found = friction(cone)
        motion, places = found.motion, found.loads.slices.centres
        half_angle = (model.cup_angle - cone) / 2
        ring, spin = 2000 * RPM - found.state.orbit[4], found.state.spin[4]
        expected = ring * (model.pitch_diameter / 2 - 10.5e-3 / 2 * np.cos(cone) + places * np.sin(cone))
        expected -= spin * (10.5e-3 / 2 + places * np.sin(half_angle))
        assert found.state.sliding[0, 4] == approx(expected, rel=1e-9, abs=1e-12)
        count = model.rollers
        without_slip = motion.state(np.zeros(count), np.zeros(1)).sliding
        assert largest / 10 < np.abs(without_slip).max() < 2 * largest


def no_shear(load, entrainment, geometry, oil):
    return RollingShear(0.0 * load * entrainment, 0.0 * load * entrainment, 0.0 * load * entrainment)


def test_without_resistance_nothing_slips():
    model = replace(
        tapered(), cup_angle=0.0, cone_angle=0.0, rib=replace(tapered().rib, angle=0.0, lever=0.0)
    )
    asked = RingOperation(load=(0, 0, 8e3, 0, 0), displacement=(0.0, None, None, 0, 0), inner_speed=300.0)
    laws = Lubrication(oil=OIL, oil_fraction=0.0, rolling=no_shear, drag_coefficient=1e-12)
    found = TaperedFriction(tapered_loads(model, asked), laws, 0.0)
    assert found.cage_slip == approx(0.0, abs=1e-12)
    assert found.roller_slip == approx(np.zeros(model.rollers), abs=1e-12)


def test_rib_friction_is_that_of_coulomb_and_drives_the_cage_ahead():
    """To how it is smooth through rest; the rib runs faster than the ends of the rollers."""
    with_rib, without = friction(), friction(coefficient=0.0)
    state = with_rib.state
    coulomb = np.abs(state.rib_sliding) * 0.05 * with_rib.loads.rib_loads
    assert with_rib.rib_heat == approx(coulomb, rel=6e-3)
    assert (without.rib_heat == 0.0).all()
    assert cage_slip(with_rib) < 0.0
    assert cage_slip(without) > cage_slip(with_rib)


def test_land_brakes_or_drives_the_cage():
    slips = {name: cage_slip(friction(cage=cage)) for name, cage in LANDS.items()}
    assert slips["inner"] < cage_slip(friction()) < slips["outer"]


def test_more_friction_in_pockets_costs_more():
    rough = replace(POCKETS, pocket_friction=0.2)
    assert friction(cage=rough).pocket_heat.sum() > 2 * friction().pocket_heat.sum()
    assert (friction(cage=FREE_POCKETS).pocket_heat == 0.0).all()


def test_rows_under_one_load_each_move_as_one_row_does():
    alone = friction(axial=10e3, radial=0.0)
    rows = tuple(RowPlace(axial=place, closer=0.0, mirrored=False) for place in (-20e-3, 20e-3))
    both = friction(axial=20e3, radial=0.0, rows=rows)
    assert both.cage_speed == approx(np.full(2, alone.cage_speed[0]), rel=1e-9)
    assert both.torque == approx(2 * alone.torque, rel=1e-9)
    assert both.cage_slip == approx(alone.cage_slip, rel=1e-6)


def test_each_row_of_a_pair_moves_with_a_cage_of_its_own():
    rows = tuple(RowPlace(axial=15e-3 * side, closer=10e-6, mirrored=side > 0) for side in (-1, 1))
    found = friction(axial=10e3, radial=3e3, rows=rows)
    pressed, other = found.cage_speed
    assert abs(pressed - other) > 1e-5 * abs(pressed)
    count, motion = found.loads.bearing.rollers, found.motion
    for number, speed in enumerate(found.cage_speed):
        of_row = slice(number * count, (number + 1) * count)
        alone = replace(
            motion,
            bearing=replace(motion.bearing, rows=ONE_ROW),
            slice_loads=motion.slice_loads[:, of_row],
            rib_loads=motion.rib_loads[of_row],
        )
        state = balanced_motion(alone)
        assert state.orbit == approx(np.full(count, speed), rel=1e-10)
        assert state.spin == approx(found.state.spin[of_row], rel=1e-10)


def test_turning_back_turns_every_force():
    one, other = friction(speeds=(2000, -300), radial=0.0), friction(speeds=(-2000, 300), radial=0.0)
    assert other.torque == approx(-one.torque, rel=1e-9)
    assert other.traction == approx(-one.traction, rel=1e-9)
    assert heat(other) == approx(heat(one), rel=1e-9)


def test_films_of_slices_are_those_of_their_loads_and_speeds():
    found, j, k = friction(), 3, 7
    motion, state = found.motion, found.state
    law = FilmLaw(
        formula=FORMULAS["dowson"], radius=motion.radius[0, 0, k], modulus=motion.modulus[0, 0, 0], oil=OIL
    )
    film = law(motion.slice_loads[0, j, k], state.sliding[0, j, k], abs(state.rolling[0, j, k])).thickness
    assert state.film[0, j, k] == approx(film, rel=1e-9)
    starved = friction(laws=replace(LAWS, inlet_length=0.5))
    assert (starved.state.film < state.film).all()


def test_short_steps_lead_where_newtons_method_does(monkeypatch):
    expected = friction(ANGLES["no apex"]).state
    monkeypatch.setattr(inclined_speeds, "NEWTON_STEPS", 0)
    found = friction(ANGLES["no apex"]).state
    assert found.spin == approx(expected.spin, rel=1e-10)
    assert found.orbit == approx(expected.orbit, rel=1e-10)


def test_speeds_without_a_balance_are_refused(monkeypatch):
    monkeypatch.setattr(inclined_speeds, "NEWTON_STEPS", 1)
    monkeypatch.setattr(inclined_speeds, "SHORT_STEPS", 1)
    with pytest.raises(NotSolved, match="no speeds of rollers and cage in balance"):
        assert friction().state


def test_rings_that_turn_alike_have_no_friction():
    with pytest.raises(ImpossiblePart, match="nothing rolls"):
        friction(speeds=(500, 500))
