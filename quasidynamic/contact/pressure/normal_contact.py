"""Pressure between elastic half-spaces whose undeformed surfaces are known on a grid."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid, Convolution, ElasticPair, Z, convolution
from quasidynamic.errors import NotSolved, OutOfRange

TOLERANCE = 1e-8  # gap left under pressure, or overlap without, over the overlap of the undeformed surfaces
LOADS = 10.0  # error of the loads that is left over that of the gaps
LIMIT = 60  # Newton steps of the free motions, and sets of cells for each of them; 3 to 10 are usual
STEPS = 500  # of conjugate gradients on one set of cells; 5 to 15 are usual
REDUCTION = 0.01  # of an error at a time: what it depends on is found no better
OVERSHOOT = 0.9  # of the loads missing along a step: at most so much may be left after it, of either sign
UNCERTAIN = 10.0  # error of the loads over that of the gaps that it comes from


@dataclass(frozen=True)
class NormalCompliance:
    """Normal displacement of two half-spaces by the pressure on a grid, with an approximate inverse."""

    grid: CellGrid
    displacement: Convolution  # [m/Pa]
    inverse: Convolution  # [Pa/m] spectrum inverted wave by wave: exact but for the ends of the grid
    images: tuple[Convolution, ...] = ()  # [m/Pa] of the pressure mirrored at the ends of y

    @classmethod
    def of(cls, pair: ElasticPair, grid: CellGrid, mirrored: float = 0.0) -> "NormalCompliance":
        """Compliance of a pair on a grid, with a share of the pressure mirrored at both ends of y."""
        forward = convolution(pair, grid, (Z,), (Z,))
        inverse = Convolution(1 / np.abs(forward.spectrum), forward.padded)
        if not mirrored:
            return cls(grid, forward, inverse)
        length = grid.shape[1] * grid.spacing[1]
        beyond = (convolution(pair, grid, (Z,), (Z,), (0.0, shift)) for shift in (-length, length))
        images = tuple(Convolution(mirrored * each.spectrum, each.padded) for each in beyond)
        return cls(grid, forward, inverse, images)

    @cached_property
    def stiffness(self) -> float:
        """Pressure per displacement of a single cell [Pa/m], the diagonal of the inverse."""
        cell = np.zeros((1, *self.grid.shape))
        cell[0, 0, 0] = 1.0
        return float(self.inverse(cell)[0, 0, 0])

    def displaced(self, pressure: NDArray) -> NDArray:
        """Displacement (nx, ny) [m] by a pressure (nx, ny) [Pa]."""
        image = pressure[None, :, ::-1]
        return self.displacement(pressure[None])[0] + sum(beyond(image)[0] for beyond in self.images)

    def pressed(self, displacement: NDArray) -> NDArray:
        """Pressure (nx, ny) [Pa] that nearly causes a displacement (nx, ny) [m]."""
        return self.inverse(displacement[None])[0]


@dataclass(frozen=True)
class RigidMotions:
    """Motions of one body towards the other that are free, and the loads they answer to.

    A motion that is 1 everywhere is the approach under a given force; y as a second one is the tilt under a
    given moment. Without any, both bodies are held.
    """

    shapes: NDArray  # (m, nx, ny) displacement by an amount of one, [-] or [m]; the first one is >= 0
    loads: NDArray  # (m) integral of pressure times weight, [N] or [N m]
    weights: NDArray | None = None  # (m, nx, ny) like the shapes, which weigh the pressure without them


@dataclass(frozen=True)
class NormalContact:
    """Two bodies pressed together."""

    grid: CellGrid
    pressure: NDArray  # (nx, ny) [Pa] even over each cell, >= 0
    separation: NDArray  # (nx, ny) [m] of the deformed surfaces, zero where there is pressure
    motions: NDArray  # (m) amounts of the free motions, [m] or [-]
    iterations: int  # of conjugate gradients for the pressure

    @property
    def touching(self) -> NDArray:
        """Cells (nx, ny) with pressure."""
        return self.pressure > 0

    @property
    def force(self) -> float:
        """Normal force [N]."""
        return float(self.pressure.sum() * self.grid.cell_area)

    @property
    def peak_pressure(self) -> float:
        """Largest mean pressure of a cell [Pa]."""
        return float(self.pressure.max())

    @property
    def cut(self) -> tuple[tuple[bool, bool], tuple[bool, bool]]:
        """Whether the contact reaches the grid's ends: at -x and +x, at -y and +y."""
        p = self.pressure
        return (bool(p[0].any()), bool(p[-1].any())), (bool(p[:, 0].any()), bool(p[:, -1].any()))


