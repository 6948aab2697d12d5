"""Motion of a slow ball whose contacts stick and slip."""

from dataclasses import dataclass
from typing import NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.rolling_ball import RollingBall
from quasidynamic.contact.rolling.rolling_contact import ACROSS, ALONG, Rolled, RollingLaw
from quasidynamic.errors import NotSolved, OutOfRange

TOLERANCE = 1e-3  # unbalanced power over the power of friction; the torque is off by 1e-6 of itself
LIMIT = 40  # evaluations, rarely more than four
GAIN = 0.5  # of what was left: more left after a step requires new slopes
SHORTEST = 1 / 256  # part of a step
STANDING = "rolling ball: the material in a contact is at rest or flows both ways"


@dataclass(frozen=True)
class RollingMotion:
    """How a ball moves when the inner ring turns by one rad/s against the outer ring."""

    ball: RollingBall
    motion: NDArray  # (4) [rad/s] outer ring, ball axial, radial, about the rolling direction, from the orbit
    rolled: Rolled
    slopes: NDArray | None  # (4, 4) of the balance by the unknowns near the end, if they were needed
    imbalance: float  # [-] unbalanced power over the power of friction
    evaluations: int

    @property
    def power(self) -> float:
        """Heat of friction [W], the torque of the ball [N m]."""
        return self.ball.power(self.motion, self.rolled)

    def cells(self, number: int, ring_speed: float = 1.0) -> dict[str, NDArray]:
        """Places [m], pressure, shear stress on the ball [Pa], slip [m/s] and stick of a contact (ny, nx).

        x is across the rolling direction, y along it, towards growing azimuth. The ring speed is that of the
        inner against the outer ring [rad/s].
        """
        contacts, speed = self.ball.contacts, ring_speed * self.ball.material_speed(self.motion)[number]
        direction = -np.sign(speed.mean())
        x, y = (np.broadcast_to(part[number], contacts.limit.shape[1:]) for part in contacts.places())
        slip, shear = np.abs(speed) * self.rolled.slip[number], self.rolled.traction[number]
        pressure = contacts.limit[number] if contacts.pressure is None else contacts.pressure[number]
        touching = contacts.limit[number] > 0.0
        cells = {
            "x": y,
            "y": direction * x,
            "slip_along": direction * slip[ALONG] * touching,
            "slip_across": slip[ACROSS] * touching,
            "shear_along": direction * shear[ALONG],
            "shear_across": shear[ACROSS],
            "pressure": pressure,
            "stick": (self.rolled.stick[number] & touching).astype(float),
        }
        order = slice(None, None, int(direction))  # places along grow with the azimuth
        return {name: values[order].T for name, values in cells.items()}


def rolling_motion(
    ball: RollingBall,
    law: RollingLaw,
    motion: NDArray,
    start: NDArray | None = None,
    slopes: NDArray | None = None,
) -> RollingMotion:
    """Motion in which friction is in balance.

    Newton's method with slopes of the linearised contacts, kept with Broyden's correction while they serve.

    The motion (4) to start from is such as that of `sliding_motion`; it may start from tractions (C, 2, nx,
    ny) [Pa] and slopes of the balance (4, 4), too.
    Raises `NotSolved` when no balance is found, with what is left; `OutOfRange` when the material is at rest
    in a contact.

    Source
    ------
    Broyden, Math. Comp. 19 (1965), 577-593.
    """
    state, evaluations = _at(ball, law, motion, start), 1
    if state is None:
        raise OutOfRange(STANDING)
    while state.size > TOLERANCE:
        fresh = slopes is None
        slopes = _slopes(ball, law, state) if slopes is None else slopes
        step, part = -np.linalg.solve(slopes, state.left), 1.0
        trial, evaluations = _stepped(ball, law, state, step), evaluations + 1
        while fresh and not _smaller(trial, state.size) and part > SHORTEST and evaluations < LIMIT:
            part /= 2
            trial, evaluations = _stepped(ball, law, state, part * step), evaluations + 1
        if trial is not None and trial.size < state.size:
            useful = trial.size < GAIN * state.size
            slopes = _corrected(slopes, part * step, trial.left - state.left) if useful else None
            state = trial
        elif not fresh:
            slopes = None
        else:
            _give_up(state.size, evaluations)
        if evaluations >= LIMIT and state.size > TOLERANCE:
            _give_up(state.size, evaluations)
    return RollingMotion(ball, state.motion, state.rolled, slopes, state.size, evaluations)


def kept_motion(
    ball: RollingBall, law: RollingLaw, motion: NDArray, start: NDArray | None = None
) -> RollingMotion:
    """Friction of a ball that moves as is given, in balance or not.

    Raises `NotSolved` when a contact is not solved; `OutOfRange` when the material is at rest in a contact.
    """
    state = _at(ball, law, motion, start)
    if state is None:
        raise OutOfRange(STANDING)
    return RollingMotion(ball, state.motion, state.rolled, None, state.size, 1)


class _State(NamedTuple):
    """A ball at one motion."""

    motion: NDArray  # (4)
    rolled: Rolled
    left: NDArray  # (4)
    size: float  # unbalanced power over that of friction


def _at(ball: RollingBall, law: RollingLaw, motion: NDArray, start: NDArray | None) -> _State | None:
    """State at a motion, None where the material of a contact flows both ways."""
    speed = ball.material_speed(motion)
    if np.any(speed * speed[:, :1] <= 0.0):
        return None
    rolled = law.friction(ball.contacts, ball.creep(motion), start)
    return _State(motion, rolled, ball.left(motion, rolled), ball.imbalance(motion, rolled))


def _stepped(ball: RollingBall, law: RollingLaw, state: _State, step: NDArray) -> _State | None:
    return _at(ball, law, state.motion + ball.unknowns @ step, state.rolled.traction)


def _slopes(ball: RollingBall, law: RollingLaw, state: _State) -> NDArray:
    changes = law.changes(state.rolled, ball.creep_changes(state.motion))
    return ball.left_changes(state.motion, changes)


def _smaller(trial: _State | None, size: float) -> bool:
    return trial is not None and trial.size < size


def _corrected(slopes: NDArray, step: NDArray, change: NDArray) -> NDArray:
    """Slopes that give the change seen over a step, else as before."""
    return slopes + np.outer(change - slopes @ step, step) / (step @ step)


def _give_up(size: float, evaluations: int) -> NoReturn:
    outcome = "iteration limit" if evaluations >= LIMIT else "stalled"
    raise NotSolved(
        f"rolling ball: no balance of friction in {evaluations} evaluations, {size:.1e} of the power is "
        f"unbalanced, allowed {TOLERANCE:.0e}",
        outcome,
    )
