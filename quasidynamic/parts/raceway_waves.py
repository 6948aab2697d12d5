"""Form error of a raceway: waves around its circumference."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart

FLATTEST = 0.01  # [-] steepest slope with which elements still run on a circle (assumed)
STRAIGHTEST = 0.1  # [-] most that waves may change the curvature of a contact, over an element's (assumed)


@dataclass(frozen=True, kw_only=True)
class RacewayWaves:
    """Waves that add up, each the same all across the raceway."""

    numbers: tuple[int, ...]  # around the circumference, >= 2
    amplitudes: tuple[float, ...]  # [m] positive: towards rollers or balls at the crest
    crests: tuple[float, ...]  # [rad] azimuth of a crest of each

    def __post_init__(self):
        if not len(self.numbers) == len(self.amplitudes) == len(self.crests):
            raise ImpossiblePart(
                f"form error: {len(self.numbers)} numbers of waves, {len(self.amplitudes)} amplitudes and "
                f"{len(self.crests)} crests; there must be one of each for every wave"
            )
        if any(number < 2 for number in self.numbers):
            raise ImpossiblePart(
                f"form error: numbers of waves {self.numbers} must be 2 or more: a mean belongs to the "
                "clearance, a single wave to the place of the ring"
            )
        if not np.isfinite([*self.amplitudes, *self.crests]).all():
            raise ImpossiblePart("form error: amplitudes and crests must be finite")

    def height(self, azimuths: NDArray) -> NDArray:
        r"""Form error where rollers or balls are.

        .. math:: h_j = \sum_k a_k \cos n_k (\varphi_j - \psi_k)

        h (..., Z) [m] is towards rollers or balls at azimuths phi (..., Z) [rad].

        Source
        ------
        Fourier series of a roundness profile, peaks out of the material, as ISO 12181-1 counts them.
        """
        height = np.zeros_like(azimuths)
        for number, amplitude, crest in zip(self.numbers, self.amplitudes, self.crests, strict=True):
            height = height + amplitude * np.cos(number * (azimuths - crest))
        return height

    def require_gentle(self, name: str, radius: float, element_radius: float) -> None:
        """Refuse waves that an element would not run over as on a round raceway.

        Raises `ImpossiblePart` if a wave is too steep, or too much more or less curved than the raceway;
        radii in m.
        """
        for number, amplitude in zip(self.numbers, self.amplitudes, strict=True):
            steep, curved = FLATTEST * radius / number, STRAIGHTEST * radius**2 / number**2 / element_radius
            largest = min(steep, curved)
            if abs(amplitude) > largest:
                raise ImpossiblePart(
                    f"{name}: {number} waves of {amplitude * 1e6:.4g} um; at most {largest * 1e6:.4g} um: an "
                    "element would not run over them as on a round raceway"
                )
