r"""Contact with Coulomb friction at the faces of a fit, by a semismooth Newton method.

With the gap g and the force of pressure p, the slip s and the force of friction t at every point,

.. math:: g \ge 0,\ p \ge 0,\ p g = 0; \qquad |t| \le \mu p,\ t = -\mu p\,s/|s| \text{ where } s \ne 0

The law holds for the whole slip, not for its rate: one load step away from a known state. Points switch
between open, stick and slip. There the equations have kinks; between them they are smooth.

Source
------
Alart, Curnier (1991), Comput. Methods Appl. Mech. Eng. 92, 353: contact and friction as one equation
without inequalities, solved by a generalised Newton method.
"""

import logging
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.errors import NotSolved
from fem.joint.interface_stiffness import InterfaceStiffness

TOLERANCE = 1e-11  # residual over the largest force at a point, with jumps or without
RIGID = 1e-9  # stiffness over the largest, below which a slip is a rigid one
LIMIT = 40  # steps; a dozen is usual
SHORTEST = 2.0**-12  # part of a Newton step
DECREASE = 1e-4  # of the residual, per part of a step taken

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class InterfaceState:
    """Forces and jumps at P azimuths times A points in D directions, pressure first."""

    jump: NDArray  # (P, A, D) gap and slip [m]
    forces: NDArray  # (P, A, D) per radian on the ring [N]
    pull: NDArray  # (P, A) p - c g [N]: what is beyond zero presses
    drag: NDArray  # (P, A, D - 1) t - c s [N]: what is beyond the limit slips
    limit: NDArray  # (P, A) mu times what presses [N]

    @property
    def open(self) -> NDArray:
        """Points without pressure (P, A)."""
        return self.pull <= 0

    @cached_property
    def slip(self) -> NDArray:
        """Points that slip under pressure (P, A)."""
        return ~self.open & (np.linalg.norm(self.drag, axis=-1) > self.limit)

    @cached_property
    def drag_size(self) -> NDArray:
        """Norm of the drag (P, A) [N], one where there is no slip."""
        return np.where(self.slip, np.linalg.norm(self.drag, axis=-1), 1.0)

    @cached_property
    def residual(self) -> NDArray:
        r"""What vanishes in contact with friction (P, A, D) [N].

        .. math:: p - \max(0, p - c g), \qquad t - \Pi(t - c s)

        with the projection on the disc of radius :math:`\mu \max(0, p - c g)`.
        """
        shrink = np.where(self.slip, np.where(self.slip, self.limit, 0.0) / self.drag_size, ~self.open)
        residual = self.forces.copy()
        residual[..., 0] -= np.maximum(self.pull, 0.0)
        residual[..., 1:] -= shrink[..., None] * self.drag
        return residual


