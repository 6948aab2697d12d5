"""An oil at the temperature of its inlet, for any use."""

from typing import ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import (
    Density,
    KinematicViscosity,
    Section,
    Temperature,
    Viscosity,
    impossible,
    key,
    require,
)

OilName = Literal["MIL-PRF-23699", "MIL-L-7808", "4 cSt aviation", "ISO VG 32", "ISO VG 68", "ISO VG 100"]


class ViscositySheet(Section):
    """The viscosity of an oil by ASTM D341, between and beyond two temperatures of a data sheet."""

    name: str = key("how notes call the oil", "oil of the data sheet", example="Turbine oil 46")
    cold_temperature: Temperature = key("of the first viscosity", example="40 degC", gt=0)
    cold_viscosity: KinematicViscosity = key("kinematic viscosity there", example="46 mm^2/s", gt=0)
    hot_temperature: Temperature = key("of the second viscosity", example="100 degC", gt=0)
    hot_viscosity: KinematicViscosity = key("kinematic viscosity there", example="6.8 mm^2/s", gt=0)

    @model_validator(mode="after")
    def _thins(self) -> Self:
        if self.hot_temperature <= self.cold_temperature:
            raise impossible("hot_temperature", "above lubricant.data_sheet.cold_temperature")
        if self.hot_viscosity >= self.cold_viscosity:
            raise impossible("hot_viscosity", "below lubricant.data_sheet.cold_viscosity")
        return self


class Oil(Section):
    """The oil: by name, by its data sheet, or by its data at the inlet temperature."""

    data: ClassVar[tuple[str, ...]] = ("viscosity", "density")  # keys of an oil without name or data sheet

    oil: OilName | None = key("oil by name, instead of its data", None)
    data_sheet: ViscositySheet | None = key("an oil from two viscosities, instead of its name", None)
    inlet_temperature: Temperature = key("temperature of the oil at the contact inlets", gt=0)
    viscosity: Viscosity | None = key("dynamic viscosity at the inlet temperature", None, gt=0)
    density: Density | None = key("density", None, example="900 kg/m^3", gt=0)

    @model_validator(mode="after")
    def _one_oil(self) -> Self:
        given = [name for name in self.data if getattr(self, name) is not None]
        if self.oil and self.data_sheet:
            raise impossible("oil", "left out where [lubricant.data_sheet] describes the oil, not both")
        if self.oil is None and self.data_sheet is None:
            require(self, self.data, "an oil without name (oil) or data sheet (data_sheet)")
        elif given:
            other = "lubricant.oil" if self.oil else "[lubricant.data_sheet]"
            raise impossible(given[0], f"either {other} or its data, not both")
        return self
