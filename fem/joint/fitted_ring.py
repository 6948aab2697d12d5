"""A ring held by a fit, on a hollow shaft or in a housing, both condensed to where they touch.

`condense_fitted` is the way in; `fem.joint.preloaded_fit.preloaded` and `fem.joint.loaded_fit.loaded` go on
from there.
"""

import logging
import time
from collections.abc import Mapping
from dataclasses import dataclass, field

from fem.assembly.factorisation import threads
from fem.joint.face_condensation import CondensedBody, ContactFace, condense_body
from fem.mesh.axial_section import AxialSection, sections
from fem.parts.boundary_conditions import ClampedFace, Housing, RigidSeat
from fem.parts.material import ImpossiblePart
from fem.parts.resolution import Resolution, Shape
from fem.parts.rings import OuterRing, RingOnShaft, require_on_track
from fem.raceway.harmonics import highest_harmonic, resolving
from fem.section.expansion import Along
from fem.section.raceway_shapes import last_harmonic_of_patches, raceway_modes
from fem.section.revolved_body import assembled

LOWEST = 3  # harmonics that any fit is condensed with
BORE, SHOULDER = 0, 1  # numbers of the faces

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class FittedRing:
    """An inner ring on a hollow shaft, perhaps against a shoulder."""

    seat: RingOnShaft  # nominal dimensions; its bond is not used
    shoulder_diameter: float | None = None  # [m] of the shaft beyond the face of the ring at x = +width/2

    def __post_init__(self):
        if self.shoulder_diameter is not None:
            self.seat.require_shoulder(self.shoulder_diameter)

    def faces(self, grid: "FitGrid") -> tuple[ContactFace, ...]:
        """Where ring and shaft can touch."""
        bore = ContactFace(edge="seat", component=1, sign=1.0, points=grid.bore_points)
        if self.shoulder_diameter is None:
            return (bore,)
        return bore, ContactFace(edge="shoulder", component=0, sign=-1.0, points=grid.shoulder_points)

    def sections(self, length: float) -> tuple[AxialSection, AxialSection]:
        """Ring, whose face away from the shoulder is "far", with the shaft, which is cut to the shoulder."""
        ring, shaft = sections(self.seat, length)
        ring_corners = [(*ring.corners[0][:2], "far"), *ring.corners[1:]]
        shaft_corners = list(shaft.corners)
        if self.shoulder_diameter is not None:
            top, end = self.shoulder_diameter / 2, shaft_corners[2][0]
            side, bore = shaft_corners[3][:2]
            ring_corners.insert(2, (side, top, "shoulder"))
            shaft_corners[2:4] = [(end, top, "clamped"), (side, top, None), (side, bore, "shoulder")]
        return (
            AxialSection(ring.material, tuple(ring_corners)),
            AxialSection(shaft.material, tuple(shaft_corners)),
        )


@dataclass(frozen=True, kw_only=True)
class HousedRing:
    """An outer ring in the bore of a housing, which it need not fill."""

    seat: OuterRing  # nominal dimensions, in a `Housing`; its bond is not used

    def __post_init__(self):
        housing = self.seat.support
        if not isinstance(housing, Housing) or not isinstance(housing.support, ClampedFace | RigidSeat):
            raise ImpossiblePart(
                f"support = {housing!r} is impossible; allowed is a Housing whose support is a ClampedFace "
                "or a RigidSeat"
            )

    def faces(self, grid: "FitGrid") -> tuple[ContactFace, ...]:
        """Where ring and housing can touch; pressure pushes the ring inwards."""
        return (ContactFace(edge="seat", component=1, sign=-1.0, points=grid.bore_points),)

    def sections(self, length: float) -> tuple[AxialSection, AxialSection]:
        """Ring with the housing."""
        ring, housing = sections(self.seat, length)
        return ring, housing


@dataclass(frozen=True, kw_only=True)
class FitGrid:
    """How finely the forces between ring and mate are resolved."""

    bore_points: int = 10  # along the axis
    shoulder_points: int = 4  # along the radius
    harmonics: int = 36  # N around the circumference, on 2 N + 1 azimuths; beyond it the fit carries nothing

    def __post_init__(self):
        if self.harmonics < LOWEST:
            raise ImpossiblePart(f"harmonics = {self.harmonics!r} of the fit; allowed is 3 or more")


@dataclass(frozen=True, kw_only=True)
class FittedBodies:
    """Ring and mate, that is shaft or housing, condensed once for all fits and loads."""

    part: FittedRing | HousedRing
    resolution: Resolution
    ring: CondensedBody
    mate: CondensedBody
    seconds: dict[str, float] = field(compare=False)  # by stage: factor, condense


def condense_fitted(
    part: FittedRing | HousedRing,
    resolution: Resolution,
    grid: FitGrid | None = None,
    variations: Mapping[str, Along] | None = None,
) -> FittedBodies:
    """Condense ring and mate to the bore, the shoulder and the raceway.

    Variations are free expansions along the axis by the name of a body, beyond the even ones of
    `fem.joint.preloaded_fit.Fit`.
    Raises `ImpossiblePart` if the band is longer than the track, or a variation ends inside its body;
    `NotSolved` if a solve fails.

    Valid
    -----
    Small displacement, clamps that are rigid to loads but follow heat and rotation freely; no load
    outside the band.
    """
    grid, shape = grid or FitGrid(), resolution.nodes_of or Shape(part=part, length=resolution.length)
    seat, detail = shape.part.seat, shape.length / resolution.axial_modes
    radius = seat.raceway_diameter / 2
    if seat.groove is None:
        of_raceway = highest_harmonic(radius, detail, resolution.mesh)
    else:
        of_raceway = last_harmonic_of_patches(seat, resolution)
    last = max(grid.harmonics, of_raceway)
    return _condensed(part, resolving(resolution, radius, last), last, grid, variations)


def condense_axisymmetric(
    part: FittedRing | HousedRing, resolution: Resolution, variations: Mapping[str, Along] | None = None
) -> FittedBodies:
    """Condense ring and mate for `fem.joint.preloaded_fit.preloaded` alone.

    Pressure and expansion are those of the whole fit, loads of rollers are not known.
    """
    return _condensed(part, resolution, LOWEST, FitGrid(harmonics=LOWEST), variations)


def _condensed(
    part: FittedRing | HousedRing,
    resolution: Resolution,
    last: int,  # harmonic of the raceway
    grid: FitGrid,
    variations: Mapping[str, Along] | None,
) -> FittedBodies:
    seat, length, nodes_of = part.seat, resolution.length, resolution.nodes_of
    require_on_track(length, seat.track)
    faces, pushed = part.faces(grid), "far" if isinstance(part, FittedRing) else None
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        others = nodes_of.part.sections(nodes_of.length) if nodes_of else (None, None)
        bodies = [
            assembled([section], seat.materials, resolution.mesh, nodes_of=other and [other])
            for section, other in zip(part.sections(length), others, strict=True)
        ]
        ready = time.perf_counter()
        raceway = raceway_modes(bodies[0], seat, resolution), last
        ring = condense_body(bodies[0], faces, grid.harmonics, raceway, pushed, variations)
        mate = condense_body(bodies[1], faces, grid.harmonics, variations=variations)
    done = time.perf_counter()
    _log.info("%s: %d unknowns, %.1f s", type(part).__name__, ring.unknowns + mate.unknowns, done - start)
    seconds = {"factor": ready - start, "condense": done - ready}
    return FittedBodies(part=part, resolution=resolution, ring=ring, mate=mate, seconds=seconds)
