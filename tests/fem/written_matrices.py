"""A housing meshed here, and its stiffness in the files of other programs, in mm and N."""

import ngsolve as ngs
import numpy as np
from netgen import occ
from scipy import sparse

from fem.assembly.elasticity import lame_constants


def meshed_tube(inner, outer, width, size, middle=0.0):
    """A tube along x [mm] of tetrahedra, clamped on its outer surface."""
    axis = occ.Axes((middle - width / 2, 0, 0), occ.X, occ.Z)
    outside, hole = (occ.Cylinder(axis, radius, width) for radius in (outer, inner))
    tube = outside - hole
    for face in tube.faces:
        at = face.center
        face.name = "side" if abs(at.x - middle) > width / 4 else "round"
    for face in outside.faces:
        if abs(face.center.x - middle) < width / 4:
            for own in tube.faces:
                if own.name == "round" and own.mass > 0.99 * face.mass:
                    own.name = "clamped"
    return ngs.Mesh(occ.OCCGeometry(tube).GenerateMesh(maxh=size))


def stiffness(mesh, elastic):
    """Places (n, 3) [mm], free unknowns as (node, motion) from 1, and their stiffness [N/mm], quadratic."""
    space = ngs.H1(mesh, order=2, dirichlet="clamped") ** 3
    u, v = space.TnT()
    lame, shear = (1e-6 * each for each in lame_constants(elastic.youngs_modulus, elastic.poisson_ratio))
    slopes, others = ngs.Grad(u), ngs.Grad(v)
    strains = ngs.InnerProduct(slopes + slopes.trans, others)
    work = shear * strains + lame * ngs.Trace(slopes) * ngs.Trace(others)
    form = ngs.BilinearForm(work * ngs.dx).Assemble()
    rows, columns, values = (np.asarray(each) for each in form.mat.COO())
    matrix = sparse.csr_array((values, (rows, columns)), shape=(space.ndof, space.ndof))
    places, to_nodes = nodes(mesh, space.components[0])
    every = sparse.csr_array(sparse.block_diag([to_nodes] * 3))
    matrix, count = every.T @ matrix @ every, len(places)
    free = np.array(list(space.FreeDofs()))
    unknowns = np.array([(node + 1, motion + 1) for motion in range(3) for node in range(count)])
    return places, unknowns[free], matrix[free][:, free]


def nodes(mesh, space):
    """Places of corners and middles of edges (n, 3), and unknowns of the space by values there (n, n)."""
    points = {vertex.nr: np.array(vertex.point) for vertex in mesh.vertices}
    corner = {number: space.GetDofNrs(ngs.NodeId(ngs.VERTEX, number))[0] for number in points}
    places, to_nodes = np.zeros((space.ndof, 3)), sparse.lil_array((space.ndof, space.ndof))
    for number, own in corner.items():
        places[own], to_nodes[own, own] = points[number], 1.0
    bubble = ngs.GridFunction(space)
    for edge in mesh.edges:
        ends = [vertex.nr for vertex in edge.vertices]
        own = space.GetDofNrs(ngs.NodeId(ngs.EDGE, edge.nr))[0]
        places[own] = sum(points[number] for number in ends) / 2
        if edge.nr == 0:  # what the function of an edge is in its middle, the same for all
            bubble.vec[own] = 1.0
            height = bubble(mesh(*places[own]))
        to_nodes[own, own] = 1 / height
        for number in ends:
            to_nodes[own, corner[number]] = -0.5 / height
    return places, sparse.csr_array(to_nodes)


def nodes_inp(path, places, numbers):
    lines = [
        f"{number}, {x:.12e}, {y:.12e}, {z:.12e}" for number, (x, y, z) in zip(numbers, places, strict=True)
    ]
    path.write_text(
        "\n".join(["** a comment", "*NODE, NSET=ALL", *lines, "*ELEMENT, TYPE=C3D10", "1, 2, 3"]) + "\n"
    )
    return path


def grid_bdf(path, places, numbers):
    """Large fields, as 16 characters take all digits that matter."""
    lines = ["$ a comment", "BEGIN BULK"]
    for number, (x, y, z) in zip(numbers, places, strict=True):
        lines += [f"GRID*   {number:<16}{'':16}{x:<16.9e}{y:<16.9e}*", f"*       {z:<16.9e}"]
    path.write_text("\n".join([*lines, "ENDDATA"]) + "\n")
    return path


def calculix(path, unknowns, matrix):
    upper = sparse.triu(matrix).tocoo()
    rows = zip(upper.row + 1, upper.col + 1, upper.data, strict=True)
    path.write_text("".join(f"{i} {j} {value:.17e}\n" for i, j, value in rows))
    path.with_suffix(".dof").write_text("".join(f"{node}.{motion}\n" for node, motion in unknowns))
    return path


def abaqus(path, unknowns, matrix):
    lower = sparse.tril(matrix).tocoo()
    rows = (
        (*unknowns[i], *unknowns[j], value)
        for i, j, value in zip(lower.row, lower.col, lower.data, strict=True)
    )
    text = "".join(f"{a},{b},{c},{d}, {value:.17e}\n" for a, b, c, d, value in rows)
    path.write_text("** stiffness\n*MATRIX INPUT, NAME=K\n" + text)
    return path


def nastran(path, unknowns, matrix):
    """Large fields with D exponents, as a punch file has them."""
    lower = sparse.csc_array(sparse.tril(matrix))
    lines = ["DMIG    KAAX    0       6       2       0"]
    for column, (node, motion) in enumerate(unknowns):
        lines.append(f"DMIG*   {'KAAX':<16}{node:<16}{motion:<16}")
        for place in range(lower.indptr[column], lower.indptr[column + 1]):
            g, c = unknowns[lower.indices[place]]
            number = f"{lower.data[place]:.9E}".replace("E", "D")
            lines.append(f"*       {g:<16}{c:<16}{number:<16}")
    path.write_text("\n".join(lines) + "\n")
    return path
