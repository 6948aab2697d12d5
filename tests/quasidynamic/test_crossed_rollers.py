"""Crossed rollers: two directions of cylinders that alternate on one circle."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import ImpossiblePart, RingOperation, tapered_loads
from quasidynamic.contact.line.load_law import raceway_coefficients
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.profile import STRAIGHT, Logarithmic, Profile
from tests.quasidynamic.test_thrust_rollers import washers
from tests.reference import plain_thrust_rollers as plain

ANGLE = np.pi / 4


def crossed(closer=0.0, rollers=18, pitch=125e-3, diameter=10e-3, length=7.5e-3, profile: Profile = STRAIGHT):
    one = washers(rollers, pitch, diameter, length, profile, ANGLE)
    return replace(one, rows=(RowPlace(closer=closer), RowPlace(closer=closer, mirrored=True)))


def test_rollers_of_both_directions_alternate():
    azimuths = np.sort(crossed().azimuths)
    assert np.diff(azimuths) == approx(np.pi / 18, rel=1e-12)
    with pytest.raises(ImpossiblePart, match="40 rollers do not fit"):
        crossed(rollers=20)


def test_thrust_is_shared_evenly_by_the_rollers_of_one_direction():
    found = tapered_loads(crossed(), RingOperation(load=(6e3, 0, 0, 0, 0), displacement=(None,) * 5))
    first, second = found.loads[0].reshape(2, -1)
    assert first == approx(
        6e3 / 18 / np.sin(ANGLE), rel=1e-7
    )  # contacts begin smoothly: others have millinewtons
    assert second.max() < 1e-4


@pytest.mark.parametrize("closer", [0.0, 3e-6, -2e-6])
@pytest.mark.parametrize("load", [(6e3, 0, 2e3, 150, 0), (500, 3e3, -4e3, 60, 90), (-4e3, 0, 1e3, 0, -100)])
def test_loads_are_those_of_the_page_of_springs(closer, load):
    bearing = crossed(closer)
    found = tapered_loads(bearing, RingOperation(load=load, displacement=(None,) * 5), 20)
    coefficient = float(np.ravel(raceway_coefficients(bearing))[0])
    expected = plain.crossed(18, 125e-3, 7.5e-3, coefficient, 20, ANGLE, closer, np.array(load, float))
    for race in (0, 1):
        assert found.loads[race].reshape(2, -1) == approx(expected, abs=2e-6 * expected.max())


@pytest.mark.parametrize("seed", range(100))
def test_random_bearings_are_in_balance(seed):
    random = np.random.default_rng(seed)
    rollers, pitch = int(random.integers(8, 60)), 10 ** random.uniform(-1.4, 0.3)
    diameter = random.uniform(0.6, 0.95) * np.pi * pitch / rollers / 2
    profile = (
        Logarithmic(amplitude=random.uniform(1e-4, 6e-4) * diameter) if random.random() < 0.7 else STRAIGHT
    )
    bearing = crossed(
        random.normal(2e-4, 4e-4) * diameter,
        rollers,
        pitch,
        diameter,
        random.uniform(0.7, 0.98) * diameter,
        profile,
    )
    size = 20e6 * rollers * diameter**2 * 10 ** random.uniform(-2, 0.5)
    load = size * random.normal(size=5) * [1, 1, 1, 0.3 * pitch, 0.3 * pitch]
    speed = random.choice([0.0, 1.0]) * 10 ** random.uniform(-1, 0.5) / pitch
    x, y, z, about_y, about_z = map(float, load)
    operation = RingOperation(
        load=(x, y, z, about_y, about_z), displacement=(None,) * 5, inner_speed=float(speed)
    )
    found = tapered_loads(bearing, operation)
    sides, azimuths = np.repeat(bearing.sides, rollers), bearing.azimuths
    moments = found.slice_loads * found.slices.widths @ found.slices.centres
    inner, outer = found.loads
    axial, outwards = sides * inner * np.sin(ANGLE), inner * np.cos(ANGLE)
    arm = axial * pitch / 2 + sides * moments[0]
    left = [
        *(outer - inner - found.speeds.centrifugal_force * np.cos(ANGLE)),
        *((moments[1] - moments[0] - found.speeds.gyroscopic_moment) / diameter),
        axial.sum() - load[0], outwards @ np.sin(azimuths) - load[1], outwards @ np.cos(azimuths) - load[2],
        (arm @ np.cos(azimuths) - load[3]) / pitch, (-arm @ np.sin(azimuths) - load[4]) / pitch,
    ]  # fmt: skip
    assert np.abs(left).max() < 1e-9 * max(inner.max(), np.abs(load[:3]).max())
