"""Places whose stress is neither that of a contact nor that of a sharp edge."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from fem.mesh.notches import Notches, notches
from fem.parts.groove import BallPatches, Groove
from fem.parts.rings import Part, Patches, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage
from fem.parts.step_solid import StepSolid

CONTACT = 4.0  # standard deviations of a load patch: within them its own stress rules, which is the contact's
UNLOADED = 1e-3  # of the largest force of a roller or ball: below it there is no contact to keep away from
JUST_BEYOND = 1e-6  # of a distance
MOVED = 1000  # places of a contact that are moved to where its reach ends: there the field is smooth


class Contact(Protocol):
    """Line on a raceway that an element at an azimuth [rad] presses."""

    def nearest(self, places: NDArray, phi: float) -> NDArray:
        """Of the line, the places (n, 3) next to places (n, 3) [m]."""
        ...

    def turned(self, places: NDArray, phi: float, reach: float) -> NDArray:
        """Places turned around the axis to where they are at a reach [m] from the line, where that can be."""
        ...


@dataclass(frozen=True)
class RollerLine:
    """Line of a roller on a cylinder, its middle at x = 0."""

    radius: float  # [m] of the raceway
    length: float  # [m]

    def nearest(self, places: NDArray, phi: float) -> NDArray:
        """Of the line, the places (n, 3) next to places (n, 3) [m]."""
        x = np.clip(places[:, 0], -self.length / 2, self.length / 2)
        return np.stack(np.broadcast_arrays(x, self.radius * np.sin(phi), self.radius * np.cos(phi)), axis=1)

    def turned(self, places: NDArray, phi: float, reach: float) -> NDArray:
        """Places turned around the axis to where they are at a reach [m] from the line, where that can be."""
        x, y, z = places.T
        r = np.hypot(y, z)
        across = reach**2 - np.maximum(np.abs(x) - self.length / 2, 0) ** 2
        cosine = (self.radius**2 + r**2 - across) / (2 * self.radius * r)
        there = np.abs(cosine) < 1
        side = np.sign(np.sin(np.arctan2(y, z) - phi))
        azimuth = phi + side[there] * np.arccos(cosine[there])
        return np.stack([x[there], r[there] * np.sin(azimuth), r[there] * np.cos(azimuth)], axis=1)


@dataclass(frozen=True)
class GrooveArc:
    """Arc of a groove between the contact angles of the patches on which a ball presses."""

    groove: Groove
    outward: int  # 1 where the race is outside the balls, else -1
    ends: tuple[float, float]  # [rad]

    def nearest(self, places: NDArray, phi: float) -> NDArray:
        """Of the arc, the places (n, 3) next to places (n, 3) [m]."""
        x, y, z = places.T
        depth = self.outward * (y * np.sin(phi) + z * np.cos(phi) - self.groove.centre_radius)
        angle = np.clip(np.arctan2(x, depth), *self.ends)
        r = self.groove.centre_radius + self.outward * self.groove.radius * np.cos(angle)
        return np.stack([self.groove.radius * np.sin(angle), r * np.sin(phi), r * np.cos(phi)], axis=1)

    def turned(self, places: NDArray, phi: float, reach: float) -> NDArray:
        """No places: those pushed away from the arc are close enough to its end."""
        return np.zeros((0, 3))


@dataclass(frozen=True, kw_only=True)
class Clearing:
    """What says whether stresses of a place count, see `clearing`."""

    part: Part | StepSolid
    sharp: Notches
    loaded: NDArray  # (n,) azimuths of loaded rollers or balls [rad]
    contact: Contact
    reach: float  # [m] within which of a contact's line places do not count
    tips: NDArray | None  # of fillets, see `_tips`

    def __call__(self, places: NDArray) -> NDArray:
        """Whether places (n, 3) [m] count (n,)."""
        x, y, z = places.T
        far = self.sharp.clear(x, np.hypot(y, z))
        for phi in self.loaded:
            far &= self._distance(places, phi) > self.reach
        return far if self.tips is None else far & _beyond_tips(self.part, self.tips, places)

    def rim(self, places: NDArray) -> NDArray:
        """Places (m, 3) [m] where the reach of contacts ends, from places (n, 3) [m] within it.

        Stress decays with the inverse of the distance there: a sample that is 1 % away misses 1 %. They are
        about `MOVED` of every contact, moved around the axis, and moved straight away from its line.
        """
        moved, end = [np.zeros((0, 3))], (1 + JUST_BEYOND) * self.reach
        for phi in self.loaded:
            within = places[self._distance(places, phi) <= self.reach]
            within = within[:: 1 + len(within) // MOVED]
            moved += [self.contact.turned(within, phi, end), self._pushed(within, phi, end)]
        rim = np.concatenate(moved)
        return rim[self(rim)]

    def _distance(self, places: NDArray, phi: float) -> NDArray:
        """From places (n, 3) to the line of a contact (n,)."""
        return np.linalg.norm(places - self.contact.nearest(places, phi), axis=1)

    def _pushed(self, places: NDArray, phi: float, end: float) -> NDArray:
        """Places within reach pushed away from the line of a contact to its end."""
        nearest = self.contact.nearest(places, phi)
        away = places - nearest
        distance = np.linalg.norm(away, axis=1)
        off = distance > 0
        return nearest[off] + away[off] * (end / distance[off])[:, None]


def clearing(
    part: Part | StepSolid, patches: Patches | BallPatches, forces: NDArray, radius: float
) -> Clearing:
    """What says whether stresses of a place count.

    Left out is what lies within `CONTACT` patch widths of the line of a loaded contact, where the Gaussian
    patch rules, which is not the true contact; close to sharp edges (`fem.mesh.notches`), where a finer mesh
    gives ever more; and, within a fillet's radius, the tips where the fillets of a bar's four sides meet. The
    line of a ball is the arc between the outermost patches that carry anything of any ball.

    `forces` are generalised (Z, M) [N], or on stations of a groove; `radius` is that of the raceway [m].
    """
    on_balls = isinstance(patches, BallPatches)
    load = np.abs(forces.sum(axis=1) if on_balls else forces[:, 0])
    return Clearing(
        part=part, sharp=notches(part), loaded=np.array(patches.azimuths)[load > UNLOADED * load.max()],
        contact=_arc(part, patches, forces) if on_balls else RollerLine(radius, patches.length),
        reach=CONTACT * patches.width,
        tips=_tips(part) if isinstance(part, SquirrelCage) and part.fillet > 0 else None,
    )  # fmt: skip


def _arc(part: Part | StepSolid, patches: BallPatches, forces: NDArray) -> GrooveArc:
    groove = getattr(part, "groove", None)
    assert groove  # of every part under balls
    load = np.abs(forces).max(axis=0)
    pressed = np.array(patches.stations.angles)[load > UNLOADED * load.max()]
    outward = -1 if isinstance(part, RingOnShaft) else 1
    return GrooveArc(groove, outward, (float(pressed.min()), float(pressed.max())))


def _tips(cage: SquirrelCage) -> NDArray:
    """Where fillets of neighbouring sides of a bar at azimuth 0 meet (8 an end, 3) [m]."""
    side, tips = cage.bar_width / 2, []
    for end in cage.ends:
        start = cage.end_distance(end)
        stop = start + cage.bar_length - cage.fillet
        tips += [end * (start + cage.fillet), end * stop]
    radii = (np.sqrt(r**2 - side**2) for r in cage.bar_radii)
    return np.array([(x, t, r) for r in radii for x in tips for t in (-side, side)])


def _beyond_tips(cage, tips: NDArray, places: NDArray) -> NDArray:
    """Whether places (n, 3) are further from tips of all bars than the radius of a fillet."""
    pitch, radius = 2 * np.pi / cage.bars, np.hypot(places[:, 1], places[:, 2])
    azimuth = np.arctan2(places[:, 1], places[:, 2])
    azimuth -= pitch * np.round(azimuth / pitch)
    turned = np.stack([places[:, 0], radius * np.sin(azimuth), radius * np.cos(azimuth)], axis=1)
    nearest = np.min([((turned - tip) ** 2).sum(axis=1) for tip in tips], axis=0)
    return nearest > cage.fillet**2
