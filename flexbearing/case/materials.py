"""Tables of materials, each of which may be the name of a material instead."""

from collections.abc import Mapping
from functools import cache
from typing import Any, ClassVar, Self

from pydantic import model_validator
from pydantic_core import PydanticCustomError

from flexbearing.case.named_materials import MATERIALS, values
from flexbearing.case.quantity import Density, PerTemperature, Pressure, Section, impossible, key

EXPANSION = "coefficient of linear thermal expansion; needed with [operation.temperatures]"


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


class RingMaterial(Material):
    """A material of a part whose stresses may be known."""

    yield_stress: Pressure | None = key(
        "yield stress; a computed stress above it is reported as a note",
        None,
        example="900 MPa",
        gt=0,
    )


@cache
def _listed(table: type[Elastic], name: str) -> dict[str, Any]:
    """Values of a listed material [SI] for a table."""
    return table.model_validate(values(name, table.model_fields)).model_dump(exclude={"name"})
