"""The kinematic viscosity of an oil of which nothing else is needed."""

import quasidynamic as qd
from flexbearing.case.oil import Oil
from quasidynamic.note import Note
from quasidynamic.parts.oil_properties import kinematic_viscosity_at


def kinematic_viscosity(lubricant: Oil) -> tuple[float, tuple[Note, ...]]:
    """Viscosity of an oil at its inlet temperature.

    Raises
    ------
    OutOfRange
        where the oil has no viscosity at this temperature
    """
    temperature, sheet = lubricant.inlet_temperature, lubricant.data_sheet
    if lubricant.oil is not None:
        oil = qd.oil_at(lubricant.oil, temperature)
        return oil.viscosity / oil.density, oil.notes
    if sheet is not None:
        cold, hot = (
            (sheet.cold_temperature, sheet.cold_viscosity),
            (sheet.hot_temperature, sheet.hot_viscosity),
        )
        return kinematic_viscosity_at(sheet.name, (cold, hot), temperature)
    assert lubricant.viscosity is not None  # checked on reading
    assert lubricant.density is not None
    return lubricant.viscosity / lubricant.density, ()
