"""Rolling shear in the inlet of a lubricated line contact."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.lubricant import Lubricant

LOAD_ROUNDING = 1e-3  # of M: the rigid-isoviscous branch begins like sqrt(M), infinitely steep


class RollingShear(NamedTuple):
    """Shear force [N] of the inlet on either surface, with its derivatives."""

    force: NDArray
    by_load: NDArray  # [-]
    by_entrainment: NDArray  # [N s/m]


def biboulet_houpert(
    load: NDArray, entrainment: NDArray, geometry: tuple[float, float, float], oil: Lubricant
) -> RollingShear:
    r"""Inlet shear force, blending rigid-isoviscous and elastohydrodynamic contacts.

    .. math:: \frac{F}{l E' R} = \frac{U_2^{0.75}}{0.985}\,
              \frac{1.4 \sqrt M}{[1 + (\frac{1.4}{1.45} \sqrt M)^{10}]^{1/10}},\quad
              U_2 = \frac{2\eta_0 u}{E' R},\; M = \frac{W}{\sqrt{U_2}},\; W = \frac{Q}{l E' R}

    The pressure force that belongs to it is 2F on the equivalent cylinder.

    Parameters
    ----------
    load : array (...)
        Q [N], >= 0
    entrainment : array (...)
        u [m/s], > 0
    geometry : tuple
        reduced radius R [m], E' [Pa], length l [m]
    oil : Lubricant
        eta0 at the inlet

    Returns
    -------
    RollingShear
        all >= 0, zero without load

    Source
    ------
    Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 1, Eq. (42).

    Valid
    -----
    M from 0.2 to 200, flooded, isothermal.
    """
    radius, modulus, length = geometry
    unit = length * modulus * radius
    speed = 2 * oil.viscosity * entrainment / (modulus * radius)
    regime = load / (unit * np.sqrt(speed))
    root = regime / np.sqrt(regime + LOAD_ROUNDING)
    root_by_regime = (regime / 2 + LOAD_ROUNDING) / (regime + LOAD_ROUNDING) ** 1.5
    crowd = 1 + (1.4 / 1.45 * root) ** 10
    scale = unit * speed**0.75 * 1.4 / 0.985
    force = scale * root / crowd**0.1
    by_regime = scale * root_by_regime / crowd**1.1
    return RollingShear(
        force=force,
        by_load=by_regime / (unit * np.sqrt(speed)),
        by_entrainment=(0.75 * force - 0.5 * regime * by_regime) / entrainment,
    )
