"""Factorisation once, solve many: the only place that calls solvers of NGSolve.

A direct solver hands back numbers also for a body that floats, so the true residual of every solve
is measured, on the full system and not on the condensed one.
"""

import logging
from collections.abc import Iterator
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
        """Displacement under a load vector.

        Parameters
        ----------
        load : array (unknowns,)
            f [N], work-conjugate to the unknowns; entries on clamped unknowns have no effect

        Returns
        -------
        array (unknowns,)
            u [m] for a stiffness in N/m, zero where clamped

        Raises
        ------
        NotSolved
            if the residual of K u = f exceeds `RESIDUAL`
        """
        f = self.form.mat.CreateColVector()
        f.FV().NumPy()[:] = np.where(self.free, load, 0.0)
        u = self._direct(f)
        left, size = self._residual(u, f)
        if size > RESIDUAL:
            # Bodies of very different stiffness cost digits, which one refinement brings back.
            correction = self._direct(left)
            u.data += correction
            size = max(self._residual(u, f)[1], RESIDUAL * correction.Norm() / (REFINABLE * u.Norm()))
        _log.debug("relative residual %.1e", size)
        if not size <= RESIDUAL:
            raise NotSolved(
                f"relative residual {size:.2g}, allowed {RESIDUAL:g}; is the body held everywhere?"
            )
        return u.FV().NumPy().copy()

    def _direct(self, f):
        """Answer of the factored, condensed system."""
        K = self.form
        u = (self.inverse @ (ngs.IdentityMatrix(f.size) + K.harmonic_extension_trans) * f).Evaluate()
        u.data += K.inner_solve * f
        u.data += K.harmonic_extension * u
        return u

    def _residual(self, u, f):
        """Residual f - (I - H^T) (S + K_ii) (I - H) u on the free unknowns; its size over that of f."""
        K = self.form
        w = (u - K.harmonic_extension * u).Evaluate()
        r = (K.mat * w + K.inner_matrix * w).Evaluate()
        r.data -= K.harmonic_extension_trans * r
        left = (f - r).Evaluate()  # a vector of its own: r.data = f - r would overwrite r first
        left.FV().NumPy()[~self.free] = 0.0
        return left, left.Norm() / (f.Norm() or 1.0)


def factorised(space, energy) -> Factorisation:
    """Assemble and factor a symmetric, positive definite form.

    Parameters
    ----------
    space : ngsolve.FESpace
        with its clamped boundaries
    energy : callable (u, v) -> ngsolve.SumOfIntegrals
        the weak form

    Returns
    -------
    Factorisation

    Raises
    ------
    NotSolved
        if the solver refuses the matrix
    """
    u, v = space.TnT()
    form = ngs.BilinearForm(space, symmetric=True, condense=True, store_inner=True)
    form += energy(u, v)
    form.Assemble()
    free = np.array(list(space.FreeDofs()))
    try:
        inverse = form.mat.Inverse(space.FreeDofs(coupling=True), inverse="sparsecholesky")
    except NgException as refusal:
        raise NotSolved(f"the stiffness could not be factored: {refusal}") from refusal
    return Factorisation(form=form, inverse=inverse, free=free)
