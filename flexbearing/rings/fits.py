"""Rings that shaft or housing hold by pressure and friction, so that their raceways are not linear."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import fem
from fem.errors import NotSolved
from flexbearing.build.expansion import hot_over_cold, material
from flexbearing.build.growth import expansions_along, fit_resolution, mean_growth
from flexbearing.build.ring_parts import Race
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.coupling.raceway_pair import linear_answer
from flexbearing.rings.raceways import compliance_figures

if TYPE_CHECKING:
    from fem.joint.loaded_fit import LoadedFit
    from fem.joint.preloaded_fit import Fit, PreloadedFit
    from fem.raceway.compliance import RacewayCompliance


@dataclass
class RacewayInFit:
    """The raceway of a ring that shaft or housing holds where it is pressed on them.

    It keeps its last answer, from which the next one starts: the same forces give the same answer, sooner.
    """

    name: str  # for messages
    fit: "PreloadedFit"
    azimuths: NDArray  # (Z) [rad]
    fit_figures: "Callable[[PreloadedFit, LoadedFit | None], dict[str, object]]"  # for the result file
    last: "LoadedFit | None" = field(default=None, repr=False)
    rigid = False
    solved_in_full = False

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N].

        Raises `PartnerFailed` when contact in the fit is not found.
        """
        return linear_answer(self.linearised(outward), outward)

    def linearised(self, outward: NDArray) -> "RacewayCompliance":
        """The raceway near outward forces (Z, M) [N].

        The mean expansion of the raceway belongs to the operating clearance; its variation along the
        rollers is part of the deviation.
        """
        from fem.joint.loaded_fit import loaded

        start = None if self.last is None else self.last.contact.jump
        with self._named_failure():
            self.last = loaded(self.fit, self.azimuths, outward, start)
        tangent, deviation = self.last.tangent, self.last.deviation + self.fit.shape
        by_load, translation = linear_answer(tangent, outward)
        return replace(
            tangent,
            initial_deviation=deviation - by_load,
            initial_translation=self.last.translation - translation,
        )

    def under(self, azimuths: NDArray) -> "RacewayInFit":
        """The same raceway under rollers at other azimuths (Z) [rad]."""
        return replace(self, azimuths=azimuths, last=None)

    def figures(self) -> dict[str, object]:
        """What finite elements and fit say; raises `PartnerFailed` where harmonics end too early."""
        with self._named_failure():
            closed = self.fit.closed.at(self.azimuths)
        return compliance_figures(closed) | self.fit_figures(self.fit, self.last)

    @contextmanager
    def _named_failure(self) -> Iterator[None]:
        try:
            yield
        except NotSolved as problem:
            raise PartnerFailed(f"{self.name}: {problem}", "not solved") from problem


def is_in_fit(case: Case, race: Race) -> bool:
    """Whether a part is held by a contact that may open or slip, so that it is not linear."""
    return case.inner.fit != "bonded" if race == "inner" else case.lifts_off


def inner_ring_in_fit(case: Case, part: fem.RingOnShaft, azimuths: NDArray) -> RacewayInFit:
    """Put the inner ring of a case on its shaft, hot and turning, before rollers load it."""
    from fem.joint.fitted_ring import FittedRing
    from fem.joint.preloaded_fit import Fit, fitted

    inner = case.inner
    ring = FittedRing(seat=part, shoulder_diameter=inner.shoulder_diameter)
    fit = Fit(
        interference=case.shaft_interference,
        friction=0.0 if inner.fit == "frictionless" else inner.fit_friction,
        clamping=inner.clamping,
        thermal_strains=(hot_over_cold(case, "inner_ring") - 1, hot_over_cold(case, "shaft") - 1),
        densities=(material(case, "inner_ring").density, material(case, "shaft").density),
        speed=case.operation.inner_speed,
    )
    along = expansions_along(case, ring="inner_ring", shaft="shaft")
    ready = fitted(ring, fit_resolution(case, ring), fit, along)
    return RacewayInFit("fit of the inner ring", ready, azimuths, _shaft_fit_figures)


def outer_ring_in_housing(case: Case, part: fem.OuterRing, azimuths: NDArray) -> RacewayInFit:
    """Put the outer ring of a case in its housing, hot and turning, before rollers load it."""
    from fem.joint.fitted_ring import HousedRing
    from fem.joint.preloaded_fit import fitted

    ring = HousedRing(seat=part)
    along = expansions_along(case, ring="outer_ring", housing="housing")
    ready = fitted(ring, fit_resolution(case, ring), in_housing(case), along)
    figures = partial(_housing_figures, hot=1 + ready.fit.thermal_strains[0])
    return RacewayInFit("outer ring in its housing", ready, azimuths, figures)


def grooved_ring_in_housing(
    case: FastCase, part: fem.OuterRing, resolution: fem.Resolution, azimuths: NDArray
) -> RacewayInFit:
    """The same of a ring with its groove, before balls load it; its mesh is that of a cold ring."""
    from fem.joint.fitted_ring import HousedRing
    from fem.joint.preloaded_fit import fitted

    ready = fitted(HousedRing(seat=part), resolution, in_housing(case))
    figures = partial(_housing_figures, hot=1.0)
    return RacewayInFit("outer ring in its housing", ready, azimuths, figures)


def in_housing(case: Case | FastCase) -> "Fit":
    """How housing and outer ring of a case hold each other, hot and turning."""
    from fem.joint.preloaded_fit import Fit

    interference = case.housing_interference
    assert interference is not None  # or the ring would be bonded
    ring, housing = (getattr(material(case, part), "density", None) for part in ("outer_ring", "housing"))
    return Fit(
        interference=interference,
        friction=0.0,
        thermal_strains=(hot_over_cold(case, "outer_ring") - 1, hot_over_cold(case, "housing") - 1),
        densities=(ring or 0.0, housing or 0.0),  # of what turns it is known, checked on reading
        speed=case.operation.outer_speed,
    )


def _shaft_fit_figures(fit: "PreloadedFit", loaded: "LoadedFit | None") -> dict[str, object]:
    figures: dict[str, object] = {
        "mean_pressure_unloaded_MPa": 1e-6 * fit.mean_pressure,
        "raceway_growth_um": 1e6 * mean_growth(fit, 1 + fit.fit.thermal_strains[0]),
    }
    if loaded is not None:
        figures |= {
            "mean_pressure_MPa": 1e-6 * loaded.mean_pressure,
            "largest_pressure_MPa": 1e-6 * float(loaded.pressure.max()),
            "open_share": loaded.opened,
            "slipping_share": loaded.slipping,
        }
    return {"fit": figures}


def _housing_figures(fit: "PreloadedFit", loaded: "LoadedFit | None", hot: float) -> dict[str, object]:
    """Of a ring whose mesh is `hot` over cold."""
    figures: dict[str, object] = {
        "mean_gap_unloaded_um": 1e6 * float(fit.gap.mean()),
        "mean_pressure_unloaded_MPa": 1e-6 * fit.mean_pressure,
        "raceway_growth_um": 1e6 * mean_growth(fit, hot),
    }
    if loaded is not None:
        figures |= {
            "touching_angle_deg": float(np.degrees(loaded.touching_angle)),
            "open_share": loaded.opened,
            "mean_pressure_MPa": 1e-6 * loaded.mean_pressure,
            "largest_pressure_MPa": 1e-6 * float(loaded.pressure.max()),
            "largest_gap_um": 1e6 * float(loaded.gap.max()),
        }
    return {"housing": figures}
