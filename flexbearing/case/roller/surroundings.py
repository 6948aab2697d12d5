"""The sections [materials] and [operation]."""

from itertools import pairwise
from math import radians
from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.fits import PartTemperatures
from flexbearing.case.materials import Material, RingMaterial
from flexbearing.case.quantity import (
    GIVEN,
    Acceleration,
    Angle,
    Force,
    Length,
    Moment,
    Section,
    Speed,
    Temperature,
    impossible,
    key,
)
from flexbearing.case.roller.fits import FITTED, IN_HOUSING, LIFTING_OFF, MOUNTED

ON_SEAT = ({"outer.kind": ("squirrel_cage",)}, {"outer.kind": ("ring",), "outer.support": ("side", "seat")})
STEEPEST = radians(5)  # slope of a ring, up to which small angles describe it
SAME = 1e-3  # [K] by which two statements of a temperature may differ


class Materials(Section):
    """Materials of the parts."""

    roller: Material = key("of the rollers")
    inner_ring: RingMaterial = key("of the inner ring")
    outer_ring: RingMaterial = key("of the outer ring, and of the squirrel cage that is one piece with it")
    shaft: RingMaterial | None = key(
        'of the shaft; needed for inner.kind = "ring_on_shaft" and for a clearance that follows from fits',
        None,
        only=({"inner.kind": ("ring_on_shaft",)}, *MOUNTED),
    )
    housing: RingMaterial | None = key(
        'of the housing; needed for [bearing.fits.housing]; without it that of outer.support = "housing" is '
        "made of the material of the outer ring",
        None,
        only=(IN_HOUSING, {"bearing.fits.housing": GIVEN}),
    )


class Along(Section):
    """A temperature that varies along the axis, linear between places."""

    at: tuple[Length, ...] = key(
        "places along the axis from the middle of the rollers, growing, from end to end of the part",
        example=["-30 mm", "30 mm"],
        strict=False,
        min_length=2,
    )
    temperatures: tuple[Temperature, ...] = key(
        "temperature at each of these places", example=["210 degC", "250 degC"], strict=False
    )

    @model_validator(mode="after")
    def _makes_a_line(self) -> Self:
        if any(right <= left for left, right in pairwise(self.at)):
            raise impossible("at", "places in growing order")
        if len(self.temperatures) != len(self.at):
            raise impossible("temperatures", f"one temperature for each of {len(self.at)} places")
        if not self.at[0] <= 0 <= self.at[-1]:
            raise impossible("at", "places on both sides of the middle, or the middle itself")
        return self

    @property
    def middle(self) -> float:
        """Temperature in the middle [K]."""
        lines = zip(pairwise(self.at), pairwise(self.temperatures), strict=True)
        return next(
            cold + (warm - cold) * -left / (right - left)
            for (left, right), (cold, warm) in lines
            if left <= 0 <= right
        )


class Temperatures(PartTemperatures):
    """Temperatures of the parts, which may vary along the axis."""

    roller: Temperature = key("of the rollers", gt=0)
    outer_ring: Temperature = key("of the outer ring and its support", gt=0)
    housing: Temperature | None = key(
        "of the housing; needed for [bearing.fits.housing] and outer.housing_clearance",
        None,
        gt=0,
        only=({"bearing.fits.housing": GIVEN}, {"outer.housing_clearance": GIVEN}),
    )
    outer_seat: Temperature | None = key(
        "of what carries the clamped face or the seat of the outer part, which expands like the material "
        "of the outer ring; without it as warm as that",
        None,
        gt=0,
        only=ON_SEAT,
    )
    shaft_along: Along | None = key("how that of the shaft varies along the axis", None, only=FITTED)
    inner_ring_along: Along | None = key(
        "how that of the inner ring varies along the axis", None, only=FITTED
    )
    outer_ring_along: Along | None = key(
        "how that of the outer ring varies along the axis", None, only=LIFTING_OFF
    )
    housing_along: Along | None = key("how that of the housing varies along the axis", None, only=LIFTING_OFF)

    @model_validator(mode="after")
    def _agree_in_the_middle(self) -> Self:
        for part in ("shaft", "inner_ring", "outer_ring", "housing"):
            along, given = getattr(self, f"{part}_along"), getattr(self, part)
            if along and (given is None or abs(along.middle - given) > SAME):
                raise impossible(
                    part, f'"{along.middle:.6g} K", which {part}_along has in the middle of the rollers'
                )
        return self


