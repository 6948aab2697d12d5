"""Every force that acts on rollers and cage at equilibria, so that balances can be summed up again."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.floating_cage import FloatingCage
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.contact.line import Slices
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

ALONG_MOTION = np.array([[-1.0], [1.0]])  # of the shear at the inner and the outer inlet


@dataclass(frozen=True)
class ActingForces:
    """Forces and torques in C states, as they act: inner raceway first, t along the motion to +azimuth."""

    rollers: RollerState
    bearing: CylindricalRollerBearing
    slices: Slices
    floating: FloatingCage | None

    @property
    def inlet_shear(self) -> NDArray:
        """Shear of the inlets (C, 2, Z) on the roller along t [N]; the same acts on the raceway along t."""
        return ALONG_MOTION * (self.rollers.sense * self.rollers.contact.rolling.force).swapaxes(0, 1)

    @property
    def inlet_pressure(self) -> NDArray:
        r"""Pressure of the inlets (C, 2, Z) on the roller along t, through its centre [N].

        .. math:: P_i = 2 (1 - \gamma) F_{Ri},\quad P_o = -2 (1 + \gamma) F_{Ro}

        Source
        ------
        Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 1: F_n = 2 F_t on the equivalent cylinder.
        """
        ratio = np.reshape(self.bearing.diameter_ratio, (-1, 1, 1))
        return -2 * np.concatenate([1 - ratio, 1 + ratio], axis=1) * self.inlet_shear

    @property
    def load_moment(self) -> NDArray:
        """Moment of the loads of a roller about mid-roller (C, 2, Z) [N m], positive: more load at +x."""
        if self.slices.axial_modes == 1:
            return np.zeros_like(self.inlet_shear)
        return (self.slices.length / 2 * self.rollers.contact.force[:, 1]).swapaxes(0, 1)

    @property
    def drag(self) -> NDArray:
        """Force of the oil-air mixture on each roller along t (C, Z) [N]."""
        return self._of_rollers(-self.rollers.drag)

    @property
    def centrifugal(self) -> NDArray:
        """Centrifugal force of each roller, outwards (C, Z) [N]."""
        return self._of_rollers(self.rollers.centrifugal)

    @property
    def weight(self) -> NDArray:
        """Weight of the rollers (C, 2, Z), outwards and along t [N]."""
        return np.stack([self._of_rollers(part) for part in self.rollers.weight], axis=1)

    @property
    def pocket_friction(self) -> NDArray:
        """Friction of the pockets on rollers (C, 2, Z) [N]: outwards, and at the surface against the spin."""
        return np.stack([self.rollers.pocket[1], self.rollers.pocket_brake], axis=1)

    @property
    def churning(self) -> NDArray:
        """Torque of the mixture between roller and cage against the spin (C, Z) [N m]."""
        return self._of_rollers(self.rollers.churning)

    @property
    def land(self) -> NDArray | None:
        """Force of the land on a free cage (C, 2), y and z [N]; None for one that is held."""
        return None if self.floating is None else self.floating.force

    @property
    def cage_body(self) -> NDArray | None:
        """Weight of a free cage and force of its unbalance (C, 2), y and z [N]; None for one that is held."""
        return None if self.floating is None else self.floating.body_force

    @property
    def radii(self) -> NDArray:
        """Radii (C, 3) of inner raceway, roller centres, outer raceway by which forces turn [m]."""
        each = (self.bearing.inner_radius, self.bearing.pitch_diameter / 2, self.bearing.outer_radius)
        cases = len(self.rollers.drag)
        return np.stack([np.broadcast_to(np.ravel(radius), cases) for radius in each], axis=1)

    def _of_rollers(self, values: NDArray) -> NDArray:
        """Values (C, Z), also of what all rollers of a case have alike (C, 1)."""
        return np.broadcast_to(values, self.rollers.pocket[0].shape)


@dataclass(frozen=True, kw_only=True)
class Losses:
    """Power turned into heat, by cause [W]: floats of one case, arrays (C) of many."""

    sliding: Any  # of the raceways on the rollers
    rolling: Any  # shear of the inlets
    drag: Any  # of the mixture on the orbiting rollers
    pocket: Any  # friction of the rollers in the pockets
    land: Any  # of the cage on its guide
    churning: Any  # of the mixture between the spinning rollers and the cage
    ribs: Any  # of the ends of the rollers on ribs
    transport: Any  # of spin from azimuth to azimuth: not heat but discretisation residual

    @property
    def total(self) -> Any:
        """All of it [W], equal to the power that the rings put in."""
        return sum(getattr(self, field.name) for field in fields(self))

    def __getitem__(self, case: int) -> "Losses":
        return Losses(**{field.name: float(getattr(self, field.name)[case]) for field in fields(self)})
