"""What a user must know of the tooth forces on the rim of a planet gear."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from quasidynamic.note import Note, information, outside

UNBALANCED = 0.05  # of the load: more is no rounding of tooth forces (assumed)


def notes(outer: Any, pin: complex, key: str) -> Iterator[Note]:
    """Say so when tooth forces act where they should not, or leave the planet gear out of balance.

    The load of the pin [N] is along z + i y, given by a key.
    """
    if outer.kind != "ring" or outer.support != "planet":
        return
    if outer.tooth_radius is None and any(outer.tooth_tangential):
        yield information(
            "tooth-forces-at-rim",
            "tooth forces act on the outer surface of the rim, as no radius is given for them, without the "
            "couple by which tangential forces at the pitch circle bend it",
            {"outer.tooth_radius": ""},
        )
    forces = np.array(outer.tooth_radial) + 1j * np.array(outer.tooth_tangential)
    left = abs(pin + (forces * np.exp(1j * np.array(outer.tooth_azimuths))).sum())
    if left > UNBALANCED * abs(pin):
        yield outside(
            "unbalanced-teeth",
            f"tooth forces and the load of {abs(pin):,.0f} N leave {left:,.0f} N unbalanced: they must add "
            "up to zero, else the rim bends differently from that of a planet gear",
            dict.fromkeys(("outer.tooth_radial", "outer.tooth_tangential", key), ""),
        )


def notes_on_couple(outer: Any, pin: complex, outside_radius: float) -> Iterator[Note]:
    """Say so when axial tooth forces and the moment of a pin that tilts freely leave a couple.

    The moment [N m] is dz/dx + i dy/dx of the plane in which it tilts; without a pitch radius teeth press on
    the outer surface [m].
    """
    if outer.kind != "ring" or outer.support != "planet" or not outer.tooth_axial:
        return
    radius = outer.tooth_radius or outside_radius
    couple = radius * (np.array(outer.tooth_axial) * np.exp(1j * np.array(outer.tooth_azimuths))).sum()
    left = abs(pin - couple)
    if left > UNBALANCED * max(abs(couple), abs(pin)):
        yield outside(
            "unbalanced-teeth",
            f"axial tooth forces tilt the planet gear with {abs(couple):,.1f} N m and leave {left:,.1f} N m "
            "unbalanced: the moment of the pin must be equal and in the same plane",
            dict.fromkeys(("outer.tooth_axial", "operation.moment", "operation.tilt_direction"), ""),
        )
