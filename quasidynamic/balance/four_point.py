"""Load distribution of a four-point contact ball bearing with rigid rings."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.point import point_contact, race_curvatures
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.motion.ball_slip import SIDE
from quasidynamic.parts.ball import FourPointBearing

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring, moments over the pitch radius
ENOUGH = 1e-9  # the same, where rounding keeps a step from lowering it any more
STEPS = 200  # rarely more than twenty: the energy is convex
HALVINGS = 50
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no ball resists a direction

AXIAL, TILT = 2, slice(3, 5)  # components of load and displacement


@dataclass(frozen=True)
class BallLoads:
    """How the balls share a load. Z balls, two diagonals: the first leans outwards to positive z."""

    loads: NDArray  # (Z, 2) [N] the same at both ends of a diagonal
    angles: NDArray  # (Z, 2) [rad] contact angle from the radial plane, loaded
    displacement: NDArray  # (5) x, y, z [m] and tilts about x and y [rad] of the inner against the outer ring
    stiffness: NDArray  # (5, 5) tangent [N/m, N, N m], symmetric
    imbalance: float  # [-] unbalanced force over the largest force
    iterations: int  # evaluations of all balls


class _State(NamedTuple):
    """Forces on the inner ring at one place of it; moments and tilts are taken over the pitch radius."""

    place: NDArray  # (5) [m]
    loads: NDArray  # (Z, 2) [N]
    angles: NDArray  # (Z, 2) [rad]
    excess: NDArray  # (5) load less what the balls carry [N]
    stiffness: NDArray  # (5, 5) [N/m]


def ball_loads(bearing: FourPointBearing, load: NDArray) -> BallLoads:
    r"""Load of every diagonal under five loads on the inner ring, with contact angles that turn.

    .. math:: Q = K [L - A]_+^{3/2},\quad A = r_i + r_o - D,\quad L_0 = A - G,\\
              L = |(L_0 \cos\alpha_0 + u_r,\; L_0 \sin\alpha_0 \pm u_z)|,\quad
              u_r = u_x \cos\varphi + u_y \sin\varphi,\quad
              u_z = u_{zz} + R_c (\theta_x \sin\varphi - \theta_y \cos\varphi)

    Newton's method on the convex energy of the contacts.

    Parameters
    ----------
    bearing : FourPointBearing
        D, r, contact angle alpha_0, clearance G of a diagonal, pitch radius R_c
    load : array (5)
        on the inner ring: radial x and y, axial z [N], moments about x and y [N m]

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
    load = np.asarray(load, dtype=float)
    if load.shape != (5,) or not np.isfinite(load).all():
        raise ImpossiblePart(f"load = {load} must be five finite numbers: Fx, Fy, Fz, Mx, My")
    if not load.any() and bearing.clearance >= 0.0:
        raise NotSolved(
            f"no load, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds the ring, its "
            "position is undetermined; give a load or an interference (negative clearance)",
            "undetermined",
        )
    pitch = bearing.pitch_diameter / 2
    lever = np.array([1.0, 1.0, 1.0, pitch, pitch])
    rings = _Rings.of(bearing, load / lever)
    state, count = _balanced(rings)
    return BallLoads(
        loads=state.loads,
        angles=state.angles,
        displacement=state.place / lever,
        stiffness=state.stiffness * lever * lever[:, None],
        imbalance=rings.imbalance(state),
        iterations=count,
    )


def diagonal_coefficient(bearing: FourPointBearing) -> float:
    """Coefficient K of a diagonal, both contacts in series, at the unloaded contact angle [N/m^1.5]."""
    curvatures = race_curvatures(
        bearing.ball.diameter, bearing.groove_radii, bearing.pitch_diameter, bearing.contact_angle, SIDE
    )
    both = point_contact(curvatures, bearing.moduli).coefficient
    return float((both ** (-2 / 3)).sum() ** -1.5)


@dataclass(frozen=True)
class _Rings:
    """Two rigid rings with balls between them."""

    coefficient: float  # K [N/m^1.5]
    touching: float  # [m] distance of the groove centres at which a diagonal begins to carry
    start: NDArray  # (2) [m] radial and axial distance of the groove centres, rings concentric
    radial: NDArray  # (Z, 5) [-] radial displacement at each ball by the place of the ring
    axial: NDArray  # (Z, 5) [-] the same, axial
    load: NDArray  # (5) [N]

    @classmethod
    def of(cls, bearing: FourPointBearing, load: NDArray) -> "_Rings":
        """Build from a bearing and a load [N]."""
        cosine, sine = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
        none, one = np.zeros_like(cosine), np.ones_like(cosine)
        distance = bearing.centre_distance - bearing.clearance
        return cls(
            coefficient=diagonal_coefficient(bearing),
            touching=bearing.centre_distance,
            start=distance * np.array([np.cos(bearing.contact_angle), np.sin(bearing.contact_angle)]),
            radial=np.stack([cosine, sine, none, none, none], 1),
            axial=np.stack([none, none, one, sine, -cosine], 1),
            load=load,
        )

    def at(self, place: NDArray) -> _State:
        """Evaluate every diagonal."""
        along = self.start[0] + self.radial @ place
        across = self.start[1] + np.multiply.outer(self.axial @ place, [1.0, -1.0])
        along = np.broadcast_to(along[:, None], across.shape)
        length = np.hypot(along, across)
        approach = np.maximum(length - self.touching, 0.0)
        loads = self.coefficient * approach**1.5
        cosine, sine = along / length, across / length
        # of the two diagonals together: forces and stiffness in (radial, axial)
        sign = np.array([1.0, -1.0])
        radial, axial = (loads * cosine).sum(1), (loads * sine * sign).sum(1)
        normal, turning = 1.5 * self.coefficient * np.sqrt(approach), loads / length
        of_radial = (normal * cosine**2 + turning * sine**2).sum(1)
        of_axial = (normal * sine**2 + turning * cosine**2).sum(1)
        mixed = ((normal - turning) * cosine * sine * sign).sum(1)
        cross = self.radial.T @ (mixed[:, None] * self.axial)
        stiffness = (
            self.radial.T @ (of_radial[:, None] * self.radial)
            + self.axial.T @ (of_axial[:, None] * self.axial)
            + cross
            + cross.T
        )
        excess = self.load - self.radial.T @ radial - self.axial.T @ axial
        return _State(place, loads, np.arctan2(across, along), excess, stiffness)

    def imbalance(self, state: _State) -> float:
        """Largest unbalanced force over the largest force [-]."""
        return float(np.abs(state.excess).max() / max(np.abs(self.load).max(), state.loads.max()))

    def usual_stiffness(self) -> float:
        """Stiffness of a diagonal that carries the largest load alone [N/m]."""
        return 1.5 * self.coefficient ** (2 / 3) * float(np.abs(self.load).max()) ** (1 / 3)

    def first_place(self) -> NDArray:
        """Ring (5) pushed along its load to where about one ball would carry it: rather too far."""
        size = np.abs(self.load).max()
        if size == 0.0:
            return np.zeros(5)
        direction = self.load / np.linalg.norm(self.load)
        moves = np.hypot(self.radial @ direction, self.axial @ direction).max()
        gap = max(self.touching - np.hypot(*self.start), 0.0)
        squeeze = (size / self.coefficient) ** (2 / 3)
        return direction * (gap + squeeze) / (moves * min(self.start) / np.hypot(*self.start))


def _balanced(rings: _Rings) -> tuple[_State, int]:
    """State in which the balls carry the load, and the number of evaluations."""
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


def _next(rings: _Rings, here: _State, imbalance: float) -> tuple[_State, int]:
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
