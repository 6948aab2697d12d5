"""An angular-contact ball bearing put together."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.ball import Ball, Groove


@dataclass(frozen=True, kw_only=True)
class RowPlace:
    """Where a row of balls is on common rings."""

    axial: float = 0.0  # [m] of the plane of its inner groove centres, along x
    mirrored: bool = False  # its inner ring pushes the balls against their shoulders along -x
    closer: float = 0.0  # [m] axial, of its grooves to each other: preload; negative is play


def azimuths_of_row(first: float, balls: int) -> NDArray:
    """Ball azimuths of a row from z towards y (Z) [rad], from the azimuth of the first ball [rad]."""
    return first + 2 * np.pi * np.arange(balls) / balls


@dataclass(frozen=True, kw_only=True)
class AngularContactBearing:
    """Rows of balls between two rings, each with one groove for a row.

    A deep groove bearing has the contact angle zero, and a clearance. Z counts the balls of all rows, one row
    after the other; rows are equal, but that a mirrored one is seen with x reversed.
    """

    ball: Ball
    inner: Groove
    outer: Groove
    balls: int  # of a row
    pitch_diameter: float  # [m] of the ball centres
    contact_angle: float  # [rad] without load, from the radial plane, the clearance below left out
    clearance: float = 0.0  # [m] of the diameter beyond that of contact_angle; negative is an interference
    first_ball_azimuth: float = 0.0  # [rad] from z towards y
    approaches: tuple[float, ...] = ()  # (Z) [m] by how much raceways are closer to each ball than round ones
    rows: tuple[RowPlace, ...] = (RowPlace(),)

    def __post_init__(self):
        require_positive("bearing.pitch_diameter", self.pitch_diameter)
        if not 0.0 <= self.contact_angle < np.pi / 2:
            raise ImpossiblePart(f"bearing.contact_angle = {self.contact_angle!r} rad must be in [0, pi/2)")
        if self.balls < 3:
            raise ImpossiblePart(f"bearing.balls = {self.balls}: a ring needs at least 3")
        if self.ball.diameter >= self.pitch_diameter * np.sin(np.pi / self.balls):
            raise ImpossiblePart(f"{self.balls} balls do not fit on the pitch circle")
        all_balls = self.balls * len(self.rows)
        if len(self.approaches) not in (0, all_balls) or not np.isfinite(self.approaches).all():
            raise ImpossiblePart(f"approaches = {self.approaches} must be {all_balls} finite numbers")
        most = 2 * self.centre_distance * np.cos(self.contact_angle)
        if not abs(self.clearance) < most:
            raise ImpossiblePart(
                f"bearing.clearance = {self.clearance!r} m: its size must be below {most:.3g} m, at which "
                "balls pass the grooves; is the unit right?"
            )

    @property
    def diameter_ratio(self) -> float:
        """Ball over pitch diameter, gamma' [-]."""
        return self.ball.diameter / self.pitch_diameter

    @property
    def inner_reach(self) -> float:
        """From the inner groove centre to a ball centre that just touches, (f_i - 1/2) D [m]."""
        return (self.inner.conformity - 0.5) * self.ball.diameter

    @property
    def outer_reach(self) -> float:
        """From the outer groove centre to a ball centre that just touches, (f_o - 1/2) D [m]."""
        return (self.outer.conformity - 0.5) * self.ball.diameter

    @property
    def centre_distance(self) -> float:
        """Distance of the groove centres when both races just touch the ball, A = (f_i + f_o - 1) D [m]."""
        return self.inner_reach + self.outer_reach

    @property
    def groove_offset(self) -> tuple[float, float]:
        """Inner groove centre from the outer one, the ring not displaced: axial, radial [m].

        A sin(alpha) and A cos(alpha) - P_d/2: the place where balls just touch, but for the clearance.
        """
        angle, distance = self.contact_angle, self.centre_distance
        return distance * np.sin(angle), distance * np.cos(angle) - self.clearance / 2

    @property
    def radial_clearance(self) -> float:
        """P_d of the diameter, that of the contact angle included [m]; negative is an interference."""
        return 2 * (self.centre_distance - self.groove_offset[1])

    @property
    def free_contact_angle(self) -> float:
        """Contact angle at which balls just touch under an axial load, cos = cos(alpha) - P_d/(2 A) [rad].

        Zero where an interference presses balls anyway.
        """
        return float(np.arccos(min(self.groove_offset[1] / self.centre_distance, 1.0)))

    @property
    def touching_place(self) -> float:
        """Axial displacement at which all balls have the free contact angle [m]; half the end play."""
        return self.centre_distance * np.sin(self.free_contact_angle) - self.groove_offset[0]

    @property
    def end_play(self) -> float | None:
        """Axial way of the ring from balls that touch on one side to the other, 2 A sin(alpha_0) [m].

        Of rows against each other what they lack to touch both. Zero with an interference; none where
        shoulders are on one side, as of one row with a contact angle.
        """
        if len({row.mirrored for row in self.rows}) == 2:
            towards, back = (
                self.touching_place - max(row.closer for row in self.rows if row.mirrored is mirrored)
                for mirrored in (False, True)
            )
            return max(towards + back, 0.0)
        return None if self.contact_angle > 0 else 2 * float(self.touching_place)

    @property
    def inner_groove_radius(self) -> float:
        """From the shaft axis to the inner groove centre, R_i = d_m/2 + (f_i - 1/2) D cos(alpha) [m]."""
        return self.pitch_diameter / 2 + self.inner_reach * np.cos(self.contact_angle)

    @cached_property
    def azimuths(self) -> NDArray:
        """Ball azimuths from z towards y (Z) [rad]."""
        return np.tile(azimuths_of_row(self.first_ball_azimuth, self.balls), len(self.rows))

    @cached_property
    def ball_rows(self) -> NDArray:
        """Number of the row of each ball, from 0 (Z)."""
        return np.repeat(np.arange(len(self.rows)), self.balls)

    @cached_property
    def along_x(self) -> NDArray:
        """Direction of x over that towards the shoulders of its row, for each ball: 1, mirrored -1 (Z)."""
        return np.where(self.of_balls("mirrored"), -1.0, 1.0)

    def of_balls(self, name: str) -> NDArray:
        """A value of `RowPlace` for each ball (Z)."""
        return np.array([getattr(row, name) for row in self.rows])[self.ball_rows]


