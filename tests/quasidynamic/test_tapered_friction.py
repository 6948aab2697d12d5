"""Film and friction of tapered rollers: power and heat, the cylinder, sliding along cones, the rib."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from pytest import approx

from quasidynamic import FORMULAS, ImpossiblePart, Lubrication, RingOperation, Roller, oil_at, tapered_loads
from quasidynamic.contact.film import FilmLaw
from quasidynamic.contact.traction import biboulet_houpert
from quasidynamic.tapered_friction import TaperedFriction
from tests.quasidynamic.test_tapered import RPM, STEEL, STRAIGHTENED, tapered

OIL = oil_at("ISO VG 100", 333.15)
LAWS = Lubrication(oil=OIL, oil_fraction=0.05, churning_gap=1e-3)
SPEEDS = {"inner": (2000, 0), "both": (-3000, 500), "outer": (0, 1500), "same way": (300, 4000)}
ANGLES = {"one apex": radians(11.6462), "no apex": radians(9)}


def friction(cone=ANGLES["one apex"], speeds=SPEEDS["inner"], laws=LAWS, coefficient=0.05, **load):
    model = replace(tapered(), side=1, cone_angle=cone)
    force = load.get("axial", 10e3), 0.0, load.get("radial", 15e3), 0.0, 0.0
    inner, outer = speeds
    asked = RingOperation(
        load=force, displacement=STRAIGHTENED, inner_speed=inner * RPM, outer_speed=outer * RPM
    )
    return TaperedFriction(tapered_loads(model, asked), laws, coefficient)


def heat(found):
    causes = found.sliding_heat.sum(), found.rolling_heat.sum(), found.rib_heat.sum()
    return [*causes, found.drag_heat, found.churning_heat]


@pytest.mark.parametrize("speeds", SPEEDS.values(), ids=SPEEDS)
@pytest.mark.parametrize("cone", ANGLES.values(), ids=ANGLES)
def test_power_that_rings_put_in_is_heat_of_all_causes(cone, speeds):
    found = friction(cone, speeds)
    causes = heat(found)
    assert min(causes) > 0
    assert found.power == approx(sum(causes), rel=1e-11)


@pytest.mark.parametrize("speeds", SPEEDS.values(), ids=SPEEDS)
def test_rollers_are_in_balance_about_both_axes(speeds):
    """Moments of all forces of the raceways, the rib and the mixture on a roller, one slice at a time."""
    found = friction(ANGLES["no apex"], speeds)
    loads, model = found.loads, found.loads.bearing
    for j in (0, 5):
        about_bearing = found.rib_force[j] * model.rib_radius - found.drag * model.pitch_diameter / 2
        about_roller = found.rib_force[j] * model.rib.depth - found.churning
        for race, side, middle in ((0, 1, model.inner_radius), (1, -1, model.outer_radius)):
            about_bearing += found.rolling_traction[race, j] * middle
            about_roller += side * found.rolling_traction[race, j] * model.roller.diameter / 2
            for k, s in enumerate(loads.slices.centres):
                raceway = middle + s * np.sin((model.cone_angle, model.cup_angle)[race])
                roller = model.roller.diameter / 2 + s * np.sin(model.taper)
                shear = np.sign(found.rolling[race, 0, k]) * found.inlet_shear[race, j, k]
                pressure = 2 * shear * raceway  # of the inlet, about the axis of the bearing
                about_bearing += (found.traction[race, j, k] - shear) * raceway + pressure
                about_roller += side * (found.traction[race, j, k] - shear) * roller
        size = 1e-9 * np.abs(found.torque).max()
        assert about_bearing == approx(0.0, abs=size)
        assert about_roller == approx(0.0, abs=size)
    assert found.torque.sum() == approx(model.rollers * found.drag * model.pitch_diameter / 2, rel=1e-9)


def test_slices_slide_as_their_cones_do():
    model = tapered()
    for cone, largest in ((ANGLES["one apex"], 1e-3), (ANGLES["no apex"], 0.1)):
        found = friction(cone)
        places, orbit = found.loads.slices.centres, found.loads.speeds.orbit
        half_angle = (model.cup_angle - cone) / 2
        ring, spin = 2000 * RPM - orbit, found.loads.speeds.spin
        expected = places * (ring * np.sin(cone) - spin * np.sin(half_angle))
        assert found.sliding[0, 0] == approx(expected, rel=1e-6, abs=1e-12)
        assert np.abs(found.sliding).max() < 2 * largest
        assert np.abs(found.sliding).max() > largest / 10
    rolling = found.rolling[:, 0].mean(-1)
    assert rolling[0] == approx(-rolling[1], rel=1e-9)  # both raceways pass the roller alike in the middle


def test_angle_zero_has_the_laws_of_the_cylindrical_roller():
    """Straight rollers under an even load per length: the laws of a whole roller at its mean line load."""
    roller = Roller(diameter=10e-3, length=9.601e-3, material=STEEL)
    model = tapered(
        rollers=14, pitch_diameter=65.032e-3, roller=roller, cup_angle=0.0, cone_angle=0.0,
        rib=replace(tapered().rib, angle=0.0, stiffness=1e13, lever=0.0, depth=4e-3),
    )  # fmt: skip
    asked = RingOperation(
        load=(0, 0, 8e3, 0, 0), displacement=(0.0, None, None, 0.0, 0.0), inner_speed=3000 * RPM
    )
    loads = tapered_loads(model, asked)
    found = TaperedFriction(loads, LAWS, 0.0)
    inner = model.inner_radius
    speed = np.array((asked.inner_speed - loads.speeds.orbit) * inner)
    assert np.abs(found.sliding).max() < 1e-12 * speed
    for race, curvature in enumerate((1 / inner, -1 / model.outer_radius)):
        radius = 1 / (2 / roller.diameter + curvature)
        load, modulus = loads.loads[race, 0], loads.moduli[race]
        shear = biboulet_houpert(load, speed, (radius, modulus, roller.length), OIL).force
        assert found.rolling_heat[race, 0] == approx(2 * shear * speed, rel=1e-9)
        film = FilmLaw(formula=FORMULAS["dowson"], radius=radius, modulus=modulus, oil=OIL)
        expected = film(np.array(load / roller.length), np.array(0.0), speed).thickness
        assert found.film[race, 0] == approx(expected, rel=1e-9)


def test_rib_and_raceways_add_up():
    with_rib, without = friction(), friction(coefficient=0.0)
    relative = with_rib.loads.operation.relative_speed
    rib = np.abs(with_rib.loads.speeds.rib_sliding) * 0.05 * with_rib.loads.rib_loads
    assert with_rib.rib_heat == approx(rib, rel=1e-12)
    drag = with_rib.drag_heat - without.drag_heat
    assert drag == 0.0
    assert (with_rib.torque - without.torque)[0] * relative == approx(rib.sum(), rel=1e-9)


def test_turning_back_turns_every_force():
    one, other = friction(speeds=(2000, -300)), friction(speeds=(-2000, 300))
    assert other.torque == approx(-one.torque, rel=1e-12)
    assert other.rolling_traction == approx(-one.rolling_traction, rel=1e-12)
    assert heat(other) == approx(heat(one), rel=1e-12)


def test_films_of_slices_follow_their_loads():
    found = friction()
    loads, film = found.loads.slice_loads, found.film
    assert film[:, 3] / film[:, 0] == approx((loads[:, 3] / loads[:, 0]) ** -0.13, rel=1e-6)
    starved = friction(laws=replace(LAWS, inlet_length=0.5))
    assert (starved.film < found.film).all()


def test_rings_that_turn_alike_have_no_friction():
    with pytest.raises(ImpossiblePart, match="nothing rolls"):
        friction(speeds=(500, 500))
