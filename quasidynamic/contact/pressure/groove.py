"""A ball pressed into a circular groove, on their true arcs."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid, ElasticPair, grid_over
from quasidynamic.contact.pressure.normal_contact import (
    NormalCompliance,
    NormalContact,
    RigidMotions,
    contact_pressure,
)
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange, require_positive

Approach = Literal["offset", "translation"]  # even along all normals, or of the ring as a rigid body

SEARCHED = (32, 64)  # cells on which the patch is sought
WIDER = 1.3  # than the ellipse of Hertz: where it is sought first, and then by as much again
WIDEST = 6  # times


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


@dataclass(frozen=True)
class PressedGroove:
    """A groove that is pressed against a ball."""

    groove: BallInGroove
    contact: NormalContact  # y towards the shoulder

    def on(self, cells: tuple[int, int]) -> tuple[CellGrid, NDArray]:
        """Grid of fewer cells along and across the rolling direction, with their mean pressure [Pa].

        The numbers of cells must divide those of the contact.
        """
        merged = tuple(have // want for have, want in zip(self.contact.grid.shape, cells, strict=True))
        spacing = tuple(side * many for side, many in zip(self.contact.grid.spacing, merged, strict=True))
        pressure = self.contact.pressure.reshape(cells[0], merged[0], cells[1], merged[1]).mean((1, 3))
        return CellGrid((spacing[0], spacing[1]), cells), pressure


@dataclass(frozen=True)
class GroovePress:
    r"""A force that presses a groove against a ball.

    .. math:: g = h - \delta\, s + A p \ge 0,\quad \int p \cos\psi\, dA = Q,\quad
              s = 1\ \text{(offset)},\quad s = \cos\psi\ \text{(translation)}

    Both surfaces come closer by as much everywhere, as an interference in finite elements is applied
    (offset); or as the rigid ring comes closer, less towards the ends of the arc (translation). Q is the part
    of the pressure along the contact normal, that which balances the load of the bearing.

    Source
    ------
    Signorini's conditions of contact on half-spaces (Johnson, Contact Mechanics, 1985, sec. 5.9), the arcs
    developed along their length; derived here.

    Valid
    -----
    Patches up to half of the ball; arcs deform as half-spaces, also at their ends and at shoulders.
    """

    groove: BallInGroove
    pair: ElasticPair  # [1/Pa]
    force: float  # [N] Q, > 0
    approach: Approach

    def pressed(self, semi_axes: tuple[float, float], cells: tuple[int, int]) -> PressedGroove:
        """Pressure on cells along and across the rolling direction, over a rectangle that holds the patch.

        It is sought near the ellipse of Hertz, of semi-axes along and across [m].

        Raises `OutOfRange` for a patch around half of the ball; `NotSolved` where no patch is found, see
        `contact_pressure`.
        """
        along, across = (WIDER * each for each in semi_axes)
        for _ in range(WIDEST):
            if across > np.pi / 2 * self.groove.section_radius:
                raise OutOfRange(
                    f"ball in a groove: {self.force:.4g} N press a patch around half of the ball; the load "
                    "is far too high, or the groove too narrow"
                )
            contact = self._on(grid_over((along, across), SEARCHED))
            wider = [WIDER if any(ends) else 1.0 for ends in contact.cut]
            if wider == [1.0, 1.0]:
                return PressedGroove(self.groove, self._on(grid_over(_held_by(contact), cells)))
            along, across = along * wider[0], across * wider[1]
        raise NotSolved(
            f"ball in a groove: the patch remains wider than a grid of {along:.3g} by {across:.3g} m"
        )

    def _on(self, grid: CellGrid) -> NormalContact:
        x, y = grid.centres
        along_normal = np.broadcast_to(self.groove.approach(y), grid.shape)[None]
        shape = np.ones_like(along_normal) if self.approach == "offset" else along_normal
        motions = RigidMotions(shape, np.array([self.force]), along_normal)
        return contact_pressure(NormalCompliance.of(self.pair, grid), self.groove.gap(x, y), motions)


def _held_by(contact: NormalContact) -> tuple[float, float]:
    """Half lengths of a rectangle [m], half a cell wider than the cells in contact."""
    (x, y), (wide, long), touching = contact.grid.centres, contact.grid.spacing, contact.touching
    along, across = np.abs(x[touching.any(1)]).max(), np.abs(y[:, touching.any(0)]).max()
    return float(along + wide), float(across + long)
