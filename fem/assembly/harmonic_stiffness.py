r"""A stiffness that is quadratic in the harmonic, :math:`K(n) = K_0 + n K_1 + n^2 K_2`, and its answers.

Displacements vary slowly with n. So the answers at a few harmonics span a small space which holds those
of all others; as the work of a load on its answer is stationary there, its relative error is about the
square of the residual.
"""

import logging
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from fem.assembly.factorisation import RESIDUAL, cholesky, refined, relative_size
from fem.errors import NotSolved

FIRST_STEP = 1.5  # ratio of the harmonics that are solved at first
SMALL_SPACE_RESIDUAL = 3e-3  # allowed |f - K u| / |f| of what the small space answers

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class HarmonicStiffness:
    """Stiffness for every harmonic, per radian."""

    matrix: Any  # ngsolve.BaseMatrix, whose pattern all three share
    parts: tuple[sparse.csr_array, ...]  # K_0, K_1, K_2 (unknowns, unknowns) [N/m]
    clamped: NDArray  # (unknowns,) of bool

    @property
    def unknowns(self) -> int:
        """Number of equations, clamped ones included."""
        return self.matrix.height

    def solve(self, harmonic: int, loads: NDArray) -> NDArray:
        """Displacements [m] under loads (unknowns, L) of one harmonic, per radian [N].

        They are zero where clamped; loads there have no effect.
        Raises `NotSolved` if the matrix cannot be factored, or if the residual stays above
        `fem.assembly.factorisation.RESIDUAL`.
        """
        return next(self.solved([harmonic], loads))

    def solved(self, harmonics: Iterable[int], loads: NDArray) -> Iterator[NDArray]:
        """Yield what `solve` returns for each of some harmonics, all factored in the order of the first.

        Raises `NotSolved` as it does.
        """
        matrix, pattern, inverse = self.matrix.CreateMatrix(), self.parts[0], None
        values, free = matrix.AsVector().FV().NumPy(), ngs.BitArray((~self.clamped).tolist())
        K = sparse.csr_array((values, pattern.indices, pattern.indptr), shape=pattern.shape)  # same memory

        def residual(u: NDArray, f: NDArray) -> NDArray:
            left = self.on_free(f - K @ u)
            if relative_size(left, f) <= RESIDUAL:
                return left
            # A thin free ring is far softer than its elements: K u in doubles loses what refinement restores.
            return self.on_free(f - K.astype(np.longdouble) @ u).astype(float)

        for harmonic in harmonics:
            values[:] = _at(harmonic, [part.data for part in self.parts])
            try:
                inverse = cholesky(matrix, free, inverse)
                yield refined(partial(_product, inverse), residual, self.on_free(loads))
            except NotSolved as problem:
                raise NotSolved(f"harmonic {harmonic}: {problem}") from problem

    def beginning_at(self, first: int) -> "HarmonicStiffness":
        """The same stiffness, its harmonics counted from another one, n = first at 0."""
        none, once, twice = (part.data for part in self.parts)
        pattern = self.parts[0]
        parts = (none + first * once + first**2 * twice, once + 2 * first * twice, twice)
        return replace(
            self,
            parts=tuple(
                sparse.csr_array((part, pattern.indices, pattern.indptr), shape=pattern.shape)
                for part in parts
            ),
        )

    def on_free(self, values: NDArray) -> NDArray:
        """Values (unknowns, L) with zeros on the clamped unknowns."""
        return np.where(self.clamped[:, None], 0.0, values)

    def orthonormal(self, values: NDArray) -> NDArray:
        """Orthonormal columns that span values (unknowns, L), zero where clamped."""
        on_free = np.linalg.qr(values[~self.clamped])[0]  # columns that repeat others become free directions
        basis = np.zeros((self.unknowns, on_free.shape[1]))
        basis[~self.clamped] = on_free
        return basis


def harmonic_stiffness(space, *forms) -> HarmonicStiffness:
    """Assemble a stiffness from its symmetric parts without n, with n, with n^2.

    Raises `NotSolved` if the parts do not couple the same unknowns.
    """
    matrices = [ngs.BilinearForm(form, symmetric=True).Assemble().mat for form in forms]
    parts = tuple(
        sparse.csr_array(tuple(np.array(column) for column in matrix.CSR()), shape=matrix.shape)
        for matrix in matrices
    )
    if not all(np.array_equal(part.indices, parts[0].indices) for part in parts):
        raise NotSolved("the parts of the stiffness have different patterns and cannot be added")
    return HarmonicStiffness(matrix=matrices[0], parts=parts, clamped=~np.array(list(space.FreeDofs())))


