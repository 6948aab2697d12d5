# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""From a part to a curved mesh with named bodies and boundaries.

Bodies are "ring" and, where the part has them, "bars", "flange", "shaft", "housing"; boundaries are
"raceway", exactly the loaded band, and "clamped". Everything here is in millimetres, the length for
which the tolerances of the geometry kernel are made; `MILLIMETRES` is the one conversion.
"""

from functools import singledispatch

import ngsolve as ngs
import numpy as np
from netgen import occ
from netgen.meshing import MeshingParameters, NgException
from numpy.typing import NDArray

from fem.errors import NotSolved
from fem.mesh import step_import
from fem.mesh.curved import FOLDED, curved
from fem.mesh.expense import require_affordable
from fem.parts.boundary_conditions import ClampedFace, Housing, RigidSeat, edge_names
from fem.parts.groove import BallPatches, Groove
from fem.parts.material import require
from fem.parts.part import Part
from fem.parts.rings import ImpossiblePart, MeshSize, OuterRing, RingOnShaft, require_on_track
from fem.parts.squirrel_cage import SquirrelCage
from fem.parts.step_solid import StepSolid

MILLIMETRES = 1e3  # per metre
FLAT = 1e-6  # [mm] below it two places are one
ARC = 0.6  # elements on the radius of a fillet; curved elements need no more
BESIDE = 2.5  # widths of a patch around a ball where elements of a groove are as small as on a raceway

_AXIS = occ.Axis(occ.Pnt(0, 0, 0), occ.X)


def meshed(
    part: Part | StepSolid, length: float, mesh_size: MeshSize, balls: BallPatches | None = None
) -> ngs.Mesh:
    """Curved tetrahedra that fill a part, with the loaded band as faces of their own.

    They are in millimetres, x along the axis. The band of `length` [m], at most the track of the part, is
    centred on x = 0; a groove has the small elements of a raceway at its `balls` only.
    Raises `ImpossiblePart` if the band is longer than the track, a drawing does not hold such a part, or
    elements are inside out or far too many; `NotSolved` if the mesh generator finds no mesh.
    """
    require_on_track(length, part.track)
    body, rounded = occ.Glue(solids(part, length)), isinstance(part, SquirrelCage) and part.fillet > 0
    require_affordable_solid(body, mesh_size)
    finer = {"curvaturesafety": ARC} if rounded else {}

    def straight(sizes: MeshSize) -> ngs.Mesh:
        # bodies meshed in parallel were seen to crash, at random, on a busy machine; and to take longer
        wanted = MeshingParameters(maxh=sizes.size * MILLIMETRES, parallel_meshing=False, **finer)
        if balls is None or part.groove is None:
            size_raceway(body, sizes)
        else:
            size = sizes.raceway_size * MILLIMETRES
            for x, y, z in _pressed(part.groove, balls, size):
                wanted.RestrictH(x=x, y=y, z=z, h=size)
        return ngs.Mesh(occ.OCCGeometry(body).GenerateMesh(mp=wanted))

    try:
        return curved(straight, mesh_size, FOLDED if rounded else 0.0)
    except NgException as refusal:
        raise NotSolved(f"the mesh generator gives up: {refusal}; take other element sizes") from refusal


def _pressed(groove: Groove, patches: BallPatches, size: float) -> NDArray:
    """Places (n, 3) [mm] of balls on the groove of an outer ring, a size [mm] apart."""
    angles, beside = patches.stations.angles, BESIDE * patches.width
    radius, centre = groove.radius * MILLIMETRES, groove.centre_radius * MILLIMETRES
    first, last = min(angles) - beside / groove.radius, max(angles) + beside / groove.radius
    alpha = np.arange(first, last + size / radius, size / radius)
    across = np.arange(-beside * MILLIMETRES, beside * MILLIMETRES + size, size)
    phi, alpha, across = np.meshgrid(patches.azimuths, alpha, across)
    r = centre + radius * np.cos(alpha)
    phi = phi + across / r
    return np.stack([radius * np.sin(alpha), r * np.sin(phi), r * np.cos(phi)], axis=-1).reshape(-1, 3)


def require_affordable_solid(body, mesh_size: MeshSize) -> None:
    """Refuse elements that are far too many for a shape; raises `NotSolved`."""
    contents = [
        (solid.mass / MILLIMETRES**3, sum(face.mass for face in solid.faces) / MILLIMETRES**2)
        for solid in body.solids
    ]
    loaded = sum(face.mass for face in body.faces if face.name == "raceway") / MILLIMETRES**2
    require_affordable(3, contents, loaded, mesh_size)


def size_raceway(body, sizes: MeshSize) -> None:
    """Set the size of elements on the loaded band of a shape."""
    for face in body.faces:
        if face.name == "raceway":
            face.maxh = sizes.raceway_size * MILLIMETRES


@singledispatch
def solids(part, length: float) -> list:
    """Bodies of a part that touch, their materials and outer faces named [mm].

    The loaded band has a `length` [m]. They are to be glued, so that the faces between them stay: a fuse
    would merge the band away.
    Raises `TypeError` for a part of which no geometry is known.
    """
    raise TypeError(f"no geometry is known for {type(part).__name__}")


@solids.register
def _(part: OuterRing, length):
    tube = part.support if isinstance(part.support, Housing) else None
    support = tube.support if tube else part.support
    if not isinstance(support, ClampedFace | RigidSeat):
        raise ImpossiblePart(f"a solid has no {type(support).__name__}; harmonics have")
    face, outside = edge_names(support)
    if not tube:
        return [_outer_ring(part, length, face, outside)]
    _, outer = _radii(part)
    half, top = tube.width / 2 * MILLIMETRES, outer + tube.thickness * MILLIMETRES
    left, right = (side * half - part.offset * MILLIMETRES for side in (-1, 1))
    housing = _revolved([(left, outer, None), (right, outer, None), (right, top, face), (left, top, outside)])
    housing.mat("housing")
    return [_outer_ring(part, length), housing]


@solids.register
def _(part: SquirrelCage, length):
    ring, *ends = cage_bodies(part, length)
    bodies = [ring]
    for bar, flange in ends:
        bodies += [*(bar.Rotate(_AXIS, 360 * k / part.bars) for k in range(part.bars)), flange]
    return bodies


def cage_bodies(part: SquirrelCage, length: float) -> tuple:
    """Bodies of a squirrel cage [mm]: the ring, then a pair of bar and flange for each of `part.ends`.

    Of the bars those at azimuth 0; the loaded band has a `length` [m].
    """
    ring = _outer_ring(part, length)
    return ring, *(_bar_and_flange(part, ring, end) for end in part.ends)


def _bar_and_flange(part: SquirrelCage, ring, end: int) -> tuple:
    """The bar at azimuth 0 and the flange at one end of the ring [mm]."""
    inner, outer = _radii(part)
    middle, half = (inner + outer) / 2, part.bar_thickness / 2 * MILLIMETRES
    width, start = part.bar_width * MILLIMETRES, part.end_distance(end) * MILLIMETRES
    stop = start + part.bar_length * MILLIMETRES
    clamp = start + (part.bar_length + part.flange_length) * MILLIMETRES
    left, right = sorted((end * start, end * stop))
    near, far = sorted((end * stop, end * clamp))
    bar = _tube(left, right, middle - half, middle + half)
    bar *= occ.Box(occ.Pnt(left, -width / 2, 0), occ.Pnt(right, width / 2, 2 * outer))
    flange = _tube(near, far, inner, outer, **{"end" if end > 0 else "start": "clamped"})
    if part.fillet > 0:
        bar = _flared(bar, ring, flange, part.fillet * MILLIMETRES)
    bar.mat("bars")
    flange.mat("flange")
    return bar.Rotate(_AXIS, 0), flange  # the copy is cut and meshed as the bars of other azimuths are


def _flared(bar, ring, flange, radius):
    """A bar with its fillets, which end at the faces of ring and flange."""
    flared = rounded(bar, ring, flange, radius) - ring - flange
    require_kept(flared, bar, radius)
    return flared


def rounded(bar, ring, flange, radius: float):
    """One body of ring, bar and flange with fillets [mm] where they meet; its raceway has no name."""
    ends = [edge.center for edge in bar.edges if abs(edge.start.x - edge.end.x) < FLAT]
    whole = ring + bar + flange
    corners = [edge for edge in whole.edges if any((edge.center - end).Norm() < FLAT for end in ends)]
    return whole.MakeFillet(corners, radius)


def require_kept(flared, bar, radius: float) -> None:
    """Refuse a fillet [mm] with which the geometry kernel loses part of a bar, as was seen close to the most.

    Raises `ImpossiblePart` if the bar became smaller.
    """
    require(
        flared.mass > bar.mass, "fillet", radius / MILLIMETRES,
        "a slightly different one: with this the geometry kernel loses the bar",
    )  # fmt: skip


@solids.register
def _(part: RingOnShaft, length):
    diameters = part.raceway_diameter, part.outside_diameter, part.bore, part.shaft_bore
    raceway, rib, bore, hollow = (d * MILLIMETRES / 2 for d in diameters)
    track, side, end = (w * MILLIMETRES / 2 for w in (part.track_width, part.width, part.shaft_length))
    right, left = ((-x, *rest) for x, *rest in _band(raceway, length))  # met from the right
    ring = _revolved([
        (-side, bore, None), (side, bore, None), (side, rib, None), (track, rib, None),
        (track, raceway, None), right, left, (-track, raceway, None),
        (-track, rib, None), (-side, rib, None),
    ])  # fmt: skip
    ring.mat("ring")
    shaft = _tube(-end, end, hollow, bore, start="clamped", end="clamped")
    shaft.mat("shaft")
    return [ring, shaft]


@solids.register
def _(part: StepSolid, length):
    return [step_import.solid(part, length)]


def _radii(part):
    """Inner and outer radius of an outer ring [mm]."""
    inner = part.raceway_diameter / 2
    return inner * MILLIMETRES, (inner + part.thickness) * MILLIMETRES


def _outer_ring(part, length, end=None, outside=None):
    inner, outer = _radii(part)
    left, right = (x * MILLIMETRES for x in part.sides)
    top = [(right, outer, end), (left, outer, outside)]
    if isinstance(part, SquirrelCage):
        top = [(x * MILLIMETRES, r * MILLIMETRES, None) for x, r in part.outline]
    ring = _revolved([(left, inner, None), *_band(inner, length), (right, inner, None), *top])
    ring.mat("ring")
    return ring


def _band(radius, length):
    """Ends of the loaded band on a profile [mm]; the edge between them becomes the raceway."""
    half = length / 2 * MILLIMETRES
    return [(-half, radius, None), (half, radius, "raceway")]


def _tube(left, right, inner, outer, start=None, end=None):
    return _revolved([(left, inner, start), (right, inner, None), (right, outer, end), (left, outer, None)])


def _revolved(profile):
    """Solid from a closed profile of (x, radius, name of the edge that ends here).

    The profile runs counter-clockwise: the other way the solid is inside out and cannot be meshed.
    """
    pen = occ.WorkPlane(occ.Axes(occ.Pnt(0, 0, 0), n=occ.Z, h=occ.X))
    pen.MoveTo(*profile[0][:2])
    at = profile[0][:2]
    for x, radius, name in [*profile[1:], profile[0]]:
        if max(abs(x - at[0]), abs(radius - at[1])) > 1e-9:  # a band as long as its track has no shoulders
            pen.LineTo(x, radius, name=name)
        at = (x, radius)
    return pen.Face().Revolve(_AXIS, 360)
