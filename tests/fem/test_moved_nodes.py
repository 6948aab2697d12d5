"""Meshes whose nodes are moved to another part of the same kind."""

from dataclasses import replace

import ngsolve as ngs
import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Foundation, Housing, ImpossiblePart, MeshSize, OuterRing, Resolution
from fem.condense import HARMONICS, SMEARED, condense_in_process
from fem.mesh import axial_section, section_mesh
from fem.mesh.half_pitch import half_pitch
from fem.mesh.moved_nodes import Faces, move_nodes
from fem.parts.resolution import Shape
from fem.squirrel_cage.half_pitch_cage import cage_responses
from fem.squirrel_cage.moved_cage import near_responses
from fem.stages import stages, unheard
from tests.fem.test_half_pitch import STUMPS
from tests.fem.test_parts import SHAFT, STEEL

L = 5e-3
COARSE = MeshSize(order=2, size=3e-3, raceway_size=1.2e-3)
SECTION = MeshSize(order=3, size=4e-3, raceway_size=1.5e-3)
RING = OuterRing(
    raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL,
    support=Housing(thickness=8e-3, width=14e-3, elastic=STEEL),
)  # fmt: skip
ON_SPRINGS = replace(RING, support=Foundation(axial=1e11, radial=3e11, tangential=1e11))
CAGES = {
    "plain": STUMPS,
    "fillets": replace(STUMPS, bar_length=6e-3, bar_thickness=1.6e-3, fillet=0.4e-3),
    "collars at both ends": replace(STUMPS, two_sided=True, collar_length=1e-3, collar_thickness=4e-3),
    "raceway aside": replace(STUMPS, offset=0.3e-3),
}  # fmt: skip
LENGTHS = (
    "raceway_diameter", "thickness", "width", "bar_width", "bar_thickness", "bar_length", "flange_length",
    "fillet", "collar_length", "collar_thickness", "offset",
)  # fmt: skip


def changed(part, share):
    """A part with every length of it changed by another share."""
    names = [name for name in LENGTHS if getattr(part, name)]
    return replace(part, **{n: getattr(part, n) * (1 + share * (1 + k % 3)) for k, n in enumerate(names)})


def volumes(mesh):
    """Of the bodies, and areas of the faces that loads and clamps need."""
    bodies = ngs.Integrate(ngs.CF(1), mesh, region_wise=True)
    faces = [
        ngs.Integrate(ngs.CF(1) * ngs.ds(name), mesh) for name in ("raceway", "clamped", "cut", "middle")
    ]
    return np.array([*bodies, *faces])


@pytest.mark.parametrize(
    "cage",
    [
        pytest.param(cage, id=name, marks=[pytest.mark.slow] * (name != "plain"))
        for name, cage in CAGES.items()
    ],
)
def test_moved_nodes_fill_the_other_cage(cage):
    other, band = changed(cage, 8e-3), 1.02 * L
    before, own = (volumes(half_pitch(each, size, COARSE)) for each, size in ((cage, L), (other, band)))
    moved = volumes(half_pitch(other, band, COARSE, nodes_of=Shape(part=cage, length=L)))
    assert moved - before == approx(own - before, abs=0.01 * np.abs(own - before).max())
    assert np.abs(own - before).max() > 1e-3 * before.max()


def condensed(part, length, mesh, discretisation=HARMONICS, nodes_of=None):
    """Condense on a mesh of its own, or on moved nodes."""
    resolution = Resolution(length=length, axial_modes=2, mesh_size=mesh, harmonics=8, nodes_of=nodes_of)
    return condense_in_process(part, discretisation, resolution)


@pytest.mark.parametrize(
    ("part", "mesh", "discretisation"),
    [
        pytest.param(STUMPS, COARSE, HARMONICS, id="half a pitch", marks=pytest.mark.slow),
        pytest.param(STUMPS, SECTION, SMEARED, id="smeared bars"),
        pytest.param(RING, SECTION, HARMONICS, id="ring in a housing"),
    ],
)
def test_part_of_twice_the_size_is_twice_as_stiff(part, mesh, discretisation):
    twice = {name: 2 * getattr(part, name) for name in LENGTHS if getattr(part, name, 0.0)}
    if part is RING:
        twice["support"] = replace(RING.support, thickness=16e-3, width=28e-3)
    small = condensed(part, L, mesh, discretisation)
    large = condensed(replace(part, **twice), 2 * L, mesh, discretisation, Shape(part=part, length=L))
    scale = np.abs(small.response).max()
    assert 2 * large.response == approx(small.response, rel=1e-8, abs=1e-9 * scale)


