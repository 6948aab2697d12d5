"""Ratings, equivalent loads and life of tapered and spherical roller bearings."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from quasidynamic.outcome.capacity import (
    MATERIAL_FACTOR,
    dynamic_rating,
    reference_raceway_capacity,
    static_rating,
)
from quasidynamic.outcome.rating_life import EquivalentLoad
from quasidynamic.parts.roller_bearing import Roller
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing

SPHERICAL_MATERIAL_FACTOR = 1.15  # b_m of spherical roller bearings


@dataclass(frozen=True)
class InclinedRow:
    """Rollers of rows as ratings see them: with the projection of their length."""

    rollers: int
    roller: Roller
    pitch_diameter: float  # [m]
    contact_angle: float  # [rad] of the cup
    row_count: int = 1
    material_factor: ClassVar[float] = MATERIAL_FACTOR

    @classmethod
    def of(cls, bearing: TaperedRollerBearing) -> "InclinedRow":
        """The rows of a bearing."""
        roller, angle = bearing.roller, bearing.cup_angle
        projected = replace(roller, length=roller.length * cls.projection(angle))
        return cls(bearing.rollers, projected, bearing.pitch_diameter, angle, len(bearing.rows))

    @staticmethod
    def projection(contact_angle: float) -> float:
        """Length of the rollers in ratings over that of the contact [-], contact angle [rad]."""
        return float(np.cos(contact_angle))

    @property
    def diameter_ratio(self) -> float:
        """Gamma, D cos(alpha)/D_pw [-]."""
        return self.roller.diameter * float(np.cos(self.contact_angle)) / self.pitch_diameter

    @property
    def dynamic_rating(self) -> float:
        r"""C_r of ISO 281 [N].

        .. math:: C_r = b_m f_c\, (i\, l \cos\alpha)^{7/9} Z^{3/4} D^{29/27} \quad \text{(N, mm)}

        Source
        ------
        ISO 281 (2007), b_m = 1.1 of tapered roller bearings, 1.15 of spherical ones.
        """
        return dynamic_rating(self, self.material_factor)

    @property
    def static_rating(self) -> float:
        r"""C_0r of ISO 76 [N].

        .. math:: C_{0r} = 44\, (1 - \gamma)\, i Z\, l D \cos\alpha \quad \text{(N, mm)}

        Source
        ------
        ISO 76 (2006).
        """
        return static_rating(self)

    def raceway_capacity(self, rating: float) -> tuple[float, float]:
        r"""Roller loads that the raceways survive for a million revolutions [N], inner and outer.

        .. math:: Q_{ci} = \frac{C_r}{0.378\, \lambda\nu\, Z \cos\alpha} \{1 + X^{9/2}\}^{2/9}

        and Q_ce with 0.364 and -9/2, from C_r [N].

        Source
        ------
        ISO/TS 16281 (2008), Eqs. 47-49 with the contact angle.
        """
        inner, outer = reference_raceway_capacity(self, rating)
        cosine = float(np.cos(self.contact_angle))
        return inner / cosine, outer / cosine


class SphericalRow(InclinedRow):
    """Barrels of a spherical roller bearing as ratings see them."""

    material_factor = SPHERICAL_MATERIAL_FACTOR


def load_limit(contact_angle: float) -> float:
    """F_a/F_r up to which an axial load does not count, e = 1.5 tan(alpha) [-], alpha [rad].

    Source
    ------
    ISO 281 (2007), table 8.
    """
    return 1.5 * float(np.tan(contact_angle))


def axial_factor(contact_angle: float, *, opposed: bool = False) -> float:
    """Y = 0.4 cot(alpha) of the dynamic equivalent load [-], alpha [rad]; 0.67 of rows against each other.

    Source
    ------
    ISO 281 (2007), table 8.
    """
    return (0.67 if opposed else 0.4) / float(np.tan(contact_angle))


def tapered_dynamic_load(
    radial: float, axial: float, contact_angle: float, *, opposed: bool = False
) -> EquivalentLoad:
    r"""Dynamic equivalent radial load of one row, or of two against each other.

    .. math:: P_r = F_r \;(F_a/F_r \le e),\quad P_r = 0.4 F_r + 0.4 \cot\alpha\, F_a \;(F_a/F_r > e)

    .. math:: P_r = F_r + 0.45 \cot\alpha\, F_a \;(\le e),\quad
              P_r = 0.67 F_r + 0.67 \cot\alpha\, F_a \;(> e) \quad \text{(two rows)}

    Parameters
    ----------
    radial, axial : float
        F_r, F_a [N], >= 0
    contact_angle : float
        alpha of the cup [rad]
    opposed : bool
        whether two rows press each other

    Returns
    -------
    EquivalentLoad
        P_r [N] with X and Y

    Source
    ------
    ISO 281 (2007), section 7.2 and table 8.

    Valid
    -----
    The axial load is that which the bearing carries, induced thrust with it.
    """
    limit = load_limit(contact_angle)
    if opposed:
        x, share = (1.0, 0.45) if axial <= limit * radial else (0.67, 0.67)
        y = share / float(np.tan(contact_angle))
        return EquivalentLoad(x * radial + y * axial, x, y, limit)
    if axial <= limit * radial:
        return EquivalentLoad(radial, 1.0, 0.0, limit)
    y = axial_factor(contact_angle)
    return EquivalentLoad(0.4 * radial + y * axial, 0.4, y, limit)


def tapered_static_load(
    radial: float, axial: float, contact_angle: float, *, opposed: bool = False
) -> EquivalentLoad:
    r"""Static equivalent radial load of one row, or of two against each other.

    .. math:: P_{0r} = \max(0.5 F_r + 0.22 \cot\alpha\, F_a,\; F_r),\quad
              P_{0r} = F_r + 0.44 \cot\alpha\, F_a \quad \text{(two rows)}

    Arguments as of `tapered_dynamic_load`; P_0r is in N, with X_0 and Y_0.

    Source
    ------
    ISO 76 (2006), section 6.2.
    """
    y = 0.22 / float(np.tan(contact_angle))
    if opposed:
        return EquivalentLoad(radial + 2 * y * axial, 1.0, 2 * y)
    together = 0.5 * radial + y * axial
    return EquivalentLoad(together, 0.5, y) if together > radial else EquivalentLoad(radial, 1.0, 0.0)


def induced_thrust(radial: float, contact_angle: float) -> float:
    r"""Axial force that a radial load makes in a bearing set without play.

    .. math:: F = F_r/(2 Y)

    Parameters
    ----------
    radial : float
        F_r [N]
    contact_angle : float
        alpha of the cup [rad]

    Returns
    -------
    float
        F [N]; the other bearing of the shaft must carry it

    Source
    ------
    Catalogues of the makers, as SKF, Rolling bearings (2018): half of the rollers carry.
    """
    return radial / (2 * axial_factor(contact_angle))
