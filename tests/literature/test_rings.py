"""Rings with known answers: Michell's solution of plane elasticity, and two independent codes."""

from itertools import pairwise
from math import cos, pi, sin

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx

from fem.assembly import elasticity
from fem.assembly.factorisation import factorised, threads

INSIDE, OUTSIDE = 37.5, 41.1  # [mm]
E, NU = 203e3, 0.28  # [MPa]
FLOATING = 1e-10 * E  # [N/mm^4] holds a whole ring whose load is in balance; 5e-6 of its stiffness


def plane_ring(order, size, patch=None):
    """Curved mesh of the ring in the plane, with a loaded arc around x = +R and x = -R if asked."""
    hole = occ.WorkPlane().Circle(0, 0, INSIDE).Face()
    hole.edges.name = "inner"
    if patch is None:
        disc = occ.WorkPlane().Circle(0, 0, OUTSIDE).Face()
        disc.edges.name = "outer"
    else:
        disc = disc_with_patches(patch)
    return curved(disc - hole, order, size)


def plane_quarter(order, size, patch=None):
    """First quadrant of the ring, with sides on which symmetry holds one component."""
    square = occ.WorkPlane().Rectangle(2 * OUTSIDE, 2 * OUTSIDE).Face()
    disc = occ.WorkPlane().Circle(0, 0, OUTSIDE).Face() if patch is None else disc_with_patches(patch)
    if patch is None:
        disc.edges.name = "outer"
    quarter = (disc - occ.WorkPlane().Circle(0, 0, INSIDE).Face()) * square
    quarter.edges.Min(occ.X).name = "side_x"
    quarter.edges.Min(occ.Y).name = "side_y"
    return curved(quarter, order, size)


def curved(face, order, size):
    mesh = ngs.Mesh(occ.OCCGeometry(face, dim=2).GenerateMesh(maxh=size))
    mesh.Curve(order)
    return mesh


def disc_with_patches(half_angle):
    cuts = [-half_angle, half_angle, pi - half_angle, pi + half_angle, 2 * pi - half_angle]
    points = [occ.Pnt(OUTSIDE * cos(a), OUTSIDE * sin(a), 0) for a in cuts]
    arcs = []
    for (a, b), (start, end), name in zip(
        pairwise(cuts), pairwise(points),
        ("patch", "outer", "patch", "outer"), strict=True,
    ):  # fmt: skip
        middle = (a + b) / 2
        arc = occ.ArcOfCircle(start, occ.Pnt(OUTSIDE * cos(middle), OUTSIDE * sin(middle), 0), end)
        arc.name = name
        arcs.append(arc)
    return occ.Face(occ.Wire(arcs))


def solved(mesh, order, load):
    """Displacement [mm] of the plane-stress ring, whole or a quarter, under a traction in balance."""
    space = ngs.VectorH1(mesh, order=order, dirichletx="side_x", dirichlety="side_y")
    lame, shear = (
        E * NU / (1 - NU**2),
        E / (2 * (1 + NU)),
    )  # of plane stress
    hold = 0.0 if "side_x" in mesh.GetBoundaries() else FLOATING
    stiffness = factorised(
        space, lambda u, v: elasticity.elasticity(u, v, lame, shear) + hold * ngs.InnerProduct(u, v) * ngs.dx
    )
    force = ngs.LinearForm(load(space.TestFunction())).Assemble()
    shift = ngs.GridFunction(space)
    shift.vec.FV().NumPy()[:] = stiffness.solve(force.vec.FV().NumPy())
    return shift


def polar(shift, mesh, radius, angle):
    """Radial and tangential displacement."""
    # A point exactly on a curved edge may be missed by the search.
    inward = 1e-9 if radius == OUTSIDE else -1e-9
    u = shift(mesh((radius - inward) * cos(angle), (radius - inward) * sin(angle)))
    return u[0] * cos(angle) + u[1] * sin(angle), -u[0] * sin(angle) + u[1] * cos(angle)


# u_r(a), u_r(b), u_t(a), u_t(b) [um] for 0.1 MPa cos(n theta) inward on the outside
MICHELL = {
    2: (-35.34057, -35.33664, 20.08310, 15.25832),
    3: (-5.010963, -5.010069, 2.274355, 1.067841),
    4: (-1.441652, -1.441608, 0.6024834, 0.1196961),
}


def cosine_pressure(mesh, order, n):
    theta, r = ngs.atan2(ngs.y, ngs.x), ngs.sqrt(ngs.x**2 + ngs.y**2)
    inward = -0.1 * ngs.cos(n * theta) * ngs.CF((ngs.x, ngs.y)) / r
    return solved(mesh, order, lambda v: ngs.InnerProduct(inward, v) * ngs.ds("outer", bonus_intorder=8))


def under_cosine_pressure(n, order=4):
    """u_r(a), u_r(b), u_t(a), u_t(b) [um], two elements through the wall."""
    mesh = plane_ring(order=order, size=1.8) if n % 2 else plane_quarter(order=order, size=1.8)
    shift = cosine_pressure(mesh, order, n)
    radial = [polar(shift, mesh, r, 0.0)[0] * 1e3 for r in (INSIDE, OUTSIDE)]
    tangential = [polar(shift, mesh, r, pi / (2 * n))[1] * 1e3 for r in (INSIDE, OUTSIDE)]
    return (*radial, *tangential)


