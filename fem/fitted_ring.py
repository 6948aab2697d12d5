"""An inner ring held on a hollow shaft by a fit, both condensed to where they touch.

`condense_fitted` is the way in; `fem.settled_fit.settled` and `fem.loaded_fit.loaded` go on from there.
"""

import logging
import time
from dataclasses import dataclass, field

from fem.fit_surface import CondensedBody, Face, condense_body
from fem.harmonics import highest_harmonic
from fem.material import ImpossiblePart
from fem.meridian import Section, sections
from fem.parts import SLENDEREST_SLOT, Mesh, RingOnShaft
from fem.revolved_body import assembled
from fem.solve import NotSolved, threads

BORE, SHOULDER = 0, 1  # numbers of the faces

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class FittedRing:
    """An inner ring on a hollow shaft, perhaps against a shoulder."""

    seat: RingOnShaft  # nominal dimensions; its bond is not used
    shoulder_diameter: float | None = None  # [m] of the shaft beyond the face of the ring at x = +width/2

    def __post_init__(self):
        if self.shoulder_diameter is not None:
            wall = 2 * SLENDEREST_SLOT
            low, high = self.seat.bore + wall, self.seat.rib_diameter - wall
            if not low <= self.shoulder_diameter <= high:
                raise ImpossiblePart(
                    f"shoulder_diameter = {self.shoulder_diameter!r} is impossible; allowed is {low:.6g} to "
                    f"{high:.6g} m, between bore and ribs"
                )


@dataclass(frozen=True, kw_only=True)
class FitGrid:
    """How finely the forces between ring and shaft are resolved."""

    bore_points: int = 10  # along the axis
    shoulder_points: int = 4  # along the radius
    harmonics: int = 36  # N around the circumference, on 2 N + 1 azimuths; beyond it the fit carries nothing

    def __post_init__(self):
        if self.harmonics < 3:
            raise ImpossiblePart(f"harmonics = {self.harmonics!r} of the fit; allowed is 3 or more")


@dataclass(frozen=True, kw_only=True)
class FittedBodies:
    """Ring and shaft condensed once, for all fits and loads."""

    part: FittedRing
    length: float  # l of the loaded band [m]
    ring: CondensedBody
    shaft: CondensedBody
    seconds: dict[str, float] = field(compare=False)  # by stage: factor, condense


def condense_fitted(
    part: FittedRing, length: float, shapes: int, mesh: Mesh, grid: FitGrid | None = None
) -> FittedBodies:
    """Condense ring and shaft to the bore, the shoulder and the raceway.

    Parameters
    ----------
    part : FittedRing
        ring and shaft
    length : float
        l of the loaded band [m]
    shapes : int
        M, number of axial shapes, 1 or more
    mesh : Mesh
        wishes for the finite elements; order 5 or 6 pays
    grid : FitGrid
        resolution of the fit

    Returns
    -------
    FittedBodies

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track
    NotSolved
        if a solve fails, or if the mesh is too coarse for the harmonics of the fit

    Valid
    -----
    Small displacement, shaft ends that do not yield to loads but follow heat and rotation freely; no load
    outside the band.
    """
    seat, grid = part.seat, grid or FitGrid()
    if length > seat.track * (1 + 1e-9):
        raise ImpossiblePart(
            f"length = {length!r} m of the loaded band; allowed is the track, {seat.track!r} m"
        )
    last = highest_harmonic(seat.raceway_diameter / 2, length / shapes, mesh)
    if last < grid.harmonics:
        raise NotSolved(
            f"{grid.harmonics} harmonics of the fit are more than the {last} of the raceway: "
            "a smaller raceway_size or a higher order resolves more"
        )
    faces = (Face(edge="seat", component=1, sign=1.0, points=grid.bore_points),)
    if part.shoulder_diameter is not None:
        faces += (Face(edge="shoulder", component=0, sign=-1.0, points=grid.shoulder_points),)
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        bodies = [assembled([section], seat.materials, mesh) for section in _sections(part, length)]
        ready = time.perf_counter()
        ring = condense_body(bodies[0], faces, grid.harmonics, (shapes, last), pushed="far")
        shaft = condense_body(bodies[1], faces, grid.harmonics)
    done = time.perf_counter()
    _log.info("FittedRing: %d unknowns, %.1f s", ring.unknowns + shaft.unknowns, done - start)
    seconds = {"factor": ready - start, "condense": done - ready}
    return FittedBodies(part=part, length=length, ring=ring, shaft=shaft, seconds=seconds)


def _sections(part: FittedRing, length: float) -> tuple[Section, Section]:
    """Ring, whose face away from the shoulder is "far", with the shaft, which is cut to the shoulder."""
    ring, shaft = sections(part.seat, length)
    around = [(*ring.corners[0][:2], "far"), *ring.corners[1:]]
    along = list(shaft.corners)
    if part.shoulder_diameter is not None:
        top = part.shoulder_diameter / 2
        side, bore = along[3][:2]
        around.insert(2, (side, top, "shoulder"))
        along[2:4] = [(along[2][0], top, "clamped"), (side, top, None), (side, bore, "shoulder")]
    return Section(ring.material, tuple(around)), Section(shaft.material, tuple(along))
