"""Sharp re-entrant edges of a part and the rims of its clamps, where linear elasticity has no finite stress.

They are lines of the axial section, taken to run all around: (x, r) of both ends in metres.
"""

from dataclasses import dataclass
from functools import singledispatch

import numpy as np
from numpy.typing import NDArray

from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import ClampedFace, Housing
from fem.parts.rings import OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage
from fem.parts.step_solid import StepSolid

JUST_BEYOND = 1e-6  # of the reach
REACH = 0.4  # of the wall: beyond, a notch is hardly felt (IIW, nearest point of the hot spot stress)


@dataclass(frozen=True)
class Notches:
    """Lines in the axial section, and the wall that they are in."""

    lines: NDArray  # (K, 2, 2) [m] (x, r) of both ends
    wall: float  # [m] thickness

    @property
    def reach(self) -> float:
        """Distance that their own stress reaches [m]."""
        return REACH * self.wall

    def clear(self, x: NDArray, radius: NDArray) -> NDArray:
        """Whether points of the axial section [m] lie further away than the reach."""
        points = np.stack([x, radius], axis=1)
        far = np.ones(len(points), dtype=bool)
        for start, end in self.lines:
            along = end - start
            t = np.clip((points - start) @ along / (along @ along or 1.0), 0, 1)
            far &= np.linalg.norm(points - start - t[:, None] * along, axis=1) > self.reach
        return far

    def around(self, intervals: int) -> NDArray:
        """Points (n, 2) of the axial section just beyond the reach, x and radius [m].

        Intervals are along the way on the reach's length.
        """
        distance, places = self.reach * (1 + JUST_BEYOND), [np.zeros((0, 2))]
        turn = np.linspace(0, 2 * np.pi, 6 * intervals, endpoint=False)
        circle = distance * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        for start, end in self.lines:
            along = end - start
            length = float(np.hypot(*along))
            places += [start + circle, end + circle]
            if length > 0:
                across = distance / length * np.array([-along[1], along[0]])
                steps = np.linspace(0, 1, max(2, int(np.ceil(intervals * length / self.reach)) + 1))[:, None]
                places += [start + steps * along + across, start + steps * along - across]
        return np.concatenate(places)


@singledispatch
def notches(part) -> Notches:
    """Notches of a part, none for a drawn solid, of which no edges are known.

    Raises `TypeError` for a part of which no notches are known.
    """
    raise TypeError(f"no notches are known for {type(part).__name__}")


@notches.register
def _(part: SquirrelCage):
    lines = [line for end in part.ends for line in _at_end(part, end)]
    outer = part.raceway_diameter / 2 + part.thickness
    collars = [_rim(x, r) for x, r in part.outline[1:-1] if r == outer]
    return Notches(np.array(lines + collars), part.bar_thickness)


def _at_end(part: SquirrelCage, end: int) -> list:
    """Feet of the bars at one end of the ring, unless they have fillets, and rims of the clamp."""
    inner, start = part.raceway_diameter / 2, part.end_distance(end)
    outer, stop, (low, high) = inner + part.thickness, start + part.bar_length, part.bar_radii
    feet = [((end * x, low), (end * x, high)) for x in (start, stop)]
    clamp = [_rim(end * (stop + part.flange_length), r) for r in (inner, outer)]
    return clamp if part.fillet > 0 else [*feet, *clamp]


@notches.register
def _(part: OuterRing):
    inner, side = part.raceway_diameter / 2, part.width / 2
    outer, support, middle = inner + part.thickness, part.support, -part.offset
    rims = []
    if isinstance(support, Housing):
        rims = [_rim(middle + sign * min(side, support.width / 2), outer) for sign in (-1, 1)]
        inner, outer, side, support = outer, outer + support.thickness, support.width / 2, support.support
    if isinstance(support, ClampedFace):
        rims += [_rim(middle + side, r) for r in (inner, outer)]
    else:
        rims += [_rim(middle + sign * side, outer) for sign in (-1, 1)]
    return Notches(np.array(rims), part.thickness)


@notches.register
def _(part: RingOnShaft):
    raceway, bore, hollow = part.raceway_diameter / 2, part.bore / 2, part.shaft_bore / 2
    corners = [(part.width / 2, bore), (part.shaft_length / 2, bore)]
    if part.rib_diameter is not None:
        corners.append((part.track_width / 2, raceway))
    if hollow:
        corners.append((part.shaft_length / 2, hollow))
    rims = [_rim(sign * x, r) for x, r in corners for sign in (-1, 1)]
    return Notches(np.array(rims), min(bore - hollow, raceway - bore))


@notches.register
def _(part: BoltedRing):
    face, land, far = part.face_side * part.face_distance, part.raceway_diameter / 2, part.far_diameter / 2
    wall = part.outward * (far - part.groove.bottom(part.outward))
    return Notches(np.array([_rim(face, land), _rim(face, far)]), wall)


@notches.register
def _(part: StepSolid):
    return Notches(np.zeros((0, 2, 2)), 0.0)


def _rim(x, radius):
    return (x, radius), (x, radius)
