"""The bearing as one callable: raceway shape or compliance in, equilibrium out."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance
from quasidynamic.balance.roller import RollerBalance
from quasidynamic.contact.hertz import reduced_radius
from quasidynamic.contact.load import LoadLaw, iso16281, palmgren
from quasidynamic.contact.raceway import RacewayContact
from quasidynamic.contact.slices import Slices
from quasidynamic.contact.traction import EyringLimited, Regression4109, TractionLaw
from quasidynamic.equilibrium import Equilibrium
from quasidynamic.errors import NotSolved
from quasidynamic.parts.bearing import CylindricalRollerBearing
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.material import Material, contact_modulus
from quasidynamic.parts.operation import Operation
from quasidynamic.solve import Step, solve
from quasidynamic.start import static_start

__all__ = ["Equilibrium", "RollerBearing"]

Compliance = tuple[NDArray | None, NDArray | None]


@dataclass(frozen=True, kw_only=True)
class RollerBearing:
    """A cylindrical roller bearing under load and speed, ready to be solved.

    Shapes: Z rollers, M axial shapes, K slices; index 0 is the inner raceway, 1 the outer one.
    """

    bearing: CylindricalRollerBearing
    operation: Operation
    oil: Lubricant
    oil_fraction: float  # [-] volume share of oil in the mixture around the rollers
    traction: Literal["4109", "eyring"] = "4109"
    limiting_ratio: float = 0.05  # [-] Eyring law: limiting shear stress over pressure
    eyring_stress: float | None = None  # [Pa] Eyring law; None: 2 limiting_ratio / alpha
    inlet_heating: bool = True
    slices: int = 20
    shapes: int = 2
    spin_inertia: bool = True

    @cached_property
    def balance(self) -> BearingBalance:
        """Equations of the bearing between rigid, round raceways."""
        return BearingBalance(
            roller=RollerBalance(
                bearing=self.bearing,
                operation=self.operation,
                inner=self._contact(self.bearing.inner_ring, self.bearing.inner_radius),
                outer=self._contact(self.bearing.outer_ring, -self.bearing.outer_radius),
                oil_fraction=self.oil_fraction,
            ),
            spin_inertia=self.spin_inertia,
        )

    def solve(self, start: Equilibrium | None = None, deviation: NDArray | None = None) -> Equilibrium:
        """Equilibrium between raceways of a given shape.

        Parameters
        ----------
        start : Equilibrium, optional
            where to begin; without it a static load distribution is computed first
        deviation : array (2, Z, M), optional
            shape coefficients of the outward raceway deviations [m]

        Raises
        ------
        NotSolved
            when Newton's method ends without equilibrium
        """
        balance = replace(self.balance, deviation=deviation)
        *_, last = self._steps(balance, start)
        if last.status != "converged":
            raise NotSolved(
                f"the bearing found no equilibrium: {last.status} after {last.number} steps, "
                f"largest unbalanced force {last.residual:.1e} of the reference force "
                f"{balance.reference_force:.4g} N"
            )
        return Equilibrium(balance, last)

    def iterate(self, compliance: Compliance, start: Equilibrium | None = None) -> Iterator[Equilibrium]:
        """Newton iterates of the bearing between raceways that yield (inner, outer; None is rigid).

        Parameters
        ----------
        compliance : pair of arrays (Z, M, Z, M) or None
            outward deviation of a raceway per outward force [m/N]
        start : Equilibrium, optional
            where to begin, such as the rigid equilibrium
        """
        flat = tuple(
            None if matrix is None else matrix.reshape(2 * [self.bearing.rollers * self.shapes])
            for matrix in compliance
        )
        balance = replace(self.balance, compliance=flat)
        for step in self._steps(balance, start):
            yield Equilibrium(balance, step)

    def _steps(self, balance: BearingBalance, start: Equilibrium | None) -> Iterator[Step]:
        if start is None:
            return solve(balance, *static_start(balance))
        unknowns = np.zeros(balance.size)
        common = min(balance.size, start.balance.size)
        unknowns[:common] = start.step.unknowns[:common]
        return solve(balance, unknowns, start.balance.film(start.step.evaluation.rollers))

    def _contact(self, raceway: Material, raceway_radius: float) -> RacewayContact:
        roller = self.bearing.roller
        slices = Slices(self.slices, roller.length, self.shapes)
        radius = reduced_radius(roller.diameter / 2, raceway_radius)
        modulus = contact_modulus(roller.material, raceway)
        return RacewayContact(
            law=self._load_law(raceway),
            traction=self._traction(radius, modulus),
            slices=slices,
            drop=roller.profile.drop(slices.centres, roller.length),
            radius=radius,
            modulus=modulus,
            oil=self.oil,
            inlet_heating=self.inlet_heating,
        )

    def _load_law(self, raceway: Material) -> LoadLaw:
        roller = self.bearing.roller
        if self.bearing.contact_law == "iso16281":
            return iso16281(roller.length)
        return palmgren(roller.material, raceway, roller.length)

    def _traction(self, radius: float, modulus: float) -> TractionLaw:
        length = self.bearing.roller.length
        if self.traction == "4109":
            return Regression4109(radius=radius, modulus=modulus, length=length, oil=self.oil)
        return EyringLimited(
            radius=radius,
            modulus=modulus,
            length=length,
            oil=self.oil,
            limiting_ratio=self.limiting_ratio,
            eyring_stress=self.eyring_stress or 2 * self.limiting_ratio / self.oil.pressure_viscosity,
        )
