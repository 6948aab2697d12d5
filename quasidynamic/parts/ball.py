"""Balls and the grooves they run in."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, pi
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.material import Material, contact_modulus


@dataclass(frozen=True, kw_only=True)
class FrictionCurve:
    """Coulomb coefficients at some peak pressures, straight lines between them."""

    pressures: tuple[float, ...]  # [Pa] peak Hertz pressure, growing
    coefficients: tuple[float, ...]  # [-]

    def __post_init__(self):
        if not self.pressures or len(self.pressures) != len(self.coefficients):
            raise ImpossiblePart("friction: as many coefficients as pressures are needed, one at least")
        if not np.all(np.diff((0.0, *self.pressures)) > 0.0):
            raise ImpossiblePart(f"friction.pressures = {self.pressures} must be above zero and grow")
        if not all(0.0 < coefficient < float("inf") for coefficient in self.coefficients):
            raise ImpossiblePart(f"friction.coefficients = {self.coefficients} must be above zero")

    def at(self, pressure: NDArray) -> NDArray:
        """Coefficient [-] at a peak pressure [Pa]; outside the range that of its end, see `outside`."""
        return np.interp(pressure, self.pressures, self.coefficients)

    def outside(self, pressure: NDArray) -> NDArray:
        """Where a peak pressure [Pa] lies outside the measured range; nowhere for a single coefficient."""
        if len(self.pressures) == 1:
            return np.zeros(np.shape(pressure), bool)
        return (pressure < self.pressures[0]) | (pressure > self.pressures[-1])


def constant_friction(coefficient: float) -> FrictionCurve:
    """One coefficient [-] at any pressure."""
    return FrictionCurve(pressures=(1.0,), coefficients=(coefficient,))


@dataclass(frozen=True, kw_only=True)
class Ball:
    """A bearing ball."""

    diameter: float  # [m]
    material: Material

    def __post_init__(self):
        require_positive("ball.diameter", self.diameter)

    @property
    def mass(self) -> float:
        """Mass of the full ball [kg]."""
        return self.material.density * np.pi / 6 * self.diameter**3

    @property
    def inertia(self) -> float:
        """Moment of inertia about any diameter [kg m2]."""
        return self.mass * self.diameter**2 / 10


@dataclass(frozen=True, kw_only=True)
class Groove:
    """A raceway groove of circular section."""

    conformity: float  # [-] groove radius over ball diameter, above 0.5
    material: Material
    # [rad] contact angles at which it ends on the shoulder that the load presses, and on the other side
    ends: tuple[float, float] = (np.inf, np.inf)

    def __post_init__(self):
        if not min(self.ends) >= 0.0:
            raise ImpossiblePart(f"groove.ends = {self.ends} rad must be contact angles, >= 0")
        if not 0.5 < self.conformity < float("inf"):
            raise ImpossiblePart(
                f"groove.conformity = {self.conformity!r} must be above 0.5: the groove radius over the ball "
                "diameter. A figure such as 1.05 counts from the ball radius: halve it"
            )


@dataclass(frozen=True, kw_only=True)
class FourPointBearing:
    """Balls between two rings with gothic arches: every ball has two diagonals of two contacts each."""

    ball: Ball
    inner: Groove
    outer: Groove
    balls: int
    pitch_diameter: float  # [m] of the ball centres
    contact_angle: float  # [rad] of both diagonals, unloaded
    clearance: float = 0.0  # [m] of a ball along a diagonal, both contacts together; negative: interference
    groove_ends: tuple[float, float] = (np.inf, np.inf)  # [rad] contact angles of the inner, outer shoulders
    outer_arches: Literal[1, 2] = 2  # of the outer groove; one arc between the halves of a split inner ring
    first_ball_azimuth: float = 0.0  # [rad] from z towards y

    def __post_init__(self):
        require_positive("bearing.pitch_diameter", self.pitch_diameter)
        if not 0.0 < self.contact_angle < np.pi / 2:
            raise ImpossiblePart(f"bearing.contact_angle = {self.contact_angle!r} rad must be in (0, pi/2)")
        if self.balls < 3:
            raise ImpossiblePart(f"bearing.balls = {self.balls}: a ring needs at least 3")
        if self.ball.diameter >= self.pitch_diameter * np.sin(np.pi / self.balls):
            raise ImpossiblePart(f"{self.balls} balls do not fit on the pitch circle")
        if not abs(self.clearance) < self.centre_distance:
            raise ImpossiblePart(
                f"bearing.clearance = {1e6 * self.clearance:.4g} um: clearance or interference must be "
                f"below the distance of the groove centres, {1e6 * self.centre_distance:.3g} um"
            )

    @property
    def centre_distance(self) -> float:
        """Distance of opposite groove centres when both touch the ball, A = r_i + r_o - D [m]."""
        return (self.inner.conformity + self.outer.conformity - 1.0) * self.ball.diameter

    @property
    def end_play(self) -> float:
        """Axial way of the ring from balls that touch on one diagonal to the other [m].

        2 (sqrt(A^2 - r^2) - x), opposite centres being x and r apart before; zero with an interference.
        """
        apart = self.centre_distance - max(self.clearance, 0.0)
        x, r = apart * np.sin(self.contact_angle), apart * np.cos(self.contact_angle)
        return 2 * float(np.sqrt(self.centre_distance**2 - r**2) - x)

    @property
    def outer_offset(self) -> float:
        """Distance of the centres of the outer arches from the plane of the ball centres [m].

        Zero for one arc; else grooves share the distance of opposite centres as their reach.
        """
        if self.outer_arches == 1:
            return 0.0
        reach = (self.outer.conformity - 0.5) * self.ball.diameter
        apart = (self.centre_distance - self.clearance) * np.sin(self.contact_angle)
        return float(reach / self.centre_distance * apart)

    @property
    def groove_radii(self) -> NDArray:
        """Groove radii r_i and r_o (2) [m]."""
        return np.array([self.inner.conformity, self.outer.conformity]) * self.ball.diameter

    @property
    def moduli(self) -> NDArray:
        """E' of the ball with the inner and with the outer ring (2) [Pa]."""
        return np.array(
            [contact_modulus(self.ball.material, ring.material) for ring in (self.inner, self.outer)]
        )

    @cached_property
    def azimuths(self) -> NDArray:
        """Ball azimuths from z towards y (Z) [rad]."""
        return self.first_ball_azimuth + 2 * np.pi * np.arange(self.balls) / self.balls


@dataclass(frozen=True, kw_only=True)
class BallRow:
    """One row of balls with its nominal geometry."""

    balls: int
    ball_diameter: float  # [m]
    pitch_diameter: float  # [m] of the ball centres
    contact_angle: float  # [rad] nominal: without clearance and load
    inner_conformity: float  # [-] groove radius over ball diameter
    outer_conformity: float  # [-]

    def __post_init__(self):
        for name in ("balls", "ball_diameter", "pitch_diameter"):
            require_positive(f"ball row: {name}", getattr(self, name))
        if not 0.0 <= self.contact_angle < pi / 2:
            raise ImpossiblePart(f"ball row: contact_angle = {self.contact_angle!r} rad must be in [0, pi/2)")
        for name in ("inner_conformity", "outer_conformity"):
            if not getattr(self, name) > 0.5:
                raise ImpossiblePart(f"ball row: {name} = {getattr(self, name)!r} must be above 0.5")

    @property
    def diameter_ratio(self) -> float:
        """D cos(alpha) over the pitch diameter, gamma [-]."""
        return self.ball_diameter * cos(self.contact_angle) / self.pitch_diameter
