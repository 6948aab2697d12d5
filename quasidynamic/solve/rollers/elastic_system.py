"""Linear solve between elastic raceways: what acts on rollers of them, where contacts are closed."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import LARGE_DEVIATION

CASES_AT_ONCE = 16  # whose matrices stay in the processor's cache
MANY = 60  # rollers from which on LAPACK is worth loading
OPEN = 1e-13  # of the steepest slope of a contact: what the rounded load law leaves of it in a gap


def cyclic_tridiagonal(
    middle: NDArray, before: NDArray, after: NDArray, sides: NDArray, rows: int = 1
) -> NDArray:
    """Solve middle s_j + before s_(j-1) + after s_(j+1) = sides (R, C, Z), cyclic in each row, for all cases.

    Not a number for cases whose system is singular: such as that of rollers which only hand on their spin,
    where the speed of all of them together is undetermined. Up to `MANY` rollers full matrices are quicker.
    """
    if rows > 1:  # each as a case of its own
        alone = middle.reshape(-1, middle.shape[1] // rows), before.repeat(rows, 0), after.repeat(rows, 0)
        of_rows = cyclic_tridiagonal(*alone, sides.reshape(len(sides), *alone[0].shape))
        return of_rows.reshape(sides.shape)
    rollers = sides.shape[2]
    if rollers > MANY:
        return _by_lapack(middle, before, after, sides)
    matrix, here = np.zeros((*middle.shape, rollers)), np.arange(rollers)
    matrix[:, here, here] = middle
    matrix[:, here, here - 1] += before
    matrix[:, here - 1, here] += after
    return dense(matrix, sides.transpose(1, 2, 0)).transpose(2, 0, 1)


def _by_lapack(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """The same as a chain that is cut open; not a number where that is singular, too."""
    count, (cases, rollers) = len(sides), middle.shape
    ends = np.zeros((2, cases, rollers))  # last spin in the first equation, the reverse
    ends[0, :, 0], ends[1, :, -1] = before[:, 0], after[:, 0]
    solved = np.array([
        _chain_by_lapack(*each)
        for each in zip(middle, before, after, np.concatenate([sides, ends]).swapaxes(0, 1), strict=True)
    ]).swapaxes(0, 1)  # fmt: skip
    opened, (first, last) = solved[:count], solved[count:]
    # Both ends of the chain from each other: s_last = opened_last - first s_last - last s_first, ...
    a, b, c, d = 1 + first[:, -1], last[:, -1], first[:, 0], 1 + last[:, 0]
    end, begin = opened[:, :, -1], opened[:, :, 0]
    determinant = _nonzero(a * d - b * c)
    end, begin = (d * end - b * begin) / determinant, (a * begin - c * end) / determinant
    return opened - first * end[..., None] - last * begin[..., None]


def _chain_by_lapack(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Solve one open chain for sides (R, Z)."""
    from scipy.linalg.lapack import dgtsv  # pyright: ignore[reportAttributeAccessIssue]  # made at import

    beside = len(middle) - 1
    *_, solved, fault = dgtsv(np.repeat(before, beside), middle, np.repeat(after, beside), sides.T)
    return np.full(sides.shape, np.nan) if fault else solved.T


def _nonzero(divisor: NDArray) -> NDArray:
    return np.where(divisor == 0, np.nan, divisor)


def dense(matrix: NDArray, side: NDArray) -> NDArray:
    """Solve small dense systems (C, n, n); not a number where one is singular."""
    try:
        return np.linalg.solve(matrix, side)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.full(side.shape, np.nan)
        return np.concatenate([dense(m[None], s[None]) for m, s in zip(matrix, side, strict=True)])


class Chain(NamedTuple):
    """Spins s_j = `right_j` - `border_j` b - sum_i `spread_ij` t_i under torques t of felt deviations."""

    border: NDArray  # (5, C, Z)
    right: NDArray  # (R, C, Z)
    spread: NDArray  # (C, Z, Z)


class Closed(NamedTuple):
    """The n felt deviations that change a contact force in any case."""

    roller: NDArray  # (n)
    combination: NDArray  # (n) among the P of a roller
    slopes: NDArray  # (n, 1 + 5, C) of spin and border
    deflections: NDArray  # (Z, D, n) by contact forces