class Carrier(Section):
    """The planet carrier, whose sides turn against each other and so tilt the pin."""

    twist: Angle = key(
        "angle by which the side at +x is ahead of the other one, in the direction of the load",
        example="0.2 mrad",
        ge=-STEEPEST,
        le=STEEPEST,
    )
    load: Force | None = key(
        "radial load under which it twists so, in proportion; without it the twist is the same at any load",
        None,
        example="360 kN",
        gt=0,
    )
    radius: Length = key("distance of the pin from the axis of the carrier", example="300 mm", gt=0)
    pin_length: Length = key("length of the pin between the sides", example="260 mm", gt=0)

    def slope(self, load: float) -> float:
        """Slope of the pin under a radial load [N]: its ends part by the twist times the radius."""
        share = 1.0 if self.load is None else load / self.load
        return share * self.twist * self.radius / self.pin_length


class Operation(Section):
    """Load and speed."""

    radial_load: Force = key("radial load on the inner ring", ge=0)
    axial_load: Force = key(
        "axial load on the inner ring, positive along x; other than 0 with [bearing.ribs] and a radial load",
        "0 N",
        example="500 N",
    )
    load_direction: Angle = key("azimuth that the radial load points to, from z towards y", "0 deg")
    inner_speed: Speed = key("speed of the inner ring")
    outer_speed: Speed = key(
        "speed of the outer ring; 0 of a squirrel cage and of a drawn ring, which are clamped; all other "
        "supports turn with the ring, but lines stay where they are",
        "0 rpm",
    )
    moment: Moment = key(
        "tilting moment on the inner ring in the plane of the load or that of tilt_direction, about the axis "
        'across it; other than 0 with tilt = "free"',
        "0 N m",
    )
    misalignment: Angle = key(
        'slope of an inner ring in the same plane; other than 0 with tilt = "fixed"',
        "0 deg",
        example="2 arcmin",
        ge=-STEEPEST,
        le=STEEPEST,
    )
    carrier: Carrier | None = key(
        "the planet carrier, whose torsion adds to the slope of the inner ring in the plane of the load",
        None,
        only={"operation.tilt": ("fixed",)},
    )
    tilt: Literal["fixed", "free"] = key(
        "how the shaft holds the inner ring: fixed, it keeps its slope (operation.misalignment); free, it "
        "tilts until the moments balance (operation.moment); must be given where a ring is flexible",
        "fixed",
    )
    tilt_direction: Angle = key(
        "azimuth, ahead of load_direction, of the plane in which moment and misalignment tilt the inner "
        "ring: 90 deg for the couple of helical teeth on a planet",
        "0 deg",
        example="90 deg",
    )
    roller_positions: int | None = key(
        "positions of the roller set within a pitch that are solved one after the other, from "
        "bearing.first_roller_azimuth on; the result has the range of loads, life and all else. Without it "
        "that position alone",
        None,
        example=8,
        ge=2,
        le=1000,
    )
    gravity: Acceleration = key(
        "gravity across the bearing axis, for the weights of rollers and cage; zero for an upright shaft",
        "9.81 m/s^2",
        ge=0,
    )
    gravity_direction: Angle = key("azimuth that weights point to, from z towards y", "0 deg")
    temperatures: Temperatures | None = key(
        "temperatures of the parts; without them all have the dimensions given", None
    )

    @property
    def slope(self) -> float:
        """Slope of an inner ring that is held [rad], in the plane of tilt_direction."""
        return self.misalignment + (self.carrier.slope(self.radial_load) if self.carrier else 0.0)

    @property
    def free_tilt(self) -> bool:
        """Whether the inner ring may tilt."""
        return self.tilt == "free"

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.inner_speed == self.outer_speed:
            raise impossible("inner_speed", "other than operation.outer_speed, or nothing rolls")
        if self.moment != 0.0 and not self.free_tilt:
            raise impossible(
                "moment",
                '"0 N m" for operation.tilt = "fixed"; a moment tilts a ring with operation.tilt = "free"',
            )
        if self.carrier and self.tilt_direction:
            raise impossible(
                "tilt_direction", '"0 deg" beside [operation.carrier], which tilts along the load'
            )
        if self.misalignment != 0.0 and self.free_tilt:
            raise impossible(
                "misalignment",
                '"0 deg" for operation.tilt = "free": the slope of the ring follows from its moments',
            )
        return self
