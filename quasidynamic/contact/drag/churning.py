"""Churning of the oil-air mixture by a roller's own spin."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.cage import couette_factor
from quasidynamic.contact.drag.orbit_drag import mixture_density
from quasidynamic.parts.oil_properties import Lubricant
from quasidynamic.parts.roller_bearing import Roller

DISC_SHARPNESS = 8  # of the smooth maximum of laminar and turbulent disc friction


class Churning(NamedTuple):
    """Braking torque of the mixture on a roller."""

    torque: NDArray  # [N m] against the spin, signed like it
    by_spin: NDArray  # [N m s] >= 0


def churning_torque(
    spin: NDArray, roller: Roller, oil: Lubricant, *, oil_fraction: float, gap: float
) -> Churning:
    r"""Torque that brakes the spin of a roller: its cylinder in the gap, its two end faces as free discs.

    .. math:: T = \frac{\rho}{\rho_{oil}} (T_{cylinder} + T_{ends}),\quad
              \rho = X \rho_{oil} + (1 - X) \rho_{air}

    Parameters
    ----------
    spin : array (...)
        omega, relative to the walls around the roller [rad/s]
    roller : Roller
        diameter, length
    oil : Lubricant
        density and viscosity
    oil_fraction : float
        X, volume share of oil in the mixture [-]
    gap : float
        c, mean distance from the roller's cylinder to raceways and cage [m], > 0

    Returns
    -------
    Churning
        odd in the spin, with a continuous derivative, zero at rest

    Source
    ------
    Sum of `cylinder_churning` and `end_face_churning`.

    Valid
    -----
    A mixture with the kinematic viscosity of the oil, as in `orbit_drag_force`; no rib near the end faces.
    """
    share = mixture_density(oil, oil_fraction) / oil.density
    cylinder, ends = cylinder_churning(spin, roller, oil, gap), end_face_churning(spin, roller, oil)
    return Churning(share * (cylinder.torque + ends.torque), share * (cylinder.by_spin + ends.by_spin))


def cylinder_churning(spin: NDArray, roller: Roller, oil: Lubricant, gap: float) -> Churning:
    r"""Torque of pure oil on the cylinder of a roller that spins in a narrow gap.

    .. math:: T = \tfrac12 f \rho\, \omega^2 r^3 A,\quad A = 2\pi r l,\;
              f = \frac{2}{Re} \frac{f}{f_L},\; Re = \rho\, \omega r c/\eta

    Odd in the spin; r and l are those of the roller, the gap is c [m].

    Source
    ------
    Rumbarger, Filetti and Gubernick (1973), with `couette_factor`; laminar friction after Petroff.

    Valid
    -----
    Gap far below the radius, the same all around.
    """
    radius = roller.diameter / 2
    laminar = 2 * np.pi * oil.viscosity * radius**3 * roller.length / gap
    reynolds = oil.density * radius * gap / oil.viscosity * np.abs(spin)
    factor, slope = couette_factor(reynolds, gap / radius)
    return Churning(laminar * factor * spin, laminar * factor * (1 + slope))


def end_face_churning(spin: NDArray, roller: Roller, oil: Lubricant) -> Churning:
    r"""Torque of pure oil on both end faces of a roller.

    .. math:: T = \tfrac12 C_M\, \rho\, \omega^2 r^5,\quad
              C_M = \max\left(3.87\, Re^{-1/2},\; 0.146\, Re^{-1/5}\right),\; Re = \rho\, \omega r^2/\eta

    The maximum is smooth (`DISC_SHARPNESS`) and turns turbulent at Re = 5.6e4; a smooth disc in still oil can
    stay laminar up to 3e5, where C_M is then too high by 66 percent.

    Odd in the spin, as its power 3/2 at rest.

    Source
    ------
    Schlichting, Boundary-Layer Theory, rotating disc wetted on both sides, laminar and turbulent.

    Valid
    -----
    Free discs: walls further away than the boundary layer; Re above 100.
    """
    radius = roller.diameter / 2
    reynolds = oil.density * radius**2 / oil.viscosity * np.abs(spin)
    turbulent = (0.146 / 3.87) ** DISC_SHARPNESS * reynolds ** (0.3 * DISC_SHARPNESS)  # over laminar
    # C_M |omega| is finite at rest, C_M alone is not: T = resistance omega.
    resistance = 0.5 * radius**3 * oil.viscosity * 3.87 * np.sqrt(reynolds)
    resistance = resistance * (1 + turbulent) ** (1 / DISC_SHARPNESS)
    return Churning(resistance * spin, resistance * (1.5 + 0.3 * turbulent / (1 + turbulent)))
