"""Oil at balls that two races drive: tractions, rolling friction and the mixture around them."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.caged_ball import Pockets
from quasidynamic.contact.drag import ball_churning, ball_drag_force
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.general_sliding import EllipsePoints, GeneralSliding
from quasidynamic.contact.ellipse.rigid_slip import CENTRE
from quasidynamic.contact.film import Film
from quasidynamic.contact.lubricated_ellipse import LubricatedRaces
from quasidynamic.contact.traction import RollingShear
from quasidynamic.motion.ball_slip import AXIAL, ORBIT, BallContacts

INLET_SHARE, INLET_SHARPNESS = 0.01, 10  # of the load: most shear of an inlet in a cage, assumed; of its bend
STANDSTILL = 1e-5  # of the pitch radius: mean surface speed over that of the rings below which it is rounded


class OiledFriction(NamedTuple):
    """What the oil does in the contacts (N, 2) of balls at one motion."""

    sliding: GeneralSliding
    film: Film
    rolling: RollingShear
    entrainment: NDArray  # [m] mean surface speed over that of the rings, > 0
    sense: NDArray  # [-] its sign, smooth through zero


class MixtureForces(NamedTuple):
    """Drag and churning of balls, by the components of their motion."""

    left: NDArray  # (N, 4) [N m]
    slopes: NDArray  # (N, 4, 4) [N m]
    drag: NDArray  # (N) [N] against the orbit
    churning: NDArray  # (N) [N m] against the spin
    orbit: NDArray  # (N) [-] speed of the orbit in space
    spin: NDArray  # (N) [-] size of the spin in space


@dataclass(frozen=True)
class OiledContacts:
    r"""Laws of the oil for N balls, speeds over that of the inner against the outer ring.

    .. math:: \bar u = \tfrac12 (u_{ball} + u_{race}) = \tfrac12 [A_{ball} h_0 + \Omega (R_c + n_r h_0)]

    Traction works on the slip, the difference of both surface speeds; the shear F of the inlet on their sum:
    on the ball it acts at the contact, and the pressure of the inlet, 2 F (R_c + n_r h_0)/R_c, at its centre.

    Of a lightly pressed ball without a cage the races overcome the part `hold` of inlets, drag and churning
    alone, instead of a cage that would carry it against the rest. In a cage the inlet of each contact has its
    part: none where no load is. Its shear stays below `INLET_SHARE` of the load, which the law exceeds at
    loads far below those that it holds for.

    Source
    ------
    Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 1, for shear and pressure of the inlet: virtual
    power of both is 2 F per mean surface speed.
    """

    races: LubricatedRaces
    speed: NDArray  # (N) [rad/s] of the rings against each other, > 0
    hold: NDArray  # (N, 2) [-] part of the loads that drive which is there, see `driving_load`
    mean_by_motion: NDArray  # (N, 2, 4) [m] mean surface speed by the motion, of rings seen from the orbit
    pockets: Pockets | None = None  # that push the balls along; None: no cage

    def taken(self, keep: NDArray) -> "OiledContacts":
        """Return that of some of the balls."""
        mean, pockets = self.mean_by_motion[keep], self.pockets and self.pockets.taken(keep)
        return replace(
            self, speed=self.speed[keep], hold=self.hold[keep], mean_by_motion=mean, pockets=pockets
        )

    def friction(
        self, slip: NDArray, mean: NDArray, bodies: tuple[BallContacts, Ellipse], points: EllipsePoints
    ) -> OiledFriction:
        """Friction by slip (N, 2, 5) and mean speed (N, 2) [m]; the ellipse has the load for its friction."""
        contacts, ellipse = bodies
        entrainment = np.sqrt(mean**2 + (STANDSTILL * contacts.pitch_radius[:, None]) ** 2)
        speed = self.speed[:, None] * entrainment
        sliding, film = self.races.traction(slip, ellipse, self.speed, speed, points)
        rolling = self.races.rolling(ellipse.traction, ellipse.width, speed)
        part = self.hold
        if self.pockets is None:
            part = part.prod(1, keepdims=True)
        else:
            rolling = _limited(rolling, ellipse.traction)
        rolling = RollingShear(*(part * each for each in rolling))
        return OiledFriction(sliding, film, rolling, entrainment, mean / entrainment)

    def rolling_by_motion(self, friction: OiledFriction) -> NDArray:
        """Power of rolling friction on a unit of each component of the motion, by contact (N, 2, 4) [N m]."""
        return (2 * friction.sense * friction.rolling.force)[..., None] * self.mean_by_motion

    def by_speed(self, friction: OiledFriction, by_unknown: NDArray, mean_by_unknown: NDArray) -> NDArray:
        """Derivatives (N, 2, 5, 4) of the power of traction by slip, as speed and film change it."""
        sliding, film, speed = friction.sliding, friction.film, self.speed[:, None, None]
        by_speed = (speed * friction.sense[..., None]) * mean_by_unknown  # (N, 2, 4) of u [m/s]
        by_slip = speed * by_unknown[..., CENTRE, :]
        film_by = film.by_entrainment[..., None] * by_speed + film.by_sliding[..., None] * by_slip
        assert sliding.by_entrainment is not None  # of lubricated contacts
        assert sliding.by_film is not None
        changed = sliding.by_entrainment[..., None] * by_speed[..., None, :]
        return changed + sliding.by_film[..., None] * film_by[..., None, :]

    def rolling_slopes(self, friction: OiledFriction, mean_by_unknown: NDArray) -> tuple[NDArray, NDArray]:
        """Slopes (N, 4, 4) of the balance by rolling friction, and what they nowhere exceed (N, 4)."""
        rolling, sense = friction.rolling, friction.sense
        whole = 2 * rolling.force / friction.entrainment
        steep = 2 * sense**2 * rolling.by_entrainment * self.speed[:, None] + whole * (1 - sense**2)
        slopes = np.einsum("ng,ngj,ngk->njk", steep, mean_by_unknown, mean_by_unknown)
        return slopes, np.einsum("ng,ngj->nj", whole, mean_by_unknown**2)

    def mixture(self, motion: NDArray, contacts: BallContacts, outer_speed: NDArray) -> MixtureForces:
        """Drag of the orbit and churning of the spin in space at motions (N, 4); the mixture is at rest."""
        laws, count = self.races.lubrication, len(motion)
        diameter = 2 * float(contacts.ball_radius[0])
        pitch, orbit = contacts.pitch_radius, outer_speed - motion[:, ORBIT]
        drag, by_speed = ball_drag_force(
            self.speed * pitch * orbit, diameter, laws.oil, laws.oil_fraction, laws.drag_coefficient
        )
        part = self.hold.prod(1) if self.pockets is None else 1.0
        drag, by_speed = part * drag, part * by_speed
        left, slopes = np.zeros((count, 4)), np.zeros((count, 4, 4))
        left[:, ORBIT] = -pitch * drag
        slopes[:, ORBIT, ORBIT] = self.speed * pitch**2 * by_speed
        spin, in_space = motion[:, AXIAL:].copy(), np.eye(4)[AXIAL:]
        spin[:, 0] += orbit
        in_space[0, ORBIT] = -1.0
        size, churning = np.linalg.norm(spin, axis=1), np.zeros(count)
        if laws.churning_gap is not None:
            along = spin / np.where(size > 0, size, 1.0)[:, None]
            churning, by_spin = ball_churning(
                self.speed * size, diameter, laws.oil, oil_fraction=laws.oil_fraction, gap=laws.churning_gap
            )
            churning, by_spin = part * churning, part * by_spin
            whole = (churning / np.where(size > 0, size, 1.0))[:, None, None]
            outer = along[:, :, None] * along[:, None, :]
            matrix = whole * (np.eye(3) - outer) + (self.speed * by_spin)[:, None, None] * outer
            left += (churning[:, None] * along) @ in_space
            slopes += in_space.T @ matrix @ in_space
        return MixtureForces(left, slopes, np.abs(drag), churning, orbit, size)


def _limited(rolling: RollingShear, load: NDArray) -> RollingShear:
    """Shear of inlets that stays below a share of the load [N]; without a slope by the load."""
    bend = 1 + (rolling.force / (INLET_SHARE * load)) ** INLET_SHARPNESS
    part = bend ** (-1 / INLET_SHARPNESS)
    return RollingShear(part * rolling.force, np.zeros_like(load), part / bend * rolling.by_entrainment)


def mean_by_motion(centre: NDArray) -> NDArray:
    """Mean surface speed (N, 2, 4) [m] by the motion, from the slip of the centre (N, 2, 4)."""
    mean = centre / 2
    mean[..., ORBIT] *= -1.0  # the race is minus its part of the slip
    return mean
