"""A solved state of the bearing, in physical units."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.cage import FloatingCage
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, INNER, OUTER, TILT_Z, Unknowns, Y, Z
from quasidynamic.contact.cage import displacement_in_pocket, land_torque
from quasidynamic.contact.line import palmgren, peak_pressure
from quasidynamic.outcome.acting_forces import ActingForces
from quasidynamic.outcome.life import basic_life, turning_share
from quasidynamic.outcome.losses import Losses
from quasidynamic.outcome.ring_stiffness import Tangent
from quasidynamic.solve.outcome import SolverOutcome

LOADED = 3e-4  # of the largest load of a raceway: contacts above it carry load and have a film worth telling


@dataclass(frozen=True)
class Equilibrium:
    """What the bearing does in one state. Z rollers, M axial modes, K slices; inner first, outer second."""

    balance: BearingBalance  # of one case
    scaled: NDArray  # (N) unknowns
    status: SolverOutcome  # empty while iterating; otherwise how the solve ended
    number: int  # evaluations it took
    axial_modes: int  # M, axial modes that loads are handed on with

    # -- the state in numbers ------------------------------------------------------------------

    @cached_property
    def system(self) -> Linearisation:
        """Residual and derivatives."""
        return self.balance.evaluate(self.scaled[None])

    @cached_property
    def unknowns(self) -> Unknowns:
        """Unknowns in SI units; fields have an axis of one case."""
        return self.balance.unpack(self.scaled[None])

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the reference force [-]."""
        return float(np.abs(self.system.residual).max())

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
                "the cage stands still and the ring position is undetermined"
            )
        force, moment = self.unbalanced
        return (
            f"{self.status} after {self.number} evaluations, "
            f"{force:.2g} N and {moment:.2g} N m unbalanced; "
            f"the largest outer force is {self.balance.scales.force[0, 0]:.4g} N"
        )

    @property
    def rollers(self) -> RollerState:
        """Forces and speeds at the rollers; arrays have an axis of one case before that of the rollers."""
        return self.system.state

    @cached_property
    def slice_loads(self) -> NDArray:
        """Load per length (2, Z, K) [N/m]."""
        slices = self.balance.roller.raceways.slices
        return slices.unfolded(self.rollers.contact.slice_load[:, 0])

    @property
    def slice_positions(self) -> NDArray:
        """Centres of the slices (K) from mid-roller [m]."""
        return self.balance.roller.raceways.slices.all_centres

    @property
    def loads(self) -> NDArray:
        """Roller loads (2, Z) [N]."""
        return self.rollers.contact.force[:, 0, 0]

    @property
    def forces(self) -> NDArray:
        """Forces (2, Z, M) [N] of the rollers on the raceways; [..., 0] is the load."""
        return self.slice_loads @ self._whole.weights

    @property
    def _whole(self):
        return replace(self.balance.roller.raceways.slices, axial_modes=max(self.axial_modes, 2))

    @property
    def deviation(self) -> NDArray:
        """Outward raceway deviations (2, Z, M) by axial modes [m]."""
        deviation = np.moveaxis(self.unknowns.deviation[:, :, 0], 1, -1)
        if self.balance.deviation is not None:
            deviation = deviation + self.balance.deviation
        return np.concatenate(
            [deviation, np.zeros((*deviation.shape[:2], self.axial_modes - deviation.shape[2]))], axis=-1
        )

    @property
    def deviation_along_rollers(self) -> NDArray:
        """Outward raceway deviations (2, Z, K) [m]."""
        return self.deviation @ replace(self._whole, axial_modes=self.deviation.shape[2]).modes.T

    @property
    def loaded(self) -> NDArray:
        """Which contacts carry load (2, Z)."""
        return self.loads > LOADED * self.loads.max(axis=1, keepdims=True)

    @property
    def film(self) -> NDArray:
        """Film (2, Z) [m]."""
        return self.unknowns.film[:, 0]

    @property
    def loaded_film(self) -> NDArray:
        """Film (2, Z) [m] of the contacts that carry load, 0 elsewhere."""
        return np.where(self.loaded, self.film, 0.0)

    @property
    def minimum_film(self) -> NDArray:
        """Smallest film (2) of the loaded contacts of each raceway [m]; 0 where none is loaded."""
        smallest = np.where(self.loaded, self.film, np.inf).min(axis=1)
        return np.where(np.isfinite(smallest), smallest, 0.0)

    # -- motion --------------------------------------------------------------------------------

    @property
    def cage_speed(self) -> float:
        """Cage speed [rad/s]."""
        return float(self.balance.speeds(self.unknowns)[1][0, 0])

    @property
    def cage_slip(self) -> float:
        """Lag of the cage behind pure rolling, as a fraction [-]; not a number when that stands still."""
        rolling = float(self.balance.rolling_cage[0, 0])
        return -float(self.unknowns.cage_drift[0, 0]) / rolling if rolling else float("nan")

    @property
    def roller_speed(self) -> NDArray:
        """Spin (Z) relative to the cage [rad/s]."""
        return self.balance.speeds(self.unknowns)[0][0]

    @property
    def roller_tilt(self) -> NDArray:
        """Tilt (Z) of the rollers in the plane through the bearing axis [rad]."""
        relative = self.unknowns.tilt[0]
        if self.balance.roller.axial_modes > 1:
            relative = relative + self.deviation[OUTER, :, 1]
        return relative / (self.balance.roller.raceways.slices.length / 2)

    @property
    def ring_displacement(self) -> NDArray:
        """Displacement (y, z) of the inner ring against the outer one [m]."""
        return self.unknowns.ring[:2, 0, 0]

    @property
    def ring_tilt(self) -> NDArray:
        """Slopes (dz/dx, dy/dx) of the inner ring [rad]."""
        return self.unknowns.ring[TILT_Z:CAGE, 0, 0]

    @property
    def load_direction(self) -> float:
        """Azimuth of the radial load [rad], 0 when there is none."""
        points = self.balance.points
        return float(np.arctan2(points.load_y[0, 0], points.load_z[0, 0]))

    # -- forces --------------------------------------------------------------------------------

    @property
    def traction(self) -> NDArray:
        """Traction of the raceways on the rollers (2, Z) [N], signed like the sliding."""
        return self.rollers.contact.traction[:, 0]

    @property
    def rolling_shear(self) -> NDArray:
        """Inlet shear at the raceways (2, Z) [N], signed along the rolling."""
        return (self.rollers.sense * self.rollers.contact.rolling.force)[:, 0]

    @property
    def sliding(self) -> NDArray:
        """Raceway over roller surface (2, Z) [m/s]."""
        return self.rollers.sliding[:, 0]

    @property
    def entrainment(self) -> NDArray:
        """Mean surface speed (2, Z) [m/s]."""
        return self.rollers.entrainment[:, 0]

    @property
    def cage_force(self) -> NDArray:
        """Force of the pockets on the rollers along the motion (Z) [N]."""
        return self.rollers.pocket[0, 0]

    @cached_property
    def acting(self) -> ActingForces:
        """Every force on rollers and cage as it acts."""
        balance = self.balance.roller
        return ActingForces(self.rollers, balance.bearing, balance.raceways.slices, self.floating)

    @property
    def applied_load(self) -> NDArray:
        """Load on the inner ring (2), y and z [N]."""
        return np.array([self.balance.points.load_y[0, 0], self.balance.points.load_z[0, 0]])

    @property
    def ring_moment(self) -> NDArray:
        """Moments (2) [N m] that act on the inner ring from outside: applied, or held by its guide."""
        if self.balance.roller.axial_modes == 1:
            return np.zeros(2)
        moment = self.balance.roller.raceways.slices.length / 2 * self.rollers.contact.force[INNER, 1, 0]
        azimuth = self.balance.roller.bearing.azimuths
        return np.array([moment @ np.cos(azimuth), moment @ np.sin(azimuth)])

    @property
    def land_torque(self) -> float:
        """Torque of the guiding land on the cage [N m]."""
        if self.floating is not None:
            return float(self.floating.torque[0])
        return float(land_torque(*self._land).torque)

    @cached_property
    def floating(self) -> FloatingCage | None:
        """Where a cage with a free centre floats in its land; None for one that is held."""
        if not self.balance.roller.bearing.cage.free:
            return None
        return self.balance.floating(self.unknowns, self.rollers.pocket)

    @property
    def pocket_displacement(self) -> NDArray | None:
        """Rollers (Z) from the centre of their pockets along the motion [m], if its clearance is known."""
        bearing = self.balance.roller.bearing
        if bearing.cage.pocket_clearance is None:
            return None
        roller = bearing.roller
        stop = palmgren(roller.material, roller.material, roller.length) * roller.length
        return displacement_in_pocket(-self.cage_force, bearing.cage.pocket_clearance, stop)

    @property
    def _land(self):
        points, cage = self.balance.points, self.balance.roller.bearing.cage
        ring_speed = points.guiding_speed(cage.guidance)
        return float(ring_speed[0, 0]) - self.cage_speed, cage, self.balance.roller.lubrication.oil

    @property
    def driving_torque(self) -> float:
        """Torque that turns the inner ring [N m], with that of the land if it guides the cage."""
        bearing = self.balance.roller.bearing
        torque = bearing.inner_radius * (self.traction[INNER] + self.rolling_shear[INNER]).sum()
        return float(torque) + (self.land_torque if bearing.cage.guidance == "inner" else 0.0)

    @property
    def outer_torque(self) -> float:
        """Torque that turns or holds the outer ring [N m], positive along the motion of the cage."""
        bearing = self.balance.roller.bearing
        torque = bearing.outer_radius * (self.traction[OUTER] - self.rolling_shear[OUTER]).sum()
        return float(torque) + (self.land_torque if bearing.cage.guidance == "outer" else 0.0)

    @property
    def transport(self) -> NDArray:
        """Torque (Z) that the change of spin around the bearing takes from each roller [N m]."""
        return self.balance.spin_transport(self.unknowns.cage_drift, self.unknowns.spin_drift).torque[0]

    @property
    def losses(self) -> Losses:
        """Power loss by cause [W]."""
        bearing, rollers = self.balance.roller.bearing, self.rollers
        difference, *_ = self._land
        return Losses(
            sliding=float((self.traction * self.sliding).sum()),
            rolling=float((2 * self.rolling_shear * (rollers.sense * rollers.entrainment)[:, 0]).sum()),
            drag=float(rollers.drag[0, 0] * self.cage_speed * bearing.pitch_diameter / 2 * bearing.rollers),
            pocket=float(rollers.pocket_brake[0] @ self.roller_speed * bearing.roller.diameter / 2),
            land=self.land_torque * difference,
            churning=float(rollers.churning[0] @ self.roller_speed),
            transport=float(self.transport @ self.roller_speed),
        )

    @property
    def driving_power(self) -> float:
        """Power that the rings put in [W]."""
        points = self.balance.points
        return float(
            self.driving_torque * points.inner_speed[0, 0] + self.outer_torque * points.outer_speed[0, 0]
        )

    # -- contacts ------------------------------------------------------------------------------

    @property
    def peak_pressure(self) -> NDArray:
        """Largest Hertz pressure (2) at the inner and outer raceway [Pa]."""
        raceways = self.balance.roller.raceways
        largest = self.slice_loads.max(axis=(1, 2))
        return peak_pressure(largest, raceways.radius[:, 0, 0], raceways.modulus[:, 0, 0])

    @property
    def life(self) -> float:
        """Basic reference life L10 [10^6 revolutions]."""
        inner, outer = self.slice_loads * self.balance.roller.raceways.slices.width
        return float(basic_life(inner, outer, self.balance.roller.bearing, self.turning))

    @property
    def turning(self) -> tuple[float, float]:
        """How far the inner and the outer ring turn against the load, 0 standing to 1 [-]."""
        points = self.balance.points
        inner, outer = float(points.inner_speed[0, 0]), float(points.outer_speed[0, 0])
        return turning_share(inner, inner - outer), turning_share(outer, inner - outer)

    # -- stiffness -----------------------------------------------------------------------------

    @cached_property
    def tangent(self) -> Tangent:
        """Compliance and stiffness of the ring at this state."""
        return Tangent.at(self.balance, self.unknowns)


@dataclass(frozen=True)
class Equilibria:
    """Equilibria of many operating points of one bearing."""

    states: tuple[Equilibrium, ...]

    def __len__(self) -> int:
        return len(self.states)

    def __iter__(self) -> Iterator[Equilibrium]:
        return iter(self.states)

    def __getitem__(self, case: int) -> Equilibrium:
        return self.states[case]

    @property
    def unsolved(self) -> tuple[int, ...]:
        """Cases where no equilibrium was reached."""
        return tuple(i for i, state in enumerate(self.states) if state.status is not SolverOutcome.CONVERGED)

    @property
    def cage_slip(self) -> NDArray:
        """Lag of the cage (cases) as a fraction [-]."""
        return np.array([state.cage_slip for state in self.states])

    @property
    def ring_displacement(self) -> NDArray:
        """Displacement (cases, 2) along y and z [m]."""
        return np.array([state.ring_displacement for state in self.states])

    @property
    def loads(self) -> NDArray:
        """Roller loads (cases, 2, Z) [N]."""
        return np.array([state.loads for state in self.states])
