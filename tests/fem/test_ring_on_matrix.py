"""A ring on a body that another program reduced to the nodes of its seat."""

import numpy as np
import pytest
from numpy.polynomial import legendre
from numpy.testing import assert_allclose
from scipy import linalg

from fem import Foundation, Housing, ImpossiblePart, MeshSize, OuterRing, ReducedBody, RigidSeat
from fem.condense import BEAM, HARMONICS, condense
from fem.parts.resolution import Resolution
from flexbearing.build import matrix_files
from tests.fem import written_matrices as write
from tests.fem.test_parts import STEEL

RADIUS, WIDTH, OFFSET = 40e-3, 14e-3, 1e-3
AZIMUTHS = 0.1 + 2 * np.pi * np.arange(7) / 7
COARSE = Resolution(length=10e-3, axial_modes=2, mesh_size=MeshSize(order=4, size=4e-3, raceway_size=1.5e-3))


def ring(support, **changes):
    sizes = {"raceway_diameter": 70e-3, "thickness": 5e-3, "width": WIDTH, "offset": OFFSET} | changes
    return OuterRing(**sizes, elastic=STEEL, support=support)


def answers(support, **changes):
    return condense(ring(support, **changes), HARMONICS, COARSE).at(AZIMUTHS)


def seat(azimuths, along):
    """Azimuths, places along the width and shares of the surface of nodes on a grid."""
    xi, weights = legendre.leggauss(along)
    phi = np.repeat(2 * np.pi * np.arange(azimuths) / azimuths, along)
    x = np.tile(xi * WIDTH / 2 - OFFSET, azimuths)
    area = np.tile(2 * np.pi * RADIUS / azimuths * WIDTH * weights / 2, azimuths)
    return np.column_stack([x, RADIUS * np.sin(phi), RADIUS * np.cos(phi)]), phi, area


def springs(per_area, azimuths=81, along=4):
    """Springs of a foundation as a matrix at nodes."""
    places, phi, area = seat(azimuths, along)
    blocks = []
    for angle, share in zip(phi, area, strict=True):
        sin, cos = np.sin(angle), np.cos(angle)
        frame = np.array([[1, 0, 0], [0, sin, cos], [0, cos, -sin]])
        blocks.append(share * frame.T @ np.diag(per_area) @ frame)
    return ReducedBody(places, linalg.block_diag(*blocks))


def largest(one, other):
    return np.abs(one - other).max() / np.abs(other).max()


@pytest.mark.slow
def test_springs_as_a_matrix_are_a_foundation():
    """All three directions, with the raceway out of the middle."""
    axial, radial, tangential = 2e12, 5e12, 1e12
    known = answers(Foundation(axial=axial, radial=radial, tangential=tangential))
    found = answers(springs((axial, radial, tangential)))
    assert largest(found.absolute, known.absolute) < 4e-3  # what lies beyond 40 harmonics
    assert largest(found.translation, known.translation) < 1e-3
    assert_allclose(found.support_stiffness, known.support_stiffness, rtol=2e-4)


@pytest.mark.slow
def test_more_harmonics_come_nearer_to_the_foundation(monkeypatch):
    known = answers(Foundation(axial=2e12, radial=5e12, tangential=1e12))
    errors = []
    for around in (10, 20, 40):
        monkeypatch.setattr("fem.section.ring_on_matrix.AROUND", around)
        errors.append(largest(answers(springs((2e12, 5e12, 1e12))).absolute, known.absolute))
    assert errors[0] > 2 * errors[1] > 4 * errors[2]


@pytest.mark.slow
def test_springs_that_are_taken_away_again_do_not_matter(monkeypatch):
    body = springs((2e12, 5e12, 1e12), azimuths=17, along=3)
    usual = answers(body)
    monkeypatch.setattr("fem.section.ring_on_matrix.SHARE", 1e-2)
    assert largest(answers(body).absolute, usual.absolute) < 2e-3


def test_rigid_body_on_a_spring_adds_its_translation_to_a_rigid_seat():
    r"""Nodes that move together along y and z alone: :math:`C = C_{seat} + \cos(\varphi_i - \varphi_j)/k`."""
    places, _, _ = seat(25, 3)
    count, spring, stiff = len(places), 1e8, 1e13
    along = np.stack([np.tile(axis, count) / np.sqrt(count) for axis in np.eye(3)[1:]], axis=1)
    together = along @ along.T
    body = ReducedBody(places, stiff * (np.eye(3 * count) - together) + spring / count * together)
    found, known = answers(body), answers(RigidSeat())
    moved = np.zeros_like(known.absolute)
    moved[:, 0, :, 0] = np.cos(AZIMUTHS[:, None] - AZIMUTHS) / spring
    # own terms differ by 1 %: between 25 nodes the ring is not held as on a rigid seat
    assert_allclose(found.absolute, known.absolute + moved, rtol=0, atol=2e-2 * np.abs(moved).max())
    assert_allclose(found.support_stiffness, 1 / (1 / spring + 1 / known.support_stiffness), rtol=1e-4)


