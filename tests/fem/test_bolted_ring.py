"""Rings with grooves of two arcs on a bolted face: how they give way to patches at stations of both arcs."""

from dataclasses import replace
from functools import cache

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx

from fem import Elastic, Groove, ImpossiblePart, MeshSize, Resolution, Stations
from fem.condense import HARMONICS, condense_in_process
from fem.half_space.gaussian_patch import patch_answers
from fem.mesh.axial_section import sections
from fem.parts.bolted_ring import BoltedRing
from fem.section.revolved_body import station_modes
from fem.section.rigid_body_modes import body_of
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, shape_of

BALLS, RADIUS, OFFSET, END, WIDTH = 12, 10.5e-3, 0.5e-3, np.radians(75.0), 1.2e-3
LAME, SHEAR = 210e9 * 0.3 / 1.3 / 0.4, 210e9 / 2.6
FAIR = MeshSize(order=3, size=12e-3, raceway_size=1.2e-3)
FINE = MeshSize(order=4, size=10e-3, raceway_size=1e-3)
INSIDE = tuple(np.radians([28.0, 38.0, 48.0]))  # four widths of a patch and more from the ends of an arc


def bolted(race="outer"):
    """Ring with arcs whose centres are at 45 degrees, bolted at +x."""
    outward = 1 if race == "outer" else -1
    aside = OFFSET * np.sqrt(0.5)
    groove = Groove(radius=RADIUS, centre_radius=75e-3 - outward * aside, aside=aside)
    return BoltedRing(
        race=race,
        groove=groove,
        raceway_diameter=2 * (groove.centre_radius + outward * RADIUS * np.cos(END)),
        far_diameter=200e-3 if race == "outer" else 100e-3,
        width=45e-3,
        face_distance=25e-3,
        face_side=1,
        elastic=Elastic(youngs_modulus=210e9, poisson_ratio=0.3),
    )


RING, INNER = bolted(), bolted("inner")
both_rings = pytest.mark.parametrize("ring", [RING, INNER], ids=["outer", "inner"])


@cache
def condensed(ring=RING, angles=INSIDE, mesh=FAIR):
    stations = Stations(angles=angles, width=WIDTH)
    resolution = Resolution(length=across(ring), mesh_size=mesh, stations=stations)
    return condense_in_process(ring, HARMONICS, resolution)


def across(ring):
    """Width of the groove."""
    return ring.groove.width(ring.raceway_diameter / 2, ring.outward)


def around(ring=RING, angles=INSIDE, mesh=FAIR, balls=BALLS):
    """Displacements (Z, 2, K) of stations at balls by forces on those of the first ball (2, K) [m/N]."""
    absolute = condensed(ring, angles, mesh).at(2 * np.pi * np.arange(balls) / balls).absolute
    return absolute.reshape(balls, 2, len(angles), balls, 2, len(angles))[:, :, :, 0]


def sides(ring, angles=INSIDE):
    """Normals (2, K, 2) away from the axis, axial and radial, and centres (2, 2) of both arcs."""
    side = np.array([1.0, -1.0])
    normals = np.stack(np.broadcast_arrays(side[:, None] * np.sin(angles), np.cos(angles)), axis=-1)
    return normals, np.stack([-ring.outward * side * ring.groove.aside, 2 * [ring.groove.centre_radius]], 1)


@both_rings
def test_work_is_the_same_in_either_order_of_loading(ring):
    response, row = condensed(ring).response, around(ring)
    assert response == approx(response.swapaxes(1, 2), abs=1e-9 * np.abs(response).max())
    assert row[1:] == approx(row[:0:-1], abs=1e-12 * np.abs(row).max())  # around either way
    assert np.linalg.eigvalsh(response[:50]).min() > 0


def test_ring_with_the_half_space_of_its_contacts_gives_way_to_every_force():
    """Without the half-space it does not: one that ends at a bolted face gives way less."""
    azimuths, angles = 2 * np.pi * np.arange(BALLS) / BALLS, np.array(INSIDE)
    absolute = condensed().at(azimuths).absolute.reshape((2 * BALLS * 3,) * 2)
    local = patch_answers(RADIUS * np.abs(angles[:, None] - angles), WIDTH, RING.elastic)
    assert np.linalg.eigvalsh(absolute).min() < 0
    assert np.linalg.eigvalsh(absolute + np.kron(np.eye(2 * BALLS), local)).min() > 0


