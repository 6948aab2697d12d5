"""Friction of fast balls whose contacts stick and slip, at the motion of their balance."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.rolling.full_sliding import full_sliding
from quasidynamic.motion.ball_slip import AXIAL, ORBIT
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.solve.balls.refined_rolling import RefinedRolling


@dataclass(frozen=True)
class FastRollingBalls:
    """Friction of Z balls of an angular-contact bearing, which move as in their balance without stick.

    Loads, contact angles and speeds are those of the balance: what stick changes in the forces of friction
    is not balanced, see `unbalanced_moment` and `unbalanced_force`.
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
        """Moment on each ball by which stick differs from full sliding with the same slip (Z) [-].

        Over the moment that the largest friction forces, mu Q of both contacts, have about the ball centre.
        """
        radius = self.state.bearing.ball.diameter / 2
        return self._over_largest(lambda change: float(np.linalg.norm(change[AXIAL:])) / radius)

    @property
    def unbalanced_force(self) -> NDArray:
        """Force along the orbit on each ball by which stick differs in the same way (Z) [-].

        Over the largest friction forces, mu Q of both contacts; positive where it pushes towards growing
        azimuth.
        """
        radius = np.sign(self.ring_speed) * self.state.bearing.pitch_diameter / 2
        return self._over_largest(lambda change: -float(change[ORBIT] + change[AXIAL]) / radius)

    def _over_largest(self, force: Callable[[NDArray], float]) -> NDArray:
        """A force (Z) by what stick changes in the power on the motion (4), over the largest friction."""
        return np.array([0.0 if ball is None else _over_largest(force, ball) for ball in self.rolled])

    def field(self, ball: int, race: int) -> dict[str, NDArray]:
        """Fields of the cells of one contact (ny, nx), see `RollingMotion.cells`."""
        rolled = self.rolled[ball]
        assert rolled is not None  # of a ball that touches both races
        return rolled.fine.cells(race, self.ring_speed)


def _over_largest(force: Callable[[NDArray], float], rolled: RefinedRolling) -> float:
    motion, ball = rolled.fine.motion, rolled.fine.ball
    sliding = full_sliding(ball.contacts, ball.creep(motion))
    change = ball.power_by_motion(motion, rolled.fine.rolled) - ball.power_by_motion(motion, sliding)
    return force(change) / float((ball.contacts.limit.sum((1, 2)) * ball.contacts.cell_area).sum())
