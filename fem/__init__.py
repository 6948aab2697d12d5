"""Flexible rings as finite elements; `fem.condense.condense` is the way in.

Only the parts are re-exported here: describing a ring costs nothing, NGSolve is loaded by the
modules that compute.
"""

from fem.parts.bolted_ring import BoltedGrooveRing
from fem.parts.boundary_conditions import (
    ClampedFace,
    Foundation,
    Housing,
    LineForce,
    LineSupports,
    PlanetGear,
    RigidSeat,
)
from fem.parts.resolution import Discretisation, Resolution
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
    "BoltedGrooveRing",
    "ClampedFace",
    "Discretisation",
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
    "Resolution",
    "RigidSeat",
    "RingOnShaft",
    "SquirrelCage",
]
