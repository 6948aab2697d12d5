"""The bearing as one callable: raceway shape or compliance in, equilibrium out."""

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.roller import RollerBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.columns import kind_and_numbers, stacked, with_columns
from quasidynamic.contact.film import FilmLaw
from quasidynamic.contact.line import LoadLaw, Slices, gap_rounding, raceway_coefficients, reduced_radius
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.raceways import Raceways
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Batch, Equilibria, Equilibrium
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing, Operation
from quasidynamic.solve.rollers.elastic_raceways import iterate
from quasidynamic.solve.rollers.strategy import MOST_WORK, solve
from quasidynamic.solve.start import RESTARTS, slipping_start, static_start
from quasidynamic.solve.step_length import SolverOutcome

__all__ = ["Batch", "Equilibria", "Equilibrium", "RollerBearing", "solve_many"]

Compliance = tuple[NDArray | None, NDArray | None]
STARTS = (slipping_start, *RESTARTS)
BUDGET = 300  # evaluations between raceways of a given shape, which a coupling may have made absurd
CASES_AT_ONCE = 128  # their slices fit into the processor's cache


@dataclass(frozen=True, kw_only=True)
class RollerBearing:
    """A cylindrical roller bearing under load and speed, ready to be solved.

    Array shapes: Z rollers, M axial modes, K slices; index 0 is the inner raceway, 1 the outer one.
    """

    bearing: CylindricalRollerBearing
    operation: Operation
    lubrication: Lubrication
    slices: int = 20
    axial_modes: int = 2  # axial modes that raceways of any shape exchange with the rollers
    spin_inertia: bool = True

    def __post_init__(self):
        if not self.operation.on_ribs:
            return
        if self.bearing.ribs is None:
            raise ImpossiblePart("axial_load: no ribs carry it")
        if self.axial_modes < 2 or self.bearing.row_count > 1:
            raise ImpossiblePart("axial_load: it needs two axial modes or more, and one row of rollers")

    def solve(self, start: Equilibrium | None = None, deviation: NDArray | None = None) -> Equilibrium:
        """Equilibrium between raceways of a given shape.

        Without a start a static load distribution is computed first; deviations (2, Z, M) of the raceways are
        outward, by axial modes [m].
        Raises `NotSolved` when no equilibrium was reached; its `outcome` says how it ended.
        """
        balance = self.balance(deviation=deviation)
        begin = None if start is None else balance.pack(start.unknowns)
        equilibrium = _solved(balance, self.axial_modes, begin, MOST_WORK if deviation is None else BUDGET)[0]
        if equilibrium.status is not SolverOutcome.CONVERGED:
            raise NotSolved(equilibrium.failure(), equilibrium.status)
        return equilibrium

    def iterate(
        self, compliance: Compliance, start: Equilibrium, deviation: NDArray | None = None
    ) -> Iterator[Equilibrium]:
        """Newton iterates of the bearing between elastic raceways (inner, outer; None is rigid).

        The compliance (Z, M, Z, M) is the outward deviation of a raceway per outward force [m/N]; the
        deviation is as of `solve`, there without any roller load.
        """
        size = self.bearing.all_rollers * self.axial_modes
        inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
        rigid = self.balance(deviation=deviation, aligned=False)
        balance = replace(rigid, compliance=(inner, outer))
        near = bool(start.balance.layout.elastic_raceways) or start.balance.deviation is not None
        unknowns = start.unknowns
        if near:  # raceways stay in their shape, whichever part of it these forces make of them
            common = min(start.axial_modes, self.axial_modes)
            by_load = start.deviation[..., :common]
            if deviation is not None:
                by_load = by_load - deviation[..., :common]
            unknowns = unknowns._replace(deviation=np.moveaxis(by_load, -1, 1)[:, :, None])
        for step in iterate(balance, balance.pack(unknowns), near, STARTS):
            state = Equilibrium(balance, step.unknowns[0], step.outcomes[0], step.number, self.axial_modes)
            if step.accepted[0]:  # or the system is that of a step too long
                state.cases.know(step.system)
            yield state

    def state(self, unknowns: Unknowns) -> Equilibrium:
        """A state between rigid raceways with given unknowns, balanced or not."""
        balance = self.balance()
        return Equilibrium(balance, balance.pack(unknowns)[0], SolverOutcome.RUNNING, 0, self.axial_modes)

    # -- equations -----------------------------------------------------------------------------

    def balance(
        self, cases: int = 1, deviation: NDArray | None = None, aligned: bool = True
    ) -> BearingBalance:
        """Equations of C cases, with rollers that can tilt only where something tilts them.

        By symmetry a ring that is free to tilt stays straight where nothing does.
        """
        aligned = aligned and deviation is None and self.bearing.symmetric and not self.operation.tilts
        return BearingBalance(
            roller=self._aligned_rollers if aligned else self._tilting_rollers,
            points=OperatingPoints.of(self.operation, cases),
            deviation=deviation,
            spin_inertia=self.spin_inertia,
        )

    @cached_property
    def _aligned_rollers(self) -> RollerBalance:
        return self._rollers(1)

    @cached_property
    def _tilting_rollers(self) -> RollerBalance:
        return self._rollers(self.axial_modes)

    def _rollers(self, axial_modes: int) -> RollerBalance:
        return RollerBalance(
            bearing=self.bearing,
            lubrication=self.lubrication,
            raceways=self._raceways(axial_modes),
            on_ribs=self.operation.on_ribs,
        )

    def _raceways(self, axial_modes: int) -> Raceways:
        bearing, roller, lubrication = self.bearing, self.bearing.roller, self.lubrication
        slices = Slices(self.slices, roller.length, axial_modes)
        radii = (
            reduced_radius(roller.diameter / 2, r) for r in (bearing.inner_radius, -bearing.outer_radius)
        )
        moduli = (contact_modulus(roller.material, ring) for ring in (bearing.inner_ring, bearing.outer_ring))
        radius, modulus = stacked(*radii), stacked(*moduli)
        return Raceways(
            law=LoadLaw(stacked(*raceway_coefficients(bearing)), gap_rounding(bearing)),
            traction=lubrication.traction(
                radius=radius,
                modulus=modulus,
                length=roller.length,
                oil=lubrication.oil,
            ),
            film_law=FilmLaw(
                formula=lubrication.film,
                radius=radius,
                modulus=modulus,
                oil=lubrication.oil,
                inlet_heating=lubrication.inlet_heating,
            ),
            lubrication=lubrication,
            slices=slices,
            drop=slices.drop(bearing),
            radius=radius,
            modulus=modulus,
        )


