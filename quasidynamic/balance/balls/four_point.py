"""Load distribution of a four-point contact ball bearing with rigid rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.four_point_diagonals import Diagonals, Pressed
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.ball import FourPointBearing

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring, moments over the pitch radius
ENOUGH = 1e-9  # the same, where rounding keeps a step from lowering it any more
STEPS = 200  # rarely more than twenty: the energy is convex
HALVINGS = 50
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no ball resists a direction


@dataclass(frozen=True)
class BallLoads:
    """How the balls share a load. Z balls, two diagonals: the first leans outwards to positive x."""

    loads: NDArray  # (Z, 2) [N] the same at both ends of a diagonal
    angles: NDArray  # (Z, 2) [rad] contact angle from the radial plane, loaded
    displacement: NDArray  # (5) x, y, z [m] and tilts about y and z [rad] of the inner against the outer ring
    stiffness: NDArray  # (5, 5) tangent [N/m, N, N m], symmetric
    imbalance: float  # [-] unbalanced force over the largest force
    iterations: int  # evaluations of all balls


class State(NamedTuple):
    """Forces on the inner ring at one place of it; moments and tilts are taken over the pitch radius."""

    place: NDArray  # (5) [m]
    pressed: Pressed
    excess: NDArray  # (5) load less what the balls carry [N]
    stiffness: NDArray  # (5, 5) [N/m]


def ball_loads(bearing: FourPointBearing, load: NDArray) -> BallLoads:
    r"""Load of every diagonal under five loads on the inner ring, with contact angles that turn.

    .. math:: Q = K [L - A]_+^{3/2},\quad A = r_i + r_o - D,\quad L_0 = A - G,\\
              L = |(L_0 \cos\alpha_0 + u_r,\; L_0 \sin\alpha_0 \pm u_a)|,\quad
              u_r = u_y \sin\varphi + u_z \cos\varphi,\quad
              u_a = u_x + R_c (\theta_y \cos\varphi - \theta_z \sin\varphi)

    Newton's method on the convex energy of the contacts.

    Parameters
    ----------
    bearing : FourPointBearing
        D, r, contact angle alpha_0, clearance G of a diagonal, pitch radius R_c
    load : array (5)
        on the inner ring: axial x, radial y and z [N], moments about y and z [N m]

    Returns
    -------
    BallLoads

    Raises
    ------
    ImpossiblePart
        when a load is not finite
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    Amasorrain, Sagartzazu and Damian (2003), Mech. Mach. Theory 38, 479-496.

    Valid
    -----
    Slow, rigid and round rings; both diagonals with one contact angle and one clearance; the stiffness K is
    that of the unloaded contact angle; moments act on the pitch circle. No truncation at the groove edge.
    """
    rings = RigidRings.of(bearing, load)
    state, count = balanced(rings)
    lever = levers(bearing)
    return BallLoads(
        loads=state.pressed.loads,
        angles=state.pressed.angles,
        displacement=state.place / lever,
        stiffness=state.stiffness * np.outer(lever, lever),
        imbalance=rings.imbalance(state),
        iterations=count,
    )


def levers(bearing: FourPointBearing) -> NDArray:
    """Over which moments become forces, and tilts displacements (5) [-, m]."""
    pitch = bearing.pitch_diameter / 2
    return np.array([1.0, 1.0, 1.0, pitch, pitch])


@dataclass(frozen=True)
class RigidRings:
    """Two rigid rings with balls between them."""

    diagonals: Diagonals
    load: NDArray  # (5) [N] moments over the pitch radius

    @classmethod
    def of(cls, bearing: FourPointBearing, load: NDArray) -> "RigidRings":
        """Build from a bearing and a load [N, N m]; raises as `ball_loads`."""
        load = np.asarray(load, dtype=float)
        if load.shape != (5,) or not np.isfinite(load).all():
            raise ImpossiblePart(f"load = {load} must be five finite numbers: Fx, Fy, Fz, My, Mz")
        if not load.any() and bearing.clearance >= 0.0:
            raise NotSolved(
                f"no load, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds the ring, its "
                "position is undetermined; give a load or an interference (negative clearance)",
                "undetermined",
            )
        return cls(Diagonals.of(bearing), load / levers(bearing))

    def at(self, place: NDArray) -> State:
        """Evaluate every diagonal."""
        pressed = self.diagonals.at(place)
        excess = self.load - self.diagonals.carried(pressed.force)
        return State(place, pressed, excess, self.diagonals.stiffness(pressed.stiffness))

    def imbalance(self, state: State) -> float:
        """Largest unbalanced force over the largest force [-]."""
        return float(np.abs(state.excess).max() / max(np.abs(self.load).max(), state.pressed.loads.max()))

    def usual_stiffness(self) -> float:
        """Stiffness of a diagonal that carries the largest load alone [N/m]."""
        return 1.5 * self.diagonals.coefficient ** (2 / 3) * float(np.abs(self.load).max()) ** (1 / 3)

    def first_place(self) -> NDArray:
        """Ring (5) pushed along its load to where about one ball would carry it: rather too far."""
        size, own = np.abs(self.load).max(), self.diagonals
        if size == 0.0:
            return np.zeros(5)
        direction = self.load / np.linalg.norm(self.load)
        moves = np.hypot(*(own.moves @ direction).T).max()
        distance = np.hypot(*own.start[0])
        gap = max(own.touching - distance, 0.0)
        squeeze = (size / own.coefficient) ** (2 / 3)
        return direction * (gap + squeeze) / (moves * own.start[0].min() / distance)


def balanced(rings: RigidRings) -> tuple[State, int]:
    """State in which the balls carry the load, and the number of evaluations; raises `NotSolved`."""
    here, count, last = rings.at(rings.first_place()), 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(here)
        if imbalance < TOLERANCE or last / 2 < imbalance < ENOUGH:
            return here, count
        here, tries = _next(rings, here, imbalance)
        count, last = count + tries, imbalance
    raise NotSolved(
        f"the rings found no balance in {count} evaluations: {rings.imbalance(here):.1e} of the largest "
        f"force is left, allowed {ENOUGH:.0e}; loads over the pitch radius {rings.load} N",
        "iteration limit",
    )


def _next(rings: RigidRings, here: State, imbalance: float) -> tuple[State, int]:
    """A step of Newton's method, halved while it runs far past the lowest energy on its way.

    A direction in which hardly anything resists is stiffened as long as forces are out of balance.
    """
    stiffer = STIFFENING * min(imbalance, 1.0) * max(here.stiffness.trace(), rings.usual_stiffness())
    step = np.linalg.solve(here.stiffness + stiffer * np.eye(5), here.excess)
    uphill = -0.5 * float(here.excess @ step)
    for halvings in range(HALVINGS):
        there = rings.at(here.place + step * 0.5**halvings)
        if float(there.excess @ step) >= uphill:
            break
    return there, halvings + 1
