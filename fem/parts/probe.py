"""A place on the surface of a ring where strain and displacement are read, as frozen data."""

from dataclasses import dataclass
from math import degrees, pi, sin
from typing import TYPE_CHECKING

from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import Housing
from fem.parts.groove import Groove
from fem.parts.material import ImpossiblePart, in_mm
from fem.parts.part import Part
from fem.parts.rings import OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage

if TYPE_CHECKING:
    from fem.parts.step_solid import StepSolid

INSIDE = 1e-6  # of the wall, by which readings stay away from its surface, where a mesh may end by rounding

Wall = tuple[float, float, float, float]  # from x to x, inner and outer radius [m]


@dataclass(frozen=True, kw_only=True)
class Probe:
    """A strain gauge or a displacement sensor; its readings are means along its length."""

    azimuth: float  # [rad] of its middle
    x: float  # [m]
    outside: bool  # on the outermost surface there, else on the innermost one
    depth: float  # [m] below that surface
    angle: (
        float  # [rad] of its length to the circumference, positive: its end at larger azimuth is at larger x
    )
    length: float  # [m] 0 reads a point


def radius(part: "Part | StepSolid", probe: Probe) -> float:
    """Radius at which a probe reads [m].

    Raises `ImpossiblePart` where the part has no material, or no known surfaces.
    """
    if not isinstance(part, Part):
        raise ImpossiblePart("surfaces of a drawn solid are not known; allowed are rings and squirrel cages")
    there = [wall for wall in walls(part) if wall[0] <= probe.x <= wall[1]]
    if not there:
        raise ImpossiblePart(f"x = {in_mm(probe.x)} is beside the part")
    low, high = min(wall[2] for wall in there), max(wall[3] for wall in there)
    if isinstance(part, SquirrelCage) and (low, high) == part.bar_radii:
        _require_on_bar(part, probe)
    if part.groove is not None:
        low, high = _beside_groove(part, part.groove, probe.x, low, high)
    if not probe.outside and low == 0:
        raise ImpossiblePart("a solid shaft has no inner surface; allowed is the outer one with a depth")
    if probe.depth > high - low:
        raise ImpossiblePart(f"depth = {in_mm(probe.depth)}; allowed is up to the wall, {in_mm(high - low)}")
    depth = min(max(probe.depth, INSIDE * (high - low)), (1 - INSIDE) * (high - low))
    return high - depth if probe.outside else low + depth


def walls(part: Part) -> list[Wall]:
    """Cylinders that a part is made of, without fillets."""
    inner = part.raceway_diameter / 2
    if isinstance(part, BoltedRing):
        low, high = sorted((inner, part.far_diameter / 2))
        return [(*part.ends, low, high)]
    if isinstance(part, RingOnShaft):
        bore, side, track = part.bore / 2, part.width / 2, part.track_width / 2
        end, rib = part.shaft_length / 2, part.outside_diameter / 2
        ribs = [(-side, -track, bore, rib), (track, side, bore, rib)]
        return [(-end, end, part.shaft_bore / 2, bore), (-track, track, bore, inner), *ribs]
    outer = inner + part.thickness
    ring = (*part.sides, inner, outer)
    if isinstance(part, OuterRing):
        housing = part.support
        if not isinstance(housing, Housing):
            return [ring]
        half = housing.width / 2
        return [ring, (-half - part.offset, half - part.offset, outer, outer + housing.thickness)]
    found = [ring]
    for end in part.ends:
        start = part.end_distance(end)
        stop = start + part.bar_length
        found += [_at_end(end, start, stop, *part.bar_radii)]
        found += [_at_end(end, stop, stop + part.flange_length, inner, outer)]
        if part.has_collar:
            found += [_at_end(end, start - part.collar_length, start, inner, inner + part.collar_thickness)]
    return found


def _at_end(end: int, near: float, far: float, inner: float, outer: float) -> Wall:
    """A cylinder from its distances along +x or -x [m]."""
    first, last = sorted((end * near, end * far))
    return first, last, inner, outer


def _beside_groove(part: Part, groove: Groove, x: float, low: float, high: float) -> tuple[float, float]:
    """Inner and outer radius [m] of a wall between which the groove leaves material."""
    land = part.raceway_diameter / 2
    surface = groove.surface(x, land, part.outward)
    if part.outward < 0:
        return low, surface if high == land else high
    return surface if low == land else low, high


def _require_on_bar(cage: SquirrelCage, probe: Probe) -> None:
    """Refuse a probe between ring and flange that misses the bars, or on bars that are spread evenly."""
    at = f"x = {in_mm(probe.x)} at {degrees(probe.azimuth):.4g} deg"
    if cage.groove is not None:
        raise ImpossiblePart(f"{at} is between ring and flange, where bars below balls are spread evenly")
    pitch = 2 * pi / cage.bars
    off = (probe.azimuth + pitch / 2) % pitch - pitch / 2
    if abs(cage.bar_radii[1] * sin(off)) > cage.bar_width / 2:
        raise ImpossiblePart(f"{at} is in a slot between bars")
