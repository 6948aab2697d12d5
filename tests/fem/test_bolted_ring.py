"""Rings with gothic grooves on a bolted face: what their arches yield to balls at equal pitches."""

from dataclasses import replace
from functools import cache

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx
from scipy.integrate import dblquad

from fem import Elastic, ImpossiblePart, MeshSize, Patches
from fem.half_space.groove_line import line_answers, line_harmonics
from fem.half_space.load_patch import half_space
from fem.mesh.bolted_ring_section import section
from fem.parts.bolted_ring import BoltedGrooveRing
from fem.parts.boundary_conditions import FreeMotions
from fem.section.bolted_ring import body_of, line_forces
from fem.section.rigid_body_modes import responses
from tests.fem.condensed import by_harmonics

STEEL = Elastic(youngs_modulus=210e9, poisson_ratio=0.3)
ANGLE, LENGTH, BALLS = np.radians(45.0), 4e-3, 12
RING = BoltedGrooveRing(
    race="outer",
    pitch_diameter=150e-3,
    ball_diameter=20e-3,
    groove_radius=10.5e-3,
    contact_angle=ANGLE,
    groove_end=np.radians(75.0),
    far_diameter=200e-3,
    width=45e-3,
    face_distance=25e-3,
    face_side=1,
    elastic=STEEL,
)
INNER = replace(RING, race="inner", far_diameter=100e-3)
FAIR = MeshSize(order=4, size=10e-3, raceway_size=2e-3)
USUAL = MeshSize(order=5, size=10e-3, raceway_size=2e-3)
MIRROR = np.diag([1.0, -1.0])  # of (outward, axial)


@cache
def yields(ring=RING, balls=BALLS, length=LENGTH, mesh=FAIR, harmonics=None):
    """Compliance (Z, 4, 4)."""
    return by_harmonics(ring, length, 1, mesh, harmonics).at(balls).reshape(balls, 4, 4)


def along_normals(ring):
    """Axes (4, 4) into the arches at +x and -x, and along them."""
    axes = np.zeros((4, 4))
    for arch, side in enumerate((ring.outward, -ring.outward)):
        axes[2 * arch : 2 * arch + 2, 2 * arch : 2 * arch + 2] = [
            [np.cos(ANGLE), side * np.sin(ANGLE)], [-np.sin(ANGLE), side * np.cos(ANGLE)],
        ]  # fmt: skip
    return axes


@pytest.mark.sampled(2)
@pytest.mark.parametrize("ring", [RING, INNER], ids=["outer", "inner"])
def test_work_is_the_same_in_either_order_of_loading(ring):
    row = yields(ring)
    assert row == approx(row.swapaxes(1, 2), rel=1e-12, abs=1e-12 * np.abs(row).max())
    assert row[1:] == approx(row[:0:-1], rel=1e-9, abs=1e-9 * np.abs(row).max())  # around either way


@pytest.mark.slow
def test_ring_bolted_on_its_other_face_is_the_mirror_image():
    row, seen = yields().reshape(-1, 2, 2, 2, 2), yields(replace(RING, face_side=-1)).reshape(-1, 2, 2, 2, 2)
    swapped = np.einsum("ab,zibjc,cd->ziajd", MIRROR, seen[:, ::-1, :, ::-1], MIRROR)
    assert swapped == approx(row, rel=1e-5, abs=1e-3 * np.abs(row).max())  # another mesh


def test_ring_with_the_indentation_of_its_contacts_yields_to_every_force():
    """Without the indentation it does not: a half-space that ends at a bolted face yields less."""
    patch = Patches(azimuths=(0.0,), length=LENGTH, axial_modes=2, width=0.5e-3)
    lowest = np.linalg.eigvalsh(np.fft.fft(yields(), axis=0).real).min()
    assert -half_space(patch, STEEL)[0, 0] < lowest < 0


@pytest.mark.slow
def test_neighbours_feel_the_whole_ring():
    """Nothing is left out between balls: there the harmonics themselves have a sum if they fade out."""
    body = body_of(RING, LENGTH, FAIR)
    W = responses(body, FreeMotions(), line_forces(body, LENGTH), 90) / (2 * np.pi)
    n = np.arange(91)
    fading = (1 + np.cos(np.pi * n / 91)) / 2
    weight = np.where(n > 0, 2.0, 1.0) * fading * np.cos(2 * np.pi * n / BALLS)
    assert np.tensordot(weight, W, axes=1) == approx(yields()[1], abs=0.02 * np.abs(yields()[1]).max())


