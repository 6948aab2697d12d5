"""Tables of an oil and of the laws that it follows in contacts, of rollers and balls alike."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.materials import Oil, ViscositySheet
from flexbearing.case.quantity import (
    Conductivity,
    Density,
    Length,
    PerPressure,
    PerTemperature,
    Pressure,
    Section,
    Velocity,
    impossible,
    key,
    needed,
    require,
)

AdoreOilName = Literal[
    "MIL-L-7808", "MIL-L-23699", "MIL-L-27502", "Santotrac 30", "Santotrac 50", "Mobil DTE SAE 30"
]
RollingName = Literal["biboulet-houpert", "dowson-higginson", "zhou-hoeprich", "goksem-hargreaves"]
TractionName = Literal["4109", "eyring", "bair-winer", "adore", "four-point"]
ShareName = Literal["zhou-hoeprich", "film-1.8", "error-function"]
AsperityFrictionName = Literal["rounded", "carter"]

HEATED = ("eyring", "bair-winer")  # laws whose film can warm by its own shear
NEEDS = {  # what a traction law cannot do without
    "4109": (),
    "eyring": ("limiting_ratio",),
    "bair-winer": ("limiting_ratio",),
    "adore": ("adore_oil", "limiting_ratio"),
    "four-point": ("traction_curve",),
}


class FilmSheet(ViscositySheet):
    """An oil as a data sheet prints it, with what films need."""

    density: Density | None = key("density at 15 degC", None, example="870 kg/m^3", gt=0)
    cold_pressure_viscosity: PerPressure | None = key(
        "pressure-viscosity coefficient alpha at the first temperature", None, example="20 1/GPa", gt=0
    )
    hot_pressure_viscosity: PerPressure | None = key(
        "alpha at the second temperature; without it alpha is constant", None, example="15 1/GPa", gt=0
    )
    conductivity: Conductivity | None = key("thermal conductivity", None, gt=0)


class TractionCurve(Section):
    """A measured traction curve by four of its points."""

    at_rest: float = key("traction coefficient at zero slip; 0 for a fluid", 0.0, ge=0, le=1)
    peak: float = key("largest traction coefficient", example=0.05, ge=1e-6, le=1)
    peak_slip: float = key("slide-to-roll ratio where it is reached", example=0.02, ge=1e-6, le=10)
    far: float = key("traction coefficient at large slip", example=0.03, ge=0, le=1)

    @model_validator(mode="after")
    def _has_a_peak(self) -> Self:
        for name in ("at_rest", "far"):
            if getattr(self, name) >= self.peak:
                raise impossible(name, "below lubricant.traction_curve.peak")
        return self


class Mixed(Section):
    """Rough surfaces that share the load with the film; needs [bearing.roughness]."""

    boundary_friction: float = key("friction coefficient where asperities touch", example=0.1, ge=0, le=1)
    share: ShareName = key("share of the load on asperities as a function of the film ratio", "zhou-hoeprich")
    asperity_friction: AsperityFrictionName = key(
        "how the boundary friction sets in with the slip: rounded, over sign_speed; carter, by the elastic "
        "creep of rolling cylinders, which slow rollers need",
        "rounded",
    )
    sign_speed: Velocity = key(
        "sliding speed over which the boundary friction changes its sign; asperity_friction rounded",
        "1 mm/s",
        example="1 mm/s",
        gt=0,
        only={"asperity_friction": ("rounded",)},
    )


class FilmOil(Oil):
    """The oil: by name, by its data sheet, or by its data at the inlet temperature; and its laws."""

    data_sheet: FilmSheet | None = key("an oil from two viscosities, instead of its name", None)
    pressure_viscosity: PerPressure | None = key("pressure-viscosity coefficient alpha", None, gt=0)
    temperature_viscosity: PerTemperature | None = key(
        "beta = -d ln(viscosity)/dT", None, example="0.035 1/K", ge=0
    )
    conductivity: Conductivity | None = key("thermal conductivity", None, gt=0)
    film: str = key("regression of the film thickness")
    inlet_heating: bool = key("whether shear heating of the inlet thins the film", True)
    inlet_length: float | None = key(
        "inlet length c_s of a starved film, about the oil before the contact in half-widths; "
        "without it the contacts are flooded",
        None,
        example=1.0,
        ge=1e-3,
        le=1000,
    )
    traction: TractionName = key(
        "traction law: regression of the oil 4109; eyring or bair-winer film with a limiting shear stress; "
        "adore, a film heated by its shear; four-point, a measured curve",
        "4109",
    )
    limiting_ratio: float | None = key(
        "limiting shear stress over pressure; laws eyring, bair-winer and adore",
        None,
        example=0.05,
        ge=1e-6,
        le=1,
        only={"traction": ("eyring", "bair-winer", "adore")},
    )
    eyring_stress: Pressure | None = key(
        "Eyring stress; without it 2 limiting_ratio / pressure_viscosity",
        None,
        example="9 MPa",
        gt=0,
        only={"traction": ("eyring",)},
    )
    film_heating: bool = key(
        "whether the film warms by its own shear; laws eyring and bair-winer",
        False,
        only={"traction": HEATED},
    )
    adore_oil: AdoreOilName | None = key(
        "oil whose traction was fitted; law adore", None, only={"traction": ("adore",)}
    )
    traction_curve: TractionCurve | None = key(
        "points of a measured curve; law four-point", None, only={"traction": ("four-point",)}
    )
    mixed: Mixed | None = key("boundary friction of rough surfaces around the traction law", None)
    rolling: RollingName = key("law of the hydrodynamic rolling friction of the oil film", "biboulet-houpert")
    oil_fraction: float | None = key(
        "volume share of oil in the mixture around rollers or balls", None, example=0.02, ge=0, le=1
    )
    drag_coefficient: float | None = key(
        "drag coefficient of rollers or balls; without it a table over the Reynolds number",
        None,
        example=1.2,
        ge=1e-3,
        le=1000,
    )
    churning_gap: Length | None = key(
        "mean gap around the spinning rollers or balls; without it no churning torque",
        None,
        example="1 mm",
        gt=0,
    )

    @model_validator(mode="after")
    def _law_is_complete(self) -> Self:
        require(self, NEEDS[self.traction], f'traction = "{self.traction}"')
        return self

    def require_rough_surfaces(self, given: bool) -> None:
        """Raise where a law needs the roughness and the case does not give it."""
        if self.mixed and not given:
            raise needed(["bearing.roughness"], "[lubricant.mixed]")

    @property
    def _of_contacts(self) -> list[str]:
        """Keys that are given for contacts in oil alone."""
        sheet = self.data_sheet.model_fields_set - set(ViscositySheet.model_fields) if self.data_sheet else ()
        names = [name for name in self.model_fields_set if name not in Oil.model_fields]
        return sorted([*names, *(f"data_sheet.{name}" for name in sheet)])

    def _require_film(self, choice: str) -> None:
        """Raise where something is missing that contacts in oil need."""
        needs: dict[str, float | None] = {"oil_fraction": self.oil_fraction}
        if self.data_sheet is not None:
            names = ("density", "cold_pressure_viscosity", "conductivity")
            needs |= {f"data_sheet.{name}": getattr(self.data_sheet, name) for name in names}
        elif self.oil is None:
            names = ("pressure_viscosity", "temperature_viscosity", "conductivity")
            needs |= {name: getattr(self, name) for name in names}
        if missing := [f"lubricant.{name}" for name, value in needs.items() if value is None]:
            raise needed(missing, choice)


def require_contacts_in_oil(oil: FilmOil | None, wet: bool, choice: str, rough: bool) -> None:
    """Raise unless contacts in oil have all that they need, and others no keys of them."""
    if not wet:
        if oil and (keys := oil._of_contacts):
            raise impossible(f"lubricant.{keys[0]}", f"left out but with {choice}")
        return
    if oil is None:
        raise needed(["lubricant"], choice)
    oil._require_film(choice)
    oil.require_rough_surfaces(rough)
