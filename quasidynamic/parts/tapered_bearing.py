"""A tapered roller bearing: conical rollers between cup and cone, and the rib that holds them."""

from dataclasses import dataclass
from functools import cached_property
from math import asin, cos, pi, sin, sqrt, tan
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.material import Material, contact_modulus
from quasidynamic.parts.profile import STRAIGHT, Hollow, Profile, Straight
from quasidynamic.parts.roller_bearing import Roller

MOST_TAPER = 0.2  # [rad] half angle of a roller, for which it may count as a cylinder in its inertia; assumed


@dataclass(frozen=True, kw_only=True)
class Rib:
    """The rib of the cone that the large ends of the rollers rest on: a contact with load ~ approach^1.5.

    Without stiffness there is none, see `without_rib`.
    """

    angle: float  # [rad] alpha_f of its normal from the axis
    stiffness: float  # [N/m^1.5]
    lever: float  # [m] of the contact force about the roller's centre, that lifts the large end
    depth: float  # [m] of the contact below the roller's axis
    curvature: float = 0.0  # [1/m] of the roller's end; 0 of a flat one, whose pressure is not known

    def __post_init__(self):
        if self.stiffness < 0:
            raise ImpossiblePart(f"rib.stiffness = {self.stiffness}: it must not be negative")


def without_rib(axis_angle: float) -> Rib:
    """No rib: cage, or rings that touch no end with a load, hold the rollers along their axes, beta [rad].

    Returns
    -------
    Rib
        without stiffness, its normal along the roller's axis

    Source
    ------
    Geometry; what inertia presses along the axes of the rollers is in balance with that which holds them.
    """
    return Rib(angle=axis_angle, stiffness=0.0, lever=0.0, depth=0.0)


def spherical_rib(roller: Roller, axis_angle: float, angle: float, radius: float, ring: Material) -> Rib:
    r"""Rib that a spherical roller end touches.

    .. math:: K_f = \tfrac43 E^* \sqrt{R_s},\quad b = R_s \sin(\beta - \alpha_f),\quad
              h = (R_s - L/2) \sin(\beta - \alpha_f)

    with E* = 1/(1/E_1' + 1/E_2'), E' = E/(1 - nu^2), of a sphere on a flat face.

    Parameters
    ----------
    roller : Roller
        its length L [m] and material
    axis_angle : float
        beta of the roller's axis from that of the bearing [rad]
    angle : float
        alpha_f, normal of the rib from the axis of the bearing [rad]
    radius : float
        R_s of the roller's end [m], its centre on the roller's axis
    ring : Material
        of the ring with the rib

    Returns
    -------
    Rib
        with the depth b and the lever h

    Raises
    ------
    ImpossiblePart
        for a contact that is not on the roller's end

    Source
    ------
    Geometry; Johnson, Contact Mechanics (1985), sec. 4.2, for the sphere.

    Valid
    -----
    Contact ellipse small against end and rib.
    """
    depth = radius * sin(axis_angle - angle)
    if not abs(depth) < roller.diameter / 2:
        raise ImpossiblePart(
            f"rib contact {1e3 * depth:.4g} mm below the roller's axis: it must be within the end of the "
            f"roller, {1e3 * roller.diameter / 2:.4g} mm; bring rib angle and axis of the roller together, "
            "or make the radius of the roller's end smaller"
        )
    modulus = contact_modulus(roller.material, ring) / 2
    return Rib(
        angle=angle,
        stiffness=4 / 3 * modulus * sqrt(radius),
        lever=(radius - roller.length / 2) * sin(axis_angle - angle),
        depth=depth,
        curvature=1 / radius,
    )


def axial_approach(clearance_change: float, cup_angle: float) -> float:
    r"""Axial distance by which cone and cup come closer where rings and rollers grow.

    .. math:: \Delta a = -\frac{\Delta G}{2 \tan\alpha_o}

    Parameters
    ----------
    clearance_change : float
        Delta G [m], change of the clearance on the diameter in the plane of the roller centres; negative
        where the raceways come closer
    cup_angle : float
        alpha_o [rad] of the outer raceway from the axis

    Returns
    -------
    float
        Delta a [m]

    Source
    ------
    Geometry, derived here: a cone that grows with its rib moves with the rollers along the cup, out of it.

    Valid
    -----
    Growth that is even along the raceways, small against their radii.
    """
    return -clearance_change / (2 * tan(cup_angle))


def apex_angles(cup_angle: float, ratio: float) -> tuple[float, float]:
    r"""Angles of the roller's axis and of the cone where all apexes meet on the axis of the bearing.

    .. math:: \alpha_o = \beta + \varepsilon,\quad \alpha_i = \beta - \varepsilon,\quad
              \sin 2\varepsilon = 2 (D/d_m) \sin\beta

    Parameters
    ----------
    cup_angle : float
        alpha_o [rad]
    ratio : float
        D/d_m, roller at mid-contact over pitch diameter [-]

    Returns
    -------
    tuple of float
        beta and alpha_i [rad]

    Source
    ------
    Geometry: only then rollers roll on both raceways along their whole length.
    """
    axis = cup_angle
    for _ in range(60):  # a contraction by some 2 D/d_m
        axis = cup_angle - asin(2 * ratio * sin(axis)) / 2
    return axis, 2 * axis - cup_angle


