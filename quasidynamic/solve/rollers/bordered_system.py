"""Linear solve that knows who feels whom: each roller by itself, a ring of spins, a border."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgtsv  # pyright: ignore[reportAttributeAccessIssue]  # made at import

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.scales import LARGE_DEVIATION, LENGTH
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, INNER, UnknownLayout, Y, Z


class Shift(NamedTuple):
    """What is subtracted from the diagonal of the scaled matrix."""

    spin: NDArray | float = 0.0  # (C, Z) at each spin: inertia over time step
    cage: NDArray | float = 0.0  # (C) at the cage speed: the same
    ring: NDArray | float = 0.0  # (C) at both displacements: a stiffness that is not there


NO_SHIFT = Shift()


def solve(balance: BearingBalance, system: Linearisation, right: NDArray, shift: Shift = NO_SHIFT) -> NDArray:
    """Solve the linearised balance for several right-hand sides.

    Every roller is eliminated on its own, then the ring of spins, then the border: the cost grows
    linearly with the number of rollers. Deviations of yielding raceways are solved densely.

    Parameters
    ----------
    balance : BearingBalance
        tells sizes and compliances
    system : Linearisation
        matrix of C cases
    right : array (C, N, R)
        right-hand sides, scaled
    shift : Shift, optional
        inertia over time step, or stiffness that holds the ring

    Returns
    -------
    array (C, N, R)
        not a number for cases whose matrix is singular
    """
    layout, (cases, _, count) = balance.layout, right.shape
    own, split = layout.per_roller, layout.fields_end
    rows, columns = system.table.shape[:2]
    table = np.zeros((rows, columns + count, cases, layout.rollers))
    table[:, :-count] = system.table
    table[:own, -count:] = (
        right[:, BORDER:split].reshape(cases, own, layout.rollers, count).transpose(1, 3, 0, 2)
    )
    border = system.border
    if shift is not NO_SHIFT:
        table[own - 1, own - 1] -= shift.spin
        border = _shifted(border, shift)
    with np.errstate(all="ignore"):
        eliminate(table, own - 1)
        rest = _dense if layout.elastic_raceways else _chained
        edge, spin, shared = rest(balance, system, table[own - 1 :, own - 1 :], border, right)
        found = np.empty((columns, count, cases, layout.rollers))
        found[own - 1], found[own : own + BORDER], found[own + BORDER :] = spin, edge[..., None], shared
        substitute(table, found, own - 1)
    fields = found[:own].transpose(2, 0, 3, 1).reshape(cases, -1, count)
    solved = [edge.transpose(2, 0, 1), fields]
    if layout.elastic_raceways:
        solved.append(_deviations(layout, shared))
    return np.concatenate(solved, axis=1)


def _shifted(border: NDArray, shift: Shift) -> NDArray:
    """Border (C, 5, 5) with its part of the shift."""
    border = border.copy()
    border[:, CAGE, CAGE] -= shift.cage
    border[:, Y, Y] -= shift.ring
    border[:, Z, Z] -= shift.ring
    return border


def eliminate(table: NDArray, pivots: int) -> None:
    """Gauss: subtract the first rows from all below, in place, until their columns are empty there."""
    for i in range(pivots):
        factor, below = table[i + 1 :, i] / table[i, i], table[i + 1 :, i + 1 :]
        below -= factor[:, None] * table[i, i + 1 :]


def substitute(table: NDArray, found: NDArray, pivots: int) -> None:
    """Fill in the first unknowns (columns, R, C, Z) from those that come later in the table."""
    count = found.shape[1]
    for i in reversed(range(pivots)):
        known = np.einsum("kcz,krcz->rcz", table[i, i + 1 : -count], found[i + 1 :])
        found[i] = (table[i, -count:] - known) / table[i, i]


def _chained(balance, system, table, border, right) -> tuple[NDArray, NDArray, NDArray]:
    """Border (5, R, C), spins (R, C, Z) and no deviations, with the spins as a cyclic tridiagonal ring."""
    # Whatever the spins answer is linear in the right-hand sides and in the border unknowns.
    spin = around(table[0, 0], system.before, system.after, table[0, 1:])
    by_border, by_side = spin[:BORDER], spin[BORDER:]
    reduced = (table[1:, 1:] - table[1:, :1] * spin).sum(-1)
    reduced = reduced.transpose(2, 0, 1)
    edge = _solved(border + reduced[..., :BORDER], right[:, :BORDER] + reduced[..., BORDER:])
    edge = edge.transpose(1, 2, 0)
    return edge, by_side - np.einsum("brc,bcz->rcz", edge, by_border), np.zeros((0, *by_side.shape))


def around(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Solve the ring middle s_j + before s_(j-1) + after s_(j+1) = sides (R, C, Z), for all cases at once.

    Not a number for cases whose ring is singular, closed or cut open: such as that of rollers which only
    hand on their spin, where nothing tells how fast all of them turn.
    """
    count, cases, rollers = sides.shape
    corners = np.zeros((2, cases, rollers))  # what the last spin does to the first one, and the reverse
    corners[0, :, 0], corners[1, :, -1] = before[:, 0], after[:, 0]
    lower, upper = before.repeat(rollers, axis=1), after.repeat(rollers, axis=1)
    lower[:, 0] = upper[:, -1] = 0.0
    columns = np.concatenate([sides, corners]).reshape(count + 2, -1).T
    bands = lower.ravel()[1:], middle.ravel(), upper.ravel()[:-1]
    *_, solved, fault = dgtsv(*bands, columns, overwrite_dl=True, overwrite_du=True, overwrite_b=True)
    if fault:  # of one case, and the columns are spent
        return _one_by_one(middle, before, after, sides)
    solved = solved.T.reshape(count + 2, cases, rollers)
    open_ring, (first, last) = solved[:count], solved[count:]
    # The two ends of the ring from each other: s_last = open_last - first s_last - last s_first, ...
    a, b, c, d = 1 + first[:, -1], last[:, -1], first[:, 0], 1 + last[:, 0]
    end, begin = open_ring[:, :, -1], open_ring[:, :, 0]
    determinant = a * d - b * c
    determinant[determinant == 0] = np.nan
    end, begin = (d * end - b * begin) / determinant, (a * begin - c * end) / determinant
    return open_ring - first * end[..., None] - last * begin[..., None]