@pytest.mark.parametrize(("n", "exact"), MICHELL.items())
def test_ring_under_a_cosine_pressure(n, exact):
    """Order 4: 1e-4 of Michell's plane-stress solution."""
    assert under_cosine_pressure(n) == approx(exact, rel=1e-4)


PATCHES = (-0.11543227, 0.10516535)  # [mm] change of the inner diameter along the load and across it


def pinched_by_patches(order=5, size=1.8):
    """P = 10 N/mm on arcs of +-0.05 rad outside; change of the inner diameters [mm]."""
    half_angle = 0.05
    mesh = plane_quarter(order=order, size=size, patch=half_angle)
    pressure = 10.0 / (2 * half_angle * OUTSIDE)
    r = ngs.sqrt(ngs.x**2 + ngs.y**2)
    inward = -pressure * ngs.CF((ngs.x, ngs.y)) / r
    shift = solved(mesh, order, lambda v: ngs.InnerProduct(inward, v) * ngs.ds("patch"))
    return tuple(2 * polar(shift, mesh, INSIDE, angle)[0] for angle in (0.0, pi / 2))


def test_ring_pinched_by_two_patches():
    """Exact in the plane."""
    assert pinched_by_patches() == approx(PATCHES, rel=1e-4)


@pytest.mark.slow
def test_ring_pinched_by_two_lines_in_space():
    """1 kN on opposite outer lines; inner diameters at mid-width. Two codes agree to 1e-5.

    An eighth of the ring by symmetry, order 4, 1.2 mm.
    """
    tube = occ.WorkPlane(occ.Axes((0, 0, 0), n=occ.Z, h=occ.X))
    profile = tube.MoveTo(0, INSIDE).LineTo(5, INSIDE).LineTo(5, OUTSIDE).LineTo(0, OUTSIDE).Close().Face()
    eighth = profile.Revolve(occ.Axis((0, 0, 0), occ.X), 90)  # from y towards z
    eighth.faces.Min(occ.X).name = "middle"
    eighth.faces.Min(occ.Y).name = "side_y"
    eighth.faces.Min(occ.Z).name = "side_z"
    for edge in eighth.edges:
        if abs(edge.center.z) < 1e-6 and abs(edge.center.y - OUTSIDE) < 1e-6:
            edge.name = "line"
    mesh = ngs.Mesh(occ.OCCGeometry(eighth).GenerateMesh(maxh=1.2))
    mesh.Curve(4)
    space = ngs.VectorH1(mesh, order=4, dirichletx="middle", dirichlety="side_y", dirichletz="side_z")
    with threads(2):
        stiffness = factorised(
            space, lambda u, v: elasticity.elasticity(u, v, *elasticity.lame_constants(E, NU))
        )
        v = space.TestFunction()
        along_line = ngs.comp.DifferentialSymbol(ngs.BBND)
        # 100 N/mm over the width; the plane of symmetry leaves half of it
        form = ngs.LinearForm(-50.0 * v.Trace()[1] * along_line("line")).Assemble()
        shift = ngs.GridFunction(space)
        shift.vec.FV().NumPy()[:] = stiffness.solve(form.vec.FV().NumPy())
    along = 2 * shift(mesh(1e-9, INSIDE + 1e-9, 1e-9))[1]
    across = 2 * shift(mesh(1e-9, 1e-9, INSIDE + 1e-9))[2]
    assert (-along, across) == approx((1.15124, 1.04936), rel=1e-4)


@pytest.mark.slow
def test_neighbours_of_a_loaded_roller_on_a_clamped_ring():
    """One face clamped, unit line load on the raceway: u_r at 12, 24, 36, 48 degrees, mid-width [mm/kN].

    Half of the ring by symmetry, order 4, 2.4 mm.
    """
    tube = occ.WorkPlane(occ.Axes((0, 0, 0), n=occ.Z, h=occ.X))
    profile = tube.MoveTo(-5, INSIDE).LineTo(5, INSIDE).LineTo(5, OUTSIDE).LineTo(-5, OUTSIDE).Close().Face()
    half = profile.Revolve(occ.Axis((0, 0, 0), occ.X), 180)  # from y over z to -y
    half.faces.Max(occ.X).name = "clamped"
    for face in half.faces:
        if abs(face.center.z) < 1e-6:
            face.name = "side_z"
    for edge in half.edges:
        if abs(edge.center.z) < 1e-6 and abs(edge.center.y - INSIDE) < 1e-6:
            edge.name = "line"
    mesh = ngs.Mesh(occ.OCCGeometry(half).GenerateMesh(maxh=2.4))
    mesh.Curve(4)
    space = ngs.VectorH1(mesh, order=4, dirichlet="clamped", dirichletz="side_z")
    with threads(2):
        stiffness = factorised(
            space, lambda u, v: elasticity.elasticity(u, v, *elasticity.lame_constants(E, NU))
        )
        v = space.TestFunction()
        form = ngs.LinearForm(50.0 * v.Trace()[1] * ngs.comp.DifferentialSymbol(ngs.BBND)("line")).Assemble()
        shift = ngs.GridFunction(space)
        shift.vec.FV().NumPy()[:] = stiffness.solve(form.vec.FV().NumPy())
    angles = np.radians([12, 24, 36, 48])
    r = INSIDE + 1e-6
    points = [shift(mesh(0.0, r * np.cos(a), r * np.sin(a))) for a in angles]
    radial = [u[1] * np.cos(a) + u[2] * np.sin(a) for u, a in zip(points, angles, strict=True)]
    assert radial == approx([1.235e-3, 1.04e-4, -9.0e-5, -6.0e-5], rel=0.01)
