"""A fit under rollers: how the raceway deflects, with the forces between ring and mate.

Rollers load the preloaded fit in one step: Coulomb's law holds for the whole slip since then.
"""

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.errors import NotSolved
from fem.joint.fitted_ring import BORE
from fem.joint.interface_stiffness import InterfaceStiffness
from fem.joint.interior_point import frictionless_start
from fem.joint.preloaded_fit import PreloadedFit
from fem.joint.semismooth_newton import ContactEquations, InterfaceState, solve_contact
from fem.raceway.compliance import RacewayCompliance

LEAST_INCREMENT = 1e-3  # part of the friction added at once
BALANCED = 1e-9  # resultant of the rollers over the sum of their forces, below which it has no direction


@dataclass(frozen=True, kw_only=True)
class LoadedFit:
    """Raceway and fit under Z rollers of M axial modes; P azimuths of A points along the faces.

    In a bonded fit the same names say where it would open or slip first.
    """

    deviation: NDArray  # (Z, M) [m] of the raceway, outward, beyond expansion; the half-space removed
    translation: NDArray  # (2,) [m] mean of the raceway along y, z
    contact: InterfaceState  # its `jump` is a start for similar cases
    steps: int  # of Newton's method
    preloaded: PreloadedFit
    equations: ContactEquations
    closed: RacewayCompliance  # where no point opens or slips
    phases: NDArray  # (Z, N + 1, M) exp(-i n phi) / 2 pi of the rollers, as their shapes fade

    @property
    def interface(self) -> InterfaceStiffness:
        """Its `azimuths` and `points` are those of the arrays here."""
        return self.equations.interface

    @cached_property
    def tangent(self) -> RacewayCompliance:
        """Compliance to small changes of the forces; not symmetric where points slip.

        At a kink, that of one side.
        """
        moved, by_opening = self._moved_by_rollers()
        support, (Z, M) = 2 / self.closed.support_stiffness + by_opening, self.deviation.shape
        by_contact = _at_rollers(moved, self.phases).reshape(Z, M, Z, M).transpose(2, 3, 0, 1)
        return replace(
            self.closed,
            absolute=self.closed.absolute + by_contact,
            translation=self.closed.translation + _translation(moved, self.closed).reshape(2, Z, M),
            support_stiffness=2 / support if support else np.inf,
        )

    def _moved_by_rollers(self) -> tuple[NDArray, float]:
        """Raceway harmonics (Z M, N + 1, M) [m/N] by opening and slip per force; trace for resultants."""
        N, (Z, M) = self.phases.shape[1], self.deviation.shape
        rollers = np.einsum("jnm,mp->jmnp", self.phases, np.eye(M)).reshape(Z * M, N, M)
        if self.preloaded.fit.bonded:
            return np.zeros_like(rollers), 0.0
        resultants = np.zeros((2, N, M), dtype=complex)
        resultants[:, 1, 0] = np.array([-1j, 1.0]) / (2 * np.pi)  # like sin, cos
        forces = self.interface.forces_of_raceway(np.concatenate([rollers, resultants]))
        jumps = self.equations.tangent(self.contact, forces.reshape(-1, *self.contact.jump.shape))
        moved = self.interface.raceway_harmonics(_flat(jumps))
        return moved[:-2], float(np.trace(_translation(moved[-2:], self.closed)))

    @property
    def pressure(self) -> NDArray:
        """Pressure (P, A) [Pa]."""
        return self.contact.forces[..., 0] / self.interface.points.weight

    @property
    def traction(self) -> NDArray:
        """Traction on the ring (P, A, 2) [Pa] along meridian (x in the bore) and circumference."""
        return _tangential(self.contact.forces) / self.interface.points.weight[:, None]

    @property
    def gap(self) -> NDArray:
        """Gap (P, A) [m]."""
        return self.contact.jump[..., 0]

    @property
    def slip(self) -> NDArray:
        """Slip of the ring on its mate since the preload (P, A, 2) [m]; zeros without friction."""
        return _tangential(self.contact.jump)

    @property
    def opened(self) -> float:
        """Part of the area without pressure [-]."""
        return self._area_share(self.contact.open)

    @property
    def touching_angle(self) -> float:
        """Around the axis, where any point of the bore presses [rad]; the azimuths set its resolution."""
        bore = self.interface.points.face == BORE
        return 2 * np.pi * float(np.mean(np.any(~self.contact.open[:, bore], axis=1)))

    @property
    def slipping(self) -> float:
        """Part of the area under pressure that slips [-]."""
        pressed = 1 - self.opened
        return self._area_share(self.contact.slip) / pressed if pressed else 0.0

    @property
    def mean_pressure(self) -> float:
        """Mean over the bore [Pa]."""
        bore = self.interface.points.face == BORE
        return float(np.average(self.pressure.mean(axis=0)[bore], weights=self.interface.points.weight[bore]))

    def _area_share(self, which: NDArray) -> float:
        return float(np.average(which.mean(axis=0), weights=self.interface.points.weight))


