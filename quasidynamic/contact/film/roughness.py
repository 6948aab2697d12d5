"""Film thickness against the roughness of the surfaces."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.errors import OutOfRange

MIXED_FROM = 1.0  # [-] lambda; below it asperities carry most of the load
FULL_FILM_FROM = 3.0  # [-] lambda; from here on the peaks of two Gaussian surfaces hardly ever touch


def composite_roughness(first: ArrayLike, second: ArrayLike) -> NDArray:
    r"""Roughness of the gap between two rough surfaces.

    .. math:: \sigma = \sqrt{R_{q1}^2 + R_{q2}^2}

    Parameters
    ----------
    first, second : array (...)
        Rq1, Rq2, root-mean-square roughness of each surface [m], >= 0; Rq is about 1.25 Ra

    Returns
    -------
    array (...)
        sigma [m], >= 0

    Source
    ------
    Sum of the variances of two independent surfaces.

    Valid
    -----
    Roughness of one surface independent of the other's.

    >>> round(float(composite_roughness(0.3e-6, 0.4e-6)) * 1e6, 3)
    0.5
    """
    return np.hypot(first, second)


def lambda_ratio(film: ArrayLike, roughness: ArrayLike) -> NDArray:
    r"""Film thickness over composite roughness.

    .. math:: \lambda = h / \sigma,\quad \sigma = \sqrt{R_{q1}^2 + R_{q2}^2}

    Parameters
    ----------
    film : array (...)
        h, film of smooth surfaces [m], >= 0
    roughness : array (...)
        sigma, composite roughness [m], > 0; see `composite_roughness`

    Returns
    -------
    array (...)
        lambda [-]; its derivative by h is lambda/h

    Raises
    ------
    OutOfRange
        where both surfaces are perfectly smooth

    Source
    ------
    Tallian, ASLE Trans. 10 (1967) 418 (recalled).

    Valid
    -----
    A film taken as if the surfaces were smooth; below lambda of about 1 it is a measure, not a gap.

    >>> round(float(lambda_ratio(0.1163e-6, composite_roughness(0.05e-6, 0.05e-6))), 2)
    1.64
    """
    if not np.all(np.asarray(roughness) > 0.0):
        raise OutOfRange("lambda needs roughness above zero; both surfaces are given as perfectly smooth")
    return np.asarray(film) / np.asarray(roughness)


def regime(ratio: ArrayLike) -> NDArray:
    """Name of the lubrication regime by lambda [-]: "boundary" below 1, "mixed" below 3, then "full film".

    Raises `OutOfRange` where lambda is negative or not a number.

    Source
    ------
    Bounds as most handbooks draw them (recalled); the transitions are gradual and some authors put the
    first at 0.4 or lower.

    Valid
    -----
    Words for a report. Steps at 1 and 3: a friction law needs a gradual share instead.

    >>> str(regime(1.64))
    'mixed'
    """
    ratio = np.asarray(ratio)
    if not np.all(ratio >= 0.0):
        raise OutOfRange("lambda must be a number >= 0; look at the film and the roughness it came from")
    names = np.array(["boundary", "mixed", "full film"])
    return names[np.digitize(ratio, [MIXED_FROM, FULL_FILM_FROM])]