@dataclass(frozen=True, kw_only=True)
class TaperedRollerBearing:
    """Conical rollers between cup and cone; cylindrical ones at angle zero, between washers at 90 degrees."""

    rollers: int  # of one row
    pitch_diameter: float  # [m] of the roller centres, where the normals of mid-contact meet the axes
    cup_angle: float  # [rad] alpha_o of the outer raceway
    cone_angle: float  # [rad] alpha_i of the inner raceway
    roller: Roller  # diameter at mid-contact, length along the contact
    rib: Rib
    inner_ring: Material
    outer_ring: Material
    side: Literal[1, -1] = 1  # of the axial force on the inner ring that rows which are not mirrored carry
    clearance: float = 0.0  # [m] diametral, with the rollers on the rib where the inner ring is at x = 0
    contact_law: Literal["palmgren", "iso16281"] = "palmgren"
    first_roller_azimuth: float = 0.0  # [rad]
    inner_profile: Profile = STRAIGHT
    outer_profile: Profile = STRAIGHT
    rows: tuple[RowPlace, ...] = (RowPlace(),)  # of the same rollers between rings in common

    def __post_init__(self):
        require_positive("bearing.pitch_diameter", self.pitch_diameter)
        if self.rollers < 3:
            raise ImpossiblePart(f"bearing.rollers = {self.rollers}: a ring needs at least 3")
        on_circle = self.all_rollers if self.crossed else self.rollers
        if on_circle * self.roller.diameter >= pi * self.pitch_diameter:
            raise ImpossiblePart(f"{on_circle} rollers do not fit on the pitch circle")
        if not 0.0 <= self.cone_angle <= self.cup_angle <= pi / 2:
            raise ImpossiblePart(
                f"angle of the cup {np.degrees(self.cup_angle):.4g} deg and of the cone "
                f"{np.degrees(self.cone_angle):.4g} deg: they must be 0 <= cone <= cup <= 90 deg"
            )
        if self.taper > MOST_TAPER:
            raise ImpossiblePart(
                f"half angle of the rollers {np.degrees(self.taper):.4g} deg: at most "
                f"{np.degrees(MOST_TAPER):.4g} deg"
            )
        if not -pi / 2 < self.rib.angle <= pi / 2:
            raise ImpossiblePart(f"rib.angle = {np.degrees(self.rib.angle):.4g} deg must be within 90 deg")

    @cached_property
    def axis_angle(self) -> float:
        """Angle beta of the rollers' axes [rad]."""
        return (self.cup_angle + self.cone_angle) / 2

    @property
    def along(self) -> float:
        """Cosine of the angle of the rollers' axes [-]."""
        return cos(self.axis_angle)

    @property
    def up(self) -> float:
        """Sine of that angle [-]."""
        return sin(self.axis_angle)

    @cached_property
    def taper(self) -> float:
        """Half angle epsilon of the rollers [rad]."""
        return (self.cup_angle - self.cone_angle) / 2

    @cached_property
    def diameter_ratio(self) -> float:
        """Gamma of the ratings, D cos(alpha_o)/d_m [-]."""
        return self.roller.diameter * cos(self.cup_angle) / self.pitch_diameter

    @cached_property
    def inner_radius(self) -> float:
        """Radius of the inner raceway at mid-contact in the kinematics [m]."""
        return (self.pitch_diameter - self.roller.diameter * cos(self.cone_angle)) / 2

    @cached_property
    def outer_radius(self) -> float:
        """Radius of the outer raceway at mid-contact in the kinematics [m]."""
        return (self.pitch_diameter + self.roller.diameter * cos(self.cup_angle)) / 2

    @cached_property
    def rib_radius(self) -> float:
        """Distance of the rib contact from the axis of the bearing [m]."""
        return self.pitch_diameter / 2 + self.roller.length / 2 * self.up - self.rib.depth * self.along

    @cached_property
    def azimuths(self) -> NDArray:
        """Azimuths of all rollers from z towards y (Z) [rad], row by row."""
        of_row = self.first_roller_azimuth + 2 * np.pi * np.arange(self.rollers) / self.rollers
        beside = 2 * np.pi / self.all_rollers if self.crossed else 0.0
        return np.concatenate([of_row + number * beside for number in range(len(self.rows))])

    @property
    def crossed(self) -> bool:
        """Whether the rollers of all rows alternate on one circle."""
        return len(self.rows) > len({row.axial for row in self.rows})

    @property
    def all_rollers(self) -> int:
        """Number of the rollers of all rows."""
        return self.rollers * len(self.rows)

    @property
    def sides(self) -> tuple[int, ...]:
        """Sign of the axial force on the inner ring that each row carries."""
        return tuple(-self.side if row.mirrored else self.side for row in self.rows)

    @property
    def opposed(self) -> bool:
        """Whether rows press each other along the axis."""
        return len(set(self.sides)) > 1

    @property
    def relieved(self) -> bool:
        """Whether roller or raceway has a profile at both contacts."""
        raceways = (self.inner_profile, self.outer_profile)
        return not isinstance(self.roller.profile, Straight) or not any(
            isinstance(each, Straight) for each in raceways
        )

    @property
    def hollows(self) -> tuple[float, float]:
        """Curvature of the generatrix of hollow raceways, inner and outer [1/m]; 0 of any other."""
        inner, outer = (
            1 / profile.radius if isinstance(profile, Hollow) else 0.0
            for profile in (self.inner_profile, self.outer_profile)
        )
        return inner, outer

    def drop(self, race: int, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop of roller and raceway together [m], see `CylindricalRollerBearing.drop`.

        Source
        ------
        Geometry: both gaps add up.
        """
        raceway = (self.inner_profile, self.outer_profile)[race]
        return self.roller.profile.drop(position, length) + raceway.drop(position, length)
