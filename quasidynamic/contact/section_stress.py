"""Stress in the plane of rolling below a contact."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class SectionStress(NamedTuple):
    """Stresses where nothing shears out of the plane; tension positive, the depth counted into the body."""

    along: NDArray  # (...) in the rolling direction
    across: NDArray  # (...) along the roller, or across the groove
    normal: NDArray  # (...) along the depth
    shear: NDArray  # (...) orthogonal shear stress, between rolling direction and depth

    @property
    def von_mises(self) -> NDArray:
        r"""Equivalent stress (...), in the unit of the others.

        .. math:: \sigma_v^2 = \tfrac12 [(\sigma_x - \sigma_y)^2 + (\sigma_y - \sigma_z)^2
                  + (\sigma_z - \sigma_x)^2] + 3 \tau_{xz}^2

        Source
        ------
        von Mises (1913).
        """
        x, y, z, shear = self
        return np.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 + 3 * shear**2)

    @property
    def principal_shear(self) -> NDArray:
        """Largest shear stress on any plane (...): half of what the principal stresses differ by at most."""
        x, y, z, shear = self
        middle, radius = (x + z) / 2, np.hypot((x - z) / 2, shear)
        return np.maximum(radius, (radius + np.abs(middle - y)) / 2)
