"""Flexible rings as finite elements; `fem.compliance.condense` is the way in.

Only the parts are re-exported here: describing a ring costs nothing, NGSolve is loaded by the
modules that compute.
"""

from fem.parts import ClampedRing, Elastic, ImpossiblePart, Mesh, Part, Patches, RingOnShaft, SquirrelCage

__all__ = [
    "ClampedRing",
    "Elastic",
    "ImpossiblePart",
    "Mesh",
    "Part",
    "Patches",
    "RingOnShaft",
    "SquirrelCage",
]
