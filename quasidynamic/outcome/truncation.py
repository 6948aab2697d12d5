"""Truncation of contacts by the shoulders of grooves: how far contacts reach, and which reach too far."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

USUAL_SHOULDER = 0.25  # of the ball diameter, assumed: races of catalogue bearings are rarely higher


def edge_angle(
    contact_angle: NDArray, across: NDArray, radius: float, semi_axis: Literal["chord", "arc"]
) -> NDArray:
    r"""Contact angle of the edge of a contact, from the radial plane.

    .. math:: \theta = \alpha + \arcsin\frac{a}{\rho}\ \text{(chord)},\quad
              \theta = \alpha + \frac{a}{\rho}\ \text{(arc)}

    The first takes a as a chord on the ball, and is used for angular-contact bearings; the second as a length
    on the groove, and is used for four-point bearings. Beside their radii they differ by (a/rho)^3/6.

    Parameters
    ----------
    contact_angle : array (...)
        alpha, loaded, positive towards the shoulder [rad]
    across : array (...)
        a, semi-axis across the rolling direction [m]
    radius : float
        rho, of the ball or of the groove [m]
    semi_axis : {"chord", "arc"}
        what a is

    Returns
    -------
    array (...)
        theta [rad], not above a right angle with "chord"

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), on the axial load at which balls override the land, with
    a chord on the ball.

    Valid
    -----
    Geometry of the contact of grooves without an end; its pressure is not cut off.
    """
    if semi_axis == "arc":
        return contact_angle + across / radius
    return np.minimum(contact_angle + np.arcsin(np.minimum(across / radius, 1.0)), np.pi / 2)


def height_above_bottom(
    angle: NDArray, groove_radius: NDArray | float, aside: NDArray | float = 0.0
) -> NDArray:
    r"""Height of a point of a groove above its bottom.

    .. math:: h = \sqrt{r^2 - s^2} - r \cos\theta

    Parameters
    ----------
    angle : array (...)
        theta of the point from the radial plane [rad]
    groove_radius : array (...)
        r [m]
    aside : float or array (...)
        s, of the centre of the circle from the middle of the groove, where two arches meet [m]; zero for a
        groove of one circle

    Returns
    -------
    array (...)
        h [m]; a shoulder of this height ends at the point

    Source
    ------
    Geometry of a groove of one or two circles.
    """
    return np.sqrt(groove_radius**2 - np.square(aside)) - groove_radius * np.cos(angle)
