"""The bearing as one callable: raceway shape or compliance in, equilibrium out."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.roller import RollerBalance
from quasidynamic.contact.film import FilmLaw
from quasidynamic.contact.line import LoadLaw, Slices, gap_rounding, raceway_coefficients, reduced_radius
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.raceways import Raceways
from quasidynamic.errors import NotSolved
from quasidynamic.outcome.equilibrium import Equilibria, Equilibrium
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.operation import Operation
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.elastic_raceways import iterate
from quasidynamic.solve.rollers.strategy import solve
from quasidynamic.solve.start import RESTARTS, slipping_start, static_start

__all__ = ["Equilibria", "Equilibrium", "RollerBearing"]

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

    def solve(self, start: Equilibrium | None = None, deviation: NDArray | None = None) -> Equilibrium:
        """Equilibrium between raceways of a given shape.

        Parameters
        ----------
        start : Equilibrium, optional
            where to begin; without it a static load distribution is computed first
        deviation : array (2, Z, M), optional
            outward raceway deviations by axial modes [m]

        Raises
        ------
        NotSolved
            when no equilibrium was reached; its `outcome` says how it ended
        """
        balance = self._balance([self.operation], deviation)
        begin = None if start is None else balance.pack(start.unknowns)
        equilibrium = self._solved(balance, begin, None if deviation is None else BUDGET)[0]
        if equilibrium.status is not SolverOutcome.CONVERGED:
            raise NotSolved(equilibrium.failure(), equilibrium.status)
        return equilibrium

    def solve_many(self, operations: Sequence[Operation]) -> "Equilibria":
        """Equilibria of many operating points between rigid, round raceways.

        All of them are solved side by side; the answers are those of one solve after the other.

        Returns
        -------
        Equilibria
            one for each operation, also where none was reached: its `status` says so
        """
        states: list[Equilibrium] = []
        for first in range(0, len(operations), CASES_AT_ONCE):
            states.extend(self._solved(self._balance(operations[first : first + CASES_AT_ONCE])))
        return Equilibria(tuple(states))

    def iterate(
        self, compliance: Compliance, start: Equilibrium, deviation: NDArray | None = None
    ) -> Iterator[Equilibrium]:
        """Newton iterates of the bearing between elastic raceways (inner, outer; None is rigid).

        Parameters
        ----------
        compliance : pair of arrays (Z, M, Z, M) or None
            outward deviation of a raceway per outward force [m/N]
        start : Equilibrium
            where to begin, such as the rigid equilibrium
        deviation : array (2, Z, M), optional
            outward deviations that are there without any roller load [m]
        """
        size = self.bearing.rollers * self.axial_modes
        inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
        rigid = self._balance([self.operation], deviation, aligned=False)
        balance = replace(rigid, compliance=(inner, outer))
        near = bool(start.balance.layout.elastic_raceways) or start.balance.deviation is not None
        for step in iterate(balance, balance.pack(start.unknowns), near, STARTS):
            yield Equilibrium(balance, step.unknowns[0], step.outcomes[0], step.number, self.axial_modes)

    def _solved(
        self, balance: BearingBalance, begin: NDArray | None = None, budget: int | None = None
    ) -> list[Equilibrium]:
        # A trial slip or step may be absurd: what overflows is no start, or shows in its residual.
        with np.errstate(all="ignore"):
            solved = solve(balance, static_start(balance) if begin is None else begin, STARTS, budget)
        return [
            Equilibrium(
                balance.take(np.array([case])) if len(solved.outcomes) > 1 else balance,
                solved.unknowns[case],
                solved.outcomes[case],
                int(solved.evaluations[case]),
                self.axial_modes,
            )
            for case in range(len(solved.outcomes))
        ]

    # -- equations -----------------------------------------------------------------------------

    def _balance(
        self, operations: Sequence[Operation], deviation: NDArray | None = None, aligned: bool = True
    ) -> BearingBalance:
        """Equations, with rollers that can tilt only where something tilts them.

        By symmetry a ring that is free to tilt stays straight where nothing does.
        """
        aligned = aligned and deviation is None and not any(operation.tilts for operation in operations)
        return BearingBalance(
            roller=self._aligned_rollers if aligned else self._tilting_rollers,
            points=OperatingPoints.of(operations),
            clearance=self.bearing.clearance,
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
            bearing=self.bearing, lubrication=self.lubrication, raceways=self._raceways(axial_modes)
        )

    def _raceways(self, axial_modes: int) -> Raceways:
        bearing, roller, lubrication = self.bearing, self.bearing.roller, self.lubrication
        slices = Slices(self.slices, roller.length, axial_modes)
        radii = [
            reduced_radius(roller.diameter / 2, r) for r in (bearing.inner_radius, -bearing.outer_radius)
        ]
        moduli = [contact_modulus(roller.material, ring) for ring in (bearing.inner_ring, bearing.outer_ring)]
        radius, modulus = (np.array(values)[:, None, None] for values in (radii, moduli))
        return Raceways(
            law=LoadLaw(np.array(raceway_coefficients(bearing))[:, None, None], gap_rounding(bearing)),
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
            drop=roller.profile.drop(slices.centres, roller.length),
            radius=radius,
            modulus=modulus,
        )
