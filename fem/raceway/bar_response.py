"""What the bars of a squirrel cage carry when rollers load its raceway, by any discretisation."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import ImpossiblePart

FORCES = 6  # axial force, radial moment at ring and flange, tangential moment at both, torque
MIRRORED = 3  # of them that stay as they are when rollers change sides; the others turn round


def is_mirrored(count: int) -> NDArray:
    """Whether section forces (count,) of the bars of one end or both stay when rollers change sides."""
    return np.arange(count) % FORCES < MIRRORED


@dataclass(frozen=True)
class BarResponse:
    r"""Section forces of every bar in harmonics of the roller forces.

    .. math:: s_b = \mathrm{Re} \sum_{nm} \{1, i\}\,g_{nm} F_{nm} e^{in\varphi_b}, \quad
              F_{nm} = \sum_j F_{jm} e^{-in\varphi_j}

    with 1 for those that stay as they are in a mirror image, i for the others.

    Source
    ------
    Cyclic symmetry with a plane of symmetry in each bar; derived here.
    """

    bars: int  # equally spaced at each end of the ring that has any, one at azimuth 0
    response: NDArray  # g (K, M, 6), harmonics -N .. N [N/N, N m/N]; or 12, then those of the end at -x
    neighbour: NDArray | None  # the same by displacements of another order, for the error

    def __post_init__(self):
        K, _, forces = self.response.shape
        same = self.neighbour is None or self.neighbour.shape == self.response.shape
        if K % 2 == 0 or forces not in (FORCES, 2 * FORCES) or not same:
            raise ImpossiblePart(
                f"response of shape {self.response.shape}; allowed is (2 N + 1, M, {FORCES} or {2 * FORCES})"
            )

    @property
    def azimuths(self) -> NDArray:
        """Of the bars (B,) [rad]; of both ends those at +x come first."""
        return np.tile(self._around, self.response.shape[2] // FORCES)

    @property
    def _around(self) -> NDArray:
        return 2 * np.pi * np.arange(self.bars) / self.bars

    def under(self, azimuths: NDArray, forces: NDArray) -> tuple[NDArray, NDArray | None]:
        """Section forces (..., B, 6) [N, N m] of all bars under roller forces (..., Z, M) [N], outward.

        Signs are as in `fem.squirrel_cage.bar_forces`; M is at most that of the response. The second array is
        of another order of displacements, None where there is none.
        """
        last = len(self.response) // 2
        n = np.arange(-last, last + 1)
        loads = np.exp(-1j * np.outer(n, azimuths)) @ forces
        turn = np.exp(1j * np.outer(self._around, n))

        def of_bars(response):
            each = np.einsum("kmc,...km->...kc", response[:, : forces.shape[-1]], loads)
            each[..., ~is_mirrored(each.shape[-1])] *= 1j
            of_ends = np.split(np.real(turn @ each), each.shape[-1] // FORCES, axis=-1)
            return np.concatenate(of_ends, axis=-2)

        return of_bars(self.response), None if self.neighbour is None else of_bars(self.neighbour)


def of_revolution(bars: int, cosines: NDArray) -> BarResponse:
    """What bars carry that are spread around a body of revolution; the error of spreading is not known.

    `cosines` (N + 1, M, 6) are section forces of a bar under the cosine of each harmonic [N/N, N m/N]: the
    factors of cos(n phi) for the first three, of sin(n phi) for the others; with bars at both ends 12, those
    of the other end last.
    """
    turned = np.where(is_mirrored(cosines.shape[2]), 1, -1)
    return BarResponse(bars, np.concatenate([cosines[:0:-1], cosines * turned]), None)
