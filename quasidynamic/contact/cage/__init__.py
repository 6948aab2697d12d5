"""Forces between the cage and what touches it: pockets, the guiding land, the oil between them.

Where the cage goes under these forces is a balance.
"""

from quasidynamic.contact.cage.land import (
    couette_factor,
    land_drag,
    land_force,
    land_notes,
    land_offset,
    land_torque,
)
from quasidynamic.contact.cage.pocket import (
    ball_on_pocket_force,
    displacement_in_pocket,
    roller_on_pocket_force,
)

__all__ = [
    "ball_on_pocket_force",
    "couette_factor",
    "displacement_in_pocket",
    "land_drag",
    "land_force",
    "land_notes",
    "land_offset",
    "land_torque",
    "roller_on_pocket_force",
]
