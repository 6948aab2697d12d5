"""Displacements of all cells of a grid by the tractions on all of them, by Fourier transforms."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space.influence import CellGrid, ElasticPair, influence_lattice


@dataclass(frozen=True)
class Convolution:
    """Displacements by tractions on a grid."""

    spectrum: NDArray  # (displacements, tractions, px, py/2 + 1) [m/Pa] transform of the influence numbers
    padded: tuple[int, int]  # px, py: cells of the transform, at least twice those of the grid less one

    def __call__(self, tractions: NDArray) -> NDArray:
        """Displacements (..., displacements, nx, ny) [m] of tractions (..., tractions, nx, ny) [Pa].

        Tractions in single precision give displacements in single precision, in half the time.
        """
        single = tractions.dtype == np.float32
        shape, spectrum = tractions.shape[-2:], self._single_spectrum if single else self.spectrum
        fft = _single_precision() if single else np.fft
        waves = fft.fft(fft.rfft(tractions, self.padded[1], axis=-1), self.padded[0], axis=-2)
        moved = spectrum[:, 0] * waves[..., None, 0, :, :]
        for number in range(1, waves.shape[-3]):
            moved += spectrum[:, number] * waves[..., None, number, :, :]
        columns = fft.ifft(moved, axis=-2)[..., : shape[0], :]
        return fft.irfft(columns, self.padded[1], axis=-1)[..., : shape[1]]

    @cached_property
    def _single_spectrum(self) -> NDArray:
        return self.spectrum.astype(np.complex64)

    def __sub__(self, other: "Convolution") -> "Convolution":
        """Difference of both displacements."""
        return Convolution(self.spectrum - other.spectrum, self.padded)


def convolution(
    pair: ElasticPair,
    grid: CellGrid,
    displacements: tuple[int, ...],
    tractions: tuple[int, ...],
    shift: tuple[float, float] = (0.0, 0.0),
) -> Convolution:
    r"""Displacements at cell centres by tractions that are even over each cell.

    .. math:: u_i(x_k) = \sum_{j,l} A_{ij}(x_k + d - x_l)\, p_j(x_l)

    without wrapping around: the transform is padded by zeros.

    Directions i and j are those of `influence_number`; d leads from the cell centres to the places of the
    displacements [m].

    Source
    ------
    Influence numbers A of `influence_number`; Liu, Wang and Liu (2000), Wear 243, 101-111, for the padding.
    """
    padded = _padded(grid.shape[0]), _padded(grid.shape[1])
    # Lags that no pair of cells has hold their influence too: zeros there would ripple the spectrum.
    edges = [
        side * (np.arange(size + 1) - size // 2 - 0.5) + offset
        for side, size, offset in zip(grid.spacing, padded, shift, strict=True)
    ]
    numbers = np.empty((len(displacements), len(tractions), *padded))
    first, second = ((np.arange(size) - size // 2) % size for size in padded)
    for i, displacement in enumerate(displacements):
        for j, traction in enumerate(tractions):
            lattice = influence_lattice(pair, displacement, traction, edges[0], edges[1])
            numbers[i, j, first[:, None], second] = lattice
    return Convolution(np.fft.rfft2(numbers), padded)


def _single_precision() -> Any:
    from scipy import fft  # twice as fast as NumPy's there, and costly to import

    return fft


def _padded(cells: int) -> int:
    """Cells of a transform that is fast, of factors 2, 3 and 5: at least twice those of the grid less one."""
    length = 2 * cells - 1
    while 60 ** length.bit_length() % length:
        length += 1
    return length
