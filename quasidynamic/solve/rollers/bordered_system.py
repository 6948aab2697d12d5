"""Linear solve of the sparse Jacobian: each roller by itself, a cyclic chain of spins, a border."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.scales import LARGE_DEVIATION
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, TILT_Y, TILT_Z, Y, Z


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

    Parameters
    ----------
    balance : BearingBalance
        scales and compliances
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
    ring, fields_end = layout.per_roller, layout.fields_end
    spin = ring - 1
    rows, columns = system.table.shape[:2]
    table = np.zeros((rows, columns + count, cases, layout.rollers))
    table[:, :-count] = system.table
    table[:ring, -count:] = (
        right[:, BORDER:fields_end].reshape(cases, ring, layout.rollers, count).transpose(1, 3, 0, 2)
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
    with np.errstate(all="ignore"):
        eliminate(table, spin)
        reduced = _with_elastic_raceways if layout.elastic_raceways else _with_rigid_raceways
        of_border, spins, deviations = reduced(balance, system, table[spin:, spin:], border, right)
        unknowns = np.empty((columns, count, cases, layout.rollers))
        unknowns[spin], unknowns[ring : ring + BORDER] = spins, of_border[..., None]
        unknowns[ring + BORDER :] = deviations
        substitute(table, unknowns, spin)
    solution = [of_border.transpose(2, 0, 1), unknowns[:ring].transpose(2, 0, 3, 1).reshape(cases, -1, count)]
    if layout.elastic_raceways:
        by_race = deviations.reshape(len(layout.elastic_raceways), layout.axial_modes, *deviations.shape[1:])
        solution.append(by_race.transpose(3, 0, 4, 1, 2).reshape(cases, -1, count))
    return np.concatenate(solution, axis=1)


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


def _with_rigid_raceways(balance, system, table, border, right) -> tuple[NDArray, NDArray, NDArray]:
    """Border (5, R, C), spins (R, C, Z) and no deviations, with the spins as a cyclic tridiagonal system."""
    # The spins are linear in the border unknowns and in the right-hand sides.
    spins = cyclic_tridiagonal(table[0, 0], system.before, system.after, table[0, 1:])
    by_border, by_right = spins[:BORDER], spins[BORDER:]
    reduced = (table[1:, 1:] - table[1:, :1] * spins).sum(-1)
    reduced = reduced.transpose(2, 0, 1)
    of_border = _solved(border + reduced[..., :BORDER], right[:, :BORDER] + reduced[..., BORDER:])
    of_border = of_border.transpose(1, 2, 0)
    spins = by_right - np.einsum("brc,bcz->rcz", of_border, by_border)
    return of_border, spins, np.zeros((0, *spins.shape))


def cyclic_tridiagonal(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Solve middle s_j + before s_(j-1) + after s_(j+1) = sides (R, C, Z), cyclic in j, for all cases.

    Not a number for cases whose system is singular, closed or cut open: such as that of rollers which only
    hand on their spin, where the speed of all of them together is undetermined.
    """
    # costly to import, and checking a case does without
    from scipy.linalg.lapack import dgtsv  # pyright: ignore[reportAttributeAccessIssue]  # made at import

    count, cases, rollers = sides.shape
    corners = np.zeros((2, cases, rollers))  # the last spin in the first equation, and the reverse
    corners[0, :, 0], corners[1, :, -1] = before[:, 0], after[:, 0]
    lower, upper = before.repeat(rollers, axis=1), after.repeat(rollers, axis=1)
    lower[:, 0] = upper[:, -1] = 0.0
    columns = np.concatenate([sides, corners]).reshape(count + 2, -1).T
    bands = lower.ravel()[1:], middle.ravel(), upper.ravel()[:-1]
    *_, solved, fault = dgtsv(*bands, columns, overwrite_dl=True, overwrite_du=True, overwrite_b=True)
    if fault:  # of one case; the columns of all are overwritten
        if cases == 1:
            return np.full(sides.shape, np.nan)
        each = (slice(case, case + 1) for case in range(cases))
        alone = [cyclic_tridiagonal(middle[c], before[c], after[c], sides[:, c]) for c in each]
        return np.concatenate(alone, axis=1)
    solved = solved.T.reshape(count + 2, cases, rollers)
    opened, (first, last) = solved[:count], solved[count:]
    # Both ends of the chain from each other: s_last = opened_last - first s_last - last s_first, ...
    a, b, c, d = 1 + first[:, -1], last[:, -1], first[:, 0], 1 + last[:, 0]
    end, begin = opened[:, :, -1], opened[:, :, 0]
    determinant = a * d - b * c
    determinant[determinant == 0] = np.nan
    end, begin = (d * end - b * begin) / determinant, (a * begin - c * end) / determinant
    return opened - first * end[..., None] - last * begin[..., None]


