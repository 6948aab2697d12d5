"""Balance of a slow ball whose contacts stick and slip."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.free_ball import motion_by_slip
from quasidynamic.balance.balls.pressed_contacts import groove_contacts, hertz_contacts
from quasidynamic.balance.balls.sliding_balls import stronger_diagonal
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.rigid_slip import CENTRE, sagitta, strip_slip
from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.pressure import PressedGroove
from quasidynamic.contact.rolling.full_sliding import hertz_pressure
from quasidynamic.contact.rolling.rolling_contact import ACROSS, ALONG, MID_STEP, Rolled, RollingContacts
from quasidynamic.motion.ball_slip import INNER, ORBIT, OUTER, TURN, BallContacts, turning_slip_by_motion


@dataclass(frozen=True)
class RollingBall:
    r"""One ball in C loaded contacts, or several with C contacts; speeds are over that of the inner against
    the outer ring.

    .. math:: \sum_{contacts} \int \frac{\partial s}{\partial u_k} \cdot p\, dA = 0,\quad
              M = -\sum_{contacts} \int s \cdot p\, dA

    with the rigid slip s, ball minus race, linear in the motion u = (Omega_o, omega_x, omega_r, omega_t), and
    the traction p on the ball: no force along the orbit, no moment; M is the torque.

    Source
    ------
    Virtual power of rigid bodies; for full sliding these are Eqs (1) to (3) of Joshi et al. (2015),
    Lubricants 3, 181-196.
    """

    contacts: RollingContacts  # x along the rolling direction, y across it
    race: NDArray  # (C) inner or outer
    by_motion: NDArray  # (C, 5, 4) slip of the contacts by the motion
    strips: NDArray  # (C, 3, 5, ny) slip of strips along the rolling direction by that of the contact
    race_speed: NDArray  # (C, ny) [m] speed of the surface of the race where it turns by one
    unknowns: NDArray  # (4, 4) motion by the unknowns, see `motion_by_slip`; of each contact (C, 4, 4)
    cut: NDArray  # (C) whether a shoulder cuts the contact

    def with_interface(self, compliance: float) -> "RollingBall":
        """Same ball, with an interface in its contacts, see `RollingContacts.with_interface`."""
        return replace(self, contacts=self.contacts.with_interface(compliance))

    def contact_slip(self, motion: NDArray) -> NDArray:
        """Slip of the contacts (C, 5) at a motion (4), or at that of the ball of each contact (C, 4)."""
        inner = np.where(self.race == INNER, 1.0, 0.0)  # the inner ring is one faster than the outer one
        return (self.by_motion @ motion[..., None])[..., 0] + inner[:, None] * self.by_motion[:, :, ORBIT]

    def material_speed(self, motion: NDArray) -> NDArray:
        """Mean speed of both surfaces through the contacts towards growing azimuth (C, ny) [m]."""
        turn = motion[..., ORBIT] + np.where(self.race == INNER, 1.0, 0.0)
        along = np.einsum("ciy,ci->cy", self.strips[:, 0], self.contact_slip(motion))
        return turn[:, None] * self.race_speed + along / 2

    def creep(self, motion: NDArray) -> NDArray:
        """Rigid slip over the speed of the material (C, 2, nx, ny) [-], `MID_STEP` ahead of the centres."""
        return self._over_speed(self.contact_slip(motion)[:, None], motion)[:, 0]

    def full_sliding_power(self, motion: NDArray) -> float:
        """Power of friction if it slid everywhere [N m], the most that it can be at any motion."""
        direction = -np.sign(self.material_speed(motion).mean(1))
        slip = self._slip_fields(self.contact_slip(motion)[:, None], direction, 0.0)[:, 0]
        size = np.hypot(slip[:, ALONG], slip[:, ACROSS])
        return float(np.einsum("c,cxy,cxy->", self.contacts.cell_area, self.contacts.limit, size))

    def left(self, motion: NDArray, rolled: Rolled) -> NDArray:
        """Forces that are not balanced, by unknown (4)."""
        return self._by_unknown(self.powers(rolled.traction[:, None], motion)[:, 0])

    def creep_changes(self, motion: NDArray) -> NDArray:
        """Changes of the creep by the unknowns (C, 4, 2, nx, ny), the speed of the material as it is."""
        return self._over_speed(np.swapaxes(self.by_motion @ self.unknowns, 1, 2), motion)

    def left_changes(self, motion: NDArray, changes: NDArray) -> NDArray:
        """Derivative of `left` by the unknowns (4, 4), by that of the tractions (C, 4, 2, nx, ny)."""
        return np.stack(
            [self._by_unknown(part) for part in np.moveaxis(self.powers(changes, motion), 1, 0)], 1
        )

    def power(self, motion: NDArray, rolled: Rolled) -> float:
        """Power of friction over the speed of the inner against the outer ring: the torque [N m]."""
        by_slip = self.powers(rolled.traction[:, None], motion)[:, 0]
        return -float((by_slip * self.contact_slip(motion)).sum())

    def power_by_slip(self, motion: NDArray, rolled: Rolled) -> NDArray:
        """Power of tractions along and across on a unit of each slip of the contacts (2, C, 5)."""
        along, across, turning = self._by_strip(rolled.traction[:, None], motion)[:, 0].swapaxes(0, 1)
        return np.stack([along, across + turning])

    def power_by_motion(self, motion: NDArray, rolled: Rolled) -> NDArray:
        """Power of the tractions on a unit of each component of the motion (4): moments on the ball [N m]."""
        by_slip = self.powers(rolled.traction[:, None], motion)[:, 0]
        return np.einsum("ci,cij->j", by_slip, self.by_motion)

    def imbalance(self, motion: NDArray, rolled: Rolled) -> float:
        """Unbalanced power of each component of the motion over the power of friction, the largest."""
        by_motion = self.power_by_motion(motion, rolled)
        ball = np.linalg.norm(motion[1:])
        parts = np.abs(by_motion) * np.array([1.0, ball, ball, ball])
        return float(parts.max() / np.abs(self.power(motion, rolled)))

    def _by_unknown(self, by_slip: NDArray) -> NDArray:
        return np.einsum("ci,cij->j", by_slip, self.by_motion @ self.unknowns)

    def _over_speed(self, slips: NDArray, motion: NDArray) -> NDArray:
        """Creep (C, m, 2, nx, ny) by slips of the contacts (C, m, 5)."""
        speed = self.material_speed(motion)
        fields = self._slip_fields(slips, -np.sign(speed.mean(1)), MID_STEP)
        return fields / np.abs(speed)[:, None, None, None]

    def _slip_fields(self, slips: NDArray, direction: NDArray, ahead: float) -> NDArray:
        """Rigid slip (C, m, 2, nx, ny) on grids that point along (1) or against (-1) growing azimuth."""
        along, middle, turning = np.moveaxis(np.einsum("csiy,cmi->cmsy", self.strips, slips), 2, 0)
        x = direction[:, None, None, None] * self.contacts.places(ahead)[0][:, None]
        fields = np.empty((*slips.shape[:2], 2, *self.contacts.limit.shape[1:]))
        fields[:, :, ALONG] = (direction[:, None, None] * along)[:, :, None]
        fields[:, :, ACROSS] = middle[:, :, None] + x * turning[:, :, None]
        return fields

    def powers(self, tractions: NDArray, motion: NDArray) -> NDArray:
        """Power (C, m, 5) of tractions (C, m, 2, nx, ny) on a unit of each slip of the contacts."""
        return self._by_strip(tractions, motion).sum(2)

    def _by_strip(self, tractions: NDArray, motion: NDArray) -> NDArray:
        """The same by what strips do (C, m, 3, 5): slip along, across, and turn."""
        direction = -np.sign(self.material_speed(motion).mean(1))[:, None, None]
        x = direction[:, None] * self.contacts.places()[0][:, None]
        across = tractions[:, :, ACROSS]
        sums = [direction * tractions[:, :, ALONG].sum(-2), across.sum(-2), (x * across).sum(-2)]
        return np.einsum("c,cmsy,csiy->cmsi", self.contacts.cell_area, np.stack(sums, 2), self.strips)


def rolling_balls(
    balls: BallContacts,
    ellipse: Ellipse,
    unknowns: NDArray,
    pairs: tuple[ElasticPair, ElasticPair],
    cells: tuple[int, int],
) -> RollingBall:
    """Several balls of one diagonal on Hertz ellipses, inner then outer contact of each."""
    count = len(balls.ball_radius)
    along, across, surface, traction, height = (
        values.reshape(2 * count)
        for values in (ellipse.along, ellipse.across, ellipse.radius, ellipse.traction, balls.height)
    )
    axial, radial = (normal.reshape(2 * count, 1) for normal in balls.normal)
    grids = tuple(grid_over(axes, cells) for axes in zip(along.tolist(), across.tolist(), strict=True))
    limit = (traction / (along * across))[:, None, None] * _unit_pressure(cells)
    contacts = RollingContacts(grids, count * pairs, limit)
    y, radius = contacts.places()[1][:, 0], surface[:, None]
    risen = height[:, None] + sagitta(y, radius)
    return RollingBall(
        contacts=contacts,
        race=np.tile([INNER, OUTER], count),
        by_motion=turning_slip_by_motion(balls).reshape(2 * count, 5, 4),
        strips=strip_slip(y, radius, ellipse.spin),
        race_speed=np.repeat(balls.pitch_radius, 2)[:, None] + radial * risen + axial * y,
        unknowns=np.repeat(unknowns, 2, axis=0),
        cut=np.zeros(2 * count, bool),
    )


@lru_cache
def _unit_pressure(cells: tuple[int, int]) -> NDArray:
    """Pressure of Hertz under a load of one on semi-axes of one."""
    return hertz_pressure(grid_over((1.0, 1.0), cells), (1.0, 1.0), 1.0)


def rolling_ball(
    ball: BallContacts,
    ellipse: Ellipse,
    load: NDArray,
    pairs: tuple[ElasticPair, ElasticPair],
    cells: tuple[int, int],
    grooves: tuple[PressedGroove, ...] = (),
) -> RollingBall:
    """One ball, pressed as by Hertz or into grooves."""
    by_motion = turning_slip_by_motion(ball)[0]
    diagonal, race = np.nonzero(load[0] > 0.0)
    loaded = (0, diagonal, race)
    if grooves:
        pressed = groove_contacts(grooves, diagonal, cells)
    else:
        pressed = hertz_contacts(ellipse.taken(loaded), load[loaded], cells)
    friction = (ellipse.traction / np.where(load > 0.0, load, 1.0))[loaded][:, None, None]
    pressure, y, radius = pressed.pressure, pressed.position, ellipse.radius[loaded][:, None]
    contacts = RollingContacts(
        pressed.grids, tuple(pairs[side] for side in race), friction * pressure, pressure=pressure
    )
    axial, radial = (normal[loaded][:, None] for normal in ball.normal)
    height = ball.height[loaded][:, None] + sagitta(y, radius)
    strong = by_motion[stronger_diagonal(ellipse)[0], :, CENTRE, :TURN]
    return RollingBall(
        contacts=contacts,
        race=race,
        by_motion=by_motion[diagonal, race],
        strips=strip_slip(y, radius, ellipse.spin),
        race_speed=ball.pitch_radius[0] + radial * height + axial * y,
        unknowns=motion_by_slip(strong[None], ball.ball_radius)[0],
        cut=pressed.cut,
    )
