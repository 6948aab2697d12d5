"""How far the peak pressure of slices is off where ends are pressed, by a line of loads on half-spaces."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.legendre import legval
from numpy.typing import NDArray

from quasidynamic.contact.line import half_width, peak_pressure
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

STEP, FEWEST, MOST = 8, 24, 128  # cells along a roller, each about as long as the contact is half wide
SPREAD = (
    np.exp(-0.5) / 2
)  # of the half-width: logarithmic mean distance from the middle under Hertz's pressure
LEAST = 0.5  # of the mean load: a cell with less is as wide as one with it
SETS = 30  # of cells that touch; rarely more than eight
END_RISE, FINE = (
    (1.2, 0.45),
    256,
)  # of the pressure of an end to that of a cell there, of so many: `_with_rise`
LEFT, TURN, BENT = 0.5, 0.15, 0.5  # pressure of slices at an end, and bending along the roller: `is_smooth`
SMALL, NEAR = 0.05, 0.8  # error, and pressure at an end over the peak, below which cells twice as long do
AT_ONCE = 32  # contacts whose matrices fit into the memory of a processor


@dataclass(frozen=True)
class LineContacts:
    """C rollers, each on a raceway."""

    force: NDArray  # (C) [N], > 0
    shape: NDArray  # (C, n) tilt less drop in the middles of n equal cells along the roller [m]
    moment: (
        NDArray  # (C) about mid-roller [N m], under which a roller tilts further; NaN where tilts are held
    )
    length: NDArray  # (C) [m]
    radius: NDArray  # (C) reduced radius [m]
    modulus: NDArray  # (C) E' [Pa], see `peak_pressure`
    sliced: NDArray  # (C, n) loads per length of slices, of which widths are known well [N/m]

    def take(self, some: slice | NDArray) -> "LineContacts":
        """Some of them."""
        return LineContacts(*(getattr(self, name)[some] for name in self.__dataclass_fields__))

    @property
    def coarse(self) -> "LineContacts":
        """In half as many cells."""
        shape, sliced = (each.reshape(len(each), -1, 2).mean(axis=2) for each in (self.shape, self.sliced))
        return replace(self, shape=shape, sliced=sliced)

    def peak_error(self, sliced: NDArray) -> NDArray:
        """Error (C) of the largest pressure (C) of slices [Pa] over that of the contact [-].

        One where the contact presses an end, which has no bound there: all of it is missing. Of cells twice
        as long where these leave no doubt that it is small.
        """
        coarse = self.coarse
        loads = line_loads(coarse, coarse.sliced)
        errors = coarse._error(loads, sliced, NEAR)
        doubtful = np.flatnonzero(errors > SMALL)
        fine, first = self.take(doubtful), np.repeat(loads[doubtful], 2, axis=1)
        errors[doubtful] = fine._error(line_loads(fine, first), sliced[doubtful], 1.0)
        return errors

    def _error(self, loads: NDArray, sliced: NDArray, share: float) -> NDArray:
        """That of loads (C, n); ends are pressed from so much of the peak pressure."""
        along = peak_pressure(loads, self.radius[:, None], self.modulus[:, None])
        peak, ends = along.max(axis=1), along[:, [0, -1]].max(axis=1)
        return np.where(self._with_rise(ends) > share * peak, 1.0, np.abs(sliced / peak - 1))

    def _with_rise(self, end: NDArray) -> NDArray:
        """Pressure (C) in the last of `FINE` cells at an end that is pressed: it grows as their root."""
        width = half_width(self.force / self.length, self.radius, self.modulus)
        least, rise = END_RISE
        return end * np.maximum(least, rise * np.sqrt(width / self.length * FINE))


def line_loads(contacts: LineContacts, first: NDArray) -> NDArray:
    r"""Loads per length along rollers on half-spaces, by the deflection on the axis of the contact.

    .. math::
        \frac{2}{\pi E'} \int \frac{q(y')\, dy'}{\sqrt{(y - y')^2 + s^2 b(y')^2}} = \delta + t y + g(y)
        \ \text{where}\ q > 0, \quad \int q\, dy = Q

    q (C, n) is in N/m; contacts are as wide as under the loads `first` (C, n) [N/m], which are zero where
    they are apart at first.

    Source
    ------
    Boussinesq's point load, spread by Hertz's pressure: s = exp(-1/2)/2 is exact for long cylinders.

    Valid
    -----
    In `number_of_cells` its largest pressure is within 1 % of that of half-spaces where the contact ends
    before the roller does, see `benchmarks/pressed_ends.py`; at a sharp end loads of the last cells grow with
    the number of cells.
    """
    loads = np.empty(first.shape)
    for k in range(0, len(first), AT_ONCE):
        some = slice(k, k + AT_ONCE)
        loads[some] = _loads(contacts.take(some), first[some])
    return loads


def _loads(contacts: LineContacts, first: NDArray) -> NDArray:
    least = LEAST * (contacts.force / contacts.length)[:, None]
    return _touching(_matrix(contacts, np.maximum(first, least)), contacts, first > 0)


def _matrix(contacts: LineContacts, carried: NDArray) -> NDArray:
    """Deflections by loads, approach and tilt (C, n + 2, n + 2), then force and moment."""
    cells, free = carried.shape[1], np.isfinite(contacts.moment)[:, None]
    width, places = contacts.length[:, None] / cells, np.arange(cells) + 0.5
    spread = SPREAD * half_width(carried, contacts.radius[:, None], contacts.modulus[:, None]) / width
    ends = np.arange(cells + 1) - places[:, None]
    below = np.arcsinh(ends[:, 1:] / spread[:, None]) - np.arcsinh(ends[:, :-1] / spread[:, None])
    arm = np.where(free, (places - cells / 2) * width, 0.0)
    matrix = np.zeros((len(carried), cells + 2, cells + 2))
    matrix[:, :cells, :cells] = 2 / (np.pi * contacts.modulus[:, None, None]) * below
    matrix[:, :cells, -2], matrix[:, -2, :cells] = -1.0, width
    matrix[:, :cells, -1], matrix[:, -1, :cells] = -arm, width * arm
    matrix[:, -1, -1] = ~free[:, 0]
    return matrix


def _touching(matrix: NDArray, contacts: LineContacts, touching: NDArray) -> NDArray:
    """Loads (C, n) above zero under which cells without load stay apart; cells that may touch at first."""
    further = np.array([contacts.force, np.nan_to_num(contacts.moment)]).T
    right, found = np.concatenate([contacts.shape, further], axis=1), np.zeros(touching.shape)
    unsettled = np.arange(len(found))
    for _ in range(SETS):
        known = np.ones((len(unsettled), right.shape[1]), bool)
        known[:, :-2] = touching[unsettled]
        count = known[:, :-2].sum(1)
        known[:, -2], known[:, -1] = count > 0, count > 1  # a single cell bears no moment
        whole, wanted = matrix[unsettled], right[unsettled]
        system = np.where(known[:, None] & known[..., None], whole, np.eye(known.shape[1]))
        solved = np.linalg.solve(system, (wanted * known)[..., None])
        loads, overlap = solved[:, :-2, 0], (wanted[..., None] - whole @ solved)[:, :-2, 0] > 0
        pulled = known[:, :-2] & (loads < 0)
        changed = np.where(pulled.any(axis=1, keepdims=True), pulled, ~known[:, :-2] & overlap)
        found[unsettled] = loads
        touching[unsettled] ^= changed
        unsettled = unsettled[changed.any(axis=1)]
        if not len(unsettled):
            break
    return np.maximum(found, 0.0)


def sliced_peak_error(
    states: BearingStates, bearings: Sequence[CylindricalRollerBearing], sliced: NDArray
) -> NDArray:
    """Error (C) of the largest pressure of slices over that of the same contact on half-spaces [-].

    It is that of the contact with the largest slice: 0 where its pressure is smooth along the roller, 1 at an
    end that it presses. `sliced` (C, 2) is the largest pressure at the inner and outer raceway, of slices
    [Pa].

    Source
    ------
    `line_loads`.

    Valid
    -----
    An indicator: it finds random rollers with more than 10 %, and hardly others, see
    `benchmarks/pressed_ends.py`.
    """
    cases = np.arange(len(sliced))
    largest = states.slice_pressure.max(axis=3)
    race, number = np.unravel_index(largest.reshape(len(cases), -1).argmax(axis=1), largest.shape[1:])
    radius, modulus = states.contact_radius[cases, race], states.contact_modulus[cases, race]
    lengths = np.array([bearing.roller.length for bearing in bearings])
    slender = half_width(states.slice_loads[cases, race, number].mean(axis=1), radius, modulus) / lengths
    rough = ~is_smooth(states.slice_pressure[cases, race, number], slender)
    errors, cells = np.zeros(len(cases)), number_of_cells(slender)
    for count in sorted({*cells[rough].tolist()}):
        some = np.flatnonzero(rough & (cells == count))
        contacts = _contacts(states, bearings, (some, race[some], number[some]), int(count))
        errors[some] = contacts.peak_error(sliced[some, race[some]])
    return errors


def number_of_cells(slender: NDArray) -> NDArray:
    """Cells along rollers of some half-widths over their lengths: much shorter ones alternate in load."""
    with np.errstate(divide="ignore"):
        return np.clip(STEP * np.round(1 / slender / STEP), FEWEST, MOST)


def in_cells(along: NDArray, count: int) -> NDArray:
    """Values (C, K) of slices in the middles of n equal cells, (C, n)."""
    return along[:, (2 * np.arange(count) + 1) * along.shape[1] // (2 * count)]


def is_smooth(along: NDArray, slender: NDArray) -> NDArray:
    """Whether pressures (..., K) fall so far, and so evenly, towards both ends that slices have their peak.

    Their powers 1.8 are about the approach: its second differences are small, and so is its second derivative
    by the place over the length, times the half-width over the length.
    """
    count, largest = along.shape[-1], along.max(axis=-1)
    if count < 3:
        return np.zeros(largest.shape, bool)
    with np.errstate(invalid="ignore", divide="ignore"):  # without load nothing is missing
        approach = (along / largest[..., None]) ** 1.8
    turn = np.abs(np.diff(approach, 2, axis=-1)).max(axis=-1)
    left = np.maximum(along[..., 0], along[..., -1])
    smooth = (turn < TURN) & (turn * count**2 * slender < BENT) & (left < LEFT * largest)
    return smooth | ~(largest > 0)


def _contacts(
    states: BearingStates,
    bearings: Sequence[CylindricalRollerBearing],
    places: tuple[NDArray, NDArray, NDArray],
    count: int,
) -> LineContacts:
    """Contacts of cases, raceways and rollers (N), each in so many cells."""
    case, race, number = places
    approach = states.balance.approach(states.unknowns)[race, :, case, number].copy()  # (N, M)
    approach[:, 0] = 0.0
    cells = (np.arange(count) + 0.5) / count - 0.5
    lengths = np.array([bearings[each].roller.length for each in case])
    drop = [
        bearings[of].drop(int(side), cells * length, length)
        for of, side, length in zip(case, race, lengths, strict=True)
    ]
    loads = states.slice_loads[case, race, number]
    moment = (loads * states.slice_positions[case]).sum(axis=1) * lengths / loads.shape[1]
    free = np.broadcast_to(states.balance.points.free_tilt[:, 0], len(states.scaled))[case]
    return LineContacts(
        force=states.loads[case, race, number],
        shape=legval(2 * cells, approach.T, tensor=True) - drop,
        moment=np.where(free, moment, np.nan),
        length=lengths,
        radius=states.contact_radius[case, race],
        modulus=states.contact_modulus[case, race],
        sliced=in_cells(loads, count),
    )
