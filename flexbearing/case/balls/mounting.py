"""Ball bearings on a shaft and in a housing, as cases: clearance, materials and temperatures."""

from functools import cache
from typing import Literal

from flexbearing.case.balls.parts import BallBearing
from flexbearing.case.fits import FITTED, HOUSED, Fits, PartTemperatures
from flexbearing.case.materials import Elastic, yield_stress
from flexbearing.case.mounted import (
    FittedBearing,
    FittedCase,
    GrowingElastic,
    WarmMaterial,
    housing_material,
    shaft_material,
)
from flexbearing.case.quantity import GIVEN, Angle, Pressure, Section, Temperature, impossible, key


class SeatMaterial(WarmMaterial):
    """A material of shaft or housing."""

    yield_stress: Pressure | None = yield_stress()


class StressedElastic(Elastic):
    """A material of a ring whose stresses may be known."""

    yield_stress: Pressure | None = yield_stress()


class RingElastic(StressedElastic, GrowingElastic):
    """A material of a ring, which fits and heat may widen, too."""


class BallTemperatures(PartTemperatures):
    """Temperatures of the parts."""

    ball: Temperature = key("of the balls", gt=0)
    housing: Temperature | None = key(
        "of the housing; needed for [bearing.fits.housing] and outer.housing_clearance",
        None,
        gt=0,
        only=(HOUSED, {"outer.housing_clearance": GIVEN}),
    )


class MountedBearing(FittedBearing, BallBearing):
    """A ball bearing that may sit on a shaft and in a housing."""

    first_ball_azimuth: Angle = key("azimuth of a ball, from z towards y", "0 deg")

    @property
    def centre_distance(self) -> float:
        """Distance of the groove centres when both races just touch a ball, A = (f_i + f_o - 1) D [m]."""
        diameter = self.ball.diameter
        return (self.inner.over(diameter) + self.outer.over(diameter) - 1) * diameter

    def require_walls(self, fits: Fits) -> None:
        """Raise unless both rings have a wall beneath their grooves."""
        inside, outside = (self.pitch_diameter + side * self.ball.diameter for side in (-1, 1))
        if fits.bore >= inside:
            allowed = f"below the bottom of the inner groove, {inside * 1e3:.4g} mm"
            raise impossible("bearing.fits.bore", allowed)
        if fits.outer_diameter <= outside:
            allowed = f"above the bottom of the outer groove, {outside * 1e3:.4g} mm"
            raise impossible("bearing.fits.outer_diameter", allowed)


AS_BALLS = "without it as the balls, or 100Cr6 where these are stiffer than any steel"
STEELS = (
    190e9,
    225e9,
)  # [Pa] Young's moduli of bearing steels, for which ISO 281 and ISO 76 are meant; assumed
SILICON_NITRIDES = (290e9, 330e9)  # [Pa] of balls of ISO 26602; assumed


class MountedMaterials(Section):
    """Materials of a bearing that may be mounted."""

    ball: Elastic = key("of the balls")
    inner_ring: StressedElastic | None = key(f"of the inner ring; {AS_BALLS}", None)
    outer_ring: StressedElastic | None = key(f"of the outer ring; {AS_BALLS}", None)
    shaft: Elastic | None = key("of the shaft; needed for [bearing.fits]", None, only=FITTED)
    housing: Elastic | None = key("of the housing; needed for [bearing.fits.housing]", None, only=HOUSED)

    def ring(self, race: Literal["inner", "outer"]) -> Elastic:
        """Material of a ring: the one given, else that of the balls, else bearing steel."""
        given = self.inner_ring if race == "inner" else self.outer_ring
        return given or (_bearing_steel() if self.ceramic else self.ball)

    @property
    def ceramic(self) -> bool:
        """Whether the balls are stiffer than any steel."""
        return self.ball.youngs_modulus > STEELS[1]

    @property
    def steel_balls(self) -> bool:
        """Whether the balls are of steel."""
        return _within(STEELS, self.ball)

    @property
    def hybrid(self) -> bool:
        """Whether balls of silicon nitride run between rings of steel, as ISO 20056 has them."""
        rings = (self.ring("inner"), self.ring("outer"))
        return _within(SILICON_NITRIDES, self.ball) and all(_within(STEELS, ring) for ring in rings)

    @property
    def not_given(self) -> tuple[str, ...]:
        """Rings whose material is not given."""
        rings = {"inner ring": self.inner_ring, "outer ring": self.outer_ring}
        return tuple(name for name, material in rings.items() if material is None)


def _within(moduli: tuple[float, float], material: Elastic) -> bool:
    low, high = moduli
    return low <= material.youngs_modulus <= high


@cache
def _bearing_steel() -> "RingElastic":
    return RingElastic.model_validate("100Cr6")


class FastMaterials(MountedMaterials):
    """Materials of the parts, whose growth by heat and speed may be known."""

    ball: WarmMaterial = key("of the balls")
    inner_ring: RingElastic | None = key(f"of the inner ring; {AS_BALLS}", None)
    outer_ring: RingElastic | None = key(f"of the outer ring; {AS_BALLS}", None)
    shaft: SeatMaterial | None = shaft_material()
    housing: SeatMaterial | None = housing_material()


class MountedCase(FittedCase):
    """A ball bearing whose operating clearance may follow from its fits."""

    bearing: MountedBearing = key("the bearing")
    materials: MountedMaterials = key("the materials")
