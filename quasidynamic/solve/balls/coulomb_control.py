"""What Coulomb friction on both races makes balls do."""

from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.caged_ball import CREEP, Cages, Pockets
from quasidynamic.balance.balls.free_ball import FreeBalls, OiledBalls, free_balls
from quasidynamic.balance.balls.light_ball import CAGED, RELEASE
from quasidynamic.balance.balls.race_control import (
    BallKinematics,
    LoadedContacts,
    PrescribedControl,
    RaceControl,
)
from quasidynamic.balance.balls.rolling_ball import RollingBall, rolling_balls
from quasidynamic.balance.balls.sliding_balls import driving_load
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.point_contact import Curvatures, PointContact, point_contact
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.contact.half_space import ElasticPair
from quasidynamic.contact.lubricated_ellipse import LubricatedRaces
from quasidynamic.motion.ball_slip import (
    AXIAL,
    INNER,
    ORBIT,
    OUTER,
    RADIAL,
    TURN,
    BallContacts,
    pressed_height,
    pressed_radius,
)
from quasidynamic.motion.roller_speeds import rolling_cage_speed
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing
from quasidynamic.parts.ball_cage import BallCage
from quasidynamic.parts.material import contact_modulus
from quasidynamic.solve.balls.caged_search import caged_ball_motion, on_base
from quasidynamic.solve.balls.free_ball_search import FreeBallMotion, free_ball_motion
from quasidynamic.solve.balls.sticking_ball_motion import sticking_ball_motion

RELEASED = (RELEASE, RELEASE / 8)  # of F_c: least driving load of the inner, of the outer race
UNEVEN = 0.05  # of the load on the other race: the same, away from balance
LEAST_CAGED = 1e-4  # assumed; of the largest load in the cage: the same
# Assumed, without a source: the same of balls in oil without a cage. What the oil does to lighter ones, by
# laws for pressed contacts, is more than friction holds.
LEAST_IN_OIL = 1e-3  # of the largest load in the bearing
STICKING_NOISE = 1e-8  # the same where contacts stick and slip
BLOCK = 64  # balls whose cells are in memory together
NOISE = 1e-9  # of the largest force: what is left of the balance of balls that friction moves
WIDEST = 0.9  # of the ball radius: semi-axis up to which a contact has a friction


class StickingContacts(NamedTuple):
    """How contacts stick and slip."""

    pairs: tuple[ElasticPair, ElasticPair]  # ball and inner, ball and outer race
    cells: tuple[int, int]  # over each contact, along and across the rolling direction
    interface: float = 0.0  # [m] its elastic slip at the limit of friction, see `RollingContacts`


class DrivenContacts(NamedTuple):
    """Contacts as friction sees them, N balls in a row, inner and outer race."""

    angles: NDArray  # (2, N) [rad]
    loads: NDArray  # (2, N) [N] that drive
    hold: NDArray  # (2, N) [-] part of these that is there
    hold_slopes: NDArray  # (2, 2, N) [1/m] by L of the same, of the other race
    chain: NDArray  # (N, 4, 4) slopes of ln N_i, alpha_i, ln N_o, alpha_o by L_i, alpha_i, L_o, alpha_o


