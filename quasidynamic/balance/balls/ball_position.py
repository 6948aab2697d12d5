"""Places at which a ball between two grooves rests without friction."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.point_contact import PointContact, in_series

Vectors = NDArray[np.complex128]  # axial + i radial

FURTHEST_ASIDE = 0.6  # of the smaller reach: bound of what a first guess moves a pressed ball aside
SMALLEST = 1e-200  # [N] stands for a load of zero where no force acts either
FLATTEST_WEDGE = 0.1  # [-] sine of the angle between the contacts in a first guess of their loads


@dataclass(frozen=True)
class BallPlaces:
    """Balls under a centrifugal force; places are complex numbers, axial + i radial, from the outer groove.

    Without friction there is one such place: the ball hangs from the two groove centres as on two
    elastic strings, pulled outwards.
    """

    inner_reach: float  # [m] from the inner groove centre to a ball that just touches
    outer_reach: float  # [m]
    inner: PointContact
    outer: PointContact
    centrifugal: NDArray  # (C, 1) [N]

    @cached_property
    def in_series(self) -> float:
        """Coefficient of both contacts in series [N/m^1.5]."""
        return float(in_series(self.inner, self.outer))

    @cached_property
    def bottom(self) -> Vectors:
        """Centres (C, 1) [m] of balls that lie at the bottom of the outer race."""
        return np.multiply(1j, self.outer_reach + self.outer.approach(self.centrifugal))

    def free(self, grooves: Vectors) -> NDArray:
        """Balls (C, Z) that stay at the bottom, in balance, where the inner race leaves them alone."""
        return (np.abs(groove_arm(grooves - self.bottom)) <= self.inner_reach) & (self.centrifugal > 0)

    def resting(self, grooves: Vectors) -> Vectors:
        """Ball centres (C, Z) [m] in balance but for the gyroscopic moment, nearly so where pressed hard.

        A ball lies on the outer race, is wedged between the races by the centrifugal force, or pressed near
        the line of the groove centres where that prevails.
        """
        apart = np.abs(groove_arm(grooves))
        approach = np.maximum(apart - self.inner_reach - self.outer_reach, 0.0)
        pressed = self.in_series * approach**1.5 >= self.centrifugal
        centres = self._pressed(grooves, apart)
        if not pressed.all():
            centres = np.where(pressed, centres, self._wedged(grooves, apart))
        return np.where(self.free(grooves), self.bottom, centres)

    def _pressed(self, grooves: Vectors, apart: NDArray) -> Vectors:
        """Centres near the line of the groove centres, the approach shared as equal loads ask.

        The centrifugal force moves a ball aside until its loads, like two taut strings, hold it.
        """
        touching = self.inner_reach + self.outer_reach
        gap = apart - touching
        soft = (self.inner.coefficient / self.outer.coefficient) ** (2 / 3)
        from_outer = (
            self.outer_reach + np.where(gap > 0, soft / (1 + soft), self.outer_reach / touching) * gap
        )
        along = grooves / apart
        load = self.in_series * np.maximum(gap, 0.0) ** 1.5
        held = np.maximum(load, self.centrifugal) * apart / (from_outer * (apart - from_outer))
        most = FURTHEST_ASIDE * min(self.inner_reach, self.outer_reach)
        aside = most * np.tanh(self.centrifugal * along.real / np.maximum(held * most, SMALLEST))
        return (from_outer + 1j * aside) * along

    def _wedged(self, grooves: Vectors, apart: NDArray) -> Vectors:
        """Centres where both races touch the ball and hold its centrifugal force without friction."""
        to_inner = np.full(apart.shape, self.inner_reach)
        to_outer = np.full(apart.shape, self.outer_reach)
        side = np.where(grooves.real < 0, -1.0, 1.0)
        length = np.abs(grooves)
        along = grooves / length
        for _ in range(2):  # touching, then pressed by the loads of that place
            foot = (length**2 + to_outer**2 - to_inner**2) / (2 * length)
            height = np.sqrt(np.maximum(to_outer**2 - foot**2, 0.0))
            centres = (foot + 1j * side * height) * along
            axial = grooves.real - side * to_inner
            on_wall = axial + 1j * np.sqrt(np.maximum(to_outer**2 - axial**2, 0.0))
            centres = np.where((grooves - centres).imag < 0, on_wall, centres)
            on_inner, on_outer = (
                arm / np.abs(arm) for arm in (groove_arm(grooves - centres), groove_arm(centres))
            )
            wedge = np.maximum(np.abs((on_inner.conj() * on_outer).imag), FLATTEST_WEDGE)
            force = self.centrifugal / wedge
            to_inner = self.inner_reach + self.inner.approach(force * np.abs(on_outer.real))
            to_outer = self.outer_reach + self.outer.approach(force * np.abs(on_inner.real))
        return centres


def groove_arm(arm: Vectors) -> Vectors:
    r"""Arm between the centre of a ball and that of a groove, or its nearest point of the mid-plane.

    .. math:: a = x + i \max(y, 0)

    A groove is half a circle, to contact angles of plus and minus a right angle, that goes on as two straight
    walls: the shoulders, without an end. Without them a ball would be pressed towards the shaft by a groove
    that closes above it.

    x + i y is the arm, axial and radial, from the ball to the inner groove or from the outer groove to the
    ball [m]. The size of a [m] is the distance, convex in the places, its direction the normal.

    Source
    ------
    Geometry.

    Valid
    -----
    A real shoulder ends at some contact angle below a right angle; nothing here sees it.
    """
    return arm.real + 1j * np.maximum(arm.imag, 0.0)


def turning(arm: Vectors) -> NDArray:
    """Whether a normal turns as the ball moves (...): on the half circle, not on the walls."""
    return arm.imag > 0
