"""Resistance of the oil-air mixture to rollers and balls: drag of their orbit, churning of their spin.

Friction with cage, raceways and flanges is in the other rooms.
"""

from quasidynamic.contact.drag.churning import ball_churning, churning_torque
from quasidynamic.contact.drag.orbit_drag import (
    ball_drag_force,
    drag_notes,
    mixture_density,
    orbit_drag_force,
)

__all__ = [
    "ball_churning",
    "ball_drag_force",
    "churning_torque",
    "drag_notes",
    "mixture_density",
    "orbit_drag_force",
]
