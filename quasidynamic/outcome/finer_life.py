"""What the life would be with finer slices, and with more axial modes of the raceways."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import Slices
from quasidynamic.contact.raceways import Raceways
from quasidynamic.errors import NotSolved
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.outcome.life import basic_life
from quasidynamic.solve.outcome import SolverOutcome

Compliances = tuple[NDArray | None, NDArray | None]  # (Z, M', Z, M') [m/N] of inner and outer raceway
FINER = (2, 4)  # times as many slices: the life may pass its limit on the way
ERROR_OVER_CHANGE = 1.6  # calibrated: on rings of 1 to 15 mm, tilted up to 4 arcmin, three profiles
LOADED = 1e-6  # of the largest load: a contact below it does not count in the life
TOLERANCE = 1e-6  # of the load
LIMIT = 20


def life_error(state: Equilibrium, compliance: Compliances = (None, None)) -> float:
    r"""Estimate how far the life is from that of fine slices and many axial modes.

    .. math:: \epsilon = 1.6 \max_{n = 2, 4} |L_{10}(n K, M') / L_{10}(K, M) - 1|

    Parameters
    ----------
    state : Equilibrium
        solved with K slices and M axial modes; loads and moments of its rollers are kept
    compliance : pair of arrays (Z, M', Z, M') or None
        outward deviation of each raceway per outward force [m/N], of more modes than the state has;
        None where a raceway is rigid, or nothing is known of more modes

    Returns
    -------
    float
        error over the life [-]

    Raises
    ------
    NotSolved
        if no line loads were found that belong to the richer deviations

    Source
    ------
    Derived here. The factor is that of the levels of `accuracy.target`.

    Valid
    -----
    Loads and moments of rollers that hardly change with the resolution.
    """
    rich = [_finer_life(state, n * state.balance.roller.raceways.slices.count, compliance) for n in FINER]
    return ERROR_OVER_CHANGE * max(abs(life / state.life - 1) for life in rich)


def _finer_life(state: Equilibrium, slices: int, compliance: Compliances) -> float:
    sides = []
    for race, matrix in enumerate(compliance):
        finer = _FinerContacts.of(state, race, slices, matrix)
        loads = finer.line_loads()
        sides.append(finer.slices.unfolded(loads) * finer.slices.width)
    return float(basic_life(sides[0], sides[1], state.balance.roller.bearing, state.turning))


@dataclass(frozen=True, kw_only=True)
class _FinerContacts:
    """Contacts of all rollers with one raceway; M' axial modes, of which the state knows M."""

    slices: Slices
    drop: NDArray  # (K) [m]
    raceways: Raceways
    race: int
    approach: NDArray  # (Z, M') of the state, zero in the further modes [m]
    force: NDArray  # (Z, M) of the state [N]
    compliance: NDArray  # (Z, M', Z, M') [m/N]; zero for a rigid raceway

    @classmethod
    def of(cls, state: Equilibrium, race: int, count: int, matrix: NDArray | None) -> "_FinerContacts":
        balance = state.balance
        raceways, roller = balance.roller.raceways, balance.roller.bearing.roller
        known = np.moveaxis(balance.inputs(state.unknowns).approach[race, :, 0], 0, -1)
        rollers, modes = known.shape
        if matrix is None or matrix.shape[1] < modes:
            matrix = np.zeros((rollers, modes, rollers, modes))
        slices = Slices(count, roller.length, matrix.shape[1])
        approach = np.zeros((rollers, matrix.shape[1]))
        approach[:, :modes] = known
        return cls(
            slices=slices,
            drop=roller.profile.drop(slices.centres, roller.length),
            raceways=raceways,
            race=race,
            approach=approach,
            force=state.rollers.contact.force[race, :, 0].T,
            compliance=matrix,
        )

    def line_loads(self) -> NDArray:
        """Loads per length (Z, K) [N/m] under the load and moment of each roller in the state.

        Raises
        ------
        NotSolved
            if they were not found in `LIMIT` steps
        """
        loaded = self.force[:, 0] > LOADED * self.force[:, 0].max()
        approach = self.approach.copy()
        for _ in range(LIMIT):
            load, stiffness = self._contact(approach)
            residual, jacobian = self._equations(approach, load, stiffness)
            if np.abs(residual[loaded] / self._scale[loaded]).max(initial=0.0) < TOLERANCE:
                return load
            step = np.linalg.solve(jacobian[loaded], residual[loaded, :, None])[..., 0]
            approach[loaded] -= step
        raise NotSolved("life with more axial modes: no line loads were found", SolverOutcome.LIMIT)

    def _contact(self, approach: NDArray) -> tuple[NDArray, NDArray]:
        """Line loads (Z, K) [N/m] and their derivatives [N/m2]."""
        law = replace(self.raceways.law, coefficient=np.ravel(self.raceways.law.coefficient)[self.race])
        return law(approach @ self.slices.modes.T - self.drop)

    def _equations(self, approach: NDArray, load: NDArray, stiffness: NDArray) -> tuple[NDArray, NDArray]:
        """Residuals (Z, M'): load and moment as they were, further modes as the raceway deflects.

        The Jacobian (Z, M', M') leaves out what rollers do to their neighbours.
        """
        known, kept = self.force.shape[1], self._kept
        weights = self.slices.weights
        force = load @ weights
        tangent = np.einsum("zk,km,kn->zmn", stiffness, self.slices.modes, weights)
        before = np.zeros_like(approach)
        before[:, :known] = np.einsum("zmyn,yn->zm", self.compliance[:, :known, :, :known], self.force)
        deflection = np.einsum("zmyn,yn->zm", self.compliance, force) - before
        residual = approach - self.approach + deflection
        own = np.einsum("zmzn->zmn", self.compliance)
        jacobian = np.eye(approach.shape[1]) + own @ tangent
        residual[:, :kept] = force[:, :kept] - self.force[:, :kept]
        jacobian[:, :kept] = tangent[:, :kept]
        return residual, jacobian

    @property
    def _kept(self) -> int:
        """Modes whose force is that of the state: load and moment."""
        return min(2, self.force.shape[1])

    @cached_property
    def _scale(self) -> NDArray:
        """Size of the residuals (Z, M'): the load [N], and the approach of the roller [m]."""
        scale = np.repeat(np.abs(self.approach[:, :1]) + 1e-9, self.approach.shape[1], axis=1)
        scale[:, : self._kept] = self.force[:, :1]
        return scale
