"""An inner ring that its shaft holds by pressure and friction, as part of the structure."""

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.build.expansion import hot_over_cold, material
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.rings.raceways import CondensedRings

if TYPE_CHECKING:
    from fem.joint.loaded_fit import LoadedFit
    from fem.joint.preloaded_fit import PreloadedFit
    from fem.raceway.compliance import RacewayCompliance
    from fem.section.expansion import Along

INNER, OUTER = 0, 1


@dataclass
class FittedRings:
    """An inner ring in its fit beside an outer ring that is condensed.

    It remembers the last answer: the next one starts from there.
    """

    fit: "PreloadedFit"
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
        outward = -forces[INNER]  # rollers push the inner raceway inwards
        self.last, inner, shift = raceway_near(
            "fit of the inner ring", self.fit, self.azimuths, outward, self.last
        )
        return CondensedRings((inner, self.outer), np.array([shift, [0.0, 0.0]]))

    def figures(self) -> dict[str, dict]:
        """What finite elements and fit say, for the result file."""
        rings = CondensedRings((self.fit.closed.at(self.azimuths), self.outer)).figures()
        told: dict[str, Any] = {
            "mean_pressure_unloaded_MPa": 1e-6 * self.fit.mean_pressure,
            "raceway_growth_um": 1e6 * float(self.fit.expansion[0]),
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


def raceway_near(
    name: str, fit: "PreloadedFit", azimuths: NDArray, outward: NDArray, last: "LoadedFit | None"
) -> "tuple[LoadedFit, RacewayCompliance, NDArray]":
    """A fit under outward forces (Z, M), its raceway near them, and its translation (2,) without them [m].

    The mean growth of the raceway belongs to the operating clearance; how it varies along the rollers is
    part of the shape.

    Raises
    ------
    PartnerFailed
        when contact in the fit is not found
    """
    from fem.assembly.factorisation import NotSolved
    from fem.joint.loaded_fit import loaded

    try:
        found = loaded(fit, azimuths, outward, None if last is None else last.contact.jump)
    except NotSolved as problem:
        raise PartnerFailed(f"{name}: {problem}", "not solved") from problem
    tangent = found.tangent
    direction = np.stack([np.sin(azimuths), np.cos(azimuths)], axis=1)
    shape = found.deviation.copy()
    shape[:, 0] -= direction @ found.translation
    shape[:, 1:] += fit.expansion[1:]
    unloaded = shape - np.tensordot(tangent.relative, outward, axes=2)
    shift = found.translation - np.tensordot(tangent.translation, outward, axes=2)
    return found, replace(tangent, initial_deviation=unloaded), shift


def variations(case: Case, **bodies: str) -> "dict[str, Along]":
    """Free expansions along the axis beyond those of the middle, where temperatures vary.

    Parameters
    ----------
    case : Case
        with the temperatures
    bodies : str
        name of each body in the structure, one of them "ring", and in the case

    Returns
    -------
    dict
        by the name of the body in the structure, only of those that vary
    """
    from fem.section.expansion import Along

    given, found = case.operation.temperatures, {}
    hot = hot_over_cold(case, bodies["ring"])  # both bodies are meshed as warm as the ring
    for name, part in bodies.items():
        along = given and getattr(given, f"{part}_along")
        if given is None or along is None:
            continue
        expansion = material(case, part).expansion
        rise = np.array(along.temperatures) - getattr(given, part)
        found[name] = Along(at=np.multiply(along.at, hot), values=expansion * rise)
    return found


def fit_of(case: Case, part: fem.RingOnShaft, length: float, mesh: fem.MeshSize) -> "PreloadedFit":
    """Settle the ring of a case on its shaft, hot and turning, before rollers load it."""
    from fem.joint.fitted_ring import FittedRing, condense_fitted
    from fem.joint.preloaded_fit import Fit, preloaded

    inner, materials = case.inner, case.materials
    assert materials.shaft is not None  # or the case would not have been read
    ring = FittedRing(seat=part, shoulder_diameter=inner.shoulder_diameter)
    bodies = condense_fitted(
        ring, length, case.accuracy.axial_shapes, mesh,
        variations=variations(case, ring="inner_ring", shaft="shaft"),
    )  # fmt: skip
    return preloaded(
        bodies,
        Fit(
            interference=inner.interference,
            friction=0.0 if inner.fit == "frictionless" else inner.fit_friction,
            clamping=inner.clamping,
            thermal_strains=(hot_over_cold(case, "inner_ring") - 1, hot_over_cold(case, "shaft") - 1),
            densities=(materials.inner_ring.density, materials.shaft.density),
            speed=case.operation.inner_speed,
        ),
    )