def contact_pressure(
    compliance: NormalCompliance,
    gap: NDArray,
    motions: RigidMotions,
    start: NDArray | None = None,
    tolerance: float = TOLERANCE,
) -> NormalContact:
    r"""Pressure that keeps two elastic bodies from overlapping.

    .. math:: g = h - \sum_i \delta_i s_i + A p \ge 0,\quad p \ge 0,\quad g\, p = 0,\quad
              \int p\, w_i\, dA = F_i

    Newton's method on the amounts of the free motions. At given amounts the set of cells under pressure is
    sought: cells of negative pressure leave it, cells that overlap join it, and on one set g = 0 is solved by
    conjugate gradients, preconditioned by the inverted spectrum of A.

    Parameters
    ----------
    compliance : NormalCompliance
        A [m/Pa]
    gap : array (nx, ny)
        h, separation of the undeformed surfaces [m]; negative where they overlap
    motions : RigidMotions
        s, w (s unless given) and F of the motions that are free [N, N m]; none for bodies that are held
    start : array (nx, ny), optional
        pressure like the one sought [Pa], >= 0
    tolerance : float
        gap or overlap left over the overlap of the undeformed surfaces [-]; ten times it of the loads

    Raises
    ------
    NotSolved
        when the iteration does not settle, as for loads that no pressure on the grid carries
    OutOfRange
        for a gap that is not finite

    Source
    ------
    Polonsky and Keer, Wear 231 (1999), 206-219, for the problem and conjugate gradients; Hintermueller, Ito
    and Kunisch, SIAM J. Optim. 13 (2002), 865-888, for the sets.

    Valid
    -----
    Elastic, frictionless or of equal materials; contact far smaller than both bodies. Nothing lies beyond
    the grid: a contact that reaches its end is cut there, see `NormalContact.cut`.
    """
    if not np.all(np.isfinite(gap)):
        raise OutOfRange("contact pressure: the gap must be a finite number in every cell of the grid")
    search = _Search(compliance, gap, motions, tolerance)
    state = search.first(np.ones_like(gap) if start is None else start)
    responses = np.zeros_like(motions.shapes)
    for _ in range(LIMIT):
        if state.error < LOADS * tolerance and state.held.tolerance <= tolerance:
            pressure, separation = state.held.pressure, np.maximum(state.held.separation, 0.0)
            separation = np.where(pressure > 0, 0.0, separation)
            return NormalContact(compliance.grid, pressure, separation, state.amounts, state.iterations)
        responses = search.responses(state, responses)
        state = search.advanced(state, responses)
    raise NotSolved(
        f"contact pressure: loads off by {state.error:.1e} after {LIMIT} steps, allowed "
        f"{LOADS * tolerance:.0e}",
        "iteration limit",
    )


@dataclass(frozen=True)
class _Closed:
    """Pressure on a set of cells, and the separation that it leaves."""

    pressure: NDArray  # (nx, ny) [Pa]
    separation: NDArray  # (nx, ny) [m]
    iterations: int  # of conjugate gradients
    tolerance: float  # that was kept, over the overlap [-] or as a length [m]


@dataclass(frozen=True)
class _State:
    """Bodies held at some amounts of their motions."""

    amounts: NDArray  # (m) [m] or [-]
    held: _Closed
    missing: NDArray  # (m) loads less those carried, [N] or [N m]
    error: float  # largest of them over what the pressure carries [-]
    iterations: int  # of conjugate gradients so far


