# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""Triangles on axial sections, in millimetres as in `fem.mesh.solid`."""

import ngsolve as ngs
from netgen import occ
from netgen.meshing import NgException

from fem.mesh.axial_section import FINER, AxialSection, require_affordable_section
from fem.mesh.moved_nodes import Faces, move_nodes
from fem.mesh.solid import MILLIMETRES
from fem.parts.rings import ImpossiblePart, MeshSize

GRADED_LAYERS = 2  # layers of ever smaller elements around each corner, where stress may be singular
GRADED_RATIO = 0.2  # size of a layer to that of the one around it


def meshed(
    bodies: list[AxialSection], mesh_size: MeshSize, nodes_of: list[AxialSection] | None = None
) -> ngs.Mesh:
    """Triangles that fill touching sections, with quadrilaterals in the layers around corners.

    In millimetres, x along the axis, y the radius. With `nodes_of` the mesh of other bodies of the same kind
    is taken, its nodes moved to these.
    Raises `ImpossiblePart` when it would have far too many elements, or none fill the section.
    """
    if nodes_of is not None:
        mesh = meshed(nodes_of, mesh_size)
        move_nodes(mesh, faces_of(nodes_of), faces_of(bodies))
        return mesh
    require_affordable_section(bodies, mesh_size)
    plane = occ.Glue([_face(body) for body in bodies])
    plane.vertices.hpref = 1
    for edge in plane.edges:
        if edge.name in FINER:
            edge.maxh = mesh_size.raceway_size * MILLIMETRES
    try:
        mesh = ngs.Mesh(occ.OCCGeometry(plane, dim=2).GenerateMesh(maxh=mesh_size.size * MILLIMETRES))
    except NgException as refusal:
        raise ImpossiblePart(f"no elements fill the section of such a part: {refusal}") from refusal
    mesh.RefineHP(GRADED_LAYERS, GRADED_RATIO)
    if any(body.bends for body in bodies):
        mesh.Curve(mesh_size.order)
    return mesh


def faces_of(bodies: list[AxialSection]) -> Faces:
    """Faces that nodes are moved with."""
    x, radii, _ = zip(*(corner for body in bodies for corner in body.corners), strict=True)
    return Faces(x=x, radii=radii)


def _face(body: AxialSection):
    pen = occ.WorkPlane()
    at = body.corners[0][:2]
    pen.MoveTo(*(c * MILLIMETRES for c in at))
    for number, (x, r, name) in [*enumerate(body.corners[1:], 1), (0, body.corners[0])]:
        if number in body.bends:
            pen.ArcTo(x * MILLIMETRES, r * MILLIMETRES, occ.gp_Vec2d(*body.bends[number]), name=name)
        elif max(abs(x - at[0]), abs(r - at[1])) * MILLIMETRES > 1e-9:  # a band as long as its track
            pen.LineTo(x * MILLIMETRES, r * MILLIMETRES, name=name)
        at = (x, r)
    face = pen.Face()
    face.faces.name = body.material
    return face
