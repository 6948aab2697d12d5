# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""A squirrel cage between the middle of a bar and the middle of the next slot, as a curved mesh.

Rotation and mirror image make the whole cage of it. Its flat sides are the boundaries "middle" (of the
bar, azimuth 0) and "cut" (of the slot, azimuth pi / bars); all else is as in `fem.mesh.solid`.
"""

from dataclasses import replace
from math import atan2, pi

import ngsolve as ngs
from netgen import occ

from fem.mesh.curved import FOLDED, curved
from fem.mesh.solid import ARC, MILLIMETRES, require_affordable_solid, require_kept, size_raceway, solids
from fem.parts.rings import MeshSize, SquirrelCage, require_on_track

NEAR = 1e-6  # [mm], [rad] geometric tolerance
LAYERS = 1  # of elements refined geometrically towards a sharp edge
LAYER_RATIO = 0.15  # close to 0.17, the best for a singular edge (Gui and Babuska 1986)

_AXIS = occ.Axis(occ.Pnt(0, 0, 0), occ.X)


def half_pitch(part: SquirrelCage, length: float, mesh_size: MeshSize) -> ngs.Mesh:
    """Curved elements that fill half a pitch of a squirrel cage.

    Where bars meet ring and flange at a sharp edge the stress is singular: layers of thinner and
    thinner elements follow the edge. A fillet needs none.

    Parameters
    ----------
    part : SquirrelCage
        ring, bars and flange
    length, mesh_size
        as for `fem.mesh.solid.meshed`

    Returns
    -------
    ngsolve.Mesh
        in millimetres, x along the axis

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track, or elements are inside out or far too many
    """
    require_on_track(length, part.track)
    body = occ.Glue(_pieces(part, length))
    require_affordable_solid(body, mesh_size)
    for face in body.faces:
        azimuth = atan2(face.center.y, face.center.z)
        if abs(azimuth) < NEAR:
            face.name = "middle"
        elif abs(azimuth - pi / part.bars) < NEAR:
            face.name = "cut"

    def straight(sizes: MeshSize) -> ngs.Mesh:
        size_raceway(body, sizes)
        tetrahedra = occ.OCCGeometry(body).GenerateMesh(
            maxh=sizes.size * MILLIMETRES, parallel_meshing=False, curvaturesafety=ARC
        )
        mesh = ngs.Mesh(tetrahedra)
        if part.fillet == 0:
            mesh.RefineHP(LAYERS, LAYER_RATIO)
        return mesh

    return curved(straight, mesh_size, FOLDED if part.fillet else 0.0)


def _pieces(part: SquirrelCage, length: float) -> list:
    """Ring, bar and flange of half a pitch [mm], sharp edges of the bar marked."""
    ring, bar, *_, flange = solids(part, length)
    wedge = _wedge(part)
    pieces = [body * wedge for body in (ring, bar, flange)]
    if part.fillet > 0:
        sharp = solids(replace(part, fillet=0.0), length)[1]
        require_kept(pieces[1], sharp * wedge, part.fillet * MILLIMETRES)
    else:
        for edge in pieces[1].edges:
            if abs(edge.start.x - edge.end.x) < NEAR and edge.center.y > NEAR:
                edge.hpref = 1
    return pieces


def _wedge(part: SquirrelCage):
    """All between the azimuths 0 and pi / bars [mm]."""
    radius, half = part.raceway_diameter / 2 * MILLIMETRES, part.width / 2 * MILLIMETRES
    right = half + (part.bar_length + part.flange_length) * MILLIMETRES
    angle = 180 / part.bars
    pen = occ.WorkPlane(occ.Axes(occ.Pnt(-2 * half, radius / 2, 0), n=occ.Z, h=occ.X))
    section = pen.Rectangle(right + 4 * half, radius + 2 * part.thickness * MILLIMETRES).Face()
    # turned from the y-axis towards z, that is towards smaller azimuths
    return section.Revolve(_AXIS, angle).Rotate(_AXIS, 90 - angle)
