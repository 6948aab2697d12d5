"""Operating points side by side: what may differ between the cases of one solve."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.operation import Operation


@dataclass(frozen=True, kw_only=True)
class OperatingPoints:
    """Loads and speeds of C cases, as columns (C, 1) that broadcast over the rollers."""

    load_y: NDArray  # [N] on the inner ring
    load_z: NDArray  # [N]
    moment_z: NDArray  # [N m] that tilts the ring in the plane x-z
    moment_y: NDArray  # [N m]
    slope_z: NDArray  # [rad] dz/dx of a ring that may not tilt freely
    slope_y: NDArray  # [rad] dy/dx
    free_tilt: NDArray  # whether it may
    inner_speed: NDArray  # [rad/s]
    outer_speed: NDArray  # [rad/s]
    gravity_y: NDArray  # [m/s2]
    gravity_z: NDArray  # [m/s2]

    @classmethod
    def of(cls, operations: Sequence[Operation]) -> "OperatingPoints":
        """Stack operations; each load, moment, misalignment and gravity is split along y and z."""
        names = ("radial_load", "load_direction", "moment", "misalignment", "inner_speed", "outer_speed")
        names += ("gravity", "gravity_direction")
        table = np.array([[getattr(o, name) for name in names] for o in operations], float)
        load, direction, moment, slope, inner, outer, gravity, down = table.T[..., None]
        cos, sin = np.cos(direction), np.sin(direction)
        return cls(
            load_y=load * sin,
            load_z=load * cos,
            moment_z=moment * cos,
            moment_y=moment * sin,
            slope_z=slope * cos,
            slope_y=slope * sin,
            free_tilt=np.array([[o.free_tilt] for o in operations], bool),
            inner_speed=inner,
            outer_speed=outer,
            gravity_y=gravity * np.sin(down),
            gravity_z=gravity * np.cos(down),
        )

    def __len__(self) -> int:
        return len(self.inner_speed)

    def take(self, cases: NDArray) -> "OperatingPoints":
        """Some of the cases."""
        return OperatingPoints(**{field.name: getattr(self, field.name)[cases] for field in fields(self)})

    @cached_property
    def relative_speed(self) -> NDArray:
        """Speed of the inner ring against the outer one (C, 1) [rad/s]."""
        return self.inner_speed - self.outer_speed

    @cached_property
    def ring_speeds(self) -> NDArray:
        """Speeds of inner and outer ring (2, C, 1) [rad/s]."""
        return np.array([self.inner_speed, self.outer_speed])

    def guiding_speed(self, guidance: str) -> NDArray:
        """Speed of the ring that guides the cage, or of the inner one (C, 1) [rad/s]."""
        return self.outer_speed if guidance == "outer" else self.inner_speed

    @cached_property
    def direction(self) -> NDArray:
        """Sense in which the rollers spin (C, 1): +1 when the inner ring turns ahead of the outer one."""
        return np.where(self.inner_speed > self.outer_speed, 1.0, -1.0)

    @cached_property
    def load(self) -> NDArray:
        """Size of the radial load (C, 1) [N]."""
        return np.hypot(self.load_y, self.load_z)

    @cached_property
    def moment(self) -> NDArray:
        """Size of the moment (C, 1) [N m]."""
        return np.hypot(self.moment_y, self.moment_z)