def test_arch_next_to_the_bolted_face_is_the_stiffer_one():
    row = along_normals(RING) @ yields().sum(axis=0) @ along_normals(RING).T
    assert row[0, 0] < row[2, 2]


@pytest.mark.slow
def test_compliance_falls_with_stiffness():
    hard = replace(RING, elastic=replace(STEEL, youngs_modulus=420e9))
    assert 2 * yields(hard) == approx(yields(), rel=1e-6, abs=1e-9 * np.abs(yields()).max())


def test_stiff_ring_on_springs_moves_as_one():
    """By F / (k A) along the axis, and likewise across under radial forces like cos(phi)."""
    k_n, k_s = 2e12, 1e12
    ring = replace(
        RING, elastic=replace(STEEL, youngs_modulus=1e15), normal_stiffness=k_n, shear_stiffness=k_s
    )
    row, area = yields(ring), np.pi / 4 * (ring.far_diameter**2 - land(ring) ** 2)
    for arch in (1, 3):  # axial forces on either one
        assert row.sum(0)[arch, 1::2] == approx(BALLS / (k_n * area), rel=1e-3)
    # across: translation and tilt of a rigid ring by outward forces cos(phi) in the plane of one arch
    lever = ring.face_distance - ring.ball_diameter / 2 * np.sin(ANGLE)
    inertia = np.pi / 64 * (ring.far_diameter**4 - land(ring) ** 4)
    wave = np.cos(2 * np.pi * np.arange(BALLS) / BALLS) @ row[:, 0, 0]
    assert wave == approx(BALLS / 2 * (1 / (k_s * area) + lever**2 / (k_n * inertia)), rel=1e-3)


def land(ring):
    return ring.pitch_diameter + 2 * ring.outward * ring.at(ring.groove_end)[1]


def test_uniform_load_all_around_is_that_of_an_axisymmetric_section():
    """Written again with plain triangles: strains u_r,r, u_r/r, u_x,x, shear, on the same outline."""
    body = body_of(RING, LENGTH, FAIR)
    forces = line_forces(body, LENGTH)
    found = forces.T @ body.stiffness.solve(0, forces)

    face = drawn(RING)
    face.edges.Max(occ.X).name = "bolted"
    mesh = ngs.Mesh(occ.OCCGeometry(face, dim=2).GenerateMesh(maxh=2.0))
    mesh.Curve(4)
    space = ngs.VectorH1(mesh, order=4, dirichlet="bolted")
    u, v = space.TnT()
    G, lame = 210e9 / 2.6, 210e9 * 0.3 / 1.3 / 0.4

    def strain(w):
        d = ngs.Grad(w)
        return d[0, 0], d[1, 1], w[1] / ngs.y, (d[0, 1] + d[1, 0]) / np.sqrt(2)

    e, f = strain(u), strain(v)
    work = 2 * G * sum(a * b for a, b in zip(e, f, strict=True)) + lame * sum(e[:3]) * sum(f[:3])
    K = ngs.BilinearForm(work * ngs.y * 1e-3 * ngs.dx).Assemble()
    inverse = K.mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    loads = []
    for side in (1, -1):
        for component in (1, 0):
            on_line = near(RING, ngs.x, ngs.y - 75.0, side) / (LENGTH * 1e3)
            loads.append(ngs.LinearForm(on_line * v[component] * ngs.ds).Assemble().vec)
    plain = np.array([[ngs.InnerProduct(p, inverse * q) for q in loads] for p in loads])
    assert found == approx(plain, rel=2e-3, abs=1e-3 * np.abs(plain).max())


def near(ring, x, y, side):
    """One on the loaded line of an arch, of places in millimetres from the ball centre, else zero."""
    x0, y0 = -1e3 * ring.offset * np.array([side * np.sin(ANGLE), np.cos(ANGLE)])
    distance = ngs.sqrt((x - x0) ** 2 + (y - y0) ** 2)
    along = side * (x - x0) * np.cos(ANGLE) - (y - y0) * np.sin(ANGLE)  # r sin of the angle from the middle
    on_arch = ngs.IfPos(1e-2 - ngs.sqrt((distance - 1e3 * ring.groove_radius) ** 2), 1.0, 0.0)
    half = 1e3 * ring.groove_radius * np.sin(LENGTH / 2 / ring.groove_radius)
    return on_arch * ngs.IfPos(half**2 - along**2, 1.0, 0.0) * ngs.IfPos(side * x, 1.0, 0.0)


