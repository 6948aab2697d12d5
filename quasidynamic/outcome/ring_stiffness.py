"""Tangent compliance and stiffness of the ring at an equilibrium."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z, Y, Z
from quasidynamic.solve.rollers import bordered_system

RING = (Y, Z, TILT_Z, TILT_Z + 1)  # the ring's places among the unknowns
TILTS = np.array([1.0, 1.0, -1.0, 1.0])  # y, z, tilts about y and z, over y, z, slopes dz/dx and dy/dx


@dataclass(frozen=True)
class Tangent:
    """Derivatives of equilibria, by implicit differentiation: nothing is solved again.

    Rollers, films, cage and elastic raceways follow. The ring is free to tilt here even where a
    guide holds it, so that the tilting rows mean something. Of many cases, or without their axis of one.
    """

    response: NDArray  # (..., 4, 4) y, z [m], slopes dz/dx, dy/dx [rad] per force on them [N, N m]
    direction: NDArray  # (..., 2) unit vector (y, z) of the radial load, or z when there is none
    held: NDArray  # (...) whether a guide holds the tilts of the real ring

    @classmethod
    def of(cls, balance: BearingBalance, change: NDArray, held: NDArray) -> "Tangent":
        """Tangents of C cases from `change_by_load` of a ring that is `free_to_tilt`, `held` (C) in truth."""
        return cls(change[:, :CAGE], _direction(balance.points), held)

    def __getitem__(self, case: int) -> "Tangent":
        return Tangent(self.response[case], self.direction[case], self.held[case])

    @property
    def compliance(self) -> NDArray:
        """Tangent compliance (..., 5, 5): x, y, z [m], tilts about y and z [rad] per N and N m.

        Infinite along x, which is left out: without thrust on ribs nothing resists there.
        """
        matrix = np.zeros((*self.held.shape, 5, 5))
        matrix[..., 0, 0] = np.inf
        matrix[..., 1:, 1:] = self.response * np.outer(TILTS, TILTS)
        return matrix

    @property
    def stiffness(self) -> NDArray:
        """Tangent stiffness (..., 5, 5), the inverse of `compliance`; zero along x."""
        matrix = np.zeros((*self.held.shape, 5, 5))
        matrix[..., 1:, 1:] = np.linalg.inv(self.response) * np.outer(TILTS, TILTS)
        return matrix

    @property
    def radial_stiffness(self) -> Any:
        """Load along the load direction per displacement there (...) [N/m]; the ring may move aside."""
        moved = np.einsum("...ij,...j->...i", self.response[..., :2, :], self._load)
        return 1.0 / np.einsum("...i,...i->...", self.direction, moved)

    @property
    def radial_matrix(self) -> NDArray:
        """Radial load per radial displacement (..., 2, 2), along y and z [N/m].

        The ring tilts as its loads require; where a guide holds its tilts, they stay.
        """
        follows = np.linalg.inv(self.response[..., :2, :2])
        stays = np.linalg.inv(self.response)[..., :2, :2]
        return np.where(np.asarray(self.held)[..., None, None], stays, follows)

    @property
    def _load(self) -> NDArray:
        """A newton of radial load, with the moments (..., 4) that hold the tilts if a guide does."""
        load = np.concatenate([self.direction, np.zeros(self.direction.shape)], axis=-1)
        tilts, held = self.response[self.held, TILT_Z:], self.direction[self.held]
        load[self.held, TILT_Z:] = -np.linalg.solve(
            tilts[..., TILT_Z:], tilts[..., :TILT_Z] @ held[..., None]
        )[..., 0]
        return load


def free_to_tilt(balance: BearingBalance) -> BearingBalance:
    """The same equations of rollers and a ring that can tilt; the same object where they can."""
    raceways, points = balance.roller.raceways, balance.points
    slices = raceways.slices.with_axial_modes(max(raceways.slices.axial_modes, 2))
    if slices is raceways.slices and points.free_tilt.all():
        return balance
    roller = balance.roller
    if slices is not raceways.slices:
        drop = slices.drop(roller.bearing)
        roller = replace(roller, raceways=replace(raceways, slices=slices, drop=drop))
    return replace(balance, roller=roller, points=replace(points, free_tilt=np.ones_like(points.free_tilt)))


@dataclass(frozen=True)
class LoadChange:
    """How one state changes under unit loads."""

    balance: BearingBalance
    system: Linearisation
    change: NDArray  # (1, N, 4), of `change_by_load`

    @cached_property
    def balanced(self) -> NDArray:
        """J X (1, N, 4) in SI, the unit loads but for rounding."""
        return _by_change(self.balance, self.system, self.change)


def change_by_load(balance: BearingBalance, system: Linearisation) -> NDArray:
    """Change of all unknowns (C, N, 4), in SI, per newton along y and z, per newton metre on dz/dx, dy/dx."""
    loads = np.zeros((*system.residual.shape, len(RING)))
    loads[:, RING, range(len(RING))] = -1.0 / balance.scales.residual[:, RING]
    return bordered_system.solve(balance, system, loads) * balance.scales.unknown[..., None]


def raceway_forces_by_load(balance: BearingBalance, system: Linearisation, change: NDArray) -> NDArray:
    """Forces of the rollers on elastic raceways (C, 4, E, Z, M) [N] that go with a `change_by_load`.

    E elastic raceways, in their order.
    """
    layout, (cases, _, loads) = balance.layout, change.shape
    first = layout.per_roller + layout.border  # row of the forces
    scaled = bordered_system.rows_by(balance, system, change / balance.scales.unknown[..., None])[first:]
    forces = scaled * balance.scales.row[first:, None, :, None]
    shape = (-1, layout.axial_modes, loads, cases, layout.rollers)
    return forces.reshape(shape).transpose(3, 2, 0, 4, 1)


def change_by_load_near(balance: BearingBalance, system: Linearisation, near: "LoadChange") -> NDArray:
    r"""`change_by_load` (C, N, 4) of cases near one, to first order: one elimination for all.

    .. math:: X \approx X_0 - J_0^{-1} (J - J_0) X_0

    Source
    ------
    J X = J_0 X_0, to first order; derived here.

    Valid
    -----
    Where J - J_0 is small and no contact has opened or closed between.
    """
    one = near.balance
    more = _by_change(balance, system, near.change) - near.balanced
    right = -more.transpose(1, 0, 2).reshape(1, more.shape[1], -1) / one.scales.residual[..., None]
    further = bordered_system.solve(one, near.system, right) * one.scales.unknown[..., None]
    return near.change + further[0].reshape(more.shape[1], len(more), -1).transpose(1, 0, 2)


def _by_change(balance: BearingBalance, system: Linearisation, change: NDArray) -> NDArray:
    """Change of the residuals (C, N, R) by a change of the unknowns (1, N, R), both in SI."""
    scaled = change / balance.scales.unknown[..., None]
    return bordered_system.product(balance, system, scaled) * balance.scales.residual[..., None]


def _direction(points: OperatingPoints) -> NDArray:
    """Unit vectors (C, 2), y and z, of the radial loads, or z where there is none."""
    load = np.concatenate([points.load_y, points.load_z], axis=1)
    return np.divide(load, points.load, out=np.tile([0.0, 1.0], (len(points), 1)), where=points.load > 0)
