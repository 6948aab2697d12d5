"""Drag of the oil-air mixture on rollers, of the oil film on the cage land."""

import numpy as np

from quasidynamic.parts.bearing import CylindricalRollerBearing
from quasidynamic.parts.cage import Cage
from quasidynamic.parts.lubricant import Lubricant

AIR_DENSITY = 1.2  # [kg/m3]

# Cylinder across a stream, linear in log10(Re) between the points.
_LOG_REYNOLDS = np.log10([0.1, 1, 10, 100, 1e3, 1e4, 1e5, 2e5, 3e5, 4e5, 5e5, 1e6])
_CYLINDER_DRAG = np.array([60, 10, 3, 1.8, 1.0, 1.2, 1.2, 1.2, 0.9, 0.65, 0.3, 0.3])


def cylinder_drag(reynolds: float) -> tuple[float, float]:
    """Drag coefficient of a cylinder across the stream, and its derivative by ln(Re).

    Parameters
    ----------
    reynolds : float
        with the diameter; held at the end values outside 0.1 to 1e6

    Returns
    -------
    tuple of float
        C_d [-], dC_d/dln Re [-]; the slope jumps at the table's points

    Source
    ------
    Table used in quasi-dynamic bearing programs, after Schlichting.
    """
    position = np.log10(max(reynolds, 1e-300))
    piece = int(np.searchsorted(_LOG_REYNOLDS, position))
    if piece in (0, len(_LOG_REYNOLDS)):
        return float(np.interp(position, _LOG_REYNOLDS, _CYLINDER_DRAG)), 0.0
    rise = _CYLINDER_DRAG[piece] - _CYLINDER_DRAG[piece - 1]
    slope = rise / (_LOG_REYNOLDS[piece] - _LOG_REYNOLDS[piece - 1])
    value = _CYLINDER_DRAG[piece - 1] + slope * (position - _LOG_REYNOLDS[piece - 1])
    return float(value), float(slope / np.log(10))


def orbit_drag(
    cage_speed: float, bearing: CylindricalRollerBearing, oil: Lubricant, oil_fraction: float
) -> tuple[float, float]:
    r"""Force of the oil-air mixture on one orbiting roller.

    .. math:: F_g = \tfrac12 \rho\, C_d V^2\, l (D - t_c),\quad
              \rho = X \rho_{oil} + (1 - X) \rho_{air},\; V = \omega_c d_m/2

    Parameters
    ----------
    cage_speed : float
        omega_c [rad/s]
    bearing : CylindricalRollerBearing
        pitch and roller diameters, length l, cage thickness t_c
    oil : Lubricant
        density and viscosity; the Reynolds number is that of the oil
    oil_fraction : float
        X, volume share of oil in the mixture [-]

    Returns
    -------
    tuple of float
        force against the motion [N], signed like the speed; derivative by cage speed [N s]

    Source
    ------
    Harris, Rolling Bearing Analysis; effective density after Parker.
    """
    roller = bearing.roller
    radius = bearing.pitch_diameter / 2
    speed = cage_speed * radius
    density = oil_fraction * oil.density + (1 - oil_fraction) * AIR_DENSITY
    area = roller.length * max(roller.diameter - bearing.cage.thickness, 0.0)
    coefficient, slope = cylinder_drag(oil.density * roller.diameter * abs(speed) / oil.viscosity)
    half = 0.5 * density * area
    return half * coefficient * speed * abs(speed), half * abs(speed) * (2 * coefficient + slope) * radius


def land_drag(cage: Cage, oil: Lubricant) -> float:
    r"""Torque of the guiding land per speed difference, concentric and laminar.

    .. math:: M/\Delta\omega = 2 \pi \eta_0 R^3 L / c

    Parameters
    ----------
    cage : Cage
        land radius R, total width L, radial clearance c
    oil : Lubricant
        eta0

    Returns
    -------
    float
        [N m s]; zero when the rollers guide the cage

    Source
    ------
    Petroff (1883).

    Valid
    -----
    Full oil film, no Taylor vortices, concentric cage.
    """
    if cage.guidance == "rollers":
        return 0.0
    radius = cage.land_diameter / 2
    return 2 * np.pi * oil.viscosity * radius**3 * cage.land_width / (cage.land_clearance / 2)