@pytest.mark.slow
@both_rings
def test_ring_bolted_on_its_other_face_is_the_mirror_image(ring):
    row, seen = around(ring, mesh=FINE), around(replace(ring, face_side=-1), mesh=FINE)
    assert seen[:, ::-1][..., ::-1, :] == approx(row, rel=1e-4, abs=1e-4 * np.abs(row).max())  # another mesh
    assert np.abs(seen - row).max() > 0.5 * np.abs(row).max()


@pytest.mark.slow
def test_compliance_falls_with_stiffness():
    hard = replace(RING, elastic=replace(RING.elastic, youngs_modulus=420e9))
    assert 2 * around(hard) == approx(around(), abs=1e-9 * np.abs(around()).max())


def test_arc_next_to_the_bolted_face_is_the_stiffer_one():
    for ring, near in ((RING, 0), (INNER, 1)):  # the inner ring is pressed to the side opposite its normal
        own = np.einsum("akal->akl", around(ring).sum(axis=0))
        assert own[near, 1, 1] < 0.3 * own[1 - near, 1, 1]


def test_neighbours_feel_the_whole_ring():
    """Between balls the harmonics themselves have a sum if they fade out, without a patch."""
    W = condensed().response
    n = np.arange(len(W))
    weight = np.where(n > 0, 2.0, 1.0) * (1 + np.cos(np.pi * n / len(W))) / 2 * np.cos(2 * np.pi * n / BALLS)
    assert around()[1].reshape(6, 6) == approx(np.tensordot(weight, W, axes=1), abs=5e-3 * around()[1].max())


@both_rings
@pytest.mark.parametrize(("widths", "allowed"), [(5, 1e-6), (2, 7e-3)])
def test_stations_read_rigid_motions_of_the_section(ring, widths, allowed):
    """Two widths from where its arc ends a patch is cut: it reads along the middle of what is left."""
    width = 0.8e-3
    margin = widths * width / RADIUS
    angles = np.linspace(ring.groove.bottom_angle + margin, END - margin, 3)
    body = body_of(ring, Resolution(length=across(ring), mesh_size=replace(FAIR, raceway_size=0.4e-3)))
    modes = station_modes(body, ring.groove, ring.outward, Stations(angles=angles, width=width))
    normals, centres = sides(ring, angles)
    for motion in (lambda *_: (1, 0), lambda *_: (0, 1), lambda x, r: (80 - r, x)):
        moved = ngs.GridFunction(body.space)
        for part, field in zip(moved.components, motion(ngs.x, ngs.y), strict=False):
            part.Set(ngs.CF(field))
        exact = np.einsum("aki,ai->ak", normals, [motion(*1e3 * centre) for centre in centres])
        assert modes.T @ moved.vec.FV().NumPy() == approx(exact.ravel(), abs=allowed * np.abs(exact).max())


@both_rings
def test_stiff_ring_on_springs_moves_as_one(ring):
    """By F / (k A) along the axis, and across it by translation and tilt under forces like cos(phi)."""
    k_n, k_s = 2e12, 1e12
    held = replace(
        ring, elastic=replace(ring.elastic, youngs_modulus=1e17), normal_stiffness=k_n, shear_stiffness=k_s
    )
    outside, bore = sorted((ring.far_diameter, ring.raceway_diameter), reverse=True)
    area, inertia = np.pi / 4 * (outside**2 - bore**2), np.pi / 64 * (outside**4 - bore**4)
    row, (normals, centres) = around(held), sides(ring)
    axial, radial = normals[..., 0].ravel(), normals[..., 1].ravel()
    x, r = (np.repeat(place, 3) for place in centres.T)
    moment = radial * (x - ring.face_distance) - axial * r  # about the middle of the bolted face
    circles = np.tile(1 / (ring.groove.centre_radius + ring.outward * RADIUS * np.cos(INSIDE)) ** 2, 2)
    curved = np.exp(WIDTH**2 / 2 * (circles[:, None] + circles))  # around, patches read radial motion exactly
    along = BALLS * np.outer(axial, axial) / (k_n * area) * curved
    assert row.sum(0).reshape(6, 6) == approx(along, abs=1e-4 * along.max())
    wave = np.tensordot(np.cos(2 * np.pi * np.arange(BALLS) / BALLS), row, axes=1).reshape(6, 6)
    wide = np.outer(radial, radial) / (k_s * area) + np.outer(moment, moment) / (k_n * inertia)
    assert wave == approx(BALLS / 2 * wide, abs=1e-4 * BALLS / 2 * wide.max())


