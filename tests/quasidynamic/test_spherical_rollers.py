"""Barrels in a sphere: both rows share, the centre carries no moment, light loads are those of Hertz."""

from math import atan, cos, sin

import numpy as np
import pytest
from pytest import approx

import quasidynamic as qd
from quasidynamic.balance.rollers.inclined import InclinedRollers
from quasidynamic.contact.ellipse.point_contact import Curvatures, point_contact
from quasidynamic.contact.line.slices import Slices
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.profile import Crowned, Hollow
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing, without_rib
from tests.random_tapered import STEEL

FIXED = (None, None, None, 0.0, 0.0)


def barrels(
    tangent=0.16,
    diameter=11e-3,
    length=7.43e-3,
    pitch=70e-3,
    rollers=18,
    osculations=(0.97, 0.97),
    clearance=0.0,
):
    angle = atan(tangent)
    sphere = pitch / 2 / cos(angle) + diameter / 2
    barrel = osculations[1] * sphere
    return TaperedRollerBearing(
        rollers=rollers,
        pitch_diameter=pitch,
        cup_angle=angle,
        cone_angle=angle,
        roller=qd.Roller(
            diameter=diameter,
            length=length,
            material=STEEL,
            profile=Crowned(straight_length=0.0, crown_radius=barrel),
        ),
        rib=without_rib(angle),
        inner_ring=STEEL,
        outer_ring=STEEL,
        clearance=clearance,
        contact_law="iso16281",
        inner_profile=Hollow(radius=barrel / osculations[0]),
        outer_profile=Hollow(radius=sphere),
        rows=tuple(RowPlace(axial=side * pitch / 2 * tangent, mirrored=side < 0) for side in (-1, 1)),
    )


def solved(bearing, load, speed=0.0, places=FIXED, slices=40):
    operation = qd.RingOperation(load=(*load, 0, 0), displacement=places, inner_speed=speed)
    return qd.tapered_loads(bearing, operation, slices)


@pytest.mark.parametrize("speed", [0.0, 300.0])
def test_rows_carry_half_of_a_radial_load_each(speed):
    loads = solved(barrels(), (0.0, 3e3, 8e3), speed)
    assert loads.row_load[:, 1:] == approx(np.array([[1.5e3, 4e3]] * 2), rel=1e-9)
    assert loads.row_load[0, 0] == approx(-loads.row_load[1, 0], rel=1e-9)


def test_one_row_carries_an_axial_load():
    bearing = barrels(clearance=20e-6)
    loads = solved(bearing, (6e3, 0.0, 0.0))
    assert loads.loads[0, 18:] == approx(6e3 / (18 * sin(bearing.cup_angle)), rel=1e-8)
    assert loads.loads[:, :18] == approx(0.0, abs=1e-9 * 6e3)


@pytest.mark.parametrize("load", [(2e3, 0.0, 8e3), (-4e3, 3e3, 1e3), (0.0, 0.0, 30e3)])
def test_the_centre_carries_no_moment_and_the_ring_turns_freely(load):
    bearing = barrels(clearance=20e-6)
    loads = solved(bearing, load)
    size = np.abs(load).max() * bearing.pitch_diameter
    assert loads.reaction[3:] == approx(0.0, abs=1e-9 * size)
    turned = loads.stiffness[3:] * 1e-3  # by a milliradian
    assert np.abs(turned[:, 3:]).max() < 1e-6 * size
    assert np.abs(turned[:, :3] * 1e-5).max() < 1e-6 * size
    askew = solved(bearing, load, places=(None, None, None, 2e-3, -1e-3))
    assert askew.loads == approx(loads.loads, abs=1e-5 * loads.loads.max())


def test_a_mirrored_load_has_the_mirrored_rows():
    bearing = barrels(clearance=20e-6)
    here, there = (solved(bearing, (side * 2e3, 1e3, 8e3), 200.0) for side in (1, -1))
    assert here.loads[:, :18] == approx(there.loads[:, 18:], rel=1e-8, abs=1e-6)
    assert here.displacement[:3] == approx(there.displacement[:3] * [-1, 1, 1], rel=1e-8)


