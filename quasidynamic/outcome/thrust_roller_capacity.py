"""Load ratings of rollers between two washers: contact angle of 90 degrees."""

from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.capacity import TABULATED, roller_size
from quasidynamic.outcome.tapered_life import InclinedRow

THRUST_MATERIAL_FACTOR = 1.0  # b_m of cylindrical and needle roller thrust bearings
THRUST_STRESS_REDUCTION = 0.73  # lambda nu of thrust roller bearings
THRUST_SHARE = 0.85  # eta = 1 - 0.15 sin(alpha), loads that rollers share unevenly


class ThrustRow(InclinedRow):
    """Rollers between washers as ratings see them."""

    @staticmethod
    def projection(contact_angle: float) -> float:
        """Ratings have the whole length of the rollers."""
        return 1.0

    @property
    def diameter_ratio(self) -> float:
        """D/D_pw [-]."""
        return self.roller.diameter / self.pitch_diameter

    @property
    def dynamic_rating(self) -> float:
        r"""C_a of ISO 281 [N].

        .. math:: C_a = b_m f_c\, l^{7/9} Z^{3/4} D^{29/27},\quad f_c = 472.45388\, \lambda\nu\, \eta\,
                  (D/D_{pw})^{2/9} \quad \text{(N, mm)}

        Raises
        ------
        OutOfRange
            when D/D_pw leaves the table of the standard

        Source
        ------
        ISO 281 (2007), single-direction thrust roller bearings of 90 degrees; f_c in closed form as a public
        program states ISO/TR 1281-1 (2008), not checked against its text.

        Valid
        -----
        D/D_pw from 0.01 to 0.30, as tabulated.
        """
        ratio, (low, high) = self.diameter_ratio, TABULATED
        if not low <= ratio <= high:
            raise OutOfRange(f"roller over pitch diameter {ratio:.4g} is outside {low} to {high} of ISO 281")
        factor = 472.45388 * THRUST_STRESS_REDUCTION * THRUST_SHARE * ratio ** (2 / 9)
        return THRUST_MATERIAL_FACTOR * factor * roller_size(self) * self.rollers ** (3 / 4)

    @property
    def static_rating(self) -> float:
        r"""C_0a of ISO 76 [N].

        .. math:: C_{0a} = 220\, Z l D \quad \text{(N, mm)}

        Source
        ------
        ISO 76 (2006), thrust roller bearings of 90 degrees.
        """
        return 220e6 * self.rollers * self.roller.length * self.roller.diameter

    def raceway_capacity(self, rating: float) -> tuple[float, float]:
        r"""Roller loads that the raceways survive for a million revolutions [N], both alike.

        .. math:: Q_c = \frac{2^{2/9} C_a}{\lambda\nu\, Z}

        Source
        ------
        ISO/TS 16281 (2008), thrust roller bearings, contact angle of 90 degrees.
        """
        each = 2 ** (2 / 9) * rating / (THRUST_STRESS_REDUCTION * self.rollers)
        return each, each