@dataclass(frozen=True, kw_only=True)
class RingOperation:
    """What is asked of the inner ring: a load or a displacement in each of five directions, a speed.

    Directions are x (axial, pushes the balls against their shoulders), y and z (radial), then the
    right-handed rotations about y and z. Speeds are positive towards growing azimuth.
    """

    load: tuple[float, float, float, float, float] = (0.0, 0.0, 0.0, 0.0, 0.0)  # [N, N, N, N m, N m]
    displacement: tuple[float | None, ...] = (None,) * 5  # [m, m, m, rad, rad] None: the ring is free
    inner_speed: float = 0.0  # [rad/s]
    outer_speed: float = 0.0  # [rad/s]

    def __post_init__(self):
        if len(self.load) != 5 or len(self.displacement) != 5:
            raise ImpossiblePart("load and displacement have five entries each: x, y, z, about y, about z")
        prescribed = [value for value in self.displacement if value is not None]
        if not np.all(np.isfinite([*self.load, *prescribed, self.inner_speed, self.outer_speed])):
            raise ImpossiblePart("loads, displacements and speeds must be finite")
        for name, load, place in zip(
            ["x", "y", "z", "tilt_y", "tilt_z"], self.load, self.displacement, strict=True
        ):
            if load and place is not None:
                raise ImpossiblePart(
                    f"direction {name} has both a load of {load} and a displacement of {place}"
                )

    @property
    def relative_speed(self) -> float:
        """Speed of the inner ring against the outer ring [rad/s]."""
        return self.inner_speed - self.outer_speed
