"""Elliptic contacts of balls with the laws of lubricated line contacts, strip by strip."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.general_sliding import (
    FINE,
    EllipsePoints,
    GeneralSliding,
    SlipFriction,
    sliding_ellipse as sliding,
)
from quasidynamic.contact.ellipse.point_contact import PointContact
from quasidynamic.contact.ellipse.rigid_slip import CENTRE
from quasidynamic.contact.film import Film, FilmLaw
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.contact.traction import RollingShear

LEAST_PART = 1e-12  # of the load of the middle strip: strips at the rim of an ellipse have one
LEAST_SLIP = 1e-100  # [m/s] where the coefficient of friction of no slip is taken


class LubricatedSliding(NamedTuple):
    """Traction of contacts, and the film that makes it."""

    sliding: GeneralSliding
    film: Film  # (N, 2); its derivative by load is not that of a changing inlet


@dataclass(frozen=True, kw_only=True)
class LubricatedRaces:
    r"""Contacts of balls with the inner and with the outer race, cut into strips along the rolling direction.

    .. math:: q(x) = \frac{3 Q}{4 a}\left(1 - \frac{x^2}{a^2}\right),\quad
              R_s = \frac{E' b}{4 p_0},\qquad
              \tau(x, y) = \frac{F(q(x), |v|, u, h)}{q(x)}\, p(x, y)

    A strip of a Hertz ellipse has the half-width and the mean pressure of a line contact of load q and radius
    R_s, the same for all strips and loads. So the traction laws F of line contacts hold for it: their
    coefficient of friction at the slip of each point, of the pressure there. Film and entrainment speed are
    those of the middle.

    The shear of the inlet is that of the ellipse, or by a law of lines that of a line contact of length 2 a
    and radius R along the rolling direction.

    Source
    ------
    Johnson, Contact Mechanics (1985), secs 4.1 and 4.2, for both pressures; strips derived here.

    Valid
    -----
    Ellipses that are wide across the rolling direction: no oil flows from strip to strip but for the factor
    of the film.
    """

    lubrication: BallLubrication
    contacts: tuple[PointContact, PointContact]
    radius: NDArray  # (2) [m] R along the rolling direction
    modulus: NDArray  # (2) [Pa] E'

    @cached_property
    def strip_radius(self) -> NDArray:
        """R_s of inner and outer contact (2) [m]."""
        across, along = (
            np.array([float(getattr(contact, name)) for contact in self.contacts])
            for name in ("across", "along")
        )
        return np.pi / 6 * self.modulus * across * along**2

    @cached_property
    def axis_ratio(self) -> NDArray:
        """a/b of inner and outer contact (2) [-]."""
        return np.array([float(contact.across / contact.along) for contact in self.contacts])

    @cached_property
    def _film_law(self) -> FilmLaw:
        return FilmLaw(
            formula=self.lubrication.film.of_axes(self.axis_ratio),
            radius=self.radius,
            modulus=self.modulus,
            oil=self.lubrication.oil,
            inlet_heating=self.lubrication.inlet_heating,
        )

    def film(self, load: NDArray, along: NDArray, sliding: NDArray, entrainment: NDArray) -> Film:
        """Film of loads (N, 2) [N], semi-axes along the rolling (N, 2) [m], at speeds (N, 2) [m/s]."""
        flooded = self._film_law(load / self.radius, sliding, entrainment)
        length = self.lubrication.inlet_length
        if length is None:
            return flooded
        return self.lubrication.film.starved_film(flooded, along, self.radius, length)

    def rolling(self, load: NDArray, across: NDArray, entrainment: NDArray) -> RollingShear:
        """Shear of the inlets at loads (N, 2) [N], semi-axes across (N, 2) [m] and speeds (N, 2) [m/s]."""
        beta = 4 / np.pi * self.strip_radius / self.radius
        geometry = (self.radius, self.modulus, 2 * across, 1 / self.axis_ratio, beta)
        return self.lubrication.rolling(load, entrainment, geometry, self.lubrication.oil)

    def traction(
        self,
        slip: NDArray,
        ellipse: Ellipse,
        speed: NDArray,
        entrainment: NDArray,
        points: EllipsePoints = FINE,
    ) -> LubricatedSliding:
        """Traction by slip (N, 2, 5) over speeds (N) [rad/s], at mean surface speeds (N, 2) [m/s].

        `ellipse` (N, 2) has the load in place of its friction. Slip is in m and without dimension, friction
        in N and N m; derivatives by entrainment [N s/m] and film [N/m].
        """
        load, scale = ellipse.traction, speed[:, None]
        film = self.film(load, ellipse.along, scale * slip[..., CENTRE], entrainment)
        strip = self.lubrication.traction(
            radius=self.strip_radius[:, None, None],
            modulus=self.modulus[:, None, None],
            length=2 * ellipse.width[..., None, None],
            oil=self.lubrication.oil,
        )
        middle = (0.75 * load / ellipse.width)[..., None]
        each, at_speed, at_film = (
            scale[..., None, None],
            entrainment[..., None, None],
            film.thickness[..., None, None],
        )

        def law(part: NDArray, size: NDArray) -> SlipFriction:
            """Coefficient of the strips at the slip of their points."""
            q = (middle * np.maximum(part, LEAST_PART))[..., None]
            found = strip(q, np.maximum(each * size, LEAST_SLIP), at_speed, at_film)
            return SlipFriction(
                found.force / q, each * found.by_sliding / q, found.by_entrainment / q, found.by_film / q
            )

        return LubricatedSliding(sliding(slip, ellipse, points, law), film)
