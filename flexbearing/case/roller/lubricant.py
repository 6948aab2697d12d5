"""The section [lubricant] of a roller bearing: an oil and the laws it follows."""

from typing import Literal

from flexbearing.case.film_oil import FilmOil, FilmSheet
from flexbearing.case.quantity import Conductivity, Density, PerPressure, key

FilmName = Literal["dowson_higginson", "dowson", "dowson_toyoda", "pan_hamrock", "pan_hamrock_central"]


class DataSheet(FilmSheet):
    """An oil as a data sheet prints it."""

    density: Density = key("density at 15 degC", example="870 kg/m^3", gt=0)
    cold_pressure_viscosity: PerPressure = key(
        "pressure-viscosity coefficient alpha at the first temperature", example="20 1/GPa", gt=0
    )
    conductivity: Conductivity = key("thermal conductivity", gt=0)


class Lubricant(FilmOil):
    """The oil: by name, by its data sheet, or by its data at the inlet temperature."""

    data = ("viscosity", "pressure_viscosity", "temperature_viscosity", "conductivity", "density")

    data_sheet: DataSheet | None = key("an oil from two viscosities, instead of its name", None)
    film: FilmName = key("regression of the film thickness", "dowson")
    oil_fraction: float = key(
        "volume share of oil in the mixture around rollers or balls", example=0.02, ge=0, le=1
    )
