"""Slip in the contacts of balls that roll on two races."""

from dataclasses import dataclass
from typing import Literal

from numpy.typing import NDArray

from quasidynamic.motion.rolling_lines import (
    RollingLines,
    slip_velocity,
    spin_torque_factor,
    spin_torque_integral,
)


@dataclass(frozen=True)
class RollingContact:
    """Where balls roll without slip; index 0 the inner and 1 the outer race.

    Only balls that touch both, by contacts that are narrower than what they press, and slide on neither race.
    """

    balls: NDArray  # (B) numbers of these balls
    wide: NDArray  # numbers of balls with a contact as wide as the surface it presses
    sliding: NDArray  # numbers of balls whose friction moments do not balance in rolling, see `ball_friction`
    parameter: NDArray  # (2, B) E [-]
    net_force: NDArray  # (2, B) e, friction in the rolling direction over mu Q [-]
    lines: RollingLines  # (2, B)
    semi_axes: tuple[NDArray, NDArray]  # a, b (2, B) [m]
    loads: NDArray  # (2, B) [N]
    section_radius: NDArray  # (2, 1) R [m]
    rolling: NDArray  # (2, B) omega_roll of `slip_velocity` [rad/s]
    spin_to_roll: NDArray  # (2, B) S [-]

    def slip_velocity(self, position: NDArray) -> NDArray:
        """Slip (2, B, P) [m/s] at x/a (P), ball minus race; see `rolling_lines.slip_velocity`."""
        lines = RollingLines(*(value[..., None] for value in self.lines))
        per_contact = self.semi_axes[0], self.section_radius, self.rolling, self.spin_to_roll
        return slip_velocity(position, lines, *(value[..., None] for value in per_contact))

    def spin_torques(self, friction: float, method: Literal["lines", "integral"] = "integral") -> NDArray:
        """Friction torque about each contact normal (2, B) [N m] for a coefficient of friction."""
        across, along = self.semi_axes
        if method == "lines":
            factor = spin_torque_factor(self.lines)
        else:
            factor = spin_torque_integral(self.lines, along / across)
        return friction * self.loads * across * factor
