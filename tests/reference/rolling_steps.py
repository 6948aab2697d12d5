"""Rolling from a given state, step by step, whose steady end `kalker` gives at once."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import (
    CellGrid,
    Convolution,
    ElasticPair,
    X,
    Y,
    convolution,
    influence_number,
)
from quasidynamic.contact.rolling.stick_slip import StickSlip, StickSlipLaw, stick_slip


@dataclass(frozen=True)
class RollingSteps:
    """One contact whose material moves by a number of whole cells in every step."""

    grid: CellGrid
    pair: ElasticPair
    cells: int = 1  # by which material moves in a step; zero: the bodies only shift against each other

    @cached_property
    def _now(self) -> Convolution:
        return convolution(self.pair, self.grid, (X, Y), (X, Y))

    @cached_property
    def _before(self) -> Convolution:
        shift = self.cells * self.grid.spacing[0]
        return convolution(self.pair, self.grid, (X, Y), (X, Y), (shift, 0.0))

    @cached_property
    def _stiffness(self) -> float:
        """Stiffness of a cell alone, the mean of both directions [Pa/m]."""
        numbers = [influence_number(self.pair, i, i, (0.0, 0.0), self.grid.spacing) for i in (X, Y)]
        return 1 / float(np.mean(numbers))

    def after(self, traction: NDArray, shift: NDArray, limit: NDArray) -> StickSlip:
        r"""Tractions one step later.

        .. math:: S = D + u(x) - u'(x + \Delta),\quad u = A p,\quad u' = A p'

        with Coulomb's law for S and p, see `at_traction`; p' before, p after the step.

        Parameters
        ----------
        traction : array (2, nx, ny)
            p' [Pa]; zero for bodies that only begin to touch
        shift : array (2, nx, ny)
            D, rigid slip of the step, first body against second [m]
        limit : array (nx, ny)
            friction coefficient times pressure after the step [Pa]

        Returns
        -------
        StickSlip

        Raises
        ------
        NotSolved
            when Newton's method finds no solution

        Source
        ------
        Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), sec. 4.1.
        """
        offset = shift - self._before(traction)
        return stick_slip(StickSlipLaw(self._now, offset, limit, self._stiffness), traction)
