r"""What holds a curved beam, as springs between its rigid section and the ground.

Motions are those of `fem.beam.curved_beam`. A straight beam along x, clamped at its far end, resists
its near end like springs in its middle: :math:`EA/L` axially, :math:`12EI/L^3(1+\Phi)` across and
:math:`EI/L`, :math:`GJ/L` against rotation.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.beam.curved_beam import SHEAR, shear_modulus, twist_constant
from fem.parts.rings import Elastic

FOOT = 16.67 / np.pi  # rotation of a half-plane below a bar, times E h b^2 / M; by work it would be 18 / pi


@dataclass(frozen=True, kw_only=True)
class SupportCompliance:
    """Compliances of a straight part along x, in its middle and per radian of the ring."""

    middle: float  # [m] x of it
    offset: float  # [m] its radius less that of the middle of the section
    compliance: NDArray  # (6,) in the order of `MOTIONS` [rad m/N, rad/(N m)]; 0: `on_ground`, `in_series`


def bars_around(
    number: int, section: tuple[float, float], span: tuple[float, float], offset: float, elastic: Elastic
) -> SupportCompliance:
    r"""Equal bars around the ring, spread evenly, which bend tangentially on elastic feet.

    .. math:: c_r = \frac{2\pi}{N} \left(\frac{L^3}{12 E I_r} + \frac{L}{\kappa G A}\right), \quad
              c_t = \frac{2\pi}{N} \left(\frac{L^3}{12 E I_t} + \frac{L}{\kappa G A}
              + \frac{c_f L^2}{2}\right), \quad c_f = \frac{16.67}{\pi E h b^2}

    Radially a bar is nearly as thick as the ring, which is no half-plane to it: no foot is counted.

    Parameters
    ----------
    number : int
        N
    section : tuple
        tangential and radial side b, h of a bar [m]
    span : tuple
        x of both ends [m]
    offset : float
        radius of the bars less that of the middle of the ring's section [m]
    elastic : Elastic
        of the bars

    Source
    ------
    Timoshenko beam with both ends guided, e.g. Przemieniecki, Theory of Matrix Structural Analysis, ch. 5;
    rotation of the edge of a half-plane: O'Donnell, J. Appl. Mech. 27 (1960) 461-464, plane stress. Its
    16.67/pi is quoted second-hand; the work of a pressure linear over the foot gives 18/pi.

    Valid
    -----
    Several bars per wave of the harmonic, with slots as wide as the bars or wider between them.
    """
    breadth, height = section
    L, area = abs(span[1] - span[0]), breadth * height
    E, G = elastic.youngs_modulus, shear_modulus(elastic)
    per_bar = np.array([
        L / (E * area),
        slide(L, breadth, height, elastic),
        tangential_slide(L, breadth, height, elastic),
        12 * L / (E * area * height**2),
        12 * L / (E * area * breadth**2) + 2 * FOOT / (E * height * breadth**2),
        L / (G * twist_constant(breadth, height)),
    ])  # fmt: skip
    return SupportCompliance(middle=sum(span) / 2, offset=offset, compliance=per_bar * 2 * np.pi / number)


def slide(length: float, breadth: float, height: float, elastic: Elastic) -> float:
    """Offset of the ends of a beam per force along its height, both ends guided [m/N]."""
    area = breadth * height
    bent = length**3 / (elastic.youngs_modulus * area * height**2)
    return bent + length / (SHEAR * shear_modulus(elastic) * area)


def tangential_slide(length: float, breadth: float, height: float, elastic: Elastic) -> float:
    """The same along its breadth, with both feet on half-planes [m/N]."""
    foot = FOOT / (elastic.youngs_modulus * height * breadth**2)
    return slide(length, height, breadth, elastic) + foot * length**2 / 2


def tube_wall(
    radius: float, height: float, span: tuple[float, float], offset: float, elastic: Elastic
) -> SupportCompliance:
    r"""A whole tube, its wall bent along x only, which resists turning (V) by its shear.

    A wall has no hinge against rotation about the radius: there it follows its own axial motion.

    .. math:: c_r = \frac1r \left(\frac{L^3}{E h^3} + \frac{L}{\kappa G h}\right), \quad c_t = \frac{L}{G r h}

    Parameters
    ----------
    radius : float
        r of the middle of its wall [m]
    height : float
        h of its wall [m]
    span : tuple
        x of both ends [m]
    offset : float
        r less the radius of the middle of the ring's section [m]
    elastic : Elastic
        of the tube

    Source
    ------
    Beams with guided ends in bending and shear around the circumference; derived here.

    Valid
    -----
    A tube so short that it carries more by bending along x than by its hoops, :math:`L < \sqrt{r h}`.
    """
    E, G, L = elastic.youngs_modulus, shear_modulus(elastic), abs(span[1] - span[0])
    bending = E * height**3 / 12
    per_metre = np.array([
        L / (E * height), slide(L, 1.0, height, elastic), L / (G * height), L / bending, 0.0,
        3 * L / (G * height**3),
    ])  # fmt: skip
    return SupportCompliance(middle=sum(span) / 2, offset=offset, compliance=per_metre / radius)


def on_ground(support: SupportCompliance) -> NDArray:
    """Stiffness (6, 6) per radian of a support on the ground; where its compliance is 0 it has no spring."""
    place = _place(support.middle, support.offset)
    springs = support.compliance > 0
    return place.T @ np.diag(np.where(springs, 1 / np.where(springs, support.compliance, 1.0), 0.0)) @ place


def in_series(*supports: SupportCompliance) -> NDArray:
    """Stiffness (6, 6) per radian of supports one behind the other; a compliance of 0 adds nothing."""
    total = np.zeros((6, 6))
    for support in supports:
        back = np.linalg.inv(_place(support.middle, support.offset))
        total += back @ np.diag(support.compliance) @ back.T
    return np.linalg.inv(total)


def forces_in_the_middle(*supports: SupportCompliance) -> NDArray:
    """Forces (6, 6) per radian in the middle of the first of supports in series, by motions of the section.

    They are those of the ring on what holds it, in the order of `MOTIONS`, and the same all along a part but
    for the lever of the forces across.
    """
    first = supports[0]
    return np.linalg.inv(_place(first.middle, first.offset)).T @ in_series(*supports)


def foundation(springs: tuple[float, float, float], radius: float, width: float, offset: float) -> NDArray:
    r"""Springs per area on a cylinder around the ring.

    .. math:: a = r \int (k_x u_x^2 + k_r u_r^2 + k_t u_t^2)\,dx

    Parameters
    ----------
    springs : tuple
        k_x, k_r, k_t [N/m^3]
    radius : float
        r of the cylinder [m]
    width : float
        of the cylinder, centred on the section [m]
    offset : float
        r less the radius of the middle of the section [m]

    Returns
    -------
    array (6, 6)
        stiffness per radian

    Source
    ------
    Virtual work of springs on a rigid section; derived here.
    """
    axial, radial, tangential = (k * radius * width for k in springs)
    lever = width**2 / 12
    law = np.diag([axial, radial, tangential, radial * lever, tangential * lever, 0.0])
    return carried(law, offset)


def carried(stiffness: NDArray, offset: float) -> NDArray:
    """Stiffness (..., 6, 6) of a ring on another radius, in the motions of the section that carries it."""
    place = _place(0.0, offset)
    return place.T @ stiffness @ place


def _place(x: float, offset: float) -> NDArray:
    """Motions of a frame that is fixed to the section at x and at some height over its middle."""
    place = np.eye(6)
    place[0, 3] = -offset  # U - rho theta
    place[1, 3] = x  # W + x theta
    place[2, 4:] = x, offset  # V + x chi + rho psi
    return place