@dataclass(frozen=True)
class _Search:
    """Newton's method for the amounts of the motions, where a concave function has its maximum."""

    compliance: NormalCompliance
    gap: NDArray  # (nx, ny) [m]
    motions: RigidMotions
    tolerance: float  # of the gaps, over the overlap of the undeformed surfaces [-]

    def first(self, pressure: NDArray) -> _State:
        """State at amounts by which the pressure, scaled to the force, closes the gaps on the average."""
        if not len(self.motions.shapes):
            return self._at(np.zeros(0), (self.gap < 0) * 1.0, 0.0, 0)
        shapes, carried = self.motions.shapes, self._carried(pressure)[0]
        pressure = pressure * (self.motions.loads[0] / carried)
        separation = self.gap + self.compliance.displaced(pressure)
        product = np.einsum("ixy,jxy,xy->ij", shapes, shapes, pressure)
        amounts = np.linalg.solve(product, np.einsum("ixy,xy,xy->i", shapes, pressure, separation))
        return self._at(amounts, pressure, 1.0, 0)

    def _carried(self, pressure: NDArray) -> NDArray:
        """Integrals (m) of a pressure times the weights, [N] or [N m]."""
        return np.einsum("ixy,xy->i", self._weights, pressure) * self.compliance.grid.cell_area

    @property
    def _weights(self) -> NDArray:
        return self.motions.shapes if self.motions.weights is None else self.motions.weights

    def _at(self, amounts: NDArray, pressure: NDArray, error: float, iterations: int) -> _State:
        """State at some amounts, from a pressure like it, as exact as an error of the loads is worth."""
        moved = np.tensordot(amounts, self.motions.shapes, 1)
        tolerance = max(self.tolerance, REDUCTION * error)
        held = _held(self.compliance, self.gap - moved, pressure, tolerance)
        missing = self.motions.loads - self._carried(held.pressure)
        size = np.abs(self._weights).max(axis=(1, 2)) * np.abs(self.motions.loads[:1])
        left = float(np.max(np.abs(missing) / size, initial=0.0))
        return _State(amounts, held, missing, left, iterations + held.iterations)

    def responses(self, state: _State, before: NDArray) -> NDArray:
        """Pressures (m, nx, ny) by an amount of one of each motion, [Pa/m] or [Pa]."""
        touching, share = state.held.pressure > 0, np.clip(state.error, 1e-6, 0.01)
        return np.array(
            [
                _closed(self.compliance, -shape, touching, start, share * np.abs(shape).max()).pressure
                for shape, start in zip(self.motions.shapes, before, strict=True)
            ]
        )

    def _newton_step(self, state: _State, responses: NDArray) -> NDArray:
        """Changes of the amounts (m) that would carry the loads missing, if no cell came or left."""
        tangent = np.array([self._carried(response) for response in responses])
        try:
            return np.linalg.solve(tangent, state.missing)
        except np.linalg.LinAlgError:
            cells = int((state.held.pressure > 0).sum())
            raise NotSolved(
                f"contact pressure: {cells} cells under pressure cannot carry {len(responses)} loads; do "
                "they act on the grid, and is it fine enough?",
                "stalled",
            ) from None

    def advanced(self, state: _State, responses: NDArray) -> _State:
        """State after a step that is halved until it neither loses contact nor goes far too far.

        Where no step can be judged as the state itself is too inexact, the same one more exactly.
        """
        change = self._newton_step(state, responses)
        ahead, iterations = float(state.missing @ change), state.iterations
        for _ in range(LIMIT):
            pressure = state.held.pressure + np.tensordot(change, responses, 1)
            next_state = self._at(state.amounts + change, np.maximum(pressure, 0.0), state.error, iterations)
            left, iterations = abs(float(next_state.missing @ change)), next_state.iterations
            as_exact = next_state.error <= UNCERTAIN * state.held.tolerance
            if next_state.held.pressure.any() and (as_exact or left <= OVERSHOOT * ahead):
                return next_state
            if next_state.held.tolerance < state.held.tolerance:
                return self._at(state.amounts, state.held.pressure, state.error, iterations)
            change, ahead = change / 2, ahead / 2
        raise NotSolved(
            f"contact pressure: no step lowers the loads' error of {state.error:.1e}, allowed "
            f"{LOADS * self.tolerance:.0e}",
            "stalled",
        )


def _held(compliance: NormalCompliance, gap: NDArray, pressure: NDArray, tolerance: float) -> _Closed:
    """Pressure (>= 0) between held bodies; the error is below a share of their overlap."""
    overlap = -float(gap.min())
    if overlap <= 0:
        return _Closed(np.zeros_like(gap), gap, 0, 0.0)
    touching = (pressure > 0) & (gap < 0) if pressure.any() else gap < 0
    error, iterations = 1.0, 0
    for _ in range(LIMIT):
        allowed = max(REDUCTION * error, tolerance / 4) * overlap
        state = _closed(compliance, gap, touching, pressure, allowed)
        iterations += state.iterations
        outside = max(0.0, -float(state.separation[~touching].min(initial=0.0)))
        tension = max(0.0, -float(state.pressure.min()) / compliance.stiffness)
        inside = float(np.abs(state.separation[touching]).max(initial=0.0))
        error = max(outside, tension, inside) / overlap
        pressure = np.maximum(state.pressure, 0.0)
        if error <= tolerance:
            return _Closed(pressure, state.separation, iterations, tolerance)
        touching = np.where(touching, state.pressure > 0, state.separation < 0)
    raise NotSolved(
        f"contact pressure: {error:.1e} of the overlap left after {LIMIT} sets of cells, allowed "
        f"{tolerance:.0e}",
        "iteration limit",
    )


def _closed(
    compliance: NormalCompliance, gap: NDArray, touching: NDArray, start: NDArray, allowed: float
) -> _Closed:
    """Pressure of either sign that closes the gaps of one set of cells but for an allowed length [m]."""
    pressure = np.where(touching, start, 0.0)
    separation = gap + compliance.displaced(pressure)
    direction, before = np.zeros_like(gap), np.inf
    for number in range(STEPS):
        residual = np.where(touching, separation, 0.0)
        if np.abs(residual).max() <= allowed:
            return _Closed(pressure, separation, number, allowed)
        downhill = np.where(touching, compliance.pressed(residual), 0.0)
        size = float(np.sum(residual * downhill))
        direction = downhill + size / before * direction
        displacement = compliance.displaced(direction)
        length = size / float(np.sum(direction * displacement))
        pressure, separation, before = pressure - length * direction, separation - length * displacement, size
    raise NotSolved(
        f"contact pressure: a gap of {np.abs(residual).max():.1e} m is left after {STEPS} steps of conjugate "
        f"gradients, allowed {allowed:.1e} m",
        "iteration limit",
    )
