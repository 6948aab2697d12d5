"""Pressure at the corner of a crowned profile."""

import numpy as np

from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.parts.profile import Crowned

CORNER_DECADE = 0.05  # of the peak pressure by which a cell ten times smaller at a corner may raise it


def corner_rise(state: Equilibrium) -> float:
    r"""Rise of the pressure at the corner of a crowned profile, where circular ends meet a straight middle.

    .. math:: p \approx \frac{E' \theta}{4 \pi} \ln\frac{2a}{x},\quad \theta = \frac{l_s}{2 R}

    Parameters
    ----------
    state : Equilibrium
        solved

    Returns
    -------
    float
        growth of p as the distance x to the corner falls to a tenth, over the peak pressure of the slices
        [-]; 0 without a corner under load

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 5.2, blunt wedge, for the part that grows without bound.
    """
    balance, loads = state.balance.roller, state.slice_loads
    bearing, raceways = balance.bearing, balance.raceways
    rise = 0.0
    for race, raceway in enumerate((bearing.inner_profile, bearing.outer_profile)):
        for profile in (bearing.roller.profile, raceway):
            if not isinstance(profile, Crowned) or not 0 < profile.straight_length < bearing.roller.length:
                continue
            beyond = np.abs(state.slice_positions) >= profile.straight_length / 2
            if not (loads[race][:, beyond] > 0).any():
                continue
            turn = profile.straight_length / 2 / profile.crown_radius
            modulus = float(np.ravel(raceways.modulus[race])[0])
            rise = max(rise, modulus * turn / (4 * np.pi) * np.log(10) / state.peak_pressure[race])
    return float(rise)