def _solved(matrix: NDArray, side: NDArray) -> NDArray:
    """Solve small dense systems (C, n, n); not a number where one is singular."""
    try:
        return np.linalg.solve(matrix, side)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.full(side.shape, np.nan)
        return np.concatenate([_solved(m[None], s[None]) for m, s in zip(matrix, side, strict=True)])


def _with_elastic_raceways(balance, system, table, border, right) -> tuple[NDArray, NDArray, NDArray]:
    """Border (5, R, C), spins (R, C, Z), deviations (races M, R, C, Z), one dense system for each case."""
    layout, count = balance.layout, right.shape[2]
    rollers, modes = layout.rollers, len(layout.elastic_raceways) * layout.axial_modes
    solutions = []
    for case in range(len(right)):
        of_case = table[:, :, case]
        matrix = _assembled(balance, system, of_case[:, : 1 + BORDER + modes], border[case], case)
        side = np.zeros((len(matrix), count))
        columns = of_case[:, 1 + BORDER + modes :]
        side[:BORDER] = right[case, :BORDER] + columns[1 : 1 + BORDER].sum(-1)
        side[BORDER : BORDER + rollers] = columns[0].T
        forces = columns[1 + BORDER :]
        side[BORDER + rollers :] = right[case, layout.fields_end :] - _deflections(balance, forces)
        solutions.append(_solved(matrix[None], side[None])[0])
    of_border, spins, deviations = np.split(np.array(solutions), [BORDER, BORDER + rollers], axis=1)
    deviations = deviations.reshape(len(right), -1, rollers, layout.axial_modes, count)
    return (
        of_border.transpose(1, 2, 0),
        spins.transpose(2, 0, 1),
        deviations.transpose(1, 3, 4, 0, 2).reshape(modes, count, len(right), rollers),
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
    contact_forces = np.zeros((races * m, z, size))  # on elastic raceways
    forces = table[1 + BORDER :]
    contact_forces[:, :, :BORDER] = forces[:, 1 : 1 + BORDER].transpose(0, 2, 1)
    contact_forces[:, each, spins] = forces[:, 0]
    for column, place in enumerate(places, start=1 + BORDER):
        contact_forces[:, each, place] = forces[:, column]
    matrix[BORDER + z :] = -_deflections(balance, contact_forces.transpose(0, 2, 1))
    rows = np.arange(BORDER + z, size)
    matrix[rows, rows] += 1 / LARGE_DEVIATION
    return matrix


def _deflections(balance, forces: NDArray) -> NDArray:
    """Deviations (races Z M, R) under forces (races M, R, Z), scaled alike."""
    m, size = balance.layout.axial_modes, balance.layout.rollers * balance.layout.axial_modes
    each = [
        balance.deflection(race, forces[place * m : (place + 1) * m].transpose(2, 0, 1).reshape(size, -1))
        for place, race in enumerate(balance.layout.elastic_raceways)
    ]
    return np.concatenate(each)
