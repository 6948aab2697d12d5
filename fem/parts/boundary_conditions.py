"""What holds a plain outer ring, as frozen data; lengths, azimuths and directions as in `fem.parts.rings`."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from fem.parts.material import Elastic, ImpossiblePart, require, require_positive
from fem.parts.reduced_body import ReducedBody

BALANCED = 1e-9  # moment about the axis that tooth forces may leave, over the largest one
HELD = 1e-6  # smallest over largest singular value of motions at lines that hold them


@dataclass(frozen=True)
class ClampedFace:
    """The end face at x = +width/2 does not move."""


@dataclass(frozen=True)
class RigidSeat:
    """The outer surface does not move."""


@dataclass(frozen=True, kw_only=True)
class Foundation:
    """Springs to ground on the outer surface.

    Without axial or tangential ones the ring does not move along or turn about its axis: no load on
    the raceway would make it.
    """

    axial: float  # [N/m^3] per area, >= 0
    radial: float  # [N/m^3] >= 0
    tangential: float  # [N/m^3] >= 0
    pushing: bool = False  # radial springs only push: the ring lifts off where they would pull

    def __post_init__(self):
        for name in ("axial", "radial", "tangential"):
            value = getattr(self, name)
            require(value >= 0 and isfinite(value), name, value, "a finite number, zero or above")
        if self.pushing and self.radial == 0:
            raise ImpossiblePart("radial = 0: there is nothing that could only push; give the springs")
        if self.radial == self.tangential == 0:
            raise ImpossiblePart(
                "radial = tangential = 0: the ring can still move along y and z; give one of the springs"
            )


@dataclass(frozen=True, kw_only=True)
class Housing:
    """A concentric tube bonded on the outer surface, centred on the ring and held itself."""

    thickness: float  # [m] radial
    width: float  # [m] axial, narrower or wider than the ring
    elastic: Elastic
    support: ClampedFace | RigidSeat | Foundation = RigidSeat()  # of the tube, at its own surfaces

    def __post_init__(self):
        require_positive(self, "thickness", "width")


@dataclass(frozen=True, kw_only=True)
class LineSupports:
    """Frictionless lines along the outer surface, over its full width; they hold it radially.

    Along and about its axis, where they do not hold it, the ring does not move: no load on the raceway
    would make it.
    """

    azimuths: Sequence[float]  # (K,) [rad], all different
    stiffness: float = inf  # [N/m] of each line to ground, evenly spread along it; inf is rigid
    tilting: bool = False  # lines hold only the mean displacement along them, as a crowned one does
    pushing: bool = False  # lines only push, and lift off where they would pull

    def __post_init__(self):
        object.__setattr__(self, "azimuths", tuple(float(phi) for phi in self.azimuths))
        require(
            len(self.azimuths) > 0 and all(map(isfinite, self.azimuths)),
            "azimuths", self.azimuths, "one or more finite angles",
        )  # fmt: skip
        require(self.stiffness > 0, "stiffness", self.stiffness, "above zero, infinite if rigid")
        if free := free_translations(self.azimuths):
            raise ImpossiblePart(
                f"azimuths = {self.azimuths}: the ring can still move {free}; "
                "lines in another direction, neither the same nor opposite, would hold it"
            )


@dataclass(frozen=True, kw_only=True)
class LineForce:
    """Force on a line along the outer surface, evenly spread over the full width."""

    azimuth: float  # [rad]
    radial: float  # [N] outward
    tangential: float  # [N] towards growing azimuth
    axial: float = 0.0  # [N] towards +x

    def __post_init__(self):
        values = (self.azimuth, self.radial, self.tangential, self.axial)
        require(all(map(isfinite, values)), "line force", values, "finite numbers")


@dataclass(frozen=True, kw_only=True)
class PlanetGear:
    """The ring is the rim of a planet gear: nothing holds it, tooth forces balance the rollers'.

    A tangential or axial force at a larger radius than that of the rim also bends it by its couple there.
    """

    forces: Sequence[LineForce]  # of the teeth
    radius: float | None = None  # [m] at which they act; None: on the outer surface of the rim

    def __post_init__(self):
        object.__setattr__(self, "forces", tuple(self.forces))
        for name, motion in (("tangential", "turn about"), ("axial", "move along")):
            forces = [getattr(force, name) for force in self.forces]
            if abs(sum(forces)) > BALANCED * max(map(abs, forces), default=0.0):
                raise ImpossiblePart(
                    f"{name} forces add up to {sum(forces):.6g} N: the ring can still {motion} its axis, as "
                    "rollers cannot hold it; allowed is a sum of zero"
                )

    @property
    def helical(self) -> bool:
        """Whether teeth press along the axis."""
        return any(force.axial for force in self.forces)


Support = ClampedFace | RigidSeat | Foundation | Housing | LineSupports | PlanetGear | ReducedBody


def free_translations(azimuths) -> str:
    """Directions in which radial lines at azimuths [rad] do not hold a ring, in words; empty for none."""
    normals = np.stack([np.sin(azimuths), np.cos(azimuths)], axis=1).reshape(-1, 2)
    _, stretch, motions = np.linalg.svd(np.concatenate([normals, np.zeros((2, 2))]))
    free = motions[stretch <= HELD * max(stretch[0], HELD)]
    if len(free) == 2:
        return "along y and z"
    return " and ".join(f"along (y, z) = ({y:.3g}, {z:.3g})" for y, z in free)


@dataclass(frozen=True)
class FreeMotions:
    """Rigid motions that nothing holds."""

    axial: bool = False
    turning: bool = False  # about the axis
    across: bool = False  # translation along y, z, with tilt about them


def free_motions(support: Support) -> FreeMotions:
    """Rigid motions that a support leaves to the ring; lines take some, see `section.ring_on_lines`."""
    match support:
        case LineSupports() | PlanetGear():
            return FreeMotions(axial=True, turning=True, across=True)
        case Foundation(axial=axial, tangential=tangential):
            return FreeMotions(axial=axial == 0, turning=tangential == 0)
        case Housing(support=outer):
            return free_motions(outer)
        case _:
            return FreeMotions()


def edge_names(support: Support) -> tuple[str | None, str | None]:
    """Names of the end face at +x and of the outer surface that a support acts on."""
    match support:
        case ClampedFace():
            return "clamped", None
        case RigidSeat():
            return None, "clamped"
        case Foundation() | ReducedBody():
            return None, "foundation"
        case LineSupports() | PlanetGear():
            return None, "lines"
        case Housing():
            return None, "seat"
