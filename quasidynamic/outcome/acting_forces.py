"""Every force that acts on rollers and cage at an equilibrium, so that balances can be summed up again."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.cage import FloatingCage
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.contact.line import Slices
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing


@dataclass(frozen=True)
class ActingForces:
    """Forces and torques of one state, as they act: inner raceway first, t along the motion to +azimuth."""

    rollers: RollerState  # of one case
    bearing: CylindricalRollerBearing
    slices: Slices
    floating: FloatingCage | None

    @cached_property
    def inlet_shear(self) -> NDArray:
        """Shear of the inlets (2, Z) on the roller along t [N]; the same acts on the raceway along t."""
        rolling = self.rollers.sense * self.rollers.contact.rolling.force
        return np.array([[-1.0], [1.0]]) * rolling[:, 0]

    @cached_property
    def inlet_pressure(self) -> NDArray:
        r"""Pressure of the inlets (2, Z) on the roller along t, through its centre [N].

        .. math:: P_i = 2 (1 - \gamma) F_{Ri},\quad P_o = -2 (1 + \gamma) F_{Ro}

        Source
        ------
        Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 1: F_n = 2 F_t on the equivalent cylinder.
        """
        ratio = self.bearing.diameter_ratio
        return -2 * np.array([[1 - ratio], [1 + ratio]]) * self.inlet_shear

    @property
    def load_moment(self) -> NDArray:
        """Moment of the loads of a roller about mid-roller (2, Z) [N m], positive: more load at +x."""
        if self.slices.axial_modes == 1:
            return np.zeros((2, self.bearing.rollers))
        return self.slices.length / 2 * self.rollers.contact.force[:, 1, 0]

    @property
    def drag(self) -> NDArray:
        """Force of the oil-air mixture on each roller along t (Z) [N]."""
        return np.full(self.bearing.rollers, -self.rollers.drag[0, 0])

    @property
    def centrifugal(self) -> NDArray:
        """Centrifugal force of each roller, outwards (Z) [N]."""
        return np.full(self.bearing.rollers, self.rollers.centrifugal[0, 0])

    @property
    def weight(self) -> NDArray:
        """Weight of the rollers (2, Z), outwards and along t [N]."""
        return self.rollers.weight[:, 0]

    @property
    def pocket_friction(self) -> NDArray:
        """Friction of the pockets on rollers (2, Z) [N]: outwards, and at the surface against the spin."""
        return np.array([self.rollers.pocket[1, 0], self.rollers.pocket_brake[0]])

    @property
    def churning(self) -> NDArray:
        """Torque of the mixture between roller and cage against the spin (Z) [N m]."""
        return self.rollers.churning[0]

    @property
    def land(self) -> NDArray | None:
        """Force of the land on a free cage (2), y and z [N]; None for one that is held."""
        return None if self.floating is None else self.floating.force[0]

    @property
    def cage_body(self) -> NDArray | None:
        """Weight of a free cage and force of its unbalance (2), y and z [N]; None for one that is held."""
        return None if self.floating is None else self.floating.body_force[0]

    @property
    def radii(self) -> NDArray:
        """Radii (3) of inner raceway, roller centres, outer raceway by which forces turn [m]."""
        bearing = self.bearing
        return np.array([bearing.inner_radius, bearing.pitch_diameter / 2, bearing.outer_radius])
