"""Linear solve of the sparse Jacobian: each roller by itself, a cyclic chain of spins, a border."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.kinematics import next_in_row
from quasidynamic.balance.rollers.unknowns import CAGE, LARGE_DEVIATION, TILT_Y, TILT_Z, Y, Z
from quasidynamic.solve.rollers.elastic_system import (
    between_elastic_raceways,
    cyclic_tridiagonal,
    deflections,
    dense,
    felt_of,
)


class Shift(NamedTuple):
    """What is subtracted from the diagonal of the scaled matrix."""

    spin: NDArray | float = 0.0  # (C, Z) at each spin: inertia over time step
    cage: NDArray | float = 0.0  # (C) at the cage speed: the same
    ring: NDArray | float = 0.0  # (C) at both displacements: a stiffness that is not there
    tilt: NDArray | float = 0.0  # (C) at both tilts: the same


NO_SHIFT = Shift()


def solve(balance: BearingBalance, system: Linearisation, right: NDArray, shift: Shift = NO_SHIFT) -> NDArray:
    """Solve the linearised balance for several right-hand sides.

    Every roller is eliminated on its own, then the cyclic chain of spins, then the border: the cost grows
    linearly with the number of rollers. Deviations of elastic raceways are solved densely.
    """
    layout, (cases, _, count) = balance.layout, right.shape
    ring, fields_end = layout.per_roller, layout.fields_end
    spin = ring - 1
    rows, columns = system.table.shape[:2]
    table = np.zeros((rows, columns + count, cases, layout.rollers))
    table[:, :-count] = system.table
    table[:ring, -count:] = (
        right[:, layout.border : fields_end].reshape(cases, ring, layout.rollers, count).transpose(1, 3, 0, 2)
    )
    border = system.border
    if shift is not NO_SHIFT:
        table[spin, spin] -= shift.spin
        border = border.copy()
        border[:, CAGE, CAGE] -= shift.cage
        border[:, Y, Y] -= shift.ring
        border[:, Z, Z] -= shift.ring
        border[:, TILT_Z, TILT_Z] -= shift.tilt
        border[:, TILT_Y, TILT_Y] -= shift.tilt
    unknowns = np.empty((columns, count, cases, layout.rollers))
    with np.errstate(all="ignore"):
        eliminate(table, spin)
        below = system, table[spin:, spin:], border, right
        if layout.elastic_raceways:
            solution = between_elastic_raceways(balance, *below)
            of_border, spins, unknowns[ring + layout.border :], deviations = solution
        else:
            of_border, spins = _with_rigid_raceways(layout, *below)
            deviations = np.empty((cases, 0, count))
        unknowns[spin], unknowns[ring : ring + layout.border] = spins, of_border[..., None]
        substitute(table, unknowns, spin)
    rollers = unknowns[:ring].transpose(2, 0, 3, 1).reshape(cases, -1, count)
    return np.concatenate([of_border.transpose(2, 0, 1), rollers, deviations], axis=1)


def rows_by(balance: BearingBalance, system: Linearisation, change: NDArray) -> NDArray:
    """What changes of the unknowns (C, N, R) add to the rows of the table (rows, R, C, Z), both scaled."""
    layout, (cases, _, count) = balance.layout, change.shape
    ring = layout.per_roller
    rollers = change[:, layout.border : layout.fields_end].reshape(cases, ring, layout.rollers, count)
    border = change[:, : layout.border].transpose(1, 2, 0)[..., None]
    columns = [rollers.transpose(1, 3, 0, 2), np.broadcast_to(border, (*border.shape[:3], layout.rollers))]
    if layout.elastic_raceways:
        columns.append(felt_of(balance, change[:, layout.fields_end :]))
    rows = np.einsum("dkcz,krcz->drcz", system.table, np.concatenate(columns))
    spins = columns[0][ring - 1]
    before, after = (next_in_row(spins, places, layout.rows) for places in (-1, 1))
    rows[ring - 1] += system.before * before + system.after * after
    return rows


def product(balance: BearingBalance, system: Linearisation, change: NDArray) -> NDArray:
    """Changes of the residuals (C, N, R) by changes of the unknowns (C, N, R), both scaled.

    The matrix is that of `solve`.
    """
    layout, (cases, _, count) = balance.layout, change.shape
    ring, rows = layout.per_roller, rows_by(balance, system, change)
    border = (
        rows[ring : ring + layout.border].sum(-1).transpose(2, 0, 1)
        + system.border @ change[:, : layout.border]
    )
    parts = [border, rows[:ring].transpose(2, 0, 3, 1).reshape(cases, -1, count)]
    if layout.elastic_raceways:
        deflected = deflections(balance, rows[ring + layout.border :])
        parts.append(change[:, layout.fields_end :] / LARGE_DEVIATION - deflected)
    return np.concatenate(parts, axis=1)


def eliminate(table: NDArray, pivots: int) -> None:
    """Gauss: subtract the first rows from all below, in place, until their columns are empty there."""
    for i in range(pivots):
        factor, below = table[i + 1 :, i] / table[i, i], table[i + 1 :, i + 1 :]
        below -= factor[:, None] * table[i, i + 1 :]


def substitute(table: NDArray, unknowns: NDArray, pivots: int) -> None:
    """Fill in the first unknowns (columns, R, C, Z) from those that come later in the table."""
    count = unknowns.shape[1]
    for i in reversed(range(pivots)):
        known = np.einsum("kcz,krcz->rcz", table[i, i + 1 : -count], unknowns[i + 1 :])
        unknowns[i] = (table[i, -count:] - known) / table[i, i]


def _with_rigid_raceways(layout, system, table, border, right) -> tuple[NDArray, NDArray]:
    """Border (B, R, C) and spins (R, C, Z), with the spins of each row as a cyclic tridiagonal system."""
    # The spins are linear in the border unknowns and in the right-hand sides.
    spins = cyclic_tridiagonal(table[0, 0], system.before, system.after, table[0, 1:], layout.rows)
    by_border, by_right = spins[: layout.border], spins[layout.border :]
    reduced = (table[1:, 1:] - table[1:, :1] * spins).sum(-1)
    reduced = reduced.transpose(2, 0, 1)
    of_border = dense(
        border + reduced[..., : layout.border], right[:, : layout.border] + reduced[..., layout.border :]
    )
    of_border = of_border.transpose(1, 2, 0)
    return of_border, by_right - np.einsum("brc,bcz->rcz", of_border, by_border)
