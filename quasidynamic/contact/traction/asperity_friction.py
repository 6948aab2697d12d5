"""Friction of the asperities in a line contact, from its slip."""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import SMALLEST_LOAD
from quasidynamic.contact.traction.film_strip import loaded_strip
from quasidynamic.errors import ImpossiblePart, require_positive

NO_STICK = 1e-200  # [-] creep of full slip that is none: nothing overflows where it divides


class AsperityTraction(NamedTuple):
    """Traction of the asperities per length [N/m], signed like the sliding, with its derivatives."""

    force: NDArray
    by_load: NDArray  # d/dq [-]
    by_sliding: NDArray  # [N s/m2]
    by_entrainment: NDArray  # [N s/m2]
    by_share: NDArray  # [N/m]


class AsperityFriction(Protocol):
    """Maps load per length, sliding, entrainment speed and share of the load on asperities to a traction."""

    def __call__(
        self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, share: NDArray
    ) -> AsperityTraction:
        """Evaluate on arrays that broadcast against each other."""
        ...


@dataclass(frozen=True, kw_only=True)
class RoundedCoulomb:
    r"""Coulomb friction that changes its sign over a sliding speed.

    .. math:: F = f_a\, \mu_b\, q\, \frac{u_s}{\sqrt{u_s^2 + v_0^2}}

    Source
    ------
    A regularisation: v0 has no physical meaning; 99 % of the friction is there at 7 v0.

    Valid
    -----
    v0 far below the sliding speeds that matter, which between slow rollers no fixed v0 is: there `Carter`.
    """

    coefficient: NDArray | float  # [-] mu_b, 0.08 to 0.13 for oils on steel
    sign_speed: NDArray | float  # [m/s] v0

    def __post_init__(self):
        _require_coefficient(self.coefficient)
        for value in np.ravel(self.sign_speed).tolist():
            require_positive("asperity friction: sign_speed", value)

    def __call__(
        self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, share: NDArray
    ) -> AsperityTraction:
        """Traction; the entrainment speed does not enter this law."""
        rounded = np.hypot(sliding, self.sign_speed)
        friction = self.coefficient * sliding / rounded
        steepness = self.coefficient * (self.sign_speed / rounded) ** 2 / rounded
        by_sliding = share * steepness * line_load
        return AsperityTraction(
            force=share * friction * line_load,
            by_load=share * friction,
            by_sliding=by_sliding,
            by_entrainment=np.zeros_like(by_sliding),
            by_share=friction * line_load,
        )


@dataclass(frozen=True, kw_only=True)
class Carter:
    r"""Coulomb friction of cylinders that roll with stick and slip: the creep of their elastic surfaces.

    .. math:: F = \mu q\; c\!\left(\frac{\xi}{\xi_1}\right),\quad c(r) = r\,(2 - |r|),\ c = \pm 1
              \text{ beyond } \pm 1,\quad \xi = \frac{u_s}{u},\quad \xi_1 = \frac{\mu b}{R},\quad
              \mu = f_a \mu_b

    The area of stick begins where material enters and has the half-width b (1 - |r|); all of the contact
    slips from xi_1 on. The slope at rest is pi E' b/4 per creep with any friction.

    Source
    ------
    Carter (1926), On the Action of a Locomotive Driving Wheel; Johnson, Contact Mechanics (1985), sec. 8.3.
    The asperities' share as a factor of the friction limit: derived here.

    Valid
    -----
    Quasi-static rolling in plane strain: half-width far below the radius and the length of the roller, and
    load that changes little along the roller over a half-width, as slices do not shear each other. Between
    unlike materials the slip that pressure makes (Bufler 1959) is left out, an effect of the order of
    Dundurs' constant beta. The film's traction does not shear the surfaces where they stick.
    One continuous derivative: c bends at r = 0 and at r = +-1.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    coefficient: NDArray | float  # [-] mu_b
    smallest_load: float = SMALLEST_LOAD  # [-] q/(E' R) below which the half-width keeps its value

    def __post_init__(self):
        _require_coefficient(self.coefficient)

    def __call__(
        self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, share: NDArray
    ) -> AsperityTraction:
        """Traction, with entrainment > 0."""
        strip, friction = loaded_strip(line_load, self), share * self.coefficient
        creep = sliding / entrainment
        full_slip = full_slip_creep(friction, strip.half_width, self.radius)
        ratio, sheared = creep_friction(creep, full_slip)
        limit, sticking = friction * line_load, 1 - np.abs(ratio)
        # friction / full_slip = R/b, also where no asperities touch
        by_creep = 2 * line_load * self.radius / strip.half_width * sticking
        changing = 2 * ratio * sticking  # r c'
        return AsperityTraction(
            force=limit * sheared,
            by_load=friction * (sheared - 0.5 * strip.load_share * changing),
            by_sliding=by_creep / entrainment,
            by_entrainment=-limit * changing / entrainment,
            by_share=self.coefficient * line_load * (sheared - changing),
        )


def full_slip_creep(friction: NDArray, half_width: NDArray, radius: NDArray | float) -> NDArray:
    r"""Creep from which on all of a line contact slips.

    .. math:: \xi_1 = \frac{\mu b}{R}

    Parameters
    ----------
    friction : array (...)
        mu [-], >= 0
    half_width : array (...)
        b [m]
    radius : array (...)
        R, reduced radius [m]

    Returns
    -------
    array (...)
        sliding over the mean surface speed [-]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 8.3: 2 mu p0/E* with p0 = E* b/(2 R); holds for unlike materials
    of Dundurs' beta = 0 as well.

    >>> round(float(full_slip_creep(0.1, 0.1e-3, 4e-3)), 6)
    0.0025
    """
    return friction * half_width / radius


def creep_friction(creep: NDArray, full_slip: NDArray) -> tuple[NDArray, NDArray]:
    r"""Friction of a line contact that rolls with stick and slip, over its limit.

    .. math:: \frac{F}{\mu q} = c(r) = r\,(2 - |r|),\quad r = \xi/\xi_1 \in [-1, 1],\qquad
              c = 1 - (1 - r)^2 \ \text{for}\ r \ge 0

    Parameters
    ----------
    creep : array (...)
        xi, sliding over mean surface speed [-], any sign
    full_slip : array (...)
        xi_1, see `full_slip_creep` [-], >= 0

    Returns
    -------
    tuple of array (...)
        r, held at +-1 where all of the contact slips, and c [-]; both odd in the creep, c' = 2 (1 - |r|)

    Source
    ------
    Carter (1926); Johnson, Contact Mechanics (1985), sec. 8.3.

    Valid
    -----
    See `Carter`. A kink of c' at r = 0 and at +-1; without any friction c is the sign of the creep.

    >>> ratio, sheared = creep_friction(np.array([0.0, -1e-3, 4e-3]), np.array(2e-3))
    >>> ratio.tolist(), sheared.tolist()
    ([0.0, -0.5, 1.0], [0.0, -0.75, 1.0])
    """
    ratio = np.clip(creep / np.maximum(full_slip, NO_STICK), -1.0, 1.0)
    return ratio, ratio * (2 - np.abs(ratio))


def _require_coefficient(coefficient: NDArray | float) -> None:
    for value in np.ravel(coefficient).tolist():
        if not 0 <= value < float("inf"):
            raise ImpossiblePart(f"asperity friction: coefficient = {value!r} must be finite and >= 0")
