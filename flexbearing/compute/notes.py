"""What left its range of validity, for the reader of the results."""

from flexbearing.case import Case
from flexbearing.compute import clearance
from flexbearing.compute.lubrication import oil, oil_name
from quasidynamic import Equilibrium
from quasidynamic.contact.drag import drag_notes
from quasidynamic.contact.rheology import ADORE_OILS


def of_case(case: Case) -> tuple[str, ...]:
    """What can be said before anything is solved."""
    found = oil(case).notes
    if case.lubricant.traction == "4109":
        found += (
            "traction: the 4109 regression was measured on point contacts; line contacts are outside it",
            f"traction: the 4109 regression is used with {oil_name(case)}",
        )
    return found + clearance.notes(case)


def of_state(case: Case, found: Equilibrium) -> tuple[str, ...]:
    """What a solved state adds: drag at its cage speed, traction at its pressures."""
    return _drag(case, found) + _traction(case, found)


def _drag(case: Case, found: Equilibrium) -> tuple[str, ...]:
    if case.lubricant.drag_coefficient is not None:
        return ()
    bearing, lubricant = found.balance.roller.bearing, found.balance.roller.lubrication.oil
    speed = abs(found.cage_speed) * bearing.pitch_diameter / 2
    return drag_notes(lubricant.density * bearing.roller.diameter / lubricant.viscosity * speed)


def _traction(case: Case, found: Equilibrium) -> tuple[str, ...]:
    given = case.lubricant
    if given.traction != "adore" or given.adore_oil is None:
        return ()
    return ADORE_OILS[given.adore_oil].notes(given.inlet_temperature, found.peak_pressure)
