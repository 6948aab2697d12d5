"""A cylindrical roller bearing put together."""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.cage import Cage
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import STRAIGHT, PointsProfile, Profile, Straight
from quasidynamic.parts.raceway_waves import RacewayWaves
from quasidynamic.parts.roller import Roller

UNLIKE = 1e-3  # [-] most deviation of a diameter: masses and contacts are those of the nominal (assumed)


@dataclass(frozen=True, kw_only=True)
class CylindricalRollerBearing:
    """Rollers between two raceways, spaced by a cage."""

    rollers: int
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
    ] = ()  # [m] of each roller's diameter from the nominal one; empty: none
    inner_profile: Profile = STRAIGHT  # of the raceways along the rollers
    outer_profile: Profile = STRAIGHT

    def __post_init__(self):
        require_positive("bearing.outer_raceway_diameter", self.outer_raceway_diameter)
        if self.rollers < 3:
            raise ImpossiblePart(f"bearing.rollers = {self.rollers}: a ring needs at least 3")
        if self.rollers * self.roller.diameter >= np.pi * self.pitch_diameter:
            raise ImpossiblePart(f"{self.rollers} rollers do not fit on the pitch circle")
        self._require_like_rollers()
        for race, radius in (("inner", self.inner_radius), ("outer", self.outer_radius)):
            waves = getattr(self, f"{race}_waves")
            if waves is not None:
                waves.require_gentle(f"bearing.form_error.{race}", radius, self.roller.diameter / 2)

    def _require_like_rollers(self) -> None:
        if len(self.roller_deviations) not in (0, self.rollers):
            raise ImpossiblePart(
                f"bearing.form_error.roller_diameters has {len(self.roller_deviations)} numbers; there must "
                f"be one for each of {self.rollers} rollers"
            )
        largest = max(map(abs, self.roller_deviations), default=0.0)
        if not largest <= UNLIKE * self.roller.diameter:
            raise ImpossiblePart(
                f"bearing.form_error.roller_diameters: {largest * 1e6:.4g} um; at most "
                f"{UNLIKE * self.roller.diameter * 1e6:.4g} um, {UNLIKE:g} of the diameter"
            )

    @cached_property
    def pitch_diameter(self) -> float:
        """Of the roller centres, rollers lying on the outer raceway [m]."""
        return self.outer_raceway_diameter - self.roller.diameter

    @cached_property
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

    @cached_property
    def azimuths(self) -> NDArray:
        """Roller azimuths from the load line (Z) [rad]."""
        return self.first_roller_azimuth + 2 * np.pi * np.arange(self.rollers) / self.rollers

    @cached_property
    def clearances(self) -> float | NDArray:
        r"""Diametral clearance at every roller (Z) [m]; one number of round raceways and rollers alike.

        .. math:: G_j = G - 2\,(h_{ij} + h_{oj}) - 2\,\delta_j

        with the form errors h towards the rollers, and the deviations delta of their diameters.

        Source
        ------
        Geometry.
        """
        waves = [waves for waves in (self.inner_waves, self.outer_waves) if waves is not None]
        if not waves and not self.roller_deviations:
            return self.clearance
        closer = [each.height(self.azimuths) for each in waves]
        if self.roller_deviations:
            closer.append(
                np.concatenate(np.broadcast_arrays(*map(np.atleast_1d, self.roller_deviations)), axis=-1)
            )
        return self.clearance - 2 * sum(closer)

    @property
    def symmetric(self) -> bool:
        """Whether both halves of rollers and raceways are alike."""
        profiles = (self.roller.profile, self.inner_profile, self.outer_profile)
        return all(each.symmetric for each in profiles if isinstance(each, PointsProfile))

    @property
    def relieved(self) -> bool:
        """Whether roller or raceway has a profile at both contacts."""
        raceways = (self.inner_profile, self.outer_profile)
        return not isinstance(self.roller.profile, Straight) or not any(
            isinstance(each, Straight) for each in raceways
        )

    def drop(self, race: int, position: NDArray, length: NDArray | float) -> NDArray:
        r"""Drop of roller and raceway together.

        .. math:: C = C_{roller} + C_{raceway}

        Parameters
        ----------
        race : int
            0 the inner, 1 the outer raceway
        position : array (...)
            from mid-roller [m]
        length : float or array (...)
            of the roller [m], or of those of many cases

        Returns
        -------
        array (...)
            C [m], >= 0

        Source
        ------
        Geometry: both gaps add up.
        """
        raceway = (self.inner_profile, self.outer_profile)[race]
        return self.roller.profile.drop(position, length) + raceway.drop(position, length)
