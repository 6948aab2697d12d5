"""How far the peak pressure of slices is from that of a whole contact."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.pressure.roller import RollerPressure
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.outcome.whole_roller import whole_contact
from quasidynamic.outcome.worst_line_contact import largest_slice
from quasidynamic.parts.profile import Crowned

CELLS = (16, 256)  # across and along: 0.5 % of the peak pressure where the contact ends before the roller
CLAIMED = 0.05  # of the peak pressure that slices may be off without a note
TOLERANCE = 1e-3  # of the pressure: a tenth of a per cent of its peak
UNCERTAIN = 0.01  # of it, by the cells: errors above `CLAIMED` less this are reported
CORNER_DECADE = 0.05  # of the peak pressure by which a cell ten times smaller at a corner may raise it


@dataclass(frozen=True)
class SlicedPeak:
    """Largest pressure of slices beside that of the same contact on half-spaces."""

    race: int  # 0 the inner, 1 the outer raceway
    roller: int  # from 0
    pressure: float  # [Pa] of the slices
    whole: RollerPressure
    edge_stress: bool = False  # whether the slices have the edge stress factor of ISO/TS 16281

    @property
    def error(self) -> float:
        """Error of the slices over the peak pressure of the whole contact [-]; negative: too low."""
        return self.pressure / self.whole.peak_pressure - 1

    @property
    def at_end(self) -> bool:
        """Whether the contact reaches an end of the roller, where no peak pressure is known."""
        return any(self.whole.at_ends)

    @property
    def holds(self) -> bool:
        """Whether the peak pressure of the slices is that of the contact within `CLAIMED`."""
        return not self.at_end and abs(self.error) < CLAIMED - UNCERTAIN


def sliced_peak(state: Equilibrium, edge_stress: NDArray | None = None) -> SlicedPeak:
    """Check the largest pressure [Pa] of all slices by the whole contact they belong to.

    `edge_stress` (K) is a factor on the load of the slices, `edge_stress_factor` [-].
    Raises `OutOfRange` or `NotSolved` as `whole_roller`.

    Source
    ------
    `whole_contact` on `CELLS`.
    """
    largest = largest_slice(state, edge_stress)
    whole = whole_contact(state, largest.race, largest.roller, CELLS, TOLERANCE)
    return SlicedPeak(largest.race, largest.roller, largest.pressure, whole, largest.edge_stress)


def corner_rise(state: Equilibrium) -> float:
    r"""Rise of the pressure at the corner of a crowned profile, where circular ends meet a straight middle.

    .. math:: p \approx \frac{E' \theta}{4 \pi} \ln\frac{2a}{x},\quad \theta = \frac{l_s}{2 R}

    The growth of p as the distance x to the corner falls to a tenth, over the peak pressure of the slices
    [-]; 0 without a corner under load.

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
