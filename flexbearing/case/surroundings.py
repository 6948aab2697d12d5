"""The sections [materials], [lubricant] and [operation]."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import (
    Conductivity,
    Density,
    Force,
    Moment,
    PerPressure,
    PerTemperature,
    Pressure,
    Section,
    Speed,
    Temperature,
    Viscosity,
    impossible,
    key,
    require,
)


class Material(Section):
    """A material."""

    youngs_modulus: Pressure = key("Young's modulus", gt=0)
    poisson_ratio: float = key("Poisson's ratio", example=0.3, ge=0, lt=0.5)
    density: Density = key("density", gt=0)
    expansion: PerTemperature = key("coefficient of linear thermal expansion")


class Materials(Section):
    """Materials of the parts."""

    roller: Material = key("of the rollers")
    inner_ring: Material = key("of the inner ring")
    outer_ring: Material = key("of the outer ring, and of the squirrel cage that is one piece with it")
    shaft: Material | None = key('of the shaft; needed for inner.kind = "ring_on_shaft"', None)


DATA = ("viscosity", "pressure_viscosity", "temperature_viscosity", "conductivity", "density")


class Lubricant(Section):
    """The oil: by name, or by its data at the inlet temperature."""

    oil: Literal["MIL-PRF-23699", "MIL-L-7808"] | None = key("oil by name, instead of its data", None)
    inlet_temperature: Temperature = key("temperature of the oil at the contact inlets", gt=0)
    viscosity: Viscosity | None = key("dynamic viscosity at the inlet temperature", None, gt=0)
    pressure_viscosity: PerPressure | None = key("pressure-viscosity coefficient alpha", None, gt=0)
    temperature_viscosity: PerTemperature | None = key(
        "beta = -d ln(viscosity)/dT", None, example="0.035 1/K", ge=0
    )
    conductivity: Conductivity | None = key("thermal conductivity", None, gt=0)
    density: Density | None = key("density", None, example="900 kg/m^3", gt=0)
    traction: Literal["4109", "eyring"] = key(
        'traction law: regression of the oil 4109, or "eyring" with a limiting shear stress', "4109"
    )
    limiting_ratio: float | None = key(
        "limiting shear stress over pressure, Eyring law", None, example=0.05, gt=0, le=1
    )
    eyring_stress: Pressure | None = key(
        "Eyring stress; without it 2 limiting_ratio / pressure_viscosity", None, example="9 MPa", gt=0
    )
    oil_fraction: float = key(
        "volume share of oil in the mixture around the rollers", example=0.02, ge=0, le=1
    )
    inlet_heating: bool = key("whether shear heating of the inlet thins the film", True)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.oil is None:
            require(self, DATA, "an oil without a name")
        elif given := [name for name in DATA if getattr(self, name) is not None]:
            raise impossible(given[0], "either lubricant.oil or its data, not both")
        if self.traction == "eyring":
            require(self, ("limiting_ratio",), 'traction = "eyring"')
        return self


class Temperatures(Section):
    """Temperatures of the parts; dimensions are given at the reference and grow with the rest."""

    shaft: Temperature = key("of the shaft", gt=0)
    inner_ring: Temperature = key("of the inner ring", gt=0)
    roller: Temperature = key("of the rollers", gt=0)
    outer_ring: Temperature = key("of the outer ring and its support", gt=0)
    reference: Temperature = key("at which the dimensions are given", gt=0)


class Operation(Section):
    """Load and speed."""

    radial_load: Force = key("radial load on the inner ring; its direction is azimuth zero", ge=0)
    inner_speed: Speed = key("speed of the inner ring")
    outer_speed: Speed = key("speed of the outer ring", "0 rpm")
    moment: Moment = key("tilting moment on the inner ring about the axis across the load", "0 N m")
    tilt: Literal["auto", "fixed", "free"] = key(
        "whether the inner ring may tilt: free, fixed, or free only under a moment (auto)", "auto"
    )
    temperatures: Temperatures | None = key(
        "temperatures of the parts; without them all have the dimensions given", None
    )

    @property
    def free_tilt(self) -> bool:
        """Whether the inner ring may tilt."""
        return self.tilt == "free" or (self.tilt == "auto" and self.moment != 0.0)

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.inner_speed == self.outer_speed:
            raise impossible("inner_speed", "other than operation.outer_speed, or nothing rolls")
        if self.tilt == "fixed" and self.moment != 0.0:
            raise impossible("moment", '"0 N m" for operation.tilt = "fixed"')
        return self
