"""The most loaded roller of a solved state, its contacts on elastic half-spaces instead of slices."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import legval
from numpy.typing import NDArray

from quasidynamic.contact.half_space import elastic_pair
from quasidynamic.contact.pressure.normal_contact import TOLERANCE
from quasidynamic.contact.pressure.roller import CELLS, RollerOnRaceway, RollerPressure
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.outcome.life import basic_life, raceway_lives
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing


@dataclass(frozen=True)
class WholeRoller:
    """A roller whose two contacts were solved as a whole; the other rollers as their slices have them."""

    state: Equilibrium
    number: int  # of the roller, from 0
    contacts: tuple[RollerPressure, RollerPressure]  # inner, outer
    coarser: tuple[RollerPressure, RollerPressure]  # the same with half as many cells both ways

    @cached_property
    def slice_loads(self) -> NDArray:
        """Load per length (2, Z, K) [N/m] of the slices of all rollers, means of this one's."""
        loads = self.state.slice_loads.copy()
        loads[:, self.number] = [contact.slice_loads(loads.shape[-1]) for contact in self.contacts]
        return loads

    @property
    def slice_pressure(self) -> NDArray:
        """Largest pressure (2, K) [Pa] on the cells that each slice of the roller shares."""
        count = self.state.slice_loads.shape[-1]
        return np.array([contact.slice_pressure(count) for contact in self.contacts])

    @property
    def peak_pressure(self) -> NDArray:
        """Largest pressure (2) [Pa]; at a sharp end, see `at_ends`, that of a cell."""
        return np.array([contact.peak_pressure for contact in self.contacts])

    @property
    def at_ends(self) -> bool:
        """Whether a contact reaches an end of the roller, where its pressure has no bound."""
        return any(any(contact.at_ends) for contact in self.contacts)

    @property
    def peak_at_ends(self) -> NDArray:
        """Whether the largest pressure of each contact (2) stands at an end of the roller: no number."""
        return np.array([contact.peak_at_ends for contact in self.contacts])

    @property
    def life(self) -> float:
        """Basic reference life L10 [10^6 revolutions], see `whole_roller`."""
        inner, outer = self._loads
        return float(basic_life(inner, outer, self._bearing, self.state.turning))

    @property
    def sliced_life(self) -> float:
        """Basic reference life by slices alone [revolutions]."""
        return 1e6 * self.state.life

    @property
    def raceway_lives(self) -> NDArray:
        """Basic life (2) of each raceway on its own [10^6 revolutions]."""
        inner, outer = self._loads
        return raceway_lives(inner, outer, self._bearing, self.state.turning)

    @property
    def _loads(self) -> NDArray:
        """Load (2, Z, K) of each slice [N]."""
        return self.slice_loads * self.state.balance.roller.raceways.slices.width

    @property
    def _bearing(self) -> CylindricalRollerBearing:
        return self.state.balance.roller.bearing

    # -- fields --------------------------------------------------------------------------------

    @property
    def positions(self) -> NDArray:
        """Middles of the cells along the roller (Y) from mid-roller [m]."""
        return self.contacts[0].positions

    @property
    def across(self) -> NDArray:
        """Middles of the cells across the contacts (2, X), along the rolling direction [m]."""
        return np.array([contact.contact.grid.centres[0][:, 0] for contact in self.contacts])

    @property
    def pressure(self) -> NDArray:
        """Pressure (2, X, Y) [Pa]."""
        return np.array([contact.contact.pressure for contact in self.contacts])

    @property
    def line_load(self) -> NDArray:
        """Load per length along the roller (2, Y) [N/m]."""
        return np.array([contact.line_load for contact in self.contacts])

    @property
    def tilt(self) -> NDArray:
        """Tilt of the roller against each raceway (2), held or as its moment requires [rad]."""
        return np.array([contact.tilt for contact in self.contacts])

    @property
    def pressure_error(self) -> NDArray:
        """Change of the peak pressure (2) from cells of twice the size [Pa]."""
        return np.abs(self.peak_pressure - self.coarser_peak_pressure)

    @property
    def coarser_peak_pressure(self) -> NDArray:
        """Largest pressure (2) on cells of twice the size [Pa]."""
        return np.array([contact.peak_pressure for contact in self.coarser])


