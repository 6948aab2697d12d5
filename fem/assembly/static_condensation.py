"""The stiffness that a body shows at a few of its unknowns, all others eliminated.

Sparse solvers do not hand out the Schur complement they form on the way, and one solve for each of
hundreds of kept unknowns would take far longer than the factorisation. Here the elements are halved
again and again; an unknown goes when the smallest group that holds all its elements is done, by dense
algebra on what that group still has in common with the rest (Duff and Reid 1983, George 1973).
"""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.linalg import LinAlgError, cholesky, solve_triangular
from scipy.linalg.blas import dsyrk  # pyright: ignore[reportAttributeAccessIssue]  # made at import

from fem.errors import NotSolved

SMALLEST = 16  # elements in a group that is not halved any more; speed only
UNEVEN = 0.2  # least part of a group that is split off
BLOCK = 32  # rows of a matrix that are added at once; speed only


@dataclass(frozen=True)
class Substructure:
    """Stiffness at the kept unknowns, bordered by loads, and the way back to the eliminated ones."""

    schur: NDArray  # (kept + loads, kept + loads) symmetric
    size: int  # number of all unknowns
    eliminated: NDArray  # unknowns in the order of elimination
    kept: NDArray  # unknowns in the order of `schur`
    fronts: list[tuple[slice, NDArray, NDArray, NDArray]]  # eliminated, remaining, triangle, coupling

    def interior(self, kept: NDArray) -> NDArray:
        """All unknowns from the kept ones and the loads.

        .. math:: u_i = K_{ii}^{-1} (F_i q - K_{ik} u_k)

        `kept` has u_k and q in the order of `schur`, (kept + loads, columns); unknowns that were left out are
        zero.

        Source
        ------
        Static condensation, exact without inertia; order of elimination after Duff and Reid (1983), George
        (1973).
        """
        u = np.vstack([np.zeros((self.eliminated.size, kept.shape[1])), kept])
        for eliminated, remaining, triangle, coupling in reversed(self.fronts):
            u[eliminated] = -solve_triangular(triangle, coupling @ u[remaining], check_finite=False)
        displacement = np.zeros((self.size, kept.shape[1]))
        order = np.concatenate([self.eliminated, self.kept])
        displacement[order] = u[: order.size]
        return displacement


def owners(elements: Sequence[NDArray], centres: NDArray, unknowns: int) -> NDArray:
    """The smallest group of elements that holds all elements of an unknown, groups numbered in a binary tree.

    Children of g are 2 g and 2 g + 1, the root is 1; unknowns without elements have 0. `elements` are the
    unknowns of every element, `centres` (elements, 3) any point of each.
    """
    leaf = _halved(elements, centres, unknowns)
    depth = _depth(leaf.max())
    counts = [len(e) for e in elements]
    member, group = np.concatenate(elements), np.repeat(leaf, counts)
    lift = depth - _depth(group)
    # first and last number that descendants have in the deepest generation
    first, last = np.full(unknowns, 2 ** (depth + 1)), np.zeros(unknowns, dtype=int)
    np.minimum.at(first, member, group << lift)
    np.maximum.at(last, member, ((group + 1) << lift) - 1)
    return np.where(last > 0, first >> (1 + _depth(np.where(last > 0, first ^ last, 0))), 0)


def eliminate(stiffness: sparse.csr_array, loads: NDArray, owner: NDArray, kept: NDArray) -> Substructure:
    r"""Schur complement of a symmetric matrix at its kept unknowns, bordered by loads.

    .. math::
        S = \begin{bmatrix} K_{kk} & -F_k \\ -F_k^T & 0 \end{bmatrix}
            - \begin{bmatrix} K_{ki} \\ -F_i^T \end{bmatrix} K_{ii}^{-1}
              \begin{bmatrix} K_{ik} & -F_i \end{bmatrix}

    K is whole and symmetric, positive definite at the eliminated unknowns, any at the kept ones; F (unknowns,
    loads) are load vectors of unit forces q. `owner` is from `owners`, 0 for the unknowns that are left out
    (held, or kept); `kept` says which unknowns stay, in this order.
    Raises `NotSolved` if nothing holds the body once the kept unknowns are held.

    Source
    ------
    Static condensation, exact without inertia; order of elimination after Duff and Reid (1983), George
    (1973).
    """
    eliminated = np.flatnonzero(owner)
    # children have higher numbers than their parents
    eliminated = eliminated[np.argsort(-owner[eliminated], kind="stable")]
    order = np.concatenate([eliminated, kept])
    place = np.full(owner.size, -1)
    place[order] = np.arange(order.size)

    def entries(unknowns: NDArray, first: int) -> tuple[NDArray, NDArray, NDArray]:
        """Row, column in the new order and value of all that unknowns have from a first column on."""
        rows, border = stiffness[unknowns], loads[unknowns]
        loaded, load = np.nonzero(border)
        row = np.append(np.repeat(np.arange(unknowns.size), np.diff(rows.indptr)), loaded)
        column = np.append(place[rows.indices], order.size + load)
        ahead = column >= first
        return row[ahead], column[ahead], np.append(rows.data, -border[loaded, load])[ahead]

    group_of = owner[eliminated]
    groups, starts = np.unique(-group_of, return_index=True)
    stops = np.append(starts, eliminated.size)[1:]
    updates, fronts, position = defaultdict(list), [], np.zeros(order.size + loads.shape[1], dtype=int)
    for group, start, stop in zip(-groups, starts, stops, strict=True):
        children = updates.pop(group, [])
        front = _assembled(slice(start, stop), entries(order[start:stop], start), children, position)
        fronts.append((slice(start, stop), *_reduced(*front, updates, group_of)))
    row, column, values = entries(kept, eliminated.size)
    schur = np.zeros((kept.size + loads.shape[1],) * 2)
    schur[column - eliminated.size, row] = values
    for unknowns, update in updates.pop(0, []):
        _add(schur, unknowns - eliminated.size, unknowns - eliminated.size, update)
    schur = np.tril(schur) + np.tril(schur, -1).T
    return Substructure(schur=schur, size=owner.size, eliminated=eliminated, kept=kept, fronts=fronts)


