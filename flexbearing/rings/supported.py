"""Rings on lines or springs that they may lift off, so that their raceways are not linear."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from fem.errors import NotSolved
from flexbearing.coupling import PartnerFailed
from flexbearing.coupling.raceway_pair import linear_answer, radial
from flexbearing.rings.raceways import compliance_figures

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance
    from fem.section.ring_on_foundation import RollersOnFoundation
    from fem.section.ring_on_lines import RollersOnLines
    from flexbearing.case.roller import Case

RINGS = {"lines": "outer ring on its lines", "foundation": "outer ring on its foundation"}
ADVICE = "give lines on both sides of the load, or outer.bilateral = true where they can pull"
BARELY = 1e-6  # of the largest line force: a line below it touches without carrying


@dataclass
class SupportedRaceway:
    """The raceway of a ring on supports that push, and pull only where the case says so.

    It keeps its last forces, of which its figures speak.
    """

    name: str  # for messages
    ring: "RollersOnLines | RollersOnFoundation"
    support_figures: Callable[[Any, NDArray], dict[str, object]]  # for the result file
    at: Callable[[NDArray], Any] = field(repr=False)  # the ring under rollers at other azimuths
    from_ground: bool = False  # places count from there, as those of grooves; else from their mean one
    last: NDArray | None = field(default=None, repr=False)
    rigid = False
    solved_in_full = False

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z) [rad]."""
        return self.ring.azimuths

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N].

        Raises `PartnerFailed` when the supports cannot hold the ring.
        """
        return linear_answer(self.linearised(outward), outward)

    def linearised(self, outward: NDArray) -> "RacewayCompliance":
        """The raceway near outward forces (Z, M) [N], exact as long as the supports touch where they do."""
        self.last = outward
        with self._named_failure():
            near = self.ring.near(outward)
        if not self.from_ground:
            return near
        return replace(near, translation=np.zeros_like(near.translation), support_stiffness=np.inf)

    def under(self, azimuths: NDArray) -> "SupportedRaceway":
        """The same raceway under rollers at other azimuths (Z) [rad]; raises `PartnerFailed`."""
        with self._named_failure():
            return replace(self, ring=self.at(azimuths).with_axial_modes(self.ring.axial_modes), last=None)

    def figures(self) -> dict[str, object]:
        """What finite elements and supports say of the last forces."""
        assert self.last is not None  # figures are those of a state
        compliance = self.linearised(self.last)
        with self._named_failure():
            return compliance_figures(compliance) | self.support_figures(self.ring, self.last)

    def with_axial_modes(self, count: int) -> "SupportedRaceway":
        """The same raceway for rollers that exchange fewer axial modes with it."""
        return replace(self, ring=self.ring.with_axial_modes(count), last=None)

    @contextmanager
    def _named_failure(self) -> Iterator[None]:
        try:
            yield
        except NotSolved as problem:
            raise PartnerFailed(f"{self.name}: {problem}; {ADVICE}", "not solved") from problem


def is_on_supports(case: "Case") -> bool:
    """Whether the outer ring is on lines or radial springs, whose forces are reported."""
    outer = case.outer
    return outer.kind == "ring" and (
        outer.support == "lines" or (outer.support == "foundation" and outer.foundation_radial > 0)
    )


def line_figures(ring: "RollersOnLines", outward: NDArray) -> dict[str, object]:
    """Force and state of every line under outward roller forces."""
    ends, azimuths = ring.line_forces(outward), ring.line_azimuths
    force = ends.sum(axis=1)
    touches = np.abs(ends).max(axis=1) > BARELY * max(np.abs(ends).max(), np.finfo(float).tiny)
    return {
        "lines": {
            "pull": not ring.pushing,
            "azimuth_deg": np.degrees(azimuths).tolist(),
            "force_N": force.tolist(),
            "end_forces_N": ends.tolist(),
            "carries": touches.tolist(),
            "resultant_N": _resultant(azimuths, force),
            "rollers_N": (outward.ravel() @ ring.points.load_motions[:, :2]).tolist(),
        }
    }


def foundation_figures(ring: "RollersOnFoundation", outward: NDArray) -> dict[str, object]:
    """Pressure of the springs on the outer surface under outward roller forces."""
    pressure = ring.pressure(outward)
    degrees = np.degrees(ring.around)
    place = np.unravel_index(pressure.argmax(), pressure.shape)
    force = (pressure * ring.area).sum(axis=1)
    return {
        "foundation": {
            "pull": not ring.pushing,
            "largest_pressure_MPa": 1e-6 * float(pressure.max()),
            "azimuth_deg": float(degrees[place[0]]),
            "x_mm": 1e3 * float(ring.x[place[1]]),
            "least_pressure_MPa": 1e-6 * float(pressure.min()),
            "open_share": float(np.average((pressure <= 0).mean(axis=0), weights=ring.area)),
            "touching_deg": _arcs(degrees, pressure.max(axis=1) > 0),
            "resultant_N": _resultant(ring.around, force),
            "rollers_N": _resultant(ring.azimuths, outward @ ring.reading),
            "azimuths_deg": degrees.tolist(),
            "width_mm": (1e3 * ring.x).tolist(),
            "pressure_MPa": (1e-6 * pressure).tolist(),
        }
    }


def _resultant(azimuths: NDArray, radial_forces: NDArray) -> list[float]:
    """Along y and z [N] of radial forces."""
    return radial(azimuths, np.eye(2)).T.dot(radial_forces).tolist()


def _arcs(degrees: NDArray, touching: NDArray) -> list[list[float]]:
    """First and last azimuth of every arc that touches, one that passes 360 degrees ends beyond."""
    if touching.all() or not touching.any():
        return [[0.0, 360.0]] if touching.all() else []
    begins = np.flatnonzero(touching & ~np.roll(touching, 1))
    ends = np.flatnonzero(touching & ~np.roll(touching, -1))
    arcs = []
    for begin in begins:
        later = ends[ends >= begin]
        arcs.append([degrees[begin], degrees[later[0]] if later.size else degrees[ends[0]] + 360.0])
    return [[float(a), float(b)] for a, b in arcs]


FIGURES = {"lines": line_figures, "foundation": foundation_figures}
