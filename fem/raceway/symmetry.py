"""Which rollers need a solve, and how the others follow from them.

A rotation or a mirror image that maps bars on bars and rollers on rollers leaves the compliance as
it is, with the rollers renumbered. Axial modes and radial directions are not changed by either.
"""

import numpy as np
from numpy.typing import NDArray

TOLERANCE = 1e-9  # [rad]


def permutations(azimuths, bars: int | None) -> NDArray:
    """Renumberings (G, Z) of the rollers by the symmetries they share with the part.

    The first row changes nothing. Row g says where each roller goes. Bars are equal with one at azimuth 0;
    None of them for a body of revolution.
    """
    phi = np.asarray(azimuths, dtype=float)
    turned = [phi + angle for angle in phi - phi[0] if _fits(angle, bars)]
    mirrored = [angle - phi for angle in phi + phi[0] if _fits(angle, bars)]
    rows = [_matched(image, phi) for image in turned + mirrored]
    unique = {tuple(row): None for row in rows if row is not None}
    return np.array(list(unique), dtype=int)


def _fits(angle: float, bars: int | None) -> bool:
    """Whether a rotation by an angle, or a mirror image of azimuth 0 at it, maps bars on bars."""
    return bars is None or bool(np.abs(_wrapped(angle * bars)) < TOLERANCE * bars)


def _matched(image: NDArray, azimuths: NDArray) -> NDArray | None:
    """Roller at which each image arrives, or None if one arrives between rollers."""
    distance = np.abs(_wrapped(image[:, None] - azimuths))
    row = distance.argmin(axis=1)
    return row if distance.min(axis=1).max() < TOLERANCE and len(set(row)) == row.size else None


def _wrapped(angle):
    return np.angle(np.exp(1j * angle))


def representatives(renumbered: NDArray) -> NDArray:
    """The rollers that need a solve, the lowest number of each class of `permutations`, ascending."""
    return np.unique(renumbered.min(axis=0))


def completed(columns: NDArray, solved: NDArray, renumbered: NDArray) -> NDArray:
    """The symmetric matrix (Z, M, Z, M) from the columns (Z, M, R, M) of the solved rollers.

    Each column is the mean of all its images, which also evens out what the mesh breaks; then the mean with
    the transpose, by Betti's theorem.
    """
    Z, M = columns.shape[:2]
    total, count = np.zeros((Z, M, Z, M)), np.zeros(Z)
    for row in renumbered:
        for number, roller in enumerate(solved):
            # row maps j on row[j]: C[row[i], row[j]] = C[i, j]
            total[row, :, row[roller]] += columns[:, :, number]
            count[row[roller]] += 1
    absolute = total / count[:, None]
    return (absolute + absolute.transpose(2, 3, 0, 1)) / 2