@both_rings
def test_uniform_load_all_around_is_that_of_an_axisymmetric_section(ring):
    """Written again with plain triangles: strains u_r,r, u_r/r, u_x,x, shear, on the same outline."""
    mesh = ngs.Mesh(occ.OCCGeometry(drawn(ring), dim=2).GenerateMesh(maxh=2.0)).Curve(4)
    space = ngs.VectorH1(mesh, order=4, dirichlet="bolted")
    u, v = space.TnT()

    def strain(w):
        d = ngs.Grad(w)
        return d[0, 0], d[1, 1], w[1] / ngs.y, (d[0, 1] + d[1, 0]) / np.sqrt(2)

    e, f = strain(u), strain(v)
    work = 2 * SHEAR * sum(a * b for a, b in zip(e, f, strict=True)) + LAME * sum(e[:3]) * sum(f[:3])
    K = ngs.BilinearForm(work * ngs.y * 1e-3 * ngs.dx).Assemble()
    inverse = K.mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    loads = []
    for side, angle in ((side, angle) for side in (1, -1) for angle in INSIDE):
        patch, axial, radial = pressed(ring, side, angle, ngs.x, ngs.y)
        read = ngs.Integrate(patch * (side * np.sin(angle) * axial + np.cos(angle) * radial), mesh, ngs.BND)
        loads.append(ngs.LinearForm(patch / read * (axial * v[0] + radial * v[1]) * ngs.ds).Assemble().vec)
    plain = np.array([[ngs.InnerProduct(p, inverse * q) for q in loads] for p in loads])
    assert 2 * np.pi * condensed(ring).response[0] == approx(plain, rel=2e-3, abs=5e-4 * plain.max())


def drawn(ring):
    """The outline with its arcs, in millimetres."""
    (outline,) = sections(ring, across(ring))
    pen = occ.WorkPlane()
    pen.MoveTo(*(1e3 * c for c in outline.corners[0][:2]))
    for number in [*range(1, len(outline.corners)), 0]:
        to = [1e3 * c for c in outline.corners[number][:2]]
        if number in outline.bends:
            pen.ArcTo(*to, occ.gp_Vec2d(*outline.bends[number]))
        else:
            pen.LineTo(*to)
    face = pen.Face()
    face.edges.Max(occ.X).name = "bolted"
    return face


def pressed(ring, side, angle, x, r):
    """Patch on an arc, by places in millimetres, and its normal there: axial, radial."""
    aside, centre, radius = (1e3 * c for c in (ring.groove.aside, ring.groove.centre_radius, RADIUS))
    outwards, up = ring.outward * side * x + aside, ring.outward * (r - centre)
    off = ngs.atan2(outwards, up) - angle
    on_arc = ngs.IfPos(0.05 - ngs.sqrt((ngs.sqrt(outwards**2 + up**2) - radius) ** 2), 1.0, 0.0)
    own = ngs.IfPos(ring.outward * side * x, 1.0, 0.0)
    patch = on_arc * own * ngs.exp(-((radius * off / (1e3 * WIDTH)) ** 2) / 2)
    return patch, side * ngs.sin(off + angle), ngs.cos(off + angle)


@pytest.mark.slow
def test_all_balls_together_are_one_pitch_of_the_solid():
    """Half a pitch in space between its mirror planes; the ball presses on a patch."""
    local = patch_answers(np.zeros(1), WIDTH, RING.elastic)[0]
    own, other = half_pitch()
    row = around(mesh=MeshSize(order=5, size=10e-3, raceway_size=1e-3)).sum(axis=0)[:, 1, 0, 1]
    assert own - local == approx(row[0], abs=1e-3 * local)
    assert other == approx(row[1], rel=0.01)