def loaded(fit: PreloadedFit, azimuths, forces, start: NDArray | None = None) -> LoadedFit:
    """Load a preloaded fit with rollers at different azimuths (Z,) [rad].

    Generalised forces (Z, M) [N] are as in `fem.assembly.roller_loads`, outward: those of rollers on an inner
    ring are negative. `start` is `contact.jump` (P, A, D) of a similar case.
    Raises `NotSolved` if nothing presses the ring on its mate, or if contact is not found.

    Valid
    -----
    Forces that grow together: slip that would turn back on the way is not followed.
    """
    phi, F = np.asarray(azimuths, dtype=float), np.asarray(forces, dtype=float)
    _require_held(fit, phi, F @ fit.reading)
    interface, closed = fit.interface, fit.closed.at(phi)
    N = len(interface.stiffness)
    waves = np.exp(-1j * np.outer(phi, np.arange(N))) / (2 * np.pi)
    phases = waves[..., None] * fit.closed.fade[:N]
    loads = np.einsum("jnm,jm->nm", phases, F)
    contact = fit.contact(interface, loads)
    state, steps = _contact_state(fit, contact, loads, start)
    moved = interface.raceway_harmonics(_flat(state.jump - fit.unloaded_jump(interface)))
    return LoadedFit(
        deviation=np.tensordot(closed.absolute, F, 2) + _at_rollers(moved, phases),
        translation=np.tensordot(closed.translation, F, 2) + _translation(moved, closed),
        contact=state,
        steps=steps,
        preloaded=fit,
        equations=contact,
        closed=closed,
        phases=phases,
    )


def _require_held(fit: PreloadedFit, phi: NDArray, forces: NDArray) -> None:
    """A loose ring that no resultant presses on its mate has no place."""
    resultant = np.abs(forces @ np.exp(1j * phi))
    if not (fit.fit.bonded or fit.force.any() or resultant > BALANCED * np.abs(forces).sum()):
        raise NotSolved(
            f"nothing holds the ring in its fit: a clearance of {fit.gap.min():.3g} m is left, and the "
            f"rolling elements press with a resultant of {resultant:.3g} N"
        )


def _contact_state(
    fit: PreloadedFit, contact: ContactEquations, loads: NDArray, start: NDArray | None
) -> tuple[InterfaceState, int]:
    """Contact, by way of the one without friction unless there is a start."""
    if fit.fit.bonded:
        return contact.at(fit.unloaded_jump(contact.interface)), 0
    if start is not None:
        with suppress(NotSolved):  # points of a loose ring change too much: from the beginning
            return solve_contact(contact, start)
    frictionless, steps = _frictionless(fit, loads)
    if contact.interface.directions == 1:
        return frictionless, steps
    jump, pressure = fit.unloaded_jump(contact.interface), np.zeros(contact.offset.shape[:2])
    pressed = fit.frictionless.carries[contact.interface.carries]
    jump[:, pressed, 0] = frictionless.jump[..., 0]
    pressure[:, pressed] = np.where(frictionless.open, 0.0, frictionless.forces[..., 0])
    if not fit.force.any():
        jump = contact.slid(jump[..., 0], pressure, ~pressed)
    state, more = _by_growing_friction(contact, jump)
    return state, steps + more


def _by_growing_friction(contact: ContactEquations, jump: NDArray) -> tuple[InterfaceState, int]:
    """Contact with friction, if need be by way of less of it."""
    reached, increment, steps = 0.0, 1.0, 0
    while True:
        try:
            state, more = solve_contact(
                replace(contact, friction=contact.friction * (reached + increment)), jump
            )
        except NotSolved:
            if not (increment > LEAST_INCREMENT and np.isfinite(contact.friction)):
                raise
            increment /= 4
            continue
        reached, jump, steps = reached + increment, state.jump, steps + more
        if reached >= 1:
            return state, steps
        increment = min(2 * increment, 1 - reached)


def _frictionless(fit: PreloadedFit, loads: NDArray) -> tuple[InterfaceState, int]:
    """Contact by pressure alone; a loose ring needs a start that knows where it touches."""
    interface = fit.frictionless
    contact, unloaded = fit.contact(interface, loads), fit.unloaded_jump(interface)
    if fit.force.any():
        return solve_contact(contact, unloaded)
    start = frictionless_start(contact, unloaded, interface.forces_of_raceway(loads))
    return solve_contact(contact, start)


def _at_rollers(harmonics: NDArray, phases: NDArray) -> NDArray:
    """Sum of harmonics 0 .. N (..., N + 1, M) at the rollers (..., Z, M); those below 0 are conjugate."""
    weight = np.where(np.arange(phases.shape[1]) == 0, 1.0, 2.0)
    waves = 2 * np.pi * phases.conj() * weight[:, None]
    return np.real(np.einsum("jnm,...nm->...jm", waves, harmonics, optimize=True))


def _translation(harmonics: NDArray, closed: RacewayCompliance) -> NDArray:
    """Mean translation along y, z (2, ...) of harmonics 0 .. N (..., N + 1, M); none is known of a groove."""
    first = harmonics[..., 1, 0] * np.isfinite(closed.support_stiffness)
    return np.stack([-2 * np.imag(first), 2 * np.real(first)])


def _flat(jump: NDArray) -> NDArray:
    """Points with their directions in one row (..., P, A D)."""
    return jump.reshape(*jump.shape[:-2], -1)


def _tangential(values: NDArray) -> NDArray:
    """Both tangential components (..., 2); zeros where only pressure acts."""
    return values[..., 1:] if values.shape[-1] == 3 else np.zeros((*values.shape[:-1], 2))
