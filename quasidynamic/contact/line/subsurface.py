"""Stresses below the line contact of a roller, with friction."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.contact.section_stress import SectionStress

ORTHOGONAL_SHEAR, ORTHOGONAL_DEPTH = 0.25, 0.5  # amplitude over p0, its depth over b; exact, see below


def line_contact_stress(
    along: ArrayLike, depth: ArrayLike, poisson_ratio: float, friction: float = 0.0
) -> SectionStress:
    r"""Stress below a Hertz strip that slides.

    .. math:: \zeta = x + i z,\quad I = \zeta - \sqrt{\zeta^2 - 1},\quad
              I' = 1 - \zeta/\sqrt{\zeta^2 - 1},

    .. math:: \sigma_x/p_0 = \Im I + z \Re I' - \mu (2 \Re I - z \Im I'),\quad
              \sigma_z/p_0 = \Im I - z \Re I' - \mu z \Im I',\\
              \tau_{xz}/p_0 = -z \Im I' + \mu (\Im I + z \Re I'),\quad
              \sigma_y = \nu (\sigma_x + \sigma_z)

    Lengths are over the half-width b, stresses over the peak pressure p0; the pressure is
    p0 sqrt(1 - x^2), the traction on the body mu times it, towards +x.

    Parameters
    ----------
    along : array (...)
        x, place in the rolling direction over b, from the middle [-]
    depth : array (...)
        z, depth over b [-], > 0
    poisson_ratio : float
        nu of the body [-]
    friction : float
        mu, traction over pressure [-], of either sign

    Returns
    -------
    SectionStress
        over p0 [-]

    Source
    ------
    McEwen, Phil. Mag. 40 (1949), 454-459, and Johnson, Contact Mechanics (1985), secs 4.2 and 7.1, whose m
    and n are the parts of the root; here as integrals I over Flamant's line loads. Its alternating part:
    tau_xz is greatest, p0/4, at z = b/2 and x = -b sqrt(3)/2, and least at +x, without friction.

    Valid
    -----
    Elastic half-space in plane strain: depths below the length of the contact and away from its ends; full
    sliding, no film. Residual stresses and those of fits come on top.

    >>> stress = line_contact_stress(0.0, 0.7861, 0.3)
    >>> print(f"{stress.principal_shear:.4f}")
    0.3003
    """
    z = np.asarray(depth, dtype=float)
    place = np.asarray(along) + 1j * z
    root = np.sqrt(place - 1) * np.sqrt(place + 1)  # of the branch that the depth requires
    whole, slope = place - root, z * (1 - place / root)
    along_stress = whole.imag + slope.real - friction * (2 * whole.real - slope.imag)
    normal = whole.imag - slope.real - friction * slope.imag
    shear = -slope.imag + friction * (whole.imag + slope.real)
    return SectionStress(along_stress, poisson_ratio * (along_stress + normal), normal, shear)


def orthogonal_shear(peak_pressure: ArrayLike, half_width: ArrayLike) -> tuple[NDArray, NDArray]:
    r"""Amplitude of the orthogonal shear stress below a line contact that rolls, and its depth.

    .. math:: \tau_0 = p_0/4,\quad z_0 = b/2

    Parameters
    ----------
    peak_pressure : array (...)
        p0 [Pa]
    half_width : array (...)
        b [m]

    Returns
    -------
    tuple of array (...)
        tau_0 [Pa], half of the range that a place of the raceway meets in passing, and z_0 [m]

    Source
    ------
    Lundberg and Palmgren (1947); the extremes of `line_contact_stress` without friction.

    Valid
    -----
    As `line_contact_stress`.
    """
    return ORTHOGONAL_SHEAR * np.asarray(peak_pressure), ORTHOGONAL_DEPTH * np.asarray(half_width)
