"""Ends of skewed rollers between the guide flanges of a ring."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing, Flange


class FlangeCorner(NamedTuple):
    """Where the edge of a flange crosses the rim of a roller's end, from the middle of the roller."""

    lever: float  # [m] along the motion, on either side; the chord between two corners is twice that
    level: float  # [m] radially outwards


def flange_corner(flange: Flange, bearing: CylindricalRollerBearing) -> FlangeCorner:
    r"""Corner of a roller's end that a skewed roller meets the flange with.

    .. math:: a = \frac{r_f^2 + r_m^2 - r_e^2}{2 r_m},\quad y = \sqrt{r_f^2 - a^2},\quad
              r_f = r_i + h \;\text{or}\; r_o - h,\; r_e = D/2 - c

    the crossing of two circles, edge of the flange and rim of the end; y is the lever, a - r_m the level.

    Parameters
    ----------
    flange : Flange
        its ring, height h [m] and the roller's chamfer c [m]
    bearing : CylindricalRollerBearing
        raceway radii r_i, r_o, pitch radius r_m [m] and roller diameter D [m]

    Returns
    -------
    FlangeCorner
        y > 0 and a - r_m [m]

    Raises
    ------
    ImpossiblePart
        for a flange that reaches the middle of the roller, where the other ring or the cage is in its way

    Source
    ------
    Plane geometry.

    Valid
    -----
    Flat ends; a roller lying on the raceway of the flanged ring.
    """
    radius, pitch = bearing.roller.diameter / 2, bearing.pitch_diameter / 2
    if flange.height >= radius:
        raise ImpossiblePart(
            f"flange.height = {1e3 * flange.height:.4g} mm must be below half a roller diameter, "
            f"{1e3 * radius:.4g} mm"
        )
    on_inner = flange.ring == "inner"
    edge = bearing.inner_radius + flange.height if on_inner else bearing.outer_radius - flange.height
    rim = radius - flange.roller_chamfer
    from_axis = (edge**2 + pitch**2 - rim**2) / (2 * pitch)
    return FlangeCorner(lever=float(np.sqrt(edge**2 - from_axis**2)), level=from_axis - pitch)


def touching_skew(flange: Flange, lever: float) -> float:
    r"""Skew at which two opposite corners touch.

    .. math:: \psi_0 = c_f / (2 y)

    Parameters
    ----------
    flange : Flange
        axial clearance c_f [m]
    lever : float
        y [m]

    Returns
    -------
    float
        psi_0 [rad]

    Source
    ------
    Plane geometry.

    Valid
    -----
    Small angles: the shortening l psi^2/2 of the roller is left out.
    """
    return flange.clearance / (2 * lever)


def flange_push(beyond: NDArray, thrust: NDArray, flange: Flange, lever: float) -> NDArray:
    r"""Sum of the forces of both flanges on a roller that they hold against thrust and skew.

    .. math:: N_- + N_+ = \max(2 k y (|\psi| - \psi_0),\; |F_x|)

    A corner deflects in proportion to its force, N = k delta, with delta_+- = y (|psi| - psi_0) +- xi and
    the axial displacement xi such that N_+ - N_- = F_x.

    Parameters
    ----------
    beyond : array (...)
        abs(psi) - psi_0, skew beyond the touching [rad], negative inside the clearance
    thrust : array (...)
        F_x, axial force of the raceways on the roller [N], any sign
    flange : Flange
        stiffness k [N/m]
    lever : float
        y [m]

    Returns
    -------
    array (...)
        sum [N], >= 0

    Source
    ------
    Statics of a rigid roller between two linear stops.

    Valid
    -----
    Both flanges alike. A kink where the second corner begins to touch.
    """
    return np.maximum(2 * flange.stiffness * lever * beyond, np.abs(thrust))


def corner_couple(skew: NDArray, beyond: NDArray, thrust: NDArray, flange: Flange, lever: float) -> NDArray:
    r"""Restoring moment of the flanges' normal forces.

    .. math:: M = y \min[\max(|F_x|,\; 2 k y (|\psi| - \psi_0)),\; 2 k y |\psi|]

    Beyond psi_0 opposite corners hold the roller. Inside, the thrust presses its end on one flange: nearly
    flat on both corners of that end for a small skew, on one corner when the other has lifted.

    M [N m] is >= 0, against the skew, and rises with the skew at a given thrust; arguments are those of
    `flange_push`, and |psi| [rad].

    Source
    ------
    Statics of a rigid roller whose ends have two linear corners each.

    Valid
    -----
    As `flange_push`. Kinks where a corner lifts or begins to touch.
    """
    stiff = 2 * flange.stiffness * lever
    return lever * np.clip(np.abs(thrust), stiff * beyond, stiff * skew)


def flange_forces(push: NDArray, thrust: NDArray) -> NDArray:
    r"""Force of each flange on the roller.

    .. math:: N_\mp = (N_- + N_+ \mp F_x)/2

    An array (2, ...) [N], >= 0: the flange at the -x end, which pushes towards +x, and that at the +x end,
    which pushes towards -x. The push is at least as large as the thrust.

    Source
    ------
    Axial balance of the roller.
    """
    return 0.5 * np.array([push - thrust, push + thrust])


def corner_sliding(corner: FlangeCorner, spin: NDArray, ring_speed: float, pitch_radius: float) -> NDArray:
    r"""Sliding of the flange over the roller at the touching corner.

    .. math:: s_t = \Omega (r_m + \rho) + w \rho,\quad s_n = -(\Omega + w)\, t

    in the cage's frame, rho the level and t = y the place along the motion. At t = -y the radial part has
    the other sign.

    Parameters
    ----------
    corner : FlangeCorner
        y and rho [m]
    spin : array (Z)
        w, roller against the cage [rad/s], positive when it rolls forwards on the inner ring
    ring_speed : float
        Omega, flanged ring against the cage [rad/s]
    pitch_radius : float
        r_m [m]

    Returns
    -------
    array (2, Z)
        s_t along the motion and s_n radially outwards [m/s]

    Source
    ------
    Velocities of two rigid bodies at one point.

    Valid
    -----
    Angles of skew and tilt small.
    """
    along = ring_speed * (pitch_radius + corner.level) + spin * corner.level
    return np.array([along, -(ring_speed + spin) * corner.lever])
