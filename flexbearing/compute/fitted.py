"""An inner ring that its shaft holds by pressure and friction, as part of the structure."""

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.case import Case
from flexbearing.compute.assemble import growth
from flexbearing.compute.structure import CondensedRings
from flexbearing.coupling import PartnerFailed

if TYPE_CHECKING:
    from fem.compliance import RacewayCompliance
    from fem.loaded_fit import LoadedFit
    from fem.settled_fit import SettledFit

INNER, OUTER = 0, 1


@dataclass
class FittedRings:
    """An inner ring in its fit beside an outer ring that is condensed.

    It remembers the last answer: the next one starts from there.
    """

    fit: "SettledFit"
    azimuths: NDArray
    outer: "RacewayCompliance | None"
    last: "LoadedFit | None" = field(default=None, repr=False)

    @property
    def rigid(self) -> bool:
        """Never: the inner ring yields."""
        return False

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m] under roller forces (2, Z, M) [N]."""
        return self.linearised(forces).deviation(forces)

    def linearised(self, forces: NDArray) -> CondensedRings:
        """Both rings near these forces."""
        from fem.loaded_fit import loaded
        from fem.solve import NotSolved

        outward = -forces[INNER]  # rollers push the inner raceway inwards
        try:
            start = None if self.last is None else self.last.contact.jump
            found = loaded(self.fit, self.azimuths, outward, start)
        except NotSolved as problem:
            raise PartnerFailed(f"fit of the inner ring: {problem}", "not solved") from problem
        self.last = found
        tangent = found.tangent
        direction = np.stack([np.sin(self.azimuths), np.cos(self.azimuths)], axis=1)
        shape = found.deviation.copy()
        shape[:, 0] -= direction @ found.translation
        unloaded = shape - np.tensordot(tangent.matrix, outward, axes=2)
        shift = found.translation - np.tensordot(tangent.translation, outward, axes=2)
        inner = replace(tangent, deviation_without_load=unloaded)
        return CondensedRings((inner, self.outer), np.array([shift, [0.0, 0.0]]))

    def figures(self) -> dict[str, dict]:
        """What finite elements and fit say, for the result file."""
        rings = CondensedRings((self.fit.closed.at(self.azimuths), self.outer)).figures()
        told: dict[str, Any] = {
            "mean_pressure_unloaded_MPa": 1e-6 * self.fit.mean_pressure,
            "raceway_growth_um": 1e6 * float(self.fit.growth[0]),
        }
        if self.last is not None:
            told |= {
                "mean_pressure_MPa": 1e-6 * self.last.mean_pressure,
                "largest_pressure_MPa": 1e-6 * float(self.last.pressure.max()),
                "open_share": self.last.opened,
                "slipping_share": self.last.slipping,
            }
        rings["inner"]["fit"] = told
        return rings


def fit_of(case: Case, part: fem.RingOnShaft, length: float, mesh: fem.Mesh) -> "SettledFit":
    """Settle the ring of a case on its shaft, hot and turning, before rollers load it."""
    from fem.fitted_ring import FittedRing, condense_fitted
    from fem.settled_fit import Fit, settled

    inner, materials = case.inner, case.materials
    assert materials.shaft is not None  # or the case would not have been read
    ring = FittedRing(seat=part, shoulder_diameter=inner.shoulder_diameter)
    bodies = condense_fitted(ring, length, case.accuracy.axial_shapes, mesh)
    return settled(
        bodies,
        Fit(
            interference=inner.interference,
            friction=0.0 if inner.fit == "frictionless" else inner.fit_friction,
            clamping=inner.clamping,
            expansions=(growth(case, "inner_ring") - 1, growth(case, "shaft") - 1),
            densities=(materials.inner_ring.density, materials.shaft.density),
            speed=case.operation.inner_speed,
        ),
    )
