"""Flexible rings as finite elements; `fem.solid.condensation.condense` is the way in.

Only the parts are re-exported here: describing a ring costs nothing, NGSolve is loaded by the
modules that compute.
"""

from fem.parts.boundary_conditions import (
    ClampedFace,
    Foundation,
    Housing,
    LineForce,
    LineSupports,
    PlanetGear,
    RigidSeat,
)
from fem.parts.rings import (
    Elastic,
    ImpossiblePart,
    MeshSize,
    OuterRing,
    Part,
    Patches,
    RingOnShaft,
    SquirrelCage,
)

__all__ = [
    "ClampedFace",
    "Elastic",
    "Foundation",
    "Housing",
    "ImpossiblePart",
    "LineForce",
    "LineSupports",
    "MeshSize",
    "OuterRing",
    "Part",
    "Patches",
    "PlanetGear",
    "RigidSeat",
    "RingOnShaft",
    "SquirrelCage",
]
