"""Slow balls between their rings: loads, motion, torque, and fields over their contacts."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse, sliding_friction, slip_field
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.contact.half_space import grid_over
from quasidynamic.contact.rolling.full_sliding import hertz_pressure
from quasidynamic.motion.ball_slip import DIAGONAL, BallContacts, slip_by_motion, slip_of
from quasidynamic.note import Note
from quasidynamic.outcome.ball_torque import (
    RaceTorques,
    hysteresis_torque,
    race_torques,
    torques_by_slip,
)
from quasidynamic.outcome.truncation import edge_angle, height_above_bottom
from quasidynamic.solve.balls.refined_rolling import RefinedRolling
from quasidynamic.solve.balls.rolling_motion import RollingMotion
from quasidynamic.solve.balls.sliding_motion import (
    SlidingMotion,
    pressed_on_both,
    rolling_heat,
    sliding_motion,
    sliding_motion_near,
)

RING_SIGN = np.array([1.0, -1.0])  # of the torques on inner and outer ring


@dataclass(frozen=True)
class SlidingBalls:
    """Balls that slide slowly between the rings: N balls, G diagonals, inner and outer race.

    Speeds are those for an inner ring that turns by one rad/s against the outer ring.
    """

    load: NDArray  # (N, G, 2) [N]
    whole: NDArray  # (N, G, 2) [N] of contacts that no shoulder cuts off, same approach, as the ellipses are
    contacts: BallContacts
    ellipse: Ellipse
    peak_pressure: NDArray  # (N, G, 2) [Pa]
    friction: NDArray  # (N, G, 2) [-] coefficient
    reach: NDArray  # (N, G, 2) [m] of the contacts, from the contact angle towards the shoulder
    hysteresis_loss: float  # [-] part of the elastic work lost in rolling
    notes: tuple[Note, ...]  # what a user must know
    near: NDArray | None = None  # (N, 3) [rad/s] motion of balls that differ little

    @cached_property
    def sliding(self) -> SlidingMotion:
        """Their motion, found when it is first needed; raises `NotSolved` when a ball finds no balance."""
        if self.near is None:
            return sliding_motion(self.contacts, self.ellipse)
        return sliding_motion_near(self.contacts, self.ellipse, self.near)

    @property
    def carried_shares(self) -> NDArray:
        """Load of contacts over that of whole ones, same approach (N, G, 2) [-]."""
        return np.where(self.whole > 0, self.load / np.where(self.whole > 0, self.whole, 1.0), 1.0)

    @cached_property
    def torques(self) -> RaceTorques:
        """Of the balls on both rings."""
        return race_torques(self.contacts, self.sliding.slip, self.ellipse)

    @cached_property
    def hysteresis(self) -> NDArray:
        """Torque of elastic hysteresis (N) [N m]."""
        return hysteresis_torque(self.sliding.slip, self.load, self.ellipse.along, self.hysteresis_loss)

    @property
    def driven(self) -> NDArray:
        """Whether each ball is pressed on both rings (N)."""
        return pressed_on_both(self.ellipse)

    @property
    def rolling_torque(self) -> float:
        """Torque of balls that roll on their stronger diagonals [N m], with more heat than they have."""
        slip, power = rolling_heat(self.contacts, self.ellipse)
        lost = hysteresis_torque(slip, self.load, self.ellipse.along, self.hysteresis_loss)
        return float(power.sum() + lost.sum())

    @property
    def ball_torques(self) -> NDArray:
        """Torque of each ball (N) [N m], the heat of its sliding and hysteresis per speed of the ring."""
        return self.sliding.power + self.hysteresis

    @property
    def torque(self) -> float:
        """Torque of all balls [N m]."""
        return float(self.ball_torques.sum())

    @property
    def ball_speed(self) -> NDArray:
        """Speed of each ball over that of the inner ring, both seen from the orbiting ball centre (N) [-]."""
        outer, axial, radial = self.sliding.motion.T
        return np.hypot(axial, radial) / (1.0 + outer)

    @property
    def axis_angle(self) -> NDArray:
        """Angle of the ball speed from that of the inner ring (N) [rad], pi where the axes are parallel."""
        _, axial, radial = self.sliding.motion.T
        return np.mod(np.arctan2(radial, axial), 2 * np.pi)

    def torque_with(self, spin: Spin) -> float:
        """Torque at the same motion with another spin across [N m], above that of its own by second order."""
        driven = self.sliding.driven
        other = replace(self.ellipse.taken(driven), spin=spin)
        return float(sliding_friction(self.sliding.slip[driven], other).power.sum() + self.hysteresis.sum())

    def truncated(self, race: int, groove_radius: float, groove_end: float) -> NDArray:
        """Whether shoulders at an angle [rad] cut off contacts with a race (N, G), see `truncation`."""
        edge = edge_angle(self.contacts.angle[..., race], self.reach[..., race], groove_radius, "arc")
        return (edge > groove_end) & (self.load[..., race] > 0)

    def needed_shoulders(self, race: int, groove_radius: float, aside: float) -> NDArray:
        """Height of a race above the bottom of its groove up to which contacts reach (N, G) [m].

        The centres of its arches lie a distance [m] aside of the middle; zero without a load. On a
        lower shoulder contacts are cut off.
        """
        angle, across = (values[..., race] for values in (self.contacts.angle, self.reach))
        edge = edge_angle(np.abs(angle), across, groove_radius, "arc")
        return np.where(self.load[..., race] > 0, height_above_bottom(edge, groove_radius, aside), 0.0)

    def field(self, ball: int, diagonal: int, race: int, points: int = 41) -> dict[str, NDArray]:
        """Cells (points, points) of a contact: places [m], pressure, stress on the ball [Pa], slip [m/s].

        Pressure is the mean of each cell, slip that of its centre; `stick` is zero everywhere.
        """
        contact = (np.array([ball]), diagonal, race)
        ellipse = Ellipse(
            *(getattr(self.ellipse, name)[contact] for name in ("across", "along", "radius", "traction")),
            spin=self.ellipse.spin,
        )
        semi_axes = float(ellipse.across[0]), float(ellipse.along[0])
        grid = grid_over(semi_axes, (points, points))
        x, y = np.broadcast_arrays(*grid.centres)
        along, across = slip_field(self.sliding.slip[contact], ellipse, x, y)
        pressure = hertz_pressure(grid, semi_axes, float(self.load[ball, diagonal, race]))
        limit = self.friction[ball, diagonal, race] * pressure
        size = np.maximum(np.hypot(along, across), np.finfo(float).tiny)
        return {
            "x": x,
            "y": y,
            "slip_along": along * (pressure > 0.0),
            "slip_across": across * (pressure > 0.0),
            "shear_along": -limit * (along / size),
            "shear_across": -limit * (across / size),
            "pressure": pressure,
            "stick": np.zeros(grid.shape),
        }


@dataclass(frozen=True, kw_only=True)
class RollingBalls(SlidingBalls):
    """Balls whose contacts stick and slip; what the fields of full sliding hold is that of stick and slip."""

    rolled: tuple[RefinedRolling | None, ...]  # (N) None for balls that are not pressed on both rings
    moved: tuple[SlidingMotion, RaceTorques, NDArray]  # motion, torques, hysteresis

    @cached_property
    def sliding(self) -> SlidingMotion:
        """Their motion."""
        return self.moved[0]

    @cached_property
    def torques(self) -> RaceTorques:
        """Of the balls on both rings."""
        return self.moved[1]

    @cached_property
    def hysteresis(self) -> NDArray:
        """Torque of elastic hysteresis (N) [N m]."""
        return self.moved[2]

    @property
    def grid_error(self) -> NDArray:
        """Error of the torque of each ball by its grid (N) [N m], see `RefinedRolling.grid_error`."""
        return np.array([0.0 if ball is None else ball.grid_error for ball in self.rolled])

    @property
    def turn(self) -> NDArray:
        """Turn of each ball about the rolling direction (N) [rad/s]."""
        return np.array([np.nan if ball is None else ball.fine.motion[3] for ball in self.rolled])

    @property
    def stick_share(self) -> NDArray:
        """Part of the cells of each contact that stick (N, G, 2) [-]."""
        return self._by_contact(lambda state: state.rolled.stick_share)

    @property
    def cut(self) -> NDArray:
        """Whether a shoulder cuts a contact whose pressure is computed (N, G, 2)."""
        return self._by_contact(lambda state: state.ball.cut) > 0.0

    def _by_contact(self, values: Callable[[RollingMotion], NDArray]) -> NDArray:
        """Values (C) of the contacts of each ball that is driven (N, G, 2), zero for the others."""
        spread = np.zeros(self.load.shape)
        for number, ball in enumerate(self.rolled):
            if ball is not None:
                spread[number][self.load[number] > 0.0] = values(ball.fine)
        return spread

    def field(self, ball: int, diagonal: int, race: int, points: int = 0) -> dict[str, NDArray]:
        """Places [m], pressure, shear stress on the ball [Pa], slip [m/s] and stick of the cells (ny, nx)."""
        solved = self.rolled[ball]
        assert solved is not None  # of a ball that is driven
        return solved.fine.cells(int((self.load[ball].ravel() > 0.0)[: 2 * diagonal + race].sum()))


def rolling_balls(
    sliding: SlidingBalls,
    rolled: Mapping[int, RefinedRolling],
    hysteresis_loss: float,
    computed_pressure: bool = False,
) -> RollingBalls:
    """Balls with stick and slip, in the place of those in full sliding.

    `rolled` has those that are driven, by their number; `hysteresis_loss` is the part of the elastic work
    lost in rolling [-], `computed_pressure` whether the pressure is not that of Hertz.

    Source
    ------
    Forces and moments of the tractions, see `RollingBall` and `race_torques`.
    """
    motion, contacts = sliding.sliding.motion.copy(), sliding.contacts
    power, imbalance = np.zeros((2, len(motion)))
    by_slip = np.zeros((2, *sliding.sliding.slip.shape))  # of tractions along and across
    for number, ball in rolled.items():
        state, loaded = ball.fine, sliding.load[number] > 0.0
        motion[number], power[number], imbalance[number] = state.motion[:3], state.power, state.imbalance
        by_slip[:, number, loaded] = -state.ball.power_by_slip(state.motion, state.rolled)[..., :3]
    slip = slip_of(motion, slip_by_motion(contacts))
    torques = torques_by_slip(contacts, by_slip.sum(0), by_slip[1])
    unbalanced = torques.total - RING_SIGN * power[:, None]  # by heat a thousand times more exact
    moved = (
        replace(sliding.sliding, motion=motion, slip=slip, power=power, imbalance=imbalance),
        replace(torques, roll=torques.roll - unbalanced),
        hysteresis_torque(slip, sliding.load, sliding.ellipse.along, hysteresis_loss),
    )
    changed: dict[str, Any] = _computed(sliding, rolled) if computed_pressure else {}
    same: dict[str, Any] = {part.name: getattr(sliding, part.name) for part in fields(SlidingBalls)}
    balls = [rolled.get(number) for number in range(len(motion))]
    return RollingBalls(**same | changed, rolled=tuple(balls), moved=moved)


def _computed(sliding: SlidingBalls, rolled: Mapping[int, RefinedRolling]) -> dict[str, NDArray]:
    """Peak pressure [Pa] of the cells, and the reach of the contacts [m]; those of Hertz for other balls."""
    peak, reach = sliding.peak_pressure.copy(), sliding.reach.copy()
    for number, ball in rolled.items():
        loaded, contacts = sliding.load[number] > 0.0, ball.fine.ball.contacts
        side = -DIAGONAL[np.nonzero(loaded)[0], None, None]  # of the shoulder
        edge = side * contacts.places()[1] + np.array([[[grid.spacing[1] / 2]] for grid in contacts.grids])
        peak[number][loaded] = contacts.limit.max((1, 2)) / sliding.friction[number][loaded]
        reach[number][loaded] = np.where(contacts.limit > 0.0, edge, 0.0).max((1, 2))
    return {"peak_pressure": peak, "reach": reach}
