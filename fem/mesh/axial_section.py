# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""Bodies of revolution as named polygons on the half-plane of x (axial) next to r (radial).

A body carries the name of its material. Edges are named "raceway", exactly the loaded band, "clamped"
or "foundation" where the part is held, "lines" where line loads may act, "seat" between bodies. The mesh
is in millimetres, as in `fem.mesh.solid`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import singledispatch
from math import cos, hypot, isinf, sin

import ngsolve as ngs
from netgen import occ
from netgen.meshing import NgException

from fem.mesh.expense import polygon, require_affordable
from fem.mesh.moved_nodes import Faces, move_nodes
from fem.mesh.solid import MILLIMETRES
from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import Housing, edge_names
from fem.parts.groove import Groove
from fem.parts.rings import ImpossiblePart, MeshSize, OuterRing, RingOnShaft

FINER = ("raceway", "lines")  # edges with elements of a size of their own
AXIS = 0.005  # bore in the section of a solid shaft over its diameter: elastic to 1e-4, no 1/r at r = 0
GRADED_LAYERS = 2  # layers of ever smaller elements around each corner, where stress may be singular
GRADED_RATIO = 0.2  # size of a layer to that of the one around it


@dataclass(frozen=True)
class AxialSection:
    """Half of a body's axial section."""

    material: str
    corners: tuple[tuple[float, float, str | None], ...]  # (x, r [m], name of the edge that ends here)
    bends: Mapping[int, tuple[float, float]] = field(default_factory=dict)  # arcs: at the start of the edge
    # that ends at a corner, by its number, the direction of the arc

    @property
    def loaded(self) -> float:
        """Length of the edges that carry loads [m]."""
        pairs = zip((self.corners[-1], *self.corners), self.corners, strict=False)
        return sum(hypot(x - u, r - s) for (u, s, _), (x, r, name) in pairs if name in FINER)


@singledispatch
def sections(part, length: float) -> list[AxialSection]:
    """Bodies of a part as polygons that touch along whole edges.

    Parameters
    ----------
    part : OuterRing, RingOnShaft, BoltedRing
        a body of revolution with its seat
    length : float
        axial length of the loaded band, centred on x = 0 [m], at most the track of the part; a groove has
        the width that its lands leave it

    Returns
    -------
    list of AxialSection
        their corners in counter-clockwise order

    Raises
    ------
    ImpossiblePart
        if the part is not a body of revolution
    """
    raise ImpossiblePart(f"{type(part).__name__} is not known as a body of revolution")


@sections.register
def _(part: OuterRing, length):
    inner, (left, right) = part.raceway_diameter / 2, part.sides
    outer, half = inner + part.thickness, half_band(part.groove, inner, 1, length)
    bore = (left, inner, None), (-half, inner, None), (half, inner, "raceway"), (right, inner, None)
    bends = {} if part.groove is None else {2: start_of_arc(part.groove.end(inner, 1), 1)}
    if not isinstance(part.support, Housing):
        face, outside = edge_names(part.support)
        return [AxialSection("ring", (*bore, (right, outer, face), (left, outer, outside)), bends)]
    face, outside = edge_names(part.support.support)
    top = outer + part.support.thickness
    first, last = (side * part.support.width / 2 - part.offset for side in (-1, 1))
    near, far = max(left, first), min(right, last)
    ring = AxialSection("ring", (
        *bore, (right, outer, None), (far, outer, None), (near, outer, "seat"), (left, outer, None)
    ), bends)  # fmt: skip
    housing = AxialSection("housing", (
        (first, outer, None), (near, outer, None), (far, outer, "seat"), (last, outer, None),
        (last, top, face), (first, top, outside),
    ))  # fmt: skip
    return [ring, housing]


@sections.register
def _(part: RingOnShaft, length):
    raceway, rib, bore = part.raceway_diameter / 2, part.outside_diameter / 2, part.bore / 2
    hollow = part.shaft_bore / 2 or AXIS * bore
    track, side, end = part.track_width / 2, part.width / 2, part.shaft_length / 2
    half = half_band(part.groove, raceway, -1, length)
    ribs = [[(side, rib, None), (track, rib, None)], [(-track, rib, None), (-side, rib, None)]]
    right, left = ribs if part.rib_diameter is not None else ([], [])
    bends = {} if part.groove is None else {4 + len(right): start_of_arc(part.groove.end(raceway, -1), -1)}
    ring = AxialSection("ring", (
        (-side, bore, None), (side, bore, "seat"), *right,
        (track, raceway, None), (half, raceway, None), (-half, raceway, "raceway"), (-track, raceway, None),
        *left,
    ), bends)  # fmt: skip
    shaft = AxialSection("shaft", (
        (-end, hollow, None), (end, hollow, None), (end, bore, "clamped"), (side, bore, None),
        (-side, bore, "seat"), (-end, bore, None), (-end, hollow, "clamped"),
    ))  # fmt: skip
    return [ring, shaft]


@sections.register
def _(part: BoltedRing, length):
    groove, outward, land = part.groove, part.outward, part.raceway_diameter / 2
    first, last = part.ends[::outward]
    half, far = outward * length / 2, part.far_diameter / 2
    faces = {part.face_side: "clamped" if isinf(part.normal_stiffness) else "foundation"}
    between = ((0.0, groove.bottom(outward), "raceway"),) if len(groove.sides) > 1 else ()
    begin = (groove.end(land, outward), -groove.bottom_angle)[: len(groove.sides)]
    return [AxialSection("ring", (
        (first, land, faces.get(-outward)),
        (-half, land, None), *between, (half, land, "raceway"),
        (last, land, None), (last, far, faces.get(outward)), (first, far, None),
    ), {2 + number: start_of_arc(angle, outward) for number, angle in enumerate(begin)})]  # fmt: skip


def half_band(groove: Groove | None, land: float, outward: int, length: float) -> float:
    """Half of what is loaded along the axis [m]: the arc of a groove, or a band of some length."""
    return length / 2 if groove is None else groove.width(land, outward) / 2


def start_of_arc(angle: float, outward: int) -> tuple[float, float]:
    """Direction (x, r) of an arc where it begins at a contact angle, counter-clockwise around its section."""
    return outward * cos(angle), outward * sin(angle)


def meshed(
    bodies: list[AxialSection], mesh_size: MeshSize, nodes_of: list[AxialSection] | None = None
) -> ngs.Mesh:
    """Triangles that fill sections, with quadrilaterals in the layers around corners.

    Parameters
    ----------
    bodies : list of AxialSection
        which touch along whole edges
    mesh_size : MeshSize
        element sizes
    nodes_of : list of AxialSection, optional
        other bodies of the same kind, whose mesh is taken with its nodes moved to these

    Returns
    -------
    ngsolve.Mesh
        in millimetres, x along the axis, y the radius

    Raises
    ------
    ImpossiblePart
        when it would have far too many elements, or none fill the section
    """
    if nodes_of is not None:
        mesh = meshed(nodes_of, mesh_size)
        move_nodes(mesh, faces_of(nodes_of), faces_of(bodies))
        return mesh
    loaded = sum(body.loaded for body in bodies)
    require_affordable(
        2, [polygon([corner[:2] for corner in body.corners]) for body in bodies], loaded, mesh_size
    )
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
