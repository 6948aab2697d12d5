"""Unknowns of the bearing: what they are, their order."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

INNER, OUTER = 0, 1
OUTWARD = (-1.0, 1.0)  # sense of the contact force on a raceway: rollers press the inner one inwards
Y, Z, TILT_Z, TILT_Y, CAGE = range(5)
BORDER = 5  # unknowns of ring and cage, before those of the rollers
CASE_AXES = (1, 0, 0, 0, 1, 0, 2)  # of the fields of `Unknowns`


class Unknowns(NamedTuple):
    """Unknowns of C cases in SI units."""

    ring: NDArray  # (4, C, 1) displacement y, z [m], slopes dz/dx, dy/dx [rad]
    cage_drift: NDArray  # (C, 1) cage speed less that of pure rolling [rad/s]
    approach: NDArray  # (C, Z) at the outer raceway [m]
    tilt: NDArray  # (C, Z) tilt approach at the outer raceway [m], zero when rollers are aligned
    film: NDArray  # (2, C, Z) [m]
    spin_drift: NDArray  # (C, Z) spin less that of pure rolling [rad/s]
    deviation: NDArray  # (2, M, C, Z) outward, of elastic raceways [m]

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

    Ring displacement y, z; ring slopes dz/dx, dy/dx; cage drift; then field by field over the rollers
    the approach at the outer raceway, the tilt approach there unless rollers are aligned, inner and
    outer film and the spin drift; then the axial modes of every elastic raceway's deviation, roller by
    roller.
    """

    rollers: int
    axial_modes: int  # M, axial modes
    elastic_raceways: tuple[int, ...] = ()  # by index

    @cached_property
    def per_roller(self) -> int:
        """Number of unknowns of each roller."""
        return 4 + (self.axial_modes > 1)

    @cached_property
    def fields_end(self) -> int:
        """Number of unknowns before the deviations."""
        return BORDER + self.rollers * self.per_roller

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
        return self.axial_modes * len(self.elastic_raceways) - both * min(self.axial_modes, 2)

    def field(self, which: int) -> slice:
        """Place of a roller's unknown (0 approach, ..., -1 spin) among the unknowns of a case."""
        start = BORDER + which % self.per_roller * self.rollers
        return slice(start, start + self.rollers)

    @cached_property
    def displacements(self) -> NDArray:
        """Places of the unknowns that are displacements of rings, rollers and raceways."""
        rollers = np.arange(BORDER, BORDER + self.rollers * (self.per_roller - 3))
        return np.concatenate([[Y, Z], rollers, np.arange(self.fields_end, self.size)])

    def split(self, x: NDArray) -> Unknowns:
        """Unknowns by name from a row (C, N), in SI units."""
        cases, m = len(x), self.axial_modes
        fields = (
            x[:, BORDER : self.fields_end].reshape(cases, self.per_roller, self.rollers).transpose(1, 0, 2)
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
        )

    def joined(self, unknowns: Unknowns) -> NDArray:
        """Row (C, N), the inverse of `split`; what has no place here is left out."""
        m, cases = self.axial_modes, len(unknowns.cage_drift)
        tilt = [unknowns.tilt] if m > 1 else []
        fields = [unknowns.approach, *tilt, *unknowns.film, unknowns.spin_drift]
        x = [unknowns.ring[..., 0].T, unknowns.cage_drift, *fields]
        if self.elastic_raceways:
            modes = np.zeros((2, m, cases, self.rollers))
            common = min(m, unknowns.deviation.shape[1])
            modes[:, :common] = unknowns.deviation[:, :common]
            x.append(modes[list(self.elastic_raceways)].transpose(2, 0, 3, 1).reshape(cases, -1))
        return np.concatenate(x, axis=1)
