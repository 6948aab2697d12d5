"""A symmetric stiffness matrix by nodes and their motions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import splu

from fem.parts.material import ImpossiblePart

UNEQUAL = 1e-6  # of the largest number: by what an entry and its mirror may differ
MOTIONS = 3  # along x, y, z, numbered from 1; 4 to 6 turn


@dataclass(frozen=True, eq=False)
class Stiffness:
    """Forces by displacements, in the units of its file."""

    nodes: NDArray  # (n) of int, the node of every unknown
    motions: NDArray  # (n) of int, 1 to 6
    matrix: sparse.csc_array  # (n, n) symmetric

    def at(self, nodes: Sequence[int]) -> NDArray:
        r"""Stiffness felt at some nodes, nothing pressing on the others.

        .. math:: S = K_{kk} - K_{ki} K_{ii}^{-1} K_{ik}

        Parameters
        ----------
        nodes : sequence of int (K)
            which displace along x, y and z

        Returns
        -------
        array (3 K, 3 K)
            symmetric, node by node

        Raises
        ------
        ImpossiblePart
            if a node has not all three motions, or the others can move without force

        Source
        ------
        Guyan, AIAA J. 3 (1965) 380: static condensation.
        """
        place = {
            pair: k for k, pair in enumerate(zip(self.nodes.tolist(), self.motions.tolist(), strict=True))
        }
        wanted = [(int(node), motion) for node in nodes for motion in range(1, MOTIONS + 1)]
        if missing := [pair for pair in wanted if pair not in place]:
            node, motion = missing[0]
            raise ImpossiblePart(
                f"node {node} on the seat has no unknown {motion} in the matrix; "
                "a seat must be free along x, y, z"
            )
        kept = np.array([place[pair] for pair in wanted])
        others = np.setdiff1d(np.arange(len(self.nodes)), kept)
        S = self.matrix[kept][:, kept].toarray()
        if others.size:
            coupling = self.matrix[others][:, kept].tocsc()
            try:
                solved = splu(self.matrix[others][:, others].tocsc()).solve(coupling.toarray())
            except RuntimeError as problem:
                raise ImpossiblePart(
                    f"nodes away from the seat can move without force: {problem}"
                ) from problem
            S = S - coupling.T @ solved
        if not np.isfinite(S).all():
            raise ImpossiblePart("nodes away from the seat can move without force")
        return (S + S.T) / 2


def symmetric(
    nodes: NDArray, motions: NDArray, rows: NDArray, columns: NDArray, values: NDArray
) -> Stiffness:
    """Stiffness of entries that stand in the file once, in either triangle, or twice alike.

    Parameters
    ----------
    nodes, motions : array (n) of int
        of the unknowns
    rows, columns : array (e) of int
        places of the entries, from 0
    values : array (e)
        of the entries

    Returns
    -------
    Stiffness

    Raises
    ------
    ImpossiblePart
        if an entry and its mirror differ, or the matrix is no finite one
    """
    count = len(nodes)
    if not values.size or not np.isfinite(values).all():
        raise ImpossiblePart("the stiffness matrix holds no numbers, or some that are not finite")
    low, high = np.minimum(rows, columns).astype(np.int64), np.maximum(rows, columns).astype(np.int64)
    pairs, first, where = np.unique(low * count + high, return_index=True, return_inverse=True)
    once = values[first]
    if np.abs(values - once[where]).max() > UNEQUAL * np.abs(values).max():
        raise ImpossiblePart("the stiffness matrix is not symmetric")
    i, j = pairs // count, pairs % count
    upper = sparse.csc_array((once, (i, j)), shape=(count, count))
    mirrored = sparse.csc_array((once[i != j], (j[i != j], i[i != j])), shape=(count, count))
    return Stiffness(nodes, motions, sparse.csc_array(upper + mirrored))
