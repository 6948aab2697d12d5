"""Drag of the oil-air mixture on orbiting rollers and balls."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from quasidynamic.note import Note, outside
from quasidynamic.parts.oil_properties import Lubricant

if TYPE_CHECKING:  # balls load no rollers
    from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

AIR_DENSITY = 1.2  # [kg/m3]

# Drag coefficients across a stream, linear in log10(Re) between the points.
_LOG_REYNOLDS = np.log10([0.1, 1, 10, 100, 1e3, 1e4, 1e5, 2e5, 3e5, 4e5, 5e5, 1e6])
_CYLINDER_DRAG = np.array([60, 10, 3, 1.8, 1.0, 1.2, 1.2, 1.2, 0.9, 0.65, 0.3, 0.3])
_SPHERE_DRAG = np.array([275, 30, 4.2, 1.2, 0.48, 0.40, 0.45, 0.40, 0.10, 0.09, 0.09, 0.09])
# By ln(Re), zero before and after the points.
_CYLINDER_SLOPES, _SPHERE_SLOPES = (
    np.concatenate(([0.0], np.diff(points) / np.diff(_LOG_REYNOLDS) / np.log(10), [0.0]))
    for points in (_CYLINDER_DRAG, _SPHERE_DRAG)
)

DragTable = Callable[[NDArray | float], tuple[NDArray, NDArray]]


def _interpolated(reynolds: NDArray | float, points: NDArray, slopes: NDArray) -> tuple[NDArray, NDArray]:
    """Drag coefficient by its points, and its derivative by ln(Re)."""
    position = np.log10(np.maximum(reynolds, 1e-300))
    return np.interp(position, _LOG_REYNOLDS, points), slopes[_LOG_REYNOLDS.searchsorted(position)]


def cylinder_drag(reynolds: NDArray | float) -> tuple[NDArray, NDArray]:
    """Drag coefficient of a cylinder across the stream, and its derivative by ln(Re).

    Parameters
    ----------
    reynolds : array (...)
        Re [-] with the diameter, >= 0; held at the end values outside 0.1 to 1e6, see `drag_notes`

    Returns
    -------
    tuple of array (...)
        C_d [-], dC_d/dln Re [-]; the slope jumps at the table's points

    Source
    ------
    Table used in quasi-dynamic bearing programs, after Schlichting.

    Valid
    -----
    Re from 0.1 to 1e6; one cylinder far from others and from walls.
    """
    return _interpolated(reynolds, _CYLINDER_DRAG, _CYLINDER_SLOPES)


def sphere_drag(reynolds: NDArray | float) -> tuple[NDArray, NDArray]:
    """Drag coefficient of a sphere, and its derivative by ln(Re).

    Parameters
    ----------
    reynolds : array (...)
        Re [-] with the diameter, >= 0; held at the end values outside 0.1 to 1e6

    Returns
    -------
    tuple of array (...)
        C_d [-], dC_d/dln Re [-]; the slope jumps at the table's points

    Source
    ------
    Table used in quasi-dynamic bearing programs, after Schlichting.

    Valid
    -----
    Re from 0.1 to 1e6; one sphere far from others and from walls.
    """
    return _interpolated(reynolds, _SPHERE_DRAG, _SPHERE_SLOPES)


def drag_notes(reynolds: NDArray | float) -> tuple[Note, ...]:
    """Tell where Reynolds numbers [-] leave the table of `cylinder_drag`; empty inside it."""
    low, high = float(np.min(reynolds)), float(np.max(reynolds))
    if low >= 0.1 and high <= 1e6:
        return ()
    return (
        outside(
            "drag-table",
            f"drag of the rollers: Re from {low:.3g} to {high:.3g} leaves the table of C_d (0.1 to 1e6); "
            "its end values are held",
        ),
    )


def mixture_density(oil: Lubricant, oil_fraction: float) -> float:
    r"""Density of the oil-air mixture around the rollers.

    .. math:: \rho = X \rho_{oil} + (1 - X) \rho_{air}

    Parameters
    ----------
    oil : Lubricant
        density of the oil
    oil_fraction : float
        X, volume share of oil in the mixture [-], 0 to 1

    Returns
    -------
    float
        rho [kg/m3]

    Source
    ------
    Parker (1984), as used in quasi-dynamic bearing programs.

    Valid
    -----
    Well mixed: the same share of oil at every roller.
    """
    return oil_fraction * oil.density + (1 - oil_fraction) * AIR_DENSITY


def orbit_drag_force(
    cage_speed: NDArray | float,
    bearing: "CylindricalRollerBearing",
    oil: Lubricant,
    oil_fraction: float,
    coefficient: float | None = None,
) -> tuple[NDArray, NDArray]:
    r"""Force of the oil-air mixture on one orbiting roller.

    .. math:: F_g = \tfrac12 \rho\, C_d V^2\, l (D - t_c),\quad V = \omega_c d_m/2

    Parameters
    ----------
    cage_speed : array (...)
        omega_c [rad/s]
    bearing : CylindricalRollerBearing
        pitch and roller diameters, length l, cage thickness t_c
    oil : Lubricant
        density and viscosity; the Reynolds number is that of the oil
    oil_fraction : float
        X, volume share of oil in the mixture [-]
    coefficient : float, optional
        C_d [-] at any speed, instead of `cylinder_drag`

    Returns
    -------
    tuple of array (...)
        force against the motion [N], signed like the speed; derivative by cage speed [N s],
        which jumps where the slope of the table of C_d does

    Source
    ------
    Harris, Rolling Bearing Analysis; effective density after Parker.

    Valid
    -----
    As `cylinder_drag`.
    """
    roller, radius = bearing.roller, bearing.pitch_diameter / 2
    area = roller.length * np.maximum(roller.diameter - bearing.cage.thickness, 0.0)
    stream = oil, oil_fraction, coefficient
    force, by_speed = roller_drag_force(cage_speed * radius, area, roller.diameter, *stream)
    return force, by_speed * radius


def roller_drag_force(
    speed: NDArray | float,
    area: NDArray | float,
    diameter: NDArray | float,
    oil: Lubricant,
    oil_fraction: float,
    coefficient: float | None = None,
) -> tuple[NDArray, NDArray]:
    r"""Force of the oil-air mixture on a roller that shows an area to the stream, see `orbit_drag_force`.

    From the speed of its centre [m/s], its area [m2] and diameter D [m]; its derivative is by the speed
    [N s/m].

    Source
    ------
    As `orbit_drag_force`.

    Valid
    -----
    As `cylinder_drag`.
    """
    pushed = oil, mixture_density(oil, oil_fraction) * area, diameter
    return _stream_force(speed, pushed, cylinder_drag, coefficient)


def ball_drag_force(
    speed: NDArray, diameter: float, oil: Lubricant, oil_fraction: float, coefficient: float | None = None
) -> tuple[NDArray, NDArray]:
    r"""Force of the oil-air mixture on a ball.

    .. math:: F = \tfrac{\pi}{8} \rho\, C_d V^2 D^2

    Parameters
    ----------
    speed : array (...)
        V of the ball centre [m/s]
    diameter : float
        D [m]
    oil : Lubricant
        density and viscosity; the Reynolds number is that of the oil
    oil_fraction : float
        X, volume share of oil in the mixture [-]
    coefficient : float, optional
        C_d [-] at any speed, instead of `sphere_drag`

    Returns
    -------
    tuple of array (...)
        force against the motion [N], signed like the speed; derivative by speed [N s/m],
        which jumps where the slope of the table of C_d does

    Source
    ------
    As `orbit_drag_force`, of a sphere.

    Valid
    -----
    As `sphere_drag`; no cage shields the ball.
    """
    pushed = oil, mixture_density(oil, oil_fraction) * np.pi / 4 * diameter**2, diameter
    return _stream_force(speed, pushed, sphere_drag, coefficient)


def _stream_force(
    speed: NDArray | float,
    pushed: tuple[Lubricant, NDArray | float, NDArray | float],
    table: DragTable,
    coefficient: float | None,
) -> tuple[NDArray, NDArray]:
    """Drag [N] of a stream and its derivative by speed; from oil, density times area [kg/m], diameter [m]."""
    oil, mass, diameter = pushed
    size = np.abs(speed)
    if coefficient is None:
        value, slope = table(oil.density * diameter / oil.viscosity * size)
    else:
        value, slope = coefficient, 0.0
    half = 0.5 * mass * size
    return half * value * speed, half * (2 * value + slope)