def _one_by_one(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Like `around`, so that a case whose ring cannot be cut open spoils no other."""
    if len(middle) == 1:
        return np.full(sides.shape, np.nan)
    each = (slice(case, case + 1) for case in range(len(middle)))
    return np.concatenate([around(middle[c], before[c], after[c], sides[:, c]) for c in each], axis=1)


def _solved(matrix: NDArray, side: NDArray) -> NDArray:
    """Solve small dense systems (C, n, n); not a number where one is singular."""
    try:
        return np.linalg.solve(matrix, side)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.full(side.shape, np.nan)
        return np.concatenate([_solved(m[None], s[None]) for m, s in zip(matrix, side, strict=True)])


def _dense(balance, system, table, border, right) -> tuple[NDArray, NDArray, NDArray]:
    """Border (5, R, C), spins (R, C, Z), deviations (races M, R, C, Z), one dense system for each case."""
    layout, count = balance.layout, right.shape[2]
    rollers, yields = layout.rollers, len(layout.elastic_raceways) * layout.axial_modes
    found = []
    for case in range(len(right)):
        here = table[:, :, case]
        matrix = _assembled(balance, system, here[:, : 1 + BORDER + yields], border[case], case)
        side = np.zeros((len(matrix), count))
        columns = here[:, 1 + BORDER + yields :]
        side[:BORDER] = right[case, :BORDER] + columns[1 : 1 + BORDER].sum(-1)
        side[BORDER : BORDER + rollers] = columns[0].T
        forces = columns[1 + BORDER :]
        side[BORDER + rollers :] = right[case, layout.fields_end :] - _pressed(balance, forces)
        found.append(_solved(matrix[None], side[None])[0])
    solved = np.array(found)
    edge, spin = solved[:, :BORDER], solved[:, BORDER : BORDER + rollers]
    axial_modes = solved[:, BORDER + rollers :].reshape(
        len(right), len(layout.elastic_raceways), rollers, layout.axial_modes, count
    )
    return (
        edge.transpose(1, 2, 0),
        spin.transpose(2, 0, 1),
        axial_modes.transpose(1, 3, 4, 0, 2).reshape(yields, count, len(right), rollers),
    )


def _assembled(balance, system, table: NDArray, border: NDArray, case: int) -> NDArray:
    """Matrix of border, spins and deviations from the reduced table (rows, columns, Z) of a case."""
    layout = balance.layout
    z, m, races = layout.rollers, layout.axial_modes, len(layout.elastic_raceways)
    each = np.arange(z)
    size = BORDER + z + races * z * m
    matrix, spins = np.zeros((size, size)), BORDER + each
    places = [BORDER + z + place * z * m + each * m + k for place in range(races) for k in range(m)]
    matrix[:BORDER, :BORDER] = border + table[1 : 1 + BORDER, 1 : 1 + BORDER].sum(-1)
    matrix[:BORDER, BORDER : BORDER + z] = table[1 : 1 + BORDER, 0]
    matrix[BORDER : BORDER + z, :BORDER] = table[0, 1 : 1 + BORDER].T
    matrix[spins, spins] = table[0, 0]
    matrix[spins, np.roll(spins, 1)] += system.before[case]
    matrix[spins, np.roll(spins, -1)] += system.after[case]
    for column, place in enumerate(places, start=1 + BORDER):
        matrix[:BORDER, place] = table[1 : 1 + BORDER, column]
        matrix[spins, place] = table[0, column]
    felt = np.zeros((races * m, z, size))  # what the forces on yielding raceways feel
    forces = table[1 + BORDER :]
    felt[:, :, :BORDER] = forces[:, 1 : 1 + BORDER].transpose(0, 2, 1)
    felt[:, each, spins] = forces[:, 0]
    for column, place in enumerate(places, start=1 + BORDER):
        felt[:, each, place] = forces[:, column]
    matrix[BORDER + z :] = -_pressed(balance, felt.transpose(0, 2, 1))
    rows = np.arange(BORDER + z, size)
    matrix[rows, rows] += LENGTH / LARGE_DEVIATION
    return matrix


def _pressed(balance, forces: NDArray) -> NDArray:
    """Deviations (races Z M, R) under forces (races M, R, Z), scaled alike."""
    layout, m, answers = balance.layout, balance.layout.axial_modes, []
    for place, race in enumerate(layout.elastic_raceways):
        here = forces[place * m : (place + 1) * m].transpose(2, 0, 1).reshape(layout.rollers * m, -1)
        answers.append((-1.0 if race == INNER else 1.0) * balance.compliance[race] @ here)
    return np.concatenate(answers)


def _deviations(layout: UnknownLayout, axial_modes: NDArray) -> NDArray:
    """Deviation unknowns (C, races Z M, R) from axial_modes (races M, R, C, Z)."""
    m, races = layout.axial_modes, len(layout.elastic_raceways)
    _, count, cases, rollers = axial_modes.shape
    split = axial_modes.reshape(races, m, count, cases, rollers)
    return split.transpose(3, 0, 4, 1, 2).reshape(cases, -1, count)
