"""Flexible rings as finite elements; `fem.condense.condense` is the way in.

Only the parts are re-exported here, and loaded when they are requested: describing a ring costs nothing,
NGSolve is loaded by the modules that compute.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fem.parts.bolted_ring import BoltedRing as BoltedRing
    from fem.parts.boundary_conditions import (
        ClampedFace as ClampedFace,
        Foundation as Foundation,
        Housing as Housing,
        LineForce as LineForce,
        LineSupports as LineSupports,
        PlanetGear as PlanetGear,
        RigidSeat as RigidSeat,
    )
    from fem.parts.groove import Groove as Groove, Stations as Stations
    from fem.parts.material import Elastic as Elastic, ImpossiblePart as ImpossiblePart
    from fem.parts.part import Part as Part
    from fem.parts.reduced_body import ReducedBody as ReducedBody
    from fem.parts.resolution import Discretisation as Discretisation, Resolution as Resolution
    from fem.parts.rings import (
        MeshSize as MeshSize,
        OuterRing as OuterRing,
        Patches as Patches,
        RingOnShaft as RingOnShaft,
    )
    from fem.parts.squirrel_cage import SquirrelCage as SquirrelCage

EXPORTS = {
    "parts.bolted_ring": ("BoltedRing",),
    "parts.boundary_conditions": (
        "ClampedFace",
        "Foundation",
        "Housing",
        "LineForce",
        "LineSupports",
        "PlanetGear",
        "RigidSeat",
    ),
    "parts.groove": ("Groove", "Stations"),
    "parts.material": ("Elastic", "ImpossiblePart"),
    "parts.part": ("Part",),
    "parts.reduced_body": ("ReducedBody",),
    "parts.resolution": ("Discretisation", "Resolution"),
    "parts.rings": ("MeshSize", "OuterRing", "Patches", "RingOnShaft"),
    "parts.squirrel_cage": ("SquirrelCage",),
}


def __getattr__(name: str) -> Any:
    """Load a public name with its module."""
    for module, names in EXPORTS.items():
        if name in names:
            value = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(name for names in EXPORTS.values() for name in names)
