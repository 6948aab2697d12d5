"""Unknowns of the bearing: what they are, their order."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.roller import RollerBalance
from quasidynamic.columns import stacked
from quasidynamic.motion.roller_speeds import rolling_cage_speed, rolling_roller_speed

INNER, OUTER = 0, 1
OUTWARD = (-1.0, 1.0)  # sense of the contact force on a raceway: rollers press the inner one inwards
Y, Z, TILT_Z, TILT_Y, CAGE, SHIFT = range(6)
BORDER = 5  # unknowns of ring and cage, before those of the rollers; one more of a ring on ribs
CASE_AXES = (1, 0, 0, 0, 1, 0, 2, 0)  # of the fields of `Unknowns`
FRICTION = 1e-2  # usual size of friction over load
LENGTH = 2e-4  # of the roller's diameter: size of approaches and displacements
ANGLE = 1e-3  # [rad]
OWN_SHARE = 1e-3  # of a roller's centrifugal force and weight, which stand for a load where there is none
FILM_SCALE = (
    100.0  # lengths, far above any film: a step is judged by its forces, not by films that lag behind
)
LARGE_DEVIATION = 100.0  # lengths, of a thin ring


class Unknowns(NamedTuple):
    """Unknowns of C cases in SI units."""

    ring: NDArray  # (4, C, 1) displacement y, z [m], slopes dz/dx, dy/dx [rad]
    cage_drift: NDArray  # (C, 1) cage speed less that of pure rolling [rad/s]
    approach: NDArray  # (C, Z) at the outer raceway [m]
    tilt: NDArray  # (C, Z) tilt approach at the outer raceway [m], zero when rollers are aligned
    film: NDArray  # (2, C, Z) [m]
    spin_drift: NDArray  # (C, Z) spin less that of pure rolling [rad/s]
    deviation: NDArray  # (2, M, C, Z) outward, of elastic raceways [m]
    shift: NDArray  # (C, 1) of the ring along the axis [m], zero where no rib is pressed

    def take(self, cases: NDArray) -> "Unknowns":
        """Unknowns of some of the cases."""
        return Unknowns(*(np.take(values, cases, axis) for values, axis in zip(self, CASE_AXES, strict=True)))

    def with_cases(self, cases: NDArray, some: "Unknowns") -> "Unknowns":
        """The same with other unknowns in some of the cases."""
        changed = Unknowns(*(values.copy() for values in self))
        for values, others, axis in zip(changed, some, CASE_AXES, strict=True):
            np.moveaxis(values, axis, 0)[cases] = np.moveaxis(others, axis, 0)
        return changed


@dataclass(frozen=True, kw_only=True)
class UnknownLayout:
    """Order of the N unknowns of a case.

    Ring displacement y, z; ring slopes dz/dx, dy/dx; cage drift; on ribs the shift of the ring along the
    axis; then field by field over the rollers the approach at the outer raceway, the tilt approach there
    unless rollers are aligned, inner and outer film and the spin drift; then the axial modes of every elastic
    raceway's deviation, roller by roller.
    """

    rollers: int  # Z, of all rows
    axial_modes: int  # M, axial modes
    elastic_raceways: tuple[int, ...] = ()  # by index
    rows: int = 1  # of rollers, one after the other
    ribs: bool = False  # whether the rollers press ribs

    @cached_property
    def border(self) -> int:
        """Number B of the unknowns of ring and cage, before those of the rollers."""
        return BORDER + self.ribs

    @cached_property
    def per_roller(self) -> int:
        """Number of unknowns of each roller."""
        return 4 + (self.axial_modes > 1)

    @cached_property
    def fields_end(self) -> int:
        """Number of unknowns before the deviations."""
        return self.border + self.rollers * self.per_roller

    @cached_property
    def size(self) -> int:
        """Number N of unknowns of a case."""
        return self.fields_end + self.rollers * self.axial_modes * len(self.elastic_raceways)

    @cached_property
    def felt(self) -> int:
        """Number of combinations of its deviations that act on a roller.

        Between two elastic raceways height and tilt of the one against the other, and the waviness of both.
        """
        both = len(self.elastic_raceways) > 1
        return self.axial_modes * len(self.elastic_raceways) - both * self.relative_modes

    @cached_property
    def relative_modes(self) -> int:
        """Number of modes in which raceways count against each other only; on ribs not the tilt."""
        return 1 if self.ribs else min(self.axial_modes, 2)

    def field(self, which: int) -> slice:
        """Place of a roller's unknown (0 approach, ..., -1 spin) among the unknowns of a case."""
        start = self.border + which % self.per_roller * self.rollers
        return slice(start, start + self.rollers)

    @cached_property
    def displacements(self) -> NDArray:
        """Places of the unknowns that are displacements of rings, rollers and raceways."""
        rollers = self.border + np.arange(self.rollers * (self.per_roller - 3))
        ring = [Y, Z, *range(SHIFT, self.border)]
        return np.concatenate([ring, rollers, np.arange(self.fields_end, self.size)])

    @cached_property
    def forces(self) -> NDArray:
        """Places of the residuals that belong to displacements and to the tilts of the ring."""
        return np.append([TILT_Z, TILT_Y], self.displacements)

    def split(self, x: NDArray) -> Unknowns:
        """Unknowns by name from a row (C, N), in SI units."""
        cases, m = len(x), self.axial_modes
        fields = (
            x[:, self.border : self.fields_end]
            .reshape(cases, self.per_roller, self.rollers)
            .transpose(1, 0, 2)
        )
        deviation = np.zeros((2, m, cases, self.rollers))
        if self.elastic_raceways:
            modes = x[:, self.fields_end :].reshape(cases, len(self.elastic_raceways), self.rollers, m)
            deviation[list(self.elastic_raceways)] = modes.transpose(1, 3, 0, 2)
        return Unknowns(
            ring=x[:, :CAGE].T[..., None],
            cage_drift=x[:, CAGE:BORDER],
            approach=fields[0],
            tilt=fields[1] if m > 1 else np.zeros(fields[0].shape),
            film=fields[-3:-1],
            spin_drift=fields[-1],
            deviation=deviation,
            shift=x[:, [SHIFT]] if self.ribs else np.zeros((cases, 1)),
        )

    def joined(self, unknowns: Unknowns) -> NDArray:
        """Row (C, N), the inverse of `split`; what has no place here is left out."""
        m, cases = self.axial_modes, len(unknowns.cage_drift)
        tilt = [unknowns.tilt] if m > 1 else []
        fields = [unknowns.approach, *tilt, *unknowns.film, unknowns.spin_drift]
        shift = [unknowns.shift] if self.ribs else []
        x = [unknowns.ring[..., 0].T, unknowns.cage_drift, *shift, *fields]
        if self.elastic_raceways:
            modes = np.zeros((2, m, cases, self.rollers))
            common = min(m, unknowns.deviation.shape[1])
            modes[:, :common] = unknowns.deviation[:, :common]
            x.append(modes[list(self.elastic_raceways)].transpose(2, 0, 3, 1).reshape(cases, -1))
        return np.concatenate(x, axis=1)


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
        outside = np.maximum(np.maximum(points.load, tilting), np.abs(points.axial_load))
        return np.maximum(outside, OWN_SHARE * own)

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
        border = layout.border
        scale[:, :border] = self.row[ring : ring + border].T
        scale[:, border : layout.fields_end] = self.row[:ring].T.repeat(layout.rollers, axis=1)
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
        levers += [1.0, 1.0, half, half, FRICTION * bearing.pitch_diameter / 2] + [1.0] * layout.ribs
        rows = ring + layout.border + layout.axial_modes * len(layout.elastic_raceways)
        scale = np.full((rows, len(self.points)), LARGE_DEVIATION * length)
        scale[: ring + layout.border] = stacked(*levers)[..., 0] * self.force[:, 0]
        scale[ring - 3 : ring - 1] = FILM_SCALE * length
        return scale

    @cached_property
    def column(self) -> NDArray:
        """Size of the unknowns in the columns of the table (columns, C, 1)."""
        layout = self.layout
        of_roller = self.unknown[:, layout.border : layout.fields_end : layout.rollers].T
        deviations = np.full((layout.felt, len(self.points)), np.ravel(self.length))
        return np.concatenate([of_roller, self.unknown[:, : layout.border].T, deviations])[..., None]

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
        """Unknowns of the border over its balances (C, B, B)."""
        ring, border = self.layout.per_roller, self.layout.border
        return self.unknown[:, None, :border] / self.row[ring : ring + border].T[..., None]
