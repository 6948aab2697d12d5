"""A cylindrical roller bearing: rollers, cage, flange, raceways, and how it is driven and loaded."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import pi
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.columns import joined
from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import STRAIGHT, PointsProfile, Profile, Straight
from quasidynamic.parts.raceway_waves import RacewayWaves

SLENDEREST = 50  # length over diameter of a roller, or diameter over length
UNLIKE = 1e-3  # [-] most deviation of a diameter: masses and contacts are those of the nominal (assumed)
GRAVITY = 9.81  # [m/s2]


@dataclass(frozen=True, kw_only=True)
class Flange:
    """Flanges at both ends of the rollers, on one ring: flat, square to the axis, alike."""

    ring: Literal["inner", "outer"]
    clearance: float  # [m] axial, of a straight roller, both ends together
    height: float  # [m] above the raceway
    roller_chamfer: float  # [m] radial, of the roller's end
    stiffness: float  # [N/m] of a roller's corner against a flange
    friction: float  # [-] Coulomb, of the roller's corner on the flange

    def __post_init__(self):
        for name in ("clearance", "height", "stiffness"):
            require_positive(f"flange.{name}", getattr(self, name))
        for name in ("roller_chamfer", "friction"):
            if not 0.0 <= getattr(self, name) < float("inf"):
                raise ImpossiblePart(f"flange.{name} = {getattr(self, name)!r} must be finite and >= 0")
        if self.height <= self.roller_chamfer:
            raise ImpossiblePart(
                f"flange.height = {1e3 * self.height:.4g} mm must be above the chamfer of the roller, "
                f"{1e3 * self.roller_chamfer:.4g} mm, or the end of the roller touches nothing"
            )


@dataclass(frozen=True, kw_only=True)
class Ribs:
    """A rib of each ring, at opposite ends of the rollers, and the ends that thrust presses on them."""

    inner_height: float  # [m] of the contact on the rib of the inner ring, above its raceway
    outer_height: float  # [m] the same of the outer ring
    end_radius: float  # [m] of a sphere on a flat, curved as end and rib together
    friction: float  # [-] Coulomb, of the ends on the ribs

    def __post_init__(self):
        for name in ("inner_height", "outer_height", "end_radius"):
            require_positive(f"ribs.{name}", getattr(self, name))
        if not 0.0 <= self.friction < float("inf"):
            raise ImpossiblePart(f"ribs.friction = {self.friction!r} must be finite and >= 0")


@dataclass(frozen=True, kw_only=True)
class Cage:
    """A cage that spaces the rollers and is guided by the land of a ring or by the rollers."""

    guidance: Literal["outer", "inner", "rollers"]
    pocket_friction: float  # [-] Coulomb coefficient between roller and pocket
    thickness: float  # [m] radial; the part of a roller that it shields from the oil-air mixture
    mass: float = 0.0  # [kg] above zero where the centre is free; else only its inertia in settling
    land_diameter: float = 0.0  # [m] unused when the rollers guide
    land_width: float = 0.0  # [m] total over both lands
    land_clearance: float = 0.0  # [m] diametral
    land_flow: Literal["laminar", "vortices"] = "laminar"  # of the oil that fills the land
    free: bool = False  # whether the cage finds its centre in the land by itself
    unbalance: float = 0.0  # [m] distance of the mass centre from the cage's axis
    unbalance_azimuth: float = 0.0  # [rad] where the mass centre is at this moment
    pocket_clearance: float | None = None  # [m] from a centred roller to either wall

    def __post_init__(self):
        if self.pocket_friction < 0 or self.thickness < 0:
            raise ImpossiblePart("cage.pocket_friction and cage.thickness must not be negative")
        if self.mass < 0 or self.unbalance < 0:
            raise ImpossiblePart("cage.mass and cage.unbalance must not be negative")
        if self.pocket_clearance is not None:
            require_positive("cage.pocket_clearance", self.pocket_clearance)
        if self.free and self.guidance == "rollers":
            raise ImpossiblePart("a cage with a free centre needs a land that carries it")
        if self.free:
            require_positive("cage.mass", self.mass)
        if self.guidance != "rollers":
            for name in ("land_diameter", "land_width", "land_clearance"):
                require_positive(f"cage.{name}", getattr(self, name))


FREE_POCKETS = Cage(guidance="rollers", pocket_friction=0.0, thickness=0.0)


@dataclass(frozen=True, kw_only=True)
class Roller:
    """A cylindrical roller."""

    diameter: float  # [m]
    length: float  # [m] effective, without end chamfers
    material: Material
    profile: Profile = STRAIGHT

    def __post_init__(self):
        for name in ("diameter", "length"):
            require_positive(f"roller.{name}", getattr(self, name))
        if not 1 / SLENDEREST <= self.length / self.diameter <= SLENDEREST:
            raise ImpossiblePart(
                f"roller.length = {1e3 * self.length:.6g} mm with roller.diameter = "
                f"{1e3 * self.diameter:.6g} mm: "
                f"neither a roller nor a needle; allowed is a length of 1/{SLENDEREST} to {SLENDEREST} "
                "diameters"
            )

    @cached_property
    def mass(self) -> float:
        """Mass of the full cylinder [kg]."""
        return self.material.density * pi / 4 * self.diameter**2 * self.length

    @cached_property
    def inertia(self) -> float:
        """Moment of inertia about the roller's own axis [kg m2]."""
        return self.mass * self.diameter**2 / 8


