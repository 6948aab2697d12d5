"""A fit preloaded by interference, heat, speed and a nut, before rollers load it.

It is preloaded without friction; Coulomb's law starts from there.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import ceil, isfinite

import numpy as np
from numpy.typing import NDArray

from fem.errors import NotSolved
from fem.joint.fitted_ring import (
    BORE,
    SHOULDER,
    FitGrid,
    FittedBodies,
    FittedRing,
    HousedRing,
    condense_fitted,
)  # fmt: skip
from fem.joint.interface_stiffness import InterfaceStiffness, interface_stiffness
from fem.joint.semismooth_newton import ContactEquations, solve_contact
from fem.parts.groove import Groove
from fem.parts.material import ImpossiblePart, in_mm, require
from fem.parts.resolution import Resolution
from fem.parts.rings import OuterRing
from fem.raceway.harmonics import DOUBLINGS, HarmonicCompliance, Responses, with_enough_harmonics
from fem.section.expansion import Along
from fem.section.raceway_shapes import Raceway, raceway_compliance

BELOW = 3.0  # harmonics of a fit over R/t below a groove: 6 change loads by 4e-5, the largest pressure by 4 %


@dataclass(frozen=True, kw_only=True)
class Fit:
    """How ring and mate, that is shaft or housing, hold each other while they run."""

    interference: float  # [m] diametral, cold and at rest; negative is a clearance
    friction: float  # mu [-] in bore and shoulder; infinite where nothing may slip
    bonded: bool = False  # glued once preloaded: nothing opens or slips any more
    clamping: float = 0.0  # [N] of a nut on the far face of the ring, which presses it on the shoulder
    thermal_strains: tuple[float, float] = (0.0, 0.0)  # alpha (T - T0) of ring, mate [-]
    densities: tuple[float, float] = (0.0, 0.0)  # rho of ring, mate [kg/m^3]
    speed: float = 0.0  # [rad/s]

    def __post_init__(self):
        require(self.friction >= 0, "friction", self.friction, "zero or above")
        require(isfinite(self.clamping) and self.clamping >= 0, "clamping", self.clamping,
                "a finite force [N], zero or above")  # fmt: skip
        require(isfinite(self.interference), "interference", self.interference, "finite [m]")


@dataclass(frozen=True)
class PreloadedFit:
    """Ring with its mate, A points along their faces."""

    bodies: FittedBodies
    fit: Fit
    force: NDArray  # (A,) of pressure, per radian [N]
    gap: NDArray  # (A,) [m]

    @property
    def pressure(self) -> NDArray:
        """Pressure (A,) [Pa]."""
        return self.force / self.bodies.ring.points.weight

    @property
    def mean_pressure(self) -> float:
        """Mean over the bore [Pa]."""
        points = self.bodies.ring.points
        bore = points.face == BORE
        return float(self.force[bore].sum() / points.weight[bore].sum())

    @property
    def expansion(self) -> NDArray:
        """Expansion of the raceway (M,) [m] outward by heat, rotation and fit; see `section.expansion`."""
        ring, fit = self.bodies.ring, self.fit
        L = 3 * self.force.size
        loads = np.array([fit.thermal_strains[0], fit.densities[0] * fit.speed**2, fit.clamping, 1.0])
        return ring.axisymmetric[L:] @ loads + ring.compliance[0, L:, :L:3] @ self.force

    @property
    def reading(self) -> NDArray:
        """What shapes of the raceway read of a translation towards them (M,) [-]."""
        return self.bodies.ring.motions[1, 3 * self.force.size :, 0]

    @property
    def growth(self) -> float:
        """Mean radial part of the expansion [m], which belongs to the operating clearance."""
        return float(self.reading @ self.expansion / (self.reading @ self.reading))

    @property
    def shape(self) -> NDArray:
        """What the expansion (M,) [m] has beyond its mean."""
        return self.expansion - self.growth * self.reading

    @cached_property
    def interface(self) -> InterfaceStiffness:
        """Ring and mate joined where they can carry forces.

        Without friction or a nut nothing balances pressure on the shoulder.
        """
        fit, shoulder = self.fit, self.bodies.ring.points.face == SHOULDER
        tangential = bool(fit.friction or fit.bonded)
        carries = ~shoulder | tangential | bool(fit.clamping)
        return interface_stiffness(self.bodies.ring, self.bodies.mate, carries, tangential)

    @cached_property
    def frictionless(self) -> InterfaceStiffness:
        """Ring and mate joined by pressure alone."""
        return interface_stiffness(
            self.bodies.ring, self.bodies.mate, _carries_pressure(self.bodies, self.fit), tangential=False
        )

    @cached_property
    def closed(self) -> Raceway:
        """Compliance of the raceway where no point opens or slips."""
        bodies = self.bodies
        answers = Responses(
            self.interface.bonded / (2 * np.pi),
            bodies.ring.unknowns + bodies.mate.unknowns,
            bodies.ring.elements + bodies.mate.elements,
        )
        return raceway_compliance(bodies.part.seat, bodies.resolution, answers, bodies.seconds)

    def unloaded_jump(self, interface: InterfaceStiffness) -> NDArray:
        """Jump without rollers (P, A, D) [m]: gaps, no slip."""
        jump = np.zeros((interface.azimuths.size, interface.points.x.size, interface.directions))
        jump[..., 0] = self.gap[interface.carries]
        return jump

    def contact(self, interface: InterfaceStiffness, loads: NDArray) -> ContactEquations:
        """Contact at an interface under harmonics of raceway loads (N + 1, M) [N/rad]."""
        unloaded = self.unloaded_jump(interface)
        offset = interface.forces_of_raceway(loads) - interface.forces(unloaded.reshape(len(unloaded), -1))
        offset = offset.reshape(unloaded.shape)
        offset[..., 0] += self.force[interface.carries]
        return ContactEquations(interface, self.fit.friction, offset)


def fitted(
    part: FittedRing | HousedRing,
    resolution: Resolution,
    fit: Fit,
    variations: Mapping[str, Along] | None = None,
) -> PreloadedFit:
    """Condense ring and mate as `condense_fitted` and put them together as `preloaded`.

    A thin ring bends between the azimuths of a coarse grid: its harmonics are doubled until they are enough,
    or are as many as what is left of it below a groove needs.
    """
    seat, along = part.seat, tuple((variations or {}).items())

    def condensed(resolution: Resolution, last: int) -> PreloadedFit:
        ready = preloaded(_bodies(part, resolution, last, along), fit)
        if isinstance(ready.closed, HarmonicCompliance):
            ready.closed.require_enough()
        return ready

    if isinstance(seat, OuterRing) and seat.groove:
        return condensed(resolution, _harmonics_below(seat, seat.groove))
    return with_enough_harmonics(condensed, resolution, seat.raceway_diameter / 2, FitGrid().harmonics)


@lru_cache(maxsize=4)  # of cases that differ by their fits
def _bodies(
    part: FittedRing | HousedRing, resolution: Resolution, last: int, along: tuple[tuple[str, Along], ...]
) -> FittedBodies:
    return condense_fitted(part, resolution, FitGrid(harmonics=last), dict(along))


def _harmonics_below(seat: OuterRing, groove: Groove) -> int:
    """Harmonics that the thickness below a groove resolves, as the usual ones or more."""
    outside, usual = seat.raceway_diameter / 2 + seat.thickness, FitGrid().harmonics
    below, most = outside - groove.bottom(1), usual * 2**DOUBLINGS
    needed = max(usual, ceil(BELOW * outside / below))
    if needed > most:
        raise NotSolved(
            f"a fit of a ring of {in_mm(below)} below its groove needs {needed} harmonics, allowed are {most}"
        )
    return needed


def preloaded(bodies: FittedBodies, fit: Fit) -> PreloadedFit:
    """Put a ring on its shaft or in its housing, without rollers and without friction.

    Raises `ImpossiblePart` if a nut presses the ring on no shoulder, `NotSolved` if contact is not found.
    """
    shoulder = bodies.ring.points.face == SHOULDER
    if fit.clamping and not shoulder.any():
        raise ImpossiblePart(f"clamping = {fit.clamping!r} N needs a shoulder, and shoulder_diameter is None")
    clearance = _clearance_by_expansion(bodies, fit) - np.where(shoulder, 0.0, fit.interference / 2)
    carries = _carries_pressure(bodies, fit)
    interface = interface_stiffness(bodies.ring, bodies.mate, carries, tangential=False)
    axisymmetric = replace(interface, stiffness=interface.stiffness[:1])  # harmonic 0, on one azimuth
    offset = fit.clamping * interface.push - axisymmetric.forces(clearance[None, carries])[0]
    contact = ContactEquations(axisymmetric, 0.0, offset[None, :, None])
    state, _ = solve_contact(contact, np.zeros_like(contact.offset))
    force, gap = np.zeros_like(clearance), np.zeros_like(clearance)
    force[carries] = np.where(state.open, 0.0, state.forces[..., 0])[0]
    gap[carries] = state.jump[0, :, 0]
    if not carries.all():
        normal = slice(0, 3 * force.size, 3)
        compliance = bodies.ring.compliance[0, normal, normal] + bodies.mate.compliance[0, normal, normal]
        distance = (clearance + compliance @ force)[shoulder]
        gap[shoulder] = distance - distance.min()  # put against the shoulder, without force
    return PreloadedFit(bodies, fit, force, gap)


def _carries_pressure(bodies: FittedBodies, fit: Fit) -> NDArray:
    """Points (A,) that can be pressed without friction: the shoulder only where a nut holds the ring."""
    return (bodies.ring.points.face != SHOULDER) | bool(fit.clamping)


def _clearance_by_expansion(bodies: FittedBodies, fit: Fit) -> NDArray:
    """Clearance (A,) [m] that free expansion of ring and mate by heat and rotation opens."""
    of_ring, of_mate = (
        body.axisymmetric[: 3 * body.points.x.size : 3] @ np.array([strain, density * fit.speed**2, 0.0, 1.0])
        for body, strain, density in zip(
            (bodies.ring, bodies.mate), fit.thermal_strains, fit.densities, strict=True
        )
    )
    return of_ring - of_mate