@pytest.mark.parametrize(
    ("part", "name", "mesh"),
    [
        pytest.param(STUMPS, "bar_width", COARSE, id="bars", marks=pytest.mark.slow),
        pytest.param(SHAFT, "rib_diameter", SECTION, id="ribs", marks=pytest.mark.slow),
        pytest.param(ON_SPRINGS, "thickness", SECTION, id="ring on springs"),
    ],
)
def test_answers_are_smooth_in_a_dimension(part, name, mesh):
    """Five places within half a percent lie on a parabola."""
    shares, nodes, size = np.linspace(-5e-3, 5e-3, 5), Shape(part=part, length=L), getattr(part, name)
    parts = [replace(part, **{name: size * (1 + share)}) for share in shares]
    answers = np.array([condensed(each, L, mesh, nodes_of=nodes).response.ravel() for each in parts])
    parabola = np.polynomial.polynomial.polyfit(shares, answers, 2)
    left = answers - np.polynomial.polynomial.polyval(shares, parabola).T
    assert np.abs(left).max() <= 1e-6 * np.abs(answers).max()
    assert np.abs(answers[-1] - answers[0]).max() > 1e-4 * np.abs(answers).max()


@pytest.mark.slow
def test_slope_on_moved_nodes_is_that_of_meshes_of_their_own():
    """Axial sections of a high order have answers that meshes hardly change."""
    fine = MeshSize(order=5, size=4e-3, raceway_size=1.5e-3)
    thin, thick = (replace(ON_SPRINGS, thickness=share * ON_SPRINGS.thickness) for share in (0.99, 1.01))
    nodes = Shape(part=ON_SPRINGS, length=L)
    moved, own = (
        condensed(thick, L, fine, nodes_of=where).response - condensed(thin, L, fine, nodes_of=where).response
        for where in (nodes, None)
    )
    assert moved[:, 0] == approx(own[:, 0], abs=2e-3 * np.abs(own[:, 0]).max())


def test_clamped_ring_with_thicker_wall_keeps_its_end_face():
    ring = replace(RING, support=ClampedFace())
    bodies, others = (axial_section.sections(each, L) for each in (replace(ring, thickness=4e-3), ring))
    mesh = section_mesh.meshed(bodies, SECTION, others)
    assert ngs.Integrate(ngs.CF(1) * ngs.ds("clamped"), mesh) == approx(4.0, rel=1e-12)
    assert ngs.Integrate(ngs.CF(1), mesh) == approx(40.0, rel=1e-12)


def test_faces_that_would_come_apart_are_refused():
    mesh = section_mesh.meshed(axial_section.sections(ON_SPRINGS, L), SECTION)
    together, apart = (Faces(x=(0.0, x), radii=(1.0, 2.0)) for x in (0.0, 1e-4))
    for before, after in ((together, apart), (apart, together)):
        with pytest.raises(ImpossiblePart, match="come apart"):
            move_nodes(mesh, before, after)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("order", [1, 2])
def test_known_fields_of_a_cage_give_its_own_answers(order):
    """At nodes that stay; elements of order 1 have fewer unknowns on the raceway than there are loads."""
    size = MeshSize(order=order, size=5e-3, raceway_size=5e-3)
    resolution = Resolution(length=L, axial_modes=4, mesh_size=size, nodes_of=Shape(part=STUMPS, length=L))
    stage, _ = stages(unheard)
    own, known = (answers(STUMPS, resolution, 20, stage) for answers in (cage_responses, near_responses))
    assert known.response == approx(own.response, rel=0, abs=1e-10 * np.abs(own.response).max())
    bars, in_bars = known.bar_response.response, own.bar_response.response
    assert bars == approx(in_bars, rel=0, abs=1e-10 * np.abs(in_bars).max())


@pytest.mark.slow
@pytest.mark.parametrize("cage", [pytest.param(cage, id=name) for name, cage in CAGES.items()])
def test_answers_by_known_fields_are_right_to_first_order(cage):
    """Twice the change, four times the error; differences about the cage have no error of second order."""
    nodes, size = Shape(part=cage, length=L), COARSE
    exact = Resolution(length=L, axial_modes=2, mesh_size=size, nodes_of=nodes)
    answers = {
        (share, first_order): condense_in_process(
            changed(cage, share), HARMONICS, replace(exact, first_order=first_order)
        )
        for share in (-1e-4, 1e-4, 2e-4)
        for first_order in (True, False)
    }
    for read in (lambda a: a.response, lambda a: a.bar_response.response, lambda a: a.short_waves):
        left = {
            share: read(answers[share, True]) - read(answers[share, False]) for share in (-1e-4, 1e-4, 2e-4)
        }
        change = np.abs(read(answers[1e-4, False]) - read(answers[-1e-4, False])).max()
        assert np.abs(left[1e-4] - left[-1e-4]).max() < 1e-4 * change
        assert 0 < np.abs(left[1e-4]).max() < 1e-2 * change
        assert left[2e-4] == approx(4 * left[1e-4], abs=0.05 * np.abs(left[2e-4]).max())


def test_known_fields_need_a_mesh_that_is_moved():
    with pytest.raises(ImpossiblePart, match="nodes_of"):
        Resolution(length=L, mesh_size=COARSE, first_order=True)
