"""Torque that slow balls make on both rings."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse, sliding_friction
from quasidynamic.contact.ellipse.rigid_slip import ROLL, SPIN
from quasidynamic.motion.ball_slip import ORBIT, BallContacts, slip_by_motion


@dataclass(frozen=True)
class RaceTorques:
    """Torque that turns each ring against the friction of its balls: last axis inner, outer ring."""

    spin: NDArray  # (N, 2) [N m] by the moments about the contact normals
    roll: NDArray  # (N, 2) [N m] by the forces along the rolling direction
    circumferential: NDArray  # (N, 2) [N m] by the traction along the rolling direction alone

    @property
    def total(self) -> NDArray:
        """Both parts (N, 2) [N m]; equal and opposite on the two rings."""
        return self.spin + self.roll


def race_torques(contacts: BallContacts, slip: NDArray, ellipse: Ellipse) -> RaceTorques:
    r"""Torque of every ball on both rings, in parts.

    .. math:: T = -\left(R_c F_t + M_x\right),\quad
              T_{spin} = -n_x M_s,\quad T_{roll} = -(R_c F_t + n_r \textstyle\int \tau_t h\, dA),\\
              T_{circ} = -\int \tau_t\, r_{ap}\, dA,\quad r_{ap} = R_c + n_r h + t_r x

    per ball and ring, summed over diagonals; F_t, M_s and tau_t act on the ball. The circumferential part
    leaves out the spin moment that lateral slip makes: the two rings then differ a little.

    Parameters
    ----------
    contacts : BallContacts
        N balls, G diagonals
    slip : array (N, G, 2, 3)
        centre slip [m/s], roll and spin [rad/s]; not a number for a ball that nothing drives
    ellipse : Ellipse
        (N, G, 2) semi-axes and friction forces

    Returns
    -------
    RaceTorques
        [N m] to be put in at the ring: of the sign of its motion against the other ring

    Source
    ------
    Joshi et al. (2015), Lubricants 3, 181-196, Eqs (4) and (5), with the rolling radius
    (int tau_t h dA)/F_t; Heras et al. (2017), Eqs (4) and (5), for the circumferential part.
    """
    driven = np.all(np.isfinite(slip), axis=(1, 2, 3), keepdims=True)
    friction = sliding_friction(np.where(driven, slip, 1.0), ellipse)
    by_slip, lateral = (np.where(driven, part, 0.0) for part in (friction.by_slip, friction.lateral))
    return torques_by_slip(contacts, by_slip, lateral)


def torques_by_slip(contacts: BallContacts, by_slip: NDArray, lateral: NDArray) -> RaceTorques:
    """Torque of every ball on both rings, in parts, by friction that is known, see `race_torques`.

    `by_slip` (N, G, 2, 3) is minus the power of the tractions on the ball on a unit of centre slip [N], roll
    and spin [N m]; `lateral` is its part of tractions across the rolling direction. Torques are in N m.

    Source
    ------
    Joshi et al. (2015), Lubricants 3, 181-196, Eqs (4) and (5).
    """
    by_race_speed, axial = slip_by_motion(contacts)[..., ORBIT], contacts.normal[0]
    whole, across = ((by_race_speed * part).sum(-1) for part in (by_slip, lateral))
    spin = -axial * by_slip[..., SPIN]
    return RaceTorques(spin=spin.sum(1), roll=(whole - spin).sum(1), circumferential=(whole - across).sum(1))


def hysteresis_torque(slip: NDArray, load: NDArray, along: NDArray, loss: float) -> NDArray:
    r"""Torque of elastic hysteresis in rolling contacts, per ball.

    .. math:: T_h = \frac{3 \alpha}{16} \sum Q\, b\, |A|

    Parameters
    ----------
    slip : array (N, G, 2, 3)
        its roll A [-], ball against race, for rings that turn by one against each other; not a number for a
        ball that nothing drives
    load : array (N, G, 2)
        Q [N]
    along : array (N, G, 2)
        b, semi-axis along the rolling direction [m]
    loss : float
        alpha, part of the elastic work that is lost [-], about 0.004 to 0.01 for bearing steel

    Returns
    -------
    array (N)
        T_h [N m], >= 0, the same on both rings

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 9.4; used for slow ball bearings by Todd and Johnson (1986), Int.
    J. Mech. Sci. 29, 339-354.
    """
    rate = np.nan_to_num(np.abs(slip[..., ROLL]), nan=0.0)
    return 3 / 16 * loss * (load * along * rate).sum((1, 2))