@pytest.mark.slow
def test_turned_body_gives_turned_answers():
    """A body that is stiff on one side: azimuths count from z towards y."""
    places, phi, _ = seat(25, 3)
    body = springs((2e12, 5e12, 1e12), azimuths=25, along=3)
    stiff = np.repeat(1 + 0.5 * np.cos(phi - 0.3), 3)
    uneven = ReducedBody(places, np.sqrt(np.outer(stiff, stiff)) * body.stiffness)
    turn = 0.7
    c, s = np.cos(turn), np.sin(turn)
    rotation = np.array([[1, 0, 0], [0, c, s], [0, -s, c]])  # (x, y, z) to azimuths larger by the turn
    every = np.kron(np.eye(len(places)), rotation)
    turned = ReducedBody(places @ rotation.T, every @ uneven.stiffness @ every.T)
    here = condense(ring(uneven), HARMONICS, COARSE).at(AZIMUTHS).absolute
    there = condense(ring(turned), HARMONICS, COARSE).at(AZIMUTHS + turn).absolute
    assert_allclose(there, here, rtol=0, atol=1e-6 * np.abs(here).max())
    even = condense(ring(body), HARMONICS, COARSE).at(AZIMUTHS).absolute
    assert largest(here, even) > 0.02


@pytest.fixture(scope="module")
def tube():
    """Housing of 8 mm around the ring, in mm and N, of quadratic tetrahedra."""
    mesh = write.meshed_tube(1e3 * RADIUS, 1e3 * RADIUS + 8, 1e3 * WIDTH, 4.0, middle=-1e3 * OFFSET)
    return write.stiffness(mesh, STEEL)


@pytest.fixture(scope="module")
def in_one_piece():
    """The housing meshed with the ring."""
    return answers(Housing(thickness=8e-3, width=WIDTH, elastic=STEEL, support=RigidSeat()))


@pytest.mark.slow
def test_the_housing_is_no_rigid_seat(in_one_piece):
    assert largest(answers(RigidSeat()).absolute, in_one_piece.absolute) > 0.2


def written_and_read(tube, program, folder):
    """Stiffness and places of its nodes, through the files of another program."""
    places, unknowns, matrix = tube
    numbers = np.arange(1, len(places) + 1)
    ways = {"sti": write.calculix, "mtx": write.abaqus, "dmig": write.nastran}
    nodes = (write.grid_bdf if program == "dmig" else write.nodes_inp)(folder / "m.inp", places, numbers)
    stiffness = matrix_files.stiffness(ways[program](folder / f"k.{program}", unknowns, matrix))
    return stiffness, *matrix_files.places(nodes)


@pytest.mark.slow
@pytest.mark.parametrize("program", ["sti", "mtx", "dmig"])
def test_a_solid_is_read_as_it_was_written(tube, program, tmp_path):
    places, unknowns, matrix = tube
    stiffness, there, read_places = written_and_read(tube, program, tmp_path)
    assert_allclose(read_places[np.argsort(there)], places, rtol=0, atol=1e-8 * np.abs(places).max())
    order = np.lexsort((stiffness.motions, stiffness.nodes))
    as_written = np.lexsort(unknowns.T[::-1])
    np.testing.assert_array_equal(
        np.column_stack([stiffness.nodes, stiffness.motions])[order], unknowns[as_written]
    )
    difference = stiffness.matrix[order][:, order] - matrix[as_written][:, as_written]
    assert abs(difference).max() < 1e-9 * abs(matrix).max()


@pytest.mark.slow
def test_own_solid_written_and_read_back_is_the_housing(tube, in_one_piece, tmp_path):
    """A housing meshed here, through the files of another program, beside that of one piece with the ring."""
    stiffness, there, places = written_and_read(tube, "mtx", tmp_path)
    on_seat = np.hypot(*places[:, 1:].T) < 1e3 * RADIUS + 0.1
    body = ReducedBody(1e-3 * places[on_seat], 1e3 * stiffness.at(there[on_seat]))
    found = answers(body)
    assert_allclose(found.support_stiffness, in_one_piece.support_stiffness, rtol=0.01)
    # elements of half the thickness of the housing
    assert largest(found.absolute, in_one_piece.absolute) < 0.04


WRONG = {
    "seven azimuths": (lambda body: ReducedBody(*few(7)), "7 azimuths"),
    "a body that turns freely": (lambda body: springs((2e12, 5e12, 0.0)), "can move or turn without force"),
    "another size": (lambda body: ReducedBody(body.places, body.stiffness[:3, :3]), "does not fit"),
}


def few(count):
    body = springs((2e12, 5e12, 1e12), azimuths=count)
    return body.places, body.stiffness


@pytest.mark.parametrize(("make", "complaint"), WRONG.values(), ids=WRONG)
def test_bodies_that_hold_no_ring_are_refused(make, complaint):
    with pytest.raises(ImpossiblePart, match=complaint):
        make(springs((2e12, 5e12, 1e12), azimuths=9))


def test_nodes_away_from_the_ring_are_refused():
    body = springs((2e12, 5e12, 1e12), azimuths=9)
    for changes in ({"thickness": 8e-3}, {"width": 10e-3, "offset": 0.0}):
        with pytest.raises(ImpossiblePart, match="must be that surface"):
            answers(body, **changes)
    with pytest.raises(ImpossiblePart, match="only as HARMONICS"):
        condense(ring(body), BEAM, COARSE)