@dataclass(frozen=True, kw_only=True)
class RollerRow:
    """Where a row of rollers is on common rings, and what it has of its own."""

    axial: float = 0.0  # [m] of mid-roller, along x
    clearance: float = 0.0  # [m] diametral, beyond that of the bearing
    azimuth: float = 0.0  # [rad] of its first roller, beyond that of the bearing


ONE_ROW = (RollerRow(),)


@dataclass(frozen=True, kw_only=True)
class CylindricalRollerBearing:
    """Rows of rollers between two rings, all spaced by one cage.

    Z counts the rollers of all rows, one row after the other.
    """

    rollers: int  # of a row
    outer_raceway_diameter: float  # [m]
    clearance: float  # [m] operating, diametral; negative is a preload
    roller: Roller
    cage: Cage
    inner_ring: Material
    outer_ring: Material
    contact_law: Literal["palmgren", "iso16281"] = "palmgren"
    first_roller_azimuth: float = 0.0  # [rad] from the load line
    inner_waves: RacewayWaves | None = None  # form errors; None: round
    outer_waves: RacewayWaves | None = None
    roller_deviations: tuple[
        float, ...
    ] = ()  # (Z) [m] of each roller's diameter from the nominal one; empty: none
    inner_profile: Profile = STRAIGHT  # of the raceways along the rollers
    outer_profile: Profile = STRAIGHT
    rows: tuple[RollerRow, ...] = ONE_ROW
    ribs: Ribs | None = None

    def __post_init__(self):
        require_positive("bearing.outer_raceway_diameter", self.outer_raceway_diameter)
        if self.rollers < 3:
            raise ImpossiblePart(f"bearing.rollers = {self.rollers}: a ring needs at least 3")
        if self.rollers * self.roller.diameter >= np.pi * self.pitch_diameter:
            raise ImpossiblePart(f"{self.rollers} rollers do not fit on the pitch circle")
        self._require_rows_apart()
        self._require_like_rollers()
        if self.ribs is not None and self.rib_distance <= 0:
            raise ImpossiblePart(
                f"ribs of {1e3 * self.ribs.inner_height:.4g} mm and {1e3 * self.ribs.outer_height:.4g} mm "
                f"meet at a roller of {1e3 * self.roller.diameter:.4g} mm diameter"
            )
        for race, radius in (("inner", self.inner_radius), ("outer", self.outer_radius)):
            waves = getattr(self, f"{race}_waves")
            if waves is not None:
                waves.require_gentle(f"bearing.form_error.{race}", radius, self.roller.diameter / 2)

    def _require_rows_apart(self) -> None:
        places = sorted(row.axial for row in self.rows)
        if not places or any(not right - left > self.roller.length for left, right in pairwise(places)):
            raise ImpossiblePart(
                f"rows at {places} m: they must be further apart than a roller is long, "
                f"{1e3 * self.roller.length:.4g} mm"
            )

    def _require_like_rollers(self) -> None:
        if len(self.roller_deviations) not in (0, self.all_rollers):
            raise ImpossiblePart(
                f"bearing.form_error.roller_diameters has {len(self.roller_deviations)} numbers; there must "
                f"be one for each of {self.all_rollers} rollers"
            )
        largest = max(map(abs, self.roller_deviations), default=0.0)
        if not largest <= UNLIKE * self.roller.diameter:
            raise ImpossiblePart(
                f"bearing.form_error.roller_diameters: {largest * 1e6:.4g} um; at most "
                f"{UNLIKE * self.roller.diameter * 1e6:.4g} um, {UNLIKE:g} of the diameter"
            )

    @property
    def pitch_diameter(self) -> float:
        """Of the roller centres, rollers lying on the outer raceway [m]."""
        return self.outer_raceway_diameter - self.roller.diameter

    @property
    def diameter_ratio(self) -> float:
        """Roller over pitch diameter, gamma [-]."""
        return self.roller.diameter / self.pitch_diameter

    @cached_property
    def inner_radius(self) -> float:
        """Inner raceway radius of the kinematics, without the clearance [m]."""
        return (self.pitch_diameter - self.roller.diameter) / 2

    @cached_property
    def outer_radius(self) -> float:
        """Outer raceway radius [m]."""
        return self.outer_raceway_diameter / 2

    @property
    def rib_levels(self) -> tuple[float, float]:
        """Contacts on the ribs of inner and outer ring, outwards from the middle of the roller [m]."""
        assert self.ribs is not None  # or nothing would be pressed on them
        radius = self.roller.diameter / 2
        return self.ribs.inner_height - radius, radius - self.ribs.outer_height

    @property
    def rib_distance(self) -> float:
        """Radial distance h of both contacts of a roller on ribs, the lever of their couple [m]."""
        inner, outer = self.rib_levels
        return outer - inner

    @property
    def row_count(self) -> int:
        """Number of rows."""
        return len(self.rows)

    @property
    def all_rollers(self) -> int:
        """Number Z of the rollers of all rows."""
        return self.rollers * self.row_count

    @cached_property
    def azimuths(self) -> NDArray:
        """Roller azimuths from the load line (Z) [rad]."""
        of_row = self.first_roller_azimuth + 2 * np.pi * np.arange(self.rollers) / self.rollers
        return joined(of_row + row.azimuth for row in self.rows)

    @cached_property
    def stations(self) -> NDArray | None:
        """Places of the rollers along the axis (Z) [m]; None where all are in the middle of the rings."""
        if not any(np.any(row.axial) for row in self.rows):
            return None
        return joined(np.ones(self.rollers) * row.axial for row in self.rows)

    @cached_property
    def clearances(self) -> float | NDArray:
        r"""Diametral clearance at every roller (Z) [m]; one number of round raceways and rollers alike.

        .. math:: G_j = G + G_k - 2\,(h_{ij} + h_{oj}) - 2\,\delta_j

        with that of its row G_k, the form errors h towards the rollers, and the deviations delta of their
        diameters.

        Source
        ------
        Geometry.
        """
        waves = [waves for waves in (self.inner_waves, self.outer_waves) if waves is not None]
        unlike = any(np.any(row.clearance) for row in self.rows)
        if not waves and not self.roller_deviations and not unlike:
            return self.clearance
        closer = [each.height(self.azimuths) for each in waves]
        if self.roller_deviations:
            closer.append(joined(map(np.atleast_1d, self.roller_deviations)))
        if unlike:
            closer.append(joined(np.ones(self.rollers) * row.clearance / -2 for row in self.rows))
        return self.clearance - 2 * sum(closer)

    @property
    def symmetric(self) -> bool:
        """Whether both halves of the bearing are alike, seen along its axis from the middle of the rings."""
        profiles = (self.roller.profile, self.inner_profile, self.outer_profile)
        alike = all(each.symmetric for each in profiles if isinstance(each, PointsProfile))
        return alike and (self.stations is None or self._mirrored_rows)

    @property
    def _mirrored_rows(self) -> bool:
        """Whether the last row is the first one seen from the other side, and so on inwards."""
        pairs = zip(self.rows, reversed(self.rows), strict=True)
        return not self.roller_deviations and all(
            np.all(one.axial == -other.axial)
            and np.all(one.clearance == other.clearance)
            and np.all(one.azimuth == other.azimuth)
            for one, other in pairs
        )

    @property
    def relieved(self) -> bool:
        """Whether roller or raceway has a profile at both contacts."""
        raceways = (self.inner_profile, self.outer_profile)
        return not isinstance(self.roller.profile, Straight) or not any(
            isinstance(each, Straight) for each in raceways
        )

    def drop(self, race: int, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop of roller and raceway together.

        .. math:: C = C_{roller} + C_{raceway}

        C [m] is >= 0, at positions from mid-roller [m]; lengths [m] may be those of many cases, and `race` is
        0 inner, 1 outer.

        Source
        ------
        Geometry: both gaps add up.
        """
        raceway = (self.inner_profile, self.outer_profile)[race]
        return self.roller.profile.drop(position, length) + raceway.drop(position, length)


@dataclass(frozen=True, kw_only=True)
class Operation:
    """Load and speed."""

    radial_load: float  # [N] on the inner ring, >= 0
    inner_speed: float  # [rad/s]
    outer_speed: float = 0.0  # [rad/s]
    load_direction: float = 0.0  # [rad] azimuth the load points to
    moment: float = 0.0  # [N m] on the inner ring, tilts it in the plane of `tilt_direction`
    misalignment: float = 0.0  # [rad] slope of a ring that may not tilt freely, in the same plane
    tilt_direction: float = 0.0  # [rad] from the load to the plane in which moment and misalignment tilt
    axial_load: float = 0.0  # [N] on the inner ring, along x: its rib at the other end presses the rollers
    free_tilt: bool = False  # whether the inner ring may tilt against the outer one
    gravity: float = GRAVITY  # [m/s2] across the axis: 0 where the shaft stands upright
    gravity_direction: float = 0.0  # [rad] azimuth that weights point to

    def __post_init__(self):
        if self.inner_speed == self.outer_speed:
            raise ImpossiblePart(f"both rings turn at {self.inner_speed * 30 / pi:.6g} rpm: nothing rolls")
        if self.radial_load < 0:
            raise ImpossiblePart(f"radial_load = {self.radial_load} N: turn load_direction instead")
        if self.gravity < 0:
            raise ImpossiblePart(f"gravity = {self.gravity} m/s2: turn gravity_direction instead")
        if self.moment and not self.free_tilt:
            raise ImpossiblePart(f"moment = {self.moment} N m acts on a ring that may not tilt")
        if self.misalignment and self.free_tilt:
            raise ImpossiblePart(
                f"misalignment = {self.misalignment} rad is given to a ring that tilts freely"
            )

    @property
    def direction(self) -> float:
        """Sense in which the rollers spin: +1 when the inner ring turns ahead of the outer one."""
        return 1.0 if self.inner_speed > self.outer_speed else -1.0

    @property
    def tilts(self) -> bool:
        """Whether rings at an angle, or ribs, tilt the rollers between raceways of no shape of their own."""
        return bool(np.any(self.moment) or np.any(self.misalignment)) or self.on_ribs

    @property
    def on_ribs(self) -> bool:
        """Whether thrust presses the rollers on ribs."""
        return bool(np.any(self.axial_load))