class Solution(NamedTuple):
    """Unknowns of C cases for R right-hand sides, scaled."""

    border: NDArray  # (5, R, C)
    spins: NDArray  # (R, C, Z)
    felt: NDArray  # (P, R, C, Z)
    deviations: NDArray  # (C, Z D, R) in the order of the unknowns


CASE_AXES = (2, 1, 2, 0)  # of these


def between_elastic_raceways(
    balance: BearingBalance, system: Linearisation, table: NDArray, border: NDArray, right: NDArray
) -> Solution:
    r"""Solve for what is left when every roller is eliminated on its own.

    Contact forces f and the compliance C of the raceways give the D deviations w of every roller; P
    combinations v of them act on it, fewer between two elastic raceways:

    .. math:: w = C f + r,\quad v = \Pi w,\quad f = F_b b + F_s s + F_v v - f_r

    The chain of the spins s is eliminated, then the border b and the v of closed contacts are solved densely:
    an open contact has no slope by its v.

    The table (1 + 5 + D, 1 + 5 + P + R, C, Z) has rows of spin, border and contact forces, columns of spin,
    border, v and right-hand sides; the border (C, 5, 5) are its balances by its unknowns. Right-hand sides
    (C, N, R) are scaled.

    Source
    ------
    Schur complements; derived here.

    Valid
    -----
    A chain of spins that is singular by itself gives no numbers, also where the whole system is not singular.
    """
    parts = []
    for first in range(0, len(right), CASES_AT_ONCE):
        some = slice(first, first + CASES_AT_ONCE)
        around = system.before[some], system.after[some]
        parts.append(_solved(balance, around, table[:, :, some], border[some], right[some]))
    if len(parts) == 1:
        return parts[0]
    each = zip(zip(*parts, strict=True), CASE_AXES, strict=True)
    return Solution(*(np.concatenate(values, axis) for values, axis in each))


def _solved(
    balance: BearingBalance, around: tuple[NDArray, NDArray], table: NDArray, border: NDArray, right: NDArray
) -> Solution:
    """Solve a few cases, spins with those before and after (C, 1)."""
    count = right.shape[2]
    given = LARGE_DEVIATION * right[:, balance.layout.fields_end :]
    chain, closed = _chain(balance, around, table, count), _closed(balance, table, count)
    matrix, side = _reduced(table, chain, closed)
    bordering = balance.layout.border
    matrix[:, :bordering, :bordering] += border
    side[:, :bordering] += right[:, :bordering]
    side[:, bordering:] += felt_of(balance, given)[closed.combination, :, :, closed.roller].transpose(2, 0, 1)
    unknowns = dense(matrix, side).transpose(1, 2, 0)
    felt = np.zeros((table.shape[1] - 1 - bordering - count, count, *table.shape[2:]))
    felt[closed.combination, :, :, closed.roller] = unknowns[bordering:]
    spins = _spins(
        chain, unknowns[:bordering], np.einsum("pcz,prcz->rcz", table[0, 1 + bordering : -count], felt)
    )
    forces = _forces(table, spins, unknowns[:bordering], felt)
    deviations = given + LARGE_DEVIATION * deflections(balance, forces)
    return Solution(unknowns[:bordering], spins, felt_of(balance, deviations), deviations)


def _chain(balance: BearingBalance, around: tuple[NDArray, NDArray], table: NDArray, count: int) -> Chain:
    """Spins by border, right-hand sides and torques."""
    layout, (cases, rollers) = balance.layout, table.shape[2:]
    torques = np.eye(rollers)[:, None].repeat(cases, axis=1)
    sides = np.concatenate([table[0, 1 : 1 + layout.border], table[0, -count:], torques])
    spins = cyclic_tridiagonal(table[0, 0], *around, sides, layout.rows)
    border, right, spread = spins[: layout.border], spins[layout.border : -rollers], spins[-rollers:]
    return Chain(border, right, np.ascontiguousarray(spread.transpose(1, 2, 0)))


def _closed(balance: BearingBalance, table: NDArray, count: int) -> Closed:
    """Felt deviations with a slope."""
    felt = 1 + balance.layout.border  # first column of felt deviations, row of contact forces
    steepest = np.abs(table[:, felt:-count]).max(axis=0)  # (P, C, Z)
    closed = ~(steepest <= OPEN * steepest.max((0, 2), keepdims=True)).all(axis=1)
    roller, combination = np.nonzero(closed.T)
    places = roller * len(closed) + combination
    deflections = LARGE_DEVIATION * np.take(balance.felt_deflections, places, axis=2)
    return Closed(roller, combination, table[:felt, felt + combination, :, roller], deflections)