def half_pitch():
    """Displacement at both middle stations per force of every ball on that of the arc at +x [m/N]."""
    turn, angle = np.pi / BALLS, INSIDE[1]
    mesh = half_pitch_mesh(turn)
    space = ngs.VectorH1(mesh, order=3, dirichlet="bolted", dirichlety="middle")
    u, v = space.TnT()
    e, f = ngs.Sym(ngs.Grad(u)), ngs.Sym(ngs.Grad(v))
    between = ngs.CF((0, np.cos(turn), -np.sin(turn)))
    K = ngs.BilinearForm(space, symmetric=True)
    K += 1e-3 * (2 * SHEAR * ngs.InnerProduct(e, f) + LAME * ngs.Trace(e) * ngs.Trace(f)) * ngs.dx
    K += 10 * SHEAR * (u.Trace() * between) * (v.Trace() * between) * ngs.ds(definedon="between")  # ~rigid
    contact = 1e3 * (RING.groove.centre_radius + RADIUS * np.cos(angle))
    radius, around_axis = ngs.sqrt(ngs.y**2 + ngs.z**2), ngs.atan2(ngs.y, ngs.z)
    gauss = ngs.exp(-((contact * around_axis / (1e3 * WIDTH)) ** 2) / 2)
    loads = []
    for side in (1, -1):
        patch, axial, radial = pressed(RING, side, angle, ngs.x, radius)
        normal = ngs.CF((axial, radial * ngs.sin(around_axis), radial * ngs.cos(around_axis)))
        middle = ngs.CF((side * np.sin(angle), 0, np.cos(angle)))
        size = 2 * ngs.Integrate(gauss * patch * (normal * middle) * ngs.ds("free", bonus_intorder=8), mesh)
        form = gauss * patch / size * (normal * v.Trace()) * ngs.ds("free", bonus_intorder=8)
        loads.append(ngs.LinearForm(form))
    with ngs.TaskManager():
        inverse = K.Assemble().mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
        answer = inverse * loads[0].Assemble().vec
        return [2 * ngs.InnerProduct(load.Assemble().vec, answer) for load in loads]


def half_pitch_mesh(turn):
    """From the plane of a ball, y = 0, to the one half way to the next."""
    axis = occ.Axis((0, 0, 0), occ.X)
    body = drawn(RING).Rotate(axis, 90).Revolve(axis, -np.degrees(turn))
    for face in body.faces:
        face.name = "free"
        if abs(face.center.x - 25.0) < 1e-6:
            face.name = "bolted"
        elif abs(face.center.y) < 1e-6:
            face.name = "middle"
        elif abs(face.center.y * np.cos(turn) - face.center.z * np.sin(turn)) < 1e-6:
            face.name = "between"
    for edge in body.edges:
        if abs(edge.center.y) < 1e-6 and 2.0 < edge.center.x < 9.0 and edge.center.z < 85.0:
            edge.maxh = 0.6  # the loaded arc
    return ngs.Mesh(occ.OCCGeometry(body).GenerateMesh(maxh=5.0, grading=0.4)).Curve(3)


@pytest.mark.slow
def test_stations_converge_for_a_force_between_them():
    """Five stations, as by default, are off by 5e-3 of the contact's half-space at 50 degrees, seven by 1e-4.

    In 1e-12 m/N, with 3, 5, 7, 9, 11 of them: -70.6, -77.8, -72.8, -72.8, -72.8 at the arc itself;
    13.2, 17.6, 18.1, 18.1, 18.1 at the other arc of the ball.
    """
    margin, angle = 2 * WIDTH / RADIUS, np.radians(50.0)
    middle, half = (RING.groove.bottom_angle + END) / 2, (END - RING.groove.bottom_angle) / 2 - margin
    moved = {}
    for count in (3, 5, 7, 9, 11):
        angles = tuple(middle + half * np.sin(np.pi / 2 * np.linspace(-1, 1, count)))
        at = condensed(RING, angles).at(2 * np.pi * np.arange(BALLS) / BALLS)
        force = np.zeros(2 * BALLS, dtype=complex)
        force[0] = np.sin(angle) + 1j * np.cos(angle)
        shape = shape_of(ElasticGroove(np.array(angles), at.absolute), np.full(2 * BALLS, angle), force)
        moved[count] = shape.moved @ [np.sin(angle), np.cos(angle)]
    local = patch_answers(np.zeros(1), WIDTH, RING.elastic)[0]
    off = {count: np.abs(moved[count] - moved[11])[:4].max() / local for count in (3, 5, 7, 9)}
    assert max(off[3], off[5]) < 6e-3
    assert max(off[7], off[9]) < 2e-4


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"raceway_diameter": 175e-3}, "raceway_diameter"),
        ({"far_diameter": 160e-3}, "far_diameter"),
        ({"width": 30e-3}, "width"),
        ({"face_distance": 5e-3}, "face_distance"),
        ({"shear_stiffness": 1e12}, "shear_stiffness"),
        ({"normal_stiffness": -1.0}, "normal_stiffness"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_ring_that_cannot_be_is_refused(change, named):
    with pytest.raises(ImpossiblePart, match=rf"^{named} = "):
        replace(RING, **change)


@pytest.mark.parametrize("angle", [8.0, 69.0])
def test_stations_off_the_arc_are_refused(angle):
    """A patch must be on its arc by its width, 6.5 degrees, and two arcs meet at 1.9 degrees."""
    with pytest.raises(ImpossiblePart, match="where the arc of the groove ends"):
        condensed(RING, tuple(np.radians([angle, 30.0, 40.0])))
