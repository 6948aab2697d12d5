"""An outer ring that touches its housing only where it is pressed on it, as part of the structure."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.build.expansion import hot_over_cold, material
from flexbearing.case.roller import Case
from flexbearing.rings.fitted import INNER, OUTER, FittedRings, raceway_near, variations
from flexbearing.rings.raceways import CondensedRings

if TYPE_CHECKING:
    from fem.joint.loaded_fit import LoadedFit
    from fem.joint.preloaded_fit import PreloadedFit


@dataclass
class HousedRings:
    """An outer ring with clearance in its housing beside an inner ring of any kind.

    It remembers the last answer: the next one starts from there.
    """

    fit: "PreloadedFit"
    azimuths: NDArray
    inner: CondensedRings | FittedRings  # without an outer ring
    last: "LoadedFit | None" = field(default=None, repr=False)

    @property
    def rigid(self) -> bool:
        """Never: the outer ring yields."""
        return False

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m] under roller forces (2, Z, M) [N]."""
        return self.linearised(forces).deviation(forces)

    def linearised(self, forces: NDArray) -> CondensedRings:
        """Both rings near these forces."""
        beside = self.inner.linearised(forces)
        self.last, outer, shift = raceway_near(
            "outer ring in its housing", self.fit, self.azimuths, forces[OUTER], self.last
        )
        shifts = np.zeros((2, 2)) if beside.shifts is None else beside.shifts.copy()
        shifts[OUTER] = shift
        return CondensedRings((beside.raceways[INNER], outer), shifts)

    def figures(self) -> dict[str, dict]:
        """What finite elements and contact say, for the result file."""
        rings = self.inner.figures() | CondensedRings((None, self.fit.closed.at(self.azimuths))).figures()
        told: dict[str, Any] = {
            "mean_gap_unloaded_um": 1e6 * float(self.fit.gap.mean()),
            "mean_pressure_unloaded_MPa": 1e-6 * self.fit.mean_pressure,
            "raceway_growth_um": 1e6 * float(self.fit.expansion[0]),
        }
        if self.last is not None:
            told |= {
                "touching_angle_deg": float(np.degrees(self.last.touching_angle)),
                "open_share": self.last.opened,
                "mean_pressure_MPa": 1e-6 * self.last.mean_pressure,
                "largest_pressure_MPa": 1e-6 * float(self.last.pressure.max()),
                "largest_gap_um": 1e6 * float(self.last.gap.max()),
            }
        rings["outer"]["housing"] = told
        return rings


def housing_fit(case: Case, part: fem.OuterRing, length: float, mesh: fem.MeshSize) -> "PreloadedFit":
    """Ring of a case in its housing, hot and turning, before rollers load it."""
    from fem.joint.fitted_ring import HousedRing, condense_fitted
    from fem.joint.preloaded_fit import Fit, preloaded

    clearance = case.outer.housing_clearance
    assert clearance is not None  # or there would be no fit
    bodies = condense_fitted(
        HousedRing(seat=part), length, case.accuracy.axial_shapes, mesh,
        variations=variations(case, ring="outer_ring", housing="housing"),
    )  # fmt: skip
    return preloaded(
        bodies,
        Fit(
            interference=-clearance,
            friction=0.0,
            thermal_strains=(hot_over_cold(case, "outer_ring") - 1, hot_over_cold(case, "housing") - 1),
            densities=(case.materials.outer_ring.density, material(case, "housing").density),
            speed=case.operation.outer_speed,
        ),
    )
