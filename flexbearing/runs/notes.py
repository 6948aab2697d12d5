"""What left its range of validity, for the reader of the results."""

import numpy as np

from flexbearing.build import clearance
from flexbearing.build.lubrication import oil, oil_name
from flexbearing.case.roller import Case
from flexbearing.quantities.roller import CAGE_SLIP
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.contact.cage import land_notes
from quasidynamic.contact.drag import drag_notes
from quasidynamic.contact.traction.adore import ADORE_OILS
from quasidynamic.note import Note, danger, information, outside
from quasidynamic.trace import equilibria_at, several_likely


def of_case(case: Case) -> tuple[Note, ...]:
    """What can be said before anything is solved."""
    notes = oil(case).notes
    if case.lubricant.traction == "4109":
        notes += (
            outside(
                "traction-data",
                "traction: the 4109 regression was measured on point contacts; line contacts are outside it",
            ),
            outside("traction-data", f"traction: the 4109 regression is used with {oil_name(case)}"),
        )
    return notes + clearance.notes(case)


def of_choice(model: RollerBearing) -> tuple[Note, ...]:
    """Other equilibria between rigid raceways, where the friction of lumped rollers hints at them."""
    if not model.operation.radial_load or not several_likely(model):
        return ()
    slips = ", ".join(f"{CAGE_SLIP.for_people(state.cage_slip):.3g}" for state in equilibria_at(model))
    if "," not in slips:
        return ()
    return (
        danger(
            "several-equilibria",
            f"several equilibria between rigid raceways, with a cage slip of {slips} %: which one the "
            "bearing runs in depends on how it came there; `flexbearing trace` shows which are stable",
        ),
    )


def of_state(case: Case, state: Equilibrium) -> tuple[Note, ...]:
    """What a solved state adds: drag at its cage speed, traction at its pressures."""
    return _drag(case, state) + _traction(case, state) + _cage(case, state)


def _drag(case: Case, state: Equilibrium) -> tuple[Note, ...]:
    if case.lubricant.drag_coefficient is not None:
        return ()
    bearing, lubricant = state.balance.roller.bearing, state.balance.roller.lubrication.oil
    speed = abs(state.cage_speed) * bearing.pitch_diameter / 2
    return drag_notes(lubricant.density * bearing.roller.diameter / lubricant.viscosity * speed)


def _cage(case: Case, state: Equilibrium) -> tuple[Note, ...]:
    notes: tuple[Note, ...] = ()
    cage = state.balance.roller.bearing.cage
    if state.floating is not None:
        notes += land_notes(np.hypot(*state.floating.offset[0]) / (cage.land_clearance / 2))
    if state.pocket_displacement is not None:
        touching = int((np.abs(state.pocket_displacement) > cage.pocket_clearance).sum())
        words = f"cage pockets: {touching} rollers touch the wall of their pocket"
        notes += (information("pocket-walls", words),) if touching else ()
    return notes


def _traction(case: Case, state: Equilibrium) -> tuple[Note, ...]:
    lubricant = case.lubricant
    if lubricant.traction != "adore" or lubricant.adore_oil is None:
        return ()
    return ADORE_OILS[lubricant.adore_oil].notes(lubricant.inlet_temperature, state.peak_pressure)