@pytest.mark.parametrize("race", [0, 1])
@pytest.mark.parametrize("way", [0, 1, 2])
def test_slices_come_closer_as_the_circles_do(race, way):
    """Against distances of points of a rigid barrel from the circle of the raceway; x along, y outwards."""
    bearing, step = barrels(), 1e-6
    half, side = bearing.roller.length / 2, (-1.0, 1.0)[race]
    slices, radius = Slices(15, 2 * half), (bearing.inner_profile, bearing.outer_profile)[race].radius
    s, middle = slices.centres, bearing.roller.diameter / 2
    points = np.array([s, side * (middle - bearing.roller.profile.drop(s, 2 * half))])
    centre = np.array([0.0, side * (middle - radius)])

    def approach(along, outwards, turn):
        moved = points + np.array([along - turn * points[1], outwards + turn * points[0]])
        return np.hypot(*(moved - centre[:, None])) - radius

    move = np.zeros(3)
    move[way] = step if way < 2 else step / half
    exact = (approach(*move) - approach(0, 0, 0)) / step
    angle = bearing.cup_angle
    to_model = np.array([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]]) @ move[:2] / step
    model = InclinedRollers.of(bearing, slices, np.zeros(3))
    given = slices.modes @ model.levers[race] @ [*to_model, move[2] * half / step]
    assert given == approx(exact, abs=1.5e-2 * np.abs(exact).max())


@pytest.mark.parametrize("race", [0, 1])
def test_curvatures_in_the_plane_of_rolling_are_those_of_the_swept_arcs(race):
    """Along its normal a raceway is as curved as its distance from the axis says: Meusnier."""
    bearing = barrels()
    loads, side = solved(bearing, (0.0, 0.0, 1e3)), (-1, 1)[race]
    angle, middle, s = bearing.cup_angle, bearing.roller.diameter / 2, loads.slices.centres
    arc = (bearing.inner_profile, bearing.outer_profile)[race]
    height = side * (middle + arc.drop(s, 1.0))  # of points above the axis of the roller, `s` along it
    radial = bearing.pitch_diameter / 2 + height * cos(angle) + s * sin(angle)
    raceway = radial / np.cos(angle - side * np.arcsin(s / arc.radius))
    roller = middle - bearing.roller.profile.drop(s, 2 * middle)
    assert loads.reduced_radius(race) == approx(1 / (1 / roller - side / raceway), rel=(2e-3, 1e-6)[race])


HERTZ = {  # load of a roller [N]: approach of both contacts, inner peak pressure, over those of Hertz
    10.0: (1.211, 0.914),
    100.0: (1.090, 0.939),
    300.0: (1.036, 0.951),
    1000.0: (0.982, 0.965),
}


@pytest.mark.parametrize("load", HERTZ)
def test_slices_against_ellipses_that_end_on_the_roller(load):
    """Springs side by side are no half-space: the measured difference, as docs/theory/tapered.md has it."""
    bearing = barrels()
    angle, diameter = bearing.cup_angle, bearing.roller.diameter
    loads = solved(bearing, (load * 18 * sin(angle), 0.0, 0.0), slices=200)
    across = bearing.pitch_diameter / cos(angle)
    sphere = (across + diameter) / 2
    barrel, modulus = 0.97 * sphere, contact_modulus(STEEL, STEEL)
    inner, outer = (
        point_contact(
            Curvatures(
                np.array(1 / barrel - 1 / sphere),  # both osculations are alike
                np.array(2 / diameter + side * 2 / (across - side * diameter)),
            ),
            modulus,
        )
        for side in (1, -1)
    )
    assert 2 * inner.semi_axes(load)[0] < bearing.roller.length
    measured = (
        loads.displacement[0] * sin(angle) / (inner.approach(load) + outer.approach(load)),
        loads.pressures[0].max() / inner.peak_pressure(load),
    )
    assert measured == approx(HERTZ[load], abs=2e-3)


def test_random_bearings_converge_in_balance():
    random = np.random.default_rng(22210)
    for _ in range(100):
        tangent, pitch = random.uniform(0.1, 0.27), 10 ** random.uniform(-1.5, 0.0)
        diameter = pitch * random.uniform(0.08, 0.2)
        bearing = barrels(
            tangent, diameter, pitch * tangent * random.uniform(0.4, 0.95), pitch,
            int(2.8 * pitch / diameter), tuple(random.uniform(0.93, 0.995, 2)),
            pitch * random.uniform(-1e-4, 6e-4),
        )  # fmt: skip
        size = 10 ** random.uniform(6.0, 8.3) * diameter * bearing.roller.length * bearing.rollers
        load = size * random.uniform(-1.0, 1.0, 3) * random.choice([0.0, 1.0], 3, p=[0.2, 0.8])
        load[2] += 1e-2 * size
        loads = solved(bearing, load, random.choice([0.0, 5.0 / pitch]))
        assert -loads.reaction[:3] == approx(load, abs=1e-9 * size)
        assert loads.reaction[3:] == approx(0.0, abs=1e-9 * size * pitch + 1e-9)