@dataclass(frozen=True)
class HarmonicAnswers:
    """Displacements under the same loads in every harmonic, in a small space that holds them all."""

    basis: NDArray  # (unknowns, B) orthonormal
    factors: NDArray  # (N + 1, B, L) [m/N] per load: the displacement of harmonic n is basis @ factors[n]


def answers(stiffness: HarmonicStiffness, loads: NDArray, last: int) -> HarmonicAnswers:
    """Displacements under loads (unknowns, L) [N/N], the same for all harmonics 0 .. `last`, at least 1.

    Residuals are `SMALL_SPACE_RESIDUAL` at most.
    Raises `NotSolved` if a solve fails.
    """
    G = stiffness.on_free(loads)
    solved: dict[int, NDArray] = {}
    first = np.geomspace(1, last, int(np.ceil(np.log(last) / np.log(FIRST_STEP))) + 1)
    unsolved = sorted({0, *np.rint(first).astype(int).tolist()})  # 0, 1, 2, 3, 5, 7, ... and the last
    while unsolved:
        solved |= zip(unsolved, stiffness.solved(unsolved, G), strict=True)
        basis = stiffness.orthonormal(np.hstack([u / np.linalg.norm(u, axis=0) for u in solved.values()]))
        forces = [stiffness.on_free(part @ basis) for part in stiffness.parts]
        small, g = [basis.T @ part for part in forces], basis.T @ G
        residuals = {}
        for n in _between(sorted(solved)):
            answer = np.linalg.solve(_at(n, small), g)
            residuals[n] = relative_size(G - _at(n, [part @ answer for part in forces]), G)
        _log.debug(
            "%d of %d harmonics solved, residual %.1e",
            len(solved), last + 1, max(residuals.values(), default=0),
        )  # fmt: skip
        unsolved = [n for n, size in residuals.items() if not size <= SMALL_SPACE_RESIDUAL]
    factors = np.array([np.linalg.solve(_at(n, small), g) for n in range(last + 1)])
    return HarmonicAnswers(basis, factors)


def compliances(stiffness: HarmonicStiffness, loads: NDArray, last: int) -> NDArray:
    """Work of loads on their answers, for all harmonics 0 .. N.

    .. math:: W_n = G^T K(n)^{-1} G

    An array (N + 1, L, L) [m/N], symmetric; the relative error is about the square of `SMALL_SPACE_RESIDUAL`.
    Arguments and errors are those of `answers`.

    Source
    ------
    Linear algebra: work of unit loads on the displacements they cause.
    """
    found = answers(stiffness, loads, last)
    return (stiffness.on_free(loads).T @ found.basis) @ found.factors


def near_compliances(known: HarmonicAnswers, stiffness: HarmonicStiffness, loads: NDArray) -> NDArray:
    """Work of loads on their answers where stiffness and loads differ little from those that were solved.

    .. math:: W_n = 2 G^T u_n - u_n^T K(n) u_n

    with the u_n of the solved ones: W is stationary there.

    An array (N + 1, L, L) [m/N], symmetric; the error grows with the square of the difference. The known
    answers are of as many loads and of a stiffness with the same unknowns.

    Source
    ------
    Principle of minimum potential energy.

    Valid
    -----
    For differences about what was solved.
    """
    small = [known.basis.T @ stiffness.on_free(part @ known.basis) for part in stiffness.parts]
    g, found = known.basis.T @ stiffness.on_free(loads), []
    for n, u in enumerate(known.factors):
        work = g.T @ u
        found.append(work + work.T - u.T @ _at(n, small) @ u)
    return np.array(found)


def _at(harmonic: int, parts):
    """Sum of the parts without n, with n, with n^2."""
    return parts[0] + harmonic * parts[1] + harmonic**2 * parts[2]


def _between(solved: list[int]) -> list[int]:
    """Harmonics half way between solved ones, where the small space is worst; none between neighbours."""
    middle = (int(np.rint(np.sqrt(a * b))) for a, b in pairwise(solved))
    return [n for n in middle if n not in solved]


def _product(inverse, loads: NDArray) -> NDArray:
    """An inverse of NGSolve times columns (unknowns, L)."""
    f, u = inverse.CreateColVector(), inverse.CreateRowVector()
    displacements = np.empty_like(loads)
    for k, load in enumerate(loads.T):
        f.FV().NumPy()[:] = load
        u.data = inverse * f
        displacements[:, k] = u.FV().NumPy()
    return displacements