def drawn(ring):
    """The outline with its arcs, in millimetres."""
    outline = section(ring, LENGTH)
    pen = occ.WorkPlane()
    pen.MoveTo(*(1e3 * c for c in outline.corners[0][:2]))
    for number in [*range(1, len(outline.corners)), 0]:
        to = [1e3 * c for c in outline.corners[number][:2]]
        if number in outline.bends:
            pen.ArcTo(*to, occ.gp_Vec2d(*outline.bends[number]))
        else:
            pen.LineTo(*to)
    return pen.Face()


def test_arches_touch_the_ball_where_they_are_loaded():
    for ring in (RING, INNER):
        names = [corner[2] for corner in section(ring, LENGTH).corners]
        corners = np.array([corner[:2] for corner in section(ring, LENGTH).corners])
        for number in [k for k, name in enumerate(names) if name == "raceway"]:
            for x, r in corners[number - 1 : number + 1]:
                y = ring.outward * (r - ring.pitch_diameter / 2)
                centre = -ring.offset * np.array([np.sign(x) * np.sin(ANGLE), np.cos(ANGLE)])
                assert np.hypot(x - centre[0], y - centre[1]) == approx(ring.groove_radius, rel=1e-12)
                assert np.arctan2(abs(x - centre[0]), y - centre[1]) == approx(ANGLE, abs=0.2)
        assert names.count("clamped") == 1


@pytest.mark.parametrize(
    ("mesh", "harmonics", "allowed"),
    [
        pytest.param(MeshSize(order=6, size=5e-3, raceway_size=1e-3), 123, 2e-3, marks=pytest.mark.slow),
        pytest.param(FAIR, 65, 1e-2, marks=pytest.mark.slow),
    ],
    ids=["finer mesh", "fewer harmonics"],
)
def test_own_terms_depend_little_on_the_numerics(mesh, harmonics, allowed):
    usual, other = yields(mesh=USUAL if harmonics > 100 else FAIR), yields(mesh=mesh, harmonics=harmonics)
    assert np.abs(other - usual).max() < allowed * np.abs(usual).max()


@pytest.mark.slow
def test_length_of_the_line_matters_little_along_the_normals():
    """What a half-space yields more under a shorter line belongs to the contact."""
    axes = along_normals(RING)
    rows = [axes @ yields(length=length)[0] @ axes.T for length in (3e-3, LENGTH)]
    normal = np.array([row[::2, ::2] for row in rows])
    assert np.abs(normal[1] - normal[0]).max() < 0.02 * np.abs(normal).max()
    local = half_space(Patches(azimuths=(0.0,), length=3e-3, axial_modes=2, width=0.3e-3), STEEL)[0, 0]
    assert np.abs(normal[1] - normal[0]).max() < 0.02 * local


