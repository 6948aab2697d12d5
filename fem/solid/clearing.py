"""Places whose stress is neither that of a contact nor that of a sharp edge."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from fem.mesh.notches import Notches, notches
from fem.parts.groove import BallPatches, Groove
from fem.parts.part import Part
from fem.parts.rings import Patches
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
    side: int = 1  # of the arc, see `Groove.sides`

    def nearest(self, places: NDArray, phi: float) -> NDArray:
        """Of the arc, the places (n, 3) next to places (n, 3) [m]."""
        (x, y, z), groove, towards = places.T, self.groove, self.outward * self.side
        depth = self.outward * (y * np.sin(phi) + z * np.cos(phi) - groove.centre_radius)
        angle = np.clip(np.arctan2(towards * x + groove.aside, depth), *self.ends)
        x = towards * (groove.radius * np.sin(angle) - groove.aside)
        r = groove.centre_radius + self.outward * groove.radius * np.cos(angle)
        return np.stack([x, r * np.sin(phi), r * np.cos(phi)], axis=1)

    def turned(self, places: NDArray, phi: float, reach: float) -> NDArray:
        """No places: those pushed away from the arc are close enough to its end."""
        return np.zeros((0, 3))


@dataclass(frozen=True, kw_only=True)
class Clearing:
    """What says whether stresses of a place count, see `clearing`."""

    part: Part | StepSolid
    sharp: Notches
    loaded: list[tuple[Contact, float]]  # with the azimuth [rad] of the roller or ball that presses it
    reach: float  # [m] within which of a contact's line places do not count
    tips: NDArray | None  # of fillets, see `_tips`

    def __call__(self, places: NDArray) -> NDArray:
        """Whether places (n, 3) [m] count (n,)."""
        x, y, z = places.T
        far = self.sharp.clear(x, np.hypot(y, z))
        for contact, phi in self._near(places):
            far &= _distance(contact, places, phi) > self.reach
        return far if self.tips is None else far & _beyond_tips(self.part, self.tips, places)

    def rim(self, places: NDArray) -> NDArray:
        """Places (m, 3) [m] where the reach of contacts ends, from places (n, 3) [m] within it.

        Stress decays with the inverse of the distance there: a sample that is 1 % away misses 1 %. They are
        about `MOVED` of every contact, moved around the axis, and moved straight away from its line.
        """
        moved, end = [np.zeros((0, 3))], (1 + JUST_BEYOND) * self.reach
        for contact, phi in self._near(places):
            within = places[_distance(contact, places, phi) <= self.reach]
            within = within[:: 1 + len(within) // MOVED]
            moved += [contact.turned(within, phi, end), _pushed(contact, within, phi, end)]
        rim = np.concatenate(moved)
        return rim[self(rim)]

    def _near(self, places: NDArray) -> list[tuple[Contact, float]]:
        """Contacts that may reach some of these places: lines are in half-planes of their azimuth."""
        if not len(places):
            return []
        azimuth, least = np.arctan2(places[:, 1], places[:, 2]), np.hypot(places[:, 1], places[:, 2]).min()
        window = np.arcsin(self.reach / least) if self.reach < least else np.pi
        most = np.abs(_wrapped(azimuth - azimuth[0])).max() + window
        return [each for each in self.loaded if abs(_wrapped(each[1] - azimuth[0])) <= most]


def _wrapped(angle):
    """The same angle between -pi and pi [rad]."""
    return (angle + np.pi) % (2 * np.pi) - np.pi


def _distance(contact: Contact, places: NDArray, phi: float) -> NDArray:
    """From places (n, 3) to the line of a contact (n,)."""
    return np.linalg.norm(places - contact.nearest(places, phi), axis=1)


def _pushed(contact: Contact, places: NDArray, phi: float, end: float) -> NDArray:
    """Places within reach pushed away from the line of a contact to its end."""
    nearest = contact.nearest(places, phi)
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
    return Clearing(
        part=part, sharp=notches(part), reach=CONTACT * patches.width,
        loaded=[
            (contact, azimuth)
            for contact, load in _contacts(part, patches, forces, radius)
            for azimuth, is_loaded in zip(patches.azimuths, load > UNLOADED, strict=True) if is_loaded
        ],
        tips=_tips(part) if isinstance(part, SquirrelCage) and part.fillet > 0 else None,
    )  # fmt: skip


def _contacts(
    part: Any, patches: Patches | BallPatches, forces: NDArray, radius: float
) -> Iterator[tuple[Contact, NDArray]]:
    """Yield lines of contacts with the load of every roller or ball on them, over the largest (Z,) [-]."""
    if not isinstance(patches, BallPatches):
        load = np.abs(forces[:, 0])
        yield RollerLine(radius, patches.length), load / (load.max() or 1.0)
        return
    angles, sides = np.array(patches.stations.angles), part.groove.sides
    on_arcs = forces.reshape(len(forces), len(sides), angles.size)
    load, stations = np.abs(on_arcs.sum(axis=2)), np.abs(on_arcs).max(axis=0)
    for arc, side in enumerate(sides):
        if stations[arc].any():
            ends = angles[stations[arc] > UNLOADED * stations[arc].max()]
            contact = GrooveArc(part.groove, part.outward, (float(ends.min()), float(ends.max())), side)
            yield contact, load[:, arc] / load.max()


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