def whole_roller(state: Equilibrium) -> WholeRoller:
    r"""Most loaded roller under the loads of its slices, with the pressure of half-spaces.

    .. math:: Q = \sum_k q_k \Delta x,\quad M = \sum_k q_k x_k \Delta x

    at either raceway. Between rings whose tilt is held the roller keeps the tilt of its slices against either
    raceway, and its moments follow; where the ring tilts freely until moments balance it has the moment M,
    and its tilts follow. Its life goes by the lamina formula of ISO/TS 16281, `basic_life`, with the mean of
    the half-spaces' load per length over each slice in the place of q_k.

    The roller is the one with the largest inner load [N].
    Raises `OutOfRange` where no roller carries load, `NotSolved` when a contact was not solved.

    Source
    ------
    `RollerOnRaceway`; ISO/TS 16281 (2008) for the life.

    Valid
    -----
    As `RollerOnRaceway`. The loads of the rollers are those of the slices. At the tilts of the slices the
    moments at both raceways differ by some percent: a roller in balance would turn by as much of its tilt.
    Where a contact reaches a sharp end, its life falls with finer slices without limit: q_k^{4.5} of an end
    slice grows faster than their number.
    """
    number = int(np.argmax(state.loads[0]))
    across, along = CELLS
    coarser = _contacts(state, number, (across // 2, along // 2))
    return WholeRoller(state, number, _contacts(state, number, CELLS), coarser)


def _contacts(
    state: Equilibrium, number: int, cells: tuple[int, int]
) -> tuple[RollerPressure, RollerPressure]:
    return whole_contact(state, 0, number, cells), whole_contact(state, 1, number, cells)


def whole_contact(
    state: Equilibrium, race: int, number: int, cells: tuple[int, int], tolerance: float = TOLERANCE
) -> RollerPressure:
    """Pressure [Pa] of a roller on one raceway, under its load and at its tilt or moment, see `whole_roller`.

    `race` is 0 for the inner, 1 for the outer raceway; rollers are numbered from 0; cells are across and
    along.

    Source
    ------
    `RollerOnRaceway`.
    """
    raceways, bearing = state.balance.roller.raceways, state.balance.roller.bearing
    ring = (bearing.inner_ring, bearing.outer_ring)[race]
    contact = RollerOnRaceway(
        pair=elastic_pair(bearing.roller.material, ring),
        radius=float(raceways.radius[race, 0, 0]),
        length=bearing.roller.length,
        drop=_drop(state, race, number),
        cells=cells,
        tolerance=tolerance,
    )
    force = float(state.loads[race, number])
    if state.balance.points.free_tilt[0, 0]:
        loads = state.slice_loads[race, number] * raceways.slices.width
        return contact.under(force, float(loads @ state.slice_positions))
    approach = state.balance.inputs(state.unknowns).approach[race, :, 0, number]
    at_end = float(approach[1]) if len(approach) > 1 else 0.0  # rollers of one axial mode are aligned
    return contact.tilted(force, at_end / (bearing.roller.length / 2))


def _drop(state: Equilibrium, race: int, number: int) -> Callable[[NDArray], NDArray]:
    """Separation of roller and raceway along it, but for approach and tilt [m]."""
    bearing, approach = state.balance.roller.bearing, state.balance.inputs(state.unknowns).approach
    length = bearing.roller.length
    bent = approach[race, :, 0, number].copy()
    bent[:2] = 0.0

    def drop(position: NDArray) -> NDArray:
        return bearing.drop(race, position, length) - legval(2 * position / length, bent)

    return drop
