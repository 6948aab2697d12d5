"""Stresses below the elliptic contact of a ball, in the plane of rolling through its middle."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import elliprd

from quasidynamic.contact.section_stress import SectionStress
from quasidynamic.errors import NotSolved, OutOfRange

TOLERANCE, LIMIT = 1e-14, 60  # of t, and Newton steps; five are usual
ROUND = 1e-6  # 1 - (b/a)^2 below which the contact counts as a circle, with an error of this size


def ellipse_stress(
    along: ArrayLike, depth: ArrayLike, axis_ratio: float, poisson_ratio: float
) -> SectionStress:
    r"""Stress below a Hertz ellipse without friction, in the plane of rolling through its middle (y = 0).

    With the semi-axes b = 1 along and a = 1/k across the rolling direction, Delta^2 = (a^2 + s)(1 + s) s and
    the positive root lambda of x^2/(1 + lambda) + z^2/lambda = 1,

    .. math:: V = \frac{\pi a}{2} \int_\lambda^\infty \Big(1 - \frac{x^2}{1+s} - \frac{y^2}{a^2+s}
              - \frac{z^2}{s}\Big) \frac{ds}{\Delta},\quad
              \chi_{yy} = \pi a \Big[\int_\lambda^\infty \frac{\sqrt{1+s-x^2}\, ds}{(a^2+s)^{3/2} (1+s)}
              - z \int_\lambda^\infty \frac{ds}{(a^2+s) \Delta}\Big],

    .. math:: 2\pi \sigma_x = 2\nu V_z - (1 - 2\nu) \chi_{xx} - z V_{xx},\quad
              2\pi \sigma_y = 2\nu V_z - (1 - 2\nu) \chi_{yy} - z V_{yy},\\
              2\pi \sigma_z = V_z - z V_{zz},\quad 2\pi \tau_{xz} = -z V_{xz},\quad
              \chi_{xx} + \chi_{yy} = -V_z

    Parameters
    ----------
    along : array (...)
        x, place in the rolling direction over b, from the middle [-]
    depth : array (...)
        z, depth over b [-], > 0
    axis_ratio : float
        k = b/a, semi-axis along over that across the rolling direction [-], above 0 to 1
    poisson_ratio : float
        nu of the body [-]

    Returns
    -------
    SectionStress
        over the peak pressure [-]

    Raises
    ------
    OutOfRange
        for an ellipse that is longer along than across the rolling direction

    Source
    ------
    Potentials of Love, Phil. Trans. R. Soc. A 228 (1929), 377-420; that of the ellipsoidal pressure as in
    Johnson, Contact Mechanics (1985), sec. 3.5; on the axis the stresses of Thomas and Hoersch (1930). The
    integral of chi is derived here: V_yy integrated over the depth, the order of both integrals exchanged.

    Valid
    -----
    Elastic half-space, frictionless; contact far smaller than both bodies.

    >>> stress = ellipse_stress(0.0, 0.481, 1.0, 0.3)
    >>> print(f"{stress.principal_shear:.4f}")
    0.3100
    """
    if not 0.0 < axis_ratio <= 1.0:
        raise OutOfRange(f"stress below an ellipse: b/a = {axis_ratio:.4g} must be above 0 and at most 1")
    x, z = np.broadcast_arrays(np.asarray(along, dtype=float), np.asarray(depth, dtype=float))
    wide = axis_ratio**-2.0  # a^2
    root = _confocal(x, z)
    by_x = elliprd(root, wide + root, 1 + root) * 2 / 3  # integrals of 1/((1 + s) Delta), and so on
    by_y = elliprd(root, 1 + root, wide + root) * 2 / 3
    by_z = elliprd(wide + root, 1 + root, root) * 2 / 3
    density = np.sqrt((wide + root) * (1 + root) * root)  # Delta at lambda
    norm = (x / (1 + root)) ** 2 + (z / root) ** 2
    root_x, root_z = 2 * x / (1 + root) / norm, 2 * z / root / norm  # slopes of lambda
    scale = np.pi / axis_ratio  # pi a, of the potentials
    v_z, v_yy = -scale * z * by_z, -scale * by_y
    v_xx = -scale * (by_x - x * root_x / ((1 + root) * density))
    v_zz = -scale * (by_z - z * root_z / (root * density))
    v_xz = scale * x * root_z / ((1 + root) * density)
    chi_yy = scale * (_across_integral(x, root, wide) - z * by_y)
    chi_xx = -v_z - chi_yy
    shrink = 1 - 2 * poisson_ratio
    stresses = (
        2 * poisson_ratio * v_z - shrink * chi_xx - z * v_xx,
        2 * poisson_ratio * v_z - shrink * chi_yy - z * v_yy,
        v_z - z * v_zz,
        -z * v_xz,
    )
    return SectionStress(*(stress / (2 * np.pi) for stress in stresses))


def _confocal(x: NDArray, z: NDArray) -> NDArray:
    """Positive root lambda of x^2/(1 + lambda) + z^2/lambda = 1, without cancellation inside the ellipse."""
    beyond = x**2 + z**2 - 1
    size = np.hypot(beyond, 2 * z)
    return np.where(beyond > 0, (size + beyond) / 2, 2 * z**2 / (size + np.abs(beyond)))


def _across_integral(x: NDArray, root: NDArray, wide: float) -> NDArray:
    r"""Integral of sqrt(1 + s - x^2)/((a^2 + s)^(3/2) (1 + s)) from lambda.

    With w^2 = (1 + s - x^2)/(a^2 + s), which grows to 1, it is that of 2 w^2/(d w^2 + x^2), d = a^2 - 1.
    """
    first = np.sqrt(np.maximum(1 + root - x**2, 0.0) / (wide + root))  # zero where rounding makes it less
    excess = wide - 1
    if excess <= ROUND * wide:
        return 2 / 3 * (1 + first + first**2) / (1 + first) / (wide + root)
    left = (excess + x**2) / ((wide + root) * (1 + first))  # 1 - w
    sized = np.sqrt(excess)
    angle = np.arctan2(sized * left * np.abs(x), x**2 + excess * first)
    return 2 / excess * (left - np.abs(x) / sized * angle)


def orthogonal_shear(
    peak_pressure: ArrayLike, half_width: ArrayLike, axis_ratio: ArrayLike
) -> tuple[NDArray, NDArray]:
    r"""Amplitude of the orthogonal shear stress below an elliptic contact that rolls, and its depth.

    .. math:: \frac{\tau_0}{p_0} = \frac{\sqrt{2t - 1}}{2 t (t + 1)},\quad
              \frac{z_0}{b} = \frac{1}{(t + 1) \sqrt{2t - 1}},\quad
              \frac{b}{a} = \sqrt{(t^2 - 1)(2t - 1)}

    Parameters
    ----------
    peak_pressure : array (...)
        p0 [Pa]
    half_width : array (...)
        b, semi-axis along the rolling direction [m]
    axis_ratio : array (...)
        b/a, over that across it [-], >= 0; 0 is a line

    Returns
    -------
    tuple of array (...)
        tau_0 [Pa], half of the range that a place of the raceway meets in passing, and z_0 [m]

    Raises
    ------
    NotSolved
        when t does not settle

    Source
    ------
    Lundberg and Palmgren (1947); Harris and Kotzalas, Rolling Bearing Analysis (2006), ch. 6.

    Valid
    -----
    As `ellipse_stress`; for every Poisson's ratio.

    >>> amplitude, depth = orthogonal_shear(1.0, 1.0, 1.0)
    >>> print(f"{amplitude:.3f} {depth:.3f}")
    0.214 0.351
    """
    t = _lundberg_parameter(np.asarray(axis_ratio, dtype=float))
    root = np.sqrt(2 * t - 1)
    return np.asarray(peak_pressure) * root / (2 * t * (t + 1)), np.asarray(half_width) / ((t + 1) * root)


def _lundberg_parameter(axis_ratio: NDArray) -> NDArray:
    """Root t >= 1 of (t^2 - 1)(2t - 1) = (b/a)^2, from above, where Newton's method never turns back."""
    t = 1 + axis_ratio**2 / 2
    for _ in range(LIMIT):
        step = ((t**2 - 1) * (2 * t - 1) - axis_ratio**2) / (6 * t**2 - 2 * t - 2)
        t = t - step
        if np.all(np.abs(step) <= TOLERANCE * t):
            return t
    raise NotSolved(
        f"Lundberg-Palmgren parameter not settled in {LIMIT} steps: {np.max(np.abs(step)):.1e} left"
    )
