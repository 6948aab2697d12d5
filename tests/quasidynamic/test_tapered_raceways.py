"""Tapered rollers between elastic raceways: one page of balances, limits, symmetry and derivatives."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import (
    Cage,
    CylindricalRollerBearing,
    ImpossiblePart,
    Material,
    RingOperation,
    Roller,
    tapered_loads,
)  # fmt: skip
from quasidynamic.balance.rollers.rigid_rings import RigidRings
from quasidynamic.contact.line.slices import Slices
from tests.quasidynamic.test_tapered import FAST, RPM, STRAIGHTENED, Crown, tapered
from tests.reference.plain_tapered import out_of_balance

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
SOFT = 6e-9  # [m/N] of a ring about as soft as its contacts


def ring(azimuths, softness=SOFT, shapes=3, slope=0.2):
    """Compliance (Z, M, Z, M) of a ring that moves, ovalises and gives way under its own load, and slopes."""
    apart = azimuths[:, None] - azimuths
    along = 1 + 0.5 * np.cos(apart) + 0.6 * np.cos(2 * apart) + 0.2 * np.cos(3 * apart)
    own = np.eye(len(azimuths))
    modes = np.diag(1.0 / (1 + np.arange(shapes)) ** 2)
    modes[0, 1] = modes[1, 0] = slope * modes[1, 1]
    whole = np.multiply.outer(softness * (along / 10 + own), modes)
    return whole.transpose(0, 2, 1, 3)


def with_rib(compliance, softness=SOFT, across=-0.3):
    """An inner raceway that also moves along itself, with the rib, by what presses on it and on its rib."""
    rollers, shapes = compliance.shape[:2]
    whole = np.zeros((rollers, shapes + 1) * 2)
    whole[:, :-1, :, :-1] = compliance
    whole[:, -1, :, 0] = whole[:, 0, :, -1] = across * compliance[:, 0, :, 0]
    whole[:, -1, :, -1] = compliance[:, 0, :, 0]
    return whole


def operation(axial=10e3, radial=15e3, held=STRAIGHTENED, speed=0.0, turn=0.0):
    load = (axial, radial * np.sin(turn), radial * np.cos(turn), 0.0, 0.0)
    return RingOperation(load=load, displacement=held, inner_speed=speed * RPM)


def bearing(**changes):
    return replace(tapered(), side=1, **changes)


def solved(model, asked, cone=True, cup=True, scale=1.0):
    soft = ring(model.azimuths) * scale
    return tapered_loads(
        model, asked, raceways=(with_rib(soft) if cone else None, 1.5 * soft if cup else None)
    )


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("held", [STRAIGHTENED, (None, None, None, None, 2e-4)], ids=["held", "free"])
def test_one_page_of_balances_is_met(side, held):
    model = replace(bearing(clearance=10e-6, first_roller_azimuth=0.1), side=side)
    asked = operation(side * 10e3, held=held, speed=FAST)
    found = solved(model, asked)
    rollers = np.column_stack([found.solution.state.rollers[:, :2], found.roller_tilt])
    compliances = with_rib(ring(model.azimuths)), 1.5 * ring(model.azimuths)
    inertia = found.speeds.centrifugal_force, found.speeds.gyroscopic_moment
    on_ring, on_rollers, misfits = out_of_balance(
        model, found.displacement, rollers, found.solution.shape, compliances, asked.load, inertia
    )
    size = 2e-6 * found.loads.max()  # of contact that begins smoothly in production
    assert on_ring == approx([0.0] * 3, abs=size)
    assert np.array(on_rollers) == approx(0.0, abs=size)
    for misfit in misfits:
        assert np.array(misfit) == approx(0.0, abs=1e-6 * np.abs(found.solution.shape).max())


def readings(model, shapes, race="inner"):
    """What raceways read (Z, M + 1, 5) of a motion of their ring: x, y, z, turns about y and z.

    Of displacements (x', r) of mid-contact, x' to the rib, that along the normal, its turn, that along.
    """
    angle, sign = (model.cone_angle, -1) if race == "inner" else (model.cup_angle, 1)
    normal = sign * np.array([-np.sin(angle), np.cos(angle)])
    middle, half = model.roller.diameter / 2 / np.cos(model.taper) * normal, model.roller.length / 2
    read, pitch = np.zeros((model.all_rollers, shapes + 1, 5)), model.pitch_diameter / 2
    for j, azimuth in enumerate(model.azimuths):
        row, s, c = j // model.rollers, np.sin(azimuth), np.cos(azimuth)
        side, place = model.sides[row], model.rows[row].axial
        turn = side * np.array([0, 0, 0, c, -s])
        along = -side * np.array([1, 0, 0, pitch * c, -pitch * s]) - turn * middle[1]
        out = np.array([0, s, c, -place * c, place * s]) + turn * middle[0]
        read[j, 0], read[j, 1] = normal[0] * along + normal[1] * out, sign * half * turn
        read[j, -1] = np.cos(angle) * along + np.sin(angle) * out
    return read


@pytest.mark.parametrize("side", [1, -1])
def test_a_rigid_ring_on_springs_is_one_that_moved(side):
    """Inner raceway and rib as one rigid body on springs: loads are those at the place where it goes."""
    model = replace(bearing(), side=side)
    read = readings(model, 3)
    springs = np.array([2e-9, 1e-9, 1e-9, 2e-6, 2e-6])  # [m/N, rad/(N m)]
    compliance = np.einsum("jma,a,knb,ab->jmkn", read, springs, read, np.eye(5))
    asked = operation(side * 10e3, held=(None, None, None, 1e-4, 0.0), speed=FAST)
    found = tapered_loads(model, asked, raceways=(compliance, None))
    assert found.solution.shape is not None
    moved = np.linalg.lstsq(read.reshape(-1, 5), found.solution.shape[0].ravel(), rcond=None)[0]
    place = tuple(found.displacement + moved)
    there = tapered_loads(model, replace(asked, load=(0.0,) * 5, displacement=place))
    assert found.loads == approx(there.loads, rel=0, abs=1e-8 * there.loads.max())
    assert found.rib_loads == approx(there.rib_loads, rel=0, abs=1e-7 * there.rib_loads.max())
    assert moved[0] == approx(-springs[0] * 10e3 * side, rel=1e-9)  # rollers and ribs carry all of it


def test_stiff_raceways_are_rigid_ones():
    model, asked = bearing(), operation()
    rigid = tapered_loads(model, asked)
    for scale in (1e-3, 1e-6):
        found = solved(model, asked, scale=scale)
        assert found.loads == approx(rigid.loads, rel=0, abs=scale * rigid.loads.max())
    assert np.abs(solved(model, asked).loads - rigid.loads).max() > 0.02 * rigid.loads.max()


@pytest.mark.parametrize(("cone", "cup"), [(True, False), (False, True), (True, True)])
def test_angle_zero_is_the_cylindrical_roller_between_elastic_raceways(cone, cup):
    """A cylinder between rings of the shape that its own forces make: shapes are linear, as the roller is."""
    roller = Roller(diameter=10e-3, length=9.601e-3, material=STEEL)
    cylinder = CylindricalRollerBearing(
        rollers=14, outer_raceway_diameter=75.032e-3, clearance=41e-6, roller=roller, inner_ring=STEEL,
        outer_ring=STEEL, cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=5e-3, mass=0.1),
    )  # fmt: skip
    rib = replace(tapered().rib, angle=0.0, stiffness=1e13, lever=0.0, depth=4e-3)
    same = tapered(
        rollers=14, pitch_diameter=65.032e-3, clearance=41e-6, roller=roller, cup_angle=0.0, cone_angle=0.0,
        rib=rib, inner_ring=STEEL, outer_ring=STEEL,
    )  # fmt: skip
    soft, held = ring(same.azimuths, shapes=2), (0.0, None, None, 0.0, 0.0)
    raceways = (
        with_rib(0 * soft) + np.pad(soft, [(0, 0), (0, 1)] * 2) if cone else None,
        soft if cup else None,
    )
    found = tapered_loads(same, RingOperation(load=(0, 0, 8e3, 0, 0), displacement=held), 20, raceways)
    slices = Slices(20, roller.length, 2)
    assert found.solution.shape is not None
    gap = found.solution.shape[..., :2].sum(0) @ slices.modes.T
    rings = RigidRings.of(cylinder, slices, np.array([[0.0, 0.0], [8e3, 0.0]]))
    rings = replace(rings, gap=rings.gap + gap)
    place = np.zeros((2, 2))
    place[:, 0] = found.displacement[1:3]
    state = rings.at(place)
    assert state.excess[:, 0] == approx([0.0, 0.0], abs=1e-9 * 8e3)
    assert state.slice_load == approx(found.slice_loads[0], rel=0, abs=1e-9 * found.slice_loads.max())
    made = np.einsum("jmkn,kn->jm", soft, state.slice_load @ slices.weights)
    for elastic, shape in zip((cone, cup), found.solution.shape, strict=True):
        assert shape[:, :2] == approx(elastic * made, rel=0, abs=1e-9 * np.abs(made).max())


def test_a_turned_load_turns_the_answer():
    turn = 0.7
    first = solved(bearing(), operation(speed=FAST))
    second = solved(bearing(first_roller_azimuth=turn), operation(speed=FAST, turn=turn))
    assert second.loads == approx(first.loads, rel=1e-9)
    y, z = first.displacement[1:3]
    turned = y * np.cos(turn) + z * np.sin(turn), z * np.cos(turn) - y * np.sin(turn)
    assert second.displacement[1:3] == approx(turned, rel=0, abs=1e-9 * z)


def test_the_answer_is_symmetric():
    found = solved(bearing(), operation())
    assert found.slice_loads[:, 1:] == approx(found.slice_loads[:, :0:-1], rel=1e-8, abs=1e-3)
    assert found.stiffness == approx(found.stiffness.T, rel=1e-12, abs=1e-3)


def test_stiffness_is_that_of_differences():
    held = np.array([38e-6, 1e-6, 12e-6, 2e-4, -1e-4])
    step = np.array([1e-9, 1e-9, 1e-9, 1e-8, 1e-8])

    def at(place):
        return solved(bearing(), RingOperation(displacement=tuple(place), inner_speed=FAST * RPM))

    differences = np.array([
        -(at(held + step * unit).reaction - at(held - step * unit).reaction) / (2 * step @ unit)
        for unit in np.eye(5)
    ]).T  # fmt: skip
    found = at(held).stiffness
    assert found == approx(differences, rel=1e-4, abs=1e-4 * np.abs(differences).max())


def test_pure_thrust_is_carried_alike_by_elastic_rings():
    found = solved(bearing(roller=replace(tapered().roller, profile=Crown(6e-6))), operation(radial=0.0))
    assert found.loads[1] == approx(1e4 / 19 / np.sin(bearing().cup_angle), rel=1e-9)


def test_a_compliance_of_other_rollers_is_refused():
    model = bearing()
    with pytest.raises(ImpossiblePart, match="does not fit 19 rollers"):
        tapered_loads(model, operation(), raceways=(None, ring(model.azimuths[1:])))