@dataclass(frozen=True)
class ContactEquations:
    """Equations of contact with friction at an interface."""

    interface: InterfaceStiffness
    friction: float  # mu, >= 0; infinite where nothing slips
    offset: NDArray  # (P, A, D) forces per radian on the ring without gaps or slip [N]

    @cached_property
    def weight(self) -> NDArray:
        """Stiffness c (A,) [N/m] of a point against its own motion, which weighs jumps against forces."""
        return np.diagonal(self.interface.blocks[0]).reshape(-1, self.interface.directions).mean(axis=1)

    def at(self, jump: NDArray) -> InterfaceState:
        """Forces that go with gaps and slips (P, A, D) [m]."""
        forces = self._linear(jump) + self.offset
        pull = forces[..., 0] - self.weight * jump[..., 0]
        drag = forces[..., 1:] - self.weight[:, None] * jump[..., 1:]
        limit = np.multiply(self.friction, pull, where=pull > 0, out=np.zeros_like(pull))
        return InterfaceState(jump, forces, pull, drag, limit)

    def error(self, state: InterfaceState) -> float:
        """Largest residual over the largest force, with or without jumps [-]."""
        size = max(np.abs(self.offset).max(), np.abs(state.forces).max())
        return float(np.abs(state.residual).max() / (size or 1.0))

    def step(self, state: InterfaceState) -> NDArray:
        """Newton step (P, A, D) [m]."""
        known = np.where(self._unknown(state), 0.0, -state.jump)
        return self._answer(state, -state.residual, known)

    def slid(self, gap: NDArray, pressure: NDArray, away: NDArray) -> NDArray:
        """Jump (P, A, 3) [m] of given gaps where no tangential force acts, and no pressure where `away` (A,).

        Motions that this leaves free make the mean slip zero, weighed by pressure, or bring the nearest of
        the points that are away in touch.
        """
        S, slides = self.interface.stiffness, np.repeat(away, 3) | (np.arange(3 * away.size) % 3 > 0)
        compliance = np.linalg.pinv(S[:, slides][:, :, slides], rcond=RIGID, hermitian=True)
        jump = np.zeros((*gap.shape, 3))
        jump[..., 0] = np.where(away, 0.0, gap)
        pull = np.fft.rfft((self._linear(jump) + self.offset).reshape(len(gap), -1)[:, slides], axis=0)
        jump.reshape(len(gap), -1)[:, slides] = np.fft.irfft(
            -np.einsum("nkl,nl->nk", compliance, pull), n=len(gap), axis=0
        )
        common = np.einsum("pa,pat->t", pressure / pressure.sum(), jump[..., 1:])
        jump[..., 2] -= common[1]
        axial = -common[0] if not away.any() else jump[:, away, 0].min()
        jump[:, ~away, 1] += axial
        jump[:, away, 0] -= axial
        return jump

    def tangent(self, state: InterfaceState, forces: NDArray) -> NDArray:
        """Change of the jump (K, P, A, D) [m] with K changes of `offset` (K, P, A, D) [N].

        At a kink, that of the side that `state` rests on.
        """
        of_force, _ = self._slopes(state)
        return self._answer(state, -_each(of_force, forces), np.zeros_like(forces))

    def _linear(self, jump: NDArray) -> NDArray:
        return self.interface.forces(jump.reshape(*jump.shape[:-2], -1)).reshape(jump.shape)

    def _unknown(self, state: InterfaceState) -> NDArray:
        """Jumps left to the balance (P, A, D): all at open points, slip at slipping ones."""
        free = np.repeat(state.open[..., None], self.interface.directions, axis=-1)
        free[..., 1:] |= state.slip[..., None]
        return free

    def _slopes(self, state: InterfaceState) -> tuple[NDArray, NDArray]:
        r"""Slopes (P, A, D, D) of the residual at a point by its force and, beyond that, by its jump.

        Where a point slips along e, from :math:`t - \mu (p - c g) e` with e the direction of t - c s:

        .. math:: \delta t - \mu e (\delta p - c\,\delta g)
                  - \frac{\mu (p - c g)}{|t - c s|} (1 - e e^T)(\delta t - c\,\delta s)
        """
        D = self.interface.directions
        slip = state.slip[..., None, None]
        along = np.where(slip[..., 0], state.drag / state.drag_size[..., None], 0.0)
        ratio = np.where(state.slip, state.limit, 0.0) / state.drag_size
        across = ratio[..., None, None] * (np.eye(D - 1) - along[..., :, None] * along[..., None, :])
        by_pressure = np.where(slip[..., 0], self.friction, 0.0) * along
        of_force = np.zeros((*state.open.shape, D, D)) + np.eye(D)
        of_force[..., 1:, 0] = -by_pressure
        of_force[..., 1:, 1:] -= across
        of_jump = np.zeros_like(of_force)
        of_jump[..., 1:, 0] = self.weight[:, None] * by_pressure
        of_jump[..., 1:, 1:] = self.weight[:, None, None] * across
        return of_force, of_jump

    def _answer(self, state: InterfaceState, residual: NDArray, known: NDArray) -> NDArray:
        """Changes of the jumps, some known, that change the residual by a given amount (..., P, A, D)."""
        unknown = self._unknown(state).ravel()
        if not unknown.any():
            return known
        of_force, of_jump = self._slopes(state)
        target = residual - _each(of_force, self._linear(known)) - _each(of_jump, known)
        sides = target.reshape(-1, unknown.size)[:, unknown]
        change = known.reshape(-1, unknown.size).copy()
        change[:, unknown] = np.linalg.solve(self._matrix(unknown, of_force, of_jump), sides.T).T
        return change.reshape(known.shape)

    def _matrix(self, unknown: NDArray, of_force: NDArray, of_jump: NDArray) -> NDArray:
        """Slopes of the residual at the unknown jumps by these (unknowns, unknowns)."""
        P, A, D = of_force.shape[:3]
        column = np.flatnonzero(unknown)
        point = np.unique(column // D)
        row = (point[:, None] * D + np.arange(D)).ravel()
        stiffness = self.interface.blocks[
            (row[:, None] // (A * D) - column // (A * D)) % P, row[:, None] % (A * D), column % (A * D)
        ]
        slopes = of_force.reshape(-1, D, D)[point] @ stiffness.reshape(point.size, D, column.size)
        slopes = slopes.reshape(row.size, -1)
        same_point = np.searchsorted(point, column // D)[:, None] * D + np.arange(D)  # rows by column
        slopes[same_point, np.arange(column.size)[:, None]] += of_jump.reshape(-1, D, D)[
            column // D, :, column % D
        ]
        return slopes[unknown[row]]


def solve_contact(contact: ContactEquations, start: NDArray) -> tuple[InterfaceState, int]:
    """Solve for contact with friction, to a residual below `TOLERANCE`; also the number of Newton steps.

    `start` are gaps and slips (P, A, D) of a similar case, or zeros [m].
    Raises `NotSolved` if a matrix is singular, because the ring is loose, or if `LIMIT` steps do not suffice.

    Valid
    -----
    With friction there may be no solution or several; this is one. Without, it is the only one.
    """
    state = contact.at(start)
    for steps in range(LIMIT):
        error = contact.error(state)
        if error <= TOLERANCE:
            _log.debug("fit: %d Newton steps, residual %.1e", steps, error)
            return state, steps
        try:
            step = contact.step(state)
        except np.linalg.LinAlgError as problem:
            raise NotSolved(f"nothing holds the ring in its fit: {problem} after {steps} steps") from problem
        state = _line_search(contact, state, step)
    raise NotSolved(
        f"contact of ring and mate: residual {contact.error(state):.2g} after {LIMIT} Newton steps, "
        f"allowed {TOLERANCE:g}; {state.open.mean():.0%} open, {state.slip.mean():.0%} slip"
    )


def _line_search(contact: ContactEquations, state: InterfaceState, step: NDArray) -> InterfaceState:
    """The first halved step that lowers the residual, else the shortest: Newton steps cross kinks."""
    size, part = np.linalg.norm(state.residual), 1.0
    while True:
        after = contact.at(state.jump + part * step)
        if np.linalg.norm(after.residual) <= (1 - DECREASE * part) * size or part <= SHORTEST:
            return after
        part /= 2


def _each(matrices: NDArray, vectors: NDArray) -> NDArray:
    """One matrix per point (P, A, D, D) times vectors (..., P, A, D)."""
    return np.einsum("paij,...paj->...pai", matrices, vectors)
