"""Forces that a model leaves out, over the load of the rolling element that carries most."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from quasidynamic.parts.roller_bearing import GRAVITY


def inertia_shares(
    mass: float, diameter: float, pitch_diameter: float, orbit: ArrayLike, spin: ArrayLike, load: ArrayLike
) -> tuple[Any, Any]:
    r"""Centrifugal force and gyroscopic moment of balls over a load.

    .. math:: \frac{m d_m \omega_m^2}{2 Q},\quad \frac{J\, \omega_m\, \omega_r}{D Q},\quad J = m D^2 / 10

    Parameters
    ----------
    mass : float
        m of a ball [kg]
    diameter : float
        D [m]
    pitch_diameter : float
        d_m [m]
    orbit : float or array (...)
        omega_m, orbital speed [rad/s]
    spin : float or array (...)
        omega_r, of a ball about the radial direction, which the orbit turns [rad/s]
    load : float or array (...)
        Q [N], > 0

    Returns
    -------
    tuple
        both shares [-], >= 0

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 5; the moment as a couple of forces at both races.

    Valid
    -----
    Balls on the pitch circle; sizes, not what they would change in loads and angles.

    >>> [round(float(share), 4) for share in inertia_shares(0.0249, 18.25e-3, 72.38e-3, 419.0, 1352.0, 342.0)]
    [0.4626, 0.0753]
    """
    inertia = mass * diameter**2 / 10
    centrifugal = mass * pitch_diameter * np.square(orbit) / 2
    return centrifugal / np.asarray(load), np.abs(inertia * np.multiply(orbit, spin)) / (
        diameter * np.asarray(load)
    )


def weight_share(mass: float, load: ArrayLike) -> Any:
    """Weight of a rolling element over a load.

    .. math:: m g / Q

    m is in kg, Q > 0 in N.

    Source
    ------
    Newton.

    Valid
    -----
    A shaft that does not stand upright.

    >>> round(float(weight_share(0.0249, 342.0)), 6)
    0.000714
    """
    return mass * GRAVITY / np.asarray(load)


def friction_share(torque: ArrayLike, pitch_diameter: float, loads: ArrayLike) -> Any:
    r"""Friction along the raceways over the loads that make it.

    .. math:: \frac{2 |M|}{d_m \sum Q}

    M [N m] is the friction torque between the rings, d_m [m] the pitch diameter, and the loads [N] are the
    sum over all contacts of a ring, > 0.

    Source
    ------
    Equivalent force on the pitch circle.

    Valid
    -----
    A mean of all rolling elements.

    >>> float(friction_share(0.5, 0.05, 1000.0))
    0.02
    """
    return 2 * np.abs(torque) / (pitch_diameter * np.asarray(loads))


def tilting_share(
    inertia: ArrayLike,
    length: ArrayLike,
    orbit: ArrayLike,
    spin: ArrayLike,
    tilt: ArrayLike,
    load: ArrayLike,
) -> Any:
    r"""Gyroscopic moment of rollers that tilt with the raceways, as a couple over a load.

    .. math:: \frac{J\, \omega_m\, \omega_R\, \psi}{L\, Q}

    Parameters
    ----------
    inertia : float or array (...)
        J of a roller about its axis, m D^2 / 8 [kg m2]
    length : float or array (...)
        L [m]
    orbit, spin : float or array (...)
        omega_m of the cage, omega_R of the roller [rad/s]
    tilt : float or array (...)
        psi, slope of the roller's axis against that of the bearing [rad]
    load : float or array (...)
        Q [N], > 0

    Returns
    -------
    float or array (...)
        share [-], >= 0

    Source
    ------
    Euler's equations for a symmetric body whose axis is turned by its orbit.

    Valid
    -----
    Small tilts.

    >>> round(float(tilting_share(1.25e-7, 0.01, 400.0, 4000.0, 1e-3, 1000.0)), 9)
    2e-05
    """
    turned = np.abs(np.asarray(orbit) * np.asarray(spin) * np.asarray(tilt))
    return np.asarray(inertia) * turned / (np.asarray(length) * np.asarray(load))
