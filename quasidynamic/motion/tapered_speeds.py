"""Speeds of tapered rollers that roll on both raceways, and what follows from them."""

from typing import NamedTuple

from quasidynamic.parts.tapered_bearing import TaperedRollerBearing


class TaperedSpeeds(NamedTuple):
    """Speeds of cage and rollers, and the forces of inertia on a roller."""

    orbit: float  # [rad/s] omega_c of the rollers about the axis of the bearing
    spin: float  # [rad/s] omega_r of a roller against the cage, > 0 when it rolls forwards on the inner ring
    centrifugal_force: float  # [N] F_c on a roller, outwards
    gyroscopic_moment: float  # [N m] M_g on a roller, lifts its large end
    rib_sliding: float  # [m/s] of the rib over the roller's end, > 0 along growing azimuth


def tapered_speeds(
    bearing: TaperedRollerBearing, inner_speed: float, outer_speed: float = 0.0
) -> TaperedSpeeds:
    r"""Pure rolling of tapered rollers.

    .. math:: \omega_c = \frac{\omega_i r_i + \omega_o r_o}{r_i + r_o},\quad
              \omega_r = (\omega_i - \omega_o) \frac{2 r_i r_o}{D (r_i + r_o)},

    .. math:: F_c = m r_m \omega_c^2,\quad
              M_g = \omega_c \sin\beta\, [J \omega_r + (I - J)\, \omega_c \cos\beta],\quad
              v_f = (\omega_i - \omega_c) r_f - \omega_r b

    with r = r_m -+ D/2 cos(alpha) at mid-contact, J and I about the roller's own and a transverse axis.

    Parameters
    ----------
    bearing : TaperedRollerBearing
        radii, angles and rollers
    inner_speed, outer_speed : float
        omega_i, omega_o [rad/s]

    Returns
    -------
    TaperedSpeeds
        speeds [rad/s], F_c [N], M_g [N m] and v_f [m/s]

    Source
    ------
    Kinematics of rigid bodies; M_g from the change of the angular momentum, dH/dt = omega_c x H.

    Valid
    -----
    No slip at mid-contact. The roller is the cylinder of its diameter at mid-contact; the frustum has 0.1 %
    more mass and 0.5 % more inertia where it tapers by 4 degrees.
    """
    inner, outer, roller = bearing.inner_radius, bearing.outer_radius, bearing.roller
    orbit = (inner_speed * inner + outer_speed * outer) / (inner + outer)
    spin = (inner_speed - outer_speed) * 2 * inner * outer / (roller.diameter * (inner + outer))
    transverse = roller.mass * (3 * roller.diameter**2 / 4 + roller.length**2) / 12
    tumbling = (transverse - roller.inertia) * orbit * bearing.along
    return TaperedSpeeds(
        orbit=orbit,
        spin=spin,
        centrifugal_force=roller.mass * bearing.pitch_diameter / 2 * orbit**2,
        gyroscopic_moment=orbit * bearing.up * (roller.inertia * spin + tumbling),
        rib_sliding=(inner_speed - orbit) * bearing.rib_radius - spin * bearing.rib.depth,
    )