def _halved(elements: Sequence[NDArray], centres: NDArray, unknowns: int) -> NDArray:
    """Number of the last group of every element."""
    number = np.ones(len(centres), dtype=int)
    unfinished = [np.arange(len(centres))]
    while unfinished:
        group = unfinished.pop()
        if group.size > SMALLEST:
            ranked = [group[np.argsort(side, kind="stable")] for side in centres[group].T]
            cuts = [_cheapest_cut([elements[e] for e in order], unknowns) for order in ranked]
            (_, at), order = min(zip(cuts, ranked, strict=True), key=lambda choice: choice[0])
            halves = order[:at], order[at:]
            for k, half in enumerate(halves):
                number[half] = 2 * number[half] + k
            unfinished.extend(halves)
    return number


def _cheapest_cut(elements: Sequence[NDArray], unknowns: int) -> tuple[float, int]:
    """Cost of the best cut through a row of elements, and its place.

    The cost is the number of unknowns on both sides, over the root of the smaller part's size: an even
    cut may share more.
    """
    count = len(elements)
    member = np.concatenate(elements)
    place = np.repeat(np.arange(count), [len(e) for e in elements])
    first, last = np.zeros(unknowns, dtype=int), np.zeros(unknowns, dtype=int)
    first[member[::-1]] = place[::-1]  # the assignment made last holds
    last[member] = place
    shared = np.cumsum(np.bincount(first, minlength=count) - np.bincount(last, minlength=count))
    least = max(1, round(count * UNEVEN))
    cuts = np.arange(least, count - least + 1)
    cost = shared[cuts - 1] / np.sqrt(np.minimum(cuts, count - cuts))
    best = int(cost.argmin())
    return float(cost[best]), int(cuts[best])


def _depth(number):
    """Generation of a group in the tree, 0 for the root; -1 for number 0."""
    return np.frexp(np.asarray(number, dtype=float))[1] - 1


def _assembled(pivots, entries, children, position):
    """The remaining unknowns of a front, its columns to eliminate, and what its children add to the others.

    Both matrices are stored by rows, and what would be above the diagonal is zero: for LAPACK, which reads
    by columns, they are upper triangles.
    """
    row, column, values = entries
    in_front = np.zeros(position.size, dtype=bool)
    for unknowns in (pivots, column, *(unknowns for unknowns, _ in children)):
        in_front[unknowns] = True
    front, size = np.flatnonzero(in_front), pivots.stop - pivots.start
    position[front] = np.arange(front.size)
    panel, update = np.zeros((front.size, size)), np.zeros((front.size - size,) * 2)
    panel[position[column], row] = values
    for unknowns, part in children:
        places = position[unknowns]
        count = np.searchsorted(places, size)
        _add(panel, places, places[:count], part[:, :count])
        _add(update, places[count:] - size, places[count:] - size, part[count:, count:])
    return front[size:], panel, update


def _add(matrix, rows, columns, part):
    """Add a part to rows and columns of a matrix, block by block; it is zero above its diagonal."""
    flat, width = matrix.reshape(-1), matrix.shape[1]
    for start in range(0, rows.size, BLOCK):
        stop = start + BLOCK
        places = rows[start:stop, None] * width + columns[:stop]
        flat[places] += part[start:stop, :stop]


def _reduced(remaining, panel, update, updates, owner):
    """Eliminate the first unknowns of a front; the group that goes next gets the update of the others."""
    size = panel.shape[1]
    try:
        triangle = cholesky(panel[:size].T, overwrite_a=True, check_finite=False)
    except LinAlgError as refusal:
        raise NotSolved(f"nothing holds the body, or its stiffness is not finite: {refusal}") from refusal
    coupling = solve_triangular(triangle, panel[size:].T, trans=1, overwrite_b=True, check_finite=False)
    if remaining.size:
        next_group = owner[remaining[0]] if remaining[0] < owner.size else 0
        update = dsyrk(-1.0, coupling, beta=1.0, c=update.T, trans=1, overwrite_c=True).T
        updates[next_group].append((remaining, update))
    return remaining, triangle, coupling
