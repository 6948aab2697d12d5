"""Factor once, solve many: the only place that calls solvers of NGSolve.

A direct solver returns numbers also for a body that nothing holds, so the true residual of every solve
is measured, on the full system and not on the condensed one.
"""

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import ngsolve as ngs
import numpy as np
from netgen.meshing import NgException  # pyright: ignore[reportAttributeAccessIssue]  # made at import
from numpy.typing import NDArray

from fem.errors import NotSolved

REFINABLE = 1e-4  # allowed change of u by a refinement: it restores digits, it does not repair
RESIDUAL = 1e-8  # allowed |f - K u| / |f|; a healthy direct solve stays below 1e-11

_log = logging.getLogger(__name__)


@contextmanager
def threads(number: int) -> Iterator[None]:
    """Run NGSolve on a stated number of threads; do not start processes inside."""
    ngs.SetNumThreads(number)
    with ngs.TaskManager():
        yield


@dataclass(frozen=True)
class Factorisation:
    """A factored stiffness K, ready to answer load vectors."""

    form: Any  # ngsolve.BilinearForm, symmetric, interior unknowns condensed
    inverse: Any  # of the condensed stiffness
    free: NDArray  # (unknowns,) bool, False where clamped

    @property
    def unknowns(self) -> int:
        """Number of equations, clamped and interior ones included."""
        return self.free.size

    def solve(self, load: NDArray) -> NDArray:
        """Displacement u [m] under a load vector f [N]; u is zero where clamped, and f has no effect there.

        Raises `NotSolved` if the answer is not as exact as `refined` demands.
        """
        return refined(self._direct, self._residual, np.where(self.free, load, 0.0))

    def _direct(self, load: NDArray) -> NDArray:
        """Answer of the factored, condensed system."""
        K, f = self.form, self._vector(load)
        u = (self.inverse @ (ngs.IdentityMatrix(f.size) + K.harmonic_extension_trans) * f).Evaluate()
        u.data += K.inner_solve * f
        u.data += K.harmonic_extension * u
        return u.FV().NumPy().copy()

    def _residual(self, displacement: NDArray, load: NDArray) -> NDArray:
        """Residual f - (I - H^T) (S + K_ii) (I - H) u on the free unknowns."""
        K, u = self.form, self._vector(displacement)
        w = (u - K.harmonic_extension * u).Evaluate()
        r = (K.mat * w + K.inner_matrix * w).Evaluate()
        r.data -= K.harmonic_extension_trans * r
        return np.where(self.free, load - r.FV().NumPy(), 0.0)

    def _vector(self, values: NDArray):
        vector = self.form.mat.CreateColVector()
        vector.FV().NumPy()[:] = values
        return vector


def factorised(space, energy) -> Factorisation:
    """Assemble and factor a symmetric, positive definite form (u, v) -> ngsolve.SumOfIntegrals.

    Raises `NotSolved` if the solver refuses the matrix.
    """
    u, v = space.TnT()
    form = ngs.BilinearForm(space, symmetric=True, condense=True, store_inner=True)
    form += energy(u, v)
    form.Assemble()
    inverse = cholesky(form.mat, space.FreeDofs(coupling=True))
    return Factorisation(form=form, inverse=inverse, free=np.array(list(space.FreeDofs())))


def cholesky(matrix, free, former=None):
    """Sparse factorisation of a symmetric, positive definite matrix; `free` is unset where it is clamped.

    A `former` one of the same matrix, whose numbers were others, is overwritten: its order of elimination
    stays.
    Raises `NotSolved` if the solver refuses the matrix.
    """
    try:
        if former is None:
            return matrix.Inverse(free, inverse="sparsecholesky")
        former.Update()
        return former
    except NgException as refusal:
        raise NotSolved(f"the stiffness could not be factored: {refusal}") from refusal


def refined(
    direct: Callable[[NDArray], NDArray], residual: Callable[[NDArray, NDArray], NDArray], loads: NDArray
) -> NDArray:
    r"""Solve K u = f directly, with one step of iterative refinement where its residual is too large.

    .. math:: r = f - K u, \quad u \leftarrow u + K^{-1} r

    Bodies of very different stiffness cost digits, which one step restores. A body far softer than its
    elements, such as a very thin ring, leaves a residual by rounding of K u alone: then the change of u by a
    second step, which estimates its error, must be as small.

    Displacements [m] and loads [N], zero where clamped, are (unknowns,) or (unknowns, L); `direct` applies
    the factored stiffness, `residual` (u, f) gives r on the unknowns that are free.
    Raises `NotSolved` if residual and change by a second step exceed `RESIDUAL` all the same, or if the first
    step changed u by more than `REFINABLE`.

    Source
    ------
    Higham, Accuracy and Stability of Numerical Algorithms (2002), ch. 12.
    """
    u = direct(loads)
    r = residual(u, loads)
    size = relative_size(r, loads)
    if size > RESIDUAL:
        correction = direct(r)
        u += correction
        r = residual(u, loads)
        left = min(relative_size(r, loads), relative_size(direct(r), u))
        size = max(left, RESIDUAL / REFINABLE * relative_size(correction, u))
    _log.debug("relative residual %.1e", size)
    if not size <= RESIDUAL:
        raise NotSolved(f"relative residual {size:.2g}, allowed {RESIDUAL:g}; is the body held everywhere?")
    return u


def relative_size(residual: NDArray, loads: NDArray) -> float:
    """Largest norm of a residual over that of its load, column by column; loads of zero count as one."""
    size = np.linalg.norm(loads, axis=0)
    return float(np.max(np.linalg.norm(residual, axis=0) / np.where(size > 0, size, 1.0)))