def test_forces_along_a_half_space_move_lines_as_the_integral_says():
    """Cerruti: (1 + nu)/(pi E) [(1 - nu)/r + nu x^2/r^3], averaged over both lines."""
    R, length, phi = 80e-3, 4e-3, 0.05
    s = 2 * R * np.sin(phi / 2)

    def kernel(x, y):
        r = np.hypot(s, x - y)
        return (0.7 / r + 0.3 * (x - y) ** 2 / r**3) / length**2

    mean = dblquad(kernel, 0, length, 0, length, epsabs=1e-9)[0]
    along = line_answers(np.array([phi]), R, length, STEEL)[0, 1]
    assert along == approx(1.3 / (np.pi * 210e9) * mean, rel=1e-8)
    n, far = np.arange(-400, 401), np.array([0.4])
    series = ((1 - np.abs(n) / 401) * np.cos(n * far)) @ line_harmonics(
        n, R, length, STEEL
    )  # mean of partial sums
    assert series == approx(line_answers(far, R, length, STEEL)[0], rel=1e-2)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"groove_radius": 9e-3}, "groove_radius"),
        ({"far_diameter": 160e-3}, "far_diameter"),
        ({"width": 30e-3}, "width"),
        ({"face_distance": 5e-3}, "face_distance"),
        ({"groove_end": 0.5}, "groove_end"),
        ({"contact_angle": 1.6}, "contact_angle"),
        ({"shear_stiffness": 1e12}, "shear_stiffness"),
        ({"normal_stiffness": -1.0}, "normal_stiffness"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_ring_that_cannot_be_is_refused(change, told):
    with pytest.raises(ImpossiblePart, match=told):
        replace(RING, **change)


def test_line_longer_than_its_arch_is_refused():
    with pytest.raises(ImpossiblePart, match="leaves the arch"):
        section(RING, 12e-3)


@pytest.mark.slow
def test_all_balls_together_are_one_pitch_of_the_solid():
    """Half a pitch in space between its mirror planes; the ball presses on a patch of finite width."""
    patch = Patches(azimuths=(0.0,), length=LENGTH, axial_modes=2, width=0.8e-3)
    axes = along_normals(RING)
    found = (axes @ yields(mesh=USUAL).sum(axis=0) @ axes.T)[[0, 0], [0, 2]]
    (own, other), local = half_pitch(patch), half_space(patch, STEEL)[0, 0]
    assert own - local == approx(found[0], abs=2e-3 * local)
    assert other == approx(found[1], rel=0.01)


def half_pitch(patch):
    """Displacement into the arches at +x and at -x per force of every ball into the one at +x [m/N]."""
    mesh, turn = half_pitch_mesh(), np.pi / BALLS
    space = ngs.VectorH1(mesh, order=3, dirichlet="bolted", dirichlety="middle")
    u, v = space.TnT()
    G, lame = 210e9 / 2.6, 210e9 * 0.3 / 1.3 / 0.4
    e, f = ngs.Sym(ngs.Grad(u)), ngs.Sym(ngs.Grad(v))
    across = ngs.CF((0, np.cos(turn), -np.sin(turn)))
    K = ngs.BilinearForm(space, symmetric=True)
    K += 1e-3 * (2 * G * ngs.InnerProduct(e, f) + lame * ngs.Trace(e) * ngs.Trace(f)) * ngs.dx
    K += 10 * G * (u.Trace() * across) * (v.Trace() * across) * ngs.ds(definedon="between")  # nearly rigid
    loads = [ngs.LinearForm(pressed(patch, side, v) * ngs.ds("free", bonus_intorder=8)) for side in (1, -1)]
    with ngs.TaskManager():
        answer = (
            K.Assemble().mat.Inverse(space.FreeDofs(), inverse="sparsecholesky") * loads[0].Assemble().vec
        )
        return [2 * ngs.InnerProduct(load.Assemble().vec, answer) for load in loads]


def pressed(patch, side, v):
    """Virtual work of a unit force on the patch, a Gaussian along the arc, into an arch."""
    radius, width = ngs.sqrt(ngs.y**2 + ngs.z**2), 1e3 * patch.width
    arc = radius * ngs.atan2(ngs.y, ngs.z)
    gauss = ngs.exp(-((arc / width) ** 2) / 2) / (width * np.sqrt(2 * np.pi))
    into = ngs.CF((side * np.sin(ANGLE), np.cos(ANGLE) * ngs.y / radius, np.cos(ANGLE) * ngs.z / radius))
    return gauss * near(RING, ngs.x, radius - 75.0, side) / (1e3 * LENGTH) * (into * v.Trace())


def half_pitch_mesh():
    """From the plane of a ball, y = 0, to the one half way to the next."""
    axis, turn = occ.Axis((0, 0, 0), occ.X), np.pi / BALLS
    body = drawn(RING).Rotate(axis, 90).Revolve(axis, -np.degrees(turn))
    for face in body.faces:
        face.name = "free"
        if abs(face.center.x - 25.0) < 1e-6:
            face.name = "bolted"
        elif abs(face.center.y) < 1e-6:
            face.name = "middle"
        elif abs(face.center.y * np.cos(turn) - face.center.z * np.sin(turn)) < 1e-6:
            face.name = "between"
    contact = 10 * np.sin(ANGLE), 0.0, 75 + 10 * np.cos(ANGLE)
    for edge in body.edges:
        if np.linalg.norm(np.subtract((*edge.center,), contact)) < 0.1:
            edge.maxh = 0.4
    mesh = ngs.Mesh(occ.OCCGeometry(body).GenerateMesh(maxh=5.0, grading=0.4))
    return mesh.Curve(3)
