"""Friction of fast balls whose contacts stick and slip, at the motion of their balance."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.rigid_slip import ACROSS
from quasidynamic.contact.rolling.fastsim import FASTSIM
from quasidynamic.contact.rolling.full_sliding import FULL_SLIDING
from quasidynamic.contact.rolling.rolling_contact import RollingLaw
from quasidynamic.motion.ball_slip import AXIAL, ORBIT, TURN
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.solve.balls.refined_rolling import RefinedRolling


@dataclass(frozen=True)
class FastRollingBalls:
    """Friction of Z balls of an angular-contact bearing, which move as in their balance.

    Loads, contact angles and speeds are those of the balance, in full sliding or with FASTSIM: by how much
    the forces of friction differ from the ones there is not balanced, see `unbalanced_moment`,
    `unbalanced_force` and `unbalanced_section_force`.
    """

    state: AngularContactState
    rolled: tuple[RefinedRolling | None, ...]  # (Z) None for balls that do not touch both races

    @property
    def ring_speed(self) -> float:
        """Speed of the inner against the outer ring [rad/s]."""
        return self.state.operation.inner_speed - self.state.operation.outer_speed

    @property
    def ball_torques(self) -> NDArray:
        """Heat of each ball over the speed of the rings against each other (Z) [N m]."""
        return np.array([0.0 if ball is None else ball.torque for ball in self.rolled])

    @property
    def friction_heat(self) -> NDArray:
        """Heat of friction of both contacts (Z) [W]."""
        return abs(self.ring_speed) * self.ball_torques

    @property
    def friction_torque(self) -> float:
        """Torque of friction between the rings [N m]."""
        return float(self.ball_torques.sum())

    @property
    def grid_error(self) -> NDArray:
        """Error of the torque of each ball by its grid (Z) [N m], see `RefinedRolling.grid_error`."""
        return np.array([0.0 if ball is None else ball.grid_error for ball in self.rolled])

    @property
    def stick_share(self) -> NDArray:
        """Part of the cells of each contact that stick (2, Z) [-]."""
        none = np.zeros(2)
        return np.array([none if ball is None else ball.fine.rolled.stick_share for ball in self.rolled]).T

    @property
    def unbalanced_moment(self) -> NDArray:
        """Moment on each ball by which friction differs from that of the balance on the same cells (Z) [-].

        Over the moment that the largest friction forces, mu Q of both contacts, have about the ball centre.
        """
        radius = self.state.bearing.ball.diameter / 2
        return np.linalg.norm(self._changes[:, 0, AXIAL : TURN + 1], axis=1) / radius

    @property
    def unbalanced_force(self) -> NDArray:
        """Force along the orbit on each ball by which friction differs in the same way (Z) [-].

        Over the largest friction forces, mu Q of both contacts; positive where it pushes towards growing
        azimuth.
        """
        radius = np.sign(self.ring_speed) * self.state.bearing.pitch_diameter / 2
        return -(self._changes[:, 0, ORBIT] + self._changes[:, 0, AXIAL]) / radius

    @property
    def unbalanced_section_force(self) -> NDArray:
        """Size of the force in the section plane by which friction differs in the same way (Z) [-].

        Over the largest friction forces. A contact that spins pushes across where it sticks in part.
        """
        inner, outer = self._changes[:, 1, :2].T
        angles = self.state.contact_angles
        return np.abs(inner * np.exp(-1j * angles[0]) - outer * np.exp(-1j * angles[1]))

    @cached_property
    def _changes(self) -> NDArray:
        """Changes of the power of friction on the motion and of its forces across (Z, 2, 4)."""
        none = np.zeros((2, 4))
        law = FASTSIM if self.state.sticking else FULL_SLIDING
        return np.array([none if ball is None else _changed(ball, law) for ball in self.rolled])

    def field(self, ball: int, race: int) -> dict[str, NDArray]:
        """Fields of the cells of one contact (ny, nx), see `RollingMotion.cells`."""
        rolled = self.rolled[ball]
        assert rolled is not None  # of a ball that touches both races
        return rolled.fine.cells(race, self.ring_speed)


def _changed(rolled: RefinedRolling, law: RollingLaw) -> NDArray:
    """Power on a unit of each component of the motion [m], and force across of each contact (2, 4) [-].

    As much as friction differs from that by another law, over the largest friction forces.
    """
    motion, ball = rolled.fine.motion, rolled.fine.ball
    other = law.friction(ball.contacts, ball.creep(motion))
    power = ball.power_by_motion(motion, rolled.fine.rolled) - ball.power_by_motion(motion, other)
    by_slip = ball.power_by_slip(motion, rolled.fine.rolled) - ball.power_by_slip(motion, other)
    largest = (ball.contacts.limit.sum((1, 2)) * ball.contacts.cell_area).sum()
    return np.stack([power, np.pad(by_slip.sum(0)[:, ACROSS], (0, 2))]) / largest
