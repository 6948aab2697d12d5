# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""A squirrel cage between the middle of a bar and the middle of the next slot, as a curved mesh.

Rotation and mirror image make the whole cage of it. Its flat sides are the boundaries "middle" (of the
bar, azimuth 0) and "cut" (of the slot, azimuth pi / bars); all else is as in `fem.mesh.solid`.
"""

from dataclasses import replace
from itertools import pairwise
from math import atan2, hypot, isclose, pi

import ngsolve as ngs
from netgen import occ

from fem.mesh.curved import FOLDED, curved
from fem.mesh.moved_nodes import cage_faces, move_nodes
from fem.mesh.solid import (
    ARC,
    MILLIMETRES,
    cage_bodies,
    require_affordable_solid,
    require_kept,
    rounded,
    size_raceway,
)
from fem.parts.resolution import Shape
from fem.parts.rings import MeshSize, require_on_track
from fem.parts.squirrel_cage import SquirrelCage

NEAR = 1e-6  # [mm], [rad] geometric tolerance
LAYERS = 1  # of elements refined geometrically towards a sharp edge
LAYER_RATIO = 0.15  # close to 0.17, the best for a singular edge (Gui and Babuska 1986)
# Small elements beside a thin step would fill the ring; half as many move its compliance by 0.4 % (measured).
THIN = 0.1  # step between bar and ring over the size of elements
GROWTH = {False: 0.3, True: 0.5}  # of elements away from small ones, by whether the step is thin

_AXIS = occ.Axis(occ.Pnt(0, 0, 0), occ.X)


def half_pitch(
    part: SquirrelCage,
    length: float,
    mesh_size: MeshSize,
    feet_size: float | None = None,
    *,
    graded_clamp: bool = False,
    nodes_of: Shape | None = None,
) -> ngs.Mesh:
    """Curved elements that fill half a pitch of a squirrel cage, in millimetres, x along the axis.

    Where bars meet ring and flange at a sharp edge the stress is singular: layers of thinner and thinner
    elements follow the edge. A fillet needs none.

    For stresses, `feet_size` is the largest element edge at the feet of the bar [m]; with fillets all is one
    body then, named after the ring: a fillet that ends at another body is a cusp. With `graded_clamp` layers
    of thinner elements follow the rims of the clamp, too, where stress is as singular: it pays where the
    clamp is what strains the cage, or where stresses of the flange count. With `nodes_of` the mesh of another
    cage and band is taken, its nodes moved to these.

    Raises `ImpossiblePart` if the band of `length` [m] is longer than the track, or elements are inside out
    or far too many.
    """
    require_on_track(length, part.track)
    if nodes_of is not None:
        mesh = half_pitch(nodes_of.part, nodes_of.length, mesh_size, feet_size, graded_clamp=graded_clamp)
        move_nodes(mesh, cage_faces(nodes_of.part, nodes_of.length), cage_faces(part, length))
        return mesh
    in_one = feet_size is not None and part.fillet > 0
    body = occ.Glue(_in_one(part, length) if in_one else _pieces(part, length))
    require_affordable_solid(body, mesh_size)
    if graded_clamp:
        _mark_clamp(body)
    _name_planes(body, part.bars)

    def straight(sizes: MeshSize) -> ngs.Mesh:
        size_raceway(body, sizes)
        if feet_size is not None:
            _size_feet(body, part, feet_size)
        tetrahedra = occ.OCCGeometry(body).GenerateMesh(
            maxh=sizes.size * MILLIMETRES,
            parallel_meshing=False,
            curvaturesafety=ARC,
            grading=_growth(part, sizes.size),
        )
        mesh = ngs.Mesh(tetrahedra)
        if part.fillet == 0 or graded_clamp:
            mesh.RefineHP(LAYERS, LAYER_RATIO)
        return mesh

    return curved(straight, mesh_size, FOLDED if part.fillet else 0.0)


def _growth(part: SquirrelCage, size: float) -> float:
    """How fast elements grow away from the steps between sharp bars and ring."""
    inner = part.raceway_diameter / 2
    low, high = part.bar_radii
    steps = [step for step in (low - inner, inner + part.thickness - high) if step * MILLIMETRES > NEAR]
    thin = part.fillet == 0 and bool(steps) and min(steps) < THIN * size
    return GROWTH[thin]


def _in_one(part: SquirrelCage, length: float) -> list:
    """Half a pitch [mm] as one body with its fillets, cut at the ends of the raceway to name that."""
    ring, *ends = cage_bodies(replace(part, fillet=0.0), length)
    sharp = whole = ring
    for bar, flange in ends:
        whole = rounded(bar, whole, flange, part.fillet * MILLIMETRES)
        sharp = sharp + bar + flange
    whole = whole * _wedge(part)
    require_kept(whole, sharp * _wedge(part), part.fillet * MILLIMETRES)
    half, wide = length / 2 * MILLIMETRES, 4 * part.raceway_diameter * MILLIMETRES
    stops = (-wide, -half, half, wide)
    slabs = (occ.Box(occ.Pnt(a, -wide, -wide), occ.Pnt(b, wide, wide)) for a, b in pairwise(stops))
    pieces = [piece for piece in (whole * slab for slab in slabs) if piece.mass > 0]
    for piece in pieces:
        piece.mat("ring")
        for face in piece.faces:
            if face.name == "raceway" and abs(face.center.x) > NEAR:  # the body carries the name all along
                face.name = "shoulder"
    return pieces


def _name_planes(body, bars: int) -> None:
    """Name the flat sides of half a pitch."""
    for face in body.faces:
        azimuth = atan2(face.center.y, face.center.z)
        if abs(azimuth) < NEAR:
            face.name = "middle"
        elif abs(azimuth - pi / bars) < NEAR:
            face.name = "cut"


def _mark_clamp(body) -> None:
    """Mark the inner and the outer rim of the clamp, along which elements become thinner."""
    for face in body.faces:
        if face.name == "clamped":
            for edge in face.edges:
                if isclose(_radius(edge.start), _radius(edge.end), abs_tol=NEAR):
                    edge.hpref = 1


def _radius(point) -> float:
    return hypot(point.y, point.z)


def _size_feet(body, part: SquirrelCage, size: float) -> None:
    """Set the size of elements on the faces on which the bar stands, or with its fillets."""
    starts = [(end, part.end_distance(end) * MILLIMETRES) for end in part.ends]
    feet = [end * x for end, start in starts for x in (start, start + part.bar_length * MILLIMETRES)]
    low, high = (radius * MILLIMETRES for radius in part.bar_radii)
    for face in body.faces:
        x, r = face.center.x, _radius(face.center)
        stands = min(abs(x - foot) for foot in feet) < NEAR and low < r < high and part.fillet == 0
        if face.name == "fillet" or stands:
            face.maxh = size * MILLIMETRES


def _pieces(part: SquirrelCage, length: float) -> list:
    """Ring, bar and flange of half a pitch [mm], sharp edges of the bar marked."""
    ring, *ends = cage_bodies(part, length)
    wedge = _wedge(part)
    bars, flanges = ([body * wedge for body in bodies] for bodies in zip(*ends, strict=True))
    if part.fillet > 0:
        _, (sharp, _), *_ = cage_bodies(replace(part, fillet=0.0), length)
        require_kept(bars[0], sharp * wedge, part.fillet * MILLIMETRES)
    else:
        for edge in (edge for bar in bars for edge in bar.edges):
            if abs(edge.start.x - edge.end.x) < NEAR and edge.center.y > NEAR:
                edge.hpref = 1
    return [ring * wedge, *bars, *flanges]


def _wedge(part: SquirrelCage):
    """All between the azimuths 0 and pi / bars [mm]."""
    radius, half = part.raceway_diameter / 2 * MILLIMETRES, part.width / 2 * MILLIMETRES
    right = part.end_distance(1) * MILLIMETRES + (part.bar_length + part.flange_length) * MILLIMETRES
    left = (half + right if part.two_sided else 0.0) + 2 * abs(part.offset) * MILLIMETRES  # of -half
    angle, thickest = 180 / part.bars, max(part.thickness, part.collar_thickness) * MILLIMETRES
    pen = occ.WorkPlane(occ.Axes(occ.Pnt(-2 * half - left, radius / 2, 0), n=occ.Z, h=occ.X))
    section = pen.Rectangle(left + right + 4 * half, radius + 2 * thickest).Face()
    # turned from the y-axis towards z, that is towards smaller azimuths
    return section.Revolve(_AXIS, angle).Rotate(_AXIS, 90 - angle)
