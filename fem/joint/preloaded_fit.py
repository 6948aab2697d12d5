"""A ring settled in its fit by interference, heat, speed and a nut, before rollers load it.

The fit settles without friction, so that Coulomb's law starts from there.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from fem.joint.fitted_ring import BORE, SHOULDER, FittedBodies
from fem.joint.interface_stiffness import InterfaceStiffness, interface_stiffness
from fem.joint.semismooth_newton import ContactEquations, solve_contact
from fem.parts.material import ImpossiblePart
from fem.raceway.harmonics import HarmonicCompliance


@dataclass(frozen=True, kw_only=True)
class Fit:
    """How ring and mate, that is shaft or housing, hold each other while they run."""

    interference: float  # [m] diametral, cold and at rest; negative is a clearance
    friction: float  # mu [-] in bore and shoulder; infinite where nothing may slip
    bonded: bool = False  # as if glued once settled: nothing opens or slips any more
    clamping: float = (
        0.0  # [N] with which a nut presses the far face of the ring, so that the shoulder holds it
    )
    thermal_strains: tuple[float, float] = (0.0, 0.0)  # alpha (T - T0) of ring, mate [-]
    densities: tuple[float, float] = (0.0, 0.0)  # rho of ring, mate [kg/m^3]
    speed: float = 0.0  # [rad/s]

    def __post_init__(self):
        if not self.friction >= 0:
            raise ImpossiblePart(f"friction = {self.friction!r} is impossible; allowed is 0 or more")
        if not (isfinite(self.clamping) and self.clamping >= 0):
            raise ImpossiblePart(f"clamping = {self.clamping!r} N is impossible; allowed is a finite push")
        if not isfinite(self.interference):
            raise ImpossiblePart(f"interference = {self.interference!r} m is impossible; allowed is finite")


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

    @cached_property
    def joint(self) -> InterfaceStiffness:
        """Ring and mate joined where they can carry forces.

        Without friction or a nut nothing balances pressure on the shoulder.
        """
        fit, shoulder = self.fit, self.bodies.ring.points.face == SHOULDER
        tangential = bool(fit.friction or fit.bonded)
        return self._joined(~shoulder | tangential | bool(fit.clamping), tangential)

    @cached_property
    def sliding(self) -> InterfaceStiffness:
        """Ring and mate joined by pressure alone."""
        shoulder = self.bodies.ring.points.face == SHOULDER
        return self._joined(~shoulder | bool(self.fit.clamping), False)

    @cached_property
    def closed(self) -> HarmonicCompliance:
        """Compliance of the raceway where no point opens or slips."""
        W = self.joint.bonded / (2 * np.pi)
        last, bodies, seat = len(W) - 1, self.bodies, self.bodies.part.seat
        return HarmonicCompliance(
            harmonics=np.arange(-last, last + 1),
            response=np.concatenate([W[:0:-1], W]),
            radius=seat.raceway_diameter / 2,
            length=bodies.length,
            elastic=seat.materials["ring"],
            bars=None,
            unknowns=bodies.ring.unknowns + bodies.mate.unknowns,
            elements=bodies.ring.elements + bodies.mate.elements,
            seconds=bodies.seconds,
        )

    def rest(self, joint: InterfaceStiffness) -> NDArray:
        """Jump of a joint without rollers (P, A, D) [m]: gaps, no slip."""
        jump = np.zeros((joint.azimuths.size, joint.points.x.size, joint.directions))
        jump[..., 0] = self.gap[joint.carries]
        return jump

    def contact(self, joint: InterfaceStiffness, loads: NDArray) -> ContactEquations:
        """Contact of a joint under harmonics of raceway loads (N + 1, M) [N/rad]."""
        rest = self.rest(joint)
        offset = joint.forces_of_raceway(loads) - joint.forces(rest.reshape(len(rest), -1))
        offset = offset.reshape(rest.shape)
        offset[..., 0] += self.force[joint.carries]
        return ContactEquations(joint, self.fit.friction, offset)

    def _joined(self, carries: NDArray, tangential: bool) -> InterfaceStiffness:
        return interface_stiffness(self.bodies.ring, self.bodies.mate, carries, tangential)


def preloaded(bodies: FittedBodies, fit: Fit) -> PreloadedFit:
    """Let a ring settle on its shaft or in its housing.

    Parameters
    ----------
    bodies : FittedBodies
        condensed ring and mate
    fit : Fit
        interference with what changes it

    Returns
    -------
    PreloadedFit

    Raises
    ------
    ImpossiblePart
        if a nut presses the ring on no shoulder
    NotSolved
        if contact is not found
    """
    shoulder = bodies.ring.points.face == SHOULDER
    if fit.clamping and not shoulder.any():
        raise ImpossiblePart(f"clamping = {fit.clamping!r} N needs a shoulder, and shoulder_diameter is None")
    apart = _growth_apart(bodies, fit) - np.where(shoulder, 0.0, fit.interference / 2)
    joint = interface_stiffness(bodies.ring, bodies.mate, ~shoulder | bool(fit.clamping), tangential=False)
    even = replace(joint, stiffness=joint.stiffness[:1])  # harmonic 0, on one azimuth
    offset = fit.clamping * joint.push - even.forces(apart[None, joint.carries])[0]
    contact = ContactEquations(even, 0.0, offset[None, :, None])
    state, _ = solve_contact(contact, np.zeros_like(contact.offset))
    force, gap = np.zeros_like(apart), np.zeros_like(apart)
    force[joint.carries] = np.where(state.open, 0.0, state.forces[..., 0])[0]
    gap[joint.carries] = state.jump[0, :, 0]
    if not joint.carries.all():
        away = (apart + _yield_apart(bodies, force))[shoulder]
        gap[shoulder] = away - away.min()  # put against the shoulder, without force
    return PreloadedFit(bodies, fit, force, gap)


def _growth_apart(bodies: FittedBodies, fit: Fit) -> NDArray:
    """How far free growth takes ring and mate apart (A,) [m]."""
    grown = [
        body.axisymmetric[: 3 * body.points.x.size : 3]
        @ np.array([expansion, density * fit.speed**2, 0.0, 1.0])
        for body, expansion, density in zip(
            (bodies.ring, bodies.mate), fit.thermal_strains, fit.densities, strict=True
        )
    ]
    return grown[0] - grown[1]


def _yield_apart(bodies: FittedBodies, force: NDArray) -> NDArray:
    """How far pressure takes ring and mate apart (A,) [m], besides motions of the ring."""
    normal = slice(0, 3 * force.size, 3)
    return (bodies.ring.compliance[0, normal, normal] + bodies.mate.compliance[0, normal, normal]) @ force
