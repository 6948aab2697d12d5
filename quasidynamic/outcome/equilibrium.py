"""A solved state of the bearing, in physical units."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.cage import FloatingCage
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.balance.rollers.unknowns import BORDER, TILT_Z, Unknowns, Y, Z
from quasidynamic.outcome.acting_forces import ActingForces
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.losses import Losses
from quasidynamic.outcome.ring_stiffness import Tangent
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.newton import step
from quasidynamic.solve.rollers.step_bounds import bounded


@dataclass(frozen=True)
class Equilibrium:
    """What the bearing does in one state. Z rollers, M axial modes, K slices; inner first, outer second."""

    balance: BearingBalance  # of one case
    scaled: NDArray  # (N) unknowns
    status: SolverOutcome  # empty while iterating; otherwise how the solve ended
    number: int  # evaluations it took
    axial_modes: int  # M, axial modes that loads are handed on with

    @classmethod
    def of(cls, states: BearingStates, status: SolverOutcome, number: int) -> "Equilibrium":
        """The state of a single case, with what is known of it."""
        state = cls(states.balance, states.scaled[0], status, number, states.axial_modes)
        state.__dict__["cases"] = states
        return state

    @cached_property
    def cases(self) -> BearingStates:
        """The same as an array of one case."""
        return BearingStates(self.balance, self.scaled[None], self.axial_modes)

    # -- the state in numbers ------------------------------------------------------------------

    @property
    def system(self) -> Linearisation:
        """Residual and derivatives."""
        return self.cases.system

    @property
    def unknowns(self) -> Unknowns:
        """Unknowns in SI units; fields have an axis of one case."""
        return self.cases.unknowns

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the reference force [-]."""
        return float(self.cases.residual[0])

    @property
    def unbalanced(self) -> tuple[float, float]:
        """Largest force [N] and largest moment [N m] that are not balanced."""
        residual = np.abs(self.system.residual * self.balance.scales.residual)[0]
        first, spin = self.balance.layout.field(0), self.balance.layout.field(-1)
        moments = [residual[TILT_Z:BORDER], residual[spin]]
        if self.balance.roller.axial_modes > 1:
            moments.append(residual[self.balance.layout.field(1)])
        forces = [residual[[Y, Z]], residual[first]]
        return float(np.concatenate(forces).max()), float(np.concatenate(moments).max())

    def failure(self) -> str:
        """Say how the solve ended and how far it came."""
        if self.status is SolverOutcome.UNDETERMINED:
            return (
                "neither load nor moment, and clearance: no roller touches the inner ring, "
                "the cage is at rest and the ring position is undetermined"
            )
        force, moment = self.unbalanced
        return (
            f"{self.status} after {self.number} evaluations, "
            f"{force:.2g} N and {moment:.2g} N m unbalanced; "
            f"the largest outer force is {self.balance.scales.force[0, 0]:.4g} N"
        )

    def refined(self) -> "Equilibrium":
        """State after another step of Newton's method, where that comes nearer to balance."""
        with np.errstate(all="ignore"):  # a step from a singular matrix is not finite, and not taken
            change = step(self.balance, self.system)
            further = replace(self, scaled=bounded(self.balance, self.scaled[None], self.scaled + change)[0])
            return further if further.residual < self.residual else self

    @property
    def rollers(self) -> RollerState:
        """Forces and speeds at the rollers; arrays have an axis of one case before that of the rollers."""
        return self.system.state

    @property
    def slice_loads(self) -> NDArray:
        """Load per length (2, Z, K) [N/m]."""
        return self.cases.slice_loads[0]

    @property
    def slice_positions(self) -> NDArray:
        """Centres of the slices (K) from mid-roller [m]."""
        return self.balance.roller.raceways.slices.all_centres

    @property
    def loads(self) -> NDArray:
        """Roller loads (2, Z) [N]."""
        return self.cases.loads[0]

    @property
    def forces(self) -> NDArray:
        """Forces (2, Z, M) [N] of the rollers on the raceways; [..., 0] is the load."""
        return self.cases.forces[0]

    @property
    def deviation(self) -> NDArray:
        """Outward raceway deviations (2, Z, M) by axial modes [m]."""
        return self.cases.deviation[0]

    @property
    def deviation_along_rollers(self) -> NDArray:
        """Outward raceway deviations (2, Z, K) [m]."""
        return self.cases.deviation_along_rollers[0]

    @property
    def loaded(self) -> NDArray:
        """Which contacts carry load (2, Z)."""
        return self.cases.loaded[0]

    @property
    def film(self) -> NDArray:
        """Film (2, Z) [m]."""
        return self.cases.film[0]

    @property
    def loaded_film(self) -> NDArray:
        """Film (2, Z) [m] of the contacts that carry load, 0 elsewhere."""
        return self.cases.loaded_film[0]

    @property
    def minimum_film(self) -> NDArray:
        """Smallest film (2) of the loaded contacts of each raceway [m]; 0 where none is loaded."""
        return self.cases.minimum_film[0]

    # -- motion --------------------------------------------------------------------------------

    @property
    def cage_speed(self) -> float:
        """Cage speed [rad/s]."""
        return float(self.cases.cage_speed[0])

    @property
    def cage_slip(self) -> float:
        """Lag of the cage behind pure rolling, as a fraction [-]; not a number when that stands still."""
        return float(self.cases.cage_slip[0])

    @property
    def roller_speed(self) -> NDArray:
        """Spin (Z) relative to the cage [rad/s]."""
        return self.cases.roller_speed[0]

    @property
    def roller_slip(self) -> NDArray:
        """Lag of the spins behind pure rolling (Z), as a fraction [-]; not a number when they stand still."""
        return self.cases.roller_slip[0]

    @property
    def roller_tilt(self) -> NDArray:
        """Tilt (Z) of the rollers in the plane through the bearing axis [rad]."""
        return self.cases.roller_tilt[0]

    @property
    def ring_displacement(self) -> NDArray:
        """Displacement (y, z) of the inner ring against the outer one [m]."""
        return self.cases.ring_displacement[0]

    @property
    def ring_tilt(self) -> NDArray:
        """Slopes (dz/dx, dy/dx) of the inner ring [rad]."""
        return self.cases.ring_tilt[0]

    @property
    def load_direction(self) -> float:
        """Azimuth of the radial load [rad], 0 when there is none."""
        return float(self.cases.load_direction[0])

    # -- forces --------------------------------------------------------------------------------

    @property
    def traction(self) -> NDArray:
        """Traction of the raceways on the rollers (2, Z) [N], signed like the sliding."""
        return self.cases.traction[0]

    @property
    def rolling_shear(self) -> NDArray:
        """Inlet shear at the raceways (2, Z) [N], signed along the rolling."""
        return self.cases.rolling_shear[0]

    @property
    def sliding(self) -> NDArray:
        """Raceway over roller surface (2, Z) [m/s]."""
        return self.cases.sliding[0]

    @property
    def entrainment(self) -> NDArray:
        """Mean surface speed (2, Z) [m/s]."""
        return self.cases.entrainment[0]

    @property
    def cage_force(self) -> NDArray:
        """Force of the pockets on the rollers along the motion (Z) [N]."""
        return self.cases.cage_force[0]

    @cached_property
    def acting(self) -> ActingForces:
        """Every force on rollers and cage as it acts."""
        balance = self.balance.roller
        return ActingForces(self.rollers, balance.bearing, balance.raceways.slices, self.floating)

    @property
    def applied_load(self) -> NDArray:
        """Load on the inner ring (2), y and z [N]."""
        return self.cases.applied_load[0]

    @property
    def ring_moment(self) -> NDArray:
        """Moments (2) [N m] that act on the inner ring from outside: applied, or held by its guide."""
        return self.cases.ring_moment[0]

    @property
    def land_torque(self) -> float:
        """Torque of the guiding land on the cage [N m]."""
        return float(self.cases.land_torque[0])

    @property
    def floating(self) -> FloatingCage | None:
        """Where a cage with a free centre floats in its land; None for one that is held."""
        return self.cases.floating

    @property
    def cage_offset(self) -> NDArray | None:
        """Centre of a free cage (2) from that of its guiding ring (y, z) [m]; None for one that is held."""
        offset = self.cases.cage_offset
        return None if offset is None else offset[0]

    @property
    def pocket_displacement(self) -> NDArray | None:
        """Rollers (Z) from the centre of their pockets along the motion [m], if its clearance is known."""
        displacement = self.cases.pocket_displacement
        return None if displacement is None else displacement[0]

    @property
    def driving_torque(self) -> float:
        """Torque that turns the inner ring [N m], with that of the land if it guides the cage."""
        return float(self.cases.driving_torque[0])

    @property
    def outer_torque(self) -> float:
        """Torque that turns or holds the outer ring [N m], positive along the motion of the cage."""
        return float(self.cases.outer_torque[0])

    @property
    def transport(self) -> NDArray:
        """Torque (Z) that the change of spin around the bearing takes from each roller [N m]."""
        return self.cases.transport[0]

    @property
    def losses(self) -> Losses:
        """Power loss by cause [W]."""
        return self.cases.losses[0]

    @property
    def driving_power(self) -> float:
        """Power that the rings put in [W]."""
        return float(self.cases.driving_power[0])

    # -- contacts ------------------------------------------------------------------------------

    @property
    def peak_pressure(self) -> NDArray:
        """Largest Hertz pressure (2) at the inner and outer raceway [Pa]."""
        return self.cases.peak_pressure[0]

    @property
    def life(self) -> float:
        """Basic reference life L10 [10^6 revolutions]."""
        return float(self.cases.life[0])

    @property
    def turning(self) -> tuple[float, float]:
        """How far the inner and the outer ring turn against the load, 0 standing to 1 [-]."""
        inner, outer = self.cases.turning
        return float(inner[0]), float(outer[0])

    # -- stiffness -----------------------------------------------------------------------------

    @property
    def tangent(self) -> Tangent:
        """Compliance and stiffness of the ring at this state."""
        return self.cases.tangent[0]
