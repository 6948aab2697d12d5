"""Operating points side by side: what may differ between the cases of one solve."""

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.roller_bearing import Operation


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
    axial_load: NDArray  # [N] on the inner ring, along x
    inner_speed: NDArray  # [rad/s]
    outer_speed: NDArray  # [rad/s]
    gravity_y: NDArray  # [m/s2]
    gravity_z: NDArray  # [m/s2]

    @classmethod
    def of(cls, operation: Operation, cases: int = 1) -> "OperatingPoints":
        """Operation of C cases, its numbers or columns; all that has a direction is split along y and z."""

        def column(value: Any) -> NDArray:
            return np.full((cases, 1), value, float)

        cos, sin = np.cos(operation.load_direction), np.sin(operation.load_direction)
        tilting = operation.load_direction + operation.tilt_direction
        tilt_cos, tilt_sin = np.cos(tilting), np.sin(tilting)
        down, gravity = operation.gravity_direction, operation.gravity
        return cls(
            load_y=column(operation.radial_load * sin),
            load_z=column(operation.radial_load * cos),
            moment_z=column(operation.moment * tilt_cos),
            moment_y=column(operation.moment * tilt_sin),
            slope_z=column(operation.misalignment * tilt_cos),
            slope_y=column(operation.misalignment * tilt_sin),
            free_tilt=np.full((cases, 1), operation.free_tilt),
            axial_load=column(operation.axial_load),
            inner_speed=column(operation.inner_speed),
            outer_speed=column(operation.outer_speed),
            gravity_y=column(gravity * np.sin(down)),
            gravity_z=column(gravity * np.cos(down)),
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
