"""Contacts that roll with friction, on grids of one shape."""

from collections.abc import Callable
from dataclasses import KW_ONLY, dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid, Convolution, ElasticPair, X, Y, Z, convolution
from quasidynamic.errors import ImpossiblePart

ALONG, ACROSS = 0, 1  # directions of slip and traction: x against the motion of the material, y across
MID_STEP = 1 / 6  # of a cell, ahead of its centre: where the rigid slip of a step is taken


@dataclass(frozen=True)
class RollingContacts:
    """C contacts through which material rolls from large to small x; tractions act on the first body."""

    grids: tuple[CellGrid, ...]
    pairs: tuple[ElasticPair, ...]
    limit: NDArray  # (C, nx, ny) [Pa] friction coefficient times pressure, zero outside the contacts
    _: KW_ONLY
    pressure: NDArray | None = None  # (C, nx, ny) [Pa] needed only where it shears unequal bodies
    compliance: NDArray | None = None  # (C, nx, ny) [m/Pa] of a layer between the bodies along their surfaces

    def __post_init__(self):
        shapes = {grid.shape for grid in self.grids}
        if not len(self.grids) == len(self.pairs) == len(self.limit) or shapes != {self.limit.shape[1:]}:
            raise ImpossiblePart(
                f"rolling contacts: {len(self.grids)} grids of shapes {sorted(shapes)} and {len(self.pairs)} "
                f"elastic pairs do not fit to limits of shape {self.limit.shape}"
            )
        for name in ("limit", "pressure", "compliance"):
            values = getattr(self, name)
            if values is not None and not np.all((values >= 0.0) & np.isfinite(values)):
                raise ImpossiblePart(f"rolling contacts: {name} must be finite and >= 0 everywhere")
        if self.pressure is None and any(pair.coupling for pair in self.pairs):
            raise ImpossiblePart(
                "rolling contacts: bodies of unequal materials shear under pressure: `pressure` is needed"
            )

    @cached_property
    def step(self) -> NDArray:
        """Side of a cell along x, by which material moves in a step (C) [m]."""
        return np.array([grid.spacing[0] for grid in self.grids])

    @cached_property
    def cell_area(self) -> NDArray:
        """Area of a cell (C) [m2]."""
        return np.array([grid.cell_area for grid in self.grids])

    @cached_property
    def step_displacements(self) -> tuple[Convolution, ...]:
        """Displacements along the surfaces in steady rolling, by which they grow over a step."""
        return tuple(
            convolution(pair, grid, (X, Y), (X, Y)) - convolution(pair, grid, (X, Y), (X, Y), (step, 0.0))
            for pair, grid, step in zip(self.pairs, self.grids, self.step, strict=True)
        )

    @cached_property
    def pressed_slip(self) -> NDArray:
        """Slip of a step that pressure makes on bodies of unequal materials (C, 2, nx, ny) [m]."""
        slip = np.zeros((len(self.grids), 2, *self.limit.shape[1:]))
        for number, (pair, grid, step) in enumerate(zip(self.pairs, self.grids, self.step, strict=True)):
            if self.pressure is not None and pair.coupling:
                here = convolution(pair, grid, (X, Y), (Z,))
                ahead = convolution(pair, grid, (X, Y), (Z,), (step, 0.0))
                slip[number] = (here - ahead)(self.pressure[number, None])
        return slip

    def with_interface(self, compliance: float) -> "RollingContacts":
        """Same contacts, with an interface between the bodies that shears as much at every limit.

        `compliance` [m] is its elastic displacement where the traction reaches mu p_n, and proportional to
        the traction below it; zero: no interface.
        """
        if not compliance:
            return self
        touching = self.limit > 0.0
        layer = np.where(touching, compliance / np.where(touching, self.limit, 1.0), 0.0)
        return replace(self, compliance=layer)

    def places(self, ahead: float = 0.0) -> tuple[NDArray, NDArray]:
        """Places x (C, nx, 1) and y (C, 1, ny) [m] of the cells, a part of a cell ahead of their centres."""
        centres = [grid.centres for grid in self.grids]
        x, y = (np.stack(values) for values in zip(*centres, strict=True))
        return x + ahead * self.step[:, None, None], y


@dataclass(frozen=True)
class Rolled:
    """Friction of rolling contacts."""

    contacts: RollingContacts
    creep: NDArray  # (C, 2, nx, ny) [-] rigid slip over rolling speed, first body against second
    traction: NDArray  # (C, 2, nx, ny) [Pa] on the first body
    slip: NDArray  # (C, 2, nx, ny) [-] slip over rolling speed, elastic displacements included
    stick: NDArray  # (C, nx, ny) where the surfaces do not slip

    @property
    def force(self) -> NDArray:
        """Force on the first body (C, 2) [N]."""
        return self.traction.sum((-2, -1)) * self.contacts.cell_area[:, None]

    @property
    def moment(self) -> NDArray:
        """Moment about the normal on the first body, from x to y (C) [N m]."""
        x, y = self.contacts.places()
        turning = x * self.traction[:, ACROSS] - y * self.traction[:, ALONG]
        return turning.sum((-2, -1)) * self.contacts.cell_area

    @property
    def stick_share(self) -> NDArray:
        """Part of the cells in contact that stick (C) [-]."""
        touching = self.contacts.limit > 0.0
        return (self.stick & touching).sum((1, 2)) / np.maximum(touching.sum((1, 2)), 1)


class RollingLaw(NamedTuple):
    """Friction of rolling contacts, and how it changes: two functions that every law has.

    `friction(contacts, creep, start)` gives a `Rolled`:

    - contacts : RollingContacts, grids, elastic constants, mu p_n [Pa]
    - creep : array (C, 2, nx, ny), W, rigid slip of the first body against the second over the
      rolling speed [-]
    - start : array (C, 2, nx, ny), optional, tractions of a neighbouring state [Pa], where a law iterates

    `changes(rolled, creep_changes)` gives the changes of the tractions (C, k, 2, nx, ny) [Pa]:

    - rolled : Rolled, of the same law
    - creep_changes : array (C, k, 2, nx, ny) [-]
    """

    friction: Callable[..., Rolled]
    changes: Callable[[Rolled, NDArray], NDArray]
