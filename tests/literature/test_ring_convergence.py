"""Order of convergence on a plane ring, against Michell's solution everywhere in it."""

from itertools import pairwise

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx

from tests.literature.test_rings import INSIDE, MICHELL, NU, OUTSIDE, E, cosine_pressure

SHEAR, KOLOSOV = E / (2 * (1 + NU)), (3 - NU) / (1 + NU)  # plane stress
LAW = 0.25  # allowed lack of order between two meshes


def constants(n):
    """Of r^n, r^-n, r^(n+2), r^(2-n) in the stress function; 0.1 MPa cos(n phi) inward on the outside."""
    powers = np.array([n - 2, -n - 2, n, -n])
    normal = np.array([-n * (n - 1), -n * (n + 1), -(n + 1) * (n - 2), -(n - 1) * (n + 2)])
    shear = np.array([n * (n - 1), -n * (n + 1), n * (n + 1), -n * (n - 1)])
    rows = [part * float(r) ** powers for r in (INSIDE, OUTSIDE) for part in (normal, shear)]
    return np.linalg.solve(rows, [0.0, 0.0, -0.1, 0.0])


def michell(n, r):
    """Displacements u_r and u_t [mm] at r, as factors of cos(n phi) and sin(n phi)."""
    powers = (n - 1, -n - 1, n + 1, 1 - n)
    radial = np.array([-n, n, KOLOSOV - 1 - n, KOLOSOV - 1 + n])
    tangential = np.array([n, n, KOLOSOV + 1 + n, -(KOLOSOV + 1 - n)])
    return (
        sum(c * part * r**p for c, part, p in zip(constants(n), parts, powers, strict=True)) / (2 * SHEAR)
        for parts in (radial, tangential)
    )


def quarter(size):
    """First quadrant of the ring, with sides on which symmetry holds one component."""
    square = occ.WorkPlane().Rectangle(2 * OUTSIDE, 2 * OUTSIDE).Face()
    disc, hole = (occ.WorkPlane().Circle(0, 0, r).Face() for r in (OUTSIDE, INSIDE))
    disc.edges.name = "outer"
    face = (disc - hole) * square
    face.edges.Min(occ.X).name, face.edges.Min(occ.Y).name = "side_x", "side_y"
    return ngs.Mesh(occ.OCCGeometry(face, dim=2).GenerateMesh(maxh=size))


def distance(mesh, order):
    """Relative L2 norm of the error of u under cos(2 phi)."""
    phi = ngs.atan2(ngs.y, ngs.x)
    radial, tangential = michell(2, ngs.sqrt(ngs.x**2 + ngs.y**2))
    u_r, u_t = radial * ngs.cos(2 * phi), tangential * ngs.sin(2 * phi)
    exact = ngs.CF((u_r * ngs.cos(phi) - u_t * ngs.sin(phi), u_r * ngs.sin(phi) + u_t * ngs.cos(phi)))
    left = cosine_pressure(mesh, order, 2) - exact
    error, size = (ngs.Integrate(w * w, mesh, order=2 * order + 4) for w in (left, exact))
    return np.sqrt(error / size)


@pytest.mark.parametrize(("n", "printed"), MICHELL.items())
def test_michell_solution_is_the_printed_one(n, printed):
    (inner_r, inner_t), (outer_r, outer_t) = (michell(n, r) for r in (INSIDE, OUTSIDE))
    assert [1e3 * u for u in (inner_r, outer_r, inner_t, outer_t)] == approx(printed, rel=1e-6)


SIZES = {1: 0.9, 2: 3.6, 3: 3.6, 4: 7.2}  # [mm] coarsest elements by their order


def errors_of(order):
    """Relative errors of u on three meshes, each halved."""
    mesh, errors = quarter(SIZES[order]), []
    for level in range(3):
        if level:
            mesh.ngmesh.Refine()
            mesh = ngs.Mesh(mesh.ngmesh)
        mesh.Curve(order)
        errors.append(float(distance(mesh, order)))
    return errors


@pytest.mark.parametrize("order", SIZES)
def test_displacement_converges_at_the_order_of_theory(order):
    """Curved elements of order p, halved twice: the error in the mean falls at least like h^(p + 1)."""
    errors = errors_of(order)
    rates = [np.log2(coarse / fine) for coarse, fine in pairwise(errors)]
    assert min(rates) > order + 1 - LAW
    assert errors[-1] < {1: 1e-2, 2: 1e-4, 3: 1e-7, 4: 1e-8}[order]
