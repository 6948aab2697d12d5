"""The rings as one partner of the coupling: condensed, inner and outer side by side."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance


@dataclass(frozen=True)
class CondensedRings:
    """Condensed raceways; None where a ring is rigid. Index 0 inner, 1 outer."""

    raceways: tuple["RacewayCompliance | None", "RacewayCompliance | None"]
    shifts: NDArray | None = None  # (2, 2) translations along (y, z) without roller loads [m]

    @property
    def rigid(self) -> bool:
        """Whether nothing yields."""
        return all(raceway is None for raceway in self.raceways)

    def linearised(self, forces: NDArray) -> "CondensedRings":
        """Themselves: they are linear."""
        return self

    @property
    def unloaded(self) -> NDArray | None:
        """Outward deviations (2, Z, M) [m] without roller loads, such as those of tooth forces."""
        given = [None if raceway is None else raceway.initial_deviation for raceway in self.raceways]
        known = [shape for shape in given if shape is not None]
        if not any(shape.any() for shape in known):
            return None
        return np.array([np.zeros_like(known[0]) if shape is None else shape for shape in given])

    @property
    def compliance(self) -> tuple[NDArray | None, NDArray | None]:
        """Outward deviation per outward force (Z, M, Z, M) [m/N]."""
        inner, outer = (None if raceway is None else raceway.relative for raceway in self.raceways)
        return inner, outer

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m]; rollers push the inner raceway inwards."""
        shapes = np.zeros_like(forces)
        for race, (raceway, sign) in enumerate(zip(self.raceways, (-1.0, 1.0), strict=True)):
            if raceway is not None:
                shapes[race] = raceway.initial_deviation
                shapes[race] += sign * np.tensordot(raceway.relative, forces[race], axes=2)
        return shapes

    def translation(self, forces: NDArray) -> NDArray:
        """Rigid translations (2, 2) of inner and outer raceway along (y, z) [m]."""
        moved = np.zeros((2, 2)) if self.shifts is None else self.shifts.copy()
        for race, (raceway, sign) in enumerate(zip(self.raceways, (-1.0, 1.0), strict=True)):
            if raceway is not None:
                moved[race] += sign * np.tensordot(raceway.translation, forces[race], axes=2)
        return moved

    def figures(self) -> dict[str, dict]:
        """What the finite elements cost and how stiff the supports are, for the result file."""
        return {
            name: {
                "unknowns": raceway.unknowns,
                "elements": raceway.elements,
                "support_stiffness_N_per_m": (
                    raceway.support_stiffness if np.isfinite(raceway.support_stiffness) else None
                ),
                "seconds": raceway.seconds,
            }
            for name, raceway in zip(("inner", "outer"), self.raceways, strict=True)
            if raceway is not None
        }
