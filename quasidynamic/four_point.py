"""Slow ball bearings of two or four contact points, put together."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.balance.balls.rolling_ball import rolling_ball
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.point_contact import PointContact, point_contact, race_curvatures
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.contact.half_space import ElasticPair, elastic_pair
from quasidynamic.contact.pressure import BallInGroove, GroovePress, PressedGroove
from quasidynamic.errors import ImpossiblePart, OutOfRange
from quasidynamic.motion.ball_slip import SIDE, BallContacts, pressed_height, pressed_radius, steepest
from quasidynamic.note import Note, outside
from quasidynamic.outcome.slow_balls import RollingBalls, SlidingBalls, rolling_balls
from quasidynamic.parts.ball import FourPointBearing, FrictionCurve
from quasidynamic.solve.balls.elastic_load_distribution import (
    ElasticBallLoads,
    elastic_ball_loads,
    elastic_ball_loads_near,
)
from quasidynamic.solve.balls.load_distribution import BallLoads, ball_loads, ball_loads_near
from quasidynamic.solve.balls.refined_rolling import RefinedRolling, RollingModel, refined_rolling

FINER = 2  # cells in each direction on which a pressure is computed, for one on which friction is
STEEPEST = np.pi / 2  # [rad] a contact angle stays below

ContactPressure = Literal["hertz", "offset", "translation"]  # of Hertz, or computed, see `GroovePress`


@dataclass(frozen=True, kw_only=True)
class RingLoad:
    """Load on the inner ring."""

    axial: float = 0.0  # [N] along x
    radial_y: float = 0.0  # [N]
    radial_z: float = 0.0  # [N] where azimuths begin
    moment_y: float = 0.0  # [N m] right-handed about y
    moment_z: float = 0.0  # [N m] right-handed about z

    def vector(self) -> NDArray:
        """Fx, Fy, Fz [N], My, Mz [N m]."""
        return np.array([self.axial, self.radial_y, self.radial_z, self.moment_y, self.moment_z])


@dataclass(frozen=True)
class FourPointEquilibrium:
    """A loaded four-point bearing that turns slowly."""

    distribution: BallLoads
    balls: SlidingBalls

    @property
    def torque(self) -> float:
        """Torque that turns the bearing [N m]."""
        return self.balls.torque


@dataclass(frozen=True, kw_only=True)
class FourPointBallBearing:
    """A four-point bearing with its friction."""

    bearing: FourPointBearing
    friction: FrictionCurve
    hysteresis_loss: float = 0.0  # [-] part of the elastic work lost in rolling
    spin: Spin = "centre"  # that makes slip across in contacts: of their middle as Jones, or of each point
    contact_pressure: ContactPressure = "hertz"  # of contacts that stick and slip
    interface_compliance: float = 0.0  # [m] elastic slip of an interface at mu p; assumed, none by theory

    def __post_init__(self):
        if not 0.0 <= self.hysteresis_loss < 1.0:
            raise ImpossiblePart(f"hysteresis_loss = {self.hysteresis_loss!r} must be in [0, 1)")
        if not 0.0 <= self.interface_compliance < np.inf:
            raise ImpossiblePart(
                f"interface_compliance = {self.interface_compliance!r} m must be finite, >= 0"
            )

    def solve(
        self,
        load: RingLoad,
        grooves: ElasticGrooves | None = None,
        near: FourPointEquilibrium | None = None,
        speed: float = 0.0,
        start: BallLoads | None = None,
    ) -> FourPointEquilibrium:
        """Load distribution, then the motion and torque of every ball.

        At a speed of the inner ring [rad/s], the outer one at rest, balls have a centrifugal force and a
        gyroscopic moment in the distribution; motion and torque are those of friction alone.

        Grooves are those of elastic rings, see `elastic_ball_loads`. Near the equilibrium of a bearing and a
        load that differ little, one step of Newton's method is taken, which is exact to first order in the
        difference. Between rigid rings the balance under another load may be given as a `start`, where the
        search begins.
        Raises `ImpossiblePart`, `NotSolved` or `OutOfRange`, see `ball_loads`, `elastic_ball_loads`,
        `sliding_motion` and `slide`.
        """
        distribution = self._distribution(load.vector(), grooves, near and near.distribution, speed, start)
        motion = None if near is None else near.balls.sliding.motion
        balls = self.slide(distribution.angles, distribution.loads, motion, distribution.whole)
        return FourPointEquilibrium(distribution, balls)

    def _distribution(
        self,
        load: NDArray,
        grooves: ElasticGrooves | None,
        near: BallLoads | None,
        speed: float,
        start: BallLoads | None,
    ) -> BallLoads:
        if grooves is None:
            if near is None:
                return ball_loads(self.bearing, load, speed, start)
            return ball_loads_near(self.bearing, load, near, speed)
        if near is None:
            return elastic_ball_loads(self.bearing, load, grooves, speed)
        assert isinstance(near, ElasticBallLoads)  # as it is between elastic rings
        return elastic_ball_loads_near(self.bearing, load, grooves, near, speed)

    def slide(
        self, angle: NDArray, load: NDArray, near: NDArray | None = None, whole: NDArray | None = None
    ) -> SlidingBalls:
        """Motion and torque of N balls whose contact angles [rad] and loads [N] (N, G, 2) are known.

        They are those at the inner and the outer race of one or two diagonals; `near` (N, 3) is the motion of
        balls that differ little, see `sliding_motion_near` [rad/s]; `whole` are the loads of contacts that
        shoulders cut off if they were whole. The motion is found when it is first
        needed, with `NotSolved` when a ball finds no balance.
        Raises `ImpossiblePart` when an angle or a load cannot be, `OutOfRange` when a contact is no longer
        small.
        """
        angle, load = np.asarray(angle, dtype=float), np.asarray(load, dtype=float)
        _check(angle, load)
        contact = self._contact(angle)
        whole = load if whole is None else whole
        across, along = contact.semi_axes(whole)
        pressure = contact.peak_pressure(whole)
        coefficient = self.friction.at(pressure)
        radius = self.bearing.ball.diameter / 2
        ellipse = Ellipse(across, along, self._surface(angle), coefficient * load, self.spin)
        if not np.all(across < radius):
            raise OutOfRange(
                f"semi-axis {1e3 * across.max():.4g} mm of a contact is not below the ball radius "
                f"{1e3 * radius:.4g} mm: the load is far too high"
            )
        contacts = BallContacts(
            ball_radius=np.full(len(angle), radius),
            pitch_radius=np.full(len(angle), self.bearing.pitch_diameter / 2),
            angle=angle,
            height=pressed_height(np.asarray(radius), self._surface(angle), across),
        )
        return SlidingBalls(
            load=load,
            whole=whole,
            contacts=contacts,
            ellipse=ellipse,
            peak_pressure=pressure,
            friction=coefficient,
            reach=across,
            hysteresis_loss=self.hysteresis_loss,
            notes=self._notes(pressure, coefficient * load),
            near=near,
        )

    def roll(
        self,
        sliding: SlidingBalls,
        model: RollingModel,
        cells: tuple[int, int] = (40, 80),
        progress: Callable[[float], None] = lambda _: None,
        mapped: Callable[..., Iterable[RefinedRolling]] = map,
    ) -> RollingBalls:
        """Motion and torque of balls whose contacts stick and slip, each from its own in full sliding.

        `cells` are those over each contact, along and across the rolling direction; `progress` takes the part
        of the balls that are solved, and `mapped` calls a function for each ball as `map` does, such as on
        several cores.
        Raises `OutOfRange` or `NotSolved`, see `refined_rolling`, and `GroovePress.pressed` where the
        pressure is computed.
        """
        ball, races = self.bearing.ball.material, (self.bearing.inner, self.bearing.outer)
        pairs = (elastic_pair(ball, races[0].material), elastic_pair(ball, races[1].material))
        rolled, driven = {}, list(map(int, np.flatnonzero(sliding.sliding.driven)))
        grooves = partial(self._grooves, pairs, cells)
        each = partial(_refined, pairs, self.interface_compliance, model, cells, grooves)
        refined = mapped(each, [_Ball.of(sliding, one) for one in driven])
        for number, one in zip(driven, refined, strict=True):
            rolled[number] = one
            progress(len(rolled) / len(driven))
        return rolling_balls(sliding, rolled, self.hysteresis_loss, self.contact_pressure != "hertz")

    def _grooves(
        self, pairs: tuple[ElasticPair, ElasticPair], cells: tuple[int, int], ball: "_Ball"
    ) -> tuple[PressedGroove, ...]:
        """Grooves that press a ball, those with a load; none where the pressure is that of Hertz."""
        if self.contact_pressure == "hertz":
            return ()
        bearing, grooves = self.bearing, []
        for place in zip(*np.nonzero(ball.load > 0.0), strict=True):
            race, angle = place[2], float(ball.contacts.angle[place])
            radius, end = float(bearing.groove_radii[race]), bearing.groove_ends[race]
            if angle >= end:
                raise OutOfRange(
                    f"a ball has turned to a contact angle of {np.degrees(angle):.1f} deg, over the shoulder "
                    f"at {np.degrees(end):.1f} deg: there is no pressure to compute"
                )
            groove = BallInGroove(
                ball_radius=bearing.ball.diameter / 2,
                groove_radius=radius,
                pitch_diameter=bearing.pitch_diameter,
                contact_angle=angle,
                side=float(SIDE[race]),
                shoulder=radius * (end - angle),
            )
            semi_axes = float(ball.ellipse.along[place]), float(ball.ellipse.across[place])
            press = GroovePress(groove, pairs[race], float(ball.load[place]), self.contact_pressure)
            grooves.append(press.pressed(semi_axes, (FINER * cells[0], FINER * cells[1])))
        return tuple(grooves)

    def _contact(self, angle: NDArray) -> PointContact:
        bearing = self.bearing
        curvatures = race_curvatures(
            bearing.ball.diameter, bearing.groove_radii, bearing.pitch_diameter, angle, SIDE
        )
        return point_contact(curvatures, bearing.moduli)

    def _surface(self, angle: NDArray) -> NDArray:
        """Radii of the pressed surfaces (N, G, 2) [m]."""
        radii = pressed_radius(np.asarray(self.bearing.ball.diameter / 2), self.bearing.groove_radii)
        return np.broadcast_to(radii, angle.shape)

    def _notes(self, pressure: NDArray, traction: NDArray) -> tuple[Note, ...]:
        beyond = self.friction.outside(pressure) & (traction > 0.0)
        if not beyond.any():
            return ()
        low, high = self.friction.pressures[0] / 1e9, self.friction.pressures[-1] / 1e9
        share = traction[beyond].sum() / traction.sum()
        return (
            outside(
                "friction-curve",
                f"friction: {beyond.sum()} contacts with {share:.0%} of the friction force have a peak "
                f"pressure outside the {low:.3g} to {high:.3g} GPa of the friction curve: that of its "
                "end is used",
            ),
        )


class _Ball(NamedTuple):
    """One ball in full sliding, for itself."""

    contacts: BallContacts  # (1, G, 2)
    ellipse: Ellipse
    load: NDArray
    motion: NDArray  # (4)

    @classmethod
    def of(cls, sliding: SlidingBalls, number: int) -> "_Ball":
        one, motion = np.array([number]), np.append(sliding.sliding.motion[number], 0.0)
        return cls(sliding.contacts.taken(one), sliding.ellipse.taken(one), sliding.load[one], motion)


def _refined(
    pairs: tuple[ElasticPair, ElasticPair],
    interface: float,
    model: RollingModel,
    cells: tuple[int, int],
    grooves: Callable[[_Ball], tuple[PressedGroove, ...]],
    ball: _Ball,
) -> RefinedRolling:
    ball_on = partial(rolling_ball, ball.contacts, ball.ellipse, ball.load, pairs, grooves=grooves(ball))
    return refined_rolling(lambda cells: ball_on(cells).with_interface(interface), model, cells, ball.motion)


def _check(angle: NDArray, load: NDArray) -> None:
    if angle.shape != load.shape or angle.ndim != 3 or angle.shape[1] not in (1, 2) or angle.shape[2] != 2:
        raise ImpossiblePart(
            f"contact angles {angle.shape} and loads {load.shape} must both be (balls, diagonals, 2 races)"
        )
    if not np.all((load >= 0.0) & np.isfinite(load)):
        raise ImpossiblePart("contact loads must be finite and >= 0")
    largest = steepest(angle, load)
    if not largest < STEEPEST:
        raise OutOfRange(
            f"contact angles of up to {np.degrees(largest):.1f} deg: balls leave their grooves, "
            "the load is far too high"
        )