def solve_many(bearings: Sequence[RollerBearing]) -> Equilibria:
    """Equilibria of many bearings between rigid, round raceways.

    Those that differ in numbers only are solved side by side; the answers are those of one solve after the
    other.

    There is one for each bearing, also where none was reached: its `status` says so.
    """
    return Equilibria(
        tuple(
            replace(_solved(together.balance(len(places)), together.axial_modes), places=places)
            for places, together in side_by_side_batches(bearings, CASES_AT_ONCE)
        )
    )


def side_by_side_batches(
    bearings: Sequence[RollerBearing], at_once: int, *, tilting_apart: bool = True
) -> Iterator[tuple[NDArray, RollerBearing]]:
    """Yield the places (C) of at most so many bearings of one kind, and the one bearing that stands for them.

    Its numbers that differ are columns (C, 1), see `kind_and_numbers`. Bearings of about the same load over
    squared speed stand together: they slip alike, and take about as many steps. Those whose rollers may be
    aligned stand apart from others.
    """
    kinds: dict[Hashable, list[int]] = {}
    numbers = []
    for place, bearing in enumerate(bearings):
        kind, own = kind_and_numbers(bearing)
        numbers.append(own)
        tilting = tilting_apart and (bearing.operation.tilts or not bearing.bearing.symmetric)
        kinds.setdefault((kind, tilting, bearing.operation.on_ribs), []).append(place)
    for places in kinds.values():
        places.sort(key=lambda place: _pressed(bearings[place].operation))
        for first in range(0, len(places), at_once):
            some = np.array(places[first : first + at_once])
            yield some, with_columns(bearings[some[0]], np.array([numbers[place] for place in some]))


def _pressed(operation: Operation) -> float:
    """Load over the square of the speed, as the centrifugal force of a roller has it."""
    return operation.radial_load / (operation.inner_speed - operation.outer_speed) ** 2


def _solved(
    balance: BearingBalance, axial_modes: int, begin: NDArray | None = None, budget: int = MOST_WORK
) -> Batch:
    # A trial slip or step may be absurd: what overflows is no start, or shows in its residual.
    with np.errstate(all="ignore"):
        solved = solve(balance, static_start(balance) if begin is None else begin, STARTS, budget)
    every, states = np.arange(len(balance.points)), BearingStates(balance, solved.unknowns, axial_modes)
    if (system := solved.system) is not None:
        states.know(system)
    return Batch(every, states, tuple(solved.outcomes), solved.evaluations)