@dataclass(frozen=True)
class CoulombControl:
    r"""Balls move as Coulomb friction balances their inertia, with no assumption on which race controls them.

    .. math:: T = -\int \mu p\, \frac{v_1}{|v|}\, dA

    All three components of the spin and the orbit follow from the balance of `FreeBalls`, for each ball alone
    and for its contacts as they are. Where friction cannot hold the gyroscopic
    moment the ball turns about the rolling direction, and the tractions stay below mu Q.

    A ball that the inner race presses lightly would slow down to where friction can drive it; in a bearing a
    cage carries it on. Without a cage no race drives with less than a share of F_c, see `driving_load`, the
    tractions being those of the true load, and the inner contact angle fades to the outer one with the inner
    load. With one the share is `CAGED`, see `caged_ball_motion`.

    With `stick` the contacts stick and slip as by FASTSIM, see `sticking_ball_motion`: a contact that spins
    pushes across, and the contact angles of both races part.

    Source
    ------
    Jones, J. Basic Eng. 81 (1959), for the slip; Harris and Kotzalas, Essential Concepts (2006), ch. 5, for
    balls that slide on both races; Johnson, J. Appl. Mech. 25 (1958), 332-338, for the force of spin.
    """

    bearing: AngularContactBearing
    contacts: tuple[PointContact, PointContact]  # with the inner and with the outer race
    friction: float  # [-] Coulomb coefficient
    spin: Spin = "centre"  # that makes slip across
    stick: StickingContacts | None = None  # None: full sliding
    oil: LubricatedRaces | None = None  # whose tractions take the place of the coefficient; None: dry
    cage: BallCage | None = None  # of balls in oil
    cage_speed: float | None = None  # [-] of the cage in space, held; None: by the balance of its moments

    @property
    def in_one_cage(self) -> bool:
        """Whether all balls are in one cage."""
        return self.cage is not None and len(self.bearing.rows) == 1

    @property
    def simpler(self) -> RaceControl:
        """Full sliding for contacts that stick; for it outer control: what friction comes to at high speed.

        Five times and a hundred times as quick.
        """
        return PrescribedControl(self.bearing, "outer") if self.stick is None else replace(self, stick=None)

    @property
    def noise(self) -> float:
        """What the search for the motion of balls leaves of their friction."""
        if self.cage_speed is not None:
            return NOISE / 10
        return NOISE if self.stick is None else STICKING_NOISE

    @property
    def cost(self) -> int:
        """A search for the motion of every ball, and less of all else."""
        if self.stick is not None:
            return 100
        if self.cage is not None and self.cage_speed is None:
            return 300
        return 20 if self.oil is None else 60

    @property
    def rolling_alone(self) -> bool:
        """Without a cage, which makes it orbit at its own speed."""
        return self.cage is None

    def kinematics(
        self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray, near: NDArray | None = None
    ) -> BallKinematics:
        """Motion of balls and what it asks of the races, see `RaceControl`."""
        bearing, shape = self.bearing, contacts.angles.shape[1:]
        driven, balls, ahead, outer = self._in_a_row(contacts, speeds, centrifugal, near)
        orbit = outer - ahead * balls.motion[:, ORBIT]
        turn = np.sign(ahead) * balls.motion[:, TURN]
        size = np.linalg.norm(balls.motion[:, AXIAL:], axis=1)
        slopes = np.einsum("nij,njk->ikn", balls.motion_slopes, driven.chain)
        across = np.einsum("ncj,njk->ckn", balls.across_slopes, driven.chain) * driven.hold[:, None]
        for race in (INNER, OUTER):
            across[race, [2 * race, 2 - 2 * race]] += driven.hold_slopes[:, race] * balls.across[:, race]
        mass = bearing.ball.mass * bearing.pitch_diameter
        kinematics = BallKinematics(
            orbit=orbit,
            spin=ahead * size,
            attitude=np.arctan2(balls.motion[:, RADIAL], 0.0 - balls.motion[:, AXIAL]),
            yaw=np.arcsin(turn / np.where(size > 0, size, 1.0)),
            centrifugal=0.5 * mass * orbit**2,
            centrifugal_slopes=-mass * orbit * ahead * slopes[ORBIT],
            gyroscopic=bearing.ball.inertia * orbit * ahead * balls.motion[:, RADIAL],
            tractions=driven.hold * balls.across.T,
            traction_slopes=across,
            near=balls.unknowns,
        )
        return BallKinematics(
            *(array.reshape(*array.shape[:-1], *shape) for array in kinematics[:-1]),
            near=np.concatenate([balls.unknowns, balls.cage[:, None]], axis=1).reshape(*shape, 5),
        )

    def heat(self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray) -> NDArray:
        """Heat of friction on both races (C, Z) [W]; for what is given see `RaceControl`."""
        driven, motion, ahead, outer = self._in_a_row(contacts, speeds, centrifugal)
        power, moving = motion.power, _moving(driven, ahead)
        if self.stick is None and moving.any():  # that of the search was one step away
            power[moving] = self._free(driven, ahead, outer, moving).powers(motion.motion[moving]).sliding
        heat = np.abs(ahead) * (driven.hold * power.T).sum(0)
        return heat.reshape(contacts.angles.shape[1:])

    def _in_a_row(
        self,
        contacts: LoadedContacts,
        speeds: NDArray,
        centrifugal: NDArray,
        near: NDArray | None = None,
        *,
        slopes: bool = True,
    ) -> tuple[DrivenContacts, FreeBallMotion, NDArray, NDArray]:
        """Balls (N) of all cases, speed of the inner against the outer ring, speed of the outer one."""
        shape = contacts.angles.shape[1:]
        flat = LoadedContacts(*(array.reshape(2, -1) for array in contacts))
        ahead, outer, free = (
            (array + np.zeros(shape)).ravel() for array in (speeds[0] - speeds[1], speeds[1], centrifugal)
        )
        driven = self.driven(flat, free)
        near = None if near is None else near.reshape(-1, 5)
        return driven, self.motion(driven, ahead, outer, near, slopes=slopes), ahead, outer

    def driven(self, contacts: LoadedContacts, centrifugal: NDArray) -> DrivenContacts:
        """Contacts as friction sees them; `contacts` (2, N), F_c (N) [N]."""
        (inner, outer), loads, stiffness = contacts
        apart, other = inner - outer, loads[::-1]
        released, uneven, least = RELEASED, UNEVEN, np.zeros_like(centrifugal)
        if self.cage is not None:
            released, uneven = (CAGED, CAGED), CAGED
        if self.oil is not None:
            of_rows = loads.reshape(2, -1, self.bearing.balls).max((0, 2))
            share = LEAST_IN_OIL if self.cage is None else LEAST_CAGED
            least = share * np.repeat(of_rows, self.bearing.balls)
        width = np.reshape(released, (2, 1)) * centrifugal + uneven * other
        part = least / np.maximum(least + width, np.finfo(float).tiny)  # one where nothing else is
        driving = driving_load(loads, width + part * least)
        by_width = uneven * (1 - part**2) * driving.by_width
        safe = np.where(driving.value > 0, driving.value, 1.0)
        by_own = stiffness * driving.by_load / safe
        by_other = stiffness[::-1] * by_width / safe
        hold_slopes = np.array([stiffness / safe - driving.hold * by_own, -driving.hold * by_other])
        chain = np.zeros((len(inner), 4, 4))
        chain[:, 0, 0], chain[:, 2, 2] = by_own
        chain[:, 0, 2], chain[:, 2, 0] = by_other
        chain[:, 1, 0], chain[:, 1, 2] = hold_slopes[:, 0] * apart
        chain[:, 1, 1], chain[:, 1, 3] = driving.hold[0], 1 - driving.hold[0]
        chain[:, 3, 3] = 1.0
        seen = np.array([outer + driving.hold[0] * apart, outer])
        return DrivenContacts(seen, driving.value, driving.hold, hold_slopes, chain)

    def motion(
        self,
        driven: DrivenContacts,
        ahead: NDArray,
        outer_speed: NDArray,
        near: NDArray | None = None,
        *,
        slopes: bool = True,
    ) -> FreeBallMotion:
        """Balance of balls (N) between rings of these speeds (N) [rad/s]; not a number where none is found.

        Of balls in oil from unknowns and speeds of the cage that are `near` (N, 5).

        Balls that nothing drives roll at no slope. Slopes of balls in oil take more time than all else.
        """
        moving = _moving(driven, ahead)
        motion = FreeBallMotion(
            *(np.zeros((len(ahead), *size)) for size in ((4,), (4, 4), (2,), (2, 4), (2,), (), (4,)))
        )
        motion.motion[:, ORBIT] = -(1 - self.bearing.diameter_ratio) / 2
        if moving.any():
            balls, loads = self._free(driven, ahead, outer_speed, moving), driven.loads[:, moving]
            if self.oil is None:
                found = self._sticking(balls, loads, free_ball_motion(balls))
            else:
                cages = self._cages(ahead, outer_speed, moving)
                start = None if near is None else near[moving]
                found = self._in_oil(self.oil, (balls, cages), loads, start, slopes=slopes)
            for array, part in zip(motion, found, strict=True):
                array[moving] = part
        return motion

    def _free(
        self, driven: DrivenContacts, ahead: NDArray, outer_speed: NDArray, moving: NDArray
    ) -> FreeBalls:
        """Balls that move, of all."""
        loads = driven.loads[:, moving]
        axes = self._axes(loads)
        return free_balls(
            self._places(driven.angles[:, moving].T, axes[:, 0].T),
            self._ellipses(axes, loads),
            self.bearing.ball.inertia * ahead[moving] ** 2,
            outer_speed[moving] / ahead[moving],
            self.oil and (self.oil, np.abs(ahead[moving]), driven.hold[:, moving].T),
            self._pockets(outer_speed[moving] / ahead[moving]),
        )

    def _pockets(self, outer_speed: NDArray) -> Pockets | None:
        """Pockets of a cage at rest around balls (N) between rings of this speed of the outer one (N) [-]."""
        bearing, cage = self.bearing, self.cage
        if cage is None:
            return None
        ball, radius, pitch = bearing.ball, bearing.ball.diameter / 2, bearing.pitch_diameter / 2
        ratio = bearing.diameter_ratio * np.cos(bearing.contact_angle)
        rolling = np.abs(rolling_cage_speed(1.0 + outer_speed, outer_speed, ratio))
        wall = Curvatures(np.array(1 / radius - 1 / (radius + cage.pocket_clearance)), np.array(1 / radius))
        return Pockets(
            cage=cage,
            stop=float(point_contact(wall, contact_modulus(ball.material, ball.material)).coefficient),
            ball_radius=radius,
            pitch_radius=pitch,
            advance=2 * np.pi * pitch / bearing.balls / np.maximum(rolling, CREEP),
            outer_speed=outer_speed,
            base=np.zeros_like(outer_speed),
            speed=np.zeros_like(outer_speed),
        )

    def _cages(self, ahead: NDArray, outer_speed: NDArray, moving: NDArray) -> Cages | None:
        """Cages of the balls (N) that move, of all, which are whole rows one after the other; or None."""
        if self.oil is None or self.cage is None:
            return None
        rows = np.flatnonzero(moving) // self.bearing.balls
        _, first, of_ball = np.unique(rows, return_index=True, return_inverse=True)
        ahead, outer_speed = ahead[moving][first], outer_speed[moving][first]
        turning = (1.0 if self.cage.guidance == "inner" else 0.0) + outer_speed / ahead
        base = np.zeros_like(turning)
        return Cages(self.cage, self.oil.lubrication.oil, of_ball, turning, np.abs(ahead), base)

    def oiled(
        self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray, near: NDArray | None = None
    ) -> OiledBalls:
        """What the oil does to balls (C, Z); for what is given see `RaceControl`. Zero of balls at rest."""
        driven, motion, ahead, outer = self._in_a_row(contacts, speeds, centrifugal, near, slopes=False)
        moving = _moving(driven, ahead)
        shape, arrays = contacts.angles.shape[1:], []
        balls, sense = self._free(driven, ahead, outer, moving), np.sign(ahead[moving])
        if (cages := self._cages(ahead, outer, moving)) is not None:
            balls = on_base(balls, cages)[0].in_cage(motion.cage[moving])
        found = balls.oiled(motion.motion[moving], motion.unknowns[moving], sense)
        if cages is not None:
            found = found.on_land(cages, sense)
        for part in found:
            array = np.zeros((*part.shape[1:], len(ahead)))
            array[..., moving] = np.moveaxis(part, 0, -1)
            arrays.append(array.reshape(*part.shape[1:], *shape))
        return OiledBalls(*arrays)

    def _in_oil(
        self,
        oil: LubricatedRaces,
        of_all: tuple[FreeBalls, Cages | None],
        loads: NDArray,
        near: NDArray | None,
        *,
        slopes: bool,
    ) -> FreeBallMotion:
        """Motion of balls (N) of loads (2, N) in oil, all of a cage together."""
        (balls, cages), found = of_all, []
        for block in _blocks(loads.shape[1], cages):
            some = balls.taken(block)
            nearby = partial(self._nearby, oil, some, loads[:, block]) if slopes else None
            start = None if near is None else near[block]
            if cages is None:
                found.append(free_ball_motion(some, nearby, *([] if start is None else [start[:, :4]])))
            else:
                found.append(caged_ball_motion(some, cages.taken(block), nearby, start, self.cage_speed))
        return FreeBallMotion(*(np.concatenate(arrays) for arrays in zip(*found, strict=True)))

    def _nearby(
        self, oil: LubricatedRaces, balls: FreeBalls, loads: NDArray, growth: float, turn: float
    ) -> FreeBalls:
        """Balls (N), their loads (2, N) times e^growth, their angles by a turn [rad] further."""
        assert balls.oil is not None
        more = np.exp(growth) * loads
        axes = self._axes(more)
        return free_balls(
            self._places(balls.contacts.angle[:, 0] + turn, axes[:, 0].T),
            self._ellipses(axes, more),
            balls.gyration,
            balls.outer_speed,
            (oil, balls.oil.speed, balls.oil.hold),
        )

    def _sticking(self, balls: FreeBalls, loads: NDArray, sliding: FreeBallMotion) -> FreeBallMotion:
        """Motion of balls (N) of loads (2, N) whose contacts stick, from that in full sliding."""
        stick, numbers = self.stick, np.arange(loads.shape[1])
        if stick is None:
            return sliding
        motion = FreeBallMotion(*(array.copy() for array in sliding))
        found = numbers[np.isfinite(sliding.motion).all(1)]
        for block in np.split(found, range(BLOCK, len(found), BLOCK)):
            some = balls.taken(block)
            contacts_at = partial(self._rolling, stick, some, loads[:, block])
            solution = sticking_ball_motion(some, contacts_at, sliding.motion[block])
            for array, part in zip(motion, solution, strict=True):
                array[block] = part
        return motion

    def _rolling(
        self, stick: StickingContacts, balls: FreeBalls, loads: NDArray, growth: float, turn: float
    ) -> RollingBall:
        """Contacts of balls (N), their loads (2, N) times e^growth, their angles by a turn [rad] further."""
        more = np.exp(growth) * loads
        axes = self._axes(more)
        places = self._places(balls.contacts.angle[:, 0] + turn, axes[:, 0].T)
        ellipse = self._ellipses(axes, more)
        ball = rolling_balls(places, ellipse, balls.unknowns, stick.pairs, stick.cells)
        return ball.with_interface(stick.interface)

    @property
    def widest(self) -> float:
        """Semi-axis across the rolling direction that contacts do not pass on the way to a balance [m].

        In balance a wider one has no friction that this model knows.
        """
        return WIDEST * self.bearing.ball.diameter / 2

    def _axes(self, loads: NDArray) -> NDArray:
        """Semi-axes (2, 2, N) [m] of contacts of loads (2, N), none too wide."""
        axes = np.array([c.semi_axes(n) for c, n in zip(self.contacts, loads, strict=True)])
        axes[:, 0] = np.minimum(axes[:, 0], self.widest)
        return axes

    def _ellipses(self, axes: NDArray, loads: NDArray) -> Ellipse:
        """Contacts (N, 2) of semi-axes (2, 2, N) and loads (2, N)."""
        across, along = axes[:, 0].T, axes[:, 1].T
        surfaces = self._surfaces + np.zeros_like(across)
        share = self.friction if self.oil is None else 1.0  # of the load
        return Ellipse(across, along, surfaces, share * loads.T, self.spin)

    def _places(self, angles: NDArray, across: NDArray) -> BallContacts:
        """Contacts at angles (N, 2) of semi-axes (N, 2)."""
        ones = np.ones(len(angles))
        radius = self.bearing.ball.diameter / 2 * ones
        height = pressed_height(radius[:, None], self._surfaces, across)
        return BallContacts(radius, self.bearing.pitch_diameter / 2 * ones, angles[:, None], height[:, None])

    @property
    def _surfaces(self) -> NDArray:
        """R of the pressed surfaces (2) [m]."""
        bearing, diameter = self.bearing, self.bearing.ball.diameter
        grooves = diameter * np.array([bearing.inner.conformity, bearing.outer.conformity])
        return pressed_radius(np.array(diameter / 2), grooves)


def _blocks(count: int, cages: Cages | None) -> list[NDArray]:
    """Numbers of balls (N) that are in memory together, those of a cage in one block."""
    numbers = np.arange(count)
    if cages is None:
        return np.split(numbers, range(BLOCK, count, BLOCK))
    first = np.searchsorted(cages.of_ball, np.arange(len(cages.speed)))
    starts = [first[0]]
    for begin, end in zip(first, [*first[1:], count], strict=True):
        if end - starts[-1] > BLOCK and begin > starts[-1]:
            starts.append(begin)
    return np.split(numbers, starts[1:])


def _moving(driven: DrivenContacts, ahead: NDArray) -> NDArray:
    """Balls (N) that both races drive."""
    return (ahead != 0) & (driven.loads > 0).all(0)
