"""Gap of a ball and a circular groove on their true arcs."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.pressure.normal_contact import NormalContact
from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class BallInGroove:
    r"""A ball that just touches a groove, in arc lengths y of their section from the point of contact.

    .. math:: h = \sqrt{r^2 - e^2 \sin^2\psi} - \sqrt{R^2 - e^2 \sin^2\psi} - 2 e \cos\psi
              + \frac{x^2}{2} \Big[\frac1R \mp \frac{\cos(\alpha + \psi)}{d_m/2 \pm R \cos(\alpha + \psi)}
              \Big],\quad e = \frac{r - R}{2},\quad \psi = \frac{y}{R_m},\quad R_m = \frac{2 R r}{R + r}

    with the upper signs on the outer race: the distance of both circles along lines through the point midway
    between their centres, which are normal to the arc between them but for e^2/R^2.

    Source
    ------
    Geometry of two circles, derived here; R_m, the radius of the pressed section, by Hertz.

    Valid
    -----
    The contact is narrow along the rolling direction; across, it may be a large part of the groove. The
    displacement is that of half-spaces over the arc length.
    """

    ball_radius: float  # [m] R
    groove_radius: float  # [m] r, above R
    pitch_diameter: float  # [m] d_m of the ball centres
    contact_angle: float  # [rad] alpha, from the radial plane
    side: float  # -1 for the inner race, 1 for the outer one
    shoulder: float = np.inf  # [m] arc length from the point of contact to the end of the groove at +y

    def __post_init__(self):
        for name in ("ball_radius", "groove_radius", "pitch_diameter", "shoulder"):
            if name != "shoulder" or np.isfinite(self.shoulder):
                require_positive(f"ball_in_groove.{name}", getattr(self, name))
        if not self.groove_radius > self.ball_radius:
            raise ImpossiblePart(
                f"ball_in_groove.groove_radius = {self.groove_radius:.6g} m must be above the ball radius "
                f"{self.ball_radius:.6g} m"
            )

    @property
    def section_radius(self) -> float:
        """Radius R_m of the pressed section [m]."""
        return 2 * self.ball_radius * self.groove_radius / (self.ball_radius + self.groove_radius)

    @property
    def _radii(self) -> tuple[float, float]:
        return self.groove_radius, self.ball_radius

    def gap(self, x: NDArray, y: NDArray) -> NDArray:
        """Separation h [m] at places x along the rolling direction and y across, on the arc [m].

        Beyond the shoulder it is that of the ball's radius more: nothing touches there.
        """
        psi, e = y / self.section_radius, (self.groove_radius - self.ball_radius) / 2
        groove, ball = (np.sqrt(radius**2 - (e * np.sin(psi)) ** 2) for radius in self._radii)
        radial = np.cos(self.contact_angle + psi)
        race = self.side * radial / (self.pitch_diameter / 2 + self.side * self.ball_radius * radial)
        h = groove - ball - 2 * e * np.cos(psi) + x**2 / 2 * (1 / self.ball_radius - race)
        return h + np.where(y > self.shoulder, self.ball_radius, 0.0)

    def approach(self, y: NDArray) -> NDArray:
        r"""Displacement cos(psi) towards the groove by an approach of one along the contact normal [-].

        A uniform offset of both surfaces, as an interference in finite elements is applied, is 1 instead.
        """
        return np.cos(y / self.section_radius)

    def cut(self, contact: NormalContact) -> bool:
        """Whether the shoulder cuts a contact: its last cells before the shoulder carry pressure."""
        inside = contact.grid.centres[1][0] <= self.shoulder
        return bool(contact.touching[:, inside][:, -1:].any() and not inside.all())
