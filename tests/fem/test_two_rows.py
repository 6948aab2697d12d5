"""Two loaded bands on one raceway: what each answers to itself, and to the other."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Elastic, ImpossiblePart, MeshSize, OuterRing, PlanetGear, Resolution, RingOnShaft
from fem.condense import HARMONICS, condense_in_process
from fem.parts.boundary_conditions import LineForce

STEEL = Elastic(youngs_modulus=206e9, poisson_ratio=0.3)
LENGTH, DISTANCE, Z = 8e-3, 12e-3, 12
FAIR = MeshSize(order=5, size=5e-3, raceway_size=1.5e-3)
ONE_ROW = 2 * np.pi * np.arange(Z) / Z
AZIMUTHS = np.concatenate([ONE_ROW, ONE_ROW + 0.2])  # a second row that is ahead of the first
RING = OuterRing(raceway_diameter=75e-3, thickness=5e-3, width=26e-3, elastic=STEEL, support=ClampedFace())
PIN = RingOnShaft(
    raceway_diameter=60e-3, track_width=26e-3, rib_diameter=None, bore=50e-3, width=26e-3, shaft_bore=0.0,
    shaft_length=40e-3, ring=STEEL, shaft=STEEL,
)  # fmt: skip


def condensed(part, distance=0.0, length=LENGTH, shapes=2):
    resolution = Resolution(length=length, axial_modes=shapes, mesh_size=FAIR, row_distance=distance)
    return condense_in_process(part, HARMONICS, resolution)


@pytest.fixture(scope="module")
def ring():
    return condensed(RING, DISTANCE).at(AZIMUTHS)


def test_each_row_answers_to_itself_as_on_the_same_ring_alone(ring):
    """The ring of one row, its raceway beside the middle by where that row is."""
    for row, phi in enumerate(np.split(AZIMUTHS, 2)):
        place = (row - 0.5) * DISTANCE
        alone = condensed(replace(RING, offset=place)).at(phi)
        own = slice(row * Z, (row + 1) * Z)
        size = np.abs(alone.absolute).max()
        assert ring.absolute[own, :, own] == approx(alone.absolute, abs=2e-3 * size)


def test_rows_answer_to_each_other_alike(ring):
    """By Maxwell, and less than to themselves."""
    assert ring.absolute == approx(ring.absolute.transpose(2, 3, 0, 1), rel=1e-12)
    cross, own = ring.absolute[:Z, 0, Z:, 0], ring.absolute[Z:, 0, Z:, 0]
    assert 0.1 * np.abs(own).max() < np.abs(cross).max() < np.abs(own).max()


@pytest.mark.parametrize("part", [PIN, replace(RING, support=PlanetGear(forces=()))])
def test_rows_are_mirror_images_on_a_symmetric_part(part):
    same = np.tile(ONE_ROW, 2)
    absolute = condensed(part, DISTANCE).at(same).absolute.reshape(2, Z, 2, 2, Z, 2)
    mirrored = absolute[::-1, :, :, ::-1] * np.outer([1, -1], [1, -1])[:, None, None, :]
    assert absolute == approx(mirrored, abs=1e-3 * np.abs(absolute).max())  # its mesh is not


def test_bands_side_by_side_are_nearly_one_of_twice_the_length():
    """Under other rollers: what is left of the own one without its half-space is another thing."""
    apart = 1e-4
    two = condensed(RING, LENGTH + apart).at(np.tile(ONE_ROW, 2))
    one, others = condensed(RING, length=2 * LENGTH).at(ONE_ROW), 1 - np.eye(Z)
    by_two = two.absolute[:, 0, :, 0].reshape(2, Z, 2, Z).mean((0, 2))
    assert by_two * others == approx(one.absolute[:, 0, :, 0] * others, abs=0.01 * np.abs(by_two).max())


def test_axial_tooth_forces_bend_a_rim_with_their_couple_about_its_section():
    """Far beyond the surface the couple alone counts, and grows with the distance; in pairs they balance."""
    forces = tuple(
        LineForce(azimuth=psi, radial=0.0, tangential=0.0, axial=pull)
        for psi, pull in ((0.0, 1e3), (np.pi / 2, -1e3), (np.pi, 1e3), (-np.pi / 2, -1e3))
    )
    near, far, further = (
        condensed(replace(RING, support=PlanetGear(forces=forces, radius=radius)))
        .at(ONE_ROW)
        .initial_deviation
        for radius in (42.5e-3, 5.0, 10.0)
    )
    assert further - near == approx((further - far) * (10.0 - 42.5e-3) / 5.0, rel=1e-6)
    assert np.abs(far[:, 0]).max() < 1e-6 * np.abs(far[:, 1]).max()  # a symmetric section twists
    assert far[0, 1] < 0 < far[3, 1]  # F_x outside of the section turns its +x end inwards


@pytest.mark.parametrize(
    ("distance", "shapes", "words"), [(20e-3, 2, "beyond the track"), (DISTANCE, 1, "axial_modes")]
)
def test_impossible_bands(distance, shapes, words):
    with pytest.raises(ImpossiblePart, match=words):
        condensed(RING, distance, shapes=shapes)


def test_axial_tooth_forces_out_of_balance_are_impossible():
    with pytest.raises(ImpossiblePart, match="move along"):
        PlanetGear(forces=(LineForce(azimuth=0.0, radial=0.0, tangential=0.0, axial=1.0),))
