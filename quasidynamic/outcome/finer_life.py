"""What the life would be with finer slices, and with more axial modes of the raceways."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import LoadLaw, Slices
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.life import basic_life

Compliances = tuple[NDArray | None, NDArray | None]  # (Z, M', Z, M') [m/N] of inner and outer raceway
FINER = (2, 4)  # times as many slices: the life may pass its limit on the way
ERROR_OVER_CHANGE = 1.6  # calibrated: on rings of 1 to 15 mm, tilted up to 4 arcmin, three profiles
LOADED = 1e-6  # of the largest load: a contact below it does not count in the life
TOLERANCE = 1e-6  # of the load
LIMIT = 20


def life_errors(states: BearingStates, compliance: Compliances = (None, None)) -> NDArray:
    r"""Estimate how far lives are from those of fine slices and many axial modes.

    .. math:: \epsilon = 1.6 \max_{n = 2, 4} |L_{10}(n K, M') / L_{10}(K, M) - 1|

    The C states are solved with K slices and M axial modes; loads and moments of rollers are kept. The
    compliance (Z, M', Z, M') is the outward deviation of each raceway per outward force [m/N], of more modes
    than the states have; None where a raceway is rigid, or nothing is known of more modes. Errors (C) over
    the lives [-] are not a number where no line loads were found that belong to the richer deviations.

    Source
    ------
    Derived here. The factor is that of the levels of `accuracy.target`.

    Valid
    -----
    Loads and moments of rollers that hardly change with the resolution.
    """
    count = states.balance.roller.raceways.slices.count
    with np.errstate(invalid="ignore"):  # a life that does not end has no error
        changes = [np.abs(_finer_lives(states, n * count, compliance) / states.life - 1) for n in FINER]
    return ERROR_OVER_CHANGE * np.maximum(*changes)


def _finer_lives(states: BearingStates, slices: int, compliance: Compliances) -> NDArray:
    finer = _FinerContacts.of(states, slices, compliance)
    loads = finer.slices.unfolded(np.moveaxis(finer.line_loads(), 0, -1))
    inner, outer = loads * np.reshape(finer.slices.width, (-1, 1, 1))
    return basic_life(inner, outer, states.balance.roller.bearing, states.turning)


@dataclass(frozen=True, kw_only=True)
class _FinerContacts:
    """Contacts of the rollers of C cases with both raceways; M' axial modes, of which the states know M."""

    slices: Slices
    drop: NDArray  # (K, 2, 1, 1), or (K, 2, C, 1) of rollers or raceways that differ [m]
    law: LoadLaw
    approach: NDArray  # (M', 2, C, Z) of the states, zero in the further modes [m]
    force: NDArray  # (M, 2, C, Z) of the states [N]
    compliance: NDArray | None  # (2, Z, M', Z, M') [m/N], zero for a rigid raceway; None for two of them

    @classmethod
    def of(cls, states: BearingStates, count: int, matrices: Compliances) -> "_FinerContacts":
        balance = states.balance
        raceways, roller = balance.roller.raceways, balance.roller.bearing.roller
        known = balance.approach(states.unknowns).swapaxes(0, 1)
        compliance = _together(matrices, len(known), known.shape[-1])
        modes = len(known) if compliance is None else compliance.shape[2]
        slices = Slices(count, roller.length, modes)
        approach = np.zeros((modes, *known.shape[1:]))
        approach[: len(known)] = known
        return cls(
            slices=slices,
            drop=slices.drop(balance.roller.bearing),
            law=raceways.law,
            approach=approach,
            force=states.rollers.contact.force.swapaxes(0, 1),
            compliance=compliance,
        )

    def line_loads(self) -> NDArray:
        """Loads per length (K, 2, C, Z) [N/m] under the load and moment of each roller in its state.

        Not a number where they are not found in `LIMIT` steps; the contacts of a case with a raceway stand
        still once theirs are found.
        """
        load = self.force[0]
        loaded = load > LOADED * load.max(axis=-1, keepdims=True)
        approach, found = self.approach.copy(), np.full((len(self.drop), *load.shape), np.nan)
        left = np.ones(load.shape[:2], bool)
        for _ in range(LIMIT):
            load, stiffness = self.law(self.slices.spread(approach) - self.drop)
            residual, jacobian = self._equations(approach, load, stiffness)
            size = np.abs(residual / self._scale).max(axis=0, initial=0.0, where=loaded).max(axis=-1)
            done = left & (size < TOLERANCE)
            found[:, done], left = load[:, done], left & ~done
            if not left.any():
                break
            moving = left[..., None] & loaded
            approach[:, moving] -= _solved(jacobian[moving], residual[:, moving].T).T
        return found

    def _equations(self, approach: NDArray, load: NDArray, stiffness: NDArray) -> tuple[NDArray, NDArray]:
        """Residuals (M', 2, C, Z): load and moment as they were, further modes as the raceway deflects.

        The Jacobian (2, C, Z, M', M') leaves out what rollers do to their neighbours.
        """
        kept = self._kept
        force, tangent = self.slices.summed(load), self.slices.paired(stiffness).transpose(2, 3, 4, 0, 1)
        residual, jacobian = approach - self._unloaded, np.zeros_like(tangent)
        jacobian[:] = np.eye(len(approach))
        if self.compliance is not None:
            residual += _deflection(self.compliance, force)
            jacobian += np.einsum("rzmzn->rzmn", self.compliance)[:, None] @ tangent
        residual[:kept], jacobian[..., :kept, :] = force[:kept] - self.force[:kept], tangent[..., :kept, :]
        return residual, jacobian

    @cached_property
    def _unloaded(self) -> NDArray:
        """Approaches (M', 2, C, Z) [m] without the deflections that the states know of."""
        if self.compliance is None:
            return self.approach
        unloaded, modes = self.approach.copy(), len(self.force)
        unloaded[:modes] += _deflection(self.compliance, self.force)[:modes]
        return unloaded

    @property
    def _kept(self) -> int:
        """Modes whose force is that of the state: load and moment."""
        return min(2, len(self.force))

    @cached_property
    def _scale(self) -> NDArray:
        """Size of the residuals (M', 2, C, Z): the load [N], and the approach of the roller [m]."""
        scale = np.repeat(np.abs(self.approach[:1]) + 1e-9, len(self.approach), axis=0)
        scale[: self._kept] = self.force[:1]
        return scale


def _together(matrices: Compliances, known: int, rollers: int) -> NDArray | None:
    """Compliances (2, Z, M', Z, M') [m/N] that have the `known` axial modes or more; None without any."""
    richer = {race: m for race, m in enumerate(matrices) if m is not None and m.shape[1] >= known}
    if not richer:
        return None
    modes = max(matrix.shape[1] for matrix in richer.values())
    compliance = np.zeros((2, rollers, modes, rollers, modes))
    for race, matrix in richer.items():
        own = matrix.shape[1]
        compliance[race, :, :own, :, :own] = matrix
    return compliance


def _deflection(compliance: NDArray, force: NDArray) -> NDArray:
    """Outward deviations (M', 2, C, Z) [m] under forces of the first modes (.., 2, C, Z) [N]."""
    return np.einsum("rzmyn,nrcy->mrcz", compliance[..., : len(force)], force)


def _solved(matrices: NDArray, right: NDArray) -> NDArray:
    """Unknowns (n, M) of systems (n, M, M), right-hand sides (n, M); not a number where one is singular."""
    try:
        return np.linalg.solve(matrices, right[..., None])[..., 0]
    except np.linalg.LinAlgError:
        if len(matrices) == 1:
            return np.full_like(right, np.nan)
        each = zip(matrices, right, strict=True)
        return np.concatenate([_solved(matrix[None], side[None]) for matrix, side in each])
