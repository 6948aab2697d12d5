"""How far the peak pressure of slices is from that of a whole contact."""

from dataclasses import dataclass

from numpy.typing import NDArray

from quasidynamic.contact.pressure.roller import RollerPressure
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.outcome.largest_slice import largest_slice
from quasidynamic.outcome.whole_roller import whole_contact

CELLS = (16, 256)  # across and along: 0.5 % of the peak pressure where the contact ends before the roller
CLAIMED = 0.05  # of the peak pressure that slices may be off without a note
TOLERANCE = 1e-3  # of the pressure: a tenth of a per cent of its peak
UNCERTAIN = 0.01  # of it, by the cells: errors above `CLAIMED` less this are reported


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
    """Check the largest pressure of all slices by the whole contact they belong to.

    Parameters
    ----------
    state : Equilibrium
        solved
    edge_stress : array (K), optional
        factor on the load of the slices, `edge_stress_factor` [-]

    Returns
    -------
    SlicedPeak
        of the contact whose slice has the largest pressure [Pa]

    Raises
    ------
    OutOfRange, NotSolved
        as `whole_roller`

    Source
    ------
    `whole_contact` on `CELLS`.
    """
    largest = largest_slice(state, edge_stress)
    whole = whole_contact(state, largest.race, largest.roller, CELLS, TOLERANCE)
    return SlicedPeak(largest.race, largest.roller, largest.pressure, whole, largest.edge_stress)
