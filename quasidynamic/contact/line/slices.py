"""A roller's length cut into slices, and the axial modes that carry load and displacement."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.contact.section_stress import SectionStress
from quasidynamic.errors import ImpossiblePart

if TYPE_CHECKING:  # balls load no rollers
    from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

ORTHOGONAL_SHEAR, ORTHOGONAL_DEPTH = 0.25, 0.5  # amplitude over p0, its depth over b; exact, see below


@dataclass(frozen=True)
class Slices:
    """Equal slices along a roller, with Legendre polynomials as axial modes.

    A displacement along the roller is sum_m a_m L_m(2x/l); the force conjugate to a_m is
    F_m = sum_k q_k L_m(2 x_k/l) l/K. F_0 is the load, F_1 l/2 the moment about mid-roller.

    With one axial mode neither roller nor raceway tilts: both halves of the roller carry the same load, and
    only one of them is computed. Where lengths differ between cases, weights are shares of the length.
    """

    count: int
    length: NDArray | float  # [m] of all rollers, or (C, 1) of those of every case
    axial_modes: int = 2  # how many Legendre polynomials; 1 is an aligned roller, 2 has a tilt

    def __post_init__(self):
        if self.count < 2 or self.axial_modes < 1:
            raise ImpossiblePart("a roller needs at least 2 slices and 1 axial mode")
        if self.axial_modes > self.count:
            raise ImpossiblePart(f"{self.axial_modes} axial modes need as many slices, found {self.count}")

    def with_axial_modes(self, count: int) -> "Slices":
        """The same slices with so many axial modes."""
        return self if count == self.axial_modes else replace(self, axial_modes=count)

    @property
    def halved(self) -> bool:
        """Whether one half stands for both."""
        return self.axial_modes == 1

    @cached_property
    def all_places(self) -> NDArray:
        """Centres of all slices (count) from mid-roller, over half of the length [-]."""
        return (2 * np.arange(self.count) + 1) / self.count - 1

    @cached_property
    def places(self) -> NDArray:
        """Centres 2x/l (K) of the slices that are computed [-]."""
        return self.all_places[self.count // 2 :] if self.halved else self.all_places

    @property
    def all_centres(self) -> NDArray:
        """Centres of all slices (count) from mid-roller, lengths being alike [m]."""
        return self.all_places * self.length / 2

    @property
    def centres(self) -> NDArray:
        """Centres x (K) of the slices that are computed, lengths being alike [m]."""
        return self.places * self.length / 2

    @cached_property
    def widths(self) -> NDArray:
        """Length of roller (K) that each computed slice stands for [m], or its share of the length [-]."""
        width = (1 if self._lengths_differ else self.length) / self.count
        widths = np.full(len(self.places), (1 + self.halved) * width)
        if self.halved and self.count % 2:
            widths[0] = width  # the middle slice has no twin
        return widths

    @property
    def width(self) -> NDArray | float:
        """Width of a slice [m]."""
        return self.length / self.count

    @cached_property
    def _lengths_differ(self) -> bool:
        return isinstance(self.length, np.ndarray)

    def drop(self, bearing: "CylindricalRollerBearing") -> NDArray:
        """Drop of rollers and raceways at the computed slices (K, 2, 1 or C, 1) [m], inner raceway first."""
        centres = self.places[:, None, None] * (self.length / 2)
        drops = (bearing.drop(race, centres, self.length) for race in (0, 1))
        return np.stack(np.broadcast_arrays(*drops), 1)

    @cached_property
    def modes(self) -> NDArray:
        r"""Legendre polynomials L_m at the computed slices (K, M) [-].

        .. math:: (m + 1)(L_{m+1} - L_m) = (2m + 1)(x - 1) L_m + m (L_m - L_{m-1})

        Source
        ------
        Bonnet's recurrence, in differences, which keep their digits at the ends of the roller.
        """
        x = self.places
        difference, modes = x - 1, [np.ones_like(x), x]
        for m in range(1, self.axial_modes - 1):
            difference = (2 * m + 1) / (m + 1) * (x - 1) * modes[-1] + m / (m + 1) * difference
            modes.append(modes[-1] + difference)
        return np.stack(modes[: self.axial_modes], axis=-1)

    def spread(self, coefficients: NDArray) -> NDArray:
        """Values (K, ...) at the computed slices from coefficients (M, ...) of the axial modes."""
        # Quicker than `@` where it is small.
        return self.modes.dot(coefficients.reshape(len(coefficients), -1)).reshape(
            -1, *coefficients.shape[1:]
        )

    def total(self, values: NDArray) -> NDArray:
        """Integral (...) along the roller of values (K, ...) per length."""
        return self._integral(self.widths, values)

    def summed(self, values: NDArray) -> NDArray:
        """Integrals (M, ...) of values (K, ...) per length times the axial modes."""
        return self._integral(self.weights.T, values)

    def paired(self, values: NDArray) -> NDArray:
        """Integrals (M, M, ...) of values (K, ...) per length times products of two axial modes."""
        return self._integral(self.products.T, values).reshape(
            self.axial_modes, self.axial_modes, *values.shape[1:]
        )

    def _integral(self, weights: NDArray, values: NDArray) -> NDArray:
        """Weighted sums (n, ...) over the slices of values (K, ...) per length, or (...) with weights (K)."""
        total = weights.dot(values.reshape(len(values), -1))
        total = total.reshape(*weights.shape[:-1], *values.shape[1:])
        return self.length * total if self._lengths_differ else total

    @cached_property
    def weights(self) -> NDArray:
        """Forces from loads per length: shape times width (K, M) [m], or over the length [-]."""
        return self.modes * self.widths[:, None]

    @cached_property
    def products(self) -> NDArray:
        """Products of two axial modes times width (K, M M), for stiffness sums [m]."""
        return (self.modes[:, :, None] * self.weights[:, None, :]).reshape(len(self.places), -1)

    def unfolded(self, values: NDArray) -> NDArray:
        """Values (..., count) at all slices from those (..., K) at the computed ones."""
        if not self.halved:
            return values
        twins = values[..., self.count % 2 :]
        return np.concatenate([twins[..., ::-1], values], axis=-1)


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
