"""Corrections towards a branch."""

import numpy as np

from quasidynamic.solve.arclength import BranchDirection, LinearisedEquations, corrected


class Unmoved:
    """One equation that neither unknown nor parameter brings to zero where steps are taken."""

    weight = np.ones(1)

    def bounded(self, before, after):
        return after

    def orientation(self, state, parameter):
        return 1.0

    def at(self, state, parameter):
        return LinearisedEquations(
            residual=np.ones(1), by_parameter=np.zeros(1), solve=lambda right: 1.0 * right, converged=False
        )


def test_a_step_that_cannot_lead_across_ends_the_correction():
    across = BranchDirection(np.ones(1), 0.0)  # along the unknown, and the branch runs along it
    assert corrected(Unmoved(), np.zeros(1), 0.5, across) is None
