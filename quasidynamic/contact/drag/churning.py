"""Churning of the oil-air mixture by the own spin of rollers and balls."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.cage import couette_factor
from quasidynamic.contact.drag.orbit_drag import mixture_density
from quasidynamic.parts.oil_properties import Lubricant

if TYPE_CHECKING:  # balls load no rollers
    from quasidynamic.parts.roller_bearing import Roller

DISC_SHARPNESS = 8  # of the smooth maximum of both kinds of friction of a disc, and of a ball


class Churning(NamedTuple):
    """Braking torque of the mixture on a roller or a ball."""

    torque: NDArray  # [N m] against the spin, signed like it
    by_spin: NDArray  # [N m s] >= 0


def churning_torque(
    spin: NDArray, roller: "Roller", oil: Lubricant, *, oil_fraction: float, gap: float
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


def cylinder_churning(spin: NDArray, roller: "Roller", oil: Lubricant, gap: float) -> Churning:
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


def end_face_churning(spin: NDArray, roller: "Roller", oil: Lubricant) -> Churning:
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


def ball_churning(
    spin: NDArray, diameter: float, oil: Lubricant, *, oil_fraction: float, gap: float
) -> Churning:
    r"""Torque that brakes the spin of a ball: creeping flow in a gap around it, or its boundary layer.

    .. math:: T = \frac{\rho}{\rho_{oil}} \max\left[8 \pi \eta\, \omega r^3
              \frac{(r+c)^3}{(r+c)^3 - r^3},\;
              \tfrac12 \frac{6.45}{\sqrt{Re}} \rho_{oil} \omega^2 r^5\right],\quad
              Re = \rho_{oil} \omega r^2/\eta

    The maximum is smooth (`DISC_SHARPNESS`).

    Parameters
    ----------
    spin : array (...)
        omega in space [rad/s], the mixture at rest
    diameter : float
        2 r [m]
    oil : Lubricant
        density and viscosity
    oil_fraction : float
        X, volume share of oil in the mixture [-]
    gap : float
        c, mean distance from the ball to raceways and cage [m], > 0

    Returns
    -------
    Churning
        odd in the spin, with a continuous derivative, zero at rest

    Source
    ------
    Creeping flow between concentric spheres: Landau and Lifshitz, Fluid Mechanics, sec. 20; boundary layer:
    leading term of Dennis, Singh and Ingham, J. Fluid Mech. 101 (1980) 257 (recalled).

    Valid
    -----
    A mixture with the kinematic viscosity of the oil, as in `ball_drag_force`; laminar, Re up to about 1e5.
    """
    radius = diameter / 2
    outside = (radius + gap) ** 3
    creeping = 8 * np.pi * oil.viscosity * radius**3 * outside / (outside - radius**3)
    layer = 0.5 * 6.45 * np.sqrt(oil.density * oil.viscosity * np.abs(spin)) * radius**4
    greater = (layer / creeping) ** DISC_SHARPNESS
    share = mixture_density(oil, oil_fraction) / oil.density
    resistance = share * creeping * (1 + greater) ** (1 / DISC_SHARPNESS)
    return Churning(resistance * spin, resistance * (1 + 0.5 * greater / (1 + greater)))
