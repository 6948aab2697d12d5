"""A cylindrical roller with its profile."""

from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.material import Material

SLENDEREST = 50  # length over diameter of a roller, or diameter over length


class Profile(Protocol):
    """How far the generatrix lies below the cylinder, at a distance from mid-roller."""

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Profile drop C >= 0 [m] at `position` [m] for a roller of `length` [m]."""
        ...


@dataclass(frozen=True)
class Straight:
    """No crowning."""

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Zero everywhere [m]."""
        return np.zeros_like(position)


@dataclass(frozen=True, kw_only=True)
class Crowned:
    """A straight middle and circular ends.

    Source
    ------
    Mao, Wang and Zhang (2016), Eq. (1), with the drop counted positive.
    """

    straight_length: float  # [m]
    crown_radius: float  # [m] of the generatrix, far above the length

    def __post_init__(self):
        if self.straight_length < 0:
            raise ImpossiblePart(f"straight_length = {self.straight_length} must not be negative")
        require_positive("crown_radius", self.crown_radius)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; zero inside the straight part."""
        outside = np.maximum(np.abs(position), self.straight_length / 2)
        return np.sqrt(self.crown_radius**2 - self.straight_length**2 / 4) - np.sqrt(
            self.crown_radius**2 - outside**2
        )


@dataclass(frozen=True, kw_only=True)
class Logarithmic:
    """P(x) = A ln 1/(1 - (2x/l)^2), the profile of ISO/TS 16281 for A = 0.00035 D."""

    amplitude: float  # [m] A

    def __post_init__(self):
        require_positive("profile drop", self.amplitude)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; grows without bound towards the very end."""
        return -self.amplitude * np.log1p(-((2 * position / length) ** 2))


@dataclass(frozen=True, kw_only=True)
class Roller:
    """A cylindrical roller."""

    diameter: float  # [m]
    length: float  # [m] effective, without end chamfers
    material: Material
    profile: Profile = Straight()

    def __post_init__(self):
        for name in ("diameter", "length"):
            require_positive(f"roller.{name}", getattr(self, name))
        if not 1 / SLENDEREST <= self.length / self.diameter <= SLENDEREST:
            raise ImpossiblePart(
                f"roller.length = {self.length:.6g} m with roller.diameter = {self.diameter:.6g} m: "
                f"neither a roller nor a needle; allowed is a length of 1/{SLENDEREST} to {SLENDEREST} "
                "diameters"
            )

    @cached_property
    def mass(self) -> float:
        """Mass of the full cylinder [kg]."""
        return self.material.density * pi / 4 * self.diameter**2 * self.length

    @cached_property
    def inertia(self) -> float:
        """Moment of inertia about the roller's own axis [kg m2]."""
        return self.mass * self.diameter**2 / 8
