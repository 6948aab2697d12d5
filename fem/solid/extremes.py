"""The largest stresses of a body, found among samples of two orders, which tell the error."""

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from fem.parts.rings import ImpossiblePart
from fem.solid.clearing import Clearing

COARSE, FINE = 4, 24  # intervals along an element edge: in every element, and in those with the largest
CAUTION = 2.0  # factor of the change from the lower order, see `extremes`
LEAST = 5e-3  # least error over the largest stress of the body: an error of the field has its size; assumed
CANDIDATES, OF_A_PEAK = 24, 8  # elements that are looked into for each measure, and those next to each other


class Samples(NamedTuple):
    """Places in some elements, and what is there."""

    key: NDArray  # (n,) of the element in its piece
    even: NDArray  # (n,) bool: those that half as many intervals would have
    place: NDArray  # (n, 3) x, y, z [m]
    displacement: NDArray  # (n, 3) [m] in any axes at right angles
    stress: NDArray  # (n, 6) [Pa] xx, yy, zz, xy, yz, xz in the same axes


NOWHERE = Samples(np.zeros(0, int), np.zeros(0, bool), *(np.zeros((0, k)) for k in (3, 3, 6)))


def in_axes(samples: Samples, axes: NDArray) -> Samples:
    """Samples in other axes: their directions (n, 3, 3) in the axes of the samples, one after the other."""
    a, b = np.array([(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]).T
    stress = axes @ _tensors(samples.stress) @ axes.swapaxes(1, 2)
    moved = np.einsum("nij,nj->ni", axes, samples.displacement)
    return samples._replace(displacement=moved, stress=stress[:, a, b])


def cylinder_axes(y: NDArray, z: NDArray) -> NDArray:
    """Directions x, r, t (n, 3, 3) at places off the x axis, r outwards, t towards growing azimuth."""
    s, c = np.array([y, z]) / np.hypot(y, z)
    axes = np.zeros((s.size, 3, 3))
    axes[:, 0, 0] = 1.0
    axes[:, 1, 1], axes[:, 1, 2], axes[:, 2, 1], axes[:, 2, 2] = s, c, c, -s
    return axes


def _tensors(stress: NDArray) -> NDArray:
    """Stresses (n, 6) as tensors (n, 3, 3)."""
    return stress[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]


class Sampled(Protocol):
    """Displacements of two orders on the same elements, which may be looked at piece by piece."""

    def pieces(self, body: str) -> Iterable[int]:
        """Numbers of the pieces that hold parts of a body."""
        ...

    def samples(
        self, body: str, piece: int, intervals: int, keys: NDArray | None = None, *, higher: bool = True
    ) -> Samples:
        """Samples of a piece, in all its elements or in some, by the higher or the lower order."""
        ...

    def at(self, body: str, piece: int, places: NDArray, *, higher: bool = True) -> Samples:
        """Samples at those of some places (n, 3) [m] that lie in a piece, in axes x, r, t; half are even."""
        ...


class Candidate(NamedTuple):
    """An element that may hold the largest value."""

    value: float  # of the largest sample in it
    piece: int
    key: int
    place: NDArray  # (3,) of that sample [m]


@dataclass(frozen=True, kw_only=True)
class Largest:
    """A largest value with its place."""

    value: float  # [Pa], tension positive
    error: float  # [Pa] estimated, >= 0
    x: float  # [m]
    radius: float  # [m]
    azimuth: float  # [rad] from z towards y


@dataclass(frozen=True, kw_only=True)
class BodyExtremes:
    """Extremes of one body; stresses away from loaded rollers and sharp edges."""

    displacement: float  # [m] anywhere
    von_mises: Largest
    tension: Largest  # largest principal stress
    compression: Largest  # smallest principal stress, negative in compression


def extremes(sampled: Sampled, body: str, clear: Clearing) -> BodyExtremes:
    r"""Extremes of a body from displacements of two orders, at places that are clear.

    Elements whose samples are largest are sampled again, finely, by both orders. Errors are twice the change
    from the lower order of displacements, of the largest value or at its place, that from half as many
    samples, and half a percent of the largest stress.
    Raises `ImpossiblePart` if no place counts.

    Source
    ------
    Beside an edge of 270 degrees values at a distance converge like :math:`p^{-4\lambda}` with
    :math:`\lambda = 0.54` (Williams 1952; Babuska and Suri 1990): the error of order p over the change from
    p - 1 is then 1.1, 1.6 and 2.0 for p = 4, 5 and 6.
    """
    best: dict[str, list[Candidate]] = defaultdict(list)
    shift = 0.0
    for piece in sampled.pieces(body):
        samples = sampled.samples(body, piece, COARSE)
        shift = max(shift, float(np.linalg.norm(samples.displacement, axis=1).max()))
        far = clear(samples.place)
        for name, measured in _measures(samples.stress).items():
            values = np.where(far, measured, -np.inf)
            largest = _peaks(values, samples.key, samples.place, clear.reach)
            best[name] += [
                Candidate(values[k], piece, int(samples.key[k]), samples.place[k]) for k in largest
            ]
    if not best["von_mises"]:
        raise ImpossiblePart(f"every place of {body!r} is close to a loaded roller or to a sharp edge")
    found = {
        name: _looked_into(sampled, body, clear, name, _best(candidates, clear.reach))
        for name, candidates in best.items()
    }
    least = LEAST * max(abs(largest.value) for largest in found.values())
    return BodyExtremes(
        displacement=shift,
        **{name: replace(largest, error=largest.error + least) for name, largest in found.items()},
    )


def _best(candidates: list[Candidate], reach: float) -> list[Candidate]:
    """The largest candidates of all pieces."""
    values, places = np.array([c.value for c in candidates]), np.array([c.place for c in candidates])
    return [candidates[k] for k in _peaks(values, np.arange(values.size), places, reach)]


def _peaks(values: NDArray, key: NDArray, place: NDArray, reach: float) -> list[int]:
    """Numbers of the largest values, one of each element, and a few of each peak: others may be higher."""
    ordered = np.lexsort((values, key))
    of_elements = ordered[np.append(key[ordered][1:] != key[ordered][:-1], True)]  # the largest of each
    left, chosen, place = values[of_elements], [], place[of_elements]
    while len(chosen) < CANDIDATES and np.isfinite(left[k := int(left.argmax())]):
        near = np.linalg.norm(place - place[k], axis=1) < reach
        crowded = np.count_nonzero(near[chosen]) >= OF_A_PEAK
        if not crowded:
            chosen.append(k)
        left[near if crowded else k] = -np.inf
    return [int(of_elements[k]) for k in chosen]


def _fine(sampled: Sampled, body: str, piece: int, keys: NDArray, clear: Clearing) -> list[Samples]:
    """Fine samples of some elements, and some where the reach of rollers ends, by both orders."""
    both = [sampled.samples(body, piece, FINE, keys, higher=higher) for higher in (True, False)]
    inside = np.flatnonzero(~clear(both[0].place))
    rim = clear.rim(both[0].place[inside])
    if len(rim):
        both = [
            Samples(
                *map(np.concatenate, zip(samples, sampled.at(body, piece, rim, higher=higher), strict=True))
            )
            for higher, samples in zip((True, False), both, strict=True)
        ]
    return both


def _looked_into(sampled: Sampled, body: str, clear, name: str, candidates) -> Largest:
    """The largest of a measure among fine samples of its candidates, without the least error."""
    value, lower, halved, changed, place = -np.inf, -np.inf, -np.inf, 0.0, np.zeros(3)
    for piece in sorted({candidate.piece for candidate in candidates}):
        keys = np.array([candidate.key for candidate in candidates if candidate.piece == piece])
        samples, others = _fine(sampled, body, piece, keys, clear)
        far = clear(samples.place)
        if not far.any():
            continue
        values = np.where(far, _measures(samples.stress)[name], -np.inf)
        of_lower = _measures(others.stress)[name]
        if values.max() > value:
            most = values.argmax()
            value, place = float(values[most]), samples.place[most]
            changed = abs(value - float(of_lower[most]))
        halved = max(halved, float(np.max(values, where=samples.even, initial=-np.inf)))
        lower = max(lower, float(np.max(of_lower, where=far, initial=-np.inf)))
    sign = -1.0 if name == "compression" else 1.0
    return Largest(
        value=sign * value,
        error=CAUTION * max(abs(value - lower), changed) + value - halved,
        x=float(place[0]),
        radius=float(np.hypot(place[1], place[2])),
        azimuth=float(np.arctan2(place[1], place[2])),
    )


def von_mises(stress: NDArray) -> NDArray:
    r"""Equivalent stress of the largest distortion energy.

    .. math:: \sigma_v^2 = \tfrac12 [(\sigma_x - \sigma_y)^2 + (\sigma_y - \sigma_z)^2
              + (\sigma_z - \sigma_x)^2] + 3 (\tau_{xy}^2 + \tau_{yz}^2 + \tau_{xz}^2)

    Parameters
    ----------
    stress : array (n, 6)
        xx, yy, zz, xy, yz, xz [Pa]

    Returns
    -------
    array (n,)
        [Pa], >= 0

    Source
    ------
    von Mises (1913); any text on strength of materials.
    """
    x, y, z, *shear = stress.T
    return np.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 + 3 * sum(s**2 for s in shear))


def principal(stress: NDArray) -> NDArray:
    """Principal stresses.

    Parameters
    ----------
    stress : array (n, 6)
        xx, yy, zz, xy, yz, xz [Pa]

    Returns
    -------
    array (n, 3)
        [Pa], largest first, tension positive

    Source
    ------
    Eigenvalues of the symmetric tensor.
    """
    return np.linalg.eigvalsh(_tensors(stress))[:, ::-1]


def _measures(stress: NDArray) -> dict[str, NDArray]:
    """What is looked for the largest of (n,) each [Pa], compression positive."""
    main = principal(stress)
    return {"von_mises": von_mises(stress), "tension": main[:, 0], "compression": -main[:, 2]}
