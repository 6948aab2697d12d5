"""Resistance of the oil-air mixture to rollers: drag of their orbit, churning of their spin.

Friction with cage, raceways and flanges is in the other rooms.
"""

from quasidynamic.contact.drag.churning import churning_torque
from quasidynamic.contact.drag.orbit_drag import drag_notes, mixture_density, orbit_drag_force

__all__ = ["churning_torque", "drag_notes", "mixture_density", "orbit_drag_force"]
