"""Bodies of revolution as named polygons on the half-plane of x (axial) next to r (radial).

A body carries the name of its material. Edges are named "raceway", exactly the loaded band, "clamped"
or "foundation" where the part is held, "lines" where line loads may act, "seat" between bodies.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import singledispatch
from math import cos, hypot, isinf, sin, tan

from fem.mesh.expense import polygon, require_affordable
from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import Housing, edge_names
from fem.parts.groove import Groove
from fem.parts.rings import MIDDLE, ImpossiblePart, MeshSize, OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage

FINER = ("raceway", "lines")  # edges with elements of a size of their own
AXIS = 0.005  # bore in the section of a solid shaft over its diameter: elastic to 1e-4, no 1/r at r = 0


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
def sections(part, length: float, rows: Sequence[float] = MIDDLE) -> list[AxialSection]:
    """Bodies of a part as polygons that touch along whole edges, corners in counter-clockwise order.

    Loaded bands of `length` [m] are centred on the places of `rows` [m], all on the track of the part; a
    groove has the width that its lands leave it.
    Raises `ImpossiblePart` if the part is not a body of revolution.
    """
    raise ImpossiblePart(f"{type(part).__name__} is not known as a body of revolution")


@sections.register
def _(part: OuterRing, length, rows=MIDDLE):
    inner, (left, right) = part.raceway_diameter / 2, part.sides
    outer, half = inner + part.thickness, half_band(part.groove, inner, 1, length)
    rows, bends = rows_of_grooves(part.groove, inner, 1, rows, 2)
    bore = _on_cone([(left, inner, None), *_bands(rows, half, inner), (right, inner, None)], part)
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
def _(part: RingOnShaft, length, rows=MIDDLE):
    raceway, rib, bore = part.raceway_diameter / 2, part.outside_diameter / 2, part.bore / 2
    hollow = part.shaft_bore / 2 or AXIS * bore
    track, side, end = part.track_width / 2, part.width / 2, part.shaft_length / 2
    half = half_band(part.groove, raceway, -1, length)
    ribs = [[(side, rib, None), (track, rib, None)], [(-track, rib, None), (-side, rib, None)]]
    right, left = ribs if part.rib_diameter is not None else ([], [])
    rows, bends = rows_of_grooves(part.groove, raceway, -1, rows, 4 + len(right))
    surface = [(track, raceway, None), *_bands(rows, -half, raceway), (-track, raceway, None)]
    ring = AxialSection("ring", (
        (-side, bore, None), (side, bore, "seat"), *right, *_on_cone(surface, part), *left,
    ), bends)  # fmt: skip
    shaft = AxialSection("shaft", (
        (-end, hollow, None), (end, hollow, None), (end, bore, "clamped"), (side, bore, None),
        (-side, bore, "seat"), (-end, bore, None), (-end, hollow, "clamped"),
    ))  # fmt: skip
    return [ring, shaft]


@sections.register
def _(part: BoltedRing, length, rows=MIDDLE):
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


def _on_cone(
    corners: Sequence[tuple[float, float, str | None]], part: OuterRing | RingOnShaft
) -> list[tuple[float, float, str | None]]:
    """Corners of a cylinder on a cone of the same radius at x = 0; on two of that radius in their middles."""
    slope, apart = tan(part.taper), part.row_distance
    return [(x, r + slope * (apart / 2 - abs(x) if apart else x), name) for x, r, name in corners]


def _bands(rows: Sequence[float], half: float, radius: float) -> list[tuple[float, float, str | None]]:
    """Corners of loaded bands one after the other, towards +x; of negative halves of their length, -x."""
    places = sorted(rows, reverse=bool(half < 0))
    return [corner for x in places for corner in ((x - half, radius, None), (x + half, radius, "raceway"))]


def smeared_sections(cage: SquirrelCage, length: float) -> list[AxialSection]:
    """Ring, sleeves and flanges as polygons that touch along whole edges."""
    inner, (left, right) = cage.raceway_diameter / 2, cage.sides
    half = half_band(cage.groove, inner, 1, length)
    bends = {} if cage.groove is None else {2: start_of_arc(cage.groove.end(inner, 1), 1)}
    low, high = cage.bar_radii
    feet = [[(right, low, None), (right, high, None)], [(left, high, None), (left, low, None)]]
    at_right, at_left = feet if cage.two_sided else (feet[0], [])
    outline = [(x, r, None) for x, r in cage.outline]
    ring = AxialSection("ring", (
        (left, inner, None), (-half, inner, None), (half, inner, "raceway"), (right, inner, None),
        *at_right, *outline, *at_left,
    ), bends)  # fmt: skip
    return [ring, *(section for end in cage.ends for section in _sleeve_and_flange(cage, end))]


def _sleeve_and_flange(cage: SquirrelCage, end: int) -> tuple[AxialSection, AxialSection]:
    """What rests on one end of the ring."""
    inner, side, (low, high) = cage.raceway_diameter / 2, cage.end_distance(end), cage.bar_radii
    outer, foot = inner + cage.thickness, side + cage.bar_length
    last = foot + cage.flange_length
    sleeve = ((side, low, None), (foot, low, None), (foot, high, None), (side, high, None))
    flange = (
        (foot, inner, None), (last, inner, None), (last, outer, "clamped"), (foot, outer, None),
        (foot, high, None), (foot, low, None),
    )  # fmt: skip
    if end > 0:
        return AxialSection("bars", sleeve), AxialSection("flange", flange)
    return AxialSection("bars", _mirrored(sleeve)), AxialSection("flange", _mirrored(flange))


def _mirrored(corners: tuple) -> tuple:
    """The mirror image of a polygon at x = 0, counter-clockwise again; names stay with their edges."""
    names = [name for _, _, name in corners]
    backwards = zip(reversed(corners), [names[0], *reversed(names[1:])], strict=True)
    return tuple((-x, r, name) for (x, r, _), name in backwards)


def half_band(groove: Groove | None, land: float, outward: int, length: float) -> float:
    """Half of what is loaded along the axis [m]: the arc of a groove, or a band of some length."""
    return length / 2 if groove is None else groove.width(land, outward) / 2


def rows_of_grooves(
    groove: Groove | None, land: float, outward: int, rows: Sequence[float], first: int
) -> tuple[Sequence[float], dict[int, tuple[float, float]]]:
    """Places of loaded bands, of grooves those of their rows, and bends of arcs that end at every other
    corner from the `first` on; of bands without a groove none.
    """
    if groove is None:
        return rows, {}
    arc = start_of_arc(groove.end(land, outward), outward)
    return groove.places, {first + 2 * row: arc for row in range(len(groove.places))}


def start_of_arc(angle: float, outward: int) -> tuple[float, float]:
    """Direction (x, r) of an arc where it begins at a contact angle, counter-clockwise around its section."""
    return outward * cos(angle), outward * sin(angle)


def require_affordable_section(bodies: list[AxialSection], mesh_size: MeshSize) -> None:
    """Refuse a mesh of far more unknowns than a computer can solve for; raises `NotSolved`."""
    polygons = [polygon([corner[:2] for corner in body.corners]) for body in bodies]
    require_affordable(2, polygons, sum(body.loaded for body in bodies), mesh_size)
