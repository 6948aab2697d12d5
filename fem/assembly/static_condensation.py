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

from fem.errors import NotSolved

SMALLEST = 16  # elements in a group that is not halved any more; speed only
UNEVEN = 0.2  # least part of a group that is split off


@dataclass(frozen=True)
class Substructure:
    """Stiffness at the kept unknowns, and the way back to the eliminated ones."""

    schur: NDArray  # (kept, kept) symmetric
    size: int  # order of the whole matrix
    order: NDArray  # (unknowns,) in the order of elimination, kept ones last
    fronts: list[tuple[slice, NDArray, NDArray, NDArray]]  # eliminated, remaining, triangle, coupling

    def interior(self, kept: NDArray) -> NDArray:
        r"""All unknowns from the kept ones, no load on the eliminated ones.

        .. math:: u_i = -K_{ii}^{-1} K_{ik} u_k

        Parameters
        ----------
        kept : array (kept, columns)
            u_k in the order of `schur`

        Returns
        -------
        array (size, columns)
            zero for unknowns that were left out

        Source
        ------
        Static condensation, exact without inertia; order of elimination after Duff and Reid (1983), George
        (1973).
        """
        u = np.zeros((self.order.size, kept.shape[1]))
        u[self.order.size - len(kept) :] = kept
        for eliminated, remaining, triangle, coupling in reversed(self.fronts):
            u[eliminated] = -solve_triangular(triangle, coupling @ u[remaining], check_finite=False)
        displacement = np.zeros((self.size, kept.shape[1]))
        displacement[self.order] = u
        return displacement


def owners(elements: Sequence[NDArray], centres: NDArray, unknowns: int) -> NDArray:
    """The smallest group of elements that holds all elements of an unknown.

    Parameters
    ----------
    elements : sequence of arrays of int
        unknowns of every element
    centres : array (elements, 3)
        any point of every element
    unknowns : int
        number of unknowns

    Returns
    -------
    array (unknowns,) of int
        group number in a binary tree, children of g are 2 g and 2 g + 1, the root is 1; 0 for
        unknowns without elements
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


def eliminate(stiffness: sparse.coo_array | sparse.csr_array, owner: NDArray, kept: NDArray) -> Substructure:
    r"""Schur complement of a symmetric matrix at its kept unknowns.

    .. math:: S = K_{kk} - K_{ki} K_{ii}^{-1} K_{ik}

    Parameters
    ----------
    stiffness : sparse array (unknowns, unknowns)
        K, whole and symmetric; positive definite at the eliminated unknowns, whatever at the kept ones
    owner : array (unknowns,) of int
        from `owners`; 0 for the unknowns that are left out (held, or kept)
    kept : array (kept,) of int
        which unknowns stay, in this order

    Returns
    -------
    Substructure

    Raises
    ------
    NotSolved
        if nothing holds the body once the kept unknowns are held

    Source
    ------
    Static condensation, exact without inertia; order of elimination after Duff and Reid (1983), George
    (1973).
    """
    eliminated = np.flatnonzero(owner)
    eliminated = eliminated[
        np.argsort(-owner[eliminated], kind="stable")
    ]  # children have higher numbers than their parents
    order = np.concatenate([eliminated, kept])
    upper = _upper(sparse.coo_array(stiffness), order)
    groups, starts = np.unique(-owner[eliminated], return_index=True)
    stops = np.append(starts, eliminated.size)[1:]
    updates, fronts, position = defaultdict(list), [], np.zeros(order.size, dtype=int)
    for group, start, stop in zip(-groups, starts, stops, strict=True):
        front = _assembled(upper, slice(start, stop), updates.pop(group, []), position)
        fronts.append((slice(start, stop), *_reduced(*front, stop - start, updates, owner[eliminated])))
    schur = np.triu(upper[eliminated.size :, eliminated.size :].toarray())
    schur += np.triu(schur, 1).T
    for unknowns, part in updates.pop(0, []):
        schur[np.ix_(unknowns - eliminated.size, unknowns - eliminated.size)] += part
    return Substructure(schur=schur, size=owner.size, order=order, fronts=fronts)


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


def _upper(stiffness, order):
    """Upper triangle of a matrix whose unknowns stand in another order; those that are left out have none."""
    place = np.full(stiffness.shape[0], -1, dtype=stiffness.row.dtype)
    place[order] = np.arange(order.size)
    row, column = place[stiffness.row], place[stiffness.col]
    above = (row >= 0) & (row <= column)
    entries = stiffness.data[above], (row[above], column[above])
    return sparse.csr_array(entries, shape=(order.size, order.size))


def _assembled(upper, pivots, children, position):
    """Unknowns of a front, first those to eliminate, and its dense matrix; other rows are without K."""
    starts = upper.indptr[pivots.start : pivots.stop + 1]
    entries = slice(starts[0], starts[-1])
    in_front = np.zeros(position.size, dtype=bool)
    for unknowns in (pivots, upper.indices[entries], *(unknowns for unknowns, _ in children)):
        in_front[unknowns] = True
    front = np.flatnonzero(in_front)
    position[front] = np.arange(front.size)
    matrix = np.zeros((front.size, front.size))
    rows = np.repeat(np.arange(starts.size - 1), np.diff(starts))
    matrix[rows, position[upper.indices[entries]]] = upper.data[entries]
    for unknowns, part in children:
        matrix[np.ix_(position[unknowns], position[unknowns])] += part
    return front, matrix


def _reduced(front, matrix, size, updates, owner):
    """Eliminate the first unknowns of a front; the group that goes next gets the update of the others."""
    try:
        triangle = cholesky(matrix[:size, :size], check_finite=False)
    except LinAlgError as refusal:
        raise NotSolved(f"nothing holds the body, or its stiffness is not finite: {refusal}") from refusal
    coupling = solve_triangular(triangle, matrix[:size, size:], trans=1, check_finite=False)
    remaining = front[size:]
    if remaining.size:
        next_group = owner[remaining[0]] if remaining[0] < owner.size else 0
        updates[next_group].append((remaining, matrix[size:, size:] - coupling.T @ coupling))
    return remaining, triangle, coupling
