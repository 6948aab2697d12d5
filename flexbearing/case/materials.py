"""Tables of materials and oils, each of which may be a name instead, and the materials with names."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator
from pydantic_core import PydanticCustomError

from flexbearing.case.quantity import (
    Density,
    KinematicViscosity,
    PerTemperature,
    Pressure,
    Section,
    Temperature,
    Viscosity,
    impossible,
    key,
    require,
)

EXPANSION = "coefficient of linear thermal expansion; needed with [operation.temperatures]"
OilName = Literal["MIL-PRF-23699", "MIL-L-7808", "4 cSt aviation", "ISO VG 32", "ISO VG 68", "ISO VG 100"]


@dataclass(frozen=True, kw_only=True)
class NamedMaterial:
    """A material of the table, its values in the words of a case file."""

    youngs_modulus: str
    poisson_ratio: float
    density: str
    expansion: str
    yield_stress: str | None = None  # none was found printed, or the material breaks before it yields
    source: str


MATERIALS = {
    "100Cr6": NamedMaterial(
        youngs_modulus="210 GPa",
        poisson_ratio=0.30,
        density="7810 kg/m^3",
        expansion="11.9e-6 1/K",
        yield_stress="2034 MPa",
        source="hardened, as AISI 52100; modulus and Poisson's ratio: SNFA, comparison of bearing steel with "
        "silicon nitride; density, expansion from 23 to 280 degC: data sheet of SAE 52100; yield stress: "
        "295 000 psi, data sheet of chrome steel balls, HRC 60 to 67",
    ),
    "M50": NamedMaterial(
        youngs_modulus="214 GPa",
        poisson_ratio=0.29,
        density="7870 kg/m^3",
        expansion="11.84e-6 1/K",
        source="AISI M50 VIM-VAR, data sheet of BTI Metals, expansion from 21 to 204 degC; Poisson's ratio: "
        "MakeItFrom, annealed SAE-AISI M50; no yield stress was found printed",
    ),
    "Si3N4": NamedMaterial(
        youngs_modulus="315 GPa",
        poisson_ratio=0.26,
        density="3190 kg/m^3",
        expansion="3.2e-6 1/K",
        source="silicon nitride for balls: SNFA, comparison with bearing steel, expansion from 20 to 1000 "
        "degC; brittle, without a yield stress",
    ),
    "structural steel": NamedMaterial(
        youngs_modulus="210 GPa",
        poisson_ratio=0.30,
        density="7850 kg/m^3",
        expansion="12e-6 1/K",
        yield_stress="235 MPa",
        source="EN 1993-1-1, 3.2.6 and table 3.1: S235, the least of its grades, up to 40 mm thick; density: "
        "EN 1991-1-1, table A.4",
    ),
    "grey cast iron": NamedMaterial(
        youngs_modulus="110 GPa",
        poisson_ratio=0.26,
        density="7200 kg/m^3",
        expansion="11e-6 1/K",
        yield_stress="165 MPa",
        source="EN-GJL-250 after DIN EN 1561, as SN-Castiron prints it: modulus 103 to 118 GPa, 0.1 % proof "
        "stress 165 to 228 MPa; expansion: MakeItFrom, EN-JL 1040",
    ),
}


def values(name: str, keys: Iterable[str]) -> dict[str, object]:
    """Values of a material for some keys of its table, in the words of a case file."""
    material = MATERIALS[name]
    return {key: value for key in keys if (value := getattr(material, key, None)) is not None}


def origin(name: str) -> str:
    """What the table has of a material, in a line."""
    material = MATERIALS[name]
    limit = f", yield stress {material.yield_stress}" if material.yield_stress else ""
    return (
        f"Young's modulus {material.youngs_modulus}, Poisson's ratio {material.poisson_ratio}, density "
        f"{material.density}, expansion {material.expansion}{limit} ({material.source})"
    )


class Elastic(Section):
    """An elastic material."""

    by_name: ClassVar[tuple[str, ...]] = tuple(MATERIALS)

    name: str | None = key(
        "name of the material; one of the list is written as text in place of the table",
        None,
        example="42CrMo4",
    )
    youngs_modulus: Pressure = key("Young's modulus", ge=1e6, le=1e20)
    poisson_ratio: float = key("Poisson's ratio", example=0.3, ge=0, lt=0.5)

    @model_validator(mode="before")
    @classmethod
    def _of_its_name(cls, given: Any) -> Any:
        """Take the values of a named material from the list."""
        if isinstance(given, Mapping) and given.get("name") in tuple(MATERIALS):
            allowed = f"another name: {given['name']} is written as text in place of the table"
            raise impossible("name", allowed)
        if not isinstance(given, str):
            return given
        if given not in MATERIALS:
            raise PydanticCustomError("quantity", "{why}", {"why": "is no material of the list"})
        return {"name": given, **values(given, cls.model_fields)}

    @model_validator(mode="after")
    def _name_is_true(self) -> Self:
        """Keep a variant that is given one value after the other from the name of another material."""
        if self.name in tuple(MATERIALS) and self.model_dump(exclude={"name"}) != _listed(
            type(self), self.name
        ):
            raise impossible("name", f"another name: {self.name} has other values on the list")
        return self


class HeavyElastic(Elastic):
    """An elastic material whose inertia is felt."""

    density: Density = key("density", gt=0)


class Material(HeavyElastic):
    """A material that expands with heat."""

    expansion: PerTemperature | None = key(EXPANSION, None, example="11.2e-6 1/K", ge=-1e-3, le=1e-3)


def yield_stress() -> Any:
    """Stress of a part whose stresses may be known."""
    words = "yield stress; a computed stress above it is reported as a note"
    return key(words, None, example="900 MPa", gt=0)


class RingMaterial(Material):
    """A material of a part whose stresses may be known."""

    yield_stress: Pressure | None = yield_stress()


@cache
def _listed(table: type[Elastic], name: str) -> dict[str, Any]:
    """Values of a listed material [SI] for a table."""
    return table.model_validate(values(name, table.model_fields)).model_dump(exclude={"name"})


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