def _reduced(table: NDArray, chain: Chain, closed: Closed) -> tuple[NDArray, NDArray]:
    """What rollers add to the matrix (C, 5 + n, 5 + n) and right side (C, 5 + n, R) of border and v.

    The matrix stands column by column, as it is made and as LAPACK wants it.
    """
    cases, rollers = table.shape[2:]
    border, count = len(chain.border), len(chain.right)
    felt, size, by_force = 1 + border, border + len(closed.roller), closed.deflections
    by_spin = np.empty((cases, rollers, size))
    by_spin[:, :, :border] = table[1:felt, 0].transpose(1, 2, 0)
    by_spin[:, :, border:] = -(table[felt:, 0].transpose(2, 1, 0) @ by_force).transpose(1, 0, 2)
    through_spins = np.take(chain.spread.transpose(0, 2, 1) @ by_spin, closed.roller, axis=1)
    through_spins *= closed.slopes[:, 0].T[:, :, None]
    forces = table[felt:, felt + closed.combination, :, closed.roller].transpose(0, 2, 1)  # (n, C, D) by v
    columns = np.empty((cases, size, size))
    columns[:, border:, :border] = closed.slopes[:, 1:].transpose(2, 0, 1)
    columns[:, border:, border:] = -(forces @ by_force[closed.roller]).transpose(1, 0, 2)
    columns[:, border:] -= through_spins
    columns.reshape(cases, -1)[:, border * (size + 1) :: size + 1] += 1.0  # on the diagonal
    spins = np.concatenate([chain.border, chain.right])
    rest = np.concatenate([table[1:, 1:felt], table[1:, -count:]], axis=1) - table[1:, :1] * spins
    left = rest[border:].transpose(3, 0, 1, 2).reshape(-1, len(spins) * cases)
    lower = -(by_force.reshape(len(left), -1).T @ left).reshape(-1, len(spins), cases)
    of_rest = np.concatenate([rest[:border].sum(-1), lower]).transpose(2, 1, 0)
    columns[:, :border] = of_rest[:, :border]
    return columns.transpose(0, 2, 1), of_rest[:, border:].transpose(0, 2, 1)


def _spins(chain: Chain, border: NDArray, torques: NDArray) -> NDArray:
    """Spins (R, C, Z) with border (5, R, C) and torques (R, C, Z) of felt deviations."""
    spread = (torques.transpose(1, 0, 2) @ chain.spread.transpose(0, 2, 1)).transpose(1, 0, 2)
    return chain.right - np.einsum("brc,bcz->rcz", border, chain.border) - spread


def _forces(table: NDArray, spins: NDArray, border: NDArray, felt: NDArray) -> NDArray:
    """Contact forces (D, R, C, Z) on elastic raceways."""
    around = border[..., None].repeat(spins.shape[-1], axis=-1)
    unknowns = np.concatenate([spins[None], around, felt])
    first = 1 + len(border)  # row of the forces
    moved = np.einsum("dkcz,krcz->drcz", table[first:, : len(unknowns)], unknowns)
    return moved - table[first:, len(unknowns) :]


def deflections(balance: BearingBalance, forces: NDArray) -> NDArray:
    """Deviations (C, Z D, R) under contact forces (D, R, C, Z), scaled alike."""
    m, (_, count, cases, _) = balance.layout.axial_modes, forces.shape
    deviations = []
    for place, race in enumerate(balance.layout.elastic_raceways):
        of_race = forces[place * m : (place + 1) * m].transpose(3, 0, 2, 1).reshape(-1, cases * count)
        deviations.append(balance.deflection(race, of_race))
    return np.concatenate(deviations).reshape(-1, cases, count).transpose(1, 0, 2)


def felt_of(balance: BearingBalance, deviations: NDArray) -> NDArray:
    """What acts on rollers (P, R, C, Z) of deviations (C, Z D, R)."""
    layout, (cases, _, count) = balance.layout, deviations.shape
    shape = (cases, len(layout.elastic_raceways), layout.rollers, layout.axial_modes, count)
    by_roller = deviations.reshape(shape).transpose(1, 3, 4, 0, 2).reshape(-1, count, cases, layout.rollers)
    felt = balance.kinematics.felt.dot(by_roller.reshape(len(by_roller), -1))
    return felt.reshape(-1, *by_roller.shape[1:])
