"""What is asked of the bearing."""

from dataclasses import dataclass

import numpy as np

from quasidynamic.errors import ImpossiblePart

GRAVITY = 9.81  # [m/s2]


@dataclass(frozen=True, kw_only=True)
class Operation:
    """Load and speed."""

    radial_load: float  # [N] on the inner ring, >= 0
    inner_speed: float  # [rad/s]
    outer_speed: float = 0.0  # [rad/s]
    load_direction: float = 0.0  # [rad] azimuth the load points to
    moment: float = 0.0  # [N m] on the inner ring, tilts it in the plane of the load
    misalignment: float = 0.0  # [rad] slope of a ring that may not tilt freely, in the plane of the load
    free_tilt: bool = False  # whether the inner ring may tilt against the outer one
    gravity: float = GRAVITY  # [m/s2] across the axis: 0 where the shaft stands upright
    gravity_direction: float = 0.0  # [rad] azimuth that weights point to

    def __post_init__(self):
        if self.inner_speed == self.outer_speed:
            raise ImpossiblePart(f"both rings turn at {self.inner_speed} rad/s: nothing rolls")
        if self.radial_load < 0:
            raise ImpossiblePart(f"radial_load = {self.radial_load} N: turn load_direction instead")
        if self.gravity < 0:
            raise ImpossiblePart(f"gravity = {self.gravity} m/s2: turn gravity_direction instead")
        if self.moment and not self.free_tilt:
            raise ImpossiblePart(f"moment = {self.moment} N m acts on a ring that may not tilt")
        if self.misalignment and self.free_tilt:
            raise ImpossiblePart(
                f"misalignment = {self.misalignment} rad is given to a ring that tilts freely"
            )

    @property
    def direction(self) -> float:
        """Sense in which the rollers spin: +1 when the inner ring turns ahead of the outer one."""
        return 1.0 if self.inner_speed > self.outer_speed else -1.0

    @property
    def tilts(self) -> bool:
        """Whether the rings stand at an angle to each other between raceways of no shape of their own."""
        return bool(np.any(self.moment) or np.any(self.misalignment))
