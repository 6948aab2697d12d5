"""Balls in the pockets of a cage, by the components of their motion."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.cage import ball_on_pocket_force, land_torque
from quasidynamic.contact.cage.pocket import BALL_FILM_LOAD
from quasidynamic.motion.ball_slip import AXIAL, ORBIT, TURN
from quasidynamic.parts.ball_cage import BallCage
from quasidynamic.parts.oil_properties import Lubricant

CREEP = 1e-3  # of the speed of the rings: least speed of the cage by which a lead becomes a displacement
ROUNDING = 1e-3  # of the load of the film at the wall: pocket force at which its friction sets in
IN_CAGE = np.eye(4)[AXIAL:TURN] - np.outer(
    [1.0, 0.0], np.eye(4)[ORBIT]
)  # spin against the cage by the motion
IN_CAGE_AT_REST = np.array([1.0, 0.0])
STANDSTILL = 1e-3  # of the speed of the rings: spin at which the friction of the pocket turns round


class PocketForces(NamedTuple):
    """What pockets do to balls, by the components of their motion."""

    left: NDArray  # (N, 4) [N m]
    slopes: NDArray  # (N, 4, 4) [N m]; those by the speed of the cage are the ones by `ORBIT`
    displacement: NDArray  # (N) [m] of the ball from the pocket centre, signed like the speed of the rings
    force: NDArray  # (N) [N] of the ball on the cage, signed alike
    torque: NDArray  # (N) [N m] of force and friction on the cage about the shaft, the same by `ORBIT`
    heat: NDArray  # (N) [N m] of friction, and of the film that the ball displaces


class CageTorque(NamedTuple):
    """Torque of the land on cages (G), signed like the speed of the rings."""

    torque: NDArray  # [N m]
    by_speed: NDArray  # [N m] by the speed of the cage
    heat: NDArray  # [N m]


@dataclass(frozen=True)
class Pockets:
    r"""Pockets of N balls; speeds are over that of the inner against the outer ring.

    .. math:: z = \frac{\pi d_m}{Z}\,\frac{\omega_m - \omega_c}{|\omega_{c0}|},\qquad
              M_p = \mu_p |F(z)| \frac{D}{2}

    A ball that orbits faster than the cage is ahead in its pocket by what it gains while the cage goes on by
    one ball. It pushes the cage with F, `ball_on_pocket_force`, and the pocket brakes its spin against the
    cage with M_p, but for that about the rolling direction; the part about the shaft drives the cage.
    omega_c0 is the speed of the cage without slip.

    Source
    ------
    Displacement by the lead: quasi-dynamic roller bearing programs, with omega_c for omega_c0. Balls of a
    cage that has neither land nor friction balance each other: it has the mean of their speeds.

    Valid
    -----
    Speeds that change little from ball to ball: the lead is that of one ball, not summed up along the orbit;
    the ball has no inertia along it. Friction of the pocket does not push balls in their section.
    """

    cage: BallCage
    stop: float  # [N/m^1.5] of the wall
    ball_radius: float  # [m]
    pitch_radius: float  # [m]
    advance: NDArray  # (N) [m] displacement by the lead of the orbit
    outer_speed: NDArray  # (N) [-] of the outer ring in space
    base: (
        NDArray  # (N) [-] speed in space that those of the cage are counted from, to keep digits of the lead
    )
    speed: NDArray  # (N) [-] of the cage beyond that

    def taken(self, keep: NDArray) -> "Pockets":
        """Return those of some of the balls."""
        arrays = {name: getattr(self, name)[keep] for name in ("advance", "outer_speed", "base", "speed")}
        return replace(self, **arrays)

    @property
    def film_stiffness(self) -> NDArray:
        """Torque about the shaft by the lead, of a film (N) [N m]."""
        return self.pitch_radius * self.advance * BALL_FILM_LOAD / self.cage.pocket_clearance

    def at_speed(self, speed: NDArray) -> "Pockets":
        """Return pockets of cages of this speed (N) [-] beyond the base."""
        return replace(self, speed=speed)

    @property
    def cage_speed(self) -> NDArray:
        """Speed of the cage in space (N) [-]."""
        return self.base + self.speed

    def lead(self, rolling: NDArray, change: NDArray) -> NDArray:
        """Lead (N) [-] of balls whose outer ring, seen from the orbit, is a change beyond that of rolling.

        Small differences stay apart from the speeds, whose rounding would be more than the film carries.
        """
        return (self.outer_speed - rolling - self.base) - change - self.speed

    def forces(self, motion: NDArray, lead: NDArray, part: NDArray | float = 1.0) -> PocketForces:
        """Forces at motions (N, 4), of the orbit by its lead (N) [-], with a part (N) of the friction."""
        displacement = self.advance * lead
        force, stiffness = ball_on_pocket_force(displacement, self.cage.pocket_clearance, self.stop)
        by_speed = self.advance * stiffness
        spin = motion @ IN_CAGE.T + (self.outer_speed - self.cage_speed)[:, None] * IN_CAGE_AT_REST
        turning = np.sqrt((spin**2).sum(1) + STANDSTILL**2)
        sense = spin / turning[:, None]
        rounded = np.sqrt(force**2 + (ROUNDING * BALL_FILM_LOAD) ** 2)
        share = force / rounded
        arm = part * self.cage.pocket_friction * self.ball_radius
        brake = arm * force * share
        along = sense @ IN_CAGE  # (N, 4)
        left = brake[:, None] * along
        left[:, ORBIT] -= self.pitch_radius * force
        outer = sense[:, :, None] * sense[:, None, :]
        turned = (brake / turning)[:, None, None] * (np.eye(2) - outer)
        slopes = IN_CAGE.T @ turned @ IN_CAGE
        slopes[:, :, ORBIT] -= (arm * share * (2 - share**2) * by_speed)[:, None] * along
        slopes[:, ORBIT, ORBIT] += self.pitch_radius * by_speed
        heat = self.pitch_radius * force * lead + brake * (sense * spin).sum(1)
        return PocketForces(left, slopes, displacement, force, -left[:, ORBIT], heat)


@dataclass(frozen=True)
class Cages:
    """Cages (G) of balls (N), and the rings that they run on; speeds are over that of the rings."""

    cage: BallCage
    oil: Lubricant
    of_ball: NDArray  # (N) number of the cage of each ball
    ring_speed: NDArray  # (G) [-] of the ring that guides, in space
    speed: NDArray  # (G) [rad/s] of the rings against each other, > 0
    base: NDArray  # (G) [-] speed of the cage in space that others are counted from, see `Pockets`

    def taken(self, keep: NDArray) -> "Cages":
        """Return those of some of the balls."""
        numbers, of_ball = np.unique(self.of_ball[keep], return_inverse=True)
        of_cages = {name: getattr(self, name)[numbers] for name in ("ring_speed", "speed", "base")}
        return replace(self, of_ball=of_ball, **of_cages)

    def land(self, speed: NDArray) -> CageTorque:
        """Torque of the land on cages of these speeds (G) [-]."""
        slip = self.ring_speed - speed
        land = land_torque(self.speed * slip, self.cage, self.oil)
        return CageTorque(land.torque, -self.speed * land.by_speed, land.torque * slip)

    def summed(self, of_balls: NDArray) -> NDArray:
        """Sum (G) over the balls (N) of each cage that have a number."""
        return np.bincount(self.of_ball, np.nan_to_num(of_balls), len(self.ring_speed))
