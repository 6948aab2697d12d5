"""Inclined rollers between elastic raceways: Newton's method for the forces that shape them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.inclined import INNER, OUTER, RIB, SECTION, InclinedRollers, InclinedState
from quasidynamic.contact.line.slices import Slices
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.solve.rollers.inclined_equilibrium import InclinedSolution, inclined_equilibrium
from quasidynamic.solve.step_length import HALVINGS

MISFIT = 1e-10  # of the largest force: what forces differ from those that made the raceways' shape
STEPS = 60  # of the forces, rarely more than ten

Compliance = NDArray | None  # [m/N] of a raceway, see `between_elastic_raceways`; None of a rigid one


class _Slopes(NamedTuple):
    """Changes of the n forces on elastic raceways."""

    by_shape: NDArray  # (n, n) [N/m] by their displacements, sign reversed, the ring kept in its place
    by_ring: NDArray  # (n, 5) [N/m] by the place of the ring


@dataclass(frozen=True)
class _Raceways:
    r"""Elastic raceways under the axial modes of all rollers.

    .. math:: w = C F,\quad F_m = \int q\, L_m(2s/l)\, ds + \rho_m Q_f

    with the displacements w of the surfaces along their normals into the parts, in modes of the place s
    towards the large end, and last the mean one along the raceway; the approach of a slice is less by w, that
    of the rib by rho w of the inner raceway, see `InclinedRollers.rib_readings`.

    Source
    ------
    Reciprocity: the modes that carry the forces read the displacements.
    """

    model: InclinedRollers  # between raceways that keep their shape
    races: tuple[int, ...]  # which are elastic
    compliance: NDArray  # (n, n) [m/N] race by race, roller by roller
    modes: Slices
    rib: NDArray  # (2, M + 1) rho, zero of the outer raceway [-]

    @classmethod
    def of(cls, model: InclinedRollers, compliance: Sequence[Compliance]) -> "_Raceways":
        races = tuple(race for race in (INNER, OUTER) if compliance[race] is not None)
        shapes = [np.asarray(compliance[race]) for race in races]
        rollers, count = len(model.sections), shapes[0].shape[1] - (races[0] == INNER)
        whole = np.zeros((len(races), rollers, count + 1) * 2)
        for number, (race, each) in enumerate(zip(races, shapes, strict=True)):
            own = count + (race == INNER)
            if each.shape != (rollers, own) * 2 or not np.isfinite(each).all() or count < 2:
                raise ImpossiblePart(
                    f"a compliance of shape {each.shape} does not fit {rollers} rollers with two modes, and "
                    "of the inner raceway the displacement along it"
                )
            whole[number, :, :own, number, :, :own] = (each + each.transpose(2, 3, 0, 1)) / 2
        size = len(races) * rollers * (count + 1)
        rib = np.stack([model.rib_readings(count), np.zeros(count + 1)])
        return cls(model, races, whole.reshape(size, size), model.slices.with_axial_modes(count), rib)

    def forces(self, state: InclinedState) -> NDArray:
        """F (n) [N] that slices and ends press with."""
        forces = _widened(state.slice_load @ self.modes.weights)
        forces += state.rib_load[:, None] * self.rib[:, None]
        return forces[list(self.races)].ravel()

    def shaped(self, forces: NDArray) -> tuple[InclinedRollers, NDArray]:
        """Rollers between raceways of the shape that forces (n) [N] make, and that (2, Z, M + 1) [m]."""
        shape = np.zeros((2, len(self.model.sections), self.modes.axial_modes + 1))
        shape[list(self.races)] = (self.compliance @ forces).reshape(len(self.races), *shape.shape[1:])
        drops = self.model.drops + shape[..., :-1] @ self.modes.modes.T
        return replace(self.model, drops=drops, rib_drop=shape[INNER] @ self.rib[INNER]), shape

    def slopes(self, state: InclinedState, floor: float) -> _Slopes:
        """How forces change where rollers find their balance, held by a floor [N/m]."""
        modes, rollers, rib = self.modes.axial_modes, len(self.model.sections), self.rib
        pressed = (state.slice_slope @ self.modes.products).reshape(2, rollers, modes, modes)
        stiff = _widened(_widened(pressed).swapaxes(2, 3))
        on_rollers = np.einsum("rmd,rzmn->rzdn", self.model.levers, stiff[:, :, :2])  # (2, Z, 3, M + 1)
        stiff += np.einsum("z,rm,rn->rzmn", state.rib_slope, rib, rib)
        on_rollers += np.einsum("z,d,rm->rzdm", state.rib_slope, self.model.normals[RIB], rib)
        count = modes + 1
        held = state.stiffness + floor * np.eye(SECTION)
        follow = np.linalg.solve(held, state.by_ring @ self.model.sections)  # (Z, 3, 5)
        size = rollers * count
        matrix = np.zeros((len(self.races), rollers, count, len(self.races), rollers, count))
        by_ring = np.zeros((len(self.races), rollers, count, 5))
        here = np.arange(rollers)
        for a, race in enumerate(self.races):
            matrix[a, here, :, a, here] = stiff[race]
            moved = follow - self.model.sections if race == INNER else follow
            by_ring[a] = on_rollers[race].swapaxes(1, 2) @ moved
            for b, other in enumerate(self.races):
                change = on_rollers[race].swapaxes(1, 2) @ np.linalg.solve(held, on_rollers[other])
                matrix[a, here, :, b, here] -= change
        total = len(self.races) * size
        return _Slopes(matrix.reshape(total, total), by_ring.reshape(total, 5))


def _widened(values: NDArray) -> NDArray:
    """Values (..., M) of modes with zero for the displacement along the raceway."""
    return np.concatenate([values, np.zeros((*values.shape[:-1], 1))], axis=-1)


@dataclass
class _Search:
    """Forces that make a shape, against those that rollers press with between raceways of that shape."""

    raceways: _Raceways
    load: NDArray  # (5) [N]
    held: NDArray  # (5)
    spent: int = 0  # evaluations of all contacts

    def at(self, forces: NDArray, near: InclinedState) -> "_Shaped":
        model, shape = self.raceways.shaped(forces)
        solution = inclined_equilibrium(model, self.load, self.held, near.ring, near.rollers)
        self.spent += solution.evaluations
        return _Shaped(forces, shape, solution, forces - self.raceways.forces(solution.state))


@dataclass(frozen=True)
class _Shaped:
    """Ring and rollers in balance between raceways of a shape."""

    forces: NDArray  # (n) [N] that made it
    shape: NDArray  # (2, Z, M + 1) [m]
    solution: InclinedSolution
    misfit: NDArray  # (n) [N] less those that rollers press with

    @cached_property
    def size(self) -> float:
        """Largest misfit over the largest force [-]."""
        largest = max(np.abs(self.solution.state.on_ring).max(), np.abs(self.forces).max())
        return float(np.abs(self.misfit).max() / largest) if largest else 0.0


def between_elastic_raceways(
    model: InclinedRollers, load: NDArray, held: NDArray, start: NDArray, compliance: Sequence[Compliance]
) -> InclinedSolution:
    r"""Ring and rollers in balance between raceways that give way to the rollers' forces.

    .. math:: F = F(C F),\quad \Big( 1 + \frac{\partial F}{\partial (-w)} C \Big)\, \Delta F = F(C F) - F

    Newton's method for the forces F on the raceways, ring and rollers in balance between the raceways'
    shape in every step. The energy is convex where C is positive: steps are halved while they run far past
    its lowest place on their way. `compliance` is that of both raceways as `tapered_loads` takes it; other
    arguments are those of `inclined_equilibrium`.

    Raises `NotSolved` where no balance is found; `ImpossiblePart` for compliances that do not fit.

    Source
    ------
    Energy of contacts and raceways; derived here.

    Valid
    -----
    Linear raceways. The rib moves with the section of an elastic inner ring.
    """
    raceways = _Raceways.of(model, compliance)
    search = _Search(raceways, load, held)
    solution = inclined_equilibrium(model, load, held, start)
    search.spent += solution.evaluations
    found = search.at(raceways.forces(solution.state), solution.state)
    for _ in range(STEPS):
        slopes = raceways.slopes(found.solution.state, found.solution.floor)
        if found.size < MISFIT:
            return _solution(search, found, slopes)
        free = ~held
        by_free, stiff = slopes.by_ring[:, free], found.solution.stiffness[np.ix_(free, free)]
        stiff = stiff + found.solution.floor * np.eye(len(stiff))
        matrix = slopes.by_shape - by_free @ np.linalg.solve(stiff, by_free.T)
        step = np.linalg.solve(np.eye(len(matrix)) + matrix @ raceways.compliance, -found.misfit)
        found = _before_the_minimum(search, found, step)
    raise NotSolved(
        f"raceways found no balance in {STEPS} steps: {found.size:.1e} of the largest force is left",
        "iteration limit",
    )


def _before_the_minimum(search: _Search, found: _Shaped, step: NDArray) -> _Shaped:
    """State after a step of the forces, halved while it runs far past the lowest energy on its way."""
    along = search.raceways.compliance @ step
    past = 0.5 * abs(float(found.misfit @ along))
    for halving in range(HALVINGS):
        trial = search.at(found.forces + 0.5**halving * step, found.solution.state)
        if float(trial.misfit @ along) <= past or trial.size < MISFIT:
            break
    return trial


def _solution(search: _Search, found: _Shaped, slopes: _Slopes) -> InclinedSolution:
    """The balance with the stiffness of the ring on contacts and raceways."""
    compliance, by_ring = search.raceways.compliance, slopes.by_ring
    softer = np.linalg.solve(np.eye(len(compliance)) + slopes.by_shape @ compliance, by_ring)
    stiffness = found.solution.stiffness - by_ring.T @ compliance @ softer
    return replace(
        found.solution,
        stiffness=(stiffness + stiffness.T) / 2,
        imbalance=max(found.solution.imbalance, found.size),
        evaluations=search.spent,
        shape=found.shape,
    )
