r"""Deflection of a half-space beside a line load, wrapped around a raceway.

The distance from the line is the chord :math:`d = 2R\,|\sin(\varphi/2)|`: near the line it is the arc,
and it goes on smoothly around the raceway, so that the harmonics of the indentation fall as 1/n
without disturbance and those of a ring differ from them by c/(n^2 - 1) for large n.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.half_space.load_patch import kernel
from fem.parts.rings import Elastic

PANEL_POINTS = 16  # Gauss points on each period of a harmonic
FAR_POINTS = 20  # Gauss points along a line that is seen from further away than its length


def indentation(azimuth, radius: float, length: float, axial_modes: int, elastic: Elastic) -> NDArray:
    r"""Generalised displacement of a half-space beside a line load.

    .. math:: H_{mm'}(\varphi) = \frac{1-\nu^2}{\pi E}\,k_{mm'}(2R\,|\sin(\varphi/2)|)

    Parameters
    ----------
    azimuth : array (...)
        phi from the line [rad], not a multiple of 2 pi
    radius : float
        R of the raceway [m]
    length : float
        l of the line [m]
    axial_modes : int
        M, number of axial modes
    elastic : Elastic
        material below the raceway

    Returns
    -------
    array (..., M, M)
        H [m/N], in the direction of the force; the kernel k is that of `fem.half_space.load_patch`

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 3.2.
    """
    chord = 2 * radius * np.abs(np.sin(np.asarray(azimuth) / 2))
    unit = (1 - elastic.poisson_ratio**2) / (np.pi * elastic.youngs_modulus)
    near = chord < length
    H = np.empty((*chord.shape, axial_modes, axial_modes))
    H[near] = kernel(chord[near], length, axial_modes)
    H[~near] = _far_kernel(chord[~near], length, axial_modes)
    return unit * H


def indentation_harmonics(
    harmonics: NDArray, radius: float, length: float, axial_modes: int, elastic: Elastic
) -> NDArray:
    r"""Fourier coefficients of `indentation`.

    .. math:: h_n = \frac{1}{\pi} \int_0^\pi H(\varphi) \cos n\varphi\,d\varphi

    h (K, M, M) [m/N] of K harmonics n; for large n it is (1 - nu^2)/(pi E) (2m + 1)/l |n|^-1 on the diagonal.

    Source
    ------
    Fourier series of the half-space answer in this module; derived here.
    """
    return _known_harmonics(tuple(harmonics.tolist()), radius, length, axial_modes, elastic)


@lru_cache(maxsize=16)
def _known_harmonics(
    harmonics: tuple[int, ...], radius: float, length: float, axial_modes: int, elastic: Elastic
) -> NDArray:
    """`indentation_harmonics`, which a run or a study requires again and again; not to be written to."""
    found = fourier(np.array(harmonics), lambda phi: indentation(phi, radius, length, axial_modes, elastic))
    found.setflags(write=False)
    return found


def fourier(harmonics: NDArray, answer: Callable[[NDArray], NDArray]) -> NDArray:
    r"""Fourier coefficients of an even answer that may have a logarithm at the line.

    .. math:: h_n = \frac{1}{\pi} \int_0^\pi H(\varphi) \cos n\varphi\,d\varphi

    `answer` gives H (Q, ...) of azimuths (Q,) between 0 and pi [rad]; h is (K, ...) for K harmonics n.

    Source
    ------
    Fourier series of the half-space answer in this module; derived here.
    """
    phi, weight = _half_turn(int(np.abs(harmonics).max()))
    return np.tensordot(np.cos(np.outer(harmonics, phi)) * weight / np.pi, answer(phi), axes=1)


def curvature_tail(azimuth, last: int) -> NDArray:
    r"""Sum of the harmonics that the curvature of a raceway adds beyond the last one known.

    .. math:: T_N(\varphi) = \sum_{|n|>N} \frac{e^{in\varphi}}{n^2-1}
              = 1 + \tfrac12 \cos\varphi - (\pi-\varphi)\sin\varphi
              - \sum_{n=2}^N \frac{2\cos n\varphi}{n^2-1}

    Printed for azimuths between 0 and 2 pi [rad] and N >= 1; about 2/N at phi = 0 [-].

    Source
    ------
    Fourier series of the half-space answer in this module; derived here.
    """
    phi = np.mod(azimuth, 2 * np.pi)
    n = np.arange(2, last + 1)
    known = np.cos(np.multiply.outer(phi, n)) @ (2 / (n**2 - 1.0))
    return 1 + np.cos(phi) / 2 - (np.pi - phi) * np.sin(phi) - known


def cubic_tail(azimuth, last: int) -> NDArray:
    r"""Sum of a cubic fall beyond the last harmonic known.

    .. math:: \sum_{|n|>N} \frac{e^{in\varphi}}{|n|^3}

    For N >= 1 it is about 1/N^2 at phi = 0 [-], where all beyond 16 N is 0.4 % of it and left out.

    Source
    ------
    Fourier series of the half-space answer in this module; derived here.
    """
    n = np.arange(last + 1, 16 * last + 1)
    return np.cos(np.multiply.outer(np.asarray(azimuth), n)) @ (2.0 / n**3)


def _far_kernel(arc: NDArray, length: float, axial_modes: int) -> NDArray:
    """The kernel of `load_patch` further away than a length, where its recurrence loses digits."""
    x, weights = legendre.leggauss(FAR_POINTS)
    patterns = weights[:, None] * legendre.legvander(x, axial_modes - 1) * (np.arange(axial_modes) + 0.5)
    inverse = 1 / np.hypot(arc[:, None, None], (x[:, None] - x) * length / 2)
    return patterns.T @ inverse @ patterns


def _half_turn(last: int) -> tuple[NDArray, NDArray]:
    """Nodes and weights on 0 .. pi for the last harmonic times a logarithm at 0."""
    first = 2 * np.pi / max(last, 32)
    ends = np.concatenate(
        [[0.0], first * 0.2 ** np.arange(24, 0, -1), np.arange(first, np.pi, first), [np.pi]]
    )
    nodes, weights = legendre.leggauss(PANEL_POINTS)
    half = np.diff(ends)[:, None] / 2
    return (ends[:-1, None] + half * (1 + nodes)).ravel(), (half * weights).ravel()
