"""The section of a ring with a gothic groove, drawn with its arches."""

from math import cos, isinf, sin

from fem.mesh.axial_section import AxialSection
from fem.parts.bolted_ring import BoltedGrooveRing
from fem.parts.material import require

Corner = tuple[float, float, str | None]


def section(ring: BoltedGrooveRing, length: float) -> AxialSection:
    """Section of a ring; the loaded lines on both arches are named "raceway".

    Parameters
    ----------
    ring : BoltedGrooveRing
        the part
    length : float
        l of each loaded line, across the groove along the arch [m]

    Returns
    -------
    AxialSection
        its bolted face is named "clamped", or "foundation" on springs

    Raises
    ------
    ImpossiblePart
        if the lines are longer than the arches
    """
    first = -ring.outward  # the side of the groove that comes first with the ring to the left
    groove, bends = _groove(ring, length, first)
    middle, sign = ring.pitch_diameter / 2, ring.outward
    land, far = middle + sign * ring.at(ring.groove_end)[1], ring.far_diameter / 2
    ends = {
        ring.face_side: ring.face_side * ring.face_distance,
        -ring.face_side: -ring.face_side * (ring.width - ring.face_distance),
    }
    faces = {ring.face_side: "clamped" if isinf(ring.normal_stiffness) else "foundation"}
    corners = (
        (ends[first], land, faces.get(first)),
        *((x, middle + sign * y, name) for x, y, name in groove),
        (ends[-first], land, None),
        (ends[-first], far, faces.get(-first)),
        (ends[first], far, None),
    )
    return AxialSection("ring", corners, {k + 1: (along, sign * into) for k, (along, into) in bends.items()})


def _groove(ring: BoltedGrooveRing, length: float, first: int) -> tuple[list[Corner], dict]:
    """Corners from shoulder to shoulder, along x and into the ring from the ball centre [m], and arcs."""
    half = length / (2 * ring.groove_radius)
    reach = min(ring.contact_angle - ring.bottom_angle, ring.groove_end - ring.contact_angle)
    most = 2 * ring.groove_radius * reach
    require(0 < length < most, "length", length, f"above zero and below {most:.6g} m, or it leaves the arch")
    down = [ring.groove_end, ring.contact_angle + half, ring.contact_angle - half, ring.bottom_angle]
    names = None, None, "raceway", None
    corners: list[Corner] = [
        (first * ring.at(a)[0], ring.at(a)[1], n) for a, n in zip(down, names, strict=True)
    ]
    corners += [
        (-first * ring.at(a)[0], ring.at(a)[1], n) for a, n in zip(down[2::-1], names[1:], strict=True)
    ]
    # tangents at the start of the edges that end at corners 1, 2, 3 (downwards) and 4, 5, 6 (upwards)
    bends = {k + 1: (-first * cos(a), sin(a)) for k, a in enumerate(down[:3])}
    bends |= {k + 4: (-first * cos(a), -sin(a)) for k, a in enumerate(down[:0:-1])}
    return corners, bends
