"""Typical size of every unknown and of every residual, by which the matrix of a bearing is scaled."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.roller import RollerBalance
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, TILT_Z, UnknownLayout
from quasidynamic.columns import stacked
from quasidynamic.motion.roller_speeds import rolling_cage_speed, rolling_roller_speed

FRICTION = 1e-2  # usual size of friction over load
LENGTH = 2e-4  # of the roller's diameter: size of approaches and displacements
ANGLE = 1e-3  # [rad]
OWN_SHARE = 1e-3  # of a roller's centrifugal force and weight, which stand for a load where there is none
FILM_SCALE = (
    100.0  # lengths, far above any film: a step is judged by its forces, not by films that lag behind
)
LARGE_DEVIATION = 100.0  # lengths, of a thin ring


@dataclass(frozen=True, kw_only=True)
class Scales:
    """Scales of C cases; columns stand for unknowns, rows for residuals.

    A table's rows and columns are as in `Linearisation`: roller, border, deviations.
    """

    layout: UnknownLayout
    roller: RollerBalance
    points: OperatingPoints

    @cached_property
    def length(self) -> NDArray | float:
        """Size of approaches and displacements, of all cases or (C, 1) [m]."""
        return LENGTH * self.roller.bearing.roller.diameter

    @cached_property
    def rolling_cage(self) -> NDArray:
        """Cage speed in pure rolling (C, 1) [rad/s]."""
        points, ratio = self.points, self.roller.bearing.diameter_ratio
        return rolling_cage_speed(points.inner_speed, points.outer_speed, ratio)

    @cached_property
    def rolling_spin(self) -> NDArray:
        """Roller spin in pure rolling (C, 1) [rad/s]."""
        points, ratio = self.points, self.roller.bearing.diameter_ratio
        return rolling_roller_speed(points.inner_speed, points.outer_speed, ratio)

    @cached_property
    def force(self) -> NDArray:
        """Force that residuals are measured against (C, 1) [N]: the applied one.

        A small share of centrifugal force and weight of a roller takes its place where that is larger.
        """
        bearing, points = self.roller.bearing, self.points
        orbit = np.maximum(np.abs(self.rolling_cage), np.abs(points.relative_speed) / 2)
        own, _ = self.roller.centrifugal(orbit)
        own = own + bearing.roller.mass * np.hypot(points.gravity_y, points.gravity_z)
        tilting = points.moment / bearing.roller.length
        return np.maximum(np.maximum(points.load, tilting), OWN_SHARE * own)

    @cached_property
    def unknown(self) -> NDArray:
        """Size of each unknown (C, N): lengths, milliradians, nominal speeds."""
        scale = np.full((len(self.points), self.layout.size), self.length)
        spin = np.abs(self.rolling_spin)
        scale[:, TILT_Z:CAGE] = ANGLE
        scale[:, CAGE:BORDER] = np.maximum(np.abs(self.rolling_cage), 1e-3 * spin)
        scale[:, self.layout.field(-1)] = spin
        return scale

    @cached_property
    def residual(self) -> NDArray:
        """Size of each residual (C, N)."""
        layout, ring = self.layout, self.layout.per_roller
        scale = np.full((len(self.points), layout.size), LARGE_DEVIATION * self.length)
        scale[:, :BORDER] = self.row[ring : ring + BORDER].T
        scale[:, BORDER : layout.fields_end] = self.row[:ring].T.repeat(layout.rollers, axis=1)
        return scale

    @cached_property
    def row(self) -> NDArray:
        """Scale of each kind of balance (rows, C).

        Friction is about a hundredth of the load that causes it, and so is the size of its balances.
        """
        bearing, layout, ring = self.roller.bearing, self.layout, self.layout.per_roller
        half, length = bearing.roller.length / 2, np.ravel(self.length)
        tilt = [half] if layout.axial_modes > 1 else []
        levers = [1.0, *tilt, 0.0, 0.0, FRICTION * bearing.roller.diameter / 2]
        levers += [1.0, 1.0, half, half, FRICTION * bearing.pitch_diameter / 2]
        rows = ring + BORDER + layout.axial_modes * len(layout.elastic_raceways)
        scale = np.full((rows, len(self.points)), LARGE_DEVIATION * length)
        scale[: ring + BORDER] = stacked(*levers)[..., 0] * self.force[:, 0]
        scale[ring - 3 : ring - 1] = FILM_SCALE * length
        return scale

    @cached_property
    def column(self) -> NDArray:
        """Size of the unknowns in the columns of the table (columns, C, 1)."""
        layout = self.layout
        of_roller = self.unknown[:, BORDER : layout.fields_end : layout.rollers].T
        deviations = np.full((layout.felt, len(self.points)), np.ravel(self.length))
        return np.concatenate([of_roller, self.unknown[:, :BORDER].T, deviations])[..., None]

    @cached_property
    def table(self) -> NDArray:
        """Columns over rows of the table (rows, columns, C, 1)."""
        return self.column[None] / self.row[:, None, :, None]

    @cached_property
    def spin(self) -> NDArray:
        """Spins over their balances (C, 1)."""
        last = self.layout.per_roller - 1
        return self.column[last] / self.row[last][:, None]

    @cached_property
    def border(self) -> NDArray:
        """Unknowns of the border over its balances (C, 5, 5)."""
        ring = self.layout.per_roller
        return self.unknown[:, None, :BORDER] / self.row[ring : ring + BORDER].T[..., None]
