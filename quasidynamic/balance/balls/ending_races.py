"""Contacts of balls with races that end on shoulders."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.point_contact import PointContact
from quasidynamic.contact.ellipse.truncated import energy_share
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing

BEHIND = np.pi  # [rad] contact angle that stands for a groove without an end
SIDES = np.array([1.0, -1.0]).reshape(2, 1, 1, 1)  # towards the shoulder that the load presses, and the other
NO_APPROACH = 1e-30  # [m] stands for none


class CutContacts(NamedTuple):
    """Contacts with the inner and with the outer race (2, C, Z), and how far shoulders cut them off."""

    whole: NDArray  # [N] loads of whole contacts at the same approach
    loads: NDArray  # [N]
    stiffness: NDArray  # [N/m] of the loads by the distances of ball and groove centres
    by_angle: NDArray  # [N/rad] of the same by the contact angles
    aside: NDArray  # [N] S along the groove section, signed like tractions
    aside_stiffness: NDArray  # [N/m] of S by the distances
    aside_by_angle: NDArray  # [N/rad]


@dataclass(frozen=True)
class EndingRaces:
    r"""Forces of contacts that shoulders cut off, by the energy U of the pressed surfaces.

    .. math:: U = \tfrac25 K \delta^{5/2} \Big[1 - \sum_\pm (1 - \psi(c_\pm))\Big],\quad
              c_\pm = \frac{r (\alpha_\pm \mp \alpha)}{a(\delta)},\quad
              Q = \frac{\partial U}{\partial L},\quad S = \frac{1}{L} \frac{\partial U}{\partial \alpha}

    with the distance L of ball and groove centres, delta = L less its unloaded value, and grooves of radius r
    that end at the contact angles alpha_+ and -alpha_-. S is what the pressure has along the groove section:
    its middle is off the contact normal, away from the cut, and pushes the ball towards the shoulder. Both
    forces act through the ball centre.

    Source
    ------
    Virtual work; psi of `energy_share`, whose derivative by the cut is the moment of the pressure.

    Valid
    -----
    As `energy_share`; of both sides of one contact what each alone takes, too little. Shoulders do not tilt
    with the ring, and semi-axes are those of the unloaded contact angle.
    """

    ends: NDArray  # (2, 2, 1, 1) [rad] alpha_+, alpha_- of the inner and of the outer race
    radius: NDArray  # (2, 1, 1) [m] r
    spread: NDArray  # (2, 1, 1) [m^0.5] a over the root of the approach
    ratio: NDArray  # (2, 1, 1) [-] a/b

    @classmethod
    def of(
        cls, bearing: AngularContactBearing, contacts: tuple[PointContact, PointContact]
    ) -> "EndingRaces | None":
        """Those of a bearing; None of grooves without an end."""
        grooves = bearing.inner, bearing.outer
        ends = np.array([groove.ends for groove in grooves]).T.reshape(2, 2, 1, 1)
        if np.isinf(ends).all():
            return None
        radius = [groove.conformity * bearing.ball.diameter for groove in grooves]
        spread = [each.across * np.cbrt(each.coefficient) for each in contacts]
        ratio = [each.across / each.along for each in contacts]
        return cls(
            np.minimum(ends, BEHIND), *(np.reshape(values, (2, 1, 1)) for values in (radius, spread, ratio))
        )

    def cuts(self, approach: NDArray, angles: NDArray) -> NDArray:
        """Cuts c (2, 2, C, Z) on both sides; hardly finite for contacts without an approach."""
        half = self.spread * np.sqrt(np.maximum(approach, NO_APPROACH))
        return self.radius * (self.ends - SIDES * angles) / half

    def beyond(self, approach: NDArray, angles: NDArray) -> NDArray:
        """Angles (2, C, Z) [rad] by which contacts that are pressed reach over shoulders, none where <= 0."""
        half = self.spread * np.sqrt(np.maximum(approach, 0.0)) / self.radius
        return np.where(approach > 0, half + SIDES * angles - self.ends, -np.inf).max(0)

    def withdrawn(self, angle: float) -> "EndingRaces":
        """Races that end further out by an angle [rad]."""
        return replace(self, ends=self.ends + angle)

    def forces(
        self, whole: tuple[NDArray, NDArray], approach: NDArray, angles: NDArray, lengths: NDArray
    ) -> CutContacts:
        """Forces of contacts that would have loads and stiffnesses as `whole`, at angles and lengths L."""
        (load, stiff), cut = whole, self.cuts(approach, angles)
        share = energy_share(cut, self.ratio)
        around = self.radius / (self.spread * np.sqrt(np.maximum(approach, NO_APPROACH)))  # -dc/d(alpha)
        bent = 0.8 * share.slope - 0.2 * cut * share.curvature  # slope of the share of the load
        energy, part = 0.4 * load * approach, 1 - (1 - share.load(cut)).sum(0)
        by_angle = -load * around * (SIDES * bent).sum(0)
        aside = -energy * around * (SIDES * share.slope).sum(0) / lengths
        return CutContacts(
            whole=load,
            loads=load * part,
            stiffness=stiff * part - stiff / 3 * (cut * bent).sum(0),
            by_angle=by_angle,
            aside=aside,
            aside_stiffness=(by_angle - aside) / lengths,
            aside_by_angle=energy * around**2 * share.curvature.sum(0) / lengths,
        )
