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

    @classmethod
    def of(cls, operations: Sequence[Operation]) -> "OperatingPoints":
        """Stack operations; each load, moment and misalignment is split along y and z."""
        cos, sin = (_column(operations, lambda o, f=f: f(o.load_direction)) for f in (np.cos, np.sin))
        load, moment, slope = (
            _column(operations, lambda o, n=name: getattr(o, n))
            for name in ("radial_load", "moment", "misalignment")
        )
        return cls(
            load_y=load * sin,
            load_z=load * cos,
            moment_z=moment * cos,
            moment_y=moment * sin,
            slope_z=slope * cos,
            slope_y=slope * sin,
            free_tilt=_column(operations, lambda o: o.free_tilt).astype(bool),
            inner_speed=_column(operations, lambda o: o.inner_speed),
            outer_speed=_column(operations, lambda o: o.outer_speed),
        )

    def __len__(self) -> int:
        return len(self.inner_speed)

    def take(self, cases: NDArray) -> "OperatingPoints":
        """Some of the cases."""
        return OperatingPoints(**{field.name: getattr(self, field.name)[cases] for field in fields(self)})

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


def _column(operations: Sequence[Operation], value) -> NDArray:
    return np.array([[float(value(operation))] for operation in operations])
