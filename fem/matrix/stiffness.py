"""A symmetric stiffness matrix by nodes and their motions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse.linalg import SuperLU, splu

from fem.parts.material import ImpossiblePart

UNEQUAL = 1e-6  # of the largest number: rounding of files, by which an entry and its mirror may differ
LOOSE = 1e-13  # of the diagonal: pivots below it are of unknowns that move without force
MOTIONS = 3  # along x, y, z, numbered from 1; 4 to 6 turn


@dataclass(frozen=True, eq=False)
class Stiffness:
    """Forces by displacements, in the units of its file."""

    nodes: NDArray  # (n) of int, the node of every unknown
    motions: NDArray  # (n) of int, 1 to 6
    matrix: sparse.csc_array  # (n, n) symmetric

    def at(self, nodes: Sequence[int]) -> NDArray:
        """Stiffness felt at some nodes, nothing pressing on the others.

        .. math:: S = K_{kk} - K_{ki} K_{ii}^{-1} K_{ik}

        The K nodes displace along x, y and z: S (3 K, 3 K) is symmetric, node by node.
        Raises `ImpossiblePart` if a node has not all three motions, or the others can move without force or
        push where they should pull.

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
            held = self.matrix[others][:, others].tocsc()
            S = S - coupling.T @ _definite(held).solve(coupling.toarray())
        if not np.isfinite(S).all():
            raise ImpossiblePart("nodes away from the seat can move without force")
        return (S + S.T) / 2

    def held_nodes(self) -> int:
        """Number of nodes that a translation of everything loads: they are held, or next to what is."""
        along = self.motions[:, None] == np.arange(1, MOTIONS + 1)
        forces, sizes = abs(self.matrix @ along), abs(self.matrix) @ along.any(axis=1)
        return len(np.unique(self.nodes[(forces > UNEQUAL * sizes[:, None]).any(axis=1)]))


def extremes(S: NDArray) -> tuple[float, float]:
    """Smallest and largest eigenvalue of a symmetric stiffness that resists every displacement, in its units.

    The smallest may be below zero by what numbers of a file are rounded.
    Raises `ImpossiblePart` if it is indefinite beyond that: a body would deflect against its load.
    """
    eigenvalues = np.linalg.eigvalsh(S)
    smallest, largest = float(eigenvalues[0]), float(eigenvalues[-1])
    if smallest < -UNEQUAL * abs(largest) or largest <= 0:
        raise ImpossiblePart(
            f"the stiffness of the seat is indefinite: its eigenvalues reach from {smallest:.4g} to "
            f"{largest:.4g} in the units of its file, that of a body has none below zero; are signs of "
            "entries wrong, or some missing?"
        )
    return smallest, largest


def _definite(matrix: sparse.csc_array) -> SuperLU:
    """Factors of a matrix whose eigenvalues are above zero.

    With pivots on the diagonal the factors are L D L^T, and D has as many numbers below zero as the matrix
    has eigenvalues (Sylvester's law of inertia).
    """
    diagonal = matrix.diagonal()
    loose = ImpossiblePart("nodes away from the seat can move without force")
    if (diagonal == 0).any():
        raise loose
    try:
        factors = splu(
            matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )
    except RuntimeError as problem:  # exactly singular
        raise loose from problem
    pivots = factors.U.diagonal()[factors.perm_c]
    if below := int((pivots < -UNEQUAL * abs(diagonal)).sum()):
        raise ImpossiblePart(
            f"the stiffness of the nodes away from the seat is indefinite: {below} of its {len(pivots)} "
            f"eigenvalues are below zero, its diagonal reaches from {diagonal.min():.4g} to "
            f"{diagonal.max():.4g}; that of a body has none below zero; are signs of entries wrong?"
        )
    if (pivots < LOOSE * abs(diagonal)).any():
        raise loose
    return factors


def symmetric(
    nodes: NDArray, motions: NDArray, rows: NDArray, columns: NDArray, values: NDArray
) -> Stiffness:
    """Stiffness of entries that are in the file once, in either triangle, or twice alike.

    Nodes and motions are those of the n unknowns, rows and columns the places of the entries, from 0.
    Raises `ImpossiblePart` if an entry and its mirror differ, or the matrix is no finite one.
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
