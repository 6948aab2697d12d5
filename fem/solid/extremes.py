"""The largest stresses of a body, found among samples of two orders, which tell the error."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from fem.parts.rings import ImpossiblePart

COARSE, FINE = 4, 24  # intervals along an element edge: in every element, and in those with the largest
CAUTION, LEAST = 2.0, 1.5e-2  # factor of the change from the lower order; least error over the value: assumed
CANDIDATES = 12  # elements that are looked into for each measure


class Samples(NamedTuple):
    """Places in some elements, and what is there."""

    key: NDArray  # (n,) of the element in its piece
    even: NDArray  # (n,) bool: those that half as many intervals would have
    place: NDArray  # (n, 3) x, y, z [m]
    shift: NDArray  # (n,) size of the displacement [m]
    stress: NDArray  # (n, 6) [Pa] xx, yy, zz, xy, yz, xz in any axes at right angles


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


def extremes(sampled: Sampled, body: str, clear: Callable[[NDArray], NDArray]) -> BodyExtremes:
    """Extremes of a body.

    Elements whose samples are largest are sampled again, finely, by both orders.

    Parameters
    ----------
    sampled : Sampled
        displacements of two orders
    body : str
        its name
    clear : callable (places)
        whether places (n, 3) [m] count

    Returns
    -------
    BodyExtremes
        their errors are twice the change from the lower order of displacements, that from half as
        many samples, and one and a half percent

    Raises
    ------
    ImpossiblePart
        if no place counts
    """
    found: list[tuple[float, int, int]] = []
    best, shift = [found[:] for _ in MEASURES], 0.0
    for piece in sampled.pieces(body):
        samples = sampled.samples(body, piece, COARSE)
        shift = max(shift, float(samples.shift.max()))
        far = clear(samples.place)
        for measure, candidates in zip(MEASURES.values(), best, strict=True):
            values = np.where(far, measure(samples.stress), -np.inf)
            candidates += _largest_elements(values, samples.key, piece)
            candidates.sort(reverse=True)
            del candidates[CANDIDATES:]
    if not best[0]:
        raise ImpossiblePart(f"every place of {body!r} is close to a loaded roller or to a sharp edge")
    by_measure = {
        name: _looked_into(sampled, body, clear, measure, candidates)
        for (name, measure), candidates in zip(MEASURES.items(), best, strict=True)
    }
    return BodyExtremes(displacement=shift, **by_measure)


def _largest_elements(values: NDArray, key: NDArray, piece: int) -> list[tuple[float, int, int]]:
    """Elements of a piece with the largest values: value, piece, key."""
    top: dict[int, float] = {}
    for k in np.argsort(values)[::-1]:
        if len(top) == CANDIDATES or not np.isfinite(values[k]):
            break
        top.setdefault(int(key[k]), float(values[k]))
    return [(value, piece, element) for element, value in top.items()]


def _looked_into(sampled: Sampled, body: str, clear, measure, candidates) -> Largest:
    """The largest of a measure among fine samples of its candidates."""
    value, lower, halved, place = -np.inf, -np.inf, -np.inf, np.zeros(3)
    for piece in sorted({piece for _, piece, _ in candidates}):
        keys = np.array([key for _, at, key in candidates if at == piece])
        samples = sampled.samples(body, piece, FINE, keys)
        far = clear(samples.place)
        if not far.any():
            continue
        values = np.where(far, measure(samples.stress), -np.inf)
        if values.max() > value:
            value, place = float(values.max()), samples.place[values.argmax()]
        halved = max(halved, float(np.max(values, where=samples.even, initial=-np.inf)))
        others = sampled.samples(body, piece, FINE, keys, higher=False)
        lower = max(lower, float(np.max(measure(others.stress), where=far, initial=-np.inf)))
    sign = -1.0 if measure is _pressure else 1.0
    return Largest(
        value=sign * value,
        error=CAUTION * abs(value - lower) + value - halved + LEAST * abs(value),
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
    return np.linalg.eigvalsh(stress[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]])[:, ::-1]


def _tension(stress: NDArray) -> NDArray:
    """Largest principal stress (n,) [Pa]."""
    return principal(stress)[:, 0]


def _pressure(stress: NDArray) -> NDArray:
    """The smallest principal stress, compression positive (n,) [Pa]."""
    return -principal(stress)[:, 2]


MEASURES = {"von_mises": von_mises, "tension": _tension, "compression": _pressure}
